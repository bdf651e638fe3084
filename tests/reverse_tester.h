// The subject reverse motor each.
#ifndef MOTORWAY_TESTS_REVERSE_TESTER_H
#define MOTORWAY_TESTS_REVERSE_TESTER_H

#include "motors.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
class ReverseEach : public Subject<T> {
public:
    std::string name() const override { return "reverse_motor_each"; }
    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::motors, 8}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::reverse_motor_each(out.motors(), inputs[0].const_motors(), count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, any_regime(random), inputs[0]);
    }

    // Only signs change, so nothing is rounded.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor value = reference::reverse(exact_motor(inputs[0]));
        return {{value.begin(), value.end()}, std::vector<long double>(8, 0.0L)};
    }
};

template <class T>
Subjects<T> subjects_of_reverse_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<ReverseEach<T>>());
    return subjects;
}

}  // namespace motorway::testing

#endif
