#include "motion_reference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace motorway::reference {
namespace {

Quaternion product(const Quaternion &a, const Quaternion &b)
{
    return {a[3] * b[0] + b[3] * a[0] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] + b[3] * a[1] + a[2] * b[0] - a[0] * b[2],
            a[3] * b[2] + b[3] * a[2] + a[0] * b[1] - a[1] * b[0],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

Quaternion sum(const Quaternion &a, const Quaternion &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}

Quaternion multiple(long double factor, const Quaternion &a)
{
    return {factor * a[0], factor * a[1], factor * a[2], factor * a[3]};
}

Quaternion conjugate(const Quaternion &a) { return {-a[0], -a[1], -a[2], a[3]}; }

long double dot(const Quaternion &a, const Quaternion &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Quaternion vector_part(const Quaternion &a) { return {a[0], a[1], a[2], 0}; }

// f(x) and f'(x) of an analytic function, which of the dual number x + εy is f(x) + ε f'(x) y.
struct Taylor {
    long double value, derivative;
};

// Σ c_k x^k, the coefficients from their quotients.
template <class Quotient>
Taylor power_series(long double x, Quotient quotient)
{
    Taylor f{0, 0};
    long double coefficient = 1, power = 1;  // of x^k
    for (int k = 0; k < 24; ++k) {
        f.value += coefficient * power;
        coefficient *= quotient(k);
        f.derivative += static_cast<long double>(k + 1) * coefficient * power;
        power *= x;
    }
    return f;
}

// sin √x / √x.
Taylor sinc_of_square(long double x)
{
    if (x < 0.5L)
        return power_series(x, [](int k) { return -1.0L / static_cast<long double>((2 * k + 2) * (2 * k + 3)); });
    const long double root = std::sqrt(x), sinc = std::sin(root) / root;
    return {sinc, (std::cos(root) - sinc) / (2 * x)};
}

// acos(c) / sqrt(1 - c²), by sine and cosine of the same angle; for a small one the series of asin(s) / s in s².
Taylor angle_over_sine(long double c, long double s)
{
    if (c > 0 && s < 0.2L) {
        const Taylor f = power_series(s * s, [](int k) {
            const long double odd = 2 * k + 1;
            return odd * odd / ((odd + 1) * (odd + 2));
        });
        return {f.value, -2 * c * f.derivative};
    }
    const long double f = std::atan2(s, c) / s;
    return {f, (c * f - 1) / (s * s)};
}

// The blossom of the paper's section 4 at (t, ..., t), in a piece [knots[i], knots[i + 1]], with any mean of two.
template <class Value>
Value blossom(std::vector<Value> values, const std::vector<long double> &knots, std::size_t i, long double t,
              Value (*mean)(const Value &, const Value &, long double))
{
    // values[r] is S with r knots up to t_i, then t, then s = given - r knots from t_(i+1); no t at first.
    for (std::size_t given = values.size() - 1; given-- > 0;)
        for (std::size_t r = 0; r <= given; ++r) {
            const long double before = knots[i - r], after = knots[i + given - r + 1];
            values[r] = mean(values[r + 1], values[r], (t - before) / (after - before));
        }
    return values[0];
}

template <class Value>
Value weighted_mean(const Value &a, const Value &b, long double u)
{
    return (1 - u) * a + u * b;
}

}  // namespace

DualQuaternion operator+(const DualQuaternion &a, const DualQuaternion &b)
{
    return {sum(a.real, b.real), sum(a.dual, b.dual)};
}

DualQuaternion operator*(long double factor, const DualQuaternion &a)
{
    return {multiple(factor, a.real), multiple(factor, a.dual)};
}

DualQuaternion operator*(const DualQuaternion &a, const DualQuaternion &b)
{
    return {product(a.real, b.real), sum(product(a.real, b.dual), product(a.dual, b.real))};
}

DualQuaternion compose(const DualQuaternion &first, const DualQuaternion &then) { return then * first; }

// The conjugate, divided by the dual number a a* = α + εβ.
DualQuaternion inverse(const DualQuaternion &a)
{
    const long double alpha = dot(a.real, a.real), beta = 2 * dot(a.real, a.dual);
    const Quaternion real = multiple(1 / alpha, conjugate(a.real));
    return {real, sum(multiple(1 / alpha, conjugate(a.dual)), multiple(-beta / alpha, real))};
}

DualQuaternion normalize(const DualQuaternion &a)
{
    const long double length = std::sqrt(dot(a.real, a.real));
    const Quaternion real = multiple(1 / length, a.real), dual = multiple(1 / length, a.dual);
    return {real, sum(dual, multiple(-dot(real, dual), real))};
}

long double dot_of_rotations(const DualQuaternion &a, const DualQuaternion &b) { return dot(a.real, b.real); }

DualQuaternion exp(const DualQuaternion &g)
{
    const long double x = dot(g.real, g.real), y = 2 * dot(g.real, g.dual);
    const Taylor sinc = sinc_of_square(x);
    DualQuaternion power{multiple(sinc.value, g.real),
                         sum(multiple(sinc.value, g.dual), multiple(sinc.derivative * y, g.real))};
    power.real[3] = std::cos(std::sqrt(x));
    power.dual[3] = -sinc.value / 2 * y;
    return power;
}

DualQuaternion log(const DualQuaternion &a)
{
    const Quaternion turn = vector_part(a.real);
    const Taylor f = angle_over_sine(a.real[3], std::sqrt(dot(turn, turn)));
    return {multiple(f.value, turn),
            sum(multiple(f.value, vector_part(a.dual)), multiple(f.derivative * a.dual[3], turn))};
}

DualQuaternion slerp(const DualQuaternion &first, const DualQuaternion &second, long double t)
{
    const DualQuaternion nearer = dot_of_rotations(first, second) < 0 ? -1.0L * second : second;
    return compose(first, exp(t * log(compose(inverse(first), nearer))));
}

std::array<long double, 3> apply_point(const DualQuaternion &pose, const std::array<long double, 3> &point)
{
    const DualQuaternion unit = normalize(pose);
    const Quaternion back = conjugate(unit.real);
    const Quaternion turned = product(product(unit.real, {point[0], point[1], point[2], 0}), back);
    const Quaternion moved = sum(turned, multiple(2, product(unit.dual, back)));
    return {moved[0], moved[1], moved[2]};
}

DualQuaternion dual_quaternion(const std::array<long double, 8> &m)
{
    return {{m[3], -m[2], m[1], m[0]}, {m[4], m[5], m[6], -m[7]}};
}

std::array<long double, 8> motor_numbers(const DualQuaternion &a)
{
    return {a.real[3], a.real[2], -a.real[1], a.real[0], a.dual[0], a.dual[1], a.dual[2], -a.dual[3]};
}

std::array<long double, 6> bivector_numbers(const DualQuaternion &a)
{
    return {a.real[2], -a.real[1], a.real[0], a.dual[0], a.dual[1], a.dual[2]};
}

std::vector<long double> default_knots(mw_motion_kind kind, std::size_t degree, std::size_t control_count,
                                       bool closed)
{
    const bool clamped = kind != MW_MOTION_GENERATOR_KEYS && !closed;
    const std::size_t pieces = closed ? control_count : control_count - (clamped ? degree : 1);
    std::vector<long double> knots(clamped ? degree - 1 : 0, 0);
    for (std::size_t k = 0; k <= pieces; ++k)
        knots.push_back(static_cast<long double>(k));
    knots.resize(knots.size() + (clamped ? degree - 1 : 0), knots.back());
    return knots;
}

// ---------------------------------------------------------------------------------------------------------- a motion

Motion::Motion(const MotionDescription &description)
    : kind_(description.kind), degree_(description.degree), controls_(description.controls),
      knots_(description.knots), base_(normalize(description.base))
{
    const bool of_keys = kind_ == MW_MOTION_GENERATOR_KEYS;
    const bool of_generators = of_keys || kind_ == MW_MOTION_GENERATOR;
    const std::size_t count = controls_.size();
    if (knots_.empty())
        knots_ = default_knots(kind_, degree_, count, description.closed);
    if (kind_ != MW_MOTION_ADDITIVE)
        for (DualQuaternion &control : controls_)
            control = normalize(control);
    if (of_generators)
        for (DualQuaternion &control : controls_)
            control = compose(inverse(base_), control);
    choose_signs(description);
    for (std::size_t k = 0; k < description.weights.size(); ++k)
        controls_[k] = description.weights[k] * controls_[k];
    if (of_generators)
        for (DualQuaternion &control : controls_)
            control = log(control);

    first_span_ = of_keys ? 0 : degree_ - 1;
    if (description.closed) {
        first_span_ = of_keys ? 1 : degree_ - 1;
        of_keys ? repeat(1, 2, 1, 1) : repeat(degree_ - 1, 1, degree_ - 1, degree_ - 1);
    }
    last_span_ = description.closed ? first_span_ + count - 1 : count - 2;
}

// Each nearer to the one before it; generators begin with the one nearer to the base, and come back to themselves.
void Motion::choose_signs(const MotionDescription &description)
{
    if (description.keeps_signs)
        return;
    const bool of_generators = kind_ == MW_MOTION_GENERATOR || kind_ == MW_MOTION_GENERATOR_KEYS;
    if (of_generators && controls_[0].real[3] < 0)
        controls_[0] = -1.0L * controls_[0];
    for (std::size_t k = 1; k < controls_.size(); ++k)
        if (dot_of_rotations(controls_[k - 1], controls_[k]) < 0)
            controls_[k] = -1.0L * controls_[k];
    return_sign_ = !of_generators && dot_of_rotations(controls_.back(), controls_.front()) < 0 ? -1 : 1;
}

// Some controls and knots of the periods before and after this one.
void Motion::repeat(std::size_t before, std::size_t after, std::size_t knots_before, std::size_t knots_after)
{
    const std::size_t count = controls_.size();
    const long double period = knots_.back() - knots_.front();
    std::vector<DualQuaternion> controls;
    for (std::size_t k = count - before; k < 2 * count + after; ++k)
        controls.push_back((k / count == 1 ? 1 : return_sign_) * controls_[k % count]);
    std::vector<long double> knots;
    for (std::size_t k = count - knots_before; k <= 2 * count + knots_after; ++k)
        knots.push_back(knots_[k % count] + (static_cast<long double>(k / count) - 1) * period);
    controls_ = controls;
    knots_ = knots;
}

std::vector<std::size_t> Motion::spans() const
{
    std::vector<std::size_t> spans;
    for (std::size_t i = first_span_; i <= last_span_; ++i)
        if (knots_[i] < knots_[i + 1])
            spans.push_back(i);
    return spans;
}

std::size_t Motion::span_of(long double t) const
{
    if (!(first() <= t && t <= last()))
        throw std::domain_error("the parameter is outside the domain");
    std::size_t span = 0;
    for (std::size_t i : spans())
        if (knots_[i] <= t)
            span = i;
    return span;
}

std::vector<DualQuaternion> Motion::controls_of(std::size_t span) const
{
    std::vector<DualQuaternion> controls;
    const std::size_t count = kind_ == MW_MOTION_GENERATOR_KEYS ? 2 : degree_ + 1;
    for (std::size_t r = 0; r < count; ++r)
        controls.push_back(controls_[span + 1 - r]);
    return controls;
}

DualQuaternion Motion::at(long double t, std::size_t span) const
{
    switch (kind_) {
    case MW_MOTION_MULTIPLICATIVE: return blossom(controls_of(span), knots_, span, t, slerp);
    case MW_MOTION_CUMULATIVE: return cumulative(t, span);
    case MW_MOTION_GENERATOR: return compose(base_, exp(sum_of_controls(t, span)));
    case MW_MOTION_GENERATOR_KEYS: return compose(base_, exp(hermite(t, span)));
    default: return sum_of_controls(t, span);
    }
}

DualQuaternion Motion::sum_of_controls(long double t, std::size_t span) const
{
    return blossom(controls_of(span), knots_, span, t, weighted_mean<DualQuaternion>);
}

// exp(c_n b_n) ... exp(c_1 b_1) S_0, from the first control of the piece on: before it every c is 1, so that the
// product is the control. c_k = N_k + N_(k+1) + ... is the spline of controls 0 up to k and of 1 from it on.
DualQuaternion Motion::cumulative(long double t, std::size_t span) const
{
    const std::size_t first = span + 1 - degree_;
    DualQuaternion pose = controls_[first];
    for (std::size_t k = first + 1; k <= span + 1; ++k) {
        std::vector<long double> steps;
        for (std::size_t r = 0; r <= degree_; ++r)
            steps.push_back(span + 1 - r >= k ? 1 : 0);
        const long double c = blossom(steps, knots_, span, t, weighted_mean<long double>);
        const DualQuaternion relative = compose(controls_[k], inverse(controls_[k - 1]));
        pose = compose(exp(c * log(relative)), pose);
    }
    return pose;
}

DualQuaternion Motion::hermite(long double t, std::size_t span) const
{
    const long double width = knots_[span + 1] - knots_[span], u = (t - knots_[span]) / width, v = 1 - u;
    return v * v * (1 + 2 * u) * controls_[span] + u * u * (1 + 2 * v) * controls_[span + 1] +
           width * u * v * v * derivative_at_key(span) + -width * u * u * v * derivative_at_key(span + 1);
}

// That of the parabola through a key and its neighbours, at an end through the last three; of two keys the chord.
DualQuaternion Motion::derivative_at_key(std::size_t key) const
{
    if (controls_.size() == 2)
        return 1 / (knots_[1] - knots_[0]) * (controls_[1] + -1.0L * controls_[0]);
    const std::size_t middle = std::clamp<std::size_t>(key, 1, controls_.size() - 2);
    const std::size_t keys[3] = {middle - 1, middle, middle + 1};
    const long double t = knots_[key];
    DualQuaternion derivative{{0, 0, 0, 0}, {0, 0, 0, 0}};
    for (int k = 0; k < 3; ++k) {
        const long double a = knots_[keys[(k + 1) % 3]], b = knots_[keys[(k + 2) % 3]], own = knots_[keys[k]];
        derivative = derivative + (2 * t - a - b) / ((own - a) * (own - b)) * controls_[keys[k]];
    }
    return derivative;
}

DualQuaternion Motion::twist(long double t, std::size_t span, Frame frame) const
{
    constexpr long double factors[] = {4 / 5.0L, -1 / 5.0L, 4 / 105.0L, -1 / 280.0L};
    const long double step = std::ldexp(knots_[span + 1] - knots_[span], -10);
    DualQuaternion derivative{{0, 0, 0, 0}, {0, 0, 0, 0}};
    for (int k = 1; k <= 4; ++k) {
        const long double shift = static_cast<long double>(k) * step, factor = factors[k - 1] / step;
        derivative = derivative + factor * (at(t + shift, span) + -1.0L * at(t - shift, span));
    }
    const DualQuaternion back = inverse(at(t, span));
    DualQuaternion twist = frame == Frame::space ? compose(back, derivative) : compose(derivative, back);
    twist.real[3] = twist.dual[3] = 0;  // the growth of the length of S, which moves nothing
    return twist;
}

}  // namespace motorway::reference
