/* Figures 1 to 5 of Hunt, Mullineux, Cripps and Cross (2017), section 4, each as an SVG file. */
#ifndef MOTORWAY_TOOL_FIGURE_HUNT_H
#define MOTORWAY_TOOL_FIGURE_HUNT_H

#include <string>

namespace motorway::tool {

std::string draw_hunt_figure_1(); /* a linear additive motion */
std::string draw_hunt_figure_2(); /* its planar path, and the helix, on their cylinder */
std::string draw_hunt_figure_3(); /* a quadratic motion along Viviani's curve */
std::string draw_hunt_figure_4(); /* a planar cubic, and its construction after de Casteljau */
std::string draw_hunt_figure_5(); /* a quadratic B-spline */

} // namespace motorway::tool

#endif
