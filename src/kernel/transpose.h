// Between packed elements and one register a component, in registers.
//
// Shuffles that stay within groups of lanes are much cheaper than others on some instruction sets. So a register is
// seen as groups of `group` lanes, and every group is transposed for itself: position p of a group is lane p % group
// of that group in register p / group. Packed elements of N components have component c of a group's element e at
// position N e + c; the transposed form has it at position c group + e.
#pragma once

#include "simd.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

#if !defined(MOTORWAY_ISA_scalar)

template <int Width> using lanes_of = std::make_integer_sequence<int, Width>;

// A register whose groups have position `Position::of(lane of the group)` of three registers.
template <class Position, int G, class V, int... J> inline V pick3(const V *r, std::integer_sequence<int, J...>)
{
    constexpr int W = sizeof...(J);
    constexpr bool uses_first = ((Position::of(J % G) < G) || ...);
    constexpr bool uses_last = ((Position::of(J % G) >= 2 * G) || ...);
    // Where position p of lane j's group is in the concatenation of two registers, the first of which starts at p = 0.
    constexpr auto lane = [](int j, int p) { return p / G * W + j / G * G + p % G; };
    if constexpr (!uses_last)
        return shuffle<lane(J, Position::of(J % G))...>(r[0], r[1]);
    else if constexpr (!uses_first)
        return shuffle<lane(J, Position::of(J % G) - G)...>(r[1], r[2]);
    else {
        const V front = shuffle<(Position::of(J % G) < 2 * G ? lane(J, Position::of(J % G)) : -1)...>(r[0], r[1]);
        return shuffle<(Position::of(J % G) < 2 * G ? J : lane(J, Position::of(J % G) - G))...>(front, r[2]);
    }
}

// Component C of packed triples.
template <int C> struct component_of_triple {
    static constexpr int of(int lane) { return 3 * lane + C; }
};

// Register R of packed triples, from three registers that hold a component each.
template <int R, int G> struct triple_of_components {
    static constexpr int of(int lane) { return (G * R + lane) % 3 * G + (G * R + lane) / 3; }
};

// In register R of packed triples: component C of the triple that each lane belongs to.
template <int R, int C, int G> struct component_in_triples {
    static constexpr int of(int lane) { return (G * R + lane) / 3 * 3 + C; }
};

template <class V, int W, int G> inline void unpack3(V *r)
{
    const V x = pick3<component_of_triple<0>, G>(r, lanes_of<W>{});
    const V y = pick3<component_of_triple<1>, G>(r, lanes_of<W>{});
    const V z = pick3<component_of_triple<2>, G>(r, lanes_of<W>{});
    r[0] = x, r[1] = y, r[2] = z;
}

template <class V, int W, int G> inline void pack3(V *r)
{
    const V a = pick3<triple_of_components<0, G>, G>(r, lanes_of<W>{});
    const V b = pick3<triple_of_components<1, G>, G>(r, lanes_of<W>{});
    const V c = pick3<triple_of_components<2, G>, G>(r, lanes_of<W>{});
    r[0] = a, r[1] = b, r[2] = c;
}

template <class V, int... J> inline void split_even_odd(V &a, V &b, std::integer_sequence<int, J...>)
{
    const V even = shuffle<(2 * J)...>(a, b);
    b = shuffle<(2 * J + 1)...>(a, b);
    a = even;
}

template <class V, int... J> inline void merge_even_odd(V &even, V &odd, std::integer_sequence<int, J...>)
{
    constexpr int W = sizeof...(J);
    const V a = shuffle<(J / 2 + J % 2 * W)...>(even, odd);
    odd = shuffle<(W / 2 + J / 2 + J % 2 * W)...>(even, odd);
    even = a;
}

// N = 2^k components: the even and the odd components are separated, and each half treated likewise. `Step` is the
// distance between the registers of the sequence at hand; component c ends in register c.
template <int N, class V, int W, int Step = 1> inline void unpack_power_of_two(V *r)
{
    if constexpr (N > 1) {
        for (int k = 0; k < N; k += 2)
            split_even_odd(r[k * Step], r[(k + 1) * Step], lanes_of<W>{});
        unpack_power_of_two<N / 2, V, W, 2 * Step>(r);
        unpack_power_of_two<N / 2, V, W, 2 * Step>(r + Step);
    }
}

template <int N, class V, int W, int Step = 1> inline void pack_power_of_two(V *r)
{
    if constexpr (N > 1) {
        pack_power_of_two<N / 2, V, W, 2 * Step>(r);
        pack_power_of_two<N / 2, V, W, 2 * Step>(r + Step);
        for (int k = 0; k < N; k += 2)
            merge_even_odd(r[k * Step], r[(k + 1) * Step], lanes_of<W>{});
    }
}

// Six components: the even and the odd ones, which are triples each.
template <class V, void (*convert)(V *)> inline void convert_even_and_odd_triples(V *r)
{
    for (int odd = 0; odd < 2; ++odd) {
        V triples[3] = {r[odd], r[odd + 2], r[odd + 4]};
        convert(triples);
        r[odd] = triples[0], r[odd + 2] = triples[1], r[odd + 4] = triples[2];
    }
}

template <class V, int W> inline void unpack6(V *r)
{
    for (int k = 0; k < 6; k += 2)
        split_even_odd(r[k], r[k + 1], lanes_of<W>{});
    convert_even_and_odd_triples<V, unpack3<V, W, W>>(r);
}

template <class V, int W> inline void pack6(V *r)
{
    convert_even_and_odd_triples<V, pack3<V, W, W>>(r);
    for (int k = 0; k < 6; k += 2)
        merge_even_odd(r[k], r[k + 1], lanes_of<W>{});
}

// Four registers of rows: in every group of four lanes, a square of four by four is transposed.
template <class V, int... J> inline void transpose_groups(V *r, std::integer_sequence<int, J...>)
{
    constexpr int W = sizeof...(J);
    // Lanes 0 1 of a and of b alternating, then lanes 2 3.
    const V a = shuffle<(J / 4 * 4 + J % 4 / 2 + J % 2 * W)...>(r[0], r[1]);
    const V b = shuffle<(J / 4 * 4 + J % 4 / 2 + J % 2 * W)...>(r[2], r[3]);
    const V c = shuffle<(J / 4 * 4 + 2 + J % 4 / 2 + J % 2 * W)...>(r[0], r[1]);
    const V d = shuffle<(J / 4 * 4 + 2 + J % 4 / 2 + J % 2 * W)...>(r[2], r[3]);
    // Pairs of lanes 0 1, then of 2 3.
    r[0] = shuffle<(J / 4 * 4 + J % 2 + J % 4 / 2 * W)...>(a, b);
    r[1] = shuffle<(J / 4 * 4 + 2 + J % 2 + J % 4 / 2 * W)...>(a, b);
    r[2] = shuffle<(J / 4 * 4 + J % 2 + J % 4 / 2 * W)...>(c, d);
    r[3] = shuffle<(J / 4 * 4 + 2 + J % 2 + J % 4 / 2 * W)...>(c, d);
}

// N registers of packed elements into one register a component, and back. Six and powers of two take whole registers
// as their groups.
template <int N, class V, int W, int G> inline void unpack(V *r)
{
    if constexpr (N == 3)
        unpack3<V, W, G>(r);
    else if constexpr (N == 6)
        unpack6<V, W>(r);
    else
        unpack_power_of_two<N, V, W>(r);
}

template <int N, class V, int W, int G> inline void pack(V *r)
{
    if constexpr (N == 3)
        pack3<V, W, G>(r);
    else if constexpr (N == 6)
        pack6<V, W>(r);
    else
        pack_power_of_two<N, V, W>(r);
}

#endif

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
