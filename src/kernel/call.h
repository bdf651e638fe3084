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

// One call of a kernel, validated. Streams are in the order of the kernel's formula.
template <class T> struct call {
    stream<T> out;
    const stream<const T> *in;
    const T *fixed;    // what all elements share: the motor, or the controls of a blend
    std::size_t terms; // of a blend
    std::size_t count;
};

template <class T> using kernel = void (*)(const call<T> &);

// Every kernel by its name.
enum class kernel_id {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...) verb##_##operand##_##pairing,
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, ...) verb##_##operand##_##pairing##_unit,
#include "../../generated/kernel_list.inc"
    count
};

// All kernels of one instruction set.
struct kernel_table {
    const char *isa;
    kernel<float> f32[static_cast<int>(kernel_id::count)];
    kernel<double> f64[static_cast<int>(kernel_id::count)];
};

} // namespace motorway
