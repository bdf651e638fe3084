// The library itself on vertices in two calls, positions and then normals: what apply_vertex_one saves.
#include "api.h"
#include "baseline.h"

namespace motorway::bench {

template <class T> work bind_two_passes(const problem<T> &p)
{
    if (p.kernel != "apply_vertex_one")
        return {};
    using functions = apply_functions<operand::vertex, T, T>;
    const auto in = view_of<typename functions::const_view>(p.in[0]);
    const auto out = view_of<typename functions::view>(p.out[0]);
    const auto *const motor = reinterpret_cast<const typename api<T>::motor *>(p.fixed.data());
    return make_work([=, count = p.count] {
        require(apply_functions<operand::point, T, T>::one(out.position, motor, in.position, count, MW_DEFAULT));
        require(apply_functions<operand::direction, T, T>::one(out.normal, motor, in.normal, count, MW_DEFAULT));
    });
}

template work bind_two_passes(const problem<float> &);
template work bind_two_passes(const problem<double> &);

} // namespace motorway::bench
