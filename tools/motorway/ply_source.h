/* A PLY file that is kept to be written again, in its own format, with other positions, normals and tangents. */
#ifndef MOTORWAY_TOOL_PLY_SOURCE_H
#define MOTORWAY_TOOL_PLY_SOURCE_H

#include <cstddef>
#include <string>
#include <vector>

#include "mesh.h"
#include "ply_header.h"
#include "ply_vertices.h"

namespace motorway::tool {

class PlySource : public MeshSource {
public:
    PlyHeader header;
    std::string text;     /* the header in lines that end with LF, and the body: if it is ascii, in such lines too */
    std::string line_end; /* what ended them in the file */

    /* An element that has vectors which are moved. */
    struct Moved {
        std::size_t element; /* its number in the header */
        std::size_t begin;   /* where its values are in the text */
        PlySlots slots;      /* of its properties */
    };
    std::vector<Moved> moved; /* in the order of the file */

    const char *kind() const override { return ".ply"; }
    std::string write(const Pose &pose) const override;

private:
    std::string header_text() const;
    std::size_t append_element(std::string &body, const Moved &element, const Pose &pose, std::size_t copied) const;
};

/* Whole numbers cannot hold a pose: properties of this type are written as this one. */
PlyType ply_written_type(PlyType type);

/* Adds the number as a PLY file of this format has it; in ascii without a blank. */
void append_ply_number(std::string &out, double value, PlyType type, PlyFormat format);

} // namespace motorway::tool

#endif
