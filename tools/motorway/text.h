/* Numbers and words as the tool reads and prints them, the same in every locale. */
#ifndef MOTORWAY_TOOL_TEXT_H
#define MOTORWAY_TOOL_TEXT_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace motorway::tool {

/* The whole word as a number, or nothing. "nan" and "inf" are numbers here: whether they will do is the caller's
 * question. The word must lie inside a text that ends with a NUL, as a std::string does. */
std::optional<float> parse_float(std::string_view word);
std::optional<double> parse_double(std::string_view word);
/* Whether this word, read as this value, is a number that is too large for its type, and not "inf". */
bool overflowed(std::string_view word, double value);

std::optional<std::int64_t> parse_integer(std::string_view word);

/* The shortest text that reads back as the same number. */
void append_number(std::string &text, float value);
void append_number(std::string &text, double value);

/* 12345678 as 12,345,678; a rounded double likewise. */
std::string grouped(std::uint64_t value);
std::string grouped(double value);

/* Significant digits: 0.00125, 3.55e-07. */
std::string brief(double value, int digits = 3);

/* As many digits as it takes to read back the same number. */
std::string precise(double value);

/* 0.31 kB, 104 kB, 2.25 MB. */
std::string byte_size(std::uintmax_t bytes);

/* "1 face", "2 faces". */
std::string counted(std::uint64_t count, const std::string &noun);

/* How many bytes the character of UTF-8 has that the text begins with; 0 if it begins with none. */
std::size_t utf8_length(std::string_view text);

/* Words of a file, made safe to print on one line: in quotes, cut short, without control characters, and
 * UTF-8 whatever they are. */
std::string in_quotes(std::string_view words);

} // namespace motorway::tool

#endif
