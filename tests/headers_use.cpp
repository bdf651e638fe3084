// What a user's file makes of the headers: every view, const ones from mutable ones, and calls of each kind.
// headers.cmake compiles it with all warnings.
#include <cstdint>

#include "motorway.hpp"

static_assert(sizeof(mw_status) == 4 && sizeof(mw_index_type) == 4 && sizeof(mw_matrix_layout) == 4 &&
                  sizeof(mw_euler_order) == 4 && sizeof(mw_motion_kind) == 4,
              "enumerations are of one size, whatever -fshort-enums says");

namespace {

template <class T> mw_status use_views(T *numbers, std::size_t stride)
{
    using namespace motorway;
    motor<T> one[2] = {};
    T *const eight[8] = {};
    const_xyz<T> points = aos(numbers), apart = soa(numbers, numbers, numbers);
    const_xyzw<T> tangents = xyzw_aos(numbers, stride), quaternions = xyzw_wxyz(numbers);
    const_vectors<T> spheres = vectors_aos(numbers);
    const_lines<T> lines = lines_aos(numbers);
    const_motors<T> motors = aos(one), motors_apart = soa(eight);
    const_bivectors<T> generators = bivectors_aos(numbers);
    const_dual_quaternions<T> duals = dual_quaternions_aos(numbers), duals_of_w = dual_quaternions_wxyz(numbers);
    const_screws<T> screws = screws_aos(numbers);
    const_matrices<T> of_rows = matrices(numbers, MW_MATRIX_ROWS_4X4);
    const_vertices<T> vertices = vertices_aos(numbers, numbers + 3, stride);
    const std::uint8_t bytes[2] = {};
    const mw_indices picked = mw_indices_from(indices(bytes), 1);

    mw_status status = apply_point_one(aos(numbers), one[0], points, 1, MW_STREAMING_STORES);
    status = status ? status : apply_direction_each(aos(numbers), motors, apart, 1);
    status = status ? status : apply_tangent_indexed(xyzw_aos(numbers), one, 2, picked, tangents, 1);
    status = status ? status : apply_vector_grid(vectors_aos(numbers), stride, motors_apart, 1, spheres, 1);
    status = status ? status : apply_line_one(lines_aos(numbers), one[1], lines, 1);
    status = status ? status : apply_vertex_one(vertices_aos(numbers, numbers + 3, stride), one[0], vertices, 1);
    status = status ? status : exp_motor_each(aos(one), generators, 1);
    status = status ? status : convert_pose_to_motor_each(aos(one), quaternions, points, 1);
    status = status ? status : convert_dual_quaternion_to_motor_each(aos(one), duals, 1);
    status = status ? status : convert_dual_quaternion_to_motor_each(aos(one), duals_of_w, 1);
    status = status ? status : convert_screw_to_motor_each(aos(one), screws, 1);
    status = status ? status : convert_matrix_to_motor_each(aos(one), of_rows, 1);
    status = status ? status : rotation(one[0], {0, 0, 1}, T(1));
    motion<T> path = {};
    path.kind = MW_MOTION_ADDITIVE;
    std::size_t size = 0;
    return status ? status : motion_size(size, path);
}

} // namespace

#define USE_FROM(view) (void)mw_##view##_f32_from({}, 1), (void)mw_const_##view##_f64_from({}, 1)

int main()
{
    USE_FROM(xyz), USE_FROM(xyzw), USE_FROM(vectors), USE_FROM(lines), USE_FROM(motors), USE_FROM(bivectors);
    USE_FROM(dual_quaternions), USE_FROM(screws), USE_FROM(vertices);
    float f32[16] = {};
    double f64[16] = {};
    return use_views(f32, sizeof f32) || use_views(f64, sizeof f64) || !mw_isas();
}
