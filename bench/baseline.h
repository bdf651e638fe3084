// What one would use instead. Every baseline binds itself to the problems that it can solve: baseline_<library>.cpp
// holds its bind_<library>, which returns an empty work for the others.
#pragma once

#include "plain.h"
#include "problem.h"
#include "rigid.h"
#include "work.h"

#include <array>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace motorway::bench {

template <class T> struct baseline {
    std::string name; // "eigen"
    std::function<work(const problem<T> &)> bind;
};

// Those that are compiled in and that this CPU runs, and the names of those that it does not.
template <class T> const std::vector<baseline<T>> &baselines();
std::vector<std::string> skipped_baselines();

// ------------------------------------------------------------------- helpers of baselines that work on single points

template <class T> std::array<double, 8> motor_at(const array<T> &motors, std::size_t i)
{
    std::array<double, 8> motor;
    for (std::size_t k = 0; k < 8; ++k)
        motor[k] = static_cast<double>(motors.at(k, i));
    return motor;
}

template <class T> std::array<double, 8> fixed_motor(const problem<T> &p)
{
    std::array<double, 8> motor;
    for (std::size_t k = 0; k < 8; ++k)
        motor[k] = static_cast<double>(p.fixed[k]);
    return motor;
}

// What a library holds for the motors of an `each` kernel: make(rigid) of every one, in an array.
template <class T, class F> auto convert_motors(const array<T> &motors, std::size_t count, F make)
{
    using element = std::decay_t<decltype(make(rigid()))>;
    auto converted = std::make_shared<std::vector<element>>();
    converted->reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        converted->push_back(make(rigid_of(motor_at(motors, i))));
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

template <int Stride, class V, class T, class F> work move_points_at(const problem<T> &p, F map)
{
    const auto view = [](const array<T> &a) {
        return points<T, Stride>{a.component()[0], a.component()[1], a.component()[2]};
    };
    return make_work([map, in = view(p.in.back()), out = view(p.out), count = p.count] {
        for (std::size_t i = 0; i < count; ++i)
            out.store(i, map(i, in.template load<V>(i)));
    });
}

// out[i] = map(i, in[i]) over the points of a problem, as vectors of the type V.
template <class V, class T, class F> work move_points(const problem<T> &p, F map)
{
    switch (p.kind) {
    case layout::soa: return move_points_at<0, V>(p, map);
    case layout::packed: return move_points_at<3, V>(p, map);
    case layout::strided: return move_points_at<PLAIN_POINT_STRIDE, V>(p, map);
    }
    return {};
}

} // namespace motorway::bench
