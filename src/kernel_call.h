// Kernel calls made of the views of the API, and whether their results are to go past the caches.
#pragma once

#include "dispatch.h"
#include "elements.h"

namespace motorway {

// What a kernel takes, but for what its pairing adds.
template <class T, class E, int N, int Parts> struct kernel_call {
    streams_of<E, N, Parts> to;
    streams_of<const E, N, Parts> from;
    call<T, E> arguments;

    kernel_call(const elements<E, N, Parts> &out, const elements<const E, N, Parts> &in, std::size_t count,
                bool streaming, const T *fixed)
        : to(out), from(in), arguments{to.part, from.part, count, fixed, streaming}
    {
    }
    kernel_call(const kernel_call &) = delete;
};

// Of a call that reads and writes so many bytes.
template <class E, int N, int Parts>
bool is_streaming(const elements<E, N, Parts> &out, const elements<const E, N, Parts> &in, std::size_t bytes,
                  unsigned flags)
{
    if (flags & (MW_STREAMING_STORES | MW_NO_STREAMING_STORES))
        return flags & MW_STREAMING_STORES;
    return bytes > MW_STREAMING_BYTES && !is_in_place(out, in);
}

} // namespace motorway
