// The C API by precision: Api<float>::compose_motor_each is mw_compose_motor_each_f32. And views of any number of
// components, which the testers lay out and turn into those of the API.
#ifndef MOTORWAY_TESTS_API_H
#define MOTORWAY_TESTS_API_H

#include <cstddef>
#include <vector>

#include "motorway.h"

namespace motorway::testing {

template <class T>
struct Api;

// apply_point_motion and its like, one an operand.
#define MOTORWAY_TEST_APPLY_MOTION(operand, views, precision)                                            \
    static constexpr auto apply_##operand##_motion = mw_apply_##operand##_motion_##precision;

#define MOTORWAY_TEST_API(T, precision)                                                                  \
    template <>                                                                                          \
    struct Api<T> {                                                                                      \
        static constexpr const char *name = #precision;                                                  \
        using Motor = mw_motor_##precision;                                                              \
        using Xyz = mw_xyz_##precision;                                                                  \
        using ConstXyz = mw_const_xyz_##precision;                                                       \
        using Motors = mw_motors_##precision;                                                            \
        using ConstMotors = mw_const_motors_##precision;                                                 \
        using Bivectors = mw_bivectors_##precision;                                                      \
        using ConstBivectors = mw_const_bivectors_##precision;                                           \
        using Weights = mw_weights_##precision;                                                          \
        using Motion = mw_motion_##precision;                                                            \
        using CompiledMotion = mw_compiled_motion_##precision;                                           \
        using MotionArrays = mw_motion_arrays_##precision;                                               \
        using MotionDistance = mw_motion_distance_##precision;                                           \
        static constexpr auto xyz_aos = mw_xyz_##precision##_aos;                                        \
        static constexpr auto const_xyz_aos = mw_const_xyz_##precision##_aos;                            \
        static constexpr auto motors_aos = mw_motors_##precision##_aos;                                  \
        static constexpr auto const_motors_aos = mw_const_motors_##precision##_aos;                      \
        static constexpr auto translation = mw_translation_##precision;                                  \
        static constexpr auto rotation = mw_rotation_##precision;                                        \
        static constexpr auto check_motors = mw_check_motors_##precision;                                \
        static constexpr auto apply_point_one = mw_apply_point_one_##precision;                          \
        static constexpr auto apply_point_each = mw_apply_point_each_##precision;                        \
        static constexpr auto apply_direction_one = mw_apply_direction_one_##precision;                  \
        static constexpr auto apply_direction_each = mw_apply_direction_each_##precision;                \
        static constexpr auto compose_motor_each = mw_compose_motor_each_##precision;                    \
        static constexpr auto compose_motor_one_first = mw_compose_motor_one_first_##precision;          \
        static constexpr auto compose_motor_one_then = mw_compose_motor_one_then_##precision;            \
        static constexpr auto compose_motor_hierarchy = mw_compose_motor_hierarchy_##precision;          \
        static constexpr auto inverse_motor_each = mw_inverse_motor_each_##precision;                    \
        static constexpr auto exp_motor_each = mw_exp_motor_each_##precision;                            \
        static constexpr auto log_motor_each = mw_log_motor_each_##precision;                            \
        static constexpr auto log_principal_motor_each = mw_log_principal_motor_each_##precision;        \
        static constexpr auto sqrt_motor_each = mw_sqrt_motor_each_##precision;                          \
        static constexpr auto power_motor_each = mw_power_motor_each_##precision;                        \
        static constexpr auto slerp_motor_each = mw_slerp_motor_each_##precision;                        \
        static constexpr auto slerp_motor_one = mw_slerp_motor_one_##precision;                          \
        static constexpr auto nlerp_motor_each = mw_nlerp_motor_each_##precision;                        \
        static constexpr auto nlerp_motor_one = mw_nlerp_motor_one_##precision;                          \
        static constexpr auto ratio_motor_each = mw_ratio_motor_each_##precision;                        \
        static constexpr auto reverse_motor_each = mw_reverse_motor_each_##precision;                    \
        static constexpr auto normalize_motor_each = mw_normalize_motor_each_##precision;                \
        static constexpr auto blend_motor_one = mw_blend_motor_one_##precision;                          \
        static constexpr auto blend_motor_each = mw_blend_motor_each_##precision;                        \
        static constexpr auto motion_size = mw_motion_size_##precision;                                  \
        static constexpr auto compile_motion = mw_compile_motion_##precision;                            \
        static constexpr auto motion_domain = mw_motion_domain_##precision;                              \
        static constexpr auto sample_motion_one = mw_sample_motion_one_##precision;                      \
        static constexpr auto sample_motion_each = mw_sample_motion_each_##precision;                    \
        static constexpr auto sample_motion_twist_one = mw_sample_motion_twist_one_##precision;          \
        static constexpr auto sample_motion_twist_each = mw_sample_motion_twist_each_##precision;        \
        static constexpr auto twist_velocity = mw_twist_velocity_##precision;                            \
        static constexpr auto motion_lengths = mw_motion_lengths_##precision;                            \
        static constexpr auto motion_even_parameters = mw_motion_even_parameters_##precision;            \
        static constexpr auto compare_motions = mw_compare_motions_##precision;                          \
        static constexpr auto interpolate_keys = mw_interpolate_keys_##precision;                        \
        static constexpr auto insert_knot = mw_insert_knot_##precision;                                  \
        static constexpr auto elevate_degree = mw_elevate_degree_##precision;                            \
        static constexpr auto split_motion = mw_split_motion_##precision;                                \
        MW_OPERANDS(MOTORWAY_TEST_APPLY_MOTION, precision)                                               \
    };

MOTORWAY_TEST_API(float, f32)
MOTORWAY_TEST_API(double, f64)
#undef MOTORWAY_TEST_API
#undef MOTORWAY_TEST_APPLY_MOTION

// Component k of element i is `stride` * i bytes behind component[k], and need not be aligned.
template <class T>
struct View {
    std::vector<T *> component;
    std::size_t stride = 0;

    typename Api<T>::Xyz xyz() const { return {component[0], component[1], component[2], stride}; }
    typename Api<T>::ConstXyz const_xyz() const { return {component[0], component[1], component[2], stride}; }

    typename Api<T>::Motors motors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], stride};
    }

    typename Api<T>::ConstMotors const_motors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], stride};
    }

    typename Api<T>::Bivectors bivectors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], stride};
    }

    typename Api<T>::ConstBivectors const_bivectors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], stride};
    }

    // The same bytes as components of another type.
    template <class U>
    View<U> as() const
    {
        View<U> view;
        for (T *pointer : component)
            view.component.push_back(reinterpret_cast<U *>(pointer));
        view.stride = stride;
        return view;
    }

    // The pointers are those of this view, which must live as long.
    typename Api<T>::Weights weights() const { return {const_cast<const T *const *>(component.data()), stride}; }
};

}  // namespace motorway::testing

#endif
