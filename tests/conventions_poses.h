// Poses in plain arithmetic, as textbooks have them: vectors, Hamilton's quaternions, 4 x 4 matrices that act on
// columns. And the library's functions for one pose at a time, which are batches of one.
#ifndef MOTORWAY_TESTS_CONVENTIONS_POSES_H
#define MOTORWAY_TESTS_CONVENTIONS_POSES_H

#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "motorway_views.h"
#include "random.h"

namespace motorway::testing::conventions {

constexpr double pi = 3.14159265358979323846;
constexpr double tolerance = 1e-12;  // coordinates here are up to about 20

using Vector = std::array<double, 3>;
using Matrix = std::array<std::array<double, 4>, 4>;  // [row][column]
using Motor = mw_motor_f64;

struct Quaternion {
    double x, y, z, w;
};

// p' = rotation p + translation.
struct Pose {
    Quaternion rotation;
    Vector translation;
};

inline Vector operator+(const Vector &a, const Vector &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double s, const Vector &a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector &a, const Vector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// i j = k, j k = i, k i = j.
inline Quaternion operator*(const Quaternion &a, const Quaternion &b)
{
    const Vector u{a.x, a.y, a.z}, v{b.x, b.y, b.z};
    const Vector sum = a.w * v + b.w * u + cross(u, v);
    return {sum[0], sum[1], sum[2], a.w * b.w - dot(u, v)};
}

inline Quaternion operator*(double s, const Quaternion &q) { return {s * q.x, s * q.y, s * q.z, s * q.w}; }
inline Quaternion operator+(const Quaternion &a, const Quaternion &b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
inline Quaternion conjugate(const Quaternion &q) { return {-q.x, -q.y, -q.z, q.w}; }
inline Quaternion about_axis(const Vector &unit_axis, double angle)
{
    const Vector v = std::sin(angle / 2) * unit_axis;
    return {v[0], v[1], v[2], std::cos(angle / 2)};
}

// q v q*.
inline Vector rotated(const Quaternion &q, const Vector &v)
{
    const Quaternion image = q * Quaternion{v[0], v[1], v[2], 0} * conjugate(q);
    return {image.x, image.y, image.z};
}

inline Vector moved(const Pose &pose, const Vector &p) { return rotated(pose.rotation, p) + pose.translation; }

inline Matrix matrix_of(const Pose &pose)
{
    Matrix matrix{};
    for (std::size_t column = 0; column < 3; ++column) {
        Vector axis{};
        axis[column] = 1;
        const Vector image = rotated(pose.rotation, axis);
        for (std::size_t row = 0; row < 3; ++row)
            matrix[row][column] = image[row];
    }
    for (std::size_t row = 0; row < 3; ++row)
        matrix[row][3] = pose.translation[row];
    matrix[3][3] = 1;
    return matrix;
}

inline Matrix operator*(const Matrix &a, const Matrix &b)
{
    Matrix product{};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t k = 0; k < 4; ++k)
                product[row][column] += a[row][k] * b[k][column];
    return product;
}

inline Matrix transposed(const Matrix &a)
{
    Matrix result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            result[row][column] = a[column][row];
    return result;
}

// ------------------------------------------------------------------------------------------------- random poses

inline Vector draw_vector(Random &random)
{
    return {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
}

inline Vector draw_axis(Random &random)
{
    for (;;) {
        const Vector v = draw_vector(random);
        if (const double square = dot(v, v); square > 0.1)
            return 1 / std::sqrt(square) * v;
    }
}

inline Pose draw_pose(Random &random)
{
    return {about_axis(draw_axis(random), random.uniform(-pi, pi)), draw_vector(random)};
}

// ------------------------------------------------------------------------------- the library, for a batch of one

inline Motor motor_of(const Pose &pose)
{
    Motor motor{};
    EXPECT_EQ(mw_convert_pose_to_motor_each_f64(&motor, sizeof motor, &pose.rotation.x, sizeof pose.rotation,
                                                pose.translation.data(), sizeof pose.translation, 1),
              MW_OK);
    return motor;
}

inline Pose pose_of(const Motor &motor)
{
    Pose pose{};
    EXPECT_EQ(mw_convert_motor_to_pose_each_f64(&pose.rotation.x, sizeof pose.rotation, pose.translation.data(),
                                                sizeof pose.translation, &motor, sizeof motor, 1),
              MW_OK);
    return pose;
}

// Of a matrix as it lies in memory.
inline Motor motor_of(const double *matrix, mw_matrix_layout layout)
{
    Motor motor{};
    EXPECT_EQ(mw_convert_matrix_to_motor_each_f64(&motor, sizeof motor,
                                                  matrix, 16 * sizeof(double), layout, 1, MW_DEFAULT, nullptr),
              MW_OK);
    return motor;
}

inline std::array<double, 16> matrix_of(const Motor &motor, mw_matrix_layout layout)
{
    std::array<double, 16> matrix{};
    EXPECT_EQ(mw_convert_motor_to_matrix_each_f64(matrix.data(), sizeof matrix, layout,
                                                  &motor, sizeof motor, 1),
              MW_OK);
    return matrix;
}

inline Motor motor_of_euler(const Vector &angles, mw_euler_order order)
{
    const Vector none{};
    Motor motor{};
    EXPECT_EQ(mw_convert_euler_to_motor_each_f64(&motor, sizeof motor,
                                                 angles.data(), sizeof angles, none.data(), sizeof none, 1, order),
              MW_OK);
    return motor;
}

inline Motor composed(const Motor &first, const Motor &then)
{
    Motor product{};
    EXPECT_EQ(mw_compose_motor_each_f64(&product, sizeof product, &first, sizeof first, &then, sizeof then, 1), MW_OK);
    return product;
}

inline Vector moved(const Motor &motor, const Vector &p)
{
    Vector image{};
    EXPECT_EQ(mw_apply_point_one_f64(image.data(), sizeof image, &motor, p.data(), sizeof p, 1, MW_DEFAULT),
              MW_OK);
    return image;
}

inline std::array<double, 8> components(const Motor &m)
{
    return {m.s, m.b12, m.b13, m.b23, m.b1i, m.b2i, m.b3i, m.w};
}

// ------------------------------------------------------------------------------------------------- expectations

template <std::size_t N>
void expect_near(const std::array<double, N> &a, const std::array<double, N> &b)
{
    for (std::size_t k = 0; k < N; ++k)
        EXPECT_NEAR(a[k], b[k], tolerance) << "number " << k;
}

inline void expect_near(const Motor &a, const Motor &b) { expect_near(components(a), components(b)); }
inline void expect_near(const Quaternion &a, const Quaternion &b)
{
    expect_near(std::array<double, 4>{a.x, a.y, a.z, a.w}, {b.x, b.y, b.z, b.w});
}

// Of the two motors of one motion, S and -S, either.
inline void expect_same_motion(const Motor &a, const Motor &b)
{
    std::array<double, 8> x = components(a);
    const std::array<double, 8> y = components(b);
    if (x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3] < 0)
        for (double &component : x)
            component = -component;
    expect_near(x, y);
}

}  // namespace motorway::testing::conventions

#endif
