#include "shape.h"

#include "dispatch.h"

#include <algorithm>
#include <stdexcept>

namespace motorway::bench {

void contestant::get_ready() const
{
    if (!isa.empty() && !select_isa(isa.c_str()))
        throw std::runtime_error("the instruction set " + isa + " does not run here");
}

template <class T>
std::vector<contestant> contestants(const shape<T> &shape, const problem<T> &problem, const suite_settings &settings)
{
    std::vector<contestant> found;
    const auto offer = [&](const std::string &name, const std::string &isa, auto bind) {
        if (!settings.filter.matches(name))
            return;
        if (work todo = bind(problem))
            found.push_back({name, isa, std::move(todo)});
    };
    for (const std::string &isa : settings.isas)
        offer(shape.kernel_name(isa), isa, [&](const auto &p) { return shape.row.bind(p); });
    for (const auto &baseline : baselines<T>())
        offer(shape.baseline_name(baseline.name), "", baseline.bind);
    return found;
}

template <class T> bool is_wanted(const shape<T> &shape, const suite_settings &settings)
{
    const auto &isas = settings.isas;
    const auto &rivals = baselines<T>();
    return std::any_of(isas.begin(), isas.end(),
                       [&](const std::string &isa) { return settings.filter.matches(shape.kernel_name(isa)); }) ||
           std::any_of(rivals.begin(), rivals.end(), [&](const baseline<T> &rival) {
               return settings.filter.matches(shape.baseline_name(rival.name));
           });
}

template std::vector<contestant> contestants(const shape<float> &, const problem<float> &, const suite_settings &);
template std::vector<contestant> contestants(const shape<double> &, const problem<double> &, const suite_settings &);
template bool is_wanted(const shape<float> &, const suite_settings &);
template bool is_wanted(const shape<double> &, const suite_settings &);

} // namespace motorway::bench
