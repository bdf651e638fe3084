// What a kernel reads and writes, of several streams; and where the motor of an element comes from.
#pragma once

#include "layout.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// The components of the streams of a kernel, as the generated code lists them.
template <int... N> struct sizes {
    static constexpr int sum = (N + ... + 0);
    static constexpr int number = sizeof...(N);
    static constexpr int value[sizeof...(N) + 1] = {N..., 0};
    static constexpr bool are_small = ((N <= 4) && ...); // attributes of vertices
    static constexpr bool are_triples = ((N == 3) && ...);
};

// Several streams that are read or written together; their components follow one another in the registers.
template <class T, template <class, int> class Stream, class Sizes> class bundle;

template <class T, template <class, int> class Stream> class bundle<T, Stream, sizes<>> {
    using V = vector<std::remove_const_t<T>>;

public:
    explicit bundle(const stream<T> *) {}
    void load(std::size_t, V *) const {}
    void load_partial(std::size_t, int, V *) const {}
    void store(std::size_t, const V *) const {}
    void store_streaming(std::size_t, const V *) const {}
    void store_partial(std::size_t, int, const V *) const {}
};

template <class T, template <class, int> class Stream, int N, int... More> class bundle<T, Stream, sizes<N, More...>> {
    using V = vector<std::remove_const_t<T>>;
    Stream<T, N> first;
    bundle<T, Stream, sizes<More...>> rest;

public:
    explicit bundle(const stream<T> *streams) : first(streams[0]), rest(streams + 1) {}
    void load(std::size_t i, V *v) const { first.load(i, v), rest.load(i, v + N); }
    void load_partial(std::size_t i, int n, V *v) const
    {
        first.load_partial(i, n, v), rest.load_partial(i, n, v + N);
    }
    void store(std::size_t i, const V *v) const { first.store(i, v), rest.store(i, v + N); }
    void store_streaming(std::size_t i, const V *v) const
    {
        first.store_streaming(i, v), rest.store_streaming(i, v + N);
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        first.store_partial(i, n, v), rest.store_partial(i, n, v + N);
    }
};

// Two streams side by side in every element, as positions and normals often are in vertices: moved as one, in fewer
// loads and stores.
template <class T, int N> class side_by_side;

template <class T, int N, int M>
class bundle<T, side_by_side, sizes<N, M>> : public interleaved_stream<T, N + M> {
public:
    explicit bundle(const stream<T> *streams) : interleaved_stream<T, N + M>(streams[0]) {}
};

template <class Sizes, class T> inline bool lie_side_by_side(const stream<T> *streams)
{
    return streams[0].stride == streams[1].stride && streams[1].component[0] == streams[0].component[0] + Sizes::value[0];
}

// ------------------------------------------------------------------------------------------- past the caches

// What becomes of the results of a whole register.
enum class store_mode { cached, streaming };

// How many elements come before the first whose scalars, of all components, begin a cache line; `never` if none does.
constexpr int never = -1;
template <class T>
__attribute__((noinline)) int elements_to_line(const stream<T> *streams, int number, int components)
{
    constexpr std::size_t scalars = cache_line / sizeof(T); // a line
    const bool soa = streams[0].kind == layout::soa;
    const std::size_t first = reinterpret_cast<std::size_t>(streams[0].component[0]);
    for (int k = 0; k < number; ++k)
        for (int c = 0; c < (soa ? components : 1); ++c)
            if ((reinterpret_cast<std::size_t>(streams[k].component[c]) - first) % cache_line != 0)
                return never;
    for (std::size_t n = 0; n < scalars; ++n)
        if ((first + n * (soa ? 1 : components) * sizeof(T)) % cache_line == 0)
            return static_cast<int>(n);
    return never;
}

// ------------------------------------------------------------------------------------------------------- motors

constexpr int motor_size = 8;

// Kernels whose motor, if any, is the same for all elements.
template <class T> struct no_motors {
    template <class E> explicit no_motors(const call<T, E> &) {}
    void load(std::size_t, vector<T> *) const {}
    void load_partial(std::size_t, int, vector<T> *) const {}
};

// One an element.
template <template <class, int> class Stream> struct own_motors {
    template <class T> struct of : Stream<const T, motor_size> {
        template <class E> explicit of(const call<T, E> &c) : Stream<const T, motor_size>(c.motors) {}
    };
};

// Rows of a palette. Compiled once: all that kernels do with it would otherwise be a lot of code.
template <class Index, class T>
inline bool find_motors(const T *palette, const index_stream &indices, std::size_t i, int n, const T **motor)
{
    const char *const first = static_cast<const char *>(indices.first) + i * indices.stride;
    Index index[width<T>];
    if (n == width<T> && indices.stride == sizeof(Index))
        __builtin_memcpy(index, first, sizeof index);
    else
        for (int lane = 0; lane < width<T>; ++lane)
            index[lane] = read<Index>(first + static_cast<std::size_t>(lane < n ? lane : 0) * indices.stride);
    Index differences = 0;
    for (int lane = 1; lane < width<T>; ++lane)
        differences |= index[lane] ^ index[0];
    for (int lane = 0; lane < (differences ? width<T> : 1); ++lane)
        motor[lane] = palette + static_cast<std::size_t>(motor_size) * index[lane];
    return differences == 0;
}

template <class T>
__attribute__((noinline, flatten)) void load_from_palette(const T *palette, const index_stream &indices, std::size_t i,
                                                          int n, vector<T> *v)
{
    if (n == 0) { // half a register of what is not there
        for (int c = 0; c < motor_size; ++c)
            v[c] = vector<T>(T(1));
        return;
    }
    const T *motor[width<T>];
    bool all_same;
    switch (indices.size) {
    case 1: all_same = find_motors<unsigned char>(palette, indices, i, n, motor); break;
    case 2: all_same = find_motors<unsigned short>(palette, indices, i, n, motor); break;
    default: all_same = find_motors<unsigned>(palette, indices, i, n, motor);
    }
    if (all_same) { // within a rigid part
        for (int c = 0; c < motor_size; ++c)
            v[c] = vector<T>(read<T>(motor[0] + c));
        return;
    }
    load_elements<motor_size, T>(v, [&](int lane) { return motor[lane]; });
}

template <class T> class palette_motors {
    const T *palette;
    const index_stream &indices;

public:
    template <class E> explicit palette_motors(const call<T, E> &c) : palette(c.palette), indices(c.indices) {}
    void load(std::size_t i, vector<T> *v) const { load_from_palette(palette, indices, i, width<T>, v); }
    void load_partial(std::size_t i, int n, vector<T> *v) const { load_from_palette(palette, indices, i, n, v); }
};

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
