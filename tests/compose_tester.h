// The subjects compose motor each, one first and one then.
#ifndef MOTORWAY_TESTS_COMPOSE_TESTER_H
#define MOTORWAY_TESTS_COMPOSE_TESTER_H

#include "guarded_buffer.h"
#include "motors.h"
#include "subject.h"

namespace motorway::testing {

// A component is the sum of at most 8 products: each is at most 8 roundings away from the result.
template <class T>
Expected expect_product(const T *first_components, const T *then_components)
{
    const reference::Motor first = exact_motor(first_components), then = exact_motor(then_components);
    const reference::Motor value = reference::compose(first, then);
    const reference::Motor magnitudes = reference::product_magnitudes(first, then);
    const long double lost = reference_error(size_of(first_components, 8) * size_of(then_components, 8));
    Expected expected;
    for (std::size_t k = 0; k < 8; ++k) {
        expected.value.push_back(value[k]);
        expected.tolerance.push_back(4 * epsilon<T> * static_cast<long double>(magnitudes[k]) + 8 * underflow<T> +
                                     lost);
    }
    return expected;
}

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
        return api<T>::compose_motor_each(out.motors(), inputs[0].const_motors(), inputs[1].const_motors(), count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, any_regime(random), inputs[0]);
        draw_motor(random, any_regime(random), inputs[1]);
    }

    Expected expect(const T *const *inputs) const override { return expect_product(inputs[0], inputs[1]); }
};

enum class Fixed { first, then };

// One factor is the same for all: the other is the input. It lies against a forbidden page.
template <class T>
class ComposeOne : public Subject<T> {
public:
    ComposeOne(Fixed fixed, Regime regime, Guard guard) : fixed_(fixed)
    {
        Random random(static_cast<std::uint64_t>(regime) + 5);
        T components[8];
        draw_motor(random, regime, components);
        motor_ = guarded_.place_copy(components, 8, guard);
    }

    std::string name() const override
    {
        return fixed_ == Fixed::first ? "compose_motor_one_first" : "compose_motor_one_then";
    }

    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::motors, 8}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        const auto *motor = reinterpret_cast<const typename api<T>::motor *>(motor_);
        return fixed_ == Fixed::first
                   ? api<T>::compose_motor_one_first(out.motors(), motor, inputs[0].const_motors(), count)
                   : api<T>::compose_motor_one_then(out.motors(), inputs[0].const_motors(), motor, count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, any_regime(random), inputs[0]);
    }

    Expected expect(const T *const *inputs) const override
    {
        return fixed_ == Fixed::first ? expect_product<T>(motor_, inputs[0]) : expect_product<T>(inputs[0], motor_);
    }

    static Subjects<T> all(Fixed fixed)
    {
        Subjects<T> subjects;
        for (Guard guard : {Guard::after, Guard::before})
            for (Regime regime : {Regime::general, Regime::scaled_pseudoscalar})
                subjects.push_back(std::make_unique<ComposeOne>(fixed, regime, guard));
        return subjects;
    }

private:
    Fixed fixed_;
    GuardedBuffer guarded_{sizeof(T[8])};
    T *motor_;
};

template <class T>
Subjects<T> subjects_of_compose_motor_one_first()
{
    return ComposeOne<T>::all(Fixed::first);
}
template <class T>
Subjects<T> subjects_of_compose_motor_one_then()
{
    return ComposeOne<T>::all(Fixed::then);
}

template <class T>
Subjects<T> subjects_of_compose_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<ComposeEach<T>>());
    return subjects;
}

}  // namespace motorway::testing

#endif
