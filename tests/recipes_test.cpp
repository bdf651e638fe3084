// What takes several calls, as docs/conventions.md and docs/motions.md say: poses relative to each other in either
// coordinates, and the crossfade of engines.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "conventions_poses.h"
#include "motorway_views.h"
#include "random.h"

namespace motorway::testing::conventions {
namespace {

void for_many_pairs(std::uint64_t seed, const std::function<void(const Pose &, const Pose &, double)> &test)
{
    Random random(seed);
    for (int repetition = 0; repetition < 200 && !::testing::Test::HasFailure(); ++repetition) {
        const Pose first = draw_pose(random), second = draw_pose(random);
        test(first, second, random.uniform(0, 1));
    }
}

// ------------------------------------------------------------------------------------------------ relative poses

Matrix inverse(const Pose &pose)
{
    const Quaternion back = conjugate(pose.rotation);
    return matrix_of(Pose{back, -1 * rotated(back, pose.translation)});
}

void expect_near(const Matrix &a, const Matrix &b)
{
    for (std::size_t row = 0; row < 4; ++row)
        conventions::expect_near(a[row], b[row]);
}

TEST(RecipesTest, a_ratio_is_T1_times_the_inverse_of_T0_in_matrices)
{
    for_many_pairs(1, [](const Pose &first, const Pose &second, double) {
        Motor ratio{};
        const Motor from = motor_of(first), to = motor_of(second);
        ASSERT_EQ(mw_ratio_motor_each_f64(&ratio, sizeof ratio, &from, sizeof from, &to, sizeof to, 1, MW_DEFAULT), MW_OK);
        expect_near(matrix_of(pose_of(ratio)), matrix_of(second) * inverse(first));
    });
}

TEST(RecipesTest, the_pose_seen_from_another_is_the_inverse_of_T0_times_T1_in_matrices)
{
    for_many_pairs(2, [](const Pose &first, const Pose &second, double) {
        Motor seen{};
        const Motor from = motor_of(first), to = motor_of(second);
        ASSERT_EQ(mw_inverse_motor_each_f64(&seen, sizeof seen, &from, sizeof from, 1), MW_OK);
        ASSERT_EQ(mw_compose_motor_each_f64(&seen, sizeof seen, &to, sizeof to, &seen, sizeof seen, 1), MW_OK);
        expect_near(matrix_of(pose_of(seen)), inverse(first) * matrix_of(second));
    });
}

// ----------------------------------------------------------------------------------------------------- crossfades

double dot(const Quaternion &a, const Quaternion &b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
double length(const Vector &v) { return std::sqrt(conventions::dot(v, v)); }

// What an engine does with two poses, in plain arithmetic: (1-t) of the one and t of the other, apart.
Pose crossfade(const Pose &first, const Pose &second, double t)
{
    const double sign = dot(first.rotation, second.rotation) < 0 ? -1 : 1;
    const Quaternion sum = (1 - t) * first.rotation + sign * t * second.rotation;
    return {1 / std::sqrt(dot(sum, sum)) * sum, (1 - t) * first.translation + t * second.translation};
}

// The first recipe: out of motors, the arithmetic of the engine but for the square root, and back.
Motor crossfade_by_poses(const Motor &first, const Motor &second, double t)
{
    const Pose a = pose_of(first), b = pose_of(second);
    const double sign = dot(a.rotation, b.rotation) < 0 ? -1 : 1;
    return motor_of(Pose{(1 - t) * a.rotation + sign * t * b.rotation, (1 - t) * a.translation + t * b.translation});
}

// The second one: motors all the way. A motor without its last four numbers is the rotation about the origin.
Motor crossfade_by_motors(const Motor &first, const Motor &second, double t)
{
    const Motor turn_a{first.s, first.b12, first.b13, first.b23, 0, 0, 0, 0};
    const Motor turn_b{second.s, second.b12, second.b13, second.b23, 0, 0, 0, 0};
    const Vector shift = (1 - t) * pose_of(first).translation + t * pose_of(second).translation;
    Motor turn{}, move{};
    EXPECT_EQ(mw_nlerp_motor_one_f64(&turn, sizeof turn, &turn_a, &turn_b, &t, 0, 1, MW_DEFAULT), MW_OK);
    EXPECT_EQ(mw_translation_f64(&move, shift.data()), MW_OK);
    return composed(turn, move);
}

Motor nlerp(const Motor &first, const Motor &second, double t)
{
    Motor motor{};
    EXPECT_EQ(mw_nlerp_motor_one_f64(&motor, sizeof motor, &first, &second, &t, 0, 1, MW_DEFAULT), MW_OK);
    return motor;
}

// To a few epsilons: of rotations, and of translations beside the longer of the two that were given.
void expect_within_epsilons(const Pose &actual, const Pose &expected, double size)
{
    const double epsilon = std::numeric_limits<double>::epsilon();
    const double sign = dot(actual.rotation, expected.rotation) < 0 ? -1 : 1;
    const Quaternion apart = actual.rotation + -sign * expected.rotation;
    EXPECT_LE(std::sqrt(dot(apart, apart)), 8 * epsilon);
    EXPECT_LE(length(actual.translation + -1 * expected.translation), 8 * epsilon * size);
}

TEST(RecipesTest, both_crossfades_are_that_of_an_engine_to_a_few_epsilons)
{
    for_many_pairs(3, [](const Pose &first, const Pose &second, double t) {
        const Pose expected = crossfade(first, second, t);
        const Motor a = motor_of(first), b = motor_of(second);
        const double size = std::max(length(first.translation), length(second.translation));
        expect_within_epsilons(pose_of(crossfade_by_poses(a, b, t)), expected, size);
        expect_within_epsilons(pose_of(crossfade_by_motors(a, b, t)), expected, size);
    });
}

// nlerp turns alike. Halfway it is off the straight line by the sagitta of the arc about the axis of the screw.
TEST(RecipesTest, nlerp_leaves_the_crossfade_by_half_the_chord_times_the_tangent_of_a_quarter_of_the_angle)
{
    for_many_pairs(4, [](const Pose &first, const Pose &second, double) {
        const Pose engine = crossfade(first, second, 0.5);
        const Pose ours = pose_of(nlerp(motor_of(first), motor_of(second), 0.5));
        expect_near(matrix_of(Pose{ours.rotation, {}}), matrix_of(Pose{engine.rotation, {}}));

        Quaternion between = second.rotation * conjugate(first.rotation);
        between = (between.w < 0 ? -1.0 : 1.0) * between;
        const Vector turn{between.x, between.y, between.z}, axis = 1 / length(turn) * turn;
        const double angle = 2 * std::atan2(length(turn), between.w);
        const Vector way = second.translation + -1 * first.translation;
        const double chord = length(way + -conventions::dot(way, axis) * axis);
        EXPECT_NEAR(length(ours.translation + -1 * engine.translation), chord / 2 * std::tan(angle / 4), tolerance);
    });
}

// The pair of docs/motions.md: a quarter turn about z, while the origin goes by (2, 0, 0).
TEST(RecipesTest, the_crossfade_of_the_documentation)
{
    const Pose first{{0, 0, 0, 1}, {0, 0, 0}}, second{about_axis({0, 0, 1}, pi / 2), {2, 0, 0}};
    const Pose ours = pose_of(nlerp(motor_of(first), motor_of(second), 0.5));
    EXPECT_NEAR(ours.translation[0], 1, tolerance);
    EXPECT_NEAR(ours.translation[1], -(std::sqrt(2.0) - 1), tolerance);
    conventions::expect_near(crossfade(first, second, 0.5).translation, {1, 0, 0});
}

}  // namespace
}  // namespace motorway::testing::conventions
