// The subjects apply point and apply direction, to one motor and to a motor each.
#ifndef MOTORWAY_TESTS_APPLY_TESTER_H
#define MOTORWAY_TESTS_APPLY_TESTER_H

#include <algorithm>
#include <cmath>

#include "guarded_buffer.h"
#include "motors.h"
#include "subject.h"

namespace motorway::testing {

enum class Moved { point, direction };
enum class Motors { any, unit };

// For component i of the result, the sum of the magnitudes of all terms of
//     p_i + 2/α (s c_i + (q × c)_i + w q_i),  c = q × p + d,  q = (b23, b13, b12), d = (b1i, b2i, b3i),
// signs aside. Expanded into a matrix and an offset the motion has the same terms, so this dominates both forms.
template <class T>
std::array<long double, 3> apply_magnitudes(const T *motor, const T *p, Moved moved)
{
    const auto size = [](T x) { return std::abs(static_cast<long double>(x)); };
    const long double s = size(motor[0]), q[] = {size(motor[3]), size(motor[2]), size(motor[1])};
    const bool offset = moved == Moved::point;
    const long double d[] = {offset ? size(motor[4]) : 0, offset ? size(motor[5]) : 0, offset ? size(motor[6]) : 0};
    const long double w = offset ? size(motor[7]) : 0;
    const long double alpha = s * s + q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
    long double c[3];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = q[j] * size(p[k]) + q[k] * size(p[j]) + d[i];
    }
    std::array<long double, 3> magnitudes;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        magnitudes[i] = size(p[i]) + 2 / alpha * (s * c[i] + q[j] * c[k] + q[k] * c[j] + w * q[i]);
    }
    return magnitudes;
}

// A result is at most 14 roundings away from any of its terms: 3 in c, 4 in the sum over c, 4 in α, a division, a
// product and the last sum. So the error is at most 14 · ½ε times the magnitudes; the 8th ε is for second order.
// Underflow adds at most half the smallest subnormal in each of some 16 operations, before a division by α or after.
template <class T>
Expected expect_moved(const T *motor, const T *p, Moved moved, Motors motors)
{
    const reference::Motor exact = exact_motor(motor);
    const auto value = moved == Moved::point ? reference::apply_point(exact, exact_vector(p))
                                             : reference::apply_direction(exact, exact_vector(p));
    const auto magnitudes = apply_magnitudes(motor, p, moved);
    const reference::Real alpha = reference::alpha(exact);
    const auto small_alpha = std::min(1.0L, static_cast<long double>(alpha));
    // The unit form takes α for 1: that is an error of |α - 1| in the input, not in the arithmetic.
    const auto not_unit = static_cast<long double>(reference::abs(alpha - reference::Real(1)));
    const long double lost = reference_error(size_of(motor, 8) * size_of(motor, 8) * (1 + size_of(p, 3)));
    Expected expected;
    for (std::size_t i = 0; i < 3; ++i) {
        expected.value.push_back(value[i]);
        const long double relative = 8 * epsilon<T> + (motors == Motors::unit ? not_unit : 0);
        const long double absolute = 16 * underflow<T> * (1 + magnitudes[0] + magnitudes[1] + magnitudes[2]) + lost;
        expected.tolerance.push_back(relative * magnitudes[i] + absolute / small_alpha);
    }
    return expected;
}

template <class T>
class ApplyOne : public Subject<T> {
public:
    // The motor itself lies against a forbidden page too.
    ApplyOne(Moved moved, const T *motor, Guard guard) : moved_(moved)
    {
        std::copy_n(motor, 8, motor_);
        placed_ = guarded_.place_copy(motor_, 8, guard);
    }

    std::string name() const override { return moved_ == Moved::point ? "apply_point_one" : "apply_direction_one"; }
    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::xyz, 3}}; }
    Operand output() const override { return Operand::xyz; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        const auto *motor = reinterpret_cast<const typename Api<T>::Motor *>(placed_);
        const auto function = moved_ == Moved::point ? Api<T>::apply_point_one : Api<T>::apply_direction_one;
        return function(out.xyz(), motor, inputs[0].const_xyz(), count, MW_DEFAULT);
    }

    void draw(Random &random, T *const *inputs) const override { draw_vector(random, inputs[0]); }
    Expected expect(const T *const *inputs) const override
    {
        return expect_moved(motor_, inputs[0], moved_, Motors::any);
    }

    static Subjects<T> all(Moved moved)
    {
        Subjects<T> subjects;
        Random random(1);
        for (Guard guard : {Guard::after, Guard::before})
            for (int regime = 0; regime < static_cast<int>(Regime::count); ++regime) {
                T motor[8];
                draw_motor(random, static_cast<Regime>(regime), motor);
                subjects.push_back(std::make_unique<ApplyOne>(moved, motor, guard));
            }
        return subjects;
    }

private:
    Moved moved_;
    T motor_[8];
    GuardedBuffer guarded_{sizeof(T[8])};
    T *placed_;
};

template <class T>
class ApplyEach : public Subject<T> {
public:
    ApplyEach(Moved moved, Motors motors) : moved_(moved), motors_(motors) {}

    std::string name() const override
    {
        return std::string(moved_ == Moved::point ? "apply_point_each" : "apply_direction_each") +
               (motors_ == Motors::unit ? " with MW_UNIT_MOTORS" : "");
    }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motor, 8}, {Operand::xyz, 3}};
    }

    Operand output() const override { return Operand::xyz; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        const auto function = moved_ == Moved::point ? Api<T>::apply_point_each : Api<T>::apply_direction_each;
        return function(out.xyz(), inputs[0].const_motors(), inputs[1].const_xyz(), count,
                        motors_ == Motors::unit ? MW_UNIT_MOTORS : MW_DEFAULT);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, motors_ == Motors::unit ? any_unit_regime(random) : any_regime(random), inputs[0]);
        draw_vector(random, inputs[1]);
    }

    Expected expect(const T *const *inputs) const override
    {
        return expect_moved(inputs[0], inputs[1], moved_, motors_);
    }

    static Subjects<T> all(Moved moved, Motors motors)
    {
        Subjects<T> subjects;
        subjects.push_back(std::make_unique<ApplyEach>(moved, motors));
        return subjects;
    }

private:
    Moved moved_;
    Motors motors_;
};

template <class T>
Subjects<T> subjects_of_apply_point_one() { return ApplyOne<T>::all(Moved::point); }
template <class T>
Subjects<T> subjects_of_apply_direction_one() { return ApplyOne<T>::all(Moved::direction); }
template <class T>
Subjects<T> subjects_of_apply_point_each() { return ApplyEach<T>::all(Moved::point, Motors::any); }
template <class T>
Subjects<T> subjects_of_apply_direction_each() { return ApplyEach<T>::all(Moved::direction, Motors::any); }
template <class T>
Subjects<T> subjects_of_apply_point_each_unit() { return ApplyEach<T>::all(Moved::point, Motors::unit); }
template <class T>
Subjects<T> subjects_of_apply_direction_each_unit() { return ApplyEach<T>::all(Moved::direction, Motors::unit); }

}  // namespace motorway::testing

#endif
