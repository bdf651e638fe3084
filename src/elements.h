// The elements of an apply function, made of one view or, for vertices, of two; and their checks.
#pragma once

#include "view.h"

namespace motorway {

// Parts of N components each, numbered through.
template <class T, int N, int Parts> struct elements {
    static constexpr int parts = Parts, components = N * Parts;
    view<T, N> part[Parts];

    elements from(std::size_t first) const
    {
        elements result = *this;
        for (view<T, N> &each : result.part)
            each = each.from(first);
        return result;
    }
    elements moved_by(std::size_t bytes) const
    {
        elements result = *this;
        for (view<T, N> &each : result.part)
            each = each.moved_by(bytes);
        return result;
    }
};

// Elements of one view, or of the two of vertices.
template <class T, int N> elements<T, N, 1> elements_of(const view<T, N> &v) { return {{v}}; }
template <class T, int N> elements<T, N, 2> elements_of(const view<T, N> &first, const view<T, N> &second)
{
    return {{first, second}};
}
template <class View> auto elements_of(const View *v) -> decltype(elements_of(view_of(v)))
{
    return elements_of(view_of(v));
}
template <class Vertices>
auto elements_of(const Vertices *v) -> decltype(elements_of(view_of(v->position), view_of(v->normal)))
{
    return elements_of(view_of(v ? &v->position : nullptr), view_of(v ? &v->normal : nullptr));
}

// Streams as a kernel takes them. They point into what they were made of.
template <class T, int N, int Parts> struct streams_of {
    stream<T> part[Parts];
    explicit streams_of(const elements<T, N, Parts> &e)
    {
        for (int k = 0; k < Parts; ++k)
            part[k] = e.part[k].as_stream();
    }
};

// ---------------------------------------------------------------------------------------------------- validation

template <class T, int N, int Parts> mw_status check_parts(const elements<T, N, Parts> &e, std::size_t count)
{
    mw_status status = MW_OK;
    for (int k = 0; k < Parts && status == MW_OK; ++k)
        status = check_view(e.part[k], count);
    return status;
}

// Two parts of an output must not share a byte.
template <class T, int N, int Parts> mw_status check_output(const elements<T, N, Parts> &e, std::size_t count)
{
    const mw_status status = check_parts(e, count);
    if constexpr (Parts == 2)
        if (status == MW_OK)
            return check_apart(e.part[0], e.part[1].as_const(), count);
    return status;
}

// Whatever every part of the output must not run into: check(part) of each.
template <class T, int N, int Parts, class Check>
mw_status check_each_part(const elements<T, N, Parts> &e, const Check &check)
{
    mw_status status = MW_OK;
    for (int k = 0; k < Parts && status == MW_OK; ++k)
        status = check(e.part[k]);
    return status;
}

template <class E, int N, int Parts>
mw_status check_elements(const elements<E, N, Parts> &out, const elements<const E, N, Parts> &in, std::size_t count)
{
    return first_error(check_output(out, count), [&] { return check_parts(in, count); }, [&] {
        return check_each_part(out, [&](const view<E, N> &to) {
            return check_each_part(in, [&](const view<const E, N> &from) { return check_overlap(to, from, count); });
        });
    });
}

// The same in a few instructions, for the usual calls of one view; the range of its output for further comparisons,
// empty if the call is none of these.
template <class E, int N, int Parts>
MOTORWAY_INLINE byte_range usual_output(const elements<E, N, Parts> &out, const elements<const E, N, Parts> &in,
                                        std::size_t count)
{
    if constexpr (Parts == 1) {
        const byte_range range = usual_range(out.part[0], count);
        if (is_usual(out.part[0], range, in.part[0], count))
            return range;
    }
    return {0, 0};
}

template <class E, int N, int Parts>
bool is_in_place(const elements<E, N, Parts> &out, const elements<const E, N, Parts> &in)
{
    bool any = false;
    for (int k = 0; k < Parts; ++k)
        any |= is_same(out.part[k], in.part[k]);
    return any;
}

} // namespace motorway
