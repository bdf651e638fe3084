// What the call layer and the kernels say to each other: plain data, no functions that a kernel calls, so that nothing of it
// is linked twice.
#pragma once

#include "../strict_math.h"

#include <cstddef>

namespace motorway {

// How the elements of a stream lie in memory. Each has its own loads and stores; `scattered` covers everything.
enum class layout : unsigned char {
    soa,         // one contiguous array a component
    packed,      // the components adjacent, and the elements too
    interleaved, // the components adjacent, any stride: vertex buffers
    scattered,   // any base pointers, any stride
};

// An array of elements: a base pointer a component, and the bytes from an element to the next.
template <class T> struct stream {
    T *const *component;
    std::size_t stride;
    layout kind;
};

// One index an element, of 1, 2 or 4 bytes.
struct index_stream {
    const void *first;
    std::size_t stride;
    unsigned size;
};

// One call of a kernel, validated. T is what it computes in, and E what the elements are made of: float in mixed
// calls, else T. Streams are in the order of the kernel's formula. No field is ever unset: a kernel may read any of
// them, whatever its pairing.
template <class T, class E = T> struct call {
    const stream<E> *out;      // one an output
    const stream<const E> *in; // one an input; of a blend the weights, and then the controls of each term
    std::size_t count;
    const T *fixed; // what all elements share: the motor of `one`, a shift, or the controls of a blend
    bool streaming; // `apply`: results may go past the caches, where they can. Whoever sets it fences

    std::size_t terms = 0;       // of a blend
    stream<const T> motors = {}; // `each`: of every element; `grid`: of every row
    const T *palette = nullptr;  // `indexed`
    index_stream indices = {};   // `indexed`
    std::size_t rows = 0;        // `grid`: how many motors
    std::size_t row_stride = 0;  // `grid`: bytes from a motor's results to those of the next

    // Field by field: what is cleared as a whole is cleared by `rep stos`, which shows in the time of a small batch.
    call(const stream<E> *to, const stream<const E> *from, std::size_t elements, const T *shared = nullptr,
         bool past_caches = false)
        : out(to), in(from), count(elements), fixed(shared), streaming(past_caches)
    {
    }
};

template <class T, class E = T> using kernel = void (*)(const call<T, E> &);

// ------------------------------------------------------------------------------------------------------- motions

// What becomes of a parameter outside the domain. `none` is outside after the check.
enum class outside : unsigned char { none, clamp, wrap };

// Samples of compiled motions (../motion/compiled.h): of one at every parameter, or of one after the other.
//
// Span j is for starts[j] <= t < starts[j + 1], the last one for its end as well. It has span_size numbers: its start,
// the inverse of its length, which give the local parameter u, and for level r = 2 ... degree of the blossom recursion
// and k = 0 ... r - 1 a factor and a summand, which make the ratio of u in which neighbours k and k + 1 are combined.
// That of level 1 is u. Its controls are degree + 1 rows of eight numbers from row first[j] on.
// cells[i] is a span at or before that of the parameters begin + (i ... i + 1) / cells_per_unit.
template <class T> struct motion_call {
    const stream<T> *out = nullptr; // the motors; then the twists, where the kernel makes them
    const T *parameters = nullptr;
    std::size_t count = 0;
    bool one_parameter = false; // for all samples

    T begin = 0, end = 0, cells_per_unit = 0;
    outside treatment = outside::none;
    bool body_frame = false; // twists

    std::size_t degree = 0, span_count = 0, cell_count = 0, span_size = 0;
    const T *starts = nullptr, *spans = nullptr;
    const unsigned *first = nullptr, *cells = nullptr;
    const T *rows = nullptr, *bases = nullptr;
    std::size_t motion_stride = 0; // numbers from a motion's rows to those of the next: 0 is one for all
    bool base_per_row = false;     // a base belongs to each row, or one to all
};

// How a pose is made of the controls of a span.
enum class scheme { additive, multiplicative, cumulative, generator, count };

template <class T> struct motion_kernels {
    // Whether all parameters are in the domain; with clamp and wrap, whether they are finite.
    bool (*are_sound)(const motion_call<T> &);
    void (*sample[static_cast<int>(scheme::count)])(const motion_call<T> &);
    void (*sample_twist[static_cast<int>(scheme::count)])(const motion_call<T> &);
};

// Every kernel by its name.
enum class kernel_id {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...) verb##_##operand##_##pairing,
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, ...) verb##_##operand##_##pairing##_unit,
#include "../../generated/kernel_list.inc"
    count
};
enum class mixed_kernel_id {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...)
#define MOTORWAY_KERNEL_MIXED(verb, operand, pairing, ...) verb##_##operand##_##pairing,
#include "../../generated/kernel_list.inc"
    count
};

// All kernels of one instruction set.
struct kernel_table {
    const char *isa;
    void (*fence)(); // to be called once after streaming calls: puts their stores before all that follows
    kernel<float> f32[static_cast<int>(kernel_id::count)];
    kernel<double> f64[static_cast<int>(kernel_id::count)];
    kernel<double, float> mixed[static_cast<int>(mixed_kernel_id::count)];
    motion_kernels<float> motions_f32;
    motion_kernels<double> motions_f64;
};

} // namespace motorway
