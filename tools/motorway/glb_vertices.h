/* The vertices of a mesh as glTF wants them: in float, and each with one normal and one texture coordinate. */
#ifndef MOTORWAY_TOOL_GLB_VERTICES_H
#define MOTORWAY_TOOL_GLB_VERTICES_H

#include <array>
#include <cstdint>
#include <vector>

#include "mesh.h"

namespace motorway::tool {

struct GlbVertices {
    std::vector<float> positions;
    std::vector<float> normals;  /* unit vectors, or empty */
    std::vector<float> tangents; /* unit vectors and a sign, or empty */
    std::vector<float> uvs;      /* v downwards, or empty */
    std::vector<float> colours;  /* linear; r g b, or r g b a */
    std::vector<std::uint32_t> triangles, lines;

    std::size_t count() const { return positions.size() / 3; }
};

/* Positions are relative to the origin. A vertex of the mesh whose corners differ comes several times; all that no
 * face has come as they are, for lines and clouds. */
GlbVertices glb_vertices(const Mesh &mesh, const std::array<double, 3> &origin);

} // namespace motorway::tool

#endif
