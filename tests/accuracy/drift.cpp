#include "drift.h"

#include <algorithm>

#include "inputs.h"
#include "isas.h"
#include "library.h"
#include "measure.h"

namespace motorway::accuracy {
namespace {

constexpr std::size_t lanes = 16, factor_count = 4096;

template <class T>
std::vector<T> draw_motors(Random &random, std::size_t count)
{
    std::vector<T> motors(8 * count);
    for (std::size_t i = 0; i < count; ++i)
        round_to(draw_exact_motor(random, to_a_turn.draw(random), {0.01, 1, 1}), &motors[8 * i]);
    return motors;
}

template <class T>
double deviation(const std::vector<T> &motors)
{
    double largest = 0;
    for (std::size_t i = 0; i < motors.size(); i += 8) {
        const Quad size = length(exactly<Quad, 8>(&motors[i]), 0, 4);
        largest = std::max(largest, std::abs(static_cast<double>(Quad(size * size - 1))));
    }
    return largest;
}

template <class T>
double pseudoscalar(const std::vector<T> &motors)
{
    double largest = 0;
    for (std::size_t i = 0; i < motors.size(); i += 8) {
        const auto S = exactly<Quad, 8>(&motors[i]);
        const Quad beta = 2 * (S[0] * S[7] - S[1] * S[6] + S[2] * S[5] - S[3] * S[4]);
        largest = std::max(largest, std::abs(static_cast<double>(Quad(beta / length(S, 4, 8)))));
    }
    return largest;
}

}  // namespace

template <class T>
std::vector<Drift> measure_drift()
{
    Random random(1);
    const std::vector<T> start = draw_motors<T>(random, lanes), factors = draw_motors<T>(random, factor_count);
    std::vector<Drift> drifts;
    for (const IsaClass &of : isa_classes()) {
        const testing::ScopedIsa scope(of.isas.front());
        Drift drift = {of.name, 0, 0, 0};
        std::vector<T> product = start;
        for (std::size_t n = 1; n < drift_products; ++n) {
            const auto begin = factors.begin() + static_cast<std::ptrdiff_t>(8 * random.below(factor_count - lanes));
            product = Library<T>::compose(product, {begin, begin + 8 * lanes});
            if ((n + 1) % drift_renormalised_every != 0)
                continue;
            drift.before = std::max(drift.before, deviation(product));
            product = Library<T>::normalize(product);
            drift.after = std::max(drift.after, deviation(product));
            drift.pseudoscalar = std::max(drift.pseudoscalar, pseudoscalar(product));
        }
        drifts.push_back(drift);
    }
    return drifts;
}

template std::vector<Drift> measure_drift<float>();
template std::vector<Drift> measure_drift<double>();

}  // namespace motorway::accuracy
