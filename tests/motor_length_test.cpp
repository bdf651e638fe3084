// Motors of every legal length: a power of two times a motor does the same, to the bit, where nothing of the result is out
// of range.

#include <cmath>
#include <cstring>
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

template <class T>
class MotorLengthTest : public ::testing::Test {
protected:
    using Motors = std::vector<typename api<T>::motor>;

    static constexpr std::size_t count = 37;
    // α = s² + ... of a motor of length 1 times 2^k is a normal number.
    static constexpr int longest = (std::numeric_limits<T>::max_exponent - 2) / 2,
                         shortest = (std::numeric_limits<T>::min_exponent + 2) / 2;

    static Motors unit_motors()
    {
        Random random(1);
        Motors motors;
        for (std::size_t i = 0; i < count; ++i) {
            double c[8];
            for (double &number : c)
                number = random.uniform(-1, 1);
            const double r = 1 / std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
            motors.push_back({T(c[0] * r), T(c[1] * r), T(c[2] * r), T(c[3] * r), T(50 * c[4]), T(50 * c[5]),
                              T(50 * c[6]), T(50 * c[7])});
        }
        return motors;
    }

    static Motors times(Motors motors, int power)
    {
        const T factor = std::ldexp(T(1), power);
        for (auto &m : motors)
            for (T *c : {&m.s, &m.b12, &m.b13, &m.b23, &m.b1i, &m.b2i, &m.b3i, &m.w})
                *c *= factor;
        return motors;
    }

    static auto in(const Motors &motors) { return api<T>::const_motors_aos(motors.data(), sizeof motors[0]); }
    static auto out(Motors &motors) { return api<T>::motors_aos(motors.data(), sizeof motors[0]); }

    template <class Numbers>
    static bool same_bits(const Numbers &a, const Numbers &b)
    {
        return std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    }

    // body(motors) on motors of all lengths is what it is on those of length 1, but for `degree` powers of the length.
    template <class Body>
    static void expect_same(const char *name, int degree, const Body &body)
    {
        for (const std::string &isa : running_isas()) {
            const ScopedIsa use(isa);
            const auto unit = body(unit_motors());
            for (int power : {shortest, shortest / 2, -12, 3, 11, longest / 2, longest}) {
                auto result = body(times(unit_motors(), power));
                scale(result, -degree * power);
                EXPECT_TRUE(same_bits(result, unit)) << name << " of motors times 2^" << power << " on " << isa;
            }
        }
    }

    static void scale(Motors &motors, int power) { motors = times(motors, power); }
    static void scale(std::vector<T> &, int) {}
};

TYPED_TEST_SUITE(MotorLengthTest, Precisions, PrecisionName);

TYPED_TEST(MotorLengthTest, Apply)
{
    using T = TypeParam;
    using A = api<T>;
    Random random(2);
    std::vector<T> points;
    for (std::size_t k = 0; k < 3 * this->count; ++k)
        points.push_back(static_cast<T>(random.magnitude(1, 1e3)));
    const std::size_t stride = 3 * sizeof(T);
    this->expect_same("apply_point_each", 0, [&](const auto &motors) {
        std::vector<T> moved(points.size());
        EXPECT_EQ(A::apply_point_each(A::xyz_aos(moved.data(), stride), this->in(motors),
                                      A::const_xyz_aos(points.data(), stride), this->count, 0),
                  MW_OK);
        return moved;
    });
    this->expect_same("apply_point_one", 0, [&](const auto &motors) {
        std::vector<T> moved(points.size());
        EXPECT_EQ(A::apply_point_one(A::xyz_aos(moved.data(), stride), &motors[0],
                                     A::const_xyz_aos(points.data(), stride), this->count, 0),
                  MW_OK);
        return moved;
    });
}

// Both the motor and what it moves: T^-1 M T is as long as M.
TEST(MotorLength, AppliedToAMotorAsLong)
{
    const mw_motor_f32 by = {std::ldexp(0.8f, 50), std::ldexp(0.6f, 50), 0, 0, 0, 0, 0, 0};
    const mw_motor_f32 moved = {std::ldexp(0.6f, 50), 0, 0, std::ldexp(0.8f, 50), 0, 0, 0, 0};
    for (const std::string &isa : running_isas()) {
        const ScopedIsa use(isa);
        mw_motor_f32 result{};
        ASSERT_EQ(mw_apply_motor_each_f32(&result, sizeof result,
                                          &by, sizeof by,
                                          &moved, sizeof moved, 1, 0),
                  MW_OK);
        EXPECT_EQ(result.s, std::ldexp(0.6f, 50)) << isa;
        // e23 turned by the angle whose half has the cosine 0.8, within a few roundings.
        EXPECT_NEAR(std::ldexp(result.b23, -50), 0.8 * (0.64 - 0.36), 1e-6) << isa;
        EXPECT_NEAR(std::ldexp(result.b13, -50), -0.8 * 2 * 0.8 * 0.6, 1e-6) << isa;
    }
}

TYPED_TEST(MotorLengthTest, TheGroup)
{
    using T = TypeParam;
    using A = api<T>;
    using Motor = typename A::motor;
    this->expect_same("inverse", -1, [&](const auto &motors) {
        std::vector<Motor> result(motors.size());
        EXPECT_EQ(A::inverse_motor_each(this->out(result), this->in(motors), motors.size()), MW_OK);
        return result;
    });
    this->expect_same("normalize", 0, [&](const auto &motors) {
        std::vector<Motor> result(motors.size());
        EXPECT_EQ(A::normalize_motor_each(this->out(result), this->in(motors), motors.size()), MW_OK);
        return result;
    });
    const auto others = this->unit_motors();
    this->expect_same("ratio", -1, [&](const auto &motors) {
        std::vector<Motor> result(motors.size());
        EXPECT_EQ(A::ratio_motor_each(this->out(result), this->in(motors), this->in(others), motors.size(), 0), MW_OK);
        return result;
    });
    this->expect_same("compose", 1, [&](const auto &motors) {
        std::vector<Motor> result(motors.size());
        EXPECT_EQ(A::compose_motor_each(this->out(result), this->in(motors), this->in(others), motors.size()), MW_OK);
        return result;
    });
    for (const auto log : {A::log_motor_each, A::log_principal_motor_each})
        this->expect_same("log", 0, [&](const auto &motors) {
            std::vector<T> result(6 * motors.size());
            T *const b = result.data();
            EXPECT_EQ(log({b, b + 1, b + 2, b + 3, b + 4, b + 5, 6 * sizeof(T)}, this->in(motors), motors.size(), 0),
                      MW_OK);
            return result;
        });
}

TYPED_TEST(MotorLengthTest, Conversions)
{
    using T = TypeParam;
    using C = api<T>;
    const auto positions_of = [](std::vector<T> &numbers, std::size_t size) {
        return api<T>::xyz_aos(numbers.data() + size - 3, size * sizeof(T));
    };
    this->expect_same("motor to pose", 0, [&](const auto &motors) {
        std::vector<T> result(7 * motors.size());
        T *const q = result.data();
        EXPECT_EQ(C::convert_motor_to_pose_each({q, q + 1, q + 2, q + 3, 7 * sizeof(T)}, positions_of(result, 7), this->in(motors),
                                   motors.size()),
                  MW_OK);
        return result;
    });
    this->expect_same("motor to axis and angle", 0, [&](const auto &motors) {
        std::vector<T> result(7 * motors.size());
        T *const q = result.data();
        EXPECT_EQ(C::convert_motor_to_axis_angle_each({q, q + 1, q + 2, q + 3, 7 * sizeof(T)}, positions_of(result, 7),
                                         this->in(motors), motors.size()),
                  MW_OK);
        return result;
    });
    for (const mw_euler_order order : {MW_EULER_XYZ, MW_EULER_ZYZ})
        this->expect_same("motor to Euler angles", 0, [&](const auto &motors) {
            std::vector<T> result(6 * motors.size());
            EXPECT_EQ(C::convert_motor_to_euler_each(api<T>::xyz_aos(result.data(), 6 * sizeof(T)), positions_of(result, 6),
                                        this->in(motors), motors.size(), order),
                      MW_OK);
            return result;
        });
    for (const mw_matrix_layout layout : all_matrix_layouts)
        this->expect_same("motor to matrix", 0, [&](const auto &motors) {
            std::vector<T> result(16 * motors.size());
            EXPECT_EQ(C::convert_motor_to_matrix_each({result.data(), 16 * sizeof(T), layout}, this->in(motors), motors.size()), MW_OK);
            return result;
        });
    this->expect_same("motor to translation", 0, [&](const auto &motors) {
        std::vector<T> result(3 * motors.size());
        EXPECT_EQ(C::convert_motor_to_translation_each(positions_of(result, 3), this->in(motors), motors.size()), MW_OK);
        return result;
    });
    this->expect_same("motor to screw", 0, [&](const auto &motors) {
        std::vector<T> result(8 * motors.size());
        T *const q = result.data();
        EXPECT_EQ(C::convert_motor_to_screw_each({q, q + 1, q + 2, q + 3, q + 4, q + 5, q + 6, q + 7, 8 * sizeof(T)},
                                    this->in(motors), motors.size()),
                  MW_OK);
        return result;
    });
}

}  // namespace
}  // namespace motorway::testing
