/* A picture of a mesh along its motion. */
#ifndef MOTORWAY_TOOL_PICTURE_H
#define MOTORWAY_TOOL_PICTURE_H

#include <cstddef>
#include <string>

#include "mesh.h"
#include "motion.h"

namespace motorway::tool {

/* SVG: the mesh in `pose_count` poses spread evenly over the motion, the curve that the origin of the mesh traces,
 * and the control poses as small frames. `path` is only named in errors. */
std::string draw_picture(const Mesh &mesh, const Motion &motion, std::size_t pose_count, const std::string &path);

} // namespace motorway::tool

#endif
