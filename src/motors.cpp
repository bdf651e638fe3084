// The group of motors: compose, invert, exp, log, powers, slerp. Validate, look up, call, return a status.
#include "grid.h"
#include "motorway.h"
#include "stream_calls.h"

namespace motorway {
namespace {

template <class T, class Bivectors> view<T, 6> view_of_bivectors(const Bivectors &v)
{
    return {{v.b12, v.b13, v.b23, v.b1i, v.b2i, v.b3i}, v.stride};
}

// A kernel, or one of two by a flag.
struct kernel_choice {
    kernel_id id;
    bool flags_known = true;

    kernel_choice(kernel_id only) : id(only) {}
    kernel_choice(kernel_id usual, kernel_id flagged, unsigned flag, unsigned flags)
        : id(flags & flag ? flagged : usual), flags_known(!(flags & ~flag))
    {
    }
};

template <class T, int N, class... Inputs>
mw_status motors_each(const kernel_choice &kernel, std::size_t count, const view<T, N> &out, const Inputs &...in)
{
    if (kernels() && !kernel.flags_known)
        return MW_ERROR_FLAGS;
    return run_streams(kernel.id, to(out), count, in...);
}

// With one or two motors that all elements share. They are copied: a kernel takes them side by side.
template <class T, int N, class Motor, class... Inputs>
mw_status motors_shared(const kernel_choice &kernel, std::size_t count, const view<T, N> &out, const Motor *first,
                        const Motor *second, const Inputs &...in)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (!kernel.flags_known)
        return MW_ERROR_FLAGS;
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
    return run_streams(kernel.id, static_cast<const T *>(fixed), to(out), count, in...);
}

// ------------------------------------------------------------------------------------------------------ hierarchies

// Whether no motor of `out` has a byte in common with a motor of `locals` but that of the same joint and instance.
template <class T>
bool is_in_place(const view<T, 8> &out, const view<const T, 8> &locals, const grid_shape &shape)
{
    std::size_t cell = std::min(out.stride, shape.row_stride);
    if (shape.rows == 1 || shape.count == 1)
        cell = shape.rows == 1 ? out.stride : shape.row_stride;
    return is_same(out, locals) || (out.stride == locals.stride && share_a_cell(out, locals, cell));
}

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
        (range.meets(range_of(locals, shape)) && !is_in_place(out, locals, shape)))
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
    for (std::size_t i = 0; i < count; ++i) {
        T motor[8]; // read whole before it is written: the two may share bytes
        for (int c = 0; c < 8; ++c)
            __builtin_memcpy(&motor[c], from.from(i).component[c], sizeof(T));
        for (int c = 0; c < 8; ++c)
            __builtin_memcpy(to.from(i).component[c], &motor[c], sizeof(T));
    }
}

// Instances that are taken through all joints before the next are begun: few enough that a parent is still in the
// second cache, and in rows long enough for the prefetcher.
constexpr std::size_t instance_chunk = 1024;

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
                compose(call<T>{&to_stream, from, some});
            }
        }
    return MW_OK;
}

} // namespace
} // namespace motorway

// ---------------------------------------------------------------------------------------------------- C functions

using namespace motorway;

// The kernels of a function that takes one flag.
#define MOTORWAY_UNIT_CHOICE(verb)                                                                                    \
    kernel_choice(kernel_id::verb##_motor_each, kernel_id::verb##_motor_each_unit, MW_UNIT_MOTORS, flags)
#define MOTORWAY_WAY_CHOICE(verb, pairing)                                                                            \
    kernel_choice(kernel_id::verb##_motor_##pairing, kernel_id::verb##_long_motor_##pairing, MW_LONG_WAY, flags)

#define MOTORWAY_INTERPOLATION(verb, P, T)                                                                            \
    mw_status mw_##verb##_motor_each_##P(mw_motors_##P out, mw_const_motors_##P first, mw_const_motors_##P second,    \
                                         const T *parameters, size_t parameter_stride, size_t count, unsigned flags)  \
    {                                                                                                                 \
        return motors_each(MOTORWAY_WAY_CHOICE(verb, each), count, view_of_motors<T>(out),                            \
                           numbers<T>{parameters, parameter_stride}, view_of_motors<const T>(first),                  \
                           view_of_motors<const T>(second));                                                          \
    }                                                                                                                 \
    mw_status mw_##verb##_motor_one_##P(mw_motors_##P out, const mw_motor_##P *first, const mw_motor_##P *second,     \
                                        const T *parameters, size_t parameter_stride, size_t count, unsigned flags)   \
    {                                                                                                                 \
        return motors_shared(MOTORWAY_WAY_CHOICE(verb, one), count, view_of_motors<T>(out), first, second,            \
                             numbers<T>{parameters, parameter_stride});                                               \
    }

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
                           view_of_bivectors<const T>(generators));                                                   \
    }                                                                                                                 \
    mw_status mw_log_motor_each_##P(mw_bivectors_##P out, mw_const_motors_##P motors, size_t count, unsigned flags)   \
    {                                                                                                                 \
        return motors_each(MOTORWAY_UNIT_CHOICE(log), count, view_of_bivectors<T>(out),                               \
                           view_of_motors<const T>(motors));                                                          \
    }                                                                                                                 \
    mw_status mw_log_principal_motor_each_##P(mw_bivectors_##P out, mw_const_motors_##P motors, size_t count,         \
                                              unsigned flags)                                                         \
    {                                                                                                                 \
        return motors_each(MOTORWAY_UNIT_CHOICE(log_principal), count, view_of_bivectors<T>(out),                     \
                           view_of_motors<const T>(motors));                                                          \
    }                                                                                                                 \
    mw_status mw_ratio_motor_each_##P(mw_motors_##P out, mw_const_motors_##P from, mw_const_motors_##P to,            \
                                      size_t count, unsigned flags)                                                   \
    {                                                                                                                 \
        return motors_each(MOTORWAY_UNIT_CHOICE(ratio), count, view_of_motors<T>(out),                                \
                           view_of_motors<const T>(from), view_of_motors<const T>(to));                               \
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
                           numbers<T>{exponents, exponent_stride}, view_of_motors<const T>(motors));                  \
    }                                                                                                                 \
    MOTORWAY_INTERPOLATION(slerp, P, T)                                                                               \
    MOTORWAY_INTERPOLATION(nlerp, P, T)

MOTORWAY_GROUP(f32, float)
MOTORWAY_GROUP(f64, double)
