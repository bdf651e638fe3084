// Which matrices become motors: rotations and translations, to a tolerance. What scales, shears, reflects, projects or
// is not finite is an error, and the first such is named before anything is written.

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "convert_api.h"
#include "precisions.h"
#include "random.h"

namespace motorway::testing {
namespace {

// By rows, as in books; whatever the layout.
using Matrix = std::array<std::array<double, 4>, 4>;

constexpr Matrix identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

Matrix operator*(const Matrix &a, const Matrix &b)
{
    Matrix product{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k)
                product[r][c] += a[r][k] * b[k][c];
    return product;
}

Matrix scaled(double x, double y, double z)
{
    Matrix matrix = identity;
    matrix[0][0] = x, matrix[1][1] = y, matrix[2][2] = z;
    return matrix;
}

Matrix with(std::size_t row, std::size_t column, double number)
{
    Matrix matrix = identity;
    matrix[row][column] = number;
    return matrix;
}

Matrix about_z(double angle)
{
    Matrix matrix = scaled(std::cos(angle), std::cos(angle), 1);
    matrix[1][0] = std::sin(angle), matrix[0][1] = -std::sin(angle);
    return matrix;
}

Matrix random_pose(Random &random)
{
    double q[4], square = 0;
    for (double &number : q)
        number = random.uniform(-1, 1), square += number * number;
    for (double &number : q)
        number /= std::sqrt(square);
    const auto [w, x, y, z] = q;
    const auto somewhere = [&] { return random.uniform(-100, 100); };
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), somewhere()},
             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), somewhere()},
             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), somewhere()},
             {0, 0, 0, 1}}};
}

// Matrices one after the other in memory.
template <class T>
std::vector<T> numbers(const std::vector<Matrix> &matrices, mw_matrix_layout layout)
{
    const std::size_t size = numbers_of(layout);
    std::vector<T> all(size * matrices.size());
    for (std::size_t i = 0; i < matrices.size(); ++i)
        for (std::size_t r = 0; r < size / 4; ++r)
            for (std::size_t c = 0; c < 4; ++c)
                all[size * i + place_in_matrix(layout, r, c)] = static_cast<T>(matrices[i][r][c]);
    return all;
}

template <class T>
struct Converted {
    mw_status status;
    std::size_t first_bad = 77;
    std::vector<T> motors;

    bool is_untouched() const { return motors == std::vector<T>(motors.size(), T(7)); }
};

template <class T>
Converted<T> convert(const std::vector<Matrix> &matrices, mw_matrix_layout layout, unsigned flags = MW_DEFAULT)
{
    Converted<T> result{MW_OK, 77, std::vector<T>(8 * matrices.size(), T(7))};
    const std::vector<T> in = numbers<T>(matrices, layout);
    auto *const motors = reinterpret_cast<typename api<T>::motor *>(result.motors.data());
    result.status = api<T>::convert_matrix_to_motor_each(api<T>::motors_aos(motors, sizeof *motors),
                                                   {in.data(), numbers_of(layout) * sizeof(T), layout},
                                                   matrices.size(), flags, &result.first_bad);
    return result;
}

template <class T>
constexpr double tolerance = sizeof(T) == sizeof(float) ? MW_MATRIX_TOLERANCE_F32 : MW_MATRIX_TOLERANCE_F64;

// The largest element of |RᵀR - 1|, of the numbers as T holds them.
template <class T>
double deviation(const Matrix &matrix)
{
    double largest = 0;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) {
            double product = a == b ? -1 : 0;
            for (std::size_t r = 0; r < 3; ++r)
                product += static_cast<double>(static_cast<T>(matrix[r][a])) *
                           static_cast<double>(static_cast<T>(matrix[r][b]));
            largest = std::fmax(largest, std::fabs(product));
        }
    return largest;
}

template <class T>
class MatricesTest : public ::testing::Test {
protected:
    // Every layout that has the row in which the matrix is not a pose.
    static std::vector<mw_matrix_layout> layouts(bool with_last_row)
    {
        if (with_last_row)
            return {MW_MATRIX_ROWS_4X4, MW_MATRIX_COLUMNS_4X4};
        return {std::begin(all_matrix_layouts), std::end(all_matrix_layouts)};
    }

    // In every place of batches of several sizes, before others that are bad as well.
    static void expect_error(const Matrix &bad, bool in_last_row, unsigned flags, const std::string &what)
    {
        Random random(31);
        for (mw_matrix_layout layout : layouts(in_last_row))
            for (std::size_t count : {1, 2, 7, 8, 9, 16, 21})
                for (std::size_t place = 0; place < count; ++place) {
                    std::vector<Matrix> matrices;
                    for (std::size_t i = 0; i < count; ++i)
                        matrices.push_back(i == place || (i > place && random.chance(3)) ? bad : random_pose(random));
                    const Converted<T> got = convert<T>(matrices, layout, flags);
                    ASSERT_EQ(got.status, MW_ERROR_MATRIX) << what << ", " << name_of(layout) << ", flags " << flags;
                    EXPECT_EQ(got.first_bad, place) << what << ", " << count << " of " << name_of(layout);
                    EXPECT_TRUE(got.is_untouched()) << what;
                }
    }

    static void expect_motors(const std::vector<Matrix> &matrices, const std::string &what)
    {
        for (mw_matrix_layout layout : all_matrix_layouts) {
            const Converted<T> got = convert<T>(matrices, layout);
            EXPECT_EQ(got.status, MW_OK) << what << ", " << name_of(layout) << ", number " << got.first_bad;
            EXPECT_EQ(got.first_bad, 77u) << what << ": written though none is bad";
            // Whoever promises the same gets the same.
            EXPECT_EQ(got.motors, convert<T>(matrices, layout, MW_ROTATION_MATRICES).motors) << what;
        }
    }
};

TYPED_TEST_SUITE(MatricesTest, Precisions, PrecisionName);

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double quarter_turn = 1.57079632679489661923;

// ------------------------------------------------------------------------------------------------------------ errors

TYPED_TEST(MatricesTest, with_scale_are_errors)
{
    for (double scale : {2.0, 0.001, 0.5, 1.001, 0.999, 1.0001, 0.9999, 1e-30, 1e15, -1.0, -2.0, 0.0}) {
        const std::string what = "scale " + std::to_string(scale);
        this->expect_error(about_z(quarter_turn) * scaled(scale, scale, scale), false, MW_DEFAULT, what);
        this->expect_error(scaled(scale, 1, 1), false, MW_DEFAULT, what + " of x");
        this->expect_error(about_z(1) * scaled(1, scale, 1), false, MW_DEFAULT, what + " of y");
        this->expect_error(about_z(1) * scaled(1, 1, scale), false, MW_DEFAULT, what + " of z");
    }
    this->expect_error(scaled(2, 0.5, 1), false, MW_DEFAULT, "of the same volume");
    if (sizeof(TypeParam) == sizeof(double))
        this->expect_error(scaled(1.000001, 1.000001, 1.000001), false, MW_DEFAULT, "a millionth");
}

TYPED_TEST(MatricesTest, that_shear_or_reflect_are_errors)
{
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            for (double shear : {1e-3, -1e-3, 0.5, -3.0})
                if (r != c)
                    this->expect_error(about_z(1) * with(r, c, shear), false, MW_DEFAULT, "shear");
    for (const Matrix &mirror : {scaled(-1, 1, 1), scaled(1, -1, 1), scaled(1, 1, -1), scaled(-1, -1, -1)})
        this->expect_error(about_z(2) * mirror, false, MW_DEFAULT, "reflection");
    Matrix exchanged{};
    exchanged[0][1] = exchanged[1][0] = exchanged[2][2] = exchanged[3][3] = 1;
    this->expect_error(exchanged, false, MW_DEFAULT, "two axes exchanged");
}

// With either flag that looks: a projection has no nearest rotation.
TYPED_TEST(MatricesTest, that_project_are_errors)
{
    for (unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_NEAREST_ROTATION)}) {
        for (std::size_t c = 0; c < 3; ++c)
            for (double number : {1.0, -1.0, 0.1, 1e-5, -1e-5})
                this->expect_error(with(3, c, number), true, flags, "projection");
        for (double w : {0.0, -1.0, 2.0, 0.5, 1.001, 0.999})
            this->expect_error(with(3, 3, w), true, flags, "w " + std::to_string(w));
    }
}

TYPED_TEST(MatricesTest, that_are_not_finite_are_errors)
{
    for (unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_NEAREST_ROTATION)})
        for (double number : {nan, infinity, -infinity})
            for (std::size_t r = 0; r < 4; ++r)
                for (std::size_t c = 0; c < 4; ++c)
                    this->expect_error(with(r, c, number), r == 3, flags, "not finite");
}

TYPED_TEST(MatricesTest, no_place_for_the_number_of_the_first_is_needed)
{
    using T = TypeParam;
    const std::vector<T> in = numbers<T>({scaled(2, 2, 2)}, MW_MATRIX_ROWS_3X4);
    typename api<T>::motor motor{};
    for (unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_NEAREST_ROTATION), unsigned(MW_ROTATION_MATRICES)})
        EXPECT_EQ(api<T>::convert_matrix_to_motor_each(api<T>::motors_aos(&motor, sizeof motor),
                                                 {in.data(), sizeof(T[12]), MW_MATRIX_ROWS_3X4}, 1, flags, nullptr),
                  flags == MW_DEFAULT ? MW_ERROR_MATRIX : MW_OK);
}

// ---------------------------------------------------------------------------------------------------------- accepted

TYPED_TEST(MatricesTest, of_rotations_and_translations_of_any_size_are_none)
{
    Random random(32);
    std::vector<Matrix> matrices = {identity, about_z(2 * quarter_turn), about_z(quarter_turn)};
    for (int k = 0; k < 500; ++k)
        matrices.push_back(random_pose(random));
    for (double far : {1e-37, 1e30, -3e38})
        matrices.push_back(with(1, 3, far));
    this->expect_motors(matrices, "poses");
}

// What files and pipelines hold.
TYPED_TEST(MatricesTest, that_were_rounded_are_none)
{
    using T = TypeParam;
    Random random(33);
    const bool single = sizeof(T) == sizeof(float);
    std::vector<Matrix> decimals, floats, products;
    for (int k = 0; k < 500; ++k) {
        Matrix matrix = random_pose(random);
        floats.push_back(matrix);
        for (auto &row : floats.back())
            for (double &number : row)
                number = static_cast<float>(number);
        const double unit = single ? 1e4 : 1e6;
        for (auto &row : matrix)
            for (double &number : row)
                number = std::round(number * unit) / unit;
        decimals.push_back(matrix);
    }
    this->expect_motors(decimals, single ? "four decimals" : "six decimals");
    this->expect_motors(floats, "floats");
    for (int k = 0; k < 5; ++k) {
        const Matrix same = random_pose(random);
        for (bool all_the_same : {true, false}) {
            Matrix product = identity;
            for (int n = 0; n < 1000; ++n) {
                product = product * (all_the_same ? same : random_pose(random));
                for (auto &row : product)
                    for (double &number : row)
                        number = static_cast<double>(static_cast<T>(number));
            }
            products.push_back(product);
        }
    }
    this->expect_motors(products, "products");
}

// General inverses leave a little of a projection.
TYPED_TEST(MatricesTest, with_a_last_row_to_rounding_are_none)
{
    const double little = static_cast<double>(std::numeric_limits<TypeParam>::epsilon());
    for (double some : {-8 * little, 8 * little}) {
        this->expect_motors({with(3, 0, some), with(3, 1, some), with(3, 2, some), with(3, 3, 1 + some)}, "last row");
        EXPECT_EQ(convert<TypeParam>({with(3, 0, 4 * some)}, MW_MATRIX_ROWS_4X4).status, MW_ERROR_MATRIX);
    }
}

// ----------------------------------------------------------------------------------------------------- the tolerance

// Around the tolerance, in every layout and every place: what is said is what mw_check_matrices says.
TYPED_TEST(MatricesTest, are_taken_up_to_the_tolerance)
{
    using T = TypeParam;
    Random random(34);
    int taken = 0, refused = 0;
    for (int k = 0; k < 2000; ++k) {
        const double size = tolerance<T> * random.uniform(0.2, 1.2) / (k % 2 ? 1 : 2);
        Matrix matrix = random_pose(random) * (k % 2 ? with(0, 1, size) : scaled(1, 1 + size, 1));
        std::optional<mw_status> before;
        for (mw_matrix_layout layout : all_matrix_layouts) {
            const std::vector<T> in = numbers<T>({matrix}, layout);
            const mw_status checked =
                api<T>::check_matrices({in.data(), numbers_of(layout) * sizeof(T), layout}, 1,
                                              static_cast<T>(tolerance<T>), nullptr, nullptr);
            EXPECT_EQ(convert<T>({matrix}, layout).status, checked) << name_of(layout);
            EXPECT_EQ(before.value_or(checked), checked) << name_of(layout);
            before = checked;
        }
        EXPECT_EQ(*before, deviation<T>(matrix) <= tolerance<T> ? MW_OK : MW_ERROR_MATRIX);
        ++(*before == MW_OK ? taken : refused);
    }
    EXPECT_GT(taken, 200);
    EXPECT_GT(refused, 200);
}

// Of a motor, normalised.
template <class T>
std::array<double, 4> rotation_of(const std::vector<T> &motor)
{
    std::array<double, 4> rotation;
    double square = 0;
    for (std::size_t k = 0; k < 4; ++k)
        square += static_cast<double>(motor[k]) * static_cast<double>(motor[k]);
    for (std::size_t k = 0; k < 4; ++k)
        rotation[k] = static_cast<double>(motor[k]) / std::sqrt(square);
    return rotation;
}

// Of two rotations, S or -S of each.
double angle_between(const std::array<double, 4> &a, const std::array<double, 4> &b)
{
    double cosine = 0, square = 0;
    for (std::size_t k = 0; k < 4; ++k)
        cosine += a[k] * b[k];
    for (std::size_t k = 0; k < 4; ++k)
        square += std::pow(a[k] - (cosine < 0 ? -b[k] : b[k]), 2);
    return 4 * std::asin(std::sqrt(square) / 2);
}

TYPED_TEST(MatricesTest, within_the_tolerance_turn_by_the_nearest_angle_but_for_twice_their_distance)
{
    using T = TypeParam;
    Random random(35);
    int taken = 0;
    for (int k = 0; k < 20000; ++k) {
        Matrix matrix = random_pose(random);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                matrix[r][c] += (random.chance(2) ? 0.4 : -0.4) * tolerance<T> * random.uniform(0.5, 1);
        const Converted<T> got = convert<T>({matrix}, MW_MATRIX_ROWS_3X4);
        if (got.status != MW_OK)
            continue;
        ++taken;
        const Converted<T> nearest = convert<T>({matrix}, MW_MATRIX_ROWS_3X4, MW_NEAREST_ROTATION);
        ASSERT_EQ(nearest.status, MW_OK);
        EXPECT_LE(angle_between(rotation_of(got.motors), rotation_of(nearest.motors)),
                  2 * deviation<T>(matrix) + 8 * static_cast<double>(std::numeric_limits<T>::epsilon()));
    }
    EXPECT_GT(taken, 2000);
}

// -------------------------------------------------------------------------------------------------- nearest rotations

TYPED_TEST(MatricesTest, with_scale_have_a_nearest_rotation)
{
    using T = TypeParam;
    for (double scale : {2.0, 0.001, 1.0001, 1e-30, 1e30})
        for (mw_matrix_layout layout : all_matrix_layouts) {
            const Converted<T> got = convert<T>({about_z(quarter_turn) * scaled(scale, scale, scale)}, layout,
                                                MW_NEAREST_ROTATION);
            ASSERT_EQ(got.status, MW_OK) << scale;
            const double h = std::sqrt(0.5), rounding = 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
            EXPECT_NEAR(static_cast<double>(got.motors[0]), h, rounding);
            EXPECT_NEAR(static_cast<double>(got.motors[1]), h, rounding);
        }
}

// A mirror image is as near to the half turn about any axis in the mirror; what leaves a line or a point of space, to
// all rotations about it.
TYPED_TEST(MatricesTest, without_one_nearest_rotation_are_errors)
{
    for (const Matrix &mirror : {scaled(-1, 1, 1), scaled(1, -1, 1), scaled(1, 1, -1), scaled(-1, -1, -1),
                                 scaled(-3, -3, -3), scaled(-1e-3, 1, 1e-3), scaled(5, -2, 2)})
        this->expect_error(about_z(2) * mirror, false, MW_NEAREST_ROTATION, "mirror image");
    this->expect_error(scaled(0, 0, 0), false, MW_NEAREST_ROTATION, "a point");
    this->expect_error(about_z(1) * scaled(2, 0, 0), false, MW_NEAREST_ROTATION, "a line");
    this->expect_error(scaled(1, 1e-30, 1e-30), false, MW_NEAREST_ROTATION, "all but a line");
}

TYPED_TEST(MatricesTest, that_flatten_or_reflect_a_little_have_a_nearest_rotation)
{
    using T = TypeParam;
    for (const Matrix &stretch : {scaled(1, 1, 0), scaled(3, 1, -0.5), scaled(1, 0.01, 0), scaled(1, 1, -0.999)}) {
        const Converted<T> got = convert<T>({about_z(quarter_turn) * stretch}, MW_MATRIX_ROWS_3X4, MW_NEAREST_ROTATION);
        ASSERT_EQ(got.status, MW_OK);
        EXPECT_NEAR(static_cast<double>(got.motors[0]), std::sqrt(0.5), 1e-3);
        EXPECT_NEAR(static_cast<double>(got.motors[1]), std::sqrt(0.5), 1e-3);
    }
}

}  // namespace
}  // namespace motorway::testing
