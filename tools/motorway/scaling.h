/* The size of a mesh under a motion: as asked for, as the motion file wants it, or as it is. */
#ifndef MOTORWAY_TOOL_SCALING_H
#define MOTORWAY_TOOL_SCALING_H

#include <optional>
#include <string>

#include "mesh.h"
#include "motion.h"

namespace motorway::tool {

struct Scaling {
    double factor;
    std::string reason; /* for the summary; empty if nobody asked for one */
};

/* Throws an Error unless the value of the option --scale, if any, is above 0 and finite. */
void check_scale(const std::optional<double> &option);

Scaling choose_scale(const std::optional<double> &option, const Motion &motion, const Mesh &mesh);

/* Throws an Error that names `path` if the mesh becomes too large for what it is written in. */
void scale_mesh(Mesh &mesh, double factor, const std::string &path);

} // namespace motorway::tool

#endif
