// What programs that were compiled against an earlier header rely on: sizes, places of members, numbers of enumerators.
// New members and enumerators go to the end, or into new types; what is asserted here stays. (The functions are in
// generated/api.json, which library_symbols.cmake compares with the library.)
#include <gtest/gtest.h>

#include <cstddef>

#include "motorway_views.h"

namespace {

constexpr std::size_t pointer = sizeof(void *), size = sizeof(std::size_t);

template <class T, class Motor, class Twist, class Distance>
constexpr bool are_numbers()
{
    return sizeof(Motor) == 8 * sizeof(T) && offsetof(Motor, s) == 0 && offsetof(Motor, b12) == sizeof(T) &&
           offsetof(Motor, b13) == 2 * sizeof(T) && offsetof(Motor, b23) == 3 * sizeof(T) &&
           offsetof(Motor, b1i) == 4 * sizeof(T) && offsetof(Motor, b2i) == 5 * sizeof(T) &&
           offsetof(Motor, b3i) == 6 * sizeof(T) && offsetof(Motor, w) == 7 * sizeof(T) &&
           sizeof(Twist) == 10 * sizeof(T) && offsetof(Twist, axis) == 0 && offsetof(Twist, angle) == 3 * sizeof(T) &&
           offsetof(Twist, along) == 4 * sizeof(T) && offsetof(Twist, across) == 7 * sizeof(T) &&
           offsetof(Distance, distance) == 0 && offsetof(Distance, parameters) == sizeof(T);
}
static_assert(are_numbers<float, mw_motor_f32, mw_twist_f32, mw_motion_distance_f32>());
static_assert(are_numbers<double, mw_motor_f64, mw_twist_f64, mw_motion_distance_f64>());
static_assert(sizeof(mw_shift) == 6 * sizeof(double) && offsetof(mw_shift, after) == 3 * sizeof(double));

// A view has a pointer per component, in order, and then the stride.
template <class View>
constexpr bool has_components(std::size_t count)
{
    return sizeof(View) == count * pointer + size && offsetof(View, stride) == count * pointer;
}
#define EXPECT_COMPONENTS(view, count, first, last)                                                                  \
    static_assert(has_components<mw_##view##_f32>(count) && has_components<mw_##view##_f64>(count) &&                \
                  has_components<mw_const_##view##_f32>(count) && has_components<mw_const_##view##_f64>(count) &&    \
                  offsetof(mw_##view##_f32, first) == 0 &&                                                           \
                  offsetof(mw_##view##_f32, last) == ((count) - 1) * pointer)
EXPECT_COMPONENTS(xyz, 3, x, z);
EXPECT_COMPONENTS(xyzw, 4, x, w);
EXPECT_COMPONENTS(vectors, 5, e0, ei);
EXPECT_COMPONENTS(lines, 6, dx, mz);
EXPECT_COMPONENTS(motors, 8, s, w);
EXPECT_COMPONENTS(bivectors, 6, b12, b3i);
EXPECT_COMPONENTS(dual_quaternions, 8, rx, dw);
EXPECT_COMPONENTS(screws, 8, ax, distance);
static_assert(sizeof(mw_vertices_f32) == 2 * sizeof(mw_xyz_f32) &&
              offsetof(mw_vertices_f32, normal) == sizeof(mw_xyz_f32));

template <class Matrices, class Weights, class Arrays, class Motion>
constexpr bool are_structs()
{
    return offsetof(Matrices, first) == 0 && offsetof(Matrices, stride) == pointer &&
           offsetof(Matrices, layout) == pointer + size && offsetof(Weights, terms) == 0 &&
           offsetof(Weights, stride) == pointer && offsetof(Arrays, controls) == 0 &&
           offsetof(Arrays, control_capacity) == pointer && offsetof(Arrays, knots) == pointer + size &&
           offsetof(Arrays, knot_capacity) == 2 * pointer + size && sizeof(Arrays) == 2 * (pointer + size) &&
           offsetof(Motion, kind) == 0 && offsetof(Motion, degree) == 4 && offsetof(Motion, controls) == 8 &&
           offsetof(Motion, control_count) == 8 + pointer && offsetof(Motion, knots) == 8 + pointer + size &&
           offsetof(Motion, knot_count) == 8 + 2 * pointer + size &&
           offsetof(Motion, weights) == 8 + 2 * (pointer + size) &&
           offsetof(Motion, closed) == 8 + 3 * pointer + 2 * size;
}
static_assert(are_structs<mw_matrices_f32, mw_weights_f32, mw_motion_arrays_f32, mw_motion_f32>());
static_assert(are_structs<mw_matrices_f64, mw_weights_f64, mw_motion_arrays_f64, mw_motion_f64>());
static_assert(offsetof(mw_indices, first) == 0 && offsetof(mw_indices, stride) == pointer &&
              offsetof(mw_indices, type) == pointer + size);

static_assert(MW_OK == 0 && MW_ERROR_NULL == 1 && MW_ERROR_STRIDE == 2 && MW_ERROR_SIZE == 3 && MW_ERROR_OVERLAP == 4 &&
              MW_ERROR_FLAGS == 5 && MW_ERROR_INDEX == 6 && MW_ERROR_INDEX_TYPE == 7 &&
              MW_ERROR_DEGENERATE_MOTOR == 8 && MW_ERROR_AXIS == 9 && MW_ERROR_MOTION_KIND == 10 &&
              MW_ERROR_DEGREE == 11 && MW_ERROR_CONTROL_COUNT == 12 && MW_ERROR_KNOT_COUNT == 13 &&
              MW_ERROR_KNOTS == 14 && MW_ERROR_WEIGHTS == 15 && MW_ERROR_VANISHING == 16 && MW_ERROR_PARAMETER == 17 &&
              MW_ERROR_MEMORY == 18 && MW_ERROR_MOTION == 19 && MW_ERROR_MOTION_INDEX == 20 &&
              MW_ERROR_CONVERGENCE == 21 && MW_ERROR_PARENT == 22 && MW_ERROR_MATRIX == 23 &&
              MW_ERROR_MATRIX_LAYOUT == 24 && MW_ERROR_EULER_ORDER == 25 && MW_ERROR_SCALE == 26 &&
              MW_ERROR_TERM_COUNT == 27 && MW_ERROR_ISA == 28);
static_assert(MW_DEFAULT == 0 && MW_UNIT_MOTORS == 1 && MW_STREAMING_STORES == 2 && MW_NO_STREAMING_STORES == 4 &&
              MW_LONG_WAY == 8 && MW_NEAREST_ROTATION == 16 && MW_KEEP_SIGNS == 32 && MW_CLAMP_PARAMETERS == 64 &&
              MW_WRAP_PARAMETERS == 128 && MW_BODY_FRAME == 256 && MW_ROTATION_MATRICES == 512);
static_assert(MW_INDEX_U8 == 1 && MW_INDEX_U16 == 2 && MW_INDEX_U32 == 4 && MW_MATRIX_ROWS_3X4 == 1 &&
              MW_MATRIX_ROWS_4X4 == 2 && MW_MATRIX_COLUMNS_3X4 == 3 && MW_MATRIX_COLUMNS_4X4 == 4 &&
              MW_EULER_XYZ == 0 && MW_EULER_ZYX == 5 && MW_EULER_XYX == 6 && MW_EULER_ZYZ == 11 &&
              MW_MOTION_ADDITIVE == 1 && MW_MOTION_MULTIPLICATIVE == 2 && MW_MOTION_CUMULATIVE == 3 &&
              MW_MOTION_GENERATOR == 4 && MW_MOTION_GENERATOR_KEYS == 5);

TEST(AbiTest, the_library_that_is_linked_is_of_this_header)
{
    EXPECT_EQ(mw_version(), unsigned(MW_VERSION));
}

}  // namespace
