// The loops of plain.c on the data of a problem: matrices, quaternions with translations and dual quaternions are
// made beforehand; those of an element in arrays of the same layout.
#include "baseline_plain.h"

#include "motions.h"
#include "rigid.h"

#include <algorithm>
#include <memory>

namespace motorway::bench {
namespace {

// The members of a table by precision.
template <class T, class M> struct plain;
#define MOTORWAY_PLAIN_PRECISION(T, M, precision, LOOPS)                                                             \
    template <> struct plain<T, M> {                                                                                 \
        using arguments = plain_arguments_##precision;                                                               \
        using loop = plain_loop_##precision;                                                                         \
        static loop columns(const plain_table &table) { return table.columns_##precision; }                          \
        static const plain_layouts_##precision *find(const plain_table &table, const std::string &kernel)            \
        {                                                                                                            \
            LOOPS(MOTORWAY_FIND_##precision)                                                                         \
            return nullptr;                                                                                          \
        }                                                                                                            \
    };
#define MOTORWAY_FIND(name, precision)                                                                               \
    if (kernel == #name)                                                                                             \
        return &table.name##_##precision;
#define MOTORWAY_FIND_f32(name) MOTORWAY_FIND(name, f32)
#define MOTORWAY_FIND_f64(name) MOTORWAY_FIND(name, f64)
#define MOTORWAY_FIND_mixed(name) MOTORWAY_FIND(name, mixed)
#define MOTORWAY_ALL_LOOPS(X) PLAIN_POINT_LOOPS(X) PLAIN_OTHER_LOOPS(X)
MOTORWAY_PLAIN_PRECISION(float, float, f32, MOTORWAY_ALL_LOOPS)
MOTORWAY_PLAIN_PRECISION(double, double, f64, MOTORWAY_ALL_LOOPS)
MOTORWAY_PLAIN_PRECISION(float, double, mixed, PLAIN_POINT_LOOPS)

template <class T, class M>
typename plain<T, M>::loop find_loop(const plain_table &table, const problem<T, M> &p)
{
    const auto *const layouts = plain<T, M>::find(table, p.kernel);
    if (!layouts)
        return nullptr;
    switch (p.kind) {
    case layout::soa: return layouts->soa;
    case layout::packed: return layouts->packed;
    case layout::strided: return layouts->strided;
    case layout::columns: return p.kernel == "apply_point_grid" ? plain<T, M>::columns(table) : nullptr;
    }
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

// The motion of a motor; in mixed precision, with its shift.
template <class T, class M> rigid motion_of(const std::array<double, 8> &motor)
{
    rigid r = rigid_of(motor);
    if constexpr (!std::is_same_v<T, M>) {
        const shift shift;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                r.translation[row] -= r.rotation[row][column] * shift.before[column];
            r.translation[row] += shift.after[row];
        }
    }
    return r;
}

std::array<double, 7> quaternion_and_translation(const rigid &r)
{
    const double *q = r.quaternion, *t = r.translation;
    return {q[0], q[1], q[2], q[3], t[0], t[1], t[2]};
}

std::array<double, 12> matrix(const rigid &r)
{
    std::array<double, 12> m;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            m[4 * row + column] = r.rotation[row][column];
        m[4 * row + 3] = r.translation[row];
    }
    return m;
}

// The weights of the controls of a span, as polynomials of the place within it by ascending powers: the blossom
// recursion, run backwards from the result.
std::array<std::array<double, 4>, 4> weight_polynomials(const std::vector<double> &knots, std::size_t span)
{
    static_assert(motion_degree == 3 && PLAIN_CONTROLS == spline_controls);
    std::array<std::array<double, 4>, 4> weights{{{1}}};
    const std::size_t begin = span + motion_degree - 1;
    const double length = knots[begin + 1] - knots[begin];
    for (std::size_t level = 1; level <= motion_degree; ++level)
        for (std::size_t k = level; k-- > 0;) {
            const double left = knots[begin + 1 + k - level], right = knots[begin + 1 + k];
            const double ratio = (knots[begin] - left) / (right - left), slope = length / (right - left);
            const auto whole = weights[k];
            for (std::size_t power = 0; power < 4; ++power) {
                const double later = ratio * whole[power] + (power ? slope * whole[power - 1] : 0);
                weights[k + 1][power] += later;
                weights[k][power] -= later;
            }
        }
    return weights;
}

template <class T> std::vector<T> all_weight_polynomials()
{
    const std::vector<double> knots = motion_knots<double>(spline_controls);
    std::vector<T> all;
    for (std::size_t span = 0; span < PLAIN_SPANS; ++span)
        for (const auto &polynomial : weight_polynomials(knots, span))
            for (double coefficient : polynomial)
                all.push_back(static_cast<T>(coefficient));
    return all;
}

// What a loop runs on, beside the elements and the results of the problem.
template <class T, class M> struct operands {
    std::vector<array<T>> duals; // converted inputs, and the output behind them if it is to be converted back
    std::vector<array<M>> rigids;
    std::vector<T *const *> in;
    std::vector<M> fixed, controls, polynomials;
    typename plain<T, M>::arguments arguments{};
};

template <class T, class M> void prepare_apply(operands<T, M> &o, const problem<T, M> &p)
{
    for (std::size_t i = 0; i < p.fixed.size() / 8; ++i)
        for (double coefficient : matrix(motion_of<T, M>(fixed_motor(p, i))))
            o.fixed.push_back(static_cast<M>(coefficient));
    if (p.motors) {
        o.rigids.push_back({7, 7, p.kind == layout::soa ? layout::soa : layout::packed, p.count, 3});
        convert_array(o.rigids[0], *p.motors, p.count, [](const std::array<double, 8> &motor) {
            return quaternion_and_translation(motion_of<T, M>(motor));
        });
        o.arguments.rigids = o.rigids[0].component();
    }
    o.in.push_back(p.in[0].component());
    o.arguments.out = p.out[0].component();
}

// An array of as many components, laid out like another.
template <class T> array<T> array_like(const array<T> &other, const problem<T> &p, std::size_t place)
{
    return {other.components(), other.stride() / sizeof(T), p.kind, p.elements, place};
}

template <class T> std::vector<T> dual_quaternions_of(const std::vector<T> &motors)
{
    std::array<T, 8> motor;
    std::vector<T> duals;
    duals.reserve(motors.size());
    for (auto first = motors.begin(); first != motors.end(); first += motor.size()) {
        std::copy_n(first, motor.size(), motor.begin());
        for (T component : dual_quaternion_of(motor))
            duals.push_back(component);
    }
    return duals;
}

// Whether many motions are sampled at one parameter.
template <class T> bool is_shared(const problem<T> &p) { return p.in.empty() && !p.controls.empty(); }

template <class T> void prepare_motors(operands<T, T> &o, const problem<T> &p)
{
    constexpr std::size_t components = 8;
    std::size_t place = components;
    for (const auto &in : p.in) {
        if (in.components() == components) {
            o.duals.push_back(array_like(in, p, place));
            convert_array(o.duals.back(), in, p.elements, dual_quaternion_of<double>);
            o.in.push_back(o.duals.back().component());
        } else
            o.in.push_back(in.component()); // weights
        place += in.components();
    }
    o.fixed = dual_quaternions_of(p.fixed);
    o.controls = dual_quaternions_of(p.controls);
    if (!o.controls.empty())
        o.polynomials = all_weight_polynomials<T>();
    for (std::size_t k = 0; is_shared(p) && k < spline_controls; ++k) {
        o.duals.push_back(array_like(p.out[0], p, place));
        o.in.push_back(o.duals.back().component());
        place += components;
        for (std::size_t i = 0; i < p.elements; ++i)
            for (std::size_t c = 0; c < components; ++c)
                o.duals.back().at(c, i) = o.controls[components * (spline_controls * i + k) + c];
    }
    o.duals.push_back(array_like(p.out[0], p, 0));
    o.arguments.out = o.duals.back().component();
}

template <class T> void publish(const array<T> &result, const problem<T> &p)
{
    for (std::size_t i = 0; i < p.elements; ++i) {
        std::array<T, 8> q;
        for (std::size_t k = 0; k < q.size(); ++k)
            q[k] = result.at(k, i);
        const auto motor = motor_of(q);
        for (std::size_t k = 0; k < motor.size(); ++k)
            p.out[0].at(k, i) = motor[k];
    }
}

template <class T, class M> std::function<void()> prepare(const std::shared_ptr<operands<T, M>> &o,
                                                          const problem<T, M> &p)
{
    if constexpr (std::is_same_v<T, M>)
        if (p.out[0].components() == 8) {
            prepare_motors(*o, p);
            return [=, &p] { publish(o->duals.back(), p); };
        }
    prepare_apply(*o, p);
    return {};
}

} // namespace

template <class T, class M> work bind_plain(const plain_table &table, const problem<T, M> &p)
{
    const auto loop = find_loop(table, p);
    if (!loop)
        return {};
    const auto o = std::make_shared<operands<T, M>>();
    const auto publish_results = prepare(o, p);
    o->arguments.in = o->in.data();
    o->arguments.fixed = o->fixed.data();
    o->arguments.indices = p.indices.data();
    o->arguments.parents = p.parents.data();
    o->arguments.controls = o->controls.data();
    o->arguments.polynomials = o->polynomials.data();
    o->arguments.parameter = static_cast<M>(shared_parameter);
    o->arguments.count = p.count;
    return make_work([=] { loop(&o->arguments); }, publish_results);
}

template work bind_plain(const plain_table &, const problem<float> &);
template work bind_plain(const plain_table &, const problem<double> &);
template work bind_plain(const plain_table &, const problem<float, double> &);

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
