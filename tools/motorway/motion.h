/* A motion as the tool uses it: what its file says, and that compiled by the library. */
#ifndef MOTORWAY_TOOL_MOTION_H
#define MOTORWAY_TOOL_MOTION_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motorway_views.h"

namespace motorway::tool {

struct Motion {
    std::string name; /* for people; may be empty */
    mw_motion_kind kind = MW_MOTION_ADDITIVE;
    unsigned degree = 1;
    std::vector<mw_motor_f64> controls;
    std::vector<double> knots;   /* empty: the library's own */
    std::vector<double> weights; /* empty: none */
    bool closed = false;
    bool keep_signs = false;
    std::optional<mw_motor_f64> base;
    std::optional<double> mesh_size; /* what the longest side of a mesh's bounding box should be */

    /* What the library makes of all that; compile() fills it, and *where is as in mw_compile_motion. */
    std::vector<std::uint64_t> memory;
    mw_status compile(std::size_t *where);
    const mw_compiled_motion_f64 *compiled() const
    {
        return reinterpret_cast<const mw_compiled_motion_f64 *>(memory.data());
    }

    /* The ends of the domain. */
    double start() const;
    double end() const;
};

/* The name of a scheme, as in motion files: "generator_keys". */
const char *scheme_name(mw_motion_kind kind);

/* `count` parameters spread evenly over the domain, both ends included; one alone is the start. */
std::vector<double> even_parameters(const Motion &motion, std::size_t count);

/* The normalised motors at these parameters. Throws an Error that names `where`. */
std::vector<mw_motor_f64> sample(const Motion &motion, const std::vector<double> &parameters,
                                 const std::string &where);

void normalize(std::vector<mw_motor_f64> &motors);

/* The paths of a point under each of the motors, as x y z. */
std::vector<double> trace(const std::vector<mw_motor_f64> &motors, const std::array<double, 3> &point);

} // namespace motorway::tool

#endif
