/* The plain loops in every layout and precision, compiled with PLAIN_TABLE set to the name of the table. */
#include "plain.h"

#include <math.h>

#define PASTE_(a, b, c) a##_##b##_##c
#define PASTE(a, b, c) PASTE_(a, b, c)
#define NAME(loop) PASTE(loop, PRECISION, LAYOUT)

#define REAL float
#define SQRT sqrtf
#define PRECISION f32
#include "plain_layouts.h"
#undef REAL
#undef SQRT
#undef PRECISION

#define REAL double
#define SQRT sqrt
#define PRECISION f64
#include "plain_layouts.h"

#define LAYOUTS(name, precision) {name##_##precision##_soa, name##_##precision##_packed, name##_##precision##_strided}
#define MEMBERS(name) LAYOUTS(name, f32), LAYOUTS(name, f64),

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
    PLAIN_LOOPS(MEMBERS)};
