#include "scaling.h"

#include <cmath>

#include "error.h"
#include "text.h"

namespace motorway::tool {

void check_scale(const std::optional<double> &option)
{
    if (option && !(std::isfinite(*option) && *option > 0))
        throw Error("--scale", "must be above 0 and finite; correct it");
}

Scaling choose_scale(const std::optional<double> &option, const Motion &motion, const Mesh &mesh)
{
    if (option)
        return {*option, "--scale"};
    const double side = bounding_box(mesh).longest_side();
    if (motion.mesh_size && side > 0)
        return {*motion.mesh_size / side, "the motion file wants a mesh of size " + brief(*motion.mesh_size)};
    return {1.0, ""};
}

void scale_mesh(Mesh &mesh, double factor, const std::string &path)
{
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double scaled = mesh.positions[i] * factor;
        if (std::isfinite(mesh.positions[i]) &&
            !std::isfinite(mesh.in_double ? scaled : static_cast<double>(static_cast<float>(scaled))))
            throw Error(path, std::string("is too large for ") + (mesh.in_double ? "doubles" : "floats") +
                                  " when it is scaled by " + brief(factor) + "; use less");
        mesh.positions[i] = scaled;
    }
}

} // namespace motorway::tool
