/* Text files as the readers want them, whatever system they come from. */
#ifndef MOTORWAY_TOOL_SOURCE_TEXT_H
#define MOTORWAY_TOOL_SOURCE_TEXT_H

#include <string>
#include <string_view>

namespace motorway::tool {

/* A text without a byte order mark, in which LF ends every line, and what ended them in the file. */
struct SourceText {
    std::string text;
    std::string line_end; /* LF, CR LF or CR; LF if the file mixes them */
};

/* Throws an Error that names `path` if the file is UTF-16, which no mesh is. */
SourceText normalised_text(std::string_view contents, const std::string &path);

/* The text with these line ends instead of LF: of a file that did not mix them, what it was. */
std::string with_line_ends(std::string text, const std::string &line_end);

} // namespace motorway::tool

#endif
