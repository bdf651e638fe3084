#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.h"
#include "files.h"
#include "obj.h"
#include "ply.h"
#include "text.h"

namespace motorway::tool {

bool Mesh::has_vertex_normals() const
{
    return !normals.empty() && corner_normals.empty() && normals.size() == positions.size();
}

bool Mesh::has_vertex_uvs() const
{
    return !uvs.empty() && corner_uvs.empty() && uvs.size() / 2 == vertex_count();
}

bool Mesh::has_finite_position(std::size_t vertex) const
{
    const double *p = &positions[3 * vertex];
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

float drawable(double number)
{
    return std::abs(number) <= std::numeric_limits<float>::max() ? static_cast<float>(number) : 0.0f;
}

double Box::longest_side() const
{
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

double Box::diagonal() const
{
    return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/* Points that have no place are common in scans, where a sensor saw nothing. */
static void warn_of_missing_points(Mesh &mesh, const std::string &path)
{
    std::uint64_t missing = 0;
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        missing += !mesh.has_finite_position(vertex);
    if (missing == mesh.vertex_count())
        throw Error(path, "has no vertex whose coordinates are finite numbers; give a mesh");
    if (missing > 0)
        mesh.warnings.push_back(counted(missing, "vertex") +
                                " with coordinates that are not finite: kept in meshes, and left out of pictures, .glb "
                                "files and measurements");
}

Mesh read_mesh(const std::string &path)
{
    const std::string kind = extension(path);
    if (kind != ".obj" && kind != ".ply")
        throw Error(path, "unknown kind of mesh; the tool reads .obj and .ply");
    const std::string contents = read_file(path);
    Mesh mesh = kind == ".obj" ? read_obj(contents, path) : read_ply(contents, path);
    if (mesh.vertex_count() == 0)
        throw Error(path, "has no vertices; is this " + std::string(kind == ".obj" ? "an OBJ" : "a PLY") +
                              " file of a mesh or a cloud of points?");
    warn_of_missing_points(mesh, path);
    return mesh;
}

Box bounding_box(const Mesh &mesh)
{
    Box box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        for (std::size_t axis = 0; axis < 3 && mesh.has_finite_position(vertex); ++axis) {
            const double value = mesh.positions[3 * vertex + axis];
            box.low[axis] = std::min(box.low[axis], value);
            box.high[axis] = std::max(box.high[axis], value);
        }
    return box;
}

std::array<double, 3> far_origin(const Mesh &mesh)
{
    constexpr double FAR = 100;
    const Box box = bounding_box(mesh);
    std::array<double, 3> middle;
    double offset = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = std::round(box.low[axis] / 2 + box.high[axis] / 2);
        offset = std::max(offset, std::abs(middle[axis]));
    }
    return box.diagonal() > 0 && offset > FAR * box.diagonal() ? middle : std::array<double, 3>{};
}

std::vector<Edge> edges(const Mesh &mesh)
{
    std::vector<Edge> all;
    all.reserve(mesh.corners.size() + mesh.lines.size());
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
        if (a != b)
            all.push_back(std::minmax(a, b));
    };
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        for (std::size_t corner = begin; corner < end; ++corner)
            add(mesh.corners[corner], mesh.corners[corner + 1 < end ? corner + 1 : begin]);
    }
    for (const Edge &line : mesh.lines)
        add(line.first, line.second);
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

/* Those of `from` that belong to these vertices, `width` numbers each. */
template <class T>
static std::vector<T> chosen(const std::vector<T> &from, std::size_t width, const std::vector<std::uint32_t> &vertices)
{
    std::vector<T> out;
    if (from.empty())
        return out;
    out.reserve(width * vertices.size());
    for (std::size_t vertex : vertices)
        out.insert(out.end(), from.begin() + static_cast<std::ptrdiff_t>(width * vertex),
                   from.begin() + static_cast<std::ptrdiff_t>(width * (vertex + 1)));
    return out;
}

/* The faces of `from` whose vertices all have a number among `numbers`. */
static void copy_numbered_faces(Mesh &to, const Mesh &from, const std::vector<std::uint32_t> &numbers)
{
    for (std::size_t face = 0; face < from.face_count(); ++face) {
        const std::size_t begin = from.face_starts[face], end = from.face_starts[face + 1];
        bool whole = true;
        for (std::size_t corner = begin; corner < end; ++corner)
            whole = whole && numbers[from.corners[corner]] != NONE;
        for (std::size_t corner = begin; whole && corner < end; ++corner) {
            to.corners.push_back(numbers[from.corners[corner]]);
            if (!from.corner_normals.empty())
                to.corner_normals.push_back(from.corner_normals[corner]);
            if (!from.corner_uvs.empty())
                to.corner_uvs.push_back(from.corner_uvs[corner]);
        }
        if (whole)
            to.face_starts.push_back(to.corners.size());
    }
    if (to.corner_normals.empty() && !from.corner_normals.empty())
        to.normals.clear();
    if (to.corner_uvs.empty() && !from.corner_uvs.empty())
        to.uvs.clear();
}

Mesh finite_part(const Mesh &mesh)
{
    std::vector<std::uint32_t> numbers(mesh.vertex_count(), NONE), vertices;
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        if (mesh.has_finite_position(vertex)) {
            numbers[vertex] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(static_cast<std::uint32_t>(vertex));
        }
    if (vertices.size() == mesh.vertex_count())
        return mesh;
    Mesh part;
    part.in_double = mesh.in_double;
    part.has_alpha = mesh.has_alpha;
    part.positions = chosen(mesh.positions, 3, vertices);
    part.tangents = chosen(mesh.tangents, 3, vertices);
    part.bitangents = chosen(mesh.bitangents, 3, vertices);
    part.tangent_signs = chosen(mesh.tangent_signs, 1, vertices);
    part.colours = chosen(mesh.colours, 4, vertices);
    part.normals = mesh.has_vertex_normals() ? chosen(mesh.normals, 3, vertices) : mesh.normals;
    part.uvs = mesh.has_vertex_uvs() ? chosen(mesh.uvs, 2, vertices) : mesh.uvs;
    copy_numbered_faces(part, mesh, numbers);
    for (const Edge &line : mesh.lines)
        if (numbers[line.first] != NONE && numbers[line.second] != NONE)
            part.lines.emplace_back(numbers[line.first], numbers[line.second]);
    return part;
}

} // namespace motorway::tool
