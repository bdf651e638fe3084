// The functions that are measured, on packed numbers: eight a motor, six a bivector.
#ifndef MOTORWAY_TESTS_ACCURACY_LIBRARY_H
#define MOTORWAY_TESTS_ACCURACY_LIBRARY_H

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "motorway_views.h"

namespace motorway::accuracy {

inline void check(mw_status status)
{
    if (status != MW_OK)
        throw std::runtime_error(mw_status_text(status));
}

// api<T>, from the table of public functions.
#include "../../generated/api.inc"

template <class T>
struct Library {
    using A = api<T>;
    using Numbers = std::vector<T>;

    static Numbers exp(const Numbers &bivectors)
    {
        const std::size_t count = bivectors.size() / 6;
        Numbers out(8 * count);
        check(A::exp_motor_each(motors(out), A::const_bivectors_aos(bivectors.data(), sizeof(T[6])), count));
        return out;
    }

    // By mw_log_motor_each or mw_log_principal_motor_each.
    template <class Function>
    static Numbers log(Function function, const Numbers &in, unsigned flags)
    {
        const std::size_t count = in.size() / 8;
        Numbers out(6 * count);
        check(function(A::bivectors_aos(out.data(), sizeof(T[6])), motors(in), count, flags));
        return out;
    }

    static Numbers sqrt(const Numbers &in)
    {
        Numbers out(in.size());
        check(A::sqrt_motor_each(motors(out), motors(in), in.size() / 8));
        return out;
    }

    static Numbers normalize(const Numbers &in)
    {
        Numbers out(in.size());
        check(A::normalize_motor_each(motors(out), motors(in), in.size() / 8));
        return out;
    }

    static Numbers power(const Numbers &in, const Numbers &exponents)
    {
        Numbers out(in.size());
        check(A::power_motor_each(motors(out), motors(in), exponents.data(), sizeof(T), exponents.size()));
        return out;
    }

    static Numbers compose(const Numbers &first, const Numbers &then)
    {
        Numbers out(first.size());
        check(A::compose_motor_each(motors(out), motors(first), motors(then), first.size() / 8));
        return out;
    }

    static Numbers ratio(const Numbers &from, const Numbers &to, unsigned flags)
    {
        Numbers out(from.size());
        check(A::ratio_motor_each(motors(out), motors(from), motors(to), from.size() / 8, flags));
        return out;
    }

    // By mw_slerp_motor_each or mw_nlerp_motor_each.
    template <class Function>
    static Numbers interpolate(Function function, const Numbers &first, const Numbers &second,
                               const Numbers &parameters, unsigned flags)
    {
        Numbers out(first.size());
        check(function(motors(out), motors(first), motors(second), parameters.data(), sizeof(T), parameters.size(),
                       flags));
        return out;
    }

    static auto motors(Numbers &n)
    {
        return A::motors_aos(reinterpret_cast<typename A::motor *>(n.data()), sizeof(typename A::motor));
    }
    static auto motors(const Numbers &n)
    {
        return A::const_motors_aos(reinterpret_cast<const typename A::motor *>(n.data()), sizeof(typename A::motor));
    }
};

}  // namespace motorway::accuracy

#endif
