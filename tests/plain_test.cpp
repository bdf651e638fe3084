// The plain functions, by pointers and strides, are those of views: the same bits, nothing written between, the same errors.
#include <gtest/gtest.h>

#include <vector>

#include "api.h"
#include "precisions.h"
#include "random.h"

namespace motorway::testing {
namespace {

constexpr std::size_t count = 37;

// Elements of N numbers in slots of N + 2, whose gaps are to stay as they are.
template <class T, std::size_t N>
struct Slots {
    std::vector<T> numbers;

    explicit Slots(Random &random) : numbers(count * (N + 2))
    {
        for (T &number : numbers)
            number = static_cast<T>(random.uniform(-2, 2));
    }
    T *first() { return numbers.data(); }
    const T *first() const { return numbers.data(); }
    static constexpr std::size_t stride() { return (N + 2) * sizeof(T); }
};

template <class T, std::size_t N>
void expect_same(const Slots<T, N> &plain, const Slots<T, N> &viewed, const char *what)
{
    EXPECT_EQ(plain.numbers, viewed.numbers) << what;
}

template <class T>
typename api<T>::motor *motors_in(Slots<T, 8> &slots)
{
    return reinterpret_cast<typename api<T>::motor *>(slots.first());
}

template <class T>
class PlainTest : public ::testing::Test {
public:
    Random random{1};
    Slots<T, 8> motors{random}, others{random};
    const std::vector<std::uint16_t> indices = [] {
        std::vector<std::uint16_t> all;
        for (std::size_t i = 0; i < count; ++i)
            all.push_back(static_cast<std::uint16_t>(i * 5 % 7));
        return all;
    }();
    const std::vector<typename api<T>::motor> palette = [this] {
        std::vector<typename api<T>::motor> all(7);
        for (auto &motor : all)
            motor = {T(random.uniform(0.5, 1)), T(0.1), T(0.2), T(-0.3), T(1), T(2), T(3), T(0.1)};
        return all;
    }();

    typename api<T>::const_motors motors_view()
    {
        return api<T>::const_motors_aos(motors_in(motors), motors.stride());
    }
};

TYPED_TEST_SUITE(PlainTest, Precisions, PrecisionName);

// Every operand of one view, in every pairing.
#define MOTORWAY_PLAIN_OPERAND(operand, views, P, N)                                                                 \
    template <class Test>                                                                                            \
    void test_##operand##_##P(Test &test)                                                                            \
    {                                                                                                                \
        using T = scalar_##P;                                                                                        \
        using A = api<T>;                                                                                            \
        Slots<T, N> in(test.random), plain(test.random), viewed = plain;                                             \
        auto *const motors = reinterpret_cast<mw_motor_##P *>(test.motors.first());                                  \
        const std::size_t stride = in.stride(), motor_stride = test.motors.stride();                                 \
        const auto from = mw_const_##views##_##P##_aos(as_##views(in.first()), stride);                              \
        const auto to = mw_##views##_##P##_aos(as_##views(viewed.first()), stride);                                  \
        const auto indices = mw_indices_u16(test.indices.data(), 2);                                                 \
        auto *const p = as_##views(plain.first());                                                                   \
        const auto *const q = as_##views(in.first());                                                                \
        ASSERT_EQ(mw_apply_##operand##_one_##P(p, stride, &test.palette[1], q, stride, count, 0), MW_OK);            \
        ASSERT_EQ(A::apply_##operand##_one(to, &test.palette[1], from, count, 0), MW_OK);                            \
        expect_same(plain, viewed, #operand " one");                                                                 \
        ASSERT_EQ(mw_apply_##operand##_each_##P(p, stride, motors, motor_stride, q, stride, count, 0), MW_OK);       \
        ASSERT_EQ(A::apply_##operand##_each(to, test.motors_view(), from, count, 0), MW_OK);                         \
        expect_same(plain, viewed, #operand " each");                                                                \
        ASSERT_EQ(mw_apply_##operand##_indexed_##P(p, stride, test.palette.data(), 7, test.indices.data(), 2,        \
                                                   MW_INDEX_U16, q, stride, count, 0),                               \
                  MW_OK);                                                                                            \
        ASSERT_EQ(A::apply_##operand##_indexed(to, test.palette.data(), 7, indices, from, count, 0), MW_OK);         \
        expect_same(plain, viewed, #operand " indexed");                                                             \
        std::size_t bad = 99;                                                                                        \
        EXPECT_EQ(mw_apply_##operand##_indexed_checked_##P(p, stride, test.palette.data(), 6, test.indices.data(),   \
                                                           2, MW_INDEX_U16, q, stride, count, 0, &bad),              \
                  MW_ERROR_INDEX);                                                                                   \
        EXPECT_EQ(bad, 4u);                                                                                          \
        ASSERT_EQ(mw_apply_##operand##_grid_##P(p, stride, count * stride, test.palette.data(), sizeof(T[8]), 1, q,  \
                                                stride, count, 0),                                                   \
                  MW_OK);                                                                                            \
        ASSERT_EQ(A::apply_##operand##_one(to, &test.palette[0], from, count, 0), MW_OK);                            \
        expect_same(plain, viewed, #operand " grid");                                                                \
        EXPECT_EQ(mw_apply_##operand##_one_##P(nullptr, stride, &test.palette[0], q, stride, count, 0),              \
                  MW_ERROR_NULL);                                                                                    \
        EXPECT_EQ(mw_apply_##operand##_one_views_##P(nullptr, &test.palette[0], &from, count, 0), MW_ERROR_NULL);    \
        EXPECT_EQ(mw_apply_##operand##_one_views_##P(&to, &test.palette[0], nullptr, count, 0), MW_ERROR_NULL);      \
        EXPECT_EQ(mw_apply_##operand##_one_views_##P(nullptr, nullptr, nullptr, 0, 0), MW_OK);                       \
        EXPECT_EQ(mw_apply_##operand##_one_##P(p, sizeof(T), &test.palette[0], q, stride, count, 0),                 \
                  MW_ERROR_STRIDE);                                                                                  \
        expect_same(plain, viewed, #operand " after errors");                                                        \
    }

template <class T> T *as_xyz(T *p) { return p; }
template <class T> T *as_xyzw(T *p) { return p; }
template <class T> T *as_vectors(T *p) { return p; }
template <class T> T *as_lines(T *p) { return p; }
template <class T> T *as_bivectors(T *p) { return p; }
mw_motor_f32 *as_motors(float *p) { return reinterpret_cast<mw_motor_f32 *>(p); }
mw_motor_f64 *as_motors(double *p) { return reinterpret_cast<mw_motor_f64 *>(p); }

#define MOTORWAY_PLAIN_OPERANDS(P)                                                                                   \
    MOTORWAY_PLAIN_OPERAND(point, xyz, P, 3)                                                                         \
    MOTORWAY_PLAIN_OPERAND(direction, xyz, P, 3)                                                                     \
    MOTORWAY_PLAIN_OPERAND(tangent, xyzw, P, 4)                                                                      \
    MOTORWAY_PLAIN_OPERAND(vector, vectors, P, 5)                                                                    \
    MOTORWAY_PLAIN_OPERAND(line, lines, P, 6)                                                                        \
    MOTORWAY_PLAIN_OPERAND(motor, motors, P, 8)                                                                      \
    MOTORWAY_PLAIN_OPERAND(bivector, bivectors, P, 6)                                                                \
    template <class Test>                                                                                            \
    void test_operands(Test &test, scalar_##P)                                                                       \
    {                                                                                                                \
        test_point_##P(test), test_direction_##P(test), test_tangent_##P(test), test_vector_##P(test);               \
        test_line_##P(test), test_motor_##P(test), test_bivector_##P(test);                                          \
    }
MOTORWAY_PLAIN_OPERANDS(f32)
MOTORWAY_PLAIN_OPERANDS(f64)

TYPED_TEST(PlainTest, operands_of_one_view)
{
    test_operands(*this, TypeParam());
}

// Vertices have two pointers and one stride: a position and a normal of one buffer, with a number between.
TEST(PlainVertices, are_two_views_of_one_buffer)
{
    Random random(2);
    Slots<float, 7> plain(random), viewed = plain;
    const mw_motor_f32 motor = {2, 1, 0, -1, 3, 4, 5, 0};
    const std::size_t stride = plain.stride();
    float *const p = plain.first(), *const v = viewed.first();
    const mw_vertices_f32 view = {mw_xyz_f32_aos(v, stride), mw_xyz_f32_aos(v + 4, stride)};
    const mw_const_vertices_f32 from = {mw_const_xyz_f32_aos(v, stride), mw_const_xyz_f32_aos(v + 4, stride)};
    ASSERT_EQ(mw_apply_vertex_one_f32(p, p + 4, stride, &motor, p, p + 4, stride, count, MW_DEFAULT), MW_OK);
    ASSERT_EQ(mw_apply_vertex_one_views_f32(&view, &motor, &from, count, MW_DEFAULT), MW_OK);
    expect_same(plain, viewed, "vertices");
    EXPECT_EQ(mw_apply_vertex_one_f32(p, p + 2, stride, &motor, p, p + 4, stride, count, MW_DEFAULT), MW_ERROR_OVERLAP);
    EXPECT_EQ(mw_apply_vertex_one_views_f32(&view, &motor, nullptr, count, MW_DEFAULT), MW_ERROR_NULL);
    expect_same(plain, viewed, "vertices after errors");
}

TYPED_TEST(PlainTest, compositions_and_representations)
{
    using T = TypeParam;
    using A = api<T>;
    Slots<T, 8> plain(this->random), viewed = plain;
    Slots<T, 4> quaternions(this->random), same_quaternions = quaternions;
    Slots<T, 3> translations(this->random), same_translations = translations;
    Slots<T, 12> matrices(this->random), same_matrices = matrices;
    const auto out = A::motors_aos(motors_in(viewed), viewed.stride());
    const auto first = this->motors_view(), then = A::const_motors_aos(motors_in(this->others), this->others.stride());
    const auto compose = [&](auto function) {
        return function(motors_in(plain), plain.stride(), motors_in(this->motors), this->motors.stride(),
                        motors_in(this->others), this->others.stride(), count);
    };
    const auto to_pose = [&](auto function) {
        return function(quaternions.first(), quaternions.stride(), translations.first(), translations.stride(),
                        motors_in(this->motors), this->motors.stride(), count);
    };
    const auto to_matrix = [&](auto function, mw_matrix_layout layout) {
        return function(matrices.first(), matrices.stride(), layout, motors_in(this->motors), this->motors.stride(),
                        count);
    };
    constexpr bool single = std::is_same_v<T, float>;
    if constexpr (single) {
        ASSERT_EQ(compose(mw_compose_motor_each_f32), MW_OK);
        ASSERT_EQ(to_pose(mw_convert_motor_to_pose_each_f32), MW_OK);
        ASSERT_EQ(to_matrix(mw_convert_motor_to_matrix_each_f32, MW_MATRIX_COLUMNS_3X4), MW_OK);
        EXPECT_EQ(to_matrix(mw_convert_motor_to_matrix_each_f32, mw_matrix_layout(0)), MW_ERROR_MATRIX_LAYOUT);
    } else {
        ASSERT_EQ(compose(mw_compose_motor_each_f64), MW_OK);
        ASSERT_EQ(to_pose(mw_convert_motor_to_pose_each_f64), MW_OK);
        ASSERT_EQ(to_matrix(mw_convert_motor_to_matrix_each_f64, MW_MATRIX_COLUMNS_3X4), MW_OK);
        EXPECT_EQ(to_matrix(mw_convert_motor_to_matrix_each_f64, mw_matrix_layout(0)), MW_ERROR_MATRIX_LAYOUT);
    }
    ASSERT_EQ(A::compose_motor_each(out, first, then, count), MW_OK);
    expect_same(plain, viewed, "compose");
    ASSERT_EQ(A::convert_motor_to_pose_each(A::xyzw_aos(same_quaternions.first(), quaternions.stride()),
                                            A::xyz_aos(same_translations.first(), translations.stride()), first, count),
              MW_OK);
    expect_same(quaternions, same_quaternions, "quaternions");
    expect_same(translations, same_translations, "translations");
    ASSERT_EQ(A::convert_motor_to_matrix_each({same_matrices.first(), matrices.stride(), MW_MATRIX_COLUMNS_3X4}, first,
                                              count),
              MW_OK);
    expect_same(matrices, same_matrices, "matrices");
}

// A view that is null is null wherever it stands, and whatever else a call has.
TEST(NullViews, are_errors_unless_there_is_nothing_to_do)
{
    mw_motor_f32 motor = {1, 0, 0, 0, 0, 0, 0, 0};
    float numbers[16] = {};
    const mw_motors_f32 out = mw_motors_f32_aos(&motor, sizeof motor);
    const mw_matrices_f32 matrices = {numbers, sizeof numbers, MW_MATRIX_ROWS_4X4};
    const mw_const_motors_f32 in = mw_const_motors_f32_aos(&motor, sizeof motor);
    EXPECT_EQ(mw_convert_motor_to_matrix_each_views_f32(nullptr, &in, 1), MW_ERROR_NULL);
    EXPECT_EQ(mw_convert_motor_to_matrix_each_views_f32(&matrices, nullptr, 1), MW_ERROR_NULL);
    EXPECT_EQ(mw_convert_matrix_to_motor_each_views_f32(&out, nullptr, 1, MW_DEFAULT, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(mw_check_matrices_views_f32(nullptr, 1, 1e-3f, nullptr, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(mw_check_motors_views_f32(nullptr, 1, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(mw_check_indices_views(nullptr, 1, 1, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(mw_blend_motor_one_views_f32(&out, &motor, nullptr, 1, 1), MW_ERROR_NULL);
    EXPECT_EQ(mw_compose_motor_hierarchy_views_f32(&out, nullptr, sizeof motor, nullptr, 1, 1, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(mw_compose_motor_each_views_f32(nullptr, nullptr, nullptr, 0), MW_OK);
    EXPECT_EQ(motor.s, 1);
}

}  // namespace
}  // namespace motorway::testing
