/* A polygon mesh as the files hold it: vertices in their order, faces with any number of corners. */
#ifndef MOTORWAY_TOOL_MESH_H
#define MOTORWAY_TOOL_MESH_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace motorway::tool {

struct Mesh {
    std::vector<float> positions;              /* x y z a vertex */
    std::vector<float> normals;                /* x y z a normal */
    std::vector<std::uint32_t> corners;        /* the vertices of all faces, one face after the other */
    std::vector<std::uint32_t> corner_normals; /* the normal of each corner; empty if normal i is that of vertex i */
    std::vector<std::size_t> face_starts{0};   /* the first corner of each face, and the number of all corners */
    std::vector<std::string> left_out;         /* what the file holds and a Mesh does not, for people to read */

    std::size_t vertex_count() const { return positions.size() / 3; }
    std::size_t normal_count() const { return normals.size() / 3; }
    std::size_t face_count() const { return face_starts.size() - 1; }
};

struct Box {
    std::array<double, 3> low, high;

    double longest_side() const;
    double diagonal() const;
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Triangle = std::array<std::uint32_t, 3>;

/* Reads an OBJ or PLY file, by its extension. Throws an Error with file and line if anything is wrong with it. */
Mesh read_mesh(const std::string &path);

Box bounding_box(const Mesh &mesh);

/* Every edge of a face once, the smaller vertex first. */
std::vector<Edge> edges(const Mesh &mesh);

/* Fans of triangles: right for convex faces. Each holds indices into mesh.corners. */
std::vector<Triangle> triangles(const Mesh &mesh);

/* Gives a mesh that has no normals one a vertex: the sum of the vector areas of the faces around it, normalised. */
void add_missing_normals(Mesh &mesh);

/* One normal a vertex, for formats that know no others: where the corners of a vertex have several, the unit vector
 * of their sum. `normals` are those of the mesh, or of a pose of it. */
std::vector<float> vertex_normals(const Mesh &mesh, const std::vector<float> &normals);

/* The vectors, each divided by its length; one of length zero becomes e3. */
std::vector<float> unit_vectors(const std::vector<double> &vectors);

} // namespace motorway::tool

#endif
