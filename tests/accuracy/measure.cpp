#include "measure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "isas.h"

namespace motorway::accuracy {
namespace {

using testing::ScopedIsa;

constexpr std::size_t batch_size = 1024, one_deep_in = 512;

double relative(double error, double size) { return error == 0 ? 0 : error / size; }

struct Distance {
    double rotation, translation;
};

// Between the halves of a result and of a true value, relative to their sizes.
template <class R, class T>
Distance distance(const T *result, const std::array<R, 8> &value, const Truth<R> &truth, std::size_t size)
{
    double squares[2] = {0, 0};
    for (std::size_t k = 0; k < size; ++k) {
        const double error = static_cast<double>(R(R(result[k]) - value[k]));
        squares[k >= size / 2] += error * error;
    }
    return {relative(std::sqrt(squares[0]), static_cast<double>(truth.rotation)),
            relative(std::sqrt(squares[1]), static_cast<double>(truth.translation))};
}

template <class T>
Distance nearest(const T *result, const Truth<Quad> &truth, std::size_t size)
{
    const Distance first = distance(result, truth.value, truth, size);
    if (!truth.other)
        return first;
    const Distance other = distance(result, *truth.other, truth, size);
    return first.rotation <= other.rotation ? first : other;
}

// In epsilons.
template <class T>
double difference(const Truth<Quad> &quad, const Truth<Deep> &deep, std::size_t size)
{
    std::array<Deep, 8> wide;
    for (std::size_t k = 0; k < size; ++k)
        wide[k] = Deep(quad.value[k]);
    const Distance apart = distance(wide.data(), deep.value, deep, size);
    const double largest = std::max(apart.rotation, apart.translation) / std::numeric_limits<T>::epsilon();
    if (!(largest < 1e-6))
        throw std::runtime_error("the true values of 34 and of 50 digits differ");
    return largest;
}

struct Samples {
    std::vector<double> errors, angles;

    void add(double error, double angle)
    {
        errors.push_back(std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
        angles.push_back(angle);
    }

    Figures figures() const
    {
        const auto worst = std::max_element(errors.begin(), errors.end());
        std::vector<double> sorted = errors;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        return {*worst, *middle, angles[static_cast<std::size_t>(worst - errors.begin())]};
    }
};

template <class T>
struct Batch {
    std::vector<std::vector<T>> inputs;
    std::vector<double> angles;
    std::vector<Truth<Quad>> truths;
    double disagreement = 0;
};

template <class T>
Batch<T> draw_batch(const Case<T> &measured, std::size_t count, Random &random)
{
    Batch<T> batch;
    for (std::size_t size : measured.input_sizes)
        batch.inputs.emplace_back(size * count);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<T *> element;
        for (std::size_t k = 0; k < batch.inputs.size(); ++k)
            element.push_back(&batch.inputs[k][measured.input_sizes[k] * i]);
        batch.angles.push_back(measured.draw(random, element.data()));
        batch.truths.push_back(measured.truth(element.data()));
        if (i % one_deep_in == 0)
            batch.disagreement =
                std::max(batch.disagreement, difference<T>(batch.truths.back(), measured.deep_truth(element.data()),
                                                           measured.result_size));
    }
    return batch;
}

}  // namespace

std::vector<IsaClass> isa_classes()
{
    std::vector<IsaClass> classes;
    const char *const wanted = std::getenv("MOTORWAY_ISA");
    for (const bool fused : {true, false}) {
        IsaClass of = {fused ? "fused" : "unfused", {}};
        for (const std::string &isa : testing::running_isas())
            if (testing::fuses(isa) == fused && (!wanted || isa == wanted))
                of.isas.push_back(isa);
        if (!of.isas.empty())
            classes.push_back(of);
    }
    return classes;
}

template <class T>
Measured measure(const Case<T> &measured, std::size_t count, std::uint64_t seed)
{
    constexpr double epsilon = std::numeric_limits<T>::epsilon();
    const std::vector<IsaClass> classes = isa_classes();
    std::vector<Samples> rotations(classes.size()), translations(classes.size());
    Random random(seed);
    Measured result;
    for (std::size_t begin = 0; begin < count; begin += batch_size) {
        const Batch<T> batch = draw_batch(measured, std::min(batch_size, count - begin), random);
        result.disagreement = std::max(result.disagreement, batch.disagreement);
        for (std::size_t c = 0; c < classes.size(); ++c) {
            std::vector<T> judged;
            for (const std::string &isa : classes[c].isas) {
                const ScopedIsa scope(isa);
                const std::vector<T> results = measured.run(batch.inputs);
                if (results == judged)  // as instruction sets of a class should have them
                    continue;
                judged = results;
                for (std::size_t i = 0; i < batch.truths.size(); ++i) {
                    const Distance error =
                        nearest(&results[measured.result_size * i], batch.truths[i], measured.result_size);
                    rotations[c].add(error.rotation / epsilon, batch.angles[i]);
                    translations[c].add(error.translation / epsilon, batch.angles[i]);
                }
            }
        }
    }
    for (std::size_t c = 0; c < classes.size(); ++c)
        result.errors.push_back({classes[c].name, rotations[c].figures(), translations[c].figures()});
    return result;
}

template Measured measure(const Case<float> &, std::size_t, std::uint64_t);
template Measured measure(const Case<double> &, std::size_t, std::uint64_t);

}  // namespace motorway::accuracy
