/* Stanford PLY: ascii, binary little-endian and binary big-endian, with any elements and properties besides. */
#ifndef MOTORWAY_TOOL_PLY_H
#define MOTORWAY_TOOL_PLY_H

#include <string>
#include <vector>

#include "mesh.h"

namespace motorway::tool {

/* `contents` of the file `path`, which is only named in errors. Throws an Error with file and line, or in a binary
 * file with the element. */
Mesh read_ply(const std::string &contents, const std::string &path);

/* The mesh in a pose, binary little-endian: its faces, with these positions and normals instead of its own. */
std::string write_ply(const Mesh &mesh, const std::vector<float> &positions, const std::vector<float> &normals);

} // namespace motorway::tool

#endif
