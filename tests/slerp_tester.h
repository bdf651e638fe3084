// The subjects slerp motor each and slerp motor one.
#ifndef MOTORWAY_TESTS_SLERP_TESTER_H
#define MOTORWAY_TESTS_SLERP_TESTER_H

#include <algorithm>
#include <cmath>

#include "guarded_buffer.h"
#include "screws.h"
#include "subject.h"

namespace motorway::testing {

// Two normalised motors. Half turns apart both ways are as short, and rounding decides: those are left out.
template <class T>
void draw_poses(Random &random, long double angle, T *first, T *second)
{
    using reference::Element;
    const Element from = reference::element(motor_of(draw_screw(random, draw_turn(random))));
    if (std::abs(angle - pi / 2) < 1e-3L)
        angle = pi / 2 - 1e-3L;
    const Element between = reference::element(motor_of(draw_screw(random, angle)));
    round_to(reference::motor(from), first);
    round_to(reference::motor(from * between), second);
}

// Mostly from 0 to 1 and close to either end; a few of the others that are allowed.
template <class T>
T draw_parameter(Random &random)
{
    switch (random.below(8)) {
    case 0: return static_cast<T>(random.below(3)) / 2;
    case 1: return static_cast<T>(std::abs(random.magnitude(1e-10, 1)));
    case 2: return static_cast<T>(1 - std::abs(random.magnitude(1e-10, 1)));
    case 3: return static_cast<T>(random.uniform(-1, 2));
    default: return static_cast<T>(random.uniform(0, 1));
    }
}

// The rotation has a size of 1. The translations of both poses may cancel, so what is lost of the larger one remains.
// Outside of them the weights and their errors are larger, and the screw goes on to twice its length.
template <class T>
Expected expect_slerp(const T *first, const T *second, T parameter)
{
    const reference::Real t(parameter);
    const reference::Motor value = reference::slerp(exact_motor(first), exact_motor(second), t);
    const long double size = std::max(length_of(first, 4, 8), length_of(second, 4, 8));
    const bool between = parameter >= 0 && parameter <= 1;
    const long double rotation = between ? 4 : 6, translation = between ? 4 : 12;
    return expect_parts(value, rotation * epsilon<T>, translation * epsilon<T> * size + 8 * underflow<T>);
}

template <class T>
class SlerpEach : public Subject<T> {
public:
    std::string name() const override { return "slerp_motor_each"; }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motors, 8}, {Operand::motors, 8}, {Operand::numbers, 1}};
    }

    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return Api<T>::slerp_motor_each(out.motors(), inputs[0].const_motors(), inputs[1].const_motors(),
                                        inputs[2].component[0], inputs[2].stride, count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_poses(random, draw_turn(random), inputs[0], inputs[1]);
        *inputs[2] = draw_parameter<T>(random);
    }

    Expected expect(const T *const *inputs) const override
    {
        return expect_slerp(inputs[0], inputs[1], *inputs[2]);
    }
};

// Both poses lie against forbidden pages.
template <class T>
class SlerpOne : public Subject<T> {
public:
    SlerpOne(long double angle, Guard guard) : angle_(angle)
    {
        Random random(7);
        T first[8], second[8];
        draw_poses(random, angle, first, second);
        first_ = first_page_.place_copy(first, 8, guard);
        second_ = second_page_.place_copy(second, 8, guard);
    }

    std::string name() const override
    {
        return "slerp_motor_one of poses twice " + std::to_string(static_cast<double>(angle_)) + " apart";
    }

    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::numbers, 1}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        using Motor = typename Api<T>::Motor;
        return Api<T>::slerp_motor_one(out.motors(), reinterpret_cast<const Motor *>(first_),
                                       reinterpret_cast<const Motor *>(second_), inputs[0].component[0],
                                       inputs[0].stride, count);
    }

    void draw(Random &random, T *const *inputs) const override { *inputs[0] = draw_parameter<T>(random); }
    Expected expect(const T *const *inputs) const override { return expect_slerp<T>(first_, second_, *inputs[0]); }

private:
    long double angle_;
    GuardedBuffer first_page_{sizeof(T[8])}, second_page_{sizeof(T[8])};
    T *first_, *second_;
};

template <class T>
Subjects<T> subjects_of_slerp_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<SlerpEach<T>>());
    return subjects;
}

template <class T>
Subjects<T> subjects_of_slerp_motor_one()
{
    Subjects<T> subjects;
    for (long double angle : {0.7L, 0.0L, 1e-20L, 1.5L, 1.7L, 3.1L})
        for (Guard guard : {Guard::after, Guard::before})
            subjects.push_back(std::make_unique<SlerpOne<T>>(angle, guard));
    return subjects;
}

}  // namespace motorway::testing

#endif
