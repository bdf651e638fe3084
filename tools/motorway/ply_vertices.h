/* The properties of the vertices and faces of a PLY file: which numbers a Mesh holds, and which a motion moves. */
#ifndef MOTORWAY_TOOL_PLY_VERTICES_H
#define MOTORWAY_TOOL_PLY_VERTICES_H

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "mesh.h"
#include "ply_header.h"
#include "ply_values.h"

namespace motorway::tool {

/* The numbers of a vertex or a face. Those before MOVED are vectors x y z, one array of a Pose each. */
namespace ply_slot {
constexpr std::size_t POSITION = 0, NORMAL = 3, TANGENT = 6, BITANGENT = 9, FACE_NORMAL = 12, MOVED = 15;
constexpr std::size_t SIGN = 15, COLOUR = 16, UV = 20, COUNT = 22, NOWHERE = 99;
} // namespace ply_slot

/* The slot of each property of the element, or NOWHERE. */
using PlySlots = std::vector<std::size_t>;

/* What has no slot is added to `beyond`, for people to read: a vector or a colour of which a part is missing as well.
 * Throws an Error if there are no x, y and z. */
PlySlots ply_slots(const PlyElement &vertices, const std::string &path, std::set<std::string> &beyond);

/* Of faces: those of their normal. */
PlySlots ply_face_slots(const PlyElement &faces);

/* Whether a property with one of these slots is a double, or a whole number that only a double can hold. */
bool ply_moves_doubles(const PlyElement &element, const PlySlots &slots);

/* Reads all rows of the element into the mesh. */
void read_ply_vertices(Mesh &mesh, const PlyElement &vertices, const PlySlots &slots, PlyValues &values);

/* Passes over a property: of a list, its length and that many items. */
void skip_ply_property(PlyValues &values, const PlyProperty &property, const std::string &element, std::uint64_t row);

/* How many items of a list follow. Throws an Error if it is negative, or more than can be there. */
std::uint64_t read_ply_length(PlyValues &values, const PlyProperty &list, const std::string &element,
                              std::uint64_t row);

} // namespace motorway::tool

#endif
