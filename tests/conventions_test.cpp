// docs/conventions.md, row by row: what each library says a rotation, a pose and a product of them is, in plain
// arithmetic from its documentation, against this library's conversions. Eigen, GLM and Sophus themselves where they
// were found.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#if __has_include(<Eigen/Geometry>)
#include <Eigen/Geometry>
#define MOTORWAY_TEST_EIGEN
#endif
#if __has_include(<glm/gtx/dual_quaternion.hpp>)
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/quaternion.hpp>
#include <glm/gtx/dual_quaternion.hpp>
#define MOTORWAY_TEST_GLM
#endif
#if __has_include(<sophus/se3.hpp>)
#include <sophus/se3.hpp>
#define MOTORWAY_TEST_SOPHUS
#endif

#include "conventions_algebra.h"
#include "conventions_poses.h"
#include "motorway_views.h"
#include "random.h"

namespace motorway::testing::conventions {
namespace {

// Calls `test` for many poses, pairs of them and points.
void for_many_poses(std::uint64_t seed, const std::function<void(const Pose &, const Pose &, const Vector &)> &test)
{
    Random random(seed);
    for (int repetition = 0; repetition < 100 && !::testing::Test::HasFailure(); ++repetition) {
        const Pose first = draw_pose(random), then = draw_pose(random);
        test(first, then, draw_vector(random));
    }
}

// The pose of doing one and then the other, by the definition of a pose.
Pose after(const Pose &first, const Pose &then)
{
    return {then.rotation * first.rotation, moved(then, first.translation)};
}

// ------------------------------------------------------------------------------------------------- our own side

TEST(ConventionsTest, a_pose_rotates_and_then_translates)
{
    for_many_poses(1, [](const Pose &pose, const Pose &then, const Vector &p) {
        const Motor motor = motor_of(pose);
        expect_near(moved(motor, p), moved(pose, p));
        expect_near(composed(motor, motor_of(then)), motor_of(after(pose, then)));
        const Pose back = pose_of(motor);
        expect_near(back.rotation, pose.rotation);
        expect_near(back.translation, pose.translation);
    });
}

TEST(ConventionsTest, a_pose_in_components)
{
    for_many_poses(2, [](const Pose &pose, const Pose &, const Vector &) {
        const auto [x, y, z, w] = pose.rotation;
        const auto [tx, ty, tz] = pose.translation;
        expect_near(motor_of(pose), {w, z, -y, x, (tx * w + ty * z - tz * y) / 2, (ty * w + tz * x - tx * z) / 2,
                                     (tz * w + tx * y - ty * x) / 2, (tx * x + ty * y + tz * z) / 2});
    });
}

// Of any eight numbers, normalised or not.
TEST(ConventionsTest, a_motor_as_a_pose_in_components)
{
    Random random(3);
    for (int repetition = 0; repetition < 100; ++repetition) {
        const Motor m{1 + random.uniform(0, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                      random.uniform(-1, 1),    random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const double alpha = m.s * m.s + m.b12 * m.b12 + m.b13 * m.b13 + m.b23 * m.b23;
        const Pose pose = pose_of(m);
        expect_near(pose.rotation, 1 / std::sqrt(alpha) * Quaternion{m.b23, -m.b13, m.b12, m.s});
        expect_near(pose.translation, 2 / alpha * Vector{m.s * m.b1i - m.b12 * m.b2i - m.b13 * m.b3i + m.b23 * m.w,
                                                         m.s * m.b2i + m.b12 * m.b1i - m.b23 * m.b3i - m.b13 * m.w,
                                                         m.s * m.b3i + m.b13 * m.b1i + m.b23 * m.b2i + m.b12 * m.w});
        const Vector p = draw_vector(random);
        expect_near(moved(m, p), moved(pose, p));
    }
}

TEST(ConventionsTest, quaternions_lie_as_xyzw_or_as_wxyz)
{
    for_many_poses(11, [](const Pose &pose, const Pose &, const Vector &) {
        const auto [x, y, z, w] = pose.rotation;
        const double wxyz[4] = {w, x, y, z};
        const mw_const_xyzw_f64 rotation = mw_const_xyzw_f64_wxyz(wxyz, sizeof wxyz);
        const mw_const_xyz_f64 translation =
            mw_const_xyz_f64_aos(pose.translation.data(), sizeof pose.translation);
        Motor motor;
        const mw_motors_f64 out = mw_motors_f64_aos(&motor, sizeof motor);
        ASSERT_EQ(mw_convert_pose_to_motor_each_views_f64(&out, &rotation, &translation, 1), MW_OK);
        expect_near(motor, motor_of(pose));
    });
}

TEST(ConventionsTest, matrices_in_every_layout)
{
    for_many_poses(4, [](const Pose &pose, const Pose &, const Vector &) {
        const Matrix m = matrix_of(pose);
        const Motor motor = motor_of(pose);
        std::array<double, 16> rows_4x4{}, columns_4x4{}, rows_3x4{}, columns_3x4{};
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column) {
                rows_4x4[4 * row + column] = columns_4x4[4 * column + row] = m[row][column];
                if (row < 3)
                    rows_3x4[4 * row + column] = columns_3x4[3 * column + row] = m[row][column];
            }
        const auto check = [&](const std::array<double, 16> &matrix, mw_matrix_layout layout) {
            expect_near(matrix_of(motor, layout), matrix);
            expect_same_motion(motor_of(matrix.data(), layout), motor);
        };
        check(rows_4x4, MW_MATRIX_ROWS_4X4);
        check(columns_4x4, MW_MATRIX_COLUMNS_4X4);
        check(rows_3x4, MW_MATRIX_ROWS_3X4);
        check(columns_3x4, MW_MATRIX_COLUMNS_3X4);
    });
}

// T R S of a node is its scale and its motor (docs/conventions.md has these two in C).
TEST(ConventionsTest, scale_of_a_matrix_beside_its_motor)
{
    Random random(44);
    for_many_poses(45, [&](const Pose &pose, const Pose &, const Vector &point) {
        const Vector size{random.magnitude(0.1, 10), random.magnitude(0.1, 10), random.magnitude(0.1, 10)};
        Matrix m = matrix_of(pose);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                m[r][c] *= size[c];
        const Vector expected = moved(pose, {size[0] * point[0], size[1] * point[1], size[2] * point[2]});
        Vector scale, columns[3];
        for (std::size_t c = 0; c < 3; ++c) {
            columns[c] = {m[0][c], m[1][c], m[2][c]};
            scale[c] = std::sqrt(dot(columns[c], columns[c]));
        }
        if (dot(columns[0], cross(columns[1], columns[2])) < 0)
            scale[0] = -scale[0];
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                m[r][c] /= scale[c];
        const Motor motor = motor_of(&m[0][0], MW_MATRIX_ROWS_4X4);
        expect_near(moved(motor, {scale[0] * point[0], scale[1] * point[1], scale[2] * point[2]}), expected);
    });
}

TEST(ConventionsTest, scale_beside_the_motors_of_a_hierarchy)
{
    Random random(46);
    for (int repetition = 0; repetition < 20; ++repetition) {
        const std::int32_t parents[4] = {-1, 0, 1, 1};
        Motor local[4], world[4];
        double scale[4];
        Matrix expected[4];
        for (std::size_t j = 0; j < 4; ++j) {
            const Pose pose = draw_pose(random);
            const double local_scale = random.uniform(0.2, 3);
            Matrix scaled = matrix_of(pose);
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < 3; ++c)
                    scaled[r][c] *= local_scale;
            const auto parent = static_cast<std::size_t>(std::max(parents[j], 0));
            expected[j] = j ? expected[parent] * scaled : scaled;
            local[j] = motor_of(pose);
            const double above = j ? scale[parent] : 1;
            scale[j] = above * local_scale;
            local[j].b1i *= above, local[j].b2i *= above, local[j].b3i *= above, local[j].w *= above;
        }
        ASSERT_EQ(mw_compose_motor_hierarchy_f64(world, 4 * sizeof(Motor),
                                                 local, 4 * sizeof(Motor), sizeof(Motor),
                                                 parents, 4, 1, nullptr),
                  MW_OK);
        const Vector point = draw_vector(random);
        for (std::size_t j = 0; j < 4; ++j) {
            Vector image{};
            for (std::size_t r = 0; r < 3; ++r)
                image[r] = expected[j][r][0] * point[0] + expected[j][r][1] * point[1] +
                           expected[j][r][2] * point[2] + expected[j][r][3];
            const Vector got = moved(world[j], scale[j] * point);
            for (std::size_t r = 0; r < 3; ++r)
                EXPECT_NEAR(got[r], image[r], 100 * tolerance) << "joint " << j;
        }
    }
}

// A quaternion of any length is the same motion, and so is a dual quaternion; one whose halves are not orthogonal moves
// by the vector part of 2 d r* / |r|².
TEST(ConventionsTest, quaternions_of_any_length)
{
    Random random(47);
    for_many_poses(48, [&](const Pose &pose, const Pose &other, const Vector &point) {
        Pose longer = pose;
        longer.rotation = random.magnitude(1e-3, 1e3) * pose.rotation;
        const Motor motor = motor_of(longer);
        expect_near(moved(motor, point), moved(pose, point));
        expect_near(moved(composed(motor, motor_of(other)), point), moved(other, moved(pose, point)));
        const Pose back = pose_of(motor);
        expect_near(moved(back, point), moved(pose, point));
    });
}

TEST(ConventionsTest, dual_quaternions_that_are_not_unit)
{
    Random random(49);
    for_many_poses(50, [&](const Pose &pose, const Pose &, const Vector &point) {
        const Quaternion r = random.magnitude(0.1, 10) * pose.rotation;
        const Quaternion d{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
        const double numbers[8] = {r.x, r.y, r.z, r.w, d.x, d.y, d.z, d.w};
        Motor motor{};
        ASSERT_EQ(mw_convert_dual_quaternion_to_motor_each_f64(
                      &motor, sizeof motor,
                      numbers, sizeof numbers, 1),
                  MW_OK);
        const Quaternion product = d * conjugate(r);
        const double square = r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w;
        const Vector way = 2 / square * Vector{product.x, product.y, product.z};
        const Vector got = moved(motor, point), expected = rotated(pose.rotation, point) + way;
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(got[k], expected[k], 100 * tolerance);
    });
}

TEST(ConventionsTest, axis_and_angle)
{
    Random random(5);
    for (int repetition = 0; repetition < 100; ++repetition) {
        const Vector a = draw_axis(random), none{};
        const double angle = random.uniform(0.1, pi - 0.01);
        const double cosine = std::cos(angle / 2), sine = std::sin(angle / 2);
        const double rotation[4] = {a[0], a[1], a[2], angle};
        Motor motor;
        ASSERT_EQ(mw_convert_axis_angle_to_motor_each_f64(&motor, sizeof motor,
                                                          rotation, sizeof rotation,
                                                          none.data(), sizeof none, 1),
                  MW_OK);
        expect_near(motor, {cosine, a[2] * sine, -a[1] * sine, a[0] * sine, 0, 0, 0, 0});
        std::array<double, 4> back;
        Vector translation;
        ASSERT_EQ(mw_convert_motor_to_axis_angle_each_f64(back.data(), sizeof back,
                                                          translation.data(), sizeof translation,
                                                          &motor, sizeof motor, 1),
                  MW_OK);
        expect_near(back, {a[0], a[1], a[2], angle});
        expect_near(translation, none);
    }
}

Quaternion about(char axis, double angle)
{
    return about_axis({axis == 'X' ? 1.0 : 0.0, axis == 'Y' ? 1.0 : 0.0, axis == 'Z' ? 1.0 : 0.0}, angle);
}

// In the order of mw_euler_order.
constexpr const char *euler_orders[] = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX",
                                        "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ"};

// About axes that turn along, the rotation named first is the leftmost factor: it acts last on a point.
TEST(ConventionsTest, euler_angles_are_about_axes_that_turn_along)
{
    Random random(6);
    for (int order = MW_EULER_XYZ; order <= int(MW_EULER_ZYZ); ++order) {
        const char *const axes = euler_orders[order];
        const Vector angles = draw_vector(random);
        const Quaternion rotation = about(axes[0], angles[0]) * about(axes[1], angles[1]) * about(axes[2], angles[2]);
        const auto ours = static_cast<mw_euler_order>(order);
        const Motor motor = motor_of_euler(angles, ours);
        expect_same_motion(motor, motor_of({rotation, {}}));
        Vector back, translation;
        ASSERT_EQ(mw_convert_motor_to_euler_each_f64(back.data(), sizeof back,
                                                     translation.data(), sizeof translation,
                                                     &motor, sizeof motor, 1, ours),
                  MW_OK);
        expect_same_motion(motor_of_euler(back, ours), motor);
    }
}

// About axes that stay fixed: the opposite order and the angles reversed.
TEST(ConventionsTest, euler_angles_about_fixed_axes)
{
    Random random(7);
    const Vector angles = draw_vector(random);
    const Motor x = motor_of({about('X', angles[0]), {}});
    const Motor y = motor_of({about('Y', angles[1]), {}});
    const Motor z = motor_of({about('Z', angles[2]), {}});
    expect_same_motion(motor_of_euler({angles[2], angles[1], angles[0]}, MW_EULER_ZYX), composed(composed(x, y), z));
}

TEST(ConventionsTest, a_screw_in_components)
{
    Random random(8);
    for (int repetition = 0; repetition < 100; ++repetition) {
        const Vector a = draw_axis(random), p = draw_vector(random), m = cross(p, a), q = draw_vector(random);
        const double angle = random.uniform(0.1, pi - 0.01), distance = random.uniform(-3, 3);
        const double c = std::cos(angle / 2), s = std::sin(angle / 2), half = distance / 2;
        const double screw[8] = {a[0], a[1], a[2], p[0], p[1], p[2], angle, distance};
        Motor motor;
        ASSERT_EQ(mw_convert_screw_to_motor_each_f64(&motor, sizeof motor,
                                                     screw, sizeof screw, 1),
                  MW_OK);
        expect_near(motor, {c, s * a[2], -s * a[1], s * a[0], half * c * a[0] + s * m[0], half * c * a[1] + s * m[1],
                            half * c * a[2] + s * m[2], half * s});
        std::array<double, 8> back;  // with the point of the axis nearest to the origin
        ASSERT_EQ(mw_convert_motor_to_screw_each_f64(back.data(), sizeof back,
                                                     &motor, sizeof motor, 1),
                  MW_OK);
        const Vector nearest = p + -dot(p, a) * a;
        expect_near(back, {a[0], a[1], a[2], nearest[0], nearest[1], nearest[2], angle, distance});
        const Vector from_axis = q + -1.0 * p;
        expect_near(moved(motor, q), p + rotated(about_axis(a, angle), from_axis) + distance * a);
    }
}

TEST(ConventionsTest, a_translation_in_components)
{
    Random random(9);
    const Vector t = draw_vector(random);
    Motor motor;
    ASSERT_EQ(mw_convert_translation_to_motor_each_f64(&motor, sizeof motor,
                                                       t.data(), sizeof t, 1),
              MW_OK);
    expect_near(motor, {1, 0, 0, 0, t[0] / 2, t[1] / 2, t[2] / 2, 0});
}

// R x ~R on F(x) = (x² n + 2 λ x - λ² n̄) / 2 λ² with n = e + ē and n̄ = e - ē (their section 1); of the image, the
// part on e1 e2 e3 is x/λ times the difference of those on ē and e.
TEST(ConventionsTest, rotors_of_wareham_and_lasenby)
{
    using Element = Multivector<Conformal>;
    const Element n = blade<Conformal>("4") + blade<Conformal>("5");
    const Element n_bar = blade<Conformal>("4") + -1.0 * blade<Conformal>("5");
    for (double lambda : {1.0, 0.5, 4.0})
        for_many_poses(10, [&](const Pose &pose, const Pose &, const Vector &x) {
            const Motor motor = motor_of(pose);
            Motor r;
            ASSERT_EQ(mw_convert_motor_to_rotor_each_f64(&r, sizeof r,
                                                         &motor, sizeof motor, 1, lambda),
                      MW_OK);
            expect_near(r, {motor.s, -motor.b12, -motor.b13, -motor.b23, -motor.b1i / lambda, -motor.b2i / lambda,
                            -motor.b3i / lambda, motor.w / lambda});
            Motor back;
            ASSERT_EQ(mw_convert_rotor_to_motor_each_f64(&back, sizeof back,
                                                         &r, sizeof r, 1, lambda),
                      MW_OK);
            expect_near(back, motor);
            const Element vector =
                x[0] * blade<Conformal>("1") + x[1] * blade<Conformal>("2") + x[2] * blade<Conformal>("3");
            const Element point = 1 / (2 * lambda * lambda) *
                                  (dot(x, x) * n + 2 * lambda * vector + -lambda * lambda * n_bar);
            const Element rotor = r.s * blade<Conformal>("") + r.b12 * blade<Conformal>("12") +
                                  r.b13 * blade<Conformal>("13") + r.b23 * blade<Conformal>("23") +
                                  (r.b1i * blade<Conformal>("1") + r.b2i * blade<Conformal>("2") +
                                   r.b3i * blade<Conformal>("3") + r.w * blade<Conformal>("123")) *
                                      n;
            const Element image = rotor * point * reverse(rotor);
            const double weight = coefficient(image, "5") - coefficient(image, "4");
            expect_near(lambda / weight * Vector{coefficient(image, "1"), coefficient(image, "2"),
                                                 coefficient(image, "3")},
                        moved(pose, x));
        });
}

// ------------------------------------------------------------------------------------- dual quaternions, and GLM

// As eight numbers in memory: the real quaternion x y z w and then the dual one.
using DualQuaternion = std::array<Quaternion, 2>;

// (r + εd) (r' + εd') with ε² = 0.
DualQuaternion product(const DualQuaternion &a, const DualQuaternion &b)
{
    return {a[0] * b[0], a[0] * b[1] + a[1] * b[0]};
}

Motor motor_of_dual(const DualQuaternion &q)
{
    Motor motor{};
    EXPECT_EQ(mw_convert_dual_quaternion_to_motor_each_f64(&motor, sizeof motor,
                                                           &q[0].x, sizeof q, 1),
              MW_OK);
    return motor;
}

// d = ½ t r.
DualQuaternion dual_quaternion_of(const Pose &pose)
{
    const Vector &t = pose.translation;
    return {pose.rotation, 0.5 * (Quaternion{t[0], t[1], t[2], 0} * pose.rotation)};
}

TEST(ConventionsTest, dual_quaternions)
{
    for_many_poses(20, [](const Pose &first, const Pose &then, const Vector &p) {
        const DualQuaternion a = dual_quaternion_of(first), b = dual_quaternion_of(then);
        const Motor m = motor_of_dual(a);
        expect_near(m, motor_of(first));
        const std::array<double, 8> in_components{m.b23, -m.b13, m.b12, m.s, m.b1i, m.b2i, m.b3i, -m.w};
        expect_near(in_components, {a[0].x, a[0].y, a[0].z, a[0].w, a[1].x, a[1].y, a[1].z, a[1].w});
        expect_near(motor_of_dual(product(b, a)), composed(m, motor_of_dual(b)));

        // r p r* + 2 d r*.
        const Quaternion offset = 2 * (a[1] * conjugate(a[0]));
        expect_near(moved(m, p), rotated(a[0], p) + Vector{offset.x, offset.y, offset.z});

        std::array<double, 8> wxyz;
        const mw_dual_quaternions_f64 out = mw_dual_quaternions_f64_wxyz(wxyz.data(), sizeof wxyz);
        const mw_const_motors_f64 motors = mw_const_motors_f64_aos(&m, sizeof m);
        ASSERT_EQ(mw_convert_motor_to_dual_quaternion_each_views_f64(&out, &motors, 1), MW_OK);
        expect_near(wxyz, {a[0].w, a[0].x, a[0].y, a[0].z, a[1].w, a[1].x, a[1].y, a[1].z});
    });
}

#ifdef MOTORWAY_TEST_GLM
using GlmQuaternion = glm::qua<double, glm::defaultp>;
using GlmDualQuaternion = glm::tdualquat<double, glm::defaultp>;

GlmDualQuaternion glm_dual_quaternion(const Pose &pose)
{
    GlmQuaternion rotation;
    rotation.x = pose.rotation.x, rotation.y = pose.rotation.y, rotation.z = pose.rotation.z;
    rotation.w = pose.rotation.w;
    return {rotation, glm::dvec3(pose.translation[0], pose.translation[1], pose.translation[2])};
}

// From its memory; w comes first if GLM was told so by GLM_FORCE_QUAT_DATA_WXYZ.
Motor motor_of_glm(const GlmDualQuaternion &q)
{
    const double *const first = reinterpret_cast<const double *>(&q);
    const mw_const_dual_quaternions_f64 view = &q.real.w < &q.real.x
                                                   ? mw_const_dual_quaternions_f64_wxyz(first, sizeof q)
                                                   : mw_const_dual_quaternions_f64_aos(first, sizeof q);
    Motor motor{};
    const mw_motors_f64 out = mw_motors_f64_aos(&motor, sizeof motor);
    EXPECT_EQ(mw_convert_dual_quaternion_to_motor_each_views_f64(&out, &view, 1), MW_OK);
    return motor;
}

TEST(ConventionsTest, glm)
{
    for_many_poses(21, [](const Pose &first, const Pose &then, const Vector &p) {
        const GlmDualQuaternion a = glm_dual_quaternion(first), b = glm_dual_quaternion(then);
        expect_near(motor_of_glm(a), motor_of(first));
        expect_near(motor_of_glm(b * a), composed(motor_of(first), motor_of(then)));
        const glm::dvec3 image = a * glm::dvec3(p[0], p[1], p[2]);
        expect_near(Vector{image.x, image.y, image.z}, moved(motor_of_glm(a), p));

        // Columns one after the other; but mat3x4_cast writes the rows of the matrix into the columns of its result.
        glm::dmat4 columns = glm::mat4_cast(a.real);
        columns[3] = glm::dvec4(first.translation[0], first.translation[1], first.translation[2], 1);
        expect_same_motion(motor_of(&columns[0].x, MW_MATRIX_COLUMNS_4X4), motor_of(first));
        const auto rows = glm::mat3x4_cast(a);
        expect_same_motion(motor_of(&rows[0].x, MW_MATRIX_ROWS_3X4), motor_of(first));
    });
}
#else
TEST(ConventionsTest, glm) { GTEST_SKIP() << "GLM was not found when this was built"; }
#endif

// ---------------------------------------------------------------------------------- projective geometric algebra

using Pga = Multivector<Projective>;

// m p ~m for the point p = x e032 + y e013 + z e021 + e123.
Vector pga_moved(const Pga &m, const Vector &p)
{
    const Pga point = p[0] * blade<Projective>("032") + p[1] * blade<Projective>("013") +
                      p[2] * blade<Projective>("021") + blade<Projective>("123");
    const Pga image = m * point * reverse(m);
    return 1 / coefficient(image, "123") *
           Vector{coefficient(image, "032"), coefficient(image, "013"), coefficient(image, "021")};
}

// The names of the components of an array, in order.
template <std::size_t N>
Pga pga_of(const std::array<double, N> &memory, const std::array<const char *, N> &names)
{
    Pga sum;
    for (std::size_t k = 0; k < N; ++k)
        sum = sum + memory[k] * blade<Projective>(names[k]);
    return sum;
}

template <std::size_t N>
std::array<double, N> memory_of(const Pga &element, const std::array<const char *, N> &names)
{
    std::array<double, N> memory;
    for (std::size_t k = 0; k < N; ++k)
        memory[k] = coefficient(element, names[k]);
    return memory;
}

// p1_ and p2_ of kln::motor.
constexpr std::array<const char *, 8> klein{"", "23", "31", "12", "0123", "01", "02", "03"};

Motor motor_of_klein(const std::array<double, 8> &k)
{
    return {k[0], -k[3], k[2], -k[1], -k[5], -k[6], -k[7], k[4]};
}

std::array<double, 8> klein_of(const Motor &m) { return {m.s, -m.b23, m.b13, -m.b12, m.w, -m.b1i, -m.b2i, -m.b3i}; }

TEST(ConventionsTest, klein_motors)
{
    for_many_poses(30, [](const Pose &first, const Pose &then, const Vector &p) {
        const Motor a = motor_of(first), b = motor_of(then);
        const Pga klein_a = pga_of(klein_of(a), klein), klein_b = pga_of(klein_of(b), klein);
        expect_near(motor_of_klein(klein_of(a)), a);
        expect_near(pga_moved(klein_a, p), moved(a, p));
        expect_near(motor_of_klein(memory_of(klein_b * klein_a, klein)), composed(a, b));
    });
}

// The numbers of motor-point and motor-to-matrix in Klein's own tests: a motor that is not normalised, and where it
// takes the point (-1, 1, 2).
TEST(ConventionsTest, klein_motor_of_its_own_tests)
{
    const Motor motor = motor_of_klein({1, 4, 3, 2, 8, 5, 6, 7});
    const double weight = 30;
    expect_near(moved(motor, {-1, 1, 2}), {-12 / weight, -86 / weight, -86 / weight});
}

// kln::rotor{angle, x, y, z} is cos + sin (x e23 + y e31 + z e12), which turns e1 away from e2, by its own test
// rotor-point; kln::translator{d, x, y, z} is 1 - ½ d (x e01 + y e02 + z e03), and moves forwards.
TEST(ConventionsTest, klein_rotors_turn_the_other_way)
{
    Random random(31);
    const Vector a = draw_axis(random), p = draw_vector(random);
    const double angle = 1.25, c = std::cos(angle / 2), s = std::sin(angle / 2), distance = 2.5;
    const Motor rotation = motor_of_klein({c, s * a[0], s * a[1], s * a[2], 0, 0, 0, 0});
    expect_near(moved(rotation, p), rotated(about_axis(a, -angle), p));
    const double half = -distance / 2;
    const Motor translation = motor_of_klein({1, 0, 0, 0, 0, half * a[0], half * a[1], half * a[2]});
    expect_near(moved(translation, p), p + distance * a);

    const double quarter = std::sqrt(0.5);
    expect_near(moved(motor_of_klein({quarter, 0, 0, quarter, 0, 0, 0, 0}), {1, 0, 0}), {0, -1, 0});
}

// The sixteen numbers of Algebra(3,0,1) in ganja.js, and of the classes that it generates in other languages.
constexpr std::array<const char *, 16> ganja{"",   "0",  "1",  "2",   "3",   "01",  "02",  "03",
                                             "12", "13", "23", "012", "013", "023", "123", "0123"};
constexpr std::array<const char *, 16> ganja_generated{"",   "0",  "1",  "2",   "3",   "01",  "02",  "03",
                                                       "12", "31", "23", "021", "013", "032", "123", "0123"};

TEST(ConventionsTest, ganja)
{
    for_many_poses(32, [](const Pose &first, const Pose &then, const Vector &p) {
        const Motor m = motor_of(first), b = motor_of(then);
        const std::array<double, 16> g{m.s,    0,      0,      0, 0, -m.b1i, -m.b2i, -m.b3i,
                                       -m.b12, -m.b13, -m.b23, 0, 0, 0,      0,      m.w};
        const Pga element = pga_of(g, ganja);
        expect_near(pga_moved(element, p), moved(m, p));
        std::array<double, 16> generated = g;
        generated[9] = m.b13;
        expect_near(memory_of(element, ganja_generated), generated);
        const auto product = memory_of(pga_of(klein_of(b), klein) * element, ganja);
        const Motor both = composed(m, b);
        expect_near(product, {both.s,    0,         0,         0, 0, -both.b1i, -both.b2i, -both.b3i,
                              -both.b12, -both.b13, -both.b23, 0, 0, 0,         0,         both.w});
    });
}

// Its examples' rotor(angle, line) = cos + sin line, and translator(d, line) = 1 + ½ d line.
TEST(ConventionsTest, ganja_examples_turn_and_move_the_other_way)
{
    const Vector p{1, 2, 3};
    const Pga one = blade<Projective>("");
    const double angle = 0.75, distance = 2.5;
    const Pga rotor = std::cos(angle / 2) * one + std::sin(angle / 2) * blade<Projective>("12");
    expect_near(pga_moved(rotor, p), rotated(about('Z', -angle), p));
    const Pga translator = one + distance / 2 * blade<Projective>("01");
    expect_near(pga_moved(translator, p), p + Vector{-distance, 0, 0});
}

// ------------------------------------------------------------------------------------------------------- engines

constexpr double degrees = pi / 180;

// UnityEngine.Quaternion * Vector3: a matrix of the quaternion.
Vector unity_rotated(const Quaternion &q, const Vector &p)
{
    const double xx = 2 * q.x * q.x, yy = 2 * q.y * q.y, zz = 2 * q.z * q.z, xy = 2 * q.x * q.y, xz = 2 * q.x * q.z;
    const double yz = 2 * q.y * q.z, wx = 2 * q.w * q.x, wy = 2 * q.w * q.y, wz = 2 * q.w * q.z;
    return {dot({1 - yy - zz, xy - wz, xz + wy}, p), dot({xy + wz, 1 - xx - zz, yz - wx}, p),
            dot({xz - wy, yz + wx, 1 - xx - yy}, p)};
}

// A child's pose in the world is parent * local; Matrix4x4 has element (row, column) at row + 4 column.
TEST(ConventionsTest, unity)
{
    for_many_poses(40, [](const Pose &local, const Pose &parent, const Vector &p) {
        const Motor motor = motor_of(local);
        expect_near(moved(motor, p), unity_rotated(local.rotation, p) + local.translation);
        const Matrix world = matrix_of(parent) * matrix_of(local);
        double memory[16];
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                memory[row + 4 * column] = world[row][column];
        expect_same_motion(motor_of(memory, MW_MATRIX_COLUMNS_4X4), composed(motor, motor_of(parent)));
        expect_near(composed(motor_of({local.rotation, {}}), motor_of({parent.rotation, {}})),
                    motor_of({parent.rotation * local.rotation, {}}));
    });
}

// Quaternion.Euler(x, y, z): z degrees about z, then x about x, then y about y.
TEST(ConventionsTest, unity_euler_angles)
{
    const double x = 20, y = -130, z = 65;
    const Motor about_x = motor_of({about('X', x * degrees), {}}), about_y = motor_of({about('Y', y * degrees), {}});
    const Motor about_z = motor_of({about('Z', z * degrees), {}});
    expect_same_motion(motor_of_euler({y * degrees, x * degrees, z * degrees}, MW_EULER_YXZ),
                       composed(composed(about_z, about_x), about_y));
}

// V + 2 w (Q × V) + 2 Q × (Q × V): FQuat::RotateVector, Godot's Quaternion::xform, Eigen.
Vector rotated_by_crosses(const Quaternion &q, const Vector &v)
{
    const Vector u{q.x, q.y, q.z}, t = 2 * cross(u, v);
    return v + q.w * t + cross(u, t);
}

// FQuat A * B: B first. FTransform and FMatrix A * B: A first. FMatrix acts on rows, M[row][column].
TEST(ConventionsTest, unreal)
{
    for_many_poses(41, [](const Pose &a, const Pose &b, const Vector &p) {
        const Motor motor_a = motor_of(a), motor_b = motor_of(b), both = composed(motor_a, motor_b);
        expect_near(moved(motor_a, p), rotated_by_crosses(a.rotation, p) + a.translation);
        expect_near(pose_of(both).rotation, b.rotation * a.rotation);
        expect_near(pose_of(both).translation, rotated_by_crosses(b.rotation, a.translation) + b.translation);

        const Matrix rows = transposed(matrix_of(a)) * transposed(matrix_of(b));
        expect_same_motion(motor_of(&rows[0][0], MW_MATRIX_COLUMNS_4X4), both);
        expect_near(Vector{rows[3][0], rows[3][1], rows[3][2]}, pose_of(both).translation);
    });
}

// FRotator in degrees: yaw about the up axis z from x forward to y right; then pitch about the new right axis, which
// lifts the nose; then roll about the new forward axis, clockwise seen along it.
Motor motor_of_rotator(double pitch, double yaw, double roll)
{
    return motor_of_euler({yaw * degrees, -pitch * degrees, -roll * degrees}, MW_EULER_ZYX);
}

TEST(ConventionsTest, unreal_rotators)
{
    const Vector forward{1, 0, 0}, right{0, 1, 0}, up{0, 0, 1};
    expect_near(moved(motor_of_rotator(0, 90, 0), forward), right);
    expect_near(moved(motor_of_rotator(90, 0, 0), forward), up);
    expect_near(moved(motor_of_rotator(0, 0, 90), up), right);

    // About axes that turn along, what comes later acts first on a point.
    const double pitch = 25, yaw = -110, roll = 70;
    const Motor pitched = motor_of_rotator(pitch, 0, 0), turned = motor_of_rotator(0, yaw, 0);
    expect_same_motion(motor_of_rotator(pitch, yaw, roll),
                       composed(composed(motor_of_rotator(0, 0, roll), pitched), turned));

    // FRotator::Quaternion in components.
    const double sp = std::sin(pitch * degrees / 2), cp = std::cos(pitch * degrees / 2);
    const double sy = std::sin(yaw * degrees / 2), cy = std::cos(yaw * degrees / 2);
    const double sr = std::sin(roll * degrees / 2), cr = std::cos(roll * degrees / 2);
    const Quaternion quaternion{cr * sp * sy - sr * cp * cy, -cr * sp * cy - sr * cp * sy,
                                cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy};
    expect_same_motion(motor_of_rotator(pitch, yaw, roll), motor_of({quaternion, {}}));
}

// Transform3D: basis.x basis.y basis.z origin are the columns; parent * child. Euler angles are YXZ by default.
TEST(ConventionsTest, godot)
{
    for_many_poses(42, [](const Pose &child, const Pose &parent, const Vector &p) {
        const Motor motor = motor_of(child), both = composed(motor, motor_of(parent));
        expect_near(moved(motor, p), rotated_by_crosses(child.rotation, p) + child.translation);
        const Matrix m = matrix_of(parent) * matrix_of(child);
        double columns[12];
        for (std::size_t k = 0; k < 12; ++k)
            columns[k] = m[k % 3][k / 3];
        expect_same_motion(motor_of(columns, MW_MATRIX_COLUMNS_3X4), both);
    });

    const double x = 0.3, y = -2.1, z = 1.2;  // Basis.from_euler(Vector3(x, y, z))
    const Quaternion basis = about('Y', y) * about('X', x) * about('Z', z);
    expect_same_motion(motor_of_euler({y, x, z}, MW_EULER_YXZ), motor_of({basis, {}}));
}

// A node has T R or a matrix by columns, and its global transform is its parent's times its own.
TEST(ConventionsTest, gltf)
{
    Random random(43);
    const Pose nodes[3] = {draw_pose(random), draw_pose(random), draw_pose(random)};
    const std::int32_t parents[3] = {-1, 0, 1};
    Motor locals[3], globals[3];
    for (std::size_t k = 0; k < 3; ++k)
        locals[k] = motor_of(nodes[k]);
    ASSERT_EQ(mw_compose_motor_hierarchy_f64(globals, 3 * sizeof(Motor),
                                             locals, 3 * sizeof(Motor), sizeof(Motor),
                                             parents, 3, 1, nullptr),
              MW_OK);
    Matrix global = matrix_of(nodes[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        if (k)
            global = global * matrix_of(nodes[k]);
        const Matrix memory = transposed(global);
        expect_same_motion(motor_of(&memory[0][0], MW_MATRIX_COLUMNS_4X4), globals[k]);
    }
}

// mathutils: Quaternion((w, x, y, z)), matrices by rows that act on columns, a @ b does b first.
TEST(ConventionsTest, blender)
{
    for_many_poses(44, [](const Pose &a, const Pose &b, const Vector &) {
        const Matrix product = matrix_of(a) * matrix_of(b);
        expect_same_motion(motor_of(&product[0][0], MW_MATRIX_ROWS_4X4), composed(motor_of(b), motor_of(a)));
    });

    // An Euler of order 'XYZ' is about fixed axes, x first.
    Random random(45);
    for (int order = MW_EULER_XYZ; order <= int(MW_EULER_ZYX); ++order) {
        const char *const axes = euler_orders[order];
        const Vector euler = draw_vector(random);  // x y z, whatever the order
        double angles[3];
        Quaternion rotation{0, 0, 0, 1};
        for (std::size_t k = 0; k < 3; ++k) {
            angles[k] = euler[static_cast<std::size_t>(axes[k] - 'X')];
            rotation = about(axes[k], angles[k]) * rotation;
        }
        const auto reversed = std::find_if(std::begin(euler_orders), std::end(euler_orders), [&](const char *other) {
            return other[0] == axes[2] && other[1] == axes[1] && other[2] == axes[0];
        });
        const auto ours = static_cast<mw_euler_order>(reversed - std::begin(euler_orders));
        expect_same_motion(motor_of_euler({angles[2], angles[1], angles[0]}, ours), motor_of({rotation, {}}));
    }
}

// XMQuaternionMultiply(Q1, Q2), as its documentation writes it out: the product Q2 Q1.
Quaternion directx_multiply(const Quaternion &q1, const Quaternion &q2)
{
    return {q2.w * q1.x + q2.x * q1.w + q2.y * q1.z - q2.z * q1.y,
            q2.w * q1.y - q2.x * q1.z + q2.y * q1.w + q2.z * q1.x,
            q2.w * q1.z + q2.x * q1.y - q2.y * q1.x + q2.z * q1.w,
            q2.w * q1.w - q2.x * q1.x - q2.y * q1.y - q2.z * q1.z};
}

// XMVector3Rotate: the conjugate times the vector times the quaternion, by the function above.
Vector directx_rotated(const Quaternion &q, const Vector &v)
{
    const Quaternion image = directx_multiply(directx_multiply(conjugate(q), {v[0], v[1], v[2], 0}), q);
    return {image.x, image.y, image.z};
}

TEST(ConventionsTest, directxmath)
{
    for_many_poses(46, [](const Pose &first, const Pose &then, const Vector &p) {
        const Motor motor = motor_of(first), both = composed(motor, motor_of(then));
        expect_near(moved(motor, p), directx_rotated(first.rotation, p) + first.translation);
        expect_near(pose_of(both).rotation, directx_multiply(first.rotation, then.rotation));

        // Row vectors and matrices by rows: p' = p M, M = first * then.
        const Matrix rows = transposed(matrix_of(first)) * transposed(matrix_of(then));
        expect_same_motion(motor_of(&rows[0][0], MW_MATRIX_COLUMNS_4X4), both);
        double float4x3[12], float3x4[12];  // XMStoreFloat4x3: rows of three. XMStoreFloat3x4: the transpose
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                float4x3[3 * row + column] = float3x4[4 * column + row] = rows[row][column];
        expect_same_motion(motor_of(float4x3, MW_MATRIX_COLUMNS_3X4), both);
        expect_same_motion(motor_of(float3x4, MW_MATRIX_ROWS_3X4), both);
    });

    // XMQuaternionRotationRollPitchYaw(pitch, yaw, roll): roll about z, then pitch about x, then yaw about y.
    const double pitch = 0.4, yaw = -2, roll = 1.1;
    const Quaternion rotation =
        directx_multiply(directx_multiply(about('Z', roll), about('X', pitch)), about('Y', yaw));
    expect_same_motion(motor_of_euler({yaw, pitch, roll}, MW_EULER_YXZ), motor_of({rotation, {}}));
}

#ifdef MOTORWAY_TEST_EIGEN
Eigen::Isometry3d eigen_pose(const Pose &pose)
{
    const Eigen::Quaterniond rotation(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    return Eigen::Translation3d(pose.translation[0], pose.translation[1], pose.translation[2]) * rotation;
}

TEST(ConventionsTest, eigen)
{
    for_many_poses(47, [](const Pose &first, const Pose &then, const Vector &p) {
        const Motor motor = motor_of(first), both = composed(motor, motor_of(then));
        const Eigen::Isometry3d a = eigen_pose(first), product = eigen_pose(then) * a;
        const Eigen::Vector3d image = a * Eigen::Vector3d(p[0], p[1], p[2]);
        expect_near(moved(motor, p), {image.x(), image.y(), image.z()});
        expect_same_motion(motor_of(product.data(), MW_MATRIX_COLUMNS_4X4), both);

        // The coefficients of a quaternion lie as x y z w, though its constructor takes w first.
        const Eigen::Quaterniond rotation(product.linear());
        const double *const c = rotation.coeffs().data();
        expect_same_motion(motor_of({{c[0], c[1], c[2], c[3]}, pose_of(both).translation}), both);

        const Eigen::Vector3d angles = a.linear().eulerAngles(2, 1, 0);
        expect_same_motion(motor_of_euler({angles[0], angles[1], angles[2]}, MW_EULER_ZYX),
                           motor_of({first.rotation, {}}));
    });
}
#else
TEST(ConventionsTest, eigen) { GTEST_SKIP() << "Eigen was not found when this was built"; }
#endif

// exp and log of the motors of a tangent (υ, ω): ½ of it, component by component.
Motor exp_of_tangent(const std::array<double, 6> &t)
{
    const double bivector[6] = {t[5] / 2, -t[4] / 2, t[3] / 2, t[0] / 2, t[1] / 2, t[2] / 2};
    Motor motor{};
    EXPECT_EQ(mw_exp_motor_each_f64(&motor, sizeof motor,
                                    bivector, sizeof bivector, 1),
              MW_OK);
    return motor;
}

std::array<double, 6> tangent_of(const Motor &motor)
{
    double b[6];
    EXPECT_EQ(mw_log_motor_each_f64(b, sizeof b,
                                    &motor, sizeof motor, 1, MW_UNIT_MOTORS),
              MW_OK);
    return {2 * b[3], 2 * b[4], 2 * b[5], 2 * b[2], -2 * b[1], 2 * b[0]};
}

std::array<double, 6> draw_tangent(Random &random)
{
    const Vector upsilon = draw_vector(random), omega = random.uniform(0.1, 3) * draw_axis(random);
    return {upsilon[0], upsilon[1], upsilon[2], omega[0], omega[1], omega[2]};
}

// SE3::exp(υ, ω) = (exp(ω), V υ), V = 1 + (1 - cos θ) / θ² Ω + (θ - sin θ) / θ³ Ω², Ω v = ω × v.
TEST(ConventionsTest, sophus_tangents)
{
    Random random(48);
    for (int repetition = 0; repetition < 100; ++repetition) {
        const std::array<double, 6> tangent = draw_tangent(random);
        const Vector upsilon{tangent[0], tangent[1], tangent[2]}, omega{tangent[3], tangent[4], tangent[5]};
        const double angle = std::sqrt(dot(omega, omega));
        const Vector once = cross(omega, upsilon), twice = cross(omega, once);
        const Vector translation = upsilon + (1 - std::cos(angle)) / (angle * angle) * once +
                                   (angle - std::sin(angle)) / (angle * angle * angle) * twice;
        const Motor motor = exp_of_tangent(tangent);
        expect_near(motor, motor_of({about_axis(1 / angle * omega, angle), translation}));
        expect_near(tangent_of(motor), tangent);
    }
}

#ifdef MOTORWAY_TEST_SOPHUS
// data() is the quaternion x y z w and then the translation.
Motor motor_of_sophus(const Sophus::SE3d &pose)
{
    const double *const d = pose.data();
    return motor_of(Pose{{d[0], d[1], d[2], d[3]}, {d[4], d[5], d[6]}});
}

TEST(ConventionsTest, sophus)
{
    Random random(49);
    for (int repetition = 0; repetition < 100; ++repetition) {
        const std::array<double, 6> t = draw_tangent(random), u = draw_tangent(random);
        const Sophus::SE3d a = Sophus::SE3d::exp(Eigen::Map<const Sophus::SE3d::Tangent>(t.data()));
        const Sophus::SE3d b = Sophus::SE3d::exp(Eigen::Map<const Sophus::SE3d::Tangent>(u.data()));
        const Vector p = draw_vector(random);
        const Eigen::Vector3d image = a * Eigen::Vector3d(p[0], p[1], p[2]);
        expect_near(moved(motor_of_sophus(a), p), {image.x(), image.y(), image.z()});
        expect_same_motion(motor_of_sophus(b * a), composed(motor_of_sophus(a), motor_of_sophus(b)));
        expect_same_motion(motor_of_sophus(a), exp_of_tangent(t));
    }
}
#else
TEST(ConventionsTest, sophus) { GTEST_SKIP() << "Sophus was not found when this was built"; }
#endif

// ---------------------------------------------------------------------------------------- other axes, and mirrors

// A motor in other coordinates, `coordinates` of those of its own: it must do there what it did here.
void expect_transferred(const std::function<Vector(const Vector &)> &coordinates,
                        const std::function<Motor(const Motor &)> &transfer)
{
    for_many_poses(50, [&](const Pose &first, const Pose &then, const Vector &p) {
        const Motor m = motor_of(first);
        expect_near(moved(transfer(m), coordinates(p)), coordinates(moved(m, p)));
        expect_near(transfer(composed(m, motor_of(then))), composed(transfer(m), transfer(motor_of(then))));
    });
}

// Every component that has the mirrored axis in its name changes its sign, and so does w.
TEST(ConventionsTest, mirrored_x_from_unity_to_gltf)
{
    expect_transferred([](const Vector &p) { return Vector{-p[0], p[1], p[2]}; },
                       [](const Motor &m) {
                           return Motor{m.s, -m.b12, -m.b13, m.b23, -m.b1i, m.b2i, m.b3i, -m.w};
                       });
}

TEST(ConventionsTest, mirrored_y_from_unreal_to_right_handed)
{
    expect_transferred([](const Vector &p) { return Vector{p[0], -p[1], p[2]}; },
                       [](const Motor &m) {
                           return Motor{m.s, -m.b12, m.b13, -m.b23, m.b1i, -m.b2i, m.b3i, -m.w};
                       });
}

TEST(ConventionsTest, mirrored_z)
{
    expect_transferred([](const Vector &p) { return Vector{p[0], p[1], -p[2]}; },
                       [](const Motor &m) {
                           return Motor{m.s, m.b12, -m.b13, -m.b23, m.b1i, m.b2i, -m.b3i, -m.w};
                       });
}

// The engine's own exporter: y and z exchanged, centimetres to metres; of a quaternion (-x, -z, -y, w).
TEST(ConventionsTest, from_unreal_to_gltf)
{
    const auto transfer = [](const Motor &m) {
        return Motor{m.s, m.b13, m.b12, -m.b23, 0.01 * m.b1i, 0.01 * m.b3i, 0.01 * m.b2i, -0.01 * m.w};
    };
    expect_transferred([](const Vector &p) { return 0.01 * Vector{p[0], p[2], p[1]}; }, transfer);
    const Quaternion q = about_axis({0.48, 0.6, 0.64}, 1.5);
    expect_near(pose_of(transfer(motor_of({q, {}}))).rotation, {-q.x, -q.z, -q.y, q.w});
}

// The exporter of Blender: (x, z, -y); of a quaternion, w first, (w, x, z, -y).
TEST(ConventionsTest, from_blender_to_gltf)
{
    const auto transfer = [](const Motor &m) {
        return Motor{m.s, m.b13, -m.b12, m.b23, m.b1i, m.b3i, -m.b2i, m.w};
    };
    expect_transferred([](const Vector &p) { return Vector{p[0], p[2], -p[1]}; }, transfer);
    const Quaternion q = about_axis({0.48, 0.6, 0.64}, 1.5);
    expect_near(pose_of(transfer(motor_of({q, {}}))).rotation, {q.x, q.z, -q.y, q.w});
}

// --------------------------------------------------------------------------------------------- the lecture notes

Motor slerp(const Motor &first, const Motor &second, double parameter, unsigned flags)
{
    Motor motor{};
    EXPECT_EQ(mw_slerp_motor_each_f64(&motor, sizeof motor,
                                      &first, sizeof first,
                                      &second, sizeof second, &parameter, 0, 1, flags),
              MW_OK);
    return motor;
}

// The notes' method 2: sin(Ω(1-t)) / sin Ω q1 + sin(Ωt) / sin Ω q2 with cos Ω = q1 · q2.
Quaternion slerp_of_the_notes(const Quaternion &q1, const Quaternion &q2, double t)
{
    const double angle = std::acos(q1.x * q2.x + q1.y * q2.y + q1.z * q2.z + q1.w * q2.w);
    return std::sin(angle * (1 - t)) / std::sin(angle) * q1 + std::sin(angle * t) / std::sin(angle) * q2;
}

TEST(LectureNotesTest, the_worked_slerp)
{
    const Quaternion q1{0, 0, 0, 1}, q2{0, 0, std::sqrt(2.0) / 2, std::sqrt(2.0) / 2};
    const Quaternion q = pose_of(slerp(motor_of({q1, {}}), motor_of({q2, {}}), 0.5, MW_DEFAULT)).rotation;
    EXPECT_EQ(q.x, 0);
    EXPECT_EQ(q.y, 0);
    EXPECT_NEAR(q.z, 0.3827, 0.00005);
    EXPECT_NEAR(q.w, 0.9239, 0.00005);
    expect_near(q, slerp_of_the_notes(q1, q2, 0.5));
    EXPECT_NEAR(std::acos(q.w), 22.5 * degrees, tolerance);
}

// "If q1 · q2 < 0 then the angle is big: take one of them and negate it." Unless the long way is asked for.
TEST(LectureNotesTest, the_shortest_path_by_flipping_the_sign)
{
    for_many_poses(60, [](const Pose &first, const Pose &second, const Vector &p) {
        const double t = (p[0] + 3) / 6;
        const Quaternion q1 = first.rotation;
        Quaternion q2 = second.rotation;
        if (q1.x * q2.x + q1.y * q2.y + q1.z * q2.z + q1.w * q2.w > 0)
            q2 = -1 * q2;
        const Motor m1 = motor_of({q1, {}}), m2 = motor_of({q2, {}});
        expect_same_motion(slerp(m1, m2, t, MW_DEFAULT), motor_of({slerp_of_the_notes(q1, -1 * q2, t), {}}));
        expect_same_motion(slerp(m1, m2, t, MW_LONG_WAY), motor_of({slerp_of_the_notes(q1, q2, t), {}}));
    });
}

// Frame 1 is displaced by d = (5, 2, 0) and not rotated: its origin has the coordinates d in frame 0.
TEST(LectureNotesTest, a_frame_of_reference)
{
    const double matrix[16] = {1, 0, 0, 5,  //
                               0, 1, 0, 2,  //
                               0, 0, 1, 0,  //
                               0, 0, 0, 1};
    const Motor from_1_to_0 = motor_of(matrix, MW_MATRIX_ROWS_4X4);
    expect_near(from_1_to_0, {1, 0, 0, 0, 2.5, 1, 0, 0});
    expect_near(moved(from_1_to_0, {0, 0, 0}), {5, 2, 0});
}

// [I d; 0 1] moves points (p, 1) and leaves directions (v, 0); [R 0; 0 1] turns both; the product does the right
// factor first.
TEST(LectureNotesTest, homogeneous_matrices)
{
    const double c = std::cos(0.7), s = std::sin(0.7);
    const Matrix displacement{{{1, 0, 0, 3}, {0, 1, 0, -4}, {0, 0, 1, 5}, {0, 0, 0, 1}}};
    const Matrix rotation{{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const Motor displaced = motor_of(&displacement[0][0], MW_MATRIX_ROWS_4X4);
    const Motor turned = motor_of(&rotation[0][0], MW_MATRIX_ROWS_4X4);
    expect_near(turned, {std::cos(0.35), std::sin(0.35), 0, 0, 0, 0, 0, 0});

    const Vector p{1, 2, 3};
    expect_near(moved(displaced, p), {4, -2, 8});
    expect_near(moved(turned, p), {c - 2 * s, s + 2 * c, 3});
    const Motor direction_by[] = {displaced, turned};
    const Vector expected[] = {p, {c - 2 * s, s + 2 * c, 3}};
    for (std::size_t k = 0; k < 2; ++k) {
        Vector direction;
        ASSERT_EQ(mw_apply_direction_one_f64(direction.data(), sizeof direction, &direction_by[k],
                                             p.data(), sizeof p, 1, MW_DEFAULT),
                  MW_OK);
        expect_near(direction, expected[k]);
    }

    const Matrix both = displacement * rotation;
    expect_near(motor_of(&both[0][0], MW_MATRIX_ROWS_4X4), composed(turned, displaced));
}

}  // namespace
}  // namespace motorway::testing::conventions
