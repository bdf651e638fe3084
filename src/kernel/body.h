// One block of elements through the arithmetic of a generated kernel.
#pragma once

#include "../near_unit.h"
#include "streams.h"

// Everything that a loop calls is compiled into it, so that elements stay in registers.
#define MOTORWAY_LOOP __attribute__((flatten))

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// ------------------------------------------------------------------------------------------ motors of any length
//
// Kernels whose motors may be of any length, and those that hold a motor of a batch far from 1 (../near_unit.h). The one
// motor of a call is brought near 1 by the caller.

template <class K, class = void> constexpr bool takes_any_length = false;
template <class K> constexpr bool takes_any_length<K, std::enable_if_t<(K::degree <= 0)>> = true;

template <class V> inline V alpha_of(const V *motor)
{
    return fma(motor[3], motor[3], fma(motor[2], motor[2], fma(motor[1], motor[1], motor[0] * motor[0])));
}

template <class V> inline bool is_far_from_unit(const V *motor)
{
    constexpr scalar_of<V> near = is_single<V> ? near_unit_f32 : near_unit_f64;
    return __builtin_expect(!all_between(alpha_of(motor), 1 / near, near), false);
}

// Scales the motors of a register, and returns by what.
template <class V> __attribute__((noinline, cold)) V bring_near_unit(V *motor)
{
    using T = scalar_of<V>;
    constexpr int lanes = sizeof(V) / sizeof(T);
    const V alpha = alpha_of(motor);
    T each[lanes];
    __builtin_memcpy(each, &alpha, sizeof alpha);
    for (T &lane : each)
        lane = factor_near_unit(lane);
    V factor;
    __builtin_memcpy(static_cast<void *>(&factor), each, sizeof factor);
    for (int c = 0; c < motor_size; ++c)
        motor[c] = motor[c] * factor;
    return factor;
}

// -------------------------------------------------------------------------------------------- prologue and body

// What the prologue makes of the fixed input, in every lane. An array of one where there is no prologue.
template <class K, class T, class V> inline void broadcast_constants(const T *fixed, V *constant)
{
    if constexpr (K::constant_size > 0) {
        T scalar[K::constant_size];
        K::template prologue<T>(fixed, scalar);
        for (int c = 0; c < K::constant_size; ++c)
            constant[c] = V(scalar[c]);
    }
}

template <class K, class V> inline void run_body_as_it_is(const V *constant, const V *in, V *out)
{
    if constexpr (K::constant_size > 0)
        K::template body<V>(constant, in, out);
    else
        K::template body<V>(in, out);
}

template <class K, class V>
__attribute__((noinline, cold)) void run_body_near_unit(const V *constant, const V *in, V *out)
{
    static_assert(K::degree == 0 || K::degree == -1);
    constexpr int N = K::motor_size + K::inputs::sum;
    V near[N];
    for (int n = 0; n < N; ++n)
        near[n] = in[n];
    const V factor = bring_near_unit(near);
    run_body_as_it_is<K>(constant, near, out);
    if constexpr (K::degree == -1)
        for (int m = 0; m < K::outputs::sum; ++m)
            out[m] = out[m] * factor;
}

template <class K, class V> inline void run_body(const V *constant, const V *in, V *out)
{
    if constexpr (takes_any_length<K>)
        if constexpr (!K::has_fixed_motor)
            if (is_far_from_unit(in))
                return run_body_near_unit<K>(constant, in, out);
    run_body_as_it_is<K>(constant, in, out);
}

template <class T, class E, int M, int Halves>
inline void narrow_halves(const vector<T> (&computed)[Halves][M], vector<E> *result)
{
    for (int m = 0; m < M; ++m)
        if constexpr (Halves == 1)
            result[m] = narrow<E>(computed[0][m]);
        else
            result[m] = narrow<E>(computed[0][m], computed[1][m]);
}

// A register of elements E fills one or two of what the kernel computes in. load_motors(half, v) fills v with the
// motors of a half, if the kernel takes any from the batch.
template <class K, class T, class E, class LoadMotors>
inline void run_halves(const vector<T> *constant, const vector<E> *given, vector<E> *result, LoadMotors load_motors)
{
    constexpr int N = K::inputs::sum, M = K::outputs::sum, halves = width<E> / width<T>;
    vector<T> computed[halves][M];
    for (int half = 0; half < halves; ++half) {
        vector<T> in[K::motor_size + N];
        load_motors(half, in);
        for (int n = 0; n < N; ++n)
            in[K::motor_size + n] = widen<T>(given[n], half);
        run_body<K>(constant, in, computed[half]);
    }
    narrow_halves<T, E, M>(computed, result);
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
