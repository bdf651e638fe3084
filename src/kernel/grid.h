// The grid of every motor with every element, where the images of an element lie side by side: lanes are motors.
// (Where those of a motor lie side by side it is `one`, motor after motor.)
#pragma once

#include "body.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// Elements that are done for all motors before the next are begun, so that their images are in the cache until all of
// them are there.
constexpr std::size_t grid_chunk = 64;

// The matrices, or whatever a prologue makes, of the motors m, m + 1, ... in the lanes of `half` of a register.
template <class K, class T, class E>
inline void load_matrices(const call<T, E> &c, const any_stream<const T, motor_size> &motors, std::size_t m, int half,
                          vector<T> *constant)
{
    vector<T> fixed[K::fixed_size];
    const std::size_t first = m + half * width<T>;
    if (first + width<T> <= c.rows)
        motors.load(first, fixed);
    else
        motors.load_partial(first, first < c.rows ? static_cast<int>(c.rows - first) : 0, fixed);
    for (int n = motor_size; n < K::fixed_size; ++n)
        fixed[n] = vector<T>(c.fixed[n - motor_size]);
    if (is_far_from_unit(fixed))
        bring_near_unit(fixed);
    K::template prologue<vector<T>>(fixed, constant);
}

// Where the images of element i are, as streams.
template <class K, class E> struct images {
    E *component[K::outputs::sum];
    stream<E> streams[K::outputs::number];

    template <class T> images(const call<T, E> &c, std::size_t i)
    {
        for (int k = 0, n = 0; k < K::outputs::number; ++k) {
            streams[k] = {component + n, c.row_stride, c.out[k].kind};
            for (int j = 0; j < K::outputs::value[k]; ++j, ++n)
                component[n] = at(c.out[k].component[j], c.out[k].stride, i);
        }
    }
};

template <class K, class T, class E> inline void broadcast_element(const call<T, E> &c, std::size_t i, vector<T> *in)
{
    for (int k = 0, n = 0; k < K::inputs::number; ++k)
        for (int j = 0; j < K::inputs::value[k]; ++j, ++n)
            in[n] = vector<T>(static_cast<T>(read<E>(at(c.in[k].component[j], c.in[k].stride, i))));
}

template <class K, class T, class E, template <class, int> class Stream>
MOTORWAY_LOOP void run_lanes_of_motors(const call<T, E> &c)
{
    constexpr int N = K::inputs::sum, M = K::outputs::sum, halves = width<E> / width<T>;
    const any_stream<const T, motor_size> motors(c.motors);
    for (std::size_t begin = 0; begin < c.count; begin += grid_chunk) {
        const std::size_t end = c.count - begin < grid_chunk ? c.count : begin + grid_chunk;
        for (std::size_t m = 0; m < c.rows; m += width<E>) {
            vector<T> constant[halves][K::constant_size];
            for (int half = 0; half < halves; ++half)
                load_matrices<K>(c, motors, m, half, constant[half]);
            for (std::size_t i = begin; i < end; ++i) {
                vector<T> in[N], computed[halves][M];
                broadcast_element<K>(c, i, in);
                for (int half = 0; half < halves; ++half)
                    K::template body<vector<T>>(constant[half], in, computed[half]);
                vector<E> result[M];
                narrow_halves<T, E, M>(computed, result);
                const images<K, E> where(c, i);
                const bundle<E, Stream, typename K::outputs> out(where.streams);
                if (c.rows - m >= width<E>)
                    out.store(m, result);
                else
                    out.store_partial(m, static_cast<int>(c.rows - m), result);
            }
        }
    }
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
