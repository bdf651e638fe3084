// The subjects convert * each: a table over one class. Two outputs, a quaternion and a translation say, are one view
// of the components of both.
#ifndef MOTORWAY_TESTS_CONVERT_TESTER_H
#define MOTORWAY_TESTS_CONVERT_TESTER_H

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "convert_api.h"
#include "exponential_tester.h"
#include "motors.h"
#include "screws.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
struct Conversion {
    std::string name;
    Operand input, output;
    std::function<mw_status(const View<T> &out, const View<T> &in, std::size_t count)> run;
    std::function<void(Random &random, T *in)> draw;
    std::function<Expected(const T *in)> expect;
};

template <class T>
class ConvertEach : public Subject<T> {
public:
    explicit ConvertEach(Conversion<T> conversion) : conversion_(std::move(conversion)) {}

    std::string name() const override { return "convert_" + conversion_.name; }
    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{conversion_.input, components_of(conversion_.input)}};
    }
    Operand output() const override { return conversion_.output; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return conversion_.run(out, inputs[0], count);
    }

    void draw(Random &random, T *const *inputs) const override { conversion_.draw(random, inputs[0]); }
    Expected expect(const T *const *inputs) const override { return conversion_.expect(inputs[0]); }

private:
    Conversion<T> conversion_;
};

template <class T>
Subjects<T> subjects_of_conversions(const std::vector<Conversion<T>> &conversions)
{
    Subjects<T> subjects;
    for (const Conversion<T> &conversion : conversions)
        subjects.push_back(std::make_unique<ConvertEach<T>>(conversion));
    return subjects;
}

// ------------------------------------------------------------------------------------------- inputs and expectations

template <class T>
void draw_any_motor(Random &random, T *motor)
{
    draw_motor(random, any_regime(random), motor);
}

// Some values that have the same tolerance.
struct Part {
    std::vector<reference::Real> value;
    long double tolerance;
};

inline Expected expect_each(std::initializer_list<Part> parts)
{
    Expected expected;
    for (const Part &part : parts) {
        expected.value.insert(expected.value.end(), part.value.begin(), part.value.end());
        expected.tolerance.insert(expected.tolerance.end(), part.value.size(), part.tolerance);
    }
    return expected;
}

template <std::size_t N>
std::vector<reference::Real> list(const std::array<reference::Real, N> &numbers)
{
    return {numbers.begin(), numbers.end()};
}

// x y z of x e23 + y e31 + z e12.
inline reference::Vector3 vector_part(const reference::Motor &motor) { return {motor[3], -motor[2], motor[1]}; }

// A translation is a sum of products of both halves of the motor, and those of a normalised motor are no longer than
// it. If the motor has been multiplied by 1 + βω they may cancel, and the error is relative to them.
template <class T>
Part expect_translation(const T *motor)
{
    const reference::Motor exact = exact_motor(motor);
    const long double terms = 2 * length_of(motor, 4, 8) / length_of(motor, 0, 4);
    return {list(reference::apply_point(exact, {})), 4 * epsilon<T> * terms + 8 * underflow<T>};
}

// R composed with 1 + ½ t e∞: the error of R, and a few roundings of products of it with t.
template <class T>
Expected expect_rotation_and_translation(const reference::Element &rotation, const T *translation,
                                         long double rotation_error)
{
    const reference::Motor value =
        reference::motor(rotation * reference::translation(exact_vector(translation)));
    const long double length = length_of(translation, 0, 3), size = length_of(value, 0, 4);
    const long double error = rotation_error / 2 + 2 * epsilon<T> * size;
    return expect_parts(value, rotation_error, error * length + 8 * underflow<T>);
}

// By `angle` about an axis through the origin, of any length.
inline reference::Element turn(const reference::Vector3 &axis, long double angle)
{
    return reference::rotation(axis, reference::Real(std::cos(angle / 2)), reference::Real(std::sin(angle / 2)), {});
}

// An angle of any size, most of them small.
template <class T>
T draw_angle(Random &random)
{
    return static_cast<T>(2 * draw_many_turns(random) * (random.chance(2) ? -1 : 1));
}

// ------------------------------------------------------------------------------------------------------ quaternions

template <class T>
Conversion<T> motor_to_pose(const char *name, const std::array<std::size_t, 4> &places)
{
    Conversion<T> conversion{name, Operand::motors, Operand::poses, {}, draw_any_motor<T>, {}};
    conversion.run = [places](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_pose_each(quaternions<typename api<T>::xyzw>(out, places),
                                            vectors<typename api<T>::xyz>(out, 4), in.const_motors(), count);
    };
    // The quaternion has length 1.
    conversion.expect = [places](const T *motor) {
        const reference::Motor unit = reference::normalize(exact_motor(motor));
        const reference::Vector3 vector = vector_part(unit);
        std::vector<reference::Real> quaternion(4);
        for (std::size_t k = 0; k < 4; ++k)
            quaternion[places[k]] = k == 3 ? unit[0] : vector[k];
        return expect_each({{quaternion, 2 * epsilon<T>}, expect_translation(motor)});
    };
    return conversion;
}

template <class T>
Conversion<T> pose_to_motor(const char *name, const std::array<std::size_t, 4> &places)
{
    Conversion<T> conversion{name, Operand::poses, Operand::motors, {}, {}, {}};
    conversion.run = [places](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_pose_to_motor_each(out.motors(),
                                            quaternions<typename api<T>::const_xyzw>(in, places),
                                            vectors<typename api<T>::const_xyz>(in, 4), count);
    };
    conversion.draw = [](Random &random, T *in) {
        T motor[8];
        draw_any_motor(random, motor);
        std::copy(motor, motor + 4, in);
        draw_vector(random, in + 4);
    };
    // The rotation is copied.
    conversion.expect = [places](const T *in) {
        const auto component = [&](std::size_t k) { return reference::Element(reference::Real(in[places[k]])); };
        const reference::Element rotation = component(3) + component(0) * reference::e("23") +
                                            component(1) * reference::e("31") + component(2) * reference::e("12");
        return expect_rotation_and_translation<T>(rotation, in + 4, 0);
    };
    return conversion;
}

// r = (b23, -b13, b12; s) and d = (b1i, b2i, b3i; -w): the places of a motor's components in (x y z w), and signs.
constexpr std::size_t places_of_dual[8] = {3, 2, 1, 0, 4, 5, 6, 7};
constexpr int signs_of_dual[8] = {1, 1, -1, 1, 1, 1, 1, -1};

inline std::size_t place_in_dual(std::size_t component, const std::array<std::size_t, 4> &places)
{
    const std::size_t place = places_of_dual[component];
    return place / 4 * 4 + places[place % 4];
}

// With w last, components are where a motor has its own, so that the two may be one view, in place.
inline Operand dual_operand(const std::array<std::size_t, 4> &places)
{
    return places == x_first ? Operand::motors : Operand::dual_quaternions;
}

template <class T>
Conversion<T> motor_to_dual_quaternion(const char *name, const std::array<std::size_t, 4> &places)
{
    Conversion<T> conversion{name, Operand::motors, dual_operand(places), {}, draw_any_motor<T>, {}};
    conversion.run = [places](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_dual_quaternion_each(
            dual_quaternions<typename api<T>::dual_quaternions>(out, places), in.const_motors(), count);
    };
    conversion.expect = [places](const T *motor) {
        std::vector<reference::Real> value(8);
        for (std::size_t k = 0; k < 8; ++k)
            value[place_in_dual(k, places)] = reference::Real(signs_of_dual[k] * motor[k]);
        return expect_each({{value, 0}});
    };
    return conversion;
}

template <class T>
Conversion<T> dual_quaternion_to_motor(const char *name, const std::array<std::size_t, 4> &places)
{
    Conversion<T> conversion{name, dual_operand(places), Operand::motors, {}, draw_any_motor<T>, {}};
    conversion.run = [places](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_dual_quaternion_to_motor_each(
            out.motors(), dual_quaternions<typename api<T>::const_dual_quaternions>(in, places), count);
    };
    conversion.expect = [places](const T *in) {
        std::vector<reference::Real> value;
        for (std::size_t k = 0; k < 8; ++k)
            value.emplace_back(signs_of_dual[k] * in[place_in_dual(k, places)]);
        return expect_each({{value, 0}});
    };
    return conversion;
}

// --------------------------------------------------------------------------------------------------------- matrices

inline Operand matrices_of(mw_matrix_layout layout)
{
    return numbers_of(layout) == 16 ? Operand::matrices_4x4 : Operand::matrices_3x4;
}

// The twelve numbers that are read, by row and column; and in 4 x 4 the last row.
inline std::vector<reference::Real> matrix_of(const reference::Motor &motor, mw_matrix_layout layout)
{
    std::vector<reference::Real> matrix(numbers_of(layout));
    if (matrix.size() == 16)
        matrix[15] = reference::Real(1);
    for (std::size_t column = 0; column < 4; ++column) {
        reference::Vector3 unit{};
        if (column < 3)
            unit[column] = reference::Real(1);
        const reference::Vector3 image =
            column < 3 ? reference::apply_direction(motor, unit) : reference::apply_point(motor, unit);
        for (std::size_t row = 0; row < 3; ++row)
            matrix[place_in_matrix(layout, row, column)] = image[row];
    }
    return matrix;
}

template <class T>
Conversion<T> motor_to_matrix(const char *name, mw_matrix_layout layout)
{
    Conversion<T> conversion{name, Operand::motors, matrices_of(layout), {}, draw_any_motor<T>, {}};
    conversion.run = [layout](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_matrix_each({out.component[0], out.stride, layout}, in.const_motors(), count);
    };
    // The elements are 1 or 0 and the rounded product of 2/α with a sum of two products, no more than 2. The last row
    // is exact.
    conversion.expect = [layout](const T *motor) {
        Expected expected{matrix_of(exact_motor(motor), layout), {}};
        expected.tolerance.assign(expected.value.size(), 0);
        const long double translation = expect_translation(motor).tolerance;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                expected.tolerance[place_in_matrix(layout, row, column)] = column < 3 ? 4 * epsilon<T> : translation;
        return expected;
    };
    return conversion;
}

// The quaternion (w, x, y, z) of a matrix that is orthonormal to rounding, with w > 0: the largest of the four rows
// of 4qqᵀ, normalised.
template <class At>
std::array<reference::Real, 4> quaternion_of(const At &at)
{
    using reference::Real;
    const Real one(1);
    const std::array<std::array<Real, 4>, 4> rows = {
        {{one + at(0, 0) + at(1, 1) + at(2, 2), at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)},
         {at(2, 1) - at(1, 2), one + at(0, 0) - at(1, 1) - at(2, 2), at(1, 0) + at(0, 1), at(0, 2) + at(2, 0)},
         {at(0, 2) - at(2, 0), at(1, 0) + at(0, 1), one - at(0, 0) + at(1, 1) - at(2, 2), at(2, 1) + at(1, 2)},
         {at(1, 0) - at(0, 1), at(0, 2) + at(2, 0), at(2, 1) + at(1, 2), one - at(0, 0) - at(1, 1) + at(2, 2)}}};
    std::size_t best = 0;
    for (std::size_t k = 1; k < 4; ++k)
        best = rows[best][best] < rows[k][k] ? k : best;
    std::array<Real, 4> q = rows[best];
    Real length = reference::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    length = q[0] < Real(0) ? -length : length;
    for (Real &component : q)
        component = component / length;
    return q;
}

// The kernels, which look at no matrix: matrices_test.cpp has what does. Half turns are in convert_test.cpp: there
// rounding decides which of the two motors it is. The matrix itself has been rounded, and the rows of 4qqᵀ differ by
// that; any of them that has a large diagonal may have been taken.
template <class T>
Conversion<T> matrix_to_motor(const char *name, mw_matrix_layout layout)
{
    Conversion<T> conversion{name, matrices_of(layout), Operand::motors, {}, {}, {}};
    conversion.run = [layout](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_matrix_to_motor_each(out.motors(), {in.component[0], in.stride, layout}, count,
                                              MW_ROTATION_MATRICES, nullptr);
    };
    conversion.draw = [layout](Random &random, T *matrix) {
        long double half_angle = draw_turn(random);
        if (std::abs(half_angle - pi / 2) < 1e-3L)
            half_angle = pi / 2 - 1e-3L;
        const std::vector<reference::Real> exact = matrix_of(motor_of(draw_screw(random, half_angle)), layout);
        for (std::size_t k = 0; k < exact.size(); ++k)
            matrix[k] = static_cast<T>(static_cast<long double>(exact[k]));
    };
    conversion.expect = [layout](const T *matrix) {
        const auto at = [&](std::size_t row, std::size_t column) {
            return reference::Real(matrix[place_in_matrix(layout, row, column)]);
        };
        const auto q = quaternion_of(at);
        const T translation[] = {matrix[place_in_matrix(layout, 0, 3)], matrix[place_in_matrix(layout, 1, 3)],
                                 matrix[place_in_matrix(layout, 2, 3)]};
        using reference::Element, reference::e;
        const Element rotation =
            Element(q[0]) + Element(q[1]) * e("23") + Element(q[2]) * e("31") + Element(q[3]) * e("12");
        return expect_rotation_and_translation(rotation, translation, 4 * epsilon<T>);
    };
    return conversion;
}

// ----------------------------------------------------------------------------------------------------------- angles

// The axis is a vector over its own length, whose components have a few roundings; the angle is relative to itself.
template <class T>
Conversion<T> motor_to_axis_angle()
{
    Conversion<T> conversion{"motor_to_axis_angle", Operand::motors, Operand::poses, {}, draw_any_motor<T>, {}};
    conversion.run = [](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_axis_angle_each(quaternions<typename api<T>::xyzw>(out, x_first),
                                                  vectors<typename api<T>::xyz>(out, 4), in.const_motors(), count);
    };
    conversion.expect = [](const T *motor) {
        using reference::Real;
        const reference::Vector3 v = vector_part(exact_motor(motor));
        Real length = reference::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        const long double angle =
            2 * std::atan2(static_cast<long double>(length), std::abs(static_cast<long double>(motor[0])));
        length = std::signbit(motor[0]) ? -length : length;
        const std::vector<Real> axis = length == Real(0)
                                           ? std::vector<Real>{Real(0), Real(0), Real(1)}
                                           : std::vector<Real>{v[0] / length, v[1] / length, v[2] / length};
        return expect_each({{axis, 4 * epsilon<T>},
                            {{Real(angle)}, 4 * epsilon<T> * angle + 8 * underflow<T>},
                            expect_translation(motor)});
    };
    return conversion;
}

// Sine and cosine of an angle that has been reduced to half a turn.
template <class T>
Conversion<T> axis_angle_to_motor()
{
    Conversion<T> conversion{"axis_angle_to_motor", Operand::poses, Operand::motors, {}, {}, {}};
    conversion.run = [](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_axis_angle_to_motor_each(out.motors(),
                                                  quaternions<typename api<T>::const_xyzw>(in, x_first),
                                                  vectors<typename api<T>::const_xyz>(in, 4), count);
    };
    conversion.draw = [](Random &random, T *in) {
        round_to(draw_axis(random), in);
        in[3] = draw_angle<T>(random);
        draw_vector(random, in + 4);
    };
    conversion.expect = [](const T *in) {
        const long double lost = angle_error<T>(std::abs(in[3] / 2));
        return expect_rotation_and_translation(turn(exact_vector(in), in[3]), in + 4, 4 * epsilon<T> + lost);
    };
    return conversion;
}

// About the axis called k, turned by the rotations before it: the last acts first.
template <class T>
reference::Element rotation_by_euler(const T *angles, mw_euler_order order)
{
    reference::Element rotation(reference::Real(1));
    for (std::size_t k = 0; k < 3; ++k) {
        reference::Vector3 axis{};
        axis[axis_of(order, k)] = reference::Real(1);
        rotation = turn(axis, angles[k]) * rotation;
    }
    return rotation;
}

// The errors of three rotations.
template <class T>
Conversion<T> euler_to_motor(mw_euler_order order)
{
    Conversion<T> conversion{std::string("euler_to_motor ") + names_of_orders[order], Operand::vertices,
                             Operand::motors, {}, {}, {}};
    conversion.run = [order](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_euler_to_motor_each(out.motors(), vectors<typename api<T>::const_xyz>(in, 0),
                                             vectors<typename api<T>::const_xyz>(in, 3), count, order);
    };
    conversion.draw = [](Random &random, T *in) {
        for (std::size_t k = 0; k < 3; ++k)
            in[k] = draw_angle<T>(random);
        draw_vector(random, in + 3);
    };
    conversion.expect = [order](const T *in) {
        const long double lost = angle_error<T>(size_of(in, 3) / 2);
        return expect_rotation_and_translation(rotation_by_euler(in, order), in + 3, 6 * epsilon<T> + lost);
    };
    return conversion;
}

// From the elements of the matrix, in long double. `hand` is 1 if the first axis, the second and the remaining one
// are right-handed, and -1 if not.
inline std::array<long double, 3> euler_of(const reference::Motor &motor, mw_euler_order order)
{
    const std::vector<reference::Real> matrix = matrix_of(motor, MW_MATRIX_ROWS_3X4);
    const auto at = [&](std::size_t row, std::size_t column) {
        return static_cast<long double>(matrix[4 * row + column]);
    };
    const std::size_t i = axis_of(order, 0), j = axis_of(order, 1), k = 3 - i - j;
    const long double hand = j == (i + 1) % 3 ? 1 : -1;
    if (axis_of(order, 2) == i)
        return {std::atan2(at(j, i), -hand * at(k, i)), std::atan2(std::hypot(at(j, i), at(k, i)), at(i, i)),
                std::atan2(at(i, j), hand * at(i, k))};
    return {std::atan2(-hand * at(j, k), at(k, k)), std::atan2(hand * at(i, k), std::hypot(at(i, i), at(i, j))),
            std::atan2(-hand * at(i, j), at(i, i))};
}

// Angles away from gimbal lock, where they are as well determined as the rotation, and from where they pass from π to
// -π; convert_test.cpp has the others.
template <class T>
Conversion<T> motor_to_euler(mw_euler_order order)
{
    const bool is_proper = axis_of(order, 0) == axis_of(order, 2);
    Conversion<T> conversion{std::string("motor_to_euler ") + names_of_orders[order], Operand::motors,
                             Operand::vertices, {}, {}, {}};
    conversion.run = [order](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_euler_each(vectors<typename api<T>::xyz>(out, 0),
                                             vectors<typename api<T>::xyz>(out, 3), in.const_motors(), count, order);
    };
    conversion.draw = [order, is_proper](Random &random, T *motor) {
        const long double centre = is_proper ? pi / 2 : 0;
        const long double angles[] = {random.uniform(-3, 3), centre + random.uniform(-1.2, 1.2),
                                      random.uniform(-3, 3)};
        const reference::Element scale{reference::Real(random.chance(2) ? 1 : random.magnitude(1e-3, 1e3))};
        round_to(reference::motor(scale * rotation_by_euler(angles, order) *
                                  reference::translation(random_vector(random, 1e-3, 1e3))),
                 motor);
    };
    // The angles up to π are sums of two of half their size, from products of the motor.
    conversion.expect = [order](const T *motor) {
        const auto angles = euler_of(exact_motor(motor), order);
        return expect_each({{{angles[0], angles[1], angles[2]}, 12 * epsilon<T>}, expect_translation(motor)});
    };
    return conversion;
}

// ----------------------------------------------------------------------------------- translations, screws and rotors

template <class T>
Conversion<T> translation_to_motor()
{
    Conversion<T> conversion{"translation_to_motor", Operand::xyz, Operand::motors, {}, draw_vector<T>, {}};
    conversion.run = [](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_translation_to_motor_each(out.motors(), in.const_xyz(), count);
    };
    // Half of a subnormal number is rounded.
    conversion.expect = [](const T *in) {
        return expect_parts(reference::motor(reference::translation(exact_vector(in))), 0, underflow<T>);
    };
    return conversion;
}

template <class T>
Conversion<T> motor_to_translation()
{
    Conversion<T> conversion{"motor_to_translation", Operand::motors, Operand::xyz, {}, draw_any_motor<T>, {}};
    conversion.run = [](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_translation_each(out.xyz(), in.const_motors(), count);
    };
    conversion.expect = [](const T *motor) { return expect_each({expect_translation(motor)}); };
    return conversion;
}

// The screw from the logarithm ½θ (a + q × a ω') + ½ d a ω' in vectors. What turns by less than 2^-59 is taken as a
// translation. Rotation and translation of a logarithm have 4ε of their sizes, of which the moment is divided by half
// the angle for the point of the axis.
template <class T>
Expected expect_screw(const T *motor)
{
    using reference::Real, reference::Vector3;
    const reference::Bivector log = reference::log(exact_motor(motor), reference::Branch::shortest);
    const Vector3 turn = {log[2], -log[1], log[0]}, moment = {log[3], log[4], log[5]};
    const long double half_angle = length_of(turn, 0, 3), half_way = length_of(moment, 0, 3);
    const bool turns = half_angle >= 0x1p-60L;
    const Vector3 &direction = turns ? turn : moment;
    const Real length = reference::sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                                        direction[2] * direction[2]);
    Vector3 axis = {Real(0), Real(0), Real(1)}, point{};
    if (length != Real(0))
        axis = {direction[0] / length, direction[1] / length, direction[2] / length};
    if (turns)
        point = {(axis[1] * moment[2] - axis[2] * moment[1]) / length,
                 (axis[2] * moment[0] - axis[0] * moment[2]) / length,
                 (axis[0] * moment[1] - axis[1] * moment[0]) / length};
    const Real along = axis[0] * moment[0] + axis[1] * moment[1] + axis[2] * moment[2];
    const long double arm = turns ? half_way / half_angle : 0;
    return expect_each({{list(axis), 6 * epsilon<T>},
                        {list(point), 12 * epsilon<T> * arm},
                        {{Real(turns ? 2 * half_angle : 0)}, 6 * epsilon<T> * 2 * half_angle},
                        {{Real(2) * along}, 12 * epsilon<T> * 2 * half_way + 8 * underflow<T>}});
}

template <class T>
Conversion<T> motor_to_screw()
{
    Conversion<T> conversion{"motor_to_screw", Operand::motors, Operand::motors, {}, draw_unit_motor<T>,
                             expect_screw<T>};
    conversion.run = [](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_screw_each(screws<typename api<T>::screws>(out), in.const_motors(), count);
    };
    return conversion;
}

template <class T>
Conversion<T> screw_to_motor()
{
    Conversion<T> conversion{"screw_to_motor", Operand::motors, Operand::motors, {}, {}, {}};
    conversion.run = [](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_screw_to_motor_each(out.motors(), screws<typename api<T>::const_screws>(in), count);
    };
    conversion.draw = [](Random &random, T *in) {
        const Screw screw = draw_screw(random, 0);
        round_to(screw.axis, in);
        round_to(screw.point, in + 3);
        in[6] = draw_angle<T>(random);
        in[7] = static_cast<T>(2 * screw.slide);
    };
    // The translation is that of the lever, which the sine of half the angle shortens, and half the way.
    conversion.expect = [](const T *in) {
        using reference::Real;
        const reference::Vector3 axis = exact_vector(in), point = exact_vector(in + 3);
        const long double half = static_cast<long double>(in[6]) / 2;
        const reference::Motor value =
            reference::motor(reference::rotation(axis, Real(std::cos(half)), Real(std::sin(half)), point) *
                             reference::translation({Real(in[7]) * axis[0], Real(in[7]) * axis[1],
                                                     Real(in[7]) * axis[2]}));
        const long double lost = angle_error<T>(std::abs(half));
        const long double lever = std::min(1.0L, std::abs(half)) * length_of(point, 0, 3);
        const long double size = lever + std::abs(static_cast<long double>(in[7])) / 2;
        return expect_parts(value, 4 * epsilon<T> + lost,
                            4 * epsilon<T> * size + lost * (length_of(point, 0, 3) + size) + 8 * underflow<T>);
    };
    return conversion;
}

// The reverse with its e∞ part times `scale`, which for rotors is 1 / λ, rounded.
template <class T>
Expected expect_reversed(const T *motor, const reference::Real &scale)
{
    reference::Motor value = reference::reverse(exact_motor(motor));
    Expected expected;
    for (std::size_t k = 0; k < 8; ++k) {
        expected.value.push_back(k < 4 ? value[k] : scale * value[k]);
        const long double size = std::abs(static_cast<long double>(expected.value[k]));
        expected.tolerance.push_back(k < 4 ? 0 : epsilon<T> * size + 2 * underflow<T>);
    }
    return expected;
}

template <class T>
Conversion<T> motor_to_rotor(T lambda)
{
    Conversion<T> conversion{"motor_to_rotor in units of " + std::to_string(lambda), Operand::motors,
                             Operand::motors, {}, draw_any_motor<T>, {}};
    conversion.run = [lambda](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_motor_to_rotor_each(out.motors(), in.const_motors(), count, lambda);
    };
    conversion.expect = [lambda](const T *motor) {
        return expect_reversed(motor, reference::Real(1) / reference::Real(lambda));
    };
    return conversion;
}

template <class T>
Conversion<T> rotor_to_motor(T lambda)
{
    Conversion<T> conversion{"rotor_to_motor in units of " + std::to_string(lambda), Operand::motors,
                             Operand::motors, {}, draw_any_motor<T>, {}};
    conversion.run = [lambda](const View<T> &out, const View<T> &in, std::size_t count) {
        return api<T>::convert_rotor_to_motor_each(out.motors(), in.const_motors(), count, lambda);
    };
    conversion.expect = [lambda](const T *rotor) { return expect_reversed(rotor, reference::Real(lambda)); };
    return conversion;
}

// -------------------------------------------------------------------------------------------------------- the table

#define MOTORWAY_TEST_CONVERSIONS(row, ...)                                                              \
    template <class T>                                                                                   \
    Subjects<T> subjects_of_convert_##row##_each()                                                       \
    {                                                                                                    \
        return subjects_of_conversions<T>({__VA_ARGS__});                                                \
    }

MOTORWAY_TEST_CONVERSIONS(motor_to_pose, motor_to_pose<T>("motor_to_pose", x_first))
MOTORWAY_TEST_CONVERSIONS(pose_to_motor, pose_to_motor<T>("pose_to_motor", x_first))
MOTORWAY_TEST_CONVERSIONS(motor_to_pose_wxyz, motor_to_pose<T>("motor_to_pose_wxyz", w_first))
MOTORWAY_TEST_CONVERSIONS(pose_wxyz_to_motor, pose_to_motor<T>("pose_wxyz_to_motor", w_first))
MOTORWAY_TEST_CONVERSIONS(motor_to_dual_quaternion,
                          motor_to_dual_quaternion<T>("motor_to_dual_quaternion", x_first))
MOTORWAY_TEST_CONVERSIONS(dual_quaternion_to_motor,
                          dual_quaternion_to_motor<T>("dual_quaternion_to_motor", x_first))
MOTORWAY_TEST_CONVERSIONS(motor_to_dual_quaternion_wxyz,
                          motor_to_dual_quaternion<T>("motor_to_dual_quaternion_wxyz", w_first))
MOTORWAY_TEST_CONVERSIONS(dual_quaternion_wxyz_to_motor,
                          dual_quaternion_to_motor<T>("dual_quaternion_wxyz_to_motor", w_first))
MOTORWAY_TEST_CONVERSIONS(motor_to_rows_3x4, motor_to_matrix<T>("motor_to_rows_3x4", MW_MATRIX_ROWS_3X4))
MOTORWAY_TEST_CONVERSIONS(motor_to_rows_4x4, motor_to_matrix<T>("motor_to_rows_4x4", MW_MATRIX_ROWS_4X4))
MOTORWAY_TEST_CONVERSIONS(motor_to_columns_3x4, motor_to_matrix<T>("motor_to_columns_3x4", MW_MATRIX_COLUMNS_3X4))
MOTORWAY_TEST_CONVERSIONS(motor_to_columns_4x4, motor_to_matrix<T>("motor_to_columns_4x4", MW_MATRIX_COLUMNS_4X4))
MOTORWAY_TEST_CONVERSIONS(rows_3x4_to_motor, matrix_to_motor<T>("rows_3x4_to_motor", MW_MATRIX_ROWS_3X4),
                          matrix_to_motor<T>("rows_4x4_to_motor", MW_MATRIX_ROWS_4X4))
MOTORWAY_TEST_CONVERSIONS(columns_3x4_to_motor, matrix_to_motor<T>("columns_3x4_to_motor", MW_MATRIX_COLUMNS_3X4))
MOTORWAY_TEST_CONVERSIONS(columns_4x4_to_motor, matrix_to_motor<T>("columns_4x4_to_motor", MW_MATRIX_COLUMNS_4X4))
MOTORWAY_TEST_CONVERSIONS(motor_to_axis_angle, motor_to_axis_angle<T>())
MOTORWAY_TEST_CONVERSIONS(axis_angle_to_motor, axis_angle_to_motor<T>())
MOTORWAY_TEST_CONVERSIONS(motor_to_euler, motor_to_euler<T>(MW_EULER_XYZ), motor_to_euler<T>(MW_EULER_XZY),
                          motor_to_euler<T>(MW_EULER_YXZ), motor_to_euler<T>(MW_EULER_YZX),
                          motor_to_euler<T>(MW_EULER_ZXY), motor_to_euler<T>(MW_EULER_ZYX))
MOTORWAY_TEST_CONVERSIONS(motor_to_euler_proper, motor_to_euler<T>(MW_EULER_XYX), motor_to_euler<T>(MW_EULER_XZX),
                          motor_to_euler<T>(MW_EULER_YXY), motor_to_euler<T>(MW_EULER_YZY),
                          motor_to_euler<T>(MW_EULER_ZXZ), motor_to_euler<T>(MW_EULER_ZYZ))
MOTORWAY_TEST_CONVERSIONS(euler_to_motor, euler_to_motor<T>(MW_EULER_XYZ), euler_to_motor<T>(MW_EULER_ZYX),
                          euler_to_motor<T>(MW_EULER_YXZ), euler_to_motor<T>(MW_EULER_ZXZ))
MOTORWAY_TEST_CONVERSIONS(translation_to_motor, translation_to_motor<T>())
MOTORWAY_TEST_CONVERSIONS(motor_to_translation, motor_to_translation<T>())
MOTORWAY_TEST_CONVERSIONS(motor_to_screw, motor_to_screw<T>())
MOTORWAY_TEST_CONVERSIONS(screw_to_motor, screw_to_motor<T>())
MOTORWAY_TEST_CONVERSIONS(rotor_to_motor, rotor_to_motor<T>(T(0.25)), rotor_to_motor<T>(3), motor_to_rotor<T>(3),
                          motor_to_rotor<T>(1))

#undef MOTORWAY_TEST_CONVERSIONS

}  // namespace motorway::testing

#endif
