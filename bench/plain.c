/* The plain loops in every layout and precision, compiled with PLAIN_TABLE set to the name of the table. */
#include "plain.h"

#include <math.h>

#define PASTE_(a, b, c) a##_##b##_##c
#define PASTE(a, b, c) PASTE_(a, b, c)
#define NAME(loop) PASTE(loop, PRECISION, LAYOUT)
#define ARGUMENTS_(precision) struct plain_arguments_##precision
#define ARGUMENTS__(precision) ARGUMENTS_(precision)
#define ARGUMENTS ARGUMENTS__(PRECISION)

#define REAL float
#define WIDE float
#define SQRT sqrtf
#define PRECISION f32
#include "plain_layouts.h"
#undef PRECISION
#undef WIDE

#define POINTS_ALONE
#define WIDE double
#define PRECISION mixed
#include "plain_layouts.h"
#undef PRECISION
#undef REAL
#undef SQRT
#undef POINTS_ALONE

#define REAL double
#define SQRT sqrt
#define PRECISION f64
#include "plain_layouts.h"

#define LAYOUTS(name, precision) {name##_##precision##_soa, name##_##precision##_packed, name##_##precision##_strided}
#define MEMBERS(name) LAYOUTS(name, f32), LAYOUTS(name, f64),
#define MIXED_MEMBER(name) LAYOUTS(name, mixed),

const struct plain_table PLAIN_TABLE = {
#ifdef __AVX2__
    1,
#else
    0,
#endif
#ifdef __AVX512F__
    1,
#else
    0,
#endif
    PLAIN_POINT_LOOPS(MEMBERS) PLAIN_POINT_LOOPS(MIXED_MEMBER) PLAIN_OTHER_LOOPS(MEMBERS)
    apply_point_columns_f32_packed, apply_point_columns_f64_packed, apply_point_columns_mixed_packed};
