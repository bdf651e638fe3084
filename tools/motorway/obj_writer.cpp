/* Meshes of other kinds as OBJ. */
#include "obj.h"
#include "text.h"

namespace motorway::tool {
namespace {

/* As many digits as the mesh has. */
void append_vector(std::string &text, const Mesh &mesh, const double *vector)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        text += ' ';
        if (mesh.in_double)
            append_number(text, vector[axis]);
        else
            append_number(text, static_cast<float>(vector[axis]));
    }
}

void append_vertices(std::string &text, const Mesh &mesh, const Pose &pose)
{
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        text += 'v';
        append_vector(text, mesh, &pose.positions[3 * vertex]);
        for (std::size_t k = 0; k < 3 && !mesh.colours.empty(); ++k) {
            text += ' ';
            append_number(text, mesh.colours[4 * vertex + k]);
        }
        text += '\n';
    }
    for (std::size_t i = 0; i < mesh.uvs.size(); i += 2) {
        text += "vt ";
        append_number(text, mesh.uvs[i]);
        text += ' ';
        append_number(text, mesh.uvs[i + 1]);
        text += '\n';
    }
    for (std::size_t normal = 0; normal < mesh.normal_count(); ++normal) {
        text += "vn";
        append_vector(text, mesh, &pose.normals[3 * normal]);
        text += '\n';
    }
}

/* v, v/vt, v//vn or v/vt/vn */
void append_corner(std::string &text, const Mesh &mesh, std::size_t corner)
{
    const std::uint32_t vertex = mesh.corners[corner];
    const auto number = [&](const std::vector<std::uint32_t> &numbers, bool by_vertex) {
        return !numbers.empty() ? numbers[corner] : by_vertex ? vertex : NONE;
    };
    const std::uint32_t uv = number(mesh.corner_uvs, mesh.has_vertex_uvs());
    const std::uint32_t normal = number(mesh.corner_normals, mesh.has_vertex_normals());
    text += ' ' + std::to_string(vertex + 1ull);
    if (uv != NONE || normal != NONE)
        text += '/';
    if (uv != NONE)
        text += std::to_string(uv + 1ull);
    if (normal != NONE)
        text += '/' + std::to_string(normal + 1ull);
}

} // namespace

std::string write_obj(const Mesh &mesh, const Pose &pose)
{
    std::string text = "# motorway\n";
    append_vertices(text, mesh, pose);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        text += 'f';
        for (std::size_t corner = mesh.face_starts[face]; corner < mesh.face_starts[face + 1]; ++corner)
            append_corner(text, mesh, corner);
        text += '\n';
    }
    for (const Edge &line : mesh.lines)
        text += "l " + std::to_string(line.first + 1ull) + " " + std::to_string(line.second + 1ull) + "\n";
    return text;
}

} // namespace motorway::tool
