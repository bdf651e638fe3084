/* The loops themselves, in the layout and precision of the macros. No include guard: once a layout and precision.
 *
 *     points    x y z
 *     vertices  a position x y z and a normal x y z
 *     rigids    a unit quaternion w x y z and a translation
 *     duals     dual quaternions: w x y z of the real part, then of the dual part
 *     matrix    3 rows of 4: a rotation and a translation
 *
 * Compilers trust `restrict` fully in parameters alone, so a loop is a function of as many pointers as it has arrays,
 * behind one of the common type. */

#define LOOP(name, arguments, ...)                                                                                   \
    static void NAME(name##_loop)(__VA_ARGS__);                                                                      \
    static void NAME(name)(const ARGUMENTS *a) { NAME(name##_loop) arguments; }                                      \
    static void NAME(name##_loop)(__VA_ARGS__)

/* ------------------------------------------------------------------------------------------------ by matrices --- */

#define LOAD_ROTATION(from)                                                                                          \
    const WIDE m00 = (from)[0], m01 = (from)[1], m02 = (from)[2];                                                    \
    const WIDE m10 = (from)[4], m11 = (from)[5], m12 = (from)[6];                                                    \
    const WIDE m20 = (from)[8], m21 = (from)[9], m22 = (from)[10];
#define LOAD_MATRIX(from)                                                                                            \
    LOAD_ROTATION(from)                                                                                              \
    const WIDE m03 = (from)[3], m13 = (from)[7], m23 = (from)[11];

/* Element i to element o; AT is POINT or VERTEX, the place of a component. */
#define MOVE_POINT(AT, o, i)                                                                                         \
    {                                                                                                                \
        const WIDE x = AT(in, 0, i), y = AT(in, 1, i), z = AT(in, 2, i);                                             \
        AT(out, 0, o) = (REAL)(m00 * x + m01 * y + m02 * z + m03);                                                   \
        AT(out, 1, o) = (REAL)(m10 * x + m11 * y + m12 * z + m13);                                                   \
        AT(out, 2, o) = (REAL)(m20 * x + m21 * y + m22 * z + m23);                                                   \
    }
#define MOVE_DIRECTION(AT, c0, c1, c2, i)                                                                            \
    {                                                                                                                \
        const WIDE x = AT(in, c0, i), y = AT(in, c1, i), z = AT(in, c2, i);                                          \
        AT(out, c0, i) = (REAL)(m00 * x + m01 * y + m02 * z);                                                        \
        AT(out, c1, i) = (REAL)(m10 * x + m11 * y + m12 * z);                                                        \
        AT(out, c2, i) = (REAL)(m20 * x + m21 * y + m22 * z);                                                        \
    }
#define MOVE_VERTEX(i) MOVE_POINT(VERTEX, i, i) MOVE_DIRECTION(VERTEX, 3, 4, 5, i)

/* The matrices were made beforehand, and are walked in the outer loop. */
#define GRID(name, one, ARRAY)                                                                                       \
    static void NAME(name)(const ARGUMENTS *a)                                                                       \
    {                                                                                                                \
        for (size_t m = 0; m < PLAIN_MOTORS; ++m)                                                                    \
            NAME(one##_loop)(ARRAY##_FROM(a->out, m * a->count), ARRAY##_OF(a->in[0]), a->fixed + 12 * m, a->count); \
    }

LOOP(apply_point_one, (POINTS_OF(a->out), POINTS_OF(a->in[0]), a->fixed, a->count),
     POINTS(REAL, out), POINTS(const REAL, in), const WIDE *matrix, size_t count)
{
    LOAD_MATRIX(matrix)
    for (size_t i = 0; i < count; ++i)
        MOVE_POINT(POINT, i, i)
}

GRID(apply_point_grid, apply_point_one, POINTS)

LOOP(apply_point_indexed, (POINTS_OF(a->out), POINTS_OF(a->in[0]), a->fixed, a->indices, a->count),
     POINTS(REAL, out), POINTS(const REAL, in), const WIDE *restrict palette, const uint16_t *restrict indices,
     size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const WIDE *matrix = palette + 12 * (size_t)indices[i];
        LOAD_MATRIX(matrix)
        MOVE_POINT(POINT, i, i)
    }
}

#ifdef COLUMNS
LOOP(apply_point_columns, (POINTS_OF(a->out), POINTS_OF(a->in[0]), a->fixed, a->count),
     POINTS(REAL, out), POINTS(const REAL, in), const WIDE *restrict matrices, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        for (size_t m = 0; m < PLAIN_MOTORS; ++m) {
            LOAD_MATRIX(matrices + 12 * m)
            MOVE_POINT(POINT, i * PLAIN_MOTORS + m, i)
        }
}
#endif

/* --------------------------------------------------------------------------------------------- by quaternions --- */

/* p + w c + q × c with c = 2 q × p: the usual rotation by a unit quaternion, and then the translation. */
LOOP(apply_point_each, (POINTS_OF(a->out), RIGIDS_OF(a->rigids), POINTS_OF(a->in[0]), a->count),
     POINTS(REAL, out), RIGIDS(const WIDE, rigid), POINTS(const REAL, in), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const WIDE x = POINT(in, 0, i), y = POINT(in, 1, i), z = POINT(in, 2, i);
        const WIDE w = RIGID(rigid, 0, i), qx = RIGID(rigid, 1, i), qy = RIGID(rigid, 2, i), qz = RIGID(rigid, 3, i);
        const WIDE cx = 2 * (qy * z - qz * y), cy = 2 * (qz * x - qx * z), cz = 2 * (qx * y - qy * x);
        POINT(out, 0, i) = (REAL)(x + w * cx + (qy * cz - qz * cy) + RIGID(rigid, 4, i));
        POINT(out, 1, i) = (REAL)(y + w * cy + (qz * cx - qx * cz) + RIGID(rigid, 5, i));
        POINT(out, 2, i) = (REAL)(z + w * cz + (qx * cy - qy * cx) + RIGID(rigid, 6, i));
    }
}

#ifndef POINTS_ALONE

LOOP(apply_direction_each, (POINTS_OF(a->out), RIGIDS_OF(a->rigids), POINTS_OF(a->in[0]), a->count),
     POINTS(REAL, out), RIGIDS(const REAL, rigid), POINTS(const REAL, in), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL x = POINT(in, 0, i), y = POINT(in, 1, i), z = POINT(in, 2, i);
        const REAL w = RIGID(rigid, 0, i), qx = RIGID(rigid, 1, i), qy = RIGID(rigid, 2, i), qz = RIGID(rigid, 3, i);
        const REAL cx = 2 * (qy * z - qz * y), cy = 2 * (qz * x - qx * z), cz = 2 * (qx * y - qy * x);
        POINT(out, 0, i) = x + w * cx + (qy * cz - qz * cy);
        POINT(out, 1, i) = y + w * cy + (qz * cx - qx * cz);
        POINT(out, 2, i) = z + w * cz + (qx * cy - qy * cx);
    }
}

/* ---------------------------------------------------------------------- directions and vertices by matrices --- */

LOOP(apply_direction_one, (POINTS_OF(a->out), POINTS_OF(a->in[0]), a->fixed, a->count),
     POINTS(REAL, out), POINTS(const REAL, in), const REAL *matrix, size_t count)
{
    LOAD_ROTATION(matrix)
    for (size_t i = 0; i < count; ++i)
        MOVE_DIRECTION(POINT, 0, 1, 2, i)
}

GRID(apply_direction_grid, apply_direction_one, POINTS)

LOOP(apply_direction_indexed, (POINTS_OF(a->out), POINTS_OF(a->in[0]), a->fixed, a->indices, a->count),
     POINTS(REAL, out), POINTS(const REAL, in), const REAL *restrict palette, const uint16_t *restrict indices,
     size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL *matrix = palette + 12 * (size_t)indices[i];
        LOAD_ROTATION(matrix)
        MOVE_DIRECTION(POINT, 0, 1, 2, i)
    }
}

LOOP(apply_vertex_one, (VERTICES_OF(a->out), VERTICES_OF(a->in[0]), a->fixed, a->count),
     VERTICES(REAL, out), VERTICES(const REAL, in), const REAL *matrix, size_t count)
{
    LOAD_MATRIX(matrix)
    for (size_t i = 0; i < count; ++i) {
        MOVE_VERTEX(i)
    }
}

GRID(apply_vertex_grid, apply_vertex_one, VERTICES)

LOOP(apply_vertex_indexed, (VERTICES_OF(a->out), VERTICES_OF(a->in[0]), a->fixed, a->indices, a->count),
     VERTICES(REAL, out), VERTICES(const REAL, in), const REAL *restrict palette, const uint16_t *restrict indices,
     size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL *matrix = palette + 12 * (size_t)indices[i];
        LOAD_MATRIX(matrix)
        MOVE_VERTEX(i)
    }
}

/* ------------------------------------------------------------------------------------------- dual quaternions --- */

/* (a + ε b)(c + ε d) = a c + ε (a d + b c), where a + ε b is the later motion. Of elements t and f, to o. */
#define COMPOSE(out, o, first, f, then, t)                                                                           \
    {                                                                                                                \
        const REAL aw = DUAL(then, 0, t), ax = DUAL(then, 1, t), ay = DUAL(then, 2, t), az = DUAL(then, 3, t);       \
        const REAL bw = DUAL(then, 4, t), bx = DUAL(then, 5, t), by = DUAL(then, 6, t), bz = DUAL(then, 7, t);       \
        const REAL cw = DUAL(first, 0, f), cx = DUAL(first, 1, f), cy = DUAL(first, 2, f), cz = DUAL(first, 3, f);   \
        const REAL dw = DUAL(first, 4, f), dx = DUAL(first, 5, f), dy = DUAL(first, 6, f), dz = DUAL(first, 7, f);   \
        DUAL(out, 0, o) = aw * cw - ax * cx - ay * cy - az * cz;                                                     \
        DUAL(out, 1, o) = aw * cx + ax * cw + ay * cz - az * cy;                                                     \
        DUAL(out, 2, o) = aw * cy - ax * cz + ay * cw + az * cx;                                                     \
        DUAL(out, 3, o) = aw * cz + ax * cy - ay * cx + az * cw;                                                     \
        DUAL(out, 4, o) = aw * dw - ax * dx - ay * dy - az * dz + bw * cw - bx * cx - by * cy - bz * cz;             \
        DUAL(out, 5, o) = aw * dx + ax * dw + ay * dz - az * dy + bw * cx + bx * cw + by * cz - bz * cy;             \
        DUAL(out, 6, o) = aw * dy - ax * dz + ay * dw + az * dx + bw * cy - bx * cz + by * cw + bz * cx;             \
        DUAL(out, 7, o) = aw * dz + ax * dy - ay * dx + az * dw + bw * cz + bx * cy - by * cx + bz * cw;             \
    }
#define COPY(k, out, o, in, i) DUAL(out, k, o) = DUAL(in, k, i)
#define COPY_ALL(out, o, in, i)                                                                                      \
    {                                                                                                                \
        COPY(0, out, o, in, i), COPY(1, out, o, in, i), COPY(2, out, o, in, i), COPY(3, out, o, in, i);              \
        COPY(4, out, o, in, i), COPY(5, out, o, in, i), COPY(6, out, o, in, i), COPY(7, out, o, in, i);              \
    }

LOOP(compose_motor_each, (DUALS_OF(a->out), DUALS_OF(a->in[0]), DUALS_OF(a->in[1]), a->count),
     DUALS(REAL, out), DUALS(const REAL, first), DUALS(const REAL, then), size_t count)
{
    for (size_t i = 0; i < count; ++i)
        COMPOSE(out, i, first, i, then, i)
}

/* Skeletons: the motion of a joint, and then that of its parent. */
#ifdef SIDE_BY_SIDE
static void NAME(copy_motors)(DUALS(REAL, out), DUALS(const REAL, in), size_t count)
{
    for (size_t i = 0; i < count; ++i)
        COPY_ALL(out, i, in, i)
}

static void NAME(compose_motor_hierarchy)(const ARGUMENTS *a)
{
    for (size_t j = 0; j < PLAIN_JOINTS; ++j) {
        const size_t first = j * a->count;
        if (a->parents[j] < 0)
            NAME(copy_motors)(DUALS_FROM(a->out, first), DUALS_FROM(a->in[0], first), a->count);
        else
            NAME(compose_motor_each_loop)(DUALS_FROM(a->out, first), DUALS_FROM(a->in[0], first),
                                          DUALS_FROM(a->out, (size_t)a->parents[j] * a->count), a->count);
    }
}
#else
LOOP(compose_motor_hierarchy, (DUALS_OF(a->out), DUALS_OF(a->in[0]), a->parents, a->count),
     DUALS(REAL, out), DUALS(const REAL, local), const int32_t *restrict parents, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const size_t first = i * PLAIN_JOINTS;
        for (size_t j = 0; j < PLAIN_JOINTS; ++j) {
            if (parents[j] < 0)
                COPY_ALL(out, first + j, local, first + j)
            else
                COMPOSE(out, first + j, local, first + j, out, first + (size_t)parents[j])
        }
    }
}
#endif

LOOP(reverse_motor_each, (DUALS_OF(a->out), DUALS_OF(a->in[0]), a->count),
     DUALS(REAL, out), DUALS(const REAL, in), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        DUAL(out, 0, i) = DUAL(in, 0, i);
        DUAL(out, 1, i) = -DUAL(in, 1, i);
        DUAL(out, 2, i) = -DUAL(in, 2, i);
        DUAL(out, 3, i) = -DUAL(in, 3, i);
        DUAL(out, 4, i) = DUAL(in, 4, i);
        DUAL(out, 5, i) = -DUAL(in, 5, i);
        DUAL(out, 6, i) = -DUAL(in, 6, i);
        DUAL(out, 7, i) = -DUAL(in, 7, i);
    }
}

/* Divided by the dual number |a + ε b| = |a| + ε (a·b) / |a|. */
LOOP(normalize_motor_each, (DUALS_OF(a->out), DUALS_OF(a->in[0]), a->count),
     DUALS(REAL, out), DUALS(const REAL, in), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL aw = DUAL(in, 0, i), ax = DUAL(in, 1, i), ay = DUAL(in, 2, i), az = DUAL(in, 3, i);
        const REAL bw = DUAL(in, 4, i), bx = DUAL(in, 5, i), by = DUAL(in, 6, i), bz = DUAL(in, 7, i);
        const REAL inverse = 1 / SQRT(aw * aw + ax * ax + ay * ay + az * az);
        const REAL rest = (aw * bw + ax * bx + ay * by + az * bz) * inverse * inverse;
        DUAL(out, 0, i) = aw * inverse;
        DUAL(out, 1, i) = ax * inverse;
        DUAL(out, 2, i) = ay * inverse;
        DUAL(out, 3, i) = az * inverse;
        DUAL(out, 4, i) = (bw - aw * rest) * inverse;
        DUAL(out, 5, i) = (bx - ax * rest) * inverse;
        DUAL(out, 6, i) = (by - ay * rest) * inverse;
        DUAL(out, 7, i) = (bz - az * rest) * inverse;
    }
}

#define BLEND(k, a, b, c, d) DUAL(out, k, i) = w0 * (a) + w1 * (b) + w2 * (c) + w3 * (d)
#define BLEND_DUALS(a, b, c, d)                                                                                      \
    {                                                                                                                \
        BLEND(0, DUAL(a, 0, i), DUAL(b, 0, i), DUAL(c, 0, i), DUAL(d, 0, i));                                        \
        BLEND(1, DUAL(a, 1, i), DUAL(b, 1, i), DUAL(c, 1, i), DUAL(d, 1, i));                                        \
        BLEND(2, DUAL(a, 2, i), DUAL(b, 2, i), DUAL(c, 2, i), DUAL(d, 2, i));                                        \
        BLEND(3, DUAL(a, 3, i), DUAL(b, 3, i), DUAL(c, 3, i), DUAL(d, 3, i));                                        \
        BLEND(4, DUAL(a, 4, i), DUAL(b, 4, i), DUAL(c, 4, i), DUAL(d, 4, i));                                        \
        BLEND(5, DUAL(a, 5, i), DUAL(b, 5, i), DUAL(c, 5, i), DUAL(d, 5, i));                                        \
        BLEND(6, DUAL(a, 6, i), DUAL(b, 6, i), DUAL(c, 6, i), DUAL(d, 6, i));                                        \
        BLEND(7, DUAL(a, 7, i), DUAL(b, 7, i), DUAL(c, 7, i), DUAL(d, 7, i));                                        \
    }

LOOP(blend_motor_one, (DUALS_OF(a->out), WEIGHTS_OF(a->in[0]), a->fixed, a->count),
     DUALS(REAL, out), WEIGHTS(const REAL, weight), const REAL *controls, size_t count)
{
    REAL c[PLAIN_TERMS][8];
    for (int k = 0; k < PLAIN_TERMS; ++k)
        for (int n = 0; n < 8; ++n)
            c[k][n] = controls[8 * k + n];
    for (size_t i = 0; i < count; ++i) {
        const REAL w0 = WEIGHT(weight, 0, i), w1 = WEIGHT(weight, 1, i);
        const REAL w2 = WEIGHT(weight, 2, i), w3 = WEIGHT(weight, 3, i);
        BLEND(0, c[0][0], c[1][0], c[2][0], c[3][0]);
        BLEND(1, c[0][1], c[1][1], c[2][1], c[3][1]);
        BLEND(2, c[0][2], c[1][2], c[2][2], c[3][2]);
        BLEND(3, c[0][3], c[1][3], c[2][3], c[3][3]);
        BLEND(4, c[0][4], c[1][4], c[2][4], c[3][4]);
        BLEND(5, c[0][5], c[1][5], c[2][5], c[3][5]);
        BLEND(6, c[0][6], c[1][6], c[2][6], c[3][6]);
        BLEND(7, c[0][7], c[1][7], c[2][7], c[3][7]);
    }
}

LOOP(blend_motor_each, (DUALS_OF(a->out), WEIGHTS_OF(a->in[0]), DUALS_OF(a->in[1]), DUALS_OF(a->in[2]),
      DUALS_OF(a->in[3]), DUALS_OF(a->in[4]), a->count),
     DUALS(REAL, out), WEIGHTS(const REAL, weight), DUALS(const REAL, a), DUALS(const REAL, b),
     DUALS(const REAL, c), DUALS(const REAL, d), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL w0 = WEIGHT(weight, 0, i), w1 = WEIGHT(weight, 1, i);
        const REAL w2 = WEIGHT(weight, 2, i), w3 = WEIGHT(weight, 3, i);
        BLEND_DUALS(a, b, c, d)
    }
}

/* Cubic B-spline motions. The span of a parameter t; the weights of the four controls there, the first of which has
 * the number of the span; and their sum. */
#define SPAN_OF(t) NAME(span_of)(t)
static int NAME(span_of)(REAL t)
{
    const int span = (int)(t * PLAIN_SPANS);
    return span < PLAIN_SPANS ? span : PLAIN_SPANS - 1;
}
#define WEIGHTS_IN(polynomials, span, t)                                                                             \
    const REAL u = (t) * PLAIN_SPANS - (REAL)(span);                                                                 \
    const REAL w0 = CUBIC((polynomials), u), w1 = CUBIC((polynomials) + 4, u);                                       \
    const REAL w2 = CUBIC((polynomials) + 8, u), w3 = CUBIC((polynomials) + 12, u);
#define CUBIC(c, u) ((((c)[3] * (u) + (c)[2]) * (u) + (c)[1]) * (u) + (c)[0])
#define BLEND_ROWS(c)                                                                                                \
    BLEND(0, (c)[0], (c)[8], (c)[16], (c)[24]);                                                                      \
    BLEND(1, (c)[1], (c)[9], (c)[17], (c)[25]);                                                                      \
    BLEND(2, (c)[2], (c)[10], (c)[18], (c)[26]);                                                                     \
    BLEND(3, (c)[3], (c)[11], (c)[19], (c)[27]);                                                                     \
    BLEND(4, (c)[4], (c)[12], (c)[20], (c)[28]);                                                                     \
    BLEND(5, (c)[5], (c)[13], (c)[21], (c)[29]);                                                                     \
    BLEND(6, (c)[6], (c)[14], (c)[22], (c)[30]);                                                                     \
    BLEND(7, (c)[7], (c)[15], (c)[23], (c)[31]);

/* Sorted parameters: span after span. */
LOOP(sample_additive_one, (DUALS_OF(a->out), a->in[0][0], a->controls, a->polynomials, a->count),
     DUALS(REAL, out), const REAL *restrict parameter, const REAL *controls, const REAL *polynomials, size_t count)
{
    for (size_t i = 0; i < count;) {
        const int span = SPAN_OF(parameter[i]);
        REAL c[32], p[16];
        for (int k = 0; k < 32; ++k)
            c[k] = controls[8 * span + k];
        for (int k = 0; k < 16; ++k)
            p[k] = polynomials[16 * span + k];
        size_t end = i;
        while (end < count && SPAN_OF(parameter[end]) == span)
            ++end;
        for (; i < end; ++i) {
            WEIGHTS_IN(p, span, parameter[i])
            BLEND_ROWS(c)
        }
    }
}

LOOP(sample_additive_one_random, (DUALS_OF(a->out), a->in[0][0], a->controls, a->polynomials, a->count),
     DUALS(REAL, out), const REAL *restrict parameter, const REAL *restrict controls,
     const REAL *restrict polynomials, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const int span = SPAN_OF(parameter[i]);
        const REAL *c = controls + 8 * span;
        WEIGHTS_IN(polynomials + 16 * span, span, parameter[i])
        BLEND_ROWS(c)
    }
}

LOOP(sample_additive_each, (DUALS_OF(a->out), a->in[0][0], a->controls, a->polynomials, a->count),
     DUALS(REAL, out), const REAL *restrict parameter, const REAL *restrict controls,
     const REAL *restrict polynomials, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const int span = SPAN_OF(parameter[i]);
        const REAL *c = controls + 8 * (PLAIN_CONTROLS * i + (size_t)span);
        WEIGHTS_IN(polynomials + 16 * span, span, parameter[i])
        BLEND_ROWS(c)
    }
}

/* Controls with the same number lie together, as results do. */
#define CONTROLS(k) DUALS_OF(a->in[SPAN_OF(a->parameter) + k])
LOOP(sample_additive_each_shared, (DUALS_OF(a->out), a->parameter, a->polynomials, CONTROLS(0), CONTROLS(1),
      CONTROLS(2), CONTROLS(3), a->count),
     DUALS(REAL, out), REAL parameter, const REAL *polynomials, DUALS(const REAL, a), DUALS(const REAL, b),
     DUALS(const REAL, c), DUALS(const REAL, d), size_t count)
{
    const int span = SPAN_OF(parameter);
    WEIGHTS_IN(polynomials + 16 * span, span, parameter)
    for (size_t i = 0; i < count; ++i)
        BLEND_DUALS(a, b, c, d)
}
#undef CONTROLS

#undef BLEND
#undef BLEND_DUALS
#undef BLEND_ROWS
#undef CUBIC
#undef SPAN_OF
#undef WEIGHTS_IN

#endif

#undef COMPOSE
#undef COPY
#undef COPY_ALL
#undef LOOP
#undef LOAD_ROTATION
#undef LOAD_MATRIX
#undef MOVE_POINT
#undef MOVE_DIRECTION
#undef MOVE_VERTEX
#undef GRID
