// The subjects slerp motor each and slerp motor one, and slerp_long motor likewise; and what every interpolation
// between two poses has in common (nlerp_tester.h).
#ifndef MOTORWAY_TESTS_SLERP_TESTER_H
#define MOTORWAY_TESTS_SLERP_TESTER_H

#include <algorithm>
#include <cmath>

#include "exponential_tester.h"
#include "guarded_buffer.h"
#include "screws.h"
#include "subject.h"

namespace motorway::testing {

enum class Way { shorter, longer };

constexpr long double no_long_way = 0x1p-40L;  // a relative motor that turns as little is taken for a translation

// `second` or -`second`, whichever is that end of the way.
inline reference::Motor end_of(Way way, const reference::Motor &first, reference::Motor second)
{
    const bool is_far = reference::compose(reference::reverse(first), second)[0] < reference::Real(0);
    if (is_far == (way == Way::shorter))
        for (reference::Real &component : second)
            component = -component;
    return second;
}

// Two normalised motors, which come to lie twice `angle` apart. Half turns apart both ways are as short, and rounding
// decides: those are left out. The long way between poses that are closer than their own rounding has any axis at
// all; such have a first pose that does not turn, and then that axis is the one of the second.
template <class T>
void draw_poses(Random &random, Way way, long double angle, T *first, T *second)
{
    using reference::Element;
    if (std::abs(angle - pi / 2) < 1e-3L)
        angle = pi / 2 - 1e-3L;
    const bool is_close = way == Way::longer && std::sin(angle) < 64 * epsilon<T>;
    if (is_close && angle > no_long_way / 2)
        angle = 64 * epsilon<T>;
    const Element from = reference::element(motor_of(draw_screw(random, is_close ? 0 : draw_turn(random))));
    const Element between = reference::element(motor_of(draw_screw(random, angle)));
    round_to(reference::motor(from), first);
    round_to(reference::motor(from * between), second);
}

// Mostly from 0 to 1 and close to either end; a few of the others that are allowed.
template <class T>
T draw_parameter(Random &random, double below, double above)
{
    switch (random.below(8)) {
    case 0: return static_cast<T>(random.below(3)) / 2;
    case 1: return static_cast<T>(std::abs(random.magnitude(1e-10, 1)));
    case 2: return static_cast<T>(1 - std::abs(random.magnitude(1e-10, 1)));
    case 3: return static_cast<T>(random.uniform(below, above));
    default: return static_cast<T>(random.uniform(0, 1));
    }
}

// A function of both pairings: its name, how it is called, which parameters it takes between two poses and what it
// must give there.
template <class T>
struct Interpolation {
    std::string verb;
    std::decay_t<decltype(api<T>::slerp_motor_each)> each;
    std::decay_t<decltype(api<T>::slerp_motor_one)> one;
    Way way;
    T (*draw)(Random &random, Way way, const T *first, const T *second);
    Expected (*expect)(Way way, const T *first, const T *second, T parameter);

    unsigned flags() const { return way == Way::longer ? MW_LONG_WAY : MW_DEFAULT; }
    std::string name(const char *pairing) const
    {
        return verb + (way == Way::longer ? "_long" : "") + "_motor_" + pairing;
    }
};

template <class T>
class InterpolateEach : public Subject<T> {
public:
    explicit InterpolateEach(const Interpolation<T> &function) : function_(function) {}

    std::string name() const override { return function_.name("each"); }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motors, 8}, {Operand::motors, 8}, {Operand::numbers, 1}};
    }

    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return function_.each(out.motors(), inputs[0].const_motors(), inputs[1].const_motors(),
                              inputs[2].component[0], inputs[2].stride, count, function_.flags());
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_poses(random, function_.way, draw_turn(random), inputs[0], inputs[1]);
        *inputs[2] = function_.draw(random, function_.way, inputs[0], inputs[1]);
    }

    Expected expect(const T *const *inputs) const override
    {
        return function_.expect(function_.way, inputs[0], inputs[1], *inputs[2]);
    }

    static Subjects<T> all(const Interpolation<T> &function)
    {
        Subjects<T> subjects;
        subjects.push_back(std::make_unique<InterpolateEach>(function));
        return subjects;
    }

private:
    Interpolation<T> function_;
};

// Both poses lie against forbidden pages.
template <class T>
class InterpolateOne : public Subject<T> {
public:
    InterpolateOne(const Interpolation<T> &function, long double angle, Guard guard)
        : function_(function), angle_(angle)
    {
        Random random(7);
        T first[8], second[8];
        draw_poses(random, function_.way, angle, first, second);
        first_ = first_page_.place_copy(first, 8, guard);
        second_ = second_page_.place_copy(second, 8, guard);
    }

    std::string name() const override
    {
        return function_.name("one") + " of poses twice " + std::to_string(static_cast<double>(angle_)) + " apart";
    }

    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::numbers, 1}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        using Motor = typename api<T>::motor;
        return function_.one(out.motors(), reinterpret_cast<const Motor *>(first_),
                             reinterpret_cast<const Motor *>(second_), inputs[0].component[0], inputs[0].stride,
                             count, function_.flags());
    }

    void draw(Random &random, T *const *inputs) const override
    {
        *inputs[0] = function_.draw(random, function_.way, first_, second_);
    }

    Expected expect(const T *const *inputs) const override
    {
        return function_.expect(function_.way, first_, second_, *inputs[0]);
    }

    static Subjects<T> all(const Interpolation<T> &function)
    {
        Subjects<T> subjects;
        for (long double angle : {0.7L, 0.0L, 1e-20L, 1.5L, 1.7L, 3.1L})
            for (Guard guard : {Guard::after, Guard::before})
                subjects.push_back(std::make_unique<InterpolateOne>(function, angle, guard));
        return subjects;
    }

private:
    Interpolation<T> function_;
    long double angle_;
    GuardedBuffer first_page_{sizeof(T[8])}, second_page_{sizeof(T[8])};
    T *first_, *second_;
};

// The short way goes a little beyond its ends, the long way anywhere.
template <class T>
T draw_slerp_parameter(Random &random, Way way, const T *, const T *)
{
    return way == Way::shorter ? draw_parameter<T>(random, -1, 2) : draw_parameter<T>(random, -20, 20);
}

// The rotation has a size of 1. The translations of both poses may cancel, so what is lost of the larger one remains.
// Outside of them the weights and their errors are larger, and the screw goes on to twice its length.
template <class T>
Expected expect_short_slerp(const T *first, const T *second, T parameter)
{
    const reference::Real t(parameter);
    const reference::Motor value = reference::slerp(exact_motor(first), exact_motor(second), t);
    const long double size = std::max(length_of(first, 4, 8), length_of(second, 4, 8));
    const bool between = parameter >= 0 && parameter <= 1;
    const long double rotation = between ? 4 : 6, translation = between ? 4 : 12;
    return expect_parts(value, rotation * epsilon<T>, translation * epsilon<T> * size + 8 * underflow<T>);
}

// The long way turns about the axis of the relative motor. That is the quotient of its bivector part and its sine, so
// that an error of the one is divided by the other, and the point of the axis is divided by it once more. The angle
// and the moment grow with the parameter, and their errors with them: see power_tester.h.
template <class T>
Expected expect_long_slerp(const T *first, const T *second, T parameter)
{
    using reference::Motor;
    const Motor from = reference::normalize(exact_motor(first)), to = reference::normalize(exact_motor(second));
    const Motor between = reference::compose(reference::reverse(from), end_of(Way::longer, from, to));
    const long double sine = length_of(between, 1, 4);
    const bool turns = sine >= no_long_way;
    const reference::Bivector log = reference::multiple(
        reference::Real(parameter),
        reference::log(between, turns ? reference::Branch::principal : reference::Branch::shortest));
    const Motor value = reference::compose(from, reference::exp(log));
    const long double t = std::abs(static_cast<long double>(parameter)), stretch = turns ? 1 / sine : 1;
    const long double angle = length_of(log, 0, 3), moment = length_of(log, 3, 6);
    const long double size = std::max(length_of(first, 4, 8), length_of(second, 4, 8));
    const long double turned = 2.5L * epsilon<T> * angle + angle_error<T>(angle);
    const long double rotation = (6 + 2 * stretch) * epsilon<T> + turned;
    const long double translation = 6 * (1 + t) * stretch * stretch * epsilon<T> * size;
    return expect_parts(value, rotation, (8 * epsilon<T> + turned) * moment + translation + 8 * underflow<T>);
}

template <class T>
Expected expect_slerp(Way way, const T *first, const T *second, T parameter)
{
    return way == Way::shorter ? expect_short_slerp(first, second, parameter)
                               : expect_long_slerp(first, second, parameter);
}

template <class T>
Interpolation<T> slerp(Way way)
{
    return {"slerp", api<T>::slerp_motor_each, api<T>::slerp_motor_one, way, draw_slerp_parameter<T>,
            expect_slerp<T>};
}

template <class T>
Subjects<T> subjects_of_slerp_motor_each()
{
    return InterpolateEach<T>::all(slerp<T>(Way::shorter));
}
template <class T>
Subjects<T> subjects_of_slerp_motor_one()
{
    return InterpolateOne<T>::all(slerp<T>(Way::shorter));
}
template <class T>
Subjects<T> subjects_of_slerp_long_motor_each()
{
    return InterpolateEach<T>::all(slerp<T>(Way::longer));
}
template <class T>
Subjects<T> subjects_of_slerp_long_motor_one()
{
    return InterpolateOne<T>::all(slerp<T>(Way::longer));
}

}  // namespace motorway::testing

#endif
