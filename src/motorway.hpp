// Motorway in C++17: the C API of motorway.h under shorter names. Overloads choose the precision, a view of const
// elements is made from a view of mutable ones by itself, flags have their default. Nothing here throws, allocates
// or adds a check; units, shapes, errors and all else are described in motorway.h.
//
//     motorway::apply_point_one(motorway::aos(out), motor, motorway::aos(points), count);
#pragma once

#include "motorway_views.h"

namespace motorway {

using status = mw_status;

namespace detail {

// The C types of each precision.
template <class T> struct types;
#define MOTORWAY_TYPES(P, T)                                                                                          \
    template <> struct types<T> {                                                                                     \
        using motor = mw_motor_##P;                                                                                   \
        using xyz = mw_xyz_##P; \
        using const_xyz = mw_const_xyz_##P; \
        using xyzw = mw_xyzw_##P; \
        using const_xyzw = mw_const_xyzw_##P; \
        using vectors = mw_vectors_##P; \
        using const_vectors = mw_const_vectors_##P; \
        using lines = mw_lines_##P; \
        using const_lines = mw_const_lines_##P; \
        using motors = mw_motors_##P; \
        using const_motors = mw_const_motors_##P; \
        using bivectors = mw_bivectors_##P; \
        using const_bivectors = mw_const_bivectors_##P; \
        using dual_quaternions = mw_dual_quaternions_##P; \
        using const_dual_quaternions = mw_const_dual_quaternions_##P; \
        using screws = mw_screws_##P; \
        using const_screws = mw_const_screws_##P; \
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

[[nodiscard]] inline unsigned version()
{
    return mw_version();
}

[[nodiscard]] inline const char *status_text(mw_status of)
{
    return mw_status_text(of);
}

[[nodiscard]] inline const char *isa()
{
    return mw_isa();
}

[[nodiscard]] inline const char *isas()
{
    return mw_isas();
}

[[nodiscard]] inline status apply_point_one(mw_xyz_f32 out, const motor<float> &motor, const_xyz<float> in,
                                            size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_point_one(mw_xyz_f64 out, const motor<double> &motor, const_xyz<double> in,
                                            size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_point_each(mw_xyz_f32 out, const_motors<float> motors, const_xyz<float> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_point_each(mw_xyz_f64 out, const_motors<double> motors, const_xyz<double> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_point_grid(mw_xyz_f32 out, size_t row_stride, const_motors<float> motors,
                                             size_t motor_count, const_xyz<float> in, size_t count,
                                             unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_point_grid(mw_xyz_f64 out, size_t row_stride, const_motors<double> motors,
                                             size_t motor_count, const_xyz<double> in, size_t count,
                                             unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_point_indexed(mw_xyz_f32 out, const motor<float> *palette, size_t palette_count,
                                                mw_indices indices, const_xyz<float> in, size_t count,
                                                unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_point_indexed(mw_xyz_f64 out, const motor<double> *palette, size_t palette_count,
                                                mw_indices indices, const_xyz<double> in, size_t count,
                                                unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_point_indexed_checked(mw_xyz_f32 out, const motor<float> *palette,
                                                        size_t palette_count, mw_indices indices, const_xyz<float> in,
                                                        size_t count, unsigned flags = MW_DEFAULT,
                                                        size_t *first_bad = nullptr)
{
    return mw_apply_point_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags, first_bad);
}
[[nodiscard]] inline status apply_point_indexed_checked(mw_xyz_f64 out, const motor<double> *palette,
                                                        size_t palette_count, mw_indices indices,
                                                        const_xyz<double> in, size_t count,
                                                        unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_point_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags, first_bad);
}
[[nodiscard]] inline status apply_direction_one(mw_xyz_f32 out, const motor<float> &motor, const_xyz<float> in,
                                                size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_one(mw_xyz_f64 out, const motor<double> &motor, const_xyz<double> in,
                                                size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_each(mw_xyz_f32 out, const_motors<float> motors, const_xyz<float> in,
                                                 size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_each(mw_xyz_f64 out, const_motors<double> motors, const_xyz<double> in,
                                                 size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_grid(mw_xyz_f32 out, size_t row_stride, const_motors<float> motors,
                                                 size_t motor_count, const_xyz<float> in, size_t count,
                                                 unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_grid(mw_xyz_f64 out, size_t row_stride, const_motors<double> motors,
                                                 size_t motor_count, const_xyz<double> in, size_t count,
                                                 unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_indexed(mw_xyz_f32 out, const motor<float> *palette, size_t palette_count,
                                                    mw_indices indices, const_xyz<float> in, size_t count,
                                                    unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_indexed(mw_xyz_f64 out, const motor<double> *palette,
                                                    size_t palette_count, mw_indices indices, const_xyz<double> in,
                                                    size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_direction_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_direction_indexed_checked(mw_xyz_f32 out, const motor<float> *palette,
                                                            size_t palette_count, mw_indices indices,
                                                            const_xyz<float> in, size_t count,
                                                            unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_direction_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags,
                                                        first_bad);
}
[[nodiscard]] inline status apply_direction_indexed_checked(mw_xyz_f64 out, const motor<double> *palette,
                                                            size_t palette_count, mw_indices indices,
                                                            const_xyz<double> in, size_t count,
                                                            unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_direction_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags,
                                                        first_bad);
}
[[nodiscard]] inline status apply_tangent_one(mw_xyzw_f32 out, const motor<float> &motor, const_xyzw<float> in,
                                              size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_one(mw_xyzw_f64 out, const motor<double> &motor, const_xyzw<double> in,
                                              size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_each(mw_xyzw_f32 out, const_motors<float> motors, const_xyzw<float> in,
                                               size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_each(mw_xyzw_f64 out, const_motors<double> motors, const_xyzw<double> in,
                                               size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_grid(mw_xyzw_f32 out, size_t row_stride, const_motors<float> motors,
                                               size_t motor_count, const_xyzw<float> in, size_t count,
                                               unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_grid(mw_xyzw_f64 out, size_t row_stride, const_motors<double> motors,
                                               size_t motor_count, const_xyzw<double> in, size_t count,
                                               unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_indexed(mw_xyzw_f32 out, const motor<float> *palette, size_t palette_count,
                                                  mw_indices indices, const_xyzw<float> in, size_t count,
                                                  unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_indexed(mw_xyzw_f64 out, const motor<double> *palette, size_t palette_count,
                                                  mw_indices indices, const_xyzw<double> in, size_t count,
                                                  unsigned flags = MW_DEFAULT)
{
    return mw_apply_tangent_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_tangent_indexed_checked(mw_xyzw_f32 out, const motor<float> *palette,
                                                          size_t palette_count, mw_indices indices,
                                                          const_xyzw<float> in, size_t count,
                                                          unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_tangent_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags,
                                                      first_bad);
}
[[nodiscard]] inline status apply_tangent_indexed_checked(mw_xyzw_f64 out, const motor<double> *palette,
                                                          size_t palette_count, mw_indices indices,
                                                          const_xyzw<double> in, size_t count,
                                                          unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_tangent_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags,
                                                      first_bad);
}
[[nodiscard]] inline status apply_vertex_one(mw_vertices_f32 out, const motor<float> &motor, const_vertices<float> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_one(mw_vertices_f64 out, const motor<double> &motor,
                                             const_vertices<double> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_each(mw_vertices_f32 out, const_motors<float> motors,
                                              const_vertices<float> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_each(mw_vertices_f64 out, const_motors<double> motors,
                                              const_vertices<double> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_grid(mw_vertices_f32 out, size_t row_stride, const_motors<float> motors,
                                              size_t motor_count, const_vertices<float> in, size_t count,
                                              unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_grid(mw_vertices_f64 out, size_t row_stride, const_motors<double> motors,
                                              size_t motor_count, const_vertices<double> in, size_t count,
                                              unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_indexed(mw_vertices_f32 out, const motor<float> *palette,
                                                 size_t palette_count, mw_indices indices, const_vertices<float> in,
                                                 size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_indexed(mw_vertices_f64 out, const motor<double> *palette,
                                                 size_t palette_count, mw_indices indices, const_vertices<double> in,
                                                 size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vertex_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_vertex_indexed_checked(mw_vertices_f32 out, const motor<float> *palette,
                                                         size_t palette_count, mw_indices indices,
                                                         const_vertices<float> in, size_t count,
                                                         unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_vertex_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags,
                                                     first_bad);
}
[[nodiscard]] inline status apply_vertex_indexed_checked(mw_vertices_f64 out, const motor<double> *palette,
                                                         size_t palette_count, mw_indices indices,
                                                         const_vertices<double> in, size_t count,
                                                         unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_vertex_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags,
                                                     first_bad);
}
[[nodiscard]] inline status apply_vector_one(mw_vectors_f32 out, const motor<float> &motor, const_vectors<float> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_one(mw_vectors_f64 out, const motor<double> &motor, const_vectors<double> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_each(mw_vectors_f32 out, const_motors<float> motors, const_vectors<float> in,
                                              size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_each(mw_vectors_f64 out, const_motors<double> motors,
                                              const_vectors<double> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_grid(mw_vectors_f32 out, size_t row_stride, const_motors<float> motors,
                                              size_t motor_count, const_vectors<float> in, size_t count,
                                              unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_grid(mw_vectors_f64 out, size_t row_stride, const_motors<double> motors,
                                              size_t motor_count, const_vectors<double> in, size_t count,
                                              unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_indexed(mw_vectors_f32 out, const motor<float> *palette,
                                                 size_t palette_count, mw_indices indices, const_vectors<float> in,
                                                 size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_indexed(mw_vectors_f64 out, const motor<double> *palette,
                                                 size_t palette_count, mw_indices indices, const_vectors<double> in,
                                                 size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_vector_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_vector_indexed_checked(mw_vectors_f32 out, const motor<float> *palette,
                                                         size_t palette_count, mw_indices indices,
                                                         const_vectors<float> in, size_t count,
                                                         unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_vector_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags,
                                                     first_bad);
}
[[nodiscard]] inline status apply_vector_indexed_checked(mw_vectors_f64 out, const motor<double> *palette,
                                                         size_t palette_count, mw_indices indices,
                                                         const_vectors<double> in, size_t count,
                                                         unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_vector_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags,
                                                     first_bad);
}
[[nodiscard]] inline status apply_line_one(mw_lines_f32 out, const motor<float> &motor, const_lines<float> in,
                                           size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_line_one(mw_lines_f64 out, const motor<double> &motor, const_lines<double> in,
                                           size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_line_each(mw_lines_f32 out, const_motors<float> motors, const_lines<float> in,
                                            size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_line_each(mw_lines_f64 out, const_motors<double> motors, const_lines<double> in,
                                            size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_line_grid(mw_lines_f32 out, size_t row_stride, const_motors<float> motors,
                                            size_t motor_count, const_lines<float> in, size_t count,
                                            unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_line_grid(mw_lines_f64 out, size_t row_stride, const_motors<double> motors,
                                            size_t motor_count, const_lines<double> in, size_t count,
                                            unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_line_indexed(mw_lines_f32 out, const motor<float> *palette, size_t palette_count,
                                               mw_indices indices, const_lines<float> in, size_t count,
                                               unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_line_indexed(mw_lines_f64 out, const motor<double> *palette, size_t palette_count,
                                               mw_indices indices, const_lines<double> in, size_t count,
                                               unsigned flags = MW_DEFAULT)
{
    return mw_apply_line_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_line_indexed_checked(mw_lines_f32 out, const motor<float> *palette,
                                                       size_t palette_count, mw_indices indices,
                                                       const_lines<float> in, size_t count,
                                                       unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_line_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags, first_bad);
}
[[nodiscard]] inline status apply_line_indexed_checked(mw_lines_f64 out, const motor<double> *palette,
                                                       size_t palette_count, mw_indices indices,
                                                       const_lines<double> in, size_t count,
                                                       unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_line_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags, first_bad);
}
[[nodiscard]] inline status apply_motor_one(mw_motors_f32 out, const motor<float> &motor, const_motors<float> in,
                                            size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_one(mw_motors_f64 out, const motor<double> &motor, const_motors<double> in,
                                            size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_each(mw_motors_f32 out, const_motors<float> motors, const_motors<float> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_each(mw_motors_f64 out, const_motors<double> motors, const_motors<double> in,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_grid(mw_motors_f32 out, size_t row_stride, const_motors<float> motors,
                                             size_t motor_count, const_motors<float> in, size_t count,
                                             unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_grid(mw_motors_f64 out, size_t row_stride, const_motors<double> motors,
                                             size_t motor_count, const_motors<double> in, size_t count,
                                             unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_indexed(mw_motors_f32 out, const motor<float> *palette, size_t palette_count,
                                                mw_indices indices, const_motors<float> in, size_t count,
                                                unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_indexed(mw_motors_f64 out, const motor<double> *palette, size_t palette_count,
                                                mw_indices indices, const_motors<double> in, size_t count,
                                                unsigned flags = MW_DEFAULT)
{
    return mw_apply_motor_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_motor_indexed_checked(mw_motors_f32 out, const motor<float> *palette,
                                                        size_t palette_count, mw_indices indices,
                                                        const_motors<float> in, size_t count,
                                                        unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_motor_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags, first_bad);
}
[[nodiscard]] inline status apply_motor_indexed_checked(mw_motors_f64 out, const motor<double> *palette,
                                                        size_t palette_count, mw_indices indices,
                                                        const_motors<double> in, size_t count,
                                                        unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_motor_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags, first_bad);
}
[[nodiscard]] inline status apply_bivector_one(mw_bivectors_f32 out, const motor<float> &motor,
                                               const_bivectors<float> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_one_views_f32(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_one(mw_bivectors_f64 out, const motor<double> &motor,
                                               const_bivectors<double> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_one_views_f64(&out, &motor, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_each(mw_bivectors_f32 out, const_motors<float> motors,
                                                const_bivectors<float> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_each_views_f32(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_each(mw_bivectors_f64 out, const_motors<double> motors,
                                                const_bivectors<double> in, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_each_views_f64(&out, &motors, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_grid(mw_bivectors_f32 out, size_t row_stride, const_motors<float> motors,
                                                size_t motor_count, const_bivectors<float> in, size_t count,
                                                unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_grid_views_f32(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_grid(mw_bivectors_f64 out, size_t row_stride, const_motors<double> motors,
                                                size_t motor_count, const_bivectors<double> in, size_t count,
                                                unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_grid_views_f64(&out, row_stride, &motors, motor_count, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_indexed(mw_bivectors_f32 out, const motor<float> *palette,
                                                   size_t palette_count, mw_indices indices,
                                                   const_bivectors<float> in, size_t count,
                                                   unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_indexed_views_f32(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_indexed(mw_bivectors_f64 out, const motor<double> *palette,
                                                   size_t palette_count, mw_indices indices,
                                                   const_bivectors<double> in, size_t count,
                                                   unsigned flags = MW_DEFAULT)
{
    return mw_apply_bivector_indexed_views_f64(&out, palette, palette_count, &indices, &in, count, flags);
}
[[nodiscard]] inline status apply_bivector_indexed_checked(mw_bivectors_f32 out, const motor<float> *palette,
                                                           size_t palette_count, mw_indices indices,
                                                           const_bivectors<float> in, size_t count,
                                                           unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_bivector_indexed_checked_views_f32(&out, palette, palette_count, &indices, &in, count, flags,
                                                       first_bad);
}
[[nodiscard]] inline status apply_bivector_indexed_checked(mw_bivectors_f64 out, const motor<double> *palette,
                                                           size_t palette_count, mw_indices indices,
                                                           const_bivectors<double> in, size_t count,
                                                           unsigned flags = MW_DEFAULT, size_t *first_bad = nullptr)
{
    return mw_apply_bivector_indexed_checked_views_f64(&out, palette, palette_count, &indices, &in, count, flags,
                                                       first_bad);
}

[[nodiscard]] inline status apply_point_one(mw_xyz_f32 out, const motor<double> &motor, const_xyz<float> points,
                                            size_t count, const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_one_views_mixed(&out, &motor, &shift, &points, count, flags);
}
[[nodiscard]] inline status apply_point_each(mw_xyz_f32 out, const_motors<double> motors, const_xyz<float> points,
                                             size_t count, const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_each_views_mixed(&out, &motors, &shift, &points, count, flags);
}
[[nodiscard]] inline status apply_point_grid(mw_xyz_f32 out, size_t row_stride, const_motors<double> motors,
                                             size_t motor_count, const_xyz<float> points, size_t count,
                                             const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_grid_views_mixed(&out, row_stride, &motors, motor_count, &shift, &points, count, flags);
}
[[nodiscard]] inline status apply_point_indexed(mw_xyz_f32 out, const motor<double> *palette, size_t palette_count,
                                                mw_indices indices, const_xyz<float> points, size_t count,
                                                const mw_shift &shift = {}, unsigned flags = MW_DEFAULT)
{
    return mw_apply_point_indexed_views_mixed(&out, palette, palette_count, &indices, &shift, &points, count, flags);
}
[[nodiscard]] inline status apply_point_indexed_checked(mw_xyz_f32 out, const motor<double> *palette,
                                                        size_t palette_count, mw_indices indices,
                                                        const_xyz<float> points, size_t count,
                                                        const mw_shift &shift = {}, unsigned flags = MW_DEFAULT,
                                                        size_t *first_bad = nullptr)
{
    return mw_apply_point_indexed_checked_views_mixed(&out, palette, palette_count, &indices, &shift, &points, count,
                                                      flags, first_bad);
}

[[nodiscard]] inline status check_indices(mw_indices indices, size_t count, size_t palette_count,
                                          size_t *first_bad = nullptr)
{
    return mw_check_indices_views(&indices, count, palette_count, first_bad);
}

[[nodiscard]] inline status translation(motor<float> &out, const float (&offset)[3])
{
    return mw_translation_f32(&out, offset);
}
[[nodiscard]] inline status translation(motor<double> &out, const double (&offset)[3])
{
    return mw_translation_f64(&out, offset);
}

[[nodiscard]] inline status rotation(motor<float> &out, const float (&axis)[3], float angle,
                                     const float (&point)[3] = {0, 0, 0})
{
    return mw_rotation_f32(&out, axis, angle, point);
}
[[nodiscard]] inline status rotation(motor<double> &out, const double (&axis)[3], double angle,
                                     const double (&point)[3] = {0, 0, 0})
{
    return mw_rotation_f64(&out, axis, angle, point);
}

[[nodiscard]] inline status check_motors(const_motors<float> motors, size_t count, size_t *first_bad = nullptr)
{
    return mw_check_motors_views_f32(&motors, count, first_bad);
}
[[nodiscard]] inline status check_motors(const_motors<double> motors, size_t count, size_t *first_bad = nullptr)
{
    return mw_check_motors_views_f64(&motors, count, first_bad);
}

[[nodiscard]] inline status compose_motor_each(mw_motors_f32 out, const_motors<float> first, const_motors<float> then,
                                               size_t count)
{
    return mw_compose_motor_each_views_f32(&out, &first, &then, count);
}
[[nodiscard]] inline status compose_motor_each(mw_motors_f64 out, const_motors<double> first,
                                               const_motors<double> then, size_t count)
{
    return mw_compose_motor_each_views_f64(&out, &first, &then, count);
}

[[nodiscard]] inline status compose_motor_one_first(mw_motors_f32 out, const motor<float> &first,
                                                    const_motors<float> then, size_t count)
{
    return mw_compose_motor_one_first_views_f32(&out, &first, &then, count);
}
[[nodiscard]] inline status compose_motor_one_first(mw_motors_f64 out, const motor<double> &first,
                                                    const_motors<double> then, size_t count)
{
    return mw_compose_motor_one_first_views_f64(&out, &first, &then, count);
}
[[nodiscard]] inline status compose_motor_one_then(mw_motors_f32 out, const_motors<float> first,
                                                   const motor<float> &then, size_t count)
{
    return mw_compose_motor_one_then_views_f32(&out, &first, &then, count);
}
[[nodiscard]] inline status compose_motor_one_then(mw_motors_f64 out, const_motors<double> first,
                                                   const motor<double> &then, size_t count)
{
    return mw_compose_motor_one_then_views_f64(&out, &first, &then, count);
}

[[nodiscard]] inline status compose_motor_hierarchy(mw_motors_f32 out, const_motors<float> locals,
                                                    size_t joint_stride, const int32_t *parents, size_t joint_count,
                                                    size_t count, size_t *first_bad = nullptr)
{
    return mw_compose_motor_hierarchy_views_f32(&out, &locals, joint_stride, parents, joint_count, count, first_bad);
}
[[nodiscard]] inline status compose_motor_hierarchy(mw_motors_f64 out, const_motors<double> locals,
                                                    size_t joint_stride, const int32_t *parents, size_t joint_count,
                                                    size_t count, size_t *first_bad = nullptr)
{
    return mw_compose_motor_hierarchy_views_f64(&out, &locals, joint_stride, parents, joint_count, count, first_bad);
}

[[nodiscard]] inline status reverse_motor_each(mw_motors_f32 out, const_motors<float> motors, size_t count)
{
    return mw_reverse_motor_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status reverse_motor_each(mw_motors_f64 out, const_motors<double> motors, size_t count)
{
    return mw_reverse_motor_each_views_f64(&out, &motors, count);
}

[[nodiscard]] inline status normalize_motor_each(mw_motors_f32 out, const_motors<float> motors, size_t count)
{
    return mw_normalize_motor_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status normalize_motor_each(mw_motors_f64 out, const_motors<double> motors, size_t count)
{
    return mw_normalize_motor_each_views_f64(&out, &motors, count);
}

[[nodiscard]] inline status inverse_motor_each(mw_motors_f32 out, const_motors<float> motors, size_t count)
{
    return mw_inverse_motor_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status inverse_motor_each(mw_motors_f64 out, const_motors<double> motors, size_t count)
{
    return mw_inverse_motor_each_views_f64(&out, &motors, count);
}

[[nodiscard]] inline status ratio_motor_each(mw_motors_f32 out, const_motors<float> from, const_motors<float> to,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_ratio_motor_each_views_f32(&out, &from, &to, count, flags);
}
[[nodiscard]] inline status ratio_motor_each(mw_motors_f64 out, const_motors<double> from, const_motors<double> to,
                                             size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_ratio_motor_each_views_f64(&out, &from, &to, count, flags);
}

[[nodiscard]] inline status exp_motor_each(mw_motors_f32 out, const_bivectors<float> generators, size_t count)
{
    return mw_exp_motor_each_views_f32(&out, &generators, count);
}
[[nodiscard]] inline status exp_motor_each(mw_motors_f64 out, const_bivectors<double> generators, size_t count)
{
    return mw_exp_motor_each_views_f64(&out, &generators, count);
}

[[nodiscard]] inline status log_motor_each(mw_bivectors_f32 out, const_motors<float> motors, size_t count,
                                           unsigned flags = MW_DEFAULT)
{
    return mw_log_motor_each_views_f32(&out, &motors, count, flags);
}
[[nodiscard]] inline status log_motor_each(mw_bivectors_f64 out, const_motors<double> motors, size_t count,
                                           unsigned flags = MW_DEFAULT)
{
    return mw_log_motor_each_views_f64(&out, &motors, count, flags);
}
[[nodiscard]] inline status log_principal_motor_each(mw_bivectors_f32 out, const_motors<float> motors, size_t count,
                                                     unsigned flags = MW_DEFAULT)
{
    return mw_log_principal_motor_each_views_f32(&out, &motors, count, flags);
}
[[nodiscard]] inline status log_principal_motor_each(mw_bivectors_f64 out, const_motors<double> motors, size_t count,
                                                     unsigned flags = MW_DEFAULT)
{
    return mw_log_principal_motor_each_views_f64(&out, &motors, count, flags);
}

[[nodiscard]] inline status sqrt_motor_each(mw_motors_f32 out, const_motors<float> motors, size_t count)
{
    return mw_sqrt_motor_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status sqrt_motor_each(mw_motors_f64 out, const_motors<double> motors, size_t count)
{
    return mw_sqrt_motor_each_views_f64(&out, &motors, count);
}

[[nodiscard]] inline status power_motor_each(mw_motors_f32 out, const_motors<float> motors, const float *exponents,
                                             size_t exponent_stride, size_t count)
{
    return mw_power_motor_each_views_f32(&out, &motors, exponents, exponent_stride, count);
}
[[nodiscard]] inline status power_motor_each(mw_motors_f64 out, const_motors<double> motors, const double *exponents,
                                             size_t exponent_stride, size_t count)
{
    return mw_power_motor_each_views_f64(&out, &motors, exponents, exponent_stride, count);
}

[[nodiscard]] inline status slerp_motor_each(mw_motors_f32 out, const_motors<float> first, const_motors<float> second,
                                             const float *parameters, size_t parameter_stride, size_t count,
                                             unsigned flags = MW_DEFAULT)
{
    return mw_slerp_motor_each_views_f32(&out, &first, &second, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status slerp_motor_each(mw_motors_f64 out, const_motors<double> first,
                                             const_motors<double> second, const double *parameters,
                                             size_t parameter_stride, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_slerp_motor_each_views_f64(&out, &first, &second, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status slerp_motor_one(mw_motors_f32 out, const motor<float> &first, const motor<float> &second,
                                            const float *parameters, size_t parameter_stride, size_t count,
                                            unsigned flags = MW_DEFAULT)
{
    return mw_slerp_motor_one_views_f32(&out, &first, &second, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status slerp_motor_one(mw_motors_f64 out, const motor<double> &first,
                                            const motor<double> &second, const double *parameters,
                                            size_t parameter_stride, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_slerp_motor_one_views_f64(&out, &first, &second, parameters, parameter_stride, count, flags);
}

[[nodiscard]] inline status nlerp_motor_each(mw_motors_f32 out, const_motors<float> first, const_motors<float> second,
                                             const float *parameters, size_t parameter_stride, size_t count,
                                             unsigned flags = MW_DEFAULT)
{
    return mw_nlerp_motor_each_views_f32(&out, &first, &second, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status nlerp_motor_each(mw_motors_f64 out, const_motors<double> first,
                                             const_motors<double> second, const double *parameters,
                                             size_t parameter_stride, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_nlerp_motor_each_views_f64(&out, &first, &second, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status nlerp_motor_one(mw_motors_f32 out, const motor<float> &first, const motor<float> &second,
                                            const float *parameters, size_t parameter_stride, size_t count,
                                            unsigned flags = MW_DEFAULT)
{
    return mw_nlerp_motor_one_views_f32(&out, &first, &second, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status nlerp_motor_one(mw_motors_f64 out, const motor<double> &first,
                                            const motor<double> &second, const double *parameters,
                                            size_t parameter_stride, size_t count, unsigned flags = MW_DEFAULT)
{
    return mw_nlerp_motor_one_views_f64(&out, &first, &second, parameters, parameter_stride, count, flags);
}

[[nodiscard]] inline status split_bivector(twist<float> &out, const float (&bivector)[6])
{
    return mw_split_bivector_f32(&out, bivector);
}
[[nodiscard]] inline status split_bivector(twist<double> &out, const double (&bivector)[6])
{
    return mw_split_bivector_f64(&out, bivector);
}

[[nodiscard]] inline status twist_pose(motor<float> &out, const twist<float> &twist, float lambda)
{
    return mw_twist_pose_f32(&out, &twist, lambda);
}
[[nodiscard]] inline status twist_pose(motor<double> &out, const twist<double> &twist, double lambda)
{
    return mw_twist_pose_f64(&out, &twist, lambda);
}
[[nodiscard]] inline status twist_position(float (&out)[3], const twist<float> &twist, float lambda)
{
    return mw_twist_position_f32(out, &twist, lambda);
}
[[nodiscard]] inline status twist_position(double (&out)[3], const twist<double> &twist, double lambda)
{
    return mw_twist_position_f64(out, &twist, lambda);
}

[[nodiscard]] inline status blend_motor_one(mw_motors_f32 out, const motor<float> *controls, weights<float> weights,
                                            size_t term_count, size_t count)
{
    return mw_blend_motor_one_views_f32(&out, controls, &weights, term_count, count);
}
[[nodiscard]] inline status blend_motor_one(mw_motors_f64 out, const motor<double> *controls, weights<double> weights,
                                            size_t term_count, size_t count)
{
    return mw_blend_motor_one_views_f64(&out, controls, &weights, term_count, count);
}

[[nodiscard]] inline status blend_motor_each(mw_motors_f32 out, const mw_const_motors_f32 *controls,
                                             weights<float> weights, size_t term_count, size_t count)
{
    return mw_blend_motor_each_views_f32(&out, controls, &weights, term_count, count);
}
[[nodiscard]] inline status blend_motor_each(mw_motors_f64 out, const mw_const_motors_f64 *controls,
                                             weights<double> weights, size_t term_count, size_t count)
{
    return mw_blend_motor_each_views_f64(&out, controls, &weights, term_count, count);
}

[[nodiscard]] inline status convert_motor_to_pose_each(mw_xyzw_f32 quaternions, mw_xyz_f32 translations,
                                                       const_motors<float> motors, size_t count)
{
    return mw_convert_motor_to_pose_each_views_f32(&quaternions, &translations, &motors, count);
}
[[nodiscard]] inline status convert_motor_to_pose_each(mw_xyzw_f64 quaternions, mw_xyz_f64 translations,
                                                       const_motors<double> motors, size_t count)
{
    return mw_convert_motor_to_pose_each_views_f64(&quaternions, &translations, &motors, count);
}
[[nodiscard]] inline status convert_pose_to_motor_each(mw_motors_f32 out, const_xyzw<float> quaternions,
                                                       const_xyz<float> translations, size_t count)
{
    return mw_convert_pose_to_motor_each_views_f32(&out, &quaternions, &translations, count);
}
[[nodiscard]] inline status convert_pose_to_motor_each(mw_motors_f64 out, const_xyzw<double> quaternions,
                                                       const_xyz<double> translations, size_t count)
{
    return mw_convert_pose_to_motor_each_views_f64(&out, &quaternions, &translations, count);
}

[[nodiscard]] inline status convert_motor_to_dual_quaternion_each(mw_dual_quaternions_f32 out,
                                                                  const_motors<float> motors, size_t count)
{
    return mw_convert_motor_to_dual_quaternion_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status convert_motor_to_dual_quaternion_each(mw_dual_quaternions_f64 out,
                                                                  const_motors<double> motors, size_t count)
{
    return mw_convert_motor_to_dual_quaternion_each_views_f64(&out, &motors, count);
}
[[nodiscard]] inline status convert_dual_quaternion_to_motor_each(mw_motors_f32 out, const_dual_quaternions<float> in,
                                                                  size_t count)
{
    return mw_convert_dual_quaternion_to_motor_each_views_f32(&out, &in, count);
}
[[nodiscard]] inline status convert_dual_quaternion_to_motor_each(mw_motors_f64 out,
                                                                  const_dual_quaternions<double> in, size_t count)
{
    return mw_convert_dual_quaternion_to_motor_each_views_f64(&out, &in, count);
}

[[nodiscard]] inline status convert_motor_to_matrix_each(mw_matrices_f32 out, const_motors<float> motors,
                                                         size_t count)
{
    return mw_convert_motor_to_matrix_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status convert_motor_to_matrix_each(mw_matrices_f64 out, const_motors<double> motors,
                                                         size_t count)
{
    return mw_convert_motor_to_matrix_each_views_f64(&out, &motors, count);
}
[[nodiscard]] inline status convert_matrix_to_motor_each(mw_motors_f32 out, const_matrices<float> matrices,
                                                         size_t count, unsigned flags = MW_DEFAULT,
                                                         size_t *first_bad = nullptr)
{
    return mw_convert_matrix_to_motor_each_views_f32(&out, &matrices, count, flags, first_bad);
}
[[nodiscard]] inline status convert_matrix_to_motor_each(mw_motors_f64 out, const_matrices<double> matrices,
                                                         size_t count, unsigned flags = MW_DEFAULT,
                                                         size_t *first_bad = nullptr)
{
    return mw_convert_matrix_to_motor_each_views_f64(&out, &matrices, count, flags, first_bad);
}

[[nodiscard]] inline status check_matrices(const_matrices<float> matrices, size_t count, float tolerance,
                                           size_t *first_bad = nullptr, float *deviation = nullptr)
{
    return mw_check_matrices_views_f32(&matrices, count, tolerance, first_bad, deviation);
}
[[nodiscard]] inline status check_matrices(const_matrices<double> matrices, size_t count, double tolerance,
                                           size_t *first_bad = nullptr, double *deviation = nullptr)
{
    return mw_check_matrices_views_f64(&matrices, count, tolerance, first_bad, deviation);
}

[[nodiscard]] inline status convert_motor_to_axis_angle_each(mw_xyzw_f32 rotations, mw_xyz_f32 translations,
                                                             const_motors<float> motors, size_t count)
{
    return mw_convert_motor_to_axis_angle_each_views_f32(&rotations, &translations, &motors, count);
}
[[nodiscard]] inline status convert_motor_to_axis_angle_each(mw_xyzw_f64 rotations, mw_xyz_f64 translations,
                                                             const_motors<double> motors, size_t count)
{
    return mw_convert_motor_to_axis_angle_each_views_f64(&rotations, &translations, &motors, count);
}
[[nodiscard]] inline status convert_axis_angle_to_motor_each(mw_motors_f32 out, const_xyzw<float> rotations,
                                                             const_xyz<float> translations, size_t count)
{
    return mw_convert_axis_angle_to_motor_each_views_f32(&out, &rotations, &translations, count);
}
[[nodiscard]] inline status convert_axis_angle_to_motor_each(mw_motors_f64 out, const_xyzw<double> rotations,
                                                             const_xyz<double> translations, size_t count)
{
    return mw_convert_axis_angle_to_motor_each_views_f64(&out, &rotations, &translations, count);
}

[[nodiscard]] inline status convert_motor_to_euler_each(mw_xyz_f32 angles, mw_xyz_f32 translations,
                                                        const_motors<float> motors, size_t count,
                                                        mw_euler_order order)
{
    return mw_convert_motor_to_euler_each_views_f32(&angles, &translations, &motors, count, order);
}
[[nodiscard]] inline status convert_motor_to_euler_each(mw_xyz_f64 angles, mw_xyz_f64 translations,
                                                        const_motors<double> motors, size_t count,
                                                        mw_euler_order order)
{
    return mw_convert_motor_to_euler_each_views_f64(&angles, &translations, &motors, count, order);
}
[[nodiscard]] inline status convert_euler_to_motor_each(mw_motors_f32 out, const_xyz<float> angles,
                                                        const_xyz<float> translations, size_t count,
                                                        mw_euler_order order)
{
    return mw_convert_euler_to_motor_each_views_f32(&out, &angles, &translations, count, order);
}
[[nodiscard]] inline status convert_euler_to_motor_each(mw_motors_f64 out, const_xyz<double> angles,
                                                        const_xyz<double> translations, size_t count,
                                                        mw_euler_order order)
{
    return mw_convert_euler_to_motor_each_views_f64(&out, &angles, &translations, count, order);
}

[[nodiscard]] inline status convert_translation_to_motor_each(mw_motors_f32 out, const_xyz<float> translations,
                                                              size_t count)
{
    return mw_convert_translation_to_motor_each_views_f32(&out, &translations, count);
}
[[nodiscard]] inline status convert_translation_to_motor_each(mw_motors_f64 out, const_xyz<double> translations,
                                                              size_t count)
{
    return mw_convert_translation_to_motor_each_views_f64(&out, &translations, count);
}
[[nodiscard]] inline status convert_motor_to_translation_each(mw_xyz_f32 translations, const_motors<float> motors,
                                                              size_t count)
{
    return mw_convert_motor_to_translation_each_views_f32(&translations, &motors, count);
}
[[nodiscard]] inline status convert_motor_to_translation_each(mw_xyz_f64 translations, const_motors<double> motors,
                                                              size_t count)
{
    return mw_convert_motor_to_translation_each_views_f64(&translations, &motors, count);
}

[[nodiscard]] inline status convert_motor_to_screw_each(mw_screws_f32 out, const_motors<float> motors, size_t count)
{
    return mw_convert_motor_to_screw_each_views_f32(&out, &motors, count);
}
[[nodiscard]] inline status convert_motor_to_screw_each(mw_screws_f64 out, const_motors<double> motors, size_t count)
{
    return mw_convert_motor_to_screw_each_views_f64(&out, &motors, count);
}
[[nodiscard]] inline status convert_screw_to_motor_each(mw_motors_f32 out, const_screws<float> screws, size_t count)
{
    return mw_convert_screw_to_motor_each_views_f32(&out, &screws, count);
}
[[nodiscard]] inline status convert_screw_to_motor_each(mw_motors_f64 out, const_screws<double> screws, size_t count)
{
    return mw_convert_screw_to_motor_each_views_f64(&out, &screws, count);
}

[[nodiscard]] inline status convert_motor_to_rotor_each(mw_motors_f32 rotors, const_motors<float> motors,
                                                        size_t count, float lambda = 1)
{
    return mw_convert_motor_to_rotor_each_views_f32(&rotors, &motors, count, lambda);
}
[[nodiscard]] inline status convert_motor_to_rotor_each(mw_motors_f64 rotors, const_motors<double> motors,
                                                        size_t count, double lambda = 1)
{
    return mw_convert_motor_to_rotor_each_views_f64(&rotors, &motors, count, lambda);
}
[[nodiscard]] inline status convert_rotor_to_motor_each(mw_motors_f32 out, const_motors<float> rotors, size_t count,
                                                        float lambda = 1)
{
    return mw_convert_rotor_to_motor_each_views_f32(&out, &rotors, count, lambda);
}
[[nodiscard]] inline status convert_rotor_to_motor_each(mw_motors_f64 out, const_motors<double> rotors, size_t count,
                                                        double lambda = 1)
{
    return mw_convert_rotor_to_motor_each_views_f64(&out, &rotors, count, lambda);
}

[[nodiscard]] inline status motion_size(size_t &size, const motion<float> &motion, size_t *where = nullptr)
{
    return mw_motion_size_f32(&size, &motion, where);
}
[[nodiscard]] inline status motion_size(size_t &size, const motion<double> &motion, size_t *where = nullptr)
{
    return mw_motion_size_f64(&size, &motion, where);
}

[[nodiscard]] inline status compile_motion(const compiled_motion<float> *&compiled, void *memory, size_t size,
                                           const motion<float> &motion, unsigned flags = MW_DEFAULT,
                                           size_t *where = nullptr)
{
    return mw_compile_motion_f32(&compiled, memory, size, &motion, flags, where);
}
[[nodiscard]] inline status compile_motion(const compiled_motion<double> *&compiled, void *memory, size_t size,
                                           const motion<double> &motion, unsigned flags = MW_DEFAULT,
                                           size_t *where = nullptr)
{
    return mw_compile_motion_f64(&compiled, memory, size, &motion, flags, where);
}

[[nodiscard]] inline status motion_domain(float (&domain)[2], const compiled_motion<float> *motion)
{
    return mw_motion_domain_f32(domain, motion);
}
[[nodiscard]] inline status motion_domain(double (&domain)[2], const compiled_motion<double> *motion)
{
    return mw_motion_domain_f64(domain, motion);
}

[[nodiscard]] inline status sample_motion_one(mw_motors_f32 out, const compiled_motion<float> *motion,
                                              const float *parameters, size_t count, unsigned flags = MW_DEFAULT,
                                              size_t index = 0)
{
    return mw_sample_motion_one_views_f32(&out, motion, index, parameters, count, flags);
}
[[nodiscard]] inline status sample_motion_one(mw_motors_f64 out, const compiled_motion<double> *motion,
                                              const double *parameters, size_t count, unsigned flags = MW_DEFAULT,
                                              size_t index = 0)
{
    return mw_sample_motion_one_views_f64(&out, motion, index, parameters, count, flags);
}
[[nodiscard]] inline status sample_motion_each(mw_motors_f32 out, const compiled_motion<float> *motion,
                                               const float *parameters, size_t parameter_stride, size_t count,
                                               unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_sample_motion_each_views_f32(&out, motion, index, parameters, parameter_stride, count, flags);
}
[[nodiscard]] inline status sample_motion_each(mw_motors_f64 out, const compiled_motion<double> *motion,
                                               const double *parameters, size_t parameter_stride, size_t count,
                                               unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_sample_motion_each_views_f64(&out, motion, index, parameters, parameter_stride, count, flags);
}

[[nodiscard]] inline status sample_motion_twist_one(mw_motors_f32 out, mw_bivectors_f32 twists,
                                                    const compiled_motion<float> *motion, const float *parameters,
                                                    size_t count, unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_sample_motion_twist_one_views_f32(&out, &twists, motion, index, parameters, count, flags);
}
[[nodiscard]] inline status sample_motion_twist_one(mw_motors_f64 out, mw_bivectors_f64 twists,
                                                    const compiled_motion<double> *motion, const double *parameters,
                                                    size_t count, unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_sample_motion_twist_one_views_f64(&out, &twists, motion, index, parameters, count, flags);
}
[[nodiscard]] inline status sample_motion_twist_each(mw_motors_f32 out, mw_bivectors_f32 twists,
                                                     const compiled_motion<float> *motion, const float *parameters,
                                                     size_t parameter_stride, size_t count,
                                                     unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_sample_motion_twist_each_views_f32(&out, &twists, motion, index, parameters, parameter_stride, count,
                                                 flags);
}
[[nodiscard]] inline status sample_motion_twist_each(mw_motors_f64 out, mw_bivectors_f64 twists,
                                                     const compiled_motion<double> *motion, const double *parameters,
                                                     size_t parameter_stride, size_t count,
                                                     unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_sample_motion_twist_each_views_f64(&out, &twists, motion, index, parameters, parameter_stride, count,
                                                 flags);
}

[[nodiscard]] inline status apply_point_motion(mw_xyz_f32 out, size_t row_stride,
                                               const compiled_motion<float> *motion, const float *parameters,
                                               size_t parameter_count, const_xyz<float> in, size_t count,
                                               unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_point_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                           flags);
}
[[nodiscard]] inline status apply_point_motion(mw_xyz_f64 out, size_t row_stride,
                                               const compiled_motion<double> *motion, const double *parameters,
                                               size_t parameter_count, const_xyz<double> in, size_t count,
                                               unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_point_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                           flags);
}
[[nodiscard]] inline status apply_direction_motion(mw_xyz_f32 out, size_t row_stride,
                                                   const compiled_motion<float> *motion, const float *parameters,
                                                   size_t parameter_count, const_xyz<float> in, size_t count,
                                                   unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_direction_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                               flags);
}
[[nodiscard]] inline status apply_direction_motion(mw_xyz_f64 out, size_t row_stride,
                                                   const compiled_motion<double> *motion, const double *parameters,
                                                   size_t parameter_count, const_xyz<double> in, size_t count,
                                                   unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_direction_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                               flags);
}
[[nodiscard]] inline status apply_tangent_motion(mw_xyzw_f32 out, size_t row_stride,
                                                 const compiled_motion<float> *motion, const float *parameters,
                                                 size_t parameter_count, const_xyzw<float> in, size_t count,
                                                 unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_tangent_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                             flags);
}
[[nodiscard]] inline status apply_tangent_motion(mw_xyzw_f64 out, size_t row_stride,
                                                 const compiled_motion<double> *motion, const double *parameters,
                                                 size_t parameter_count, const_xyzw<double> in, size_t count,
                                                 unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_tangent_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                             flags);
}
[[nodiscard]] inline status apply_vertex_motion(mw_vertices_f32 out, size_t row_stride,
                                                const compiled_motion<float> *motion, const float *parameters,
                                                size_t parameter_count, const_vertices<float> in, size_t count,
                                                unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_vertex_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                            flags);
}
[[nodiscard]] inline status apply_vertex_motion(mw_vertices_f64 out, size_t row_stride,
                                                const compiled_motion<double> *motion, const double *parameters,
                                                size_t parameter_count, const_vertices<double> in, size_t count,
                                                unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_vertex_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                            flags);
}
[[nodiscard]] inline status apply_vector_motion(mw_vectors_f32 out, size_t row_stride,
                                                const compiled_motion<float> *motion, const float *parameters,
                                                size_t parameter_count, const_vectors<float> in, size_t count,
                                                unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_vector_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                            flags);
}
[[nodiscard]] inline status apply_vector_motion(mw_vectors_f64 out, size_t row_stride,
                                                const compiled_motion<double> *motion, const double *parameters,
                                                size_t parameter_count, const_vectors<double> in, size_t count,
                                                unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_vector_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                            flags);
}
[[nodiscard]] inline status apply_line_motion(mw_lines_f32 out, size_t row_stride,
                                              const compiled_motion<float> *motion, const float *parameters,
                                              size_t parameter_count, const_lines<float> in, size_t count,
                                              unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_line_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                          flags);
}
[[nodiscard]] inline status apply_line_motion(mw_lines_f64 out, size_t row_stride,
                                              const compiled_motion<double> *motion, const double *parameters,
                                              size_t parameter_count, const_lines<double> in, size_t count,
                                              unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_line_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                          flags);
}
[[nodiscard]] inline status apply_motor_motion(mw_motors_f32 out, size_t row_stride,
                                               const compiled_motion<float> *motion, const float *parameters,
                                               size_t parameter_count, const_motors<float> in, size_t count,
                                               unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_motor_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                           flags);
}
[[nodiscard]] inline status apply_motor_motion(mw_motors_f64 out, size_t row_stride,
                                               const compiled_motion<double> *motion, const double *parameters,
                                               size_t parameter_count, const_motors<double> in, size_t count,
                                               unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_motor_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                           flags);
}
[[nodiscard]] inline status apply_bivector_motion(mw_bivectors_f32 out, size_t row_stride,
                                                  const compiled_motion<float> *motion, const float *parameters,
                                                  size_t parameter_count, const_bivectors<float> in, size_t count,
                                                  unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_bivector_motion_views_f32(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                              flags);
}
[[nodiscard]] inline status apply_bivector_motion(mw_bivectors_f64 out, size_t row_stride,
                                                  const compiled_motion<double> *motion, const double *parameters,
                                                  size_t parameter_count, const_bivectors<double> in, size_t count,
                                                  unsigned flags = MW_DEFAULT, size_t index = 0)
{
    return mw_apply_bivector_motion_views_f64(&out, row_stride, motion, index, parameters, parameter_count, &in, count,
                                              flags);
}

[[nodiscard]] inline status twist_velocity(float (&velocity)[3], const float (&twist)[6], const float (&place)[3])
{
    return mw_twist_velocity_f32(velocity, twist, place);
}
[[nodiscard]] inline status twist_velocity(double (&velocity)[3], const double (&twist)[6], const double (&place)[3])
{
    return mw_twist_velocity_f64(velocity, twist, place);
}

[[nodiscard]] inline status motion_lengths(float *lengths, const compiled_motion<float> *motion,
                                           const float (&point)[3], const float *parameters, size_t count,
                                           size_t index = 0)
{
    return mw_motion_lengths_f32(lengths, motion, index, point, parameters, count);
}
[[nodiscard]] inline status motion_lengths(double *lengths, const compiled_motion<double> *motion,
                                           const double (&point)[3], const double *parameters, size_t count,
                                           size_t index = 0)
{
    return mw_motion_lengths_f64(lengths, motion, index, point, parameters, count);
}

[[nodiscard]] inline status motion_even_parameters(float *parameters, const compiled_motion<float> *motion,
                                                   const float (&point)[3], size_t count, size_t index = 0)
{
    return mw_motion_even_parameters_f32(parameters, motion, index, point, count);
}
[[nodiscard]] inline status motion_even_parameters(double *parameters, const compiled_motion<double> *motion,
                                                   const double (&point)[3], size_t count, size_t index = 0)
{
    return mw_motion_even_parameters_f64(parameters, motion, index, point, count);
}

[[nodiscard]] inline status compare_motions(motion_distance<float> &largest, const compiled_motion<float> *first,
                                            const compiled_motion<float> *second, const_xyz<float> points,
                                            size_t count, size_t sample_count, size_t first_index = 0,
                                            size_t second_index = 0)
{
    return mw_compare_motions_views_f32(&largest, first, first_index, second, second_index, &points, count, sample_count);
}
[[nodiscard]] inline status compare_motions(motion_distance<double> &largest, const compiled_motion<double> *first,
                                            const compiled_motion<double> *second, const_xyz<double> points,
                                            size_t count, size_t sample_count, size_t first_index = 0,
                                            size_t second_index = 0)
{
    return mw_compare_motions_views_f64(&largest, first, first_index, second, second_index, &points, count, sample_count);
}

[[nodiscard]] inline status interpolate_keys(motion<float> &out, const motion_arrays<float> &arrays,
                                             mw_motion_kind kind, unsigned degree, const motor<float> *keys,
                                             const float *times, size_t count, void *memory, size_t &size,
                                             size_t *where = nullptr)
{
    return mw_interpolate_keys_f32(&out, &arrays, kind, degree, keys, times, count, memory, &size, where);
}
[[nodiscard]] inline status interpolate_keys(motion<double> &out, const motion_arrays<double> &arrays,
                                             mw_motion_kind kind, unsigned degree, const motor<double> *keys,
                                             const double *times, size_t count, void *memory, size_t &size,
                                             size_t *where = nullptr)
{
    return mw_interpolate_keys_f64(&out, &arrays, kind, degree, keys, times, count, memory, &size, where);
}

[[nodiscard]] inline status insert_knot(motion<float> &out, const motion_arrays<float> &arrays,
                                        const motion<float> &motion, float knot, unsigned times = 1)
{
    return mw_insert_knot_f32(&out, &arrays, &motion, knot, times);
}
[[nodiscard]] inline status insert_knot(motion<double> &out, const motion_arrays<double> &arrays,
                                        const motion<double> &motion, double knot, unsigned times = 1)
{
    return mw_insert_knot_f64(&out, &arrays, &motion, knot, times);
}
[[nodiscard]] inline status elevate_degree(motion<float> &out, const motion_arrays<float> &arrays,
                                           const motion<float> &motion)
{
    return mw_elevate_degree_f32(&out, &arrays, &motion);
}
[[nodiscard]] inline status elevate_degree(motion<double> &out, const motion_arrays<double> &arrays,
                                           const motion<double> &motion)
{
    return mw_elevate_degree_f64(&out, &arrays, &motion);
}
[[nodiscard]] inline status split_motion(motion<float> &before, const motion_arrays<float> &before_arrays,
                                         motion<float> &after, const motion_arrays<float> &after_arrays,
                                         const motion<float> &motion, float at)
{
    return mw_split_motion_f32(&before, &before_arrays, &after, &after_arrays, &motion, at);
}
[[nodiscard]] inline status split_motion(motion<double> &before, const motion_arrays<double> &before_arrays,
                                         motion<double> &after, const motion_arrays<double> &after_arrays,
                                         const motion<double> &motion, double at)
{
    return mw_split_motion_f64(&before, &before_arrays, &after, &after_arrays, &motion, at);
}

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
