// How elements get from memory into one register a component, and back: one reader and one writer a layout.
//
// All have the same interface: load(i, v) and store(i, v) move the `width` elements from element i;
// load_partial(i, n, v) and store_partial(i, n, v) the n <= width elements from element i. Not a byte outside these
// elements is touched; lanes without an element hold ones. Writers of whole registers also have store_streaming(i, v),
// a store past the caches.
#pragma once

#include "call.h"
#include "transpose.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// The address of element i of a strided array.
template <class T> inline T *at(T *base, std::size_t stride, std::size_t i)
{
    using byte = std::conditional_t<std::is_const_v<T>, const char, char>;
    return reinterpret_cast<T *>(reinterpret_cast<byte *>(base) + i * stride);
}

// How many of n scalars are in the register whose first lane is scalar `first`.
template <class T> constexpr int lanes_left(int n, int first)
{
    return n <= first ? 0 : n - first < width<T> ? n - first : width<T>;
}

// ---------------------------------------------------------------------------------------------------- soa

template <class T, int N> class soa_stream {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    T *base[N];

public:
    explicit soa_stream(const stream<T> &s)
    {
        for (int c = 0; c < N; ++c)
            base[c] = s.component[c];
    }
    void load(std::size_t i, V *v) const
    {
        for (int c = 0; c < N; ++c)
            v[c] = MOTORWAY_ISA_NAME::load(base[c] + i);
        if constexpr (N <= 4) // more would crowd out what is computed
            for (int c = 0; c < N; ++c)
                keep(v[c]);
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        for (int c = 0; c < N; ++c)
            v[c] = MOTORWAY_ISA_NAME::load_partial(base[c] + i, n);
    }
    void store(std::size_t i, const V *v) const
    {
        for (int c = 0; c < N; ++c)
            MOTORWAY_ISA_NAME::store(base[c] + i, v[c]);
    }
    void store_streaming(std::size_t i, const V *v) const
    {
        for (int c = 0; c < N; ++c)
            MOTORWAY_ISA_NAME::store_streaming(base[c] + i, v[c]);
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        for (int c = 0; c < N; ++c)
            MOTORWAY_ISA_NAME::store_partial(base[c] + i, v[c], n);
    }
};

// ------------------------------------------------------------------------------------------------- packed

// N registers of packed elements, groups of lanes as transpose.h describes them.
template <class T, int N> class packed_registers {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    static constexpr int W = width<real>, G = group<real>;
    T *base;

public:
    explicit packed_registers(const stream<T> &s) : base(s.component[0]) {}
    void load(std::size_t i, V *v) const { load_from(base + N * i, v); }
    void store(std::size_t i, const V *v) const { store_to(base + N * i, v); }
    void store_streaming(std::size_t i, const V *v) const
    {
        for (int r = 0; r < N; ++r)
            store_groups_streaming(base + N * i + r * G, v[r], N * G);
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        if constexpr (G == W) {
            for (int r = 0; r < N; ++r) {
                const int lanes = lanes_left<real>(N * n, r * W);
                const T *from = base + N * i + r * W;
                v[r] = lanes == W ? MOTORWAY_ISA_NAME::load(from)
                       : lanes    ? MOTORWAY_ISA_NAME::load_partial(from, lanes)
                                  : V(real(1));
            }
        } else { // groups of one register are not adjacent in memory
            real padded[N * W];
            for (int k = 0; k < N * W; ++k)
                padded[k] = k < N * n ? read<real>(base + N * i + k) : real(1);
            load_from(padded, v);
        }
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        if constexpr (G == W) {
            for (int r = 0; r < N; ++r) {
                const int lanes = lanes_left<real>(N * n, r * W);
                T *to = base + N * i + r * W;
                if (lanes == W)
                    MOTORWAY_ISA_NAME::store(to, v[r]);
                else if (lanes)
                    MOTORWAY_ISA_NAME::store_partial(to, v[r], lanes);
            }
        } else {
            real padded[N * W];
            store_to(padded, v);
            for (int k = 0; k < N * n; ++k)
                write(base + N * i + k, padded[k]);
        }
    }

private:
    static void load_from(const real *from, V *v)
    {
        for (int r = 0; r < N; ++r)
            v[r] = load_groups(from + r * G, N * G);
    }
    static void store_to(real *to, const V *v)
    {
        for (int r = 0; r < N; ++r)
            store_groups(to + r * G, v[r], N * G);
    }
};

#if !defined(MOTORWAY_ISA_scalar)
template <class T, int N> class packed_transposed {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    packed_registers<T, N> memory;

public:
    explicit packed_transposed(const stream<T> &s) : memory(s) {}
    void load(std::size_t i, V *v) const
    {
        memory.load(i, v);
        unpack<N, V, width<real>, group<real>>(v);
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        memory.load_partial(i, n, v);
        unpack<N, V, width<real>, group<real>>(v);
    }
    void store(std::size_t i, const V *v) const
    {
        V turned[N];
        turn(v, turned);
        memory.store(i, turned);
    }
    void store_streaming(std::size_t i, const V *v) const
    {
        V turned[N];
        turn(v, turned);
        memory.store_streaming(i, turned);
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        V turned[N];
        turn(v, turned);
        memory.store_partial(i, n, turned);
    }

private:
    static void turn(const V *v, V *turned)
    {
        for (int c = 0; c < N; ++c)
            turned[c] = v[c];
        pack<N, V, width<real>, group<real>>(turned);
    }
};
#endif

// -------------------------------------------------------------------------------------------- interleaved
//
// Adjacent components at any addresses: elements are moved in rows of up to four components, which are transposed in
// registers. Lane 4 g + q holds element 4 g + q, so register q of a square holds the rows of elements q, 4 + q, ...

// What lanes without an element read.
template <class T> constexpr T ones[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

#if !defined(MOTORWAY_ISA_scalar)
template <int N, int First> constexpr int row_size = N - First < 4 ? N - First : 4;

// Elements of N components; element(lane) is where that of a lane begins.
template <int N, class T, int First = 0, class Address> inline void load_squares(vector<T> *v, Address element)
{
    if constexpr (First < N) {
        vector<T> square[4];
        for (int q = 0; q < 4; ++q) {
            const T *row[rows<T>];
            for (int g = 0; g < rows<T>; ++g)
                row[g] = element(4 * g + q) + First;
            square[q] = load_rows<row_size<N, First>>(row);
        }
        transpose_groups(square, lanes_of<width<T>>{});
        for (int c = 0; c < row_size<N, First>; ++c)
            v[First + c] = square[c];
        load_squares<N, T, First + 4>(v, element);
    }
}
template <int N, class T, int First = 0, class Address> inline void store_squares(const vector<T> *v, Address element)
{
    if constexpr (First < N) {
        vector<T> square[4];
        for (int c = 0; c < 4; ++c)
            square[c] = v[First + (c < row_size<N, First> ? c : 0)];
        transpose_groups(square, lanes_of<width<T>>{});
        for (int q = 0; q < 4; ++q) {
            T *row[rows<T>];
            for (int g = 0; g < rows<T>; ++g)
                row[g] = element(4 * g + q) + First;
            store_rows<row_size<N, First>>(row, square[q]);
        }
        store_squares<N, T, First + 4>(v, element);
    }
}

template <class T, int N> class interleaved_rows {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    T *base;
    std::size_t stride;

public:
    explicit interleaved_rows(const stream<T> &s) : base(s.component[0]), stride(s.stride) {}
    void load(std::size_t i, V *v) const
    {
        load_squares<N, real>(v, [=](int lane) { return at(base, stride, i + lane); });
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        static_assert(N <= sizeof ones<real> / sizeof(real));
        load_squares<N, real>(v, [=](int lane) { return lane < n ? at(base, stride, i + lane) : ones<real>; });
    }
    void store(std::size_t i, const V *v) const
    {
        store_squares<N, real>(v, [=](int lane) { return at(base, stride, i + lane); });
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        real nowhere[N];
        real *const dropped = nowhere;
        store_squares<N, real>(v, [=](int lane) { return lane < n ? at(base, stride, i + lane) : dropped; });
    }
};
#endif

// ---------------------------------------------------------------------------------------------- scattered

// Any base pointers and any stride: lane by lane.
template <class T, int N> class scattered_stream {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    static constexpr int W = width<real>;
    T *base[N];
    std::size_t stride;

public:
    explicit scattered_stream(const stream<T> &s) : stride(s.stride)
    {
        for (int c = 0; c < N; ++c)
            base[c] = s.component[c];
    }
    void load(std::size_t i, V *v) const
    {
        for (int c = 0; c < N; ++c) {
            real lanes[W];
            for (int lane = 0; lane < W; ++lane)
                lanes[lane] = read<real>(at(base[c], stride, i + lane));
            v[c] = MOTORWAY_ISA_NAME::load(lanes);
        }
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        for (int c = 0; c < N; ++c) {
            real lanes[W];
            for (int lane = 0; lane < W; ++lane)
                lanes[lane] = lane < n ? read<real>(at(base[c], stride, i + lane)) : real(1);
            v[c] = MOTORWAY_ISA_NAME::load(lanes);
        }
    }
    void store(std::size_t i, const V *v) const { store_first(i, W, v); }
    void store_partial(std::size_t i, int n, const V *v) const { store_first(i, n, v); }

private:
    void store_first(std::size_t i, int n, const V *v) const
    {
        for (int c = 0; c < N; ++c) {
            real lanes[W];
            MOTORWAY_ISA_NAME::store(lanes, v[c]);
            for (int lane = 0; lane < n; ++lane)
                write(at(base[c], stride, i + lane), lanes[lane]);
        }
    }
};

// ------------------------------------------------------------------------------------------------ choices

#if defined(MOTORWAY_ISA_scalar) // one element a register: nothing to transpose
template <class T> constexpr bool has_rows = false;
template <class T, int N> using interleaved_stream = scattered_stream<T, N>;
template <class T, int N> using packed_stream = packed_registers<T, N>;
#else
// Rows must fit into a register; where they do not, lanes are as good.
template <class T> constexpr bool has_rows = rows<std::remove_const_t<T>> > 0;
template <class T, int N>
using interleaved_stream = std::conditional_t<has_rows<T>, interleaved_rows<T, N>, scattered_stream<T, N>>;
// Whole rows of four are transposed at less cost than by permutes, except where every permute is one instruction.
template <int N> constexpr bool has_permutes = N == 3 || N == 4 || N == 8 || (N == 6 && permutes_are_cheap);
template <class T, int N>
using packed_stream =
    std::conditional_t<N == 1, soa_stream<T, N>,
                       std::conditional_t<has_permutes<N> && !(N % 4 == 0 && has_rows<T> && !permutes_are_cheap),
                                          packed_transposed<T, N>, interleaved_stream<T, N>>>;
#endif

// Elements of N adjacent components at any addresses: element(lane) is where that of a lane begins.
template <int N, class T, class Address> inline void load_elements(vector<T> *v, Address element)
{
#if !defined(MOTORWAY_ISA_scalar)
    if constexpr (has_rows<T>)
        return load_squares<N, T>(v, element);
#endif
    for (int c = 0; c < N; ++c) {
        T lanes[width<T>];
        for (int lane = 0; lane < width<T>; ++lane)
            lanes[lane] = read<T>(element(lane) + c);
        v[c] = load(lanes);
    }
}

// --------------------------------------------------------------------------------------------------- any

#if defined(MOTORWAY_ISA_scalar)
template <class T, int N> using any_stream = scattered_stream<T, N>;
#else
// Whichever of the four the stream is, decided at every access.
template <class T, int N> class any_stream {
    using V = vector<std::remove_const_t<T>>;
    layout kind;
    soa_stream<T, N> soa;
    packed_stream<T, N> packed;
    interleaved_stream<T, N> interleaved;
    scattered_stream<T, N> scattered;

    // Compiled as one, but not into the loops: four layouts for each of several streams would be a lot of code.
    template <class Use> __attribute__((noinline, flatten)) void use(Use use_stream) const
    {
        switch (kind) {
        case layout::soa: return use_stream(soa);
        case layout::packed: return use_stream(packed);
        case layout::interleaved: return use_stream(interleaved);
        case layout::scattered: return use_stream(scattered);
        }
    }

public:
    explicit any_stream(const stream<T> &s) : kind(s.kind), soa(s), packed(s), interleaved(s), scattered(s) {}
    void load(std::size_t i, V *v) const
    {
        use([=](const auto &s) { s.load(i, v); });
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        use([=](const auto &s) { s.load_partial(i, n, v); });
    }
    void store(std::size_t i, const V *v) const
    {
        use([=](const auto &s) { s.store(i, v); });
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        use([=](const auto &s) { s.store_partial(i, n, v); });
    }
};
#endif

// A writer that knows the usual layouts without a call.
template <class T, int N> class result_stream {
    layout kind;
    soa_stream<T, N> soa;
    packed_stream<T, N> packed;
    any_stream<T, N> any;

public:
    explicit result_stream(const stream<T> &s) : kind(s.kind), soa(s), packed(s), any(s) {}
    void store(std::size_t i, int n, const vector<T> *v) const
    {
        if (n < width<T>)
            any.store_partial(i, n, v);
        else if (kind == layout::soa)
            soa.store(i, v);
        else if (kind == layout::packed)
            packed.store(i, v);
        else
            any.store(i, v);
    }
};

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
