// The kernels in use: the widest instruction set of this CPU, or the one that MOTORWAY_ISA asks for.
#pragma once

#include "kernel/call.h"

#include <atomic>

namespace motorway {

// The table in use: null until one is chosen, which the first call does.
extern std::atomic<const kernel_table *> selected_kernels;
const kernel_table *select_kernels();

// The table in use; null if MOTORWAY_ISA asked for one that cannot run here.
inline const kernel_table *kernels()
{
    const kernel_table *table = selected_kernels.load(std::memory_order_acquire);
    return __builtin_expect(table && table->isa, true) ? table : select_kernels();
}

// For tests and benchmarks: use this instruction set from now on. False, and no change, if it cannot run here.
bool select_isa(const char *name);

// The names of the instruction sets that can run here, best first, separated by ", ".
const char *isa_names();

// One line about a MOTORWAY_ISA that cannot run here.
const char *isa_error();

template <class T> kernel<T> find(const kernel_table &table, kernel_id id)
{
    if constexpr (sizeof(T) == sizeof(float))
        return table.f32[static_cast<int>(id)];
    else
        return table.f64[static_cast<int>(id)];
}

// That of the table in use, which there is.
template <class T> kernel<T> kernel_of(kernel_id id) { return find<T>(*kernels(), id); }
template <class T> kernel<double, float> kernel_of(mixed_kernel_id id)
{
    return kernels()->mixed[static_cast<int>(id)];
}

} // namespace motorway
