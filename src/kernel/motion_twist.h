// Velocities of motions: derivatives of what the generated bodies call, and twists of poses and of exponentials.
#pragma once

#include "jet.h"
#include "body.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// Those of the approximated functions are themselves approximated functions where these are close, which the derivative
// of a polynomial is not at the ends of its interval.

// S' = (C - S) / 2x
template <class V> inline jet<V> sinc(const jet<V> &x)
{
    return {sinc(x.value), V(scalar_of<V>(0.5)) * sinc_slope(x.value) * x.derivative};
}

// f(s), x = 1 - s
template <class V> inline jet<V> arc(const jet<V> &x)
{
    return {arc(x.value), negate(arc_slope(x.value) * x.derivative)};
}

// f'(s), x = 1 - s: f'' = (f + 3 s f') / (1 - s²), which cancels near s = 1, where the polynomial is good.
template <class V> inline jet<V> arc_slope(const jet<V> &x)
{
    using T = scalar_of<V>;
    const jet<V> polynomial = arc_slope<jet<V>>(x);
    const V s = V(T(1)) - x.value, safe = if_less(x.value, V(T(0.5)), V(T(0.5)), x.value);
    const V second = fma(V(T(3)) * s, polynomial.value, arc(x.value)) / (safe * (V(T(2)) - safe));
    return {polynomial.value,
            if_less(x.value, V(T(0.5)), polynomial.derivative, negate(second * x.derivative))};
}

// ------------------------------------------------------------------------------------------------------- twists

// The bivectors in motors: what is not s and w.
constexpr int bivector_size = 6;

template <class V> inline void copy(int size, const V *from, V *to)
{
    for (int n = 0; n < size; ++n)
        to[n] = from[n];
}

// S^-1 S', of which the rest is the change of S̄S.
template <class K, class V> inline void twist_of(const jet<V> *pose, V *twist)
{
    V in[2 * motor_size], both[motor_size];
    for (int n = 0; n < motor_size; ++n) {
        in[n] = pose[n].value;
        in[motor_size + n] = pose[n].derivative;
    }
    run_body<K>(static_cast<const V *>(nullptr), in, both);
    copy(bivector_size, both + 1, twist);
}

// M^-1 B M
template <class K, class V> inline void move_bivector(const V *motor, const V *bivector, V *out)
{
    V in[motor_size + bivector_size];
    copy(motor_size, motor, in);
    copy(bivector_size, bivector, in + motor_size);
    run_body<K>(static_cast<const V *>(nullptr), in, out);
}

// From the frame of the space into that of the body: S Ω S^-1.
template <class V> inline void into_body(const V *pose, V *twist)
{
    V reversed[motor_size], moved[bivector_size];
    copy(motor_size, pose, reversed);
    for (int n = 1; n <= bivector_size; ++n)
        reversed[n] = negate(pose[n]);
    move_bivector<apply_bivector_each>(reversed, twist, moved);
    copy(bivector_size, moved, twist);
}

// (real + dual ω) B
template <class V> inline void add_scaled(const V &real, const V &dual, const V *b, V *sum)
{
    sum[0] = fma(real, b[0], sum[0]);
    sum[1] = fma(real, b[1], sum[1]);
    sum[2] = fma(real, b[2], sum[2]);
    sum[3] = fnma(dual, b[2], fma(real, b[3], sum[3]));
    sum[4] = fma(dual, b[1], fma(real, b[4], sum[4]));
    sum[5] = fnma(dual, b[0], fma(real, b[5], sum[5]));
}

// A B - B A
template <class V> inline void commutator(const V *a, const V *b, V *out)
{
    const V two(scalar_of<V>(2));
    out[0] = two * fms(a[2], b[1], a[1] * b[2]);
    out[1] = two * fms(a[0], b[2], a[2] * b[0]);
    out[2] = two * fms(a[1], b[0], a[0] * b[1]);
    out[3] = two * fnma(a[4], b[0], fma(a[0], b[4], fms(a[1], b[5], a[5] * b[1])));
    out[4] = two * fnma(a[0], b[3], fma(a[3], b[0], fms(a[2], b[5], a[5] * b[2])));
    out[5] = two * fnma(a[1], b[3], fma(a[3], b[1], fms(a[4], b[2], a[2] * b[4])));
}

// S^-1 S' of S = exp(B), with the pose exp(B) given: the series B' - [B, B'] / 2! + [B, [B, B']] / 3! - ... summed,
// B' - p(x̂) [B, B'] + q(x̂) [B, [B, B']] with x̂ = -B² = x + yω, p = S² / 2 and q = (1 - S C) / 4x, both entire.
template <class V> inline void twist_of_exponential(const jet<V> *b, const V *pose, V *twist)
{
    using T = scalar_of<V>;
    V value[bivector_size], rate[bivector_size];
    for (int n = 0; n < bivector_size; ++n)
        value[n] = b[n].value, rate[n] = b[n].derivative;
    const V x = fma(value[0], value[0], fma(value[1], value[1], value[2] * value[2]));
    const V y = V(T(-2)) * fma(value[2], value[3], fnma(value[1], value[4], value[0] * value[5]));
    const V one(T(1));
    const V near_x = if_less(x, one, x, one), far_x = if_less(x, one, one, x), inverse = one / far_x;

    // S and its derivative; C is s. Beyond x = 1 nothing cancels.
    const V sine = fma(pose[1], value[0], fma(pose[2], value[1], pose[3] * value[2]));
    const V s = if_less(x, one, sinc(near_x), sine * inverse), c = pose[0], half(T(0.5));
    const V s_rate = half * if_less(x, one, sinc_slope(near_x), (c - s) * inverse);
    const V p = half * (s * s), p_rate = s * s_rate;

    const V quarter = V(T(0.25)) * inverse;
    const V q_far = quarter * fnma(s, c, one);
    const V q_far_rate = fnma(inverse, q_far, quarter * fnma(s_rate, c, half * (s * s)));
    const V q = if_less(x, one, adjoint(near_x), q_far);
    const V q_rate = if_less(x, one, adjoint_slope(near_x), q_far_rate);

    V once[bivector_size], twice[bivector_size];
    commutator(value, rate, once);
    commutator(value, once, twice);
    copy(bivector_size, rate, twist);
    add_scaled(negate(p), negate(p_rate * y), once, twist);
    add_scaled(q, q_rate * y, twice, twist);
}

// first then: the product in which `first` acts first.
template <class N> inline void compose(const N *first, const N *then, N *out)
{
    N in[2 * motor_size];
    copy(motor_size, first, in);
    copy(motor_size, then, in + motor_size);
    compose_motor_each::body<N>(in, out);
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
