// The loop that drives a generated kernel over a batch, and the choice of its readers and writers. Tails go through
// the same vector code.
#pragma once

#include "affine.h"
#include "blend.h"
#include "grid.h"
#include "streams.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// The elements of a register from element i on; with Partial the first n of them.
template <class K, class T, class E, bool Partial, store_mode Mode, class Motors, class In, class Out>
inline void run_block(const vector<T> *constant, const Motors &motors, const In &in, const Out &out, std::size_t i,
                      [[maybe_unused]] int n)
{
    vector<E> given[K::inputs::sum], result[K::outputs::sum];
    if constexpr (Partial)
        in.load_partial(i, n, given);
    else
        in.load(i, given);
    run_halves<K, T, E>(constant, given, result, [&](int half, vector<T> *v) {
        const std::size_t first = i + half * width<T>;
        if constexpr (Partial) {
            const int left = lanes_left<T>(n, half * width<T>);
            left < width<T> ? motors.load_partial(first, left, v) : motors.load(first, v);
        } else
            motors.load(first, v);
    });
    if constexpr (Partial)
        out.store_partial(i, n, result);
    else if constexpr (Mode == store_mode::streaming)
        out.store_streaming(i, result);
    else
        out.store(i, result);
}

// Whether the tails of every layout go through the loop for any: all but attributes of vertices, which come in small
// batches. That spares the compiler a second copy of a lot of arithmetic for each layout.
template <class K> constexpr bool shares_tails = !(K::inputs::are_small && K::outputs::are_small);

template <class K, class T, class E, template <class> class Motors> void run_rest(const call<T, E> &c, std::size_t i);

// Elements from number `i` on, from motors of any source and streams of one layout. `before_line` elements come
// before the results begin a cache line.
template <class K, class T, class E, template <class> class Motors, template <class, int> class Stream,
          store_mode Mode = store_mode::cached>
MOTORWAY_LOOP void run_elements(const call<T, E> &c, [[maybe_unused]] int before_line = 0, std::size_t i = 0)
{
    vector<T> constant[K::constant_size + 1];
    broadcast_constants<K>(c.fixed, constant);
    const Motors<T> motors(c);
    const bundle<const E, Stream, typename K::inputs> in(c.in);
    const bundle<E, Stream, typename K::outputs> out(c.out);
    const std::size_t count = c.count; // a store could change the original for all that the compiler knows
    if constexpr (Mode == store_mode::streaming)
        for (int n; before_line > 0; before_line -= n, i += static_cast<std::size_t>(n)) {
            n = lanes_left<E>(before_line, 0);
            run_block<K, T, E, true, Mode>(constant, motors, in, out, i, n);
        }
    for (; count - i >= width<E>; i += width<E>)
        run_block<K, T, E, false, Mode>(constant, motors, in, out, i, width<E>);
    if (const int left = static_cast<int>(count - i)) {
        if constexpr (shares_tails<K> && !std::is_same_v<Stream<E, 1>, any_stream<E, 1>>)
            run_rest<K, T, E, Motors>(c, i);
        else
            run_block<K, T, E, true, Mode>(constant, motors, in, out, i, left);
    }
}

template <class K, class T, class E, template <class> class Motors>
__attribute__((noinline)) void run_rest(const call<T, E> &c, std::size_t i)
{
    run_elements<K, T, E, Motors, any_stream>(c, 0, i);
}

// Whether what reads or writes streams of a kind does with this one: arrays of one component are packed as well, and
// packed elements are interleaved.
template <class Stream> inline bool is(layout kind, const Stream &stream, int components)
{
    const bool array = components == 1 && stream.kind == layout::soa;
    return stream.kind == kind || (kind == layout::packed && array) ||
           (kind == layout::interleaved && (array || stream.kind == layout::packed));
}

template <class Sizes, class Stream> inline bool all_are(layout kind, const Stream *streams)
{
    bool all = true;
    for (int k = 0; k < Sizes::number; ++k)
        all &= is(kind, streams[k], Sizes::value[k]);
    return all;
}

template <class K, class T, class E> inline bool elements_are(const call<T, E> &c, layout kind)
{
#if defined(MOTORWAY_ISA_scalar) // one element a register: every layout is as good as any
    return false;
#endif
    return all_are<typename K::outputs>(kind, c.out) && all_are<typename K::inputs>(kind, c.in);
}

// All streams of one layout that has whole registers: their results can go past the caches.
template <class K, class T, class E, template <class> class Motors, template <class, int> class Stream>
inline void run_whole_registers(const call<T, E> &c)
{
    if constexpr (has_streaming_stores && K::outputs::are_triples)
        if (c.streaming && c.count >= cache_line) {
            const int before_line = elements_to_line(c.out, K::outputs::number, 3);
            if (before_line != never)
                return run_elements<K, T, E, Motors, Stream, store_mode::streaming>(c, before_line);
        }
    run_elements<K, T, E, Motors, Stream>(c);
}

// Adjacent components at any stride.
template <class K, class T, class E, template <class> class Motors> inline void run_interleaved(const call<T, E> &c)
{
    using in = typename K::inputs;
    using out = typename K::outputs;
    if constexpr (has_rows<E> && in::number == 2 && out::number == 2 && in::are_triples && out::are_triples)
        if (lie_side_by_side<in>(c.in) && lie_side_by_side<out>(c.out))
            return run_elements<K, T, E, Motors, side_by_side>(c);
    run_elements<K, T, E, Motors, interleaved_stream>(c);
}

// Motors that do not depend on the layout of the elements: the fast loops where all of these have the same layout,
// else the general one.
template <class K, class T, class E, template <class> class Motors> inline void run_any_layout(const call<T, E> &c)
{
    if (elements_are<K>(c, layout::soa))
        return run_whole_registers<K, T, E, Motors, soa_stream>(c);
#if !defined(MOTORWAY_ISA_scalar)
    if constexpr (is_affine<K> && std::is_same_v<T, E>)
        if (run_as_packed_affine<K>(c))
            return;
#endif
    if (elements_are<K>(c, layout::packed))
        return run_whole_registers<K, T, E, Motors, packed_stream>(c);
    if constexpr (K::inputs::are_small || K::motor_size == 0)
        if (elements_are<K>(c, layout::interleaved))
            return run_interleaved<K, T, E, Motors>(c);
    run_elements<K, T, E, Motors, any_stream>(c);
}

// ----------------------------------------------------------------------- the entries of the kernel table, by pairing

template <class K, class T, class E> void run_one(const call<T, E> &c)
{
    if constexpr (accumulates<K>)
        run_blend_shared<K>(c);
    else
        run_any_layout<K, T, E, no_motors>(c);
}

// One motor that acts first, or last.
template <class K, class T, class E> void run_one_first(const call<T, E> &c) { run_any_layout<K, T, E, no_motors>(c); }
template <class K, class T, class E> void run_one_then(const call<T, E> &c) { run_any_layout<K, T, E, no_motors>(c); }

template <class K, class T, class E> void run_each(const call<T, E> &c)
{
    if constexpr (accumulates<K>)
        run_blend_each<K>(c);
    else if constexpr (K::motor_size == 0)
        run_any_layout<K, T, E, no_motors>(c);
    else {
        // As above; the motors have that layout too, or no stream is taken for fast.
        const layout kind = c.motors.kind;
        if (kind == layout::soa && elements_are<K>(c, kind))
            return run_whole_registers<K, T, E, own_motors<soa_stream>::template of, soa_stream>(c);
        if (kind == layout::packed && elements_are<K>(c, kind))
            return run_whole_registers<K, T, E, own_motors<packed_stream>::template of, packed_stream>(c);
        if constexpr (K::inputs::are_small)
            if (kind == layout::packed && elements_are<K>(c, layout::interleaved))
                return run_interleaved<K, T, E, own_motors<packed_stream>::template of>(c);
        run_elements<K, T, E, own_motors<any_stream>::template of, any_stream>(c);
    }
}

// The images of an element lie side by side: the other grid is apply.cpp's.
template <class K, class T, class E> void run_grid(const call<T, E> &c)
{
    if (all_are<typename K::outputs>(layout::soa, c.out))
        return run_lanes_of_motors<K, T, E, soa_stream>(c);
    if (all_are<typename K::outputs>(layout::packed, c.out))
        return run_lanes_of_motors<K, T, E, packed_stream>(c);
    run_lanes_of_motors<K, T, E, any_stream>(c);
}

template <class K, class T, class E> void run_indexed(const call<T, E> &c)
{
    run_any_layout<K, T, E, palette_motors>(c);
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
