/* The headers are C99,
        its views and every pair of its functions work from C. Exits with the number of what fails. */
#include <stdio.h>
#include <string.h>

#include "motorway_views.h"

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
        const mw_xyz_##precision to = mw_xyz_##precision##_soa(&columns[0], &columns[1], &columns[2]);               \
        const mw_const_xyz_##precision from = mw_const_xyz_##precision##_soa(&point[0], &point[1], &point[2]);       \
        const mw_const_motors_##precision motors = mw_const_motors_##precision##_aos(&pose, sizeof pose);            \
        CHECK(mw_rotation_##precision(&turn, axis, angle, NULL) == MW_OK);                                           \
        CHECK(mw_translation_##precision(&step, offset) == MW_OK);                                                   \
        CHECK(mw_compose_motor_each_##precision(&pose, sizeof pose,                                                  \
                                                &turn, sizeof turn,                                                  \
                                                &step, sizeof step, 1) == MW_OK);                                    \
        CHECK(mw_check_motors_##precision(&pose, sizeof pose, 1, &bad) == MW_OK);                                    \
        CHECK(mw_apply_point_one_##precision(moved, sizeof moved, &pose,                                             \
                                             point, sizeof point, 1,                                                 \
                                             MW_DEFAULT) == MW_OK);                                                  \
        CHECK(near_##precision(moved[0], 10) && near_##precision(moved[1], 1) && near_##precision(moved[2], 0));     \
        CHECK(mw_apply_point_each_views_##precision(&to, &motors, &from, 1, MW_UNIT_MOTORS) == MW_OK);               \
        CHECK(near_##precision(columns[0], 10) && near_##precision(columns[1], 1));                                  \
        CHECK(mw_apply_direction_one_##precision(turned, sizeof turned, &pose,                                       \
                                                 point, sizeof point, 1,                                             \
                                                 MW_DEFAULT) == MW_OK);                                              \
        CHECK(near_##precision(turned[0], 0) && near_##precision(turned[1], 1));                                     \
        CHECK(mw_apply_direction_each_##precision(turned, sizeof turned,                                             \
                                                  &pose, sizeof pose,                                                \
                                                  point, sizeof point, 1,                                            \
                                                  MW_DEFAULT) == MW_OK);                                             \
        CHECK(near_##precision(turned[0], 0) && near_##precision(turned[1], 1));                                     \
        CHECK(mw_reverse_motor_each_##precision(&back, sizeof back,                                                  \
                                                &pose, sizeof pose, 1) == MW_OK);                                    \
        CHECK(mw_apply_point_one_##precision(moved, sizeof moved, &back,                                             \
                                             moved, sizeof moved, 1,                                                 \
                                             MW_DEFAULT) == MW_OK);                                                  \
        CHECK(near_##precision(moved[0], 1) && near_##precision(moved[1], 0));                                       \
        {                                                                                                            \
            /* Twice the motor is the same motion; eight arrays of one number are a view as well. */                 \
            T twice[8], result[8], *out[8];                                                                          \
            const T *in[8];                                                                                          \
            mw_motors_##precision to_arrays;                                                                         \
            mw_const_motors_##precision from_arrays;                                                                 \
            int k;                                                                                                   \
            memcpy(twice, &pose, sizeof twice);                                                                      \
            for (k = 0; k < 8; ++k) {                                                                                \
                twice[k] *= 2;                                                                                       \
                in[k] = &twice[k];                                                                                   \
                out[k] = &result[k];                                                                                 \
            }                                                                                                        \
            to_arrays = mw_motors_##precision##_soa(out);                                                            \
            from_arrays = mw_const_motors_##precision##_soa(in);                                                     \
            CHECK(mw_normalize_motor_each_views_##precision(&to_arrays, &from_arrays, 1) == MW_OK);                  \
            memcpy(&unit, result, sizeof unit);                                                                      \
            CHECK(near_##precision(unit.s, pose.s) && near_##precision(unit.b1i, pose.b1i));                         \
        }                                                                                                            \
    }                                                                                                                \
                                                                                                                     \
    static void test_sums_##precision(void)                                                                          \
    {                                                                                                                \
        const mw_motor_##precision controls[2] = {{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 4, 0, 0, 0}};               \
        const T weights[2] = {(T)0.25, (T)0.75}, *const terms[2] = {&weights[0], &weights[1]};                       \
        mw_const_motors_##precision views[2];                                                                        \
        mw_weights_##precision view;                                                                                 \
        mw_motor_##precision sum;                                                                                    \
        const mw_motors_##precision out = mw_motors_##precision##_aos(&sum, sizeof sum);                             \
        view.terms = terms;                                                                                          \
        view.stride = sizeof weights;                                                                                \
        CHECK(mw_blend_motor_one_views_##precision(&out, controls, &view, 2, 1) == MW_OK);                           \
        CHECK(near_##precision(sum.s, 1) && near_##precision(sum.b1i, 3));                                           \
        views[0] = mw_const_motors_##precision##_aos(&controls[0], sizeof controls[0]);                              \
        views[1] = mw_const_motors_##precision##_aos(&controls[1], sizeof controls[1]);                              \
        CHECK(mw_blend_motor_each_views_##precision(&out, views, &view, 2, 1) == MW_OK);                             \
        CHECK(near_##precision(sum.s, 1) && near_##precision(sum.b1i, 3));                                           \
    }

DEFINE_TEST(f32, float, 1e-5f)
DEFINE_TEST(f64, double, 1e-14)

/* A straight motion of 4 along e1, from the description to a point that it moves. */
#define DEFINE_MOTION_TEST(P, T)                                                                                     \
    static void test_motion_##P(void)                                                                                \
    {                                                                                                                \
        const mw_motor_##P controls[2] = {{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 2, 0, 0, 0}};                       \
        const T knots[2] = {0, 1}, parameters[2] = {(T)0.25, (T)0.75}, point[3] = {1, 2, 3};                         \
        uint64_t memory[256];                                                                                        \
        const mw_compiled_motion_##P *compiled = NULL;                                                               \
        mw_motion_##P motion;                                                                                        \
        mw_motor_##P poses[2];                                                                                       \
        T domain[2], twists[2][6], moved[2][3], velocity[3];                                                         \
        size_t size = 0, where = 7;                                                                                  \
        memset(&motion, 0, sizeof motion);                                                                           \
        motion.kind = MW_MOTION_ADDITIVE;                                                                            \
        motion.degree = 1;                                                                                           \
        motion.controls = controls;                                                                                  \
        motion.control_count = 2;                                                                                    \
        motion.knots = knots;                                                                                        \
        motion.knot_count = 2;                                                                                       \
        CHECK(mw_motion_size_##P(&size, &motion, &where) == MW_OK && size <= sizeof memory);                         \
        CHECK(mw_compile_motion_##P(&compiled, memory, sizeof memory, &motion, MW_DEFAULT, &where) == MW_OK);        \
        CHECK(mw_motion_domain_##P(domain, compiled) == MW_OK && near_##P(domain[0], 0) && near_##P(domain[1],       \
                                   1));                                                                              \
        CHECK(mw_sample_motion_one_##P(poses, sizeof poses[0], compiled, 0, parameters, 2, MW_DEFAULT) == MW_OK);    \
        CHECK(near_##P(poses[1].s, 1) && near_##P(poses[1].b1i, (T)1.5));                                            \
        CHECK(mw_sample_motion_each_##P(poses, sizeof poses[0], compiled, 0, parameters, sizeof(T), 1,               \
                                        MW_CLAMP_PARAMETERS) == MW_OK);                                              \
        CHECK(near_##P(poses[0].b1i, (T)0.5));                                                                       \
        CHECK(mw_sample_motion_twist_one_##P(poses, sizeof poses[0], twists[0], sizeof twists[0], compiled, 0,       \
                                             parameters, 2, MW_BODY_FRAME) == MW_OK);                                \
        CHECK(near_##P(twists[1][3], 2) && near_##P(twists[1][0], 0));                                               \
        CHECK(mw_sample_motion_twist_each_##P(poses, sizeof poses[0], twists[0], sizeof twists[0], compiled, 0,      \
                                              parameters, 0, 1, MW_DEFAULT) == MW_OK);                               \
        CHECK(near_##P(twists[0][3], 2));                                                                            \
        CHECK(mw_twist_velocity_##P(velocity, twists[0], point) == MW_OK && near_##P(velocity[0], 4));               \
        CHECK(mw_apply_point_motion_##P(moved[0], sizeof moved[0], sizeof moved[0], compiled, 0,                     \
                                        parameters, 2, point, sizeof point, 1,                                       \
                                        MW_DEFAULT) == MW_OK);                                                       \
        CHECK(near_##P(moved[0][0], 2) && near_##P(moved[1][0], 4) && near_##P(moved[1][1], 2));                     \
        motion.degree = 0;                                                                                           \
        CHECK(mw_motion_size_##P(&size, &motion, NULL) == MW_ERROR_DEGREE);                                          \
    }

DEFINE_MOTION_TEST(f32, float)
DEFINE_MOTION_TEST(f64, double)

#define DEFINE_MOTION_TOOLS_TEST(P, T)                                                                               \
    static void test_motion_tools_##P(void)                                                                          \
    {                                                                                                                \
        /* Through three keys 4 apart along e1, at 0, 1 and 2. */                                                    \
        const mw_motor_##P keys[3] = {{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 2, 0, 0, 0}, {1, 0, 0, 0, 4, 0, 0,      \
                0}};                                                                                                 \
        const T times[3] = {0, 1, 2}, origin[3] = {0, 0, 0};                                                         \
        mw_motor_##P controls[2][8];                                                                                 \
        T knots[2][16], lengths[3], even[3];                                                                         \
        uint64_t memory[512], working[512];                                                                          \
        size_t size = 0, where = 7;                                                                                  \
        mw_motion_##P motion, longer, higher, before, after;                                                         \
        mw_motion_arrays_##P arrays[2];                                                                              \
        mw_motion_distance_##P largest;                                                                              \
        const mw_compiled_motion_##P *compiled = NULL;                                                               \
        int k;                                                                                                       \
        for (k = 0; k < 2; ++k) {                                                                                    \
            arrays[k].controls = controls[k];                                                                        \
            arrays[k].control_capacity = 8;                                                                          \
            arrays[k].knots = knots[k];                                                                              \
            arrays[k].knot_capacity = 16;                                                                            \
        }                                                                                                            \
        CHECK(mw_interpolate_keys_##P(&motion, &arrays[0], MW_MOTION_ADDITIVE, 2, keys, times, 3, NULL, &size,       \
                                      &where) == MW_OK && size <= sizeof working);                                   \
        CHECK(mw_interpolate_keys_##P(&motion, &arrays[0], MW_MOTION_ADDITIVE, 2, keys, times, 3, working, &size,    \
                                      &where) == MW_OK);                                                             \
        CHECK(motion.control_count == 3 && near_##P(motion.controls[1].b1i, 2));                                     \
        CHECK(mw_compile_motion_##P(&compiled, memory, sizeof memory, &motion, MW_KEEP_SIGNS, NULL) == MW_OK);       \
        CHECK(mw_motion_lengths_##P(lengths, compiled, 0, origin, times, 3) == MW_OK && near_##P(lengths[2], 8));    \
        CHECK(mw_motion_even_parameters_##P(even, compiled, 0, origin, 3) == MW_OK && near_##P(even[1], 1));         \
        CHECK(mw_compare_motions_##P(&largest, compiled, 0, compiled, 0,                                             \
                                     origin, sizeof origin, 1, 9) == MW_OK);                                         \
        CHECK(largest.distance == 0);                                                                                \
        CHECK(mw_insert_knot_##P(&longer, &arrays[1], &motion, 1, 1) == MW_OK && longer.control_count == 4);         \
        CHECK(mw_elevate_degree_##P(&higher, &arrays[1], &motion) == MW_OK && higher.degree == 3);                   \
        arrays[0].controls = controls[0] + 4;                                                                        \
        arrays[0].control_capacity = 4;                                                                              \
        arrays[0].knots = knots[0] + 8;                                                                              \
        arrays[0].knot_capacity = 8;                                                                                 \
        CHECK(mw_split_motion_##P(&before, &arrays[0], &after, &arrays[1], &motion, 1) == MW_OK);                    \
        CHECK(near_##P(before.controls[2].b1i, 2) && near_##P(after.controls[0].b1i, 2));                            \
    }

DEFINE_MOTION_TOOLS_TEST(f32, float)
DEFINE_MOTION_TOOLS_TEST(f64, double)

/* A half turn about e3 is e12, its logarithm ½ π e12, and its root the quarter turn. */
#define DEFINE_GROUP_TEST(precision, T)                                                                              \
    static void test_group_##precision(void)                                                                         \
    {                                                                                                                \
        const T half_pi = (T)1.57079632679489661923, root = (T)0.70710678118654752440, half = (T)0.5;                \
        const mw_motor_##precision one = {1, 0, 0, 0, 0, 0, 0, 0}, turn = {0, 1, 0, 0, 0, 0, 0, 0};                  \
        const int32_t parents[2] = {-1, 0};                                                                          \
        mw_motor_##precision result, locals[2], poses[2];                                                            \
        T log[6], principal[6];                                                                                      \
        size_t bad = 7;                                                                                              \
        CHECK(mw_log_motor_each_##precision(log, sizeof log, &turn, sizeof turn, 1,                                  \
                                            MW_DEFAULT) == MW_OK);                                                   \
        CHECK(near_##precision(log[0], half_pi) && near_##precision(log[1], 0) && near_##precision(log[3], 0));      \
        CHECK(mw_log_principal_motor_each_##precision(                                                               \
                  principal, sizeof principal, &turn, sizeof turn, 1, MW_UNIT_MOTORS) == MW_OK);                     \
        CHECK(near_##precision(principal[0], half_pi));                                                              \
        CHECK(mw_exp_motor_each_##precision(&result, sizeof result, log, sizeof log, 1) == MW_OK);                   \
        CHECK(near_##precision(result.s, 0) && near_##precision(result.b12, 1));                                     \
        CHECK(mw_sqrt_motor_each_##precision(&result, sizeof result, &turn, sizeof turn, 1) == MW_OK);               \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, root));                               \
        CHECK(mw_power_motor_each_##precision(&result, sizeof result, &turn, sizeof turn, &half, 0, 1) == MW_OK);    \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, root));                               \
        CHECK(mw_slerp_motor_each_##precision(&result, sizeof result, &one, sizeof one, &turn, sizeof turn,          \
                                              &half, sizeof half, 1, MW_DEFAULT) == MW_OK);                          \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, root));                               \
        CHECK(mw_slerp_motor_one_##precision(&result, sizeof result, &one, &turn, &half, sizeof half, 1,             \
                                             MW_DEFAULT) == MW_OK);                                                  \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, root));                               \
        /* The long way is back by as much, for a half turn. */                                                      \
        CHECK(mw_slerp_motor_one_##precision(&result, sizeof result, &one, &turn, &half, sizeof half, 1,             \
                                             MW_LONG_WAY) == MW_OK);                                                 \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, -root));                              \
        CHECK(mw_nlerp_motor_each_##precision(&result, sizeof result, &one, sizeof one, &turn, sizeof turn,          \
                                              &half, sizeof half, 1, MW_DEFAULT) == MW_OK);                          \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, root));                               \
        CHECK(mw_nlerp_motor_one_##precision(&result, sizeof result, &one, &turn, &half, sizeof half, 1,             \
                                             MW_LONG_WAY) == MW_OK);                                                 \
        CHECK(near_##precision(result.s, root) && near_##precision(result.b12, -root));                              \
        CHECK(mw_ratio_motor_each_##precision(&result, sizeof result, &turn, sizeof turn, &one, sizeof one, 1,       \
                                              MW_DEFAULT) == MW_OK);                                                 \
        CHECK(near_##precision(result.s, 0) && near_##precision(result.b12, -1));                                    \
        CHECK(mw_inverse_motor_each_##precision(&result, sizeof result, &turn, sizeof turn, 1) == MW_OK);            \
        CHECK(near_##precision(result.s, 0) && near_##precision(result.b12, -1));                                    \
        CHECK(mw_compose_motor_one_first_##precision(&result, sizeof result, &turn, &turn, sizeof turn,              \
                                                     1) == MW_OK);                                                   \
        CHECK(near_##precision(result.s, -1));                                                                       \
        CHECK(mw_compose_motor_one_then_##precision(&result, sizeof result, &turn, sizeof turn, &turn,               \
                                                    1) == MW_OK);                                                    \
        CHECK(near_##precision(result.s, -1));                                                                       \
        locals[0] = locals[1] = turn;                                                                                \
        CHECK(mw_compose_motor_hierarchy_##precision(poses, sizeof poses[0],                                         \
                                                     locals, sizeof locals[0],                                       \
                                                     sizeof locals[0], parents, 2, 1, &bad) == MW_OK);               \
        CHECK(near_##precision(poses[0].b12, 1) && near_##precision(poses[1].s, -1));                                \
    }

DEFINE_GROUP_TEST(f32, float)
DEFINE_GROUP_TEST(f64, double)

/* The same pose in everything that holds one, and back: a half turn about e3 and then a step of 10 along e1. */
#define DEFINE_CONVERSION_TEST(P, T)                                                                                 \
    static void check_pose_##P(const mw_motor_##P *pose)                                                             \
    {                                                                                                                \
        CHECK(near_##P(pose->s, 0) && near_##P(pose->b12 * pose->b12, 1));                                           \
        CHECK(near_##P(pose->b2i, -5 * pose->b12) && near_##P(pose->b1i, 0));                                        \
        CHECK(near_##P(pose->b3i, 0) && near_##P(pose->w, 0));                                                       \
    }                                                                                                                \
                                                                                                                     \
    static void test_conversions_##P(void)                                                                           \
    {                                                                                                                \
        const T half_pi = (T)1.57079632679489661923;                                                                 \
        const mw_motor_##P pose = {0, 1, 0, 0, 0, -5, 0, 0};                                                         \
        mw_motor_##P back;                                                                                           \
        T four[4], three[3], angles[3], eight[8], numbers[16], deviation = 1;                                        \
        size_t bad = 7;                                                                                              \
        const mw_motors_##P out = mw_motors_##P##_aos(&back, sizeof back);                                           \
        const mw_const_motors_##P in = mw_const_motors_##P##_from(mw_const_motors_##P##_aos(&pose, sizeof pose),     \
                                                                  0);                                                \
        const mw_xyz_##P to_three = mw_xyz_##P##_aos(three, sizeof three);                                           \
        const mw_xyzw_##P wxyz = mw_xyzw_##P##_wxyz(four, sizeof four);                                              \
        const mw_dual_quaternions_##P to_eight = mw_dual_quaternions_##P##_wxyz(eight, sizeof eight);                \
        const mw_const_dual_quaternions_##P from_eight = mw_const_dual_quaternions_##P##_wxyz(eight,                 \
                sizeof eight);                                                                                       \
        CHECK(mw_convert_motor_to_pose_each_##P(four, sizeof four, three, sizeof three, &pose, sizeof pose,          \
                                                1) == MW_OK);                                                        \
        CHECK(near_##P(four[2], 1) && near_##P(four[3], 0) && near_##P(three[0], 10));                               \
        CHECK(mw_convert_pose_to_motor_each_##P(&back, sizeof back, four, sizeof four, three, sizeof three,          \
                                                1) == MW_OK);                                                        \
        check_pose_##P(&back);                                                                                       \
        CHECK(mw_convert_motor_to_pose_each_views_##P(&wxyz, &to_three, &in, 1) == MW_OK);                           \
        CHECK(near_##P(four[0], 0) && near_##P(four[3], 1));                                                         \
        CHECK(mw_convert_motor_to_dual_quaternion_each_views_##P(&to_eight, &in, 1) == MW_OK);                       \
        CHECK(eight[3] == 1 && eight[6] == -5);                                                                      \
        CHECK(mw_convert_dual_quaternion_to_motor_each_views_##P(&out, &from_eight, 1) == MW_OK);                    \
        check_pose_##P(&back);                                                                                       \
        CHECK(mw_convert_motor_to_matrix_each_##P(numbers, sizeof numbers, MW_MATRIX_COLUMNS_4X4, &pose,             \
                                                  sizeof pose, 1) == MW_OK);                                         \
        CHECK(near_##P(numbers[0], -1) && near_##P(numbers[12], 10) && numbers[15] == 1);                            \
        CHECK(mw_check_matrices_##P(numbers, sizeof numbers, MW_MATRIX_COLUMNS_4X4, 1, (T)0.001, &bad,               \
                                    &deviation) == MW_OK);                                                           \
        CHECK(bad == 7 && near_##P(deviation, 0));                                                                   \
        CHECK(mw_convert_matrix_to_motor_each_##P(&back, sizeof back, numbers, sizeof numbers,                       \
                                                  MW_MATRIX_COLUMNS_4X4, 1, MW_DEFAULT, &bad) == MW_OK);             \
        check_pose_##P(&back);                                                                                       \
        CHECK(mw_convert_motor_to_axis_angle_each_##P(four, sizeof four, three, sizeof three, &pose,                 \
                                                      sizeof pose, 1) == MW_OK);                                     \
        CHECK(near_##P(four[2] * four[2], 1) && near_##P(four[3], 2 * half_pi));                                     \
        CHECK(mw_convert_axis_angle_to_motor_each_##P(&back, sizeof back, four, sizeof four, three,                  \
                                                      sizeof three, 1) == MW_OK);                                    \
        check_pose_##P(&back);                                                                                       \
        CHECK(mw_convert_motor_to_euler_each_##P(angles, sizeof angles, three, sizeof three, &pose, sizeof pose,     \
                                                 1,                                                                  \
                                                 MW_EULER_XYZ) == MW_OK);                                            \
        CHECK(mw_convert_euler_to_motor_each_##P(&back, sizeof back, angles, sizeof angles, three, sizeof three,     \
                                                 1,                                                                  \
                                                 MW_EULER_XYZ) == MW_OK);                                            \
        check_pose_##P(&back);                                                                                       \
        CHECK(mw_convert_motor_to_translation_each_##P(three, sizeof three, &pose, sizeof pose, 1) == MW_OK);        \
        CHECK(near_##P(three[0], 10) && near_##P(three[1], 0));                                                      \
        CHECK(mw_convert_translation_to_motor_each_##P(&back, sizeof back, three, sizeof three, 1) == MW_OK);        \
        CHECK(near_##P(back.s, 1) && near_##P(back.b1i, 5));                                                         \
        CHECK(mw_convert_motor_to_screw_each_##P(eight, sizeof eight, &pose, sizeof pose, 1) == MW_OK);              \
        CHECK(near_##P(eight[3], 5) && near_##P(eight[6], 2 * half_pi) && near_##P(eight[7], 0));                    \
        CHECK(mw_convert_screw_to_motor_each_##P(&back, sizeof back, eight, sizeof eight, 1) == MW_OK);              \
        check_pose_##P(&back);                                                                                       \
        CHECK(mw_convert_motor_to_rotor_each_##P(&back, sizeof back, &pose, sizeof pose, 1, 2) == MW_OK);            \
        CHECK(near_##P(back.b12, -1) && near_##P(back.b2i, (T)2.5));                                                 \
        CHECK(mw_convert_rotor_to_motor_each_##P(&back, sizeof back, &back, sizeof back, 1, 2) == MW_OK);            \
        check_pose_##P(&back);                                                                                       \
    }                                                                                                                \
                                                                                                                     \
    static void test_twist_##P(void)                                                                                 \
    {                                                                                                                \
        const T bivector[6] = {(T)1.57079632679489661923, 0, 0, 0, 0, 1};                                            \
        mw_twist_##P twist;                                                                                          \
        mw_motor_##P pose;                                                                                           \
        T position[3];                                                                                               \
        CHECK(mw_split_bivector_##P(&twist, bivector) == MW_OK);                                                     \
        CHECK(near_##P(twist.axis[2], 1) && near_##P(twist.angle, 2 * bivector[0]));                                 \
        CHECK(near_##P(twist.along[2], 2) && near_##P(twist.across[0], 0));                                          \
        CHECK(mw_twist_pose_##P(&pose, &twist, (T)0.5) == MW_OK);                                                    \
        CHECK(near_##P(pose.s, pose.b12) && near_##P(pose.s * pose.s, (T)0.5));                                      \
        CHECK(mw_twist_position_##P(position, &twist, (T)0.5) == MW_OK);                                             \
        CHECK(near_##P(position[0], 0) && near_##P(position[2], 1));                                                 \
    }

DEFINE_CONVERSION_TEST(f32, float)
DEFINE_CONVERSION_TEST(f64, double)

/* Every operand in every pairing. Twice the identity leaves an element where it is,
        and so does whoever picks it. */
#define ELEMENT 8

#define VIEW_xyz(kind, P, numbers) mw_##kind##xyz_##P##_aos(numbers, 3 * sizeof *(numbers))
#define VIEW_xyzw(kind, P, numbers) mw_##kind##xyzw_##P##_aos(numbers, 4 * sizeof *(numbers))
#define VIEW_vertices(kind, P, numbers) kind##vertices_##P(numbers)
#define VIEW_vectors(kind, P, numbers) mw_##kind##vectors_##P##_aos(numbers, 5 * sizeof *(numbers))
#define VIEW_lines(kind, P, numbers) mw_##kind##lines_##P##_aos(numbers, 6 * sizeof *(numbers))
#define VIEW_motors(kind, P, numbers) kind##motors_##P(numbers)
#define VIEW_bivectors(kind, P, numbers) mw_##kind##bivectors_##P##_aos(numbers, 6 * sizeof *(numbers))

#define DEFINE_VIEWS(P, T)                                                                                           \
    static mw_vertices_##P vertices_##P(T *numbers)                                                                  \
    {                                                                                                                \
        mw_vertices_##P view;                                                                                        \
        view.position = mw_xyz_##P##_aos(numbers, 6 * sizeof *numbers);                                              \
        view.normal = mw_xyz_##P##_aos(numbers + 3, 6 * sizeof *numbers);                                            \
        return mw_vertices_##P##_from(view, 0);                                                                      \
    }                                                                                                                \
    static mw_const_vertices_##P const_vertices_##P(const T *numbers)                                                \
    {                                                                                                                \
        mw_const_vertices_##P view;                                                                                  \
        view.position = mw_const_xyz_##P##_aos(numbers, 6 * sizeof *numbers);                                        \
        view.normal = mw_const_xyz_##P##_aos(numbers + 3, 6 * sizeof *numbers);                                      \
        return mw_const_vertices_##P##_from(view, 0);                                                                \
    }                                                                                                                \
    static mw_motors_##P motors_##P(T *numbers)                                                                      \
    {                                                                                                                \
        return mw_motors_##P##_aos((mw_motor_##P *)(void *)numbers, sizeof(mw_motor_##P));                           \
    }                                                                                                                \
    static mw_const_motors_##P const_motors_##P(const T *numbers)                                                    \
    {                                                                                                                \
        return mw_const_motors_##P##_aos((const mw_motor_##P *)(const void *)numbers, sizeof(mw_motor_##P));         \
    }                                                                                                                \
    static void check_same_##P(T *out, const T *in, size_t components)                                               \
    {                                                                                                                \
        size_t k;                                                                                                    \
        for (k = 0; k < components; ++k) {                                                                           \
            CHECK(near_##P(out[k], in[k]));                                                                          \
            out[k] = -1;                                                                                             \
        }                                                                                                            \
    }

DEFINE_VIEWS(f32, float)
DEFINE_VIEWS(f64, double)

#define SCALAR_f32 float
#define SCALAR_f64 double

#define DEFINE_APPLY_TEST(operand, views, P)                                                                         \
    static void test_##operand##_##P(void)                                                                           \
    {                                                                                                                \
        const SCALAR_##P in[ELEMENT] = {1, 2, 3, 4, 5, 6, 7, 8};                                                     \
        SCALAR_##P out[ELEMENT] = {0};                                                                               \
        const mw_motor_##P identity = {2, 0, 0, 0, 0, 0, 0, 0};                                                      \
        const uint8_t index = 0;                                                                                     \
        const mw_indices indices = mw_indices_u8(&index, sizeof index);                                              \
        const mw_const_motors_##P motors = mw_const_motors_##P##_aos(&identity, sizeof identity);                    \
        const mw_##views##_##P to = VIEW_##views(, P, out);                                                          \
        const mw_const_##views##_##P from = VIEW_##views(const_, P, in);                                             \
        size_t bad = 7;                                                                                              \
        CHECK(mw_apply_##operand##_one_views_##P(&to, &identity, &from, 1, MW_DEFAULT) == MW_OK);                    \
        check_same_##P(out, in, COMPONENTS_##views);                                                                 \
        CHECK(mw_apply_##operand##_each_views_##P(&to, &motors, &from, 1, MW_DEFAULT) == MW_OK);                     \
        check_same_##P(out, in, COMPONENTS_##views);                                                                 \
        CHECK(mw_apply_##operand##_grid_views_##P(&to, sizeof out, &motors, 1, &from, 1, MW_DEFAULT) == MW_OK);      \
        check_same_##P(out, in, COMPONENTS_##views);                                                                 \
        CHECK(mw_apply_##operand##_indexed_views_##P(&to, &identity, 1, &indices, &from, 1,                          \
                                                     MW_STREAMING_STORES) == MW_OK);                                 \
        check_same_##P(out, in, COMPONENTS_##views);                                                                 \
        CHECK(mw_apply_##operand##_indexed_checked_views_##P(&to, &identity, 1, &indices, &from, 1,                  \
                                                             MW_NO_STREAMING_STORES,                                 \
                                                       &bad) == MW_OK);                                              \
        check_same_##P(out, in, COMPONENTS_##views);                                                                 \
        CHECK(mw_apply_##operand##_indexed_checked_views_##P(&to, &identity, 0, &indices, &from, 1, MW_DEFAULT,      \
                                                             &bad) ==                                                \
              MW_ERROR_INDEX);                                                                                       \
        CHECK(bad == 0);                                                                                             \
    }

#define COMPONENTS_xyz 3
#define COMPONENTS_xyzw 4
#define COMPONENTS_vertices 6
#define COMPONENTS_vectors 5
#define COMPONENTS_lines 6
#define COMPONENTS_motors 8
#define COMPONENTS_bivectors 6

MW_OPERANDS(DEFINE_APPLY_TEST, f32)
MW_OPERANDS(DEFINE_APPLY_TEST, f64)

static void test_mixed(void)
{
    const float in[3] = {1, 2, 3};
    float out[3] = {0, 0, 0};
    const mw_motor_f64 identity = {2, 0, 0, 0, 0, 0, 0, 0};
    const mw_shift shift = {{-1e6, 0, 0}, {1e6, 0, 0}}, back = {{1e6, 0, 0}, {1e6, 0, 0}};
    const uint32_t index = 0;
    const mw_indices indices = mw_indices_from(mw_indices_u32(&index, sizeof index), 0);
    const mw_const_motors_f64 motors = mw_const_motors_f64_aos(&identity, sizeof identity);
    const mw_xyz_f32 to = mw_xyz_f32_aos(out, sizeof out);
    const mw_const_xyz_f32 from = mw_const_xyz_f32_aos(in, sizeof in);
    size_t bad = 7;
    CHECK(mw_apply_point_one_views_mixed(&to, &identity, &shift, &from, 1, MW_DEFAULT) == MW_OK);
    CHECK(out[0] == 2000001.f && out[1] == 2.f && out[2] == 3.f);
    CHECK(mw_apply_point_one_views_mixed(&to, &identity, &back, &from, 1, MW_DEFAULT) == MW_OK);
    check_same_f32(out, in, 3);
    CHECK(mw_apply_point_each_views_mixed(&to, &motors, NULL, &from, 1, MW_DEFAULT) == MW_OK);
    check_same_f32(out, in, 3);
    CHECK(mw_apply_point_grid_views_mixed(&to, sizeof out, &motors, 1, &back, &from, 1, MW_DEFAULT) == MW_OK);
    check_same_f32(out, in, 3);
    CHECK(mw_apply_point_indexed_views_mixed(&to, &identity, 1, &indices, &back, &from, 1, MW_DEFAULT) == MW_OK);
    check_same_f32(out, in, 3);
    CHECK(mw_apply_point_indexed_checked_views_mixed(&to, &identity, 1, &indices, &back, &from, 1, MW_DEFAULT,
                                                     &bad) == MW_OK);
    check_same_f32(out, in, 3);
    CHECK(mw_check_indices_views(&indices, 1, 1, &bad) == MW_OK);
    CHECK(mw_check_indices(&index, 2, MW_INDEX_U16, 2, 0, &bad) == MW_ERROR_INDEX);
    CHECK(bad == 0);
}

#define RUN_APPLY_TEST(operand, views, P) test_##operand##_##P();

int main(void)
{
    CHECK(mw_isa() != NULL);
    CHECK(strstr(mw_isas(), "scalar") != NULL);
    CHECK(strlen(mw_status_text(MW_OK)) > 0);
    CHECK(mw_version() == MW_VERSION);
    CHECK(MW_VERSION_MAJOR >= 0 && MW_VERSION_MINOR >= 0 && MW_VERSION_PATCH >= 0);
    test_motors_f32();
    test_motors_f64();
    test_sums_f32();
    test_sums_f64();
    test_motion_f32();
    test_motion_f64();
    test_motion_tools_f32();
    test_motion_tools_f64();
    test_group_f32();
    test_group_f64();
    test_conversions_f32();
    test_conversions_f64();
    test_twist_f32();
    test_twist_f64();
    MW_OPERANDS(RUN_APPLY_TEST, f32)
    MW_OPERANDS(RUN_APPLY_TEST, f64)
    test_mixed();
    return failures;
}
