// The reference for motions, against the dense one and against what is known in closed form.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"
#include "screws.h"

namespace motorway::reference {
namespace {

using testing::Random;
using testing::random_displacement;

constexpr long double tiny = 1e-16L;  // long double has 64 bits or more: some hundred of their roundings

DualQuaternion exact(const Motor &motor)
{
    std::array<long double, 8> numbers;
    for (std::size_t k = 0; k < 8; ++k)
        numbers[k] = static_cast<long double>(motor[k]);
    return dual_quaternion(numbers);
}

Motor dense(const DualQuaternion &a)
{
    const auto numbers = motor_numbers(a);
    Motor motor;
    for (std::size_t k = 0; k < 8; ++k)
        motor[k] = Real(numbers[k]);
    return motor;
}

void expect_near(const DualQuaternion &a, const DualQuaternion &b, long double tolerance = tiny)
{
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LE(std::abs(a.real[k] - b.real[k]), tolerance);
        EXPECT_LE(std::abs(a.dual[k] - b.dual[k]), tolerance);
    }
}

DualQuaternion of_bivector(const Bivector &b)
{
    return exact({Real(0), b[0], b[1], b[2], b[3], b[4], b[5], Real(0)});
}

TEST(MotionReference, dual_quaternions_are_motors)
{
    Random random(71);
    for (int k = 0; k < 20; ++k) {
        DualQuaternion a = random_displacement(random, 3, 4), b = random_displacement(random, 3, 4);
        expect_near(compose(a, b), exact(compose(dense(a), dense(b))));
        expect_near(log(a), of_bivector(log(dense(a), Branch::principal)));
        expect_near(exp(log(a)), a);
        expect_near(slerp(a, b, 0.3L), exact(slerp(dense(a), dense(b), Real(0.3L))));
        const std::array<long double, 3> point = {1, -2, 0.5L}, image = apply_point(a, point);
        const Vector3 expected = apply_point(dense(a), {Real(point[0]), Real(point[1]), Real(point[2])});
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_LE(std::abs(image[c] - static_cast<long double>(expected[c])), tiny);
        a = 1.5L * compose(a, {{0, 0, 0, 1}, {0, 0, 0, 0.25L}});  // times a dual number
        expect_near(inverse(a), exact(inverse(dense(a))));
        expect_near(normalize(a), exact(normalize(dense(a))));
    }
}

// Where the logarithm changes from a series to a quotient, and near the identity.
TEST(MotionReference, logarithms_of_every_angle)
{
    Random random(72);
    for (double half_angle : {0.0, 1e-30, 1e-9, 0.01, 0.199, 0.2, 0.202, 0.4, 1.5, 2.9}) {
        const Bivector b = testing::bivector_of({testing::random_unit_vector(random), {}, half_angle, 0.75L});
        expect_near(log(exp(of_bivector(b))), of_bivector(b));
        expect_near(exp(of_bivector(b)), exact(exp(b)));
    }
}

TEST(MotionReference, an_additive_motion_is_the_b_spline)
{
    Random random(73);
    for (std::size_t degree : {1, 2, 3, 5})
        for (int repetition = 0; repetition < 4; ++repetition) {
            auto data = testing::random_motion<double>(random, MW_MOTION_ADDITIVE, degree, degree + 4);
            testing::draw_knots(random, data, testing::Ends::free, degree + 1);
            const Motion motion = data.exact(0, MW_KEEP_SIGNS);
            std::vector<Motor> controls;
            for (const auto &control : data.controls)
                controls.push_back(testing::exact_motor(&control.s));
            const std::vector<Real> knots(data.knots.begin(), data.knots.end());
            for (double t : testing::parameters_of<double>(random, motion, 3))
                expect_near(motion.at(t), exact(sample_bspline(controls, knots, degree, Real(t))), 100 * tiny);
        }
}

// A linear motion of two poses is a screw in all kinds but the additive: the twist is the logarithm.
TEST(MotionReference, two_poses_make_a_screw)
{
    Random random(74);
    for (mw_motion_kind kind : testing::all_motion_kinds) {
        if (kind == MW_MOTION_ADDITIVE)
            continue;
        MotionDescription description;
        description.kind = kind;
        description.controls = {random_displacement(random, 1, 2), random_displacement(random, 1, 2)};
        description.base = description.controls[0];
        const Motion motion(description);
        const DualQuaternion screw = log(compose(inverse(description.controls[0]), description.controls[1]));
        for (long double t : {0.0L, 0.25L, 0.7L, 1.0L}) {
            expect_near(motion.at(t), compose(description.controls[0], exp(t * screw)));
            expect_near(motion.twist(t, motion.span_of(t)), screw, 10 * tiny);
            const DualQuaternion body = motion.twist(t, motion.span_of(t), Motion::Frame::body);
            expect_near(compose(motion.at(t), screw), compose(body, motion.at(t)), 10 * tiny);
        }
    }
}

// Exactly: the path of equation (5) between 1 and a quarter turn, 1 - t + t √½ (1 + e12), turns at half of
// √½ / ((1 - t + t √½)² + ½t²).
TEST(MotionReference, the_twist_of_a_linear_additive_motion)
{
    const long double root = std::sqrt(0.5L);
    MotionDescription description;
    description.controls = {DualQuaternion(), {{0, 0, root, root}, {0, 0, 0, 0}}};
    const Motion motion(description);
    for (long double t : {0.0L, 0.3L, 1.0L}) {
        const long double s = 1 - t + t * root;
        const DualQuaternion twist = motion.twist(t, motion.span_of(t));
        expect_near(twist, {{0, 0, root / (s * s + t * t / 2), 0}, {0, 0, 0, 0}}, 10 * tiny);
    }
}

// Wareham and Lasenby's section 3.2, and a closed motion through four keys, which is periodic and smooth.
TEST(MotionReference, keys)
{
    Random random(75);
    MotionDescription description;
    description.kind = MW_MOTION_GENERATOR_KEYS;
    for (int k = 0; k < 3; ++k)
        description.controls.push_back(random_displacement(random, 1.3, 3));
    description.knots = {-1, 0, 1};
    const Motion quadratic(description);
    const DualQuaternion b1 = log(description.controls[0]), b2 = log(description.controls[1]),
                         b3 = log(description.controls[2]);
    for (long double t : {-1.0L, -0.4L, 0.0L, 0.3L, 1.0L})
        expect_near(quadratic.at(t), exp(t * t * (0.5L * b3 + 0.5L * b1 + -1.0L * b2) +
                                         t / 2 * (b3 + -1.0L * b1) + b2));

    description.controls.push_back(random_displacement(random, 1.3, 3));
    description.knots = {0, 1, 3, 4, 6};
    description.closed = true;
    const Motion closed(description);
    const std::size_t start = closed.span_of(0), end = closed.span_of(6);
    expect_near(closed.at(6), closed.at(0));
    expect_near(closed.twist(6, end), closed.twist(0, start), 10 * tiny);
    for (std::size_t k = 0; k < 4; ++k)
        expect_near(closed.at(description.knots[k]), description.controls[k]);
}

TEST(MotionReference, closed_motions_come_back_as_smooth_as_elsewhere)
{
    Random random(76);
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_CUMULATIVE, MW_MOTION_GENERATOR}) {
        MotionDescription description;
        description.kind = kind;
        description.degree = 3;
        description.closed = true;
        for (int k = 0; k < 4; ++k)
            description.controls.push_back(random_displacement(random, 1, 2));
        description.knots = {1, 2, 4, 5, 6.5L};
        const Motion motion(description);
        EXPECT_EQ(motion.first(), 1);
        EXPECT_EQ(motion.last(), 6.5L);
        const std::size_t start = motion.span_of(1), end = motion.span_of(6.5L);
        expect_near(motion.at(6.5L, end), motion.at(1, start));
        expect_near(motion.twist(6.5L, end), motion.twist(1, start), 10 * tiny);
        const long double step = 0.001L;  // the change of the twist on both sides, to the third order of the step
        const DualQuaternion after = motion.twist(1 + step, start) + -1.0L * motion.twist(1 - step, start);
        const DualQuaternion before = motion.twist(6.5L + step, end) + -1.0L * motion.twist(6.5L - step, end);
        expect_near(before, after, 1e-6L);
    }
}

}  // namespace
}  // namespace motorway::reference
