// One block of elements through the arithmetic of a generated kernel.
#pragma once

#include "streams.h"

// Everything that a loop calls is compiled into it, so that elements stay in registers.
#define MOTORWAY_LOOP __attribute__((flatten))

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

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

template <class K, class V> inline void run_body(const V *constant, const V *in, V *out)
{
    if constexpr (K::constant_size > 0)
        K::template body<V>(constant, in, out);
    else
        K::template body<V>(in, out);
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
