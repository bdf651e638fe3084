// What must hold whatever the numbers are: laws of the algebra and of rigid motions, through the public API alone.

#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_tester.h"
#include "motors.h"
#include "precisions.h"
#include "subject.h"

namespace motorway::testing {
namespace {

template <class T>
class PropertyTest : public ::testing::Test {
protected:
    static constexpr std::size_t count = 333;
    using Motor = typename api<T>::motor;
    using Vectors = std::vector<T>;       // x y z x y z ...
    using Motors = std::vector<T>;        // eight components each

    static auto out_motors(Motors &m)
    {
        return api<T>::motors_aos(reinterpret_cast<Motor *>(m.data()), sizeof(Motor));
    }
    static auto in_motors(const Motors &m)
    {
        return api<T>::const_motors_aos(reinterpret_cast<const Motor *>(m.data()), sizeof(Motor));
    }

    // Of ordinary sizes, so that errors are small multiples of epsilon and the laws can be seen to hold.
    static Motors draw_motors(Random &random, std::initializer_list<Regime> regimes)
    {
        Motors motors(8 * count);
        for (std::size_t i = 0; i < count; ++i)
            draw_motor(random, regimes.begin()[i % regimes.size()], &motors[8 * i]);
        return motors;
    }

    static Vectors draw_vectors(Random &random)
    {
        Vectors vectors(3 * count);
        for (T &coordinate : vectors)
            coordinate = static_cast<T>(random.uniform(-2, 2));
        return vectors;
    }

    static Vectors moved(const Motors &motors, const Vectors &points, unsigned flags = MW_DEFAULT)
    {
        Vectors result(points.size());
        EXPECT_EQ(api<T>::apply_point_each(api<T>::xyz_aos(result.data(), 3 * sizeof(T)), in_motors(motors),
                                           api<T>::const_xyz_aos(points.data(), 3 * sizeof(T)), count, flags),
                  MW_OK);
        return result;
    }

    static Motors composed(const Motors &first, const Motors &then)
    {
        Motors result(first.size());
        EXPECT_EQ(api<T>::compose_motor_each(out_motors(result), in_motors(first), in_motors(then), count), MW_OK);
        return result;
    }

    static Motors normalized(const Motors &motors)
    {
        Motors result(motors.size());
        EXPECT_EQ(api<T>::normalize_motor_each(out_motors(result), in_motors(motors), count), MW_OK);
        return result;
    }

    static Motors reversed(const Motors &motors)
    {
        Motors result(motors.size());
        EXPECT_EQ(api<T>::reverse_motor_each(out_motors(result), in_motors(motors), count), MW_OK);
        return result;
    }

    // In units of epsilon; sizes of points and offsets here are up to about 10.
    static void expect_close(const std::vector<T> &a, const std::vector<T> &b, long double epsilons)
    {
        const double tolerance = static_cast<double>(epsilons * epsilon<T>);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k)
            ASSERT_NEAR(static_cast<double>(a[k]), static_cast<double>(b[k]), tolerance) << "number " << k;
    }

    static long double distance(const T *a, const T *b)
    {
        long double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            sum += (static_cast<long double>(a[k]) - b[k]) * (static_cast<long double>(a[k]) - b[k]);
        return std::sqrt(sum);
    }
};

TYPED_TEST_SUITE(PropertyTest, Precisions, PrecisionName);

// F_UV = F_V F_U (lemma 3.5), normalised or not.
TYPED_TEST(PropertyTest, a_composition_does_the_first_motion_and_then_the_other)
{
    Random random(31);
    const auto u = this->draw_motors(random, {Regime::general, Regime::scaled, Regime::half_turn});
    const auto v = this->draw_motors(random, {Regime::rotation, Regime::general, Regime::scaled_pseudoscalar});
    const auto points = this->draw_vectors(random);
    // Points reach about 20, motors with a pseudoscalar part have terms some ten times that.
    this->expect_close(this->moved(this->composed(u, v), points), this->moved(v, this->moved(u, points)), 3000);
}

TYPED_TEST(PropertyTest, the_reverse_of_any_motor_undoes_its_motion)
{
    Random random(32);
    const auto motors = this->draw_motors(random, {Regime::general, Regime::scaled, Regime::half_turn});
    const auto points = this->draw_vectors(random);
    this->expect_close(this->moved(this->reversed(motors), this->moved(motors, points)), points, 200);
}

TYPED_TEST(PropertyTest, the_reverse_of_the_reverse_is_the_motor_itself)
{
    Random random(33);
    const auto motors = this->draw_motors(random, {Regime::general, Regime::far, Regime::arbitrary});
    EXPECT_EQ(this->reversed(this->reversed(motors)), motors);
}

// Theorem 3.8, also for motors that are not normalised: that is what blending relies on.
TYPED_TEST(PropertyTest, distances_are_kept_by_every_motor)
{
    using T = TypeParam;
    Random random(34);
    auto motors = this->draw_motors(random, {Regime::general, Regime::scaled, Regime::pseudoscalar, Regime::half_turn,
                                             Regime::tiny_angle, Regime::scaled_pseudoscalar});
    const auto points = this->draw_vectors(random), others = this->draw_vectors(random);
    const auto p = this->moved(motors, points), q = this->moved(motors, others);
    for (std::size_t i = 0; i < this->count; ++i)
        ASSERT_NEAR(static_cast<double>(this->distance(&p[3 * i], &q[3 * i])),
                    static_cast<double>(this->distance(&points[3 * i], &others[3 * i])),
                    static_cast<double>(1000 * epsilon<T>))
            << "motor " << i;
}

// S̄S = 1 with no pseudoscalar part left, and the same motion.
TYPED_TEST(PropertyTest, normalising_leaves_a_unit_and_the_motion)
{
    using T = TypeParam;
    Random random(35);
    const auto motors =
        this->draw_motors(random, {Regime::scaled, Regime::pseudoscalar, Regime::scaled_pseudoscalar});
    const auto units = this->normalized(motors);
    for (std::size_t i = 0; i < this->count; ++i) {
        const reference::Motor unit = exact_motor(&units[8 * i]);
        ASSERT_NEAR(static_cast<double>(static_cast<long double>(reference::alpha(unit))), 1,
                    static_cast<double>(8 * epsilon<T>));
        ASSERT_NEAR(static_cast<double>(static_cast<long double>(reference::beta(unit))), 0,
                    static_cast<double>(200 * epsilon<T>));
        ASSERT_EQ(std::signbit(units[8 * i]), std::signbit(motors[8 * i]));
    }
    const auto points = this->draw_vectors(random);
    this->expect_close(this->moved(units, points), this->moved(motors, points), 1000);
    this->expect_close(this->moved(units, points, MW_UNIT_MOTORS), this->moved(motors, points), 1000);
}

TYPED_TEST(PropertyTest, normalising_twice_changes_no_more_than_rounding)
{
    Random random(36);
    const auto units = this->normalized(this->draw_motors(random, {Regime::scaled, Regime::general}));
    this->expect_close(this->normalized(units), units, 100);
}

TYPED_TEST(PropertyTest, the_identity_changes_nothing)
{
    using T = TypeParam;
    Random random(37);
    std::vector<T> identity(8 * this->count, T(0));
    for (std::size_t i = 0; i < this->count; ++i)
        identity[8 * i] = T(1);
    const auto points = this->draw_vectors(random);
    EXPECT_EQ(this->moved(identity, points), points);
    EXPECT_EQ(this->moved(identity, points, MW_UNIT_MOTORS), points);
    const auto motors = this->draw_motors(random, {Regime::general, Regime::far});
    EXPECT_EQ(this->composed(motors, identity), motors);
    EXPECT_EQ(this->composed(identity, motors), motors);
}

// The square of a motor in place: `out` is both inputs.
TYPED_TEST(PropertyTest, out_may_be_both_factors_of_a_product)
{
    Random random(38);
    const auto motors = this->draw_motors(random, {Regime::general, Regime::arbitrary});
    auto square = motors;
    ASSERT_EQ(api<TypeParam>::compose_motor_each(this->out_motors(square), this->in_motors(square),
                                                 this->in_motors(square), this->count),
              MW_OK);
    EXPECT_EQ(square, this->composed(motors, motors));
}

// Every result of the element with the NaN that depends on it is NaN, and the neighbours are what they were.
TYPED_TEST(PropertyTest, a_nan_or_an_infinity_stays_in_its_element)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(39);
        const auto motors = this->draw_motors(random, {Regime::general});
        const auto points = this->draw_vectors(random);
        const auto clean = this->moved(motors, points);
        for (T bad : {Limits::quiet_NaN(), Limits::infinity()})
            for (std::size_t place : {0, 1, 15, 16, 17, 200, 331, 332}) {
                auto spoilt = points;
                spoilt[3 * place + random.below(3)] = bad;
                const auto result = this->moved(motors, spoilt);
                for (std::size_t i = 0; i < this->count; ++i)
                    for (std::size_t k = 0; k < 3; ++k) {
                        const T value = result[3 * i + k];
                        ASSERT_TRUE(i == place ? !std::isfinite(value) : same(value, clean[3 * i + k]))
                            << "element " << i << " for " << bad << " in " << place;
                    }
            }
    }
}

// A degenerate motor spoils its own element only, and is no reason for an error in a batch.
TYPED_TEST(PropertyTest, a_degenerate_motor_stays_in_its_element)
{
    using T = TypeParam;
    Random random(40);
    auto motors = this->draw_motors(random, {Regime::general});
    const auto points = this->draw_vectors(random);
    const auto clean = this->moved(motors, points);
    const auto clean_units = this->normalized(motors);
    const std::size_t place = 100;
    std::fill_n(motors.begin() + 8 * place, 4, T(0));
    const auto result = this->moved(motors, points);
    const auto units = this->normalized(motors);
    for (std::size_t i = 0; i < this->count; ++i) {
        if (i == place)
            continue;
        ASSERT_EQ(std::memcmp(&result[3 * i], &clean[3 * i], sizeof(T[3])), 0) << "element " << i;
        ASSERT_EQ(std::memcmp(&units[8 * i], &clean_units[8 * i], sizeof(T[8])), 0) << "element " << i;
    }
    EXPECT_FALSE(std::isfinite(units[8 * place]) && std::isfinite(units[8 * place + 4]));
}

// "Term after term in the order k = 0, 1, ...": fused where the instruction set fuses, rounded twice where not.
TYPED_TEST(PropertyTest, a_blend_adds_its_terms_in_order)
{
    using T = TypeParam;
    constexpr std::size_t terms = 5;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(41);
        const auto controls = this->draw_motors(random, {Regime::general, Regime::far, Regime::scaled});
        std::vector<T> weights(terms * this->count), result(8 * this->count);
        for (T &weight : weights)
            weight = static_cast<T>(random.uniform(-1, 1));
        std::vector<const T *> columns;
        for (std::size_t k = 0; k < terms; ++k)
            columns.push_back(&weights[k * this->count]);
        ASSERT_EQ(api<T>::blend_motor_one(this->out_motors(result),
                                          reinterpret_cast<const typename api<T>::motor *>(controls.data()),
                                          {columns.data(), sizeof(T)}, terms, this->count),
                  MW_OK);
        for (std::size_t i = 0; i < this->count; ++i)
            for (std::size_t c = 0; c < 8; ++c) {
                T sum = 0;
                for (std::size_t k = 0; k < terms; ++k) {
                    volatile T product = columns[k][i] * controls[8 * k + c];  // rounded, whatever the compiler fuses
                    sum = fuses(isa) ? std::fma(columns[k][i], controls[8 * k + c], sum) : product + sum;
                }
                ASSERT_EQ(result[8 * i + c], sum) << "element " << i << ", component " << c;
            }
    }
}

}  // namespace
}  // namespace motorway::testing
