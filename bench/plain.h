/* The plain loops that one writes in C and leaves to the compiler: the honest rival. plain.c is compiled once for
 * each compiler and set of flags; every object exports one table. */
#ifndef MOTORWAY_BENCH_PLAIN_H
#define MOTORWAY_BENCH_PLAIN_H

#include <stddef.h>
#include <stdint.h>

/* The loops by the kernel that they stand against: first those that have a mixed precision. */
#define PLAIN_POINT_LOOPS(X)                                                                                         \
    X(apply_point_one)                                                                                               \
    X(apply_point_each)                                                                                              \
    X(apply_point_grid)                                                                                              \
    X(apply_point_indexed)
#define PLAIN_OTHER_LOOPS(X)                                                                                         \
    X(apply_direction_one)                                                                                           \
    X(apply_direction_each)                                                                                          \
    X(apply_direction_grid)                                                                                          \
    X(apply_direction_indexed)                                                                                       \
    X(apply_vertex_one)                                                                                              \
    X(apply_vertex_grid)                                                                                             \
    X(apply_vertex_indexed)                                                                                          \
    X(compose_motor_each)                                                                                            \
    X(compose_motor_hierarchy)                                                                                       \
    X(reverse_motor_each)                                                                                            \
    X(normalize_motor_each)                                                                                          \
    X(blend_motor_one)                                                                                               \
    X(blend_motor_each)                                                                                              \
    X(sample_additive_one)                                                                                           \
    X(sample_additive_one_random)                                                                                    \
    X(sample_additive_each)                                                                                          \
    X(sample_additive_each_shared)

/* Arrays are given by the pointers to their components: all of them in soa, of which packed and strided loops use the
 * first alone. T is what elements are made of, W what rigid motions are made of and what is computed in. Nothing may
 * overlap. Of a grid by columns, the images of an element lie side by side. */
#define PLAIN_TYPES(T, W, precision)                                                                                 \
    struct plain_arguments_##precision {                                                                             \
        T *const *out;                                                                                               \
        const T *const *const *in;                                                                                   \
        const W *const *rigids;  /* a quaternion and a translation of every element */                               \
        const W *fixed;          /* what all elements share: matrices, or dual quaternions */                        \
        const uint16_t *indices; /* of every element's matrix */                                                     \
        const int32_t *parents;  /* of the joints of a skeleton */                                                   \
        const W *controls;       /* of motions, motion after motion: dual quaternions */                             \
        const W *polynomials;    /* of each span those of the weights of its controls, by ascending powers */        \
        W parameter;             /* that all motions share */                                                        \
        size_t count;                                                                                                \
    };                                                                                                               \
    typedef void (*plain_loop_##precision)(const struct plain_arguments_##precision *arguments);                     \
    struct plain_layouts_##precision {                                                                               \
        plain_loop_##precision soa, packed, strided;                                                                 \
    };
PLAIN_TYPES(float, float, f32)
PLAIN_TYPES(double, double, f64)
PLAIN_TYPES(float, double, mixed)
#undef PLAIN_TYPES

#define PLAIN_MEMBERS(name) struct plain_layouts_f32 name##_f32; struct plain_layouts_f64 name##_f64;
#define PLAIN_MIXED_MEMBER(name) struct plain_layouts_mixed name##_mixed;
struct plain_table {
    int needs_avx2, needs_avx512; /* what the compiler was allowed to use */
    PLAIN_POINT_LOOPS(PLAIN_MEMBERS)
    PLAIN_POINT_LOOPS(PLAIN_MIXED_MEMBER)
    PLAIN_OTHER_LOOPS(PLAIN_MEMBERS)
    plain_loop_f32 columns_f32; /* apply_point_grid by columns, packed */
    plain_loop_f64 columns_f64;
    plain_loop_mixed columns_mixed;
};
#undef PLAIN_MEMBERS
#undef PLAIN_MIXED_MEMBER

/* Scalars from an element to the next in strided arrays: of points and all else in vertices, and of motors. */
enum { PLAIN_VERTEX_STRIDE = 8, PLAIN_MOTOR_STRIDE = 12 };

/* Matrices of a grid. The loops know it, as programs know the size of their skeletons. */
enum { PLAIN_MOTORS = 64 };

/* Joints of a skeleton. */
enum { PLAIN_JOINTS = 64 };

/* Terms of a blend. The loops know it, so that compilers can unroll. */
enum { PLAIN_TERMS = 4 };

/* Controls and spans of a motion of degree 3 over [0, 1]. Spans are equally long. */
enum { PLAIN_CONTROLS = 16, PLAIN_SPANS = PLAIN_CONTROLS - 3 };

#endif
