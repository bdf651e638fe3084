/* What the tool cannot do, said in one line: where; what; what to do about it. Thrown anywhere, caught in main. */
#ifndef MOTORWAY_TOOL_ERROR_H
#define MOTORWAY_TOOL_ERROR_H

#include <stdexcept>
#include <string>

namespace motorway::tool {

class Error : public std::runtime_error {
public:
    /* `where` is a file, a file and line, a file and field, or an option. */
    Error(const std::string &where, const std::string &what) : std::runtime_error(where + ": " + what) {}
};

} // namespace motorway::tool

#endif
