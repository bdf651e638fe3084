#include "simplify.h"

#include <algorithm>
#include <map>
#include <utility>

#include "normals.h"

namespace motorway::tool {
namespace {

using Cell = std::array<int, 3>;

Cell cell_of(const Mesh &mesh, const Box &box, std::size_t vertex, int cells)
{
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double place = (mesh.positions[3 * vertex + axis] - box.low[axis]) / box.longest_side();
        cell[axis] = std::min(static_cast<int>(place * cells), cells - 1);
    }
    return cell;
}

/* Merges by a grid of this many cells along the longest side. */
Mesh clustered(const Mesh &mesh, int cells)
{
    const Box box = bounding_box(mesh);
    const std::vector<double> normals = vertex_normals(mesh, mesh.normals);
    std::map<Cell, std::uint32_t> numbers;
    std::vector<std::uint32_t> merged(mesh.vertex_count());
    std::vector<double> positions, directions, counts;
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        const auto next = static_cast<std::uint32_t>(numbers.size());
        const std::uint32_t number = numbers.try_emplace(cell_of(mesh, box, vertex, cells), next).first->second;
        positions.resize(3 * numbers.size());
        directions.resize(3 * numbers.size());
        counts.resize(numbers.size());
        merged[vertex] = number;
        counts[number] += 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            positions[3 * std::size_t{number} + axis] += mesh.positions[3 * vertex + axis];
            directions[3 * std::size_t{number} + axis] += normals[3 * vertex + axis];
        }
    }
    Mesh out;
    for (std::size_t i = 0; i < positions.size(); ++i)
        out.positions.push_back(positions[i] / counts[i / 3]);
    make_unit(directions);
    out.normals = std::move(directions);
    out.in_double = mesh.in_double;
    for (const Triangle &triangle : triangles(mesh)) {
        std::uint32_t corner[3];
        for (std::size_t k = 0; k < 3; ++k)
            corner[k] = merged[mesh.corners[triangle[k]]];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            continue;
        out.corners.insert(out.corners.end(), corner, corner + 3);
        out.face_starts.push_back(out.corners.size());
    }
    for (const auto &[from, to] : mesh.lines)
        if (merged[from] != merged[to])
            out.lines.emplace_back(merged[from], merged[to]);
    return out;
}

} // namespace

Mesh simplified(const Mesh &mesh, std::size_t most_triangles)
{
    if (mesh.corners.size() - 2 * mesh.face_count() <= most_triangles)
        return mesh;
    int cells = 128;
    Mesh coarse = clustered(mesh, cells);
    while (coarse.face_count() > most_triangles && cells > 4) {
        cells = cells * 5 / 6;
        coarse = clustered(mesh, cells);
    }
    return coarse;
}

} // namespace motorway::tool
