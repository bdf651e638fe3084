/* The loops of plain_loops.h in every layout. For each kind of array: its parameters, the arguments for them out of
 * the pointers to its components (_OF; from element `first` on: _FROM), and component k of element i. No include
 * guard: once a precision. */

#define ONE(T, name) T *restrict name##0
#define THREE(T, name) ONE(T, name), T *restrict name##1, T *restrict name##2
#define FOUR(T, name) THREE(T, name), T *restrict name##3
#define SIX(T, name) FOUR(T, name), T *restrict name##4, T *restrict name##5
#define SEVEN(T, name) SIX(T, name), T *restrict name##6
#define EIGHT(T, name) SEVEN(T, name), T *restrict name##7
#define ONE_FROM(from, first) (from)[0] + (first)
#define THREE_FROM(from, first) ONE_FROM(from, first), (from)[1] + (first), (from)[2] + (first)
#define FOUR_FROM(from, first) THREE_FROM(from, first), (from)[3] + (first)
#define SIX_FROM(from, first) FOUR_FROM(from, first), (from)[4] + (first), (from)[5] + (first)
#define SEVEN_FROM(from, first) SIX_FROM(from, first), (from)[6] + (first)
#define EIGHT_FROM(from, first) SEVEN_FROM(from, first), (from)[7] + (first)

#define POINTS_OF(from) POINTS_FROM(from, 0)
#define VERTICES_OF(from) VERTICES_FROM(from, 0)
#define DUALS_OF(from) DUALS_FROM(from, 0)

/* An array a component. */
#define LAYOUT soa
#define POINTS THREE
#define POINTS_FROM THREE_FROM
#define POINT(name, k, i) name##k[i]
#define VERTICES SIX
#define VERTICES_FROM SIX_FROM
#define VERTEX(name, k, i) name##k[i]
#define RIGIDS SEVEN
#define RIGIDS_OF(from) SEVEN_FROM(from, 0)
#define RIGID(name, k, i) name##k[i]
#define DUALS EIGHT
#define DUALS_FROM EIGHT_FROM
#define DUAL(name, k, i) name##k[i]
#define SIDE_BY_SIDE
#define WEIGHTS FOUR
#define WEIGHTS_OF(from) FOUR_FROM(from, 0)
#define WEIGHT(name, k, i) name##k[i]
#include "plain_loops.h"
#undef LAYOUT
#undef POINTS
#undef POINTS_FROM
#undef POINT
#undef VERTICES
#undef VERTICES_FROM
#undef VERTEX
#undef RIGIDS
#undef RIGIDS_OF
#undef RIGID
#undef DUALS
#undef DUALS_FROM
#undef DUAL
#undef SIDE_BY_SIDE
#undef WEIGHTS
#undef WEIGHTS_OF
#undef WEIGHT

/* The components adjacent. */
#define POINTS ONE
#define VERTICES ONE
#define RIGIDS ONE
#define RIGIDS_OF(from) ONE_FROM(from, 0)
#define RIGID(name, k, i) name##0[7 * (i) + k]
#define DUALS ONE
#define DUALS_FROM ONE_FROM
#define WEIGHTS ONE
#define WEIGHTS_OF(from) ONE_FROM(from, 0)
#define WEIGHT(name, k, i) name##0[PLAIN_TERMS * (i) + k]

#define LAYOUT packed
#define POINTS_FROM(from, first) ONE_FROM(from, 3 * (first))
#define POINT(name, k, i) name##0[3 * (i) + k]
#define VERTICES_FROM(from, first) ONE_FROM(from, 6 * (first))
#define VERTEX(name, k, i) name##0[6 * (i) + k]
#define DUAL(name, k, i) name##0[8 * (i) + k]
#define COLUMNS
#include "plain_loops.h"
#undef LAYOUT
#undef POINTS_FROM
#undef POINT
#undef VERTICES_FROM
#undef VERTEX
#undef DUAL
#undef COLUMNS

#define LAYOUT strided
#define POINTS_FROM(from, first) ONE_FROM(from, PLAIN_VERTEX_STRIDE * (first))
#define POINT(name, k, i) name##0[PLAIN_VERTEX_STRIDE * (i) + k]
#define VERTICES_FROM(from, first) ONE_FROM(from, PLAIN_VERTEX_STRIDE * (first))
#define VERTEX(name, k, i) name##0[PLAIN_VERTEX_STRIDE * (i) + k]
#define DUAL(name, k, i) name##0[PLAIN_MOTOR_STRIDE * (i) + k]
#include "plain_loops.h"
#undef LAYOUT
#undef POINTS_FROM
#undef POINT
#undef VERTICES_FROM
#undef VERTEX
#undef DUAL

#undef POINTS
#undef POINTS_OF
#undef VERTICES
#undef VERTICES_OF
#undef RIGIDS
#undef RIGIDS_OF
#undef RIGID
#undef DUALS
#undef DUALS_FROM
#undef DUALS_OF
#undef WEIGHTS
#undef WEIGHTS_OF
#undef WEIGHT
#undef ONE
#undef THREE
#undef FOUR
#undef SIX
#undef SEVEN
#undef EIGHT
#undef ONE_FROM
#undef THREE_FROM
#undef FOUR_FROM
#undef SIX_FROM
#undef SEVEN_FROM
#undef EIGHT_FROM
