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
#define MOTORWAY_TYPES(P, T)                                                                                          \
    template <> struct types<T> {                                                                                     \
        using motor = mw_motor_##P;                                                                                   \
        using xyz = mw_xyz_##P;                                                                                       \
        using const_xyz = mw_const_xyz_##P;                                                                           \
        using xyzw = mw_xyzw_##P;                                                                                     \
        using const_xyzw = mw_const_xyzw_##P;                                                                         \
        using vectors = mw_vectors_##P;                                                                               \
        using const_vectors = mw_const_vectors_##P;                                                                   \
        using lines = mw_lines_##P;                                                                                   \
        using const_lines = mw_const_lines_##P;                                                                       \
        using motors = mw_motors_##P;                                                                                 \
        using const_motors = mw_const_motors_##P;                                                                     \
        using vertices = mw_vertices_##P;                                                                             \
        using const_vertices = mw_const_vertices_##P;                                                                 \
        using weights = mw_weights_##P;                                                                               \
        using bspline = mw_bspline_##P;                                                                               \
    };
MOTORWAY_TYPES(f32, float)
MOTORWAY_TYPES(f64, double)
#undef MOTORWAY_TYPES

using f32 = float;
using f64 = double;

} // namespace detail

template <class T> using motor = typename detail::types<T>::motor;
template <class T> using bspline = typename detail::types<T>::bspline;
template <class T> using weights = typename detail::types<T>::weights;

// Inputs: a C view of const elements, which a view of mutable ones becomes by itself.
#define MOTORWAY_CONST_VIEW(name, ...)                                                                                \
    template <class T> struct const_##name : detail::types<T>::const_##name {                                         \
        using base = typename detail::types<T>::const_##name;                                                         \
        const_##name(const base &view) : base(view) {}                                                                \
        const_##name(const typename detail::types<T>::name &v) : base{__VA_ARGS__} {}                                 \
    };
MOTORWAY_CONST_VIEW(xyz, v.x, v.y, v.z, v.stride)
MOTORWAY_CONST_VIEW(xyzw, v.x, v.y, v.z, v.w, v.stride)
MOTORWAY_CONST_VIEW(vectors, v.e0, v.e1, v.e2, v.e3, v.ei, v.stride)
MOTORWAY_CONST_VIEW(lines, v.dx, v.dy, v.dz, v.mx, v.my, v.mz, v.stride)
MOTORWAY_CONST_VIEW(motors, v.s, v.b12, v.b13, v.b23, v.b1i, v.b2i, v.b3i, v.w, v.stride)
MOTORWAY_CONST_VIEW(vertices, const_xyz<T>(v.position), const_xyz<T>(v.normal))
#undef MOTORWAY_CONST_VIEW

// Views. The stride is in bytes; without one the elements are packed. aos and soa of scalars make xyz; the other views
// of scalars have their own names.
#define MOTORWAY_VIEW(function, name, P, prefix, element, T, size)                                                    \
    inline mw_##prefix##name##_##P function(element *first, size_t stride = size)                                     \
    {                                                                                                                 \
        return mw_##prefix##name##_##P##_aos(first, stride);                                                          \
    }
#define MOTORWAY_SOA_VIEW(function, name, P, prefix, T, number)                                                       \
    inline mw_##prefix##name##_##P function(T *const (&components)[number])                                           \
    {                                                                                                                 \
        return mw_##prefix##name##_##P##_soa(components);                                                             \
    }
#define MOTORWAY_VIEWS(P, T)                                                                                          \
    MOTORWAY_VIEW(aos, xyz, P, , T, T, 3 * sizeof(T))                                                                 \
    MOTORWAY_VIEW(aos, xyz, P, const_, const T, const T, 3 * sizeof(T))                                               \
    MOTORWAY_VIEW(xyzw_aos, xyzw, P, , T, T, 4 * sizeof(T))                                                           \
    MOTORWAY_VIEW(xyzw_aos, xyzw, P, const_, const T, const T, 4 * sizeof(T))                                         \
    MOTORWAY_VIEW(vectors_aos, vectors, P, , T, T, 5 * sizeof(T))                                                     \
    MOTORWAY_VIEW(vectors_aos, vectors, P, const_, const T, const T, 5 * sizeof(T))                                   \
    MOTORWAY_VIEW(lines_aos, lines, P, , T, T, 6 * sizeof(T))                                                         \
    MOTORWAY_VIEW(lines_aos, lines, P, const_, const T, const T, 6 * sizeof(T))                                       \
    MOTORWAY_VIEW(aos, motors, P, , mw_motor_##P, T, sizeof(mw_motor_##P))                                            \
    MOTORWAY_VIEW(aos, motors, P, const_, const mw_motor_##P, const T, sizeof(mw_motor_##P))                          \
    MOTORWAY_SOA_VIEW(xyzw_soa, xyzw, P, , T, 4)                                                                      \
    MOTORWAY_SOA_VIEW(xyzw_soa, xyzw, P, const_, const T, 4)                                                          \
    MOTORWAY_SOA_VIEW(vectors_soa, vectors, P, , T, 5)                                                                \
    MOTORWAY_SOA_VIEW(vectors_soa, vectors, P, const_, const T, 5)                                                    \
    MOTORWAY_SOA_VIEW(lines_soa, lines, P, , T, 6)                                                                    \
    MOTORWAY_SOA_VIEW(lines_soa, lines, P, const_, const T, 6)                                                        \
    inline mw_xyz_##P soa(T *x, T *y, T *z) { return mw_xyz_##P##_soa(x, y, z); }                                     \
    inline mw_const_xyz_##P soa(const T *x, const T *y, const T *z) { return mw_const_xyz_##P##_soa(x, y, z); }       \
    inline mw_motors_##P soa(T *const components[8]) { return mw_motors_##P##_soa(components); }                      \
    inline mw_const_motors_##P soa(const T *const components[8]) { return mw_const_motors_##P##_soa(components); }
MOTORWAY_VIEWS(f32, float)
MOTORWAY_VIEWS(f64, double)
#undef MOTORWAY_VIEWS
#undef MOTORWAY_SOA_VIEW
#undef MOTORWAY_VIEW

// Positions and normals, each three adjacent scalars, in one buffer of vertices.
#define MOTORWAY_VERTICES(P, prefix, T)                                                                               \
    inline mw_##prefix##vertices_##P vertices_aos(T *position, T *normal, size_t stride)                              \
    {                                                                                                                 \
        return {aos(position, stride), aos(normal, stride)};                                                          \
    }
MOTORWAY_VERTICES(f32, , float)
MOTORWAY_VERTICES(f32, const_, const float)
MOTORWAY_VERTICES(f64, , double)
MOTORWAY_VERTICES(f64, const_, const double)
#undef MOTORWAY_VERTICES

inline mw_indices indices(const uint8_t *first, size_t stride = 1) { return mw_indices_u8(first, stride); }
inline mw_indices indices(const uint16_t *first, size_t stride = 2) { return mw_indices_u16(first, stride); }
inline mw_indices indices(const uint32_t *first, size_t stride = 4) { return mw_indices_u32(first, stride); }

// apply_<operand>_<pairing>, for every operand.
#define MOTORWAY_APPLY(operand, views, P)                                                                             \
    [[nodiscard]] inline status apply_##operand##_one(mw_##views##_##P out, const mw_motor_##P &motor,                \
                                                      const_##views<detail::P> in, size_t count,                      \
                                                      unsigned flags = MW_DEFAULT)                                    \
    {                                                                                                                 \
        return mw_apply_##operand##_one_##P(out, &motor, in, count, flags);                                           \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_##operand##_each(mw_##views##_##P out, const_motors<detail::P> motors,          \
                                                       const_##views<detail::P> in, size_t count,                     \
                                                       unsigned flags = MW_DEFAULT)                                   \
    {                                                                                                                 \
        return mw_apply_##operand##_each_##P(out, motors, in, count, flags);                                          \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_##operand##_grid(mw_##views##_##P out, size_t row_stride,                       \
                                                       const_motors<detail::P> motors, size_t motor_count,            \
                                                       const_##views<detail::P> in, size_t count,                     \
                                                       unsigned flags = MW_DEFAULT)                                   \
    {                                                                                                                 \
        return mw_apply_##operand##_grid_##P(out, row_stride, motors, motor_count, in, count, flags);                 \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_##operand##_indexed(mw_##views##_##P out, const mw_motor_##P *palette,          \
                                                          size_t palette_count, mw_indices indices,                   \
                                                          const_##views<detail::P> in, size_t count,                  \
                                                          unsigned flags = MW_DEFAULT)                                \
    {                                                                                                                 \
        return mw_apply_##operand##_indexed_##P(out, palette, palette_count, indices, in, count, flags);              \
    }                                                                                                                 \
    [[nodiscard]] inline status apply_##operand##_indexed_checked(                                                    \
        mw_##views##_##P out, const mw_motor_##P *palette, size_t palette_count, mw_indices indices,                  \
        const_##views<detail::P> in, size_t count, unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)          \
    {                                                                                                                 \
        return mw_apply_##operand##_indexed_checked_##P(out, palette, palette_count, indices, in, count, flags,       \
                                                        first_bad);                                                   \
    }
MW_OPERANDS(MOTORWAY_APPLY, f32)
MW_OPERANDS(MOTORWAY_APPLY, f64)
#undef MOTORWAY_APPLY

// The mixed ones: motors of double on points of float.
[[nodiscard]] inline status apply_point_one(mw_xyz_f32 out, const mw_motor_f64 &motor, const_xyz<float> points,
                                            size_t count, const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_one_mixed(out, &motor, &shift, points, count, flags);
}
[[nodiscard]] inline status apply_point_each(mw_xyz_f32 out, const_motors<double> motors, const_xyz<float> points,
                                             size_t count, const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_each_mixed(out, motors, &shift, points, count, flags);
}
[[nodiscard]] inline status apply_point_grid(mw_xyz_f32 out, size_t row_stride, const_motors<double> motors,
                                             size_t motor_count, const_xyz<float> points, size_t count,
                                             const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_grid_mixed(out, row_stride, motors, motor_count, &shift, points, count, flags);
}
[[nodiscard]] inline status apply_point_indexed(mw_xyz_f32 out, const mw_motor_f64 *palette, size_t palette_count,
                                                mw_indices indices, const_xyz<float> points, size_t count,
                                                const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_indexed_mixed(out, palette, palette_count, indices, &shift, points, count, flags);
}
[[nodiscard]] inline status apply_point_indexed_checked(mw_xyz_f32 out, const mw_motor_f64 *palette,
                                                        size_t palette_count, mw_indices indices,
                                                        const_xyz<float> points, size_t count,
                                                        const mw_shift &shift = {}, unsigned flags = MW_DEFAULT,
                                                        size_t *first_bad = nullptr)
{
    return mw_apply_point_indexed_checked_mixed(out, palette, palette_count, indices, &shift, points, count, flags,
                                                first_bad);
}
[[nodiscard]] inline status check_indices(mw_indices indices, size_t count, size_t palette_count,
                                          size_t *first_bad = nullptr)
{
    return mw_check_indices(indices, count, palette_count, first_bad);
}

// The other functions that come in two precisions.
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
