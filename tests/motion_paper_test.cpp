// What the papers say of their motions: the coefficients and the properties of the figures, lemmas 4.1 and 4.2, and
// the helix of Wareham and Lasenby. docs/errata.md lists what is misprinted.

#include <cmath>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

using reference::Element;
using reference::Real;

constexpr double pi = 3.14159265358979323846;

template <class T>
class MotionPaperTest : public ::testing::Test {
protected:
    using A = api<T>;
    using Motor = typename A::motor;

    static Motor rotation(std::initializer_list<T> axis, double angle)
    {
        Motor motor{};
        EXPECT_EQ(A::rotation(&motor, axis.begin(), static_cast<T>(angle), nullptr), MW_OK);
        return motor;
    }

    static Motor translation(double x, double y, double z)
    {
        Motor motor{};
        const T offset[] = {static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)};
        EXPECT_EQ(A::translation(&motor, offset), MW_OK);
        return motor;
    }

    // The product of the paper: the first acts first.
    static Motor product(std::initializer_list<Motor> factors)
    {
        Motor result{1, 0, 0, 0, 0, 0, 0, 0};
        for (const Motor &factor : factors)
            EXPECT_EQ(A::compose_motor_each(packed_motors(&result.s), A::const_motors_aos(&result, sizeof result),
                                            A::const_motors_aos(&factor, sizeof factor), 1),
                      MW_OK);
        return result;
    }

    // To half a unit of the last digit printed, and the rounding of T.
    static void expect_printed(const Motor &motor, const double (&printed)[8], double unit)
    {
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_NEAR(static_cast<double>((&motor.s)[c]), printed[c],
                        unit / 2 + 8 * std::abs(printed[c]) * static_cast<double>(epsilon<T>))
                << "component " << c;
    }

    // The controls are printed, and the motion meets its ends.
    static void expect_ends_printed(const MotionData<T> &data, const double (&first)[8], const double (&last)[8],
                                    double unit)
    {
        const CompiledMotion<T> motion(data);
        const std::vector<T> out = sampled(motion, {motion.first(), motion.last()});
        Motor ends[2];
        std::memcpy(static_cast<void *>(ends), out.data(), sizeof ends);
        expect_printed(ends[0], first, unit);
        expect_printed(ends[1], last, unit);
    }

    static MotionData<T> bezier(std::vector<Motor> controls, mw_motion_kind kind = MW_MOTION_ADDITIVE)
    {
        MotionData<T> data;
        data.kind = kind;
        data.degree = controls.size() - 1;
        data.controls = std::move(controls);
        return data;
    }

    // Where the motion takes a point, at many parameters: three numbers each.
    static std::vector<T> path(const MotionData<T> &data, const std::vector<T> &parameters,
                               const std::array<T, 3> &point = {0, 0, 0})
    {
        const CompiledMotion<T> motion(data);
        std::vector<T> out(3 * parameters.size());
        const mw_status status = A::apply_point_motion(
            A::xyz_aos(out.data(), sizeof(T[3])), sizeof(T[3]), motion.get(), 0, parameters.data(), parameters.size(),
            A::const_xyz_aos(point.data(), sizeof(T[3])), 1, MW_DEFAULT);
        EXPECT_EQ(status, MW_OK);
        return out;
    }
};

TYPED_TEST_SUITE(MotionPaperTest, Precisions, PrecisionName);

TYPED_TEST(MotionPaperTest, figure_1_coefficients)
{
    const auto first = this->product({this->rotation({0, 0, 1}, pi / 3), this->translation(8, 0, 0)});
    const auto second = this->product({this->rotation({1, 0, 0}, -2 * pi / 3), this->translation(0, 6, 0)});
    this->expect_ends_printed(this->bezier({first, second}), {0.866, 0.5, 0, 0, 3.464, -2, 0, 0},
                              {0.5, 0, 0, -0.866, 0, 1.5, 2.598, 0}, 1e-3);
}

// The path of the origin lies on a cylinder of radius 10 about e3 and in a plane through its ends; that of the
// multiplicative motion is the true helix.
TYPED_TEST(MotionPaperTest, figure_2_planar_curve_and_true_helix)
{
    using T = TypeParam;
    const double alpha = 5 * pi / 6;
    const auto first = this->translation(10, 0, 2);
    const auto second = this->product({this->rotation({0, 0, 1}, alpha),
                                       this->translation(10 * std::cos(alpha), 10 * std::sin(alpha), 22)});
    const auto data = this->bezier({first, second});
    const double c = std::cos(alpha / 2), s = std::sin(alpha / 2);
    this->expect_ends_printed(data, {1, 0, 0, 0, 5, 0, 1, 0},
                              {c, s, 0, 0, 5 * c, 5 * s, 11 * c, 11 * s}, 1e-6);
    const auto parameters = unit_interval<TypeParam>(65);
    const std::vector<T> planar = this->path(data, parameters);
    const std::vector<T> helix = this->path(this->bezier({first, second}, MW_MOTION_MULTIPLICATIVE), parameters);
    const long double tolerance = 8 * 22 * epsilon<T>;  // lengths up to 22
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const long double x = planar[3 * i], y = planar[3 * i + 1], z = planar[3 * i + 2];
        EXPECT_LE(std::abs(std::hypot(x, y) - 10), tolerance);
        // Turned to the middle, the plane through the ends and the centre of the curve, at height 12, is y' ~ z - 12.
        EXPECT_LE(std::abs((y * c - x * s) / (10 * s) - (z - 12) / 10), tolerance / (10 * s));
        const long double angle = parameters[i] * static_cast<long double>(alpha);
        EXPECT_LE(std::abs(helix[3 * i] - 10 * std::cos(angle)), tolerance);
        EXPECT_LE(std::abs(helix[3 * i + 1] - 10 * std::sin(angle)), tolerance);
        EXPECT_LE(std::abs(helix[3 * i + 2] - (2 + 20 * static_cast<long double>(parameters[i]))), tolerance);
    }
}

// On the sphere of radius 1 about -e1 and on the cylinder of half its radius through its centre and the origin: as
// the paper prints the three controls for t from 0 to 1, and between other knots for t far beyond.
TYPED_TEST(MotionPaperTest, figure_3_viviani_s_curve_satisfies_its_equations)
{
    using T = TypeParam;
    using Pose = typename TestFixture::Motor;
    // The blossom of 1 + t (e12 + e13 + e2∞ + e3∞) + t² e23.
    const auto blossom = [](T a, T b) {
        const T mean = (a + b) / 2;
        return Pose{1, mean, mean, a * b, 0, mean, mean, 0};
    };
    for (const T reach : {T(1), T(8)}) {
        auto data = this->bezier({blossom(0, 0), blossom(0, 1), blossom(1, 1)});
        if (reach > 1) {
            data.controls = {blossom(-reach, -reach), blossom(-reach, reach), blossom(reach, reach)};
            data.knots = {-reach, -reach, reach, reach};
        }
        std::vector<T> parameters;
        for (int i = reach > 1 ? -256 : 0; i <= 256; ++i)
            parameters.push_back(reach * static_cast<T>(i) / 256);
        const std::vector<T> path = this->path(data, parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const long double x = path[3 * i], y = path[3 * i + 1], z = path[3 * i + 2];
            EXPECT_LE(std::abs((x + 1) * (x + 1) + y * y + z * z - 1), 4 * epsilon<T>) << "at " << parameters[i];
            EXPECT_LE(std::abs(x * x + y * y + x), 4 * epsilon<T>) << "at " << parameters[i];
        }
        if (reach == T(1)) {  // from the origin to the north pole
            EXPECT_EQ(std::vector<T>(path.begin(), path.begin() + 3), (std::vector<T>{0, 0, 0}));
            EXPECT_EQ(std::vector<T>(path.end() - 3, path.end()), (std::vector<T>{-1, 0, 1}));
        }
    }
}

TYPED_TEST(MotionPaperTest, figure_4_coefficients_and_de_casteljau)
{
    using T = TypeParam;
    using Pose = typename TestFixture::Motor;
    const auto turned = [&](double half, double x, double y) {
        return this->product({this->rotation({0, 0, 1}, -2 * half), this->translation(x, y, 0)});
    };
    const std::vector<Pose> controls = {this->translation(1, 1, 0), turned(pi / 12, 2, 6), turned(pi / 4, 5, 6),
                                         turned(pi / 4, 8, 2)};
    this->expect_printed(controls[1], {0.9659, -0.2588, 0, 0, 0.1895, 3.1566, 0, 0}, 1e-4);
    this->expect_printed(controls[2], {0.7071, -0.7071, 0, 0, -0.3536, 3.8891, 0, 0}, 1e-4);
    const auto data = this->bezier(controls);
    this->expect_ends_printed(data, {1, 0, 0, 0, 0.5, 0.5, 0, 0}, {0.7071, -0.7071, 0, 0, 2.1213, 3.5355, 0, 0},
                              1e-4);

    // The construction at t = 0.4: every entry of the tableau is a linear motion of the two to its left.
    std::vector<Pose> tableau = controls;
    while (tableau.size() > 1) {
        for (std::size_t k = 0; k + 1 < tableau.size(); ++k) {
            const auto linear = this->bezier({tableau[k], tableau[k + 1]});
            const std::vector<T> mean = sampled(CompiledMotion<T>(linear), {T(0.4)});
            std::memcpy(static_cast<void *>(&tableau[k]), mean.data(), sizeof(Pose));
        }
        tableau.pop_back();
    }
    const std::vector<T> out = sampled(CompiledMotion<T>(data), {T(0.4)});
    EXPECT_LE(pose_error(out.data(), exact_pose(&tableau[0].s), 4), 8);
}

// The paper writes e31 in R_y, and e2 e123 = e31: a rotation about e2.
TYPED_TEST(MotionPaperTest, figure_5_coefficients)
{
    using T = TypeParam;
    struct Control {
        double z, x, y;  // angles of the rotations, in this order, in units of π
        double offset[3];
        double printed[8];
    };
    const Control controls[] = {
        {0, 0, 0, {1, 1, 0}, {1.000, 0, 0, 0, 0.500, 0.500, 0, 0}},
        {1. / 6, 0, 0, {6, 1, 0}, {0.966, 0.259, 0, 0, 3.027, -0.293, 0, 0}},
        {1. / 2, 0, 0, {8, 4, 2}, {0.707, 0.707, 0, 0, 4.243, -1.414, 0.707, 0.707}},
        {1. / 2, 1. / 4, 0, {8, 6, 4}, {0.653, 0.653, 0.271, 0.271, 5.114, -0.112, -0.588, 1.577}},
        {1. / 2, 0, 1. / 3, {4, 6, 6}, {0.612, 0.612, -0.354, 0.354, 2.001, 1.673, 1.484, 3.605}},
        {1. / 2, 0, 1. / 2, {1, 6, 2}, {0.500, 0.500, -0.500, 0.500, 1.250, 1.750, -0.750, 2.250}}};
    MotionData<T> data;
    data.degree = 2;
    for (const Control &c : controls) {
        const auto offset = this->translation(c.offset[0], c.offset[1], c.offset[2]);
        data.controls.push_back(this->product({this->rotation({0, 0, 1}, c.z * pi),
                                               this->rotation({1, 0, 0}, c.x * pi),
                                               this->rotation({0, 1, 0}, c.y * pi), offset}));
        this->expect_printed(data.controls.back(), c.printed, 1e-3);
    }
    // The knots of the figure are those that it has without any.
    const CompiledMotion<T> without(data);
    data.knots = {0, 0, 1, 2, 3, 4, 4};
    this->expect_ends_printed(data, controls[0].printed, controls[5].printed, 1e-3);
    Random random(83);
    const auto parameters = parameters_of<T>(random, data.exact(), 40);
    EXPECT_TRUE(same_bits(sampled(CompiledMotion<T>(data), parameters), sampled(without, parameters)));
}

// ------------------------------------------------------------------------------------------------------------ lemmas

// The homogeneous control point of a pair of poses, e0 e1 e2 e3 of ½ (Ā p B + B̄ p A).
std::array<Real, 4> mixed_image(const Element &a, const Element &b, const Element &point)
{
    const Element sum = reverse(a) * point * b + reverse(b) * point * a;
    std::array<Real, 4> image;
    const char *const names[] = {"0", "1", "2", "3"};
    for (std::size_t k = 0; k < 4; ++k)
        image[k] = Real(0.5L) * coordinate(sum, names[k]);
    return image;
}

// Points of a Bézier motion of degree n run on the rational Bézier curve of degree 2n with the control points
// Σ C(n,i) C(n,j) / C(2n,k) ½ (S̄_i p S_j + S̄_j p S_i), over i + j = k. For n = 1 that is lemma 4.2.
template <class T>
std::vector<std::array<Real, 4>> control_points(const MotionData<T> &data, const std::array<T, 3> &point)
{
    const auto binomial = [](std::size_t n, std::size_t k) {
        double value = 1;
        for (std::size_t m = 1; m <= k; ++m)
            value = value * static_cast<double>(n + 1 - m) / static_cast<double>(m);
        return value;
    };
    const reference::Vector5 homogeneous = {Real(1), Real(point[0]), Real(point[1]), Real(point[2]), Real(0)};
    std::vector<std::array<Real, 4>> points(2 * data.degree + 1);
    for (std::size_t i = 0; i <= data.degree; ++i)
        for (std::size_t j = 0; j <= data.degree; ++j) {
            const Real factor = Real(binomial(data.degree, i) * binomial(data.degree, j)) /
                                Real(binomial(2 * data.degree, i + j));
            const auto image = mixed_image(element(exact_motor(&data.controls[i].s)),
                                           element(exact_motor(&data.controls[j].s)), element(homogeneous));
            for (std::size_t c = 0; c < 4; ++c)
                points[i + j][c] += factor * image[c];
        }
    return points;
}

template <class T>
std::array<long double, 3> rational_point(std::vector<std::array<Real, 4>> points, T parameter)
{
    const Real t(parameter), rest = Real(1) - t;
    for (; points.size() > 1; points.pop_back())
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            for (std::size_t c = 0; c < 4; ++c)
                points[k][c] = rest * points[k][c] + t * points[k + 1][c];
    std::array<long double, 3> point;
    for (std::size_t c = 0; c < 3; ++c)
        point[c] = static_cast<long double>(points[0][c + 1] / points[0][0]);
    return point;
}

// An image is a sum of products of two components of a sample, which has 3.5 (n + 1) ε of its controls; beside that,
// α can be smaller than its terms: of these poses by a factor of 1/4 at most.
TYPED_TEST(MotionPaperTest, lemma_4_2_and_rational_bezier_curves_of_twice_the_degree)
{
    using T = TypeParam;
    Random random(81);
    for (std::size_t degree : {1, 2, 3, 5})
        for (int repetition = 0; repetition < (degree == 1 ? 20 : 4); ++repetition) {
            auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 1);
            for (std::size_t k = 1; k <= degree; ++k)  // the signs that it would be given
                if (dot_of_rotations(exact_pose(&data.controls[k - 1].s), exact_pose(&data.controls[k].s)) < 0)
                    data.controls[k] = rounded_pose<T>(-1.0L * exact_pose(&data.controls[k].s));
            const std::array<T, 3> point = {T(0.5), -2, T(1.25)};
            const auto points = control_points(data, point);
            const auto parameters = unit_interval<TypeParam>(9);
            const std::vector<T> path = this->path(data, parameters, point);
            const long double size = 4 * reach_of(data) + 4;
            for (std::size_t i = 0; i < parameters.size(); ++i) {
                const auto expected = rational_point(points, parameters[i]);
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_LE(std::abs(path[3 * i + c] - expected[c]),
                              8 * static_cast<long double>(degree + 1) * size * epsilon<T>)
                        << data.name() << ", parameter " << parameters[i];
            }
        }
}

// The distance to the axis of the screw from one pose to the other, over random poses of any size.
TYPED_TEST(MotionPaperTest, lemma_4_1_points_stay_on_the_cylinder)
{
    using T = TypeParam;
    Random random(82);
    for (int repetition = 0; repetition < 40; ++repetition) {
        const auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 1, 2);
        using reference::normalize;
        const auto screw = log(compose(inverse(normalize(exact_pose(&data.controls[0].s))),
                                       normalize(exact_pose(&data.controls[1].s))));
        // The axis through a × m / |a|², of direction a and moment m.
        const long double *a = screw.real.data(), *m = screw.dual.data();
        const long double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        if (square < 0.01L)
            continue;  // it hardly turns: the axis is far away
        const auto distance = [&](const T *p) {
            long double q[3], sum = 0;
            for (int k = 0; k < 3; ++k)
                q[k] = p[k] - (a[(k + 1) % 3] * m[(k + 2) % 3] - a[(k + 2) % 3] * m[(k + 1) % 3]) / square;
            for (int k = 0; k < 3; ++k) {
                const long double c = a[(k + 1) % 3] * q[(k + 2) % 3] - a[(k + 2) % 3] * q[(k + 1) % 3];
                sum += c * c / square;
            }
            return std::sqrt(sum);
        };
        const auto parameters = unit_interval<TypeParam>(17);
        const std::vector<T> path = this->path(data, parameters, {T(0.5), -2, T(1.25)});
        const long double tolerance = 64 * (reach_of(data) + 2) * epsilon<T>;  // as above, twice, and an angle of 0.1
        for (std::size_t i = 0; i < parameters.size(); ++i)
            EXPECT_LE(std::abs(distance(&path[3 * i]) - distance(&path[0])), tolerance) << repetition << ", " << i;
    }
}

// The helix of Wareham and Lasenby's figure 7, section 4.1: t∥ = 4a + 6b, ψ = 9π, |t⊥| = 1, with e1, e2 and e3 for a,
// b and their normal. By ten turns of less than a half, or the first of them from the base as a generator. With c and
// s of λψ/2 its points are λ (sinc λψ/2) (4c - 6s, 6c + 4s) in the plane and λ along its normal.
TYPED_TEST(MotionPaperTest, linear_screws_are_the_helix_of_wareham_and_lasenby)
{
    using T = TypeParam;
    const std::size_t pieces = 10;
    const long double psi = 9 * static_cast<long double>(pi);
    for (mw_motion_kind kind : {MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE, MW_MOTION_GENERATOR,
                                MW_MOTION_GENERATOR_KEYS}) {
        const bool from_base = kind == MW_MOTION_GENERATOR || is_of_keys(kind);
        MotionData<T> data;
        data.kind = kind;
        for (std::size_t k = 0; k <= (from_base ? 1 : pieces); ++k) {
            const long double part = static_cast<long double>(k) / pieces;
            data.controls.push_back(rounded_pose<T>(
                exp(part * reference::DualQuaternion{{0, 0, psi / 2, 0}, {2, 3, 0.5L, 0}})));
        }
        const CompiledMotion<T> motion(data);
        std::vector<T> parameters;
        for (std::size_t i = 0; i <= 90; ++i)
            parameters.push_back(motion.last() * static_cast<T>(i) / 90);
        const std::vector<T> path = this->path(data, parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const long double lambda = static_cast<long double>(parameters[i]) / pieces;
            const long double c = std::cos(lambda * psi / 2), s = std::sin(lambda * psi / 2);
            const long double tolerance = 16 * epsilon<T>;
            const long double expected[] = {2 * s / psi * (4 * c - 6 * s), 2 * s / psi * (6 * c + 4 * s), lambda};
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LE(std::abs(path[3 * i + k] - expected[k]), tolerance) << name_of(kind) << ", " << i;
        }
    }
}

}  // namespace
}  // namespace motorway::testing
