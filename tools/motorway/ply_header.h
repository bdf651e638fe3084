/* The header of a PLY file: which elements follow, and the properties of each. */
#ifndef MOTORWAY_TOOL_PLY_HEADER_H
#define MOTORWAY_TOOL_PLY_HEADER_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace motorway::tool {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type; /* of the value, or of each item of a list */
    bool is_list = false;
    PlyType count_type = PlyType::uint8; /* of the length of a list */
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::size_t line; /* where the header announces it */
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t body = 0;      /* where the data begin */
    std::size_t body_line = 0; /* and in which line, of an ascii file */
};

std::size_t ply_size(PlyType type);
bool ply_is_integer(PlyType type);

PlyHeader read_ply_header(const std::string &contents, const std::string &path);

} // namespace motorway::tool

#endif
