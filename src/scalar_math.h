// Functions of one number, in double, instead of libm's: a program in C needs no -lm, and the bits are the same
// whatever the system's libm is.
#pragma once

#include "strict_math.h"

#include <cstdint>
#include <type_traits>

namespace motorway {

// In a debug build too, these are instructions and no calls.
inline float square_root(float x) { return __builtin_sqrtf(x); }
inline double square_root(double x) { return __builtin_sqrt(x); }

struct sine_cosine {
    double sine, cosine;
};

// Of any angle, within 0.8 ulp. NaN if it is not finite.
sine_cosine sine_and_cosine(double angle);

// The angle of (x, y) with y >= 0, from 0 to π, within 1.75 ulp. 0 for (0, 0).
double angle_of(double x, double y);

// √(x² + y² + z²) without over- or underflow on the way, within 1.5 ulp.
double length_of(double x, double y, double z);

// The n for which 2^(n - 1) <= |x| < 2^n; x must be finite and not 0.
int exponent_of(double x);

// x 2^n, for |n| up to 1100.
double times_power_of_two(double x, int n);

template <class T> using bits_of = std::conditional_t<sizeof(T) == sizeof(float), std::uint32_t, std::uint64_t>;

// The next number from x > 0 upwards, and from a finite x downwards.
template <class T> T next_above(T x)
{
    bits_of<T> bits;
    __builtin_memcpy(&bits, &x, sizeof x);
    ++bits;
    __builtin_memcpy(&x, &bits, sizeof x);
    return x;
}
template <class T> T next_below(T x)
{
    if (x == 0)
        return -next_above(T(0));
    bits_of<T> bits;
    __builtin_memcpy(&bits, &x, sizeof x);
    bits = x > 0 ? bits - 1 : bits + 1;
    __builtin_memcpy(&x, &bits, sizeof x);
    return x;
}

} // namespace motorway
