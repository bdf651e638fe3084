// All benchmarks, shape by shape: the kernel on every instruction set, its baselines and the limits of the machine at
// that size, on the same data and measured in turns.
#pragma once

#include "shape.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace motorway::bench {

// What the report needs to know of a kernel or a baseline, for one call: its results; the bytes of the components
// read and written; the bytes from the first element to the last, which strides can make more; and the operations
// of the kernel, counted as fused multiply-adds.
constexpr const char *report_counters[] = {"results",   "bytes_read",   "bytes_written",
                                           "span_read", "span_written", "operations"};

// The names, without running anything.
std::vector<std::string> list_suite(const suite_settings &settings);

// Returns the number of benchmarks.
std::size_t run_suite(const suite_settings &settings, benchmark::BenchmarkReporter &reporter);

} // namespace motorway::bench
