/* The header of a PLY file: which elements follow, and the properties of each. */
#ifndef MOTORWAY_TOOL_PLY_HEADER_H
#define MOTORWAY_TOOL_PLY_HEADER_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace motorway::tool {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type;         /* of the value, or of each item of a list */
    std::size_t type_at;  /* where the text of the header names it */
    std::size_t type_size;
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

/* How many bytes the header of a file takes, of whatever line ends; all of them, if it has no end. The first line end
 * says of which kind the others are: in a binary file the data may begin with a byte that looks like one. */
std::size_t ply_header_size(std::string_view contents);

/* `text` is the header with lines that end with LF; `body_size` how many bytes follow it. */
PlyHeader read_ply_header(const std::string &text, std::uint64_t body_size, const std::string &path);

} // namespace motorway::tool

#endif
