// The group of motors: compose, invert, exp, log, powers, slerp. Validate, look up, call, return a status.
#include "grid.h"
#include "motorway.h"
#include "stream_calls.h"

namespace motorway {
namespace {

// With one or two motors that all elements share. They are copied: a kernel takes them side by side.
template <class T, int N, class... Inputs>
mw_status run_with_shared_motors(const kernel_choice &kernel, const outputs<view<T, N>> &out, std::size_t count,
                                 const T *first, const T *second, const Inputs &...in)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (!kernel.flags_known)
        return MW_ERROR_FLAGS;
    if (count == 0)
        return MW_OK;
    if (!first || !second)
        return MW_ERROR_NULL;
    const view<T, N> &results = std::get<0>(out);
    const mw_status status = first_error(
        check_view(results, count), [&] { return check_overlap(results, first, 8, count); },
        [&] { return check_overlap(results, second, 8, count); });
    if (status != MW_OK)
        return status;
    T fixed[16];
    std::copy_n(first, 8, fixed);
    std::copy_n(second, 8, fixed + 8);
    return run_streams_of(kernel, static_cast<const T *>(fixed), out, count, in...);
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
mw_status compose_motor_hierarchy(const view<T, 8> &out, const view<const T, 8> &locals, std::size_t joint_stride,
                                  const std::int32_t *parents, std::size_t joints, std::size_t count,
                                  std::size_t *first_bad)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (joints == 0 || count == 0)
        return MW_OK;
    const mw_status status = check_hierarchy(out, locals, {joints, joint_stride, count}, parents, first_bad);
    if (status != MW_OK)
        return status;
    const kernel<T> compose = kernel_of<T>(kernel_id::compose_motor_each);
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

using namespace motorway;
#include "../generated/calls/motors.inc"
