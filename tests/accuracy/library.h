// The functions that are measured, on packed numbers: eight a motor, six a bivector.
#ifndef MOTORWAY_TESTS_ACCURACY_LIBRARY_H
#define MOTORWAY_TESTS_ACCURACY_LIBRARY_H

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "motorway.h"

namespace motorway::accuracy {

inline void check(mw_status status)
{
    if (status != MW_OK)
        throw std::runtime_error(mw_status_text(status));
}

// The C API by precision.
template <class T>
struct Api;

#define MOTORWAY_ACCURACY_API(T, P)                                                                \
    template <>                                                                                    \
    struct Api<T> {                                                                                \
        static constexpr const char *name = #P;                                                    \
        using Motor = mw_motor_##P;                                                                \
        using Matrices = mw_matrices_##P;                                                          \
        using ConstMatrices = mw_const_matrices_##P;                                               \
        static constexpr auto motors = mw_motors_##P##_aos;                                        \
        static constexpr auto const_motors = mw_const_motors_##P##_aos;                            \
        static constexpr auto bivectors = mw_bivectors_##P##_aos;                                  \
        static constexpr auto const_bivectors = mw_const_bivectors_##P##_aos;                      \
        static constexpr auto xyz = mw_xyz_##P##_aos;                                              \
        static constexpr auto const_xyz = mw_const_xyz_##P##_aos;                                  \
        static constexpr auto xyzw = mw_xyzw_##P##_aos;                                            \
        static constexpr auto const_xyzw = mw_const_xyzw_##P##_aos;                                \
        static constexpr auto dual_quaternions = mw_dual_quaternions_##P##_aos;                    \
        static constexpr auto const_dual_quaternions = mw_const_dual_quaternions_##P##_aos;        \
        static constexpr auto screws = mw_screws_##P##_aos;                                        \
        static constexpr auto const_screws = mw_const_screws_##P##_aos;                            \
        static constexpr auto compose = mw_compose_motor_each_##P;                                 \
        static constexpr auto normalize = mw_normalize_motor_each_##P;                             \
        static constexpr auto ratio = mw_ratio_motor_each_##P;                                     \
        static constexpr auto exp = mw_exp_motor_each_##P;                                         \
        static constexpr auto log = mw_log_motor_each_##P;                                         \
        static constexpr auto log_principal = mw_log_principal_motor_each_##P;                     \
        static constexpr auto sqrt = mw_sqrt_motor_each_##P;                                       \
        static constexpr auto power = mw_power_motor_each_##P;                                     \
        static constexpr auto slerp = mw_slerp_motor_each_##P;                                     \
        static constexpr auto nlerp = mw_nlerp_motor_each_##P;                                     \
        static constexpr auto to_pose = mw_convert_motor_to_pose_each_##P;                         \
        static constexpr auto from_pose = mw_convert_pose_to_motor_each_##P;                       \
        static constexpr auto to_dual_quaternion = mw_convert_motor_to_dual_quaternion_each_##P;   \
        static constexpr auto from_dual_quaternion = mw_convert_dual_quaternion_to_motor_each_##P; \
        static constexpr auto to_matrix = mw_convert_motor_to_matrix_each_##P;                     \
        static constexpr auto from_matrix = mw_convert_matrix_to_motor_each_##P;                   \
        static constexpr auto to_axis_angle = mw_convert_motor_to_axis_angle_each_##P;             \
        static constexpr auto from_axis_angle = mw_convert_axis_angle_to_motor_each_##P;           \
        static constexpr auto to_euler = mw_convert_motor_to_euler_each_##P;                       \
        static constexpr auto from_euler = mw_convert_euler_to_motor_each_##P;                     \
        static constexpr auto to_screw = mw_convert_motor_to_screw_each_##P;                       \
        static constexpr auto from_screw = mw_convert_screw_to_motor_each_##P;                     \
        static constexpr auto to_rotor = mw_convert_motor_to_rotor_each_##P;                       \
        static constexpr auto from_rotor = mw_convert_rotor_to_motor_each_##P;                     \
    };

MOTORWAY_ACCURACY_API(float, f32)
MOTORWAY_ACCURACY_API(double, f64)
#undef MOTORWAY_ACCURACY_API

template <class T>
struct Library {
    using A = Api<T>;
    using Numbers = std::vector<T>;

    static Numbers exp(const Numbers &bivectors)
    {
        const std::size_t count = bivectors.size() / 6;
        Numbers out(8 * count);
        check(A::exp(motors(out), A::const_bivectors(bivectors.data(), sizeof(T[6])), count));
        return out;
    }

    // By mw_log_motor_each or mw_log_principal_motor_each.
    template <class Function>
    static Numbers log(Function function, const Numbers &in, unsigned flags)
    {
        const std::size_t count = in.size() / 8;
        Numbers out(6 * count);
        check(function(A::bivectors(out.data(), sizeof(T[6])), motors(in), count, flags));
        return out;
    }

    static Numbers sqrt(const Numbers &in)
    {
        Numbers out(in.size());
        check(A::sqrt(motors(out), motors(in), in.size() / 8));
        return out;
    }

    static Numbers normalize(const Numbers &in)
    {
        Numbers out(in.size());
        check(A::normalize(motors(out), motors(in), in.size() / 8));
        return out;
    }

    static Numbers power(const Numbers &in, const Numbers &exponents)
    {
        Numbers out(in.size());
        check(A::power(motors(out), motors(in), exponents.data(), sizeof(T), exponents.size()));
        return out;
    }

    static Numbers compose(const Numbers &first, const Numbers &then)
    {
        Numbers out(first.size());
        check(A::compose(motors(out), motors(first), motors(then), first.size() / 8));
        return out;
    }

    static Numbers ratio(const Numbers &from, const Numbers &to, unsigned flags)
    {
        Numbers out(from.size());
        check(A::ratio(motors(out), motors(from), motors(to), from.size() / 8, flags));
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
        return A::motors(reinterpret_cast<typename A::Motor *>(n.data()), sizeof(typename A::Motor));
    }
    static auto motors(const Numbers &n)
    {
        return A::const_motors(reinterpret_cast<const typename A::Motor *>(n.data()), sizeof(typename A::Motor));
    }
};

}  // namespace motorway::accuracy

#endif
