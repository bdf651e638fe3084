// The subjects ratio motor each.
#ifndef MOTORWAY_TESTS_RATIO_TESTER_H
#define MOTORWAY_TESTS_RATIO_TESTER_H

#include <cmath>

#include "exponential_tester.h"
#include "motors.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
class RatioEach : public Subject<T> {
public:
    explicit RatioEach(Given given) : given_(given) {}

    std::string name() const override
    {
        return std::string("ratio_motor_each") + (given_ == Given::unit ? " of unit motors" : "");
    }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motors, 8}, {Operand::motors, 8}};
    }

    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::ratio_motor_each(out.motors(), inputs[0].const_motors(), inputs[1].const_motors(), count,
                                        given_ == Given::unit ? MW_UNIT_MOTORS : MW_DEFAULT);
    }

    // Only the first has to be normalised.
    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, given_ == Given::unit ? any_unit_regime(random) : any_regime(random), inputs[0]);
        draw_motor(random, any_regime(random), inputs[1]);
    }

    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor from = exact_motor(inputs[0]), to = exact_motor(inputs[1]);
        const reference::Square square = reference::square(from);
        const reference::Motor terms = reference::product_magnitudes(terms_of_inverse(inputs[0]), to);
        const auto term = [&](std::size_t k) { return static_cast<long double>(terms[k]); };
        const long double lost = lost_by_the_reference(inputs[0], inputs[1]);
        Expected expected;
        for (std::size_t k = 0; k < 8; ++k) {
            expected.value.push_back(reference::compose(reference::inverse(from), to)[k]);
            long double tolerance = epsilon<T> * roundings(k) / 2 * term(k);
            if (given_ == Given::unit) {
                // α for 1 and β for 0: an error in the input, not in the arithmetic.
                const auto off = static_cast<long double>(reference::abs(square.alpha - reference::Real(1)));
                const auto beta = static_cast<long double>(reference::abs(square.beta));
                tolerance += 1.25L * (off * term(k) + (k < 4 ? 0 : beta * term(7 - k)));
            }
            expected.tolerance.push_back(tolerance + below(k, inputs) + lost);
        }
        return expected;
    }

    static Subjects<T> all(Given given)
    {
        Subjects<T> subjects;
        subjects.push_back(std::make_unique<RatioEach>(given));
        return subjects;
    }

private:
    // Those of a product, and before it those of the inverse (inverse_tester.h): 6 or 18.
    int roundings(std::size_t k) const
    {
        const int product = 8;
        return product + (given_ == Given::unit ? 0 : k < 4 ? 6 : 18);
    }

    // The magnitudes of what the components of the inverse are the sums of.
    reference::Motor terms_of_inverse(const T *motor) const
    {
        const auto size = [&](std::size_t k) { return std::abs(static_cast<long double>(motor[k])); };
        const bool is_unit = given_ == Given::unit;
        const long double alpha = is_unit ? 1 : static_cast<long double>(reference::alpha(exact_motor(motor)));
        const long double beta = 2 * (size(0) * size(7) + size(1) * size(6) + size(2) * size(5) + size(3) * size(4));
        reference::Motor terms;
        for (std::size_t k = 0; k < 8; ++k)
            terms[k] = reference::Real((size(k) + (is_unit || k < 4 ? 0 : beta / alpha * size(7 - k))) / alpha);
        return terms;
    }

    // What underflows in the inverse is multiplied by the second motor, and what does in a product is left as it is.
    long double below(std::size_t k, const T *const *inputs) const
    {
        const long double alpha = static_cast<long double>(reference::alpha(exact_motor(inputs[0])));
        const long double inverse = k < 4 ? 1 : 1 + 4 * (1 + size_of(inputs[0], 8)) / alpha;
        return 8 * underflow<T> * (1 + inverse * size_of(inputs[1], 8) / std::min(1.0L, alpha));
    }

    static long double lost_by_the_reference(const T *from, const T *to)
    {
        const long double alpha = static_cast<long double>(reference::alpha(exact_motor(from)));
        return reference_error(std::pow(size_of(from, 8), 3.0L) / (alpha * alpha) * size_of(to, 8));
    }

    Given given_;
};

template <class T>
Subjects<T> subjects_of_ratio_motor_each()
{
    return RatioEach<T>::all(Given::any);
}
template <class T>
Subjects<T> subjects_of_ratio_motor_each_unit()
{
    return RatioEach<T>::all(Given::unit);
}

}  // namespace motorway::testing

#endif
