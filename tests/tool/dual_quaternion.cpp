#include "dual_quaternion.h"

#include <algorithm>
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

/* The knots with one more at each end, as basis() wants them. */
static std::vector<double> with_ends(const std::vector<double> &knots)
{
    std::vector<double> all = {knots.front()};
    all.insert(all.end(), knots.begin(), knots.end());
    all.push_back(knots.back());
    return all;
}

DualQuaternion reference_bspline(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                 unsigned degree, double t)
{
    const std::vector<double> all = with_ends(knots);
    DualQuaternion sum = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    for (std::size_t i = 0; i < controls.size(); ++i) {
        const double weight = basis(all, i, degree, t);
        sum.real = sum.real + scaled(weight, controls[i].real);
        sum.dual = sum.dual + scaled(weight, controls[i].dual);
    }
    return sum;
}

/* ------------------------------------------------------------------------------------ logarithms and schemes --- */

/* u + εp, of pure quaternions: half of a screw, with |u| half of its angle. */
struct Generator {
    Vector u, p;
};

static double dot(const Vector &a, const Vector &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static Vector mixed(double j, const Vector &a, double k, const Vector &b)
{
    return {j * a[0] + k * b[0], j * a[1] + k * b[1], j * a[2] + k * b[2]};
}

static Generator mixed(double j, const Generator &a, double k, const Generator &b)
{
    return {mixed(j, a.u, k, b.u), mixed(j, a.p, k, b.p)};
}

static DualQuaternion product(const DualQuaternion &a, const DualQuaternion &b)
{
    return {a.real * b.real, a.real * b.dual + a.dual * b.real};
}

static DualQuaternion inverse(const DualQuaternion &unit)
{
    return {conjugate(unit.real), conjugate(unit.dual)};
}

DualQuaternion reference_normalized(const DualQuaternion &pose)
{
    const double size = std::sqrt(square(pose.real));
    double along = 0;
    for (std::size_t k = 0; k < 4; ++k)
        along += pose.real[k] * pose.dual[k] / (size * size);
    return {scaled(1 / size, pose.real), scaled(1 / size, pose.dual + scaled(-along, pose.real))};
}

/* cos â + sin â n̂ with the dual angle â = a + εb and the dual vector n̂ = n + εm, of a unit dual quaternion; of q and
 * -q the one with the smaller angle. */
static Generator logarithm(DualQuaternion q)
{
    if (q.real[0] < 0)
        q = {scaled(-1, q.real), scaled(-1, q.dual)};
    const Vector v = {q.real[1], q.real[2], q.real[3]}, d = {q.dual[1], q.dual[2], q.dual[3]};
    const double sine = std::hypot(v[0], v[1], v[2]);
    if (sine < 1e-12)
        return {{0, 0, 0}, d};
    const double a = std::atan2(sine, q.real[0]), b = -q.dual[0] / sine;
    const Vector n = mixed(1 / sine, v, 0, v), m = mixed(1 / sine, d, -b * q.real[0] / sine, n);
    return {mixed(a, n, 0, n), mixed(a, m, b, n)};
}

static DualQuaternion exponential(const Generator &g)
{
    const double a = std::hypot(g.u[0], g.u[1], g.u[2]);
    if (a < 1e-12)
        return {{1, 0, 0, 0}, {0, g.p[0], g.p[1], g.p[2]}};
    const Vector n = mixed(1 / a, g.u, 0, g.u);
    const double b = dot(g.p, n), c = std::cos(a), s = std::sin(a);
    const Vector m = mixed(1 / a, g.p, -b / a, n), d = mixed(b * c, n, s, m);
    return {{c, s * n[0], s * n[1], s * n[2]}, {-b * s, d[0], d[1], d[2]}};
}

/* from (from^-1 to)^t, in the order of quaternions, of unit poses. */
static DualQuaternion on_the_way(const DualQuaternion &from, const DualQuaternion &to, double t)
{
    const Generator whole = logarithm(product(inverse(from), to));
    return product(from, exponential(mixed(t, whole, 0, whole)));
}

DualQuaternion reference_slerp(const DualQuaternion &from, const DualQuaternion &to, double t)
{
    return on_the_way(reference_normalized(from), reference_normalized(to), t);
}

DualQuaternion reference_multiplicative(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                        unsigned degree, double t)
{
    std::size_t first = 0; /* of the degree + 1 controls that are felt at t */
    while (first + degree + 1 < controls.size() && t >= knots[first + degree])
        ++first;
    std::vector<DualQuaternion> row(controls.begin() + static_cast<std::ptrdiff_t>(first),
                                    controls.begin() + static_cast<std::ptrdiff_t>(first + degree + 1));
    for (unsigned round = 0; round < degree; ++round)
        for (std::size_t k = 0; k + round < degree; ++k) {
            const double low = knots[first + k + round], high = knots[first + k + degree];
            row[k] = reference_slerp(row[k], row[k + 1], (t - low) / (high - low));
        }
    return row[0];
}

DualQuaternion reference_cumulative(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                    unsigned degree, double t)
{
    const std::vector<double> all = with_ends(knots);
    DualQuaternion pose = reference_normalized(controls[0]);
    for (std::size_t k = 1; k < controls.size(); ++k) {
        double power = 0;
        for (std::size_t later = k; later < controls.size(); ++later)
            power += basis(all, later, degree, t);
        const DualQuaternion before = reference_normalized(controls[k - 1]);
        pose = product(pose, product(inverse(before), reference_slerp(before, controls[k], power)));
    }
    return pose;
}

static Generator relative(const DualQuaternion &pose, const DualQuaternion &base)
{
    return logarithm(product(reference_normalized(pose), inverse(reference_normalized(base))));
}

DualQuaternion reference_generator(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                   unsigned degree, const DualQuaternion &base, double t)
{
    const std::vector<double> all = with_ends(knots);
    Generator sum = {};
    for (std::size_t k = 0; k < controls.size(); ++k)
        sum = mixed(1, sum, basis(all, k, degree, t), relative(controls[k], base));
    return product(exponential(sum), reference_normalized(base));
}

/* The parabola through the logarithms of the keys around the one in the middle, by Lagrange. */
static Generator parabola(const std::vector<DualQuaternion> &keys, const std::vector<double> &times,
                          const DualQuaternion &base, std::size_t middle, double t)
{
    Generator sum = {};
    for (std::size_t k = middle - 1; k <= middle + 1; ++k) {
        double weight = 1;
        for (std::size_t other = middle - 1; other <= middle + 1; ++other)
            if (other != k)
                weight *= (t - times[other]) / (times[k] - times[other]);
        sum = mixed(1, sum, weight, relative(keys[k], base));
    }
    return sum;
}

DualQuaternion reference_generator_keys(const std::vector<DualQuaternion> &keys, const std::vector<double> &times,
                                        const DualQuaternion &base, double t)
{
    std::size_t before = 0;
    while (before + 2 < keys.size() && t >= times[before + 1])
        ++before;
    const std::size_t first = std::max<std::size_t>(before, 1), second = std::min(before + 1, keys.size() - 2);
    const double share = (t - times[before]) / (times[before + 1] - times[before]);
    return product(exponential(mixed(1 - share, parabola(keys, times, base, first, t), share,
                                     parabola(keys, times, base, second, t))),
                   reference_normalized(base));
}

/* ------------------------------------------------------------------------------------------------- their use --- */

Vector reference_translation_of(const DualQuaternion &pose)
{
    return reference_point(pose, {0, 0, 0});
}

/* The logarithm of what happens between two moments, over the time between them. */
Velocity reference_velocity(const std::function<DualQuaternion(double)> &motion, double t, double step)
{
    const DualQuaternion before = reference_normalized(motion(t - step)),
                         after = reference_normalized(motion(t + step));
    const Generator way = logarithm(product(after, inverse(before)));
    const double rate = 1 / (2 * step);
    const Vector ends = mixed(rate, reference_translation_of(after), -rate, reference_translation_of(before));
    return {mixed(2 * rate, way.u, 0, way.u), ends};
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
