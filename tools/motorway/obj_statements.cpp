#include "obj_statements.h"

#include <algorithm>

namespace motorway::tool {
namespace {

constexpr std::string_view BLANKS = " \t\r\v\f";

bool is_blank(char c)
{
    return BLANKS.find(c) != std::string_view::npos;
}

/* Where the next line begins if a backslash at this position joins it to this one, else 0. Blanks behind the
 * backslash cannot be seen, so they do no harm; at the end of the file there is nothing to join. */
std::size_t joined_line(std::string_view text, std::size_t position)
{
    if (text[position] != '\\')
        return 0;
    const std::size_t end = std::min(text.find_first_not_of(BLANKS, position + 1), text.size());
    return end == text.size() || text[end] == '\n' ? std::min(end + 1, text.size()) : 0;
}

} // namespace

std::string_view obj_word(std::string_view text, ObjPlace &place)
{
    std::size_t &at = place.position;
    while (at < text.size()) {
        if (text[at] == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else if (text[at] == '\n') {
            ++at, ++place.line;
            return {};
        } else if (const std::size_t next_line = joined_line(text, at)) {
            at = next_line, ++place.line;
        } else if (is_blank(text[at])) {
            ++at;
        } else {
            const std::size_t begin = at;
            while (at < text.size() && !is_blank(text[at]) && text[at] != '\n' && !joined_line(text, at))
                ++at;
            return text.substr(begin, at - begin);
        }
    }
    return {};
}

bool ObjStatements::next(std::vector<std::string_view> &words)
{
    words.clear();
    while (words.empty() && place_.position < text_.size()) {
        line_ = place_.line;
        for (std::string_view word = obj_word(text_, place_); !word.empty(); word = obj_word(text_, place_))
            words.push_back(word);
    }
    return !words.empty();
}

} // namespace motorway::tool
