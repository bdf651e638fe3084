// The same additive motion written with more controls. Every new control is the blossom of the motion at the knots
// that it belongs to, found by means of two controls with positive weights, as Boehm's algorithm inserts knots; one
// whose knots are all old is copied to the bit.
#include "../view.h"
#include "description.h"
#include "scalar_motor.h"

#include <algorithm>

namespace motorway {
namespace {

using motor = scalar_motor<double>;

// What is edited: its knots, and its controls with the weights multiplied in.
template <class T> struct source {
    motion_of<T> motion;
    timeline<T> times;

    explicit source(const motion_of<T> &of) : motion(of), times(of) {}

    T knot(std::size_t i) const { return times.knot(i); }
    std::size_t knot_count() const { return times.knot_count(); }
    motor control(std::size_t k) const
    {
        const motor m = load_motor<double>(motion.controls[k]);
        return motion.weights ? m * double(motion.weights[k]) : m;
    }

    // The first knot that is not below x.
    std::size_t lower_bound(T x) const
    {
        std::size_t first = 0, past = knot_count();
        while (first < past) {
            const std::size_t middle = first + (past - first) / 2;
            if (knot(middle) < x)
                first = middle + 1;
            else
                past = middle;
        }
        return first;
    }

    std::size_t count_of(T x) const
    {
        std::size_t i = lower_bound(x), count = 0;
        for (; i < knot_count() && knot(i) == x; ++i)
            ++count;
        return count;
    }
};

// The blossom at `degree` knots u that are neighbours in a new motion, whose knots are those of the old one and more.
// Those of them that are old are kept, and the others, x_1 ... x_r, take the place of old ones that lie around all u:
//     ... L_2 L_1 | u_1 ... u_d | R_1 R_2 ...    P_m = the control of L_(r-m) ... L_1, the knots kept and R_1 ... R_m
// An x is between any L and any R, so each step takes the mean of two neighbours with positive weights. Where the
// motion jumps, and all u are the knot where it does, `copies_before` says which of the two controls there is meant.
template <class T> motor blossom(const source<T> &from, const T *u, std::size_t copies_before)
{
    const std::size_t d = from.motion.degree, first = from.lower_bound(u[0]), old_count = from.count_of(u[0]);
    const auto same = static_cast<std::size_t>(std::upper_bound(u, u + d, u[0]) - u);
    std::size_t left = first + (old_count > same ? old_count - same : 0); // of the kept knots the first
    if (same == d)
        left = std::min(left, first + copies_before);

    T x[MW_MAX_DEGREE];
    std::size_t kept = 0, r = 0;
    for (std::size_t i = 0; i < d; ++i)
        if (left + kept < from.knot_count() && from.knot(left + kept) == u[i])
            ++kept;
        else
            x[r++] = u[i];

    motor point[MW_MAX_DEGREE + 1];
    for (std::size_t m = 0; m <= r; ++m)
        point[m] = from.control(left - r + m);
    for (std::size_t level = 0; level < r; ++level)
        for (std::size_t m = 0; m < r - level; ++m) {
            const double begin = from.knot(left - r + level + m), end = from.knot(left + kept + m), at = x[level];
            point[m] = point[m] * ((end - at) / (end - begin)) + point[m + 1] * ((at - begin) / (end - begin));
        }
    return point[0];
}

// How many knots equal to x come before number i of the new motion.
template <class Knots, class T> std::size_t copies_before(const Knots &knots, std::size_t i, T x)
{
    std::size_t count = 0;
    while (i > count && knots(i - count - 1) == x)
        ++count;
    return count;
}

// ------------------------------------------------------------------------------------------------- inserting knots

// The knots of a motion with one more knot, several times.
template <class T> class knots_with_one_more {
    const source<T> &from;
    T more;
    std::size_t times;

public:
    const std::size_t place;

    knots_with_one_more(const source<T> &old, T knot, std::size_t how_often)
        : from(old), more(knot), times(how_often), place(old.lower_bound(knot))
    {
    }
    T operator()(std::size_t i) const
    {
        return i < place ? from.knot(i) : i < place + times ? more : from.knot(i - times);
    }
    std::size_t count() const { return from.knot_count() + times; }

    // What the library divides by must be a normal number.
    bool are_far_enough_apart() const
    {
        const T before = more - from.knot(place - 1), after = from.knot(place) - more;
        return times == 0 || (before >= std::numeric_limits<T>::min() &&
                              (after == 0 || after >= std::numeric_limits<T>::min()));
    }
};

// Writes as many knots and controls as `out` has, from number `begin` on.
template <class T>
void write_part(const motion_of<T> &out, T *knots, motor_of<T> *controls, const source<T> &from,
                const knots_with_one_more<T> &all, std::size_t begin)
{
    for (std::size_t i = 0; i < out.knot_count; ++i)
        knots[i] = all(begin + i);
    for (std::size_t k = 0; k < out.control_count; ++k)
        controls[k] = store_motor<motor_of<T>>(blossom(from, knots + k, copies_before(all, begin + k, knots[k])));
}

// --------------------------------------------------------------------------------------------- elevating the degree

// Each knot once more, so that the motion stays as smooth as it is. Before and after the domain that makes more knots
// than the higher degree asks for: the outermost are left out.
template <class T> struct elevated_knots {
    std::size_t left_out = 0, count; // left out at the start

    explicit elevated_knots(const source<T> &from) : count(from.knot_count())
    {
        for (std::size_t i = 0; i < from.knot_count(); ++i)
            if (i == 0 || from.knot(i) != from.knot(i - 1)) {
                left_out += from.knot(i) < from.times.begin();
                count += from.knot(i) >= from.times.begin() && from.knot(i) <= from.times.end();
            }
    }

    void write(const source<T> &from, T *knots) const
    {
        std::size_t number = 0;
        const auto put = [&](T knot) {
            if (number >= left_out && number - left_out < count)
                knots[number - left_out] = knot;
            ++number;
        };
        for (std::size_t i = 0; i < from.knot_count(); ++i) {
            put(from.knot(i));
            if (i + 1 == from.knot_count() || from.knot(i) != from.knot(i + 1))
                put(from.knot(i));
        }
    }
};

// The mean of the blossoms at d of the d + 1 knots that control k belongs to (Ramshaw): equal ones are found once.
template <class T> motor elevated_control(const source<T> &from, const T *knots, std::size_t k)
{
    const std::size_t d = from.motion.degree;
    motor sum{};
    for (std::size_t i = 0, next; i <= d; i = next) {
        for (next = i + 1; next <= d && knots[k + next] == knots[k + i];)
            ++next;
        T u[MW_MAX_DEGREE + 1];
        std::copy_n(knots + k, d + 1, u);
        std::copy(u + i + 1, u + d + 1, u + i);
        const auto knot = [&](std::size_t j) { return knots[j]; };
        sum = sum + blossom(from, u, copies_before(knot, k, u[0])) * (double(next - i) / double(d + 1));
    }
    return sum;
}

// ------------------------------------------------------------------------------------------------------- the API

template <class T> motion_of<T> description(unsigned degree, std::size_t knot_count)
{
    const std::size_t control_count = knot_count - degree + 1;
    return {MW_MOTION_ADDITIVE, degree, nullptr, control_count, nullptr, knot_count, nullptr, 0, nullptr, 1};
}

template <class T> mw_status check_source(const motion_of<T> *motion)
{
    std::size_t where;
    if (!motion)
        return MW_ERROR_NULL;
    const mw_status status = check_description<T>(*motion, &where);
    if (status != MW_OK)
        return status;
    const bool is_one = number_of_motions(motion->motion_count) == 1;
    return motion->kind == MW_MOTION_ADDITIVE && !motion->closed && is_one ? MW_OK : MW_ERROR_MOTION_KIND;
}

template <class T, class Arrays> bool have_room(const Arrays &arrays, const motion_of<T> &asked)
{
    return arrays.control_capacity >= asked.control_count && arrays.knot_capacity >= asked.knot_count;
}

// Of arrays that have room.
template <class T, class Arrays>
mw_status check_arrays(const Arrays &arrays, const motion_of<T> &asked, const motion_of<T> &motion)
{
    if (!arrays.controls || !arrays.knots)
        return MW_ERROR_NULL;
    const byte_range controls = range_of(arrays.controls, asked.control_count),
                     knots = range_of(arrays.knots, asked.knot_count);
    const auto meet = [&](const byte_range &range) { return controls.meets(range) || knots.meets(range); };
    const bool overlap = controls.meets(knots) || meet(range_of(motion.controls, motion.control_count)) ||
                         (motion.knots && meet(range_of(motion.knots, motion.knot_count))) ||
                         (motion.weights && meet(range_of(motion.weights, motion.control_count)));
    return overlap ? MW_ERROR_OVERLAP : MW_OK;
}

template <class T, class Arrays> motion_of<T> with_arrays(motion_of<T> motion, const Arrays &arrays)
{
    motion.controls = arrays.controls;
    motion.knots = arrays.knots;
    return motion;
}

template <class T> bool is_inside(const source<T> &from, T knot)
{
    return knot > from.times.begin() && knot < from.times.end();
}

template <class T, class Arrays>
mw_status insert_knot(motion_of<T> *out, const Arrays &arrays, const motion_of<T> *motion, T knot, unsigned times)
{
    mw_status status = out ? check_source<T>(motion) : MW_ERROR_NULL;
    if (status != MW_OK)
        return status;
    const source<T> from(*motion);
    if (!is_inside(from, knot))
        return MW_ERROR_PARAMETER;
    const knots_with_one_more<T> knots(from, knot, times);
    if (times > motion->degree + 1 - from.count_of(knot) || !knots.are_far_enough_apart())
        return MW_ERROR_KNOTS;
    const motion_of<T> asked = description<T>(motion->degree, knots.count());
    if (!have_room<T>(arrays, asked)) {
        *out = asked;
        return MW_ERROR_MEMORY;
    }
    status = check_arrays<T>(arrays, asked, *motion);
    if (status != MW_OK)
        return status;
    write_part(asked, arrays.knots, arrays.controls, from, knots, 0);
    *out = with_arrays<T>(asked, arrays);
    return MW_OK;
}

template <class T, class Arrays>
mw_status elevate_degree(motion_of<T> *out, const Arrays &arrays, const motion_of<T> *motion)
{
    mw_status status = out ? check_source<T>(motion) : MW_ERROR_NULL;
    if (status != MW_OK)
        return status;
    if (motion->degree == MW_MAX_DEGREE)
        return MW_ERROR_DEGREE;
    const source<T> from(*motion);
    const elevated_knots<T> knots(from);
    const motion_of<T> asked = description<T>(motion->degree + 1, knots.count);
    if (!have_room<T>(arrays, asked)) {
        *out = asked;
        return MW_ERROR_MEMORY;
    }
    status = check_arrays<T>(arrays, asked, *motion);
    if (status != MW_OK)
        return status;
    knots.write(from, arrays.knots);
    for (std::size_t k = 0; k < asked.control_count; ++k)
        arrays.controls[k] = store_motor<motor_of<T>>(elevated_control(from, arrays.knots, k));
    *out = with_arrays<T>(asked, arrays);
    return MW_OK;
}

// A knot that is there `degree` times begins a motion and ends one: what comes before it is cut off, and what comes
// after.
template <class T, class Arrays>
mw_status split_motion(motion_of<T> *before, const Arrays &before_arrays, motion_of<T> *after,
                       const Arrays &after_arrays, const motion_of<T> *motion, T at)
{
    mw_status status = before && after ? check_source<T>(motion) : MW_ERROR_NULL;
    if (status != MW_OK)
        return status;
    const source<T> from(*motion);
    if (!is_inside(from, at))
        return MW_ERROR_PARAMETER;
    const std::size_t d = motion->degree, old = from.count_of(at), copies = std::max(old, d);
    const knots_with_one_more<T> knots(from, at, copies - old);
    if (!knots.are_far_enough_apart())
        return MW_ERROR_KNOTS;
    const std::size_t before_end = knots.place + d, after_begin = knots.place + copies - d;
    const motion_of<T> first = description<T>(motion->degree, before_end),
                       second = description<T>(motion->degree, knots.count() - after_begin);
    if (!have_room<T>(before_arrays, first) || !have_room<T>(after_arrays, second)) {
        *before = first;
        *after = second;
        return MW_ERROR_MEMORY;
    }
    status = check_arrays<T>(before_arrays, first, *motion);
    if (status == MW_OK)
        status = check_arrays<T>(after_arrays, second, *motion);
    if (status == MW_OK) // and the halves must not meet each other
        status = check_arrays<T>(after_arrays, second, with_arrays<T>(first, before_arrays));
    if (status != MW_OK)
        return status;
    write_part(first, before_arrays.knots, before_arrays.controls, from, knots, 0);
    write_part(second, after_arrays.knots, after_arrays.controls, from, knots, after_begin);
    *before = with_arrays<T>(first, before_arrays);
    *after = with_arrays<T>(second, after_arrays);
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../../generated/calls/motion_edit.inc"
