/* What a picture of a motion shows, in space: the mesh at some parameters, the path of its origin, the controls. */
#ifndef MOTORWAY_TOOL_PICTURE_SCENE_H
#define MOTORWAY_TOOL_PICTURE_SCENE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "camera.h"
#include "mesh.h"
#include "motion.h"

namespace motorway::tool {

constexpr std::size_t PATH_STEPS = 240;

struct Box3 {
    Vec3 low, high;

    Vec3 middle() const { return 0.5 * (low + high); }
    double longest_side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-30}); }
};

/* The mesh at one parameter. */
struct Figure {
    double share; /* of the way along the motion, 0 to 1 */
    Pose pose;
    Box3 box;
};

/* What there is to see, in space. */
struct Scene {
    std::vector<Figure> figures;
    std::vector<double> path;                        /* of the origin, PATH_STEPS + 1 points */
    std::vector<std::array<Vec3, 4>> control_frames; /* the origin of each, and the tips of its axes */
    std::vector<Triangle> triangles;                 /* of vertices */
    std::vector<Edge> lines;
    std::vector<std::uint32_t> points; /* the vertices that are drawn of a cloud */
    bool closed;                                     /* nobody sees the inside of a closed mesh */
    bool simplified = false;                         /* the mesh has more details than are drawn */
    Box3 box;
};

/* Throws an Error that names `path`, the file of the motion, if the mesh lands too far away to be drawn. */
Scene make_scene(const Mesh &whole, const Motion &motion, std::size_t pose_count, const std::string &path);

/* Points that hold the whole scene between them: the corners of each figure's box, the path, the control poses. */
std::vector<Vec3> outermost_points(const Scene &scene);

} // namespace motorway::tool

#endif
