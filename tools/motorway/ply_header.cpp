#include "ply_header.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "error.h"
#include "text.h"

namespace motorway::tool {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr TypeName TYPE_NAMES[] = {
    {"char", PlyType::int8},       {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},     {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},     {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"int64", PlyType::int64},     {"uint64", PlyType::uint64},   {"float", PlyType::float32},
    {"float32", PlyType::float32}, {"double", PlyType::float64},  {"float64", PlyType::float64},
};

constexpr std::string_view BLANKS = " \t\r\v\f";

/* The first word of a line. */
std::string_view first_word(std::string_view line)
{
    const std::size_t begin = std::min(line.find_first_not_of(BLANKS), line.size());
    return line.substr(begin, line.find_first_of(BLANKS, begin) - begin);
}

class HeaderReader {
public:
    HeaderReader(const std::string &text, std::uint64_t body_size, const std::string &path)
        : text_(text), body_size_(body_size), path_(path)
    {
    }

    PlyHeader read()
    {
        if (!next_line() || words_.size() != 1 || words_[0] != "ply")
            throw error("does not begin with \"ply\"; is this a PLY file?");
        bool format_known = false;
        for (;;) {
            if (!next_line())
                throw error("the header has no \"end_header\"; is the file truncated?");
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info")
                continue;
            if (words_[0] == "end_header")
                break;
            if (words_[0] == "format")
                format_known = read_format();
            else if (words_[0] == "element")
                read_element();
            else if (words_[0] == "property")
                read_property();
            else
                throw error(in_quotes(words_[0]) + " is no PLY header keyword; correct the header");
        }
        if (!format_known)
            throw error("the header has no \"format\" line; add one");
        header_.body = text_.size();
        header_.body_line = line_ + 1;
        check_room();
        return std::move(header_);
    }

private:
    Error error(const std::string &what) const { return error_at(line_, what); }
    Error error_at(std::size_t line, const std::string &what) const
    {
        return Error(path_ + ":" + std::to_string(std::max<std::size_t>(line, 1)), what);
    }

    bool next_line()
    {
        words_.clear();
        if (position_ == text_.size())
            return false;
        const std::size_t end = std::min(text_.find('\n', position_), text_.size());
        const std::string_view line = text_.substr(position_, end - position_);
        position_ = std::min(end + 1, text_.size());
        ++line_;
        for (std::string_view word = first_word(line); !word.empty();) {
            words_.push_back(word);
            const auto behind = static_cast<std::size_t>(word.data() + word.size() - line.data());
            word = first_word(line.substr(behind));
        }
        return true;
    }

    bool read_format()
    {
        const std::string_view name = words_.size() == 3 && words_[2] == "1.0" ? words_[1] : "";
        if (name == "ascii")
            header_.format = PlyFormat::ascii;
        else if (name == "binary_little_endian")
            header_.format = PlyFormat::little_endian;
        else if (name == "binary_big_endian")
            header_.format = PlyFormat::big_endian;
        else
            throw error("unknown format; it is ascii, binary_little_endian or binary_big_endian, and 1.0");
        return true;
    }

    void read_element()
    {
        const auto count = words_.size() == 3 ? parse_integer(words_[2]) : std::nullopt;
        if (!count || *count < 0)
            throw error("an element needs a name and a count; write \"element vertex 8\"");
        if (!element_names_.emplace(words_[1]).second)
            throw error("a second element " + in_quotes(words_[1]) + "; keep one");
        property_names_.clear();
        header_.elements.push_back({std::string(words_[1]), static_cast<std::uint64_t>(*count), line_, {}});
    }

    void read_property()
    {
        if (header_.elements.empty())
            throw error("a property before any element; correct the header");
        PlyProperty property = {};
        std::string_view type_word;
        if (words_.size() == 5 && words_[1] == "list") {
            property.is_list = true;
            property.count_type = type(words_[2]);
            type_word = words_[3];
            if (!ply_is_integer(property.count_type))
                throw error("the length of a list is a whole number, not " + in_quotes(words_[2]) +
                            "; correct the type");
        } else if (words_.size() == 3) {
            type_word = words_[1];
        } else {
            throw error("a property is a type and a name, or \"list\", two types and a name; correct the header");
        }
        property.type = type(type_word);
        property.type_at = static_cast<std::size_t>(type_word.data() - text_.data());
        property.type_size = type_word.size();
        property.name = std::string(words_.back());
        if (!property_names_.insert(property.name).second)
            throw error("a second property " + in_quotes(property.name) + "; keep one");
        header_.elements.back().properties.push_back(property);
    }

    PlyType type(std::string_view name) const
    {
        for (const TypeName &known : TYPE_NAMES)
            if (known.name == name)
                return known.type;
        throw error("unknown type " + in_quotes(name) +
                    "; use float, double, char, uchar, short, ushort, int or uint");
    }

    /* A count that the rest of the file cannot hold is an error here, before anything is allocated for it. */
    void check_room() const
    {
        for (const PlyElement &element : header_.elements) {
            std::uint64_t smallest = 0;
            for (const PlyProperty &property : element.properties)
                smallest += header_.format == PlyFormat::ascii
                                ? 2
                                : ply_size(property.is_list ? property.count_type : property.type);
            /* The last word of an ascii file needs no blank behind it. */
            if (smallest > 0 && element.count > (body_size_ + 1) / smallest)
                throw error_at(element.line, std::to_string(element.count) + " times " + in_quotes(element.name) +
                                                 " cannot be in the " + std::to_string(body_size_) +
                                                 " bytes that follow; is the file truncated?");
        }
    }

    std::string_view text_;
    std::uint64_t body_size_;
    std::string path_;
    std::size_t position_ = 0, line_ = 0;
    std::vector<std::string_view> words_;
    std::set<std::string> element_names_, property_names_; /* the latter of the last element */
    PlyHeader header_;
};

} // namespace

std::size_t ply_size(PlyType type)
{
    switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
        return 1;
    case PlyType::int16:
    case PlyType::uint16:
        return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
        return 4;
    case PlyType::int64:
    case PlyType::uint64:
    case PlyType::float64:
        break;
    }
    return 8;
}

bool ply_is_integer(PlyType type)
{
    return type != PlyType::float32 && type != PlyType::float64;
}

std::size_t ply_header_size(std::string_view contents)
{
    const auto ends_with_crlf = [&](std::size_t at) { return contents.substr(at, 2) == "\r\n"; };
    const std::size_t first = std::min(contents.find_first_of("\r\n"), contents.size());
    const bool only_cr = contents.substr(first, 1) == "\r" && !ends_with_crlf(first);
    for (std::size_t begin = 0;;) {
        const std::size_t end = contents.find_first_of("\r\n", begin);
        if (end == std::string_view::npos)
            return contents.size();
        const std::size_t next = end + (ends_with_crlf(end) && !only_cr ? 2 : 1);
        if (first_word(contents.substr(begin, end - begin)) == "end_header")
            return next;
        begin = next;
    }
}

PlyHeader read_ply_header(const std::string &text, std::uint64_t body_size, const std::string &path)
{
    return HeaderReader(text, body_size, path).read();
}

} // namespace motorway::tool
