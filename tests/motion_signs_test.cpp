// S and -S are the same pose: motions that go the shortest way whatever the signs of their controls, motions that
// keep them, and blends that vanish.

#include <cmath>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

constexpr double pi = 3.14159265358979323846;

template <class T>
class MotionSignsTest : public ::testing::Test {
protected:
    using Pose = typename api<T>::motor;

    static void negate(Pose &pose)
    {
        for (std::size_t c = 0; c < 8; ++c)
            (&pose.s)[c] = -(&pose.s)[c];
    }

    // A rotation about e3 and then a step along e1, by half the angle.
    static Pose turned(double half, double step = 0)
    {
        const double c = std::cos(half), s = std::sin(half);
        return {static_cast<T>(c), static_cast<T>(s), 0, 0, static_cast<T>(c * step / 2),
                static_cast<T>(-s * step / 2), 0, 0};
    }

    // A Bézier motion through these half angles about e3.
    static MotionData<T> turns(std::initializer_list<double> halves, mw_motion_kind kind = MW_MOTION_ADDITIVE)
    {
        MotionData<T> data;
        data.kind = kind;
        data.degree = halves.size() - 1;
        for (double half : halves)
            data.controls.push_back(turned(half));
        return data;
    }

    static void expect_vanishing(const MotionData<T> &data, unsigned flags, std::size_t where)
    {
        const auto motion = data.view();
        std::vector<std::uint64_t> memory(2000, 7);
        const auto before = memory;
        const typename api<T>::compiled_motion *compiled = nullptr;
        std::size_t got = 1234;
        EXPECT_EQ(api<T>::compile_motion(&compiled, memory.data(), 8 * memory.size(), &motion, flags, &got),
                  MW_ERROR_VANISHING)
            << data.name();
        EXPECT_EQ(got, where) << data.name();
        EXPECT_EQ(compiled, nullptr);
        EXPECT_TRUE(memory == before);
    }

    // Of a rotation about e3, between -π and π.
    static double half_angle(const std::vector<T> &pose)
    {
        return std::atan2(static_cast<double>(pose[1]), static_cast<double>(pose[0]));
    }
};

TYPED_TEST_SUITE(MotionSignsTest, Precisions, PrecisionName);

// The same bits but for the sign of all, which is that of the first control; generators begin at their base.
TYPED_TEST(MotionSignsTest, flipped_signs_give_the_same_motion)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(101);
        for (mw_motion_kind kind : all_motion_kinds)
            for (bool closed : {false, true})
                for (int repetition = 0; repetition < 4; ++repetition) {
                    auto data = random_motion<T>(random, kind, 3, 8, closed);
                    if (is_additive(kind) && repetition % 2)
                        data.weights = {1, 2, 3, 1, T(0.5), 1, 1, 4};
                    const auto parameters = parameters_of<T>(random, data.exact(), 10);
                    const std::vector<T> plain = sampled(CompiledMotion<T>(data), parameters);
                    const Twists<T> moving = twisted(CompiledMotion<T>(data), parameters);
                    for (auto &control : data.controls)
                        if (random.chance(2))
                            this->negate(control);
                    const CompiledMotion<T> motion(data);
                    std::vector<T> flipped = sampled(motion, parameters);
                    if (dot_of_rotations(exact_pose(&plain[0]), exact_pose(&flipped[0])) < 0)
                        for (T &number : flipped)
                            number = -number;
                    for (std::size_t i = 0; i < plain.size(); ++i)
                        ASSERT_EQ(flipped[i], plain[i]) << isa << ": " << data.name();
                    const Twists<T> flipped_moving = twisted(motion, parameters);
                    for (std::size_t i = 0; i < moving.twists.size(); ++i)
                        ASSERT_EQ(flipped_moving.twists[i], moving.twists[i]) << isa << ": " << data.name();
                }
    }
}

// Half turns apart there are two shortest ways. Whichever it is, the motion is sound and meets its poses.
TYPED_TEST(MotionSignsTest, half_turns)
{
    using T = TypeParam;
    for (mw_motion_kind kind : all_motion_kinds)
        for (int sign : {1, -1}) {
            auto data = this->turns({0, sign * pi / 2}, kind);
            const std::vector<T> out = sampled(CompiledMotion<T>(data), {0, T(0.5), 1});
            EXPECT_LE(pose_error(&out[0], exact_pose(&data.controls[0].s)), 4) << name_of(kind);
            EXPECT_LE(pose_error(&out[16], exact_pose(&data.controls[1].s)), 4) << name_of(kind);
            // Half way it is a quarter turn to one side or the other.
            const std::vector<T> middle(out.begin() + 8, out.begin() + 16);
            EXPECT_NEAR(std::abs(std::remainder(this->half_angle(middle), pi)), pi / 4, 16 * epsilon<T>);
        }
}

// A full turn is no turn: S and -S are the same pose. A motion between them rests.
TYPED_TEST(MotionSignsTest, full_turns)
{
    using T = TypeParam;
    for (mw_motion_kind kind : all_motion_kinds) {
        MotionData<T> data;
        data.kind = kind;
        data.degree = 2;
        for (double turn : {0.0, 1.0, 2.0})
            data.controls.push_back(this->turned(0.3 + turn * pi, 2));
        const CompiledMotion<T> motion(data);
        const Twists<T> moving = twisted(motion, {motion.first(), T(0.3), motion.last()});
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LE(pose_error(&moving.poses[8 * i], exact_pose(&data.controls[0].s), 2), 8) << name_of(kind);
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_LE(std::abs(moving.twists[6 * i + c]), 32 * epsilon<T>) << name_of(kind);
        }
    }
}

// Two thirds of a turn: the shortest way is back by a third; with the signs kept it is on by two thirds.
TYPED_TEST(MotionSignsTest, kept_signs_take_the_long_way)
{
    using T = TypeParam;
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_CUMULATIVE, MW_MOTION_GENERATOR,
                                MW_MOTION_GENERATOR_KEYS}) {
        const auto data = this->turns({0, 2 * pi / 3}, kind);
        const CompiledMotion<T> shortest(data), kept(data, MW_KEEP_SIGNS);
        const double back = this->half_angle(sampled(shortest, {T(0.5)}));
        const double on = this->half_angle(sampled(kept, {T(0.5)}));
        EXPECT_NEAR(std::remainder(back, pi), -pi / 6, 16 * epsilon<T>) << name_of(kind);
        EXPECT_NEAR(on, pi / 3, 16 * epsilon<T>) << name_of(kind);
        const std::vector<T> end = sampled(kept, {T(1)});
        EXPECT_LE(pose_error(end.data(), exact_pose(&data.controls[1].s)), 4) << name_of(kind);
    }
}

// Controls that turn on and on, each by less than a half turn, make more than a full turn of generators.
TYPED_TEST(MotionSignsTest, shortest_ways_add_up)
{
    using T = TypeParam;
    for (mw_motion_kind kind : all_motion_kinds) {
        auto data = this->turns({0, 0.9, 1.8, 2.7}, kind);
        data.degree = 1;
        const CompiledMotion<T> motion(data);
        for (int k = 0; k <= 6; ++k) {
            const std::vector<T> pose = sampled(motion, {static_cast<T>(k) / 2});
            EXPECT_NEAR(std::remainder(this->half_angle(pose) - 0.45 * k, pi), 0, 32 * epsilon<T>)
                << name_of(kind) << ", " << k;
        }
    }
}

// ---------------------------------------------------------------------------------------------------- vanishing sums

TYPED_TEST(MotionSignsTest, opposite_controls_vanish_half_way)
{
    using T = TypeParam;
    Random random(102);
    for (int repetition = 0; repetition < 20; ++repetition) {
        auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 1, 2);
        data.controls[1] = data.controls[0];
        this->negate(data.controls[1]);
        this->expect_vanishing(data, MW_KEEP_SIGNS, 0);
        CompiledMotion<T> flipped(data);  // by default they are one pose
        data.weights = {1, 5};
        this->expect_vanishing(data, MW_KEEP_SIGNS, 0);
        // What is opposite is the rotation: the way vanishes whatever the translations are.
        data.weights.clear();
        data.controls[1].b1i += 3;
        this->expect_vanishing(data, MW_KEEP_SIGNS, 0);
    }
}

// Anywhere in a motion, of any degree, in any of many motions: the first of the controls of the span in which it
// passes through zero.
TYPED_TEST(MotionSignsTest, the_first_of_the_controls_that_cancel_is_named)
{
    using T = TypeParam;
    for (std::size_t degree : {1, 2, 3, 5})
        for (std::size_t at : {0, 2, 4}) {
            MotionData<T> data;
            data.degree = degree;
            data.controls.assign(degree + 6, this->turned(0.5, 1));
            for (std::size_t k = at + 1; k < data.controls.size(); ++k)
                this->negate(data.controls[k]);
            const reference::Motion exact = data.exact(0, MW_KEEP_SIGNS);
            std::size_t where = 0;
            for (std::size_t span : exact.spans())
                if (exact.at(exact.span_end(span), span).real[3] < 1e-6L) {
                    where = span + 1 - degree;
                    break;
                }
            this->expect_vanishing(data, MW_KEEP_SIGNS, where);
            MotionData<T> second = data;
            second.motion_count = 2;
            second.controls.assign(data.control_count(), this->turned(0.5, 1));
            second.controls.insert(second.controls.end(), data.controls.begin(), data.controls.end());
            this->expect_vanishing(second, MW_KEEP_SIGNS, data.control_count() + where);
        }
}

// Where a motion jumps no parameter lies between the two controls.
TYPED_TEST(MotionSignsTest, opposite_controls_on_both_sides_of_a_jump)
{
    auto data = this->turns({0, 0.5, 0.5 + pi, 1 + pi});
    data.degree = 1;
    data.knots = {0, 1, 1, 2};
    CompiledMotion<TypeParam> jumps(data, MW_KEEP_SIGNS);
    data.knots = {0, 1, 2, 3};
    this->expect_vanishing(data, MW_KEEP_SIGNS, 1);
}

// Neighbours at right angles, and the last opposite to the first: only the way back vanishes.
TYPED_TEST(MotionSignsTest, where_a_closed_motion_comes_back)
{
    auto data = this->turns({0, pi / 2, pi});
    data.degree = 1;
    CompiledMotion<TypeParam> open(data, MW_KEEP_SIGNS);
    data.closed = true;
    this->expect_vanishing(data, MW_KEEP_SIGNS, 2);
    CompiledMotion<TypeParam> shortest(data);
}

// Rotations whose motors are 120° apart, whose sum is 0: at t = ½ where weights make them count alike.
TYPED_TEST(MotionSignsTest, three_rotations_that_cancel)
{
    using T = TypeParam;
    auto data = this->turns({0, 2 * pi / 3, 4 * pi / 3});
    data.weights = {1, T(0.5), 1};
    this->expect_vanishing(data, MW_KEEP_SIGNS, 0);
    // By default the second comes with the other sign, 60° from the first, and the third 60° on.
    CompiledMotion<T> shortest(data);
    // Other weights pass by: the sum is never 0, for where its part across the first control is, they differ.
    data.weights.clear();
    CompiledMotion<T> plain(data, MW_KEEP_SIGNS);
    data.weights = {1, T(0.6), 1};
    CompiledMotion<T> near(data, MW_KEEP_SIGNS);
    const std::vector<T> out = sampled(near, {T(0.5)});
    EXPECT_NEAR(out[0], 0.25 + 0.5 * 0.6 * -0.5 + 0.25 * -0.5, 8 * epsilon<T>);
}

// Controls whose neighbours are less than a half turn apart, which they are not together: by default they can vanish
// all the same. A cubic with motors 86° apart in one plane; that its second half is a mirror image of the first makes
// its middle a sum along one direction, which weights can bring to zero.
TYPED_TEST(MotionSignsTest, controls_more_than_a_half_turn_apart_within_a_span)
{
    using T = TypeParam;
    auto data = this->turns({0, 1.5, 3.0, 4.5});
    CompiledMotion<T> sound(data);
    // (1 3w 3w 1) / 8 at t = ½, along the bisector cos 2.25 + 3w cos 0.75 = 0.
    const T weight = static_cast<T>(-std::cos(2.25) / std::cos(0.75) / 3);
    data.weights = {1, weight, weight, 1};
    this->expect_vanishing(data, MW_DEFAULT, 0);
    data.weights = {1, weight * 2, weight * 2, 1};
    CompiledMotion<T> passes_by(data);
}

// Nothing that vanishes nowhere is refused: signs at random, compared with the smallest sum of the reference.
TYPED_TEST(MotionSignsTest, vanishing_is_not_found_wrongly)
{
    using T = TypeParam;
    Random random(103);
    std::size_t refused = 0;
    for (int repetition = 0; repetition < 300; ++repetition) {
        const std::size_t degree = 1 + random.below(4);
        auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 1 + random.below(4));
        for (auto &control : data.controls)
            if (random.chance(2))
                this->negate(control);
        const auto motion = data.view();
        std::vector<std::uint64_t> memory(10000);
        const typename api<T>::compiled_motion *compiled = nullptr;
        const mw_status status = api<T>::compile_motion(&compiled, memory.data(), 8 * memory.size(), &motion,
                                                        MW_KEEP_SIGNS, nullptr);
        const reference::Motion exact = data.exact(0, MW_KEEP_SIGNS);
        long double least = 1;
        for (std::size_t span : exact.spans())
            for (int k = 0; k <= 200; ++k) {
                const auto pose = exact.at(exact.span_begin(span) + k / 200.0L, span);
                least = std::min(least, dot_of_rotations(pose, pose));
            }
        if (least > 0.001L) {
            EXPECT_EQ(status, MW_OK) << repetition << ": " << data.name() << ", α >= " << static_cast<double>(least);
        }
        refused += status != MW_OK;
    }
    EXPECT_LT(refused, 3u);
}

}  // namespace
}  // namespace motorway::testing
