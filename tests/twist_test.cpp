// One twist: the parts of a generator, and its motion in closed form against the exponential.

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "convert_api.h"
#include "precisions.h"
#include "screws.h"
#include "subject.h"

namespace motorway::testing {
namespace {

using reference::Real;

template <class T>
class TwistTest : public ::testing::Test {
protected:
    using Twist = typename api<T>::twist;

    static Twist split(const T *bivector)
    {
        Twist twist{};
        EXPECT_EQ(api<T>::split_bivector(&twist, bivector), MW_OK);
        return twist;
    }

    static std::array<T, 8> pose(const Twist &twist, T lambda)
    {
        typename api<T>::motor motor{};
        EXPECT_EQ(api<T>::twist_pose(&motor, &twist, lambda), MW_OK);
        return {motor.s, motor.b12, motor.b13, motor.b23, motor.b1i, motor.b2i, motor.b3i, motor.w};
    }

    static std::array<T, 3> position(const Twist &twist, T lambda)
    {
        std::array<T, 3> result{};
        EXPECT_EQ(api<T>::twist_position(result.data(), &twist, lambda), MW_OK);
        return result;
    }

    // ½ angle (axis e123) + ½ (along + across) e∞, in the numbers of the twist.
    static reference::Bivector bivector_of(const Twist &twist)
    {
        const Real half(0.5L), half_angle = half * Real(twist.angle);
        const auto moment = [&](int k) { return half * (Real(twist.along[k]) + Real(twist.across[k])); };
        return {half_angle * Real(twist.axis[2]), -(half_angle * Real(twist.axis[1])),
                half_angle * Real(twist.axis[0]), moment(0), moment(1), moment(2)};
    }

    static long double dot(const T *a, const T *b)
    {
        long double sum = 0;
        for (int k = 0; k < 3; ++k)
            sum += static_cast<long double>(a[k]) * b[k];
        return sum;
    }

    // Generators of every angle, nine half turns and 1e-30 among them, of every pitch, and of translations.
    static std::vector<std::array<T, 6>> all_bivectors()
    {
        Random random(31);
        std::vector<std::array<T, 6>> all = {{}, {0, 0, 0, 1, -2, 3}, {1, 0, 0, 0, 0, 0}};
        for (long double half_angle : {1e-30L, 1e-10L, pi / 2, pi, 4.5L * pi})
            for (int k = 0; k < 10; ++k)
                all.push_back(rounded(draw_screw(random, half_angle)));
        for (int k = 0; k < 200; ++k)
            all.push_back(rounded(draw_screw(random, draw_turn(random))));
        return all;
    }

private:
    static std::array<T, 6> rounded(const Screw &screw)
    {
        std::array<T, 6> bivector;
        round_to(motorway::testing::bivector_of(screw), bivector.data());
        return bivector;
    }
};

TYPED_TEST_SUITE(TwistTest, Precisions, PrecisionName);

// Rounded once: the parts have half an epsilon of their own, and so has their sum of theirs.
TYPED_TEST(TwistTest, the_parts_are_the_generator)
{
    using T = TypeParam;
    for (const auto &bivector : this->all_bivectors()) {
        const auto twist = this->split(bivector.data());
        const reference::Bivector sum = this->bivector_of(twist);
        const long double angle = length_of(bivector, 0, 3), moment = length_of(bivector, 3, 6);
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_NEAR(static_cast<double>(static_cast<long double>(sum[k])), static_cast<double>(bivector[k]),
                        static_cast<double>(4 * epsilon<T> * (k < 3 ? angle : moment) + underflow<T>));
        EXPECT_NEAR(length_of(twist.axis, 0, 3), 1, 2 * epsilon<T>);
        EXPECT_GE(twist.angle, T(0));
        // Along is a multiple of the axis, across is normal to it.
        EXPECT_NEAR(this->dot(twist.axis, twist.across), 0, 8 * epsilon<T> * moment);
        const long double along = this->dot(twist.axis, twist.along);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(twist.along[k], along * twist.axis[k], 8 * epsilon<T> * moment);
    }
}

TYPED_TEST(TwistTest, a_generator_by_numbers)
{
    using T = TypeParam;
    // A half of about z is 1, so it turns by 2, and moves by 6 along z.
    const T bivector[6] = {1, 0, 0, 1, 2, 3};
    const auto twist = this->split(bivector);
    const T axis[3] = {0, 0, 1}, along[3] = {0, 0, 6}, across[3] = {2, 4, 0};
    EXPECT_EQ(twist.angle, T(2));
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(twist.axis[k], axis[k]);
        EXPECT_EQ(twist.along[k], along[k]);
        EXPECT_EQ(twist.across[k], across[k]);
    }
    // Without rotation the axis is z.
    const T translation[6] = {0, 0, 0, 1, 2, 3};
    const auto still = this->split(translation);
    EXPECT_EQ(still.angle, T(0));
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(still.axis[k], axis[k]);
        EXPECT_EQ(still.along[k], along[k]);
        EXPECT_EQ(still.across[k], across[k]);
    }
}

// So short or so long that the inverse of the length is no normal number. The axis is right all the same.
TYPED_TEST(TwistTest, generators_of_any_size)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    for (const T size : {Limits::denorm_min(), Limits::min() / 2, Limits::min(), T(1), Limits::max() / 16}) {
        const T bivector[6] = {4 * size, 0, 3 * size, 1, 2, 3};
        const auto twist = this->split(bivector);
        const long double axis[3] = {0.6L, 0, 0.8L};
        EXPECT_EQ(twist.angle, 10 * size);
        const long double along = 2 * (0.6L * 1 + 0.8L * 3), across[3] = {2 - 0.6L * along, 4, 6 - 0.8L * along};
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(twist.axis[k], axis[k], 2 * epsilon<T>) << size;
            EXPECT_NEAR(twist.along[k], along * axis[k], 16 * epsilon<T>) << size;
            EXPECT_NEAR(twist.across[k], across[k], 16 * epsilon<T>) << size;
        }
    }
}

// Of the generator that the numbers of the twist are: the pose has the rounding to T, and that of the arithmetic in
// double of angles up to λ times nine half turns.
TYPED_TEST(TwistTest, the_pose_is_the_exponential)
{
    using T = TypeParam;
    for (const auto &bivector : this->all_bivectors()) {
        const auto twist = this->split(bivector.data());
        for (double parameter : {0.0, 1.0, 0.5, -0.25, 3.0, 1e-6, 1e-30}) {
            const T lambda = static_cast<T>(parameter);
            const reference::Bivector generator = reference::multiple(Real(lambda), this->bivector_of(twist));
            const reference::Motor expected = reference::exp(generator);
            const auto pose = this->pose(twist, lambda);
            const long double angle = length_of(generator, 0, 3), moment = length_of(generator, 3, 6);
            const long double relative = epsilon<T> + (4 + 2 * angle) * epsilon<double>;
            // The axis is a little off its unit length, and the parts a little off being normal.
            const long double rotation = relative + 4 * epsilon<T> * angle;
            for (std::size_t k = 0; k < 8; ++k)
                EXPECT_NEAR(static_cast<double>(pose[k]), static_cast<double>(static_cast<long double>(expected[k])),
                            static_cast<double>((k < 4 ? rotation : 4 * rotation * moment) + 2 * underflow<T>))
                    << "component " << k << ", lambda " << lambda;
        }
    }
}

// The closed form of the path against the pose, point by point.
TYPED_TEST(TwistTest, the_position_is_where_the_pose_takes_the_origin)
{
    using T = TypeParam;
    for (const auto &bivector : this->all_bivectors()) {
        const auto twist = this->split(bivector.data());
        for (int sample = -4; sample <= 16; ++sample) {
            const T lambda = T(sample) / 8;
            const reference::Bivector generator = reference::multiple(Real(lambda), this->bivector_of(twist));
            const reference::Vector3 expected = reference::apply_point(reference::exp(generator), {});
            const auto position = this->position(twist, lambda);
            const long double angle = length_of(generator, 0, 3), moment = length_of(generator, 3, 6);
            const long double error = 4 * epsilon<T> * (1 + angle) + 16 * (1 + angle) * epsilon<double>;
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(static_cast<double>(position[k]),
                            static_cast<double>(static_cast<long double>(expected[k])),
                            static_cast<double>(error * 2 * moment + 2 * underflow<T>))
                    << "lambda " << lambda;
        }
    }
}

// τ(ψ, P, a) of definition 4, of which the motor is the reverse: a rotation, and a translation along its axis, in any
// order.
TYPED_TEST(TwistTest, without_across_it_is_a_rotation_and_a_translation_along_the_axis)
{
    using T = TypeParam;
    const typename TestFixture::Twist twist{{T(0.6), 0, T(0.8)}, T(1.5), {3, 0, 4}, {0, 0, 0}};
    for (double parameter : {0.0, 1.0, 0.3, -2.0}) {
        const T lambda = static_cast<T>(parameter);
        const long double half = static_cast<long double>(lambda) * twist.angle / 2;
        const reference::Element rotation = reference::rotation(
            exact_vector(twist.axis), Real(std::cos(half)), Real(std::sin(half)), {});
        const reference::Element translation =
            reference::translation({Real(3) * Real(lambda), Real(0), Real(4) * Real(lambda)});
        const auto pose = this->pose(twist, lambda);
        for (const reference::Motor &expected :
             {reference::motor(rotation * translation), reference::motor(translation * rotation)})
            for (std::size_t k = 0; k < 8; ++k)
                EXPECT_NEAR(static_cast<double>(pose[k]), static_cast<double>(static_cast<long double>(expected[k])),
                            16 * static_cast<double>(epsilon<T>));
    }
}

// t∥ = 4a + 6b, ψ = 9π and |t⊥| = 1, with e1, e2 and e3 for a, b and their normal. With c and s of λψ/2 the position
// is λ (sinc λψ/2) (4c - 6s, 6c + 4s) in the plane, which is (-12, 8) / 9π after four and a half turns.
TYPED_TEST(TwistTest, the_helix_of_figure_7)
{
    using T = TypeParam;
    const T bivector[6] = {static_cast<T>(4.5L * pi), 0, 0, 2, 3, T(0.5)};
    const auto twist = this->split(bivector);
    const long double psi = 9 * pi;
    EXPECT_NEAR(twist.angle, psi, 16 * psi * epsilon<T>);
    const T along[3] = {0, 0, 1}, across[3] = {4, 6, 0};
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(twist.along[k], along[k]);
        EXPECT_EQ(twist.across[k], across[k]);
    }
    for (int sample = 0; sample <= 90; ++sample) {
        const T lambda = static_cast<T>(sample / 90.0L);
        const long double half = lambda * psi / 2, c = std::cos(half), s = std::sin(half);
        const auto position = this->position(twist, lambda);
        const long double tolerance = 16 * epsilon<T>;
        EXPECT_NEAR(position[0], 2 * s / psi * (4 * c - 6 * s), tolerance) << sample;
        EXPECT_NEAR(position[1], 2 * s / psi * (6 * c + 4 * s), tolerance) << sample;
        EXPECT_NEAR(position[2], lambda, tolerance) << sample;
        // A cylinder around the axis through the point of which `across` is the velocity over the angle.
        EXPECT_NEAR(std::hypot(position[0] + 6 / psi, position[1] - 4 / psi), std::sqrt(52) / psi, tolerance);
    }
    const auto end = this->position(twist, T(1));
    EXPECT_NEAR(end[0], -12 / psi, 16 * epsilon<T>);
    EXPECT_NEAR(end[1], 8 / psi, 16 * epsilon<T>);
    EXPECT_NEAR(end[2], 1, 16 * epsilon<T>);
}

// ------------------------------------------------------------------------------------------------------------ errors

template <class T>
T worst(int which)
{
    using Limits = std::numeric_limits<T>;
    return which == 0 ? Limits::quiet_NaN() : which == 1 ? Limits::infinity() : -Limits::infinity();
}

// A call that is to fail, with what it must not write to.
template <class Out, class Call>
void expect_error(mw_status status, Call call)
{
    Out out, before;
    std::memset(static_cast<void *>(&out), 0x5a, sizeof out);
    std::memcpy(static_cast<void *>(&before), &out, sizeof out);
    EXPECT_EQ(call(&out), status);
    EXPECT_EQ(std::memcmp(&out, &before, sizeof out), 0) << "bytes changed";
}

TYPED_TEST(TwistTest, null)
{
    using T = TypeParam;
    using C = api<T>;
    using Parts = typename TestFixture::Twist;
    using Motor = typename api<T>::motor;
    const T bivector[6] = {1, 2, 3, 4, 5, 6};
    const Parts twist{{0, 0, 1}, 1, {0, 0, 1}, {1, 0, 0}};
    EXPECT_EQ(C::split_bivector(nullptr, bivector), MW_ERROR_NULL);
    EXPECT_EQ(C::twist_pose(nullptr, &twist, T(1)), MW_ERROR_NULL);
    EXPECT_EQ(C::twist_position(nullptr, &twist, T(1)), MW_ERROR_NULL);
    expect_error<Parts>(MW_ERROR_NULL, [](Parts *out) { return C::split_bivector(out, nullptr); });
    expect_error<Motor>(MW_ERROR_NULL, [](Motor *out) { return C::twist_pose(out, nullptr, T(1)); });
    expect_error<T[3]>(MW_ERROR_NULL, [](T(*out)[3]) { return C::twist_position(*out, nullptr, T(1)); });
}

TYPED_TEST(TwistTest, numbers_that_are_not_finite)
{
    using T = TypeParam;
    using C = api<T>;
    using Parts = typename TestFixture::Twist;
    using Motor = typename api<T>::motor;
    const auto fails = [](const Parts &twist, T lambda) {
        expect_error<Motor>(MW_ERROR_AXIS, [&](Motor *out) { return C::twist_pose(out, &twist, lambda); });
        expect_error<T[3]>(MW_ERROR_AXIS, [&](T(*out)[3]) { return C::twist_position(*out, &twist, lambda); });
    };
    for (int which = 0; which < 3; ++which) {
        const T bad = worst<T>(which);
        for (int k = 0; k < 6; ++k) {
            T bivector[6] = {1, 2, 3, 4, 5, 6};
            bivector[k] = bad;
            expect_error<Parts>(MW_ERROR_AXIS, [&](Parts *out) { return C::split_bivector(out, bivector); });
        }
        const Parts good{{0, 0, 1}, 1, {0, 0, 1}, {1, 0, 0}};
        for (int k = 0; k < 3; ++k) {
            Parts axis = good, along = good, across = good;
            axis.axis[k] = along.along[k] = across.across[k] = bad;
            for (const Parts &twist : {axis, along, across})
                fails(twist, 1);
        }
        Parts angle = good;
        angle.angle = bad;
        fails(angle, 1);
        fails(good, bad);
    }
}

TYPED_TEST(TwistTest, an_axis_that_is_not_of_length_1)
{
    using T = TypeParam;
    using C = api<T>;
    using Parts = typename TestFixture::Twist;
    using Motor = typename api<T>::motor;
    Parts twist{{0, 0, 1}, 1, {0, 0, 1}, {1, 0, 0}};
    for (double length : {0.0, 0.5, 1 - 0x1.1p-10, 1 + 0x1.1p-10, 2.0}) {
        twist.axis[2] = static_cast<T>(length);
        expect_error<Motor>(MW_ERROR_AXIS, [&](Motor *out) { return C::twist_pose(out, &twist, T(1)); });
        expect_error<T[3]>(MW_ERROR_AXIS, [&](T(*out)[3]) { return C::twist_position(*out, &twist, T(1)); });
    }
    for (double length : {1 - 0x1.0p-10, 1 + 0x1.0p-10, -1.0}) {
        twist.axis[2] = static_cast<T>(length);
        Motor motor;
        T place[3];
        EXPECT_EQ(C::twist_pose(&motor, &twist, T(1)), MW_OK);
        EXPECT_EQ(C::twist_position(place, &twist, T(1)), MW_OK);
    }
}

}  // namespace
}  // namespace motorway::testing
