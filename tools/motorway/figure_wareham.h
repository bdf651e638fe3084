/* Figures 5 and 7 of Wareham and Lasenby, sections 3 and 4, each as an SVG file. */
#ifndef MOTORWAY_TOOL_FIGURE_WAREHAM_H
#define MOTORWAY_TOOL_FIGURE_WAREHAM_H

#include <string>

namespace motorway::tool {

std::string draw_wareham_figure_5(); /* three poses: piecewise linear, and quadratic */
std::string draw_wareham_figure_7(); /* the helix of a linear interpolation of many turns */

} // namespace motorway::tool

#endif
