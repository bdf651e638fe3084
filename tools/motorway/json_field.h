/* JSON as the tool wants it: no key twice, no unknown key, and an error that says which line and field it means. */
#ifndef MOTORWAY_TOOL_JSON_FIELD_H
#define MOTORWAY_TOOL_JSON_FIELD_H

#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "error.h"

namespace motorway::tool {

struct Document {
    nlohmann::json value;
    std::string file;
    std::map<std::string, std::size_t> lines; /* where fields begin, by their paths: controls[3].motor */
};

/* The document. Throws an Error with file, line and field if it is not JSON, or if an object has a key twice. */
Document parse_json(const std::string &contents, const std::string &path);

/* A value in a document that knows where it stands. The document must outlive it. */
class Field {
public:
    explicit Field(const Document &document) : Field(document.value, document, "") {}

    /* The error, at this field. */
    Error error(const std::string &what) const;

    /* Throws unless this is an object with no other keys than these. */
    void check_object(std::initializer_list<const char *> keys) const;

    bool has(const char *key) const { return value_->contains(key); }
    Field operator[](const char *key) const;

    double number() const; /* finite, and finite as a float */
    long long integer() const;
    bool boolean() const;
    std::string string() const;
    std::vector<Field> array() const;
    std::vector<double> numbers() const; /* a list of any length */
    std::vector<double> numbers(std::size_t count) const;

private:
    Field(const nlohmann::json &value, const Document &document, std::string path)
        : value_(&value), document_(&document), path_(std::move(path))
    {
    }

    Error wrong_type(const char *wanted) const;
    Error error_at(const std::string &path, const std::string &what) const; /* on the line of the field at `path` */
    std::string path_of(const char *key) const;

    const nlohmann::json *value_;
    const Document *document_;
    std::string path_;
};

} // namespace motorway::tool

#endif
