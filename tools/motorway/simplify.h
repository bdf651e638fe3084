/* A coarser mesh for pictures, where details smaller than a pixel only make the file large. */
#ifndef MOTORWAY_TOOL_SIMPLIFY_H
#define MOTORWAY_TOOL_SIMPLIFY_H

#include <cstddef>

#include "mesh.h"

namespace motorway::tool {

/* The mesh itself if it is made of few enough triangles, else one of about that many or fewer, in which the vertices
 * of each cell of a grid are merged into their mean. It has one normal a vertex. */
Mesh simplified(const Mesh &mesh, std::size_t most_triangles);

} // namespace motorway::tool

#endif
