/* Colours by lightness, chroma and hue as people see them (the OKLCH space), and a gradient through them. */
#ifndef MOTORWAY_TOOL_COLOUR_H
#define MOTORWAY_TOOL_COLOUR_H

#include <string>

namespace motorway::tool {

struct Colour {
    double lightness; /* 0 black to 1 white */
    double chroma;    /* 0 grey; what a screen cannot show is reduced when the colour is written */
    double hue;       /* degrees */
};

/* As #rrggbb. */
std::string hex(const Colour &colour);

/* From 0 to 1: blue, violet, rose, orange, gold, of even steps to the eye. */
Colour gradient(double share);

} // namespace motorway::tool

#endif
