#include "ply_vertices.h"

#include <algorithm>
#include <string_view>

#include "error.h"
#include "text.h"

namespace motorway::tool {
namespace {

using namespace ply_slot;

struct SlotName {
    std::string_view name;
    std::size_t slot;
};
constexpr SlotName SLOT_NAMES[] = {
    {"x", POSITION},
    {"y", POSITION + 1},
    {"z", POSITION + 2},
    {"nx", NORMAL},
    {"ny", NORMAL + 1},
    {"nz", NORMAL + 2},
    {"normal_x", NORMAL},
    {"normal_y", NORMAL + 1},
    {"normal_z", NORMAL + 2},
    {"tx", TANGENT},
    {"ty", TANGENT + 1},
    {"tz", TANGENT + 2},
    {"tangent_x", TANGENT},
    {"tangent_y", TANGENT + 1},
    {"tangent_z", TANGENT + 2},
    {"bx", BITANGENT},
    {"by", BITANGENT + 1},
    {"bz", BITANGENT + 2},
    {"bitangent_x", BITANGENT},
    {"bitangent_y", BITANGENT + 1},
    {"bitangent_z", BITANGENT + 2},
    {"tw", SIGN},
    {"tangent_w", SIGN},
    {"red", COLOUR},
    {"green", COLOUR + 1},
    {"blue", COLOUR + 2},
    {"alpha", COLOUR + 3},
    {"diffuse_red", COLOUR},
    {"diffuse_green", COLOUR + 1},
    {"diffuse_blue", COLOUR + 2},
    {"diffuse_alpha", COLOUR + 3},
    {"s", UV},
    {"t", UV + 1},
    {"u", UV},
    {"v", UV + 1},
    {"texture_u", UV},
    {"texture_v", UV + 1},
};

/* Slots that are of no use one without the other. */
constexpr struct {
    std::size_t first, count;
} GROUPS[] = {{POSITION, 3}, {NORMAL, 3}, {TANGENT, 3}, {BITANGENT, 3}, {COLOUR, 3}, {UV, 2}};

bool has(const PlySlots &slots, std::size_t slot)
{
    return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

std::size_t slot_of(const PlyProperty &property)
{
    for (const SlotName &known : SLOT_NAMES)
        if (known.name == property.name && !property.is_list)
            return known.slot;
    return NOWHERE;
}

void forget(PlySlots &slots, std::size_t first, std::size_t count)
{
    for (std::size_t &slot : slots)
        if (slot >= first && slot < first + count)
            slot = NOWHERE;
}

/* What a colour of 1 is in this type. */
double full_colour(PlyType type)
{
    if (!ply_is_integer(type))
        return 1;
    return type == PlyType::uint16 ? 65535 : 255;
}

void append(std::vector<double> &out, const double *row, std::size_t slot, bool wanted)
{
    if (wanted)
        out.insert(out.end(), row + slot, row + slot + 3);
}

} // namespace

PlySlots ply_slots(const PlyElement &vertices, const std::string &path, std::set<std::string> &beyond)
{
    PlySlots slots;
    for (const PlyProperty &property : vertices.properties) {
        const std::size_t slot = slot_of(property);
        slots.push_back(slot != NOWHERE && has(slots, slot) ? NOWHERE : slot);
    }
    for (const auto &[first, count] : GROUPS)
        for (std::size_t k = 0; k < count; ++k)
            if (!has(slots, first + k))
                forget(slots, first, count);
    if (!has(slots, COLOUR))
        forget(slots, COLOUR + 3, 1);
    if (!has(slots, TANGENT))
        forget(slots, SIGN, 1);
    if (!has(slots, POSITION))
        throw Error(path + ":" + std::to_string(vertices.line), "the vertices have no x, y and z; add them");
    for (std::size_t k = 0; k < slots.size(); ++k)
        if (slots[k] == NOWHERE)
            beyond.insert(vertices.name + " " + in_quotes(vertices.properties[k].name));
    return slots;
}

PlySlots ply_face_slots(const PlyElement &faces)
{
    PlySlots slots;
    for (const PlyProperty &property : faces.properties) {
        const std::size_t slot = slot_of(property), moved = slot - NORMAL + FACE_NORMAL;
        slots.push_back(slot < NORMAL || slot >= TANGENT || has(slots, moved) ? NOWHERE : moved);
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (!has(slots, FACE_NORMAL + k))
            forget(slots, FACE_NORMAL, 3);
    return slots;
}

bool ply_moves_doubles(const PlyElement &element, const PlySlots &slots)
{
    for (std::size_t k = 0; k < slots.size(); ++k) {
        const PlyType type = element.properties[k].type;
        if (slots[k] < MOVED && ply_size(type) >= 4 && type != PlyType::float32)
            return true;
    }
    return false;
}

void read_ply_vertices(Mesh &mesh, const PlyElement &vertices, const PlySlots &slots, PlyValues &values)
{
    const bool normals = has(slots, NORMAL), tangents = has(slots, TANGENT), bitangents = has(slots, BITANGENT);
    const bool colours = has(slots, COLOUR), uvs = has(slots, UV), signs = has(slots, SIGN);
    mesh.has_alpha = has(slots, COLOUR + 3);
    mesh.in_double = mesh.in_double || ply_moves_doubles(vertices, slots);
    for (std::uint64_t row = 0; row < vertices.count; ++row) {
        double value[COUNT] = {};
        value[COLOUR + 3] = 1;
        for (std::size_t k = 0; k < slots.size(); ++k) {
            const PlyProperty &property = vertices.properties[k];
            if (slots[k] == NOWHERE)
                skip_ply_property(values, property, vertices.name, row);
            else
                value[slots[k]] = values.real(property.type, vertices.name, row);
            if (slots[k] >= COLOUR && slots[k] < COLOUR + 4)
                value[slots[k]] = std::clamp(value[slots[k]] / full_colour(property.type), 0.0, 1.0);
        }
        append(mesh.positions, value, POSITION, true);
        append(mesh.normals, value, NORMAL, normals);
        append(mesh.tangents, value, TANGENT, tangents);
        append(mesh.bitangents, value, BITANGENT, bitangents);
        if (signs)
            mesh.tangent_signs.push_back(value[SIGN] < 0 ? -1.0f : 1.0f);
        for (std::size_t k = COLOUR; colours && k < COLOUR + 4; ++k)
            mesh.colours.push_back(drawable(value[k]));
        for (std::size_t k = UV; uvs && k < UV + 2; ++k)
            mesh.uvs.push_back(drawable(value[k]));
    }
}

void skip_ply_property(PlyValues &values, const PlyProperty &property, const std::string &element, std::uint64_t row)
{
    const std::uint64_t count = property.is_list ? read_ply_length(values, property, element, row) : 1;
    values.skip(property.type, count, element, row);
}

std::uint64_t read_ply_length(PlyValues &values, const PlyProperty &list, const std::string &element,
                              std::uint64_t row)
{
    const std::int64_t count = values.integer(list.count_type, element, row);
    if (count < 0)
        throw values.error(element, row, "the length of " + list.name + " is negative; correct it");
    values.check_room(list.type, static_cast<std::uint64_t>(count), element, row);
    return static_cast<std::uint64_t>(count);
}

} // namespace motorway::tool
