// One motor at a time, in double: for what is done once a control, not once a sample.
//
// ω = e123∞ commutes with motors and squares to zero, so a function of a bivector is one of the dual number
// θ - (h/θ) ω, where B² = -θ² + 2hω (Wareham and Lasenby, theorems 3 and 9).
#pragma once

#include "../scalar_math.h"

#include <cmath>

namespace motorway {

template <class T> struct scalar_bivector {
    T b12, b13, b23, b1i, b2i, b3i;
};

template <class T> struct scalar_motor {
    T s, b12, b13, b23, b1i, b2i, b3i, w;
};

// From and into mw_motor_f32 and mw_motor_f64.
template <class T, class Motor> scalar_motor<T> load_motor(const Motor &m)
{
    return {T(m.s), T(m.b12), T(m.b13), T(m.b23), T(m.b1i), T(m.b2i), T(m.b3i), T(m.w)};
}
template <class Motor, class T> Motor store_motor(const scalar_motor<T> &m)
{
    using R = decltype(Motor::s);
    return {R(m.s), R(m.b12), R(m.b13), R(m.b23), R(m.b1i), R(m.b2i), R(m.b3i), R(m.w)};
}

template <class T> scalar_bivector<T> operator*(const scalar_bivector<T> &b, T x)
{
    return {b.b12 * x, b.b13 * x, b.b23 * x, b.b1i * x, b.b2i * x, b.b3i * x};
}
template <class T> scalar_bivector<T> operator+(const scalar_bivector<T> &a, const scalar_bivector<T> &b)
{
    return {a.b12 + b.b12, a.b13 + b.b13, a.b23 + b.b23, a.b1i + b.b1i, a.b2i + b.b2i, a.b3i + b.b3i};
}
template <class T> scalar_bivector<T> operator-(const scalar_bivector<T> &a, const scalar_bivector<T> &b)
{
    return {a.b12 - b.b12, a.b13 - b.b13, a.b23 - b.b23, a.b1i - b.b1i, a.b2i - b.b2i, a.b3i - b.b3i};
}
template <class T> scalar_motor<T> operator*(const scalar_motor<T> &m, T x)
{
    return {m.s * x, m.b12 * x, m.b13 * x, m.b23 * x, m.b1i * x, m.b2i * x, m.b3i * x, m.w * x};
}
template <class T> scalar_motor<T> operator+(const scalar_motor<T> &a, const scalar_motor<T> &b)
{
    return {a.s + b.s,     a.b12 + b.b12, a.b13 + b.b13, a.b23 + b.b23,
            a.b1i + b.b1i, a.b2i + b.b2i, a.b3i + b.b3i, a.w + b.w};
}
template <class T> scalar_motor<T> operator-(const scalar_motor<T> &a, const scalar_motor<T> &b)
{
    return {a.s - b.s,     a.b12 - b.b12, a.b13 - b.b13, a.b23 - b.b23,
            a.b1i - b.b1i, a.b2i - b.b2i, a.b3i - b.b3i, a.w - b.w};
}

template <class T> scalar_motor<T> reverse(const scalar_motor<T> &m)
{
    return {m.s, -m.b12, -m.b13, -m.b23, -m.b1i, -m.b2i, -m.b3i, m.w};
}

// The geometric product: f acts first, then t.
template <class T> scalar_motor<T> operator*(const scalar_motor<T> &f, const scalar_motor<T> &t)
{
    return {
        f.s * t.s - f.b12 * t.b12 - f.b13 * t.b13 - f.b23 * t.b23,
        f.s * t.b12 + f.b12 * t.s - f.b13 * t.b23 + f.b23 * t.b13,
        f.s * t.b13 + f.b12 * t.b23 + f.b13 * t.s - f.b23 * t.b12,
        f.s * t.b23 - f.b12 * t.b13 + f.b13 * t.b12 + f.b23 * t.s,
        f.s * t.b1i + f.b12 * t.b2i + f.b13 * t.b3i + f.b1i * t.s - f.b23 * t.w - f.b2i * t.b12 - f.b3i * t.b13
            - f.w * t.b23,
        f.s * t.b2i - f.b12 * t.b1i + f.b13 * t.w + f.b1i * t.b12 + f.b23 * t.b3i + f.b2i * t.s - f.b3i * t.b23
            + f.w * t.b13,
        f.s * t.b3i - f.b12 * t.w - f.b13 * t.b1i + f.b1i * t.b13 - f.b23 * t.b2i + f.b2i * t.b23 + f.b3i * t.s
            - f.w * t.b12,
        f.s * t.w + f.b12 * t.b3i - f.b13 * t.b2i + f.b1i * t.b23 + f.b23 * t.b1i - f.b2i * t.b13 + f.b3i * t.b12
            + f.w * t.s,
    };
}

// Of two rotations as vectors: below 0 if one is nearer to the other with the opposite sign.
template <class T> T rotations_dot(const scalar_motor<T> &a, const scalar_motor<T> &b)
{
    return a.s * b.s + a.b12 * b.b12 + a.b13 * b.b13 + a.b23 * b.b23;
}

// The part of S̄S = α + βω that is no pseudoscalar.
template <class T> T alpha(const scalar_motor<T> &m) { return rotations_dot(m, m); }

// S / √(S̄S): the same motion with S̄S = 1, and the sign of s.
template <class T> scalar_motor<T> normalized(const scalar_motor<T> &m)
{
    const T r = 1 / square_root(alpha(m)), half_beta = m.s * m.w - m.b12 * m.b3i + m.b13 * m.b2i - m.b23 * m.b1i;
    const T q = half_beta * r * r;
    return scalar_motor<T>{m.s,
                           m.b12,
                           m.b13,
                           m.b23,
                           m.b1i + m.b23 * q,
                           m.b2i - m.b13 * q,
                           m.b3i + m.b12 * q,
                           m.w - m.s * q} * r;
}

// (cos θ - sin θ/θ) / θ²; below θ = 1 by the power series, since the difference cancels.
template <class T> T sinc_slope(T theta, T cosine, T sinc)
{
    const T square = theta * theta;
    if (square >= 1)
        return (cosine - sinc) / square;
    T sum = 1;
    for (int k = 9; k > 0; --k)
        sum = 1 - sum * square / T(2 * k * (2 * k + 3));
    return sum / -3;
}

template <class T> scalar_motor<T> exp(const scalar_bivector<T> &b)
{
    const T theta = square_root(b.b12 * b.b12 + b.b13 * b.b13 + b.b23 * b.b23);
    const auto [sine, cosine] = sine_and_cosine(theta);
    const T f = theta > 0 ? sine / theta : T(1);
    const T h = b.b12 * b.b3i - b.b13 * b.b2i + b.b23 * b.b1i, g = h * sinc_slope(theta, cosine, f);
    return {cosine,
            b.b12 * f,
            b.b13 * f,
            b.b23 * f,
            b.b1i * f + b.b23 * g,
            b.b2i * f - b.b13 * g,
            b.b3i * f + b.b12 * g,
            h * f};
}

// The bivector B with exp(B) = m, which must be normalised: the motion of less than a full turn. Near m = -1 the axis
// is lost to rounding; where there is none, |b| <= 2^-40 as mw_log_principal_motor_each has it, the result is
// log(-m).
template <class T> scalar_bivector<T> log(const scalar_motor<T> &m)
{
    const T sine = square_root(m.b12 * m.b12 + m.b13 * m.b13 + m.b23 * m.b23);
    if (m.s < 0 && sine <= T(0x1p-40))
        return log(m * T(-1));
    const T theta = angle_of(m.s, sine), f = sine > 0 ? theta / sine : T(1);
    const T g = m.w * sinc_slope(theta, m.s, 1 / f) * f * f * f;
    return {m.b12 * f, m.b13 * f, m.b23 * f, m.b1i * f - m.b23 * g, m.b2i * f + m.b13 * g, m.b3i * f - m.b12 * g};
}

} // namespace motorway
