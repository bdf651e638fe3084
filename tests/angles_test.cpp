// Angles of every size, from the smallest number to the largest, on every instruction set: what they make is a unit motor,
// by the angle that was given. The reference is the system's libm in long double, which reduces any angle exactly.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "convert_api.h"
#include "isas.h"
#include "precisions.h"
#include "random.h"

namespace motorway::testing {
namespace {

using Quaternion = std::vector<long double>;  // s b12 b13 b23

template <class T>
class AnglesTest : public ::testing::Test {
protected:
    using A = api<T>;
    using C = api<T>;
    using Motor = typename A::motor;

    static constexpr long double epsilon = std::numeric_limits<T>::epsilon();
    static constexpr int smallest = std::numeric_limits<T>::min_exponent, largest = std::numeric_limits<T>::max_exponent;

    static Quaternion quaternion_of(const Motor &m) { return {m.s, m.b12, m.b13, m.b23}; }

    // |α - 1| in epsilons.
    static long double length_error(const Motor &m)
    {
        long double alpha = 0;
        for (long double c : quaternion_of(m))
            alpha += c * c;
        return std::fabs(alpha - 1) / epsilon;
    }

    static long double distance(const Motor &m, const Quaternion &wanted)
    {
        long double square = 0;
        for (std::size_t k = 0; k < 4; ++k)
            square += std::pow(quaternion_of(m)[k] - wanted[k], 2.0L);
        return std::sqrt(square) / epsilon;
    }

    // A number of either sign, with an exponent in [low, high].
    static T number(Random &random, int low, int high)
    {
        const double mantissa = random.uniform(1, 2) * (random.chance(2) ? -1 : 1);
        return static_cast<T>(std::ldexp(mantissa, low + static_cast<int>(random.below(std::size_t(high - low + 1)))));
    }

    static std::vector<Motor> exp(const std::vector<T> &bivectors)
    {
        std::vector<Motor> result(bivectors.size() / 6);
        const std::size_t stride = 6 * sizeof(T);
        T *const first = const_cast<T *>(bivectors.data());
        const typename A::const_bivectors in = {first, first + 1, first + 2, first + 3, first + 4, first + 5, stride};
        EXPECT_EQ(A::exp_motor_each(A::motors_aos(result.data(), sizeof(Motor)), in, result.size()), MW_OK);
        return result;
    }

    static std::vector<Motor> of_axis_angle(const std::vector<T> &rotations)
    {
        std::vector<Motor> result(rotations.size() / 4);
        const std::vector<T> origin(3 * result.size());
        T *const first = const_cast<T *>(rotations.data());
        const typename C::const_xyzw in = {first, first + 1, first + 2, first + 3, 4 * sizeof(T)};
        EXPECT_EQ(C::convert_axis_angle_to_motor_each(A::motors_aos(result.data(), sizeof(Motor)), in,
                                         A::const_xyz_aos(origin.data(), 3 * sizeof(T)), result.size()),
                  MW_OK);
        return result;
    }

    static std::vector<Motor> of_euler(const std::vector<T> &angles, mw_euler_order order)
    {
        std::vector<Motor> result(angles.size() / 3);
        const std::vector<T> origin(angles.size());
        EXPECT_EQ(C::convert_euler_to_motor_each(A::motors_aos(result.data(), sizeof(Motor)),
                                    A::const_xyz_aos(angles.data(), 3 * sizeof(T)),
                                    A::const_xyz_aos(origin.data(), 3 * sizeof(T)), result.size(), order),
                  MW_OK);
        return result;
    }

    static std::vector<T> euler_of(const std::vector<Motor> &motors, mw_euler_order order)
    {
        std::vector<T> angles(3 * motors.size()), positions(angles.size());
        EXPECT_EQ(C::convert_motor_to_euler_each(A::xyz_aos(angles.data(), 3 * sizeof(T)), A::xyz_aos(positions.data(), 3 * sizeof(T)),
                                    A::const_motors_aos(motors.data(), sizeof(Motor)), motors.size(), order),
                  MW_OK);
        return angles;
    }

    static void on_every_isa(const std::function<void()> &body)
    {
        for (const std::string &isa : running_isas()) {
            SCOPED_TRACE(isa);
            const ScopedIsa use(isa);
            body();
        }
    }
};

TYPED_TEST_SUITE(AnglesTest, Precisions, PrecisionName);

constexpr std::size_t batch = 4099;

// The rotation part of an exponential, whose component k is where a bivector about one axis has its angle.
TYPED_TEST(AnglesTest, ExpAboutOneAxisIsLibm)
{
    this->on_every_isa([&] {
        Random random(1);
        std::vector<TypeParam> bivectors(6 * batch);
        for (std::size_t i = 0; i < batch; ++i)
            bivectors[6 * i + i % 3] = this->number(random, this->smallest - 10, this->largest - 1);
        const auto motors = this->exp(bivectors);
        for (std::size_t i = 0; i < batch; ++i) {
            const long double angle = bivectors[6 * i + i % 3];
            Quaternion wanted = {std::cos(angle), 0, 0, 0};
            wanted[1 + i % 3] = std::sin(angle);
            ASSERT_LE(this->distance(motors[i], wanted), 3) << "angle " << std::hexfloat << angle;
            ASSERT_LE(this->length_error(motors[i]), 4) << "angle " << std::hexfloat << angle;
        }
    });
}

TYPED_TEST(AnglesTest, ExpAboutAnyAxisIsAUnitMotor)
{
    this->on_every_isa([&] {
        Random random(2);
        std::vector<TypeParam> bivectors(6 * batch);
        for (std::size_t i = 0; i < batch; ++i) {
            // Now and then every number has a size of its own.
            const int size = this->smallest + static_cast<int>(random.below(std::size_t(this->largest - this->smallest)));
            for (std::size_t k = 0; k < 6; ++k)
                bivectors[6 * i + k] = k > 2                ? this->number(random, -3, 3)
                                       : random.chance(4) ? this->number(random, this->smallest, this->largest - 1)
                                                          : this->number(random, size - 1, size - 1);
        }
        const auto motors = this->exp(bivectors);
        for (std::size_t i = 0; i < batch; ++i)
            ASSERT_LE(this->length_error(motors[i]), 4)
                << std::hexfloat << bivectors[6 * i] << ' ' << bivectors[6 * i + 1] << ' ' << bivectors[6 * i + 2];
    });
}

// The angle is that of the bivector to its last bit, and no further, for that is lost in |b|.
TYPED_TEST(AnglesTest, ExpAboutAnyAxisTurnsByTheAngle)
{
    this->on_every_isa([&] {
        Random random(3);
        std::vector<TypeParam> bivectors(6 * batch);
        const int digits = std::numeric_limits<TypeParam>::digits;
        for (std::size_t i = 0; i < batch; ++i) {
            const int size = static_cast<int>(random.below(std::size_t(digits))) - 4;
            for (std::size_t k = 0; k < 3; ++k)
                bivectors[6 * i + k] = this->number(random, size - 2, size);
        }
        const auto motors = this->exp(bivectors);
        for (std::size_t i = 0; i < batch; ++i) {
            const long double a = bivectors[6 * i], b = bivectors[6 * i + 1], c = bivectors[6 * i + 2];
            const long double angle = std::sqrt(a * a + b * b + c * c), f = std::sin(angle) / angle;
            const long double last_bit = std::ldexp(1.0L, std::ilogb(angle) - digits + 1) / this->epsilon;
            ASSERT_LE(this->distance(motors[i], {std::cos(angle), a * f, b * f, c * f}), 3 + last_bit)
                << std::hexfloat << a << ' ' << b << ' ' << c;
        }
    });
}

// The translation of a screw with a large angle: along the axis the whole way, around it next to nothing.
TYPED_TEST(AnglesTest, ALargeScrewGoesItsWayAlongTheAxis)
{
    this->on_every_isa([&] {
        Random random(4);
        std::vector<TypeParam> bivectors(6 * batch);
        for (std::size_t i = 0; i < batch; ++i) {
            bivectors[6 * i] = this->number(random, 30, this->largest - 1);  // about z, along which b3i goes
            bivectors[6 * i + 3] = this->number(random, 0, 2);
            bivectors[6 * i + 5] = this->number(random, 0, 2);
        }
        const auto motors = this->exp(bivectors);
        for (std::size_t i = 0; i < batch; ++i) {
            const auto &m = motors[i];
            const long double angle = bivectors[6 * i], way = bivectors[6 * i + 5], across = bivectors[6 * i + 3];
            const long double size = this->epsilon * (std::fabs(way) + std::fabs(across));
            const long double shrunk = across * std::sin(angle) / angle;  // of the part of the moment across the axis
            ASSERT_NEAR(double(m.b3i), double(way * std::cos(angle)), double(6 * size));
            ASSERT_NEAR(double(m.w), double(way * std::sin(angle)), double(6 * size));
            ASSERT_NEAR(double(m.b1i), double(shrunk), double(6 * size));
        }
    });
}

// A lane with a large angle takes a way of its own; its neighbours keep their bits.
TYPED_TEST(AnglesTest, NeighboursOfALargeAngleKeepTheirBits)
{
    this->on_every_isa([&] {
        Random random(5);
        constexpr std::size_t count = 64;
        std::vector<TypeParam> bivectors(6 * count);
        for (TypeParam &number : bivectors)
            number = this->number(random, -6, 0);
        const auto alone = this->exp(bivectors);
        for (std::size_t i = 0; i < count; i += 5)
            bivectors[6 * i + 1] = this->number(random, 40, this->largest - 1);
        const auto beside = this->exp(bivectors);
        for (std::size_t i = 0; i < count; ++i)
            if (i % 5 != 0) {
                EXPECT_EQ(std::memcmp(&alone[i], &beside[i], sizeof alone[i]), 0) << i;
            }
    });
}

TYPED_TEST(AnglesTest, InfinityAndNaNStayWhereTheyAre)
{
    this->on_every_isa([&] {
        std::vector<TypeParam> bivectors(6 * 32, TypeParam(0.5));
        const auto plain = this->exp(bivectors);
        bivectors[6 * 3] = std::numeric_limits<TypeParam>::infinity();
        bivectors[6 * 7 + 2] = std::numeric_limits<TypeParam>::quiet_NaN();
        bivectors[6 * 9 + 1] = std::numeric_limits<TypeParam>::max();
        const auto motors = this->exp(bivectors);
        EXPECT_TRUE(std::isnan(motors[3].s));
        EXPECT_TRUE(std::isnan(motors[7].s));
        EXPECT_LE(this->length_error(motors[9]), 4);
        for (std::size_t i : {2, 4, 6, 8, 10})
            EXPECT_EQ(std::memcmp(&plain[i], &motors[i], sizeof plain[i]), 0) << i;
    });
}

// ------------------------------------------------------------------------------------------------ axes, Euler angles

TYPED_TEST(AnglesTest, AxisAndAngleOfEverySize)
{
    this->on_every_isa([&] {
        Random random(6);
        std::vector<TypeParam> rotations(4 * batch);
        for (std::size_t i = 0; i < batch; ++i) {
            rotations[4 * i + i % 3] = 1;
            rotations[4 * i + 3] = random.chance(3) ? static_cast<TypeParam>(random.uniform(-1000, 1000))
                                                    : this->number(random, this->smallest, this->largest - 1);
        }
        const auto motors = this->of_axis_angle(rotations);
        for (std::size_t i = 0; i < batch; ++i) {
            const long double half = static_cast<long double>(rotations[4 * i + 3]) / 2;
            const long double sine = std::sin(half);
            const Quaternion wanted = {std::cos(half), i % 3 == 2 ? sine : 0, i % 3 == 1 ? -sine : 0,
                                       i % 3 == 0 ? sine : 0};
            ASSERT_LE(this->distance(motors[i], wanted), 3) << std::hexfloat << half;
            ASSERT_LE(this->length_error(motors[i]), 4) << std::hexfloat << half;
        }
    });
}

Quaternion product(const Quaternion &p, const Quaternion &q)  // Hamilton's, of w x y z
{
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

// About three axes, each turned by the rotations before it; as s b12 b13 b23.
template <class T>
Quaternion euler_rotation(const T *angles, mw_euler_order order)
{
    Quaternion turned = {1, 0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
        const long double half = static_cast<long double>(angles[k]) / 2;
        Quaternion next = {std::cos(half), 0, 0, 0};
        next[1 + axis_of(order, k)] = std::sin(half);
        turned = product(turned, next);
    }
    return {turned[0], turned[3], -turned[2], turned[1]};
}

TYPED_TEST(AnglesTest, EulerAnglesOfEverySize)
{
    this->on_every_isa([&] {
        Random random(7);
        for (int order = MW_EULER_XYZ; order <= int(MW_EULER_ZYZ); ++order) {
            const auto in_order = static_cast<mw_euler_order>(order);
            std::vector<TypeParam> angles(3 * 1000);
            for (TypeParam &angle : angles)
                angle = random.chance(3) ? static_cast<TypeParam>(random.uniform(-1000, 1000))
                                         : this->number(random, this->smallest, this->largest - 1);
            const auto motors = this->of_euler(angles, in_order);
            for (std::size_t i = 0; i < motors.size(); ++i) {
                ASSERT_LE(this->distance(motors[i], euler_rotation(&angles[3 * i], in_order)), 4)
                    << names_of_orders[order] << std::hexfloat << ' ' << angles[3 * i] << ' ' << angles[3 * i + 1] << ' '
                    << angles[3 * i + 2];
                ASSERT_LE(this->length_error(motors[i]), 4) << names_of_orders[order];
            }
        }
    });
}

// One answer for all: the third angle is 0, and the first has what both had.
TYPED_TEST(AnglesTest, AtGimbalLockTheThirdAngleIsZero)
{
    this->on_every_isa([&] {
        Random random(8);
        for (int order = MW_EULER_XYZ; order <= int(MW_EULER_ZYZ); ++order) {
            const auto in_order = static_cast<mw_euler_order>(order);
            const bool proper = order >= int(MW_EULER_XYX);
            const double pi = 3.14159265358979323846;
            const double locks[] = {proper ? 0 : -pi / 2, proper ? pi : pi / 2};
            std::vector<TypeParam> given;
            for (int i = 0; i < 500; ++i) {
                const double first = i < 200 ? 15 * (i % 24) * pi / 180 : random.uniform(-pi, pi);
                const double third = i < 200 ? 45 * (i % 5) * pi / 180 : random.uniform(-pi, pi);
                given.insert(given.end(), {TypeParam(first), TypeParam(locks[i % 2]), TypeParam(third)});
            }
            const auto motors = this->of_euler(given, in_order);
            const auto found = this->euler_of(motors, in_order);
            for (std::size_t i = 0; i < motors.size(); ++i) {
                const TypeParam *angles = &found[3 * i];
                ASSERT_EQ(angles[2], 0) << names_of_orders[order] << " of " << given[3 * i] << ' ' << given[3 * i + 2];
                const Quaternion back = euler_rotation(angles, in_order);
                Quaternion opposite = back;
                for (long double &c : opposite)
                    c = -c;
                ASSERT_LE(std::min(this->distance(motors[i], back), this->distance(motors[i], opposite)), 12)
                    << names_of_orders[order];
            }
        }
    });
}

// No angle is out of the bounds that the manual gives, not by rounding either.
TYPED_TEST(AnglesTest, AnglesStayWithinTheirBounds)
{
    this->on_every_isa([&] {
        using T = TypeParam;
        Random random(9);
        const T pi = static_cast<T>(3.14159265358979323846L), half_pi = static_cast<T>(3.14159265358979323846L / 2);
        // Half turns and what is near them, about all kinds of axes.
        std::vector<typename api<T>::motor> motors;
        const T close = static_cast<T>(0x1.cd129p-115);
        motors.push_back({-close, static_cast<T>(-0x1.410beep-1), static_cast<T>(-0x1.5f3e6ap-1),
                          static_cast<T>(0x1.79e4b8p-2), 0, 0, 0, 0});
        for (int i = 0; i < 4000; ++i) {
            double a[3], square = 0;
            for (double &c : a)
                c = random.uniform(-1, 1), square += c * c;
            const T r = static_cast<T>(1 / std::sqrt(square));
            const T s = random.chance(2) ? T(0) : this->number(random, -60, -20);
            motors.push_back({s, T(a[0]) * r, T(a[1]) * r, T(a[2]) * r, 0, 0, 0, 0});
        }
        std::vector<T> rotations(4 * motors.size()), positions(3 * motors.size()), screws(8 * motors.size());
        T *const r = rotations.data(), *const q = screws.data();
        const auto in = api<T>::const_motors_aos(motors.data(), sizeof motors[0]);
        ASSERT_EQ(api<T>::convert_motor_to_axis_angle_each({r, r + 1, r + 2, r + 3, 4 * sizeof(T)},
                                                     api<T>::xyz_aos(positions.data(), 3 * sizeof(T)), in, motors.size()),
                  MW_OK);
        ASSERT_EQ(api<T>::convert_motor_to_screw_each({q, q + 1, q + 2, q + 3, q + 4, q + 5, q + 6, q + 7, 8 * sizeof(T)}, in,
                                                motors.size()),
                  MW_OK);
        for (std::size_t i = 0; i < motors.size(); ++i) {
            ASSERT_LE(rotations[4 * i + 3], pi) << i;
            ASSERT_LE(screws[8 * i + 6], pi) << i;
        }
        for (int order = MW_EULER_XYZ; order <= int(MW_EULER_ZYZ); ++order) {
            const auto angles = this->euler_of(motors, static_cast<mw_euler_order>(order));
            for (std::size_t i = 0; i < motors.size(); ++i) {
                ASSERT_LE(std::fabs(angles[3 * i]), pi) << names_of_orders[order];
                ASSERT_LE(std::fabs(angles[3 * i + 2]), pi) << names_of_orders[order];
                ASSERT_LE(std::fabs(angles[3 * i + 1]), order >= int(MW_EULER_XYX) ? pi : half_pi) << names_of_orders[order];
            }
        }
    });
}

// ------------------------------------------------------------------------------------------------------------ powers

TYPED_TEST(AnglesTest, PowersOfEverySizeAreUnitMotors)
{
    this->on_every_isa([&] {
        using T = TypeParam;
        Random random(10);
        std::vector<typename api<T>::motor> motors, result(batch);
        std::vector<T> exponents;
        for (std::size_t i = 0; i < batch; ++i) {
            motors.push_back({T(0.8), T(0.6), 0, 0, 0, 0, 0, 0});
            exponents.push_back(i == 0 ? T(80925848) : this->number(random, this->smallest, this->largest - 3));
        }
        ASSERT_EQ(api<T>::power_motor_each(api<T>::motors_aos(result.data(), sizeof result[0]),
                                           api<T>::const_motors_aos(motors.data(), sizeof motors[0]), exponents.data(),
                                           sizeof(T), batch),
                  MW_OK);
        for (std::size_t i = 0; i < batch; ++i)
            ASSERT_LE(this->length_error(result[i]), 4) << std::hexfloat << exponents[i];
    });
}

}  // namespace
}  // namespace motorway::testing
