/* A polygon mesh or a cloud of points as the files hold it: vertices in their order, faces with any number of
 * corners. */
#ifndef MOTORWAY_TOOL_MESH_H
#define MOTORWAY_TOOL_MESH_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace motorway::tool {

class MeshSource;

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Triangle = std::array<std::uint32_t, 3>;

/* The number of something that is not there. */
constexpr std::uint32_t NONE = 0xffffffff;

/* What becomes of what a file may hold and nobody can draw. */
constexpr const char *ONLY_KEPT = "kept in files of the same kind, and left out of all else";

struct Mesh {
    /* What a motion moves. Floats are exact as doubles, and are rounded to floats again when they have been moved. */
    std::vector<double> positions;            /* x y z a vertex */
    std::vector<double> normals;              /* x y z a normal */
    std::vector<double> tangents, bitangents; /* x y z a vertex, or empty */
    std::vector<double> face_normals;         /* x y z a face of the file, or empty */
    bool in_double = false;                   /* they are doubles in the file, or some of them */

    std::vector<float> tangent_signs; /* 1 or -1 a vertex, or empty */
    std::vector<float> colours;       /* r g b a a vertex, from 0 to 1, or empty */
    bool has_alpha = false;           /* else a is 1 */
    std::vector<float> uvs;           /* u v a texture coordinate, v upwards */

    std::vector<std::uint32_t> corners; /* the vertices of all faces, one face after the other */
    /* The normal and the texture coordinate of each corner, or NONE; empty if number i is that of vertex i. */
    std::vector<std::uint32_t> corner_normals, corner_uvs;
    std::vector<std::size_t> face_starts{0}; /* the first corner of each face, and the number of all corners */
    std::vector<Edge> lines;                 /* that are not edges of faces */

    std::vector<std::string> beyond;   /* what the file holds and the rest of a Mesh does not, for people to read */
    std::vector<std::string> notes;    /* what was found in the file and is in order */
    std::vector<std::string> warnings; /* what was found and may be a mistake */
    std::shared_ptr<const MeshSource> source; /* the file itself, to be written again; null if there is none */

    std::size_t vertex_count() const { return positions.size() / 3; }
    std::size_t normal_count() const { return normals.size() / 3; }
    std::size_t face_count() const { return face_starts.size() - 1; }
    bool is_cloud() const { return corners.empty() && lines.empty(); }

    bool has_vertex_normals() const;
    bool has_vertex_uvs() const;
    bool has_finite_position(std::size_t vertex) const;
};

/* A Mesh in a pose: the numbers that are written instead of its own. */
struct Pose {
    std::vector<double> positions, normals, tangents, bitangents, face_normals;
};

/* A file that was read as a mesh, and is kept to be written again. */
class MeshSource {
public:
    virtual ~MeshSource() = default;

    /* The extension of its format: ".ply". */
    virtual const char *kind() const = 0;

    /* The contents of the file with these numbers in the places of its own, and else as it was. */
    virtual std::string write(const Pose &pose) const = 0;
};

/* A number that is only drawn, as a float; one that no float can hold becomes 0. */
float drawable(double number);

struct Box {
    std::array<double, 3> low, high;

    double longest_side() const;
    double diagonal() const;
};

/* Reads an OBJ or PLY file, by its extension. Throws an Error with file and line if anything is wrong with it. */
Mesh read_mesh(const std::string &path);

Box bounding_box(const Mesh &mesh);

/* Zero; of a mesh that is very far from zero for its size, as in the coordinates of a map, a point near its middle. */
std::array<double, 3> far_origin(const Mesh &mesh);

/* Every edge of a face and every line once, the smaller vertex first. */
std::vector<Edge> edges(const Mesh &mesh);

/* Fans of triangles: right for convex faces. Each holds indices into mesh.corners. */
std::vector<Triangle> triangles(const Mesh &mesh);

/* The mesh without the vertices whose coordinates are not all finite, and the faces and lines that touch them: what
 * can be drawn of it. */
Mesh finite_part(const Mesh &mesh);

} // namespace motorway::tool

#endif
