// What one would use instead. Every baseline binds itself to the problems that it can solve: baseline_<library>.cpp
// holds its bind_<library>, which returns an empty work for the others.
#pragma once

#include "plain.h"
#include "problem.h"
#include "rigid.h"
#include "work.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace motorway::bench {

template <class T, class M = T> struct baseline {
    std::string name; // "eigen"
    std::function<work(const problem<T, M> &)> bind;
};

// Those that are compiled in and that this CPU runs, and the names of those that it does not.
template <class T, class M = T> const std::vector<baseline<T, M>> &baselines();
std::vector<std::string> skipped_baselines();

// ------------------------------------------------------------------- helpers of baselines that work on single points

template <class T> std::array<double, 8> motor_at(const array<T> &motors, std::size_t i)
{
    std::array<double, 8> motor;
    for (std::size_t k = 0; k < 8; ++k)
        motor[k] = static_cast<double>(motors.at(k, i));
    return motor;
}

// Of the motors that all elements share.
template <class T, class M> std::array<double, 8> fixed_motor(const problem<T, M> &p, std::size_t i = 0)
{
    std::array<double, 8> motor;
    for (std::size_t k = 0; k < 8; ++k)
        motor[k] = static_cast<double>(p.fixed[8 * i + k]);
    return motor;
}

// What a library holds for the motors of an `each` kernel, or else for those that all elements share: make(rigid) of
// every one, in an array.
template <class T, class F> auto convert_motors(const problem<T> &p, F make)
{
    using element = std::decay_t<decltype(make(rigid()))>;
    auto converted = std::make_shared<std::vector<element>>();
    const std::size_t count = p.motors ? p.count : p.fixed.size() / 8;
    converted->reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        converted->push_back(make(rigid_of(p.motors ? motor_at(*p.motors, i) : fixed_motor(p, i))));
    return converted;
}

// Points as somebody's code sees them who knows the layout when it is compiled: Stride scalars from one to the next,
// or an array a component if Stride is 0.
template <class T, int Stride> struct points {
    T *__restrict x, *__restrict y, *__restrict z;

    template <class V> V load(std::size_t i) const
    {
        if constexpr (Stride == 0)
            return V(x[i], y[i], z[i]);
        else
            return V(x[Stride * i], x[Stride * i + 1], x[Stride * i + 2]);
    }
    template <class V> void store(std::size_t i, const V &p) const
    {
        T *const at = x + Stride * i;
        (Stride == 0 ? x[i] : at[0]) = p[0];
        (Stride == 0 ? y[i] : at[1]) = p[1];
        (Stride == 0 ? z[i] : at[2]) = p[2];
    }
};

template <int Stride, class T> points<T, Stride> points_of(const array<T> &a, std::size_t component = 0)
{
    T *const *const c = a.component() + component;
    return {c[0], c[1], c[2]};
}

// Calls visit with the stride that the points of a layout have when it is compiled, as an std::integral_constant:
// elements of so many scalars.
template <int Scalars, class F> work with_stride(layout kind, F visit)
{
    switch (kind) {
    case layout::soa: return visit(std::integral_constant<int, 0>());
    case layout::packed: return visit(std::integral_constant<int, Scalars>());
    case layout::strided: return visit(std::integral_constant<int, PLAIN_VERTEX_STRIDE>());
    case layout::columns: return {};
    }
    return {};
}

// out[i] = map(i, in[i]) over the points of a problem, as vectors of the type V. A map is copied in the call, so that
// compilers see that no result is stored over it, and may keep it in registers.
template <class V, class T, class F> work move_points(const problem<T> &p, F map)
{
    return with_stride<3>(p.kind, [&](auto stride) {
        const auto in = points_of<stride>(p.in[0]), out = points_of<stride>(p.out[0]);
        return make_work([=, count = p.count] {
            const F move = map;
            for (std::size_t i = 0; i < count; ++i)
                out.store(i, move(i, in.template load<V>(i)));
        });
    });
}

// out[m][i] = map_of(m)(i, in[i]), pose by pose, over the points of a grid.
template <class V, class T, class F> work move_poses(const problem<T> &p, F map_of)
{
    return with_stride<3>(p.kind, [&](auto stride) {
        const auto in = points_of<stride>(p.in[0]), out = points_of<stride>(p.out[0]);
        return make_work([=, count = p.count] {
            for (std::size_t m = 0; m < shared_motors; ++m) {
                const auto move = map_of(m);
                for (std::size_t i = 0; i < count; ++i)
                    out.store(m * count + i, move(i, in.template load<V>(i)));
            }
        });
    });
}

// Positions and normals of vertices.
template <class V, class T, class F, class G> work move_vertices(const problem<T> &p, F map_position, G map_normal)
{
    return with_stride<6>(p.kind, [&](auto stride) {
        const auto positions = points_of<stride>(p.in[0]), normals = points_of<stride>(p.in[0], 3);
        const auto out_positions = points_of<stride>(p.out[0]), out_normals = points_of<stride>(p.out[0], 3);
        return make_work([=, count = p.count] {
            const F move_position = map_position;
            const G move_normal = map_normal;
            for (std::size_t i = 0; i < count; ++i) {
                out_positions.store(i, move_position(i, positions.template load<V>(i)));
                out_normals.store(i, move_normal(i, normals.template load<V>(i)));
            }
        });
    });
}

} // namespace motorway::bench
