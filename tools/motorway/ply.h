/* Stanford PLY: ascii, binary little-endian and binary big-endian. What a Mesh holds is read, and all other elements
 * and properties kept for writing the file again. */
#ifndef MOTORWAY_TOOL_PLY_H
#define MOTORWAY_TOOL_PLY_H

#include <string>

#include "mesh.h"

namespace motorway::tool {

/* `contents` of the file `path`, which is only named in errors. Throws an Error with file and line, or in a binary
 * file with the element. */
Mesh read_ply(const std::string &contents, const std::string &path);

/* A mesh from a file of another kind, in a pose: binary little-endian. */
std::string write_ply(const Mesh &mesh, const Pose &pose);

} // namespace motorway::tool

#endif
