/* glTF binary: the mesh or cloud in its rest pose under one node, which the motion moves. */
#ifndef MOTORWAY_TOOL_GLB_H
#define MOTORWAY_TOOL_GLB_H

#include <string>
#include <vector>

#include "mesh.h"
#include "motorway_views.h"

namespace motorway::tool {

/* The contents of a .glb file with one key a motor, `frames_per_second` of them; the motors are normalised. A rigid
 * motion is a rotation and a translation of the node, so the vertices are there once. Viewers blend between the keys in
 * their own way: the keys are exact, what lies between is as near as the keys are dense. Throws an Error if it would
 * not fit into a file. */
std::string write_glb(const Mesh &mesh, const std::vector<mw_motor_f64> &motors, double frames_per_second,
                      const std::string &path);

} // namespace motorway::tool

#endif
