// Velocities, lengths of ways and parameters equally far apart along them: against differences of poses, closed forms
// and integrals of the reference.

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"
#include "screws.h"

namespace motorway::testing {
namespace {

using reference::Real;
using Place = std::array<long double, 3>;

template <class T>
using Point = std::array<T, 3>;

template <class T>
Place exact_place(const Point<T> &point)
{
    return {point[0], point[1], point[2]};
}

long double distance(const Place &a, const Place &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// ------------------------------------------------------------------------------------------------------- references

// Nodes and weights on [-1, 1] of the rule that is exact up to degree 2n - 1: the roots of the Legendre polynomial.
struct Rule {
    std::vector<long double> nodes, weights;

    explicit Rule(int n)
    {
        for (int i = 0; i < n; ++i) {
            long double x = std::cos(pi * (i + 0.75L) / (n + 0.5L)), slope = 0;
            for (int iteration = 0; iteration < 20; ++iteration) {
                long double value = 1, before = 0;
                for (int k = 0; k < n; ++k) {
                    const long double next = ((2 * k + 1) * x * value - k * before) / (k + 1);
                    before = value, value = next;
                }
                slope = n * (x * value - before) / (x * x - 1);
                x -= value / slope;
            }
            nodes.push_back(x);
            weights.push_back(2 / ((1 - x * x) * slope * slope));
        }
    }
};

// The speed of a point, by differences of the eighth order. Each piece of the motion goes on beyond its knots.
long double exact_speed(const reference::Motion &motion, long double t, std::size_t span, const Place &point)
{
    constexpr long double factors[] = {4 / 5.0L, -1 / 5.0L, 4 / 105.0L, -1 / 280.0L};
    const long double step = std::ldexp(motion.span_end(span) - motion.span_begin(span), -11);
    Place velocity{};
    for (int k = 1; k <= 4; ++k) {
        const Place before = apply_point(motion.at(t - k * step, span), point);
        const Place after = apply_point(motion.at(t + k * step, span), point);
        for (std::size_t c = 0; c < 3; ++c)
            velocity[c] += factors[k - 1] / step * (after[c] - before[c]);
    }
    return distance(velocity, {});
}

// Of a part of a span, in halves where the speed comes close to zero.
template <class T>
long double exact_length(const reference::Motion &motion, std::size_t span, long double from, long double to,
                         const Place &point, int depth = 0)
{
    static const Rule rule(16);
    const auto integral = [&](long double begin, long double end) {
        long double sum = 0;
        for (std::size_t k = 0; k < rule.nodes.size(); ++k)
            sum += rule.weights[k] *
                   exact_speed(motion, (begin + end + (end - begin) * rule.nodes[k]) / 2, span, point);
        return sum * (end - begin) / 2;
    };
    const long double middle = (from + to) / 2, halves = integral(from, middle) + integral(middle, to);
    if (depth == 12 || std::abs(halves - integral(from, to)) <= epsilon<T> / 4)
        return halves;
    return exact_length<T>(motion, span, from, middle, point, depth + 1) +
           exact_length<T>(motion, span, middle, to, point, depth + 1);
}

// From the start of the domain to parameters that do not decrease; and the whole.
template <class T>
std::vector<long double> exact_lengths(const reference::Motion &motion, std::vector<T> parameters,
                                       const Point<T> &point)
{
    parameters.push_back(static_cast<T>(motion.last()));
    std::vector<long double> lengths;
    long double sum = 0, from = motion.first();
    for (T to : parameters) {
        for (std::size_t span : motion.spans()) {
            const long double begin = std::max(from, motion.span_begin(span));
            const long double end = std::min<long double>(to, motion.span_end(span));
            if (begin < end)
                sum += exact_length<T>(motion, span, begin, end, exact_place(point));
        }
        from = to;
        lengths.push_back(sum);
    }
    return lengths;
}

// ---------------------------------------------------------------------------------------------------------- motions

template <class T>
typename api<T>::motor translation(T x, T y, T z)
{
    const T offset[] = {x, y, z};
    typename api<T>::motor motor{};
    EXPECT_EQ(api<T>::translation(&motor, offset), MW_OK);
    return motor;
}

// An additive motion of translations alone: a Bézier curve, if knots are left out.
template <class T>
MotionData<T> curve(const std::vector<Point<T>> &points, const std::vector<T> &knots = {}, std::size_t degree = 0)
{
    MotionData<T> data;
    data.degree = degree ? degree : points.size() - 1;
    data.knots = knots;
    for (const Point<T> &p : points)
        data.controls.push_back(translation(p[0], p[1], p[2]));
    return data;
}

// From the identity by a screw about the axis z: in one span, by `angle` and `distance`.
template <class T>
MotionData<T> screw_about_z(long double angle, long double distance)
{
    MotionData<T> data;
    data.kind = MW_MOTION_MULTIPLICATIVE;
    const Screw screw{{Real(0), Real(0), Real(1)}, {}, angle / 2, distance / 2};
    typename api<T>::motor end{};
    round_to(motor_of(screw), &end.s);
    data.controls = {translation<T>(0, 0, 0), end};
    return data;
}

template <class T>
std::vector<T> lengths_of(const CompiledMotion<T> &motion, const Point<T> &point, const std::vector<T> &parameters,
                          std::size_t index = 0)
{
    std::vector<T> lengths(parameters.size());
    const mw_status status = api<T>::motion_lengths(lengths.data(), motion.get(), index, point.data(),
                                                    parameters.data(), parameters.size());
    EXPECT_EQ(status, MW_OK) << mw_status_text(status);
    return lengths;
}

template <class T>
T whole_length(const CompiledMotion<T> &motion, const Point<T> &point)
{
    return lengths_of(motion, point, {motion.last()})[0];
}

template <class T>
std::vector<T> even_parameters_of(const CompiledMotion<T> &motion, const Point<T> &point, std::size_t count,
                                  std::size_t index = 0)
{
    std::vector<T> parameters(count);
    const mw_status status =
        api<T>::motion_even_parameters(parameters.data(), motion.get(), index, point.data(), count);
    EXPECT_EQ(status, MW_OK) << mw_status_text(status);
    return parameters;
}

template <class T>
std::vector<T> spread(T first, T last, std::size_t count)
{
    std::vector<T> all(count, first);
    for (std::size_t i = 1; i < count; ++i)
        all[i] = i + 1 == count ? last : first + (last - first) * static_cast<T>(i) / static_cast<T>(count - 1);
    return all;
}

template <class T>
std::vector<Place> images(const CompiledMotion<T> &motion, const Point<T> &point, const std::vector<T> &parameters)
{
    std::vector<Place> places;
    const std::vector<T> poses = sampled(motion, parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        places.push_back(apply_point(exact_pose(&poses[8 * i]), exact_place(point)));
    return places;
}

// What lengths may be off by: of smooth motions, epsilons of the whole and of the coordinates that it is made of.
template <class T>
long double tolerance(long double whole, long double reach, long double epsilons)
{
    return epsilons * epsilon<T> * (whole + reach) + 4 * underflow<T>;
}

template <class T>
class MotionLengthsTest : public ::testing::Test {};

TYPED_TEST_SUITE(MotionLengthsTest, Precisions, PrecisionName);

// ------------------------------------------------------------------------------------------------------- velocities

// The difference of the places a moment before and after, by the exponentials of the reference.
TYPED_TEST(MotionLengthsTest, a_velocity_is_the_difference_of_places)
{
    using T = TypeParam;
    Random random(151);
    const Real moment(0x1p-30L);
    for (int repetition = 0; repetition < 100; ++repetition) {
        T twist[6], velocity[3];
        Point<T> place;
        for (T &component : twist)
            component = static_cast<T>(random.uniform(-2, 2));
        for (T &component : place)
            component = static_cast<T>(random.uniform(-5, 5));
        ASSERT_EQ(api<T>::twist_velocity(velocity, twist, place.data()), MW_OK);
        const auto image = [&](const Real &time) {
            return reference::apply_point(reference::exp(reference::multiple(time, exact_bivector(twist))),
                                          exact_vector(place.data()));
        };
        const reference::Vector3 before = image(-moment), after = image(moment);
        for (std::size_t k = 0; k < 3; ++k) {
            const Real quotient = (after[k] - before[k]) / (moment + moment);
            EXPECT_NEAR(static_cast<double>(velocity[k]), static_cast<double>(static_cast<long double>(quotient)),
                        static_cast<double>(60 * epsilon<T>));
        }
    }
}

TYPED_TEST(MotionLengthsTest, a_velocity_by_numbers)
{
    using T = TypeParam;
    // One turn of 2 a second from e1 to e2, and 6 along e3. What is on e1 moves along e2; and in place.
    const T twist[6] = {1, 0, 0, 0, 0, 3};
    T place[3] = {5, 0, 0};
    ASSERT_EQ(api<T>::twist_velocity(place, twist, place), MW_OK);
    EXPECT_EQ(place[0], T(0));
    EXPECT_EQ(place[1], T(10));
    EXPECT_EQ(place[2], T(6));
}

TYPED_TEST(MotionLengthsTest, a_velocity_of_nothing)
{
    using T = TypeParam;
    const T twist[6] = {1, 2, 3, 4, 5, 6}, place[3] = {7, 8, 9};
    T velocity[3] = {10, 11, 12};
    EXPECT_EQ(api<T>::twist_velocity(nullptr, twist, place), MW_ERROR_NULL);
    EXPECT_EQ(api<T>::twist_velocity(velocity, nullptr, place), MW_ERROR_NULL);
    EXPECT_EQ(api<T>::twist_velocity(velocity, twist, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(velocity[0], T(10));
    EXPECT_EQ(velocity[1], T(11));
    EXPECT_EQ(velocity[2], T(12));
}

// The twist of the space at the place of the point gives what the places of the exact motion do.
TYPED_TEST(MotionLengthsTest, the_velocity_of_a_point_of_a_motion)
{
    using T = TypeParam;
    Random random(152);
    const Point<T> point = {T(0.5), T(-0.75), T(2)};
    for (mw_motion_kind kind : all_motion_kinds) {
        const auto data = random_motion<T>(random, kind, 3, 7);
        const CompiledMotion<T> motion(data);
        const reference::Motion exact = data.exact();
        const std::vector<T> parameters = parameters_of<T>(random, exact, 20);
        const Twists<T> samples = twisted(motion, parameters);
        const std::vector<Place> places = images(motion, point, parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const long double t = parameters[i], moment = 0x1p-16L;
            const std::size_t span = exact.span_of(t);
            const Place before = apply_point(exact.at(t - moment, span), exact_place(point));
            const Place after = apply_point(exact.at(t + moment, span), exact_place(point));
            T velocity[3], place[3];
            for (std::size_t k = 0; k < 3; ++k)
                place[k] = static_cast<T>(places[i][k]);
            ASSERT_EQ(api<T>::twist_velocity(velocity, &samples.twists[6 * i], place), MW_OK);
            for (std::size_t k = 0; k < 3; ++k)  // the difference is good to the square of the moment
                EXPECT_NEAR(static_cast<double>(velocity[k]),
                            static_cast<double>((after[k] - before[k]) / (2 * moment)),
                            sizeof(T) == sizeof(float) ? 1e-3 : 1e-7)
                    << data.name() << ", parameter " << parameters[i];
        }
    }
}

// ---------------------------------------------------------------------------------------------------------- lengths

TYPED_TEST(MotionLengthsTest, of_a_straight_line)
{
    using T = TypeParam;
    const CompiledMotion<T> motion(curve<T>({{1, 2, 3}, {1, 5, 7}}));
    const std::vector<T> parameters = {0, T(0.125), T(0.25), T(0.5), T(0.5), T(0.75), 1};
    for (const Point<T> &point : {Point<T>{}, Point<T>{7, -8, 9}}) {
        const std::vector<T> lengths = lengths_of(motion, point, parameters);
        EXPECT_EQ(lengths[0], T(0));
        for (std::size_t i = 0; i < parameters.size(); ++i)
            EXPECT_NEAR(static_cast<double>(lengths[i]), 5 * static_cast<double>(parameters[i]),
                        static_cast<double>(5 * epsilon<T>));
    }
}

// There and back again on a line, x(t) = 6t - 10t²: where it turns back, at 0.3, the speed has a kink.
TYPED_TEST(MotionLengthsTest, of_a_line_that_turns_back)
{
    using T = TypeParam;
    const CompiledMotion<T> motion(curve<T>({{0, 0, 0}, {3, 0, 0}, {-4, 0, 0}}));
    const std::vector<T> parameters = spread<T>(0, 1, 41);
    const std::vector<T> lengths = lengths_of(motion, {}, parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const long double t = parameters[i], x = 6 * t - 10 * t * t;
        EXPECT_NEAR(static_cast<double>(lengths[i]), static_cast<double>(t < 0.3L ? x : 1.8L - x),
                    static_cast<double>(tolerance<T>(5.8L, 4, 4)))
            << parameters[i];
    }
}

// A cubic with a cusp: x' = 3 (1 - 2t)², y' = 3 (1 - 2t), in spans of which none has the cusp at a fraction of two.
TYPED_TEST(MotionLengthsTest, of_a_cusp)
{
    using T = TypeParam;
    const auto bezier = curve<T>({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}, {0, 0, 0, T(0.7), T(0.7), T(0.7)});
    const CompiledMotion<T> motion(bezier);
    const std::vector<T> parameters = spread<T>(0, T(0.7), 30);
    const std::vector<T> lengths = lengths_of(motion, {}, parameters);
    // ∫ 3 u √(u² + 1) dt with u = 1 - 2t is (u² + 1)^(3/2) / 2.
    const auto antiderivative = [](long double u) { return std::pow(u * u + 1, 1.5L) / 2; };
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const long double u = 1 - 2 * static_cast<long double>(parameters[i]) / static_cast<long double>(T(0.7));
        const long double before_the_cusp = antiderivative(1) - antiderivative(u);
        const long double expected = u > 0 ? before_the_cusp : 2 * (antiderivative(1) - 0.5L) - before_the_cusp;
        EXPECT_NEAR(static_cast<double>(lengths[i]), static_cast<double>(expected),
                    static_cast<double>(tolerance<T>(2, 1, 4)))
            << parameters[i];
    }
}

// Almost a cusp: the speed comes down to 1e-5 of what it is elsewhere, smoothly.
TYPED_TEST(MotionLengthsTest, of_what_is_almost_a_cusp)
{
    using T = TypeParam;
    // (6t - 10t², ct)
    const T c = T(1e-4);
    const CompiledMotion<T> motion(curve<T>({{0, 0, 0}, {3, c / 2, 0}, {-4, c, 0}}));
    // ∫ √(v² + c²) dt with v = 6 - 20t
    const auto antiderivative = [&](long double t) {
        const long double v = 6 - 20 * t, k = c;
        return -(v * std::hypot(v, k) + k * k * std::asinh(v / k)) / 40;
    };
    EXPECT_NEAR(static_cast<double>(whole_length(motion, Point<T>{})),
                static_cast<double>(antiderivative(1) - antiderivative(0)),
                static_cast<double>(tolerance<T>(5.8L, 4, 4)));
}

TYPED_TEST(MotionLengthsTest, of_circles_and_helices)
{
    using T = TypeParam;
    for (long double rise : {0.0L, 0.25L, 7.0L}) {
        const auto data = screw_about_z<T>(2.5L, rise);
        const CompiledMotion<T> motion(data);
        const std::vector<T> parameters = spread<T>(0, 1, 23);
        for (T radius : {T(0), T(0.5), T(3), T(1000)}) {
            const Point<T> point = {T(0.6) * radius, T(-0.8) * radius, T(4)};
            const std::vector<T> lengths = lengths_of(motion, point, parameters);
            const long double whole = std::hypot(2.5L * std::hypot(point[0], point[1]), rise);
            for (std::size_t i = 0; i < parameters.size(); ++i)
                EXPECT_NEAR(static_cast<double>(lengths[i]), static_cast<double>(whole * parameters[i]),
                            static_cast<double>(tolerance<T>(whole, rise + radius + 4, 6)))
                    << "rise " << rise << ", radius " << radius;
        }
    }
}

// Every kind and degree, over several spans, at all knots and between.
TYPED_TEST(MotionLengthsTest, match_the_reference_for_every_kind)
{
    using T = TypeParam;
    Random random(153);
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t degree : {1, 2, 3, 5})
            for (bool closed : {false, true}) {
                if (closed && (kind == MW_MOTION_GENERATOR || is_of_keys(kind)) && degree > 1)
                    continue;
                auto data = random_motion<T>(random, kind, degree, degree + 4, closed);
                draw_knots(random, data, Ends::clamped, degree);
                const CompiledMotion<T> motion(data);
                const reference::Motion exact = data.exact();
                std::vector<T> parameters = parameters_of<T>(random, exact, 6);
                std::sort(parameters.begin(), parameters.end());
                const Point<T> point = {T(0.5), T(-1.5), T(0.25)};
                const std::vector<T> lengths = lengths_of(motion, point, parameters);
                const std::vector<long double> expected = exact_lengths(exact, parameters, point);
                for (std::size_t i = 0; i < parameters.size(); ++i)
                    ASSERT_NEAR(static_cast<double>(lengths[i]), static_cast<double>(expected[i]),
                                static_cast<double>(tolerance<T>(expected.back(), reach_of(data), 3)))
                        << data.name() << ", parameter " << parameters[i] << " of " << exact.first() << " to "
                        << exact.last();
            }
}

// So late that numbers of T are about the root of an epsilon apart: the nodes of an integral lie between them.
TYPED_TEST(MotionLengthsTest, of_a_motion_at_a_late_time)
{
    using T = TypeParam;
    Random random(154);
    const auto early = random_motion<T>(random, MW_MOTION_ADDITIVE, 3, 4);
    const T begin = std::floor(1 / std::sqrt(std::numeric_limits<T>::epsilon()));
    auto late = early;
    late.knots = {begin, begin, begin, begin + 1, begin + 1, begin + 1};
    const CompiledMotion<T> motion(late);
    const Point<T> point = {T(0.5), T(-1.5), T(0.25)};
    const std::vector<T> parameters = spread<T>(0, 1, 9);
    std::vector<T> later;
    for (T t : parameters)
        later.push_back(begin + t);
    const std::vector<T> lengths = lengths_of(motion, point, later);
    const std::vector<long double> expected = exact_lengths(early.exact(), parameters, point);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        EXPECT_NEAR(static_cast<double>(lengths[i]), static_cast<double>(expected[i]),
                    static_cast<double>(tolerance<T>(expected.back(), reach_of(early), 3)))
            << parameters[i];
}

// Thousands of spans of the same length, which would all round the sum in the same direction.
TYPED_TEST(MotionLengthsTest, of_many_spans)
{
    using T = TypeParam;
    MotionData<T> data;
    constexpr int steps = 5000;
    for (int k = 0; k <= steps; ++k)
        data.controls.push_back(translation<T>(k % 2 ? T(0.1) : T(0), 0, 0));
    const CompiledMotion<T> motion(data);
    const long double whole = static_cast<long double>(T(0.1)) * steps;
    EXPECT_NEAR(static_cast<double>(whole_length(motion, Point<T>{})), static_cast<double>(whole),
                static_cast<double>(whole * 4 * epsilon<T>));
}

// At a knot that is repeated degree + 1 times the motion jumps, which is no part of the way.
TYPED_TEST(MotionLengthsTest, of_a_motion_that_jumps)
{
    using T = TypeParam;
    const CompiledMotion<T> motion(curve<T>({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {5, 2, 0}}, {0, 1, 1, 2}, 1));
    const std::vector<T> lengths = lengths_of(motion, {}, {0, T(0.5), 1, T(1.5), 2});
    const T expected[] = {0, T(0.5), 1, 2, 3};
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(lengths[i], expected[i], static_cast<double>(8 * epsilon<T>)) << i;
    const std::vector<T> parameters = even_parameters_of(motion, {}, 4);
    EXPECT_NEAR(parameters[1], 1, static_cast<double>(8 * epsilon<T>));
    EXPECT_NEAR(parameters[2], 1.5, static_cast<double>(8 * epsilon<T>));
}

// So far away that little more than roundings is left of its speed.
TYPED_TEST(MotionLengthsTest, of_a_short_way_far_away)
{
    using T = TypeParam;
    const T far = T(0x1p-4) / std::numeric_limits<T>::epsilon();
    const CompiledMotion<T> motion(
        curve<T>({{far, 0, 0}, {far + 1, 1, 0}, {far + 2, -1, 0}, {far, 1, 0}, {far + 1, 0, 0}}, {}, 3));
    const T whole = whole_length(motion, Point<T>{});
    EXPECT_GT(whole, T(1));
    EXPECT_LT(whole, T(8));
    const std::vector<T> parameters = even_parameters_of(motion, Point<T>{}, 100);
    EXPECT_TRUE(std::is_sorted(parameters.begin(), parameters.end()));
}

TYPED_TEST(MotionLengthsTest, of_points_that_rest)
{
    using T = TypeParam;
    // On the axis of a rotation; and a body that does not move at all.
    const CompiledMotion<T> turning(screw_about_z<T>(2.5L, 0));
    EXPECT_LE(static_cast<long double>(whole_length(turning, {0, 0, 5})), 16 * epsilon<T>);
    const CompiledMotion<T> resting(curve<T>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
    EXPECT_LE(static_cast<long double>(whole_length(resting, {4, 5, 6})), 16 * epsilon<T>);
}

TYPED_TEST(MotionLengthsTest, of_one_of_many_motions)
{
    using T = TypeParam;
    MotionData<T> data = curve<T>({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {0, 0, 0}, {0, 0, 3}});
    data.degree = 1, data.motion_count = 3;
    const CompiledMotion<T> motion(data);
    for (std::size_t index = 0; index < 3; ++index)
        EXPECT_NEAR(static_cast<double>(lengths_of<T>(motion, {}, {T(0.5)}, index)[0]),
                    static_cast<double>(index + 1) / 2, static_cast<double>(4 * epsilon<T>));
    // Of the points of the second motion, which are even on its own way alone.
    data.controls[3] = data.controls[2];
    const CompiledMotion<T> others(data);
    EXPECT_TRUE(same_bits(even_parameters_of<T>(others, {}, 3, 1), spread<T>(0, 1, 3)));
}

// A length is that of its own parameter, to the last bit, and may take its place.
TYPED_TEST(MotionLengthsTest, do_not_depend_on_one_another)
{
    using T = TypeParam;
    Random random(155);
    const auto data = random_motion<T>(random, MW_MOTION_CUMULATIVE, 3, 9);
    const CompiledMotion<T> motion(data);
    std::vector<T> parameters = parameters_of<T>(random, data.exact(), 1000);
    std::sort(parameters.begin(), parameters.end());
    const Point<T> point = {1, 2, 3};
    const std::vector<T> together = lengths_of(motion, point, parameters);
    for (std::size_t i = 0; i < parameters.size(); i += 37) {
        EXPECT_TRUE(same_bits(lengths_of(motion, point, {parameters[i]}), {together[i]})) << i;
        const std::vector<T> from(parameters.begin() + static_cast<std::ptrdiff_t>(i), parameters.end());
        EXPECT_TRUE(same_bits(lengths_of(motion, point, from),
                              {together.begin() + static_cast<std::ptrdiff_t>(i), together.end()}));
    }
    ASSERT_EQ(api<T>::motion_lengths(parameters.data(), motion.get(), 0, point.data(), parameters.data(),
                                     parameters.size()),
              MW_OK);
    EXPECT_TRUE(same_bits(parameters, together));
}

TYPED_TEST(MotionLengthsTest, agree_within_a_class_of_instruction_sets)
{
    using T = TypeParam;
    Random random(156);
    const auto data = random_motion<T>(random, MW_MOTION_MULTIPLICATIVE, 3, 8);
    const CompiledMotion<T> motion(data);
    const std::vector<T> parameters = spread(motion.first(), motion.last(), 100);
    std::vector<T> lengths[2], even[2];
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        const bool fused = fuses(isa);
        const std::vector<T> some = lengths_of(motion, {1, 2, 3}, parameters);
        const std::vector<T> others = even_parameters_of(motion, {1, 2, 3}, 100);
        if (lengths[fused].empty())
            lengths[fused] = some, even[fused] = others;
        EXPECT_TRUE(same_bits(lengths[fused], some)) << isa;
        EXPECT_TRUE(same_bits(even[fused], others)) << isa;
    }
}

// A point that is not finite has no length, and none is made up.
TYPED_TEST(MotionLengthsTest, of_points_that_are_not_finite)
{
    using T = TypeParam;
    const CompiledMotion<T> motion(screw_about_z<T>(2.5L, 1));
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const std::vector<T> lengths = lengths_of(motion, {nan, 0, 0}, {0, T(0.5), 1});
    EXPECT_TRUE(std::isnan(lengths[1]));
    EXPECT_TRUE(std::isnan(lengths[2]));
    EXPECT_TRUE(same_bits(even_parameters_of(motion, {nan, 0, 0}, 3), {0, T(0.5), 1}));
}

// -------------------------------------------------------------------------------------------------- even parameters

TYPED_TEST(MotionLengthsTest, even_parameters_of_a_straight_line)
{
    using T = TypeParam;
    // x = t² (3 - 2t): slow at both ends.
    const CompiledMotion<T> motion(curve<T>({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}));
    for (std::size_t count : {2, 3, 5, 11, 1000}) {
        const std::vector<T> parameters = even_parameters_of(motion, {}, count);
        EXPECT_EQ(parameters.front(), T(0));
        EXPECT_EQ(parameters.back(), T(1));
        for (std::size_t i = 0; i < count; ++i) {
            const long double t = parameters[i];
            EXPECT_NEAR(static_cast<double>(t * t * (3 - 2 * t)),
                        static_cast<double>(i) / static_cast<double>(count - 1), static_cast<double>(4 * epsilon<T>));
        }
    }
}

// Of every kind, by the lengths of the reference; a parameter is rounded, and its place with it.
TYPED_TEST(MotionLengthsTest, even_parameters_are_equally_far_along_the_way)
{
    using T = TypeParam;
    Random random(157);
    const Point<T> point = {T(0.5), T(-1.5), T(0.25)};
    for (mw_motion_kind kind : all_motion_kinds) {
        auto data = random_motion<T>(random, kind, 3, 7);
        draw_knots(random, data, Ends::clamped, 2);
        const CompiledMotion<T> motion(data);
        const reference::Motion exact = data.exact();
        for (std::size_t count : {2, 3, 14}) {
            const std::vector<T> parameters = even_parameters_of(motion, point, count);
            const std::vector<long double> lengths = exact_lengths(exact, parameters, point);
            EXPECT_EQ(parameters.front(), motion.first());
            EXPECT_EQ(parameters.back(), motion.last());
            for (std::size_t i = 1; i + 1 < count; ++i) {
                const long double t = parameters[i];
                const long double rounding =
                    exact_speed(exact, t, exact.span_of(t), exact_place(point)) * std::abs(t) * epsilon<T>;
                ASSERT_GT(parameters[i], parameters[i - 1]);
                ASSERT_NEAR(static_cast<double>(lengths[i]),
                            static_cast<double>(lengths.back() * i / (count - 1)),
                            static_cast<double>(tolerance<T>(lengths.back(), reach_of(data), 3) + rounding))
                    << data.name() << ", " << i << " of " << count;
            }
        }
    }
}

// What a user sees: points on a circle, equally far from one another, whatever the speed.
TYPED_TEST(MotionLengthsTest, even_parameters_make_equal_chords)
{
    using T = TypeParam;
    // An additive motion of two rotations about z takes a point along a circle, fastest in the middle.
    MotionData<T> data = screw_about_z<T>(3, 0);
    data.kind = MW_MOTION_ADDITIVE;
    const CompiledMotion<T> motion(data);
    const Point<T> point = {2, 0, 1};
    constexpr std::size_t count = 1000;
    const std::vector<Place> places = images(motion, point, even_parameters_of(motion, point, count));
    const long double chord = 4 * std::sin(3.0L / (2 * (count - 1)));
    for (std::size_t i = 1; i < count; ++i)
        ASSERT_NEAR(static_cast<double>(distance(places[i], places[i - 1])), static_cast<double>(chord),
                    static_cast<double>(60 * epsilon<T>));
    // Parameters that are equally far apart would not do.
    const std::vector<Place> uneven = images(motion, point, spread<T>(0, 1, count));
    EXPECT_GT(std::abs(distance(uneven[1], uneven[0]) - chord), 0.2L * chord);
}

// It waits on the way, turns back, and waits at the end.
TYPED_TEST(MotionLengthsTest, even_parameters_never_decrease)
{
    using T = TypeParam;
    const CompiledMotion<T> motion(curve<T>(
        {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-2, 3, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {}, 2));
    for (std::size_t count : {2, 3, 10, 1000}) {
        const std::vector<T> parameters = even_parameters_of(motion, {1, 2, 3}, count);
        EXPECT_EQ(parameters.front(), motion.first());
        EXPECT_EQ(parameters.back(), motion.last());
        EXPECT_TRUE(std::is_sorted(parameters.begin(), parameters.end()));
    }
}

TYPED_TEST(MotionLengthsTest, even_parameters_of_points_that_rest)
{
    using T = TypeParam;
    const CompiledMotion<T> turning(screw_about_z<T>(2.5L, 0));
    EXPECT_TRUE(same_bits(even_parameters_of(turning, {0, 0, 5}, 5), spread<T>(0, 1, 5)));
    const CompiledMotion<T> resting(
        curve<T>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {-1, -1, -1, 3, 3, 3}, 3));
    EXPECT_TRUE(same_bits(even_parameters_of(resting, {4, 5, 6}, 9), spread<T>(-1, 3, 9)));
}

TYPED_TEST(MotionLengthsTest, one_even_parameter_is_the_start)
{
    using T = TypeParam;
    const CompiledMotion<T> moving(curve<T>({{0, 0, 0}, {1, 0, 0}}, {-2, 7}, 1));
    EXPECT_TRUE(same_bits(even_parameters_of(moving, {}, 1), {T(-2)}));
    const CompiledMotion<T> resting(curve<T>({{1, 2, 3}, {1, 2, 3}}, {-2, 7}, 1));
    EXPECT_TRUE(same_bits(even_parameters_of(resting, {}, 1), {T(-2)}));
}

// ----------------------------------------------------------------------------------------------------------- errors

// A call that is to fail must leave its output as it is.
template <class T, class Call>
void expect_error(mw_status status, std::vector<T> &out, Call call)
{
    const std::vector<T> before = out;
    const mw_status got = call();
    EXPECT_EQ(got, status) << mw_status_text(got);
    EXPECT_TRUE(same_bits(before, out)) << "bytes changed";
}

template <class T>
using OtherPrecision = std::conditional_t<std::is_same_v<T, float>, double, float>;

TYPED_TEST(MotionLengthsTest, errors_of_lengths)
{
    using T = TypeParam;
    using Other = OtherPrecision<T>;
    const CompiledMotion<T> motion(curve<T>({{0, 0, 0}, {1, 0, 0}}));
    const CompiledMotion<Other> other(curve<Other>({{0, 0, 0}, {1, 0, 0}}));
    const auto *of_other = reinterpret_cast<const typename api<T>::compiled_motion *>(other.get());
    std::vector<T> out(12, T(-3));
    T *const lengths = out.data(), *const point = out.data() + 4, *const parameters = out.data() + 8;
    const std::vector<T> good = {0, T(0.25), T(0.5), 1};
    std::copy(good.begin(), good.end(), parameters);
    const auto fails = [&](mw_status status, T *to, const typename api<T>::compiled_motion *of, std::size_t index,
                           const T *place, const T *at, std::size_t count) {
        expect_error(status, out, [&] { return api<T>::motion_lengths(to, of, index, place, at, count); });
    };
    fails(MW_OK, nullptr, nullptr, 7, nullptr, nullptr, 0);
    fails(MW_ERROR_NULL, nullptr, motion.get(), 0, point, parameters, 4);
    fails(MW_ERROR_NULL, lengths, nullptr, 0, point, parameters, 4);
    fails(MW_ERROR_NULL, lengths, motion.get(), 0, nullptr, parameters, 4);
    fails(MW_ERROR_NULL, lengths, motion.get(), 0, point, nullptr, 4);
    fails(MW_ERROR_MOTION, lengths, of_other, 0, point, parameters, 4);
    const std::vector<std::uint64_t> zeros(64);
    fails(MW_ERROR_MOTION, lengths, reinterpret_cast<const typename api<T>::compiled_motion *>(zeros.data()), 0, point,
          parameters, 4);
    fails(MW_ERROR_MOTION_INDEX, lengths, motion.get(), 1, point, parameters, 4);
    fails(MW_ERROR_OVERLAP, parameters - 1, motion.get(), 0, point, parameters, 4);
    fails(MW_ERROR_OVERLAP, point + 2, motion.get(), 0, point, parameters, 2);
    fails(MW_ERROR_SIZE, lengths, motion.get(), 0, point, parameters, std::numeric_limits<std::size_t>::max() / 2);
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    for (T bad : {T(0.125), std::nextafter(T(1), T(2)), T(2), T(-1), nan, infinity, -infinity}) {
        parameters[2] = bad;
        fails(MW_ERROR_PARAMETER, lengths, motion.get(), 0, point, parameters, 4);
    }
    parameters[2] = good[2];
    parameters[0] = -std::numeric_limits<T>::denorm_min();
    fails(MW_ERROR_PARAMETER, lengths, motion.get(), 0, point, parameters, 4);
}

TYPED_TEST(MotionLengthsTest, errors_of_even_parameters)
{
    using T = TypeParam;
    using Other = OtherPrecision<T>;
    const CompiledMotion<T> motion(curve<T>({{0, 0, 0}, {1, 0, 0}}));
    const CompiledMotion<Other> other(curve<Other>({{0, 0, 0}, {1, 0, 0}}));
    const auto *of_other = reinterpret_cast<const typename api<T>::compiled_motion *>(other.get());
    std::vector<T> out(8, T(-3));
    T *const parameters = out.data(), *const point = out.data() + 4;
    const auto fails = [&](mw_status status, T *to, const typename api<T>::compiled_motion *of, std::size_t index,
                           const T *place, std::size_t count) {
        expect_error(status, out, [&] { return api<T>::motion_even_parameters(to, of, index, place, count); });
    };
    fails(MW_OK, nullptr, nullptr, 7, nullptr, 0);
    fails(MW_ERROR_NULL, nullptr, motion.get(), 0, point, 4);
    fails(MW_ERROR_NULL, parameters, nullptr, 0, point, 4);
    fails(MW_ERROR_NULL, parameters, motion.get(), 0, nullptr, 4);
    fails(MW_ERROR_MOTION, parameters, of_other, 0, point, 4);
    fails(MW_ERROR_MOTION_INDEX, parameters, motion.get(), 1, point, 4);
    fails(MW_ERROR_OVERLAP, parameters, motion.get(), 0, parameters + 1, 4);
    fails(MW_ERROR_SIZE, parameters, motion.get(), 0, point, std::numeric_limits<std::size_t>::max() / 2);
}

// The motion itself is no place for results.
TYPED_TEST(MotionLengthsTest, results_inside_the_motion)
{
    using T = TypeParam;
    const auto data = curve<T>({{0, 0, 0}, {1, 0, 0}});
    const CompiledMotion<T> motion(data);
    std::vector<std::uint64_t> copy(motion.size() / 8 + 1);
    std::memcpy(copy.data(), motion.get(), motion.size());
    const std::vector<std::uint64_t> before = copy;
    const auto *moved = reinterpret_cast<const typename api<T>::compiled_motion *>(copy.data());
    T *const inside = reinterpret_cast<T *>(copy.data()) + motion.size() / sizeof(T) - 1;
    const Point<T> point = {};
    const T parameter = 1;
    EXPECT_EQ(api<T>::motion_lengths(inside, moved, 0, point.data(), &parameter, 1), MW_ERROR_OVERLAP);
    EXPECT_EQ(api<T>::motion_even_parameters(inside, moved, 0, point.data(), 1), MW_ERROR_OVERLAP);
    EXPECT_EQ(copy, before);
}

}  // namespace
}  // namespace motorway::testing
