// B-spline motions against the reference: every kind of knot vector, both ends, parameters in any order.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "guarded_buffer.h"
#include "isas.h"
#include "layout.h"
#include "motors.h"
#include "precisions.h"
#include "subject.h"

namespace motorway::testing {
namespace {

using reference::Real;

template <class T>
struct Motion {
    std::vector<typename Api<T>::Motor> controls;
    std::vector<T> knots;
    std::size_t degree;

    typename Api<T>::Bspline view() const
    {
        return {controls.data(), controls.size(), knots.data(), knots.size(), static_cast<unsigned>(degree)};
    }
    T first() const { return knots[degree - 1]; }
    T last() const { return knots[controls.size() - 1]; }

    std::vector<reference::Motor> exact_controls() const
    {
        std::vector<reference::Motor> exact;
        for (const auto &control : controls)
            exact.push_back(exact_motor(&control.s));
        return exact;
    }
    std::vector<Real> exact_knots() const { return {knots.begin(), knots.end()}; }
};

enum class Ends { free, clamped };

// Knots are exact in both precisions. Inner ones are repeated at random, up to degree + 1 times.
template <class T>
Motion<T> random_motion(Random &random, std::size_t degree, std::size_t control_count, Ends ends)
{
    Motion<T> motion;
    motion.degree = degree;
    for (std::size_t k = 0; k < control_count; ++k) {
        motion.controls.emplace_back();
        draw_motor(random, k % 3 ? Regime::general : Regime::scaled_pseudoscalar, &motion.controls.back().s);
    }
    T knot = static_cast<T>(random.uniform(-64, 64));
    knot = std::floor(knot * 16) / 16;
    std::size_t repeated = 0;
    const std::size_t knot_count = control_count + degree - 1;
    for (std::size_t k = 0; k < knot_count; ++k) {
        const bool at_end = ends == Ends::clamped && ((k > 0 && k < degree) || k > control_count - 1);
        const bool must_rise = k == control_count - 1 || (ends == Ends::clamped && k == degree);
        const bool repeats = at_end || (!must_rise && k > 0 && repeated < degree && random.chance(3));
        if (k > 0 && !repeats)
            knot += static_cast<T>(1 + random.below(64)) / 16;
        repeated = repeats ? repeated + 1 : 0;
        motion.knots.push_back(knot);
    }
    return motion;
}

// Both ends, all knots inside, and `count` others, in no order.
template <class T>
std::vector<T> parameters_of(Random &random, const Motion<T> &motion, std::size_t count)
{
    std::vector<T> parameters = {motion.first(), motion.last(), std::nextafter(motion.last(), motion.first()),
                                 std::nextafter(motion.first(), motion.last())};
    for (T knot : motion.knots)
        if (motion.first() < knot && knot < motion.last()) {
            parameters.push_back(knot);
            parameters.push_back(std::nextafter(knot, motion.first()));
        }
    for (std::size_t k = 0; k < count; ++k) {
        const double first = static_cast<double>(motion.first()), last = static_cast<double>(motion.last());
        parameters.push_back(std::clamp(static_cast<T>(random.uniform(first, last)), motion.first(), motion.last()));
    }
    for (std::size_t k = parameters.size(); k > 1; --k)
        std::swap(parameters[k - 1], parameters[random.below(k)]);
    return parameters;
}

template <class T>
std::vector<T> sampled(const Motion<T> &motion, const std::vector<T> &parameters)
{
    using Motor = typename Api<T>::Motor;
    std::vector<T> out(8 * parameters.size());
    const auto view = motion.view();
    EXPECT_EQ(Api<T>::sample_bspline(Api<T>::motors_aos(reinterpret_cast<Motor *>(out.data()), sizeof(Motor)), &view,
                                     parameters.data(), parameters.size()),
              MW_OK);
    return out;
}

// The weights are between 0 and 1 and each level of the recursion splits them by a quotient of two differences: at
// most 6 roundings of numbers up to 1, so after d levels a weight is off by no more than 3dε; the sum over d + 1
// controls adds ½(d + 1)ε. The error is relative to the controls of the span: a weight may be close to 0 because two
// numbers cancel, and then its own relative error is not small.
template <class T>
void expect_matches_reference(const Motion<T> &motion, const std::vector<T> &parameters)
{
    const std::vector<T> out = sampled(motion, parameters);
    const auto controls = motion.exact_controls();
    const auto knots = motion.exact_knots();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Real t(parameters[i]);
        const reference::Motor exact = reference::sample_bspline(controls, knots, motion.degree, t);
        const std::vector<Real> basis = reference::bspline_basis(controls.size(), knots, motion.degree, t);
        for (std::size_t c = 0; c < 8; ++c) {
            Real magnitude;
            for (std::size_t k = 0; k < controls.size(); ++k)
                if (!(basis[k] == Real(0)))
                    magnitude += abs(controls[k][c]);
            const long double epsilons = 3.5L * static_cast<long double>(motion.degree + 1);
            ASSERT_LE(std::abs(static_cast<long double>(Real(out[8 * i + c]) - exact[c])),
                      epsilons * (epsilon<T> * static_cast<long double>(magnitude) + underflow<T>))
                << Api<T>::name << ", degree " << motion.degree << ", " << controls.size() << " controls, parameter "
                << parameters[i] << ", component " << c;
        }
    }
}

template <class T>
class MotionTest : public ::testing::Test {};

TYPED_TEST_SUITE(MotionTest, Precisions, PrecisionName);

TYPED_TEST(MotionTest, matches_the_reference_for_every_degree)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(51);
        for (std::size_t degree : {1, 2, 3, 4, 5, 31})
            for (int repetition = 0; repetition < (degree == 31 ? 1 : 6); ++repetition)
                for (Ends ends : {Ends::free, Ends::clamped}) {
                    const std::size_t controls = degree + 1 + random.below(8);
                    const auto motion = random_motion<T>(random, degree, controls, ends);
                    expect_matches_reference(motion, parameters_of(random, motion, degree == 31 ? 4 : 12));
                    if (this->HasFatalFailure())
                        return;
                }
    }
}

// Where a knot is repeated degree + 1 times the motion jumps, and the knot itself belongs to what comes after.
TYPED_TEST(MotionTest, is_taken_from_the_right_at_a_knot)
{
    using T = TypeParam;
    Random random(52);
    Motion<T> motion;
    motion.degree = 2;
    motion.knots = {0, 0, 1, 1, 1, 2, 2};
    for (std::size_t k = 0; k < 6; ++k) {
        motion.controls.emplace_back();
        draw_motor(random, Regime::general, &motion.controls.back().s);
    }
    const std::vector<T> out = sampled(motion, {T(1), std::nextafter(T(1), T(0))});
    const auto after = exact_motor(&motion.controls[3].s), before = exact_motor(&motion.controls[2].s);
    for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_EQ(Real(out[c]), after[c]);
        EXPECT_NEAR(static_cast<double>(out[8 + c]), static_cast<double>(static_cast<long double>(before[c])),
                    static_cast<double>(40 * epsilon<T>));
    }
}

TYPED_TEST(MotionTest, bezier_ends_are_the_controls_exactly)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(53);
        for (std::size_t degree = 1; degree <= MW_MAX_DEGREE; ++degree) {
            Motion<T> motion;
            motion.degree = degree;
            motion.knots.assign(degree, T(0.1));
            motion.knots.resize(2 * degree, T(0.7));
            for (std::size_t k = 0; k <= degree; ++k) {
                motion.controls.emplace_back();
                draw_motor(random, Regime::scaled, &motion.controls.back().s);
            }
            const std::vector<T> out = sampled(motion, {T(0.1), T(0.7)});
            for (std::size_t c = 0; c < 8; ++c) {
                EXPECT_EQ(out[c], (&motion.controls.front().s)[c]) << "degree " << degree;
                EXPECT_EQ(out[8 + c], (&motion.controls.back().s)[c]) << "degree " << degree;
            }
        }
    }
}

TYPED_TEST(MotionTest, a_linear_motion_is_equation_5)
{
    using T = TypeParam;
    Random random(54);
    Motion<T> motion;
    motion.degree = 1;
    motion.knots = {0, 1};
    motion.controls.resize(2);
    for (auto &control : motion.controls)
        draw_motor(random, Regime::general, &control.s);
    const std::vector<T> out = sampled(motion, {T(0.25)});
    for (std::size_t c = 0; c < 8; ++c)
        EXPECT_NEAR(static_cast<double>(out[c]),
                    0.75 * static_cast<double>((&motion.controls[0].s)[c]) +
                        0.25 * static_cast<double>((&motion.controls[1].s)[c]),
                    static_cast<double>(4 * epsilon<T>));
}

// The motion of the paper's figure 5, its controls made by the API in the paper's order, against the coefficients
// printed there, to their three decimals. (The paper writes e31 in R_y, and e2 e123 = e31: a rotation about e2.)
TYPED_TEST(MotionTest, figure_5_has_the_controls_printed_in_the_paper)
{
    using T = TypeParam;
    using Motor = typename Api<T>::Motor;
    constexpr double pi = 3.14159265358979323846;
    struct Control {
        double z, x, y;         // angles of the rotations, in this order, in units of π
        T offset[3];
        double printed[8];
    };
    const Control controls[] = {
        {0, 0, 0, {1, 1, 0}, {1.000, 0, 0, 0, 0.500, 0.500, 0, 0}},
        {1. / 6, 0, 0, {6, 1, 0}, {0.966, 0.259, 0, 0, 3.027, -0.293, 0, 0}},
        {1. / 2, 0, 0, {8, 4, 2}, {0.707, 0.707, 0, 0, 4.243, -1.414, 0.707, 0.707}},
        {1. / 2, 1. / 4, 0, {8, 6, 4}, {0.653, 0.653, 0.271, 0.271, 5.114, -0.112, -0.588, 1.577}},
        {1. / 2, 0, 1. / 3, {4, 6, 6}, {0.612, 0.612, -0.354, 0.354, 2.001, 1.673, 1.484, 3.605}},
        {1. / 2, 0, 1. / 2, {1, 6, 2}, {0.500, 0.500, -0.500, 0.500, 1.250, 1.750, -0.750, 2.250}}};
    const T e1[] = {1, 0, 0}, e2[] = {0, 1, 0}, e3[] = {0, 0, 1};
    Motion<T> motion;
    motion.degree = 2;
    motion.knots = {0, 0, 1, 2, 3, 4, 4};
    for (const Control &control : controls) {
        Motor pose, factors[3];
        ASSERT_EQ(Api<T>::rotation(&pose, e3, static_cast<T>(control.z * pi), nullptr), MW_OK);
        ASSERT_EQ(Api<T>::rotation(&factors[0], e1, static_cast<T>(control.x * pi), nullptr), MW_OK);
        ASSERT_EQ(Api<T>::rotation(&factors[1], e2, static_cast<T>(control.y * pi), nullptr), MW_OK);
        ASSERT_EQ(Api<T>::translation(&factors[2], control.offset), MW_OK);
        for (const Motor &factor : factors)
            ASSERT_EQ(Api<T>::compose_motor_each(Api<T>::motors_aos(&pose, sizeof pose),
                                                 Api<T>::const_motors_aos(&pose, sizeof pose),
                                                 Api<T>::const_motors_aos(&factor, sizeof factor), 1),
                      MW_OK);
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_NEAR(static_cast<double>((&pose.s)[c]), control.printed[c], 0.0006)
                << "control " << &control - controls << ", component " << c;
        motion.controls.push_back(pose);
    }
    Random random(55);
    expect_matches_reference(motion, parameters_of(random, motion, 50));
}

// Every layout of the result, against a forbidden page, with parameters and motion against pages of their own.
TYPED_TEST(MotionTest, samples_into_every_layout_and_touches_nothing_else)
{
    using T = TypeParam;
    Random random(56);
    const auto motion = random_motion<T>(random, 3, 9, Ends::clamped);
    GuardedBuffer controls(4096), knots(4096), parameters(4096);
    std::vector<GuardedBuffer> out;
    for (int k = 0; k < 8; ++k)
        out.emplace_back(65536);
    for (Guard guard : {Guard::after, Guard::before})
        for (const Layout &layout : Layout::all(8, sizeof(T)))
            for (std::size_t count = 0; count < 70; count = count < 20 ? count + 1 : count + 7) {
                std::vector<T> t = parameters_of(random, motion, 70);
                t.resize(count);
                const std::vector<T> expected = sampled(motion, t);
                auto view = motion.view();
                view.controls = controls.place_copy(view.controls, view.control_count, guard);
                view.knots = knots.place_copy(view.knots, view.knot_count, guard);
                const T *placed = parameters.place_copy(t.data(), count, guard);

                const Placement placement = layout.place(8, count, sizeof(T));
                std::vector<unsigned char *> blocks;
                for (std::size_t size : placement.block_sizes) {
                    blocks.push_back(out[blocks.size()].place(size, guard));
                    std::fill_n(blocks.back(), size, static_cast<unsigned char>(0xa7));
                }
                View<T> motors;
                motors.stride = placement.stride;
                for (const auto &[block, offset] : placement.component)
                    motors.component.push_back(reinterpret_cast<T *>(blocks[block] + offset));
                ASSERT_EQ(Api<T>::sample_bspline(motors.motors(), &view, placed, count), MW_OK);

                for (std::size_t i = 0; i < count; ++i)
                    for (std::size_t c = 0; c < 8; ++c) {
                        auto *address = reinterpret_cast<unsigned char *>(motors.component[c]) + i * motors.stride;
                        ASSERT_EQ(std::memcmp(address, &expected[8 * i + c], sizeof(T)), 0)
                            << layout.name() << ", count " << count << ", element " << i << ", component " << c;
                        std::fill_n(address, sizeof(T), static_cast<unsigned char>(0xa7));
                    }
                for (std::size_t b = 0; b < blocks.size(); ++b)
                    for (std::size_t k = 0; k < placement.block_sizes[b]; ++k)
                        ASSERT_EQ(blocks[b][k], 0xa7) << layout.name() << ", count " << count << ", byte " << k;
            }
}

// A sample does not depend on its neighbours: not on the order of the parameters, nor on how many there are.
TYPED_TEST(MotionTest, samples_do_not_depend_on_one_another)
{
    using T = TypeParam;
    Random random(57);
    const auto motion = random_motion<T>(random, 4, 12, Ends::free);
    const std::vector<T> parameters = parameters_of(random, motion, 100);
    const std::vector<T> together = sampled(motion, parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const std::vector<T> alone = sampled(motion, {parameters[i]});
        ASSERT_EQ(std::memcmp(alone.data(), &together[8 * i], sizeof(T[8])), 0) << "parameter " << parameters[i];
    }
}

TYPED_TEST(MotionTest, samples_agree_within_a_class_of_instruction_sets)
{
    using T = TypeParam;
    Random random(58);
    const auto motion = random_motion<T>(random, 5, 14, Ends::clamped);
    const std::vector<T> parameters = parameters_of(random, motion, 100);
    std::vector<T> of_class[2];
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        const std::vector<T> out = sampled(motion, parameters);
        std::vector<T> &first = of_class[fuses(isa)];
        if (first.empty())
            first = out;
        EXPECT_EQ(std::memcmp(first.data(), out.data(), out.size() * sizeof(T)), 0) << isa;
    }
}

}  // namespace
}  // namespace motorway::testing
