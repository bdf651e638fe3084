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

// Calls visit(number, component, element) for all that the problem has of results.
template <class T, class M, class F> void for_each_number(const problem<T, M> &problem, F visit)
{
    for (const array<T> &out : problem.out)
        for (std::size_t i = 0; i < problem.results(); ++i)
            for (std::size_t k = 0; k < out.components(); ++k)
                visit(out.at(k, i), k, i);
}

template <class T, class M> void run_once(const contestant &contestant, const problem<T, M> &problem)
{
    for_each_number(problem, [](T &number, auto...) { number = std::numeric_limits<T>::quiet_NaN(); });
    contestant.get_ready();
    contestant.todo.once();
    if (contestant.todo.publish)
        contestant.todo.publish();
}

template <class T, class M>
std::vector<T> results_of(const contestant &contestant, const problem<T, M> &problem)
{
    run_once(contestant, problem);
    std::vector<T> results;
    for_each_number(problem, [&](T number, auto...) { results.push_back(number); });
    return results;
}

// Numbers are of the order of one, and some tens of roundings are in each. False for what is not a number.
template <class T> bool are_close(T a, T b)
{
    return std::abs(a - b) <= 64 * std::numeric_limits<T>::epsilon() * (1 + std::abs(b));
}

template <class T, class M>
void require_close(const contestant &contestant, const problem<T, M> &problem, const std::vector<T> &expected)
{
    run_once(contestant, problem);
    auto wanted = expected.begin();
    for_each_number(problem, [&](T number, std::size_t component, std::size_t element) {
        const T kernels = *wanted++;
        if (component >= contestant.todo.components || are_close(number, kernels))
            return;
        std::ostringstream message;
        message << contestant.name << ": component " << component << " of element " << element << " is "
                << std::setprecision(std::numeric_limits<T>::max_digits10) << number << ", but the kernel's is "
                << kernels;
        throw std::runtime_error(message.str());
    });
}

template <class T, class M> void verify(const shape<T, M> &shape, const suite_settings &settings)
{
    const auto problem = shape.make_problem();
    const std::string &isa = settings.isas.front();
    const auto expected = results_of({shape.kernel_name(isa), isa, shape.bind(problem)}, problem);
    for (const contestant &contestant : contestants(shape, problem, settings))
        require_close(contestant, problem, expected);
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
