#include "ply_source.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "source_text.h"
#include "text.h"

namespace motorway::tool {
namespace {

template <class Bits, class Real> void append_bits(std::string &out, Real value, bool big_endian)
{
    Bits bits;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    for (std::size_t k = 0; k < sizeof bits; ++k)
        out += static_cast<char>(bits >> 8 * (big_endian ? sizeof bits - 1 - k : k) & 0xff);
}

const std::vector<double> &moved(const Pose &pose, std::size_t slot)
{
    using namespace ply_slot;
    return slot < NORMAL ? pose.positions : slot < TANGENT ? pose.normals : slot < BITANGENT ? pose.tangents
                                                                                            : pose.bitangents;
}

} // namespace

PlyType ply_written_type(PlyType type)
{
    return ply_is_integer(type) ? PlyType::float64 : type;
}

void append_ply_number(std::string &out, double value, PlyType type, PlyFormat format)
{
    const bool big_endian = format == PlyFormat::big_endian;
    if (type == PlyType::float32) {
        const auto rounded = static_cast<float>(value);
        format == PlyFormat::ascii ? append_number(out, rounded)
                                   : append_bits<std::uint32_t>(out, rounded, big_endian);
    } else {
        format == PlyFormat::ascii ? append_number(out, value) : append_bits<std::uint64_t>(out, value, big_endian);
    }
}

/* The header with the types that are written. */
std::string PlySource::header_text() const
{
    std::string out;
    std::size_t copied = 0;
    const PlyElement &element = header.elements[vertex_element];
    for (std::size_t k = 0; k < slots.size(); ++k) {
        const PlyProperty &property = element.properties[k];
        if (slots[k] >= ply_slot::MOVED || ply_written_type(property.type) == property.type)
            continue;
        out.append(text, copied, property.type_at - copied);
        out += "double";
        copied = property.type_at + property.type_size;
    }
    return out.append(text, copied, header.body - copied);
}

std::string PlySource::write(const Pose &pose) const
{
    std::string body;
    body.reserve(text.size());
    const PlyElement &element = header.elements[vertex_element];
    const auto values = ply_values(header, text, vertices, "");
    std::size_t copied = header.body;
    for (std::uint64_t row = 0; row < element.count; ++row)
        for (std::size_t k = 0; k < slots.size(); ++k) {
            const PlyProperty &property = element.properties[k];
            skip_ply_property(*values, property, element.name, row);
            if (slots[k] >= ply_slot::MOVED)
                continue;
            body.append(text, copied, values->begin() - copied);
            append_ply_number(body, moved(pose, slots[k])[3 * row + slots[k] % 3], ply_written_type(property.type),
                              header.format);
            copied = values->end();
        }
    body.append(text, copied);
    if (header.format == PlyFormat::ascii)
        return with_line_ends(header_text() + body, line_end);
    return with_line_ends(header_text(), line_end) + body;
}

} // namespace motorway::tool
