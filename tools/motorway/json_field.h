/* JSON as the tool wants it: no key twice, no unknown key, and an error that says which field it means. */
#ifndef MOTORWAY_TOOL_JSON_FIELD_H
#define MOTORWAY_TOOL_JSON_FIELD_H

#include <initializer_list>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "error.h"

namespace motorway::tool {

/* The document. Throws an Error with file, line and field if it is not JSON, or if an object has a key twice. */
nlohmann::json parse_json(const std::string &contents, const std::string &path);

/* A value in a document that knows where it stands. The document must outlive it. */
class Field {
public:
    Field(const nlohmann::json &value, std::string file, std::string path = "")
        : value_(&value), file_(std::move(file)), path_(std::move(path))
    {
    }

    /* The error, at this field. */
    Error error(const std::string &what) const { return Error(path_.empty() ? file_ : file_ + ": " + path_, what); }

    /* Throws unless this is an object with no other keys than these. */
    void check_object(std::initializer_list<const char *> keys) const;

    bool has(const char *key) const { return value_->contains(key); }
    Field operator[](const char *key) const;

    double number() const; /* finite, and finite as a float */
    long long integer() const;
    std::string string() const;
    std::vector<Field> array() const;
    std::vector<double> numbers(std::size_t count) const;

private:
    Error wrong_type(const char *wanted) const;

    const nlohmann::json *value_;
    std::string file_, path_;
};

} // namespace motorway::tool

#endif
