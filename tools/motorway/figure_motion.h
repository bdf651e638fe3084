/* Poses and motions for figures: the C API of motions in double, with arrays that look after themselves. */
#ifndef MOTORWAY_TOOL_FIGURE_MOTION_H
#define MOTORWAY_TOOL_FIGURE_MOTION_H

#include <cstddef>
#include <vector>

#include "camera.h"
#include "motorway_views.h"

namespace motorway::tool {

using Poses = std::vector<mw_motor_f64>;
using Path = std::vector<Vec3>;

constexpr double PI = 3.14159265358979323846;

mw_motor_f64 rotation(Vec3 axis, double angle);
mw_motor_f64 translation(Vec3 offset);
mw_motor_f64 product(const mw_motor_f64 &first, const mw_motor_f64 &then);

/* Row i is the sum of the controls with the weights of row i. */
Poses blends(const Poses &controls, const std::vector<std::vector<double>> &weights);

/* The points under a pose; one point under many. */
Path images(const mw_motor_f64 &pose, const Path &points);
Path images(const Poses &poses, Vec3 point);

/* `count` numbers spread evenly from first to last, both included. */
std::vector<double> spread(double first, double last, std::size_t count);

class CompiledMotion {
public:
    CompiledMotion(mw_motion_kind kind, unsigned degree, const Poses &controls,
                   const std::vector<double> &knots = {});

    /* Additive, of this degree, through the keys at these times. */
    static CompiledMotion through(const Poses &keys, const std::vector<double> &times, unsigned degree);

    double start() const { return domain_[0]; }
    double end() const { return domain_[1]; }
    std::vector<double> parameters(std::size_t count) const { return spread(start(), end(), count); }

    /* At `count` parameters spread evenly over the domain: the poses; the places of the origin; its speeds. */
    Poses poses(std::size_t count) const;
    Path path(std::size_t count) const;
    std::vector<double> speeds(std::size_t count) const;

    /* Of the way of the origin. */
    double length() const;

    /* The largest distance between the images of these points under this motion and under another. */
    double distance(const CompiledMotion &other, const Path &points) const;

private:
    CompiledMotion(const mw_motion_f64 &description, unsigned flags) { compile(description, flags); }

    void compile(const mw_motion_f64 &description, unsigned flags);
    const mw_compiled_motion_f64 *compiled() const;

    std::vector<double> memory_;
    double domain_[2] = {0, 0};
};

} // namespace motorway::tool

#endif
