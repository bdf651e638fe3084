#include "json_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "json_text.h"
#include "text.h"

namespace motorway::tool {
namespace {

/* By the first character of a value. */
const char *type_name(char first)
{
    switch (first) {
    case '{':
        return "an object";
    case '[':
        return "a list";
    case '"':
        return "a text";
    case 't':
    case 'f':
        return "true or false";
    case 'n':
        return "null";
    default:
        return "a number";
    }
}

} // namespace

char Field::first_character() const
{
    return document_->contents[document_->nodes[node_].begin];
}

std::string Field::text_at(std::size_t node) const
{
    std::size_t at = document_->nodes[node].begin;
    return read_json_text(document_->contents, at);
}

/* From the root down, always into the value that holds this one. */
std::string Field::path() const
{
    const std::vector<JsonNode> &nodes = document_->nodes;
    std::string path;
    for (std::size_t node = 0; node != node_;) {
        const bool is_object = document_->contents[nodes[node].begin] == '{';
        std::size_t value = node + 1 + is_object, index = 0;
        for (; nodes[value].next <= node_; ++index)
            value = nodes[value].next + is_object;
        if (is_object)
            append_key(path, text_at(value - 1));
        else
            append_index(path, index);
        node = value;
    }
    return path;
}

Error Field::error(const std::string &what) const
{
    return error_in_line_of(node_, what);
}

Error Field::error_in_line_of(std::size_t node, const std::string &what) const
{
    const std::size_t line = place_in(document_->contents, document_->nodes[node].begin).line;
    const std::string where = path();
    return Error(document_->file + ":" + std::to_string(line) + (where.empty() ? "" : ": " + where), what);
}

Error Field::wrong_type(const char *wanted) const
{
    return error(std::string("must be ") + wanted + ", and is " + type_name(first_character()) + "; correct it");
}

std::optional<Field> Field::find(const char *key) const
{
    if (first_character() != '{')
        return std::nullopt;
    const std::vector<JsonNode> &nodes = document_->nodes;
    for (std::size_t name = node_ + 1; name < nodes[node_].next; name = nodes[name + 1].next)
        if (text_at(name) == key)
            return Field(*document_, name + 1);
    return std::nullopt;
}

void Field::check_object(std::initializer_list<const char *> keys) const
{
    if (first_character() != '{')
        throw wrong_type("an object in braces");
    const std::vector<JsonNode> &nodes = document_->nodes;
    for (std::size_t name = node_ + 1; name < nodes[node_].next; name = nodes[name + 1].next) {
        const std::string written = text_at(name);
        if (std::any_of(keys.begin(), keys.end(), [&](const char *key) { return written == key; }))
            continue;
        std::string known;
        for (const char *key : keys)
            known += (known.empty() ? "" : ", ") + std::string(key);
        throw error_in_line_of(name, "unknown key " + in_quotes(written) + "; the keys here are " + known);
    }
}

Field Field::operator[](const char *key) const
{
    if (first_character() != '{')
        throw wrong_type("an object in braces");
    const std::optional<Field> field = find(key);
    if (!field)
        throw error("the key \"" + std::string(key) + "\" is missing; add it");
    return *field;
}

double Field::number() const
{
    if (first_character() != '-' && (first_character() < '0' || first_character() > '9'))
        throw wrong_type("a number");
    const double number = std::strtod(document_->contents.c_str() + document_->nodes[node_].begin, nullptr);
    if (!std::isfinite(static_cast<float>(number)))
        throw error("is too large for a float; write a smaller number");
    return number;
}

long long Field::integer() const
{
    const double rounded = std::nearbyint(number());
    if (rounded != number() || std::abs(rounded) > 1e9)
        throw error("must be a whole number; correct it");
    return static_cast<long long>(rounded);
}

bool Field::boolean() const
{
    if (first_character() != 't' && first_character() != 'f')
        throw wrong_type("true or false");
    return first_character() == 't';
}

std::string Field::string() const
{
    if (first_character() != '"')
        throw wrong_type("a text in quotes");
    return text_at(node_);
}

std::vector<Field> Field::array() const
{
    if (first_character() != '[')
        throw wrong_type("a list in brackets");
    std::vector<Field> fields;
    for (std::size_t node = node_ + 1; node < document_->nodes[node_].next; node = document_->nodes[node].next)
        fields.push_back(Field(*document_, node));
    return fields;
}

std::vector<double> Field::numbers() const
{
    std::vector<double> values;
    for (const Field &field : array())
        values.push_back(field.number());
    return values;
}

std::vector<double> Field::numbers(std::size_t count) const
{
    std::vector<double> values = numbers();
    if (values.size() != count)
        throw error("must hold " + std::to_string(count) + " numbers, and holds " + std::to_string(values.size()) +
                    "; correct it");
    return values;
}

} // namespace motorway::tool
