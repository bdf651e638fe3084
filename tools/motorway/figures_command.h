/* motorway figures: the figures of the papers, and all schemes side by side, as SVG files. */
#ifndef MOTORWAY_TOOL_FIGURES_COMMAND_H
#define MOTORWAY_TOOL_FIGURES_COMMAND_H

#include <string>

namespace motorway::tool {

struct FiguresOptions {
    std::string out; /* a directory, which is made if there is none */
};

/* Throws an Error, and then has written no file. */
void run_figures(const FiguresOptions &options);

} // namespace motorway::tool

#endif
