/* The values in the body of a PLY file, one after the other, whatever their format. */
#ifndef MOTORWAY_TOOL_PLY_VALUES_H
#define MOTORWAY_TOOL_PLY_VALUES_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "error.h"
#include "ply_header.h"

namespace motorway::tool {

/* Values are read in the order of the file, and each is of the type that the header says.
 * `row` is the element that is being read, such as "vertex 17": a binary file has no lines to name in an error. */
class PlyValues {
public:
    virtual ~PlyValues() = default;

    /* The next value: it lies in the text from begin() to end(). */
    virtual double real(PlyType type, const std::string &name, std::uint64_t row) = 0;
    virtual std::int64_t integer(PlyType type, const std::string &name, std::uint64_t row) = 0;

    /* Passes over `count` values, whatever they are. */
    virtual void skip(PlyType type, std::uint64_t count, const std::string &name, std::uint64_t row) = 0;

    virtual std::size_t begin() const = 0;
    virtual std::size_t end() const = 0;

    /* Throws unless `count` more values of the type can be there. */
    virtual void check_room(PlyType type, std::uint64_t count, const std::string &name, std::uint64_t row) = 0;

    /* An error at the value that was read last. */
    virtual Error error(const std::string &name, std::uint64_t row, const std::string &what) const = 0;

    /* Where that value was: a line of an ascii file, else 0. */
    virtual std::size_t line() const { return 0; }
};

/* The values of this text from `position` on, which is the beginning of the body or an end() in it. */
std::unique_ptr<PlyValues> ply_values(const PlyHeader &header, const std::string &text, std::size_t position,
                                      const std::string &path);

} // namespace motorway::tool

#endif
