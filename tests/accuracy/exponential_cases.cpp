// exp, log, roots and powers against their true values.
#include "cases.h"
#include "library.h"
#include "sizes.h"

namespace motorway::accuracy {
namespace {

constexpr const char *section = "functions";
constexpr const char *over_sine = "the translation given / sin φ/2";

// ------------------------------------------------------------------------------------------------------------- exp

// What errors are relative to: the true value; what is given, for by a full turn a translation comes to nothing and
// its errors do not; or that times the angle.
enum class Relative { to_result, to_given, to_angle };

template <class T>
Case<T> exp_case(const std::string &function, const Angles &angles, Relative relative)
{
    Case<T> c;
    c.title = {section, function, angles.name, of_1, itself, 4};
    if (relative == Relative::to_given)
        c.title.translation = "the moment given";
    if (relative == Relative::to_angle) {
        c.title.rotation = "φ";
        c.title.translation = "φ times the moment given";
        c.title.asked = 0;
    }
    c.input_sizes = {6};
    c.draw = [=](Random &random, T *const *inputs) {
        const double angle = angles.draw(random);
        round_to(draw_generator(random, angle), inputs[0]);
        return angle;
    };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto bivector = exactly<R, 6>(inputs[0]);
        Truth<R> truth = by_its_own_size(exp(bivector));
        if (relative != Relative::to_result)
            truth.translation = length(bivector, 3, 6);
        if (relative == Relative::to_angle) {
            truth.rotation = 2 * length(bivector, 0, 3);
            truth.translation *= truth.rotation;
        }
        return truth;
    });
    c.run = [](const auto &inputs) { return Library<T>::exp(inputs[0]); };
    return c;
}

// ------------------------------------------------------------------------------------------------------------- log

enum class Given { unit, any };

// Of either sign; of any length if that is given.
template <class T>
double draw_motor(Random &random, const Angles &angles, Given given, T *components)
{
    const double angle = angles.draw(random);
    const double sign = random.chance(2) ? -1 : 1, size = given == Given::unit ? 1 : draw_size(random, 1e-3, 1e3);
    round_to(multiple(Quad(sign * size), draw_exact_motor(random, angle)), components);
    if (angle == turn / 2)  // which is not quite a half turn
        components[0] = static_cast<T>(sign * 0.0);
    return angle;
}

// Exact half turns have two shortest logarithms.
template <class R>
Truth<R> log_truth(const Motor<R> &motor, Branch branch)
{
    Truth<R> truth = by_its_own_size(log(motor, branch));
    if (motor[0] == 0)
        truth.other = by_its_own_size(log(negated(motor), branch)).value;
    return truth;
}

template <class T>
Case<T> log_case(const Angles &angles, Given given)
{
    Case<T> c;
    c.title = {section, given == Given::unit ? "log" : "log, motors of any length", angles.name, itself, itself, 4};
    c.input_sizes = {8};
    c.result_size = 6;
    c.draw = [=](Random &random, T *const *inputs) { return draw_motor(random, angles, given, inputs[0]); };
    c.set_truth([](auto number, const T *const *inputs) {
        return log_truth(exactly<decltype(number), 8>(inputs[0]), Branch::shortest);
    });
    c.run = [=](const auto &inputs) {
        return Library<T>::log(api<T>::log_motor_each, inputs[0], given == Given::unit ? MW_UNIT_MOTORS : MW_DEFAULT);
    };
    return c;
}

// Beyond a half turn the moment is the difference of two terms that grow as 1/sin: see docs/accuracy.md.
template <class T>
Case<T> log_principal_case(const std::string &function, const Angles &angles, Relative relative)
{
    const bool to_given = relative == Relative::to_given;
    Case<T> c;
    c.title = {section, function, angles.name, itself, to_given ? over_sine : itself, to_given ? 0.0 : 4.0};
    c.input_sizes = {8};
    c.result_size = 6;
    c.draw = [=](Random &random, T *const *inputs) {
        const double angle = angles.draw(random);
        round_to(draw_exact_motor(random, angle), inputs[0]);
        return angle;
    };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto motor = exactly<R, 8>(inputs[0]);
        const bool has_axis = length(motor, 1, 4) > R(0x1p-40);  // as motorway.h has it
        Truth<R> truth = log_truth(motor, has_axis ? Branch::principal : Branch::shortest);
        if (to_given && has_axis)
            truth.translation = length(motor, 4, 8) / length(motor, 1, 4);
        return truth;
    });
    c.run = [](const auto &inputs) { return Library<T>::log(api<T>::log_principal_motor_each, inputs[0], MW_UNIT_MOTORS); };
    return c;
}

// ------------------------------------------------------------------------------------------------ roots and powers

template <class T>
Case<T> sqrt_case(const Angles &angles)
{
    Case<T> c;
    c.title = {section, "sqrt", angles.name, of_1, itself};
    c.input_sizes = {8};
    c.draw = [=](Random &random, T *const *inputs) { return draw_motor(random, angles, Given::unit, inputs[0]); };
    c.set_truth([](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto motor = exactly<R, 8>(inputs[0]);
        Truth<R> truth = by_its_own_size(power(motor, R(0.5)));
        if (motor[0] == 0)
            truth.other = power(negated(motor), R(0.5));
        return truth;
    });
    c.run = [](const auto &inputs) { return Library<T>::sqrt(inputs[0]); };
    return c;
}

// An error of the logarithm is multiplied by the exponent; one of its angle meets a moment that is as well.
template <class T>
Case<T> power_case(const Angles &angles, const std::string &exponents, double low, double high)
{
    Case<T> c;
    c.title = {section, "power", angles.name + ", " + exponents, "t, or 1", "t², or 1, times the moment of log"};
    c.input_sizes = {8, 1};
    c.draw = [=](Random &random, T *const *inputs) {
        *inputs[1] = static_cast<T>(random.uniform(low, high));
        return draw_motor(random, angles, Given::unit, inputs[0]);
    };
    c.set_truth([](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto motor = exactly<R, 8>(inputs[0]);
        const R exponent = *inputs[1], size = exponent < -1 ? R(-exponent) : exponent < 1 ? R(1) : exponent;
        const R moment = length(log(motor, Branch::shortest), 3, 6);
        Truth<R> truth = {power(motor, exponent), size, size * size * moment};
        if (motor[0] == 0)
            truth.other = power(negated(motor), exponent);
        return truth;
    });
    c.run = [](const auto &inputs) { return Library<T>::power(inputs[0], inputs[1]); };
    return c;
}

// ------------------------------------------------------------------------------------------------------- all of them

template <class T>
void add_exponentials(std::vector<Case<T>> &cases)
{
    for (const Angles &angles : {nothing, tiny_angles, to_a_half_turn, around_a_half_turn})
        cases.push_back(exp_case<T>("exp, to a half turn", angles, Relative::to_result));
    for (const Angles &angles : {a_half_to_two_turns, around_a_turn, around_two_turns})
        cases.push_back(exp_case<T>("exp, to two turns", angles, Relative::to_given));
    for (Relative relative : {Relative::to_given, Relative::to_angle})
        cases.push_back(exp_case<T>(relative == Relative::to_given ? "exp, beyond" : "exp, beyond, of φ",
                                    two_to_many_turns, relative));
    cases.push_back(exp_case<T>(std::string("exp, to two turns") + own_size, a_half_to_two_turns,
                                Relative::to_result));
}

template <class T>
void add_logarithms(std::vector<Case<T>> &cases)
{
    for (Given given : {Given::unit, Given::any})
        for (const Angles &angles : {nothing, tiny_angles, to_a_turn, around_a_half_turn, around_a_turn})
            cases.push_back(log_case<T>(angles, given));
    for (const Angles &angles : {nothing, tiny_angles, to_a_half_turn, around_a_half_turn})
        cases.push_back(log_principal_case<T>("log_principal, to a half turn", angles, Relative::to_result));
    const Angles a_half_to_a_turn = evenly("a half turn to a full turn", turn / 2, turn);
    for (const Angles &angles : {a_half_to_a_turn, around_a_turn})
        cases.push_back(log_principal_case<T>("log_principal, to a full turn", angles, Relative::to_given));
    cases.push_back(log_principal_case<T>(std::string("log_principal, to a full turn") + own_size, a_half_to_a_turn,
                                          Relative::to_result));
}

}  // namespace

template <class T>
std::vector<Case<T>> exponential_cases()
{
    std::vector<Case<T>> cases;
    add_exponentials(cases);
    add_logarithms(cases);
    for (const Angles &angles : {nothing, tiny_angles, to_a_turn, around_a_half_turn, around_a_turn})
        cases.push_back(sqrt_case<T>(angles));
    for (const Angles &angles : {tiny_angles, to_a_turn}) {
        cases.push_back(power_case<T>(angles, "t in [0, 1]", 0, 1));
        cases.push_back(power_case<T>(angles, "t in [-8, 8]", -8, 8));
    }
    return cases;
}

template <class T>
std::vector<Curve<T>> exponential_curves()
{
    return {{"exp", [](const Angles &angles) { return exp_case<T>("exp", angles, Relative::to_given); }},
            {"log", [](const Angles &angles) { return log_case<T>(angles, Given::unit); }}};
}

template std::vector<Case<float>> exponential_cases();
template std::vector<Case<double>> exponential_cases();
template std::vector<Curve<float>> exponential_curves();
template std::vector<Curve<double>> exponential_curves();

}  // namespace motorway::accuracy
