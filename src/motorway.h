/* Motorway: batches of motors on point clouds, meshes and motions, in every lane of the CPU.
 *
 * This header is the manual of the C API. src/motorway.hpp is a thin C++17 face of it.
 *
 * MOTORS. A motor holds a rotation and a translation in eight numbers,
 *
 *     S = s + b12 e12 + b13 e13 + b23 e23 + b1i e1∞ + b2i e2∞ + b3i e3∞ + w e123∞,
 *
 * an even-grade 0-free element of the conformal geometric algebra G(4,1), in the order of equation (3) of Hunt,
 * Mullineux, Cripps and Cross, "Free-form additive motions using conformal geometric algebra" (2017), "the paper"
 * below. It moves the point p to P(S̄ p S) divided by its e0 part α = s² + b12² + b13² + b23². A motor need not be
 * normalised: a multiple of it, and a sum of motors, is a motor. Only α = 0 is none. The library takes a motor whose
 * α is finite and at least the smallest normal number of its precision; any other is called degenerate.
 *
 * VIEWS. Every array is given as a view: one base pointer a component, and the stride in bytes from an element to
 * the next. That covers packed arrays, vertex buffers with other attributes between, and one array a component:
 *
 *     mw_xyz_f32_aos(p, 12)        x y z x y z ...      a packed array of float[3]
 *     mw_xyz_f32_aos(p, 32)        x y z . . . . .      the position in a 32-byte vertex
 *     mw_xyz_f32_soa(x, y, z)      three arrays         stride 4
 *
 * All three are fast paths, and a stride need not be a multiple of the alignment of the type. The components of one
 * view may not share bytes.
 *
 * RULES that hold for every function unless its own text says otherwise:
 * - Units are the caller's; angles are radians. Right-handed rotations: from e1 to e2 about e3.
 * - `count` is the number of elements; 0 is allowed, reads and writes nothing, and then pointers may be null.
 * - Nothing is read but the elements of the inputs, nothing written but the elements of `out`: not a byte between
 *   or past them. Nothing at all is written unless MW_OK is returned.
 * - An input may be `out` itself (the same pointers and stride): that works in place. Interleaved views of one
 *   buffer, which have the same stride and no byte in common, are fine. Anything else is MW_ERROR_OVERLAP.
 * - Time is linear in the count, and memory is constant: no function allocates, locks, starts a thread or keeps
 *   state. All may be called from any thread at once. Split a batch over threads by advancing the views.
 * - An element of the result depends on its own inputs alone, to the last bit: not on its place, the count, the
 *   alignment, the layout or the thread; nor on the instruction set within the class of those that fuse a multiply
 *   with an add (avx2, avx512, neon64) or of those that do not (scalar, sse2).
 * - NaN and infinity in an element stay in that element of the result.
 * - f32 functions compute in float, f64 functions in double. Each pair is described once, at its f32 form.
 *
 * INSTRUCTION SETS are chosen when the library is first called, the widest that the CPU has. The environment
 * variable MOTORWAY_ISA (scalar, sse2, avx2, avx512 or neon64) overrides that; if it asks for one that cannot run
 * here every function that works on a batch returns MW_ERROR_ISA, whose text names those that can.
 */
#ifndef MOTORWAY_H
#define MOTORWAY_H

#include <stddef.h>

#define MW_VERSION_MAJOR 0
#define MW_VERSION_MINOR 1
#define MW_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* ------------------------------------------------------------------------------------------------- status --- */

typedef enum mw_status {
    MW_OK = 0,
    MW_ERROR_NULL,             /* a null pointer with a nonzero count */
    MW_ERROR_STRIDE,           /* a stride smaller than the element: components of one view share bytes */
    MW_ERROR_SIZE,             /* count times stride overflows the address space */
    MW_ERROR_OVERLAP,          /* `out` shares bytes with an input without being exactly that input */
    MW_ERROR_FLAGS,            /* a flag that this function does not know */
    MW_ERROR_DEGENERATE_MOTOR, /* a motor whose α is zero, subnormal, infinite or NaN */
    MW_ERROR_AXIS,             /* a rotation axis of length zero, or a number that is not finite */
    MW_ERROR_DEGREE,           /* a degree of 0 or above MW_MAX_DEGREE */
    MW_ERROR_CONTROL_COUNT,    /* fewer control motors than degree + 1 */
    MW_ERROR_KNOT_COUNT,       /* not exactly control_count + degree - 1 knots */
    MW_ERROR_KNOTS,            /* a knot that decreases, is not finite, or is repeated more than degree + 1 times;
                                  or a domain of length zero */
    MW_ERROR_PARAMETER,        /* a parameter outside the domain of the motion, or NaN */
    MW_ERROR_TERM_COUNT,       /* more than MW_MAX_TERMS terms in a blend of separate control arrays */
    MW_ERROR_ISA               /* MOTORWAY_ISA names an instruction set that cannot run here */
} mw_status;

/* What a status means and what to do about it: one line of English without a line end, never null, valid forever.
 * For MW_ERROR_ISA it names the instruction sets that can run here. */
const char *mw_status_text(mw_status status);

/* The name of the instruction set in use, "avx2" say; null if MOTORWAY_ISA asked for one that cannot run here. */
const char *mw_isa(void);

/* The names of all instruction sets that are compiled in and that this CPU runs, best first, separated by ", ". */
const char *mw_isas(void);

/* -------------------------------------------------------------------------------------------------- flags --- */

enum {
    MW_DEFAULT = 0,
    /* The caller promises that every motor is normalised, S̄S = 1 to rounding, which saves a division an element.
     * If one is not, what it moves its element by comes out multiplied by its α. */
    MW_UNIT_MOTORS = 1
};

/* -------------------------------------------------------------------------------------------- data and views --- */

typedef struct mw_motor_f32 { float s, b12, b13, b23, b1i, b2i, b3i, w; } mw_motor_f32;
typedef struct mw_motor_f64 { double s, b12, b13, b23, b1i, b2i, b3i, w; } mw_motor_f64;

/* Points or directions: x, y and z of element i are at byte offset i * stride from x, y and z. */
typedef struct mw_xyz_f32 { float *x, *y, *z; size_t stride; } mw_xyz_f32;
typedef struct mw_xyz_f64 { double *x, *y, *z; size_t stride; } mw_xyz_f64;
typedef struct mw_const_xyz_f32 { const float *x, *y, *z; size_t stride; } mw_const_xyz_f32;
typedef struct mw_const_xyz_f64 { const double *x, *y, *z; size_t stride; } mw_const_xyz_f64;

/* Motors, likewise. */
typedef struct mw_motors_f32 { float *s, *b12, *b13, *b23, *b1i, *b2i, *b3i, *w; size_t stride; } mw_motors_f32;
typedef struct mw_motors_f64 { double *s, *b12, *b13, *b23, *b1i, *b2i, *b3i, *w; size_t stride; } mw_motors_f64;
typedef struct mw_const_motors_f32 {
    const float *s, *b12, *b13, *b23, *b1i, *b2i, *b3i, *w;
    size_t stride;
} mw_const_motors_f32;
typedef struct mw_const_motors_f64 {
    const double *s, *b12, *b13, *b23, *b1i, *b2i, *b3i, *w;
    size_t stride;
} mw_const_motors_f64;

/* Views are made by
 *     mw_[const_]xyz_f32_aos(first, stride)       x, y, z adjacent at `first`, `stride` bytes from element to element
 *     mw_[const_]xyz_f32_soa(x, y, z)             one array a component
 *     mw_[const_]motors_f32_aos(first, stride)    mw_motor_f32 at `first`, `stride` bytes from element to element
 *     mw_[const_]motors_f32_soa(components)       eight arrays, in the order of the paper: s, b12, b13, ... w
 * and the same for f64. They check nothing. */
#define MW_DEFINE_VIEWS(precision, T, qualifier, prefix)                                                              \
    static inline mw_##prefix##xyz_##precision mw_##prefix##xyz_##precision##_aos(qualifier T *first, size_t stride)  \
    {                                                                                                                 \
        mw_##prefix##xyz_##precision view;                                                                            \
        view.x = first;                                                                                               \
        view.y = first ? first + 1 : NULL;                                                                            \
        view.z = first ? first + 2 : NULL;                                                                            \
        view.stride = stride;                                                                                         \
        return view;                                                                                                  \
    }                                                                                                                 \
    static inline mw_##prefix##xyz_##precision mw_##prefix##xyz_##precision##_soa(qualifier T *x, qualifier T *y,     \
                                                                                  qualifier T *z)                     \
    {                                                                                                                 \
        mw_##prefix##xyz_##precision view;                                                                            \
        view.x = x;                                                                                                   \
        view.y = y;                                                                                                   \
        view.z = z;                                                                                                   \
        view.stride = sizeof(T);                                                                                      \
        return view;                                                                                                  \
    }                                                                                                                 \
    static inline mw_##prefix##motors_##precision mw_##prefix##motors_##precision##_aos(                              \
        qualifier mw_motor_##precision *first, size_t stride)                                                         \
    {                                                                                                                 \
        mw_##prefix##motors_##precision view = {NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0};                   \
        if (first) {                                                                                                  \
            view.s = &first->s;                                                                                       \
            view.b12 = &first->b12;                                                                                   \
            view.b13 = &first->b13;                                                                                   \
            view.b23 = &first->b23;                                                                                   \
            view.b1i = &first->b1i;                                                                                   \
            view.b2i = &first->b2i;                                                                                   \
            view.b3i = &first->b3i;                                                                                   \
            view.w = &first->w;                                                                                       \
        }                                                                                                             \
        view.stride = stride;                                                                                         \
        return view;                                                                                                  \
    }                                                                                                                 \
    static inline mw_##prefix##motors_##precision mw_##prefix##motors_##precision##_soa(                              \
        qualifier T *const components[8])                                                                             \
    {                                                                                                                 \
        mw_##prefix##motors_##precision view;                                                                         \
        view.s = components[0];                                                                                       \
        view.b12 = components[1];                                                                                     \
        view.b13 = components[2];                                                                                     \
        view.b23 = components[3];                                                                                     \
        view.b1i = components[4];                                                                                     \
        view.b2i = components[5];                                                                                     \
        view.b3i = components[6];                                                                                     \
        view.w = components[7];                                                                                       \
        view.stride = sizeof(T);                                                                                      \
        return view;                                                                                                  \
    }

#define MW_MUTABLE
MW_DEFINE_VIEWS(f32, float, MW_MUTABLE, )
MW_DEFINE_VIEWS(f32, float, const, const_)
MW_DEFINE_VIEWS(f64, double, MW_MUTABLE, )
MW_DEFINE_VIEWS(f64, double, const, const_)
#undef MW_MUTABLE
#undef MW_DEFINE_VIEWS

/* ---------------------------------------------------------------------------------------------- making motors --- */

/* The translation by `offset`: 1 + ½ t e∞ (the paper's lemma 3.10). MW_ERROR_NULL. */
mw_status mw_translation_f32(mw_motor_f32 *out, const float offset[3]);
mw_status mw_translation_f64(mw_motor_f64 *out, const double offset[3]);

/* The rotation by `angle` about the axis through `point` (null: the origin) along `axis`, of any length but zero:
 * cos θ/2 + sin θ/2 (b + (b∧q) e∞) with b = a e123 (lemma 3.11). Computed in double, rounded once.
 * MW_ERROR_NULL; MW_ERROR_AXIS if the axis has length zero or any number is not finite. */
mw_status mw_rotation_f32(mw_motor_f32 *out, const float axis[3], float angle, const float point[3]);
mw_status mw_rotation_f64(mw_motor_f64 *out, const double axis[3], double angle, const double point[3]);

/* One pass over the motors: MW_ERROR_DEGENERATE_MOTOR if one is degenerate, and then *first_bad (unless that
 * pointer is null) is the index of the first. The batched functions below do not make this pass: they turn a
 * degenerate motor into results that are not finite or meaningless, in that element alone.
 * MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE. */
mw_status mw_check_motors_f32(mw_const_motors_f32 motors, size_t count, size_t *first_bad);
mw_status mw_check_motors_f64(mw_const_motors_f64 motors, size_t count, size_t *first_bad);

/* ------------------------------------------------------------------------------------------ applying motors --- */

/* out[i] = F_S(points[i]), the points moved by one motor, which need not be normalised (the paper's section 3).
 * The motor is expanded once into twelve coefficients; then it is 9 fused multiply-adds a point.
 * MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS; MW_ERROR_DEGENERATE_MOTOR. */
mw_status mw_apply_point_one_f32(mw_xyz_f32 out, const mw_motor_f32 *motor, mw_const_xyz_f32 points, size_t count,
                                 unsigned flags);
mw_status mw_apply_point_one_f64(mw_xyz_f64 out, const mw_motor_f64 *motor, mw_const_xyz_f64 points, size_t count,
                                 unsigned flags);

/* out[i] = F_S(points[i]) with S = motors[i].
 * Flags: MW_UNIT_MOTORS. Errors: as apply_point_one, but for degenerate motors: see mw_check_motors. */
mw_status mw_apply_point_each_f32(mw_xyz_f32 out, mw_const_motors_f32 motors, mw_const_xyz_f32 points, size_t count,
                                  unsigned flags);
mw_status mw_apply_point_each_f64(mw_xyz_f64 out, mw_const_motors_f64 motors, mw_const_xyz_f64 points, size_t count,
                                  unsigned flags);

/* The same for directions, which a motor rotates and does not translate: normals, tangents, velocities. */
mw_status mw_apply_direction_one_f32(mw_xyz_f32 out, const mw_motor_f32 *motor, mw_const_xyz_f32 directions,
                                     size_t count, unsigned flags);
mw_status mw_apply_direction_one_f64(mw_xyz_f64 out, const mw_motor_f64 *motor, mw_const_xyz_f64 directions,
                                     size_t count, unsigned flags);
mw_status mw_apply_direction_each_f32(mw_xyz_f32 out, mw_const_motors_f32 motors, mw_const_xyz_f32 directions,
                                      size_t count, unsigned flags);
mw_status mw_apply_direction_each_f64(mw_xyz_f64 out, mw_const_motors_f64 motors, mw_const_xyz_f64 directions,
                                      size_t count, unsigned flags);

/* ----------------------------------------------------------------------------------------- combining motors --- */

/* out[i] = first[i] then[i], the geometric product: the motor that does `first` and then `then` (F_UV = F_V F_U,
 * lemma 3.5). MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_compose_motor_each_f32(mw_motors_f32 out, mw_const_motors_f32 first, mw_const_motors_f32 then,
                                    size_t count);
mw_status mw_compose_motor_each_f64(mw_motors_f64 out, mw_const_motors_f64 first, mw_const_motors_f64 then,
                                    size_t count);

/* out[i] = the reverse of motors[i]: the opposite motion, and for a normalised motor its inverse.
 * MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_reverse_motor_each_f32(mw_motors_f32 out, mw_const_motors_f32 motors, size_t count);
mw_status mw_reverse_motor_each_f64(mw_motors_f64 out, mw_const_motors_f64 motors, size_t count);

/* out[i] = the motor of the same motion with S̄S = 1: motors[i] divided by the square root of the pseudoscalar
 * S̄S = α + βω (lemma 3.4, corollary 3.7), so that the translation is right as well. The sign of s is kept.
 * MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP; degenerate motors: see mw_check_motors. */
mw_status mw_normalize_motor_each_f32(mw_motors_f32 out, mw_const_motors_f32 motors, size_t count);
mw_status mw_normalize_motor_each_f64(mw_motors_f64 out, mw_const_motors_f64 motors, size_t count);

/* The weights of a blend: `term_count` base pointers, one a term, and one byte stride: the weight of term k in
 * element i is at byte offset i * stride from terms[k]. N rows of K adjacent weights are terms[k] = first + k with
 * stride K * sizeof(float); K columns of N weights are terms[k] = first + k * N with stride sizeof(float). */
typedef struct mw_weights_f32 { const float *const *terms; size_t stride; } mw_weights_f32;
typedef struct mw_weights_f64 { const double *const *terms; size_t stride; } mw_weights_f64;

/* out[i] = Σk weights[i][k] controls[k]: weighted sums of the same control motors, term after term in the order
 * k = 0, 1, ... The result is not normalised and need not be (the paper's section 4). It is degenerate where
 * controls of opposite sign cancel.
 * Without terms (term_count = 0) every sum is the zero motor.
 * MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. Time: count * term_count. */
mw_status mw_blend_motor_one_f32(mw_motors_f32 out, const mw_motor_f32 *controls, mw_weights_f32 weights,
                                 size_t term_count, size_t count);
mw_status mw_blend_motor_one_f64(mw_motors_f64 out, const mw_motor_f64 *controls, mw_weights_f64 weights,
                                 size_t term_count, size_t count);

/* out[i] = Σk weights[i][k] controls[k][i]: as above, each element with control motors of its own; controls[k] is
 * the view of all elements' k-th control. At most MW_MAX_TERMS terms.
 * The errors of blend_motor_one; MW_ERROR_TERM_COUNT. */
enum { MW_MAX_TERMS = 256 };
mw_status mw_blend_motor_each_f32(mw_motors_f32 out, const mw_const_motors_f32 *controls, mw_weights_f32 weights,
                                  size_t term_count, size_t count);
mw_status mw_blend_motor_each_f64(mw_motors_f64 out, const mw_const_motors_f64 *controls, mw_weights_f64 weights,
                                  size_t term_count, size_t count);

/* ------------------------------------------------------------------------------------------------- motions --- */

enum { MW_MAX_DEGREE = 31 };

/* An additive B-spline motion S(t) = Σ N_i(t) S_i (the paper's section 4), of any degree d from 1 to MW_MAX_DEGREE.
 * The knots t_0 <= t_1 <= ... are those of the paper: control i belongs to the d consecutive knots from t_i, so
 * there are control_count + degree - 1 of them, without the two superfluous ones that some libraries add at the
 * ends. The domain is [t_(d-1), t_(n)] with n = control_count - 1.
 *
 *     linear        degree 1, 2 controls, knots 0 1                    equation (5)
 *     Bézier        degree d, d + 1 controls, knots 0 (d times) 1 (d times)
 *     figure 5      degree 2, 6 controls, knots 0 0 1 2 3 4 4
 *
 * All arrays are the caller's and are only read. */
typedef struct mw_bspline_f32 {
    const mw_motor_f32 *controls;
    size_t control_count;
    const float *knots;
    size_t knot_count;
    unsigned degree;
} mw_bspline_f32;
typedef struct mw_bspline_f64 {
    const mw_motor_f64 *controls;
    size_t control_count;
    const double *knots;
    size_t knot_count;
    unsigned degree;
} mw_bspline_f64;

/* All that can be wrong with a motion. *where (unless that pointer is null) is then the index of the control
 * (MW_ERROR_DEGENERATE_MOTOR) or of the knot (MW_ERROR_KNOTS), else 0.
 * MW_ERROR_NULL, MW_ERROR_DEGREE, MW_ERROR_CONTROL_COUNT, MW_ERROR_KNOT_COUNT, MW_ERROR_KNOTS,
 * MW_ERROR_DEGENERATE_MOTOR. Time: linear in controls and knots. */
mw_status mw_check_bspline_f32(const mw_bspline_f32 *motion, size_t *where);
mw_status mw_check_bspline_f64(const mw_bspline_f64 *motion, size_t *where);

/* out[i] = S(parameters[i]), not normalised: made for mw_apply_*, which needs no normalised motors. At a knot
 * inside the domain the motion is taken from the right. Weights come from the blossom recursion (the paper's
 * section 4, errata.md), then the controls are blended; both ends of a Bézier motion are its controls exactly.
 * Parameters are fastest in runs that lie between the same two knots: sorted ones are.
 * The errors of mw_check_bspline, which is part of the call; MW_ERROR_PARAMETER if a parameter is outside the domain
 * or NaN; MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP (with the parameters, the controls or the
 * knots). Time: linear in controls and knots, and count * degree². */
mw_status mw_sample_bspline_f32(mw_motors_f32 out, const mw_bspline_f32 *motion, const float *parameters,
                                size_t count);
mw_status mw_sample_bspline_f64(mw_motors_f64 out, const mw_bspline_f64 *motion, const double *parameters,
                                size_t count);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
