#include "dual_quaternion.h"

#include <cmath>

namespace motorway::tool {

static Quaternion operator*(const Quaternion &a, const Quaternion &b)
{
    return {
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

static Quaternion operator+(const Quaternion &a, const Quaternion &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}

static Quaternion scaled(double k, const Quaternion &a)
{
    return {k * a[0], k * a[1], k * a[2], k * a[3]};
}

static Quaternion conjugate(const Quaternion &a)
{
    return {a[0], -a[1], -a[2], -a[3]};
}

static double square(const Quaternion &a)
{
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3];
}

DualQuaternion reference_translation(const Vector &offset)
{
    return {{1, 0, 0, 0}, {0, offset[0] / 2, offset[1] / 2, offset[2] / 2}};
}

DualQuaternion reference_sequence(const std::vector<DualQuaternion> &steps)
{
    DualQuaternion pose = {{1, 0, 0, 0}, {0, 0, 0, 0}};
    for (const DualQuaternion &step : steps)
        pose = {step.real * pose.real, step.real * pose.dual + step.dual * pose.real};
    return pose;
}

DualQuaternion reference_rotation(const Vector &axis, double degrees, const Vector &through)
{
    const double half = degrees * std::acos(-1.0) / 360, size = std::hypot(axis[0], axis[1], axis[2]);
    const double s = std::sin(half) / size;
    const DualQuaternion turn = {{std::cos(half), s * axis[0], s * axis[1], s * axis[2]}, {0, 0, 0, 0}};
    return reference_sequence(
        {reference_translation({-through[0], -through[1], -through[2]}), turn, reference_translation(through)});
}

std::array<double, 8> coefficients(const DualQuaternion &pose)
{
    return {pose.real[0], pose.real[3], -pose.real[2], pose.real[1],
            pose.dual[1], pose.dual[2], pose.dual[3],  -pose.dual[0]};
}

/* N of this control and degree, over knots with the superfluous ones added at both ends. */
static double basis(const std::vector<double> &knots, std::size_t control, unsigned degree, double t)
{
    if (degree == 0) {
        const bool last = t == knots.back() && knots[control] < t && knots[control + 1] == t;
        return (knots[control] <= t && t < knots[control + 1]) || last ? 1 : 0;
    }
    const double rise = knots[control + degree] - knots[control];
    const double fall = knots[control + degree + 1] - knots[control + 1];
    double sum = 0;
    if (rise > 0)
        sum += (t - knots[control]) / rise * basis(knots, control, degree - 1, t);
    if (fall > 0)
        sum += (knots[control + degree + 1] - t) / fall * basis(knots, control + 1, degree - 1, t);
    return sum;
}

DualQuaternion reference_bspline(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                 unsigned degree, double t)
{
    std::vector<double> all = {knots.front()};
    all.insert(all.end(), knots.begin(), knots.end());
    all.push_back(knots.back());
    DualQuaternion sum = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    for (std::size_t i = 0; i < controls.size(); ++i) {
        const double weight = basis(all, i, degree, t);
        sum.real = sum.real + scaled(weight, controls[i].real);
        sum.dual = sum.dual + scaled(weight, controls[i].dual);
    }
    return sum;
}

Vector reference_direction(const DualQuaternion &pose, const Vector &direction)
{
    const Quaternion turned =
        pose.real * Quaternion{0, direction[0], direction[1], direction[2]} * conjugate(pose.real);
    const double size = square(pose.real);
    return {turned[1] / size, turned[2] / size, turned[3] / size};
}

Vector reference_point(const DualQuaternion &pose, const Vector &point)
{
    const Vector turned = reference_direction(pose, point);
    const Quaternion moved = scaled(2 / square(pose.real), pose.dual * conjugate(pose.real));
    return {turned[0] + moved[1], turned[1] + moved[2], turned[2] + moved[3]};
}

std::vector<DualQuaternion> figure_5_controls()
{
    const Vector x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    return {
        reference_translation({1, 1, 0}),
        reference_sequence({reference_rotation(z, 30), reference_translation({6, 1, 0})}),
        reference_sequence({reference_rotation(z, 90), reference_translation({8, 4, 2})}),
        reference_sequence({reference_rotation(z, 90), reference_rotation(x, 45), reference_translation({8, 6, 4})}),
        reference_sequence({reference_rotation(z, 90), reference_rotation(y, 60), reference_translation({4, 6, 6})}),
        reference_sequence({reference_rotation(z, 90), reference_rotation(y, 90), reference_translation({1, 6, 2})}),
    };
}

} // namespace motorway::tool
