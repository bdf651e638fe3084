// What the generated kernels are made of beside arithmetic: the approximations, and the reduction of angles.
//
// Kernels take off half turns in a few operations, which is exact up to `quick_angle`. A register that holds a larger
// angle, up to the last finite one, takes the branch of `unwind` or `unwind_angle` first: one lane after the other, with
// as many bits of 1/(2π) as it takes (Payne and Hanek, 1983). Lanes with smaller angles stay as they are, to the bit.
#pragma once

#include "simd.h"

#include <cstdint>

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

#include "../../generated/kernels/approximations.inl"

// The generator of a motor.
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

// --------------------------------------------------------------------------------------------- exact reduction

// a b = product + rest, exactly, without fused operations (Dekker).
struct exact_product {
    double product, rest;

    exact_product(double a, double b) : product(a * b)
    {
        const double a_high = upper_half(a), a_low = a - a_high, b_high = upper_half(b), b_low = b - b_high;
        rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    }
    static double upper_half(double a)
    {
        const double shifted = a * 0x8000001p0;
        return shifted - (shifted - a);
    }
};

// 2^exponent, a normal number.
inline double power_of_two(int exponent)
{
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    return read<double>(&bits);
}

// value 2^exponent, where the power alone need not be a normal number.
inline double scale(double value, int exponent)
{
    return value * power_of_two(exponent / 2) * power_of_two(exponent - exponent / 2);
}

// The exponent of a normal number: 0 of [1, 2).
inline int exponent_of(double value) { return static_cast<int>(read<std::uint64_t>(&value) >> 52 & 0x7ff) - 1023; }

// A part of a turn in [0, 1): the bits behind the point, the highest first.
class turn_part {
    static constexpr int words = 8, mantissa_words = 3;
    std::uint32_t word[words] = {};

    // Bits of 1/(2π): those behind the point, and zeros around them.
    static std::uint64_t inverse_word(int k)
    {
        return k < 0 || k >= static_cast<int>(sizeof inverse_two_pi_words / sizeof(unsigned)) ? 0
                                                                                              : inverse_two_pi_words[k];
    }

public:
    // Of the angle value 2^exponent >= 0. Words of 1/(2π) that make whole turns are left out, and so are whole turns.
    turn_part(double value, int exponent)
    {
        if (value < 0x1p-1022) // a subnormal number is no part of a turn that shows beside others
            return;
        const std::uint64_t mantissa = (read<std::uint64_t>(&value) & 0xfffffffffffff) | 0x10000000000000;
        const int last_bit = exponent_of(value) - 52 + exponent;
        const int first = last_bit >= 0 ? last_bit / 32 : -((31 - last_bit) / 32), shift = last_bit - 32 * first;
        const std::uint64_t low = mantissa << shift, high = shift > 11 ? mantissa >> (64 - shift) : 0;
        const std::uint64_t factor[mantissa_words] = {low & 0xffffffff, low >> 32, high};
        for (int a = 0; a < mantissa_words; ++a) {
            std::uint64_t carry = 0;
            for (int k = words - 1; k >= 0; --k) {
                carry += factor[a] * inverse_word(first + k + a) + word[k];
                word[k] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
        }
    }

    // Add another, or take it off, without whole turns.
    void add(const turn_part &other, bool take_off)
    {
        std::uint64_t carry = take_off ? 1 : 0;
        for (int k = words - 1; k >= 0; --k) {
            carry += std::uint64_t(word[k]) + (take_off ? ~other.word[k] : other.word[k]);
            word[k] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
    }

    // The angle in [-π, π], rounded once.
    double angle() const
    {
        const bool backwards = word[0] >> 31;
        turn_part part = *this;
        if (backwards) {
            part = turn_part();
            part.add(*this, true);
        }
        int first = 0;
        while (first < words && part.word[first] == 0)
            ++first;
        if (first == words)
            return 0;
        const auto next = [&](int k) { return std::uint64_t(first + k < words ? part.word[first + k] : 0); };
        const int zeros = __builtin_clz(part.word[first]);
        const std::uint64_t two = next(0) << 32 | next(1), leading = two << zeros | (next(2) << zeros) >> 32;
        // The leading 53 bits, and 11 more.
        const double head = static_cast<double>(leading >> 11), tail = static_cast<double>(leading & 0x7ff) * 0x1p-11;
        const exact_product main(head, two_pi<double>());
        const double rest = main.rest + (head * two_pi_rest<double>() + tail * two_pi<double>());
        const double result = (main.product + rest) * power_of_two(-53 - zeros - 32 * first);
        return backwards ? -result : result;
    }

private:
    turn_part() = default;
};

// ------------------------------------------------------------------------------------------------- single lanes

// The motor exp(B) is that of another B, whose angle is at most π: rotating by that, and moving by as much along the
// axis.
template <class T> inline void unwind_lane(bivector<T> &b)
{
    const double rotation[] = {b.b12, b.b13, b.b23};
    double largest = 0;
    for (double c : rotation)
        largest = largest < magnitude(c) ? magnitude(c) : largest;
    const int exponent = exponent_of(largest);
    // |b|² of what is scaled to 1 ≤ |b| < 4, and its root, to twice the precision.
    double c[3], square = 0, lost = 0;
    for (int k = 0; k < 3; ++k) {
        c[k] = scale(rotation[k], -exponent);
        const exact_product next(c[k], c[k]);
        const double sum = square + next.product, part = sum - square;
        lost += ((square - (sum - part)) + (next.product - part)) + next.rest;
        square = sum;
    }
    const double length = sqrt(square);
    const exact_product again(length, length);
    const double rest = ((square - again.product) - again.rest + lost) / (2 * length);

    turn_part part(length, exponent);
    part.add(turn_part(magnitude(rest), exponent), rest < 0);
    const double angle = part.angle(), shrink = scale(angle / length, -exponent);
    const double a12 = c[0] / length, a13 = c[1] / length, a23 = c[2] / length;
    const double along = a12 * b.b3i - a13 * b.b2i + a23 * b.b1i;
    const double along1 = along * a23, along2 = -along * a13, along3 = along * a12;
    b = {static_cast<T>(angle * a12),
         static_cast<T>(angle * a13),
         static_cast<T>(angle * a23),
         static_cast<T>(along1 + shrink * (b.b1i - along1)),
         static_cast<T>(along2 + shrink * (b.b2i - along2)),
         static_cast<T>(along3 + shrink * (b.b3i - along3))};
}

template <class T> inline T unwind_lane(T angle)
{
    const double given = angle;
    return static_cast<T>(with_sign(1.0, given) * turn_part(magnitude(given), 0).angle());
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
        bivector<T> one{here(0), here(1), here(2), here(3), here(4), here(5)};
        unwind_lane(one);
        here(0) = one.b12, here(1) = one.b13, here(2) = one.b23;
        here(3) = one.b1i, here(4) = one.b2i, here(5) = one.b3i;
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
            one = unwind_lane(one);
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
