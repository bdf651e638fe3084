// The functions that stand in for libm's, against libm in long double (64 bits), over all magnitudes.

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"
#include "scalar_math.h"

namespace motorway::testing {
namespace {

// How far off, in units in the last place of the exact value.
long double ulps(double value, long double exact)
{
    const double rounded = static_cast<double>(exact);
    const double unit = std::nextafter(std::fabs(rounded), INFINITY) - std::fabs(rounded);
    return std::fabs(value - exact) / unit;
}

// Of any sign; `low` to `high` in powers of two.
double any_magnitude(Random &random, double low, double high)
{
    const double size = std::exp2(random.uniform(low, high));
    return random.chance(2) ? -size : size;
}

TEST(ScalarMath, sine_and_cosine_over_all_magnitudes)
{
    if (std::numeric_limits<long double>::digits < 64)
        GTEST_SKIP() << "long double is no better than double here";
    Random random(31);
    for (int k = 0; k < 200000; ++k) {
        const double angle = any_magnitude(random, k % 2 ? -3 : -1070, k % 2 ? 8 : 1023.99);
        const sine_cosine of = sine_and_cosine(angle);
        ASSERT_LE(ulps(of.sine, std::sin(static_cast<long double>(angle))), 0.8L) << std::hexfloat << angle;
        ASSERT_LE(ulps(of.cosine, std::cos(static_cast<long double>(angle))), 0.8L) << std::hexfloat << angle;
    }
}

// Where most of the bits cancel: next to multiples of π/2. The last two are the doubles nearest to any of them.
TEST(ScalarMath, sine_and_cosine_near_multiples_of_a_right_angle)
{
    if (std::numeric_limits<long double>::digits < 64)
        GTEST_SKIP() << "long double is no better than double here";
    std::vector<double> angles = {0x1.6ac5b262ca1ffp+849, 0x1.951f1572eba23p+43};
    for (int n = 1; n < 1000; ++n)
        angles.push_back(static_cast<double>(n * 1.57079632679489661923L));
    for (double near : angles)
        for (double angle : {near, std::nextafter(near, 0), std::nextafter(near, INFINITY), -near}) {
            const sine_cosine of = sine_and_cosine(angle);
            ASSERT_LE(ulps(of.sine, std::sin(static_cast<long double>(angle))), 0.8L) << std::hexfloat << angle;
            ASSERT_LE(ulps(of.cosine, std::cos(static_cast<long double>(angle))), 0.8L) << std::hexfloat << angle;
        }
}

TEST(ScalarMath, sine_and_cosine_of_what_is_special)
{
    for (double zero : {0.0, -0.0}) {
        EXPECT_EQ(std::signbit(sine_and_cosine(zero).sine), std::signbit(zero));
        EXPECT_EQ(sine_and_cosine(zero).cosine, 1);
    }
    for (double tiny : {5e-324, 1e-310, -2e-308})
        EXPECT_EQ(sine_and_cosine(tiny).sine, tiny);
    for (double none : {INFINITY, -INFINITY, NAN}) {
        EXPECT_TRUE(std::isnan(sine_and_cosine(none).sine));
        EXPECT_TRUE(std::isnan(sine_and_cosine(none).cosine));
    }
}

TEST(ScalarMath, angles_over_all_quotients)
{
    if (std::numeric_limits<long double>::digits < 64)
        GTEST_SKIP() << "long double is no better than double here";
    Random random(32);
    for (int k = 0; k < 200000; ++k) {
        const double x = any_magnitude(random, -40, 40);
        const double y = std::fabs(k % 2 ? x * std::exp2(random.uniform(-4, 4)) : any_magnitude(random, -60, 60));
        const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        ASSERT_LE(ulps(angle_of(x, y), exact), 1.75L) << std::hexfloat << x << ", " << y;
    }
}

TEST(ScalarMath, angles_of_what_is_special)
{
    EXPECT_EQ(angle_of(0, 0), 0);
    EXPECT_EQ(angle_of(1, 0), 0);
    EXPECT_EQ(angle_of(-1, 0), 0x1.921fb54442d18p+1);
    EXPECT_EQ(angle_of(0, 1), 0x1.921fb54442d18p+0);
    EXPECT_EQ(angle_of(3, 3), 0x1.921fb54442d18p-1);
    EXPECT_TRUE(std::isnan(angle_of(NAN, 1)));
    EXPECT_TRUE(std::isnan(angle_of(1, NAN)));
}

TEST(ScalarMath, lengths_neither_overflow_nor_underflow)
{
    EXPECT_EQ(length_of(3, -4, 12), 13);
    EXPECT_EQ(length_of(0, 0, 0), 0);
    for (int n = -1074; n <= 1020; ++n)
        EXPECT_EQ(length_of(std::ldexp(3, n), 0, std::ldexp(-4, n)), std::ldexp(5, n)) << n;
    EXPECT_EQ(length_of(1e308, 1e308, 0), 1e308 * std::sqrt(2.0));
    EXPECT_EQ(length_of(1, -INFINITY, 0), INFINITY);
    EXPECT_TRUE(std::isnan(length_of(1, NAN, 0)));
    Random random(33);
    for (int k = 0; k < 20000; ++k) {
        const double x = any_magnitude(random, -500, 500), y = x * random.uniform(-2, 2), z = x * random.uniform(-2, 2);
        const long double exact = std::sqrt(static_cast<long double>(x) * x + static_cast<long double>(y) * y +
                                            static_cast<long double>(z) * z);
        ASSERT_LE(ulps(length_of(x, y, z), exact), 1.5L) << std::hexfloat << x << ", " << y << ", " << z;
    }
}

TEST(ScalarMath, exponents_and_powers_of_two_are_those_of_libm)
{
    for (int n = -1073; n <= 1024; ++n)
        for (double fraction : {0.5, 0x1.fffffffffffffp-1, -0.75}) {
            const double x = std::ldexp(fraction, n);
            int exponent;
            std::frexp(x, &exponent);
            ASSERT_EQ(exponent_of(x), exponent) << n;
            ASSERT_EQ(times_power_of_two(fraction, n), x) << n;
        }
}

template <class T>
void expect_neighbours()
{
    const T infinity = std::numeric_limits<T>::infinity(), smallest = std::numeric_limits<T>::denorm_min();
    for (T x : {smallest, std::numeric_limits<T>::min(), T(1), T(0x1.fffffep0), std::numeric_limits<T>::max()}) {
        EXPECT_EQ(next_above(x), std::nextafter(x, infinity));
        EXPECT_EQ(next_below(x), std::nextafter(x, -infinity));
        EXPECT_EQ(next_below(-x), std::nextafter(-x, -infinity));
    }
    EXPECT_EQ(next_below(T(0)), -smallest);
}

TEST(ScalarMath, neighbours_are_those_of_libm)
{
    expect_neighbours<float>();
    expect_neighbours<double>();
}

}  // namespace
}  // namespace motorway::testing
