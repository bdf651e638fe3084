// The subjects sqrt motor each and power motor each.
#ifndef MOTORWAY_TESTS_POWER_TESTER_H
#define MOTORWAY_TESTS_POWER_TESTER_H

#include <cmath>

#include "exponential_tester.h"
#include "screws.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
class SqrtEach : public Subject<T> {
public:
    std::string name() const override { return "sqrt_motor_each"; }
    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::motors, 8}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::sqrt_motor_each(out.motors(), inputs[0].const_motors(), count);
    }

    void draw(Random &random, T *const *inputs) const override { draw_unit_motor(random, inputs[0]); }

    // The rotation has a size of 1; the translation is no shorter than half of that given.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor value = reference::power(exact_motor(inputs[0]), reference::Real(0.5L));
        return expect_parts(value, 4 * epsilon<T>, 4 * epsilon<T> * length_of(value, 4, 8) + 8 * underflow<T>);
    }
};

template <class T>
class PowerEach : public Subject<T> {
public:
    std::string name() const override { return "power_motor_each"; }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motors, 8}, {Operand::numbers, 1}};
    }

    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::power_motor_each(out.motors(), inputs[0].const_motors(), inputs[1].component[0],
                                        inputs[1].stride, count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_unit_motor(random, inputs[0]);
        const double some[] = {0, 1, -1, 0.5, random.magnitude(1e-6, 1), random.magnitude(1, 1000)};
        *inputs[1] = static_cast<T>(random.chance(2) ? some[random.below(std::size(some))] : random.uniform(-3, 3));
    }

    // The logarithm has 2ε of its own size in each part, a product half of one more; the exponential turns that of
    // the angle into one of the motor, and has 4 and 5ε.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Real exponent(*inputs[1]);
        const reference::Bivector log = reference::multiple(
            exponent, reference::log(exact_motor(inputs[0]), reference::Branch::shortest));
        const long double angle = length_of(log, 0, 3), moment = length_of(log, 3, 6);
        const long double turned = 2.5L * epsilon<T> * angle + angle_error<T>(angle);
        return expect_parts(reference::exp(log), 4 * epsilon<T> + turned,
                            (8 * epsilon<T> + turned) * moment + 8 * underflow<T>);
    }
};

template <class T>
Subjects<T> subjects_of_sqrt_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<SqrtEach<T>>());
    return subjects;
}

template <class T>
Subjects<T> subjects_of_power_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<PowerEach<T>>());
    return subjects;
}

}  // namespace motorway::testing

#endif
