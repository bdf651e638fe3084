// Continuity across knots, measured: poses, velocities and accelerations of both sides, the latter by differences of
// velocities that the library returns. Of degree d across a knot repeated r times, B-splines and whatever is a smooth
// function of them have d - r derivatives. The multiplicative tableau promises one at most: each screw starts in the
// direction in which the one before it ends, but accelerates from there in another, if only by a little.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

// Jumps at a parameter inside the domain, or from the end of a closed motion to its start.
struct Jumps {
    double pose, velocity, acceleration;
};

class MotionSmoothnessTest : public ::testing::Test {
protected:
    // A step so small that the cubic through four velocities gives their slope to 1e-9 or so.
    static constexpr double step = 0x1p-10;

    // Motions that accelerate a lot: controls that are far apart, with turns of every axis.
    static MotionData<double> motion_of(Random &random, mw_motion_kind kind, std::size_t degree, std::size_t controls,
                                        bool closed = false)
    {
        auto data = random_motion<double>(random, kind, degree, controls, closed);
        if (is_additive(kind))
            for (auto &control : data.controls)
                control = rounded_pose<double>(normalize(exact_pose(&control.s)));
        return data;
    }

    static Jumps jumps(const CompiledMotion<double> &motion, double left, double right)
    {
        const double before = left == right ? std::nextafter(left, -1e9) : left;
        const Twists<double> a = twisted(motion, {before, left - step, left - 2 * step, left - 3 * step});
        const Twists<double> b = twisted(motion, {right, right + step, right + 2 * step, right + 3 * step});
        const auto first = normalize(exact_pose(&a.poses[0])), second = normalize(exact_pose(&b.poses[0]));
        Jumps jumps{static_cast<double>(motor_error<double>(first, second) * epsilon<double>), 0, 0};
        for (std::size_t c = 0; c < 6; ++c) {
            jumps.velocity = std::max(jumps.velocity, std::abs(a.twists[c] - b.twists[c]));
            jumps.acceleration = std::max(jumps.acceleration, std::abs(slope(&a.twists[c]) + slope(&b.twists[c])));
        }
        return jumps;
    }

    // Away from the first of four velocities.
    static double slope(const double *v)
    {
        return (-11 * v[0] + 18 * v[6] - 9 * v[12] + 2 * v[18]) / (6 * step);
    }

    // The poses and this many derivatives do not jump. The next does, unless it is that which the multiplicative
    // tableau does not promise.
    static void expect_derivatives(const Jumps &jumps, int derivatives, const MotionData<double> &data)
    {
        const bool promises_no_more = data.kind == MW_MOTION_MULTIPLICATIVE && derivatives > 0;
        derivatives = promises_no_more ? 1 : derivatives;
        const double at[] = {jumps.pose, jumps.velocity, jumps.acceleration};
        // To rounding, of lengths up to about 20, speeds up to 50, and of differences of speeds.
        const double none[] = {1e-13, 1e-12, 1e-4}, some[] = {1e-3, 1e-3, 1e-2};
        for (int k = 0; k < 3; ++k) {
            if (k <= derivatives) {
                EXPECT_LT(at[k], none[k]) << data.name() << ", derivative " << k;
            } else if (k == derivatives + 1 && !promises_no_more) {
                EXPECT_GT(at[k], some[k]) << data.name() << ", derivative " << k;
            }
        }
    }
};

// Knots inside repeated 1 to d times, and d + 1 times if the motion is additive: then it jumps.
TEST_F(MotionSmoothnessTest, knots_repeated_lower_it)
{
    Random random(121);
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                MW_MOTION_GENERATOR})
        for (std::size_t degree : {1, 2, 3})
            for (std::size_t repeated = 1; repeated <= degree + 1; ++repeated) {
                auto data = motion_of(random, kind, degree, degree + 5 + repeated);
                const std::size_t count = data.control_count() + degree - 1;
                data.knots.clear();
                for (int k = 0; data.knots.size() < count; ++k)
                    data.knots.insert(data.knots.end(), k == 4 ? repeated : 1, k);
                const double knot = 4;
                const CompiledMotion<double> motion(data);
                ASSERT_TRUE(motion.first() < knot - 4 * step && knot + 4 * step < motion.last()) << data.name();
                SCOPED_TRACE(std::to_string(repeated) + " times");
                expect_derivatives(jumps(motion, knot, knot), static_cast<int>(degree) - static_cast<int>(repeated),
                                   data);
            }
}

// Quadratics are once differentiable in every scheme, cubics twice but for the multiplicative, at every knot inside,
// whatever the distances of knots. Those that are not promised do exist.
TEST_F(MotionSmoothnessTest, simple_knots_of_any_distances)
{
    Random random(122);
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                MW_MOTION_GENERATOR})
        for (std::size_t degree : {2, 3, 5}) {
            auto data = motion_of(random, kind, degree, degree + 5);
            data.knots.clear();
            double knot = 0, largest = 0;
            for (std::size_t k = 0; k < data.control_count() + degree - 1; ++k)
                data.knots.push_back(knot += 0.5 + 0.25 * double(random.below(5)));
            const CompiledMotion<double> motion(data);
            for (double inside : data.knots)
                if (motion.first() < inside && inside < motion.last()) {
                    const Jumps here = jumps(motion, inside, inside);
                    expect_derivatives(here, static_cast<int>(degree) - 1, data);
                    largest = std::max(largest, here.acceleration);
                }
            if (degree == 3) {
                EXPECT_EQ(largest > 1e-3, kind == MW_MOTION_MULTIPLICATIVE) << data.name() << ": " << largest;
            }
        }
}

// Catmull and Rom's spline turns smoothly into every key, and accelerates at once.
TEST_F(MotionSmoothnessTest, keys_have_velocities_that_do_not_jump)
{
    Random random(123);
    for (bool closed : {false, true}) {
        auto data = motion_of(random, MW_MOTION_GENERATOR_KEYS, 3, 6, closed);
        data.knots = {0, 1, 1.5, 3, 4, 6};
        if (closed)
            data.knots.push_back(7);
        const CompiledMotion<double> motion(data);
        for (std::size_t k = 1; k < 5; ++k)
            expect_derivatives(jumps(motion, data.knots[k], data.knots[k]), 1, data);
        if (closed)
            expect_derivatives(jumps(motion, motion.last(), motion.first()), 1, data);
    }
}

// Through three keys it is one parabola, and so it is between the keys at either end.
TEST_F(MotionSmoothnessTest, three_keys_have_no_corner)
{
    Random random(124);
    auto data = motion_of(random, MW_MOTION_GENERATOR_KEYS, 3, 3);
    data.knots = {0, 1, 3};
    const CompiledMotion<double> motion(data);
    expect_derivatives(jumps(motion, 1, 1), 2, data);
}

// Where a closed motion comes back to its start, it is as smooth as at other knots.
TEST_F(MotionSmoothnessTest, closed_motions)
{
    Random random(125);
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                MW_MOTION_GENERATOR})
        for (std::size_t degree : {1, 2, 3})
            for (bool knots : {false, true}) {
                auto data = motion_of(random, kind, degree, 7, true);
                if (knots)
                    draw_knots(random, data, Ends::free, 1);
                const CompiledMotion<double> motion(data);
                expect_derivatives(jumps(motion, motion.last(), motion.first()), static_cast<int>(degree) - 1, data);
            }
}

// In float too, poses and velocities do not jump at knots.
TEST_F(MotionSmoothnessTest, floats)
{
    Random random(126);
    for (mw_motion_kind kind : all_motion_kinds) {
        const auto data = random_motion<float>(random, kind, 3, 7);
        const CompiledMotion<float> motion(data);
        for (float knot = 1; knot < motion.last(); ++knot) {
            const Twists<float> out = twisted(motion, {std::nextafter(knot, 0.f), knot});
            const float reach = static_cast<float>(reach_of(data));
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_NEAR(out.twists[c], out.twists[6 + c], 1e-5f * (c < 3 ? 1 : reach)) << data.name();
            EXPECT_LE(pose_error(&out.poses[0], exact_pose(&out.poses[8]), reach), 16) << data.name();
        }
    }
}

}  // namespace
}  // namespace motorway::testing
