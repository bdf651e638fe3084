#include "shape.h"

#include "dispatch.h"

#include <algorithm>
#include <stdexcept>

namespace motorway::bench {

void contestant::get_ready() const
{
    if (!select_isa(isa.c_str()))
        throw std::runtime_error("the instruction set " + isa + " does not run here");
}

template <class T, class M>
std::vector<contestant> contestants(const shape<T, M> &shape, const problem<T, M> &problem,
                                    const suite_settings &settings)
{
    std::vector<contestant> found;
    const auto offer = [&](const std::string &name, const std::string &isa, auto bind) {
        if (!settings.filter.matches(name))
            return;
        if (work todo = bind(problem))
            found.push_back({name, isa, std::move(todo)});
    };
    for (const std::string &isa : settings.isas)
        offer(shape.kernel_name(isa), isa, [&](const auto &p) { return shape.bind(p); });
    for (const auto &baseline : baselines<T, M>())
        offer(shape.baseline_name(baseline.name), settings.isas.front(), baseline.bind);
    return found;
}

template <class T, class M> bool is_wanted(const shape<T, M> &shape, const suite_settings &settings)
{
    const auto &isas = settings.isas;
    const auto &rivals = baselines<T, M>();
    return std::any_of(isas.begin(), isas.end(),
                       [&](const std::string &isa) { return settings.filter.matches(shape.kernel_name(isa)); }) ||
           std::any_of(rivals.begin(), rivals.end(), [&](const baseline<T, M> &rival) {
               return settings.filter.matches(shape.baseline_name(rival.name));
           });
}

#define MOTORWAY_INSTANTIATE(T, M)                                                                                   \
    template std::vector<contestant> contestants(const shape<T, M> &, const problem<T, M> &,                         \
                                                 const suite_settings &);                                            \
    template bool is_wanted(const shape<T, M> &, const suite_settings &);
MOTORWAY_INSTANTIATE(float, float)
MOTORWAY_INSTANTIATE(double, double)
MOTORWAY_INSTANTIATE(float, double)

} // namespace motorway::bench
