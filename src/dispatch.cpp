#include "dispatch.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace motorway {

// One table a unit in kernel/, compiled with that instruction set's flags.
#define MOTORWAY_ISA(name) extern const kernel_table kernels_##name;
#include "isa_list.inc"

namespace {

bool runs_scalar() { return true; }

// Those of instruction sets that are not compiled in (MOTORWAY_INSTRUCTION_SETS) are not used.
#if defined(__x86_64__) || defined(__i386__)
[[maybe_unused]] bool runs_sse2() { return __builtin_cpu_supports("sse2"); }
[[maybe_unused]] bool runs_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
[[maybe_unused]] bool runs_avx512()
{
    return runs_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#elif defined(__aarch64__)
[[maybe_unused]] bool runs_neon64() { return true; } // part of the architecture
#endif

struct implementation {
    const kernel_table *table;
    bool (*runs)();
};

// Best first.
const implementation implementations[] = {
#define MOTORWAY_ISA(name) {&kernels_##name, runs_##name},
#include "isa_list.inc"
};

const kernel_table *find_isa(const char *name)
{
    for (const implementation &candidate : implementations)
        if (candidate.runs() && (!name || std::strcmp(name, candidate.table->isa) == 0))
            return candidate.table;
    return nullptr;
}

const char *requested_isa()
{
    const char *name = std::getenv("MOTORWAY_ISA");
    return name && *name ? name : nullptr;
}

// A line of text that is made once.
struct text {
    char characters[256] = {};
    std::size_t length = 0;

    void append(const char *more)
    {
        const int written = std::snprintf(characters + length, sizeof characters - length, "%s", more);
        length += static_cast<std::size_t>(written);
        if (length >= sizeof characters)
            length = sizeof characters - 1;
    }
};

text make_isa_names()
{
    text names;
    for (const implementation &candidate : implementations)
        if (candidate.runs()) {
            names.append(names.length ? ", " : "");
            names.append(candidate.table->isa);
        }
    return names;
}

text make_isa_error()
{
    text error;
    error.append("MOTORWAY_ISA asks for an instruction set that cannot run here; unset it, or set it to one of: ");
    error.append(isa_names());
    return error;
}

// Selected if MOTORWAY_ISA asked for what cannot run. It has no name.
const kernel_table nothing{};

} // namespace

std::atomic<const kernel_table *> selected_kernels{nullptr};

const kernel_table *select_kernels()
{
    const kernel_table *table = selected_kernels.load(std::memory_order_acquire);
    if (!table) {
        // Threads that get here at once all find the same; the first to store wins.
        const kernel_table *found = find_isa(requested_isa());
        table = found ? found : &nothing;
        const kernel_table *expected = nullptr;
        if (!selected_kernels.compare_exchange_strong(expected, table, std::memory_order_acq_rel))
            table = expected;
    }
    return table == &nothing ? nullptr : table;
}

bool select_isa(const char *name)
{
    const kernel_table *table = find_isa(name);
    if (table)
        selected_kernels.store(table, std::memory_order_release);
    return table != nullptr;
}

const char *isa_names()
{
    static const text names = make_isa_names();
    return names.characters;
}

const char *isa_error()
{
    static const text error = make_isa_error();
    return error.characters;
}

} // namespace motorway
