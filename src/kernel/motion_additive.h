// Poses of additive motions: the usual and the cheapest case, in which finding things would cost more than blending them.
#pragma once

#include "motion_span.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// make_weights for the usual degrees, in the same order with everything in registers; number(i) is that of the span.
template <int Degree, class V, class Number> inline void make_few_weights(const V &u, const Number &number, V *weight)
{
    using T = scalar_of<V>;
    weight[0] = V(T(1)) - u;
    weight[1] = u;
    int ratio = 2;
    for (int r = 2; r <= Degree; ratio += 2 * r, ++r) {
        weight[r] = V(T(0));
        for (int k = r; k-- > 0;) {
            const V a = fma(u, number(ratio + 2 * k), number(ratio + 2 * k + 1));
            weight[k + 1] = fma(weight[k], a, weight[k + 1]);
            weight[k] = fnma(weight[k], a, weight[k]);
        }
    }
}

// A run of samples from number i on whose parameters go from span to span: whole registers in one span, and where one is
// in this and the next, what comes before the first of the next, which then begins a register. Where it ends.
template <int Degree, class T, class Stream>
inline std::size_t blend_run(const motion_call<T> &call, std::size_t index, const Stream &out, std::size_t i)
{
    using V = vector<T>;
    const motion_call<T> c = call; // stores could change the original for all that the compiler knows
    for (;; ++index) {
        const span_bounds<T> bounds(c, index);
        const T *const span = c.spans + c.span_size * index;
        const T *const row = c.rows + std::size_t(motor_size) * c.first[index];
        const auto blend = [&](const V &t, V *sum) {
            const V local = (t - V(span[0])) * V(span[1]), u = if_less(local, V(T(1)), local, V(T(1)));
            V weight[Degree + 1];
            make_few_weights<Degree>(u, [&](int n) { return V(span[n]); }, weight);
            for (int n = 0; n < motor_size; ++n) {
                sum[n] = V(T(0));
                for (int k = 0; k <= Degree; ++k)
                    sum[n] = fma(weight[k], V(row[motor_size * k + n]), sum[n]);
            }
        };
        V t, sum[motor_size];
        for (;; i += width<T>) {
            if (c.count - i < width<T>)
                return i;
            t = into_domain(c, load(c.parameters + i));
            if (!bounds.hold(t))
                break;
            blend(t, sum);
            out.store(i, sum);
        }
        if (bounds.has_end || !all_between(t, bounds.begin, c.starts[index + 2]))
            return i;
        if (const int n = bounds.count_held(t)) {
            const V low = if_less(t, V(bounds.begin), V(bounds.begin), t);
            blend(if_less(V(bounds.end), low, V(bounds.end), low), sum);
            out.store(i, sum); // those of the next span are stored again
            i += static_cast<std::size_t>(n);
        }
    }
}
template <class T, class Stream>
inline std::size_t blend_run(const motion_call<T> &c, std::size_t index, const Stream &out, std::size_t i)
{
    switch (c.degree) {
    case 1: return blend_run<1>(c, index, out, i);
    case 2: return blend_run<2>(c, index, out, i);
    case 3: return blend_run<3>(c, index, out, i);
    default: return i;
    }
}
template <class T> inline std::size_t blend_run(const motion_call<T> &c, std::size_t i)
{
    T first[width<T>];
    store(first, into_domain(c, vector<T>(c.parameters[i])));
    const std::size_t index = find_span(c, first[0], cell_of(c, first[0]));
    const stream<T> &out = c.out[0];
    return out.kind == layout::soa      ? blend_run(c, index, soa_stream<T, motor_size>(out), i)
           : out.kind == layout::packed ? blend_run(c, index, packed_stream<T, motor_size>(out), i)
                                        : i;
}

template <int Degree> constexpr int few_span_size = (Degree * (Degree + 1) + 3) / 4 * 4; // numbers of a span

// A register of motors that are adjacent.
template <class T> inline void load_packed(T (&motors)[width<T>][motor_size], vector<T> *v)
{
    T *first[] = {motors[0]};
    packed_stream<T, motor_size>(stream<T>{first, motor_size * sizeof(T), layout::packed}).load(0, v);
}

// Samples that have their controls in different places: the controls of each are blended as they lie in memory, which
// takes at most one transposition, and not one a control.
template <int Degree, class T> inline void blend_apart(const place<T> &where, const vector<T> &u, T *to)
{
    constexpr int parts = motor_parts<T>, size = motor_size / parts;
    vector<T> number[few_span_size<Degree>], weight[Degree + 1];
    where.template load_span<few_span_size<Degree>>(number);
    make_few_weights<Degree>(u, [&](int n) { return number[n]; }, weight);
    T weights[Degree + 1][width<T>];
    for (int k = 0; k <= Degree; ++k)
        store(weights[k], weight[k]);
    for (int lane = 0; lane < width<T>; ++lane, to += motor_size) {
        const T *const row = where.row_of(lane);
        for (int p = 0; p < parts; ++p) {
            motor_part<T> blend(T(0));
            for (int k = 0; k <= Degree; ++k)
                blend = fma(motor_part<T>(weights[k][lane]), load_motor_part(row + motor_size * k + size * p), blend);
            store_motor_part(to + size * p, blend);
        }
    }
}
template <class T>
inline void blend_apart(std::size_t degree, const place<T> &where, const vector<T> &u, T *to)
{
    switch (degree) {
    case 1: return blend_apart<1>(where, u, to);
    case 2: return blend_apart<2>(where, u, to);
    default: return blend_apart<3>(where, u, to);
    }
}
constexpr std::size_t most_few = 3; // the degrees of make_few_weights

// Whole registers of many motions at one parameter: their controls are blended as above, with the same weights for all.
// Where it ends.
template <int Degree, class T>
inline std::size_t blend_crowd(const motion_call<T> &call, const result_stream<T, motor_size> &out)
{
    const motion_call<T> c = call; // stores could change the original for all that the compiler knows
    constexpr int parts = motor_parts<T>, size = motor_size / parts;
    const vector<T> t = into_domain(c, vector<T>(c.parameters[0]));
    place<T> where;
    where.find(c, 0, 1, t);
    vector<T> number[few_span_size<Degree>], weight[Degree + 1];
    where.template load_span<few_span_size<Degree>>(number);
    make_few_weights<Degree>(where.local_parameter(t).value, [&](int n) { return number[n]; }, weight);
    motor_part<T> weights[Degree + 1];
    for (int k = 0; k <= Degree; ++k) {
        T lanes[width<T>];
        store(lanes, weight[k]);
        weights[k] = motor_part<T>(lanes[0]);
    }
    const bool is_packed = c.out[0].kind == layout::packed;
    const T *row = where.row_of(0);
    T sum[width<T>][motor_size];
    std::size_t i = 0;
    for (; c.count - i >= width<T>; i += width<T>) {
        T *const to = is_packed ? c.out[0].component[0] + motor_size * i : sum[0];
        for (int lane = 0; lane < width<T>; ++lane, row += c.motion_stride)
            for (int p = 0; p < parts; ++p) {
                motor_part<T> blend(T(0));
                for (int k = 0; k <= Degree; ++k)
                    blend = fma(weights[k], load_motor_part(row + motor_size * k + size * p), blend);
                store_motor_part(to + motor_size * lane + size * p, blend);
            }
        if (!is_packed) {
            vector<T> pose[motor_size];
            load_packed(sum, pose);
            out.store(i, width<T>, pose);
        }
    }
    return i;
}
template <class T>
inline std::size_t blend_crowd(const motion_call<T> &c, const result_stream<T, motor_size> &out)
{
    switch (c.one_parameter ? c.degree : 0) {
    case 1: return blend_crowd<1>(c, out);
    case 2: return blend_crowd<2>(c, out);
    case 3: return blend_crowd<3>(c, out);
    default: return 0;
    }
}

// A register of samples from number i on, wherever they are; how many.
template <class T>
inline std::size_t sample_apart(const motion_call<T> &c, const result_stream<T, motor_size> &out, std::size_t i)
{
    place<T> where;
    const int n = c.count - i < width<T> ? static_cast<int>(c.count - i) : width<T>;
    const vector<T> t = into_domain(c, load_parameters(c, i, n));
    where.find(c, i, n, t);
    const vector<T> u = where.local_parameter(t).value;
    vector<T> pose[motor_size];
    if (c.degree > most_few) {
        blend_rows(c.degree, where, u, pose);
        out.store(i, n, pose);
    } else if (n == width<T> && c.out[0].kind == layout::packed)
        blend_apart(c.degree, where, u, c.out[0].component[0] + motor_size * i);
    else {
        T sum[width<T>][motor_size];
        blend_apart(c.degree, where, u, sum[0]);
        load_packed(sum, pose);
        out.store(i, n, pose);
    }
    return static_cast<std::size_t>(n);
}

// Additive motions, of which runs of parameters between the same two knots are the usual and the fastest case.
template <class T> MOTORWAY_LOOP void run_additive_motion(const motion_call<T> &c)
{
    const result_stream<T, motor_size> out(c.out[0]);
    for (std::size_t i = blend_crowd(c, out); i < c.count;) {
        const std::size_t end = c.motion_stride == 0 ? blend_run(c, i) : i;
        i = end != i ? end : i + sample_apart(c, out, i);
    }
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
