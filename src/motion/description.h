// The description of a motion, in either precision: what can be wrong with it, and the knots and controls that it means.
#pragma once

#include "../motorway.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace motorway {

// The C types of a precision.
template <class T> struct c_types;
template <> struct c_types<float> {
    using motor = mw_motor_f32;
    using motion = mw_motion_f32;
    using compiled = mw_compiled_motion_f32;
};
template <> struct c_types<double> {
    using motor = mw_motor_f64;
    using motion = mw_motion_f64;
    using compiled = mw_compiled_motion_f64;
};
template <class T> using motor_of = typename c_types<T>::motor;
template <class T> using motion_of = typename c_types<T>::motion;

template <class T> T alpha_of(const T *motor)
{
    return motor[0] * motor[0] + motor[1] * motor[1] + motor[2] * motor[2] + motor[3] * motor[3];
}

// Whether α is outside the normal range, so that the motor has no inverse.
template <class T> bool is_degenerate(const T *motor)
{
    const T alpha = alpha_of(motor);
    return !(alpha >= std::numeric_limits<T>::min() && alpha <= std::numeric_limits<T>::max());
}

inline std::size_t number_of_motions(std::size_t motion_count) { return motion_count ? motion_count : 1; }

inline bool has_generators(mw_motion_kind kind)
{
    return kind == MW_MOTION_GENERATOR || kind == MW_MOTION_GENERATOR_KEYS;
}

// The open B-spline that a description means. Knots that were left out are made up; what is closed is unrolled, so
// that the first controls come again at the end; and keys are written as Bézier curves of degree three from each to
// the next. Control k of it belongs to the knots k ... k + degree - 1, and span j lies between the knots j and j + 1,
// from degree - 1 on.
template <class T> class timeline {
    const T *given;
    std::size_t given_controls;
    bool keys, closed;

    // The knots of the description, continued beyond both ends of a closed one by its period.
    T given_knot(std::ptrdiff_t i) const
    {
        if (!closed)
            return given ? given[i] : default_knot(i);
        const auto period = static_cast<std::ptrdiff_t>(given_controls);
        const std::ptrdiff_t round = i < 0 ? -1 : i / period, within = i - round * period;
        if (!given)
            return static_cast<T>(i);
        return given[within] + static_cast<T>(round) * (given[period] - given[0]);
    }
    T default_knot(std::ptrdiff_t i) const
    {
        if (keys)
            return static_cast<T>(i);
        const auto inside = i - static_cast<std::ptrdiff_t>(degree) + 1,
                   last = static_cast<std::ptrdiff_t>(given_controls - degree);
        return static_cast<T>(inside < 0 ? 0 : inside > last ? last : inside);
    }

public:
    std::size_t degree, control_count;

    explicit timeline(const motion_of<T> &motion)
        : given(motion.knots), given_controls(motion.control_count), keys(motion.kind == MW_MOTION_GENERATOR_KEYS),
          closed(motion.closed != 0), degree(keys ? 3 : motion.degree),
          control_count(keys     ? 3 * (given_controls - (closed ? 0 : 1)) + 1
                        : closed ? given_controls + degree
                                 : given_controls)
    {
    }

    std::size_t knot_count() const { return control_count + degree - 1; }
    T knot(std::size_t i) const
    {
        if (keys)
            return given_knot(static_cast<std::ptrdiff_t>(i / 3));
        return given_knot(static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(closed ? degree - 1 : 0));
    }
    T begin() const { return knot(degree - 1); }
    T end() const { return knot(control_count - 1); }
    bool is_empty(std::size_t span) const { return !(knot(span) < knot(span + 1)); }

    // Which control of the description control k is; of keys, which key is number k.
    std::size_t source(std::size_t k) const
    {
        return !closed ? k : keys ? k % given_controls : (k + degree * (given_controls - 1) + 1) % given_controls;
    }

    // Which knot of the description knot i is.
    std::size_t knot_source(std::size_t i) const
    {
        if (keys)
            return i / 3;
        return closed ? (i + (degree - 1) * given_controls - (degree - 1)) % given_controls : i;
    }

    // How many knots the description must have, if it has any.
    std::size_t expected_knots() const
    {
        return closed ? given_controls + 1 : keys ? given_controls : given_controls + degree - 1;
    }
};

// Knots must not decrease, d + 2 equal ones would leave a control without any influence, and what is divided by must be
// a normal number. Of keys no two times are equal.
template <class T> mw_status check_knots(const timeline<T> &times, std::size_t *where)
{
    const std::size_t most = times.degree + 1, count = times.knot_count();
    const auto is_bad = [&](std::size_t i) {
        const T knot = times.knot(i);
        if (!std::isfinite(knot) || !std::isfinite(knot - times.knot(0)))
            return true;
        const T step = i > 0 ? knot - times.knot(i - 1) : T(0);
        return step < 0 || (step > 0 && step < std::numeric_limits<T>::min()) ||
               (i >= most && knot == times.knot(i - most));
    };
    for (std::size_t i = 0; i < count; ++i)
        if (is_bad(i)) {
            *where = times.knot_source(i);
            return MW_ERROR_KNOTS;
        }
    if (!(times.begin() < times.end())) {
        *where = times.knot_source(times.control_count - 1);
        return MW_ERROR_KNOTS;
    }
    return MW_OK;
}

template <class T> mw_status check_times_of_keys(const motion_of<T> &motion, std::size_t *where)
{
    for (std::size_t i = 0; i < motion.knot_count; ++i)
        if (!std::isfinite(motion.knots[i]) || (i > 0 && !(motion.knots[i] > motion.knots[i - 1]))) {
            *where = i;
            return MW_ERROR_KNOTS;
        }
    return MW_OK;
}

// Everything but the controls themselves. *where is set if something is wrong.
template <class T> mw_status check_description(const motion_of<T> &motion, std::size_t *where)
{
    *where = 0;
    if (!motion.controls || (!motion.knots && motion.knot_count))
        return MW_ERROR_NULL;
    if (motion.kind < MW_MOTION_ADDITIVE || motion.kind > MW_MOTION_GENERATOR_KEYS)
        return MW_ERROR_MOTION_KIND;
    const bool keys = motion.kind == MW_MOTION_GENERATOR_KEYS;
    if (!keys && (motion.degree < 1 || motion.degree > MW_MAX_DEGREE))
        return MW_ERROR_DEGREE;
    if (motion.control_count < (keys ? 2 : motion.degree + std::size_t(1)))
        return MW_ERROR_CONTROL_COUNT;
    if (motion.control_count > PTRDIFF_MAX / 1024 || motion.motion_count > PTRDIFF_MAX / 1024)
        return MW_ERROR_SIZE;
    const timeline<T> times(motion);
    if (motion.knots && motion.knot_count != times.expected_knots())
        return MW_ERROR_KNOT_COUNT;
    if (keys && motion.knots) {
        const mw_status status = check_times_of_keys<T>(motion, where);
        if (status != MW_OK)
            return status;
    }
    const mw_status status = check_knots(times, where);
    if (status != MW_OK || !motion.weights)
        return status;
    if (motion.kind != MW_MOTION_ADDITIVE)
        return MW_ERROR_WEIGHTS;
    for (std::size_t k = 0; k < motion.control_count; ++k)
        if (!(motion.weights[k] > 0 && std::isfinite(motion.weights[k]))) {
            *where = k;
            return MW_ERROR_WEIGHTS;
        }
    return MW_OK;
}

// Null are arrays of no size.
template <class Arrays> Arrays arrays_of(const Arrays *arrays) { return arrays ? *arrays : Arrays{}; }

} // namespace motorway
