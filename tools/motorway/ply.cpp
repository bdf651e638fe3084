#include "ply.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "error.h"
#include "ply_header.h"
#include "ply_values.h"
#include "text.h"

namespace motorway::tool {
namespace {

class PlyReader {
public:
    PlyReader(const std::string &contents, const std::string &path)
        : path_(path), header_(read_ply_header(contents, path)), values_(ply_values(header_, contents, path))
    {
    }

    Mesh read()
    {
        for (const PlyElement &element : header_.elements) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                skip(element);
        }
        check_indices();
        mesh_.left_out.assign(left_out_.begin(), left_out_.end());
        return std::move(mesh_);
    }

private:
    static constexpr std::size_t NOWHERE = std::numeric_limits<std::size_t>::max();

    /* The index of each property among `names`; those not among them are NOWHERE, and will be left out. */
    std::vector<std::size_t> slots(const PlyElement &element, const std::vector<std::string> &names)
    {
        std::vector<std::size_t> places;
        for (const PlyProperty &property : element.properties) {
            const auto found = std::find(names.begin(), names.end(), property.name);
            const bool known = found != names.end() && !property.is_list;
            places.push_back(known ? static_cast<std::size_t>(found - names.begin()) : NOWHERE);
            if (!known)
                left_out_.insert(element.name + " " + in_quotes(property.name));
        }
        return places;
    }

    void read_vertices(const PlyElement &element)
    {
        const std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz"};
        const std::vector<std::size_t> places = slots(element, names);
        const auto has = [&](std::size_t slot) {
            return std::find(places.begin(), places.end(), slot) != places.end();
        };
        if (!has(0) || !has(1) || !has(2))
            throw Error(path_ + ":" + std::to_string(element.line), "the vertices have no x, y and z; add them");
        const bool has_normals = has(3) && has(4) && has(5);
        if (!has_normals && (has(3) || has(4) || has(5)))
            left_out_.insert("incomplete normals");
        for (std::uint64_t row = 0; row < element.count; ++row) {
            double value[6] = {};
            for (std::size_t k = 0; k < places.size(); ++k) {
                if (places[k] == NOWHERE)
                    skip(element.properties[k], element.name, row);
                else
                    value[places[k]] = coordinate(element.properties[k], element.name, row);
            }
            for (int k = 0; k < 3; ++k)
                mesh_.positions.push_back(static_cast<float>(value[k]));
            for (int k = 3; has_normals && k < 6; ++k)
                mesh_.normals.push_back(static_cast<float>(value[k]));
        }
    }

    double coordinate(const PlyProperty &property, const std::string &name, std::uint64_t row)
    {
        const double value = values_->real(property.type, name, row);
        if (!std::isfinite(static_cast<float>(value)))
            throw values_->error(name, row, property.name + " is not a finite float; correct it");
        return value;
    }

    void read_faces(const PlyElement &element)
    {
        const auto is_corners = [](const PlyProperty &property) {
            return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
        };
        const auto corners = std::find_if(element.properties.begin(), element.properties.end(), is_corners);
        if (corners == element.properties.end() || !ply_is_integer(corners->type))
            throw Error(path_ + ":" + std::to_string(element.line),
                        "the faces have no list vertex_indices of whole numbers; add one");
        for (const PlyProperty &property : element.properties)
            if (&property != &*corners)
                left_out_.insert(element.name + " " + in_quotes(property.name));
        for (std::uint64_t row = 0; row < element.count; ++row)
            for (const PlyProperty &property : element.properties) {
                if (&property == &*corners)
                    read_corners(property, element.name, row);
                else
                    skip(property, element.name, row);
            }
    }

    void read_corners(const PlyProperty &property, const std::string &name, std::uint64_t row)
    {
        const std::uint64_t count = list_length(property, name, row);
        if (count < 3)
            throw values_->error(name, row,
                                 "there are " + std::to_string(count) + " corners; a face needs 3 or more");
        for (std::uint64_t k = 0; k < count; ++k) {
            const std::int64_t index = values_->integer(property.type, name, row);
            if (index < 0 || index > std::numeric_limits<std::uint32_t>::max())
                throw values_->error(name, row,
                                     "vertex " + std::to_string(index) + " does not exist; correct the index");
            mesh_.corners.push_back(static_cast<std::uint32_t>(index));
        }
        mesh_.face_starts.push_back(mesh_.corners.size());
        if (values_->line() != 0)
            face_lines_.push_back(values_->line());
    }

    std::uint64_t list_length(const PlyProperty &property, const std::string &name, std::uint64_t row)
    {
        const std::int64_t count = values_->integer(property.count_type, name, row);
        if (count < 0)
            throw values_->error(name, row, "the length of " + property.name + " is negative; correct it");
        values_->check_room(property.type, static_cast<std::uint64_t>(count), name, row);
        return static_cast<std::uint64_t>(count);
    }

    void skip(const PlyProperty &property, const std::string &name, std::uint64_t row)
    {
        const std::uint64_t count = property.is_list ? list_length(property, name, row) : 1;
        for (std::uint64_t k = 0; k < count; ++k)
            values_->real(property.type, name, row);
    }

    void skip(const PlyElement &element)
    {
        left_out_.insert("element " + in_quotes(element.name));
        for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row)
            for (const PlyProperty &property : element.properties)
                skip(property, element.name, row);
    }

    /* At the end, because a file may give its faces before its vertices. */
    void check_indices() const
    {
        for (std::size_t face = 0; face < mesh_.face_count(); ++face)
            for (std::size_t corner = mesh_.face_starts[face]; corner < mesh_.face_starts[face + 1]; ++corner)
                if (mesh_.corners[corner] >= mesh_.vertex_count())
                    throw Error(face_lines_.empty() ? path_ : path_ + ":" + std::to_string(face_lines_[face]),
                                "face " + std::to_string(face) + " has vertex " +
                                    std::to_string(mesh_.corners[corner]) + ", but there are " +
                                    std::to_string(mesh_.vertex_count()) + " (counting from 0); correct the index");
    }

    std::string path_;
    PlyHeader header_;
    std::unique_ptr<PlyValues> values_;
    Mesh mesh_;
    std::vector<std::size_t> face_lines_;
    std::set<std::string> left_out_;
};

void append_unsigned(std::string &out, std::uint32_t bits, int bytes)
{
    for (int k = 0; k < bytes; ++k)
        out += static_cast<char>(bits >> 8 * k & 0xff);
}

void append_f32(std::string &out, float value)
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    append_unsigned(out, bits, 4);
}

} // namespace

Mesh read_ply(const std::string &contents, const std::string &path)
{
    return PlyReader(contents, path).read();
}

std::string write_ply(const Mesh &mesh, const std::vector<float> &positions, const std::vector<float> &normals)
{
    std::size_t most_corners = 0;
    for (std::size_t face = 0; face < mesh.face_count(); ++face)
        most_corners = std::max(most_corners, mesh.face_starts[face + 1] - mesh.face_starts[face]);
    const bool short_lists = most_corners < 256; /* the usual type of the length, which every reader knows */
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment motorway\nelement vertex " +
                      std::to_string(mesh.vertex_count()) +
                      "\nproperty float x\nproperty float y\nproperty float z\n"
                      "property float nx\nproperty float ny\nproperty float nz\nelement face " +
                      std::to_string(mesh.face_count()) + "\nproperty list " + (short_lists ? "uchar" : "uint") +
                      " int vertex_indices\nend_header\n";
    const std::vector<float> one_a_vertex = vertex_normals(mesh, normals);
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            append_f32(out, positions[i + axis]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            append_f32(out, one_a_vertex[i + axis]);
    }
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        append_unsigned(out, static_cast<std::uint32_t>(end - begin), short_lists ? 1 : 4);
        for (std::size_t corner = begin; corner < end; ++corner)
            append_unsigned(out, mesh.corners[corner], 4);
    }
    return out;
}

} // namespace motorway::tool
