// Before anything is timed: do all give the same results?
#pragma once

#include "shape.h"

namespace motorway::bench {

// For every shape of which the filter lets anything pass, compares what the kernel gives on all instruction sets and
// what all its baselines give. Throws std::runtime_error where two differ by more than rounding explains.
void verify(const suite_settings &settings);

} // namespace motorway::bench
