#include "kernels.h"

#include "api.h"
#include "call.h"
#include "motions.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace motorway::bench {
namespace {

// -------------------------------------------------------------------------------------------- from array to array
//
// A line each: name, (_BY: C function, if its name is another,) results, arguments, and what is constant.

template <class F32, class F64>
kernel make_map(F32 f32, F64 f64, std::vector<operand> out, std::vector<operand> in, constants always = {})
{
    bench::arguments arguments{std::move(out), std::move(in)};
    arguments.fixed = fixed_motors_of(f32);
    const auto binding_of = [=](auto function) {
        return [=](const auto &problem, unsigned flags) {
            return make_call(function, problem, arguments, {always.flags | flags, always.order});
        };
    };
    return {arguments, binding_of(f32), binding_of(f64), {}};
}

using op = operand;
#define MOTORWAY_MAP(name, ...) MOTORWAY_MAP_BY(name, name, __VA_ARGS__)
#define MOTORWAY_MAP_BY(name, function, ...)                                                                         \
    const kernel name = make_map(api<float>::function, api<double>::function, __VA_ARGS__);

MOTORWAY_MAP(compose_motor_each, {op::motor}, {op::motor, op::motor})
MOTORWAY_MAP(compose_motor_one_first, {op::motor}, {op::motor})
MOTORWAY_MAP(compose_motor_one_then, {op::motor}, {op::motor})
MOTORWAY_MAP(reverse_motor_each, {op::motor}, {op::motor})
MOTORWAY_MAP(normalize_motor_each, {op::motor}, {op::any_motor})
MOTORWAY_MAP(inverse_motor_each, {op::motor}, {op::any_motor})
MOTORWAY_MAP(ratio_motor_each, {op::motor}, {op::motor, op::motor})

MOTORWAY_MAP(exp_motor_each, {op::motor}, {op::bivector})
MOTORWAY_MAP(log_motor_each, {op::bivector}, {op::motor})
MOTORWAY_MAP(log_principal_motor_each, {op::bivector}, {op::motor})
MOTORWAY_MAP(sqrt_motor_each, {op::motor}, {op::motor})
MOTORWAY_MAP(power_motor_each, {op::motor}, {op::motor, op::parameter})
MOTORWAY_MAP(slerp_motor_each, {op::motor}, {op::motor, op::motor, op::parameter})
MOTORWAY_MAP(slerp_motor_one, {op::motor}, {op::parameter})
MOTORWAY_MAP_BY(slerp_long_motor_each, slerp_motor_each, {op::motor}, {op::motor, op::motor, op::parameter},
                {MW_LONG_WAY})
MOTORWAY_MAP_BY(slerp_long_motor_one, slerp_motor_one, {op::motor}, {op::parameter}, {MW_LONG_WAY})
MOTORWAY_MAP(nlerp_motor_each, {op::motor}, {op::motor, op::motor, op::parameter})
MOTORWAY_MAP(nlerp_motor_one, {op::motor}, {op::parameter})
MOTORWAY_MAP_BY(nlerp_long_motor_each, nlerp_motor_each, {op::motor}, {op::motor, op::motor, op::parameter},
                {MW_LONG_WAY})
MOTORWAY_MAP_BY(nlerp_long_motor_one, nlerp_motor_one, {op::motor}, {op::parameter}, {MW_LONG_WAY})

// convert_<name>_each.
#define MOTORWAY_CONVERT(name, ...) MOTORWAY_CONVERT_BY(name, name, __VA_ARGS__)
#define MOTORWAY_CONVERT_BY(name, function, ...)                                                                     \
    MOTORWAY_MAP_BY(convert_##name##_each, convert_##function##_each, __VA_ARGS__)

MOTORWAY_CONVERT(motor_to_pose, {op::quaternion, op::translation}, {op::motor})
MOTORWAY_CONVERT_BY(motor_to_pose_wxyz, motor_to_pose, {op::quaternion_wxyz, op::translation}, {op::motor})
MOTORWAY_CONVERT(pose_to_motor, {op::motor}, {op::quaternion, op::translation})
MOTORWAY_CONVERT_BY(pose_wxyz_to_motor, pose_to_motor, {op::motor}, {op::quaternion_wxyz, op::translation})
MOTORWAY_CONVERT(motor_to_dual_quaternion, {op::dual_quaternion}, {op::motor})
MOTORWAY_CONVERT_BY(motor_to_dual_quaternion_wxyz, motor_to_dual_quaternion, {op::dual_quaternion_wxyz}, {op::motor})
MOTORWAY_CONVERT(dual_quaternion_to_motor, {op::motor}, {op::dual_quaternion})
MOTORWAY_CONVERT_BY(dual_quaternion_wxyz_to_motor, dual_quaternion_to_motor, {op::motor}, {op::dual_quaternion_wxyz})
MOTORWAY_CONVERT_BY(motor_to_rows_3x4, motor_to_matrix, {op::rows_3x4}, {op::motor})
MOTORWAY_CONVERT_BY(motor_to_rows_4x4, motor_to_matrix, {op::rows_4x4}, {op::motor})
MOTORWAY_CONVERT_BY(motor_to_columns_3x4, motor_to_matrix, {op::columns_3x4}, {op::motor})
MOTORWAY_CONVERT_BY(motor_to_columns_4x4, motor_to_matrix, {op::columns_4x4}, {op::motor})
// The kernels alone: by default matrices are looked at first, which costs more.
MOTORWAY_CONVERT_BY(rows_3x4_to_motor, matrix_to_motor, {op::motor}, {op::rows_3x4}, {MW_ROTATION_MATRICES})
MOTORWAY_CONVERT_BY(columns_3x4_to_motor, matrix_to_motor, {op::motor}, {op::columns_3x4}, {MW_ROTATION_MATRICES})
MOTORWAY_CONVERT_BY(columns_4x4_to_motor, matrix_to_motor, {op::motor}, {op::columns_4x4}, {MW_ROTATION_MATRICES})
MOTORWAY_CONVERT(motor_to_axis_angle, {op::axis_angle, op::translation}, {op::motor})
MOTORWAY_CONVERT(axis_angle_to_motor, {op::motor}, {op::axis_angle, op::translation})
MOTORWAY_CONVERT(motor_to_euler, {op::euler_angles, op::translation}, {op::motor})
MOTORWAY_CONVERT_BY(motor_to_euler_proper, motor_to_euler, {op::euler_angles, op::translation}, {op::motor},
                    {MW_DEFAULT, MW_EULER_ZXZ})
MOTORWAY_CONVERT(euler_to_motor, {op::motor}, {op::euler_angles, op::translation})
MOTORWAY_CONVERT(translation_to_motor, {op::motor}, {op::translation})
MOTORWAY_CONVERT(motor_to_translation, {op::translation}, {op::motor})
MOTORWAY_CONVERT(motor_to_screw, {op::screw}, {op::motor})
MOTORWAY_CONVERT(screw_to_motor, {op::motor}, {op::screw})
MOTORWAY_CONVERT(rotor_to_motor, {op::motor}, {op::motor})

// --------------------------------------------------------------------------------------------- apply: four pairings

enum class pairing { one, each, grid, indexed };

template <operand O, pairing P> bench::arguments apply_arguments()
{
    bench::arguments result{{O}, {O}};
    result.motor_an_element = P == pairing::each;
    result.index_an_element = P == pairing::indexed;
    result.fixed = P == pairing::each ? 0 : P == pairing::one ? 1 : shared_motors;
    result.images = P == pairing::grid ? shared_motors : 1;
    return result;
}

template <class functions, class T, class M> work bind_grid(const problem<T, M> &p, unsigned flags)
{
    const bool columns = p.kind == layout::columns;
    const std::size_t step = p.out[0].stride(), count = p.count;
    const auto motors = packed_motors<M>(p.fixed.data());
    const auto in = view_of<typename functions::const_view>(p.in[0]);
    const auto out = view_of<typename functions::view>(p.out[0], columns ? shared_motors * step : step);
    const std::size_t row_stride = columns ? step : count * step;
    return make_work([=] {
        require(functions::grid(out, row_stride, motors, shared_motors, in, count, flags));
    });
}

template <operand O, pairing P, class T, class M> work bind_apply(const problem<T, M> &p, unsigned flags)
{
    using functions = apply_functions<O, T, M>;
    const auto in = view_of<typename functions::const_view>(p.in[0]);
    const auto out = view_of<typename functions::view>(p.out[0]);
    const auto *const shared = fixed_motors(p.fixed);
    const std::size_t count = p.count;
    if constexpr (P == pairing::one)
        return make_work([=] { require(functions::one(out, shared, in, count, flags)); });
    else if constexpr (P == pairing::each) {
        const auto motors = view_of<typename api<M>::const_motors>(*p.motors);
        return make_work([=] { require(functions::each(out, motors, in, count, flags)); });
    } else if constexpr (P == pairing::grid)
        return bind_grid<functions>(p, flags);
    else {
        const mw_indices indices = mw_indices_u16(p.indices.data(), sizeof p.indices[0]);
        return make_work([=] {
            require(functions::indexed(out, shared, shared_motors, indices, in, count, flags));
        });
    }
}

template <operand O, pairing P> kernel make_apply()
{
    kernel made{apply_arguments<O, P>(), bind_apply<O, P, float, float>, bind_apply<O, P, double, double>, {}};
    if constexpr (O == operand::point)
        made.mixed = bind_apply<O, P, float, double>;
    return made;
}

#define MOTORWAY_APPLY(name, views, P)                                                                               \
    const kernel apply_##name##_one = make_apply<operand::name, pairing::one>();                                     \
    const kernel apply_##name##_each = make_apply<operand::name, pairing::each>();                                   \
    const kernel apply_##name##_grid = make_apply<operand::name, pairing::grid>();                                   \
    const kernel apply_##name##_indexed = make_apply<operand::name, pairing::indexed>();
MW_OPERANDS(MOTORWAY_APPLY, )

// ------------------------------------------------------------------------------------------------------------ blend

template <class T> typename api<T>::weights weights_of(const array<T> &a)
{
    return {const_cast<const T *const *>(a.component()), a.stride()};
}

template <class T> work bind_blend_one(const problem<T> &p, unsigned)
{
    return make_work([out = view_of<typename api<T>::motors>(p.out[0]), controls = fixed_motors(p.fixed),
                      weights = weights_of(p.in[0]), count = p.count] {
        require(api<T>::blend_motor_one(out, controls, weights, blend_terms, count));
    });
}

template <class T> work bind_blend_each(const problem<T> &p, unsigned)
{
    using control_views = std::vector<typename api<T>::const_motors>;
    const auto controls = std::make_shared<control_views>();
    for (std::size_t k = 0; k < blend_terms; ++k)
        controls->push_back(view_of<typename api<T>::const_motors>(p.in[1 + k]));
    return make_work([=, out = view_of<typename api<T>::motors>(p.out[0]), weights = weights_of(p.in[0]),
                      count = p.count] {
        require(api<T>::blend_motor_each(out, controls->data(), weights, blend_terms, count));
    });
}

bench::arguments blend_each_arguments()
{
    bench::arguments result{{operand::motor}, {operand::weights}};
    result.in.insert(result.in.end(), blend_terms, operand::motor);
    return result;
}

const kernel blend_motor_one{{{operand::motor}, {operand::weights}, blend_terms},
                             bind_blend_one<float>, bind_blend_one<double>, {}};
const kernel blend_motor_each{blend_each_arguments(), bind_blend_each<float>, bind_blend_each<double>, {}};

// -------------------------------------------------------------------------------------------------------- skeletons

template <class T> work bind_hierarchy(const problem<T> &p, unsigned)
{
    const bool side_by_side = p.kind == layout::soa;
    const std::size_t step = p.out[0].stride(), count = p.count;
    const std::size_t stride = side_by_side ? step : skeleton_joints * step;
    const std::size_t joint_stride = side_by_side ? count * step : step;
    const auto out = view_of<typename api<T>::motors>(p.out[0], stride);
    const auto locals = view_of<typename api<T>::const_motors>(p.in[0], stride);
    return make_work([=, parents = p.parents.data()] {
        require(api<T>::compose_motor_hierarchy(out, locals, joint_stride, parents, skeleton_joints, count, nullptr));
    });
}

bench::arguments hierarchy_arguments()
{
    bench::arguments result{{operand::motor}, {operand::motor}};
    result.joints = skeleton_joints;
    result.natural_count = skeletons;
    return result;
}

const kernel compose_motor_hierarchy{hierarchy_arguments(), bind_hierarchy<float>, bind_hierarchy<double>, {}};

// --------------------------------------------------------------------------------------------------------- the rows

kernel_row make_row(const kernel &kernel, const std::string &verb, const std::string &name, std::size_t operations,
                    unsigned flags = MW_DEFAULT)
{
    kernel_row row{kernel, verb, name, operations, verb == "blend" ? blend_terms : 1, flags};
    row.mixed = nullptr;
    return row;
}

kernel_row make_mixed_row(const kernel &kernel, const std::string &verb, const std::string &name,
                          std::size_t operations)
{
    return {{kernel.arguments, nullptr, nullptr, kernel.mixed}, verb, name, operations, 1, MW_DEFAULT};
}

std::vector<kernel_row> listed_rows()
{
#define MOTORWAY_KERNEL(verb, operand, pairing, inputs, outputs, operations, divisions)                              \
    make_row(verb##_##operand##_##pairing, #verb, #verb "_" #operand "_" #pairing, operations),
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, inputs, outputs, operations, divisions)                         \
    make_row(verb##_##operand##_##pairing, #verb, #verb "_" #operand "_" #pairing "-unit", operations,               \
             MW_UNIT_MOTORS),
#define MOTORWAY_KERNEL_MIXED(verb, operand, pairing, inputs, outputs, operations, divisions)                        \
    make_mixed_row(verb##_##operand##_##pairing, #verb, #verb "_" #operand "_" #pairing, operations),
    return {
#include "../generated/kernel_list.inc"
    };
}

// Skeletons and motions are no kernels of the list, but made of them.
std::vector<kernel_row> all_rows()
{
    std::vector<kernel_row> rows = listed_rows();
    const auto operations_of = [&](const std::string &name) {
        const auto has_name = [&](const kernel_row &row) { return row.name == name; };
        return std::find_if(rows.begin(), rows.end(), has_name)->operations;
    };
    const std::size_t product = operations_of("compose_motor_each");
    const std::vector<kernel_row> motions =
        motion_rows({product, operations_of("exp_motor_each"), operations_of("slerp_motor_each"),
                     operations_of("apply_point_one")});
    rows.push_back(make_row(compose_motor_hierarchy, "compose", "compose_motor_hierarchy", product));
    rows.insert(rows.end(), motions.begin(), motions.end());
    return rows;
}

} // namespace

const std::vector<kernel_row> &kernel_rows()
{
    static const std::vector<kernel_row> rows = all_rows();
    return rows;
}

} // namespace motorway::bench
