// What the judges of several families share.
#ifndef MOTORWAY_TESTS_FUZZ_JUDGE_H
#define MOTORWAY_TESTS_FUZZ_JUDGE_H

#include <string>

#include "api.h"
#include "draw.h"
#include "families.h"

namespace motorway::fuzz {

using testing::api;
using testing::Random;

// Bounds in epsilons where multiplications and additions are fused, and where they are not.
struct Bound {
    double fused, apart;
    Bound(double both) : fused(both), apart(both) {}
    Bound(double f, double a) : fused(f), apart(a) {}
    double of(bool fuses) const { return fuses ? fused : apart; }
};

template <class T>
std::string named(const char *name)
{
    return std::string(name) + (sizeof(T) == 4 ? "_f32" : "_f64");
}

template <class T>
const T *numbers(const void *input)
{
    return static_cast<const T *>(input);
}

template <class T>
Stream motors_of(Stream::Kind kind = Stream::apart)
{
    return {8, sizeof(T), kind};
}

// The two halves of a motor, each relative to a size of its own.
template <class T>
void near_motor(Verdict &verdict, const T *out, const Motor<Wide<T>> &right, Wide<T> rotation_scale,
                double rotation_bound, Wide<T> translation_scale, double translation_bound, Wide<T> lost = 4)
{
    Wide<T> components[8];
    components_of(right, components);
    verdict.near("rotation", out, components, 4, rotation_scale, rotation_bound, lost);
    verdict.near("translation", out + 4, components + 4, 4, translation_scale, translation_bound, lost);
}

template <class T>
void near_bivector(Verdict &verdict, const T *out, const Motor<Wide<T>> &right, Wide<T> rotation_scale,
                   double rotation_bound, Wide<T> moment_scale, double moment_bound, Wide<T> lost = 4)
{
    Wide<T> components[6];
    bivector_components_of(right, components);
    verdict.near("rotation", out, components, 3, rotation_scale, rotation_bound, lost);
    verdict.near("moment", out + 3, components + 3, 3, moment_scale, moment_bound, lost);
}

// How far α of a result is from 1.
template <class T>
void unit_motor(Verdict &verdict, const T *out, double bound = 4)
{
    using R = Wide<T>;
    const R off = abs(R(alpha(motor_of<R>(out)) - 1)) / epsilon<T>();
    verdict.at_most("alpha is 1", is_finite(off) ? static_cast<double>(off) : HUGE_VAL, bound);
}

template <class T>
bool judgeable(const void *input, std::size_t count)
{
    return Draw<T>::finite(numbers<T>(input), count);
}
template <class T>
bool legal_motor(const void *input)
{
    return judgeable<T>(input, 8) && Draw<T>::legal(numbers<T>(input));
}

// Of what motors of any length do.
template <class T>
Verdict of_any_length()
{
    return {static_cast<long double>(headroom<T>()), static_cast<long double>(footroom<T>())};
}

// How far a motor that need not be normalised moves the origin, twice the size of its halves: at least that, and what
// its pseudoscalar part adds to what cancels.
template <class R>
R reach(const Motor<R> &m)
{
    return 2 * length(m.d) / length(m.r);
}

// Legal, and not so far away that formulas overflow on the way.
template <class T>
bool usable_motor(const void *input)
{
    return legal_motor<T>(input) && reach(motor_of<Wide<T>>(numbers<T>(input))) * headroom<T>() <= largest<T>();
}

}  // namespace motorway::fuzz

#endif
