/* A JSON document (RFC 8259), read strictly: time and memory grow with its size and with nothing else, and what is
 * wrong with it is said with its place, and with what to do. */
#ifndef MOTORWAY_TOOL_JSON_H
#define MOTORWAY_TOOL_JSON_H

#include <cstddef>
#include <string>
#include <vector>

#include "error.h"

namespace motorway::tool {

/* A value, or the key before one. All nodes of a document lie in one list, each before what it holds; numbers and texts
 * stay in the file until they are asked for. */
struct JsonNode {
    std::size_t begin; /* where it begins in the file */
    std::size_t next;  /* the node after it and all that it holds */
};

struct Document {
    std::string file; /* its name, for messages */
    std::string contents;
    std::vector<JsonNode> nodes; /* the first is the whole document */
};

/* Throws an Error with file, line, column and field if it is not JSON, nests too deep, or if an object has a key
 * twice. A byte order mark is passed over. */
Document parse_json(const std::string &contents, const std::string &file);

/* Counted from 1: columns in characters, lines as any system ends them. */
struct Place {
    std::size_t line, column;
};
Place place_in(const std::string &contents, std::size_t offset);

/* A path, controls[3].motor, and one key more. Keys that are no plain words are put in quotes. */
void append_key(std::string &path, const std::string &key);
void append_index(std::string &path, std::size_t index);

} // namespace motorway::tool

#endif
