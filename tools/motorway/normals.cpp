#include "normals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace motorway::tool {

/* Twice the vector area of a face, right for every plane polygon, convex or not. */
static std::array<double, 3> vector_area(const Mesh &mesh, std::size_t begin, std::size_t end)
{
    std::array<double, 3> area{};
    const double *first = &mesh.positions[3 * std::size_t{mesh.corners[begin]}];
    for (std::size_t corner = begin + 2; corner < end; ++corner) {
        const double *p = &mesh.positions[3 * std::size_t{mesh.corners[corner - 1]}];
        const double *q = &mesh.positions[3 * std::size_t{mesh.corners[corner]}];
        double u[3], v[3];
        for (int k = 0; k < 3; ++k) {
            u[k] = p[k] - first[k];
            v[k] = q[k] - first[k];
        }
        area[0] += u[1] * v[2] - u[2] * v[1];
        area[1] += u[2] * v[0] - u[0] * v[2];
        area[2] += u[0] * v[1] - u[1] * v[0];
    }
    return area;
}

static std::vector<double> normals_of_vertices(const Mesh &mesh)
{
    std::vector<double> sums(mesh.positions.size(), 0.0);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        const std::array<double, 3> area = vector_area(mesh, begin, end);
        for (std::size_t corner = begin; corner < end; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sums[3 * std::size_t{mesh.corners[corner]} + axis] += area[axis];
    }
    make_unit(sums);
    return sums;
}

void add_missing_normals(Mesh &mesh)
{
    if (mesh.corners.empty() || has_all_normals(mesh))
        return;
    const std::vector<double> made = normals_of_vertices(mesh);
    const auto has_one = [](std::uint32_t normal) { return normal != NONE; };
    if (std::none_of(mesh.corner_normals.begin(), mesh.corner_normals.end(), has_one)) {
        mesh.normals = made;
        mesh.corner_normals.clear();
        return;
    }
    const auto first = static_cast<std::uint32_t>(mesh.normal_count());
    mesh.normals.insert(mesh.normals.end(), made.begin(), made.end());
    for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner)
        if (mesh.corner_normals[corner] == NONE)
            mesh.corner_normals[corner] = first + mesh.corners[corner];
}

bool has_all_normals(const Mesh &mesh)
{
    const auto &given = mesh.corner_normals;
    return mesh.has_vertex_normals() || (!given.empty() && std::find(given.begin(), given.end(), NONE) == given.end());
}

std::vector<double> vertex_normals(const Mesh &mesh, const std::vector<double> &normals)
{
    if (mesh.corner_normals.empty())
        return normals;
    std::vector<double> sums(mesh.positions.size(), 0.0);
    for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
            sums[3 * std::size_t{mesh.corners[corner]} + axis] +=
                normals[3 * std::size_t{mesh.corner_normals[corner]} + axis];
    make_unit(sums);
    return sums;
}

void make_unit(std::vector<double> &vectors)
{
    for (std::size_t i = 0; i + 2 < vectors.size(); i += 3) {
        const double size = std::hypot(vectors[i], vectors[i + 1], vectors[i + 2]);
        const bool some = size > 0 && std::isfinite(size);
        for (std::size_t axis = 0; axis < 3; ++axis)
            vectors[i + axis] = some ? vectors[i + axis] / size : axis == 2 ? 1.0 : 0.0;
    }
}

} // namespace motorway::tool
