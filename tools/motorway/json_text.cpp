#include "json_text.h"

#include <cstdint>
#include <cstdio>
#include <string_view>

#include "text.h"

namespace motorway::tool {
namespace {

void append_utf8(std::string &text, std::uint32_t code_point)
{
    constexpr std::uint32_t LEADS[] = {0x00, 0xc0, 0xe0, 0xf0};
    const int more = code_point < 0x80 ? 0 : code_point < 0x800 ? 1 : code_point < 0x10000 ? 2 : 3;
    text += static_cast<char>(LEADS[more] | code_point >> 6 * more);
    for (int k = more - 1; k >= 0; --k)
        text += static_cast<char>(0x80 | (code_point >> 6 * k & 0x3f));
}

/* The text as it is read: `at` is the next byte of the contents. */
class TextReader {
public:
    TextReader(const std::string &contents, std::size_t &at) : contents_(contents), at_(at), quote_(at) {}

    std::string read()
    {
        for (++at_; !next_is('"');)
            read_character();
        ++at_;
        return text_;
    }

private:
    bool next_is(char c) const { return at_ < contents_.size() && contents_[at_] == c; }

    void read_character()
    {
        if (at_ == contents_.size() || next_is('\n') || next_is('\r'))
            throw JsonFault{quote_, "this text has no closing quote in its line; add it, or write \\n for a new line"};
        if (next_is('\\'))
            return read_escape();
        if (static_cast<unsigned char>(contents_[at_]) < ' ')
            throw JsonFault{at_, json_character(contents_, at_) + " in a text; write it as \\t, or \\u and 4 digits"};
        const std::size_t length = utf8_length(std::string_view(contents_).substr(at_));
        if (length == 0)
            throw JsonFault{at_, json_character(contents_, at_) + " is no UTF-8; save the file as UTF-8"};
        text_.append(contents_, at_, length);
        at_ += length;
    }

    void read_escape()
    {
        constexpr std::string_view NAMES = "\"\\/bfnrt", VALUES = "\"\\/\b\f\n\r\t";
        const std::size_t backslash = at_++;
        const std::size_t found = at_ < contents_.size() ? NAMES.find(contents_[at_]) : NAMES.npos;
        if (found != NAMES.npos) {
            text_ += VALUES[found];
            ++at_;
        } else if (next_is('u')) {
            append_utf8(text_, read_code_point(backslash));
        } else {
            throw JsonFault{backslash, "no escape of JSON; write \\\\ for a backslash"};
        }
    }

    /* Characters beyond 16 bits are written as two escapes, a high and a low surrogate. */
    std::uint32_t read_code_point(std::size_t backslash)
    {
        const std::uint32_t first = read_unit(backslash);
        if (first < 0xd800 || first > 0xdfff)
            return first;
        if (first < 0xdc00 && contents_.compare(at_, 2, "\\u") == 0) {
            ++at_;
            const std::uint32_t second = read_unit(backslash);
            if (second >= 0xdc00 && second <= 0xdfff)
                return 0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00);
        }
        throw JsonFault{backslash, "half of a surrogate pair, which is no character; write the character itself"};
    }

    std::uint32_t read_unit(std::size_t backslash)
    {
        constexpr std::string_view DIGITS = "0123456789abcdef0123456789ABCDEF";
        std::uint32_t unit = 0;
        ++at_; /* the u */
        for (int k = 0; k < 4; ++k, ++at_) {
            const std::size_t digit = at_ < contents_.size() ? DIGITS.find(contents_[at_]) : DIGITS.npos;
            if (digit == DIGITS.npos)
                throw JsonFault{backslash, "\\u needs 4 hexadecimal digits; complete them"};
            unit = unit * 16 + static_cast<std::uint32_t>(digit % 16);
        }
        return unit;
    }

    const std::string &contents_;
    std::size_t &at_;
    const std::size_t quote_;
    std::string text_;
};

} // namespace

std::string read_json_text(const std::string &contents, std::size_t &at)
{
    return TextReader(contents, at).read();
}

std::string json_character(const std::string &contents, std::size_t at)
{
    if (at >= contents.size())
        return "the end of the file";
    const auto byte = static_cast<unsigned char>(contents[at]);
    const std::size_t length = utf8_length(std::string_view(contents).substr(at));
    if (length > 0 && byte >= ' ' && byte != 0x7f)
        return "'" + contents.substr(at, length) + "'";
    char hexadecimal[8];
    std::snprintf(hexadecimal, sizeof hexadecimal, "0x%02x", static_cast<unsigned>(byte));
    return std::string("the byte ") + hexadecimal;
}

} // namespace motorway::tool
