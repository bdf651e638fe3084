/* Motorway: batches of motors on point clouds, meshes and motions, in every lane of the CPU.
 *
 * This header is the manual of the C API. motorway.hpp is a thin C++17 face of it. Both are written by
 * codegen/generate.py from the table of public functions in codegen/functions/; do not edit them.
 *
 * CONTENTS
 *
 *     status
 *     flags
 *     data
 *     making motors
 *     applying motors
 *     combining motors
 *     exponentials, interpolation
 *     representations
 *     one twist
 *     motions
 *     making and editing motions
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
 * ARRAYS. Pass a pointer to the first element, and the stride: the number of bytes from one element to the next. The
 * components of an element lie next to each other. Between two elements there may be anything:
 *
 *     points, 12        x y z x y z ...      a packed array of float[3]
 *     vertices, 32      x y z . . . . .      the position in a vertex of 32 bytes
 *     motors, 32        an array of mw_motor_f32
 *
 *     // Move the vertices of a mesh, in place, by one motor:
 *     mw_apply_point_one_f32(v[0].position, sizeof v[0], &motor, v[0].position, sizeof v[0], count, MW_DEFAULT);
 *
 * Any stride will do; it need not be a multiple of the size of a number. To work on a part of a batch, pass a pointer to
 * its first element. Parts give what the whole gives, to the last bit.
 * Does each component have an array of its own, or do they lie in another order? Then pass views: motorway_views.h.
 *
 * RULES. They hold for every function, unless its own text says otherwise:
 * - Units are yours. Angles are radians. Rotations are right-handed: from e1 to e2 about e3.
 * - `count` is the number of elements. If it is 0, nothing is read or written, and pointers may be null.
 * - A call reads the elements of its inputs and writes those of `out`, and no byte between or past them. If it does
 *   not return MW_OK it has written nothing.
 * - You may work in place. `out` may be an input. More exactly: an element of `out` may share bytes with the same
 *   element of an input, in any way, if both have the same stride (or the count is 1) and the same precision. So
 *   matrices may be written over the motors that they are made of, in slots of 16 numbers. Arrays that lie between each
 *   other in one buffer, and have no byte in common, are fine as well.
 *   It is MW_ERROR_OVERLAP if an element of `out` shares a byte with another element of an input; with another output;
 *   or with what a call reads as a whole: one motor, a palette, indices, controls, one parameter for all.
 * - No function allocates, locks, starts a thread or keeps state. Call them from any thread, also on parts of one batch
 *   at once. Time is linear in the count.
 * - A result depends on its own inputs alone, to the last bit: not on its place, the count, the alignment, the layout or
 *   the thread. It is the same on all instruction sets that fuse a multiply with an add (avx2, avx512, neon64), and the
 *   same on all that do not (scalar, sse2).
 * - NaN or infinity in one element stays in that element of the result.
 * - f32 functions compute in float, f64 functions in double. Each pair is described once. `mixed` functions compute in
 *   double: motors are double, elements are float.
 *
 * INSTRUCTION SETS. The first call chooses the widest that the CPU has. The environment variable MOTORWAY_ISA (scalar,
 * sse2, avx2, avx512 or neon64, in any case of letters) overrides that. If it asks for one that cannot run here, every function that works on a
 * batch returns MW_ERROR_ISA, whose text names those that can.
 */
#ifndef MOTORWAY_H
#define MOTORWAY_H

#include <stddef.h>
#include <stdint.h>

#define MW_VERSION_MAJOR 0
#define MW_VERSION_MINOR 1
#define MW_VERSION_PATCH 0
#define MW_VERSION (10000 * MW_VERSION_MAJOR + 100 * MW_VERSION_MINOR + MW_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* Of an enumeration: four bytes, with -fshort-enums too, so that a program and the library always agree. */
#ifdef __GNUC__
#define MW_ENUMERATION __attribute__((__mode__(__SI__)))
#else
#define MW_ENUMERATION
#endif

/* ------------------------------------------------------------------------------------------------- status --- */

typedef enum MW_ENUMERATION mw_status {
    MW_OK = 0,
    MW_ERROR_NULL,             /* a null pointer with a nonzero count */
    MW_ERROR_STRIDE,           /* a stride smaller than the element: components share bytes */
    MW_ERROR_SIZE,             /* count times stride overflows the address space */
    MW_ERROR_OVERLAP,          /* `out` shares bytes with an input, and not in place; or with another output */
    MW_ERROR_FLAGS,            /* a flag that this function does not know, or two that contradict each other */
    MW_ERROR_INDEX,            /* an index that is not below the number of motors in the palette */
    MW_ERROR_INDEX_TYPE,       /* not one of mw_index_type */
    MW_ERROR_DEGENERATE_MOTOR, /* a motor whose α is zero, subnormal, infinite or NaN */
    MW_ERROR_AXIS,             /* a rotation axis of length zero, or a number that is not finite */
    MW_ERROR_MOTION_KIND,      /* not one of mw_motion_kind, or not one that this function takes */
    MW_ERROR_DEGREE,           /* a degree of 0 or above MW_MAX_DEGREE */
    MW_ERROR_CONTROL_COUNT,    /* fewer control poses than the motion needs */
    MW_ERROR_KNOT_COUNT,       /* not as many knots as the controls, the degree and whether it is closed ask for */
    MW_ERROR_KNOTS,            /* a knot that decreases, is not finite, or is repeated more than degree + 1 times;
                                  or a domain of length zero */
    MW_ERROR_WEIGHTS,          /* a weight that is not positive and finite, or so far from 1 that the control times it
                                  has no inverse; or weights of a motion that takes none */
    MW_ERROR_VANISHING,        /* controls of opposite sign cancel somewhere on the way */
    MW_ERROR_PARAMETER,        /* a parameter outside the domain of the motion, or NaN */
    MW_ERROR_MEMORY,           /* memory of the caller's that is too small or not aligned to 8 bytes */
    MW_ERROR_MOTION,           /* what was passed for a compiled motion is none, or is one of the other precision */
    MW_ERROR_MOTION_INDEX,     /* a motion beyond the motion_count of the compiled ones */
    MW_ERROR_CONVERGENCE,      /* no controls were found whose motion passes through the keys */
    MW_ERROR_PARENT,           /* a joint whose parent does not come before it */
    MW_ERROR_MATRIX,           /* a matrix that is no rotation and translation: with scale, shear, a reflection or a
                                  projection, or not finite */
    MW_ERROR_MATRIX_LAYOUT,    /* not one of mw_matrix_layout */
    MW_ERROR_EULER_ORDER,      /* not one of mw_euler_order */
    MW_ERROR_SCALE,            /* a length scale that is zero or not finite */
    MW_ERROR_TERM_COUNT,       /* more than MW_MAX_TERMS terms in a blend of separate control arrays */
    MW_ERROR_ISA               /* MOTORWAY_ISA names an instruction set that cannot run here */
} mw_status;

/* The version of the library that is linked, as 10000 * major + 100 * minor + patch. MW_VERSION is that of the header. */
unsigned mw_version(void);

/* What a status means and what to do about it: one line of English without a line end, never null, valid forever.
 * For MW_ERROR_ISA it names the instruction sets that can run here. */
const char *mw_status_text(mw_status of);

/* The name of the instruction set in use, "avx2" say; null if MOTORWAY_ISA asked for one that cannot run here. */
const char *mw_isa(void);

/* The names of all instruction sets that are compiled in and that this CPU runs, best first, separated by ", ". */
const char *mw_isas(void);

/* -------------------------------------------------------------------------------------------------- flags --- */

enum {
    MW_DEFAULT = 0,
    /* You promise that every motor is normalised: S̄S = 1, to rounding. That saves one division per element where each has
     * a motor of its own, and nothing elsewhere. If a motor is not, its results are wrong: points move α times as far as
     * they should. */
    MW_UNIT_MOTORS = 1,
    /* Results go past the caches straight to memory; or never do. Without either flag they do where that is faster: out
     * of place, in calls that move more than MW_STREAMING_BYTES. Only points, directions and vertices can, if they are
     * packed or have one array per component; a grid only row by row; and only if some element begins a cache line in
     * all components: bases are multiples of sizeof(T) and agree modulo 64. Where they cannot, the flag is no error. It
     * never changes a result. */
    MW_STREAMING_STORES = 2,
    MW_NO_STREAMING_STORES = 4,
    /* Interpolation takes the long way round: by the rotation of more than a half turn. */
    MW_LONG_WAY = 8,
    /* A matrix need not be orthonormal: the rotation nearest to it is taken, where there is one. */
    MW_NEAREST_ROTATION = 16,
    /* Controls of a motion keep their signs: S and -S are the same pose, but the ways between poses differ. */
    MW_KEEP_SIGNS = 32,
    /* Parameters outside the domain of a motion are errors. With one of these they are taken for the nearer end of it, or
     * the domain is repeated for ever. */
    MW_CLAMP_PARAMETERS = 64,
    MW_WRAP_PARAMETERS = 128,
    /* Twists in the frame of the moving body, not of the space. */
    MW_BODY_FRAME = 256,
    /* You promise that every matrix is a rotation and a translation, as mw_check_matrices finds it with the tolerance
     * below. None is looked at. If one is not, its motor is wrong: of a matrix with the scale 2, a rotation
     * by another angle. */
    MW_ROTATION_MATRICES = 512
};

/* How far a matrix may be from a rotation and a translation to be taken for one: the largest element of |RᵀR - 1|, 1510
 * epsilons of float, and 8e9 of double. Matrices written with four decimals, in double with six, are within it (up to
 * 1.74e-4, 1.74e-6), and so are products of a thousand rotations. A scale of 1.0001, in double of 1.000001, is not
 * (2e-4, 2e-6). Nor is what has been float on its way to double and was multiplied often there: MW_NEAREST_ROTATION is
 * for that. The angle of the motor is off by less than twice the distance, in radians: 0.02 degrees at most. */
#define MW_MATRIX_TOLERANCE_F32 1.8e-4f
#define MW_MATRIX_TOLERANCE_F64 1.8e-6

/* Results of calls that read and write more bytes than this bypass the caches. */
enum { MW_STREAMING_BYTES = 32 << 20 };

/* -------------------------------------------------------------------------------------------------- data --- */

typedef struct mw_motor_f32 { float s, b12, b13, b23, b1i, b2i, b3i, w; } mw_motor_f32;
typedef struct mw_motor_f64 { double s, b12, b13, b23, b1i, b2i, b3i, w; } mw_motor_f64;

/* One index per element, into a palette of motors. Indices may lie anywhere, so that one may be a field of a vertex. */
typedef enum MW_ENUMERATION mw_index_type { MW_INDEX_U8 = 1, MW_INDEX_U16 = 2, MW_INDEX_U32 = 4 } mw_index_type;

/* Matrices of rotations and translations, which act on columns: p' = R p + t. Element (r, c) of matrix i is at byte
 * offset i * stride from first[4 r + c] where rows are adjacent, from first[3 c + r] or first[4 c + r] where columns
 * are. 4 x 4 matrices have the last row 0 0 0 1, which is written, and looked at. Libraries in which rows are
 * multiplied from the left (p' = p M, as DirectX has it) keep the transpose: their 4 x 4 matrices by rows are ours by
 * columns, their 4 x 3 ones ours of 3 x 4 by columns. docs/conventions.md has a table. */
typedef enum MW_ENUMERATION mw_matrix_layout {
    MW_MATRIX_ROWS_3X4 = 1, /* 12 numbers: r00 r01 r02 tx  r10 ... */
    MW_MATRIX_ROWS_4X4,     /* 16 numbers: r00 r01 r02 tx  r10 ...  0 0 0 1 */
    MW_MATRIX_COLUMNS_3X4,  /* 12 numbers: r00 r10 r20  r01 ...  tx ty tz */
    MW_MATRIX_COLUMNS_4X4   /* 16 numbers: r00 r10 r20 0  r01 ...  tx ty tz 1 */
} mw_matrix_layout;

/* Three angles, about the axes in the order named, each axis turned by the rotations before it (intrinsic). About axes
 * that stay fixed, the same three angles in the opposite order are the same rotation: fixed x, y, z is
 * MW_EULER_ZYX with the angles reversed. */
typedef enum MW_ENUMERATION mw_euler_order {
    MW_EULER_XYZ, MW_EULER_XZY, MW_EULER_YXZ, MW_EULER_YZX, MW_EULER_ZXY, MW_EULER_ZYX, /* the second in ±π/2 */
    MW_EULER_XYX, MW_EULER_XZX, MW_EULER_YXY, MW_EULER_YZY, MW_EULER_ZXZ, MW_EULER_ZYZ  /* the second in [0, π] */
} mw_euler_order;

/* ---------------------------------------------------------------------------------------------- making motors --- */

/* The translation by `offset`: 1 + ½ t e∞ (the paper's lemma 3.10).
 * Errors: MW_ERROR_NULL. */
mw_status mw_translation_f32(mw_motor_f32 *out, const float offset[3]);
mw_status mw_translation_f64(mw_motor_f64 *out, const double offset[3]);

/* The rotation by `angle` about the axis through `point` (null: the origin) along `axis`, of any length but zero:
 * cos θ/2 + sin θ/2 (b + (b∧q) e∞) with b = a e123 (lemma 3.11). Computed in double, rounded once.
 * Errors: MW_ERROR_NULL, MW_ERROR_AXIS (the axis has length zero, or a number is not finite). */
mw_status mw_rotation_f32(mw_motor_f32 *out, const float axis[3], float angle, const float point[3]);
mw_status mw_rotation_f64(mw_motor_f64 *out, const double axis[3], double angle, const double point[3]);

/* One pass over the motors: MW_ERROR_DEGENERATE_MOTOR if one is degenerate, and then *first_bad (unless that
 * pointer is null) is the index of the first. The batched functions below do not make this pass: they turn a
 * degenerate motor into results that are not finite or meaningless, in that element alone.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_DEGENERATE_MOTOR. */
mw_status mw_check_motors_f32(const mw_motor_f32 *motors, size_t motor_stride, size_t count, size_t *first_bad);
mw_status mw_check_motors_f64(const mw_motor_f64 *motors, size_t motor_stride, size_t count, size_t *first_bad);

/* ------------------------------------------------------------------------------------------ applying motors --- */

/* mw_apply_<operand>_<pairing>_<precision>: every operand in every pairing.
 *
 *     operand     numbers       what becomes of an element under the motor S (the paper's section 3)
 *     point       x y z         F_S(p): rotated and translated
 *     direction   x y z         rotated: normals, velocities
 *     tangent     x y z w       x y z rotated, w passed through, as glTF and engines store tangents
 *     vertex      2 of x y z    a point and a direction in one pass: the position and the normal
 *     vector      e0 ... e3 ei  moved as a whole: of a point, a sphere or a plane the same of its image
 *     line        d, then m     Plücker: the direction, and the moment p × d of any point p on it. The line through the
 *                               images of its points; its length is kept
 *     motor       mw_motor      T^-1 M T of the motor M under T: the same motion about the moved place
 *     bivector    b12 ... b3i   S^-1 B S: the logarithm of a motor, or a twist, moved likewise (the adjoint action).
 *                               In Plücker coordinates, as a twist (ω, velocity of the origin) or a wrench (force,
 *                               torque about the origin), it is a line
 *
 *     pairing     out[i] is element i ...
 *     one         under `motor`, the same for all
 *     each        under motors[i]
 *     indexed     under palette[indices[i]]: rigid parts, instances
 *     grid        under motors[m], for every m: out holds motor_count rows of count elements, and row m begins
 *                 m * row_stride bytes after row 0. Rows one after the other (motor-major) have row_stride >= count *
 *                 out_stride; elements one after the other (point-major), each with its motor_count images side by
 *                 side, have out_stride >= motor_count * row_stride. One of the two must hold.
 *
 * Motors need not be normalised, in any of them. Flags: MW_UNIT_MOTORS, MW_STREAMING_STORES, MW_NO_STREAMING_STORES.
 *
 * A degenerate motor is an error of `one`. The others do not look for one: it makes results that are not finite or
 * meaningless, of its own elements alone (mw_check_motors finds it). A grid is never in place: the range of its output,
 * gaps included, meets no input; and its rows may not run into each other (MW_ERROR_STRIDE).
 *
 * Indices are not looked at either: one past the palette reads outside of it. Call mw_check_indices once per mesh, or
 * mw_apply_<operand>_indexed_checked, which looks at all of them first and writes nothing if one is out of range:
 * MW_ERROR_INDEX, and *first_bad (unless that pointer is null) is the number of the first such element.
 *
 * Cost: `one` and `grid` expand a motor into a matrix once, and then take 9 fused multiply-adds per point; the others
 * take 25 and a division per point, 21 with MW_UNIT_MOTORS. generated/kernel_list.inc has the counts of all.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS, MW_ERROR_DEGENERATE_MOTOR
 * (one), MW_ERROR_INDEX (indexed_checked), MW_ERROR_INDEX_TYPE (indexed, indexed_checked). */

/* All points under one motor. */
mw_status mw_apply_point_one_f32(float *out, size_t out_stride, const mw_motor_f32 *motor, const float *in,
                                 size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_point_one_f64(double *out, size_t out_stride, const mw_motor_f64 *motor, const double *in,
                                 size_t in_stride, size_t count, unsigned flags);

/* Each point under a motor of its own. */
mw_status mw_apply_point_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                  const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_point_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                  const double *in, size_t in_stride, size_t count, unsigned flags);

/* All points under every motor. */
mw_status mw_apply_point_grid_f32(float *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                  size_t motor_stride, size_t motor_count, const float *in, size_t in_stride,
                                  size_t count, unsigned flags);
mw_status mw_apply_point_grid_f64(double *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                  size_t motor_stride, size_t motor_count, const double *in, size_t in_stride,
                                  size_t count, unsigned flags);

/* Each point under the motor of a palette that its index names. */
mw_status mw_apply_point_indexed_f32(float *out, size_t out_stride, const mw_motor_f32 *palette, size_t palette_count,
                                     const void *indices, size_t index_stride, mw_index_type index_type,
                                     const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_point_indexed_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                     size_t palette_count, const void *indices, size_t index_stride,
                                     mw_index_type index_type, const double *in, size_t in_stride, size_t count,
                                     unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_point_indexed_checked_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                             size_t palette_count, const void *indices, size_t index_stride,
                                             mw_index_type index_type, const float *in, size_t in_stride,
                                             size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_point_indexed_checked_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                             size_t palette_count, const void *indices, size_t index_stride,
                                             mw_index_type index_type, const double *in, size_t in_stride,
                                             size_t count, unsigned flags, size_t *first_bad);

/* All directions under one motor. */
mw_status mw_apply_direction_one_f32(float *out, size_t out_stride, const mw_motor_f32 *motor, const float *in,
                                     size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_direction_one_f64(double *out, size_t out_stride, const mw_motor_f64 *motor, const double *in,
                                     size_t in_stride, size_t count, unsigned flags);

/* Each direction under a motor of its own. */
mw_status mw_apply_direction_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                      const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_direction_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                      const double *in, size_t in_stride, size_t count, unsigned flags);

/* All directions under every motor. */
mw_status mw_apply_direction_grid_f32(float *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                      size_t motor_stride, size_t motor_count, const float *in, size_t in_stride,
                                      size_t count, unsigned flags);
mw_status mw_apply_direction_grid_f64(double *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                      size_t motor_stride, size_t motor_count, const double *in, size_t in_stride,
                                      size_t count, unsigned flags);

/* Each direction under the motor of a palette that its index names. */
mw_status mw_apply_direction_indexed_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                         size_t palette_count, const void *indices, size_t index_stride,
                                         mw_index_type index_type, const float *in, size_t in_stride, size_t count,
                                         unsigned flags);
mw_status mw_apply_direction_indexed_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                         size_t palette_count, const void *indices, size_t index_stride,
                                         mw_index_type index_type, const double *in, size_t in_stride, size_t count,
                                         unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_direction_indexed_checked_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                                 size_t palette_count, const void *indices, size_t index_stride,
                                                 mw_index_type index_type, const float *in, size_t in_stride,
                                                 size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_direction_indexed_checked_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                                 size_t palette_count, const void *indices, size_t index_stride,
                                                 mw_index_type index_type, const double *in, size_t in_stride,
                                                 size_t count, unsigned flags, size_t *first_bad);

/* All tangents under one motor. */
mw_status mw_apply_tangent_one_f32(float *out, size_t out_stride, const mw_motor_f32 *motor, const float *in,
                                   size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_tangent_one_f64(double *out, size_t out_stride, const mw_motor_f64 *motor, const double *in,
                                   size_t in_stride, size_t count, unsigned flags);

/* Each tangent under a motor of its own. */
mw_status mw_apply_tangent_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                    const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_tangent_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                    const double *in, size_t in_stride, size_t count, unsigned flags);

/* All tangents under every motor. */
mw_status mw_apply_tangent_grid_f32(float *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                    size_t motor_stride, size_t motor_count, const float *in, size_t in_stride,
                                    size_t count, unsigned flags);
mw_status mw_apply_tangent_grid_f64(double *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                    size_t motor_stride, size_t motor_count, const double *in, size_t in_stride,
                                    size_t count, unsigned flags);

/* Each tangent under the motor of a palette that its index names. */
mw_status mw_apply_tangent_indexed_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                       size_t palette_count, const void *indices, size_t index_stride,
                                       mw_index_type index_type, const float *in, size_t in_stride, size_t count,
                                       unsigned flags);
mw_status mw_apply_tangent_indexed_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                       size_t palette_count, const void *indices, size_t index_stride,
                                       mw_index_type index_type, const double *in, size_t in_stride, size_t count,
                                       unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_tangent_indexed_checked_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                               size_t palette_count, const void *indices, size_t index_stride,
                                               mw_index_type index_type, const float *in, size_t in_stride,
                                               size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_tangent_indexed_checked_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                               size_t palette_count, const void *indices, size_t index_stride,
                                               mw_index_type index_type, const double *in, size_t in_stride,
                                               size_t count, unsigned flags, size_t *first_bad);

/* All vertices under one motor. */
mw_status mw_apply_vertex_one_f32(float *out_positions, float *out_normals, size_t out_stride,
                                  const mw_motor_f32 *motor, const float *in_positions, const float *in_normals,
                                  size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vertex_one_f64(double *out_positions, double *out_normals, size_t out_stride,
                                  const mw_motor_f64 *motor, const double *in_positions, const double *in_normals,
                                  size_t in_stride, size_t count, unsigned flags);

/* Each vertex under a motor of its own. */
mw_status mw_apply_vertex_each_f32(float *out_positions, float *out_normals, size_t out_stride,
                                   const mw_motor_f32 *motors, size_t motor_stride, const float *in_positions,
                                   const float *in_normals, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vertex_each_f64(double *out_positions, double *out_normals, size_t out_stride,
                                   const mw_motor_f64 *motors, size_t motor_stride, const double *in_positions,
                                   const double *in_normals, size_t in_stride, size_t count, unsigned flags);

/* All vertices under every motor. */
mw_status mw_apply_vertex_grid_f32(float *out_positions, float *out_normals, size_t out_stride, size_t row_stride,
                                   const mw_motor_f32 *motors, size_t motor_stride, size_t motor_count,
                                   const float *in_positions, const float *in_normals, size_t in_stride, size_t count,
                                   unsigned flags);
mw_status mw_apply_vertex_grid_f64(double *out_positions, double *out_normals, size_t out_stride, size_t row_stride,
                                   const mw_motor_f64 *motors, size_t motor_stride, size_t motor_count,
                                   const double *in_positions, const double *in_normals, size_t in_stride,
                                   size_t count, unsigned flags);

/* Each vertex under the motor of a palette that its index names. */
mw_status mw_apply_vertex_indexed_f32(float *out_positions, float *out_normals, size_t out_stride,
                                      const mw_motor_f32 *palette, size_t palette_count, const void *indices,
                                      size_t index_stride, mw_index_type index_type, const float *in_positions,
                                      const float *in_normals, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vertex_indexed_f64(double *out_positions, double *out_normals, size_t out_stride,
                                      const mw_motor_f64 *palette, size_t palette_count, const void *indices,
                                      size_t index_stride, mw_index_type index_type, const double *in_positions,
                                      const double *in_normals, size_t in_stride, size_t count, unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_vertex_indexed_checked_f32(float *out_positions, float *out_normals, size_t out_stride,
                                              const mw_motor_f32 *palette, size_t palette_count, const void *indices,
                                              size_t index_stride, mw_index_type index_type,
                                              const float *in_positions, const float *in_normals, size_t in_stride,
                                              size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_vertex_indexed_checked_f64(double *out_positions, double *out_normals, size_t out_stride,
                                              const mw_motor_f64 *palette, size_t palette_count, const void *indices,
                                              size_t index_stride, mw_index_type index_type,
                                              const double *in_positions, const double *in_normals, size_t in_stride,
                                              size_t count, unsigned flags, size_t *first_bad);

/* All vectors under one motor. */
mw_status mw_apply_vector_one_f32(float *out, size_t out_stride, const mw_motor_f32 *motor, const float *in,
                                  size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vector_one_f64(double *out, size_t out_stride, const mw_motor_f64 *motor, const double *in,
                                  size_t in_stride, size_t count, unsigned flags);

/* Each vector under a motor of its own. */
mw_status mw_apply_vector_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                   const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vector_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                   const double *in, size_t in_stride, size_t count, unsigned flags);

/* All vectors under every motor. */
mw_status mw_apply_vector_grid_f32(float *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                   size_t motor_stride, size_t motor_count, const float *in, size_t in_stride,
                                   size_t count, unsigned flags);
mw_status mw_apply_vector_grid_f64(double *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                   size_t motor_stride, size_t motor_count, const double *in, size_t in_stride,
                                   size_t count, unsigned flags);

/* Each vector under the motor of a palette that its index names. */
mw_status mw_apply_vector_indexed_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                      size_t palette_count, const void *indices, size_t index_stride,
                                      mw_index_type index_type, const float *in, size_t in_stride, size_t count,
                                      unsigned flags);
mw_status mw_apply_vector_indexed_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                      size_t palette_count, const void *indices, size_t index_stride,
                                      mw_index_type index_type, const double *in, size_t in_stride, size_t count,
                                      unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_vector_indexed_checked_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                              size_t palette_count, const void *indices, size_t index_stride,
                                              mw_index_type index_type, const float *in, size_t in_stride,
                                              size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_vector_indexed_checked_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                              size_t palette_count, const void *indices, size_t index_stride,
                                              mw_index_type index_type, const double *in, size_t in_stride,
                                              size_t count, unsigned flags, size_t *first_bad);

/* All lines under one motor. */
mw_status mw_apply_line_one_f32(float *out, size_t out_stride, const mw_motor_f32 *motor, const float *in,
                                size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_line_one_f64(double *out, size_t out_stride, const mw_motor_f64 *motor, const double *in,
                                size_t in_stride, size_t count, unsigned flags);

/* Each line under a motor of its own. */
mw_status mw_apply_line_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                 const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_line_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                 const double *in, size_t in_stride, size_t count, unsigned flags);

/* All lines under every motor. */
mw_status mw_apply_line_grid_f32(float *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                 size_t motor_stride, size_t motor_count, const float *in, size_t in_stride,
                                 size_t count, unsigned flags);
mw_status mw_apply_line_grid_f64(double *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                 size_t motor_stride, size_t motor_count, const double *in, size_t in_stride,
                                 size_t count, unsigned flags);

/* Each line under the motor of a palette that its index names. */
mw_status mw_apply_line_indexed_f32(float *out, size_t out_stride, const mw_motor_f32 *palette, size_t palette_count,
                                    const void *indices, size_t index_stride, mw_index_type index_type,
                                    const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_line_indexed_f64(double *out, size_t out_stride, const mw_motor_f64 *palette, size_t palette_count,
                                    const void *indices, size_t index_stride, mw_index_type index_type,
                                    const double *in, size_t in_stride, size_t count, unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_line_indexed_checked_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                            size_t palette_count, const void *indices, size_t index_stride,
                                            mw_index_type index_type, const float *in, size_t in_stride, size_t count,
                                            unsigned flags, size_t *first_bad);
mw_status mw_apply_line_indexed_checked_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                            size_t palette_count, const void *indices, size_t index_stride,
                                            mw_index_type index_type, const double *in, size_t in_stride,
                                            size_t count, unsigned flags, size_t *first_bad);

/* All motors under one motor. */
mw_status mw_apply_motor_one_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motor,
                                 const mw_motor_f32 *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_motor_one_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motor,
                                 const mw_motor_f64 *in, size_t in_stride, size_t count, unsigned flags);

/* Each motor under a motor of its own. */
mw_status mw_apply_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motors,
                                  size_t motor_stride, const mw_motor_f32 *in, size_t in_stride, size_t count,
                                  unsigned flags);
mw_status mw_apply_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motors,
                                  size_t motor_stride, const mw_motor_f64 *in, size_t in_stride, size_t count,
                                  unsigned flags);

/* All motors under every motor. */
mw_status mw_apply_motor_grid_f32(mw_motor_f32 *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                  size_t motor_stride, size_t motor_count, const mw_motor_f32 *in, size_t in_stride,
                                  size_t count, unsigned flags);
mw_status mw_apply_motor_grid_f64(mw_motor_f64 *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                  size_t motor_stride, size_t motor_count, const mw_motor_f64 *in, size_t in_stride,
                                  size_t count, unsigned flags);

/* Each motor under the motor of a palette that its index names. */
mw_status mw_apply_motor_indexed_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *palette,
                                     size_t palette_count, const void *indices, size_t index_stride,
                                     mw_index_type index_type, const mw_motor_f32 *in, size_t in_stride, size_t count,
                                     unsigned flags);
mw_status mw_apply_motor_indexed_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *palette,
                                     size_t palette_count, const void *indices, size_t index_stride,
                                     mw_index_type index_type, const mw_motor_f64 *in, size_t in_stride, size_t count,
                                     unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_motor_indexed_checked_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *palette,
                                             size_t palette_count, const void *indices, size_t index_stride,
                                             mw_index_type index_type, const mw_motor_f32 *in, size_t in_stride,
                                             size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_motor_indexed_checked_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *palette,
                                             size_t palette_count, const void *indices, size_t index_stride,
                                             mw_index_type index_type, const mw_motor_f64 *in, size_t in_stride,
                                             size_t count, unsigned flags, size_t *first_bad);

/* All bivectors under one motor. */
mw_status mw_apply_bivector_one_f32(float *out, size_t out_stride, const mw_motor_f32 *motor, const float *in,
                                    size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_bivector_one_f64(double *out, size_t out_stride, const mw_motor_f64 *motor, const double *in,
                                    size_t in_stride, size_t count, unsigned flags);

/* Each bivector under a motor of its own. */
mw_status mw_apply_bivector_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                     const float *in, size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_bivector_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                     const double *in, size_t in_stride, size_t count, unsigned flags);

/* All bivectors under every motor. */
mw_status mw_apply_bivector_grid_f32(float *out, size_t out_stride, size_t row_stride, const mw_motor_f32 *motors,
                                     size_t motor_stride, size_t motor_count, const float *in, size_t in_stride,
                                     size_t count, unsigned flags);
mw_status mw_apply_bivector_grid_f64(double *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                     size_t motor_stride, size_t motor_count, const double *in, size_t in_stride,
                                     size_t count, unsigned flags);

/* Each bivector under the motor of a palette that its index names. */
mw_status mw_apply_bivector_indexed_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                        size_t palette_count, const void *indices, size_t index_stride,
                                        mw_index_type index_type, const float *in, size_t in_stride, size_t count,
                                        unsigned flags);
mw_status mw_apply_bivector_indexed_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                        size_t palette_count, const void *indices, size_t index_stride,
                                        mw_index_type index_type, const double *in, size_t in_stride, size_t count,
                                        unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_bivector_indexed_checked_f32(float *out, size_t out_stride, const mw_motor_f32 *palette,
                                                size_t palette_count, const void *indices, size_t index_stride,
                                                mw_index_type index_type, const float *in, size_t in_stride,
                                                size_t count, unsigned flags, size_t *first_bad);
mw_status mw_apply_bivector_indexed_checked_f64(double *out, size_t out_stride, const mw_motor_f64 *palette,
                                                size_t palette_count, const void *indices, size_t index_stride,
                                                mw_index_type index_type, const double *in, size_t in_stride,
                                                size_t count, unsigned flags, size_t *first_bad);

/* Two offsets of points, below. */
typedef struct mw_shift { double before[3], after[3]; } mw_shift;

/* Large worlds: motors of double on points of float. out[i] = F_S(points[i] - before) + after, all of it computed in
 * double and rounded once. So points may be stored near an origin of their own, and come out near another, such as
 * the camera: before = -(the origin of the points), after = -(the camera). `shift` null: both are zero.
 * Pairings, flags and errors as above. (Directions need no double: round the motor, and use the f32 functions.)
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS, MW_ERROR_DEGENERATE_MOTOR
 * (one), MW_ERROR_INDEX (indexed_checked), MW_ERROR_INDEX_TYPE (indexed, indexed_checked). */

/* All points under one motor. */
mw_status mw_apply_point_one_mixed(float *out, size_t out_stride, const mw_motor_f64 *motor, const mw_shift *shift,
                                   const float *points, size_t point_stride, size_t count, unsigned flags);

/* Each point under a motor of its own. */
mw_status mw_apply_point_each_mixed(float *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                    const mw_shift *shift, const float *points, size_t point_stride, size_t count,
                                    unsigned flags);

/* All points under every motor. */
mw_status mw_apply_point_grid_mixed(float *out, size_t out_stride, size_t row_stride, const mw_motor_f64 *motors,
                                    size_t motor_stride, size_t motor_count, const mw_shift *shift,
                                    const float *points, size_t point_stride, size_t count, unsigned flags);

/* Each point under the motor of a palette that its index names. */
mw_status mw_apply_point_indexed_mixed(float *out, size_t out_stride, const mw_motor_f64 *palette,
                                       size_t palette_count, const void *indices, size_t index_stride,
                                       mw_index_type index_type, const mw_shift *shift, const float *points,
                                       size_t point_stride, size_t count, unsigned flags);

/* The same after a look at all indices. */
mw_status mw_apply_point_indexed_checked_mixed(float *out, size_t out_stride, const mw_motor_f64 *palette,
                                               size_t palette_count, const void *indices, size_t index_stride,
                                               mw_index_type index_type, const mw_shift *shift, const float *points,
                                               size_t point_stride, size_t count, unsigned flags, size_t *first_bad);

/* One pass over the indices: MW_ERROR_INDEX if one is not below palette_count, and then *first_bad (unless that
 * pointer is null) is the number of the first such element.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_INDEX, MW_ERROR_INDEX_TYPE. */
mw_status mw_check_indices(const void *indices, size_t index_stride, mw_index_type index_type, size_t count,
                           size_t palette_count, size_t *first_bad);

/* ----------------------------------------------------------------------------------------- combining motors --- */

/* out[i] = first[i] then[i], the geometric product: the motor that does `first` and then `then` (F_UV = F_V F_U,
 * lemma 3.5).
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_compose_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                    size_t first_stride, const mw_motor_f32 *then, size_t then_stride, size_t count);
mw_status mw_compose_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                    size_t first_stride, const mw_motor_f64 *then, size_t then_stride, size_t count);

/* The same where one factor is the same for all: out[i] = first then[i], and out[i] = first[i] then.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_compose_motor_one_first_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                         const mw_motor_f32 *then, size_t then_stride, size_t count);
mw_status mw_compose_motor_one_first_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                         const mw_motor_f64 *then, size_t then_stride, size_t count);
mw_status mw_compose_motor_one_then_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                        size_t first_stride, const mw_motor_f32 *then, size_t count);
mw_status mw_compose_motor_one_then_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                        size_t first_stride, const mw_motor_f64 *then, size_t count);

/* Poses along a hierarchy, of many instances at once: out[j][i] = locals[j][i] out[parents[j]][i], the motor that moves
 * from the space of joint j to that of its root, for joints j < joint_count in order and instances i < count.
 * parents[j] < j, or negative for a root, of which out[j][i] = locals[j][i]. The motors of joint j begin
 * j * joint_stride bytes after those of joint 0, of locals and of out alike: instances side by side
 * (joint_stride >= count * out_stride) are a lane each, which is the fast way; skeletons one after the other have
 * out_stride >= joint_count * joint_stride. Joints may not run into each other (MW_ERROR_STRIDE).
 * In place if locals is out; or if a motor of each, such as two fields of a joint, lies within the smaller of the two
 * strides. On MW_ERROR_PARENT *first_bad (unless that pointer is null) is the joint.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_PARENT (parents[j] >= j). */
mw_status mw_compose_motor_hierarchy_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *locals,
                                         size_t local_stride, size_t joint_stride, const int32_t *parents,
                                         size_t joint_count, size_t count, size_t *first_bad);
mw_status mw_compose_motor_hierarchy_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *locals,
                                         size_t local_stride, size_t joint_stride, const int32_t *parents,
                                         size_t joint_count, size_t count, size_t *first_bad);

/* out[i] = the reverse of motors[i]: the opposite motion, and for a normalised motor its inverse.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_reverse_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motors,
                                    size_t motor_stride, size_t count);
mw_status mw_reverse_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motors,
                                    size_t motor_stride, size_t count);

/* out[i] = the motor of the same motion with S̄S = 1: motors[i] divided by the square root of the pseudoscalar
 * S̄S = α + βω (lemma 3.4, corollary 3.7), so that the translation is right as well. The sign of s is kept.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP.
 * Degenerate motors: see mw_check_motors. */
mw_status mw_normalize_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motors,
                                      size_t motor_stride, size_t count);
mw_status mw_normalize_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motors,
                                      size_t motor_stride, size_t count);

/* out[i] = motors[i]^-1 = S̄ / (S̄S), the opposite motion, of motors that need not be normalised (lemma 3.4).
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP.
 * Degenerate motors: see mw_check_motors. */
mw_status mw_inverse_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motors,
                                    size_t motor_stride, size_t count);
mw_status mw_inverse_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motors,
                                    size_t motor_stride, size_t count);

/* out[i] = from[i]^-1 to[i], the relative motor: what is to be done after from[i] to come to to[i], so that composing
 * from[i] and then out[i] gives to[i]. The left factor acts first: as matrices, which act on columns, out is T1 T0^-1,
 * with T0 that of `from` and T1 that of `to`. T0^-1 T1, the pose of `to` as seen from `from`, is another one:
 * mw_inverse_motor_each of `from`, and then mw_compose_motor_each of `to` and that.
 * With MW_UNIT_MOTORS from[i] must be normalised.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS.
 * Degenerate motors: see mw_check_motors. */
mw_status mw_ratio_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *from, size_t from_stride,
                                  const mw_motor_f32 *to, size_t to_stride, size_t count, unsigned flags);
mw_status mw_ratio_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *from, size_t from_stride,
                                  const mw_motor_f64 *to, size_t to_stride, size_t count, unsigned flags);

/* -------------------------------------------------------------------------------- exponentials, interpolation --- */

/* A bivector B generates the motions exp(tB), which are screws: with B = ½θ (b + (b∧q) e∞) + ½ t e∞, b = a e123 and t
 * along a, exp(B) rotates by θ about the axis a through q and moves by t along it (Wareham and Lasenby, section 2).
 * docs/accuracy.md has the errors of these functions and where they come from. None of them branches, but for angles of
 * thousands of turns, and none calls a mathematical library. */

/* out[i] = exp(generators[i]), normalised for every finite angle: |α - 1| is at most 4 epsilons.
 * About a coordinate axis the result is that of libm's sine and cosine to a few epsilons, up to the largest finite
 * angle. About other axes the angle is also rounded, by less than its last bit.
 * Large angles cost more: a register that holds |b| above 8192 (2^27 in double; above 4 where the instruction set does
 * not fuse) takes some 50 ns for each lane that does.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_exp_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *generators,
                                size_t generator_stride, size_t count);
mw_status mw_exp_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *generators,
                                size_t generator_stride, size_t count);

/* out[i] = the logarithm of motors[i] or of -motors[i], which move alike, whichever turns by no more than a half turn:
 * exp(out[i]) is the motor with s >= 0. Translations are exact.
 * Motors need not be normalised; with MW_UNIT_MOTORS they must be, which saves two thirds of the time.
 *
 * log_principal is the same for the motor itself: exp(out[i]) = motors[i], which turns by less than a full turn. Near
 * s = -1 (a full turn) the axis is lost to rounding and the moment grows as 1/sin; where |b| <= 2^-40, as at -1 itself,
 * there is none, and the result is that of mw_log_motor_each.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS.
 * Degenerate motors: see mw_check_motors. */
mw_status mw_log_motor_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors, size_t motor_stride,
                                size_t count, unsigned flags);
mw_status mw_log_motor_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors, size_t motor_stride,
                                size_t count, unsigned flags);
mw_status mw_log_principal_motor_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors,
                                          size_t motor_stride, size_t count, unsigned flags);
mw_status mw_log_principal_motor_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors,
                                          size_t motor_stride, size_t count, unsigned flags);

/* out[i] = the normalised motor that does half of what motors[i], which must be normalised, does the short way.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_sqrt_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motors,
                                 size_t motor_stride, size_t count);
mw_status mw_sqrt_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motors,
                                 size_t motor_stride, size_t count);

/* out[i] = exp(t log S), the power t = exponents[i] of S = motors[i], which must be normalised, by its shortest
 * logarithm: for every t for which t times that is finite. exponents[i] is at byte offset i * exponent_stride;
 * exponent_stride 0: one exponent for all.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_power_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *motors,
                                  size_t motor_stride, const float *exponents, size_t exponent_stride, size_t count);
mw_status mw_power_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *motors,
                                  size_t motor_stride, const double *exponents, size_t exponent_stride, size_t count);

/* out[i] = first[i] (first[i]^-1 second[i])^t, the screw between two poses at t = parameters[i]: first[i] at 0 and
 * ±second[i] at 1, to rounding. Both normalised. parameter_stride as above.
 * It goes the short way, towards second or -second, whichever is nearer. With MW_LONG_WAY it goes the other one, which
 * turns on by what is missing to a full turn (a translation has no long way and takes the short one).
 * The short way is meant for 0 <= t <= 1, and loses little for -1 <= t <= 2. DO NOT USE IT BEYOND: for such t the
 * result is no motion. The long way, and mw_power_motor_each of mw_ratio_motor_each, take any t.
 * The long way between poses that are near to each other is about an axis that they hardly determine: with φ the angle
 * between them, rotations are right within 7 epsilons (8 where nothing fuses) for φ >= 0.1, and within 1/φ epsilons
 * below that.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS. */
mw_status mw_slerp_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                  size_t first_stride, const mw_motor_f32 *second, size_t second_stride,
                                  const float *parameters, size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_slerp_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                  size_t first_stride, const mw_motor_f64 *second, size_t second_stride,
                                  const double *parameters, size_t parameter_stride, size_t count, unsigned flags);

/* Between the same two poses, at many parameters. */
mw_status mw_slerp_motor_one_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                 const mw_motor_f32 *second, const float *parameters, size_t parameter_stride,
                                 size_t count, unsigned flags);
mw_status mw_slerp_motor_one_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                 const mw_motor_f64 *second, const double *parameters, size_t parameter_stride,
                                 size_t count, unsigned flags);

/* out[i] = (1-t) first[i] ± t second[i], normalised ("method 1" of the lecture notes; equation (5) of the paper): the
 * same poses at both ends and almost the same path as slerp, at less than half the cost and at a speed that is not
 * constant. Both normalised; for every t of which the square, times the translations, is finite. The long way
 * (MW_LONG_WAY) is the sum with the other sign, which is degenerate where the two cancel: halfway between equal poses.
 * mw_blend_motor_* is the same without normalising.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_FLAGS. */
mw_status mw_nlerp_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                  size_t first_stride, const mw_motor_f32 *second, size_t second_stride,
                                  const float *parameters, size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_nlerp_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                  size_t first_stride, const mw_motor_f64 *second, size_t second_stride,
                                  const double *parameters, size_t parameter_stride, size_t count, unsigned flags);

/* Between the same two poses, at many parameters. */
mw_status mw_nlerp_motor_one_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first,
                                 const mw_motor_f32 *second, const float *parameters, size_t parameter_stride,
                                 size_t count, unsigned flags);
mw_status mw_nlerp_motor_one_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *first,
                                 const mw_motor_f64 *second, const double *parameters, size_t parameter_stride,
                                 size_t count, unsigned flags);

/* --------------------------------------------------------------------------------------------- representations --- */

/* mw_convert_<a>_to_<b>_each_<precision>: motors from and into what other libraries hold. A single motor is a batch of
 * one; motorway.hpp has that as functions of values. docs/conventions.md compares component orders, signs and
 * senses with those of other libraries, each row of it a test.
 *
 * Wherever there is a rotation and a translation, the rotation acts first: p' = R p + t. Every rotation has two
 * motors, S and -S: of matrices comes the one with s >= 0, of angles that of half of each, so that a full turn
 * more changes the sign, and of quaternions the one with their sign. Motors to be converted need not be normalised,
 * and those made of normalised input are. A motor holds no scale: docs/conventions.md says what to do with one.
 * All: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP; degenerate motors: see mw_check_motors.
 * Error: a few epsilons of the rotation, and of the translation relative to its length; docs/accuracy.md. */

/* Unit quaternions and translations. The sign of the motor is that of the quaternion, and a quaternion of any other
 * length but zero makes a motor of that length, of the same motion: w + z e12 - y e13 + x e23, and then 1 + ½ t e∞.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_convert_motor_to_pose_each_f32(float *quaternions, size_t quaternion_stride, float *translations,
                                            size_t translation_stride, const mw_motor_f32 *motors,
                                            size_t motor_stride, size_t count);
mw_status mw_convert_motor_to_pose_each_f64(double *quaternions, size_t quaternion_stride, double *translations,
                                            size_t translation_stride, const mw_motor_f64 *motors,
                                            size_t motor_stride, size_t count);
mw_status mw_convert_pose_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *quaternions,
                                            size_t quaternion_stride, const float *translations,
                                            size_t translation_stride, size_t count);
mw_status mw_convert_pose_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *quaternions,
                                            size_t quaternion_stride, const double *translations,
                                            size_t translation_stride, size_t count);

/* Dual quaternions r + εd with d = ½ t r, as engines and skinning have them: r = (b23, -b13, b12; s) and
 * d = (b1i, b2i, b3i; -w). Exact. Of any length, and also where r and d are not orthogonal, as in sums of dual
 * quaternions: the motor turns as r does and then moves by the vector part of 2 d r* / |r|², as in skinning.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_convert_motor_to_dual_quaternion_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors,
                                                       size_t motor_stride, size_t count);
mw_status mw_convert_motor_to_dual_quaternion_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors,
                                                       size_t motor_stride, size_t count);
mw_status mw_convert_dual_quaternion_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *in,
                                                       size_t in_stride, size_t count);
mw_status mw_convert_dual_quaternion_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *in,
                                                       size_t in_stride, size_t count);

/* Matrices. All are looked at before any is converted, and one that is no rotation and translation is
 * MW_ERROR_MATRIX: then *first_bad (unless that pointer is null) is the number of the first, and nothing is written.
 * What is meant is the distance of mw_check_matrices, and MW_MATRIX_TOLERANCE_F32 or _F64. That costs about 4 ns per
 * matrix of floats and 7 of doubles, where the conversion takes 2 and 5. With MW_ROTATION_MATRICES none is looked at.
 * With MW_NEAREST_ROTATION comes the rotation nearest to R, in the sum of the squares of the differences: that of a
 * matrix with scale and shear, and of one that reflects as long as a single rotation is nearest. MW_ERROR_MATRIX where
 * none is (a mirror image, which is as near to all its half turns; what leaves no plane of space), of projections, and
 * of numbers that are not finite. Slower by far: one after the other, twice each, by Jacobi's method in double.
 * MW_ERROR_FLAGS also for both flags together.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_MATRIX_LAYOUT, MW_ERROR_MATRIX
 * (matrix_to_motor), MW_ERROR_FLAGS (matrix_to_motor). */
mw_status mw_convert_motor_to_matrix_each_f32(float *out, size_t out_stride, mw_matrix_layout out_layout,
                                              const mw_motor_f32 *motors, size_t motor_stride, size_t count);
mw_status mw_convert_motor_to_matrix_each_f64(double *out, size_t out_stride, mw_matrix_layout out_layout,
                                              const mw_motor_f64 *motors, size_t motor_stride, size_t count);
mw_status mw_convert_matrix_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *matrices,
                                              size_t matrix_stride, mw_matrix_layout matrix_layout, size_t count,
                                              unsigned flags, size_t *first_bad);
mw_status mw_convert_matrix_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *matrices,
                                              size_t matrix_stride, mw_matrix_layout matrix_layout, size_t count,
                                              unsigned flags, size_t *first_bad);

/* One pass over the matrices: MW_ERROR_MATRIX if one is further from a rotation than `tolerance`, and then *first_bad
 * is the number of the first such. Its distance is the largest element of |RᵀR - 1|; of 4 x 4 matrices also how far
 * the last number is from 1. It is infinite if R is a reflection, if the last row does not begin with three zeros (to
 * 16 epsilons: the matrix projects) or if any number is not finite. *deviation is the largest distance of all. Both
 * pointers may be null.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_MATRIX, MW_ERROR_MATRIX_LAYOUT. */
mw_status mw_check_matrices_f32(const float *matrices, size_t matrix_stride, mw_matrix_layout matrix_layout,
                                size_t count, float tolerance, size_t *first_bad, float *deviation);
mw_status mw_check_matrices_f64(const double *matrices, size_t matrix_stride, mw_matrix_layout matrix_layout,
                                size_t count, double tolerance, size_t *first_bad, double *deviation);

/* Axis and angle, and translations: x y z is the axis through the origin, and w the angle, of any finite size. THE AXIS
 * MUST HAVE LENGTH 1, which is not looked at: with another length a it turns by another angle φ, tan φ/2 = a tan θ/2.
 * (mw_rotation takes an axis of any length.) From motors come angles in [0, π]; where it is 0, the axis is z.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_convert_motor_to_axis_angle_each_f32(float *rotations, size_t rotation_stride, float *translations,
                                                  size_t translation_stride, const mw_motor_f32 *motors,
                                                  size_t motor_stride, size_t count);
mw_status mw_convert_motor_to_axis_angle_each_f64(double *rotations, size_t rotation_stride, double *translations,
                                                  size_t translation_stride, const mw_motor_f64 *motors,
                                                  size_t motor_stride, size_t count);
mw_status mw_convert_axis_angle_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *rotations,
                                                  size_t rotation_stride, const float *translations,
                                                  size_t translation_stride, size_t count);
mw_status mw_convert_axis_angle_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *rotations,
                                                  size_t rotation_stride, const double *translations,
                                                  size_t translation_stride, size_t count);

/* Euler angles, and translations: x is the first angle, y the second, z the third, of any finite size. From motors
 * come the first and third angle in [-π, π]. Where these two are about the same axis (gimbal lock: the second angle
 * is ±π/2, or in orders that begin and end with the same axis 0 or π), only their sum or their difference is
 * determined. Then the third is 0 and the first has all of it, on every instruction set: as scipy has it, and
 * engines. That begins where the second angle is within 16 epsilons of those, and costs the rotation as much.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_EULER_ORDER. */
mw_status mw_convert_motor_to_euler_each_f32(float *angles, size_t angle_stride, float *translations,
                                             size_t translation_stride, const mw_motor_f32 *motors,
                                             size_t motor_stride, size_t count, mw_euler_order order);
mw_status mw_convert_motor_to_euler_each_f64(double *angles, size_t angle_stride, double *translations,
                                             size_t translation_stride, const mw_motor_f64 *motors,
                                             size_t motor_stride, size_t count, mw_euler_order order);
mw_status mw_convert_euler_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *angles,
                                             size_t angle_stride, const float *translations,
                                             size_t translation_stride, size_t count, mw_euler_order order);
mw_status mw_convert_euler_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *angles,
                                             size_t angle_stride, const double *translations,
                                             size_t translation_stride, size_t count, mw_euler_order order);

/* Translations alone: 1 + ½ t e∞ (the paper's lemma 3.10); and of any motor where it takes the origin.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_convert_translation_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *translations,
                                                   size_t translation_stride, size_t count);
mw_status mw_convert_translation_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *translations,
                                                   size_t translation_stride, size_t count);
mw_status mw_convert_motor_to_translation_each_f32(float *translations, size_t translation_stride,
                                                   const mw_motor_f32 *motors, size_t motor_stride, size_t count);
mw_status mw_convert_motor_to_translation_each_f64(double *translations, size_t translation_stride,
                                                   const mw_motor_f64 *motors, size_t motor_stride, size_t count);

/* Screws (Chasles): a rotation by `angle` about the axis of direction a, of length 1, through the point p, and a
 * translation by `distance` along it, in any order. The pitch is distance / angle. With distance 0 that is the
 * rotation about a point of lemma 3.11. From motors come angles in [0, π], and the point of the axis that is nearest
 * to the origin. A translation has angle 0, its own direction for the axis, and the origin for the point; so has what
 * turns by less than 2^-59. The identity has the axis z. INTO MOTORS THE AXIS MUST HAVE LENGTH 1, which is not looked
 * at: with another length the angle is wrong as above, and so is the way along the axis.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_convert_motor_to_screw_each_f32(float *out, size_t out_stride, const mw_motor_f32 *motors,
                                             size_t motor_stride, size_t count);
mw_status mw_convert_motor_to_screw_each_f64(double *out, size_t out_stride, const mw_motor_f64 *motors,
                                             size_t motor_stride, size_t count);
mw_status mw_convert_screw_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const float *screws,
                                             size_t screw_stride, size_t count);
mw_status mw_convert_screw_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const double *screws,
                                             size_t screw_stride, size_t count);

/* Rotors as Wareham and Lasenby write them, which act as R x R̃ and in which lengths are measured in units of `lambda`
 * (their embedding, section 1): R = S̃ with its e∞ part divided by lambda, and n for e∞. The components of rotors are
 * in the order of a motor's, e1∞ standing for e1 n. Sign and length are kept, and rotors need not be normalised; exact
 * up to the rounding of 1 / lambda.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_SCALE (lambda is 0 or not finite,
 * or its inverse is not). */
mw_status mw_convert_motor_to_rotor_each_f32(mw_motor_f32 *rotors, size_t rotor_stride, const mw_motor_f32 *motors,
                                             size_t motor_stride, size_t count, float lambda);
mw_status mw_convert_motor_to_rotor_each_f64(mw_motor_f64 *rotors, size_t rotor_stride, const mw_motor_f64 *motors,
                                             size_t motor_stride, size_t count, double lambda);
mw_status mw_convert_rotor_to_motor_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *rotors,
                                             size_t rotor_stride, size_t count, float lambda);
mw_status mw_convert_rotor_to_motor_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_motor_f64 *rotors,
                                             size_t rotor_stride, size_t count, double lambda);

/* -------------------------------------------------------------------------------------------------- one twist --- */

/* What the motor exp(λB) does, in the parts into which Wareham and Lasenby split its generator (section 2.4):
 *     B = ½ angle (axis e123) + ½ (along + across) e∞
 * with `along` parallel to the axis (their t⊥, normal to the plane of rotation) and `across` normal to it (their t∥),
 * and the signs so that exp(B) rotates by `angle` and translates by `along`. Their twist τ(ψ, P, a) of definition 4
 * is the case without `across`. axis has length 1. */
typedef struct mw_twist_f32 { float axis[3], angle, along[3], across[3]; } mw_twist_f32;
typedef struct mw_twist_f64 { double axis[3], angle, along[3], across[3]; } mw_twist_f64;

/* The parts of a generator b12 b13 b23 b1i b2i b3i; of one without rotation angle 0, axis z, and all of it in `along`
 * and `across` of that axis. Computed in double, rounded once.
 * Errors: MW_ERROR_NULL, MW_ERROR_AXIS (a number is not finite). */
mw_status mw_split_bivector_f32(mw_twist_f32 *out, const float bivector[6]);
mw_status mw_split_bivector_f64(mw_twist_f64 *out, const double bivector[6]);

/* The pose exp(λB), as the sum of a twist and what `across` adds (their equation (2)), and the position r_λ of what
 * is at the origin when λ = 0, a helix in closed form (section 4.1, errata.md). Computed in double, rounded once.
 * Errors: MW_ERROR_NULL, MW_ERROR_AXIS (the axis does not have length 1, to 2^-10, or a number is not finite). */
mw_status mw_twist_pose_f32(mw_motor_f32 *out, const mw_twist_f32 *twist, float lambda);
mw_status mw_twist_pose_f64(mw_motor_f64 *out, const mw_twist_f64 *twist, double lambda);
mw_status mw_twist_position_f32(float out[3], const mw_twist_f32 *twist, float lambda);
mw_status mw_twist_position_f64(double out[3], const mw_twist_f64 *twist, double lambda);

/* ------------------------------------------------------------------------------------------------- motions --- */

/* A motion is a pose as a function of a parameter. It is described by control poses and knots, compiled once, and then
 * sampled as often as one likes, without allocation and by any number of threads at once. docs/motions.md shows all
 * of them side by side and says which to take. */

enum { MW_MAX_DEGREE = 31 };

/* How a motion makes a pose of its controls S_0 ... S_n. N_k(t) are the B-spline functions of its degree and knots. */
typedef enum MW_ENUMERATION mw_motion_kind {
    /* Σ N_k(t) w_k S_k: the paper's section 4 and equation (5). The fastest by far; a point moves on a rational curve of
     * twice the degree. Of two poses: an ellipse, on the cylinder of the screw between them (lemma 4.1). Samples are not
     * normalised: mw_apply_* needs no normalised motors, and mw_normalize_motor_each makes them so. */
    MW_MOTION_ADDITIVE = 1,
    /* The same blossom recursion with slerp in place of each weighted sum of two. Of degree 1 the piecewise screw of
     * Wareham and Lasenby, section 3.1: knots are then the times of the poses. */
    MW_MOTION_MULTIPLICATIVE,
    /* exp(c_n(t) b_n) ... exp(c_1(t) b_1) S_0 with b_k = log(S_k S_(k-1)^-1) and c_k = N_k + ... + N_n: the relative
     * motors, each raised to a power that grows from 0 to 1. As smooth as the B-spline functions (Kim, Kim and Shin,
     * 1995, of rotations). */
    MW_MOTION_CUMULATIVE,
    /* base exp(Σ N_k(t) log(base^-1 S_k)): generators are a vector space, in which every curve will do (Wareham and
     * Lasenby, section 3). Best near the base. */
    MW_MOTION_GENERATOR,
    /* The same through the controls themselves: Catmull and Rom's spline of their generators, at any times. Between
     * three poses it is Wareham and Lasenby's quadratic (section 3.2); between more the quadratics of neighbouring
     * triples run smoothly into one another. Of two poses it is the screw, if one is the base. */
    MW_MOTION_GENERATOR_KEYS
} mw_motion_kind;

/* A motion, described; or many that share everything but their controls, such as a crowd. All arrays are the
 * caller's, are only read, and are no longer needed once the motion is compiled. What is left zero has a default.
 *
 * knots: t_0 <= t_1 <= ... as the paper has them: control k belongs to the d consecutive knots from t_k on, and is
 * felt most around their mean. There are control_count + degree - 1 of them, without the two superfluous ones that some
 * libraries add at the ends; the domain is [t_(d-1), t_n]. A knot may be repeated: d times at an end makes the motion
 * begin at its first control (clamped); r times inside leaves it d - r times differentiable.
 *     linear        degree 1, 2 controls, knots 0 1                              equation (5)
 *     Bézier        degree d, d + 1 controls, knots 0 (d times) 1 (d times)
 *     figure 5      degree 2, 6 controls, knots 0 0 1 2 3 4 4
 *     closed        control_count + 1 knots, those of one period, which is the domain; controls and knots repeat
 *     keys          the times of the controls, which increase; if closed, also that of the return to the first
 * Without knots (null, 0) these are 0, 1, 2, ..., clamped at both ends unless it is closed: with d + 1 controls, Bézier.
 *
 * SIGNS: S and -S are the same pose. A motion goes the shortest way: every control is taken with the sign that brings
 * its rotation nearer to the control before it; the first of an open motion is taken as it is, or of generators with
 * that nearer to the base. With MW_KEEP_SIGNS all are taken as they are. An additive motion may then vanish on the way,
 * which is found when it is compiled; the others turn by more than a half turn where two are of opposite sign.
 * Closed motions of generators come back to the logarithms that they began with. */
typedef struct mw_motion_f32 {
    mw_motion_kind kind;
    unsigned degree;               /* from 1 to MW_MAX_DEGREE; of keys it is not read */
    const mw_motor_f32 *controls;  /* control_count of them; of many motions one after the other */
    size_t control_count;          /* of one motion: more than the degree, and at least two */
    const float *knots;
    size_t knot_count;
    const float *weights;          /* null, or one per control: rational additive motions */
    int closed;                    /* nonzero: comes back to its start, as smooth there as elsewhere */
    const mw_motor_f32 *base;      /* of generators: null is the identity */
    size_t motion_count;           /* how many motions there are; 0 is 1 */
} mw_motion_f32;
typedef struct mw_motion_f64 {
    mw_motion_kind kind;
    unsigned degree;
    const mw_motor_f64 *controls;
    size_t control_count;
    const double *knots;
    size_t knot_count;
    const double *weights;
    int closed;
    const mw_motor_f64 *base;
    size_t motion_count;
} mw_motion_f64;

/* Compiled motions live in memory of the caller's, aligned to 8 bytes. They hold no pointers: copy them, send them, map
 * them from a file (of the same version of this library, on a machine of the same byte order). All of their bytes are
 * written, and depend on the description alone. */
typedef struct mw_compiled_motion_f32 mw_compiled_motion_f32;
typedef struct mw_compiled_motion_f64 mw_compiled_motion_f64;

/* *size = how many bytes the compiled motion takes: about 8 numbers per control and (degree + 1)² per knot. This
 * looks at everything that mw_compile_motion looks at but the controls, and has its errors.
 * Errors: MW_ERROR_NULL, MW_ERROR_MOTION_KIND, MW_ERROR_DEGREE, MW_ERROR_CONTROL_COUNT, MW_ERROR_KNOT_COUNT,
 * MW_ERROR_KNOTS (where: the knot), MW_ERROR_WEIGHTS (where: the control; or the kind is not additive),
 * MW_ERROR_SIZE. */
mw_status mw_motion_size_f32(size_t *size, const mw_motion_f32 *motion, size_t *where);
mw_status mw_motion_size_f64(size_t *size, const mw_motion_f64 *motion, size_t *where);

/* Checks a motion and makes *compiled, which is `memory`. Flags: MW_KEEP_SIGNS (not of multiplicative motions, whose
 * slerp always goes the shortest way). On an error memory is not touched, and *where (unless that pointer is null) is
 * the index of what is wrong, else 0.
 * Time: linear in controls and knots, times degree²; logarithms of the controls where the kind takes them.
 * Errors: MW_ERROR_NULL, MW_ERROR_FLAGS, MW_ERROR_MOTION_KIND, MW_ERROR_DEGREE, MW_ERROR_CONTROL_COUNT,
 * MW_ERROR_KNOT_COUNT, MW_ERROR_KNOTS (where: the knot), MW_ERROR_WEIGHTS (where: the control; or the kind is not
 * additive), MW_ERROR_DEGENERATE_MOTOR (where: the control, counted through all motions; or the base),
 * MW_ERROR_VANISHING (where: the first of the degree + 1 controls that cancel; only with weights or MW_KEEP_SIGNS, or
 * where rotations are more than a half turn apart within a span), MW_ERROR_SIZE, MW_ERROR_MEMORY, MW_ERROR_OVERLAP. */
mw_status mw_compile_motion_f32(const mw_compiled_motion_f32 **compiled, void *memory, size_t size,
                                const mw_motion_f32 *motion, unsigned flags, size_t *where);
mw_status mw_compile_motion_f64(const mw_compiled_motion_f64 **compiled, void *memory, size_t size,
                                const mw_motion_f64 *motion, unsigned flags, size_t *where);

/* domain[0] and domain[1] = the first and the last parameter.
 * Errors: MW_ERROR_NULL, MW_ERROR_MOTION. */
mw_status mw_motion_domain_f32(float domain[2], const mw_compiled_motion_f32 *motion);
mw_status mw_motion_domain_f64(double domain[2], const mw_compiled_motion_f64 *motion);

/* Samples. `one`: out[i] is motion number `index` (0, if there is only one) at parameters[i]. `each`: out[i] is motion
 * number index + i at a parameter of its own, parameter_stride bytes after that before it; stride 0 is one parameter
 * for all. At a knot inside the domain a motion is taken from the right.
 * Runs of parameters between the same two knots are fastest: sorted ones are.
 * Flags: MW_CLAMP_PARAMETERS, MW_WRAP_PARAMETERS.
 * Operations per sample (fused multiply-adds and what costs as much), of degree d: 2 d² for the weights, and 8 (d + 1)
 * additive, ½ d (d + 1) slerps multiplicative, d exponentials and products cumulative, one of each for generators.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP (with the parameters or the motion),
 * MW_ERROR_FLAGS, MW_ERROR_MOTION, MW_ERROR_MOTION_INDEX, MW_ERROR_PARAMETER (outside the domain, unless a flag says
 * what to do, or not finite). */

/* Of one motion, at every parameter. */
mw_status mw_sample_motion_one_f32(mw_motor_f32 *out, size_t out_stride, const mw_compiled_motion_f32 *motion,
                                   size_t index, const float *parameters, size_t count, unsigned flags);
mw_status mw_sample_motion_one_f64(mw_motor_f64 *out, size_t out_stride, const mw_compiled_motion_f64 *motion,
                                   size_t index, const double *parameters, size_t count, unsigned flags);

/* Of one motion after the other. */
mw_status mw_sample_motion_each_f32(mw_motor_f32 *out, size_t out_stride, const mw_compiled_motion_f32 *motion,
                                    size_t index, const float *parameters, size_t parameter_stride, size_t count,
                                    unsigned flags);
mw_status mw_sample_motion_each_f64(mw_motor_f64 *out, size_t out_stride, const mw_compiled_motion_f64 *motion,
                                    size_t index, const double *parameters, size_t parameter_stride, size_t count,
                                    unsigned flags);

/* Samples and velocities. The twist Ω at a parameter is the bivector S^-1 S' of the normalised motion: a moment h
 * later the pose is S exp(hΩ). It generates motions as logarithms do, so it holds halves: the angular velocity is
 * 2 (b23, -b13, b12), and the velocity of what is at the origin just then is 2 (b1i, b2i, b3i). With MW_BODY_FRAME it
 * is S' S^-1, in the coordinates of the body. Both are per unit of the parameter, and exact: the same formulas are
 * evaluated over numbers that carry their derivatives. At a knot where the motion is not smooth: that of the right.
 * The flags and parameters of mw_sample_motion_*, and MW_BODY_FRAME. `out` and `twists` share no byte.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP (with the parameters or the motion),
 * MW_ERROR_FLAGS, MW_ERROR_MOTION, MW_ERROR_MOTION_INDEX, MW_ERROR_PARAMETER (outside the domain, unless a flag says
 * what to do, or not finite). */

/* Of one motion, at every parameter. */
mw_status mw_sample_motion_twist_one_f32(mw_motor_f32 *out, size_t out_stride, float *twists, size_t twist_stride,
                                         const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                         size_t count, unsigned flags);
mw_status mw_sample_motion_twist_one_f64(mw_motor_f64 *out, size_t out_stride, double *twists, size_t twist_stride,
                                         const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                         size_t count, unsigned flags);

/* Of one motion after the other. */
mw_status mw_sample_motion_twist_each_f32(mw_motor_f32 *out, size_t out_stride, float *twists, size_t twist_stride,
                                          const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                          size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_sample_motion_twist_each_f64(mw_motor_f64 *out, size_t out_stride, double *twists, size_t twist_stride,
                                          const mw_compiled_motion_f64 *motion, size_t index,
                                          const double *parameters, size_t parameter_stride, size_t count,
                                          unsigned flags);

/* A motion straight onto elements: row m of out is `in` under the motion at parameters[m], as mw_apply_<operand>_grid
 * does it of motors. The poses are made some at a time and never leave the first cache.
 * Flags: those of apply and of mw_sample_motion_one.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP (with the parameters or the motion),
 * MW_ERROR_FLAGS, MW_ERROR_MOTION, MW_ERROR_MOTION_INDEX, MW_ERROR_PARAMETER (outside the domain, unless a flag says
 * what to do, or not finite). */
mw_status mw_apply_point_motion_f32(float *out, size_t out_stride, size_t row_stride,
                                    const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                    size_t parameter_count, const float *in, size_t in_stride, size_t count,
                                    unsigned flags);
mw_status mw_apply_point_motion_f64(double *out, size_t out_stride, size_t row_stride,
                                    const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                    size_t parameter_count, const double *in, size_t in_stride, size_t count,
                                    unsigned flags);
mw_status mw_apply_direction_motion_f32(float *out, size_t out_stride, size_t row_stride,
                                        const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                        size_t parameter_count, const float *in, size_t in_stride, size_t count,
                                        unsigned flags);
mw_status mw_apply_direction_motion_f64(double *out, size_t out_stride, size_t row_stride,
                                        const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                        size_t parameter_count, const double *in, size_t in_stride, size_t count,
                                        unsigned flags);
mw_status mw_apply_tangent_motion_f32(float *out, size_t out_stride, size_t row_stride,
                                      const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                      size_t parameter_count, const float *in, size_t in_stride, size_t count,
                                      unsigned flags);
mw_status mw_apply_tangent_motion_f64(double *out, size_t out_stride, size_t row_stride,
                                      const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                      size_t parameter_count, const double *in, size_t in_stride, size_t count,
                                      unsigned flags);
mw_status mw_apply_vertex_motion_f32(float *out_positions, float *out_normals, size_t out_stride, size_t row_stride,
                                     const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                     size_t parameter_count, const float *in_positions, const float *in_normals,
                                     size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vertex_motion_f64(double *out_positions, double *out_normals, size_t out_stride, size_t row_stride,
                                     const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                     size_t parameter_count, const double *in_positions, const double *in_normals,
                                     size_t in_stride, size_t count, unsigned flags);
mw_status mw_apply_vector_motion_f32(float *out, size_t out_stride, size_t row_stride,
                                     const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                     size_t parameter_count, const float *in, size_t in_stride, size_t count,
                                     unsigned flags);
mw_status mw_apply_vector_motion_f64(double *out, size_t out_stride, size_t row_stride,
                                     const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                     size_t parameter_count, const double *in, size_t in_stride, size_t count,
                                     unsigned flags);
mw_status mw_apply_line_motion_f32(float *out, size_t out_stride, size_t row_stride,
                                   const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                   size_t parameter_count, const float *in, size_t in_stride, size_t count,
                                   unsigned flags);
mw_status mw_apply_line_motion_f64(double *out, size_t out_stride, size_t row_stride,
                                   const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                   size_t parameter_count, const double *in, size_t in_stride, size_t count,
                                   unsigned flags);
mw_status mw_apply_motor_motion_f32(mw_motor_f32 *out, size_t out_stride, size_t row_stride,
                                    const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                    size_t parameter_count, const mw_motor_f32 *in, size_t in_stride, size_t count,
                                    unsigned flags);
mw_status mw_apply_motor_motion_f64(mw_motor_f64 *out, size_t out_stride, size_t row_stride,
                                    const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                    size_t parameter_count, const mw_motor_f64 *in, size_t in_stride, size_t count,
                                    unsigned flags);
mw_status mw_apply_bivector_motion_f32(float *out, size_t out_stride, size_t row_stride,
                                       const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                       size_t parameter_count, const float *in, size_t in_stride, size_t count,
                                       unsigned flags);
mw_status mw_apply_bivector_motion_f64(double *out, size_t out_stride, size_t row_stride,
                                       const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                       size_t parameter_count, const double *in, size_t in_stride, size_t count,
                                       unsigned flags);

/* The velocity of the point of the body that is at `place`, under a twist of the space.
 * Errors: MW_ERROR_NULL. */
mw_status mw_twist_velocity_f32(float velocity[3], const float twist[6], const float place[3]);
mw_status mw_twist_velocity_f64(double velocity[3], const double twist[6], const double place[3]);

/* lengths[i] = the length of the way of a point of the body, from the start of the domain to parameters[i], which must
 * not decrease (MW_ERROR_PARAMETER). Integrated from the twists, to a few epsilons of the whole length and of the
 * coordinates. `lengths` may be `parameters`.
 * Errors: MW_ERROR_NULL, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_MOTION, MW_ERROR_MOTION_INDEX, MW_ERROR_PARAMETER. */
mw_status mw_motion_lengths_f32(float *lengths, const mw_compiled_motion_f32 *motion, size_t index,
                                const float point[3], const float *parameters, size_t count);
mw_status mw_motion_lengths_f64(double *lengths, const mw_compiled_motion_f64 *motion, size_t index,
                                const double point[3], const double *parameters, size_t count);

/* parameters[i] = where a point of the body has gone the part i / (count - 1) of its whole way: samples there are
 * equally far apart along it. The first and the last are the ends of the domain; one alone is its start. If the point
 * never moves, by more than rounding, or is not finite, the parameters are equally far apart instead.
 * Errors: MW_ERROR_NULL, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_MOTION, MW_ERROR_MOTION_INDEX. */
mw_status mw_motion_even_parameters_f32(float *parameters, const mw_compiled_motion_f32 *motion, size_t index,
                                        const float point[3], size_t count);
mw_status mw_motion_even_parameters_f64(double *parameters, const mw_compiled_motion_f64 *motion, size_t index,
                                        const double point[3], size_t count);

/* The largest distance between two motions: of the images of `count` points under both, at sample_count parameters
 * equally far apart over the domain of each. Both ends are among them. Distances that are NaN are passed over; without
 * points or samples the distance is 0, at both starts. */
typedef struct mw_motion_distance_f32 {
    float distance;
    float parameters[2]; /* of the first motion and of the second, where it is largest */
    size_t point;        /* which point it is largest for */
} mw_motion_distance_f32;
typedef struct mw_motion_distance_f64 {
    double distance;
    double parameters[2];
    size_t point;
} mw_motion_distance_f64;

/* Time: count * sample_count.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_MOTION, MW_ERROR_MOTION_INDEX. */
mw_status mw_compare_motions_f32(mw_motion_distance_f32 *largest, const mw_compiled_motion_f32 *first,
                                 size_t first_index, const mw_compiled_motion_f32 *second, size_t second_index,
                                 const float *points, size_t point_stride, size_t count, size_t sample_count);
mw_status mw_compare_motions_f64(mw_motion_distance_f64 *largest, const mw_compiled_motion_f64 *first,
                                 size_t first_index, const mw_compiled_motion_f64 *second, size_t second_index,
                                 const double *points, size_t point_stride, size_t count, size_t sample_count);

/* ---------------------------------------------------------------------------------- making and editing motions --- */

/* Where the functions below put controls and knots. They set *out to a motion that reads them. */
typedef struct mw_motion_arrays_f32 {
    mw_motor_f32 *controls;
    size_t control_capacity;
    float *knots;
    size_t knot_capacity;
} mw_motion_arrays_f32;
typedef struct mw_motion_arrays_f64 {
    mw_motor_f64 *controls;
    size_t control_capacity;
    double *knots;
    size_t knot_capacity;
} mw_motion_arrays_f64;

/* Controls of a motion that passes through `count` keys at times that increase: additive or cumulative, of a degree
 * below the number of keys. As many controls as keys; knots are means of the times of `degree` neighbours (de Boor),
 * so that the equations have one solution. Additive: they are solved in one go. Cumulative: by Newton's method, in a
 * few rounds. Keys are taken with the signs of the shortest way. COMPILE THE RESULT WITH MW_KEEP_SIGNS: neighbouring
 * controls may be more than a half turn apart even where keys are not.
 * `memory`: *size bytes of working memory, aligned to 8; null to be told by *size how many, which reads nothing but
 * kind, degree and count. Arrays may be `keys` and `times` themselves.
 * Time: count * degree², ten times that per round if cumulative.
 * Errors: MW_ERROR_NULL, MW_ERROR_MOTION_KIND, MW_ERROR_DEGREE, MW_ERROR_CONTROL_COUNT, MW_ERROR_KNOTS (where: the
 * time), MW_ERROR_DEGENERATE_MOTOR (where: the key), MW_ERROR_MEMORY (also arrays that are too small), MW_ERROR_SIZE,
 * MW_ERROR_OVERLAP, MW_ERROR_CONVERGENCE (no controls, or none less than a full turn apart from their neighbours:
 * cumulative motions through keys that turn far between each other, at uneven times, need such ones. Add keys). */
mw_status mw_interpolate_keys_f32(mw_motion_f32 *out, const mw_motion_arrays_f32 *arrays, mw_motion_kind kind,
                                  unsigned degree, const mw_motor_f32 *keys, const float *times, size_t count,
                                  void *memory, size_t *size, size_t *where);
mw_status mw_interpolate_keys_f64(mw_motion_f64 *out, const mw_motion_arrays_f64 *arrays, mw_motion_kind kind,
                                  unsigned degree, const mw_motor_f64 *keys, const double *times, size_t count,
                                  void *memory, size_t *size, size_t *where);

/* The same additive motion written with more controls: with a knot inserted `times` times, of one degree more, or in
 * two parts, before and after a parameter. Weights are multiplied into the controls of the result, which has none. Of
 * open additive motions with one set of controls: MW_ERROR_MOTION_KIND of others.
 * Signs are kept as they are: compile the result with MW_KEEP_SIGNS. The arrays share no byte with the motion. If they
 * are too small, such as {0}, *out says by control_count and knot_count what it takes.
 * Errors: MW_ERROR_NULL, MW_ERROR_MOTION_KIND, MW_ERROR_DEGREE, MW_ERROR_CONTROL_COUNT, MW_ERROR_KNOT_COUNT,
 * MW_ERROR_KNOTS (where: the knot), MW_ERROR_WEIGHTS (where: the control; or the kind is not additive),
 * MW_ERROR_SIZE, MW_ERROR_PARAMETER (the knot is not strictly inside the domain), MW_ERROR_KNOTS (it would be
 * repeated more than degree + 1 times, or is less than a normal number from another), MW_ERROR_DEGREE (beyond
 * MW_MAX_DEGREE), MW_ERROR_OVERLAP, MW_ERROR_MEMORY (the arrays are too small). */
mw_status mw_insert_knot_f32(mw_motion_f32 *out, const mw_motion_arrays_f32 *arrays, const mw_motion_f32 *motion,
                             float knot, unsigned times);
mw_status mw_insert_knot_f64(mw_motion_f64 *out, const mw_motion_arrays_f64 *arrays, const mw_motion_f64 *motion,
                             double knot, unsigned times);
mw_status mw_elevate_degree_f32(mw_motion_f32 *out, const mw_motion_arrays_f32 *arrays, const mw_motion_f32 *motion);
mw_status mw_elevate_degree_f64(mw_motion_f64 *out, const mw_motion_arrays_f64 *arrays, const mw_motion_f64 *motion);
mw_status mw_split_motion_f32(mw_motion_f32 *before, const mw_motion_arrays_f32 *before_arrays, mw_motion_f32 *after,
                              const mw_motion_arrays_f32 *after_arrays, const mw_motion_f32 *motion, float at);
mw_status mw_split_motion_f64(mw_motion_f64 *before, const mw_motion_arrays_f64 *before_arrays, mw_motion_f64 *after,
                              const mw_motion_arrays_f64 *after_arrays, const mw_motion_f64 *motion, double at);

#undef MW_ENUMERATION
#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
