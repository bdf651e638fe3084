// The rows of generated/kernel_list.inc as benchmarks. A row of a verb, an operand or a pairing for which kernels.cpp
// does not say what its arguments are and how it is called does not compile.
#pragma once

#include "problem.h"
#include "work.h"

#include <string>
#include <type_traits>
#include <vector>

namespace motorway::bench {

// Makes the call of a kernel on the data of a problem.
template <class T, class M = T> using binding = work (*)(const problem<T, M> &);

struct kernel_row {
    std::string verb;       // "apply"
    std::string name;       // "apply_point_each-unit": -unit relies on normalised motors
    std::size_t operations; // a result, as generated/kernel_list.inc has it: of a blend, a result and term
    bench::arguments arguments;
    std::size_t terms;
    // The kernel through the C API, whatever instruction set is selected when it runs. Null: it has none.
    binding<float> f32 = nullptr;
    binding<double> f64 = nullptr;
    binding<float, double> mixed = nullptr;

    template <class T, class M> binding<T, M> bind() const
    {
        if constexpr (!std::is_same_v<T, M>)
            return mixed;
        else if constexpr (sizeof(T) == sizeof(float))
            return f32;
        else
            return f64;
    }
};

const std::vector<kernel_row> &kernel_rows();

} // namespace motorway::bench
