#include "info_command.h"

#include <cstdio>

#include "cpu_name.h"
#include "error.h"
#include "motorway_views.h"

namespace motorway::tool {
namespace {

struct Kernel {
    const char *verb, *operand, *pairing, *motors;
    int inputs, outputs, operations, divisions;
};

constexpr Kernel KERNELS[] = {
#define MOTORWAY_KERNEL(verb, operand, pairing, inputs, outputs, operations, divisions)                              \
    {#verb, #operand, #pairing, "any", inputs, outputs, operations, divisions},
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, inputs, outputs, operations, divisions)                         \
    {#verb, #operand, #pairing, "unit", inputs, outputs, operations, divisions},
#include "kernel_list.inc"
};

void print_kernel(const Kernel &kernel)
{
    std::printf("  %-10s %-10s %-6s %-6s %5d %6d %11d %10d %10d %10d\n", kernel.verb, kernel.operand, kernel.pairing,
                kernel.motors, kernel.inputs, kernel.outputs, kernel.operations, kernel.divisions,
                4 * (kernel.inputs + kernel.outputs), 8 * (kernel.inputs + kernel.outputs));
}

} // namespace

void run_info()
{
    if (!mw_isa())
        throw Error("MOTORWAY_ISA", mw_status_text(MW_ERROR_ISA));
    std::printf("motorway  %d.%d.%d\n", MW_VERSION_MAJOR, MW_VERSION_MINOR, MW_VERSION_PATCH);
    std::printf("CPU       %s\n", cpu_name().c_str());
    std::printf("ISAs      %s\n", mw_isas());
    std::printf("in use    %s\n\n", mw_isa());
    std::printf("kernels, each for f32 and f64; numbers an element (of a blend: an element and term)\n\n");
    std::printf("  %-10s %-10s %-6s %-6s %5s %6s %11s %10s %10s %10s\n", "verb", "operand", "pairs", "motors",
                "reads", "writes", "operations", "divisions", "bytes f32", "bytes f64");
    for (const Kernel &kernel : KERNELS)
        print_kernel(kernel);
    std::printf("\n  operations: of the class of a fused multiply-add; divisions: with square roots\n");
}

} // namespace motorway::tool
