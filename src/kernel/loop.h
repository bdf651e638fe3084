// The loops that drive a generated kernel over a batch: one for element kernels, one for affine maps of packed
// triples, two for blends. Tails go through the same vector code.
#pragma once

#include "layout.h"

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

// A kernel of one or two streams, each with its reader, into a writer.
template <class K, class T, template <class, int> class Stream> MOTORWAY_LOOP void run_elements(const call<T> &c)
{
    using V = vector<T>;
    constexpr int N = K::first_size, M = K::second_size;
    V constant[K::constant_size + 1];
    broadcast_constants<K>(c.fixed, constant);
    const Stream<const T, N> first(c.in[0]);
    const Stream<const T, M ? M : N> second(c.in[M ? 1 : 0]);
    const Stream<T, K::output_size> out(c.out);
    V in[N + M], result[K::output_size];
    const std::size_t count = c.count; // a store could change the original for all that the compiler knows
    std::size_t i = 0;
    for (; count - i >= width<T>; i += width<T>) {
        first.load(i, in);
        if constexpr (M > 0)
            second.load(i, in + N);
        run_body<K>(constant, in, result);
        out.store(i, result);
    }
    if (const int left = static_cast<int>(count - i)) {
        first.load_partial(i, left, in);
        if constexpr (M > 0)
            second.load_partial(i, left, in + N);
        run_body<K>(constant, in, result);
        out.store_partial(i, left, result);
    }
}

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
    template <int R> void set_register(const T *constant)
    {
        matrix[R][0] = repeat<R, 0>(constant, lanes_of<W>{});
        matrix[R][1] = repeat<R, 1>(constant, lanes_of<W>{});
        matrix[R][2] = repeat<R, 2>(constant, lanes_of<W>{});
        if constexpr (translates)
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

template <class K, class T> MOTORWAY_LOOP void run_packed_affine(const call<T> &c)
{
    const packed_affine_map<K, T> affine(c.fixed);
    const packed_registers<const T, 3> from(c.in[0]);
    const packed_registers<T, 3> to(c.out);
    vector<T> in[3], out[3];
    const std::size_t count = c.count;
    std::size_t i = 0;
    for (; count - i >= width<T>; i += width<T>) {
        from.load(i, in);
        affine.map(in, out);
        to.store(i, out);
    }
    if (const int left = static_cast<int>(count - i)) {
        from.load_partial(i, left, in);
        affine.map(in, out);
        to.store_partial(i, left, out);
    }
}

#endif

// The count from which setting up the coefficients of a packed affine map costs less than it saves.
constexpr std::size_t affine_pays = 128;

// Whether a kernel is an affine map of triples.
template <class K, class = void> constexpr bool is_affine = false;
template <class K> constexpr bool is_affine<K, std::enable_if_t<K::affine>> = true;

template <class K, class T> inline bool all_are(const call<T> &c, layout kind)
{
    return c.out.kind == kind && c.in[0].kind == kind && (K::second_size == 0 || c.in[1].kind == kind);
}

// The entry of the kernel table: the fast loops where every stream has the same layout, else the general one.
template <class K, class T> void run(const call<T> &c)
{
    if (all_are<K>(c, layout::soa))
        return run_elements<K, T, soa_stream>(c);
    if (all_are<K>(c, layout::packed)) {
#if !defined(MOTORWAY_ISA_scalar)
        if constexpr (is_affine<K>)
            if (c.count >= affine_pays)
                return run_packed_affine<K, T>(c);
#endif
        return run_elements<K, T, packed_stream>(c);
    }
    if (all_are<K>(c, layout::interleaved))
        return run_elements<K, T, interleaved_stream>(c);
    run_elements<K, T, any_stream>(c);
}

// --------------------------------------------------------------------------------------------------- blends

// Σk weight k · control k for one block of elements. `load_term(k, v)` fills v with a weight and a control.
template <class K, class T, class Load> inline void blend_block(std::size_t terms, const Load &load_term, vector<T> *sum)
{
    using V = vector<T>;
    constexpr int N = K::output_size;
    for (int n = 0; n < N; ++n)
        sum[n] = V(T(0));
    for (std::size_t k = 0; k < terms; ++k) {
        V in[N + 1 + N]; // the sum so far, a weight, a control
        for (int n = 0; n < N; ++n)
            in[n] = sum[n];
        load_term(k, in + N);
        K::template body<V>(in, sum);
    }
}

// A blend with given readers. Controls is shared_controls or a stream.
template <class K, class T, template <class, int> class Weights, template <class, int> class Controls>
MOTORWAY_LOOP void run_blend(const call<T> &c)
{
    using V = vector<T>;
    constexpr int N = K::output_size;
    const any_stream<T, N> out(c.out);
    const auto weights = [&](std::size_t k) {
        return Weights<const T, 1>({c.in[0].component + k, c.in[0].stride, c.in[0].kind});
    };
    const auto controls = [&](std::size_t k) { return Controls<const T, N>(c, k); };
    V sum[N];
    const std::size_t count = c.count;
    std::size_t i = 0;
    for (; count - i >= width<T>; i += width<T>) {
        blend_block<K, T>(
            c.terms, [&](std::size_t k, V *v) { weights(k).load(i, v), controls(k).load(i, v + 1); }, sum);
        out.store(i, sum);
    }
    if (const int left = static_cast<int>(count - i)) {
        blend_block<K, T>(
            c.terms,
            [&](std::size_t k, V *v) {
                weights(k).load_partial(i, left, v), controls(k).load_partial(i, left, v + 1);
            },
            sum);
        out.store_partial(i, left, sum);
    }
}

// The k-th control, the same for every element.
template <class T, int N> class shared_controls {
    using V = vector<std::remove_const_t<T>>;
    T *control;

public:
    shared_controls(const call<std::remove_const_t<T>> &c, std::size_t k) : control(c.fixed + N * k) {}
    void load(std::size_t, V *v) const
    {
        for (int n = 0; n < N; ++n)
            v[n] = V(control[n]);
    }
    void load_partial(std::size_t i, int, V *v) const { load(i, v); }
};

// The k-th controls, one an element.
template <template <class, int> class Stream> struct own_controls {
    template <class T, int N> struct type : Stream<T, N> {
        type(const call<std::remove_const_t<T>> &c, std::size_t k) : Stream<T, N>(c.in[1 + k]) {}
    };
};

template <class K, class T> void run_blend_shared(const call<T> &c)
{
    if (c.in[0].kind == layout::soa)
        return run_blend<K, T, soa_stream, shared_controls>(c);
    run_blend<K, T, any_stream, shared_controls>(c);
}

template <class T> inline bool all_controls_are(const call<T> &c, layout kind)
{
    for (std::size_t k = 1; k <= c.terms; ++k)
        if (c.in[k].kind != kind)
            return false;
    return true;
}

template <class K, class T> void run_blend_each(const call<T> &c)
{
    if (c.in[0].kind == layout::soa && all_controls_are(c, layout::soa))
        return run_blend<K, T, soa_stream, own_controls<soa_stream>::template type>(c);
    if (c.in[0].kind == layout::soa && all_controls_are(c, layout::packed))
        return run_blend<K, T, soa_stream, own_controls<packed_stream>::template type>(c);
    run_blend<K, T, any_stream, own_controls<any_stream>::template type>(c);
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
