/* Motorway on views: arrays in any layout, one array per component among them, which is the fastest.
 *
 * For each function mw_<name>_<precision> of motorway.h that takes arrays of elements by a pointer and a stride there is
 * mw_<name>_views_<precision>, which takes a pointer to a view of each instead. All else is the same, and is described
 * there. A view says where the components of an element lie: one base pointer per component, and the stride in bytes from
 * an element to the next. That covers packed arrays, vertex buffers with other attributes between, and one array per
 * component:
 *
 *     mw_xyz_f32_aos(p, 12)        x y z x y z ...      a packed array of float[3]
 *     mw_xyz_f32_aos(p, 32)        x y z . . . . .      the position in a 32-byte vertex
 *     mw_xyz_f32_soa(x, y, z)      three arrays         stride 4
 *
 *     mw_xyz_f32 to = mw_xyz_f32_soa(x, y, z);
 *     mw_const_xyz_f32 from = mw_const_xyz_f32_aos(vertices, 32);
 *     mw_status status = mw_apply_point_one_views_f32(&to, &motor, &from, count, MW_DEFAULT);
 *
 * A stride need not be a multiple of the alignment of the type. The components of one view may not share bytes. A null
 * pointer to a view is an error where the count is not 0. A job takes elements [begin, begin + count) of a batch by
 * mw_xyz_f32_from(view, begin), which every view has; what the ranges give together is what the whole would, to the last
 * bit.
 *
 * Written by codegen/generate.py from the table of public functions in codegen/functions/; do not edit. */
#ifndef MOTORWAY_VIEWS_H
#define MOTORWAY_VIEWS_H

#include "motorway.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* In C++ a cast that no compiler warns of. */
#ifdef __cplusplus
#define MW_CAST(type, value) reinterpret_cast<type>(value)
#else
#define MW_CAST(type, value) ((type)(value))
#endif

/* ------------------------------------------------------------------------------------------------- views --- */

/* The views, each in four versions: mw_xyz_f32 and mw_xyz_f64, and mw_const_xyz_f32 and mw_const_xyz_f64 for inputs.
 * They have one pointer per component and the stride: component c of element i is at byte offset i * stride from c.
 *
 *     mw_xyz       x y z                          points and directions
 *     mw_xyzw      x y z w                        tangents: a direction, and a w that stays what it is
 *     mw_vectors   e0 e1 e2 e3 ei                 grade 1: points, spheres and planes (ei: the coefficient of e∞)
 *     mw_lines     dx dy dz mx my mz              Plücker: the direction d, and the moment p × d of any point p on it
 *     mw_motors    s b12 b13 b23 b1i b2i b3i w    motors, in the order of the paper
 *     mw_bivectors b12 b13 b23 b1i b2i b3i        logarithms of motors, twists
 *     mw_dual_quaternions rx ry rz rw dx dy dz dw   the real quaternion, then the dual one
 *     mw_screws    ax ay az px py pz angle distance   the axis, a point on it, the angle about it, the way along it
 *
 * They are made by
 *     mw_[const_]xyz_f32_aos(first, stride)    components adjacent at `first`, `stride` bytes from element to element;
 *                                              `first` points to a float, or for motors to a mw_motor_f32
 *     mw_[const_]xyz_f32_soa(components)       one array per component: an array of as many pointers, in that order;
 *                                              for xyz alone three arguments, x, y and z
 *     mw_[const_]xyz_f32_from(view, begin)     the elements of a view from number `begin` on
 *     mw_[const_]xyzw_f32_wxyz(first, stride)  quaternions that lie in memory as w x y z; as fast as x y z w. And
 *                                              mw_[const_]dual_quaternions_f32_wxyz: both quaternions so
 * and the same for f64. They check nothing. */
#define MW_COMPONENTS_xyz(use, T) \
    use(x, T) use(y, T) use(z, T)
#define MW_COMPONENTS_xyzw(use, T) \
    use(x, T) use(y, T) use(z, T) use(w, T)
#define MW_COMPONENTS_vectors(use, T) \
    use(e0, T) use(e1, T) use(e2, T) use(e3, T) use(ei, T)
#define MW_COMPONENTS_lines(use, T) \
    use(dx, T) use(dy, T) use(dz, T) use(mx, T) use(my, T) use(mz, T)
#define MW_COMPONENTS_motors(use, T) \
    use(s, T) use(b12, T) use(b13, T) use(b23, T) use(b1i, T) use(b2i, T) use(b3i, T) use(w, T)
#define MW_COMPONENTS_bivectors(use, T) \
    use(b12, T) use(b13, T) use(b23, T) use(b1i, T) use(b2i, T) use(b3i, T)
#define MW_COMPONENTS_dual_quaternions(use, T) \
    use(rx, T) use(ry, T) use(rz, T) use(rw, T) use(dx, T) use(dy, T) use(dz, T) use(dw, T)
#define MW_COMPONENTS_screws(use, T) \
    use(ax, T) use(ay, T) use(az, T) use(px, T) use(py, T) use(pz, T) use(angle, T) use(distance, T)

#define MW_DECLARE(component, T) T *component;
#define MW_SET_NUMBER(component, T) view.component = first ? first + k++ : NULL;
#define MW_SET_MEMBER(component, T) view.component = first ? &first->component : NULL;
#define MW_SET_ARRAY(component, T) view.component = components[k++];
#define MW_ADVANCE(component, T)                                                                                      \
    if (view.component)                                                                                               \
        view.component = MW_CAST(T *, MW_CAST(uintptr_t, view.component) + begin * view.stride);

#define MW_DEFINE_VIEW(view_type, components_of, T, element, set, soa)                                                \
    typedef struct view_type { components_of(MW_DECLARE, T) size_t stride; } view_type;                               \
    static inline view_type view_type##_aos(element *first, size_t stride)                                            \
    {                                                                                                                 \
        view_type view;                                                                                               \
        int k = 0;                                                                                                    \
        components_of(set, T) view.stride = stride;                                                                   \
        (void)k;                                                                                                      \
        return view;                                                                                                  \
    }                                                                                                                 \
    static inline view_type view_type##soa(T *const *components)                                                      \
    {                                                                                                                 \
        view_type view;                                                                                               \
        int k = 0;                                                                                                    \
        components_of(MW_SET_ARRAY, T) view.stride = sizeof(T);                                                       \
        return view;                                                                                                  \
    }                                                                                                                 \
    static inline view_type view_type##_from(view_type view, size_t begin)                                            \
    {                                                                                                                 \
        components_of(MW_ADVANCE, T) return view;                                                                     \
    }

/* Of every view, the four versions. `element` is what its packed form is an array of: of numbers, or of structs whose
 * members are the components. */
#define MW_DEFINE_VIEWS(name, element_f32, element_f64, set, soa)                                                     \
    MW_DEFINE_VIEW(mw_##name##_f32, MW_COMPONENTS_##name, float, element_f32, set, soa)                               \
    MW_DEFINE_VIEW(mw_##name##_f64, MW_COMPONENTS_##name, double, element_f64, set, soa)                              \
    MW_DEFINE_VIEW(mw_const_##name##_f32, MW_COMPONENTS_##name, const float, const element_f32, set, soa)             \
    MW_DEFINE_VIEW(mw_const_##name##_f64, MW_COMPONENTS_##name, const double, const element_f64, set, soa)

MW_DEFINE_VIEWS(xyz, float, double, MW_SET_NUMBER, _soa_of)
MW_DEFINE_VIEWS(xyzw, float, double, MW_SET_NUMBER, _soa)
MW_DEFINE_VIEWS(vectors, float, double, MW_SET_NUMBER, _soa)
MW_DEFINE_VIEWS(lines, float, double, MW_SET_NUMBER, _soa)
MW_DEFINE_VIEWS(motors, mw_motor_f32, mw_motor_f64, MW_SET_MEMBER, _soa)
MW_DEFINE_VIEWS(bivectors, float, double, MW_SET_NUMBER, _soa)
MW_DEFINE_VIEWS(dual_quaternions, float, double, MW_SET_NUMBER, _soa)
MW_DEFINE_VIEWS(screws, float, double, MW_SET_NUMBER, _soa)

#define MW_DEFINE_XYZ_SOA(view_type, T)                                                                               \
    static inline view_type view_type##_soa(T *x, T *y, T *z)                                                         \
    {                                                                                                                 \
        T *components[3];                                                                                             \
        components[0] = x, components[1] = y, components[2] = z;                                                      \
        return view_type##_soa_of(components);                                                                        \
    }
MW_DEFINE_XYZ_SOA(mw_xyz_f32, float)
MW_DEFINE_XYZ_SOA(mw_xyz_f64, double)
MW_DEFINE_XYZ_SOA(mw_const_xyz_f32, const float)
MW_DEFINE_XYZ_SOA(mw_const_xyz_f64, const double)

#define MW_DEFINE_WXYZ(quaternions, dual_quaternions, T)                                                              \
    static inline quaternions quaternions##_wxyz(T *first, size_t stride)                                             \
    {                                                                                                                 \
        quaternions view = quaternions##_aos(first, stride);                                                          \
        view.w = first, view.x = view.y, view.y = view.z, view.z = first ? first + 3 : first;                         \
        return view;                                                                                                  \
    }                                                                                                                 \
    static inline dual_quaternions dual_quaternions##_wxyz(T *first, size_t stride)                                   \
    {                                                                                                                 \
        dual_quaternions view = dual_quaternions##_aos(first, stride);                                                \
        view.rw = first, view.rx = view.ry, view.ry = view.rz, view.rz = first ? first + 3 : first;                   \
        view.dw = view.dx, view.dx = view.dy, view.dy = view.dz, view.dz = first ? first + 7 : first;                 \
        return view;                                                                                                  \
    }
MW_DEFINE_WXYZ(mw_xyzw_f32, mw_dual_quaternions_f32, float)
MW_DEFINE_WXYZ(mw_xyzw_f64, mw_dual_quaternions_f64, double)
MW_DEFINE_WXYZ(mw_const_xyzw_f32, mw_const_dual_quaternions_f32, const float)
MW_DEFINE_WXYZ(mw_const_xyzw_f64, mw_const_dual_quaternions_f64, const double)

/* Positions and normals of vertices, each a view of its own: of one interleaved buffer
 *     {mw_xyz_f32_aos(&vertex[0].position, sizeof vertex[0]), mw_xyz_f32_aos(&vertex[0].normal, sizeof vertex[0])}
 * or wherever they lie. mw_[const_]vertices_f32_from(view, begin), and the same for f64. */
#define MW_DEFINE_VERTICES(view_type, xyz_type)                                                                       \
    typedef struct view_type { xyz_type position, normal; } view_type;                                                \
    static inline view_type view_type##_from(view_type view, size_t begin)                                            \
    {                                                                                                                 \
        view.position = xyz_type##_from(view.position, begin);                                                        \
        view.normal = xyz_type##_from(view.normal, begin);                                                            \
        return view;                                                                                                  \
    }
MW_DEFINE_VERTICES(mw_vertices_f32, mw_xyz_f32)
MW_DEFINE_VERTICES(mw_vertices_f64, mw_xyz_f64)
MW_DEFINE_VERTICES(mw_const_vertices_f32, mw_const_xyz_f32)
MW_DEFINE_VERTICES(mw_const_vertices_f64, mw_const_xyz_f64)

#undef MW_COMPONENTS_xyz
#undef MW_COMPONENTS_xyzw
#undef MW_COMPONENTS_vectors
#undef MW_COMPONENTS_lines
#undef MW_COMPONENTS_motors
#undef MW_COMPONENTS_bivectors
#undef MW_COMPONENTS_dual_quaternions
#undef MW_COMPONENTS_screws
#undef MW_DECLARE
#undef MW_SET_NUMBER
#undef MW_SET_MEMBER
#undef MW_SET_ARRAY
#undef MW_ADVANCE
#undef MW_DEFINE_VIEW
#undef MW_DEFINE_VIEWS
#undef MW_DEFINE_XYZ_SOA
#undef MW_DEFINE_WXYZ
#undef MW_DEFINE_VERTICES

/* One index per element: at byte offset i * stride from `first`, of any alignment. */
typedef struct mw_indices { const void *first; size_t stride; mw_index_type type; } mw_indices;

static inline mw_indices mw_indices_u8(const uint8_t *first, size_t stride)
{
    mw_indices indices;
    indices.first = first, indices.stride = stride, indices.type = MW_INDEX_U8;
    return indices;
}
static inline mw_indices mw_indices_u16(const uint16_t *first, size_t stride)
{
    mw_indices indices;
    indices.first = first, indices.stride = stride, indices.type = MW_INDEX_U16;
    return indices;
}
static inline mw_indices mw_indices_u32(const uint32_t *first, size_t stride)
{
    mw_indices indices;
    indices.first = first, indices.stride = stride, indices.type = MW_INDEX_U32;
    return indices;
}
static inline mw_indices mw_indices_from(mw_indices indices, size_t begin)
{
    if (indices.first)
        indices.first = MW_CAST(const char *, indices.first) + begin * indices.stride;
    return indices;
}

/* Matrices: see mw_matrix_layout. Element (r, c) of matrix i is at byte offset i * stride from first[4 r + c] where rows are
 * adjacent, from first[3 c + r] or first[4 c + r] where columns are. */
typedef struct mw_matrices_f32 { float *first; size_t stride; mw_matrix_layout layout; } mw_matrices_f32;
typedef struct mw_matrices_f64 { double *first; size_t stride; mw_matrix_layout layout; } mw_matrices_f64;
typedef struct mw_const_matrices_f32 {
    const float *first;
    size_t stride;
    mw_matrix_layout layout;
} mw_const_matrices_f32;
typedef struct mw_const_matrices_f64 {
    const double *first;
    size_t stride;
    mw_matrix_layout layout;
} mw_const_matrices_f64;

/* The list of operands, for whoever wants to say something of each. */
#define MW_OPERANDS(use, P) \
    use(point, xyz, P) use(direction, xyz, P) use(tangent, xyzw, P) use(vertex, vertices, P) use(vector, vectors, P) \
    use(line, lines, P) use(motor, motors, P) use(bivector, bivectors, P)

/* ------------------------------------------------------------------------------------------- functions --- */

mw_status mw_apply_point_one_views_f32(const mw_xyz_f32 *out, const mw_motor_f32 *motor, const mw_const_xyz_f32 *in,
                                       size_t count, unsigned flags);
mw_status mw_apply_point_one_views_f64(const mw_xyz_f64 *out, const mw_motor_f64 *motor, const mw_const_xyz_f64 *in,
                                       size_t count, unsigned flags);
mw_status mw_apply_point_each_views_f32(const mw_xyz_f32 *out, const mw_const_motors_f32 *motors,
                                        const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_point_each_views_f64(const mw_xyz_f64 *out, const mw_const_motors_f64 *motors,
                                        const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_point_grid_views_f32(const mw_xyz_f32 *out, size_t row_stride, const mw_const_motors_f32 *motors,
                                        size_t motor_count, const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_point_grid_views_f64(const mw_xyz_f64 *out, size_t row_stride, const mw_const_motors_f64 *motors,
                                        size_t motor_count, const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_point_indexed_views_f32(const mw_xyz_f32 *out, const mw_motor_f32 *palette, size_t palette_count,
                                           const mw_indices *indices, const mw_const_xyz_f32 *in, size_t count,
                                           unsigned flags);
mw_status mw_apply_point_indexed_views_f64(const mw_xyz_f64 *out, const mw_motor_f64 *palette, size_t palette_count,
                                           const mw_indices *indices, const mw_const_xyz_f64 *in, size_t count,
                                           unsigned flags);
mw_status mw_apply_point_indexed_checked_views_f32(const mw_xyz_f32 *out, const mw_motor_f32 *palette,
                                                   size_t palette_count, const mw_indices *indices,
                                                   const mw_const_xyz_f32 *in, size_t count, unsigned flags,
                                                   size_t *first_bad);
mw_status mw_apply_point_indexed_checked_views_f64(const mw_xyz_f64 *out, const mw_motor_f64 *palette,
                                                   size_t palette_count, const mw_indices *indices,
                                                   const mw_const_xyz_f64 *in, size_t count, unsigned flags,
                                                   size_t *first_bad);
mw_status mw_apply_direction_one_views_f32(const mw_xyz_f32 *out, const mw_motor_f32 *motor,
                                           const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_one_views_f64(const mw_xyz_f64 *out, const mw_motor_f64 *motor,
                                           const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_each_views_f32(const mw_xyz_f32 *out, const mw_const_motors_f32 *motors,
                                            const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_each_views_f64(const mw_xyz_f64 *out, const mw_const_motors_f64 *motors,
                                            const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_grid_views_f32(const mw_xyz_f32 *out, size_t row_stride,
                                            const mw_const_motors_f32 *motors, size_t motor_count,
                                            const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_grid_views_f64(const mw_xyz_f64 *out, size_t row_stride,
                                            const mw_const_motors_f64 *motors, size_t motor_count,
                                            const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_indexed_views_f32(const mw_xyz_f32 *out, const mw_motor_f32 *palette,
                                               size_t palette_count, const mw_indices *indices,
                                               const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_indexed_views_f64(const mw_xyz_f64 *out, const mw_motor_f64 *palette,
                                               size_t palette_count, const mw_indices *indices,
                                               const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_indexed_checked_views_f32(const mw_xyz_f32 *out, const mw_motor_f32 *palette,
                                                       size_t palette_count, const mw_indices *indices,
                                                       const mw_const_xyz_f32 *in, size_t count, unsigned flags,
                                                       size_t *first_bad);
mw_status mw_apply_direction_indexed_checked_views_f64(const mw_xyz_f64 *out, const mw_motor_f64 *palette,
                                                       size_t palette_count, const mw_indices *indices,
                                                       const mw_const_xyz_f64 *in, size_t count, unsigned flags,
                                                       size_t *first_bad);
mw_status mw_apply_tangent_one_views_f32(const mw_xyzw_f32 *out, const mw_motor_f32 *motor,
                                         const mw_const_xyzw_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_one_views_f64(const mw_xyzw_f64 *out, const mw_motor_f64 *motor,
                                         const mw_const_xyzw_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_each_views_f32(const mw_xyzw_f32 *out, const mw_const_motors_f32 *motors,
                                          const mw_const_xyzw_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_each_views_f64(const mw_xyzw_f64 *out, const mw_const_motors_f64 *motors,
                                          const mw_const_xyzw_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_grid_views_f32(const mw_xyzw_f32 *out, size_t row_stride,
                                          const mw_const_motors_f32 *motors, size_t motor_count,
                                          const mw_const_xyzw_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_grid_views_f64(const mw_xyzw_f64 *out, size_t row_stride,
                                          const mw_const_motors_f64 *motors, size_t motor_count,
                                          const mw_const_xyzw_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_indexed_views_f32(const mw_xyzw_f32 *out, const mw_motor_f32 *palette,
                                             size_t palette_count, const mw_indices *indices,
                                             const mw_const_xyzw_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_indexed_views_f64(const mw_xyzw_f64 *out, const mw_motor_f64 *palette,
                                             size_t palette_count, const mw_indices *indices,
                                             const mw_const_xyzw_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_indexed_checked_views_f32(const mw_xyzw_f32 *out, const mw_motor_f32 *palette,
                                                     size_t palette_count, const mw_indices *indices,
                                                     const mw_const_xyzw_f32 *in, size_t count, unsigned flags,
                                                     size_t *first_bad);
mw_status mw_apply_tangent_indexed_checked_views_f64(const mw_xyzw_f64 *out, const mw_motor_f64 *palette,
                                                     size_t palette_count, const mw_indices *indices,
                                                     const mw_const_xyzw_f64 *in, size_t count, unsigned flags,
                                                     size_t *first_bad);
mw_status mw_apply_vertex_one_views_f32(const mw_vertices_f32 *out, const mw_motor_f32 *motor,
                                        const mw_const_vertices_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_one_views_f64(const mw_vertices_f64 *out, const mw_motor_f64 *motor,
                                        const mw_const_vertices_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_each_views_f32(const mw_vertices_f32 *out, const mw_const_motors_f32 *motors,
                                         const mw_const_vertices_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_each_views_f64(const mw_vertices_f64 *out, const mw_const_motors_f64 *motors,
                                         const mw_const_vertices_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_grid_views_f32(const mw_vertices_f32 *out, size_t row_stride,
                                         const mw_const_motors_f32 *motors, size_t motor_count,
                                         const mw_const_vertices_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_grid_views_f64(const mw_vertices_f64 *out, size_t row_stride,
                                         const mw_const_motors_f64 *motors, size_t motor_count,
                                         const mw_const_vertices_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_indexed_views_f32(const mw_vertices_f32 *out, const mw_motor_f32 *palette,
                                            size_t palette_count, const mw_indices *indices,
                                            const mw_const_vertices_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_indexed_views_f64(const mw_vertices_f64 *out, const mw_motor_f64 *palette,
                                            size_t palette_count, const mw_indices *indices,
                                            const mw_const_vertices_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_indexed_checked_views_f32(const mw_vertices_f32 *out, const mw_motor_f32 *palette,
                                                    size_t palette_count, const mw_indices *indices,
                                                    const mw_const_vertices_f32 *in, size_t count, unsigned flags,
                                                    size_t *first_bad);
mw_status mw_apply_vertex_indexed_checked_views_f64(const mw_vertices_f64 *out, const mw_motor_f64 *palette,
                                                    size_t palette_count, const mw_indices *indices,
                                                    const mw_const_vertices_f64 *in, size_t count, unsigned flags,
                                                    size_t *first_bad);
mw_status mw_apply_vector_one_views_f32(const mw_vectors_f32 *out, const mw_motor_f32 *motor,
                                        const mw_const_vectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_one_views_f64(const mw_vectors_f64 *out, const mw_motor_f64 *motor,
                                        const mw_const_vectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_each_views_f32(const mw_vectors_f32 *out, const mw_const_motors_f32 *motors,
                                         const mw_const_vectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_each_views_f64(const mw_vectors_f64 *out, const mw_const_motors_f64 *motors,
                                         const mw_const_vectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_grid_views_f32(const mw_vectors_f32 *out, size_t row_stride,
                                         const mw_const_motors_f32 *motors, size_t motor_count,
                                         const mw_const_vectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_grid_views_f64(const mw_vectors_f64 *out, size_t row_stride,
                                         const mw_const_motors_f64 *motors, size_t motor_count,
                                         const mw_const_vectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_indexed_views_f32(const mw_vectors_f32 *out, const mw_motor_f32 *palette,
                                            size_t palette_count, const mw_indices *indices,
                                            const mw_const_vectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_indexed_views_f64(const mw_vectors_f64 *out, const mw_motor_f64 *palette,
                                            size_t palette_count, const mw_indices *indices,
                                            const mw_const_vectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_indexed_checked_views_f32(const mw_vectors_f32 *out, const mw_motor_f32 *palette,
                                                    size_t palette_count, const mw_indices *indices,
                                                    const mw_const_vectors_f32 *in, size_t count, unsigned flags,
                                                    size_t *first_bad);
mw_status mw_apply_vector_indexed_checked_views_f64(const mw_vectors_f64 *out, const mw_motor_f64 *palette,
                                                    size_t palette_count, const mw_indices *indices,
                                                    const mw_const_vectors_f64 *in, size_t count, unsigned flags,
                                                    size_t *first_bad);
mw_status mw_apply_line_one_views_f32(const mw_lines_f32 *out, const mw_motor_f32 *motor,
                                      const mw_const_lines_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_line_one_views_f64(const mw_lines_f64 *out, const mw_motor_f64 *motor,
                                      const mw_const_lines_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_line_each_views_f32(const mw_lines_f32 *out, const mw_const_motors_f32 *motors,
                                       const mw_const_lines_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_line_each_views_f64(const mw_lines_f64 *out, const mw_const_motors_f64 *motors,
                                       const mw_const_lines_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_line_grid_views_f32(const mw_lines_f32 *out, size_t row_stride, const mw_const_motors_f32 *motors,
                                       size_t motor_count, const mw_const_lines_f32 *in, size_t count,
                                       unsigned flags);
mw_status mw_apply_line_grid_views_f64(const mw_lines_f64 *out, size_t row_stride, const mw_const_motors_f64 *motors,
                                       size_t motor_count, const mw_const_lines_f64 *in, size_t count,
                                       unsigned flags);
mw_status mw_apply_line_indexed_views_f32(const mw_lines_f32 *out, const mw_motor_f32 *palette, size_t palette_count,
                                          const mw_indices *indices, const mw_const_lines_f32 *in, size_t count,
                                          unsigned flags);
mw_status mw_apply_line_indexed_views_f64(const mw_lines_f64 *out, const mw_motor_f64 *palette, size_t palette_count,
                                          const mw_indices *indices, const mw_const_lines_f64 *in, size_t count,
                                          unsigned flags);
mw_status mw_apply_line_indexed_checked_views_f32(const mw_lines_f32 *out, const mw_motor_f32 *palette,
                                                  size_t palette_count, const mw_indices *indices,
                                                  const mw_const_lines_f32 *in, size_t count, unsigned flags,
                                                  size_t *first_bad);
mw_status mw_apply_line_indexed_checked_views_f64(const mw_lines_f64 *out, const mw_motor_f64 *palette,
                                                  size_t palette_count, const mw_indices *indices,
                                                  const mw_const_lines_f64 *in, size_t count, unsigned flags,
                                                  size_t *first_bad);
mw_status mw_apply_motor_one_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *motor,
                                       const mw_const_motors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_one_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *motor,
                                       const mw_const_motors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *motors,
                                        const mw_const_motors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *motors,
                                        const mw_const_motors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_grid_views_f32(const mw_motors_f32 *out, size_t row_stride,
                                        const mw_const_motors_f32 *motors, size_t motor_count,
                                        const mw_const_motors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_grid_views_f64(const mw_motors_f64 *out, size_t row_stride,
                                        const mw_const_motors_f64 *motors, size_t motor_count,
                                        const mw_const_motors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_indexed_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *palette,
                                           size_t palette_count, const mw_indices *indices,
                                           const mw_const_motors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_indexed_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *palette,
                                           size_t palette_count, const mw_indices *indices,
                                           const mw_const_motors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_motor_indexed_checked_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *palette,
                                                   size_t palette_count, const mw_indices *indices,
                                                   const mw_const_motors_f32 *in, size_t count, unsigned flags,
                                                   size_t *first_bad);
mw_status mw_apply_motor_indexed_checked_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *palette,
                                                   size_t palette_count, const mw_indices *indices,
                                                   const mw_const_motors_f64 *in, size_t count, unsigned flags,
                                                   size_t *first_bad);
mw_status mw_apply_bivector_one_views_f32(const mw_bivectors_f32 *out, const mw_motor_f32 *motor,
                                          const mw_const_bivectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_one_views_f64(const mw_bivectors_f64 *out, const mw_motor_f64 *motor,
                                          const mw_const_bivectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_each_views_f32(const mw_bivectors_f32 *out, const mw_const_motors_f32 *motors,
                                           const mw_const_bivectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_each_views_f64(const mw_bivectors_f64 *out, const mw_const_motors_f64 *motors,
                                           const mw_const_bivectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_grid_views_f32(const mw_bivectors_f32 *out, size_t row_stride,
                                           const mw_const_motors_f32 *motors, size_t motor_count,
                                           const mw_const_bivectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_grid_views_f64(const mw_bivectors_f64 *out, size_t row_stride,
                                           const mw_const_motors_f64 *motors, size_t motor_count,
                                           const mw_const_bivectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_indexed_views_f32(const mw_bivectors_f32 *out, const mw_motor_f32 *palette,
                                              size_t palette_count, const mw_indices *indices,
                                              const mw_const_bivectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_indexed_views_f64(const mw_bivectors_f64 *out, const mw_motor_f64 *palette,
                                              size_t palette_count, const mw_indices *indices,
                                              const mw_const_bivectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_indexed_checked_views_f32(const mw_bivectors_f32 *out, const mw_motor_f32 *palette,
                                                      size_t palette_count, const mw_indices *indices,
                                                      const mw_const_bivectors_f32 *in, size_t count, unsigned flags,
                                                      size_t *first_bad);
mw_status mw_apply_bivector_indexed_checked_views_f64(const mw_bivectors_f64 *out, const mw_motor_f64 *palette,
                                                      size_t palette_count, const mw_indices *indices,
                                                      const mw_const_bivectors_f64 *in, size_t count, unsigned flags,
                                                      size_t *first_bad);

mw_status mw_apply_point_one_views_mixed(const mw_xyz_f32 *out, const mw_motor_f64 *motor, const mw_shift *shift,
                                         const mw_const_xyz_f32 *points, size_t count, unsigned flags);
mw_status mw_apply_point_each_views_mixed(const mw_xyz_f32 *out, const mw_const_motors_f64 *motors,
                                          const mw_shift *shift, const mw_const_xyz_f32 *points, size_t count,
                                          unsigned flags);
mw_status mw_apply_point_grid_views_mixed(const mw_xyz_f32 *out, size_t row_stride, const mw_const_motors_f64 *motors,
                                          size_t motor_count, const mw_shift *shift, const mw_const_xyz_f32 *points,
                                          size_t count, unsigned flags);
mw_status mw_apply_point_indexed_views_mixed(const mw_xyz_f32 *out, const mw_motor_f64 *palette, size_t palette_count,
                                             const mw_indices *indices, const mw_shift *shift,
                                             const mw_const_xyz_f32 *points, size_t count, unsigned flags);
mw_status mw_apply_point_indexed_checked_views_mixed(const mw_xyz_f32 *out, const mw_motor_f64 *palette,
                                                     size_t palette_count, const mw_indices *indices,
                                                     const mw_shift *shift, const mw_const_xyz_f32 *points,
                                                     size_t count, unsigned flags, size_t *first_bad);

mw_status mw_check_indices_views(const mw_indices *indices, size_t count, size_t palette_count, size_t *first_bad);

mw_status mw_check_motors_views_f32(const mw_const_motors_f32 *motors, size_t count, size_t *first_bad);
mw_status mw_check_motors_views_f64(const mw_const_motors_f64 *motors, size_t count, size_t *first_bad);

mw_status mw_compose_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *first,
                                          const mw_const_motors_f32 *then, size_t count);
mw_status mw_compose_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *first,
                                          const mw_const_motors_f64 *then, size_t count);

mw_status mw_compose_motor_one_first_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *first,
                                               const mw_const_motors_f32 *then, size_t count);
mw_status mw_compose_motor_one_first_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *first,
                                               const mw_const_motors_f64 *then, size_t count);
mw_status mw_compose_motor_one_then_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *first,
                                              const mw_motor_f32 *then, size_t count);
mw_status mw_compose_motor_one_then_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *first,
                                              const mw_motor_f64 *then, size_t count);

mw_status mw_compose_motor_hierarchy_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *locals,
                                               size_t joint_stride, const int32_t *parents, size_t joint_count,
                                               size_t count, size_t *first_bad);
mw_status mw_compose_motor_hierarchy_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *locals,
                                               size_t joint_stride, const int32_t *parents, size_t joint_count,
                                               size_t count, size_t *first_bad);

mw_status mw_reverse_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *motors, size_t count);
mw_status mw_reverse_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *motors, size_t count);

mw_status mw_normalize_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *motors,
                                            size_t count);
mw_status mw_normalize_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *motors,
                                            size_t count);

mw_status mw_inverse_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *motors, size_t count);
mw_status mw_inverse_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *motors, size_t count);

mw_status mw_ratio_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *from,
                                        const mw_const_motors_f32 *to, size_t count, unsigned flags);
mw_status mw_ratio_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *from,
                                        const mw_const_motors_f64 *to, size_t count, unsigned flags);

mw_status mw_exp_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_bivectors_f32 *generators,
                                      size_t count);
mw_status mw_exp_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_bivectors_f64 *generators,
                                      size_t count);

mw_status mw_log_motor_each_views_f32(const mw_bivectors_f32 *out, const mw_const_motors_f32 *motors, size_t count,
                                      unsigned flags);
mw_status mw_log_motor_each_views_f64(const mw_bivectors_f64 *out, const mw_const_motors_f64 *motors, size_t count,
                                      unsigned flags);
mw_status mw_log_principal_motor_each_views_f32(const mw_bivectors_f32 *out, const mw_const_motors_f32 *motors,
                                                size_t count, unsigned flags);
mw_status mw_log_principal_motor_each_views_f64(const mw_bivectors_f64 *out, const mw_const_motors_f64 *motors,
                                                size_t count, unsigned flags);

mw_status mw_sqrt_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *motors, size_t count);
mw_status mw_sqrt_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *motors, size_t count);

mw_status mw_power_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *motors,
                                        const float *exponents, size_t exponent_stride, size_t count);
mw_status mw_power_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *motors,
                                        const double *exponents, size_t exponent_stride, size_t count);

mw_status mw_slerp_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *first,
                                        const mw_const_motors_f32 *second, const float *parameters,
                                        size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_slerp_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *first,
                                        const mw_const_motors_f64 *second, const double *parameters,
                                        size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_slerp_motor_one_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *first,
                                       const mw_motor_f32 *second, const float *parameters, size_t parameter_stride,
                                       size_t count, unsigned flags);
mw_status mw_slerp_motor_one_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *first,
                                       const mw_motor_f64 *second, const double *parameters, size_t parameter_stride,
                                       size_t count, unsigned flags);

mw_status mw_nlerp_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *first,
                                        const mw_const_motors_f32 *second, const float *parameters,
                                        size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_nlerp_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *first,
                                        const mw_const_motors_f64 *second, const double *parameters,
                                        size_t parameter_stride, size_t count, unsigned flags);
mw_status mw_nlerp_motor_one_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *first,
                                       const mw_motor_f32 *second, const float *parameters, size_t parameter_stride,
                                       size_t count, unsigned flags);
mw_status mw_nlerp_motor_one_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *first,
                                       const mw_motor_f64 *second, const double *parameters, size_t parameter_stride,
                                       size_t count, unsigned flags);

mw_status mw_convert_motor_to_pose_each_views_f32(const mw_xyzw_f32 *quaternions, const mw_xyz_f32 *translations,
                                                  const mw_const_motors_f32 *motors, size_t count);
mw_status mw_convert_motor_to_pose_each_views_f64(const mw_xyzw_f64 *quaternions, const mw_xyz_f64 *translations,
                                                  const mw_const_motors_f64 *motors, size_t count);
mw_status mw_convert_pose_to_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_xyzw_f32 *quaternions,
                                                  const mw_const_xyz_f32 *translations, size_t count);
mw_status mw_convert_pose_to_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_xyzw_f64 *quaternions,
                                                  const mw_const_xyz_f64 *translations, size_t count);

mw_status mw_convert_motor_to_dual_quaternion_each_views_f32(const mw_dual_quaternions_f32 *out,
                                                             const mw_const_motors_f32 *motors, size_t count);
mw_status mw_convert_motor_to_dual_quaternion_each_views_f64(const mw_dual_quaternions_f64 *out,
                                                             const mw_const_motors_f64 *motors, size_t count);
mw_status mw_convert_dual_quaternion_to_motor_each_views_f32(const mw_motors_f32 *out,
                                                             const mw_const_dual_quaternions_f32 *in, size_t count);
mw_status mw_convert_dual_quaternion_to_motor_each_views_f64(const mw_motors_f64 *out,
                                                             const mw_const_dual_quaternions_f64 *in, size_t count);

mw_status mw_convert_motor_to_matrix_each_views_f32(const mw_matrices_f32 *out, const mw_const_motors_f32 *motors,
                                                    size_t count);
mw_status mw_convert_motor_to_matrix_each_views_f64(const mw_matrices_f64 *out, const mw_const_motors_f64 *motors,
                                                    size_t count);
mw_status mw_convert_matrix_to_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_matrices_f32 *matrices,
                                                    size_t count, unsigned flags, size_t *first_bad);
mw_status mw_convert_matrix_to_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_matrices_f64 *matrices,
                                                    size_t count, unsigned flags, size_t *first_bad);

mw_status mw_check_matrices_views_f32(const mw_const_matrices_f32 *matrices, size_t count, float tolerance,
                                      size_t *first_bad, float *deviation);
mw_status mw_check_matrices_views_f64(const mw_const_matrices_f64 *matrices, size_t count, double tolerance,
                                      size_t *first_bad, double *deviation);

mw_status mw_convert_motor_to_axis_angle_each_views_f32(const mw_xyzw_f32 *rotations, const mw_xyz_f32 *translations,
                                                        const mw_const_motors_f32 *motors, size_t count);
mw_status mw_convert_motor_to_axis_angle_each_views_f64(const mw_xyzw_f64 *rotations, const mw_xyz_f64 *translations,
                                                        const mw_const_motors_f64 *motors, size_t count);
mw_status mw_convert_axis_angle_to_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_xyzw_f32 *rotations,
                                                        const mw_const_xyz_f32 *translations, size_t count);
mw_status mw_convert_axis_angle_to_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_xyzw_f64 *rotations,
                                                        const mw_const_xyz_f64 *translations, size_t count);

mw_status mw_convert_motor_to_euler_each_views_f32(const mw_xyz_f32 *angles, const mw_xyz_f32 *translations,
                                                   const mw_const_motors_f32 *motors, size_t count,
                                                   mw_euler_order order);
mw_status mw_convert_motor_to_euler_each_views_f64(const mw_xyz_f64 *angles, const mw_xyz_f64 *translations,
                                                   const mw_const_motors_f64 *motors, size_t count,
                                                   mw_euler_order order);
mw_status mw_convert_euler_to_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_xyz_f32 *angles,
                                                   const mw_const_xyz_f32 *translations, size_t count,
                                                   mw_euler_order order);
mw_status mw_convert_euler_to_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_xyz_f64 *angles,
                                                   const mw_const_xyz_f64 *translations, size_t count,
                                                   mw_euler_order order);

mw_status mw_convert_translation_to_motor_each_views_f32(const mw_motors_f32 *out,
                                                         const mw_const_xyz_f32 *translations, size_t count);
mw_status mw_convert_translation_to_motor_each_views_f64(const mw_motors_f64 *out,
                                                         const mw_const_xyz_f64 *translations, size_t count);
mw_status mw_convert_motor_to_translation_each_views_f32(const mw_xyz_f32 *translations,
                                                         const mw_const_motors_f32 *motors, size_t count);
mw_status mw_convert_motor_to_translation_each_views_f64(const mw_xyz_f64 *translations,
                                                         const mw_const_motors_f64 *motors, size_t count);

mw_status mw_convert_motor_to_screw_each_views_f32(const mw_screws_f32 *out, const mw_const_motors_f32 *motors,
                                                   size_t count);
mw_status mw_convert_motor_to_screw_each_views_f64(const mw_screws_f64 *out, const mw_const_motors_f64 *motors,
                                                   size_t count);
mw_status mw_convert_screw_to_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_screws_f32 *screws,
                                                   size_t count);
mw_status mw_convert_screw_to_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_screws_f64 *screws,
                                                   size_t count);

mw_status mw_convert_motor_to_rotor_each_views_f32(const mw_motors_f32 *rotors, const mw_const_motors_f32 *motors,
                                                   size_t count, float lambda);
mw_status mw_convert_motor_to_rotor_each_views_f64(const mw_motors_f64 *rotors, const mw_const_motors_f64 *motors,
                                                   size_t count, double lambda);
mw_status mw_convert_rotor_to_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *rotors,
                                                   size_t count, float lambda);
mw_status mw_convert_rotor_to_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *rotors,
                                                   size_t count, double lambda);

mw_status mw_sample_motion_one_views_f32(const mw_motors_f32 *out, const mw_compiled_motion_f32 *motion, size_t index,
                                         const float *parameters, size_t count, unsigned flags);
mw_status mw_sample_motion_one_views_f64(const mw_motors_f64 *out, const mw_compiled_motion_f64 *motion, size_t index,
                                         const double *parameters, size_t count, unsigned flags);
mw_status mw_sample_motion_each_views_f32(const mw_motors_f32 *out, const mw_compiled_motion_f32 *motion,
                                          size_t index, const float *parameters, size_t parameter_stride,
                                          size_t count, unsigned flags);
mw_status mw_sample_motion_each_views_f64(const mw_motors_f64 *out, const mw_compiled_motion_f64 *motion,
                                          size_t index, const double *parameters, size_t parameter_stride,
                                          size_t count, unsigned flags);

mw_status mw_sample_motion_twist_one_views_f32(const mw_motors_f32 *out, const mw_bivectors_f32 *twists,
                                               const mw_compiled_motion_f32 *motion, size_t index,
                                               const float *parameters, size_t count, unsigned flags);
mw_status mw_sample_motion_twist_one_views_f64(const mw_motors_f64 *out, const mw_bivectors_f64 *twists,
                                               const mw_compiled_motion_f64 *motion, size_t index,
                                               const double *parameters, size_t count, unsigned flags);
mw_status mw_sample_motion_twist_each_views_f32(const mw_motors_f32 *out, const mw_bivectors_f32 *twists,
                                                const mw_compiled_motion_f32 *motion, size_t index,
                                                const float *parameters, size_t parameter_stride, size_t count,
                                                unsigned flags);
mw_status mw_sample_motion_twist_each_views_f64(const mw_motors_f64 *out, const mw_bivectors_f64 *twists,
                                                const mw_compiled_motion_f64 *motion, size_t index,
                                                const double *parameters, size_t parameter_stride, size_t count,
                                                unsigned flags);

mw_status mw_apply_point_motion_views_f32(const mw_xyz_f32 *out, size_t row_stride,
                                          const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                          size_t parameter_count, const mw_const_xyz_f32 *in, size_t count,
                                          unsigned flags);
mw_status mw_apply_point_motion_views_f64(const mw_xyz_f64 *out, size_t row_stride,
                                          const mw_compiled_motion_f64 *motion, size_t index,
                                          const double *parameters, size_t parameter_count,
                                          const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_motion_views_f32(const mw_xyz_f32 *out, size_t row_stride,
                                              const mw_compiled_motion_f32 *motion, size_t index,
                                              const float *parameters, size_t parameter_count,
                                              const mw_const_xyz_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_direction_motion_views_f64(const mw_xyz_f64 *out, size_t row_stride,
                                              const mw_compiled_motion_f64 *motion, size_t index,
                                              const double *parameters, size_t parameter_count,
                                              const mw_const_xyz_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_motion_views_f32(const mw_xyzw_f32 *out, size_t row_stride,
                                            const mw_compiled_motion_f32 *motion, size_t index,
                                            const float *parameters, size_t parameter_count,
                                            const mw_const_xyzw_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_tangent_motion_views_f64(const mw_xyzw_f64 *out, size_t row_stride,
                                            const mw_compiled_motion_f64 *motion, size_t index,
                                            const double *parameters, size_t parameter_count,
                                            const mw_const_xyzw_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_motion_views_f32(const mw_vertices_f32 *out, size_t row_stride,
                                           const mw_compiled_motion_f32 *motion, size_t index,
                                           const float *parameters, size_t parameter_count,
                                           const mw_const_vertices_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vertex_motion_views_f64(const mw_vertices_f64 *out, size_t row_stride,
                                           const mw_compiled_motion_f64 *motion, size_t index,
                                           const double *parameters, size_t parameter_count,
                                           const mw_const_vertices_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_motion_views_f32(const mw_vectors_f32 *out, size_t row_stride,
                                           const mw_compiled_motion_f32 *motion, size_t index,
                                           const float *parameters, size_t parameter_count,
                                           const mw_const_vectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_vector_motion_views_f64(const mw_vectors_f64 *out, size_t row_stride,
                                           const mw_compiled_motion_f64 *motion, size_t index,
                                           const double *parameters, size_t parameter_count,
                                           const mw_const_vectors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_line_motion_views_f32(const mw_lines_f32 *out, size_t row_stride,
                                         const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                         size_t parameter_count, const mw_const_lines_f32 *in, size_t count,
                                         unsigned flags);
mw_status mw_apply_line_motion_views_f64(const mw_lines_f64 *out, size_t row_stride,
                                         const mw_compiled_motion_f64 *motion, size_t index, const double *parameters,
                                         size_t parameter_count, const mw_const_lines_f64 *in, size_t count,
                                         unsigned flags);
mw_status mw_apply_motor_motion_views_f32(const mw_motors_f32 *out, size_t row_stride,
                                          const mw_compiled_motion_f32 *motion, size_t index, const float *parameters,
                                          size_t parameter_count, const mw_const_motors_f32 *in, size_t count,
                                          unsigned flags);
mw_status mw_apply_motor_motion_views_f64(const mw_motors_f64 *out, size_t row_stride,
                                          const mw_compiled_motion_f64 *motion, size_t index,
                                          const double *parameters, size_t parameter_count,
                                          const mw_const_motors_f64 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_motion_views_f32(const mw_bivectors_f32 *out, size_t row_stride,
                                             const mw_compiled_motion_f32 *motion, size_t index,
                                             const float *parameters, size_t parameter_count,
                                             const mw_const_bivectors_f32 *in, size_t count, unsigned flags);
mw_status mw_apply_bivector_motion_views_f64(const mw_bivectors_f64 *out, size_t row_stride,
                                             const mw_compiled_motion_f64 *motion, size_t index,
                                             const double *parameters, size_t parameter_count,
                                             const mw_const_bivectors_f64 *in, size_t count, unsigned flags);

mw_status mw_compare_motions_views_f32(mw_motion_distance_f32 *largest, const mw_compiled_motion_f32 *first,
                                       size_t first_index, const mw_compiled_motion_f32 *second, size_t second_index,
                                       const mw_const_xyz_f32 *points, size_t count, size_t sample_count);
mw_status mw_compare_motions_views_f64(mw_motion_distance_f64 *largest, const mw_compiled_motion_f64 *first,
                                       size_t first_index, const mw_compiled_motion_f64 *second, size_t second_index,
                                       const mw_const_xyz_f64 *points, size_t count, size_t sample_count);

/* --------------------------------------------------------------------------------------------- blending motors --- */

/* The weights of a blend: `term_count` base pointers, one per term, and one byte stride: the weight of term k in
 * element i is at byte offset i * stride from terms[k]. N rows of K adjacent weights are terms[k] = first + k with
 * stride K * sizeof(float); K columns of N weights are terms[k] = first + k * N with stride sizeof(float). */
typedef struct mw_weights_f32 { const float *const *terms; size_t stride; } mw_weights_f32;
typedef struct mw_weights_f64 { const double *const *terms; size_t stride; } mw_weights_f64;

/* out[i] = Σk weights[i][k] controls[k]: weighted sums of the same control motors, term after term in the order
 * k = 0, 1, ... The result is not normalised and need not be (the paper's section 4). It is degenerate where
 * controls of opposite sign cancel. Without terms (term_count = 0) every sum is the zero motor.
 * Time: count * term_count.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP. */
mw_status mw_blend_motor_one_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *controls,
                                       const mw_weights_f32 *weights, size_t term_count, size_t count);
mw_status mw_blend_motor_one_views_f64(const mw_motors_f64 *out, const mw_motor_f64 *controls,
                                       const mw_weights_f64 *weights, size_t term_count, size_t count);

/* The most terms of a blend in which each element has control motors of its own. */
enum { MW_MAX_TERMS = 256 };

/* out[i] = Σk weights[i][k] controls[k][i]: as above, each element with control motors of its own; controls[k] is
 * the view of all elements' k-th control. At most MW_MAX_TERMS terms.
 * Errors: MW_ERROR_NULL, MW_ERROR_STRIDE, MW_ERROR_SIZE, MW_ERROR_OVERLAP, MW_ERROR_TERM_COUNT. */
mw_status mw_blend_motor_each_views_f32(const mw_motors_f32 *out, const mw_const_motors_f32 *controls,
                                        const mw_weights_f32 *weights, size_t term_count, size_t count);
mw_status mw_blend_motor_each_views_f64(const mw_motors_f64 *out, const mw_const_motors_f64 *controls,
                                        const mw_weights_f64 *weights, size_t term_count, size_t count);

#undef MW_CAST
#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
