// What api.cpp and the kernels say to each other: plain data, no functions, so that nothing of it is linked twice.
#pragma once

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
// calls, else T. Streams are in the order of the kernel's formula. Only what the pairing of a kernel takes is set:
// clearing the rest would show in the time of a small batch.
template <class T, class E = T> struct call {
    const stream<E> *out;      // one an output
    const stream<const E> *in; // one an input; of a blend the weights, and then the controls of each term
    std::size_t count;

    bool streaming;         // `apply`: results may go past the caches, where they can
    const T *fixed;         // what all elements share: the motor of `one`, a shift, or the controls of a blend
    std::size_t terms;      // of a blend
    stream<const T> motors; // `each`: of every element; `grid`: of every row
    const T *palette;       // `indexed`
    index_stream indices;   // `indexed`
    std::size_t rows;       // `grid`: how many motors
    std::size_t row_stride; // `grid`: bytes from a motor's results to those of the next
};

template <class T, class E = T> using kernel = void (*)(const call<T, E> &);

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
};

} // namespace motorway
