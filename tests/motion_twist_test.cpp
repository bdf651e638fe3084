// Velocities: the twists of motions against the derivative of the reference, in both frames.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

using Frame = reference::Motion::Frame;

// What the twists of a motion must be at some parameters, in both frames, and how far off they may be.
template <class T>
struct Case {
    MotionData<T> data;
    std::vector<T> parameters;
    std::vector<std::array<long double, 6>> twists[2], tolerances[2];
};

long double largest(const std::array<long double, 6> &twist, std::size_t begin)
{
    return std::max({std::abs(twist[begin]), std::abs(twist[begin + 1]), std::abs(twist[begin + 2])});
}

// An error of a few epsilons for each level, of what the twist is in the span at most, and of a radian in four spans,
// for poses that hardly differ are rounded too; of its second half also of the speed that this rotation gives to what
// is as far away as the controls. The reference is as exact as differences of long double are, about 2^-49 of what
// moves fast where that has 64 bits.
template <class T>
Case<T> make_case(const MotionData<T> &data, const std::vector<T> &parameters)
{
    Case<T> result{data, parameters, {}, {}};
    const reference::Motion exact = data.exact();
    const long double levels = is_of_keys(data.kind) ? 3 + swing_of(exact) : static_cast<long double>(data.degree);
    const long double unit = 8 * (1 + levels) * epsilon<T>, reach = reach_of(data);
    for (Frame frame : {Frame::space, Frame::body})
        for (T t : parameters) {
            const std::size_t span = exact.span_of(t);
            const long double begin = exact.span_begin(span), end = exact.span_end(span);
            const auto expected = bivector_numbers(exact.twist(t, span, frame));
            long double turn = 0.25L / (end - begin), slide = 0;
            for (long double at : {begin, static_cast<long double>(t), end}) {
                const auto twist = bivector_numbers(exact.twist(at, span, frame));
                turn = std::max(turn, largest(twist, 0));
                slide = std::max(slide, largest(twist, 3));
            }
            const int number = frame == Frame::body;
            const long double rotation = unit * turn, translation = unit * (slide + reach * turn);
            result.twists[number].push_back(expected);
            result.tolerances[number].push_back(
                {rotation, rotation, rotation, translation, translation, translation});
        }
    return result;
}

template <class T>
class MotionTwistTest : public ::testing::Test {
protected:
    static void expect(const Case<T> &all)
    {
        const CompiledMotion<T> motion(all.data);
        for (int body : {0, 1}) {
            const Twists<T> out = twisted(motion, all.parameters, body ? MW_BODY_FRAME : MW_DEFAULT);
            for (std::size_t i = 0; i < all.parameters.size(); ++i)
                for (std::size_t c = 0; c < 6; ++c)
                    ASSERT_LE(std::abs(out.twists[6 * i + c] - all.twists[body][i][c]), all.tolerances[body][i][c])
                        << all.data.name() << ", parameter " << all.parameters[i] << ", component " << c
                        << (body ? ", of the body" : "");
        }
    }
};

TYPED_TEST_SUITE(MotionTwistTest, Precisions, PrecisionName);

TYPED_TEST(MotionTwistTest, is_the_derivative_of_every_kind)
{
    using T = TypeParam;
    Random random(111);
    std::vector<Case<T>> cases;
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t degree : {1, 2, 3, 5})
            for (int repetition = 0; repetition < 6; ++repetition) {
                const std::size_t controls = degree + 1 + random.below(5);
                auto data = random_motion<T>(random, kind, degree, controls, repetition % 3 == 2);
                for (std::size_t k = 0; is_additive(kind) && repetition == 0 && k < controls; ++k)
                    data.weights.push_back(static_cast<T>(random.uniform(0.5, 2)));
                if (repetition % 2)
                    draw_knots(random, data, Ends::clamped, degree);
                cases.push_back(make_case(data, parameters_of<T>(random, data.exact(), 3)));
            }
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        for (const Case<T> &each : cases)
            this->expect(each);
    }
}

// The poses that come with twists are those that come alone: what a frame of a film is must not depend on whether its
// blur is wanted.
TYPED_TEST(MotionTwistTest, poses_are_those_of_samples)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(112);
        for (mw_motion_kind kind : all_motion_kinds) {
            const auto data = random_motion<T>(random, kind, 3, 8);
            const CompiledMotion<T> motion(data);
            const auto parameters = parameters_of<T>(random, data.exact(), 30);
            const std::vector<T> poses = sampled(motion, parameters);
            for (unsigned flags : {MW_DEFAULT, MW_BODY_FRAME})
                EXPECT_TRUE(same_bits(twisted(motion, parameters, flags).poses, poses))
                    << isa << ": " << name_of(kind);
        }
    }
}

// A screw has one twist all the way, its logarithm over the time that it takes.
TYPED_TEST(MotionTwistTest, of_a_screw_is_constant)
{
    using T = TypeParam;
    Random random(113);
    for (mw_motion_kind kind : {MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE, MW_MOTION_GENERATOR,
                                MW_MOTION_GENERATOR_KEYS})
        for (int repetition = 0; repetition < 10; ++repetition) {
            auto data = random_motion<T>(random, kind, 1, 2);
            data.base = {data.controls[0]};
            if (!is_of_keys(kind) && kind != MW_MOTION_GENERATOR)
                data.base.clear();
            data.knots = {3, 5};
            const auto first = exact_pose(&data.controls[0].s), second = exact_pose(&data.controls[1].s);
            const auto screw = log(compose(inverse(normalize(first)), normalize(second)));
            const auto expected = bivector_numbers(0.5L * screw);
            const Twists<T> out = twisted(CompiledMotion<T>(data), {3, T(3.25), T(4.5), 5});
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t c = 0; c < 6; ++c)
                    EXPECT_LE(std::abs(out.twists[6 * i + c] - expected[c]), 32 * reach_of(data) * epsilon<T>)
                        << name_of(kind) << ", " << c;
        }
}

// What turns by an angle of next to nothing, by just less than a half turn, and not at all.
TYPED_TEST(MotionTwistTest, of_every_angle)
{
    using T = TypeParam;
    Random random(114);
    for (mw_motion_kind kind : all_motion_kinds)
        for (double turn : {0.0, 1e-30, 1e-6, 0.01, 3.0}) {
            MotionData<T> data;
            data.kind = kind;
            data.degree = 1;
            data.controls = {{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0}};
            const reference::DualQuaternion half{{0, 0, turn / 2, 0}, {0.5L, -1, 2, 0}};
            data.controls[1] = rounded_pose<T>(exp(half));
            this->expect(make_case(data, std::vector<T>{0, T(0.25), T(0.5), 1}));
        }
}

// What is at `place` moves as the twist says: by differences of where the poses take a point of the body.
TYPED_TEST(MotionTwistTest, velocities_of_points)
{
    using T = TypeParam;
    Random random(115);
    for (mw_motion_kind kind : all_motion_kinds) {
        const auto data = random_motion<T>(random, kind, 3, 6);
        const reference::Motion exact = data.exact();
        const std::array<long double, 3> point = {0.5L, -2, 1};
        const long double t = (exact.first() + exact.last()) / 3, step = 0x1p-12L;
        const auto at = exact.span_of(t);
        const auto place = apply_point(exact.at(t, at), point), after = apply_point(exact.at(t + step, at), point),
                   before = apply_point(exact.at(t - step, at), point);
        const Twists<T> out = twisted(CompiledMotion<T>(data), {static_cast<T>(t)});
        const T where[3] = {static_cast<T>(place[0]), static_cast<T>(place[1]), static_cast<T>(place[2])};
        T velocity[3] = {};
        EXPECT_EQ(api<T>::twist_velocity(velocity, out.twists.data(), where), MW_OK);
        for (std::size_t k = 0; k < 3; ++k)  // to the square of the step, times a third derivative
            EXPECT_LE(std::abs(velocity[k] - (after[k] - before[k]) / (2 * step)), 1e-5) << name_of(kind);
    }
}

// ω × place + v, from halves: integers are exact.
TYPED_TEST(MotionTwistTest, velocity_by_numbers)
{
    using T = TypeParam;
    const T twist[6] = {3, -2, 1, 10, 20, 30}, place[3] = {5, 7, 11};  // ω = 2 (1, 2, 3)
    T velocity[3];
    ASSERT_EQ(api<T>::twist_velocity(velocity, twist, place), MW_OK);
    EXPECT_EQ(velocity[0], T(2 * (2 * 11 - 3 * 7 + 10)));
    EXPECT_EQ(velocity[1], T(2 * (3 * 5 - 1 * 11 + 20)));
    EXPECT_EQ(velocity[2], T(2 * (1 * 7 - 2 * 5 + 30)));
}

// The twist of the body is that of the space, moved into its frame by the pose: S Ω S^-1 = S' S^-1.
TYPED_TEST(MotionTwistTest, of_the_body_is_that_of_the_space_moved)
{
    using T = TypeParam;
    Random random(116);
    for (mw_motion_kind kind : all_motion_kinds) {
        const auto data = random_motion<T>(random, kind, 3, 6);
        const CompiledMotion<T> motion(data);
        const auto parameters = parameters_of<T>(random, data.exact(), 5);
        const Twists<T> space = twisted(motion, parameters), body = twisted(motion, parameters, MW_BODY_FRAME);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const auto pose = exact_pose(&space.poses[8 * i]);
            std::array<long double, 8> omega{};
            std::copy_n(&space.twists[6 * i], 6, omega.begin() + 1);
            const auto after = compose(pose, reference::dual_quaternion(omega));
            const auto moved = bivector_numbers(compose(after, inverse(pose)));
            const long double reach = reach_of(data);
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_LE(std::abs(body.twists[6 * i + c] - moved[c]), 64 * (c < 3 ? 1 : reach * reach) * epsilon<T>)
                    << name_of(kind);
        }
    }
}

}  // namespace
}  // namespace motorway::testing
