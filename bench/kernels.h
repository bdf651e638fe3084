// The rows of generated/kernel_list.inc as benchmarks. A row for which nobody has written in kernels.cpp what its
// arguments are and how it is called (kernel_of_<verb>_<operand>_<pairing>) does not compile.
#pragma once

#include "problem.h"
#include "work.h"

#include <string>
#include <vector>

namespace motorway::bench {

struct kernel_row {
    std::string name; // "apply_point_each-unit"
    bool unit;        // relies on normalised motors
    std::size_t operations; // an element, as generated/kernel_list.inc has it: of a blend, an element and term
    bench::arguments arguments;
    std::size_t terms;
    work (*bind_f32)(const problem<float> &);
    work (*bind_f64)(const problem<double> &);

    // The kernel through the C API, whatever instruction set is selected when it runs.
    work bind(const problem<float> &problem) const { return bind_f32(problem); }
    work bind(const problem<double> &problem) const { return bind_f64(problem); }
};

const std::vector<kernel_row> &kernel_rows();

} // namespace motorway::bench
