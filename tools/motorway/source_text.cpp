#include "source_text.h"

#include "error.h"

namespace motorway::tool {

static bool begins_with(std::string_view text, std::string_view beginning)
{
    return text.substr(0, beginning.size()) == beginning;
}

SourceText normalised_text(std::string_view contents, const std::string &path)
{
    if (begins_with(contents, "\xff\xfe") || begins_with(contents, "\xfe\xff"))
        throw Error(path, "is written in UTF-16; save it as UTF-8");
    if (begins_with(contents, "\xef\xbb\xbf"))
        contents.remove_prefix(3);
    SourceText source;
    source.text.reserve(contents.size());
    bool mixed = false;
    for (std::size_t begin = 0; begin < contents.size();) {
        const std::size_t end = contents.find_first_of("\r\n", begin);
        source.text += contents.substr(begin, end - begin);
        if (end == std::string_view::npos)
            break;
        const std::string_view line_end = begins_with(contents.substr(end), "\r\n") ? "\r\n" : contents.substr(end, 1);
        mixed = mixed || (!source.line_end.empty() && source.line_end != line_end);
        source.line_end = line_end;
        source.text += '\n';
        begin = end + line_end.size();
    }
    if (mixed || source.line_end.empty())
        source.line_end = "\n";
    return source;
}

std::string with_line_ends(std::string text, const std::string &line_end)
{
    if (line_end == "\n")
        return text;
    std::string out;
    out.reserve(text.size() + text.size() / 16);
    for (char c : text)
        c == '\n' ? out += line_end : out += c;
    return out;
}

} // namespace motorway::tool
