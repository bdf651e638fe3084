// What the machine itself can do, as benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace motorway::bench {

struct limit {
    std::string name;
    std::function<void(benchmark::State &)> run;
};

// limit_copy/<method>/<bytes>, of which half are read and half are written, limit_fill and limit_read: at the sizes
// just below and just above a footprint, or at it. There are two sizes to an octave.
std::vector<limit> memory_limits(std::size_t footprint);

// limit_fma/<precision>/<isa>: operations a second, each a product and a sum, fused if it can.
std::vector<limit> fma_limits(const std::vector<std::string> &isas);

} // namespace motorway::bench
