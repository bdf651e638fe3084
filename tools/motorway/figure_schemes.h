/* The same four poses under every kind of motion, side by side: the motions themselves, and how fast they are. */
#ifndef MOTORWAY_TOOL_FIGURE_SCHEMES_H
#define MOTORWAY_TOOL_FIGURE_SCHEMES_H

#include <string>
#include <vector>

#include "figure_motion.h"

namespace motorway::tool {

struct Scheme {
    std::string name;
    CompiledMotion motion;
};

/* The first is the additive Bézier motion. */
std::vector<Scheme> schemes_of_four_poses();

/* The largest distance between the corners of the plate that is drawn, under two motions. */
double plate_distance(const CompiledMotion &first, const CompiledMotion &second);

std::string draw_schemes();
std::string draw_speeds();

} // namespace motorway::tool

#endif
