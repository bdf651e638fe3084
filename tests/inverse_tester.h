// The subject inverse motor each.
#ifndef MOTORWAY_TESTS_INVERSE_TESTER_H
#define MOTORWAY_TESTS_INVERSE_TESTER_H

#include <cmath>

#include "motors.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
class InverseEach : public Subject<T> {
public:
    // Every motor drawn is multiplied by 2^exponent: at the ends of the range α is all but subnormal or infinite.
    explicit InverseEach(int exponent) : exponent_(exponent) {}

    std::string name() const override { return "inverse_motor_each of motors times 2^" + std::to_string(exponent_); }
    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::motors, 8}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::inverse_motor_each(out.motors(), inputs[0].const_motors(), count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, exponent_ ? Regime::general : any_regime(random), inputs[0]);
        for (std::size_t k = 0; k < 8; ++k)
            inputs[0][k] = std::ldexp(inputs[0][k], exponent_);
    }

    // s, b12, b13 and b23 are divided by α, which has 4 roundings, with a quotient and a product: 6. The others are
    // (d - k β/α)/α: 4 roundings in β, 5 in each 1/α, and three products and a sum, at most 18. That is 3 and 9ε,
    // relative to the magnitudes of both terms.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor motor = exact_motor(inputs[0]), value = reference::inverse(motor);
        const auto size = [&](std::size_t k) { return std::abs(static_cast<long double>(inputs[0][k])); };
        const long double alpha = static_cast<long double>(reference::alpha(motor));
        const long double beta = 2 * (size(0) * size(7) + size(1) * size(6) + size(2) * size(5) + size(3) * size(4));
        const long double lost = reference_error(std::pow(size_of(inputs[0], 8), 3.0L) / (alpha * alpha));
        // An α close to the smallest normal number is a sum of terms that underflow, and so is β.
        const long double lost_below = 4 * underflow<T> / alpha;
        Expected expected;
        for (std::size_t k = 0; k < 8; ++k) {
            const long double from_beta = k < 4 ? 0 : beta / alpha * size(7 - k);
            const long double terms = (size(k) + from_beta) / alpha;
            const long double below = lost_below * (2 * terms + (k < 4 ? 0 : 2 * size(7 - k) / alpha));
            expected.value.push_back(value[k]);
            expected.tolerance.push_back((k < 4 ? 3 : 9) * epsilon<T> * terms + below + 8 * underflow<T> + lost);
        }
        return expected;
    }

private:
    int exponent_;
};

template <class T>
Subjects<T> subjects_of_inverse_motor_each()
{
    Subjects<T> subjects;
    const int lowest = (std::numeric_limits<T>::min_exponent - 1) / 2 + 1;
    const int highest = (std::numeric_limits<T>::max_exponent - 1) / 2 - 4;
    for (int exponent : {0, lowest, highest})
        subjects.push_back(std::make_unique<InverseEach<T>>(exponent));
    return subjects;
}

}  // namespace motorway::testing

#endif
