// Where the results of a grid lie: rows of elements, or elements of rows.
#pragma once

#include "elements.h"

namespace motorway {

// The two strides of an output of `rows` times `count` elements.
struct grid_shape {
    std::size_t rows, row_stride, count;

    // The images of an element lie side by side, and not those of a row.
    template <class T, int N> bool is_point_major(const view<T, N> &v) const { return rows > 1 && row_stride < v.stride; }
};

// From the first byte to past the last.
template <class T, int N> byte_range range_of(const view<T, N> &v, const grid_shape &grid)
{
    byte_range range = range_of(v, grid.count);
    range.end += (grid.rows - 1) * grid.row_stride;
    return range;
}

template <class T, int N> bool have_disjoint_ranges(const view<T, N> &v, std::size_t extent)
{
    for (int a = 0; a < N; ++a)
        for (int b = a + 1; b < N; ++b)
            if (share_bytes(address(v.component[a]), address(v.component[b]), extent, extent, 1))
                return false;
    return true;
}

// Whether no component of an output has its range, gaps included, in common with one of an input.
template <class E, class T, int N, int M>
bool is_apart(const view<E, N> &out, const grid_shape &grid, const view<const T, M> &in, std::size_t count)
{
    bool apart = true;
    for (int a = 0; a < N; ++a) {
        byte_range range = range_of_component(out, a, grid.count);
        range.end += (grid.rows - 1) * grid.row_stride;
        apart &= !meets_a_component(in, count, range);
    }
    return apart;
}

// Null, strides and size. Every scalar must have a place of its own: within a run along the smaller stride; and from
// run to run, because a run of all components is no longer than the larger stride, or because no two components meet.
template <class T, int N> mw_status check_grid(const view<T, N> &v, const grid_shape &grid)
{
    const bool point_major = grid.is_point_major(v);
    const view<T, N> run = v.with_stride(point_major ? grid.row_stride : v.stride);
    const std::size_t length = point_major ? grid.rows : grid.count, runs = point_major ? grid.count : grid.rows;
    const std::size_t distance = point_major ? v.stride : grid.row_stride;
    std::size_t extent;
    if (__builtin_mul_overflow(runs, distance, &extent) || extent > PTRDIFF_MAX)
        return MW_ERROR_SIZE;
    const mw_status status = check_view(run, length);
    if (status != MW_OK || runs == 1)
        return status;
    for (const T *base : v.component) {
        std::uintptr_t end;
        if (__builtin_add_overflow(address(base), extent, &end) ||
            __builtin_add_overflow(end, length * run.stride, &end))
            return MW_ERROR_SIZE;
    }
    const byte_range whole = range_of(run, length);
    const bool fits = whole.end - whole.begin <= distance || have_disjoint_ranges(v, extent);
    return fits && length * run.stride <= distance ? MW_OK : MW_ERROR_STRIDE;
}

template <class T, int N, int Parts> mw_status check_grid(const elements<T, N, Parts> &out, const grid_shape &grid)
{
    mw_status status =
        check_each_part(out, [&](const view<T, N> &part) { return check_grid(part, grid); });
    if constexpr (Parts == 2) {
        if (status == MW_OK && out.part[0].stride == out.part[1].stride) {
            view<T, 2 * N> both{{}, out.part[0].stride};
            for (int c = 0; c < 2 * N; ++c)
                both.component[c] = out.part[c / N].component[c % N];
            status = check_grid(both, grid);
        } else if (status == MW_OK && range_of(out.part[0], grid).meets(range_of(out.part[1], grid)))
            status = MW_ERROR_OVERLAP;
    }
    return status;
}

} // namespace motorway
