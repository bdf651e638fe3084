// Conversions there and back, what of them is exact, and the conventions by numbers. That each is accurate is tested
// with the kernels (convert_tester.h).

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "convert_api.h"
#include "kernel_tester.h"
#include "motors.h"
#include "precisions.h"
#include "screws.h"

namespace motorway::testing {
namespace {

template <class T>
using Numbers = std::vector<T>;

// What a library may hold instead of a motor: so many numbers an element, adjacent.
template <class T>
struct Representation {
    using Function = std::function<mw_status(const View<T> &out, const View<T> &in, std::size_t count)>;

    std::string name;
    std::size_t size;
    Function from_motor, to_motor;
    Numbers<T> identity;

    static Numbers<T> run(const Function &function, const Numbers<T> &in, std::size_t in_size, std::size_t out_size)
    {
        const std::size_t count = in.size() / in_size;
        Numbers<T> out(count * out_size, T(7));
        const View<T> to = packed_view(out.data(), out_size);
        EXPECT_EQ(function(to, packed_view(const_cast<T *>(in.data()), in_size), count), MW_OK);
        return out;
    }

    Numbers<T> of(const Numbers<T> &motors) const { return run(from_motor, motors, 8, size); }
    Numbers<T> motors(const Numbers<T> &in) const { return run(to_motor, in, size, 8); }
};

template <class T>
Representation<T> poses(const char *name, const std::array<std::size_t, 4> &places)
{
    using C = api<T>;
    return {name, 7,
            [places](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_pose_each(quaternions<typename C::xyzw>(out, places),
                                        vectors<typename api<T>::xyz>(out, 4), in.const_motors(), count);
            },
            [places](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_pose_to_motor_each(out.motors(), quaternions<typename C::const_xyzw>(in, places),
                                        vectors<typename api<T>::const_xyz>(in, 4), count);
            },
            places == x_first ? Numbers<T>{0, 0, 0, 1, 0, 0, 0} : Numbers<T>{1, 0, 0, 0, 0, 0, 0}};
}

template <class T>
Representation<T> dual(const char *name, const std::array<std::size_t, 4> &places)
{
    using C = api<T>;
    return {name, 8,
            [places](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_dual_quaternion_each(dual_quaternions<typename C::dual_quaternions>(out, places),
                                                   in.const_motors(), count);
            },
            [places](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_dual_quaternion_to_motor_each(
                    out.motors(), dual_quaternions<typename C::const_dual_quaternions>(in, places), count);
            },
            places == x_first ? Numbers<T>{0, 0, 0, 1, 0, 0, 0, 0} : Numbers<T>{1, 0, 0, 0, 0, 0, 0, 0}};
}

template <class T>
Representation<T> matrices(mw_matrix_layout layout, unsigned flags = MW_DEFAULT)
{
    using C = api<T>;
    const std::size_t size = numbers_of(layout);
    Numbers<T> identity(size);
    for (std::size_t k = 0; k < 3; ++k)
        identity[place_in_matrix(layout, k, k)] = 1;
    if (size == 16)
        identity[15] = 1;
    return {name_of(layout), size,
            [layout](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_matrix_each({out.component[0], out.stride, layout}, in.const_motors(), count);
            },
            [layout, flags](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_matrix_to_motor_each(out.motors(), {in.component[0], in.stride, layout}, count, flags, nullptr);
            },
            identity};
}

template <class T>
Representation<T> axes_and_angles()
{
    using C = api<T>;
    return {"axis and angle", 7,
            [](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_axis_angle_each(quaternions<typename C::xyzw>(out, x_first),
                                              vectors<typename api<T>::xyz>(out, 4), in.const_motors(), count);
            },
            [](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_axis_angle_to_motor_each(out.motors(), quaternions<typename C::const_xyzw>(in, x_first),
                                              vectors<typename api<T>::const_xyz>(in, 4), count);
            },
            {0, 0, 1, 0, 0, 0, 0}};
}

template <class T>
Representation<T> euler_angles(mw_euler_order order)
{
    using C = api<T>;
    return {std::string("Euler ") + names_of_orders[order], 6,
            [order](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_euler_each(vectors<typename api<T>::xyz>(out, 0), vectors<typename api<T>::xyz>(out, 3),
                                         in.const_motors(), count, order);
            },
            [order](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_euler_to_motor_each(out.motors(), vectors<typename api<T>::const_xyz>(in, 0),
                                         vectors<typename api<T>::const_xyz>(in, 3), count, order);
            },
            {0, 0, 0, 0, 0, 0}};
}

template <class T>
Representation<T> all_screws()
{
    using C = api<T>;
    return {"screw", 8,
            [](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_screw_each(screws<typename C::screws>(out), in.const_motors(), count);
            },
            [](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_screw_to_motor_each(out.motors(), screws<typename C::const_screws>(in), count);
            },
            {0, 0, 1, 0, 0, 0, 0, 0}};
}

template <class T>
Representation<T> rotors(T lambda)
{
    using C = api<T>;
    return {"rotor in units of " + std::to_string(lambda), 8,
            [lambda](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_motor_to_rotor_each(out.motors(), in.const_motors(), count, lambda);
            },
            [lambda](const View<T> &out, const View<T> &in, std::size_t count) {
                return C::convert_rotor_to_motor_each(out.motors(), in.const_motors(), count, lambda);
            },
            {1, 0, 0, 0, 0, 0, 0, 0}};
}

constexpr mw_euler_order order_of(std::size_t k) { return static_cast<mw_euler_order>(k); }

template <class T>
std::vector<Representation<T>> all_representations()
{
    std::vector<Representation<T>> all = {poses<T>("pose", x_first), poses<T>("pose, w first", w_first),
                                          dual<T>("dual quaternion", x_first),
                                          dual<T>("dual quaternion, w first", w_first)};
    for (mw_matrix_layout layout : all_matrix_layouts)
        all.push_back(matrices<T>(layout));
    all.push_back(axes_and_angles<T>());
    for (std::size_t k = 0; k < std::size(names_of_orders); ++k)
        all.push_back(euler_angles<T>(order_of(k)));
    all.push_back(all_screws<T>());
    for (double lambda : {0.25, 1.0, 3.0})
        all.push_back(rotors(static_cast<T>(lambda)));
    return all;
}

// ------------------------------------------------------------------------------------------------------------ motors

// Every kind of motor: exactly 1 and -1 and half turns, turns down to 1e-30 of either sign of s, far translations,
// those of `Regime`, which need not be normalised.
template <class T>
Numbers<T> all_motors()
{
    Random random(20080313);
    Numbers<T> motors = {1, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0};
    const auto add = [&](const reference::Element &motor) {
        motors.resize(motors.size() + 8);
        round_to(reference::motor(motor), &motors[motors.size() - 8]);
    };
    for (std::size_t k = 1; k < 4; ++k)
        for (int sign : {1, -1})
            for (int offset : {0, 1, 1000000}) {
                Numbers<T> half_turn(8);
                half_turn[k] = T(sign);
                half_turn[4] = half_turn[5] = T(offset);
                motors.insert(motors.end(), half_turn.begin(), half_turn.end());
            }
    for (int exponent = 0; exponent <= 30; ++exponent)
        for (int sign : {1, -1})
            add(reference::Element(reference::Real(sign)) *
                random_screw(random, std::pow(10.0L, static_cast<long double>(-exponent)), 0.1, 10));
    for (int k = 0; k < 20; ++k)
        add(random_screw(random, 3 - k / 10.0L, 1e5, 1e7));
    for (int k = 0; k < 400; ++k) {
        motors.resize(motors.size() + 8);
        const Regime regime = any_regime(random);
        draw_motor(random, regime == Regime::tiny_offset ? Regime::general : regime, &motors[motors.size() - 8]);
    }
    return motors;
}

template <class T>
std::string text_of(const T *numbers, std::size_t count)
{
    std::ostringstream text;
    text << std::setprecision(std::numeric_limits<T>::max_digits10);
    for (std::size_t k = 0; k < count; ++k)
        text << numbers[k] << " ";
    return text.str();
}

// Whether two motors are the same motion: one is ± the other when both are normalised, the rotation within
// `tolerance`, the translation relative to what it is the sum of.
template <class T>
void expect_same_motion(const T *a, const T *b, long double tolerance, const std::string &what)
{
    const reference::Motor x = reference::normalize(exact_motor(a)), y = reference::normalize(exact_motor(b));
    long double between = 0;
    for (std::size_t k = 0; k < 4; ++k)
        between += static_cast<long double>(x[k] * y[k]);
    const reference::Real sign(between < 0 ? -1 : 1);
    const long double size = std::max({length_of(x, 4, 8), length_of(a, 4, 8) / length_of(a, 0, 4),
                                       length_of(b, 4, 8) / length_of(b, 0, 4)});
    for (std::size_t k = 0; k < 8; ++k) {
        const long double off = std::abs(static_cast<long double>(x[k] - sign * y[k]));
        EXPECT_LE(off, tolerance * (k < 4 ? 1 : size) + 16 * underflow<T>)
            << what << ", component " << k << " of " << text_of(a, 8) << "and " << text_of(b, 8);
    }
}

template <class T>
class ConvertTest : public ::testing::Test {
protected:
    static Numbers<T> moved(const Numbers<T> &motors, const Numbers<T> &points)
    {
        Numbers<T> out(points.size());
        const View<T> in = packed_view(const_cast<T *>(points.data()), 3);
        EXPECT_EQ(api<T>::apply_point_each(packed_view(out.data(), 3).xyz(),
                                           packed_view(const_cast<T *>(motors.data()), 8).const_motors(),
                                           in.const_xyz(), points.size() / 3, MW_DEFAULT),
                  MW_OK);
        return out;
    }

    static bool same_bits(const Numbers<T> &a, const Numbers<T> &b)
    {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
    }

    static void expect_near(const Numbers<T> &got, const std::vector<double> &expected, const std::string &what)
    {
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t k = 0; k < got.size(); ++k)
            EXPECT_NEAR(static_cast<double>(got[k]), expected[k], 4 * static_cast<double>(epsilon<T>) *
                                                                      std::max(1.0, std::abs(expected[k])))
                << what << ", number " << k;
    }
};

TYPED_TEST_SUITE(ConvertTest, Precisions, PrecisionName);

// ------------------------------------------------------------------------------------------------------- round trips

// There and back each have a few epsilons; three angles as many each.
TYPED_TEST(ConvertTest, motors_come_back)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    for (const auto &representation : all_representations<T>()) {
        const Numbers<T> back = representation.motors(representation.of(motors));
        for (std::size_t k = 0; k < motors.size(); k += 8)
            expect_same_motion(&motors[k], &back[k], 16 * epsilon<T>, representation.name);
    }
}

TYPED_TEST(ConvertTest, motors_that_come_back_move_points_alike)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    Random random(3);
    Numbers<T> points(motors.size() / 8 * 3);
    for (T &coordinate : points)
        coordinate = static_cast<T>(random.uniform(-10, 10));
    const Numbers<T> expected = this->moved(motors, points);
    for (const auto &representation : all_representations<T>()) {
        const Numbers<T> got = this->moved(representation.motors(representation.of(motors)), points);
        for (std::size_t k = 0; k < points.size(); k += 3) {
            const T *motor = &motors[k / 3 * 8];
            const long double size =
                length_of(&points[k], 0, 3) + 2 * length_of(motor, 4, 8) / length_of(motor, 0, 4);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(static_cast<double>(got[k + c]), static_cast<double>(expected[k + c]),
                            static_cast<double>(64 * epsilon<T> * size))
                    << representation.name << " of " << text_of(motor, 8);
        }
    }
}

// Exactly, in all representations.
TYPED_TEST(ConvertTest, the_identity)
{
    using T = TypeParam;
    const Numbers<T> identity = {1, 0, 0, 0, 0, 0, 0, 0};
    for (const auto &representation : all_representations<T>()) {
        EXPECT_EQ(representation.of(identity), representation.identity) << representation.name;
        EXPECT_EQ(representation.motors(representation.identity), identity) << representation.name;
    }
}

// Those from which the motor cannot be told from its negative, and those that keep it.
TYPED_TEST(ConvertTest, minus_one)
{
    using T = TypeParam;
    const Numbers<T> one = {1, 0, 0, 0, 0, 0, 0, 0}, minus_one = {-1, 0, 0, 0, 0, 0, 0, 0};
    for (const auto &representation : all_representations<T>()) {
        const bool keeps_sign = representation.name.find("pose") == 0 || representation.name.find("dual") == 0 ||
                                representation.name.find("rotor") == 0;
        const Numbers<T> back = representation.motors(representation.of(minus_one));
        if (representation.name.find("Euler") == 0)
            expect_same_motion(one.data(), back.data(), 4 * epsilon<T>, representation.name);
        else
            EXPECT_EQ(back, keeps_sign ? minus_one : one) << representation.name;
    }
}

TYPED_TEST(ConvertTest, dual_quaternions_are_the_same_bits)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    for (const auto &representation : {dual<T>("", x_first), dual<T>("", w_first)})
        EXPECT_TRUE(this->same_bits(representation.motors(representation.of(motors)), motors));
}

TYPED_TEST(ConvertTest, w_first_gives_the_same_bits)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    const Representation<T> pairs[][2] = {{poses<T>("", x_first), poses<T>("", w_first)},
                                          {dual<T>("", x_first), dual<T>("", w_first)}};
    for (const auto &[usual, other] : pairs) {
        const Numbers<T> expected = usual.of(motors), got = other.of(motors);
        Numbers<T> turned(got.size());
        for (std::size_t k = 0; k < got.size(); ++k) {
            const std::size_t place = k % usual.size, first = place / 4 * 4;
            const bool in_quaternion = usual.size == 8 || place < 4;
            turned[k] = got[k - place + (in_quaternion ? first + w_first[place - first] : place)];
        }
        EXPECT_TRUE(this->same_bits(turned, expected));
        EXPECT_TRUE(this->same_bits(other.motors(got), usual.motors(expected)));
    }
}

TYPED_TEST(ConvertTest, quaternions_of_any_length_make_motors_of_that_length)
{
    using T = TypeParam;
    const Representation<T> pose = poses<T>("pose", x_first);
    for (double factor : {-1.0, 0.125, 3.0, -1000.0}) {
        const T f = static_cast<T>(factor);
        const Numbers<T> unit = {T(0.5), T(-0.5), T(0.5), T(0.5), 1, -2, 3};
        Numbers<T> scaled = unit;
        for (std::size_t k = 0; k < 4; ++k)
            scaled[k] *= f;
        const Numbers<T> motor = pose.motors(unit), got = pose.motors(scaled);
        for (std::size_t k = 0; k < 8; ++k)
            EXPECT_EQ(got[k], f * motor[k]);
        const Numbers<T> back = pose.of(got);
        for (std::size_t k = 0; k < 7; ++k)
            EXPECT_NEAR(back[k], (k < 4 && factor < 0 ? -1 : 1) * unit[k], 16 * epsilon<T>);
    }
}

TYPED_TEST(ConvertTest, poses_come_back)
{
    using T = TypeParam;
    Random random(5);
    Numbers<T> in;
    for (int k = 0; k < 500; ++k) {
        T motor[8];
        draw_unit_motor(random, motor);
        in.insert(in.end(), motor, motor + 4);
        for (int c = 0; c < 3; ++c)
            in.push_back(static_cast<T>(random.uniform(-100, 100)));
    }
    const Representation<T> pose = poses<T>("pose", x_first);
    const Numbers<T> back = pose.of(pose.motors(in));
    for (std::size_t k = 0; k < in.size(); ++k) {
        const long double size = k % 7 < 4 ? 1 : length_of(&in[k / 7 * 7], 4, 7);
        EXPECT_NEAR(back[k], in[k], 8 * epsilon<T> * size);
    }
}

// Only angles in [0, π] come back.
TYPED_TEST(ConvertTest, axes_and_angles_come_back)
{
    using T = TypeParam;
    Random random(6);
    Numbers<T> in;
    for (int k = 0; k < 500; ++k) {
        in.resize(in.size() + 3);
        round_to(draw_axis(random), &in[in.size() - 3]);
        in.push_back(static_cast<T>(k % 2 ? random.uniform(1e-3, 3.14) : std::abs(random.magnitude(1e-30, 1))));
        for (int c = 0; c < 3; ++c)
            in.push_back(static_cast<T>(random.uniform(-100, 100)));
    }
    const Representation<T> representation = axes_and_angles<T>();
    const Numbers<T> back = representation.of(representation.motors(in));
    for (std::size_t k = 0; k < in.size(); k += 7)
        for (std::size_t c = 0; c < 7; ++c) {
            const long double size = c < 3 ? 1 : c == 3 ? in[k + 3] : length_of(&in[k], 4, 7);
            EXPECT_NEAR(back[k + c], in[k + c], 12 * epsilon<T> * size) << text_of(&in[k], 7);
        }
}

TYPED_TEST(ConvertTest, matrices_come_back)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    for (mw_matrix_layout layout : all_matrix_layouts) {
        const Representation<T> representation = matrices<T>(layout);
        const Numbers<T> in = representation.of(motors), back = representation.of(representation.motors(in));
        for (std::size_t k = 0; k < in.size(); k += representation.size) {
            const long double moved = std::hypot(in[k + place_in_matrix(layout, 0, 3)],
                                                 in[k + place_in_matrix(layout, 1, 3)],
                                                 in[k + place_in_matrix(layout, 2, 3)]);
            for (std::size_t c = 0; c < representation.size; ++c)
                EXPECT_NEAR(back[k + c], in[k + c], 16 * epsilon<T> * (1 + moved)) << representation.name;
        }
    }
}

// ------------------------------------------------------------------------------------------------------ Euler angles

using Rotation = std::array<std::array<double, 3>, 3>;

Rotation operator*(const Rotation &a, const Rotation &b)
{
    Rotation product{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k)
                product[r][c] += a[r][k] * b[k][c];
    return product;
}

// The matrices of every textbook.
Rotation about(char axis, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    switch (axis) {
    case 'x': return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
    case 'y': return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
    default: return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
    }
}

template <class T>
Rotation rotation_of(const Numbers<T> &motor)
{
    const Numbers<T> matrix = matrices<T>(MW_MATRIX_ROWS_3X4).of(motor);
    Rotation rotation;
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            rotation[r][c] = static_cast<double>(matrix[4 * r + c]);
    return rotation;
}

template <class T>
void expect_rotation(const Rotation &got, const Rotation &expected, const std::string &what)
{
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[r][c], expected[r][c], static_cast<double>(16 * epsilon<T>)) << what << " " << r << c;
}

// Angles anywhere, with the second at, next to and far from where the first and the third are about the same axis.
template <class T>
std::vector<Numbers<T>> all_angles(std::size_t order)
{
    Random random(order + 1);
    std::vector<Numbers<T>> all;
    const bool is_proper = order >= MW_EULER_XYX;
    const double half_pi = static_cast<double>(pi / 2);
    for (double lock : {is_proper ? 0.0 : half_pi, is_proper ? 2 * half_pi : -half_pi})
        for (double off : {0.0, 1e-30, 1e-12, -1e-12, 1e-7, -1e-7, 1e-4, -1e-4, 0.01, -0.01})
            all.push_back({static_cast<T>(random.uniform(-3, 3)), static_cast<T>(lock + off),
                           static_cast<T>(random.uniform(-3, 3)), 1, 2, 3});
    for (int k = 0; k < 200; ++k)
        all.push_back({static_cast<T>(random.uniform(-10, 10)), static_cast<T>(random.uniform(-10, 10)),
                       static_cast<T>(random.uniform(-10, 10)), 1, 2, 3});
    return all;
}

TYPED_TEST(ConvertTest, euler_angles_are_the_product_of_three_matrices)
{
    using T = TypeParam;
    for (std::size_t k = 0; k < std::size(names_of_orders); ++k) {
        const Representation<T> euler = euler_angles<T>(order_of(k));
        const char *axes = names_of_orders[k];
        for (const Numbers<T> &angles : all_angles<T>(k)) {
            const Rotation expected =
                about(axes[0], angles[0]) * about(axes[1], angles[1]) * about(axes[2], angles[2]);
            const Numbers<T> motor = euler.motors(angles), back = euler.of(motor);
            expect_rotation<T>(rotation_of(motor), expected, euler.name);
            expect_rotation<T>(about(axes[0], back[0]) * about(axes[1], back[1]) * about(axes[2], back[2]), expected,
                               euler.name + " and back " + text_of(angles.data(), 3));
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(back[3 + c], angles[3 + c], 32 * epsilon<T>) << euler.name;
        }
    }
}

TYPED_TEST(ConvertTest, euler_angles_are_in_their_ranges)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    const T half_turn = static_cast<T>(pi) * (1 + 2 * std::numeric_limits<T>::epsilon());
    for (std::size_t k = 0; k < std::size(names_of_orders); ++k) {
        const bool is_proper = k >= MW_EULER_XYX;
        const Numbers<T> angles = euler_angles<T>(order_of(k)).of(motors);
        for (std::size_t i = 0; i < angles.size(); i += 6) {
            EXPECT_LE(std::abs(angles[i]), half_turn);
            EXPECT_LE(std::abs(angles[i + 2]), half_turn);
            EXPECT_GE(angles[i + 1], is_proper ? 0 : -half_turn / 2);
            EXPECT_LE(angles[i + 1], is_proper ? half_turn : half_turn / 2);
        }
    }
}

// By quaternions of which a sum and a difference are exactly 0: in every order the third angle is 0, and the rotation
// is that of the quaternion.
TYPED_TEST(ConvertTest, euler_angles_at_gimbal_lock_have_a_third_angle_of_0)
{
    using T = TypeParam;
    for (std::size_t order = 0; order < std::size(names_of_orders); ++order) {
        const std::size_t i = axis_of(order_of(order), 0), j = axis_of(order_of(order), 1), k = 3 - i - j;
        const bool is_proper = order >= MW_EULER_XYX;
        const T hand = j == (i + 1) % 3 ? T(1) : T(-1), a = T(0.75), b = T(0.25);
        for (T sign : {T(1), T(-1)}) {
            T q[4] = {};  // x y z w
            if (is_proper) {
                q[sign > 0 ? 3 : j] = a;
                q[sign > 0 ? i : k] = b;
            } else {
                q[3] = a, q[j] = sign * a, q[i] = b, q[k] = sign * hand * b;
            }
            const Representation<T> euler = euler_angles<T>(order_of(order));
            const Numbers<T> motor = poses<T>("", x_first).motors({q[0], q[1], q[2], q[3], 0, 0, 0});
            const Numbers<T> angles = euler.of(motor);
            EXPECT_EQ(angles[2], T(0)) << euler.name;
            EXPECT_NE(angles[0], T(0)) << euler.name;
            const T locked = is_proper ? (sign > 0 ? T(0) : static_cast<T>(pi)) : sign * static_cast<T>(pi / 2);
            EXPECT_NEAR(angles[1], locked, 4 * epsilon<T>) << euler.name;
            expect_same_motion(motor.data(), euler.motors(angles).data(), 8 * epsilon<T>, euler.name);
        }
    }
}

// ------------------------------------------------------------------------------------------------------------ screws

// A screw, and the motor of the library's own rotation and translation.
TYPED_TEST(ConvertTest, screws_are_rotations_and_translations)
{
    using T = TypeParam;
    using A = api<T>;
    Random random(8);
    const Representation<T> screw = all_screws<T>();
    for (int k = 0; k < 500; ++k) {
        T axis[3], point[3];
        round_to(draw_axis(random), axis);
        for (T &coordinate : point)
            coordinate = static_cast<T>(random.uniform(-5, 5));
        const T angle = static_cast<T>(random.uniform(-3, 3));
        const T distance = k % 3 == 0 ? T(0) : static_cast<T>(random.uniform(-5, 5));
        const T way[3] = {distance * axis[0], distance * axis[1], distance * axis[2]};
        Numbers<T> rotation(8), translation(8), product(8);
        const auto motor = [](Numbers<T> &numbers) { return reinterpret_cast<typename A::motor *>(numbers.data()); };
        const auto view = [](Numbers<T> &numbers) { return packed_view(numbers.data(), 8); };
        ASSERT_EQ(A::rotation(motor(rotation), axis, angle, point), MW_OK);
        ASSERT_EQ(A::translation(motor(translation), way), MW_OK);
        const Numbers<T> got =
            screw.motors({axis[0], axis[1], axis[2], point[0], point[1], point[2], angle, distance});
        ASSERT_EQ(A::compose_motor_each(view(product).motors(), view(rotation).const_motors(),
                                        view(translation).const_motors(), 1),
                  MW_OK);
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_NEAR(got[c], product[c], 64 * epsilon<T>) << "in order";
        ASSERT_EQ(A::compose_motor_each(view(product).motors(), view(translation).const_motors(),
                                        view(rotation).const_motors(), 1),
                  MW_OK);
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_NEAR(got[c], product[c], 64 * epsilon<T>) << "the translation first";
    }
}

// Of angles in [0, π] and with the point of the axis that is nearest to the origin.
TYPED_TEST(ConvertTest, screws_come_back)
{
    using T = TypeParam;
    const Representation<T> screw = all_screws<T>();
    for (double far : {0.0, 1.0, 1e6})
        for (double angle : {1e-3, 0.5, 1.5, 3.0})
            for (double distance : {0.0, 2.0, -3.0}) {
                const T p = static_cast<T>(far), a = static_cast<T>(angle), d = static_cast<T>(distance);
                const Numbers<T> in = {T(0.6), 0, T(0.8), T(0.8) * p, p, T(-0.6) * p, a, d};
                const Numbers<T> back = screw.of(screw.motors(in));
                for (std::size_t k = 0; k < 8; ++k) {
                    const double size = k < 3 ? 1 : k < 6 ? (far + 3) / angle : k == 6 ? angle : 3 + 2 * far;
                    EXPECT_NEAR(back[k], in[k], 16 * static_cast<double>(epsilon<T>) * size)
                        << "number " << k << " of " << text_of(in.data(), 8);
                }
            }
}

TYPED_TEST(ConvertTest, a_translation_is_a_screw_without_angle)
{
    using T = TypeParam;
    const Representation<T> screw = all_screws<T>();
    EXPECT_EQ(screw.of({1, 0, 0, 0, 0, T(1.5), 0, 0}), (Numbers<T>{0, 1, 0, 0, 0, 0, 0, 3}));
    EXPECT_EQ(screw.of({-1, 0, 0, 0, 0, T(1.5), 0, 0}), (Numbers<T>{0, -1, 0, 0, 0, 0, 0, 3}));
    const T angle = std::ldexp(T(1), -62);  // of which half is b12
    EXPECT_EQ(screw.of({1, angle, 0, 0, 2, 0, 0, 0}), (Numbers<T>{1, 0, 0, 0, 0, 0, 0, 4}));
}

// However short it is.
TYPED_TEST(ConvertTest, tiny_translations_are_screws_along_themselves)
{
    using T = TypeParam;
    const Representation<T> screw = all_screws<T>();
    for (int exponent = -30; exponent <= 30; exponent += 5) {
        const T way = static_cast<T>(std::pow(10.0, exponent));
        const Numbers<T> got = screw.of({1, 0, 0, 0, way * T(0.3), way * T(0.4), 0, 0});
        EXPECT_NEAR(got[0], T(0.6), 4 * epsilon<T>) << way;
        EXPECT_NEAR(got[1], T(0.8), 4 * epsilon<T>) << way;
        EXPECT_EQ(got[6], T(0)) << way;
        EXPECT_NEAR(got[7] / way, T(1), 8 * epsilon<T>) << way;
    }
}

// The motor of an angle is that of half of it, so that θ and θ + 2π make S and -S, as exponentials do.
TYPED_TEST(ConvertTest, angles_beyond_a_half_turn_go_on)
{
    using T = TypeParam;
    const T angle = 4;
    const T c = std::cos(angle / 2), s = std::sin(angle / 2);
    for (const Numbers<T> &motor :
         {axes_and_angles<T>().motors({0, 0, 1, angle, 0, 0, 0}),
          all_screws<T>().motors({0, 0, 1, 0, 0, 0, angle, 0}),
          euler_angles<T>(MW_EULER_ZYX).motors({angle, 0, 0, 0, 0, 0})}) {
        EXPECT_NEAR(motor[0], c, 4 * epsilon<T>);
        EXPECT_NEAR(motor[1], s, 4 * epsilon<T>);
    }
}

// ------------------------------------------------------------------------------------------------------------ rotors

// R x R̃ in Wareham and Lasenby's algebra is what S̄ x S is in the paper's: with λ = 1 they differ by the reverse
// alone, and with another lengths are divided by it.
TYPED_TEST(ConvertTest, rotors_act_from_the_left)
{
    using T = TypeParam;
    Random random(12);
    for (double lambda : {0.25, 1.0, 3.0}) {
        const Representation<T> rotor = rotors(static_cast<T>(lambda));
        for (int k = 0; k < 200; ++k) {
            Numbers<T> motor(8);
            draw_motor(random, Regime::general, motor.data());
            const reference::Element r = reference::element(exact_motor(rotor.of(motor).data()));
            const reference::Vector3 point = random_vector(random, 0.1, 10);
            const reference::Real unit(lambda), one(1);
            // The point p / λ with lengths in units of λ, moved by R p R̃.
            const reference::Motor by = reference::motor(reference::reverse(r));
            const reference::Vector3 image =
                reference::apply_point(by, {point[0] / unit, point[1] / unit, point[2] / unit});
            const reference::Vector3 expected = reference::apply_point(exact_motor(motor.data()), point);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(static_cast<double>(static_cast<long double>(unit * image[c])),
                            static_cast<double>(static_cast<long double>(expected[c])),
                            static_cast<double>(32 * epsilon<T>));
        }
    }
}

TYPED_TEST(ConvertTest, rotors_by_numbers)
{
    using T = TypeParam;
    const Numbers<T> motor = {1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_EQ(rotors(T(0.25)).of(motor), (Numbers<T>{1, -2, -3, -4, -20, -24, -28, 32}));
    EXPECT_EQ(rotors(T(0.25)).motors({1, -2, -3, -4, -20, -24, -28, 32}), motor);
    EXPECT_EQ(rotors(T(1)).of(motor), (Numbers<T>{1, -2, -3, -4, -5, -6, -7, 8}));
}

// ------------------------------------------------------------------------------------------- conventions, by numbers

// A quarter turn about z takes x to y; then the translation by (1, 2, 3).
TYPED_TEST(ConvertTest, a_quarter_turn_about_z)
{
    using T = TypeParam;
    const double h = std::sqrt(0.5), quarter = static_cast<double>(pi / 2);
    const Numbers<T> motor = poses<T>("", x_first).motors({0, 0, static_cast<T>(h), static_cast<T>(h), 1, 2, 3});
    this->expect_near(motor, {h, h, 0, 0, 1.5 * h, h / 2, 1.5 * h, 1.5 * h}, "motor");
    this->expect_near(matrices<T>(MW_MATRIX_ROWS_3X4).of(motor), {0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3}, "rows 3x4");
    this->expect_near(matrices<T>(MW_MATRIX_ROWS_4X4).of(motor), {0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1},
                      "rows 4x4");
    this->expect_near(matrices<T>(MW_MATRIX_COLUMNS_3X4).of(motor), {0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 2, 3},
                      "columns 3x4");
    this->expect_near(matrices<T>(MW_MATRIX_COLUMNS_4X4).of(motor), {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1},
                      "columns 4x4");
    this->expect_near(axes_and_angles<T>().of(motor), {0, 0, 1, quarter, 1, 2, 3}, "axis and angle");
    this->expect_near(euler_angles<T>(MW_EULER_ZYX).of(motor), {quarter, 0, 0, 1, 2, 3}, "Euler angles");
    this->expect_near(dual<T>("", x_first).of(motor), {0, 0, h, h, 1.5 * h, h / 2, 1.5 * h, -1.5 * h}, "dual");
    // (-½, 3/2) stays where it is.
    this->expect_near(all_screws<T>().of(motor), {0, 0, 1, -0.5, 1.5, 0, quarter, 3}, "screw");
}

TYPED_TEST(ConvertTest, quarter_turns_about_x_and_y)
{
    using T = TypeParam;
    const T h = static_cast<T>(std::sqrt(0.5));
    const Representation<T> pose = poses<T>("", x_first), matrix = matrices<T>(MW_MATRIX_ROWS_3X4);
    this->expect_near(matrix.of(pose.motors({h, 0, 0, h, 0, 0, 0})), {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}, "x");
    this->expect_near(matrix.of(pose.motors({0, h, 0, h, 0, 0, 0})), {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0}, "y");
}

TYPED_TEST(ConvertTest, translations)
{
    using T = TypeParam;
    using C = api<T>;
    Numbers<T> in = {1, -2, 3}, motor(8), back(3);
    const View<T> motors = packed_view(motor.data(), 8);
    ASSERT_EQ(C::convert_translation_to_motor_each(motors.motors(), packed_view(in.data(), 3).const_xyz(), 1), MW_OK);
    EXPECT_EQ(motor, (Numbers<T>{1, 0, 0, 0, T(0.5), -1, T(1.5), 0}));
    ASSERT_EQ(C::convert_motor_to_translation_each(packed_view(back.data(), 3).xyz(), motors.const_motors(), 1), MW_OK);
    EXPECT_EQ(back, in);
}

// ---------------------------------------------------------------------------------------------------------- matrices

TYPED_TEST(ConvertTest, the_last_row_is_written_and_makes_no_difference_to_the_motor)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    const T nan = std::numeric_limits<T>::quiet_NaN();
    for (mw_matrix_layout layout : {MW_MATRIX_ROWS_4X4, MW_MATRIX_COLUMNS_4X4}) {
        const Numbers<T> in = matrices<T>(layout).of(motors);
        Numbers<T> spoilt = in;
        for (std::size_t k = 0; k < in.size(); k += 16)
            for (std::size_t column = 0; column < 4; ++column) {
                T &number = spoilt[k + place_in_matrix(layout, 3, column)];
                EXPECT_EQ(number, column == 3 ? T(1) : T(0));
                number = nan;
            }
        const Representation<T> not_looked_at = matrices<T>(layout, MW_ROTATION_MATRICES);
        EXPECT_TRUE(this->same_bits(matrices<T>(layout).motors(in), not_looked_at.motors(spoilt)));
    }
}

// Of a half turn either sign is right.
TYPED_TEST(ConvertTest, motors_of_matrices_have_no_negative_s)
{
    using T = TypeParam;
    for (unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_NEAREST_ROTATION)}) {
        const Representation<T> representation = matrices<T>(MW_MATRIX_ROWS_3X4, flags);
        const Numbers<T> motors = representation.motors(representation.of(all_motors<T>()));
        for (std::size_t k = 0; k < motors.size(); k += 8) {
            EXPECT_GE(motors[k], T(0));
            EXPECT_NEAR(length_of(&motors[k], 0, 4), 1, 4 * epsilon<T>);
        }
    }
}

template <class T>
Numbers<T> random_matrices(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    Numbers<T> motors(8 * count);
    for (std::size_t k = 0; k < count; ++k)
        draw_motor(random, k % 4 ? Regime::general : Regime::half_turn, &motors[8 * k]);
    return matrices<T>(MW_MATRIX_ROWS_3X4).of(motors);
}

// M times a symmetric matrix with eigenvalues from 0.3 to 3 and one of 0.2 or -0.2.
template <class T>
void stretch(T *matrix, Random &random, double last_sign)
{
    Numbers<double> frame(8);
    draw_motor(random, Regime::rotation, frame.data());
    const Rotation q = rotation_of(frame);
    double sizes[3];
    for (double &size : sizes)
        size = random.uniform(0.3, 3);
    sizes[2] = 0.2 * last_sign;
    double stretched[3][3] = {};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    stretched[r][c] += static_cast<double>(matrix[4 * r + i]) * q[i][k] * sizes[k] * q[c][k];
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            matrix[4 * r + c] = static_cast<T>(stretched[r][c]);
}

TYPED_TEST(ConvertTest, the_rotation_nearest_to_a_rotation_is_itself)
{
    using T = TypeParam;
    const Numbers<T> in = random_matrices<T>(500, 21);
    const Numbers<T> expected = matrices<T>(MW_MATRIX_ROWS_3X4).motors(in);
    const Numbers<T> nearest = matrices<T>(MW_MATRIX_ROWS_3X4, MW_NEAREST_ROTATION).motors(in);
    for (std::size_t k = 0; k < expected.size(); k += 8)
        expect_same_motion(&expected[k], &nearest[k], 8 * epsilon<T>, "nearest");
}

// The polar decomposition; of a matrix with a column all but lost, so that rounding it matters five times as much.
TYPED_TEST(ConvertTest, the_rotation_nearest_to_a_stretched_one_is_the_rotation)
{
    using T = TypeParam;
    Random random(22);
    const Numbers<T> rotations = random_matrices<T>(300, 23);
    for (mw_matrix_layout layout : all_matrix_layouts) {
        const Representation<T> by_layout = matrices<T>(layout, MW_NEAREST_ROTATION);
        for (std::size_t k = 0; k < rotations.size(); k += 12) {
            const Numbers<T> rotation(&rotations[k], &rotations[k] + 12);
            Numbers<T> rows = rotation, in = by_layout.identity;
            stretch(rows.data(), random, 1);
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < 4; ++c)
                    in[place_in_matrix(layout, r, c)] = rows[4 * r + c];
            expect_same_motion(matrices<T>(MW_MATRIX_ROWS_3X4).motors(rotation).data(), by_layout.motors(in).data(),
                               64 * epsilon<T>, by_layout.name);
        }
    }
}

// The sum of the squares of the differences.
template <class T>
double distance(const Rotation &rotation, const T *matrix)
{
    double sum = 0;
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            sum += std::pow(rotation[r][c] - static_cast<double>(matrix[4 * r + c]), 2);
    return sum;
}

TYPED_TEST(ConvertTest, no_rotation_is_nearer_to_a_reflection)
{
    using T = TypeParam;
    Random random(24);
    const Representation<T> representation = matrices<T>(MW_MATRIX_ROWS_3X4, MW_NEAREST_ROTATION);
    Numbers<T> in = random_matrices<T>(200, 25);
    for (std::size_t k = 0; k < in.size(); k += 12) {
        stretch(&in[k], random, -1);
        const Numbers<T> motor = representation.motors(Numbers<T>(&in[k], &in[k] + 12));
        const Rotation nearest = rotation_of(Numbers<double>(motor.begin(), motor.end()));
        const double least = distance(nearest, &in[k]) * (1 + 4 * static_cast<double>(epsilon<T>));
        for (char axis : {'x', 'y', 'z'})
            for (double angle : {1e-2, -1e-2, 0.5, -0.5, 3.0}) {
                EXPECT_GE(distance(nearest * about(axis, angle), &in[k]), least) << axis << angle;
                EXPECT_GE(distance(about(axis, angle) * nearest, &in[k]), least) << axis << angle;
            }
    }
}

TYPED_TEST(ConvertTest, the_nearest_rotation_of_matrices_of_any_size)
{
    using T = TypeParam;
    const Representation<T> representation = matrices<T>(MW_MATRIX_ROWS_3X4, MW_NEAREST_ROTATION);
    const Numbers<T> rotations = random_matrices<T>(100, 26), expected = representation.motors(rotations);
    const double smallest = static_cast<double>(std::numeric_limits<T>::min());
    for (double scale : {1e-20, 1e20, 1024 * smallest, 0.25 / smallest}) {
        Numbers<T> in = rotations;
        for (std::size_t k = 0; k < in.size(); ++k)
            if (k % 4 != 3)
                in[k] *= static_cast<T>(scale);
        const Numbers<T> got = representation.motors(in);
        for (std::size_t k = 0; k < got.size(); k += 8)
            expect_same_motion(&expected[k], &got[k], sizeof(T) == 4 && scale < 1e-30 ? 1e-3L : 8 * epsilon<T>,
                               std::to_string(std::log10(scale)));
    }
    // Subnormal numbers alone, whose reciprocals overflow.
    const T tiny = 8 * std::numeric_limits<T>::denorm_min();
    const Numbers<T> identity = {1, 0, 0, 0, 0, 0, 0, 0};
    EXPECT_EQ(representation.motors({tiny, 0, 0, 0, 0, tiny, 0, 0, 0, 0, tiny, 0}), identity);
}

TYPED_TEST(ConvertTest, nan_and_infinity_stay_in_their_matrix)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    const Numbers<T> one = matrices<T>(MW_MATRIX_ROWS_3X4).identity;
    const Representation<T> not_looked_at = matrices<T>(MW_MATRIX_ROWS_3X4, MW_ROTATION_MATRICES);
    for (T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()})
        for (std::size_t place = 0; place < 12; ++place)
            for (bool in_identity : {false, true}) {
                Numbers<T> in = random_matrices<T>(5, 27);
                if (in_identity)
                    std::copy(one.begin(), one.end(), &in[24]);
                const Numbers<T> expected = not_looked_at.motors(in);
                in[24 + place] = bad;
                const Numbers<T> got = not_looked_at.motors(in);
                for (std::size_t k = 0; k < got.size(); ++k) {
                    if (k / 8 != 2) {
                        EXPECT_EQ(got[k], expected[k]);
                    }
                }
            }
}

// ------------------------------------------------------------------------------------------------- checking matrices

template <class T>
struct Check {
    mw_status status;
    std::size_t first_bad = 77;
    T deviation = 77;
};

template <class T>
Check<T> check(const Numbers<T> &in, mw_matrix_layout layout, T tolerance)
{
    Check<T> result{};
    result.status = api<T>::check_matrices({in.data(), numbers_of(layout) * sizeof(T), layout},
                                                  in.size() / numbers_of(layout), tolerance, &result.first_bad,
                                                  &result.deviation);
    return result;
}

TYPED_TEST(ConvertTest, rotations_are_within_a_tolerance)
{
    using T = TypeParam;
    const Numbers<T> motors = all_motors<T>();
    for (mw_matrix_layout layout : all_matrix_layouts) {
        const Numbers<T> in = matrices<T>(layout).of(motors);
        const Check<T> found = check(in, layout, static_cast<T>(16 * epsilon<T>));
        EXPECT_EQ(found.status, MW_OK) << name_of(layout);
        EXPECT_LE(found.deviation, 16 * epsilon<T>);
        EXPECT_EQ(found.first_bad, 77u) << "written though none is bad";
        // A translation that is finite is none of its concern.
        Numbers<T> identity = matrices<T>(layout).identity;
        identity[place_in_matrix(layout, 1, 3)] = std::numeric_limits<T>::max();
        EXPECT_EQ(check(identity, layout, T(0)).status, MW_OK) << name_of(layout);
        EXPECT_EQ(check(identity, layout, T(0)).deviation, T(0));
    }
}

TYPED_TEST(ConvertTest, the_deviation_is_the_largest_and_the_first_is_named)
{
    using T = TypeParam;
    for (mw_matrix_layout layout : all_matrix_layouts) {
        const Numbers<T> one = matrices<T>(layout).identity;
        Numbers<T> in;
        for (int k = 0; k < 5; ++k)
            in.insert(in.end(), one.begin(), one.end());
        in[1 * one.size() + place_in_matrix(layout, 0, 0)] = T(1.0625);  // squared 1 + 33/256
        in[2 * one.size() + place_in_matrix(layout, 0, 1)] = T(0.5);     // and with the first column ½
        in[4 * one.size() + place_in_matrix(layout, 2, 2)] = T(1.125);
        const Check<T> found = check(in, layout, T(0.125));
        EXPECT_EQ(found.status, MW_ERROR_MATRIX);
        EXPECT_EQ(found.first_bad, 1u);
        EXPECT_EQ(found.deviation, T(0.5));
        EXPECT_EQ(check(in, layout, T(33.0 / 256)).first_bad, 2u);  // just within
        EXPECT_EQ(check(in, layout, T(0.5)).status, MW_OK);
        const std::size_t stride = one.size() * sizeof(T);
        EXPECT_EQ(api<T>::check_matrices({in.data(), stride, layout}, 5, T(0.125), nullptr, nullptr),
                  MW_ERROR_MATRIX);
    }
}

TYPED_TEST(ConvertTest, reflections_and_what_is_not_finite_are_infinitely_far)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    const mw_matrix_layout layout = MW_MATRIX_ROWS_3X4;
    const Numbers<T> one = matrices<T>(layout).identity;
    const auto expect_infinite = [&](std::size_t place, T number) {
        Numbers<T> in = one;
        in[place] = number;
        const Check<T> found = check(in, layout, Limits::max());
        EXPECT_EQ(found.status, MW_ERROR_MATRIX) << place << " " << number;
        EXPECT_EQ(found.first_bad, 0u);
        EXPECT_EQ(found.deviation, Limits::infinity());
    };
    for (std::size_t k = 0; k < 3; ++k)
        expect_infinite(place_in_matrix(layout, k, k), -1);
    expect_infinite(place_in_matrix(layout, 2, 2), 0);
    for (std::size_t place = 0; place < 12; ++place)
        for (T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()})
            expect_infinite(place, bad);
}

}  // namespace
}  // namespace motorway::testing
