#include "ply_source.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "error.h"
#include "source_text.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr double LARGEST_FLOAT = std::numeric_limits<float>::max();

template <class Bits, class Real> void append_bits(std::string &out, Real value, bool big_endian)
{
    Bits bits;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    for (std::size_t k = 0; k < sizeof bits; ++k)
        out += static_cast<char>(bits >> 8 * (big_endian ? sizeof bits - 1 - k : k) & 0xff);
}

const std::vector<double> &vectors_of(const Pose &pose, std::size_t slot)
{
    const std::vector<double> *const arrays[] = {&pose.positions, &pose.normals, &pose.tangents, &pose.bitangents,
                                                 &pose.face_normals};
    return *arrays[slot / 3];
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
    for (const auto &[number, begin, slots] : moved)
        for (std::size_t k = 0; k < slots.size(); ++k) {
            const PlyProperty &property = header.elements[number].properties[k];
            if (slots[k] >= ply_slot::MOVED || ply_written_type(property.type) == property.type)
                continue;
            out.append(text, copied, property.type_at - copied);
            out += "double";
            copied = property.type_at + property.type_size;
        }
    return out.append(text, copied, header.body - copied);
}

/* The text up to the last number of the element, with the new numbers; returns where that ended. */
std::size_t PlySource::append_element(std::string &body, const Moved &moved_element, const Pose &pose,
                                      std::size_t copied) const
{
    const PlyElement &element = header.elements[moved_element.element];
    const PlySlots &slots = moved_element.slots;
    const auto values = ply_values(header, text, moved_element.begin, "");
    for (std::uint64_t row = 0; row < element.count; ++row)
        for (std::size_t k = 0; k < slots.size(); ++k) {
            const PlyProperty &property = element.properties[k];
            skip_ply_property(*values, property, element.name, row);
            if (slots[k] >= ply_slot::MOVED)
                continue;
            const double number = vectors_of(pose, slots[k])[3 * row + slots[k] % 3];
            if (property.type == PlyType::float32 && std::isfinite(number) && std::abs(number) > LARGEST_FLOAT)
                throw Error(element.name + " " + std::to_string(row) + " (counting from 0)",
                            property.name + " lands too far away for a float; use smaller lengths");
            body.append(text, copied, values->begin() - copied);
            append_ply_number(body, number, ply_written_type(property.type), header.format);
            copied = values->end();
        }
    return copied;
}

std::string PlySource::write(const Pose &pose) const
{
    std::string body;
    body.reserve(text.size());
    std::size_t copied = header.body;
    for (const Moved &element : moved)
        copied = append_element(body, element, pose, copied);
    body.append(text, copied);
    if (header.format == PlyFormat::ascii)
        return with_line_ends(header_text() + body, line_end);
    return with_line_ends(header_text(), line_end) + body;
}

} // namespace motorway::tool
