/* JSON as the tool wants it: no unknown key, and an error that says which line and field it means. */
#ifndef MOTORWAY_TOOL_JSON_FIELD_H
#define MOTORWAY_TOOL_JSON_FIELD_H

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "error.h"
#include "json.h"

namespace motorway::tool {

/* A value in a document that knows where it stands. The document must outlive it. */
class Field {
public:
    explicit Field(const Document &document) : Field(document, 0) {}

    /* The error, at this field. */
    Error error(const std::string &what) const;

    /* Throws unless this is an object with no other keys than these. */
    void check_object(std::initializer_list<const char *> keys) const;

    bool has(const char *key) const { return find(key).has_value(); }
    Field operator[](const char *key) const;

    double number() const; /* finite, and finite as a float */
    long long integer() const;
    bool boolean() const;
    std::string string() const;
    std::vector<Field> array() const;
    std::vector<double> numbers() const; /* a list of any length */
    std::vector<double> numbers(std::size_t count) const;

private:
    Field(const Document &document, std::size_t node) : document_(&document), node_(node) {}

    char first_character() const;
    std::string path() const; /* controls[3].motor */
    std::string text_at(std::size_t node) const; /* a key, or a text */
    std::optional<Field> find(const char *key) const; /* of an object; nothing of anything else */
    Error error_in_line_of(std::size_t node, const std::string &what) const;
    Error wrong_type(const char *wanted) const;

    const Document *document_;
    std::size_t node_;
};

} // namespace motorway::tool

#endif
