// The public views as the library sees them: checked, compared, and turned into the streams of a kernel call.
#pragma once

#include "kernel/call.h"
#include "motorway_views.h"

#include <cstdint>
#include <type_traits>

namespace motorway {

// N base pointers and a stride. T is const for inputs.
template <class T, int N> struct view {
    T *component[N];
    std::size_t stride;

    stream<T> as_stream() const { return {component, stride, classify()}; }

    // The components of an element lie next to each other, in order.
    bool is_adjacent() const
    {
        for (int c = 1; c < N; ++c)
            if (component[c] != component[0] + c)
                return false;
        return true;
    }

    view<const T, N> as_const() const
    {
        view<const T, N> result{{}, stride};
        for (int c = 0; c < N; ++c)
            result.component[c] = component[c];
        return result;
    }

    view with_stride(std::size_t bytes) const
    {
        view result = *this;
        result.stride = bytes;
        return result;
    }

    // The view from element `first` on.
    view from(std::size_t first) const
    {
        return moved_by(first * stride);
    }

    view moved_by(std::size_t bytes) const
    {
        using byte = std::conditional_t<std::is_const_v<T>, const char, char>;
        view result = *this;
        for (T *&base : result.component)
            base = reinterpret_cast<T *>(reinterpret_cast<byte *>(base) + bytes);
        return result;
    }

private:
    layout classify() const
    {
        if (stride == sizeof(T))
            return layout::soa;
        if (!is_adjacent())
            return layout::scattered;
        return stride == N * sizeof(T) ? layout::packed : layout::interleaved;
    }
};

// Of the public ones.
#include "../generated/views.inc"
template <class View> constexpr View no_view{};
template <class View> auto view_of(const View *v) -> decltype(view_of(*v)) { return view_of(v ? *v : no_view<View>); }

// Components side by side.
template <int N, class T> view<T, N> adjacent(T *first, std::size_t stride)
{
    view<T, N> result{{}, stride};
    for (int c = 0; c < N; ++c)
        result.component[c] = first ? first + c : nullptr;
    return result;
}

// Motors as the eight numbers that each is.
inline const float *numbers_of(const mw_motor_f32 *motors) { return reinterpret_cast<const float *>(motors); }
inline const double *numbers_of(const mw_motor_f64 *motors) { return reinterpret_cast<const double *>(motors); }
inline float *numbers_of(mw_motor_f32 *motors) { return reinterpret_cast<float *>(motors); }
inline double *numbers_of(mw_motor_f64 *motors) { return reinterpret_cast<double *>(motors); }
static_assert(sizeof(mw_motor_f32) == 8 * sizeof(float) && sizeof(mw_motor_f64) == 8 * sizeof(double));

// ------------------------------------------------------------------------------------------------ shared bytes

template <class T> std::uintptr_t address(const T *pointer) { return reinterpret_cast<std::uintptr_t>(pointer); }

// Which items are compared: all, or only those with different numbers.
enum class items { all, others };

// Items of a_size bytes at a + i stride and of b_size bytes at b + j stride, for i, j < count: is a byte common to
// two? Every call of the library asks this several times, so the two usual answers cost no division.
inline bool share_bytes(std::uintptr_t a, std::size_t a_size, std::uintptr_t b, std::size_t b_size, std::size_t stride,
                        std::size_t count, items which = items::all)
{
    if (b < a)
        return share_bytes(b, b_size, a, a_size, stride, count, which);
    const std::uintptr_t distance = b - a;
    if (distance >= stride * count)
        return false;
    const std::uintptr_t steps = distance < stride ? 0 : distance / stride, phase = distance - steps * stride;
    const bool compared = steps > 0 || which == items::all;
    return (phase < a_size && compared) || (stride - phase < b_size && steps + 1 < count);
}
inline bool share_bytes(std::uintptr_t a, std::uintptr_t b, std::size_t stride, std::size_t size, std::size_t count)
{
    return share_bytes(a, size, b, size, stride, count);
}

// From the first byte of a view to past its last.
struct byte_range {
    std::uintptr_t begin, end;
    bool meets(const byte_range &other) const { return begin < other.end && other.begin < end; }
};

template <class T, int N> byte_range range_of(const view<T, N> &v, std::size_t count)
{
    byte_range range{address(v.component[0]), address(v.component[0])};
    for (const T *base : v.component) {
        range.begin = address(base) < range.begin ? address(base) : range.begin;
        range.end = address(base) > range.end ? address(base) : range.end;
    }
    range.end += (count - 1) * v.stride + sizeof(T);
    return range;
}

template <class T> byte_range range_of(const T *array, std::size_t count)
{
    return {address(array), address(array) + count * sizeof(T)};
}

// Of one component, from its first byte to past its last.
template <class T, int N> byte_range range_of_component(const view<T, N> &v, int c, std::size_t count)
{
    return {address(v.component[c]), address(v.component[c]) + (count - 1) * v.stride + sizeof(T)};
}

template <class T, int N> bool meets_a_component(const view<T, N> &v, std::size_t count, const byte_range &range)
{
    bool meets = false;
    for (int c = 0; c < N; ++c)
        meets |= range_of_component(v, c, count).meets(range);
    return meets;
}

inline byte_range range_of(const mw_indices &indices, std::size_t count)
{
    const auto begin = reinterpret_cast<std::uintptr_t>(indices.first);
    return {begin, begin + (count - 1) * indices.stride + indices.type};
}

// -------------------------------------------------------------------------------------------------- validation

// Null, stride and size. `count` is not 0.
template <class T, int N> mw_status check_view(const view<T, N> &v, std::size_t count)
{
    for (const T *base : v.component)
        if (!base)
            return MW_ERROR_NULL;
    if (v.stride < sizeof(T))
        return MW_ERROR_STRIDE;
    std::size_t extent;
    std::uintptr_t end;
    if (__builtin_mul_overflow(count, v.stride, &extent) || extent > PTRDIFF_MAX)
        return MW_ERROR_SIZE;
    for (const T *base : v.component)
        if (__builtin_add_overflow(address(base), extent, &end))
            return MW_ERROR_SIZE;
    for (int a = 0; a < N; ++a)
        for (int b = a + 1; b < N; ++b)
            if (share_bytes(address(v.component[a]), address(v.component[b]), v.stride, sizeof(T), count))
                return MW_ERROR_STRIDE;
    return MW_OK;
}

// An array of `count` scalars or motors.
template <class T> mw_status check_array(const T *array, std::size_t count)
{
    std::size_t extent;
    std::uintptr_t end;
    if (!array)
        return MW_ERROR_NULL;
    if (__builtin_mul_overflow(count, sizeof(T), &extent) || extent > PTRDIFF_MAX ||
        __builtin_add_overflow(address(array), extent, &end))
        return MW_ERROR_SIZE;
    return MW_OK;
}

// One view in two roles.
template <class E, class T, int N, int M> bool is_same(const view<E, N> &out, const view<const T, M> &in)
{
    if constexpr (N != M || !std::is_same_v<E, T>)
        return false;
    else {
        bool same = out.stride == in.stride;
        for (int c = 0; c < N && same; ++c)
            same = out.component[c] == in.component[c];
        return same;
    }
}

// Whether all bytes of element 0 of both views lie within one stride, so that no two elements with different numbers
// have a byte in common.
template <class E, class T, int N, int M>
bool share_a_cell(const view<E, N> &out, const view<const T, M> &in, std::size_t stride)
{
    const byte_range a = range_of(out, 1), b = range_of(in, 1);
    return (a.end > b.end ? a.end : b.end) - (a.begin < b.begin ? a.begin : b.begin) <= stride;
}

// MW_OK if no item of `out` has a byte in common with one of `in`, of all or only of those with another number.
template <class E, class T, int N, int M>
mw_status check_bytes(const view<E, N> &out, const view<const T, M> &in, std::size_t count, items which)
{
    if (!range_of(out, count).meets(range_of(in, count)))
        return MW_OK;
    if (which == items::others && (count == 1 || (out.stride == in.stride && share_a_cell(out, in, out.stride))))
        return MW_OK;
    if (out.stride != in.stride) { // where the ranges of two components meet, so may their elements
        bool meets = false;
        for (int c = 0; c < M; ++c)
            meets |= meets_a_component(out, count, range_of_component(in, c, count));
        return meets ? MW_ERROR_OVERLAP : MW_OK;
    }
    for (const E *a : out.component)
        for (const T *b : in.component)
            if (share_bytes(address(a), sizeof(E), address(b), sizeof(T), out.stride, count, which))
                return MW_ERROR_OVERLAP;
    return MW_OK;
}

// MW_OK if two views have no byte in common.
template <class E, class T, int N, int M>
mw_status check_apart(const view<E, N> &out, const view<const T, M> &in, std::size_t count)
{
    return check_bytes(out, in, count, items::all);
}

// MW_OK if an element of `out` has no byte in common with another element of `in`. It may have with the same one,
// which is read before it is written: every loop of the kernels loads some elements from all inputs, whole, and then
// stores the same elements. Of another type they must be apart, for the compiler may then change that order.
template <class E, class T, int N, int M>
mw_status check_overlap(const view<E, N> &out, const view<const T, M> &in, std::size_t count)
{
    return check_bytes(out, in, count, std::is_same_v<E, T> ? items::others : items::all);
}

// MW_OK if no byte is common with indices, which may be fields of the same vertices.
template <class E, int N>
mw_status check_overlap(const view<E, N> &out, const mw_indices &indices, std::size_t count)
{
    const byte_range range = range_of(indices, count);
    if (!range_of(out, count).meets(range))
        return MW_OK;
    if (out.stride != indices.stride)
        return meets_a_component(out, count, range) ? MW_ERROR_OVERLAP : MW_OK;
    for (const E *a : out.component)
        if (share_bytes(address(a), sizeof(E), range.begin, indices.type, out.stride, count))
            return MW_ERROR_OVERLAP;
    return MW_OK;
}

// The same for an array that the call reads as a whole.
template <class T, int N, class Item>
mw_status check_overlap(const view<T, N> &out, const Item *array, std::size_t items, std::size_t count)
{
    return meets_a_component(out, count, range_of(array, items)) ? MW_ERROR_OVERLAP : MW_OK;
}

// Small batches would pay more for these checks than for their work. So a few instructions look whether a call is one
// of the usual ones, which all of the checks above would pass; only others are checked in full.
#define MOTORWAY_INLINE inline __attribute__((always_inline))

// The bytes of a view of adjacent components, or of one array a component in ascending order, that share none and
// are far from the ends of the address space. Empty if it is not clearly such a view.
template <class T, int N> MOTORWAY_INLINE byte_range usual_range(const view<T, N> &v, std::size_t count)
{
    constexpr std::size_t large = std::size_t(1) << 31, lowest = 4096, highest = UINTPTR_MAX / 2;
    const std::uintptr_t begin = address(v.component[0]), last = address(v.component[N - 1]);
    const std::size_t extent = count * v.stride;
    bool usual = v.stride < large && count < large && begin >= lowest && last < highest;
    if (v.stride == sizeof(T)) {
        for (int c = 1; c < N; ++c)
            usual &= address(v.component[c]) >= address(v.component[c - 1]) + extent;
        return usual ? byte_range{begin, last + extent} : byte_range{0, 0};
    }
    usual &= v.stride >= N * sizeof(T) && v.is_adjacent();
    return usual ? byte_range{begin, begin + extent} : byte_range{0, 0};
}

// Whether an element of the output lies over the same element of the input, both of adjacent components.
template <class E, class T, int N, int M>
MOTORWAY_INLINE bool is_usual_in_place(const view<E, N> &out, const view<const T, M> &in)
{
    constexpr std::size_t size = (N > M ? N : M) * sizeof(E);
    return std::is_same_v<E, T> && address(out.component[0]) == address(in.component[0]) && out.stride == in.stride &&
           size <= out.stride;
}

// The output may lie over the input.
template <class E, class T, int N, int M>
MOTORWAY_INLINE bool is_usual(const view<E, N> &out, const byte_range &out_range, const view<const T, M> &in,
                              std::size_t count)
{
    const byte_range in_range = usual_range(in, count);
    if (out_range.end == 0 || in_range.end == 0)
        return false;
    return !out_range.meets(in_range) || is_usual_in_place(out, in) || is_same(out, in);
}

// The first status of several that is not MW_OK. Later arguments are functions, so that a check may rely on those
// before it.
inline mw_status first_error(mw_status status) { return status; }
template <class Check, class... Checks>
mw_status first_error(mw_status status, const Check &check, const Checks &...checks)
{
    return status != MW_OK ? status : first_error(check(), checks...);
}

} // namespace motorway
