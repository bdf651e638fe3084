// Functions that should undo each other, against what went in.
#include <cmath>

#include "cases.h"
#include "library.h"
#include "sizes.h"

namespace motorway::accuracy {
namespace {

constexpr const char *section = "identities";
constexpr const char *the_given = "the one given";
constexpr const char *over_sine = "the one given / sin φ/2";

// Beyond a half turn the moment of the principal logarithm is only as good as its motor: see docs/accuracy.md.
enum class Reach { to_a_half_turn, beyond };

// ---------------------------------------------------------------------------------------------------- exp(log S) = S

template <class T>
Case<T> exp_of_log_case(const Angles &angles, Branch branch, Reach reach)
{
    const bool principal = branch == Branch::principal, beyond = reach == Reach::beyond;
    Case<T> c;
    c.title = {section, principal ? "exp(log_principal S) = S" : "exp(log S) = ±S", angles.name, of_1,
               beyond ? over_sine : the_given, 6};
    if (beyond)
        c.title.function += ", beyond a half turn";
    c.input_sizes = {8};
    c.draw = [=](Random &random, T *const *inputs) {
        const double angle = angles.draw(random), sign = !principal && random.chance(2) ? -1 : 1;
        round_to(multiple(Quad(sign), draw_exact_motor(random, angle)), inputs[0]);
        return angle;
    };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto motor = exactly<R, 8>(inputs[0]);
        Truth<R> truth = by_its_own_size(motor);
        if (beyond)
            truth.translation /= length(motor, 1, 4);
        if (!principal || motor[0] == 0)
            truth.other = negated(motor);
        return truth;
    });
    c.run = [=](const auto &inputs) {
        const auto function = principal ? api<T>::log_principal_motor_each : api<T>::log_motor_each;
        return Library<T>::exp(Library<T>::log(function, inputs[0], MW_UNIT_MOTORS));
    };
    return c;
}

// ---------------------------------------------------------------------------------------------------- log(exp B) = B

template <class T>
Case<T> log_of_exp_case(const Angles &angles, Branch branch, Reach reach)
{
    const bool principal = branch == Branch::principal, beyond = reach == Reach::beyond;
    Case<T> c;
    c.title = {section, principal ? "log_principal(exp B) = B" : "log(exp B) = B", angles.name, the_given,
               beyond ? over_sine : the_given, 6};
    if (beyond)
        c.title.function += ", beyond a half turn";
    c.input_sizes = {6};
    c.result_size = 6;
    c.draw = [=](Random &random, T *const *inputs) {
        const double angle = angles.draw(random);
        round_to(draw_generator(random, angle), inputs[0]);
        return angle;
    };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        using std::sin;
        Truth<R> truth = by_its_own_size(exactly<R, 6>(inputs[0]));
        if (beyond)
            truth.translation /= sin(truth.rotation);
        return truth;
    });
    c.run = [=](const auto &inputs) {
        const auto function = principal ? api<T>::log_principal_motor_each : api<T>::log_motor_each;
        return Library<T>::log(function, Library<T>::exp(inputs[0]), MW_UNIT_MOTORS);
    };
    return c;
}

// ------------------------------------------------------------------------------------------------ exp(b)ⁿ = exp(nb)

template <class T>
Case<T> power_of_exp_case(const Angles &angles, int n)
{
    Case<T> c;
    c.title = {"chains", "exp(b)ⁿ = exp(nb), " + angles.name, "n = " + std::to_string(n), "n",
               "n times the moment of nb", 1};
    c.input_sizes = {6};
    c.draw = [=](Random &random, T *const *inputs) {
        const double angle = angles.draw(random);
        round_to(draw_generator(random, angle, usual_lengths), inputs[0]);
        return angle;
    };
    c.set_truth([=](auto number, const T *const *inputs) {
        using R = decltype(number);
        const Bivector<R> sum = multiple(R(n), exactly<R, 6>(inputs[0]));
        return Truth<R>{exp(sum), R(n), n * length(sum, 3, 6)};
    });
    c.run = [=](const auto &inputs) {
        const auto factor = Library<T>::exp(inputs[0]);
        auto product = factor;
        for (int k = 1; k < n; ++k)
            product = Library<T>::compose(product, factor);
        return product;
    };
    return c;
}

}  // namespace

template <class T>
std::vector<Case<T>> identity_cases()
{
    const Angles to_almost_a_half_turn = evenly("to a half turn less 10⁻⁶ rad", 0, turn / 2 - 1e-6);
    const Angles beyond_a_half_turn = evenly("a half turn to a full turn less 0.1 rad", turn / 2, turn - 0.1);
    std::vector<Case<T>> cases;
    for (const Angles &angles : {nothing, tiny_angles, to_a_turn, around_a_half_turn, around_a_turn})
        cases.push_back(exp_of_log_case<T>(angles, Branch::shortest, Reach::to_a_half_turn));
    cases.push_back(exp_of_log_case<T>(to_a_half_turn, Branch::principal, Reach::to_a_half_turn));
    cases.push_back(exp_of_log_case<T>(beyond_a_half_turn, Branch::principal, Reach::beyond));
    for (const Angles &angles : {nothing, tiny_angles, to_almost_a_half_turn})
        cases.push_back(log_of_exp_case<T>(angles, Branch::shortest, Reach::to_a_half_turn));
    for (const Angles &angles : {to_a_half_turn, around_a_half_turn})
        cases.push_back(log_of_exp_case<T>(angles, Branch::principal, Reach::to_a_half_turn));
    cases.push_back(log_of_exp_case<T>(beyond_a_half_turn, Branch::principal, Reach::beyond));
    for (const Angles &angles : {evenly("to 1 rad", 0, 1), evenly("to a half turn", 0, turn / 2),
                                 evenly("to 6 rad", 0, 6)})
        for (int n : {2, 10, 100, 1000})
            cases.push_back(power_of_exp_case<T>(angles, n));
    return cases;
}

template std::vector<Case<float>> identity_cases();
template std::vector<Case<double>> identity_cases();

}  // namespace motorway::accuracy
