// The group of motors: compose, invert, exp, log, powers, slerp. Validate, look up, call, return a status.
#include "grid.h"
#include "kernel_call.h"
#include "motorway.h"

#include <algorithm>
#include <tuple>

namespace motorway {
namespace {

template <class T, class Bivectors> view<T, 6> view_of_bivectors(const Bivectors &v)
{
    return {{v.b12, v.b13, v.b23, v.b1i, v.b2i, v.b3i}, v.stride};
}

// One number an element, or with stride 0 one for all.
template <class T> struct numbers {
    const T *first;
    std::size_t stride;

    view<const T, 1> as_view() const { return {{first}, stride}; }
};

// ---------------------------------------------------------------------------------------------------- validation

template <class T, int N> mw_status check_input(const view<const T, N> &in, std::size_t count)
{
    return check_view(in, count);
}
template <class T> mw_status check_input(const numbers<T> &in, std::size_t count)
{
    return in.stride == 0 ? check_array(in.first, 1) : check_view(in.as_view(), count);
}

template <class T, int N, int M>
mw_status check_apart(const view<T, N> &out, const view<const T, M> &in, std::size_t count)
{
    return check_overlap(out, in, count);
}
template <class T, int N> mw_status check_apart(const view<T, N> &out, const numbers<T> &in, std::size_t count)
{
    return in.stride == 0 ? check_overlap(out, in.first, 1, count) : check_overlap(out, in.as_view(), count);
}

template <class T, int N> view<const T, N> view_of_input(const view<const T, N> &in) { return in; }
template <class T> view<const T, 1> view_of_input(const numbers<T> &in) { return in.as_view(); }

template <class T, int N, int M>
bool is_usual_input(const view<T, N> &out, const byte_range &range, const view<const T, M> &in, std::size_t count)
{
    return is_usual(out, range, in, count);
}
template <class T, int N>
bool is_usual_input(const view<T, N> &out, const byte_range &range, const numbers<T> &in, std::size_t count)
{
    return in.stride != 0 && is_usual(out, range, in.as_view(), count);
}

// ---------------------------------------------------------------------------------------------------------- calls

// A kernel of element streams, whose fixed motors are `fixed` if there are any.
template <class T, int N, class... Inputs>
mw_status run_streams(kernel_id id, const T *fixed, const view<T, N> &out, std::size_t count, const Inputs &...in)
{
    const byte_range range = usual_range(out, count);
    if (!(is_usual_input(out, range, in, count) && ...)) {
        mw_status status = check_view(out, count);
        ((status = status != MW_OK ? status : check_input(in, count)), ...);
        ((status = status != MW_OK ? status : check_apart(out, in, count)), ...);
        if (status != MW_OK)
            return status;
    }
    const auto views = std::make_tuple(view_of_input(in)...);
    return std::apply(
        [&](const auto &...each) {
            const stream<T> to = out.as_stream();
            const stream<const T> from[] = {each.as_stream()...};
            call<T> arguments;
            arguments.out = &to;
            arguments.in = from;
            arguments.count = count;
            arguments.fixed = fixed;
            find<T>(*kernels(), id)(arguments);
            return MW_OK;
        },
        views);
}

template <class T, int N, class... Inputs>
mw_status motors_each(kernel_id id, std::size_t count, const view<T, N> &out, const Inputs &...in)
{
    if (!kernels())
        return MW_ERROR_ISA;
    return count == 0 ? MW_OK : run_streams(id, static_cast<const T *>(nullptr), out, count, in...);
}

// With one or two motors that all elements share. They are copied: a kernel takes them side by side.
template <class T, int N, class Motor, class... Inputs>
mw_status motors_shared(kernel_id id, std::size_t count, const view<T, N> &out, const Motor *first,
                        const Motor *second, const Inputs &...in)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (count == 0)
        return MW_OK;
    if (!first || !second)
        return MW_ERROR_NULL;
    const mw_status status = first_error(
        check_view(out, count), [&] { return check_overlap(out, numbers_of<T>(first), 8, count); },
        [&] { return check_overlap(out, numbers_of<T>(second), 8, count); });
    if (status != MW_OK)
        return status;
    T fixed[16];
    std::copy_n(numbers_of<T>(first), 8, fixed);
    std::copy_n(numbers_of<T>(second), 8, fixed + 8);
    return run_streams(id, static_cast<const T *>(fixed), out, count, in...);
}

template <class T>
mw_status logarithm(kernel_id any, kernel_id unit, std::size_t count, const view<T, 6> &out,
                    const view<const T, 8> &motors, unsigned flags)
{
    if (kernels() && (flags & ~static_cast<unsigned>(MW_UNIT_MOTORS)))
        return MW_ERROR_FLAGS;
    return motors_each(flags & MW_UNIT_MOTORS ? unit : any, count, out, motors);
}

// ------------------------------------------------------------------------------------------------------ hierarchies

template <class T>
mw_status check_hierarchy(const view<T, 8> &out, const view<const T, 8> &locals, const grid_shape &shape,
                          const std::int32_t *parents, std::size_t *first_bad)
{
    // An input has the shape of an output; nothing is written through this.
    view<T, 8> as_output{{}, locals.stride};
    for (int c = 0; c < 8; ++c)
        as_output.component[c] = const_cast<T *>(locals.component[c]);
    const mw_status status =
        first_error(check_grid(out, shape), [&] { return check_grid(as_output, shape); },
                    [&] { return check_array(parents, shape.rows); });
    if (status != MW_OK)
        return status;
    const byte_range range = range_of(out, shape);
    if (range.meets(range_of(parents, shape.rows)) ||
        (!is_same(out, locals) && range.meets(range_of(locals, shape))))
        return MW_ERROR_OVERLAP;
    for (std::size_t joint = 0; joint < shape.rows; ++joint)
        if (parents[joint] >= 0 && static_cast<std::size_t>(parents[joint]) >= joint) {
            if (first_bad)
                *first_bad = joint;
            return MW_ERROR_PARENT;
        }
    return MW_OK;
}

template <class T> void copy_motors(const view<T, 8> &to, const view<const T, 8> &from, std::size_t count)
{
    if (is_same(to, from))
        return;
    for (std::size_t i = 0; i < count; ++i)
        for (int c = 0; c < 8; ++c)
            __builtin_memcpy(to.from(i).component[c], from.from(i).component[c], sizeof(T));
}

// Instances that are taken through all joints before the next are begun, so that parents are still in the cache.
constexpr std::size_t instance_chunk = 64;

template <class T>
mw_status hierarchy(const view<T, 8> &out, const view<const T, 8> &locals, std::size_t joint_stride,
                    const std::int32_t *parents, std::size_t joints, std::size_t count, std::size_t *first_bad)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (joints == 0 || count == 0)
        return MW_OK;
    const mw_status status = check_hierarchy(out, locals, {joints, joint_stride, count}, parents, first_bad);
    if (status != MW_OK)
        return status;
    const kernel<T> compose = find<T>(*kernels(), kernel_id::compose_motor_each);
    for (std::size_t begin = 0; begin < count; begin += instance_chunk)
        for (std::size_t joint = 0; joint < joints; ++joint) {
            const std::size_t some = std::min(instance_chunk, count - begin);
            const view<T, 8> to = out.moved_by(joint * joint_stride).from(begin);
            const view<const T, 8> local = locals.moved_by(joint * joint_stride).from(begin);
            if (parents[joint] < 0)
                copy_motors(to, local, some);
            else {
                const auto parent = static_cast<std::size_t>(parents[joint]);
                const view<const T, 8> world = out.moved_by(parent * joint_stride).from(begin).as_const();
                const stream<T> to_stream = to.as_stream();
                const stream<const T> from[] = {local.as_stream(), world.as_stream()};
                call<T> arguments;
                arguments.out = &to_stream;
                arguments.in = from;
                arguments.count = some;
                compose(arguments);
            }
        }
    return MW_OK;
}

} // namespace
} // namespace motorway

// ---------------------------------------------------------------------------------------------------- C functions

using namespace motorway;

#define MOTORWAY_GROUP(P, T)                                                                                          \
    mw_status mw_compose_motor_each_##P(mw_motors_##P out, mw_const_motors_##P first, mw_const_motors_##P then,       \
                                        size_t count)                                                                 \
    {                                                                                                                 \
        return motors_each(kernel_id::compose_motor_each, count, view_of_motors<T>(out),                              \
                           view_of_motors<const T>(first), view_of_motors<const T>(then));                            \
    }                                                                                                                 \
    mw_status mw_compose_motor_one_first_##P(mw_motors_##P out, const mw_motor_##P *first, mw_const_motors_##P then,  \
                                             size_t count)                                                            \
    {                                                                                                                 \
        return motors_shared(kernel_id::compose_motor_one_first, count, view_of_motors<T>(out), first, first,         \
                             view_of_motors<const T>(then));                                                          \
    }                                                                                                                 \
    mw_status mw_compose_motor_one_then_##P(mw_motors_##P out, mw_const_motors_##P first, const mw_motor_##P *then,   \
                                            size_t count)                                                             \
    {                                                                                                                 \
        return motors_shared(kernel_id::compose_motor_one_then, count, view_of_motors<T>(out), then, then,            \
                             view_of_motors<const T>(first));                                                         \
    }                                                                                                                 \
    mw_status mw_compose_motor_hierarchy_##P(mw_motors_##P out, mw_const_motors_##P locals, size_t joint_stride,      \
                                             const int32_t *parents, size_t joint_count, size_t count,                \
                                             size_t *first_bad)                                                       \
    {                                                                                                                 \
        return hierarchy<T>(view_of_motors<T>(out), view_of_motors<const T>(locals), joint_stride, parents,           \
                            joint_count, count, first_bad);                                                           \
    }                                                                                                                 \
    mw_status mw_reverse_motor_each_##P(mw_motors_##P out, mw_const_motors_##P motors, size_t count)                  \
    {                                                                                                                 \
        return motors_each(kernel_id::reverse_motor_each, count, view_of_motors<T>(out),                              \
                           view_of_motors<const T>(motors));                                                          \
    }                                                                                                                 \
    mw_status mw_normalize_motor_each_##P(mw_motors_##P out, mw_const_motors_##P motors, size_t count)                \
    {                                                                                                                 \
        return motors_each(kernel_id::normalize_motor_each, count, view_of_motors<T>(out),                            \
                           view_of_motors<const T>(motors));                                                          \
    }                                                                                                                 \
    mw_status mw_inverse_motor_each_##P(mw_motors_##P out, mw_const_motors_##P motors, size_t count)                  \
    {                                                                                                                 \
        return motors_each(kernel_id::inverse_motor_each, count, view_of_motors<T>(out),                              \
                           view_of_motors<const T>(motors));                                                          \
    }                                                                                                                 \
    mw_status mw_exp_motor_each_##P(mw_motors_##P out, mw_const_bivectors_##P generators, size_t count)               \
    {                                                                                                                 \
        return motors_each(kernel_id::exp_motor_each, count, view_of_motors<T>(out),                                  \
                           view_of_bivectors<const T>(generators));                                                         \
    }                                                                                                                 \
    mw_status mw_log_motor_each_##P(mw_bivectors_##P out, mw_const_motors_##P motors, size_t count, unsigned flags)   \
    {                                                                                                                 \
        return logarithm(kernel_id::log_motor_each, kernel_id::log_motor_each_unit, count, view_of_bivectors<T>(out),   \
                         view_of_motors<const T>(motors), flags);                                                     \
    }                                                                                                                 \
    mw_status mw_log_principal_motor_each_##P(mw_bivectors_##P out, mw_const_motors_##P motors, size_t count,         \
                                              unsigned flags)                                                         \
    {                                                                                                                 \
        return logarithm(kernel_id::log_principal_motor_each, kernel_id::log_principal_motor_each_unit, count,        \
                         view_of_bivectors<T>(out), view_of_motors<const T>(motors), flags);                            \
    }                                                                                                                 \
    mw_status mw_sqrt_motor_each_##P(mw_motors_##P out, mw_const_motors_##P motors, size_t count)                     \
    {                                                                                                                 \
        return motors_each(kernel_id::sqrt_motor_each, count, view_of_motors<T>(out),                                 \
                           view_of_motors<const T>(motors));                                                          \
    }                                                                                                                 \
    mw_status mw_power_motor_each_##P(mw_motors_##P out, mw_const_motors_##P motors, const T *exponents,              \
                                      size_t exponent_stride, size_t count)                                           \
    {                                                                                                                 \
        return motors_each(kernel_id::power_motor_each, count, view_of_motors<T>(out),                                \
                           view_of_motors<const T>(motors), numbers<T>{exponents, exponent_stride});                  \
    }                                                                                                                 \
    mw_status mw_slerp_motor_each_##P(mw_motors_##P out, mw_const_motors_##P first, mw_const_motors_##P second,       \
                                      const T *parameters, size_t parameter_stride, size_t count)                     \
    {                                                                                                                 \
        return motors_each(kernel_id::slerp_motor_each, count, view_of_motors<T>(out),                                \
                           view_of_motors<const T>(first), view_of_motors<const T>(second),                           \
                           numbers<T>{parameters, parameter_stride});                                                 \
    }                                                                                                                 \
    mw_status mw_slerp_motor_one_##P(mw_motors_##P out, const mw_motor_##P *first, const mw_motor_##P *second,        \
                                     const T *parameters, size_t parameter_stride, size_t count)                      \
    {                                                                                                                 \
        return motors_shared(kernel_id::slerp_motor_one, count, view_of_motors<T>(out), first, second,                \
                             numbers<T>{parameters, parameter_stride});                                               \
    }

MOTORWAY_GROUP(f32, float)
MOTORWAY_GROUP(f64, double)
