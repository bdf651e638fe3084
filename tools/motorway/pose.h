/* Posing a mesh with the library, and measuring how rigid and how fast that is. */
#ifndef MOTORWAY_TOOL_POSE_H
#define MOTORWAY_TOOL_POSE_H

#include <string>
#include <vector>

#include "mesh.h"
#include "motion.h"
#include "motorway_views.h"

namespace motorway::tool {

/* The mesh moved by one motor, into arrays that are resized as needed. It is computed in double; a mesh of floats is
 * rounded to floats once, at the end. */
void pose_mesh(Pose &out, const Mesh &mesh, const mw_motor_f64 &motor);

/* Throws an Error that names `where` if a position of the mesh was finite, and is not in the pose. */
void check_finite(const Pose &pose, const Mesh &mesh, const std::string &where);

/* The largest change of the length of an edge, in the units of the mesh. */
double edge_deviation(const Mesh &mesh, const std::vector<Edge> &edges, const Pose &pose);

struct Speed {
    double vertices_per_second; /* position and normal of each, by the median pass */
    std::size_t passes;
};

/* Poses the positions and normals of the mesh by every motor into one buffer, again and again for about a quarter of a
 * second, as a program does that holds them as the file does, in float or in double: no reading, no writing, one
 * thread. */
Speed measure_speed(const Mesh &mesh, const std::vector<mw_motor_f64> &motors);

} // namespace motorway::tool

#endif
