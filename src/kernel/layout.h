// How elements get from memory into one register a component, and back: one reader and one writer a layout.
//
// All have the same interface: load(i, v) and store(i, v) move the `width` elements from element i;
// load_partial(i, n, v) and store_partial(i, n, v) the n < width elements from element i. Not a byte outside these
// elements is touched; lanes without an element hold ones.
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
    void store_partial(std::size_t i, int n, const V *v) const
    {
        for (int c = 0; c < N; ++c)
            MOTORWAY_ISA_NAME::store_partial(base[c] + i, v[c], n);
    }
};

// ------------------------------------------------------------------------------------------------- packed

// N registers as they lie in memory.
template <class T, int N> class packed_registers {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    T *base;

public:
    explicit packed_registers(const stream<T> &s) : base(s.component[0]) {}
    void load(std::size_t i, V *v) const
    {
        for (int r = 0; r < N; ++r)
            v[r] = MOTORWAY_ISA_NAME::load(base + N * i + r * width<real>);
    }
    void store(std::size_t i, const V *v) const
    {
        for (int r = 0; r < N; ++r)
            MOTORWAY_ISA_NAME::store(base + N * i + r * width<real>, v[r]);
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        for (int r = 0; r < N; ++r) {
            const int lanes = lanes_left<real>(N * n, r * width<real>);
            const T *from = base + N * i + r * width<real>;
            v[r] = lanes == width<real> ? MOTORWAY_ISA_NAME::load(from)
                   : lanes > 0           ? MOTORWAY_ISA_NAME::load_partial(from, lanes)
                                         : V(real(1));
        }
    }
    void store_partial(std::size_t i, int n, const V *v) const
    {
        for (int r = 0; r < N; ++r) {
            const int lanes = lanes_left<real>(N * n, r * width<real>);
            T *to = base + N * i + r * width<real>;
            if (lanes == width<real>)
                MOTORWAY_ISA_NAME::store(to, v[r]);
            else if (lanes > 0)
                MOTORWAY_ISA_NAME::store_partial(to, v[r], lanes);
        }
    }
};

#if defined(MOTORWAY_ISA_scalar)
template <class T, int N> using packed_stream = packed_registers<T, N>; // one element a register: nothing to turn
#else
template <class T, int N> class packed_stream {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    packed_registers<T, N> memory;

public:
    explicit packed_stream(const stream<T> &s) : memory(s) {}
    void load(std::size_t i, V *v) const
    {
        memory.load(i, v);
        unpack<N, V, width<real>>(v);
    }
    void load_partial(std::size_t i, int n, V *v) const
    {
        memory.load_partial(i, n, v);
        unpack<N, V, width<real>>(v);
    }
    void store(std::size_t i, const V *v) const
    {
        V turned[N];
        turn(v, turned);
        memory.store(i, turned);
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
        pack<N, V, width<real>>(turned);
    }
};
#endif

// ------------------------------------------------------------------------------------------------ strided

// Any base pointers and any stride: lane by lane.
template <class T, int N> class strided_stream {
    using real = std::remove_const_t<T>;
    using V = vector<real>;
    static constexpr int W = width<real>;
    T *base[N];
    std::size_t stride;

public:
    explicit strided_stream(const stream<T> &s) : stride(s.stride)
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

// --------------------------------------------------------------------------------------------------- any

// Whichever of the three the stream is, decided at every access.
template <class T, int N> class any_stream {
    using V = vector<std::remove_const_t<T>>;
    layout kind;
    soa_stream<T, N> soa;
    packed_stream<T, N> packed;
    strided_stream<T, N> strided;

    template <class Use> void use(Use use_stream) const
    {
        switch (kind) {
        case layout::soa: return use_stream(soa);
        case layout::packed: return use_stream(packed);
        case layout::strided: return use_stream(strided);
        }
    }

public:
    explicit any_stream(const stream<T> &s) : kind(s.kind), soa(s), packed(s), strided(s) {}
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

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
