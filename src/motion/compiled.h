// A compiled motion: one block of memory without pointers, which begins with this header. After it come, each aligned,
//
//     starts     the parameter at which each span begins, and the end of the last
//     spans      of each span what makes weights of a parameter: motion_call in kernel/call.h says how
//     first      of each span its first control
//     cells      equal parts of the domain: the span in which each begins, to find others from there
//     rows       of each motion its controls, eight numbers each; of generators and relative motors, their logarithms
//     bases      what exponentials are multiplied with: of generators one motor, of cumulative motions every control
#pragma once

#include "../view.h"
#include "description.h"

namespace motorway {

constexpr std::uint32_t compiled_magic = 0x4d574d31; // "MWM1"

struct compiled_header {
    std::uint32_t magic, scalar_size;
    std::uint32_t kind, degree;
    std::uint64_t motion_count, control_count, span_count, cell_count;
    double begin, end, cells_per_unit;
};

// How many numbers a span takes: where it begins, the inverse of its length, and a factor and a summand for each of
// the ratios of the levels 2 ... degree of the blossom recursion; padded to whole rows of four.
constexpr std::size_t span_size(std::size_t degree) { return (2 + degree * (degree + 1) - 2 + 3) / 4 * 4; }

template <class T> class compiled {
    const compiled_header *header;

    static constexpr std::size_t aligned(std::size_t bytes) { return (bytes + 63) / 64 * 64; }
    const char *bytes(std::size_t offset) const { return reinterpret_cast<const char *>(header) + offset; }

    std::size_t starts_at() const { return aligned(sizeof *header); }
    std::size_t spans_at() const { return aligned(starts_at() + (header->span_count + 1) * sizeof(T)); }
    std::size_t first_at() const
    {
        return aligned(spans_at() + header->span_count * span_size(header->degree) * sizeof(T));
    }
    std::size_t cells_at() const { return aligned(first_at() + header->span_count * sizeof(std::uint32_t)); }
    std::size_t rows_at() const { return aligned(cells_at() + (header->cell_count + 1) * sizeof(std::uint32_t)); }
    std::size_t bases_at() const { return aligned(rows_at() + row_numbers() * sizeof(T)); }
    std::size_t row_numbers() const { return 8 * header->motion_count * header->control_count; }

public:
    explicit compiled(const compiled_header &of) : header(&of) {}

    const compiled_header *operator->() const { return header; }
    mw_motion_kind kind() const { return static_cast<mw_motion_kind>(header->kind); }
    T begin() const { return static_cast<T>(header->begin); }
    T end() const { return static_cast<T>(header->end); }
    std::size_t size() const { return bases_at() + base_numbers() * sizeof(T); }
    std::size_t base_numbers() const
    {
        return has_generators(kind()) ? 8 : kind() == MW_MOTION_CUMULATIVE ? row_numbers() : 0;
    }

    const T *starts() const { return reinterpret_cast<const T *>(bytes(starts_at())); }
    const T *spans() const { return reinterpret_cast<const T *>(bytes(spans_at())); }
    const std::uint32_t *first() const { return reinterpret_cast<const std::uint32_t *>(bytes(first_at())); }
    const std::uint32_t *cells() const { return reinterpret_cast<const std::uint32_t *>(bytes(cells_at())); }
    const T *rows() const { return reinterpret_cast<const T *>(bytes(rows_at())); }
    const T *bases() const { return reinterpret_cast<const T *>(bytes(bases_at())); }
    byte_range range() const { return {address(bytes(0)), address(bytes(0)) + size()}; }
};

// MW_OK if this is a compiled motion of the precision.
template <class T> mw_status check_compiled(const void *motion)
{
    if (!motion)
        return MW_ERROR_NULL;
    if (address(static_cast<const char *>(motion)) % alignof(compiled_header))
        return MW_ERROR_MOTION;
    const auto &header = *static_cast<const compiled_header *>(motion);
    return header.magic == compiled_magic && header.scalar_size == sizeof(T) ? MW_OK : MW_ERROR_MOTION;
}

// The same, and whether it holds so many motions from number `index` on.
template <class T> mw_status check_compiled(const void *motion, std::size_t index, std::size_t count = 1)
{
    const mw_status status = check_compiled<T>(motion);
    if (status != MW_OK)
        return status;
    const std::size_t motions = static_cast<const compiled_header *>(motion)->motion_count;
    return index < motions && count <= motions - index ? MW_OK : MW_ERROR_MOTION_INDEX;
}

template <class T> compiled<T> compiled_of(const typename c_types<T>::compiled *motion)
{
    return compiled<T>(*reinterpret_cast<const compiled_header *>(motion));
}

} // namespace motorway
