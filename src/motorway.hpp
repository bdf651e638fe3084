// Motorway in C++17: the C API of motorway.h under shorter names. Overloads choose the precision, a view of const
// elements is made from a view of mutable ones by itself, flags have their default. Nothing here throws, allocates
// or adds a check; units, shapes, errors and all else are described in motorway.h.
//
//     motorway::apply_point_one(motorway::aos(out), motor, motorway::aos(points), count);
#pragma once

#include "motorway.h"

namespace motorway {

using status = mw_status;

namespace detail {

// The C types of each precision.
template <class T> struct types;
template <> struct types<float> {
    using motor = mw_motor_f32;
    using xyz = mw_xyz_f32;
    using const_xyz = mw_const_xyz_f32;
    using motors = mw_motors_f32;
    using const_motors = mw_const_motors_f32;
    using weights = mw_weights_f32;
    using bspline = mw_bspline_f32;
};
template <> struct types<double> {
    using motor = mw_motor_f64;
    using xyz = mw_xyz_f64;
    using const_xyz = mw_const_xyz_f64;
    using motors = mw_motors_f64;
    using const_motors = mw_const_motors_f64;
    using weights = mw_weights_f64;
    using bspline = mw_bspline_f64;
};

} // namespace detail

template <class T> using motor = typename detail::types<T>::motor;
template <class T> using bspline = typename detail::types<T>::bspline;
template <class T> using weights = typename detail::types<T>::weights;

// Inputs: a C view of const elements, which a view of mutable ones becomes by itself.
template <class T> struct const_xyz : detail::types<T>::const_xyz {
    using base = typename detail::types<T>::const_xyz;
    const_xyz(const base &view) : base(view) {}
    const_xyz(const typename detail::types<T>::xyz &view) : base{view.x, view.y, view.z, view.stride} {}
};
template <class T> struct const_motors : detail::types<T>::const_motors {
    using base = typename detail::types<T>::const_motors;
    const_motors(const base &view) : base(view) {}
    const_motors(const typename detail::types<T>::motors &v)
        : base{v.s, v.b12, v.b13, v.b23, v.b1i, v.b2i, v.b3i, v.w, v.stride}
    {
    }
};

// Views. The stride is in bytes; without one the elements are packed.
inline mw_xyz_f32 aos(float *first, size_t stride = 3 * sizeof(float)) { return mw_xyz_f32_aos(first, stride); }
inline mw_xyz_f64 aos(double *first, size_t stride = 3 * sizeof(double)) { return mw_xyz_f64_aos(first, stride); }
inline mw_const_xyz_f32 aos(const float *first, size_t stride = 3 * sizeof(float))
{
    return mw_const_xyz_f32_aos(first, stride);
}
inline mw_const_xyz_f64 aos(const double *first, size_t stride = 3 * sizeof(double))
{
    return mw_const_xyz_f64_aos(first, stride);
}
inline mw_motors_f32 aos(mw_motor_f32 *first, size_t stride = sizeof(mw_motor_f32))
{
    return mw_motors_f32_aos(first, stride);
}
inline mw_motors_f64 aos(mw_motor_f64 *first, size_t stride = sizeof(mw_motor_f64))
{
    return mw_motors_f64_aos(first, stride);
}
inline mw_const_motors_f32 aos(const mw_motor_f32 *first, size_t stride = sizeof(mw_motor_f32))
{
    return mw_const_motors_f32_aos(first, stride);
}
inline mw_const_motors_f64 aos(const mw_motor_f64 *first, size_t stride = sizeof(mw_motor_f64))
{
    return mw_const_motors_f64_aos(first, stride);
}
inline mw_xyz_f32 soa(float *x, float *y, float *z) { return mw_xyz_f32_soa(x, y, z); }
inline mw_xyz_f64 soa(double *x, double *y, double *z) { return mw_xyz_f64_soa(x, y, z); }
inline mw_const_xyz_f32 soa(const float *x, const float *y, const float *z) { return mw_const_xyz_f32_soa(x, y, z); }
inline mw_const_xyz_f64 soa(const double *x, const double *y, const double *z)
{
    return mw_const_xyz_f64_soa(x, y, z);
}
inline mw_motors_f32 soa(float *const components[8]) { return mw_motors_f32_soa(components); }
inline mw_motors_f64 soa(double *const components[8]) { return mw_motors_f64_soa(components); }
inline mw_const_motors_f32 soa(const float *const components[8]) { return mw_const_motors_f32_soa(components); }
inline mw_const_motors_f64 soa(const double *const components[8]) { return mw_const_motors_f64_soa(components); }

// Every function of the C API that comes in two precisions.
#define MOTORWAY_OVERLOADS(P, T)                                                                                      \
    [[nodiscard]] inline status translation(motor<T> &out, const T (&offset)[3])                                      \
    {                                                                                                                 \
        return mw_translation_##P(&out, offset);                                                                      \
    }                                                                                                                 \
    [[nodiscard]] inline status rotation(motor<T> &out, const T (&axis)[3], T angle, const T (&point)[3] = {0, 0, 0}) \
    {                                                                                                                 \
        return mw_rotation_##P(&out, axis, angle, point);                                                             \
    }                                                                                                                 \
    [[nodiscard]] inline status check_motors(const_motors<T> motors, size_t count, size_t *first_bad = nullptr)       \
    {                                                                                                                 \
        return mw_check_motors_##P(motors, count, first_bad);                                                         \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_point_one(mw_xyz_##P out, const motor<T> &motor, const_xyz<T> points,           \
                                                size_t count, unsigned flags = MW_DEFAULT)                            \
    {                                                                                                                 \
        return mw_apply_point_one_##P(out, &motor, points, count, flags);                                             \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_point_each(mw_xyz_##P out, const_motors<T> motors, const_xyz<T> points,         \
                                                 size_t count, unsigned flags = MW_DEFAULT)                           \
    {                                                                                                                 \
        return mw_apply_point_each_##P(out, motors, points, count, flags);                                            \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_direction_one(mw_xyz_##P out, const motor<T> &motor, const_xyz<T> directions,   \
                                                    size_t count, unsigned flags = MW_DEFAULT)                        \
    {                                                                                                                 \
        return mw_apply_direction_one_##P(out, &motor, directions, count, flags);                                     \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_direction_each(mw_xyz_##P out, const_motors<T> motors, const_xyz<T> directions, \
                                                     size_t count, unsigned flags = MW_DEFAULT)                       \
    {                                                                                                                 \
        return mw_apply_direction_each_##P(out, motors, directions, count, flags);                                    \
    }                                                                                                                 \
    [[nodiscard]] inline status compose_motor_each(mw_motors_##P out, const_motors<T> first, const_motors<T> then,    \
                                                   size_t count)                                                      \
    {                                                                                                                 \
        return mw_compose_motor_each_##P(out, first, then, count);                                                    \
    }                                                                                                                 \
    [[nodiscard]] inline status reverse_motor_each(mw_motors_##P out, const_motors<T> motors, size_t count)           \
    {                                                                                                                 \
        return mw_reverse_motor_each_##P(out, motors, count);                                                         \
    }                                                                                                                 \
    [[nodiscard]] inline status normalize_motor_each(mw_motors_##P out, const_motors<T> motors, size_t count)         \
    {                                                                                                                 \
        return mw_normalize_motor_each_##P(out, motors, count);                                                       \
    }                                                                                                                 \
    [[nodiscard]] inline status blend_motor_one(mw_motors_##P out, const motor<T> *controls, weights<T> weights,      \
                                                size_t term_count, size_t count)                                      \
    {                                                                                                                 \
        return mw_blend_motor_one_##P(out, controls, weights, term_count, count);                                     \
    }                                                                                                                 \
    [[nodiscard]] inline status blend_motor_each(mw_motors_##P out, const mw_const_motors_##P *controls,              \
                                                 weights<T> weights, size_t term_count, size_t count)                 \
    {                                                                                                                 \
        return mw_blend_motor_each_##P(out, controls, weights, term_count, count);                                    \
    }                                                                                                                 \
    [[nodiscard]] inline status check_bspline(const bspline<T> &motion, size_t *where = nullptr)                      \
    {                                                                                                                 \
        return mw_check_bspline_##P(&motion, where);                                                                  \
    }                                                                                                                 \
    [[nodiscard]] inline status sample_bspline(mw_motors_##P out, const bspline<T> &motion, const T *parameters,      \
                                               size_t count)                                                          \
    {                                                                                                                 \
        return mw_sample_bspline_##P(out, &motion, parameters, count);                                                \
    }
MOTORWAY_OVERLOADS(f32, float)
MOTORWAY_OVERLOADS(f64, double)
#undef MOTORWAY_OVERLOADS

} // namespace motorway
