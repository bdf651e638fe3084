#include "ply.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "error.h"
#include "ply_header.h"
#include "ply_source.h"
#include "ply_values.h"
#include "ply_vertices.h"
#include "source_text.h"
#include "text.h"

namespace motorway::tool {
namespace {

std::shared_ptr<PlySource> read_source(std::string_view contents, const std::string &path)
{
    const auto source = std::make_shared<PlySource>();
    const std::size_t header_size = ply_header_size(contents);
    const std::string_view body = contents.substr(header_size);
    SourceText text = normalised_text(contents.substr(0, header_size), path);
    source->header = read_ply_header(text.text, body.size(), path);
    if (source->header.format == PlyFormat::ascii)
        text = normalised_text(contents, path);
    else
        text.text += body;
    source->text = std::move(text.text);
    source->line_end = std::move(text.line_end);
    return source;
}

const PlyProperty *find_property(const PlyElement &element, std::initializer_list<std::string_view> names,
                                 bool is_list)
{
    for (const PlyProperty &property : element.properties)
        if (property.is_list == is_list && std::find(names.begin(), names.end(), property.name) != names.end())
            return &property;
    return nullptr;
}

class PlyReader {
public:
    PlyReader(const std::string &contents, const std::string &path)
        : path_(path), source_(read_source(contents, path)),
          values_(ply_values(source_->header, source_->text, source_->header.body, path))
    {
    }

    Mesh read()
    {
        const std::vector<PlyElement> &elements = source_->header.elements;
        for (std::size_t k = 0; k < elements.size(); ++k) {
            if (elements[k].name == "vertex")
                read_vertices(elements[k], k);
            else if (elements[k].name == "face")
                read_faces(elements[k], k);
            else if (elements[k].name == "tristrips")
                read_strips(elements[k]);
            else if (elements[k].name == "edge")
                read_edges(elements[k]);
            else
                read_other(elements[k]);
        }
        check_indices();
        settle_uvs();
        settle_remarks();
        mesh_.source = source_;
        return std::move(mesh_);
    }

private:
    /* Where a face was read: its number, and its line if the file has any. */
    struct Place {
        std::uint64_t row;
        std::size_t line;
    };

    void read_vertices(const PlyElement &element, std::size_t number)
    {
        const PlySlots slots = ply_slots(element, path_, beyond_);
        will_move(number, slots);
        read_ply_vertices(mesh_, element, slots, *values_);
    }

    /* The element whose values come next. */
    void will_move(std::size_t number, const PlySlots &slots)
    {
        source_->moved.push_back({number, values_->end(), slots});
        const std::vector<PlyProperty> &properties = source_->header.elements[number].properties;
        for (std::size_t k = 0; k < slots.size(); ++k)
            if (slots[k] < ply_slot::MOVED && ply_is_integer(properties[k].type))
                whole_numbers_ += (whole_numbers_.empty() ? "" : ", ") + properties[k].name;
    }

    void read_faces(const PlyElement &element, std::size_t number)
    {
        const PlyProperty *const corners = corner_list(element), *const uvs = uv_list(element);
        const PlySlots slots = ply_face_slots(element);
        const bool has_normals = std::find(slots.begin(), slots.end(), ply_slot::FACE_NORMAL) != slots.end();
        if (has_normals)
            will_move(number, slots);
        mesh_.in_double = mesh_.in_double || ply_moves_doubles(element, slots);
        leave_all_but(element, {corners, uvs}, slots);
        std::vector<std::uint32_t> face;
        std::vector<float> face_uvs;
        for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
            face.clear();
            face_uvs.clear();
            double normal[3] = {};
            for (std::size_t k = 0; k < slots.size(); ++k) {
                const PlyProperty &property = element.properties[k];
                if (slots[k] != ply_slot::NOWHERE)
                    normal[slots[k] % 3] = values_->real(property.type, element.name, row);
                else if (&property == corners)
                    read_indices(face, property, element.name, row);
                else if (&property == uvs)
                    read_reals(face_uvs, property, element.name, row);
                else
                    skip_ply_property(*values_, property, element.name, row);
            }
            if (has_normals)
                mesh_.face_normals.insert(mesh_.face_normals.end(), normal, normal + 3);
            if (corners)
                add_face(face, face_uvs);
        }
    }

    /* Triangles of three neighbours each; their senses alternate, and -1 begins a new strip. */
    void read_strips(const PlyElement &element)
    {
        const PlyProperty *const list = corner_list(element);
        leave_all_but(element, {list});
        std::vector<std::uint32_t> strip;
        for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row)
            for (const PlyProperty &property : element.properties) {
                if (&property != list) {
                    skip_ply_property(*values_, property, element.name, row);
                    continue;
                }
                strip.clear();
                read_indices(strip, property, element.name, row, true);
                add_strips(strip);
            }
    }

    void read_edges(const PlyElement &element)
    {
        const PlyProperty *const from = find_property(element, {"vertex1"}, false);
        const PlyProperty *const to = find_property(element, {"vertex2"}, false);
        const bool whole = from && to && ply_is_integer(from->type) && ply_is_integer(to->type);
        if (!whole) {
            read_other(element);
            return;
        }
        leave_all_but(element, {from, to});
        for (std::uint64_t row = 0; row < element.count; ++row) {
            std::int64_t ends[2] = {};
            for (const PlyProperty &property : element.properties) {
                if (&property == from || &property == to)
                    ends[&property == to] = values_->integer(property.type, element.name, row);
                else
                    skip_ply_property(*values_, property, element.name, row);
            }
            if (std::min(ends[0], ends[1]) >= 0 && std::max(ends[0], ends[1]) < NONE)
                mesh_.lines.emplace_back(static_cast<std::uint32_t>(ends[0]), static_cast<std::uint32_t>(ends[1]));
        }
    }

    void read_other(const PlyElement &element)
    {
        beyond_.insert("element " + in_quotes(element.name));
        if (find_property(element, {"x"}, false) && find_property(element, {"y"}, false) &&
            find_property(element, {"z"}, false))
            mesh_.notes.push_back("the element " + in_quotes(element.name) +
                                  " has x, y and z too, and stays where it is: only vertices are moved");
        for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row)
            for (const PlyProperty &property : element.properties)
                skip_ply_property(*values_, property, element.name, row);
    }

    /* The list of the vertices of a face or strip, or null. */
    const PlyProperty *corner_list(const PlyElement &element)
    {
        const PlyProperty *const list = find_property(element, {"vertex_indices", "vertex_index"}, true);
        if (list && ply_is_integer(list->type))
            return list;
        if (element.count > 0)
            mesh_.warnings.push_back("the element " + in_quotes(element.name) +
                                     " has no list vertex_indices of whole numbers: " + ONLY_KEPT);
        return nullptr;
    }

    /* The texture coordinates of the corners, u and v of one after the other, as MeshLab has them. */
    static const PlyProperty *uv_list(const PlyElement &element)
    {
        const PlyProperty *const list = find_property(element, {"texcoord"}, true);
        return list && !ply_is_integer(list->type) ? list : nullptr;
    }

    void leave_all_but(const PlyElement &element, std::initializer_list<const PlyProperty *> wanted,
                       const PlySlots &slots = {})
    {
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty &property = element.properties[k];
            const bool is_wanted = std::find(wanted.begin(), wanted.end(), &property) != wanted.end();
            if (!is_wanted && (slots.empty() || slots[k] == ply_slot::NOWHERE))
                beyond_.insert(element.name + " " + in_quotes(property.name));
        }
    }

    void read_indices(std::vector<std::uint32_t> &out, const PlyProperty &list, const std::string &name,
                      std::uint64_t row, bool with_none = false)
    {
        const std::uint64_t count = read_ply_length(*values_, list, name, row);
        for (std::uint64_t k = 0; k < count; ++k) {
            const std::int64_t index = values_->integer(list.type, name, row);
            const bool is_none = with_none && (index == -1 || index == NONE);
            if (!is_none && (index < 0 || index >= NONE))
                throw values_->error(name, row,
                                     "vertex " + std::to_string(index) + " does not exist; correct the index");
            out.push_back(is_none ? NONE : static_cast<std::uint32_t>(index));
        }
        place_ = {row, values_->line()};
    }

    void read_reals(std::vector<float> &out, const PlyProperty &list, const std::string &name, std::uint64_t row)
    {
        const std::uint64_t count = read_ply_length(*values_, list, name, row);
        for (std::uint64_t k = 0; k < count; ++k)
            out.push_back(drawable(values_->real(list.type, name, row)));
    }

    void add_face(const std::vector<std::uint32_t> &face, const std::vector<float> &uvs)
    {
        if (face.size() < 3) {
            short_faces_ += 1;
            return;
        }
        if (uvs.size() == 2 * face.size()) {
            corner_uvs_.resize(mesh_.corners.size(), NONE);
            for (std::size_t k = 0; k < face.size(); ++k)
                corner_uvs_.push_back(static_cast<std::uint32_t>(face_uvs_.size() / 2 + k));
            face_uvs_.insert(face_uvs_.end(), uvs.begin(), uvs.end());
        }
        mesh_.corners.insert(mesh_.corners.end(), face.begin(), face.end());
        mesh_.face_starts.push_back(mesh_.corners.size());
        places_.push_back(place_);
    }

    void add_strips(const std::vector<std::uint32_t> &indices)
    {
        std::size_t length = 0;
        for (std::size_t k = 0; k < indices.size(); ++k) {
            length = indices[k] == NONE ? 0 : length + 1;
            if (length < 3)
                continue;
            const bool swapped = length % 2 == 0;
            const std::uint32_t a = indices[k - 2], b = indices[k - 1], c = indices[k];
            if (a != b && b != c && c != a) /* else it only joins the triangles beside it */
                add_face({swapped ? b : a, swapped ? a : b, c}, {});
        }
    }

    /* At the end, because a file may give its faces before its vertices. */
    void check_indices()
    {
        for (std::size_t face = 0; face < mesh_.face_count(); ++face)
            for (std::size_t corner = mesh_.face_starts[face]; corner < mesh_.face_starts[face + 1]; ++corner)
                if (mesh_.corners[corner] >= mesh_.vertex_count())
                    throw Error(places_[face].line == 0 ? path_ : path_ + ":" + std::to_string(places_[face].line),
                                "face " + std::to_string(places_[face].row) + " has vertex " +
                                    std::to_string(mesh_.corners[corner]) + ", but there are " +
                                    std::to_string(mesh_.vertex_count()) + " (counting from 0); correct the index");
        const auto is_wrong = [&](const Edge &line) {
            return std::max(line.first, line.second) >= mesh_.vertex_count();
        };
        mesh_.lines.erase(std::remove_if(mesh_.lines.begin(), mesh_.lines.end(), is_wrong), mesh_.lines.end());
    }

    /* Those of the corners count if the vertices have none. */
    void settle_uvs()
    {
        if (face_uvs_.empty())
            return;
        if (mesh_.has_vertex_uvs()) {
            beyond_.insert("texture coordinates of corners");
            return;
        }
        corner_uvs_.resize(mesh_.corners.size(), NONE);
        mesh_.corner_uvs = std::move(corner_uvs_);
        mesh_.uvs = std::move(face_uvs_);
    }

    void settle_remarks()
    {
        if (!whole_numbers_.empty())
            mesh_.notes.push_back("whole numbers that a pose cannot stay in, written as double: " + whole_numbers_);
        if (short_faces_ > 0)
            mesh_.warnings.push_back(counted(short_faces_, "face") + " of fewer than three corners: " + ONLY_KEPT);
        const std::string &text = source_->text;
        const bool is_ascii = source_->header.format == PlyFormat::ascii;
        const std::size_t end = is_ascii ? text.find_first_not_of(" \t\n\v\f", values_->end()) : values_->end();
        if (end < text.size())
            mesh_.warnings.push_back(counted(text.size() - end, "byte") + " behind the last element: " + ONLY_KEPT);
        mesh_.beyond.assign(beyond_.begin(), beyond_.end());
    }

    std::string path_;
    std::shared_ptr<PlySource> source_;
    std::unique_ptr<PlyValues> values_;
    Mesh mesh_;
    std::vector<std::uint32_t> corner_uvs_; /* into face_uvs_, as far as faces have any */
    std::vector<float> face_uvs_;
    Place place_ = {};          /* of the face or strip that is being read */
    std::vector<Place> places_; /* of all faces */
    std::uint64_t short_faces_ = 0;
    std::string whole_numbers_;
    std::set<std::string> beyond_;
};

} // namespace

Mesh read_ply(const std::string &contents, const std::string &path)
{
    return PlyReader(contents, path).read();
}

} // namespace motorway::tool
