/* The loops of plain_loops.h in every layout. For each kind of array: its parameters, the arguments for them out of
 * the pointers to its components, and component k of element i. No include guard: once a precision. */

#define ONE(T, name) T *restrict name##0
#define THREE(T, name) ONE(T, name), T *restrict name##1, T *restrict name##2
#define FOUR(T, name) THREE(T, name), T *restrict name##3
#define SEVEN(T, name) FOUR(T, name), T *restrict name##4, T *restrict name##5, T *restrict name##6
#define EIGHT(T, name) SEVEN(T, name), T *restrict name##7
#define ONE_OF(from) (from)[0]
#define THREE_OF(from) ONE_OF(from), (from)[1], (from)[2]
#define FOUR_OF(from) THREE_OF(from), (from)[3]
#define SEVEN_OF(from) FOUR_OF(from), (from)[4], (from)[5], (from)[6]
#define EIGHT_OF(from) SEVEN_OF(from), (from)[7]

/* An array a component. */
#define LAYOUT soa
#define POINTS THREE
#define POINTS_OF THREE_OF
#define POINT(name, k, i) name##k[i]
#define RIGIDS SEVEN
#define RIGIDS_OF SEVEN_OF
#define RIGID(name, k, i) name##k[i]
#define DUALS EIGHT
#define DUALS_OF EIGHT_OF
#define DUAL(name, k, i) name##k[i]
#define WEIGHTS FOUR
#define WEIGHTS_OF FOUR_OF
#define WEIGHT(name, k, i) name##k[i]
#include "plain_loops.h"
#undef LAYOUT
#undef POINTS
#undef POINTS_OF
#undef POINT
#undef RIGIDS
#undef RIGIDS_OF
#undef RIGID
#undef DUALS
#undef DUALS_OF
#undef DUAL
#undef WEIGHTS
#undef WEIGHTS_OF
#undef WEIGHT

/* The components adjacent. */
#define POINTS ONE
#define POINTS_OF ONE_OF
#define RIGIDS ONE
#define RIGIDS_OF ONE_OF
#define RIGID(name, k, i) name##0[7 * (i) + k]
#define DUALS ONE
#define DUALS_OF ONE_OF
#define WEIGHTS ONE
#define WEIGHTS_OF ONE_OF
#define WEIGHT(name, k, i) name##0[PLAIN_TERMS * (i) + k]

#define LAYOUT packed
#define POINT(name, k, i) name##0[3 * (i) + k]
#define DUAL(name, k, i) name##0[8 * (i) + k]
#include "plain_loops.h"
#undef LAYOUT
#undef POINT
#undef DUAL

#define LAYOUT strided
#define POINT(name, k, i) name##0[PLAIN_POINT_STRIDE * (i) + k]
#define DUAL(name, k, i) name##0[PLAIN_MOTOR_STRIDE * (i) + k]
#include "plain_loops.h"
#undef LAYOUT
#undef POINT
#undef DUAL

#undef POINTS
#undef POINTS_OF
#undef RIGIDS
#undef RIGIDS_OF
#undef RIGID
#undef DUALS
#undef DUALS_OF
#undef WEIGHTS
#undef WEIGHTS_OF
#undef WEIGHT
#undef ONE
#undef THREE
#undef FOUR
#undef SEVEN
#undef EIGHT
#undef ONE_OF
#undef THREE_OF
#undef FOUR_OF
#undef SEVEN_OF
#undef EIGHT_OF
