// The data of one benchmark: the arrays of a kernel in one layout at one count, for the library and its rivals alike.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace motorway::bench {

template <class T> constexpr const char *precision_name = sizeof(T) == sizeof(float) ? "f32" : "f64";

// How the components of an element and the elements of an array lie.
enum class layout {
    packed,  // components adjacent, and elements too
    strided, // components adjacent, elements apart
    soa      // one array a component
};

// An array of elements of several components, in memory of its own.
template <class T> class array {
public:
    // `stride` is the scalars from an element to the next, of which soa takes no notice. Arrays of different `place`
    // start at different cache lines of a page: else the many arrays of a kernel in soa, at a count that is a power
    // of two, would meet in the same sets of the cache.
    array(std::size_t components, std::size_t stride, layout kind, std::size_t count, std::size_t place);

    std::size_t components() const { return component_.size(); }
    std::size_t stride() const { return stride_; } // bytes
    T *const *component() const { return component_.data(); }
    T &at(std::size_t component, std::size_t element) const
    {
        return component_[component][element * (stride_ / sizeof(T))];
    }
    std::size_t span() const { return span_; } // bytes from the first element to the last

private:
    struct release {
        void operator()(T *memory) const { std::free(memory); }
    };
    std::unique_ptr<T[], release> memory_;
    std::vector<T *> component_;
    std::size_t stride_, span_;
};

enum class operand { xyz, motor, weights };

// What a kernel must be given.
enum class motors {
    unit,     // S̄S = 1
    multiples // of unit motors, with a pseudoscalar that is not zero: as sums of motors are
};

// The arguments of a kernel, in the order of its C function.
struct arguments {
    operand out;
    std::vector<operand> in;
    std::size_t fixed; // motors that all elements share
    motors kind;
};

// Terms of a blend.
constexpr std::size_t blend_terms = 4;

template <class T> struct problem {
    std::string kernel; // "apply_point_one"
    layout kind;
    std::size_t count;
    std::vector<array<T>> in;
    std::vector<T> fixed;
    array<T> out;

    problem(std::string name, const arguments &arguments, layout where, std::size_t elements);

    std::size_t bytes_read() const { return count * sizeof(T) * components_in(); }
    std::size_t bytes_written() const { return count * sizeof(T) * out.components(); }
    std::size_t span_read() const;

private:
    std::size_t components_in() const;
};

// "aos", "aos32" with a stride of 32 bytes, or "soa".
template <class T> std::string layout_name(const arguments &arguments, layout kind);

// The bytes of the arrays of a problem, with what strides leave between.
template <class T> std::size_t problem_size(const arguments &arguments, layout kind, std::size_t count);

} // namespace motorway::bench
