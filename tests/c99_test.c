/* motorway.h is C99, its views and every pair of its functions work from C. Exits with the number of what fails. */
#include <stdio.h>
#include <string.h>

#include "motorway.h"

static int failures = 0;

static void check(int holds, const char *what, int line)
{
    if (!holds) {
        fprintf(stderr, "c99_test.c:%d: %s\n", line, what);
        ++failures;
    }
}

#define CHECK(condition) check(condition, #condition, __LINE__)

/* A quarter turn about e3 and then a step of 10 along e1 take (1, 0, 0) to (10, 1, 0). */
#define DEFINE_TEST(precision, T, tolerance)                                                                         \
    static int near_##precision(T a, T b) { return a - b < (tolerance) && b - a < (tolerance); }                     \
                                                                                                                     \
    static void test_motors_##precision(void)                                                                        \
    {                                                                                                                \
        const T axis[3] = {0, 0, 1}, offset[3] = {10, 0, 0}, point[3] = {1, 0, 0};                                   \
        const T angle = (T)1.57079632679489661923;                                                                   \
        mw_motor_##precision turn, step, pose, back, unit;                                                           \
        size_t bad = 7;                                                                                              \
        T moved[3], columns[3], turned[3];                                                                           \
        CHECK(mw_rotation_##precision(&turn, axis, angle, NULL) == MW_OK);                                           \
        CHECK(mw_translation_##precision(&step, offset) == MW_OK);                                                   \
        CHECK(mw_compose_motor_each_##precision(mw_motors_##precision##_aos(&pose, sizeof pose),                     \
                                                mw_const_motors_##precision##_aos(&turn, sizeof turn),               \
                                                mw_const_motors_##precision##_aos(&step, sizeof step), 1) == MW_OK); \
        CHECK(mw_check_motors_##precision(mw_const_motors_##precision##_aos(&pose, sizeof pose), 1, &bad) == MW_OK); \
        CHECK(mw_apply_point_one_##precision(mw_xyz_##precision##_aos(moved, sizeof moved), &pose,                   \
                                             mw_const_xyz_##precision##_aos(point, sizeof point), 1,                 \
                                             MW_DEFAULT) == MW_OK);                                                  \
        CHECK(near_##precision(moved[0], 10) && near_##precision(moved[1], 1) && near_##precision(moved[2], 0));     \
        CHECK(mw_apply_point_each_##precision(                                                                       \
                  mw_xyz_##precision##_soa(&columns[0], &columns[1], &columns[2]),                                   \
                  mw_const_motors_##precision##_aos(&pose, sizeof pose),                                             \
                  mw_const_xyz_##precision##_soa(&point[0], &point[1], &point[2]), 1, MW_UNIT_MOTORS) == MW_OK);     \
        CHECK(near_##precision(columns[0], 10) && near_##precision(columns[1], 1));                                  \
        CHECK(mw_apply_direction_one_##precision(mw_xyz_##precision##_aos(turned, sizeof turned), &pose,             \
                                                 mw_const_xyz_##precision##_aos(point, sizeof point), 1,             \
                                                 MW_DEFAULT) == MW_OK);                                              \
        CHECK(near_##precision(turned[0], 0) && near_##precision(turned[1], 1));                                     \
        CHECK(mw_apply_direction_each_##precision(mw_xyz_##precision##_aos(turned, sizeof turned),                   \
                                                  mw_const_motors_##precision##_aos(&pose, sizeof pose),             \
                                                  mw_const_xyz_##precision##_aos(point, sizeof point), 1,            \
                                                  MW_DEFAULT) == MW_OK);                                             \
        CHECK(near_##precision(turned[0], 0) && near_##precision(turned[1], 1));                                     \
        CHECK(mw_reverse_motor_each_##precision(mw_motors_##precision##_aos(&back, sizeof back),                     \
                                                mw_const_motors_##precision##_aos(&pose, sizeof pose), 1) == MW_OK); \
        CHECK(mw_apply_point_one_##precision(mw_xyz_##precision##_aos(moved, sizeof moved), &back,                   \
                                             mw_const_xyz_##precision##_aos(moved, sizeof moved), 1,                 \
                                             MW_DEFAULT) == MW_OK);                                                  \
        CHECK(near_##precision(moved[0], 1) && near_##precision(moved[1], 0));                                       \
        {                                                                                                            \
            /* Twice the motor is the same motion; eight arrays of one number are a view as well. */                 \
            T twice[8], result[8], *out[8];                                                                          \
            const T *in[8];                                                                                          \
            int k;                                                                                                   \
            memcpy(twice, &pose, sizeof twice);                                                                      \
            for (k = 0; k < 8; ++k) {                                                                                \
                twice[k] *= 2;                                                                                       \
                in[k] = &twice[k];                                                                                   \
                out[k] = &result[k];                                                                                 \
            }                                                                                                        \
            CHECK(mw_normalize_motor_each_##precision(mw_motors_##precision##_soa(out),                              \
                                                      mw_const_motors_##precision##_soa(in), 1) == MW_OK);           \
            memcpy(&unit, result, sizeof unit);                                                                      \
            CHECK(near_##precision(unit.s, pose.s) && near_##precision(unit.b1i, pose.b1i));                         \
        }                                                                                                            \
    }                                                                                                                \
                                                                                                                     \
    static void test_sums_##precision(void)                                                                          \
    {                                                                                                                \
        const mw_motor_##precision controls[2] = {{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 4, 0, 0, 0}};               \
        const T weights[2] = {(T)0.25, (T)0.75}, *const terms[2] = {&weights[0], &weights[1]};                       \
        const T knots[2] = {0, 1}, parameter = (T)0.75;                                                              \
        mw_const_motors_##precision views[2];                                                                        \
        mw_weights_##precision view;                                                                                 \
        mw_bspline_##precision motion;                                                                               \
        mw_motor_##precision sum;                                                                                    \
        size_t where = 7;                                                                                            \
        view.terms = terms;                                                                                          \
        view.stride = sizeof weights;                                                                                \
        CHECK(mw_blend_motor_one_##precision(mw_motors_##precision##_aos(&sum, sizeof sum), controls, view, 2, 1) == \
              MW_OK);                                                                                                \
        CHECK(near_##precision(sum.s, 1) && near_##precision(sum.b1i, 3));                                           \
        views[0] = mw_const_motors_##precision##_aos(&controls[0], sizeof controls[0]);                              \
        views[1] = mw_const_motors_##precision##_aos(&controls[1], sizeof controls[1]);                              \
        CHECK(mw_blend_motor_each_##precision(mw_motors_##precision##_aos(&sum, sizeof sum), views, view, 2, 1) ==   \
              MW_OK);                                                                                                \
        CHECK(near_##precision(sum.s, 1) && near_##precision(sum.b1i, 3));                                           \
        motion.controls = controls;                                                                                  \
        motion.control_count = 2;                                                                                    \
        motion.knots = knots;                                                                                        \
        motion.knot_count = 2;                                                                                       \
        motion.degree = 1;                                                                                           \
        CHECK(mw_check_bspline_##precision(&motion, &where) == MW_OK);                                               \
        CHECK(mw_sample_bspline_##precision(mw_motors_##precision##_aos(&sum, sizeof sum), &motion, &parameter,      \
                                            1) == MW_OK);                                                            \
        CHECK(near_##precision(sum.s, 1) && near_##precision(sum.b1i, 3));                                           \
    }

DEFINE_TEST(f32, float, 1e-5f)
DEFINE_TEST(f64, double, 1e-14)

int main(void)
{
    CHECK(mw_isa() != NULL);
    CHECK(strstr(mw_isas(), "scalar") != NULL);
    CHECK(strlen(mw_status_text(MW_OK)) > 0);
    CHECK(MW_VERSION_MAJOR >= 0 && MW_VERSION_MINOR >= 0 && MW_VERSION_PATCH >= 0);
    test_motors_f32();
    test_motors_f64();
    test_sums_f32();
    test_sums_f64();
    return failures;
}
