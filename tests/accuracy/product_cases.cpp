// Products, interpolation and normalising against their true values.
#include <algorithm>

#include "cases.h"
#include "library.h"
#include "sizes.h"

namespace motorway::accuracy {
namespace {

constexpr const char *section = "functions";

// Two poses, so far apart.
template <class T>
double draw_poses(Random &random, const Angles &angles, T *first, T *second)
{
    const double angle = angles.draw(random);
    const Motor<Quad> from = draw_exact_motor(random, to_a_turn.draw(random), usual_lengths);
    round_to(from, first);
    round_to(compose(from, draw_exact_motor(random, angle, usual_lengths)), second);
    return angle;
}

template <class T>
Case<T> product_case(const std::string &function, const Angles &angles)
{
    const bool is_ratio = function == "ratio";
    Case<T> c;
    c.title = {section, function, angles.name, of_1, "the sum of the translations given"};
    c.input_sizes = {8, 8};
    c.draw = [=](Random &random, T *const *inputs) { return draw_poses(random, angles, inputs[0], inputs[1]); };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto a = exactly<R, 8>(inputs[0]), b = exactly<R, 8>(inputs[1]);
        return Truth<R>{compose(is_ratio ? reverse(a) : a, b), 1, length(a, 4, 8) + length(b, 4, 8)};
    });
    c.run = [=](const auto &inputs) {
        return is_ratio ? Library<T>::ratio(inputs[0], inputs[1], MW_UNIT_MOTORS)
                        : Library<T>::compose(inputs[0], inputs[1]);
    };
    return c;
}

// Mostly anywhere, some very close to the ends.
template <class T>
T draw_parameter(Random &random, double low, double high)
{
    const double near = draw_size(random, 1e-10, 1);
    switch (random.below(8)) {
    case 0: return static_cast<T>(low + near);
    case 1: return static_cast<T>(high - near);
    default: return static_cast<T>(random.uniform(low, high));
    }
}

// What errors of translations are relative to: the true value; the larger translation given, which may cancel against
// the other; where the way goes on beyond them, the largest of all three; and on the long way the larger one over the
// square of the sine of half the angle apart, for the screw between near poses is that little determined.
enum class Size { of_result, of_larger, of_largest, of_larger_over_sine };

struct Interpolation {
    std::string function, parameters;
    bool along_a_screw;  // slerp; else nlerp
    unsigned flags;
    double low, high;  // of the parameters
    Size size;
};

const char *name_of(Size size)
{
    switch (size) {
    case Size::of_result: return itself;
    case Size::of_larger: return "the larger translation given";
    case Size::of_largest: return "the largest translation";
    default: return "the larger translation given / sin² φ/2";
    }
}

// Towards `second` or its negative: at half turns, where rounding decides, towards either.
template <class R>
Truth<R> interpolation_truth(const Interpolation &of, const Motor<R> &first, const Motor<R> &second, const R &t)
{
    const auto towards = [&](const Motor<R> &end) {
        return of.along_a_screw ? slerp(first, end, t) : nlerp(first, end, t);
    };
    const R cosine = dot(first, second);
    const bool same_sign = (cosine < 0) == ((of.flags & MW_LONG_WAY) != 0);
    const R larger = std::max(length(first, 4, 8), length(second, 4, 8));
    Truth<R> truth = by_its_own_size(towards(same_sign ? second : negated(second)));
    if (cosine < R(1e-6) && cosine > R(-1e-6))
        truth.other = towards(same_sign ? negated(second) : second);
    switch (of.size) {
    case Size::of_result: break;
    case Size::of_larger: truth.translation = larger; break;
    case Size::of_largest: truth.translation = std::max(larger, truth.translation); break;
    case Size::of_larger_over_sine: truth.translation = larger / (1 - cosine * cosine); break;
    }
    return truth;
}

template <class T>
Case<T> interpolation_case(const Interpolation &of, const Angles &angles)
{
    Case<T> c;
    c.title = {section, of.function, angles.name + " apart, " + of.parameters, of_1, name_of(of.size),
               of.along_a_screw ? 4.0 : 0.0};
    c.input_sizes = {8, 8, 1};
    c.draw = [=](Random &random, T *const *inputs) {
        *inputs[2] = draw_parameter<T>(random, of.low, of.high);
        return draw_poses(random, angles, inputs[0], inputs[1]);
    };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        return interpolation_truth(of, exactly<R, 8>(inputs[0]), exactly<R, 8>(inputs[1]), R(*inputs[2]));
    });
    c.run = [=](const auto &inputs) {
        return Library<T>::interpolate(of.along_a_screw ? api<T>::slerp_motor_each : api<T>::nlerp_motor_each, inputs[0], inputs[1],
                                       inputs[2], of.flags);
    };
    return c;
}

const Interpolation slerp_short = {"slerp", "t in [0, 1]", true, MW_DEFAULT, 0, 1, Size::of_larger};
const Interpolation slerp_outside = {"slerp, outside", "t in [-1, 2]", true, MW_DEFAULT, -1, 2, Size::of_largest};
const Interpolation slerp_long = {"slerp, the long way", "t in [0, 1]", true, MW_LONG_WAY, 0, 1,
                                  Size::of_larger_over_sine};
const Interpolation nlerp_short = {"nlerp", "t in [0, 1]", false, MW_DEFAULT, 0, 1, Size::of_larger};

Interpolation of_its_own_size(Interpolation of)
{
    of.function += own_size;
    of.size = Size::of_result;
    return of;
}

// ----------------------------------------------------------------------------------------------------- normalising

// The product of 64 motors as the library rounds it, each one of a thousand.
template <class T>
Case<T> normalize_case()
{
    std::vector<std::vector<T>> factors(1000, std::vector<T>(8));
    Random source(1);
    for (std::vector<T> &factor : factors)
        round_to(draw_exact_motor(source, to_a_turn.draw(source), usual_lengths), factor.data());
    Case<T> c;
    c.title = {section, "normalize", "products of 64 unit motors", of_1, itself};
    c.input_sizes = {8};
    c.draw = [factors](Random &random, T *const *inputs) {
        std::vector<T> product = factors[random.below(factors.size())];
        for (int k = 1; k < 64; ++k)
            product = Library<T>::compose(product, factors[random.below(factors.size())]);
        std::copy(product.begin(), product.end(), inputs[0]);
        return 0.0;
    };
    c.set_truth([](auto number, const T *const *inputs) {
        return by_its_own_size(normalize(exactly<decltype(number), 8>(inputs[0])));
    });
    c.run = [](const auto &inputs) { return Library<T>::normalize(inputs[0]); };
    return c;
}

template <class T>
void add_interpolations(std::vector<Case<T>> &cases)
{
    for (const Interpolation &of : {slerp_short, nlerp_short})
        for (const Angles &angles : {nothing, tiny_angles, to_a_turn, around_a_half_turn, around_a_turn})
            cases.push_back(interpolation_case<T>(of, angles));
    cases.push_back(interpolation_case<T>(of_its_own_size(slerp_short), to_a_turn));
    cases.push_back(interpolation_case<T>(slerp_outside, to_a_turn));
    const Angles near = evenly("0.1 rad to a quarter turn", 0.1, turn / 4);
    const Angles far = evenly("a quarter to a half turn", turn / 4, turn / 2);
    for (const Angles &angles : {near, far})
        cases.push_back(interpolation_case<T>(slerp_long, angles));
    cases.push_back(interpolation_case<T>(of_its_own_size(slerp_long), far));
}

}  // namespace

template <class T>
std::vector<Case<T>> product_cases()
{
    std::vector<Case<T>> cases;
    add_interpolations(cases);
    for (const char *function : {"compose", "ratio"})
        cases.push_back(product_case<T>(function, to_a_turn));
    cases.push_back(normalize_case<T>());
    return cases;
}

template <class T>
std::vector<Curve<T>> product_curves()
{
    return {{"slerp", [](const Angles &angles) { return interpolation_case<T>(slerp_short, angles); }}};
}

template std::vector<Case<float>> product_cases();
template std::vector<Case<double>> product_cases();
template std::vector<Curve<float>> product_curves();
template std::vector<Curve<double>> product_curves();

}  // namespace motorway::accuracy
