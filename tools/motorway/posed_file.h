/* A mesh in a pose as a file: of its own kind it is the file that was read with other numbers, of another kind what
 * that can hold. */
#ifndef MOTORWAY_TOOL_POSED_FILE_H
#define MOTORWAY_TOOL_POSED_FILE_H

#include <string>
#include <vector>

#include "mesh.h"

namespace motorway::tool {

/* The contents of a file with this extension, ".obj" or ".ply". */
std::string write_posed(const Mesh &mesh, const Pose &pose, const std::string &kind);

/* What the mesh's file holds and one with this extension, ".glb" among them, will not, for people to read. */
std::vector<std::string> left_out(const Mesh &mesh, const std::string &kind);

} // namespace motorway::tool

#endif
