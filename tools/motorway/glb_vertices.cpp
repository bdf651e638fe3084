#include "glb_vertices.h"

#include <algorithm>
#include <cmath>

#include "normals.h"

namespace motorway::tool {
namespace {

/* A vertex with a normal and a texture coordinate, by their numbers. */
using Key = std::array<std::uint32_t, 3>;

/* The distinct vertices of the file, sorted, and which of them each corner has. */
struct Split {
    std::vector<Key> keys;
    std::vector<std::uint32_t> of_corner, of_vertex;
};

std::uint32_t place(const std::vector<Key> &keys, const Key &key)
{
    return static_cast<std::uint32_t>(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
}

Split split(const Mesh &mesh)
{
    const auto count = static_cast<std::uint32_t>(mesh.vertex_count());
    const bool has_normals = has_all_normals(mesh), has_uvs = mesh.has_vertex_uvs();
    Split out;
    const auto own = [&](std::uint32_t vertex) {
        return Key{vertex, mesh.has_vertex_normals() ? vertex : NONE, has_uvs ? vertex : NONE};
    };
    std::vector<Key> of_corner;
    std::vector<bool> has_face(count, false);
    for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner) {
        Key key = own(mesh.corners[corner]);
        if (has_normals && !mesh.corner_normals.empty())
            key[1] = mesh.corner_normals[corner];
        if (!mesh.corner_uvs.empty())
            key[2] = mesh.corner_uvs[corner];
        of_corner.push_back(key);
        has_face[key[0]] = true;
    }
    out.keys = of_corner;
    for (std::uint32_t vertex = 0; vertex < count; ++vertex)
        if (!has_face[vertex])
            out.keys.push_back(own(vertex));
    std::sort(out.keys.begin(), out.keys.end());
    out.keys.erase(std::unique(out.keys.begin(), out.keys.end()), out.keys.end());
    for (const Key &key : of_corner)
        out.of_corner.push_back(place(out.keys, key));
    for (std::uint32_t vertex = 0; vertex < count; ++vertex)
        out.of_vertex.push_back(place(out.keys, {vertex, 0, 0}));
    return out;
}

/* Files hold colours as screens show them, glTF by the amount of light. */
float linear(float component)
{
    return component <= 0.04045f ? component / 12.92f : std::pow((component + 0.055f) / 1.055f, 2.4f);
}

void append(std::vector<double> &out, const std::vector<double> &vectors, std::uint32_t number)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        out.push_back(number == NONE ? 0 : vectors[3 * std::size_t{number} + axis]);
}

} // namespace

GlbVertices glb_vertices(const Mesh &mesh, const std::array<double, 3> &origin)
{
    const Split vertices = split(mesh);
    GlbVertices out;
    std::vector<double> normals, tangents;
    const bool has_normals = has_all_normals(mesh);
    for (const auto &[vertex, normal, uv] : vertices.keys) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            out.positions.push_back(
                static_cast<float>(mesh.positions[3 * std::size_t{vertex} + axis] - origin[axis]));
        if (has_normals)
            append(normals, mesh.normals, normal);
        if (has_normals && !mesh.tangents.empty())
            append(tangents, mesh.tangents, vertex);
        for (std::size_t k = 0; k < 2 && !mesh.uvs.empty(); ++k) {
            const float up = uv == NONE ? 0 : mesh.uvs[2 * std::size_t{uv} + k];
            out.uvs.push_back(k == 1 ? 1 - up : up);
        }
        for (std::size_t k = 0; k < (mesh.has_alpha ? 4u : 3u) && !mesh.colours.empty(); ++k) {
            const float component = mesh.colours[4 * std::size_t{vertex} + k];
            out.colours.push_back(k == 3 ? component : linear(component));
        }
    }
    make_unit(normals);
    make_unit(tangents);
    out.normals.assign(normals.begin(), normals.end());
    for (std::size_t i = 0; i < tangents.size() / 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            out.tangents.push_back(static_cast<float>(tangents[3 * i + axis]));
        out.tangents.push_back(mesh.tangent_signs.empty() ? 1 : mesh.tangent_signs[vertices.keys[i][0]]);
    }
    for (const Triangle &triangle : triangles(mesh))
        for (std::uint32_t corner : triangle)
            out.triangles.push_back(vertices.of_corner[corner]);
    for (const Edge &line : mesh.lines)
        out.lines.insert(out.lines.end(), {vertices.of_vertex[line.first], vertices.of_vertex[line.second]});
    return out;
}

} // namespace motorway::tool
