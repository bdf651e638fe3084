/* Wavefront OBJ: what a Mesh holds is read, and all else kept for writing the file again. */
#ifndef MOTORWAY_TOOL_OBJ_H
#define MOTORWAY_TOOL_OBJ_H

#include <string>

#include "mesh.h"

namespace motorway::tool {

/* `contents` of the file `path`, which is only named in errors. Throws an Error with file and line. */
Mesh read_obj(const std::string &contents, const std::string &path);

/* A mesh from a file of another kind, in a pose. */
std::string write_obj(const Mesh &mesh, const Pose &pose);

} // namespace motorway::tool

#endif
