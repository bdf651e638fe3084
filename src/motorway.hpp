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
        using bivectors = mw_bivectors_##P;                                                                           \
        using const_bivectors = mw_const_bivectors_##P;                                                               \
        using dual_quaternions = mw_dual_quaternions_##P;                                                             \
        using const_dual_quaternions = mw_const_dual_quaternions_##P;                                                 \
        using screws = mw_screws_##P;                                                                                 \
        using const_screws = mw_const_screws_##P;                                                                     \
        using matrices = mw_matrices_##P;                                                                             \
        using const_matrices = mw_const_matrices_##P;                                                                 \
        using twist = mw_twist_##P;                                                                                   \
        using vertices = mw_vertices_##P;                                                                             \
        using const_vertices = mw_const_vertices_##P;                                                                 \
        using weights = mw_weights_##P;                                                                               \
        using motion = mw_motion_##P;                                                                                 \
        using compiled_motion = mw_compiled_motion_##P;                                                               \
        using motion_arrays = mw_motion_arrays_##P;                                                                   \
        using motion_distance = mw_motion_distance_##P;                                                               \
    };
MOTORWAY_TYPES(f32, float)
MOTORWAY_TYPES(f64, double)
#undef MOTORWAY_TYPES

using f32 = float;
using f64 = double;

} // namespace detail

template <class T> using motor = typename detail::types<T>::motor;
template <class T> using twist = typename detail::types<T>::twist;
template <class T> using motion = typename detail::types<T>::motion;
template <class T> using compiled_motion = typename detail::types<T>::compiled_motion;
template <class T> using motion_arrays = typename detail::types<T>::motion_arrays;
template <class T> using motion_distance = typename detail::types<T>::motion_distance;
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
MOTORWAY_CONST_VIEW(bivectors, v.b12, v.b13, v.b23, v.b1i, v.b2i, v.b3i, v.stride)
MOTORWAY_CONST_VIEW(dual_quaternions, v.rx, v.ry, v.rz, v.rw, v.dx, v.dy, v.dz, v.dw, v.stride)
MOTORWAY_CONST_VIEW(screws, v.ax, v.ay, v.az, v.px, v.py, v.pz, v.angle, v.distance, v.stride)
MOTORWAY_CONST_VIEW(matrices, v.first, v.stride, v.layout)
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
    MOTORWAY_VIEW(bivectors_aos, bivectors, P, , T, T, 6 * sizeof(T))                                                 \
    MOTORWAY_VIEW(bivectors_aos, bivectors, P, const_, const T, const T, 6 * sizeof(T))                               \
    MOTORWAY_SOA_VIEW(bivectors_soa, bivectors, P, , T, 6)                                                            \
    MOTORWAY_SOA_VIEW(bivectors_soa, bivectors, P, const_, const T, 6)                                                \
    MOTORWAY_VIEW(dual_quaternions_aos, dual_quaternions, P, , T, T, 8 * sizeof(T))                                   \
    MOTORWAY_VIEW(dual_quaternions_aos, dual_quaternions, P, const_, const T, const T, 8 * sizeof(T))                 \
    MOTORWAY_SOA_VIEW(dual_quaternions_soa, dual_quaternions, P, , T, 8)                                              \
    MOTORWAY_SOA_VIEW(dual_quaternions_soa, dual_quaternions, P, const_, const T, 8)                                  \
    MOTORWAY_VIEW(screws_aos, screws, P, , T, T, 8 * sizeof(T))                                                       \
    MOTORWAY_VIEW(screws_aos, screws, P, const_, const T, const T, 8 * sizeof(T))                                     \
    MOTORWAY_SOA_VIEW(screws_soa, screws, P, , T, 8)                                                                  \
    MOTORWAY_SOA_VIEW(screws_soa, screws, P, const_, const T, 8)                                                      \
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

// Quaternions that lie in memory as w x y z, and matrices, which are packed without a stride.
#define MOTORWAY_WXYZ(P, prefix, T)                                                                                   \
    inline mw_##prefix##xyzw_##P xyzw_wxyz(T *first, size_t stride = 4 * sizeof(T))                                   \
    {                                                                                                                 \
        return mw_##prefix##xyzw_##P##_wxyz(first, stride);                                                           \
    }                                                                                                                 \
    inline mw_##prefix##dual_quaternions_##P dual_quaternions_wxyz(T *first, size_t stride = 8 * sizeof(T))           \
    {                                                                                                                 \
        return mw_##prefix##dual_quaternions_##P##_wxyz(first, stride);                                               \
    }                                                                                                                 \
    inline mw_##prefix##matrices_##P matrices(T *first, mw_matrix_layout layout, size_t stride = 0)                   \
    {                                                                                                                 \
        const bool are_square = layout == MW_MATRIX_ROWS_4X4 || layout == MW_MATRIX_COLUMNS_4X4;                      \
        return {first, stride ? stride : (are_square ? 16 : 12) * sizeof(T), layout};                                 \
    }
MOTORWAY_WXYZ(f32, , float)
MOTORWAY_WXYZ(f32, const_, const float)
MOTORWAY_WXYZ(f64, , double)
MOTORWAY_WXYZ(f64, const_, const double)
#undef MOTORWAY_WXYZ

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
    }                                                                                                                 \
    [[nodiscard]] inline status apply_##operand##_motion(mw_##views##_##P out, size_t row_stride,                     \
                                                         const mw_compiled_motion_##P *motion,                        \
                                                         const detail::P *parameters, size_t parameter_count,         \
                                                         const_##views<detail::P> in, size_t count,                   \
                                                         unsigned flags = MW_DEFAULT, size_t index = 0)               \
    {                                                                                                                 \
        return mw_apply_##operand##_motion_##P(out, row_stride, motion, index, parameters, parameter_count, in, count,\
                                               flags);                                                                \
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
    }
MOTORWAY_OVERLOADS(f32, float)
MOTORWAY_OVERLOADS(f64, double)
#undef MOTORWAY_OVERLOADS

// Motions. The compiled one is `memory`, which is the caller's.
#define MOTORWAY_MOTIONS(P, T)                                                                                        \
    [[nodiscard]] inline status motion_size(size_t &size, const motion<T> &motion, size_t *where = nullptr)           \
    {                                                                                                                 \
        return mw_motion_size_##P(&size, &motion, where);                                                             \
    }                                                                                                                 \
    [[nodiscard]] inline status compile_motion(const compiled_motion<T> *&compiled, void *memory, size_t size,        \
                                               const motion<T> &motion, unsigned flags = MW_DEFAULT,                  \
                                               size_t *where = nullptr)                                               \
    {                                                                                                                 \
        return mw_compile_motion_##P(&compiled, memory, size, &motion, flags, where);                                 \
    }                                                                                                                 \
    [[nodiscard]] inline status motion_domain(T (&domain)[2], const compiled_motion<T> *motion)                       \
    {                                                                                                                 \
        return mw_motion_domain_##P(domain, motion);                                                                  \
    }                                                                                                                 \
    [[nodiscard]] inline status sample_motion_one(mw_motors_##P out, const compiled_motion<T> *motion,                \
                                                  const T *parameters, size_t count, unsigned flags = MW_DEFAULT,     \
                                                  size_t index = 0)                                                   \
    {                                                                                                                 \
        return mw_sample_motion_one_##P(out, motion, index, parameters, count, flags);                                \
    }                                                                                                                 \
    [[nodiscard]] inline status sample_motion_each(mw_motors_##P out, const compiled_motion<T> *motion,               \
                                                   const T *parameters, size_t parameter_stride, size_t count,        \
                                                   unsigned flags = MW_DEFAULT, size_t index = 0)                     \
    {                                                                                                                 \
        return mw_sample_motion_each_##P(out, motion, index, parameters, parameter_stride, count, flags);             \
    }                                                                                                                 \
    [[nodiscard]] inline status sample_motion_twist_one(mw_motors_##P out, mw_bivectors_##P twists,                   \
                                                        const compiled_motion<T> *motion, const T *parameters,        \
                                                        size_t count, unsigned flags = MW_DEFAULT, size_t index = 0)  \
    {                                                                                                                 \
        return mw_sample_motion_twist_one_##P(out, twists, motion, index, parameters, count, flags);                  \
    }                                                                                                                 \
    [[nodiscard]] inline status sample_motion_twist_each(mw_motors_##P out, mw_bivectors_##P twists,                  \
                                                         const compiled_motion<T> *motion, const T *parameters,       \
                                                         size_t parameter_stride, size_t count,                       \
                                                         unsigned flags = MW_DEFAULT, size_t index = 0)               \
    {                                                                                                                 \
        return mw_sample_motion_twist_each_##P(out, twists, motion, index, parameters, parameter_stride, count,       \
                                               flags);                                                                \
    }                                                                                                                 \
    [[nodiscard]] inline status twist_velocity(T (&velocity)[3], const T (&twist)[6], const T (&place)[3])            \
    {                                                                                                                 \
        return mw_twist_velocity_##P(velocity, twist, place);                                                         \
    }                                                                                                                 \
    [[nodiscard]] inline status motion_lengths(T *lengths, const compiled_motion<T> *motion, const T (&point)[3],     \
                                               const T *parameters, size_t count, size_t index = 0)                   \
    {                                                                                                                 \
        return mw_motion_lengths_##P(lengths, motion, index, point, parameters, count);                               \
    }                                                                                                                 \
    [[nodiscard]] inline status motion_even_parameters(T *parameters, const compiled_motion<T> *motion,               \
                                                       const T (&point)[3], size_t count, size_t index = 0)           \
    {                                                                                                                 \
        return mw_motion_even_parameters_##P(parameters, motion, index, point, count);                                \
    }                                                                                                                 \
    [[nodiscard]] inline status compare_motions(motion_distance<T> &largest, const compiled_motion<T> *first,         \
                                                const compiled_motion<T> *second, const_xyz<T> points, size_t count,  \
                                                size_t sample_count, size_t first_index = 0, size_t second_index = 0) \
    {                                                                                                                 \
        return mw_compare_motions_##P(&largest, first, first_index, second, second_index, points, count,              \
                                      sample_count);                                                                  \
    }                                                                                                                 \
    [[nodiscard]] inline status interpolate_keys(motion<T> &out, motion_arrays<T> arrays, mw_motion_kind kind,        \
                                                 unsigned degree, const motor<T> *keys, const T *times, size_t count, \
                                                 void *memory, size_t &size, size_t *where = nullptr)                 \
    {                                                                                                                 \
        return mw_interpolate_keys_##P(&out, arrays, kind, degree, keys, times, count, memory, &size, where);         \
    }                                                                                                                 \
    [[nodiscard]] inline status insert_knot(motion<T> &out, motion_arrays<T> arrays, const motion<T> &motion, T knot, \
                                            unsigned times = 1)                                                       \
    {                                                                                                                 \
        return mw_insert_knot_##P(&out, arrays, &motion, knot, times);                                                \
    }                                                                                                                 \
    [[nodiscard]] inline status elevate_degree(motion<T> &out, motion_arrays<T> arrays, const motion<T> &motion)      \
    {                                                                                                                 \
        return mw_elevate_degree_##P(&out, arrays, &motion);                                                          \
    }                                                                                                                 \
    [[nodiscard]] inline status split_motion(motion<T> &before, motion_arrays<T> before_arrays, motion<T> &after,     \
                                             motion_arrays<T> after_arrays, const motion<T> &motion, T at)            \
    {                                                                                                                 \
        return mw_split_motion_##P(&before, before_arrays, &after, after_arrays, &motion, at);                        \
    }
MOTORWAY_MOTIONS(f32, float)
MOTORWAY_MOTIONS(f64, double)
#undef MOTORWAY_MOTIONS

// The group of motors, and representations.
#define MOTORWAY_GROUP(P, T)                                                                                          \
    [[nodiscard]] inline status compose_motor_one_first(mw_motors_##P out, const motor<T> &first,                     \
                                                        const_motors<T> then, size_t count)                           \
    {                                                                                                                 \
        return mw_compose_motor_one_first_##P(out, &first, then, count);                                              \
    }                                                                                                                 \
    [[nodiscard]] inline status compose_motor_one_then(mw_motors_##P out, const_motors<T> first, const motor<T> &then,\
                                                       size_t count)                                                  \
    {                                                                                                                 \
        return mw_compose_motor_one_then_##P(out, first, &then, count);                                               \
    }                                                                                                                 \
    [[nodiscard]] inline status compose_motor_hierarchy(mw_motors_##P out, const_motors<T> locals,                    \
                                                        size_t joint_stride, const int32_t *parents,                  \
                                                        size_t joint_count, size_t count, size_t *first_bad = nullptr)\
    {                                                                                                                 \
        return mw_compose_motor_hierarchy_##P(out, locals, joint_stride, parents, joint_count, count, first_bad);     \
    }                                                                                                                 \
    [[nodiscard]] inline status inverse_motor_each(mw_motors_##P out, const_motors<T> motors, size_t count)           \
    {                                                                                                                 \
        return mw_inverse_motor_each_##P(out, motors, count);                                                         \
    }                                                                                                                 \
    [[nodiscard]] inline status ratio_motor_each(mw_motors_##P out, const_motors<T> from, const_motors<T> to,         \
                                                 size_t count, unsigned flags = MW_DEFAULT)                           \
    {                                                                                                                 \
        return mw_ratio_motor_each_##P(out, from, to, count, flags);                                                  \
    }                                                                                                                 \
    [[nodiscard]] inline status exp_motor_each(mw_motors_##P out, const_bivectors<T> generators, size_t count)        \
    {                                                                                                                 \
        return mw_exp_motor_each_##P(out, generators, count);                                                         \
    }                                                                                                                 \
    [[nodiscard]] inline status log_motor_each(mw_bivectors_##P out, const_motors<T> motors, size_t count,            \
                                               unsigned flags = MW_DEFAULT)                                           \
    {                                                                                                                 \
        return mw_log_motor_each_##P(out, motors, count, flags);                                                      \
    }                                                                                                                 \
    [[nodiscard]] inline status log_principal_motor_each(mw_bivectors_##P out, const_motors<T> motors, size_t count,  \
                                                         unsigned flags = MW_DEFAULT)                                 \
    {                                                                                                                 \
        return mw_log_principal_motor_each_##P(out, motors, count, flags);                                            \
    }                                                                                                                 \
    [[nodiscard]] inline status sqrt_motor_each(mw_motors_##P out, const_motors<T> motors, size_t count)              \
    {                                                                                                                 \
        return mw_sqrt_motor_each_##P(out, motors, count);                                                            \
    }                                                                                                                 \
    [[nodiscard]] inline status power_motor_each(mw_motors_##P out, const_motors<T> motors, const T *exponents,       \
                                                 size_t exponent_stride, size_t count)                                \
    {                                                                                                                 \
        return mw_power_motor_each_##P(out, motors, exponents, exponent_stride, count);                               \
    }                                                                                                                 \
    [[nodiscard]] inline status slerp_motor_each(mw_motors_##P out, const_motors<T> first, const_motors<T> second,    \
                                                 const T *parameters, size_t parameter_stride, size_t count,          \
                                                 unsigned flags = MW_DEFAULT)                                         \
    {                                                                                                                 \
        return mw_slerp_motor_each_##P(out, first, second, parameters, parameter_stride, count, flags);               \
    }                                                                                                                 \
    [[nodiscard]] inline status slerp_motor_one(mw_motors_##P out, const motor<T> &first, const motor<T> &second,     \
                                                const T *parameters, size_t parameter_stride, size_t count,           \
                                                unsigned flags = MW_DEFAULT)                                          \
    {                                                                                                                 \
        return mw_slerp_motor_one_##P(out, &first, &second, parameters, parameter_stride, count, flags);              \
    }                                                                                                                 \
    [[nodiscard]] inline status nlerp_motor_each(mw_motors_##P out, const_motors<T> first, const_motors<T> second,    \
                                                 const T *parameters, size_t parameter_stride, size_t count,          \
                                                 unsigned flags = MW_DEFAULT)                                         \
    {                                                                                                                 \
        return mw_nlerp_motor_each_##P(out, first, second, parameters, parameter_stride, count, flags);               \
    }                                                                                                                 \
    [[nodiscard]] inline status nlerp_motor_one(mw_motors_##P out, const motor<T> &first, const motor<T> &second,     \
                                                const T *parameters, size_t parameter_stride, size_t count,           \
                                                unsigned flags = MW_DEFAULT)                                          \
    {                                                                                                                 \
        return mw_nlerp_motor_one_##P(out, &first, &second, parameters, parameter_stride, count, flags);              \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_pose_each(mw_xyzw_##P quaternions, mw_xyz_##P translations,          \
                                                           const_motors<T> motors, size_t count)                      \
    {                                                                                                                 \
        return mw_convert_motor_to_pose_each_##P(quaternions, translations, motors, count);                           \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_pose_to_motor_each(mw_motors_##P out, const_xyzw<T> quaternions,              \
                                                           const_xyz<T> translations, size_t count)                   \
    {                                                                                                                 \
        return mw_convert_pose_to_motor_each_##P(out, quaternions, translations, count);                              \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_dual_quaternion_each(mw_dual_quaternions_##P out,                    \
                                                                      const_motors<T> motors, size_t count)           \
    {                                                                                                                 \
        return mw_convert_motor_to_dual_quaternion_each_##P(out, motors, count);                                      \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_dual_quaternion_to_motor_each(mw_motors_##P out, const_dual_quaternions<T> in,\
                                                                      size_t count)                                   \
    {                                                                                                                 \
        return mw_convert_dual_quaternion_to_motor_each_##P(out, in, count);                                          \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_matrix_each(mw_matrices_##P out, const_motors<T> motors,             \
                                                             size_t count)                                            \
    {                                                                                                                 \
        return mw_convert_motor_to_matrix_each_##P(out, motors, count);                                               \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_matrix_to_motor_each(mw_motors_##P out, const_matrices<T> in, size_t count,   \
                                                             unsigned flags = MW_DEFAULT,                             \
                                                             size_t *first_bad = nullptr)                             \
    {                                                                                                                 \
        return mw_convert_matrix_to_motor_each_##P(out, in, count, flags, first_bad);                                 \
    }                                                                                                                 \
    [[nodiscard]] inline status check_matrices(const_matrices<T> in, size_t count, T tolerance,                       \
                                               size_t *first_bad = nullptr, T *deviation = nullptr)                   \
    {                                                                                                                 \
        return mw_check_matrices_##P(in, count, tolerance, first_bad, deviation);                                     \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_axis_angle_each(mw_xyzw_##P rotations, mw_xyz_##P translations,      \
                                                                 const_motors<T> motors, size_t count)                \
    {                                                                                                                 \
        return mw_convert_motor_to_axis_angle_each_##P(rotations, translations, motors, count);                       \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_axis_angle_to_motor_each(mw_motors_##P out, const_xyzw<T> rotations,          \
                                                                 const_xyz<T> translations, size_t count)             \
    {                                                                                                                 \
        return mw_convert_axis_angle_to_motor_each_##P(out, rotations, translations, count);                          \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_euler_each(mw_xyz_##P angles, mw_xyz_##P translations,               \
                                                            const_motors<T> motors, size_t count,                     \
                                                            mw_euler_order order)                                     \
    {                                                                                                                 \
        return mw_convert_motor_to_euler_each_##P(angles, translations, motors, count, order);                        \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_euler_to_motor_each(mw_motors_##P out, const_xyz<T> angles,                   \
                                                            const_xyz<T> translations, size_t count,                  \
                                                            mw_euler_order order)                                     \
    {                                                                                                                 \
        return mw_convert_euler_to_motor_each_##P(out, angles, translations, count, order);                           \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_translation_to_motor_each(mw_motors_##P out, const_xyz<T> translations,       \
                                                                  size_t count)                                       \
    {                                                                                                                 \
        return mw_convert_translation_to_motor_each_##P(out, translations, count);                                    \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_translation_each(mw_xyz_##P translations, const_motors<T> motors,    \
                                                                  size_t count)                                       \
    {                                                                                                                 \
        return mw_convert_motor_to_translation_each_##P(translations, motors, count);                                 \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_screw_each(mw_screws_##P out, const_motors<T> motors, size_t count)  \
    {                                                                                                                 \
        return mw_convert_motor_to_screw_each_##P(out, motors, count);                                                \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_screw_to_motor_each(mw_motors_##P out, const_screws<T> screws, size_t count)  \
    {                                                                                                                 \
        return mw_convert_screw_to_motor_each_##P(out, screws, count);                                                \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_rotor_each(mw_motors_##P rotors, const_motors<T> motors,             \
                                                            size_t count, T lambda = 1)                               \
    {                                                                                                                 \
        return mw_convert_motor_to_rotor_each_##P(rotors, motors, count, lambda);                                     \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_rotor_to_motor_each(mw_motors_##P out, const_motors<T> rotors, size_t count,  \
                                                            T lambda = 1)                                             \
    {                                                                                                                 \
        return mw_convert_rotor_to_motor_each_##P(out, rotors, count, lambda);                                        \
    }                                                                                                                 \
    [[nodiscard]] inline status split_bivector(twist<T> &out, const T (&bivector)[6])                                 \
    {                                                                                                                 \
        return mw_split_bivector_##P(&out, bivector);                                                                 \
    }                                                                                                                 \
    [[nodiscard]] inline status twist_pose(motor<T> &out, const twist<T> &twist, T lambda)                            \
    {                                                                                                                 \
        return mw_twist_pose_##P(&out, &twist, lambda);                                                               \
    }                                                                                                                 \
    [[nodiscard]] inline status twist_position(T (&out)[3], const twist<T> &twist, T lambda)                          \
    {                                                                                                                 \
        return mw_twist_position_##P(out, &twist, lambda);                                                            \
    }
MOTORWAY_GROUP(f32, float)
MOTORWAY_GROUP(f64, double)
#undef MOTORWAY_GROUP

// Representations of a single motor: arrays in the order of the views.
#define MOTORWAY_SINGLE(P, T)                                                                                         \
    [[nodiscard]] inline status convert_motor_to_pose(T (&quaternion)[4], T (&translation)[3], const motor<T> &motor) \
    {                                                                                                                 \
        return convert_motor_to_pose_each(xyzw_aos(quaternion), aos(translation), aos(&motor), 1);                    \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_pose_to_motor(motor<T> &out, const T (&quaternion)[4],                        \
                                                      const T (&translation)[3])                                      \
    {                                                                                                                 \
        return convert_pose_to_motor_each(aos(&out), xyzw_aos(quaternion), aos(translation), 1);                      \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_dual_quaternion(T (&out)[8], const motor<T> &motor)                  \
    {                                                                                                                 \
        return convert_motor_to_dual_quaternion_each(dual_quaternions_aos(out), aos(&motor), 1);                      \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_dual_quaternion_to_motor(motor<T> &out, const T (&in)[8])                     \
    {                                                                                                                 \
        return convert_dual_quaternion_to_motor_each(aos(&out), dual_quaternions_aos(in), 1);                         \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_matrix(T *out, mw_matrix_layout layout, const motor<T> &motor)       \
    {                                                                                                                 \
        return convert_motor_to_matrix_each(matrices(out, layout), aos(&motor), 1);                                   \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_matrix_to_motor(motor<T> &out, const T *in, mw_matrix_layout layout,          \
                                                        unsigned flags = MW_DEFAULT)                                  \
    {                                                                                                                 \
        return convert_matrix_to_motor_each(aos(&out), matrices(in, layout), 1, flags);                               \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_axis_angle(T (&rotation)[4], T (&translation)[3],                    \
                                                            const motor<T> &motor)                                    \
    {                                                                                                                 \
        return convert_motor_to_axis_angle_each(xyzw_aos(rotation), aos(translation), aos(&motor), 1);                \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_axis_angle_to_motor(motor<T> &out, const T (&rotation)[4],                    \
                                                            const T (&translation)[3])                                \
    {                                                                                                                 \
        return convert_axis_angle_to_motor_each(aos(&out), xyzw_aos(rotation), aos(translation), 1);                  \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_euler(T (&angles)[3], T (&translation)[3], const motor<T> &motor,    \
                                                       mw_euler_order order)                                          \
    {                                                                                                                 \
        return convert_motor_to_euler_each(aos(angles), aos(translation), aos(&motor), 1, order);                     \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_euler_to_motor(motor<T> &out, const T (&angles)[3], const T (&translation)[3],\
                                                       mw_euler_order order)                                          \
    {                                                                                                                 \
        return convert_euler_to_motor_each(aos(&out), aos(angles), aos(translation), 1, order);                       \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_screw(T (&out)[8], const motor<T> &motor)                            \
    {                                                                                                                 \
        return convert_motor_to_screw_each(screws_aos(out), aos(&motor), 1);                                          \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_screw_to_motor(motor<T> &out, const T (&screw)[8])                            \
    {                                                                                                                 \
        return convert_screw_to_motor_each(aos(&out), screws_aos(screw), 1);                                          \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_motor_to_rotor(motor<T> &rotor, const motor<T> &motor, T lambda = 1)          \
    {                                                                                                                 \
        return convert_motor_to_rotor_each(aos(&rotor), aos(&motor), 1, lambda);                                      \
    }                                                                                                                 \
    [[nodiscard]] inline status convert_rotor_to_motor(motor<T> &out, const motor<T> &rotor, T lambda = 1)            \
    {                                                                                                                 \
        return convert_rotor_to_motor_each(aos(&out), aos(&rotor), 1, lambda);                                        \
    }
MOTORWAY_SINGLE(f32, float)
MOTORWAY_SINGLE(f64, double)
#undef MOTORWAY_SINGLE

} // namespace motorway
