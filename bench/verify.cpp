#include "verify.h"

#include "schedule.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace motorway::bench {
namespace {

// A count with a tail for every vector width.
constexpr std::size_t verified_count = 1023;

template <class T, class M>
std::vector<T> results_of(const contestant &contestant, const problem<T, M> &problem)
{
    const array<T> &out = problem.out;
    const auto for_each_number = [&](auto visit) {
        for (std::size_t i = 0; i < problem.results(); ++i)
            for (std::size_t k = 0; k < out.components(); ++k)
                visit(out.at(k, i));
    };
    for_each_number([](T &number) { number = std::numeric_limits<T>::quiet_NaN(); });
    contestant.get_ready();
    contestant.todo.once();
    if (contestant.todo.publish)
        contestant.todo.publish();
    std::vector<T> results;
    for_each_number([&](T number) { results.push_back(number); });
    return results;
}

// Numbers are of the order of one, and some tens of roundings are in each. False for what is not a number.
template <class T> bool are_close(T a, T b)
{
    return std::abs(a - b) <= 64 * std::numeric_limits<T>::epsilon() * (1 + std::abs(b));
}

template <class T>
void require_close(const std::string &name, const std::vector<T> &results, const std::vector<T> &expected,
                   std::size_t components)
{
    const auto differ = std::mismatch(expected.begin(), expected.end(), results.begin(), are_close<T>);
    if (differ.first == expected.end())
        return;
    const auto i = static_cast<std::size_t>(differ.first - expected.begin());
    std::ostringstream message;
    message << name << ": component " << i % components << " of element " << i / components << " is "
            << std::setprecision(std::numeric_limits<T>::max_digits10) << *differ.second << ", but the kernel's is "
            << *differ.first;
    throw std::runtime_error(message.str());
}

template <class T, class M> void verify(const shape<T, M> &shape, const suite_settings &settings)
{
    const auto problem = shape.make_problem();
    const std::string &isa = settings.isas.front();
    const auto expected = results_of({shape.kernel_name(isa), isa, shape.bind(problem)}, problem);
    for (const contestant &contestant : contestants(shape, problem, settings))
        require_close(contestant.name, results_of(contestant, problem), expected, problem.out.components());
}

} // namespace

void verify(const suite_settings &settings)
{
    suite_settings all = settings;
    all.filter = filter("");
    for_each_shape(verified_count, [&](const auto &verified) {
        // The filter may name a count.
        const std::vector<std::size_t> measured = counts(settings.quick);
        const bool wanted = std::any_of(measured.begin(), measured.end(), [&](std::size_t count) {
            auto shape = verified;
            shape.count = count;
            return is_scheduled(shape, settings.quick) && is_wanted(shape, settings);
        });
        if (wanted)
            verify(verified, all);
    });
}

} // namespace motorway::bench
