// Making motors: translations, rotations, and the check for degenerate ones.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "api.h"
#include "motors.h"
#include "precisions.h"
#include "subject.h"

namespace motorway::testing {
namespace {

using reference::Real;

template <class T>
class MakingTest : public ::testing::Test {
protected:
    static void expect_close(const typename api<T>::motor &motor, const reference::Element &exact,
                             long double tolerance)
    {
        const T components[] = {motor.s, motor.b12, motor.b13, motor.b23, motor.b1i, motor.b2i, motor.b3i, motor.w};
        const reference::Motor expected = reference::motor(exact);
        for (std::size_t k = 0; k < 8; ++k)
            EXPECT_LE(std::abs(static_cast<long double>(Real(components[k]) - expected[k])), tolerance)
                << "component " << k;
    }
};

TYPED_TEST_SUITE(MakingTest, Precisions, PrecisionName);

TYPED_TEST(MakingTest, translation_is_exact)
{
    using T = TypeParam;
    Random random(21);
    for (int repetition = 0; repetition < 100; ++repetition) {
        T offset[3];
        draw_vector(random, offset);
        typename api<T>::motor motor;
        ASSERT_EQ(api<T>::translation(&motor, offset), MW_OK);
        // Half of a number is exact unless it is subnormal.
        this->expect_close(motor, reference::translation(exact_vector(offset)), underflow<T>);
    }
}

// In double and rounded once: half a unit in the last place for float. For double the sine and the cosine, the unit
// axis and its cross product with the point leave about 8 roundings. `reach` is the distance the offsets grow with.
TYPED_TEST(MakingTest, rotation_is_that_of_lemma_3_11)
{
    using T = TypeParam;
    Random random(22);
    for (int repetition = 0; repetition < 300; ++repetition) {
        T axis[3], point[3];
        const double length = random.magnitude(1e-3, 1e3);
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        axis[0] = static_cast<T>(length * x);
        axis[1] = static_cast<T>(length * y);
        axis[2] = static_cast<T>(length * z);
        for (T &coordinate : point)
            coordinate = static_cast<T>(random.uniform(-10, 10));
        const T angle = static_cast<T>(random.chance(4) ? random.magnitude(1e-6, 1e-3) : random.uniform(-7, 7));
        const bool at_origin = random.chance(3);

        reference::Vector3 unit = exact_vector(axis), centre{};
        const Real norm = sqrt(unit[0] * unit[0] + unit[1] * unit[1] + unit[2] * unit[2]);
        for (Real &component : unit)
            component = component / norm;
        if (!at_origin)
            centre = exact_vector(point);
        const long double half = static_cast<long double>(angle) / 2;
        const auto exact = reference::rotation(unit, Real(std::cos(half)), Real(std::sin(half)), centre);

        typename api<T>::motor motor;
        ASSERT_EQ(api<T>::rotation(&motor, axis, angle, at_origin ? nullptr : point), MW_OK);
        const long double reach = 1 + (at_origin ? 0 : size_of(point, 3));
        this->expect_close(motor, exact, (sizeof(T) == sizeof(float) ? 0.51L : 8) * epsilon<T> * reach);
    }
}

TYPED_TEST(MakingTest, rotations_are_right_handed)
{
    using T = TypeParam;
    const T axis[3] = {0, 0, 2}, quarter = static_cast<T>(1.57079632679489661923), e1[3] = {1, 0, 0};
    typename api<T>::motor motor;
    ASSERT_EQ(api<T>::rotation(&motor, axis, quarter, nullptr), MW_OK);
    T turned[3];
    ASSERT_EQ(api<T>::apply_direction_one(api<T>::xyz_aos(turned, sizeof turned), &motor,
                                          api<T>::const_xyz_aos(e1, sizeof e1), 1, MW_DEFAULT),
              MW_OK);
    EXPECT_NEAR(static_cast<double>(turned[0]), 0, static_cast<double>(2 * epsilon<T>));
    EXPECT_NEAR(static_cast<double>(turned[1]), 1, static_cast<double>(2 * epsilon<T>));
    EXPECT_EQ(turned[2], T(0));
}

// Axes whose squared length overflows or underflows the precision are axes all the same.
TYPED_TEST(MakingTest, rotation_takes_an_axis_of_any_length)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    for (T length : {Limits::denorm_min(), Limits::min(), Limits::max() / 4, Limits::max()}) {
        const T axis[3] = {length, 0, -length};
        typename api<T>::motor motor;
        ASSERT_EQ(api<T>::rotation(&motor, axis, T(1), nullptr), MW_OK) << length;
        const Real unit = Real(1) / sqrt(Real(2)), cosine(std::cos(0.5L)), sine(std::sin(0.5L));
        this->expect_close(motor, reference::rotation({unit, Real(0), -unit}, cosine, sine, {}), 4 * epsilon<T>);
    }
}

TYPED_TEST(MakingTest, check_finds_the_first_degenerate_motor)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    using Motor = typename api<T>::motor;
    // α is subnormal; α overflows; and so on. The offset part does not matter.
    const T small = std::sqrt(Limits::min()) / 2, large = std::sqrt(Limits::max()) * 2;
    const Motor degenerate[] = {{0, 0, 0, 0, 1, 2, 3, 4},
                                {small, 0, 0, 0, 0, 0, 0, 0},
                                {0, Limits::denorm_min(), 0, 0, 0, 0, 0, 0},
                                {large, 0, 0, 0, 0, 0, 0, 0},
                                {1, Limits::quiet_NaN(), 0, 0, 0, 0, 0, 0},
                                {1, 0, Limits::infinity(), 0, 0, 0, 0, 0},
                                {1, 0, 0, -Limits::infinity(), 0, 0, 0, 0}};
    for (const Motor &bad : degenerate)
        for (std::size_t place = 0; place < 40; ++place) {
            std::vector<Motor> motors(40, Motor{0, 1, 0, 0, 0, 0, 0, 0});
            motors[place] = bad;
            if (place + 3 < motors.size())
                motors[place + 3] = bad;
            std::size_t first_bad = 1234;
            const auto view = api<T>::const_motors_aos(motors.data(), sizeof(Motor));
            ASSERT_EQ(api<T>::check_motors(view, motors.size(), &first_bad), MW_ERROR_DEGENERATE_MOTOR);
            EXPECT_EQ(first_bad, place);
            EXPECT_EQ(api<T>::check_motors(view, motors.size(), nullptr), MW_ERROR_DEGENERATE_MOTOR);
            EXPECT_EQ(api<T>::check_motors(view, place, &first_bad), MW_OK);
        }
}

TYPED_TEST(MakingTest, check_accepts_every_motor_whose_alpha_is_normal)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    using Motor = typename api<T>::motor;
    const T small = std::sqrt(Limits::min()) * T(1.001), large = std::sqrt(Limits::max()) * T(0.999);
    const Motor motors[] = {{1, 0, 0, 0, 0, 0, 0, 0},
                            {small, 0, 0, 0, 0, 0, 0, 0},
                            {0, 0, -small, 0, 0, 0, 0, 0},
                            {0, large, 0, 0, 0, 0, 0, 0}};
    EXPECT_EQ(api<T>::check_motors(api<T>::const_motors_aos(motors, sizeof(Motor)), 4, nullptr), MW_OK);
}

}  // namespace
}  // namespace motorway::testing
