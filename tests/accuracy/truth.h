// What the functions of the group are, in closed form, for numbers R of any precision. check_truth holds them to the
// power series of the dense reference, which knows nothing of these formulas.
#ifndef MOTORWAY_TESTS_ACCURACY_TRUTH_H
#define MOTORWAY_TESTS_ACCURACY_TRUTH_H

#include <array>
#include <cmath>
#include <cstddef>

#include "reference.h"

namespace motorway::accuracy {

using reference::Branch;

template <class R>
using Motor = std::array<R, 8>;  // s b12 b13 b23 b1i b2i b3i w
template <class R>
using Bivector = std::array<R, 6>;  // b12 b13 b23 b1i b2i b3i

template <class R, std::size_t N, class T>
std::array<R, N> exactly(const T *components)
{
    std::array<R, N> numbers;
    for (std::size_t k = 0; k < N; ++k)
        numbers[k] = R(components[k]);
    return numbers;
}

template <class R, std::size_t N>
R length(const std::array<R, N> &numbers, std::size_t begin, std::size_t end)
{
    using std::sqrt;
    R sum = 0;
    for (std::size_t k = begin; k < end; ++k)
        sum += numbers[k] * numbers[k];
    return sqrt(sum);
}

template <class R, std::size_t N>
std::array<R, N> multiple(const R &factor, std::array<R, N> numbers)
{
    for (R &number : numbers)
        number *= factor;
    return numbers;
}

template <class R>
Motor<R> negated(const Motor<R> &motor)
{
    return multiple(R(-1), motor);
}

template <class R>
Motor<R> reverse(Motor<R> motor)
{
    for (std::size_t k = 1; k < 7; ++k)
        motor[k] = -motor[k];
    return motor;
}

// Σ first (-x)^k / (...), whose terms are in the ratio -x / (2k + 2)(2k + odd).
template <class R>
R alternating_series(const R &x, const R &first, int odd)
{
    R sum = 0, term = first;
    for (int k = 0; k < 24; ++k) {
        sum += term;
        term *= -x / R((2 * k + 2) * (2 * k + odd));
    }
    return sum;
}

// C(x̂) + S(x̂) B with x̂ = -B², C(x) = cos √x, S(x) = sin √x / √x, and (C - S) / x = 2 S'(x).
template <class R>
Motor<R> exp(const Bivector<R> &B)
{
    using std::cos, std::sin, std::sqrt;
    const R x = B[0] * B[0] + B[1] * B[1] + B[2] * B[2], h = B[0] * B[5] - B[1] * B[4] + B[2] * B[3];
    R C, S, slope;
    if (x < R(0.25)) {
        S = alternating_series(x, R(1), 3);
        slope = alternating_series(x, R(-1) / 3, 5);
        C = S + x * slope;
    } else {
        const R angle = sqrt(x);
        C = cos(angle);
        S = sin(angle) / angle;
        slope = (C - S) / x;
    }
    const R g = h * slope;
    return {C, S * B[0], S * B[1], S * B[2],
            S * B[3] + g * B[2], S * B[4] - g * B[1], S * B[5] + g * B[0], S * h};
}

// Divided by the root √α (1 + ½ β/α ω) of S̄S.
template <class R>
Motor<R> normalize(const Motor<R> &S)
{
    const R size = length(S, 0, 4);
    const R q = (S[0] * S[7] - S[1] * S[6] + S[2] * S[5] - S[3] * S[4]) / (size * size);
    return multiple(R(1 / size), Motor<R>{S[0], S[1], S[2], S[3], S[4] + S[3] * q, S[5] - S[2] * q, S[6] + S[1] * q,
                                          S[7] - S[0] * q});
}

// f(ŝ) times the bivector part of the motor normalised, ŝ = s + wω, f(s) = acos(s) / √(1 - s²). Where there is no
// axis, at -1, the shortest.
template <class R>
Bivector<R> log(const Motor<R> &motor, Branch branch)
{
    using std::atan2;
    Motor<R> S = normalize(motor);
    const R sine = length(S, 1, 4);
    if (S[0] < 0 && (branch == Branch::shortest || sine == 0))
        S = negated(S);
    R f, slope;
    if (sine < R(0.03) && S[0] > 0) {  // the series in z = 1 - s
        const R z = sine * sine / (1 + S[0]);
        R power = 1, coefficient = 1;
        f = 0, slope = 0;
        for (int k = 0; k < 20; ++k) {
            const R next = coefficient * R(k + 1) / R(2 * k + 3);
            f += coefficient * power;
            slope -= R(k + 1) * next * power;
            power *= z;
            coefficient = next;
        }
    } else {
        f = atan2(sine, S[0]) / sine;
        slope = (S[0] * f - 1) / (sine * sine);
    }
    const R g = slope * S[7];
    return {f * S[1], f * S[2], f * S[3], f * S[4] - g * S[3], f * S[5] + g * S[2], f * S[6] - g * S[1]};
}

template <class R>
Motor<R> compose(const Motor<R> &f, const Motor<R> &t)
{
    return {f[0] * t[0] - f[1] * t[1] - f[2] * t[2] - f[3] * t[3],
            f[0] * t[1] + f[1] * t[0] - f[2] * t[3] + f[3] * t[2],
            f[0] * t[2] + f[1] * t[3] + f[2] * t[0] - f[3] * t[1],
            f[0] * t[3] - f[1] * t[2] + f[2] * t[1] + f[3] * t[0],
            f[0] * t[4] + f[1] * t[5] + f[2] * t[6] + f[4] * t[0] - f[3] * t[7] - f[5] * t[1] - f[6] * t[2] -
                f[7] * t[3],
            f[0] * t[5] - f[1] * t[4] + f[2] * t[7] + f[4] * t[1] + f[3] * t[6] + f[5] * t[0] - f[6] * t[3] +
                f[7] * t[2],
            f[0] * t[6] - f[1] * t[7] - f[2] * t[4] + f[4] * t[2] - f[3] * t[5] + f[5] * t[3] + f[6] * t[0] -
                f[7] * t[1],
            f[0] * t[7] + f[1] * t[6] - f[2] * t[5] + f[4] * t[3] + f[3] * t[4] - f[5] * t[2] + f[6] * t[1] +
                f[7] * t[0]};
}

template <class R>
Motor<R> ratio(const Motor<R> &from, const Motor<R> &to)
{
    return compose(reverse(normalize(from)), normalize(to));
}

template <class R>
Motor<R> power(const Motor<R> &motor, const R &exponent)
{
    return exp(multiple(exponent, log(motor, Branch::shortest)));
}

// The cosine of the half angle between two normalised motors.
template <class R>
R dot(const Motor<R> &a, const Motor<R> &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// From `first` to `second` itself, not to its negative.
template <class R>
Motor<R> slerp(const Motor<R> &first, const Motor<R> &second, const R &t)
{
    return compose(normalize(first), exp(multiple(t, log(ratio(first, second), Branch::principal))));
}

template <class R>
Motor<R> nlerp(const Motor<R> &first, const Motor<R> &second, const R &t)
{
    Motor<R> sum;
    for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] = (1 - t) * first[k] + t * second[k];
    return normalize(sum);
}

}  // namespace motorway::accuracy

#endif
