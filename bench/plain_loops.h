/* The loops themselves, in the layout and precision of the macros. No include guard: once a layout and precision.
 *
 *     points   x y z
 *     rigids   a unit quaternion w x y z and a translation
 *     duals    dual quaternions: w x y z of the real part, then of the dual part
 *     matrix   3 rows of 4: a rotation and a translation
 *
 * Compilers trust `restrict` fully in parameters alone, so a loop is a function of as many pointers as it has arrays,
 * behind one of the common type. */

#define LOOP(name, arguments, ...)                                                                                   \
    static void NAME(name##_loop)(__VA_ARGS__);                                                                      \
    static void NAME(name)(REAL *const *to, const REAL *const *const *from, const REAL *fixed, size_t count)         \
    {                                                                                                                \
        (void)fixed;                                                                                                 \
        NAME(name##_loop) arguments;                                                                                 \
    }                                                                                                                \
    static void NAME(name##_loop)(__VA_ARGS__)

LOOP(apply_point_one, (POINTS_OF(to), POINTS_OF(from[0]), fixed, count),
     POINTS(REAL, out), POINTS(const REAL, in), const REAL *matrix, size_t count)
{
    const REAL m00 = matrix[0], m01 = matrix[1], m02 = matrix[2], m03 = matrix[3];
    const REAL m10 = matrix[4], m11 = matrix[5], m12 = matrix[6], m13 = matrix[7];
    const REAL m20 = matrix[8], m21 = matrix[9], m22 = matrix[10], m23 = matrix[11];
    for (size_t i = 0; i < count; ++i) {
        const REAL x = POINT(in, 0, i), y = POINT(in, 1, i), z = POINT(in, 2, i);
        POINT(out, 0, i) = m00 * x + m01 * y + m02 * z + m03;
        POINT(out, 1, i) = m10 * x + m11 * y + m12 * z + m13;
        POINT(out, 2, i) = m20 * x + m21 * y + m22 * z + m23;
    }
}

LOOP(apply_direction_one, (POINTS_OF(to), POINTS_OF(from[0]), fixed, count),
     POINTS(REAL, out), POINTS(const REAL, in), const REAL *matrix, size_t count)
{
    const REAL m00 = matrix[0], m01 = matrix[1], m02 = matrix[2];
    const REAL m10 = matrix[4], m11 = matrix[5], m12 = matrix[6];
    const REAL m20 = matrix[8], m21 = matrix[9], m22 = matrix[10];
    for (size_t i = 0; i < count; ++i) {
        const REAL x = POINT(in, 0, i), y = POINT(in, 1, i), z = POINT(in, 2, i);
        POINT(out, 0, i) = m00 * x + m01 * y + m02 * z;
        POINT(out, 1, i) = m10 * x + m11 * y + m12 * z;
        POINT(out, 2, i) = m20 * x + m21 * y + m22 * z;
    }
}

/* p + w c + q × c with c = 2 q × p: the usual rotation by a unit quaternion, and then the translation. */
LOOP(apply_point_each, (POINTS_OF(to), RIGIDS_OF(from[0]), POINTS_OF(from[1]), count),
     POINTS(REAL, out), RIGIDS(const REAL, rigid), POINTS(const REAL, in), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL x = POINT(in, 0, i), y = POINT(in, 1, i), z = POINT(in, 2, i);
        const REAL w = RIGID(rigid, 0, i), qx = RIGID(rigid, 1, i), qy = RIGID(rigid, 2, i), qz = RIGID(rigid, 3, i);
        const REAL cx = 2 * (qy * z - qz * y), cy = 2 * (qz * x - qx * z), cz = 2 * (qx * y - qy * x);
        POINT(out, 0, i) = x + w * cx + (qy * cz - qz * cy) + RIGID(rigid, 4, i);
        POINT(out, 1, i) = y + w * cy + (qz * cx - qx * cz) + RIGID(rigid, 5, i);
        POINT(out, 2, i) = z + w * cz + (qx * cy - qy * cx) + RIGID(rigid, 6, i);
    }
}

LOOP(apply_direction_each, (POINTS_OF(to), RIGIDS_OF(from[0]), POINTS_OF(from[1]), count),
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

/* (a + ε b)(c + ε d) = a c + ε (a d + b c), where a + ε b is the later motion. */
LOOP(compose_motor_each, (DUALS_OF(to), DUALS_OF(from[0]), DUALS_OF(from[1]), count),
     DUALS(REAL, out), DUALS(const REAL, first), DUALS(const REAL, then), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL aw = DUAL(then, 0, i), ax = DUAL(then, 1, i), ay = DUAL(then, 2, i), az = DUAL(then, 3, i);
        const REAL bw = DUAL(then, 4, i), bx = DUAL(then, 5, i), by = DUAL(then, 6, i), bz = DUAL(then, 7, i);
        const REAL cw = DUAL(first, 0, i), cx = DUAL(first, 1, i), cy = DUAL(first, 2, i), cz = DUAL(first, 3, i);
        const REAL dw = DUAL(first, 4, i), dx = DUAL(first, 5, i), dy = DUAL(first, 6, i), dz = DUAL(first, 7, i);
        DUAL(out, 0, i) = aw * cw - ax * cx - ay * cy - az * cz;
        DUAL(out, 1, i) = aw * cx + ax * cw + ay * cz - az * cy;
        DUAL(out, 2, i) = aw * cy - ax * cz + ay * cw + az * cx;
        DUAL(out, 3, i) = aw * cz + ax * cy - ay * cx + az * cw;
        DUAL(out, 4, i) = aw * dw - ax * dx - ay * dy - az * dz + bw * cw - bx * cx - by * cy - bz * cz;
        DUAL(out, 5, i) = aw * dx + ax * dw + ay * dz - az * dy + bw * cx + bx * cw + by * cz - bz * cy;
        DUAL(out, 6, i) = aw * dy - ax * dz + ay * dw + az * dx + bw * cy - bx * cz + by * cw + bz * cx;
        DUAL(out, 7, i) = aw * dz + ax * dy - ay * dx + az * dw + bw * cz + bx * cy - by * cx + bz * cw;
    }
}

LOOP(reverse_motor_each, (DUALS_OF(to), DUALS_OF(from[0]), count),
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
LOOP(normalize_motor_each, (DUALS_OF(to), DUALS_OF(from[0]), count),
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

LOOP(blend_motor_one, (DUALS_OF(to), WEIGHTS_OF(from[0]), fixed, count),
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

LOOP(blend_motor_each, (DUALS_OF(to), WEIGHTS_OF(from[0]), DUALS_OF(from[1]), DUALS_OF(from[2]),
      DUALS_OF(from[3]), DUALS_OF(from[4]), count),
     DUALS(REAL, out), WEIGHTS(const REAL, weight), DUALS(const REAL, a), DUALS(const REAL, b),
     DUALS(const REAL, c), DUALS(const REAL, d), size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const REAL w0 = WEIGHT(weight, 0, i), w1 = WEIGHT(weight, 1, i);
        const REAL w2 = WEIGHT(weight, 2, i), w3 = WEIGHT(weight, 3, i);
        BLEND(0, DUAL(a, 0, i), DUAL(b, 0, i), DUAL(c, 0, i), DUAL(d, 0, i));
        BLEND(1, DUAL(a, 1, i), DUAL(b, 1, i), DUAL(c, 1, i), DUAL(d, 1, i));
        BLEND(2, DUAL(a, 2, i), DUAL(b, 2, i), DUAL(c, 2, i), DUAL(d, 2, i));
        BLEND(3, DUAL(a, 3, i), DUAL(b, 3, i), DUAL(c, 3, i), DUAL(d, 3, i));
        BLEND(4, DUAL(a, 4, i), DUAL(b, 4, i), DUAL(c, 4, i), DUAL(d, 4, i));
        BLEND(5, DUAL(a, 5, i), DUAL(b, 5, i), DUAL(c, 5, i), DUAL(d, 5, i));
        BLEND(6, DUAL(a, 6, i), DUAL(b, 6, i), DUAL(c, 6, i), DUAL(d, 6, i));
        BLEND(7, DUAL(a, 7, i), DUAL(b, 7, i), DUAL(c, 7, i), DUAL(d, 7, i));
    }
}

#undef BLEND
#undef LOOP
