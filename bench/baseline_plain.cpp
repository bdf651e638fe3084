// The loops of plain.c on the data of a problem: matrices, quaternions with translations and dual quaternions are
// made beforehand, in arrays of the same layout.
#include "baseline_plain.h"

#include "rigid.h"

#include <algorithm>
#include <memory>

namespace motorway::bench {
namespace {

template <class T> using loop = std::conditional_t<sizeof(T) == sizeof(float), plain_loop_f32, plain_loop_f64>;

template <class T, class Layouts> loop<T> loop_for(const Layouts &layouts, layout kind)
{
    switch (kind) {
    case layout::soa: return layouts.soa;
    case layout::packed: return layouts.packed;
    case layout::strided: return layouts.strided;
    }
    return nullptr;
}

template <class T> loop<T> find_loop(const plain_table &table, const problem<T> &p)
{
#define MOTORWAY_FIND(name)                                                                                          \
    if (p.kernel == #name) {                                                                                         \
        if constexpr (sizeof(T) == sizeof(float))                                                                    \
            return loop_for<T>(table.name##_f32, p.kind);                                                            \
        else                                                                                                         \
            return loop_for<T>(table.name##_f64, p.kind);                                                            \
    }
    PLAIN_LOOPS(MOTORWAY_FIND)
#undef MOTORWAY_FIND
    return nullptr;
}

// Component k of element i from convert(motor i)[k].
template <class T, class F>
void convert_array(const array<T> &to, const array<T> &motors, std::size_t count, F convert)
{
    for (std::size_t i = 0; i < count; ++i) {
        const auto converted = convert(motor_at(motors, i));
        for (std::size_t k = 0; k < to.components(); ++k)
            to.at(k, i) = static_cast<T>(converted[k]);
    }
}

std::array<double, 7> quaternion_and_translation(const std::array<double, 8> &motor)
{
    const rigid r = rigid_of(motor);
    const double *q = r.quaternion, *t = r.translation;
    return {q[0], q[1], q[2], q[3], t[0], t[1], t[2]};
}

std::array<double, 12> matrix(const std::array<double, 8> &motor)
{
    const rigid r = rigid_of(motor);
    std::array<double, 12> m;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            m[4 * row + column] = r.rotation[row][column];
        m[4 * row + 3] = r.translation[row];
    }
    return m;
}

// What a loop runs on, beside the points of the problem.
template <class T> struct operands {
    std::vector<array<T>> converted;
    std::vector<T *const *> in;
    std::vector<T> fixed;
    std::vector<array<T>> out; // one array if the result is dual quaternions, else none

    void add(array<T> array)
    {
        converted.push_back(std::move(array));
        in.push_back(converted.back().component());
    }
};

// An array of as many components, laid out like another.
template <class T> array<T> array_like(const array<T> &other, const problem<T> &p, std::size_t place)
{
    return {other.components(), other.stride() / sizeof(T), p.kind, p.count, place};
}

template <class T> void prepare_apply(operands<T> &o, const problem<T> &p)
{
    if (p.in.size() == 1) {
        for (double coefficient : matrix(fixed_motor(p)))
            o.fixed.push_back(static_cast<T>(coefficient));
    } else {
        o.add({7, 7, p.kind, p.count, 3});
        convert_array(o.converted.back(), p.in[0], p.count, quaternion_and_translation);
    }
    o.in.push_back(p.in.back().component());
}

template <class T> void prepare_motors(operands<T> &o, const problem<T> &p)
{
    constexpr std::size_t components = 8;
    std::size_t place = components;
    for (const auto &in : p.in) {
        if (in.components() == components) {
            o.add(array_like(in, p, place));
            convert_array(o.converted.back(), in, p.count, dual_quaternion_of<double>);
        } else
            o.in.push_back(in.component()); // weights
        place += in.components();
    }
    for (std::size_t first = 0; first < p.fixed.size(); first += components) {
        std::array<T, components> motor;
        std::copy_n(p.fixed.begin() + static_cast<std::ptrdiff_t>(first), components, motor.begin());
        for (T component : dual_quaternion_of(motor))
            o.fixed.push_back(component);
    }
    o.out.push_back(array_like(p.out, p, 0));
}

template <class T> void publish(const array<T> &result, const problem<T> &p)
{
    for (std::size_t i = 0; i < p.count; ++i) {
        std::array<T, 8> q;
        for (std::size_t k = 0; k < q.size(); ++k)
            q[k] = result.at(k, i);
        const auto motor = motor_of(q);
        for (std::size_t k = 0; k < motor.size(); ++k)
            p.out.at(k, i) = motor[k];
    }
}

} // namespace

template <class T> work bind_plain(const plain_table &table, const problem<T> &p)
{
    const auto loop = find_loop(table, p);
    if (!loop)
        return {};
    const auto o = std::make_shared<operands<T>>();
    o->converted.reserve(p.in.size());
    const bool gives_points = p.out.components() == 3;
    gives_points ? prepare_apply(*o, p) : prepare_motors(*o, p);
    T *const *const out = gives_points ? p.out.component() : o->out[0].component();
    return make_work([=, count = p.count] { loop(out, o->in.data(), o->fixed.data(), count); },
                     gives_points ? std::function<void()>() : [=, &p] { publish(o->out[0], p); });
}

template work bind_plain(const plain_table &, const problem<float> &);
template work bind_plain(const plain_table &, const problem<double> &);

bool can_run(const plain_table &table)
{
#if defined(__x86_64__) || defined(__i386__)
    return (!table.needs_avx2 || (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))) &&
           (!table.needs_avx512 || __builtin_cpu_supports("avx512f"));
#else
    return !table.needs_avx2 && !table.needs_avx512;
#endif
}

} // namespace motorway::bench
