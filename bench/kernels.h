// The rows of generated/kernel_list.inc as benchmarks, and what is made of them. A row for which kernels.cpp does not
// say what its arguments are and how it is called does not compile.
#pragma once

#include "problem.h"
#include "work.h"

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace motorway::bench {

// Makes the call of a kernel on the data of a problem, with flags where it has them.
template <class T, class M = T> using binding = std::function<work(const problem<T, M> &, unsigned flags)>;

// What a kernel takes and makes, and its functions of the C API, which run whatever instruction set is selected.
// Null: it has none.
struct kernel {
    bench::arguments arguments;
    binding<float> f32;
    binding<double> f64;
    binding<float, double> mixed;
};

struct kernel_row : kernel {
    std::string verb;       // "apply"
    std::string name;       // "apply_point_each-unit": -unit relies on normalised motors
    std::size_t operations; // a result, as generated/kernel_list.inc has it: of a blend, a result and term
    std::size_t terms;
    unsigned flags;

    template <class T, class M> work bind(const problem<T, M> &problem) const
    {
        if constexpr (!std::is_same_v<T, M>)
            return mixed(problem, flags);
        else if constexpr (sizeof(T) == sizeof(float))
            return f32(problem, flags);
        else
            return f64(problem, flags);
    }
};

const std::vector<kernel_row> &kernel_rows();

} // namespace motorway::bench
