// Calls of the kernels that sample compiled motions: checked, and made.
#pragma once

#include "../dispatch.h"
#include "../stream_calls.h"
#include "compiled.h"

#include <algorithm>

namespace motorway {

constexpr unsigned parameter_flags = MW_CLAMP_PARAMETERS | MW_WRAP_PARAMETERS;

template <class T> const motion_kernels<T> &motion_kernels_of(const kernel_table &table)
{
    if constexpr (sizeof(T) == sizeof(float))
        return table.motions_f32;
    else
        return table.motions_f64;
}

inline scheme scheme_of(mw_motion_kind kind)
{
    return kind == MW_MOTION_ADDITIVE         ? scheme::additive
           : kind == MW_MOTION_MULTIPLICATIVE ? scheme::multiplicative
           : kind == MW_MOTION_CUMULATIVE     ? scheme::cumulative
                                              : scheme::generator;
}

// How many motions a call samples.
enum class motions_sampled { one, each };

// Motions to be sampled at parameters. Parameters with another stride than that of an array are copied some at a time.
template <class T> class motion_samples {
    static constexpr std::size_t chunk = 256;
    motion_call<T> arguments;
    int scheme_number;
    numbers<T> parameters;
    std::size_t count;

    // The parameters from number `begin` on, at most a chunk of them.
    motion_call<T> part(std::size_t begin, std::size_t some, T *room) const
    {
        motion_call<T> result = arguments;
        result.count = some;
        result.rows += begin * arguments.motion_stride;
        result.bases += arguments.base_per_row ? begin * arguments.motion_stride : 0;
        result.parameters = parameters.stride == 0 ? parameters.first : parameters.first + begin;
        if (parameters.stride != 0 && parameters.stride != sizeof(T)) {
            for (std::size_t i = 0; i < some; ++i)
                __builtin_memcpy(room + i, bytes_at(begin + i), sizeof(T));
            result.parameters = room;
        }
        return result;
    }
    const char *bytes_at(std::size_t i) const
    {
        return reinterpret_cast<const char *>(parameters.first) + i * parameters.stride;
    }
    template <class Use> bool for_each_part(const Use &use) const
    {
        T room[chunk];
        const std::size_t most = parameters.stride == sizeof(T) || parameters.stride == 0 ? count : chunk;
        for (std::size_t begin = 0; begin < count; begin += most)
            if (!use(begin, part(begin, std::min(most, count - begin), room)))
                return false;
        return true;
    }

public:
    motion_samples(const compiled<T> &motion, motions_sampled which, std::size_t index, const numbers<T> &at,
                   std::size_t number, unsigned flags)
        : scheme_number(static_cast<int>(scheme_of(motion.kind()))), parameters(at), count(number)
    {
        const std::size_t stride = 8 * motion->control_count;
        arguments.one_parameter = at.stride == 0;
        arguments.begin = motion.begin();
        arguments.end = motion.end();
        arguments.cells_per_unit = static_cast<T>(motion->cells_per_unit);
        arguments.treatment = flags & MW_CLAMP_PARAMETERS  ? outside::clamp
                              : flags & MW_WRAP_PARAMETERS ? outside::wrap
                                                           : outside::none;
        arguments.body_frame = flags & MW_BODY_FRAME;
        arguments.degree = motion->degree;
        arguments.span_count = motion->span_count;
        arguments.cell_count = motion->cell_count;
        arguments.span_size = span_size(motion->degree);
        arguments.starts = motion.starts();
        arguments.spans = motion.spans();
        arguments.first = motion.first();
        arguments.cells = motion.cells();
        arguments.rows = motion.rows() + stride * index;
        arguments.base_per_row = motion.kind() == MW_MOTION_CUMULATIVE;
        arguments.bases = motion.bases() + (arguments.base_per_row ? stride * index : 0);
        arguments.motion_stride = which == motions_sampled::each ? stride : 0;
    }

    bool are_sound() const
    {
        const auto check = motion_kernels_of<T>(*kernels()).are_sound;
        return for_each_part([&](std::size_t, const motion_call<T> &part) { return check(part); });
    }
    void sample(const view<T, 8> &out) const
    {
        const auto function = motion_kernels_of<T>(*kernels()).sample[scheme_number];
        for_each_part([&](std::size_t begin, motion_call<T> part) {
            const view<T, 8> here = out.from(begin);
            const stream<T> to[] = {here.as_stream()};
            part.out = to;
            function(part);
            return true;
        });
    }
    void sample_twist(const view<T, 8> &out, const view<T, 6> &twists) const
    {
        const auto function = motion_kernels_of<T>(*kernels()).sample_twist[scheme_number];
        for_each_part([&](std::size_t begin, motion_call<T> part) {
            const view<T, 8> here = out.from(begin);
            const view<T, 6> twists_here = twists.from(begin);
            const stream<T> to[] = {here.as_stream(), twists_here.as_stream()};
            part.out = to;
            function(part);
            return true;
        });
    }
};

// What can be said of a call without its output. `known` are the flags that it takes beside those of parameters.
template <class T>
mw_status check_motion_call(const void *motion, motions_sampled which, std::size_t index, std::size_t count,
                            unsigned flags, unsigned known)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if ((flags & ~(parameter_flags | known)) || (flags & parameter_flags) == parameter_flags)
        return MW_ERROR_FLAGS;
    if (!motion && count == 0)
        return MW_OK;
    return check_compiled<T>(motion, index, which == motions_sampled::each ? count : 1);
}

} // namespace motorway
