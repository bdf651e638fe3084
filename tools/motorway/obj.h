/* Wavefront OBJ: positions, normals and faces; what else a file may hold is passed over and named. */
#ifndef MOTORWAY_TOOL_OBJ_H
#define MOTORWAY_TOOL_OBJ_H

#include <string>
#include <vector>

#include "mesh.h"

namespace motorway::tool {

/* `contents` of the file `path`, which is only named in errors. Throws an Error with file and line. */
Mesh read_obj(const std::string &contents, const std::string &path);

/* The mesh in a pose: its faces, with these positions and normals instead of its own. */
std::string write_obj(const Mesh &mesh, const std::vector<float> &positions, const std::vector<float> &normals);

} // namespace motorway::tool

#endif
