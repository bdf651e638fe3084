/* The statements of an OBJ file: words up to the end of a line, or of several that a backslash joins. */
#ifndef MOTORWAY_TOOL_OBJ_STATEMENTS_H
#define MOTORWAY_TOOL_OBJ_STATEMENTS_H

#include <cstddef>
#include <string_view>
#include <vector>

namespace motorway::tool {

/* A place in a text whose lines end with LF. */
struct ObjPlace {
    std::size_t position = 0;
    std::size_t line = 1;
};

/* The next word of the statement at this place, which moves behind it; at the end of the statement nothing, and the
 * place moves to the next one. A word that begins with # begins a comment, up to the end of its line. */
std::string_view obj_word(std::string_view text, ObjPlace &place);

/* The words of one statement after the other; lines without any are passed over. */
class ObjStatements {
public:
    explicit ObjStatements(std::string_view text) : text_(text) {}

    bool next(std::vector<std::string_view> &words);

    /* Where the statement begins. */
    std::size_t line() const { return line_; }

private:
    std::string_view text_;
    ObjPlace place_;
    std::size_t line_ = 0;
};

} // namespace motorway::tool

#endif
