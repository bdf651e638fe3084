// Where the samples of a motion find what they are made of: the span of every parameter of a register, and the weights of
// its controls.
#pragma once

#include "jet.h"
#include "streams.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

constexpr int max_degree = 31;

// ------------------------------------------------------------------------------------------------------- spans

// The parameter in the domain, if it was sound.
template <class T> inline vector<T> into_domain(const motion_call<T> &c, const vector<T> &t)
{
    using V = vector<T>;
    if (c.treatment == outside::none)
        return t;
    V inside = t;
    if (c.treatment == outside::wrap) {
        const V from_begin = t - V(c.begin), period(c.end - c.begin);
        const V moved = fnma(nearest(from_begin / period), period, t);
        const V wrapped = if_less(moved, V(c.begin), moved + period, moved);
        inside = if_less(t, V(c.begin), wrapped, if_less(V(c.end), t, wrapped, t));
    }
    // What is too large to be wrapped is NaN by now, and goes to the begin.
    const V low = if_less(V(c.begin), inside, inside, V(c.begin));
    return if_less(low, V(c.end), low, V(c.end));
}

// The parameters from number i on; lanes from n on repeat the last.
template <class T> inline vector<T> load_parameters(const motion_call<T> &c, std::size_t i, int n)
{
    if (c.one_parameter)
        return vector<T>(c.parameters[0]);
    if (n == width<T>)
        return load(c.parameters + i);
    T lanes[width<T>];
    for (int lane = 0; lane < width<T>; ++lane)
        lanes[lane] = c.parameters[i + static_cast<std::size_t>(lane < n ? lane : n - 1)];
    return load(static_cast<const T *>(lanes));
}

// The span of a parameter, which is in cell number `at`. That knows a span at or before its own, almost always that or
// the next.
template <class V, class T> inline V cell_of(const motion_call<T> &c, const V &t)
{
    return (t - V(c.begin)) * V(c.cells_per_unit);
}
template <class T> inline std::size_t find_span(const motion_call<T> &c, T t, T at)
{
    const auto rounded = static_cast<std::ptrdiff_t>(at); // at least 0 in the domain
    const std::size_t cell = std::size_t(rounded) < c.cell_count ? std::size_t(rounded) : c.cell_count - 1;
    const std::size_t last = c.span_count - 1;
    std::size_t low = c.cells[cell];
    low += static_cast<std::size_t>(c.starts[low + 1] <= t);
    if (low >= last || t < c.starts[low + 1])
        return low < last ? low : last;
    std::size_t high = c.cells[cell + 2 < c.cell_count ? cell + 2 : c.cell_count];
    while (low < high) {
        const std::size_t middle = (low + high + 1) / 2;
        if (c.starts[middle] <= t)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

// The parameters of a span.
template <class T> struct span_bounds {
    T begin = T(0), end = T(0);
    bool has_end = false; // the last

    span_bounds() = default;
    span_bounds(const motion_call<T> &c, std::size_t span)
        : begin(c.starts[span]), end(c.starts[span + 1]), has_end(span + 1 == c.span_count)
    {
    }
    bool hold(const vector<T> &t) const { return has_end ? all_between(t, begin, end) : all_within(t, begin, end); }
    // How many of a register do, before the first that does not.
    int count_held(const vector<T> &t) const
    {
        T parameter[width<T>];
        store(parameter, t);
        int n = 0;
        while (n < width<T> && begin <= parameter[n] && (has_end ? parameter[n] <= end : parameter[n] < end))
            ++n;
        return n;
    }
};

// Where the samples of a register find what they are made of: all in the same place, or each in its own.
template <class T> class place {
    using V = vector<T>;
    static constexpr int W = width<T>;
    bool same_span = false, same_rows = false;
    const T *span[W], *row[W], *base[W];

    template <int N> static void load_from(bool same, const T *const *from, std::size_t offset, V *v)
    {
        if (same)
            for (int n = 0; n < N; ++n)
                v[n] = V(from[0][offset + n]);
        else
            load_elements<N, T>(v, [=](int lane) { return from[lane] + offset; });
    }

public:
    const T *row_of(int lane) const { return row[lane]; }

    // Elements i ... of parameters t; lanes from n on repeat the last.
    void find(const motion_call<T> &c, std::size_t i, int n, const V &t)
    {
        T parameter[W], cell[W];
        store(parameter, t);
        store(cell, cell_of(c, t));
        std::size_t index[W] = {find_span(c, parameter[0], cell[0])};
        bool same = true;
        for (int lane = 1; lane < W; ++lane) {
            index[lane] = c.one_parameter ? index[0] : find_span(c, parameter[lane], cell[lane]);
            same &= index[lane] == index[0];
        }
        for (int lane = 0; lane < W; ++lane) {
            const std::size_t motion = i + static_cast<std::size_t>(lane < n ? lane : n - 1);
            const std::size_t first = std::size_t(motor_size) * c.first[index[lane]];
            span[lane] = c.spans + c.span_size * index[lane];
            row[lane] = c.rows + c.motion_stride * motion + first;
            base[lane] = c.bases + (c.base_per_row ? c.motion_stride * motion + first : 0);
        }
        same_span = same;
        same_rows = same && c.motion_stride == 0;
        bounds = span_bounds<T>(c, index[0]);
        first_number = std::size_t(motor_size) * c.first[index[0]];
    }

    // Whether these parameters are in the same span; then the place of elements i ... of them.
    bool holds(const V &t) const { return same_span && bounds.hold(t); }
    void move_to(const motion_call<T> &c, std::size_t i, int n)
    {
        if (same_rows)
            return;
        const std::size_t base_stride = c.base_per_row ? c.motion_stride : 0;
        row[0] = c.rows + c.motion_stride * i + first_number;
        base[0] = c.bases + base_stride * i + (c.base_per_row ? first_number : 0);
        for (int lane = 1; lane < W; ++lane) {
            row[lane] = row[lane - 1] + (lane < n ? c.motion_stride : 0);
            base[lane] = base[lane - 1] + (lane < n ? base_stride : 0);
        }
    }

    // From 0 to 1, and its derivative.
    jet<V> local_parameter(const V &t) const
    {
        V v[2];
        load_from<2>(same_span, span, 0, v);
        const V u = (t - v[0]) * v[1], one(T(1));
        return {if_less(u, one, u, one), v[1]};
    }
    // Factor and summand of a ratio, counted from level 2 on.
    void load_ratio(std::size_t number, V *v) const { load_from<2>(same_span, span, 2 + 2 * number, v); }
    // All numbers of a span.
    template <int N> void load_span(V *v) const
    {
        for (int n = 0; n < N; n += 4)
            load_from<4>(same_span, span, static_cast<std::size_t>(n), v + n);
    }
    void load_row(std::size_t k, V *v) const { load_from<motor_size>(same_rows, row, motor_size * k, v); }
    void load_base(V *v) const { load_from<motor_size>(same_rows, base, 0, v); }

private:
    span_bounds<T> bounds;
    std::size_t first_number = 0;
};

// ----------------------------------------------------------------------------------------------------- weights

// A vector, or a jet of vectors: what a scheme computes with.
template <class V> inline const V &value_of(const V &a) { return a; }
template <class V> inline const V &value_of(const jet<V> &a) { return a.value; }

// factor u + summand
template <class V> inline V ratio(const V &u, const V *v) { return fma(u, v[0], v[1]); }
template <class V> inline jet<V> ratio(const jet<V> &u, const V *v)
{
    return {fma(u.value, v[0], v[1]), u.derivative * v[0]};
}

// Level r of the blossom recursion combines neighbours k and k + 1 in this ratio. Ratios are counted from level 2 on.
template <class T, class N> inline N ratio_of(const place<T> &where, const N &u, std::size_t level, std::size_t k)
{
    if (level == 1)
        return u;
    vector<T> v[2];
    where.load_ratio(level * (level - 1) / 2 - 1 + k, v);
    return ratio(u, v);
}

// The weights of the controls: the recursion run backwards from the result, where it acts on weights and not on motors.
template <class T, class N>
inline void make_weights(std::size_t degree, const place<T> &where, const N &u, N *weight)
{
    weight[0] = N(T(1)) - u;
    weight[1] = u;
    for (std::size_t r = 2; r <= degree; ++r) {
        weight[r] = N(T(0));
        for (std::size_t k = r; k-- > 0;) {
            const N a = ratio_of(where, u, r, k);
            weight[k + 1] = fma(weight[k], a, weight[k + 1]);
            weight[k] = fnma(weight[k], a, weight[k]);
        }
    }
}

// A blend of rows, and with jets its derivative.
template <class V> inline void add_term(const V &weight, const V *row, V *sum)
{
    for (int n = 0; n < motor_size; ++n)
        sum[n] = fma(weight, row[n], sum[n]);
}
template <class V> inline void add_term(const jet<V> &weight, const V *row, jet<V> *sum)
{
    for (int n = 0; n < motor_size; ++n)
        sum[n] = {fma(weight.value, row[n], sum[n].value), fma(weight.derivative, row[n], sum[n].derivative)};
}
template <class T, class N> inline void blend_rows(std::size_t degree, const place<T> &where, const N &u, N *sum)
{
    N weight[max_degree + 1];
    make_weights(degree, where, u, weight);
    for (int n = 0; n < motor_size; ++n)
        sum[n] = N(T(0));
    for (std::size_t k = 0; k <= degree; ++k) {
        vector<T> row[motor_size];
        where.load_row(k, row);
        add_term(weight[k], row, sum);
    }
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
