// Kernels from streams of elements to streams of elements, of any number and size: validated and called.
#pragma once

#include "dispatch.h"
#include "view.h"

#include <algorithm>
#include <tuple>

namespace motorway {

// One number an element, or with stride 0 one for all.
template <class T> struct numbers {
    const T *first;
    std::size_t stride;

    view<const T, 1> as_view() const { return {{first}, stride}; }
};

// What a call writes.
template <class... Views> using outputs = std::tuple<const Views &...>;
template <class... Views> outputs<Views...> into(const Views &...out) { return {out...}; }

// ---------------------------------------------------------------------------------------------------- validation

template <class T, int N> mw_status check_input(const view<const T, N> &in, std::size_t count)
{
    return check_view(in, count);
}
template <class T> mw_status check_input(const numbers<T> &in, std::size_t count)
{
    return in.stride == 0 ? check_array(in.first, 1) : check_view(in.as_view(), count);
}

template <class T, int N> mw_status check_overlap(const view<T, N> &out, const numbers<T> &in, std::size_t count)
{
    return in.stride == 0 ? check_overlap(out, in.first, 1, count) : check_overlap(out, in.as_view(), count);
}

// Two outputs share no byte; no output shares one with an input but for being in place.
template <class T, int N, class... Inputs>
mw_status check_streams(const outputs<view<T, N>> &out, std::size_t count, const Inputs &...in)
{
    mw_status status = check_view(std::get<0>(out), count);
    ((status = status != MW_OK ? status : check_input(in, count)), ...);
    ((status = status != MW_OK ? status : check_overlap(std::get<0>(out), in, count)), ...);
    return status;
}
template <class T, int N, int M, class... Inputs>
mw_status check_streams(const outputs<view<T, N>, view<T, M>> &out, std::size_t count, const Inputs &...in)
{
    const auto &[first, second] = out;
    mw_status status = check_streams(into(first), count, in...);
    status = status != MW_OK ? status : check_streams(into(second), count, in...);
    return status != MW_OK ? status : check_apart(first, second.as_const(), count);
}

// The usual calls, in a few instructions (view.h).
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

template <class T, int N, class... Inputs>
bool is_usual_call(const outputs<view<T, N>> &out, std::size_t count, const Inputs &...in)
{
    const byte_range range = usual_range(std::get<0>(out), count);
    return (is_usual_input(std::get<0>(out), range, in, count) && ...);
}
template <class T, int N, int M, class... Inputs>
bool is_usual_call(const outputs<view<T, N>, view<T, M>> &out, std::size_t count, const Inputs &...in)
{
    const auto &[first, second] = out;
    return !usual_range(first, count).meets(usual_range(second, count)) && is_usual_call(into(first), count, in...) &&
           is_usual_call(into(second), count, in...);
}

// ---------------------------------------------------------------------------------------------------------- calls

// A validated call. `fixed` is what all elements share, if anything.
template <class T, class... Outputs, class... Inputs>
void call_streams(kernel_id id, const T *fixed, const outputs<Outputs...> &out, std::size_t count, const Inputs &...in)
{
    std::apply(
        [&](const auto &...to) {
            const stream<T> to_streams[] = {to.as_stream()...};
            const stream<const T> from[] = {in.as_stream()...};
            find<T>(*kernels(), id)(call<T>{to_streams, from, count, fixed});
        },
        out);
}

template <class T, class... Outputs, int... N>
void call_inputs(kernel_id id, const T *fixed, const outputs<Outputs...> &out, std::size_t count,
                 const view<const T, N> &...in)
{
    call_streams(id, fixed, out, count, in...);
}

// Numbers are a kernel's last input. One for all is repeated, so that it is read like any other.
template <class T, class Output, int... N>
void call_inputs(kernel_id id, const T *fixed, const outputs<Output> &out, std::size_t count,
                 const numbers<T> &parameter, const view<const T, N> &...in)
{
    if (parameter.stride != 0)
        return call_streams(id, fixed, out, count, in..., parameter.as_view());
    constexpr std::size_t chunk = 256;
    T same[chunk];
    std::fill_n(same, std::min(chunk, count), *parameter.first);
    for (std::size_t begin = 0; begin < count; begin += chunk)
        call_streams(id, fixed, into(std::get<0>(out).from(begin)), std::min(chunk, count - begin), in.from(begin)...,
                     view<const T, 1>{{same}, sizeof(T)});
}

// The streams of a call of the API, of which there are some.
template <class... Outputs, class... Inputs>
mw_status check_call(const outputs<Outputs...> &out, std::size_t count, const Inputs &...in)
{
    return is_usual_call(out, count, in...) ? MW_OK : check_streams(out, count, in...);
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

// A call of the API. The inputs are views; numbers, if any, come before them. `fixed` is what all elements share.
template <class T, class... Outputs, class... Inputs>
mw_status run_streams_of(const kernel_choice &kernel, const T *fixed, const outputs<Outputs...> &out, std::size_t count,
                         const Inputs &...in)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (!kernel.flags_known)
        return MW_ERROR_FLAGS;
    if (count == 0)
        return MW_OK;
    const mw_status status = check_call(out, count, in...);
    if (status == MW_OK)
        call_inputs(kernel.id, fixed, out, count, in...);
    return status;
}
template <class T, int... N, class... Inputs>
mw_status run_streams(const kernel_choice &kernel, const outputs<view<T, N>...> &out, std::size_t count,
                      const Inputs &...in)
{
    return run_streams_of(kernel, static_cast<const T *>(nullptr), out, count, in...);
}

} // namespace motorway
