// The public views as the library sees them: checked, compared, and turned into the streams of a kernel call.
#pragma once

#include "kernel/call.h"
#include "motorway.h"

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

    // The view from element `first` on.
    view from(std::size_t first) const
    {
        using byte = std::conditional_t<std::is_const_v<T>, const char, char>;
        view result = *this;
        for (T *&base : result.component)
            base = reinterpret_cast<T *>(reinterpret_cast<byte *>(base) + first * stride);
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

template <class T, class XYZ> view<T, 3> view_of_xyz(const XYZ &v) { return {{v.x, v.y, v.z}, v.stride}; }
template <class T, class Motors> view<T, 8> view_of_motors(const Motors &v)
{
    return {{v.s, v.b12, v.b13, v.b23, v.b1i, v.b2i, v.b3i, v.w}, v.stride};
}

// ------------------------------------------------------------------------------------------------ shared bytes

template <class T> std::uintptr_t address(const T *pointer) { return reinterpret_cast<std::uintptr_t>(pointer); }
template <class T> std::uintptr_t distance(const T *a, const T *b)
{
    return address(a) < address(b) ? address(b) - address(a) : address(a) - address(b);
}

// Scalars of `size` bytes at a + i stride and at b + j stride, for i, j < count: is a byte common to two? Every call
// of the library asks this several times, so the two usual answers cost no division.
inline bool share_bytes(std::uintptr_t a, std::uintptr_t b, std::size_t stride, std::size_t size, std::size_t count)
{
    const std::uintptr_t distance = a < b ? b - a : a - b;
    if (distance >= stride * count)
        return false;
    const std::uintptr_t steps = distance < stride ? 0 : distance / stride, phase = distance - steps * stride;
    return phase < size || (stride - phase < size && steps + 1 < count);
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

// MW_OK if `in` and `out` have no byte in common or are the same view.
template <class T, int N, int M>
mw_status check_overlap(const view<T, N> &out, const view<const T, M> &in, std::size_t count)
{
    if (!range_of(out, count).meets(range_of(in, count)))
        return MW_OK;
    if (out.stride != in.stride)
        return MW_ERROR_OVERLAP; // their ranges meet, and so may their elements
    bool same = N == M;
    for (int c = 0; c < N && same; ++c)
        same = out.component[c] == in.component[c];
    if (same)
        return MW_OK;
    for (const T *a : out.component)
        for (const T *b : in.component)
            if (share_bytes(address(a), address(b), out.stride, sizeof(T), count))
                return MW_ERROR_OVERLAP;
    return MW_OK;
}

// The same for an array that the call reads as a whole.
template <class T, int N, class Item>
mw_status check_overlap(const view<T, N> &out, const Item *array, std::size_t items, std::size_t count)
{
    return range_of(out, count).meets(range_of(array, items)) ? MW_ERROR_OVERLAP : MW_OK;
}

// A few instructions that see for most calls that all the checks above would pass: streams of adjacent components, or
// of one array a component, that are clearly apart from each other and from the ends of the address space. Small
// batches would otherwise pay more for their checks than for their work.
template <class T, int N> bool is_surely_fine(const view<T, N> &v, std::size_t count)
{
    constexpr std::size_t largest = std::size_t(1) << 31, lowest = 4096;
    bool fine = v.stride < largest && count < largest;
    if (v.stride == sizeof(T)) {
        for (int a = 0; a < N; ++a)
            for (int b = a + 1; b < N; ++b)
                fine &= distance(v.component[a], v.component[b]) >= count * sizeof(T);
    } else
        fine &= v.stride >= N * sizeof(T) && v.is_adjacent();
    for (const T *base : v.component)
        fine &= address(base) - lowest < UINTPTR_MAX / 2;
    return fine;
}
template <class T, int N, int M>
bool are_surely_fine(const view<T, N> &out, const view<const T, M> &in, std::size_t count)
{
    if (!is_surely_fine(out, count) || !is_surely_fine(in, count))
        return false;
    if (!range_of(out, count).meets(range_of(in, count)))
        return true;
    bool apart = out.stride == sizeof(T) && in.stride == sizeof(T);
    for (const T *a : out.component)
        for (const T *b : in.component)
            apart &= distance(a, b) >= count * sizeof(T);
    return apart;
}

// The first status of several that is not MW_OK. Later arguments are functions, so that a check may rely on those
// before it.
inline mw_status first_error(mw_status status) { return status; }
template <class Check, class... Checks> mw_status first_error(mw_status status, Check check, Checks... checks)
{
    return status != MW_OK ? status : first_error(check(), checks...);
}

} // namespace motorway
