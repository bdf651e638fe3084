/* The normals of a mesh: made where there are none, and one a vertex for formats that know no others. */
#ifndef MOTORWAY_TOOL_NORMALS_H
#define MOTORWAY_TOOL_NORMALS_H

#include <vector>

#include "mesh.h"

namespace motorway::tool {

/* Gives each corner that has no normal that of its vertex: the sum of the vector areas of the faces around it,
 * normalised. A cloud of points has nothing to make normals of, and keeps what it has. */
void add_missing_normals(Mesh &mesh);

/* Whether there is a normal for each vertex or for each corner. */
bool has_all_normals(const Mesh &mesh);

/* One normal a vertex, where has_all_normals(): where the corners of a vertex have several, the unit vector of their
 * sum. `normals` are those of the mesh, or of a pose of it. */
std::vector<double> vertex_normals(const Mesh &mesh, const std::vector<double> &normals);

/* Divides each vector by its length; one that has none becomes e3. */
void make_unit(std::vector<double> &vectors);

} // namespace motorway::tool

#endif
