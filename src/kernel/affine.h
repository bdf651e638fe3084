// Affine maps of packed triples, which need no transposing.
#pragma once

#include "body.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// Whether a kernel is an affine map of triples; of two streams, the second is mapped without the translation.
template <class K, class = void> constexpr bool is_affine = false;
template <class K> constexpr bool is_affine<K, std::enable_if_t<K::affine>> = true;
template <class K> constexpr int triples = K::inputs::number;

// Whether streams lie so that all their triples are packed: one packed stream, or two that alternate.
template <class K, class T> inline bool are_packed_triples(const stream<T> *streams)
{
    if constexpr (triples<K> == 1)
        return streams[0].kind == layout::packed;
    else
        return streams[0].kind == layout::interleaved && streams[1].kind == layout::interleaved &&
               streams[0].stride == 6 * sizeof(T) && streams[1].stride == 6 * sizeof(T) &&
               streams[1].component[0] == streams[0].component[0] + 3;
}

// The count from which setting up the coefficients of a packed affine map costs less than it saves.
constexpr std::size_t affine_pays = 128;

#if !defined(MOTORWAY_ISA_scalar)

// An affine map of packed triples, without transposing: in each of three output registers, lane by lane, the three
// components of its element are picked from the input and multiplied with coefficients of period three. The order
// of the operations is that of the body, so the bits are the same.
template <class K, class T> class packed_affine_map {
    using V = vector<T>;
    static constexpr int W = width<T>, G = group<T>;
    static constexpr bool translates = K::constant_size == 12;
    V matrix[3][3]; // [register][column]
    V translation[3];

    // The coefficients of column C in register R: those of the row that each lane belongs to. Column 3 translates.
    template <int R, int C> struct coefficient {
        static constexpr int of(int lane)
        {
            const int row = (G * R + lane % G) % 3;
            return C == 3 ? 9 + row : 3 * row + C;
        }
    };
    template <int R, int C, int... J> static V repeat(const T *constant, std::integer_sequence<int, J...> lanes)
    {
        if constexpr (W >= 4) {
            const V r[] = {load(constant), load(constant + (W < 16 ? W : 0)), load(constant + (W < 8 ? 2 * W : 0))};
            return pick3<coefficient<R, C>, W>(r, lanes);
        } else
            return from_lanes<T>(constant[coefficient<R, C>::of(J)]...);
    }
    // The translation for the triples with even numbers. The others have -0, which changes no product, not even -0.
    template <int R, int... J> static V every_other(const V &translation_of_all, std::integer_sequence<int, J...>)
    {
        return shuffle<((G * R + J % G) / 3 % 2 ? W + J : J)...>(translation_of_all, V(-T(0)));
    }
    template <int R> void set_register(const T *constant)
    {
        matrix[R][0] = repeat<R, 0>(constant, lanes_of<W>{});
        matrix[R][1] = repeat<R, 1>(constant, lanes_of<W>{});
        matrix[R][2] = repeat<R, 2>(constant, lanes_of<W>{});
        if constexpr (translates && triples<K> == 2)
            translation[R] = every_other<R>(repeat<R, 3>(constant, lanes_of<W>{}), lanes_of<W>{});
        else if constexpr (translates)
            translation[R] = repeat<R, 3>(constant, lanes_of<W>{});
    }
    template <int R> V map_register(const V *in) const
    {
        const V x = pick3<component_in_triples<R, 0, G>, G>(in, lanes_of<W>{});
        const V y = pick3<component_in_triples<R, 1, G>, G>(in, lanes_of<W>{});
        const V z = pick3<component_in_triples<R, 2, G>, G>(in, lanes_of<W>{});
        const V first = translates ? fma(matrix[R][0], x, translation[R]) : matrix[R][0] * x;
        return fma(matrix[R][2], z, fma(matrix[R][1], y, first));
    }

public:
    explicit packed_affine_map(const T *fixed)
    {
        T constant[16] = {}; // whole registers
        K::template prologue<T>(fixed, constant);
        set_register<0>(constant);
        set_register<1>(constant);
        set_register<2>(constant);
    }
    void map(const V *in, V *out) const
    {
        out[0] = map_register<0>(in);
        out[1] = map_register<1>(in);
        out[2] = map_register<2>(in);
    }
};

// `before_line` triples come before the results begin a cache line.
template <class K, class T, store_mode Mode>
MOTORWAY_LOOP void run_packed_affine(const call<T> &c, [[maybe_unused]] int before_line)
{
    const packed_affine_map<K, T> affine(c.fixed);
    const packed_registers<const T, 3> from(c.in[0]);
    const packed_registers<T, 3> to(c.out[0]);
    const auto run_partial = [&](std::size_t i, int n) {
        vector<T> in[3], out[3];
        from.load_partial(i, n, in);
        affine.map(in, out);
        to.store_partial(i, n, out);
    };
    const std::size_t count = c.count * triples<K>;
    std::size_t i = 0;
    if constexpr (Mode == store_mode::streaming)
        for (int n; before_line > 0; before_line -= n, i += static_cast<std::size_t>(n))
            run_partial(i, n = lanes_left<T>(before_line, 0));
    for (; count - i >= width<T>; i += width<T>) {
        vector<T> in[3], out[3];
        from.load(i, in);
        affine.map(in, out);
        if constexpr (Mode == store_mode::streaming)
            to.store_streaming(i, out);
        else
            to.store(i, out);
    }
    if (const int left = static_cast<int>(count - i))
        run_partial(i, left);
}

// Runs a call of packed triples so, if it is one and large enough.
template <class K, class T> inline bool run_as_packed_affine(const call<T> &c)
{
    if (c.count * triples<K> < affine_pays || !are_packed_triples<K>(c.out) || !are_packed_triples<K>(c.in))
        return false;
    if constexpr (has_streaming_stores)
        if (c.streaming) {
            const int before_line = elements_to_line(c.out, 1, 3 * triples<K>);
            if (before_line != never) {
                run_packed_affine<K, T, store_mode::streaming>(c, triples<K> * before_line);
                return true;
            }
        }
    run_packed_affine<K, T, store_mode::cached>(c, 0);
    return true;
}

#endif

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
