// What the generated kernels are made of beside arithmetic: the approximations, and the reduction of angles.
//
// Kernels take off half turns in a few operations, which is exact up to `quick_angle`. A register that holds a larger
// angle, up to the last finite one, takes the branch of `unwind` or `unwind_angle` first: there the lanes of such angles
// are reduced one by one (../exact_angle.h), and all others stay as they are, to the bit.
#pragma once

#include "../exact_angle.h"
#include "simd.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

#include "../../generated/kernels/approximations.inl"

// What generates a motor.
template <class V> struct bivector {
    V b12, b13, b23, b1i, b2i, b3i;
};

// The part of a motor that rotates.
template <class V> struct rotor {
    V s, b12, b13, b23;
};

// Up to here half_turns pi is exact, by halves of pi where nothing fuses, and the error of pi times as much does not show.
template <class V> constexpr scalar_of<V> quick_angle = is_single<V> ? 0x1p13 : 0x1p27;

// angle - half_turns pi, exactly.
template <class V> inline V less_half_turns(const V &angle, const V &half_turns)
{
    if constexpr (fuses)
        return fnma(pi<V>(), half_turns, angle);
    else
        return (angle - half_turns * pi_high<V>()) - half_turns * pi_low<V>();
}

// 1 / (angle + rest) from the rounded 1 / angle, by one step of Newton's; without fused operations that gains nothing.
template <class V> inline V refine(const V &inverse, const V &angle, const V &rest)
{
    if constexpr (fuses)
        return fma(inverse, fnma(rest, inverse, fnma(angle, inverse, V(scalar_of<V>(1)))), inverse);
    else
        return inverse;
}

// A rotor whose length is 1 but for a few epsilons, without most of these.
template <class V> inline rotor<V> trim(const V &s, const V &b12, const V &b13, const V &b23)
{
    const V half(scalar_of<V>(0.5)), square = fma(b23, b23, fma(b13, b13, fma(b12, b12, s * s)));
    const V lack = fnma(half, square, half);
    return {fma(s, lack, s), fma(b12, lack, b12), fma(b13, lack, b13), fma(b23, lack, b23)};
}

// The same where it is needed because nothing fuses.
template <class V> inline rotor<V> trim_unless_fused(const V &s, const V &b12, const V &b13, const V &b23)
{
    if constexpr (fuses)
        return {s, b12, b13, b23};
    else
        return trim(s, b12, b13, b23);
}

// The value, and with an odd number its negative.
template <class V> inline V flip_if_odd(const V &value, const V &number)
{
    // In this sum the last bit of the mantissa is that of the integer.
    const V last_bit = number + V(is_single<V> ? scalar_of<V>(0x1.8p23) : scalar_of<V>(0x1.8p52));
    return with_flipped_sign(value, last_bit);
}

// Whether a number is finite.
template <class T> inline bool is_finite(T a) { return a - a == 0; }

// ------------------------------------------------------------------------------------------------------ registers

// What |b| may be. Where nothing fuses |b| is known to a few bits less, which shows in larger angles.
template <class V> constexpr scalar_of<V> quick_length = fuses ? quick_angle<V> : 4;
template <class V> constexpr scalar_of<V> quick_square = quick_length<V> * quick_length<V>;

template <class V> __attribute__((noinline, cold)) void unwind_lanes(bivector<V> &b, const V &square)
{
    using T = scalar_of<V>;
    constexpr int lanes = sizeof(V) / sizeof(T);
    T component[6][lanes], squares[lanes];
    __builtin_memcpy(component, &b, sizeof b);
    __builtin_memcpy(squares, &square, sizeof square);
    for (int lane = 0; lane < lanes; ++lane) {
        const auto here = [&](int k) -> T & { return component[k][lane]; };
        if (!(squares[lane] > quick_square<V>) || !is_finite(here(0)) || !is_finite(here(1)) || !is_finite(here(2)))
            continue;
        double one[6];
        for (int k = 0; k < 6; ++k)
            one[k] = here(k);
        take_turns_off(one);
        for (int k = 0; k < 6; ++k)
            here(k) = static_cast<T>(one[k]);
    }
    __builtin_memcpy(static_cast<void *>(&b), component, sizeof b);
}

// A bivector of the same exponential in every lane, with an angle that is quickly reduced.
template <class V>
inline bivector<V> unwind(const V &b12, const V &b13, const V &b23, const V &b1i, const V &b2i, const V &b3i)
{
    bivector<V> b{b12, b13, b23, b1i, b2i, b3i};
    const V square = fma(b23, b23, fma(b13, b13, b12 * b12));
    if (__builtin_expect(!all_between(square, scalar_of<V>(0), quick_square<V>), false))
        unwind_lanes(b, square);
    return b;
}

template <class V> __attribute__((noinline, cold)) V unwind_angles(const V &angle)
{
    using T = scalar_of<V>;
    constexpr int lanes = sizeof(V) / sizeof(T);
    T lane[lanes];
    __builtin_memcpy(lane, &angle, sizeof angle);
    for (T &one : lane)
        if (magnitude(one) > quick_angle<V> && is_finite(one))
            one = static_cast<T>(without_turns(one));
    V result;
    __builtin_memcpy(static_cast<void *>(&result), lane, sizeof result);
    return result;
}

// An angle of the same cosine and sine in every lane, which is quickly reduced.
template <class V> inline V unwind_angle(const V &angle)
{
    if (__builtin_expect(!all_between(angle, -quick_angle<V>, quick_angle<V>), false))
        return unwind_angles(angle);
    return angle;
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
