#include "json.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>

#include "json_text.h"
#include "text.h"

namespace motorway::tool {
namespace {

/* Motions nest 7 deep: a coordinate of an axis of a rotation of a step of a control. */
constexpr std::size_t DEEPEST = 16;

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* What numbers and words consist of, well written or not. */
bool is_of_word(char c)
{
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || c == '+' ||
           c == '-';
}

/* The brackets that are open: which value of a list it is at, or of which key. */
struct Level {
    std::size_t node;
    bool is_list;
    std::size_t index = 0;
    std::string key = {};
};

class Parser {
public:
    explicit Parser(Document &document) : text_(document.contents), nodes_(document.nodes) {}

    void read()
    {
        skip_byte_order_mark();
        skip_space();
        if (at_ == text_.size())
            throw JsonFault{at_, "the file is empty; fill it"};
        read_value();
        skip_space();
        if (at_ < text_.size())
            throw JsonFault{at_, json_character(text_, at_) + " after the end of the document; remove it"};
    }

    std::string path() const
    {
        std::string path;
        for (const Level &level : levels_)
            if (level.is_list)
                append_index(path, level.index);
            else if (!level.key.empty())
                append_key(path, level.key);
        return path;
    }

private:
    /* ---------------------------------------------------------------------------------------- between values --- */

    void skip_byte_order_mark()
    {
        if (text_.compare(0, 2, "\xff\xfe") == 0 || text_.compare(0, 2, "\xfe\xff") == 0)
            throw JsonFault{0, "the file is in UTF-16; save it as UTF-8"};
        if (text_.compare(0, 3, "\xef\xbb\xbf") == 0)
            at_ = 3;
    }

    void skip_space()
    {
        while (next_is(' ') || next_is('\t') || next_is('\n') || next_is('\r'))
            ++at_;
        if (next_is('/') || next_is('#'))
            throw JsonFault{at_, json_character(text_, at_) + ", and JSON has no comments; remove it"};
    }

    bool next_is(char c) const { return at_ < text_.size() && text_[at_] == c; }

    bool take(char c)
    {
        const bool found = next_is(c);
        at_ += found;
        return found;
    }

    /* ------------------------------------------------------------------------------------------------- values --- */

    std::size_t add_node()
    {
        nodes_.push_back({at_, nodes_.size() + 1});
        return nodes_.size() - 1;
    }

    void read_value()
    {
        if (next_is('{'))
            return read_object();
        if (next_is('['))
            return read_list();
        const std::size_t node = add_node();
        if (next_is('"'))
            read_json_text(text_, at_);
        else if (const std::string_view word = word_here(); word == "null" || word == "true" || word == "false")
            at_ += word.size();
        else if (!word.empty() && (is_digit(word[0]) || word[0] == '-' || word[0] == '+' || word[0] == '.'))
            read_number(node, word);
        else
            throw wrong_value(word);
    }

    void read_list()
    {
        open(true);
        skip_space();
        for (bool done = next_is(']'); !done; ++levels_.back().index) {
            read_value();
            done = !another(']');
        }
        close();
    }

    void read_object()
    {
        std::vector<std::pair<std::string, std::size_t>> keys;
        open(false);
        skip_space();
        for (bool done = next_is('}'); !done;) {
            keys.emplace_back("", at_);
            keys.back().first = levels_.back().key = read_key();
            read_value();
            done = !another('}');
            levels_.back().key.clear();
        }
        check_that_differ(keys);
        close();
    }

    void open(bool is_list)
    {
        if (levels_.size() == DEEPEST)
            throw JsonFault{at_, "brackets are nested more than " + std::to_string(DEEPEST) +
                                     " deep, which no motion needs; correct them"};
        levels_.push_back({add_node(), is_list});
        ++at_;
    }

    void close()
    {
        ++at_;
        nodes_[levels_.back().node].next = nodes_.size();
        levels_.pop_back();
    }

    std::string read_key()
    {
        if (!next_is('"'))
            throw wrong_key();
        add_node();
        const std::string key = read_json_text(text_, at_);
        skip_space();
        if (at_ == text_.size())
            throw truncated();
        if (!take(':'))
            throw JsonFault{at_, "found " + json_character(text_, at_) + " where a ':' belongs, after the key " +
                                     in_quotes(key) + "; write the ':' and a value"};
        skip_space();
        return key;
    }

    /* Whether a value follows after a comma, and not the end of the list or object, which is left to close(). */
    bool another(char end)
    {
        skip_space();
        if (next_is(end))
            return false;
        const std::size_t comma = at_;
        if (!take(','))
            throw no_comma(end);
        skip_space();
        if (next_is(']') || next_is('}'))
            throw JsonFault{comma, "a comma before " + json_character(text_, at_) + "; remove it"};
        return true;
    }

    /* The library that reads numbers later takes more than JSON does. */
    void read_number(std::size_t node, std::string_view word)
    {
        const std::size_t begin = at_;
        const auto digits = [this] {
            const std::size_t first = at_;
            while (at_ < text_.size() && is_digit(text_[at_]))
                ++at_;
            return at_ - first;
        };
        take('-');
        const bool begins_with_zero = next_is('0');
        const std::size_t whole = digits();
        bool good = whole > 0 && !(begins_with_zero && whole > 1);
        if (take('.'))
            good = digits() > 0 && good;
        if (take('e') || take('E')) {
            if (!take('-'))
                take('+');
            good = digits() > 0 && good;
        }
        if (!good || at_ != begin + word.size())
            throw JsonFault{begin, in_quotes(word) + " is no number of JSON; numbers are finite and decimal, as -12, " +
                                       "0.5 and 1e-3"};
        if (!std::isfinite(std::strtod(text_.c_str() + nodes_[node].begin, nullptr)))
            throw JsonFault{begin, in_quotes(word) + " is too large a number; write a smaller one"};
    }

    std::string_view word_here() const
    {
        std::size_t end = at_;
        while (end < text_.size() && is_of_word(text_[end]))
            ++end;
        return std::string_view(text_).substr(at_, end - at_);
    }

    /* ------------------------------------------------------------------------------------------------ mistakes --- */

    JsonFault wrong_value(std::string_view word) const
    {
        if (at_ == text_.size())
            return truncated();
        if (word.empty())
            return {at_, "found " + json_character(text_, at_) +
                             " where a value belongs; values are numbers, lists in [], objects in {}, texts in \"\", "
                             "true, false and null"};
        std::string lower(word);
        std::transform(lower.begin(), lower.end(), lower.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        if (lower == "nan" || lower == "inf" || lower == "infinity")
            return {at_, in_quotes(word) + " is no number of JSON; numbers are finite and decimal"};
        if (lower == "true" || lower == "false" || lower == "null" || lower == "none")
            return {at_, "found " + in_quotes(word) + "; write " + (lower == "none" ? "null" : lower)};
        return {at_, "the word " + in_quotes(word) + " is not in double quotes; put it in them"};
    }

    JsonFault wrong_key() const
    {
        if (at_ == text_.size())
            return truncated();
        const std::string_view word = word_here();
        return {at_, "found " + (word.empty() ? json_character(text_, at_) : in_quotes(word)) +
                         " where a key in double quotes belongs; write it so"};
    }

    JsonFault no_comma(char end) const
    {
        if (at_ == text_.size())
            return truncated();
        const std::string found = json_character(text_, at_), close = std::string("'") + end + "'";
        if (next_is(']') || next_is('}'))
            return {at_, "found " + found + ", and " + opened() + " is open; close it with " + close};
        if (next_is('{') || next_is('[') || next_is('"') || is_of_word(text_[at_]))
            return {at_, "a comma is missing before " + found + "; add it"};
        return {at_, "found " + found + " where a comma or " + close + " belongs; correct it"};
    }

    JsonFault truncated() const
    {
        const std::string open = levels_.empty() ? "a value" : opened();
        return {text_.size(), "the file ends here, and " + open + " is open; is it truncated?"};
    }

    /* "the '{' of line 7" */
    std::string opened() const
    {
        const std::size_t begin = nodes_[levels_.back().node].begin;
        return "the " + json_character(text_, begin) + " of line " + std::to_string(place_in(text_, begin).line);
    }

    /* Of the keys that come again the first in the file is reported. */
    void check_that_differ(std::vector<std::pair<std::string, std::size_t>> &keys)
    {
        std::sort(keys.begin(), keys.end());
        const std::pair<std::string, std::size_t> *again = nullptr;
        for (std::size_t k = 1; k < keys.size(); ++k)
            if (keys[k].first == keys[k - 1].first && (!again || keys[k].second < again->second))
                again = &keys[k];
        if (again)
            throw JsonFault{again->second, "the key " + in_quotes(again->first) + " comes twice here; keep one"};
    }

    const std::string &text_;
    std::vector<JsonNode> &nodes_;
    std::vector<Level> levels_;
    std::size_t at_ = 0;
};

bool is_plain(const std::string &key)
{
    constexpr std::size_t LONGEST = 40;
    return !key.empty() && key.size() <= LONGEST && std::all_of(key.begin(), key.end(), [](char c) {
        return is_of_word(c) && c != '.' && c != '+' && c != '-';
    });
}

} // namespace

Document parse_json(const std::string &contents, const std::string &file)
{
    Document document{file, contents, {}};
    Parser parser(document);
    try {
        parser.read();
    } catch (const JsonFault &fault) {
        const Place place = place_in(contents, fault.offset);
        const std::string path = parser.path();
        throw Error(file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column),
                    path.empty() ? fault.what : path + ": " + fault.what);
    }
    return document;
}

Place place_in(const std::string &contents, std::size_t offset)
{
    Place place = {1, 1};
    for (std::size_t k = 0; k < offset; ++k) {
        const bool before_line_feed = k + 1 < contents.size() && contents[k + 1] == '\n';
        if (contents[k] == '\n' || (contents[k] == '\r' && !before_line_feed))
            place = {place.line + 1, 1};
        else if ((static_cast<unsigned char>(contents[k]) & 0xc0) != 0x80) /* not inside a character of UTF-8 */
            ++place.column;
    }
    return place;
}

void append_key(std::string &path, const std::string &key)
{
    if (is_plain(key))
        path += (path.empty() ? "" : ".") + key;
    else
        path += "[" + in_quotes(key) + "]";
}

void append_index(std::string &path, std::size_t index)
{
    path += "[" + std::to_string(index) + "]";
}

} // namespace motorway::tool
