/* The plain loops that one writes in C and leaves to the compiler: the honest rival. plain.c is compiled once for
 * each compiler and set of flags; every object exports one table. */
#ifndef MOTORWAY_BENCH_PLAIN_H
#define MOTORWAY_BENCH_PLAIN_H

#include <stddef.h>

/* The loops by the kernel that they stand against. */
#define PLAIN_LOOPS(X)                                                                                               \
    X(apply_point_one)                                                                                               \
    X(apply_point_each)                                                                                              \
    X(apply_direction_one)                                                                                           \
    X(apply_direction_each)                                                                                          \
    X(compose_motor_each)                                                                                            \
    X(reverse_motor_each)                                                                                            \
    X(normalize_motor_each)                                                                                          \
    X(blend_motor_one)                                                                                               \
    X(blend_motor_each)

/* Arrays are given by the pointers to their components: all of them in soa, of which packed and strided loops use the
 * first alone. `fixed` is what all elements share. Nothing may overlap. */
#define PLAIN_TYPES(T, precision)                                                                                    \
    typedef void (*plain_loop_##precision)(T *const *out, const T *const *const *in, const T *fixed, size_t count);  \
    struct plain_layouts_##precision {                                                                               \
        plain_loop_##precision soa, packed, strided;                                                                 \
    };
PLAIN_TYPES(float, f32)
PLAIN_TYPES(double, f64)
#undef PLAIN_TYPES

#define PLAIN_MEMBERS(name) struct plain_layouts_f32 name##_f32; struct plain_layouts_f64 name##_f64;
struct plain_table {
    int needs_avx2, needs_avx512; /* what the compiler was allowed to use */
    PLAIN_LOOPS(PLAIN_MEMBERS)
};
#undef PLAIN_MEMBERS

/* Scalars from an element to the next in strided arrays: of points, and of motors. */
enum { PLAIN_POINT_STRIDE = 8, PLAIN_MOTOR_STRIDE = 12 };

/* Terms of a blend. The loops know it, so that compilers can unroll. */
enum { PLAIN_TERMS = 4 };

#endif
