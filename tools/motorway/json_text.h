/* Texts of JSON: quotes, escapes and UTF-8. */
#ifndef MOTORWAY_TOOL_JSON_TEXT_H
#define MOTORWAY_TOOL_JSON_TEXT_H

#include <cstddef>
#include <string>

namespace motorway::tool {

/* What is wrong, and where in the contents; parse_json makes an Error of it. */
struct JsonFault {
    std::size_t offset;
    std::string what;
};

/* The text in quotes that begins at `at`, as UTF-8; `at` is moved behind it. Throws a JsonFault. */
std::string read_json_text(const std::string &contents, std::size_t &at);

/* What stands at a place, for messages: "the end of the file", "']'", "the byte 0x00". */
std::string json_character(const std::string &contents, std::size_t at);

} // namespace motorway::tool

#endif
