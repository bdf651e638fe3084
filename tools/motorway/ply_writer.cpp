/* Meshes of other kinds as PLY. */
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "normals.h"
#include "ply.h"
#include "ply_source.h"

namespace motorway::tool {
namespace {

class PlyWriter {
public:
    PlyWriter(const Mesh &mesh, const Pose &pose)
        : mesh_(mesh), pose_(pose), has_normals_(has_all_normals(mesh)),
          has_bytes_(std::all_of(mesh.colours.begin(), mesh.colours.end(), is_byte)),
          corner_uvs_(!mesh.corner_uvs.empty())
    {
        for (std::size_t face = 0; face < mesh.face_count(); ++face)
            most_corners_ = std::max(most_corners_, mesh.face_starts[face + 1] - mesh.face_starts[face]);
    }

    std::string write()
    {
        write_header();
        write_vertices();
        for (std::size_t face = 0; face < mesh_.face_count(); ++face)
            write_face(mesh_.face_starts[face], mesh_.face_starts[face + 1]);
        for (const Edge &line : mesh_.lines) {
            append_unsigned(line.first, 4);
            append_unsigned(line.second, 4);
        }
        return std::move(out_);
    }

private:
    static bool is_byte(float component)
    {
        return std::abs(component * 255 - std::round(component * 255)) < 1e-3f;
    }

    /* The usual type of a length, which every reader knows, where it suffices. */
    static bool is_short(std::size_t longest) { return longest < 256; }

    void declare(const char *type, std::initializer_list<const char *> names)
    {
        for (const char *name : names)
            out_ += std::string("property ") + type + " " + name + "\n";
    }

    void write_header()
    {
        const char *const real = mesh_.in_double ? "double" : "float";
        out_ = "ply\nformat binary_little_endian 1.0\ncomment motorway\nelement vertex " +
               std::to_string(mesh_.vertex_count()) + "\n";
        declare(real, {"x", "y", "z"});
        if (has_normals_)
            declare(real, {"nx", "ny", "nz"});
        if (!mesh_.colours.empty())
            declare(has_bytes_ ? "uchar" : "float", {"red", "green", "blue"});
        if (mesh_.has_alpha)
            declare(has_bytes_ ? "uchar" : "float", {"alpha"});
        if (mesh_.has_vertex_uvs())
            declare("float", {"s", "t"});
        if (mesh_.face_count() > 0) {
            out_ += "element face " + std::to_string(mesh_.face_count()) + "\n";
            declare(is_short(most_corners_) ? "list uchar int" : "list uint int", {"vertex_indices"});
            if (corner_uvs_)
                declare(is_short(2 * most_corners_) ? "list uchar float" : "list uint float", {"texcoord"});
        }
        if (!mesh_.lines.empty()) {
            out_ += "element edge " + std::to_string(mesh_.lines.size()) + "\n";
            declare("int", {"vertex1", "vertex2"});
        }
        out_ += "end_header\n";
    }

    void write_vertices()
    {
        const std::vector<double> normals =
            has_normals_ ? vertex_normals(mesh_, pose_.normals) : std::vector<double>();
        for (std::size_t vertex = 0; vertex < mesh_.vertex_count(); ++vertex) {
            append_vector(&pose_.positions[3 * vertex]);
            if (has_normals_)
                append_vector(&normals[3 * vertex]);
            for (std::size_t k = 0; k < (mesh_.has_alpha ? 4u : 3u) && !mesh_.colours.empty(); ++k)
                append_colour(mesh_.colours[4 * vertex + k]);
            for (std::size_t k = 0; k < 2 && mesh_.has_vertex_uvs(); ++k)
                append_float(mesh_.uvs[2 * vertex + k]);
        }
    }

    void write_face(std::size_t begin, std::size_t end)
    {
        append_unsigned(end - begin, is_short(most_corners_) ? 1 : 4);
        for (std::size_t corner = begin; corner < end; ++corner)
            append_unsigned(mesh_.corners[corner], 4);
        if (!corner_uvs_)
            return;
        append_unsigned(2 * (end - begin), is_short(2 * most_corners_) ? 1 : 4);
        for (std::size_t corner = begin; corner < end; ++corner)
            for (std::size_t k = 0; k < 2; ++k) {
                const std::size_t uv = mesh_.corner_uvs[corner];
                append_float(uv == NONE ? 0.0f : mesh_.uvs[2 * uv + k]);
            }
    }

    void append_vector(const double *vector)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            append_ply_number(out_, vector[axis], mesh_.in_double ? PlyType::float64 : PlyType::float32,
                              PlyFormat::little_endian);
    }

    void append_float(float value) { append_ply_number(out_, value, PlyType::float32, PlyFormat::little_endian); }

    void append_colour(float component)
    {
        if (has_bytes_)
            out_ += static_cast<char>(std::lround(component * 255));
        else
            append_float(component);
    }

    void append_unsigned(std::size_t value, std::size_t bytes)
    {
        for (std::size_t k = 0; k < bytes; ++k)
            out_ += static_cast<char>(value >> 8 * k & 0xff);
    }

    const Mesh &mesh_;
    const Pose &pose_;
    bool has_normals_, has_bytes_, corner_uvs_;
    std::size_t most_corners_ = 0;
    std::string out_;
};

} // namespace

std::string write_ply(const Mesh &mesh, const Pose &pose)
{
    return PlyWriter(mesh, pose).write();
}

} // namespace motorway::tool
