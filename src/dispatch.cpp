#include "dispatch.h"

#include <atomic>
#include <cstdlib>

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

// Best first. A CPU that runs one of them runs all that follow.
const implementation implementations[] = {
#define MOTORWAY_ISA(name) {&kernels_##name, runs_##name},
#include "isa_list.inc"
};
constexpr std::size_t implementation_count = sizeof implementations / sizeof *implementations;

// The best that runs here.
std::size_t best_implementation()
{
    std::size_t best = 0;
    while (!implementations[best].runs()) // the last one does
        ++best;
    return best;
}

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// In any case of letters. Names of instruction sets have small ones.
bool is_named(const char *given, const char *isa)
{
    while (*isa && small_letter(*given) == *isa)
        ++given, ++isa;
    return *given == *isa;
}

const kernel_table *find_isa(const char *name)
{
    for (std::size_t k = best_implementation(); k < implementation_count; ++k)
        if (!name || is_named(name, implementations[k].table->isa))
            return implementations[k].table;
    return nullptr;
}

const char *requested_isa()
{
    const char *name = std::getenv("MOTORWAY_ISA");
    return name && *name ? name : nullptr;
}

// A line that ends with the names of the instruction sets from one on. Made by the compiler: what is made at the first
// call takes the guards of the C++ library, which a program in C does not link.
struct line {
    char characters[256] = {};
    std::size_t length = 0;

    constexpr void append(const char *more)
    {
        while (*more)
            characters[length++] = *more++;
    }
};

constexpr line make_line(const char *beginning, std::size_t first)
{
    const char *const names[] = {
#define MOTORWAY_ISA(name) #name,
#include "isa_list.inc"
    };
    line made;
    made.append(beginning);
    for (std::size_t k = first; k < implementation_count; ++k) {
        made.append(k > first ? ", " : "");
        made.append(names[k]);
    }
    return made;
}

// A line for each that may be the best.
struct lines {
    line of[implementation_count];
};

constexpr lines make_lines(const char *beginning)
{
    lines made{};
    for (std::size_t k = 0; k < implementation_count; ++k)
        made.of[k] = make_line(beginning, k);
    return made;
}

constexpr lines names = make_lines("");
constexpr lines errors =
    make_lines("MOTORWAY_ISA asks for an instruction set that cannot run here; unset it, or set it to one of: ");

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

const char *isa_names() { return names.of[best_implementation()].characters; }

const char *isa_error() { return errors.of[best_implementation()].characters; }

} // namespace motorway
