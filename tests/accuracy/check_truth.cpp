#include "check_truth.h"

#include <algorithm>

#include "inputs.h"
#include "numbers.h"
#include "truth.h"

namespace motorway::accuracy {
namespace {

constexpr int count = 60;

template <std::size_t N, class T>
std::array<reference::Real, N> for_reference(const std::array<T, N> &numbers)
{
    std::array<reference::Real, N> same;
    for (std::size_t k = 0; k < N; ++k)
        same[k] = reference::Real(static_cast<long double>(numbers[k]));
    return same;
}

// Of the two halves, each relative to its own size.
template <std::size_t N>
double difference(const std::array<reference::Real, N> &found, const std::array<Deep, N> &truth)
{
    double largest = 0;
    for (std::size_t begin : {std::size_t(0), N / 2}) {
        const Deep size = length(truth, begin, begin + N / 2);
        for (std::size_t k = begin; k < begin + N / 2 && size > 0; ++k) {
            const Deep error = Deep(found[k].high) + Deep(found[k].low) - truth[k];
            largest = std::max(largest, std::abs(static_cast<double>(Deep(error / size))));
        }
    }
    return largest;
}

// Motors of double, as exact as they are.
Motor<double> draw_motor(Random &random, double angle)
{
    Motor<double> motor;
    round_to(draw_exact_motor(random, angle, usual_lengths), motor.data());
    return motor;
}

}  // namespace

double check_truth()
{
    Random random(2);
    double largest = 0;
    for (int k = 0; k < count; ++k) {
        const double angle = random.chance(4) ? draw_size(random, 1e-20, 1) : random.uniform(0, turn - 0.1);
        const Bivector<double> B = draw_generator(random, angle, usual_lengths);
        const Motor<double> S = draw_motor(random, angle), P = draw_motor(random, to_a_turn.draw(random));
        const Bivector<Deep> deep_B = exactly<Deep, 6>(B.data());
        const Motor<Deep> deep_S = exactly<Deep, 8>(S.data()), deep_P = exactly<Deep, 8>(P.data());
        const reference::Motor dense_S = for_reference(S), dense_P = for_reference(P);
        largest = std::max(largest, difference(reference::exp(for_reference(B)), exp(deep_B)));
        largest = std::max(largest, difference(reference::normalize(dense_S), normalize(deep_S)));
        for (Branch branch : {Branch::shortest, Branch::principal})
            largest = std::max(largest, difference(reference::log(dense_S, branch), log(deep_S, branch)));
        largest = std::max(largest, difference(reference::compose(dense_S, dense_P), compose(deep_S, deep_P)));
        const double t = random.uniform(0, 1);
        const bool near = dot(normalize(deep_S), normalize(deep_P)) >= 0;
        largest = std::max(largest, difference(reference::slerp(dense_S, dense_P, reference::Real(t)),
                                               slerp(deep_S, near ? deep_P : negated(deep_P), Deep(t))));
    }
    return largest;
}

}  // namespace motorway::accuracy
