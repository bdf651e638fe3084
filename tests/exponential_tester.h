// The subjects exp motor each, log motor each and log_principal motor each.
#ifndef MOTORWAY_TESTS_EXPONENTIAL_TESTER_H
#define MOTORWAY_TESTS_EXPONENTIAL_TESTER_H

#include <cmath>

#include "isas.h"
#include "screws.h"
#include "subject.h"

namespace motorway::testing {

// What the rounding of an angle costs where multiply and add are not fused: the square of the angle has three
// roundings, of which the root halves the effect, and then there are the root and the product with a number of turns.
// Where they are fused the kernel keeps the angle to twice the precision.
template <class T>
long double angle_error(long double angle)
{
    return fuses(mw_isa()) ? 0 : 1.75L * epsilon<T> * angle;
}

template <class T>
class ExpEach : public Subject<T> {
public:
    std::string name() const override { return "exp_motor_each"; }
    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::bivectors, 6}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::exp_motor_each(out.motors(), inputs[0].const_bivectors(), count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        round_to(bivector_of(draw_screw(random, draw_many_turns(random))), inputs[0]);
    }

    // The rotation has a size of 1. The translation of a full turn is 0 but for the pitch, and then what is lost of
    // the moment remains: its error is relative to that, and for no more than a half turn to itself. Beyond, the
    // angle over which the moment is divided is rounded once more.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Bivector bivector = exact_bivector(inputs[0]);
        const reference::Motor value = reference::exp(bivector);
        const long double angle = length_of(inputs[0], 0, 3), moment = length_of(inputs[0], 3, 6);
        const long double lost = angle_error<T>(angle);
        const long double size = angle <= pi / 2 ? length_of(value, 4, 8) : 1.25L * moment;
        return expect_parts(value, 4 * epsilon<T> + lost, 4 * epsilon<T> * size + lost * moment + 8 * underflow<T>);
    }
};

enum class Given { any, unit };

template <class T>
class LogEach : public Subject<T> {
public:
    LogEach(reference::Branch branch, Given given) : branch_(branch), given_(given) {}

    std::string name() const override
    {
        return std::string(is_principal() ? "log_principal_motor_each" : "log_motor_each") +
               (given_ == Given::unit ? " of unit motors" : "");
    }

    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::motors, 8}}; }
    Operand output() const override { return Operand::bivectors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        const unsigned flags = given_ == Given::unit ? MW_UNIT_MOTORS : MW_DEFAULT;
        const auto function = is_principal() ? api<T>::log_principal_motor_each : api<T>::log_motor_each;
        return function(out.bivectors(), inputs[0].const_motors(), count, flags);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        reference::Motor motor = motor_of(draw_screw(random, draw_turn(random)));
        if (random.chance(2))
            for (reference::Real &component : motor)
                component = -component;
        if (given_ == Given::any && !random.chance(4)) {
            using reference::Element, reference::Real;
            const Element factor = Element(Real(random.magnitude(1e-3, 1e3))) +
                                   Element(Real(random.uniform(-3, 3))) * reference::e("123i");
            motor = reference::motor(reference::element(motor) * factor);
        }
        round_to(motor, inputs[0]);
    }

    // Each part relative to its own size. Towards a full turn the moment is the small difference of two terms that
    // grow as 1/sin: what one rounding of the motor makes of it, and its w, which is small there if
    // the motor is normalised, once more. Normalising first costs the rotation
    // little; the moment has another 4ε of the terms that the normalised translation is the sum of.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor motor = exact_motor(inputs[0]);
        const reference::Motor unit = reference::normalize(motor);
        const long double sine = length_of(unit, 1, 4);
        const reference::Bivector value =
            reference::log(motor, sine < no_axis ? reference::Branch::shortest : branch_);
        const long double angle = length_of(value, 0, 3);
        const long double stretch = sine > 0 ? angle / sine : 1;
        const bool beyond = angle > pi / 2 + 0.1L;
        long double moment = 4 * length_of(value, 3, 6);
        if (beyond)
            moment += 6 * stretch * length_of(unit, 4, 8);
        if (given_ == Given::any)
            moment += 4 * stretch * (beyond ? 1 + 1 / sine : 1) * normalized_terms(inputs[0]);
        return expect_parts(value, 4 * epsilon<T> * angle + 8 * underflow<T>,
                            epsilon<T> * moment + 8 * underflow<T>);
    }

    static Subjects<T> all(reference::Branch branch, Given given)
    {
        Subjects<T> subjects;
        subjects.push_back(std::make_unique<LogEach>(branch, given));
        return subjects;
    }

private:
    static constexpr long double no_axis = 0x1p-40L;  // as close to -1 there is no principal logarithm

    bool is_principal() const { return branch_ == reference::Branch::principal; }

    // The magnitudes of the terms of which the translation of the normalised motor is made.
    static long double normalized_terms(const T *components)
    {
        const long double alpha = length_of(components, 0, 4) * length_of(components, 0, 4);
        long double beta = 0;
        for (std::size_t k = 0; k < 4; ++k)
            beta += 2 * std::abs(static_cast<long double>(components[k]) * components[7 - k]);
        return length_of(components, 4, 8) / std::sqrt(alpha) + beta / (2 * alpha);
    }

    reference::Branch branch_;
    Given given_;
};

template <class T>
Subjects<T> subjects_of_exp_motor_each()
{
    Subjects<T> subjects;
    subjects.push_back(std::make_unique<ExpEach<T>>());
    return subjects;
}

template <class T>
Subjects<T> subjects_of_log_motor_each()
{
    return LogEach<T>::all(reference::Branch::shortest, Given::any);
}
template <class T>
Subjects<T> subjects_of_log_motor_each_unit()
{
    return LogEach<T>::all(reference::Branch::shortest, Given::unit);
}
template <class T>
Subjects<T> subjects_of_log_principal_motor_each()
{
    return LogEach<T>::all(reference::Branch::principal, Given::any);
}
template <class T>
Subjects<T> subjects_of_log_principal_motor_each_unit()
{
    return LogEach<T>::all(reference::Branch::principal, Given::unit);
}

}  // namespace motorway::testing

#endif
