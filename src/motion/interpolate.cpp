// Motions through keys. Additive: the keys are linear in the controls, which are the solution of one system of
// equations. Cumulative: Newton's method, in which each round solves such a system for corrections of the controls.
#include "../view.h"
#include "adjoint.h"
#include "banded.h"
#include "description.h"
#include "scalar_motor.h"

#include <algorithm>

namespace motorway {
namespace {

using motor = scalar_motor<double>;
using bivector = scalar_bivector<double>;

// Newton's method squares what is missing of rotations, and of translations a round later. So once so many epsilons are
// missing, what is left after this round and another is rounding alone.
constexpr double almost = 256;
constexpr int most_rounds = 50;

// What is worked out before anything is written: in double, in memory of the caller's.
struct workspace {
    std::size_t count, degree;
    double *knots;     // count + degree - 1
    motor *controls;   // at first the keys, normalised
    motor *keys;       // of cumulative motions, like what follows
    bivector *steps;   // the logarithm from each control to the next
    bivector *missing; // at each key, and then the corrections of the controls
    void *band;        // a row a key, a column a control

    workspace(void *memory, mw_motion_kind kind, std::size_t key_count, std::size_t of_degree)
        : count(key_count), degree(of_degree), knots(static_cast<double *>(memory)),
          controls(reinterpret_cast<motor *>(knots + count + degree - 1)), keys(controls + count),
          steps(reinterpret_cast<bivector *>(keys + count)), missing(steps + count),
          band(kind == MW_MOTION_CUMULATIVE ? static_cast<void *>(missing + count) : keys)
    {
    }

    static std::size_t size(mw_motion_kind kind, std::size_t count, std::size_t degree)
    {
        const std::size_t entries = banded<double>::entry_count(count, degree - 1);
        const std::size_t bytes = (count + degree - 1) * sizeof(double) + count * sizeof(motor);
        return kind == MW_MOTION_CUMULATIVE
                   ? bytes + count * (sizeof(motor) + 2 * sizeof(bivector)) + entries * sizeof(matrix3)
                   : bytes + entries * sizeof(double);
    }
};

// De Boor's knots: both ends `degree` times, and between them the means of `degree` neighbouring times. They are kept
// in order and between the times they are means of whatever rounding does: so control i is felt at time i, which
// makes the equations solvable (Schoenberg and Whitney).
template <class T> void choose_knots(const workspace &work, const T *times)
{
    const std::size_t d = work.degree, n = work.count;
    std::fill_n(work.knots, d, double(times[0]));
    for (std::size_t j = 1; j + d < n; ++j) {
        double mean = times[j];
        for (std::size_t k = 1; k < d; ++k)
            mean += (double(times[j + k]) - double(times[j])) / double(d);
        const double lowest = std::max(double(times[j]), work.knots[d + j - 2]);
        work.knots[d + j - 1] = std::clamp(double(static_cast<T>(mean)), lowest, double(times[j + d - 1]));
    }
    std::fill_n(work.knots + n - 1, d, double(times[n - 1]));
}

// The B-spline functions at a time, of `degree` + 1 controls from the one returned on; all others are zero. They are
// the blossom recursion run backwards from the result, where it acts on weights instead of motors.
std::size_t basis(const workspace &work, double time, double *weights)
{
    const double *knots = work.knots, *first = knots + work.degree - 1, *last = knots + work.count - 1;
    const double *after = time < *last ? std::upper_bound(first, last, time) : std::lower_bound(first, last, time);
    weights[0] = 1;
    for (std::size_t r = 1; r <= work.degree; ++r) {
        weights[r] = 0;
        for (std::size_t k = r; k-- > 0;) {
            const double left = *(after + k - r), right = after[k], weight = weights[k];
            weights[k] = weight * ((right - time) / (right - left));
            weights[k + 1] += weight * ((time - left) / (right - left));
        }
    }
    return std::size_t(after - knots) - work.degree;
}

// ------------------------------------------------------------------------------------------------------ additive

// The matrix is totally positive, so that it needs no pivots (de Boor and Pinkus, 1977). Outside the band it is zero.
template <class T> void find_additive(const workspace &work, const T *times)
{
    banded<double> equations(work.band, work.count, work.degree - 1);
    equations.clear();
    double weights[MW_MAX_DEGREE + 1];
    for (std::size_t i = 0; i < work.count; ++i) {
        const std::size_t first = basis(work, times[i], weights);
        for (std::size_t k = 0; k <= work.degree; ++k)
            if (equations.has(i, first + k))
                equations(i, first + k) = weights[k];
    }
    equations.solve(work.controls);
}

// ---------------------------------------------------------------------------------------------------- cumulative

// The motion at a time is E_d ... E_1 S_0 of the controls that are felt there, with the powers E_k = exp(c_k b_k) of
// D_k = exp(b_k) = S_k S_(k-1)^-1. If each control becomes exp(x_k) S_k, with small x_k, then D_k becomes exp(x_k -
// D_k x_(k-1) D_k^-1) D_k, its power exp(J_k (..)) E_k, and the motion exp(Σ a_k x_k) times what it was. The matrices
// are found from the left; `turned` is what the E so far do. They leave out how corrections that turn also shift, so
// a round brings rotations right, and translations as far as rotations were right before it.
struct linear_motion {
    std::size_t first;
    motor pose;
    matrix3 derivative[MW_MAX_DEGREE + 1]; // a_k
};

linear_motion linearize(const workspace &work, double time)
{
    linear_motion motion{};
    double weights[MW_MAX_DEGREE + 1], power = 0;
    motion.first = basis(work, time, weights);
    motion.pose = {1, 0, 0, 0, 0, 0, 0, 0};
    matrix3 turned = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (std::size_t k = work.degree; k > 0; --k) {
        const bivector &step = work.steps[motion.first + k];
        power += weights[k];
        const matrix3 of_step = turned * power_derivative(step, power);
        motion.derivative[k] = of_step - motion.derivative[k];
        motion.derivative[k - 1] = of_step * conjugation(step, 1);
        motion.pose = motion.pose * exp(step * power);
        turned = turned * conjugation(step, power);
    }
    motion.derivative[0] = turned - motion.derivative[0];
    motion.pose = motion.pose * work.controls[motion.first];
    return motion;
}

motor shortest(const motor &m) { return m.s < 0 ? m * -1.0 : m; }
double length(double a, double b, double c) { return square_root(a * a + b * b + c * c); }

// One round. Returns by how many epsilons the worst key was missed before it: by its rotation, or by its translation
// beside that of the key that is furthest away.
template <class T> double improve(const workspace &work, const T *times)
{
    banded<matrix3> equations(work.band, work.count, work.degree - 1);
    equations.clear();
    for (std::size_t k = 1; k < work.count; ++k)
        work.steps[k] = log(work.controls[k] * reverse(work.controls[k - 1]));
    double turn = 0, shift = 0, reach = 0;
    for (std::size_t i = 0; i < work.count; ++i) {
        const linear_motion motion = linearize(work, times[i]);
        for (std::size_t k = 0; k <= work.degree; ++k)
            if (equations.has(i, motion.first + k))
                equations(i, motion.first + k) = motion.derivative[k];
        const motor &key = work.keys[i];
        const bivector b = work.missing[i] = log(shortest(key * reverse(motion.pose)));
        turn = std::max(turn, length(b.b12, b.b13, b.b23));
        shift = std::max(shift, length(b.b1i, b.b2i, b.b3i));
        reach = std::max(reach, length_of(length(key.b1i, key.b2i, key.b3i), key.w, 0));
    }
    equations.solve(work.missing);
    for (std::size_t k = 0; k < work.count; ++k)
        work.controls[k] = normalized(exp(work.missing[k]) * work.controls[k]);
    return std::max(turn, shift > 0 ? shift / reach : 0.0) / double(std::numeric_limits<T>::epsilon());
}

template <class T> bool find_cumulative(const workspace &work, const T *times)
{
    std::copy_n(work.controls, work.count, work.keys);
    for (int round = 0; round < most_rounds; ++round)
        if (improve(work, times) <= almost) {
            improve(work, times);
            return true;
        }
    return false;
}

// ------------------------------------------------------------------------------------------------------- the API

template <class T> mw_status check_times(const T *times, std::size_t count, std::size_t *where)
{
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(times[i]) || !std::isfinite(times[i] - times[0]) ||
            (i > 0 && !(times[i] - times[i - 1] >= std::numeric_limits<T>::min()))) {
            *where = i;
            return MW_ERROR_KNOTS;
        }
    return MW_OK;
}

template <class Motor> mw_status check_keys(const Motor *keys, std::size_t count, std::size_t *where)
{
    for (std::size_t i = 0; i < count; ++i)
        if (is_degenerate(&keys[i].s)) {
            *where = i;
            return MW_ERROR_DEGENERATE_MOTOR;
        }
    return MW_OK;
}

// Normalised, and each with the sign that is nearer to the one before it.
template <class Motor> void read_keys(const workspace &work, const Motor *keys)
{
    motor before{};
    for (std::size_t i = 0; i < work.count; ++i) {
        const motor m = normalized(load_motor<double>(keys[i]));
        before = work.controls[i] = rotations_dot(m, before) < 0 ? m * -1.0 : m;
    }
}

template <class Motor> bool are_usable(const workspace &work)
{
    for (std::size_t k = 0; k < work.count; ++k) {
        const Motor control = store_motor<Motor>(work.controls[k]);
        if (is_degenerate(&control.s) || !std::isfinite(control.b1i + control.b2i + control.b3i + control.w))
            return false;
    }
    return true;
}

// Whether two ranges have bytes in common and are not the same array, read and then written.
bool clash(const byte_range &out, const byte_range &in) { return out.meets(in) && out.begin != in.begin; }

template <class T, class Motor, class Arrays>
mw_status check_arrays(const Arrays &arrays, std::size_t knot_count, const Motor *keys, const T *times, std::size_t n,
                       const byte_range &memory)
{
    if (arrays.control_capacity < n || arrays.knot_capacity < knot_count || memory.begin % alignof(double))
        return MW_ERROR_MEMORY;
    const byte_range controls = range_of(arrays.controls, n), knots = range_of(arrays.knots, knot_count),
                     from_keys = range_of(keys, n), from_times = range_of(times, n);
    const bool overlap = memory.meets(controls) || memory.meets(knots) || memory.meets(from_keys) ||
                         memory.meets(from_times) || controls.meets(knots) || controls.meets(from_times) ||
                         knots.meets(from_keys) || clash(controls, from_keys) || clash(knots, from_times);
    return overlap ? MW_ERROR_OVERLAP : MW_OK;
}

template <class T, class Arrays>
mw_status interpolate_keys(motion_of<T> *out, const Arrays &arrays, mw_motion_kind kind, unsigned degree,
                           const motor_of<T> *keys, const T *times, std::size_t count, void *memory,
                           std::size_t *size, std::size_t *where)
{
    std::size_t ignored;
    where = where ? where : &ignored;
    *where = 0;
    if (!size || (memory && (!out || !arrays.controls || !arrays.knots || !keys || !times)))
        return MW_ERROR_NULL;
    if (kind != MW_MOTION_ADDITIVE && kind != MW_MOTION_CUMULATIVE)
        return MW_ERROR_MOTION_KIND;
    if (degree < 1 || degree > MW_MAX_DEGREE)
        return MW_ERROR_DEGREE;
    if (count <= degree)
        return MW_ERROR_CONTROL_COUNT;
    if (count > PTRDIFF_MAX / (64 * 1024))
        return MW_ERROR_SIZE;
    const std::size_t needed = workspace::size(kind, count, degree), knot_count = count + degree - 1;
    if (!memory) {
        *size = needed;
        return MW_OK;
    }
    mw_status status = check_times(times, count, where);
    if (status == MW_OK)
        status = check_keys(keys, count, where);
    if (status == MW_OK && *size < needed)
        status = MW_ERROR_MEMORY;
    if (status == MW_OK)
        status = check_arrays(arrays, knot_count, keys, times, count,
                              range_of(static_cast<const char *>(memory), needed));
    if (status != MW_OK)
        return status;

    const workspace work(memory, kind, count, degree);
    read_keys(work, keys);
    choose_knots(work, times);
    if (kind == MW_MOTION_ADDITIVE)
        find_additive(work, times);
    else if (!find_cumulative(work, times))
        return MW_ERROR_CONVERGENCE;
    if (!are_usable<motor_of<T>>(work))
        return MW_ERROR_CONVERGENCE;
    for (std::size_t k = 0; k < count; ++k)
        arrays.controls[k] = store_motor<motor_of<T>>(work.controls[k]);
    for (std::size_t k = 0; k < knot_count; ++k)
        arrays.knots[k] = static_cast<T>(work.knots[k]);
    *out = {kind, degree, arrays.controls, count, arrays.knots, knot_count, nullptr, 0, nullptr, 1};
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../../generated/calls/motion_interpolate.inc"
