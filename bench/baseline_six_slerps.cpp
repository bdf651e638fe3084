// The library itself on cubic multiplicative Bézier motions in six calls: de Casteljau's tableau by slerp, a call for
// each of its motors, on controls in arrays of the layout of the results.
#include "api.h"
#include "baseline.h"

#include <array>
#include <memory>

namespace motorway::bench {
namespace {

// Control k of every element's motion.
template <class T> array<T> controls_of(const problem<T> &p, std::size_t k, std::size_t place)
{
    constexpr std::size_t components = components_of(operand::motor);
    array<T> made(components, p.out[0].stride() / sizeof(T), p.kind, p.count, place);
    const bool shared = p.controls.size() == bezier_controls * components;
    for (std::size_t i = 0; i < p.count; ++i)
        for (std::size_t c = 0; c < components; ++c)
            made.at(c, i) = p.controls[components * (k + (shared ? 0 : bezier_controls * i)) + c];
    return made;
}

// Level by level, from the controls to a single motor; made[k] is of the controls from k on.
template <class T> struct tableau {
    std::vector<array<T>> controls, made;

    explicit tableau(const problem<T> &p)
    {
        for (std::size_t k = 0; k < bezier_controls; ++k)
            controls.push_back(controls_of(p, k, components_of(operand::motor) * (k + 1)));
        for (std::size_t k = 0; k < motion_degree; ++k)
            made.push_back(controls_of(p, k, components_of(operand::motor) * (k + bezier_controls + 1)));
    }
};

} // namespace

template <class T> work bind_six_slerps(const problem<T> &p)
{
    if (p.kernel != "sample_multiplicative_one" && p.kernel != "sample_multiplicative_each")
        return {};
    const auto motors = std::make_shared<tableau<T>>(p);
    const auto slerp = [=, t = p.in[0].component()[0], count = p.count](const array<T> &out, const array<T> &first,
                                                                        const array<T> &second) {
        require(api<T>::slerp_motor_each(view_of<typename api<T>::motors>(out),
                                         view_of<typename api<T>::const_motors>(first),
                                         view_of<typename api<T>::const_motors>(second), t, sizeof(T), count,
                                         MW_DEFAULT));
    };
    return make_work([=, out = &p.out[0]] {
        const auto &c = motors->controls, &m = motors->made;
        slerp(m[0], c[0], c[1]);
        slerp(m[1], c[1], c[2]);
        slerp(m[2], c[2], c[3]);
        slerp(m[0], m[0], m[1]);
        slerp(m[1], m[1], m[2]);
        slerp(*out, m[0], m[1]);
    });
}

template work bind_six_slerps(const problem<float> &);
template work bind_six_slerps(const problem<double> &);

} // namespace motorway::bench
