// Errors of a function over many inputs, by class of instruction sets.
#ifndef MOTORWAY_TESTS_ACCURACY_MEASURE_H
#define MOTORWAY_TESTS_ACCURACY_MEASURE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "inputs.h"
#include "numbers.h"

namespace motorway::accuracy {

// A motor, or a bivector and two zeros, and what the errors of its two halves are relative to.
template <class R>
struct Truth {
    std::array<R, 8> value{};
    R rotation = 1, translation = 0;
    std::optional<std::array<R, 8>> other = std::nullopt;  // as good a result
};

// What is measured, in words for the tables. Errors are in epsilons, of sizes that `rotation` and `translation` name.
struct Title {
    std::string section, function, inputs;
    std::string rotation, translation;
    double asked = 0;  // epsilons; 0: nothing was
};

template <class T>
struct Case {
    using Numbers = std::vector<T>;

    Title title;
    std::vector<std::size_t> input_sizes;  // numbers an element
    std::size_t result_size = 8;
    std::function<double(Random &, T *const *)> draw;  // the inputs of one element; returns the angle
    std::function<Truth<Quad>(const T *const *)> truth;
    std::function<Truth<Deep>(const T *const *)> deep_truth;
    std::function<Numbers(const std::vector<Numbers> &)> run;

    // Of a generic function of (R(), inputs) for numbers R.
    template <class Function>
    void set_truth(Function function)
    {
        truth = [=](const T *const *inputs) { return function(Quad(), inputs); };
        deep_truth = [=](const T *const *inputs) { return function(Deep(), inputs); };
    }
};

struct IsaClass {
    std::string name;  // fused or unfused: whether a multiply and an add are rounded once
    std::vector<std::string> isas;
};

// Those of the instruction sets that run here; only that of MOTORWAY_ISA if it is set.
std::vector<IsaClass> isa_classes();

struct Figures {
    double worst = 0, median = 0;
    double worst_angle = 0;
};

struct Errors {
    std::string isa_class;
    Figures rotation, translation;
};

struct Measured {
    std::vector<Errors> errors;
    double disagreement = 0;  // of the two kinds of true values where both were found: the largest, in epsilons
};

template <class T>
Measured measure(const Case<T> &measured, std::size_t count, std::uint64_t seed);

}  // namespace motorway::accuracy

#endif
