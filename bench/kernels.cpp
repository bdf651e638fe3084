#include "kernels.h"

#include "motorway.hpp"

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

namespace motorway::bench {
namespace {

// The views of the API.
template <class T> auto xyz(const array<T> &a)
{
    const auto c = a.component();
    return typename detail::types<T>::xyz{c[0], c[1], c[2], a.stride()};
}
template <class T> auto motors_view(const array<T> &a)
{
    const auto c = a.component();
    return typename detail::types<T>::motors{c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], a.stride()};
}
template <class T> const motor<T> *fixed_motors(const problem<T> &p)
{
    return reinterpret_cast<const motor<T> *>(p.fixed.data());
}

void require(status result)
{
    if (result != MW_OK)
        throw std::runtime_error(mw_status_text(result));
}

template <class T, class F> work motor_to_each(const problem<T> &p, F function, unsigned flags)
{
    const const_motors<T> motors = motors_view(p.in[0]);
    const const_xyz<T> in = xyz(p.in[1]);
    return make_work([=, out = xyz(p.out), count = p.count] { require(function(out, motors, in, count, flags)); });
}

// What the rows are made of: the arguments, and a function that binds the kernel to a problem.
template <class T> struct kernel {
    bench::arguments arguments;
    work (*bind)(const problem<T> &);
};

const arguments one_to_xyz = {operand::xyz, {operand::xyz}, 1, motors::unit};
const arguments each_to_xyz = {operand::xyz, {operand::motor, operand::xyz}, 0, motors::unit};

template <class T> kernel<T> kernel_of_apply_point_one()
{
    return {one_to_xyz, [](const problem<T> &p) {
                const const_xyz<T> in = xyz(p.in[0]);
                return make_work([=, out = xyz(p.out), motor = fixed_motors(p), count = p.count] {
                    require(apply_point_one(out, *motor, in, count));
                });
            }};
}

template <class T> kernel<T> kernel_of_apply_direction_one()
{
    return {one_to_xyz, [](const problem<T> &p) {
                const const_xyz<T> in = xyz(p.in[0]);
                return make_work([=, out = xyz(p.out), motor = fixed_motors(p), count = p.count] {
                    require(apply_direction_one(out, *motor, in, count));
                });
            }};
}

#define MOTORWAY_EACH(function) [](auto &&...arguments) { return function(arguments...); }

template <class T> kernel<T> kernel_of_apply_point_each()
{
    return {each_to_xyz,
            [](const problem<T> &p) { return motor_to_each(p, MOTORWAY_EACH(apply_point_each), MW_DEFAULT); }};
}

template <class T> kernel<T> kernel_of_apply_point_each_unit()
{
    return {each_to_xyz,
            [](const problem<T> &p) { return motor_to_each(p, MOTORWAY_EACH(apply_point_each), MW_UNIT_MOTORS); }};
}

template <class T> kernel<T> kernel_of_apply_direction_each()
{
    return {each_to_xyz,
            [](const problem<T> &p) { return motor_to_each(p, MOTORWAY_EACH(apply_direction_each), MW_DEFAULT); }};
}

template <class T> kernel<T> kernel_of_apply_direction_each_unit()
{
    return {each_to_xyz,
            [](const problem<T> &p) {
                return motor_to_each(p, MOTORWAY_EACH(apply_direction_each), MW_UNIT_MOTORS);
            }};
}

#undef MOTORWAY_EACH

template <class T> kernel<T> kernel_of_compose_motor_each()
{
    return {{operand::motor, {operand::motor, operand::motor}, 0, motors::unit}, [](const problem<T> &p) {
                const const_motors<T> first = motors_view(p.in[0]), then = motors_view(p.in[1]);
                return make_work([=, out = motors_view(p.out), count = p.count] {
                    require(compose_motor_each(out, first, then, count));
                });
            }};
}

template <class T> kernel<T> kernel_of_reverse_motor_each()
{
    return {{operand::motor, {operand::motor}, 0, motors::unit}, [](const problem<T> &p) {
                const const_motors<T> in = motors_view(p.in[0]);
                return make_work([=, out = motors_view(p.out), count = p.count] {
                    require(reverse_motor_each(out, in, count));
                });
            }};
}

template <class T> kernel<T> kernel_of_normalize_motor_each()
{
    return {{operand::motor, {operand::motor}, 0, motors::multiples}, [](const problem<T> &p) {
                const const_motors<T> in = motors_view(p.in[0]);
                return make_work([=, out = motors_view(p.out), count = p.count] {
                    require(normalize_motor_each(out, in, count));
                });
            }};
}

template <class T> weights<T> weights_view(const array<T> &a)
{
    return {const_cast<const T *const *>(a.component()), a.stride()};
}

template <class T> kernel<T> kernel_of_blend_motor_one()
{
    return {{operand::motor, {operand::weights}, blend_terms, motors::unit}, [](const problem<T> &p) {
                return make_work([=, out = motors_view(p.out), controls = fixed_motors(p),
                                  weights = weights_view(p.in[0]), count = p.count] {
                    require(blend_motor_one(out, controls, weights, blend_terms, count));
                });
            }};
}

template <class T> kernel<T> kernel_of_blend_motor_each()
{
    return {{operand::motor,
             {operand::weights, operand::motor, operand::motor, operand::motor, operand::motor},
             0,
             motors::unit},
            [](const problem<T> &p) {
                using views = std::array<typename detail::types<T>::const_motors, blend_terms>;
                const auto controls = std::make_shared<views>();
                for (std::size_t k = 0; k < blend_terms; ++k)
                    (*controls)[k] = const_motors<T>(motors_view(p.in[1 + k]));
                return make_work(
                    [=, out = motors_view(p.out), weights = weights_view(p.in[0]), count = p.count] {
                        require(blend_motor_each(out, controls->data(), weights, blend_terms, count));
                    });
            }};
}

kernel_row make_row(std::string name, bool unit, bool blends, std::size_t operations, kernel<float> f32,
                    kernel<double> f64)
{
    return {std::move(name), unit, operations, f32.arguments, blends ? blend_terms : 1, f32.bind, f64.bind};
}

} // namespace

const std::vector<kernel_row> &kernel_rows()
{
#define MOTORWAY_ROW(kernel, name, unit, verb, operations)                                                           \
    make_row(name, unit, std::string(#verb) == "blend", operations, kernel_of_##kernel<float>(),                     \
             kernel_of_##kernel<double>()),
#define MOTORWAY_KERNEL(verb, operand, pairing, inputs, outputs, operations, divisions)                              \
    MOTORWAY_ROW(verb##_##operand##_##pairing, #verb "_" #operand "_" #pairing, false, verb, operations)
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, inputs, outputs, operations, divisions)                         \
    MOTORWAY_ROW(verb##_##operand##_##pairing##_unit, #verb "_" #operand "_" #pairing "-unit", true, verb, operations)
    static const std::vector<kernel_row> rows = {
#include "../generated/kernel_list.inc"
    };
#undef MOTORWAY_ROW
    return rows;
}

} // namespace motorway::bench
