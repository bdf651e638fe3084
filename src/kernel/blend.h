// Blends: weighted sums of motors, term by term.
#pragma once

#include "body.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// Whether a kernel adds a term to a sum.
template <class K, class = void> constexpr bool accumulates = false;
template <class K> constexpr bool accumulates<K, std::enable_if_t<K::accumulates>> = true;

// Σk weight k · control k for one block of elements. `load_term(k, v)` fills v with a weight and a control.
template <class K, class T, class Load>
inline void blend_block(std::size_t terms, const Load &load_term, vector<T> *sum)
{
    using V = vector<T>;
    constexpr int N = K::outputs::sum;
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
    constexpr int N = K::outputs::sum;
    const any_stream<T, N> out(c.out[0]);
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
