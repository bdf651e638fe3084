// One unit an instruction set includes this: the generated kernels, the loops over them, and the table of both.
#pragma once

#include "loop.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

#include "../../generated/kernels/apply_direction.inl"
#include "../../generated/kernels/apply_point.inl"
#include "../../generated/kernels/blend_motor.inl"
#include "../../generated/kernels/compose_motor.inl"
#include "../../generated/kernels/normalize_motor.inl"
#include "../../generated/kernels/reverse_motor.inl"

// Which loop drives a kernel.
template <class K, class T> constexpr kernel<T> loop_of = run<K, T>;
template <class T> constexpr kernel<T> loop_of<blend_motor_one, T> = run_blend_shared<blend_motor_one, T>;
template <class T> constexpr kernel<T> loop_of<blend_motor_each, T> = run_blend_each<blend_motor_each, T>;

} // namespace
} // namespace MOTORWAY_ISA_NAME

#define MOTORWAY_STRING(x) #x
#define MOTORWAY_STRING_OF(x) MOTORWAY_STRING(x)
#define MOTORWAY_JOIN(a, b) a##b
#define MOTORWAY_TABLE(name) MOTORWAY_JOIN(kernels_, name)

extern const kernel_table MOTORWAY_TABLE(MOTORWAY_ISA_NAME);
const kernel_table MOTORWAY_TABLE(MOTORWAY_ISA_NAME) = {
    MOTORWAY_STRING_OF(MOTORWAY_ISA_NAME),
    {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...)                                                                  \
    MOTORWAY_ISA_NAME::loop_of<MOTORWAY_ISA_NAME::verb##_##operand##_##pairing, float>,
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, ...)                                                             \
    MOTORWAY_ISA_NAME::loop_of<MOTORWAY_ISA_NAME::verb##_##operand##_##pairing##_unit, float>,
#include "../../generated/kernel_list.inc"
    },
    {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...)                                                                  \
    MOTORWAY_ISA_NAME::loop_of<MOTORWAY_ISA_NAME::verb##_##operand##_##pairing, double>,
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, ...)                                                             \
    MOTORWAY_ISA_NAME::loop_of<MOTORWAY_ISA_NAME::verb##_##operand##_##pairing##_unit, double>,
#include "../../generated/kernel_list.inc"
    },
};

} // namespace motorway
