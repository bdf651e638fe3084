// The reference itself: the algebra against the paper's rules, the motions against matrices, the B-spline against the
// definition of its basis functions.

#include <cmath>

#include <gtest/gtest.h>

#include "motors.h"
#include "reference.h"
#include "screws.h"

namespace motorway::reference {
namespace {

using testing::Random;
using testing::Regime;

constexpr long double tiny = 1e-28L;  // far above the errors of Extended, far below those of double

long double distance(const Real &a, const Real &b) { return std::abs(static_cast<long double>(a - b)); }

void expect_equal(const Element &a, const Element &b)
{
    for (unsigned bits = 0; bits < 32; ++bits)
        ASSERT_LE(distance(a[bits], b[bits]), tiny) << "component " << bits;
}

template <std::size_t N>
void expect_close(const std::array<Real, N> &a, const std::array<Real, N> &b, long double tolerance)
{
    for (std::size_t k = 0; k < N; ++k)
        ASSERT_LE(distance(a[k], b[k]), tolerance) << "component " << k;
}

Element random_element(Random &random)
{
    Element a;
    for (unsigned bits = 0; bits < 32; ++bits)
        a[bits] = Real(random.uniform(-1, 1));
    return a;
}

TEST(Extended, keeps_what_long_double_drops)
{
    const Real small(0x1p-100L), sum = Real(1) + small;
    EXPECT_EQ(sum - Real(1), small);
    EXPECT_EQ(sum * sum - Real(1), small + small);
    const Real third = Real(1) / Real(3);
    EXPECT_LE(distance(third * Real(3), Real(1)), 0x1p-105L);
    const Real root = sqrt(Real(2));
    EXPECT_LE(distance(root * root, Real(2)), 0x1p-104L);
    EXPECT_NE(third.low, 0);
    EXPECT_NE(root.low, 0);
}

TEST(Reference, orthonormal_vectors_square_to_their_signature)
{
    for (unsigned k = 0; k < 5; ++k) {
        const Element v = Element::blade(1u << k);
        expect_equal(v * v, Element(Real(k == 4 ? -1 : 1)));
        for (unsigned other = 0; other < k; ++other)
            expect_equal(v * Element::blade(1u << other), Element(Real(-1)) * (Element::blade(1u << other) * v));
    }
}

// Section 2 of the paper.
TEST(Reference, obeys_the_rules_of_the_papers_basis)
{
    for (const char *k : {"1", "2", "3"}) {
        expect_equal(e(k) * e(k), Element(Real(1)));
        for (const char *null : {"0", "i"})
            expect_equal(e(k) * e(null), Element(Real(-1)) * e(null) * e(k));
    }
    expect_equal(e("0") * e("0"), Element());
    expect_equal(e("i") * e("i"), Element());
    expect_equal(e("i") * e("0"), Element(Real(-2)) - e("0") * e("i"));
    expect_equal(reverse(e("0i")), Element(Real(-2)) - e("0i"));  // equation (2)
    expect_equal(e("123i") * e("123i"), Element());               // ω² = 0
}

TEST(Reference, product_is_associative_and_its_reverse_the_product_of_reverses)
{
    Random random(11);
    for (int k = 0; k < 20; ++k) {
        const Element a = random_element(random), b = random_element(random), c = random_element(random);
        expect_equal((a * b) * c, a * (b * c));
        expect_equal(reverse(a * b), reverse(b) * reverse(a));
    }
}

TEST(Reference, coordinates_in_the_papers_basis_give_the_element_back)
{
    Random random(12);
    const Element a = random_element(random);
    Element sum;
    for (unsigned sigma = 0; sigma < 32; ++sigma) {
        std::string name;
        for (unsigned k = 0; k < 5; ++k)
            if (sigma & (1u << k))
                name += "0123i"[k];
        EXPECT_EQ(coordinate(e(name.c_str()), name.c_str()), Real(1)) << name;
        sum = sum + Element(coordinate(a, name.c_str())) * e(name.c_str());
    }
    expect_equal(sum, a);
}

// e_{01∞} is of grades 1 and 3 in the usual sense; the paper's P takes nothing of it.
TEST(Reference, projection_is_along_the_papers_basis)
{
    expect_equal(project(e("01i")), Element());
    expect_equal(project(e("0123i")), Element());
    expect_equal(project(e("i") + e("123")), Element());
    expect_equal(project(e("0") + e("2")), e("0") + e("2"));
    EXPECT_NE(e("01i")[1], Real(0));
}

TEST(Reference, motors_are_closed_under_the_product)
{
    Random random(13);
    for (int k = 0; k < 20; ++k) {
        const Motor a = exact_random_motor(random, Regime::arbitrary), b = exact_random_motor(random, Regime::far);
        EXPECT_LE(static_cast<long double>(outside_of_motors(element(a) * element(b))), 1e-20L);
        expect_close(motor(element(a)), a, tiny);
    }
}

TEST(Reference, rotation_and_translation_are_those_of_lemmas_3_10_and_3_11)
{
    const Vector3 p = {Real(1), Real(2), Real(3)};
    const Vector3 moved = apply_point(motor(translation({Real(10), Real(-20), Real(30)})), p);
    expect_close<3>(moved, {Real(11), Real(-18), Real(33)}, tiny);
    // A quarter turn about the line through (1, 0, 0) along e3: (2, 0, 5) goes to (1, 1, 5), and e1 to e2.
    const Real half = sqrt(Real(0.5L));
    const Motor turn = motor(rotation({Real(0), Real(0), Real(1)}, half, half, {Real(1), Real(0), Real(0)}));
    expect_close<3>(apply_point(turn, {Real(2), Real(0), Real(5)}), {Real(1), Real(1), Real(5)}, tiny);
    expect_close<3>(apply_direction(turn, {Real(1), Real(0), Real(0)}), {Real(0), Real(1), Real(0)}, tiny);
}

TEST(Reference, the_first_factor_acts_first)
{
    Random random(14);
    for (int k = 0; k < 50; ++k) {
        const Motor u = exact_random_motor(random, Regime::general);
        const Motor v = exact_random_motor(random, Regime::arbitrary);
        const Vector3 p = testing::random_vector(random, 0.1, 10);
        expect_close(apply_point(compose(u, v), p), apply_point(v, apply_point(u, p)), 1e-25L);
    }
}

// Lemma 3.4 and corollary 3.7.
TEST(Reference, normalised_motors_move_alike_and_have_no_pseudoscalar_part)
{
    Random random(15);
    for (int k = 0; k < 50; ++k) {
        const Motor s = exact_random_motor(random, Regime::scaled_pseudoscalar), unit = normalize(s);
        expect_equal(reverse(element(unit)) * element(unit), Element(Real(1)));
        const Vector3 p = testing::random_vector(random, 0.1, 10);
        expect_close(apply_point(s, p), apply_point(unit, p), 1e-25L);
        EXPECT_EQ(s[0] < Real(0), unit[0] < Real(0));
    }
}

TEST(Reference, dividing_by_the_scalar_alone_leaves_the_pseudoscalar_part)
{
    Motor s{};
    s[0] = Real(2);
    s[7] = Real(3);
    EXPECT_EQ(beta(s), Real(12));
    expect_close<8>(normalize(s), {Real(1), Real(0), Real(0), Real(0), Real(0), Real(0), Real(0), Real(0)}, tiny);
}

TEST(Reference, product_magnitudes_bound_the_product)
{
    Random random(16);
    const Motor a = exact_random_motor(random, Regime::arbitrary), b = exact_random_motor(random, Regime::arbitrary);
    const Motor product = compose(a, b), magnitudes = product_magnitudes(a, b);
    for (std::size_t k = 0; k < 8; ++k)
        EXPECT_LE(std::abs(static_cast<long double>(product[k])), static_cast<long double>(magnitudes[k]));
    // s t takes part in one component only, and alone gives just that.
    Motor one{};
    one[0] = Real(-1);
    expect_close<8>(product_magnitudes(one, one), {Real(1)}, 0);
}

Vector3 operator+(const Vector3 &a, const Vector3 &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector3 operator-(const Vector3 &a, const Vector3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real dot(const Vector3 &a, const Vector3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3 &a, const Vector3 &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The points p with v·p = 0 are those at `radius` from `centre`; of radius 0 it is the point itself.
Vector5 sphere(const Vector3 &centre, const Real &radius)
{
    return {Real(1), centre[0], centre[1], centre[2], (dot(centre, centre) - radius * radius) / Real(2)};
}

Vector5 plane(const Vector3 &normal, const Real &distance)
{
    return {Real(0), normal[0], normal[1], normal[2], distance};
}

Line line_through(const Vector3 &p, const Vector3 &q)
{
    const Vector3 direction = q - p, moment = cross(p, direction);
    return {direction[0], direction[1], direction[2], moment[0], moment[1], moment[2]};
}

// Motors of every kind and ordinary size, none of them normalised.
Motor unnormalised(Random &random, int k)
{
    const Regime regimes[] = {Regime::scaled, Regime::pseudoscalar, Regime::scaled_pseudoscalar, Regime::half_turn};
    Motor motor = exact_random_motor(random, regimes[k % 4]);
    const Real size = sqrt(alpha(motor));
    for (Real &component : motor)
        component = component / size * Real(1.25L);
    return motor;
}

Vector3 ordinary_point(Random &random) { return testing::random_vector(random, 0.1, 10); }

// The inner product of e0 + p + ½p² e∞ with itself is 0: that is what makes it a point.
TEST(Reference, points_and_spheres_have_the_squares_of_their_radii)
{
    Random random(19);
    for (int k = 0; k < 20; ++k) {
        const Vector3 centre = ordinary_point(random);
        const Real radius(random.uniform(0, 5));
        const Element v = element(sphere(centre, radius)), p = element(sphere(centre, Real(0)));
        expect_equal(v * v, Element(radius * radius));
        expect_equal(p * p, Element());
    }
}

TEST(Reference, the_image_of_a_sphere_is_the_sphere_about_the_image_of_its_centre)
{
    Random random(20);
    for (int k = 0; k < 100; ++k) {
        const Motor s = unnormalised(random, k);
        const Vector3 centre = ordinary_point(random);
        for (const Real &radius : {Real(0), Real(random.uniform(0, 5))})
            expect_close(apply_vector(s, sphere(centre, radius)), sphere(apply_point(s, centre), radius), 1e-25L);
    }
}

TEST(Reference, the_image_of_a_plane_goes_through_the_images_of_its_points)
{
    Random random(21);
    for (int k = 0; k < 100; ++k) {
        const Motor s = unnormalised(random, k);
        const Vector3 p[] = {ordinary_point(random), ordinary_point(random), ordinary_point(random)};
        const auto through = [](const Vector3 &a, const Vector3 &b, const Vector3 &c) {
            const Vector3 normal = cross(b - a, c - a);
            return plane(normal, dot(normal, a));
        };
        expect_close(apply_vector(s, through(p[0], p[1], p[2])),
                     through(apply_point(s, p[0]), apply_point(s, p[1]), apply_point(s, p[2])), 1e-23L);
    }
}

TEST(Reference, the_image_of_a_line_goes_through_the_images_of_its_points)
{
    Random random(22);
    for (int k = 0; k < 100; ++k) {
        const Motor s = unnormalised(random, k);
        const Vector3 p = ordinary_point(random), q = ordinary_point(random);
        expect_close(apply_line(s, line_through(p, q)), line_through(apply_point(s, p), apply_point(s, q)), 1e-24L);
    }
}

// The six numbers of a line are those of the rotation about it by half a turn (lemma 3.11).
TEST(Reference, a_line_is_the_half_turn_about_itself)
{
    Random random(23);
    for (int k = 0; k < 20; ++k) {
        const Vector3 axis = testing::random_unit_vector(random), p = ordinary_point(random);
        expect_equal(element(line_through(p, p + axis)), rotation(axis, Real(0), Real(1), p));
    }
}

TEST(Reference, a_moved_rotation_is_the_rotation_about_the_moved_axis)
{
    Random random(24);
    for (int k = 0; k < 100; ++k) {
        const Motor t = unnormalised(random, k);
        const Vector3 axis = testing::random_unit_vector(random), p = ordinary_point(random);
        const Real cosine(random.uniform(-1, 1)), sine = sqrt(Real(1) - cosine * cosine);
        expect_close(apply_motor(t, motor(rotation(axis, cosine, sine, p))),
                     motor(rotation(apply_direction(t, axis), cosine, sine, apply_point(t, p))), 1e-25L);
    }
}

// Moving where a motion happens: from the moved place the moved motion goes where the motion goes, moved.
TEST(Reference, a_moved_motor_does_to_moved_points_what_it_did)
{
    Random random(25);
    for (int k = 0; k < 100; ++k) {
        const Motor t = unnormalised(random, k), m = unnormalised(random, k / 4);
        const Vector3 p = ordinary_point(random);
        expect_close(apply_point(apply_motor(t, m), apply_point(t, p)), apply_point(t, apply_point(m, p)), 1e-25L);
    }
}

TEST(Reference, moving_by_a_product_is_moving_by_its_factors)
{
    Random random(26);
    for (int k = 0; k < 50; ++k) {
        const Motor u = unnormalised(random, k), v = unnormalised(random, k / 4), uv = compose(u, v);
        const Vector5 vector = sphere(ordinary_point(random), Real(2));
        const Line line = line_through(ordinary_point(random), ordinary_point(random));
        const Motor m = exact_random_motor(random, Regime::arbitrary);
        expect_close(apply_vector(uv, vector), apply_vector(v, apply_vector(u, vector)), 1e-24L);
        expect_close(apply_line(uv, line), apply_line(v, apply_line(u, line)), 1e-24L);
        expect_close(apply_motor(uv, m), apply_motor(v, apply_motor(u, m)), 1e-24L);
    }
}

const Motor one = {Real(1), Real(0), Real(0), Real(0), Real(0), Real(0), Real(0), Real(0)};

// Half the angle of at most 20, as far away as draw_screw goes: sines and cosines are those of long double.
TEST(Reference, exp_of_a_screw_is_its_rotation_and_then_its_translation)
{
    Random random(19);
    for (int k = 0; k < 100; ++k) {
        testing::Screw screw = testing::draw_screw(random, random.uniform(0, 20));
        screw.slide = random.uniform(-3, 3);
        const Motor expected = testing::motor_of(screw);
        const long double size = 1 + testing::length_of(expected, 4, 8);
        expect_close(exp(testing::bivector_of(screw)), expected, 1e-17L * size);
    }
}

TEST(Reference, exp_of_translations_and_tiny_rotations_is_1_and_the_bivector)
{
    const Bivector step = {Real(0), Real(0), Real(0), Real(1e20L), Real(-0.1L), Real(1e-30L)};
    expect_close<8>(exp(step), {Real(1), Real(0), Real(0), Real(0), step[3], step[4], step[5], Real(0)}, 1e-100L);
    const Bivector turn = {Real(1e-30L), Real(0), Real(-2e-30L), Real(1e10L), Real(1), Real(0)};
    const Motor motor = exp(turn);
    for (std::size_t k = 0; k < 6; ++k) {
        const long double size = std::abs(static_cast<long double>(turn[k]));
        EXPECT_LE(distance(motor[k + 1], turn[k]), 1e-19L * size + 1e-45L) << k;
    }
    expect_close(log(motor, Branch::principal), turn, 1e-28L);
    EXPECT_LE(distance(log(motor, Branch::principal)[0], turn[0]), 1e-55L);
}

TEST(Reference, exp_of_multiples_are_powers)
{
    Random random(20);
    for (int k = 0; k < 20; ++k) {
        const Bivector b = log(exact_random_motor(random, Regime::general), Branch::principal);
        expect_close(compose(exp(b), exp(multiple(Real(2), b))), exp(multiple(Real(3), b)), 1e-27L);
        expect_close(compose(exp(b), exp(multiple(Real(-1), b))), one, tiny);
    }
}

TEST(Reference, log_is_the_inverse_of_exp)
{
    Random random(21);
    for (int k = 0; k < 100; ++k) {
        Motor s = normalize(exact_random_motor(random, k % 2 ? Regime::general : Regime::scaled_pseudoscalar));
        for (Real &component : s)
            component = k % 3 ? component : -component;
        const Bivector principal = log(s, Branch::principal), shortest = log(s, Branch::shortest);
        expect_close(exp(principal), s, 1e-27L);
        const Motor nearer = exp(shortest);
        EXPECT_GE(static_cast<long double>(nearer[0]), 0);
        expect_close(compose(nearer, nearer), compose(s, s), 1e-26L);
        EXPECT_LE(testing::length_of(shortest, 0, 3), testing::pi / 2 * (1 + 1e-15L));
        EXPECT_LE(testing::length_of(principal, 0, 3), testing::pi * (1 + 1e-15L));
    }
    // A quarter of the way round is e12 itself, and four of them are one turn.
    const Motor e12 = {Real(0), Real(1), Real(0), Real(0), Real(0), Real(0), Real(0), Real(0)};
    const Bivector quarter = log(e12, Branch::principal);
    EXPECT_LE(distance(quarter[0], Real(testing::pi / 2)), 1e-18L);
    expect_close(exp(multiple(Real(4), quarter)), one, tiny);
}

TEST(Reference, inverse_undoes_any_motor)
{
    Random random(22);
    for (Regime regime : {Regime::scaled_pseudoscalar, Regime::arbitrary, Regime::half_turn}) {
        const Motor s = exact_random_motor(random, regime);
        expect_close(compose(s, inverse(s)), one, 1e-26L);
        expect_close(compose(inverse(s), s), one, 1e-26L);
    }
}

TEST(Reference, slerp_goes_from_one_motor_to_the_other_in_equal_steps)
{
    Random random(23);
    for (int k = 0; k < 20; ++k) {
        const Motor first = normalize(exact_random_motor(random, Regime::general));
        const Motor second = normalize(exact_random_motor(random, Regime::general));
        expect_close(slerp(first, second, Real(0)), first, 1e-27L);
        const Motor last = slerp(first, second, Real(1));
        expect_close(compose(last, last), compose(second, second), 1e-25L);  // second or -second
        const Motor middle = slerp(first, second, Real(0.5L));
        expect_close(slerp(first, middle, Real(0.5L)), slerp(first, second, Real(0.25L)), 1e-26L);
        // From the other end it is the same pose, or -1 times it.
        const Motor back = compose(slerp(second, first, Real(0.5L)), inverse(middle));
        expect_close(compose(back, back), one, 1e-25L);
    }
}

struct Spline {
    std::vector<Motor> controls;
    std::vector<Real> knots;
};

Spline random_spline(Random &random, std::size_t degree, std::size_t controls)
{
    Spline spline;
    for (std::size_t k = 0; k < controls; ++k)
        spline.controls.push_back(exact_random_motor(random, Regime::arbitrary));
    Real knot(0);
    for (std::size_t k = 0; k < controls + degree - 1; ++k) {
        spline.knots.push_back(knot);
        if (!random.chance(3))
            knot += Real(random.uniform(0.1, 1));
    }
    return spline;
}

// The paper's recursion has t_{i-1} where t_{i-r} must be. With that, it agrees with the definition of the basis.
TEST(Reference, blossom_recursion_agrees_with_the_basis_functions)
{
    Random random(17);
    for (std::size_t degree = 1; degree <= 6; ++degree)
        for (int repetition = 0; repetition < 20; ++repetition) {
            const std::size_t controls = degree + 1 + random.below(6);
            const Spline spline = random_spline(random, degree, controls);
            const Real first = spline.knots[degree - 1], last = spline.knots[controls - 1];
            if (!(first < last))
                continue;
            for (int k = 0; k <= 8; ++k) {
                const Real t = first + (last - first) * Real(k / 8.0L);
                const std::vector<Real> basis = bspline_basis(controls, spline.knots, degree, t);
                expect_close(sample_bspline(spline.controls, spline.knots, degree, t), blend(basis, spline.controls),
                             1e-24L);
                Real sum;
                for (const Real &b : basis) {
                    EXPECT_FALSE(b < Real(0));
                    sum += b;
                }
                EXPECT_LE(distance(sum, Real(1)), 1e-24L);
            }
        }
}

TEST(Reference, bezier_motions_are_the_special_case_of_knots_0_and_1)
{
    Random random(18);
    const std::size_t degree = 3;
    Spline spline = random_spline(random, degree, degree + 1);
    spline.knots = {Real(0), Real(0), Real(0), Real(1), Real(1), Real(1)};
    const Real t(0.375L), u(0.625L);
    const std::vector<Real> bernstein = {u * u * u, Real(3) * u * u * t, Real(3) * u * t * t, t * t * t};
    expect_close(sample_bspline(spline.controls, spline.knots, degree, t), blend(bernstein, spline.controls), tiny);
}

}  // namespace
}  // namespace motorway::reference
