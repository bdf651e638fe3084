// The subject compose motor each.
#ifndef MOTORWAY_TESTS_COMPOSE_TESTER_H
#define MOTORWAY_TESTS_COMPOSE_TESTER_H

#include "motors.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
class ComposeEach : public Subject<T> {
public:
    std::string name() const override { return "compose_motor_each"; }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motors, 8}, {Operand::motors, 8}};
    }

    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return Api<T>::compose_motor_each(out.motors(), inputs[0].const_motors(), inputs[1].const_motors(), count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, any_regime(random), inputs[0]);
        draw_motor(random, any_regime(random), inputs[1]);
    }

    // A component is the sum of at most 8 products: each is at most 8 roundings away from the result.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor first = exact_motor(inputs[0]), then = exact_motor(inputs[1]);
        const reference::Motor value = reference::compose(first, then);
        const reference::Motor magnitudes = reference::product_magnitudes(first, then);
        const long double lost = reference_error(size_of(inputs[0], 8) * size_of(inputs[1], 8));
        Expected expected;
        for (std::size_t k = 0; k < 8; ++k) {
            expected.value.push_back(value[k]);
            expected.tolerance.push_back(4 * epsilon<T> * static_cast<long double>(magnitudes[k]) +
                                         8 * underflow<T> + lost);
        }
        return expected;
    }
};

template <class T>
Subjects<T> subjects_of_compose_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<ComposeEach<T>>());
    return subjects;
}

}  // namespace motorway::testing

#endif
