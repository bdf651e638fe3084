#include "mesh.h"

#include <algorithm>
#include <cmath>

#include "error.h"
#include "files.h"
#include "obj.h"
#include "ply.h"

namespace motorway::tool {

static double length(double x, double y, double z)
{
    return std::sqrt(x * x + y * y + z * z);
}

double Box::longest_side() const
{
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

double Box::diagonal() const
{
    return length(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

Mesh read_mesh(const std::string &path)
{
    const std::string kind = extension(path);
    if (kind != ".obj" && kind != ".ply")
        throw Error(path, "unknown kind of mesh; the tool reads .obj and .ply");
    const std::string contents = read_file(path);
    Mesh mesh = kind == ".obj" ? read_obj(contents, path) : read_ply(contents, path);
    if (mesh.vertex_count() == 0)
        throw Error(path, "has no vertices; give a mesh");
    if (mesh.face_count() == 0)
        throw Error(path, "has no faces; give a mesh, not a cloud of points");
    return mesh;
}

Box bounding_box(const Mesh &mesh)
{
    Box box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double value = mesh.positions[i];
        box.low[i % 3] = std::min(box.low[i % 3], value);
        box.high[i % 3] = std::max(box.high[i % 3], value);
    }
    return box;
}

std::vector<Edge> edges(const Mesh &mesh)
{
    std::vector<Edge> all;
    all.reserve(mesh.corners.size());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        for (std::size_t corner = begin; corner < end; ++corner) {
            const std::uint32_t a = mesh.corners[corner], b = mesh.corners[corner + 1 < end ? corner + 1 : begin];
            if (a != b)
                all.push_back(std::minmax(a, b));
        }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<Triangle> triangles(const Mesh &mesh)
{
    std::vector<Triangle> fans;
    fans.reserve(mesh.corners.size() - 2 * mesh.face_count());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        for (std::size_t corner = begin + 2; corner < end; ++corner)
            fans.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(corner - 1),
                            static_cast<std::uint32_t>(corner)});
    }
    return fans;
}

std::vector<float> unit_vectors(const std::vector<double> &vectors)
{
    std::vector<float> units(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); i += 3) {
        const double size = length(vectors[i], vectors[i + 1], vectors[i + 2]);
        const bool some = size > 0 && std::isfinite(size);
        units[i] = some ? static_cast<float>(vectors[i] / size) : 0.0f;
        units[i + 1] = some ? static_cast<float>(vectors[i + 1] / size) : 0.0f;
        units[i + 2] = some ? static_cast<float>(vectors[i + 2] / size) : 1.0f;
    }
    return units;
}

/* Twice the vector area of a face, right for every plane polygon, convex or not. */
static std::array<double, 3> vector_area(const Mesh &mesh, std::size_t begin, std::size_t end)
{
    std::array<double, 3> area{};
    const float *first = &mesh.positions[3 * std::size_t{mesh.corners[begin]}];
    for (std::size_t corner = begin + 2; corner < end; ++corner) {
        const float *p = &mesh.positions[3 * std::size_t{mesh.corners[corner - 1]}];
        const float *q = &mesh.positions[3 * std::size_t{mesh.corners[corner]}];
        double u[3], v[3];
        for (int k = 0; k < 3; ++k) {
            u[k] = static_cast<double>(p[k]) - first[k];
            v[k] = static_cast<double>(q[k]) - first[k];
        }
        area[0] += u[1] * v[2] - u[2] * v[1];
        area[1] += u[2] * v[0] - u[0] * v[2];
        area[2] += u[0] * v[1] - u[1] * v[0];
    }
    return area;
}

void add_missing_normals(Mesh &mesh)
{
    if (!mesh.normals.empty())
        return;
    std::vector<double> sums(mesh.positions.size(), 0.0);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        const std::array<double, 3> area = vector_area(mesh, begin, end);
        for (std::size_t corner = begin; corner < end; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sums[3 * std::size_t{mesh.corners[corner]} + axis] += area[axis];
    }
    mesh.normals = unit_vectors(sums);
}

std::vector<float> vertex_normals(const Mesh &mesh, const std::vector<float> &normals)
{
    if (mesh.corner_normals.empty())
        return normals;
    std::vector<double> sums(mesh.positions.size(), 0.0);
    for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
            sums[3 * std::size_t{mesh.corners[corner]} + axis] +=
                normals[3 * std::size_t{mesh.corner_normals[corner]} + axis];
    return unit_vectors(sums);
}

} // namespace motorway::tool
