/* A motion as the tool uses it: the arrays of a B-spline, and what its file says besides. */
#ifndef MOTORWAY_TOOL_MOTION_H
#define MOTORWAY_TOOL_MOTION_H

#include <optional>
#include <string>
#include <vector>

#include "motorway.h"

namespace motorway::tool {

struct Motion {
    std::string name; /* for people; may be empty */
    unsigned degree = 0;
    std::vector<float> knots;
    std::vector<mw_motor_f32> controls;
    std::optional<double> mesh_size; /* what the longest side of a mesh's bounding box should be */

    /* The library's view of it; valid as long as this object. */
    mw_bspline_f32 spline() const { return {controls.data(), controls.size(), knots.data(), knots.size(), degree}; }

    float start() const { return knots[degree - 1]; }
    float end() const { return knots[controls.size() - 1]; }
};

/* `count` parameters spread evenly over the domain, both ends included; one alone is the start. */
std::vector<float> even_parameters(const Motion &motion, std::size_t count);

/* The motors at these parameters. Throws an Error that names `where` if one of them is degenerate. */
std::vector<mw_motor_f32> sample(const Motion &motion, const std::vector<float> &parameters,
                                 const std::string &where);

/* The paths of the points F_S(p) for each of the motors, as x y z. */
std::vector<float> trace(const std::vector<mw_motor_f32> &motors, const float point[3]);

} // namespace motorway::tool

#endif
