// What a tester is told about a kernel: its operands, how to call it, how to draw inputs for it, and what must come
// out, with the tolerance. One class a kernel derives from it; see apply_tester.h and its neighbours.
#ifndef MOTORWAY_TESTS_SUBJECT_H
#define MOTORWAY_TESTS_SUBJECT_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "api.h"
#include "random.h"
#include "reference.h"

namespace motorway::testing {

// By the views that the API takes them in. The index of an element's motor is drawn as a number, and the subject
// makes an array of indices of it. Numbers are an array of exponents or parameters. A pose is two views, of four
// numbers for the rotation and of three for the translation, and vertices are two of three. A matrix is a pointer to
// adjacent numbers.
enum class Operand {
    xyz, xyzw, vertices, vectors, lines, motors, bivectors, dual_quaternions, poses, matrices_3x4, matrices_4x4,
    weights, numbers, indices
};

// Of one element; of weights there are as many as a blend has terms.
constexpr std::size_t components_of(Operand operand)
{
    switch (operand) {
    case Operand::xyz: return 3;
    case Operand::xyzw: return 4;
    case Operand::vertices: return 6;
    case Operand::vectors: return 5;
    case Operand::lines: return 6;
    case Operand::motors: return 8;
    case Operand::bivectors: return 6;
    case Operand::dual_quaternions: return 8;
    case Operand::poses: return 7;
    case Operand::matrices_3x4: return 12;
    case Operand::matrices_4x4: return 16;
    default: return 1;
    }
}

// Of the view with the most, which the stride must have room for.
constexpr std::size_t components_of_a_view(Operand operand)
{
    switch (operand) {
    case Operand::vertices: return 3;
    case Operand::poses: return 4;
    default: return components_of(operand);
    }
}

constexpr bool is_matrix(Operand operand)
{
    return operand == Operand::matrices_3x4 || operand == Operand::matrices_4x4;
}

// The exact components of an element of the result, and how far from each the computed one may be.
struct Expected {
    std::vector<reference::Real> value;
    std::vector<long double> tolerance;
};

// Motors and bivectors have their rotation in the first half and their translation in the second.
template <std::size_t N>
Expected expect_parts(const std::array<reference::Real, N> &value, long double rotation, long double translation)
{
    Expected expected{{value.begin(), value.end()}, std::vector<long double>(N, rotation)};
    std::fill(expected.tolerance.begin() + N / 2, expected.tolerance.end(), translation);
    return expected;
}

template <class T>
class Subject {
public:
    struct Input {
        Operand operand;
        std::size_t components;
        std::size_t scalar = sizeof(T);  // bytes a component: motors of mixed functions have doubles among floats

        // How many T an element takes.
        std::size_t size() const { return components * scalar / sizeof(T); }
    };

    virtual ~Subject() = default;

    virtual std::string name() const = 0;
    virtual std::vector<Input> inputs() const = 0;
    virtual Operand output() const = 0;
    virtual mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const = 0;

    // Whether no byte of an input may lie between those of the output, so that nothing is in place or interleaved.
    virtual bool keeps_apart() const { return false; }

    // Flags for the runs from now on; kernels that have none do not mind.
    virtual void add_flags(unsigned) {}

    // Draws the inputs of one element; inputs[k] points to the components of input k.
    virtual void draw(Random &random, T *const *inputs) const = 0;
    virtual Expected expect(const T *const *inputs) const = 0;

    std::size_t output_components() const { return components_of(output()); }
};

template <class T>
using Subjects = std::vector<std::unique_ptr<Subject<T>>>;

// The unit of every tolerance. An operation has a relative error of at most half of it.
template <class T>
constexpr long double epsilon = std::numeric_limits<T>::epsilon();

// Half the spacing of subnormal numbers: what an operation that underflows is off by, at most.
template <class T>
constexpr long double underflow = static_cast<long double>(std::numeric_limits<T>::denorm_min()) / 2;

// The dense reference has terms in e+ and e- that cancel, up to the product of the sizes of its operands; this is
// what it loses by that. It matters only where the exact result is all but zero beside its operands.
inline long double reference_error(long double largest_term) { return 0x1p-118L * largest_term; }

// The sum of the magnitudes of a few components.
template <class T>
long double size_of(const T *components, std::size_t count)
{
    long double sum = 0;
    for (std::size_t k = 0; k < count; ++k)
        sum += std::abs(static_cast<long double>(components[k]));
    return sum;
}

template <std::size_t N, class T>
std::array<reference::Real, N> exact_numbers(const T *components)
{
    std::array<reference::Real, N> numbers;
    for (std::size_t k = 0; k < N; ++k)
        numbers[k] = reference::Real(components[k]);
    return numbers;
}

template <class T>
reference::Motor exact_motor(const T *components) { return exact_numbers<8>(components); }
template <class T>
reference::Bivector exact_bivector(const T *components) { return exact_numbers<6>(components); }
template <class T>
reference::Vector3 exact_vector(const T *components) { return exact_numbers<3>(components); }

}  // namespace motorway::testing

#endif
