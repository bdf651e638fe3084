// The subject normalize motor each.
#ifndef MOTORWAY_TESTS_NORMALIZE_TESTER_H
#define MOTORWAY_TESTS_NORMALIZE_TESTER_H

#include <cmath>

#include "motors.h"
#include "subject.h"

namespace motorway::testing {

template <class T>
class NormalizeEach : public Subject<T> {
public:
    // Every motor drawn is multiplied by 2^exponent: at the ends of the range α is all but subnormal or infinite.
    explicit NormalizeEach(int exponent) : exponent_(exponent) {}

    std::string name() const override
    {
        return "normalize_motor_each of motors times 2^" + std::to_string(exponent_);
    }

    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::motors, 8}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        return api<T>::normalize_motor_each(out.motors(), inputs[0].const_motors(), count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_motor(random, exponent_ ? Regime::general : any_regime(random), inputs[0]);
        for (std::size_t k = 0; k < 8; ++k)
            inputs[0][k] = std::ldexp(inputs[0][k], exponent_);
    }

    // s, b12, b13 and b23 are divided by √α: α has 4 roundings of which the root halves the effect, and then there
    // are a root, a quotient and a product: 5 roundings. The others are d/√α - k q with k = β/(2α√α): the first term
    // has one more for the sum, 6; in the second there are 4 in β, 6 in α√α, and a root, a quotient, two products and
    // the sum: at most 16. Relative to the magnitudes of both terms that is 8ε.
    Expected expect(const T *const *inputs) const override
    {
        const reference::Motor motor = exact_motor(inputs[0]), value = reference::normalize(motor);
        const auto size = [&](std::size_t k) { return std::abs(static_cast<long double>(inputs[0][k])); };
        const long double alpha = static_cast<long double>(reference::alpha(motor)), root = std::sqrt(alpha);
        const long double beta = 2 * (size(0) * size(7) + size(1) * size(6) + size(2) * size(5) + size(3) * size(4));
        const std::size_t partner[] = {7, 6, 5, 4, 3, 2, 1, 0};  // times ω: e12 ω is a multiple of e3∞, and so on
        const long double lost = reference_error(std::pow(size_of(inputs[0], 8) / root, 3.0L));
        Expected expected;
        for (std::size_t k = 0; k < 8; ++k) {
            expected.value.push_back(value[k]);
            const long double from_beta = k < 4 ? 0 : beta / (2 * alpha * root) * size(partner[k]);
            const long double relative = (k < 4 ? 3 : 8) * epsilon<T> * (size(k) / root + from_beta);
            // An α close to the smallest normal number is a sum of terms that underflow, and so is β.
            const long double lost_below = 4 * underflow<T> / alpha;
            const long double factor = k < 4 ? 1 : 2 + size(k) / root + from_beta;
            const long double absolute = lost_below * factor + 8 * underflow<T> + lost;
            expected.tolerance.push_back(relative + absolute);
        }
        return expected;
    }

private:
    int exponent_;
};

template <class T>
Subjects<T> subjects_of_normalize_motor_each()
{
    Subjects<T> subjects;
    const int lowest = (std::numeric_limits<T>::min_exponent - 1) / 2 + 1;
    const int highest = (std::numeric_limits<T>::max_exponent - 1) / 2 - 4;
    for (int exponent : {0, lowest, highest})
        subjects.push_back(std::make_unique<NormalizeEach<T>>(exponent));
    return subjects;
}

}  // namespace motorway::testing

#endif
