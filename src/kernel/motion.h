// The loops that sample motions, a register of parameters at a time.
#pragma once

#include "loop.h"
#include "motion_additive.h"
#include "motion_scheme.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// The samples of a register from number i on: n of them, in their place, at a local parameter.
template <class T, class Sample>
inline void sample_register(const motion_call<T> &c, std::size_t i, place<T> &where, const Sample &sample)
{
    const int n = c.count - i < width<T> ? static_cast<int>(c.count - i) : width<T>;
    const vector<T> t = into_domain(c, load_parameters(c, i, n));
    if (where.holds(t))
        where.move_to(c, i, n);
    else
        where.find(c, i, n, t);
    sample(n, where.local_parameter(t));
}

template <class T, class Scheme> MOTORWAY_LOOP void run_motion(const motion_call<T> &c)
{
    const result_stream<T, motor_size> out(c.out[0]);
    place<T> where;
    for (std::size_t i = 0; i < c.count; i += width<T>)
        sample_register(c, i, where, [&](int n, const jet<vector<T>> &u) {
            vector<T> pose[motor_size];
            Scheme::pose(c.degree, where, u, pose);
            out.store(i, n, pose);
        });
}

template <class T, class Scheme> MOTORWAY_LOOP void run_motion_twist(const motion_call<T> &c)
{
    const result_stream<T, motor_size> out(c.out[0]);
    const result_stream<T, bivector_size> twists(c.out[1]);
    place<T> where;
    for (std::size_t i = 0; i < c.count; i += width<T>)
        sample_register(c, i, where, [&](int n, const jet<vector<T>> &u) {
            vector<T> pose[motor_size], twist[bivector_size];
            Scheme::moving(c.degree, where, u, pose, twist);
            if (c.body_frame)
                into_body(pose, twist);
            out.store(i, n, pose);
            twists.store(i, n, twist);
        });
}

template <class T> bool are_sound(const motion_call<T> &c)
{
    const T largest = sizeof(T) == sizeof(float) ? T(3.4028234663852886e38) : T(1.7976931348623157e308);
    const bool any = c.treatment != outside::none;
    const T low = any ? -largest : c.begin, high = any ? largest : c.end;
    const std::size_t count = c.one_parameter ? 1 : c.count;
    for (std::size_t i = 0; i < count; i += width<T>) {
        const int n = count - i < width<T> ? static_cast<int>(count - i) : width<T>;
        if (!all_between(load_parameters(c, i, n), low, high))
            return false;
    }
    return true;
}

// In the order of `scheme`.
template <class T>
constexpr motion_kernels<T> kernels_of_motions = {
    are_sound<T>,
    {run_additive_motion<T>, run_motion<T, multiplicative_scheme>, run_motion<T, cumulative_scheme>,
     run_motion<T, generator_scheme>},
    {run_motion_twist<T, additive_scheme>, run_motion_twist<T, multiplicative_scheme>,
     run_motion_twist<T, cumulative_scheme>, run_motion_twist<T, generator_scheme>},
};

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
