// One unit an instruction set includes this: the generated kernels, the loops over them, and the table of both.
#pragma once

#include "angles.h"
#include "loop.h"

#if (defined(MOTORWAY_ISA_scalar) || defined(MOTORWAY_ISA_sse2)) && (defined(__AVX__) || defined(__FMA__)) ||         \
    defined(MOTORWAY_ISA_avx2) && defined(__AVX512F__)
#error "This unit must be compiled for its own instruction set and no more: append the flags of src/flags.cmake."
#endif

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

#include "../../generated/kernels.inc"

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway

#include "motion.h"

namespace motorway {

#define MOTORWAY_STRING(x) #x
#define MOTORWAY_STRING_OF(x) MOTORWAY_STRING(x)
#define MOTORWAY_JOIN(a, b) a##b
#define MOTORWAY_TABLE(name) MOTORWAY_JOIN(kernels_, name)

// The loop that drives a kernel: that of its pairing.
#define MOTORWAY_LOOP_OF(kernel, pairing, T, E)                                                                       \
    MOTORWAY_ISA_NAME::run_##pairing<MOTORWAY_ISA_NAME::kernel::arithmetic, T, E>,

extern const kernel_table MOTORWAY_TABLE(MOTORWAY_ISA_NAME);
const kernel_table MOTORWAY_TABLE(MOTORWAY_ISA_NAME) = {
    MOTORWAY_STRING_OF(MOTORWAY_ISA_NAME),
    MOTORWAY_ISA_NAME::fence,
    {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...)                                                                  \
    MOTORWAY_LOOP_OF(verb##_##operand##_##pairing, pairing, float, float)
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, ...)                                                             \
    MOTORWAY_LOOP_OF(verb##_##operand##_##pairing##_unit, pairing, float, float)
#include "../../generated/kernel_list.inc"
    },
    {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...)                                                                  \
    MOTORWAY_LOOP_OF(verb##_##operand##_##pairing, pairing, double, double)
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, ...)                                                             \
    MOTORWAY_LOOP_OF(verb##_##operand##_##pairing##_unit, pairing, double, double)
#include "../../generated/kernel_list.inc"
    },
    {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...)
#define MOTORWAY_KERNEL_MIXED(verb, operand, pairing, ...)                                                            \
    MOTORWAY_LOOP_OF(verb##_##operand##_##pairing##_mixed, pairing, double, float)
#include "../../generated/kernel_list.inc"
    },
    MOTORWAY_ISA_NAME::kernels_of_motions<float>,
    MOTORWAY_ISA_NAME::kernels_of_motions<double>,
};

} // namespace motorway
