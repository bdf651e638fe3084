// Copies, fills and reads in the widest vectors of the machine that builds this.
#include "limit_memory.h"

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace motorway::bench {
namespace {

#if defined(__AVX512F__)
constexpr std::size_t width = 64;
#elif defined(__AVX__)
constexpr std::size_t width = 32;
#else
constexpr std::size_t width = 16;
#endif
typedef std::int64_t block __attribute__((vector_size(width), may_alias));

constexpr std::size_t unrolled = 4;

#if defined(__AVX512F__)
inline void stream(block *to, block value) { _mm512_stream_si512(reinterpret_cast<__m512i *>(to), (__m512i)value); }
#elif defined(__AVX__)
inline void stream(block *to, block value) { _mm256_stream_si256(reinterpret_cast<__m256i *>(to), (__m256i)value); }
#elif defined(__SSE2__)
inline void stream(block *to, block value) { _mm_stream_si128(reinterpret_cast<__m128i *>(to), (__m128i)value); }
#endif

void copy_library(void *to, const void *from, std::size_t size) { std::memcpy(to, from, size); }

// Makes of a value something that the compiler knows nothing of: else these loops would be taken for memcpy and
// memset, or left out.
inline block opaque(block value)
{
#if defined(__x86_64__) || defined(__i386__)
    asm volatile("" : "+v"(value));
#elif defined(__aarch64__)
    asm volatile("" : "+w"(value));
#endif
    return value;
}

void copy_loop(void *to, const void *from, std::size_t size)
{
    block *out = static_cast<block *>(to);
    const block *in = static_cast<const block *>(from);
    for (std::size_t i = 0; i < size / width; i += unrolled) {
        const block a = opaque(in[i]), b = opaque(in[i + 1]), c = opaque(in[i + 2]), d = opaque(in[i + 3]);
        out[i] = a;
        out[i + 1] = b;
        out[i + 2] = c;
        out[i + 3] = d;
    }
}

void fill_library(void *to, std::size_t size) { std::memset(to, 1, size); }

void fill_loop(void *to, std::size_t size)
{
    block *out = static_cast<block *>(to);
    const block value = opaque(block{1});
    for (std::size_t i = 0; i < size / width; i += unrolled) {
        out[i] = value;
        out[i + 1] = value;
        out[i + 2] = value;
        out[i + 3] = opaque(value);
    }
}

void read_loop(const void *from, std::size_t size)
{
    const block *in = static_cast<const block *>(from);
    block a{}, b{}, c{}, d{};
    for (std::size_t i = 0; i < size / width; i += unrolled) {
        a |= in[i];
        b |= in[i + 1];
        c |= in[i + 2];
        d |= in[i + 3];
    }
    opaque(a | b | c | d);
}

#if defined(__SSE2__)
void copy_nontemporal(void *to, const void *from, std::size_t size)
{
    block *out = static_cast<block *>(to);
    const block *in = static_cast<const block *>(from);
    for (std::size_t i = 0; i < size / width; i += unrolled) {
        const block a = in[i], b = in[i + 1], c = in[i + 2], d = in[i + 3];
        stream(out + i, a);
        stream(out + i + 1, b);
        stream(out + i + 2, c);
        stream(out + i + 3, d);
    }
    _mm_sfence();
}

void fill_nontemporal(void *to, std::size_t size)
{
    block *out = static_cast<block *>(to);
    for (std::size_t i = 0; i < size / width; ++i)
        stream(out + i, block{1});
    _mm_sfence();
}
#endif

} // namespace

std::vector<copy_method> copy_methods()
{
    return {{"library", copy_library},
            {"loop", copy_loop},
#if defined(__SSE2__)
            {"nontemporal", copy_nontemporal},
#endif
    };
}

std::vector<fill_method> fill_methods()
{
    return {{"library", fill_library},
            {"loop", fill_loop},
#if defined(__SSE2__)
            {"nontemporal", fill_nontemporal},
#endif
    };
}

std::vector<read_method> read_methods() { return {{"loop", read_loop}}; }

} // namespace motorway::bench
