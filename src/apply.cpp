// mw_apply_...: validate, look up, call, return a status.
#include "dispatch.h"
#include "elements.h"
#include "grid.h"
#include "kernel_call.h"
#include "motion/sample.h"
#include "motorway.h"
#include "near_unit.h"

#include <algorithm>

namespace motorway {
namespace {

static_assert(sizeof(mw_shift) == 6 * sizeof(double));

constexpr unsigned streaming_flags = MW_STREAMING_STORES | MW_NO_STREAMING_STORES;

// What is known without looking at the data.
MOTORWAY_INLINE mw_status check_call(unsigned flags)
{
    if (!kernels())
        return MW_ERROR_ISA;
    return (flags & ~(MW_UNIT_MOTORS | streaming_flags)) || (flags & streaming_flags) == streaming_flags
               ? MW_ERROR_FLAGS
               : MW_OK;
}

template <class E, int N, int Parts, class Item>
mw_status check_overlap(const elements<E, N, Parts> &out, const Item *array, std::size_t items, std::size_t count)
{
    return check_each_part(out, [&](const view<E, N> &part) { return check_overlap(part, array, items, count); });
}

// What all elements share beside a motor: nothing, or in mixed calls a shift. It lies behind the motor where a kernel
// takes both.
struct no_shift {
    template <class T> const T *of_all() const { return nullptr; }
    template <class T> const T *with(const T *motor, T *) const { return motor; }
};
struct some_shift {
    double number[6] = {};

    explicit some_shift(const mw_shift *shift)
    {
        for (int c = 0; c < 3 && shift; ++c)
            number[c] = shift->before[c], number[3 + c] = shift->after[c];
    }
    template <class T> const T *of_all() const { return number; }
    const double *with(const double *motor, double *room) const
    {
        std::copy_n(motor, 8, room);
        std::copy_n(number, 6, room + 8);
        return room;
    }
};
constexpr int fixed_size = 14;

template <class T, class E> void run(kernel<T, E> function, const call<T, E> &arguments)
{
    function(arguments);
    if (arguments.streaming)
        kernels()->fence();
}

// A motor for formulas that take its α times other numbers: itself, or if it is far from 1 a multiple in `room`. Null if
// it is degenerate.
template <class T> const T *near_unit(const T *motor, T *room)
{
    constexpr T near = sizeof(T) == sizeof(float) ? T(near_unit_f32) : T(near_unit_f64);
    const T alpha = alpha_of(motor);
    if (alpha >= 1 / near && alpha <= near)
        return motor;
    const T factor = factor_near_unit(alpha);
    for (int c = 0; c < 8; ++c)
        room[c] = motor[c] * factor;
    return is_degenerate(motor) ? nullptr : room;
}

// ----------------------------------------------------------------------------------------------------- pairings

template <class Id, class T, class E, int N, int Parts, class Shift>
mw_status apply_one(Id kernel, const elements<E, N, Parts> &out, const T *motor, const Shift &shift,
                    const elements<const E, N, Parts> &in, std::size_t count, unsigned flags)
{
    const mw_status called = check_call(flags);
    if (called != MW_OK || count == 0)
        return called;
    const byte_range usual = usual_output(out, in, count);
    if (!motor || usual.end == 0 || usual.meets(range_of(motor, 8))) {
        const mw_status status = first_error(check_array(motor, 8), [&] { return check_elements(out, in, count); },
                                             [&] { return check_overlap(out, motor, 8, count); });
        if (status != MW_OK)
            return status;
    }
    T near[8], room[fixed_size];
    motor = near_unit(motor, near);
    if (!motor)
        return MW_ERROR_DEGENERATE_MOTOR;
    const bool streaming = is_streaming(out, in, 2 * count * N * Parts * sizeof(E), flags);
    run(kernel_of<T>(kernel), kernel_call<T, E, N, Parts>(out, in, count, streaming, shift.with(motor, room)).arguments);
    return MW_OK;
}

template <class Id, class T, class E, int N, int Parts, class Shift>
mw_status apply_each(Id kernel, Id unit_kernel, const elements<E, N, Parts> &out, const view<const T, 8> &motors,
                     const Shift &shift, const elements<const E, N, Parts> &in, std::size_t count, unsigned flags)
{
    const mw_status called = check_call(flags);
    if (called != MW_OK || count == 0)
        return called;
    const byte_range usual = usual_output(out, in, count);
    if (usual.end == 0 || !is_usual(out.part[0], usual, motors, count)) {
        const mw_status status = first_error(
            check_elements(out, in, count), [&] { return check_view(motors, count); }, [&] {
                return check_each_part(out, [&](const view<E, N> &to) { return check_overlap(to, motors, count); });
            });
        if (status != MW_OK)
            return status;
    }
    const bool streaming = is_streaming(out, in, count * (8 * sizeof(T) + 2 * N * Parts * sizeof(E)), flags);
    kernel_call<T, E, N, Parts> made(out, in, count, streaming, shift.template of_all<T>());
    made.arguments.motors = motors.as_stream();
    run(kernel_of<T>(flags & MW_UNIT_MOTORS ? unit_kernel : kernel), made.arguments);
    return MW_OK;
}

mw_status check_indices(const mw_indices &indices, std::size_t count)
{
    if (indices.type != MW_INDEX_U8 && indices.type != MW_INDEX_U16 && indices.type != MW_INDEX_U32)
        return MW_ERROR_INDEX_TYPE;
    if (!indices.first)
        return MW_ERROR_NULL;
    if (indices.stride < static_cast<std::size_t>(indices.type))
        return MW_ERROR_STRIDE;
    std::size_t extent, end;
    if (__builtin_mul_overflow(count, indices.stride, &extent) || extent > PTRDIFF_MAX ||
        __builtin_add_overflow(reinterpret_cast<std::uintptr_t>(indices.first), extent, &end))
        return MW_ERROR_SIZE;
    return MW_OK;
}

template <class Index>
mw_status find_bad_index(const mw_indices &indices, std::size_t count, std::size_t palette_count, std::size_t *first_bad)
{
    const char *next = static_cast<const char *>(indices.first);
    for (std::size_t i = 0; i < count; ++i, next += indices.stride) {
        Index index;
        __builtin_memcpy(&index, next, sizeof index);
        if (index >= palette_count) {
            if (first_bad)
                *first_bad = i;
            return MW_ERROR_INDEX;
        }
    }
    return MW_OK;
}

mw_status check_index_values(const mw_indices &indices, std::size_t count, std::size_t palette_count,
                             std::size_t *first_bad)
{
    switch (indices.type) {
    case MW_INDEX_U8: return find_bad_index<std::uint8_t>(indices, count, palette_count, first_bad);
    case MW_INDEX_U16: return find_bad_index<std::uint16_t>(indices, count, palette_count, first_bad);
    default: return find_bad_index<std::uint32_t>(indices, count, palette_count, first_bad);
    }
}

mw_indices indices_of(const mw_indices *indices) { return indices ? *indices : mw_indices{nullptr, 0, MW_INDEX_U8}; }

// Whether values are looked at, and where the first bad one goes.
struct index_check {
    bool wanted = false;
    std::size_t *first_bad = nullptr;
};

template <class Id, class T, class E, int N, int Parts, class Shift>
mw_status apply_indexed(Id kernel, Id unit_kernel, const elements<E, N, Parts> &out, const T *palette,
                        std::size_t palette_count, const mw_indices &indices, const Shift &shift,
                        const elements<const E, N, Parts> &in, std::size_t count, unsigned flags,
                        const index_check &check = {})
{
    const mw_status called = check_call(flags);
    if (called != MW_OK || count == 0)
        return called;
    if (palette_count > PTRDIFF_MAX / (8 * sizeof(T)))
        return MW_ERROR_SIZE;
    const mw_status status = first_error(
        usual_output(out, in, count).end ? MW_OK : check_elements(out, in, count),
        [&] { return check_indices(indices, count); },
        [&] { return palette_count ? check_array(palette, 8 * palette_count) : MW_OK; },
        [&] { return check_overlap(out, palette, 8 * palette_count, count); },
        [&] {
            return check_each_part(out, [&](const view<E, N> &part) { return check_overlap(part, indices, count); });
        },
        [&] { return check.wanted ? check_index_values(indices, count, palette_count, check.first_bad) : MW_OK; });
    if (status != MW_OK)
        return status;
    const auto index_size = static_cast<unsigned>(indices.type);
    const bool streaming = is_streaming(out, in, count * (index_size + 2 * N * Parts * sizeof(E)), flags);
    kernel_call<T, E, N, Parts> made(out, in, count, streaming, shift.template of_all<T>());
    made.arguments.palette = palette;
    made.arguments.indices = {indices.first, indices.stride, index_size};
    run(kernel_of<T>(flags & MW_UNIT_MOTORS ? unit_kernel : kernel), made.arguments);
    return MW_OK;
}

template <class Id, class T, class E, int N, int Parts, class Shift>
mw_status apply_indexed_checked(Id kernel, Id unit_kernel, const elements<E, N, Parts> &out, const T *palette,
                                std::size_t palette_count, const mw_indices &indices, const Shift &shift,
                                const elements<const E, N, Parts> &in, std::size_t count, unsigned flags,
                                std::size_t *first_bad)
{
    return apply_indexed(kernel, unit_kernel, out, palette, palette_count, indices, shift, in, count, flags,
                         {true, first_bad});
}

mw_status check_indices(const mw_indices &indices, std::size_t count, std::size_t palette_count, std::size_t *first_bad)
{
    if (count == 0)
        return MW_OK;
    return first_error(check_indices(indices, count),
                       [&] { return check_index_values(indices, count, palette_count, first_bad); });
}

// --------------------------------------------------------------------------------------------------------- grids

// Elements that are moved by every motor before the next are begun: few enough to stay in the first cache, and enough
// for the matrix of a motor not to show.
constexpr std::size_t row_chunk = 2048;

template <class T, class E, int N, int Parts, class Shift> struct grid_batch {
    elements<E, N, Parts> out;
    view<const T, 8> motors;
    Shift shift;
    elements<const E, N, Parts> in;
    grid_shape shape;
};

template <class T, class E, int N, int Parts, class Shift>
grid_batch<T, E, N, Parts, Shift> grid_of(const elements<E, N, Parts> &out, const view<const T, 8> &motors,
                                          const Shift &shift, const elements<const E, N, Parts> &in,
                                          const grid_shape &shape)
{
    return {out, motors, shift, in, shape};
}

// Row by row: `one`, motor after motor.
template <class T, class E, int N, int Parts, class Shift>
void run_rows(kernel<T, E> one, const grid_batch<T, E, N, Parts, Shift> &grid, bool streaming)
{
    for (std::size_t begin = 0; begin < grid.shape.count; begin += row_chunk)
        for (std::size_t row = 0; row < grid.shape.rows; ++row) {
            T motor[8], near[8], room[fixed_size];
            const view<const T, 8> here = grid.motors.from(row);
            for (int c = 0; c < 8; ++c)
                __builtin_memcpy(&motor[c], here.component[c], sizeof(T));
            const T *const usual = near_unit(motor, near);
            const elements<E, N, Parts> out = grid.out.moved_by(row * grid.shape.row_stride).from(begin);
            const std::size_t some = std::min(row_chunk, grid.shape.count - begin);
            one(kernel_call<T, E, N, Parts>(out, grid.in.from(begin), some, streaming,
                                           grid.shift.with(usual ? usual : motor, room))
                    .arguments);
        }
}

// Element by element: lanes are motors.
template <class T, class E, int N, int Parts, class Shift>
void run_columns(kernel<T, E> grid_kernel, const grid_batch<T, E, N, Parts, Shift> &grid)
{
    elements<E, N, Parts> images = grid.out;
    for (view<E, N> &part : images.part)
        part.stride = grid.shape.row_stride;
    kernel_call<T, E, N, Parts> made(images, grid.in, grid.shape.count, false, grid.shift.template of_all<T>());
    for (int k = 0; k < Parts; ++k)
        made.to.part[k].stride = grid.out.part[k].stride;
    made.arguments.motors = grid.motors.as_stream();
    made.arguments.rows = grid.shape.rows;
    made.arguments.row_stride = grid.shape.row_stride;
    grid_kernel(made.arguments);
}

template <class Id, class T, class E, int N, int Parts, class Shift>
mw_status apply_grid(Id one, Id grid_kernel, const elements<E, N, Parts> &out, std::size_t row_stride,
                     const view<const T, 8> &motors, std::size_t motor_count, const Shift &shift,
                     const elements<const E, N, Parts> &in, std::size_t count, unsigned flags)
{
    const mw_status called = check_call(flags);
    if (called != MW_OK || count == 0 || motor_count == 0)
        return called;
    const grid_shape shape = {motor_count, row_stride, count};
    const auto check_apart = [&](const view<E, N> &part) {
        bool apart = is_apart(part, shape, motors, motor_count);
        for (const view<const E, N> &from : in.part)
            apart &= is_apart(part, shape, from, count);
        return apart ? MW_OK : MW_ERROR_OVERLAP;
    };
    const mw_status status = first_error(
        check_grid(out, shape), [&] { return check_view(motors, motor_count); },
        [&] { return check_parts(in, count); }, [&] { return check_each_part(out, check_apart); });
    if (status != MW_OK)
        return status;
    const auto grid = grid_of(out, motors, shift, in, shape);
    if (shape.is_point_major(out.part[0]))
        run_columns(kernel_of<T>(grid_kernel), grid);
    else {
        const bool streaming = is_streaming(out, in, shape.rows * shape.count * N * Parts * sizeof(E), flags);
        run_rows(kernel_of<T>(one), grid, streaming);
        if (streaming)
            kernels()->fence();
    }
    return MW_OK;
}

// ------------------------------------------------------------------------------------------------------- motions

// Poses that are made at a time: few enough to stay in the first cache beside a chunk of a row.
constexpr std::size_t pose_chunk = 64;

template <class T, int N, int Parts>
mw_status check_motion_grid(const motion_samples<T> &samples, const byte_range &motion, const T *parameters,
                       const elements<T, N, Parts> &out, const elements<const T, N, Parts> &in,
                       const grid_shape &shape)
{
    const byte_range at = range_of(parameters, shape.rows);
    const auto check_apart = [&](const view<T, N> &part) {
        const byte_range whole = range_of(part, shape);
        bool apart = !whole.meets(at) && !whole.meets(motion);
        for (const view<const T, N> &from : in.part)
            apart &= is_apart(part, shape, from, shape.count);
        return apart ? MW_OK : MW_ERROR_OVERLAP;
    };
    return first_error(
        check_grid(out, shape), [&] { return check_array(parameters, shape.rows); },
        [&] { return check_parts(in, shape.count); }, [&] { return check_each_part(out, check_apart); },
        [&] { return samples.are_sound() ? MW_OK : MW_ERROR_PARAMETER; });
}

template <class T, int N, int Parts, class Motion>
mw_status apply_motion(kernel_id one, kernel_id grid_kernel, const elements<T, N, Parts> &out, std::size_t row_stride,
                       const Motion *motion, std::size_t index, const T *parameters, std::size_t parameter_count,
                       const elements<const T, N, Parts> &in, std::size_t count, unsigned flags)
{
    const bool nothing_to_do = parameter_count == 0 || count == 0;
    const mw_status called = first_error(check_call(flags & ~parameter_flags), [&] {
        return check_motion_call<T>(motion, motions_sampled::one, index, nothing_to_do ? 0 : 1, flags,
                                    MW_UNIT_MOTORS | streaming_flags);
    });
    if (called != MW_OK || nothing_to_do)
        return called;
    const grid_shape shape = {parameter_count, row_stride, count};
    const compiled<T> from = compiled_of<T>(motion);
    const auto samples_at = [&](std::size_t first, std::size_t number) {
        return motion_samples<T>(from, motions_sampled::one, index, {parameters + first, sizeof(T)}, number, flags);
    };
    const mw_status status =
        check_motion_grid<T>(samples_at(0, shape.rows), from.range(), parameters, out, in, shape);
    if (status != MW_OK)
        return status;
    const bool point_major = shape.is_point_major(out.part[0]);
    const std::size_t bytes = shape.rows * shape.count * N * Parts * sizeof(T);
    const bool streaming = !point_major && is_streaming(out, in, bytes, flags);
    motor_of<T> pose[pose_chunk];
    const view<T, 8> poses{{&pose->s, &pose->b12, &pose->b13, &pose->b23, &pose->b1i, &pose->b2i, &pose->b3i, &pose->w},
                           sizeof *pose};
    for (std::size_t row = 0; row < shape.rows; row += pose_chunk) {
        const std::size_t some = std::min(pose_chunk, shape.rows - row);
        samples_at(row, some).sample(poses);
        const auto part = grid_of(out.moved_by(row * shape.row_stride), poses.as_const(), no_shift(), in,
                                  {some, shape.row_stride, shape.count});
        if (point_major)
            run_columns(kernel_of<T>(grid_kernel), part);
        else
            run_rows(kernel_of<T>(one), part, streaming);
    }
    if (streaming)
        kernels()->fence();
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/apply.inc"
