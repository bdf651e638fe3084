// Additive motions written with more controls: with a knot inserted, of a higher degree, in two parts. They must be
// the same motions, in the exact numbers of the reference, and stay within the arrays they are given.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "motion_room.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

template <class T>
MotionData<T> data_of(const typename api<T>::motion &motion)
{
    EXPECT_EQ(motion.kind, MW_MOTION_ADDITIVE);
    EXPECT_EQ(motion.weights, nullptr);
    EXPECT_EQ(motion.base, nullptr);
    EXPECT_EQ(motion.closed, 0);
    EXPECT_LE(motion.motion_count, 1u);
    MotionData<T> data;
    data.degree = motion.degree;
    data.controls.assign(motion.controls, motion.controls + motion.control_count);
    data.knots.assign(motion.knots, motion.knots + motion.knot_count);
    std::size_t size;
    const auto view = data.view();
    EXPECT_EQ(api<T>::motion_size(&size, &view, nullptr), MW_OK) << data.name();
    return data;
}

// Asks what an edit takes, gives it just that, and returns what it makes.
template <class T, class Edit>
MotionData<T> edited(const Edit &edit, Guard guard = Guard::after)
{
    typename api<T>::motion out{};
    EXPECT_EQ(edit(&out, typename api<T>::motion_arrays{}), MW_ERROR_MEMORY);
    Room<T> room(out, guard);
    const std::size_t controls = out.control_count, knots = out.knot_count;
    EXPECT_EQ(edit(&out, room.arrays), MW_OK);
    EXPECT_TRUE(room.is_untouched_elsewhere());
    EXPECT_EQ(out.controls, room.arrays.controls);
    EXPECT_EQ(out.knots, room.arrays.knots);
    EXPECT_EQ(out.control_count, controls);
    EXPECT_EQ(out.knot_count, knots);
    return data_of<T>(out);
}

template <class T>
MotionData<T> with_knot(const MotionData<T> &data, T knot, unsigned times)
{
    const auto motion = data.view();
    return edited<T>([&](auto *out, auto arrays) { return api<T>::insert_knot(out, arrays, &motion, knot, times); });
}

template <class T>
MotionData<T> elevated(const MotionData<T> &data)
{
    const auto motion = data.view();
    return edited<T>([&](auto *out, auto arrays) { return api<T>::elevate_degree(out, arrays, &motion); });
}

template <class T>
struct Parts {
    MotionData<T> before, after;
};

template <class T>
Parts<T> split(const MotionData<T> &data, T at, Guard guard = Guard::after)
{
    const auto motion = data.view();
    typename api<T>::motion before{}, after{};
    EXPECT_EQ(api<T>::split_motion(&before, {}, &after, {}, &motion, at), MW_ERROR_MEMORY);
    Room<T> before_room(before, guard), after_room(after, guard);
    EXPECT_EQ(api<T>::split_motion(&before, before_room.arrays, &after, after_room.arrays, &motion, at), MW_OK);
    EXPECT_TRUE(before_room.is_untouched_elsewhere() && after_room.is_untouched_elsewhere());
    return {data_of<T>(before), data_of<T>(after)};
}

template <class T>
std::vector<T> knots_of(const MotionData<T> &data)
{
    if (!data.knots.empty())
        return data.knots;
    const auto knots = reference::default_knots(data.kind, data.degree, data.control_count(), false);
    return {knots.begin(), knots.end()};
}

// The largest number that each coordinate has in the controls of a span, none of which a sample can exceed.
std::array<long double, 8> magnitudes(const reference::Motion &motion, std::size_t span)
{
    std::array<long double, 8> largest{};
    for (const auto &control : motion.controls_of(span)) {
        const auto numbers = motor_numbers(control);
        for (std::size_t c = 0; c < 8; ++c)
            largest[c] = std::max(largest[c], std::abs(numbers[c]));
    }
    return largest;
}

// A control is rounded once to T, and made before by `steps` weighted means in double. A weight has three roundings,
// its product and the sum two more, each of half an epsilon; with the weights w_k multiplied in that is one more.
template <class T>
long double tolerance(std::size_t steps)
{
    const long double in_double = 3 * static_cast<long double>(steps) + 1;
    return epsilon<T> / 2 + in_double * epsilon<double>;
}

template <class T>
void expect_same(const MotionData<T> &data, const MotionData<T> &expected, const std::vector<T> &parameters,
                 std::size_t steps)
{
    const reference::Motion motion = data.exact(0, MW_KEEP_SIGNS), exact = expected.exact(0, MW_KEEP_SIGNS);
    for (T t : parameters) {
        const auto numbers = motor_numbers(motion.at(t)), wanted = motor_numbers(exact.at(t));
        const auto largest = magnitudes(exact, exact.span_of(t));
        for (std::size_t c = 0; c < 8; ++c)
            ASSERT_LE(std::abs(numbers[c] - wanted[c]), tolerance<T>(steps) * largest[c])
                << expected.name() << ", parameter " << t << ", coordinate " << c;
    }
}

template <class T>
class MotionEditTest : public ::testing::Test {
protected:
    // Every kind of knots there is, with and without weights.
    static MotionData<T> draw(Random &random, std::size_t degree)
    {
        MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 1 + random.below(8));
        if (!random.chance(4))
            draw_knots(random, data, random.chance(2) ? Ends::clamped : Ends::free, 1 + random.below(degree + 1));
        if (random.chance(2))
            for (std::size_t k = 0; k < data.controls.size(); ++k)
                data.weights.push_back(static_cast<T>(random.uniform(0.25, 4)));
        if (random.chance(3))  // signs are kept
            for (T *number = &data.controls[1].s; number <= &data.controls[1].w; ++number)
                *number = -*number;
        return data;
    }

    static T begin_of(const MotionData<T> &data) { return knots_of(data)[data.degree - 1]; }
    static T end_of(const MotionData<T> &data) { return knots_of(data)[data.control_count() - 1]; }
    static std::size_t repeats(const MotionData<T> &data, T knot)
    {
        const std::vector<T> knots = knots_of(data);
        return static_cast<std::size_t>(std::count(knots.begin(), knots.end(), knot));
    }

    // Inside the domain: a knot of the motion, if it has one there, or any other number.
    static T draw_inside(Random &random, const MotionData<T> &data)
    {
        const std::vector<T> knots = knots_of(data);
        const T knot = knots[random.below(knots.size())];
        if (begin_of(data) < knot && knot < end_of(data))
            return knot;
        const double t = random.uniform(static_cast<double>(begin_of(data)), static_cast<double>(end_of(data)));
        return std::clamp(static_cast<T>(t), std::nextafter(begin_of(data), end_of(data)),
                          std::nextafter(end_of(data), begin_of(data)));
    }

    static std::vector<T> parameters(Random &random, const MotionData<T> &data)
    {
        return parameters_of<T>(random, data.exact(0, MW_KEEP_SIGNS), 20);
    }
};

TYPED_TEST_SUITE(MotionEditTest, Precisions, PrecisionName);

// ------------------------------------------------------------------------------------------------------ inserting

TYPED_TEST(MotionEditTest, inserting_a_knot_keeps_the_motion)
{
    using T = TypeParam;
    Random random(301);
    for (std::size_t degree = 1; degree <= 7; ++degree)
        for (int repetition = 0; repetition < 60; ++repetition) {
            const auto data = this->draw(random, degree);
            const T knot = this->draw_inside(random, data);
            const std::size_t room = degree + 1 - this->repeats(data, knot);
            const auto times = static_cast<unsigned>(random.below(room + 1));
            const auto result = with_knot(data, knot, times);
            ASSERT_EQ(result.degree, degree);
            ASSERT_EQ(result.control_count(), data.control_count() + times);
            std::vector<T> knots = knots_of(data);
            knots.insert(std::lower_bound(knots.begin(), knots.end(), knot), times, knot);
            ASSERT_EQ(result.knots, knots);
            expect_same(result, data, this->parameters(random, data), degree);
            if (this->HasFatalFailure())
                return;
        }
}

// Boehm: only controls around the new knot change.
TYPED_TEST(MotionEditTest, controls_away_from_a_new_knot_are_copied)
{
    using T = TypeParam;
    Random random(302);
    for (std::size_t degree = 1; degree <= 7; ++degree) {
        MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 12);
        const std::vector<T> knots = knots_of(data);
        const std::size_t span = degree + 3;
        const T knot = (knots[span] + knots[span + 1]) / 2;
        const auto result = with_knot(data, knot, 1);
        for (std::size_t k = 0; k < result.controls.size(); ++k) {
            const bool comes_before = k + degree - 1 <= span, comes_after = k > span + 1;
            if (comes_before || comes_after) {
                const auto &source = data.controls[comes_before ? k : k - 1];
                ASSERT_EQ(std::memcmp(&result.controls[k], &source, sizeof source), 0) << k;
            }
        }
    }
}

// A knot that is there as often as the degree is where the motion passes through a control, and one more time a jump
// between two equal ones.
TYPED_TEST(MotionEditTest, a_knot_inserted_as_often_as_it_can_be_gives_the_pose_there)
{
    using T = TypeParam;
    Random random(303);
    for (std::size_t degree = 1; degree <= 7; ++degree) {
        const MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 5);
        const T knot = T(2.25);
        const auto result = with_knot(data, knot, static_cast<unsigned>(degree + 1));
        const std::size_t k = static_cast<std::size_t>(
            std::find(result.knots.begin(), result.knots.end(), knot) - result.knots.begin());
        EXPECT_EQ(std::memcmp(&result.controls[k], &result.controls[k + 1], sizeof result.controls[k]), 0);
        const reference::Motion exact = data.exact(0, MW_KEEP_SIGNS);
        const auto pose = motor_numbers(exact.at(knot)), largest = magnitudes(exact, exact.span_of(knot));
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_LE(std::abs((&result.controls[k].s)[c] - pose[c]), tolerance<T>(degree) * largest[c]) << degree;
    }
}

// Chaikin's corners: of a quadratic motion with even knots, a knot halfway.
TYPED_TEST(MotionEditTest, a_knot_in_a_quadratic_motion_cuts_corners_at_a_quarter)
{
    using T = TypeParam;
    MotionData<T> data;
    data.degree = 2;
    data.knots = {-1, 0, 1, 2};
    data.controls = {{8, 16, 0, -8, 4, 0, 32, 8}, {16, 0, 8, 8, -4, 8, 0, 0}, {0, 24, 8, -16, 8, 0, 16, 40}};
    const auto result = with_knot(data, T(0.5), 1);
    ASSERT_EQ(result.knots, (std::vector<T>{-1, 0, T(0.5), 1, 2}));
    ASSERT_EQ(result.controls.size(), 4u);
    for (std::size_t c = 0; c < 8; ++c) {
        const T a = (&data.controls[0].s)[c], b = (&data.controls[1].s)[c], d = (&data.controls[2].s)[c];
        EXPECT_EQ((&result.controls[0].s)[c], a);
        EXPECT_EQ((&result.controls[1].s)[c], (a + 3 * b) / 4);
        EXPECT_EQ((&result.controls[2].s)[c], (3 * b + d) / 4);
        EXPECT_EQ((&result.controls[3].s)[c], d);
    }
}

// ------------------------------------------------------------------------------------------------------ elevating

// Each control is the mean of up to d + 1 blossoms.
TYPED_TEST(MotionEditTest, elevating_the_degree_keeps_the_motion)
{
    using T = TypeParam;
    Random random(304);
    for (std::size_t degree = 1; degree <= 7; ++degree)
        for (int repetition = 0; repetition < 60; ++repetition) {
            const auto data = this->draw(random, degree);
            const auto result = elevated(data);
            ASSERT_EQ(result.degree, degree + 1);
            ASSERT_EQ(this->begin_of(result), this->begin_of(data));
            ASSERT_EQ(this->end_of(result), this->end_of(data));
            for (T knot : knots_of(data))
                if (knot >= this->begin_of(data) && knot <= this->end_of(data)) {
                    ASSERT_EQ(this->repeats(result, knot), this->repeats(data, knot) + 1);
                }
            expect_same(result, data, this->parameters(random, data), 2 * degree + 1);
            if (this->HasFatalFailure())
                return;
        }
}

TYPED_TEST(MotionEditTest, the_degree_is_elevated_up_to_the_highest)
{
    using T = TypeParam;
    Random random(305);
    MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, 1, 3), result = data;
    std::size_t steps = 0;
    while (result.degree < MW_MAX_DEGREE) {
        steps += 2 * result.degree + 1;
        result = elevated(result);
    }
    EXPECT_EQ(result.control_count(), 2u * MW_MAX_DEGREE + 1);
    // Each result is rounded to T on its way.
    const reference::Motion motion = result.exact(0, MW_KEEP_SIGNS), exact = data.exact(0, MW_KEEP_SIGNS);
    for (T t : this->parameters(random, data)) {
        const auto numbers = motor_numbers(motion.at(t)), wanted = motor_numbers(exact.at(t));
        const auto largest = magnitudes(exact, exact.span_of(t));
        for (std::size_t c = 0; c < 8; ++c)
            ASSERT_LE(std::abs(numbers[c] - wanted[c]),
                      (MW_MAX_DEGREE * epsilon<T> / 2 + 3 * steps * epsilon<double>)*largest[c]);
    }
}

// Bézier: (a, b) is (a, ½a + ½b, b), and (a, b, c) is (a, ⅓a + ⅔b, ⅔b + ⅓c, c). Ends are copied.
TYPED_TEST(MotionEditTest, bezier_motions_are_elevated_as_by_hand)
{
    using T = TypeParam;
    MotionData<T> line;
    line.controls = {{2, 4, -6, 8, 10, 0, 12, 2}, {4, -2, 6, 0, 2, 8, -4, 6}};
    const auto quadratic = elevated(line);
    ASSERT_EQ(quadratic.knots, (std::vector<T>{0, 0, 1, 1}));
    const auto cubic = elevated(quadratic);
    ASSERT_EQ(cubic.knots, (std::vector<T>{0, 0, 0, 1, 1, 1}));
    for (std::size_t c = 0; c < 8; ++c) {
        const T a = (&line.controls[0].s)[c], b = (&line.controls[1].s)[c], middle = (&quadratic.controls[1].s)[c];
        EXPECT_EQ((&quadratic.controls[0].s)[c], a);
        EXPECT_EQ(middle, (a + b) / 2);
        EXPECT_EQ((&quadratic.controls[2].s)[c], b);
        EXPECT_EQ((&cubic.controls[0].s)[c], a);
        const double size = std::abs(static_cast<double>(a)) + std::abs(static_cast<double>(b));
        const double few = 2 * static_cast<double>(epsilon<T>) * size;
        EXPECT_NEAR(static_cast<double>((&cubic.controls[1].s)[c]), static_cast<double>(a + 2 * middle) / 3, few);
        EXPECT_NEAR(static_cast<double>((&cubic.controls[2].s)[c]), static_cast<double>(2 * middle + b) / 3, few);
        EXPECT_EQ((&cubic.controls[3].s)[c], b);
    }
}

// ------------------------------------------------------------------------------------------------------ splitting

TYPED_TEST(MotionEditTest, the_parts_of_a_motion_are_the_motion)
{
    using T = TypeParam;
    Random random(306);
    for (std::size_t degree = 1; degree <= 7; ++degree)
        for (int repetition = 0; repetition < 60; ++repetition) {
            const auto data = this->draw(random, degree);
            const T at = this->draw_inside(random, data);
            const auto parts = split(data, at, random.chance(2) ? Guard::after : Guard::before);
            ASSERT_EQ(this->begin_of(parts.before), this->begin_of(data));
            ASSERT_EQ(this->end_of(parts.before), at);
            ASSERT_EQ(this->begin_of(parts.after), at);
            ASSERT_EQ(this->end_of(parts.after), this->end_of(data));
            std::vector<T> before, after = {at};
            for (T t : this->parameters(random, data))
                (t < at ? before : after).push_back(t);
            expect_same(parts.before, data, before, degree);
            expect_same(parts.after, data, after, degree);
            if (this->HasFatalFailure())
                return;
        }
}

// Both parts are clamped where they meet: the last control of the one and the first of the other are the pose there,
// and they differ only if the motion jumps.
TYPED_TEST(MotionEditTest, parts_meet_in_a_control)
{
    using T = TypeParam;
    Random random(307);
    for (std::size_t degree = 1; degree <= 7; ++degree)
        for (bool jumps : {false, true}) {
            MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, 2 * degree + 2);
            data.knots.assign(degree, T(0));
            data.knots.insert(data.knots.end(), degree + 1, jumps ? T(2) : T(1));
            data.knots.insert(data.knots.end(), degree, T(3));
            if (!jumps)
                data.knots[2 * degree] = T(2);  // 1 as often as the degree, and then 2
            const auto &a = data.controls[degree], &b = data.controls[degree + 1];
            const auto parts = split(data, jumps ? T(2) : T(1));
            EXPECT_EQ(std::memcmp(&parts.before.controls.back(), &a, sizeof a), 0);
            EXPECT_EQ(std::memcmp(&parts.after.controls.front(), jumps ? &b : &a, sizeof a), 0);
            EXPECT_EQ(std::count(parts.before.knots.begin(), parts.before.knots.end(), parts.before.knots.back()),
                      static_cast<std::ptrdiff_t>(degree));
            EXPECT_EQ(std::count(parts.after.knots.begin(), parts.after.knots.end(), parts.after.knots.front()),
                      static_cast<std::ptrdiff_t>(degree));
        }
}

// De Casteljau at ½, with numbers that are exact.
TYPED_TEST(MotionEditTest, bezier_motions_are_split_as_by_hand)
{
    using T = TypeParam;
    MotionData<T> line;
    line.controls = {{2, 4, -6, 8, 10, 0, 12, 2}, {4, -2, 6, 0, 2, 8, -4, 6}};
    const auto halves = split(line, T(0.5));
    EXPECT_EQ(halves.before.knots, (std::vector<T>{0, T(0.5)}));
    EXPECT_EQ(halves.after.knots, (std::vector<T>{T(0.5), 1}));
    MotionData<T> parabola;
    parabola.degree = 2;
    parabola.controls = {{8, 16, 0, -8, 4, 0, 32, 8}, {16, 0, 8, 8, -4, 8, 0, 0}, {0, 24, 8, -16, 8, 0, 16, 40}};
    const auto arcs = split(parabola, T(0.5));
    EXPECT_EQ(arcs.before.knots, (std::vector<T>{0, 0, T(0.5), T(0.5)}));
    EXPECT_EQ(arcs.after.knots, (std::vector<T>{T(0.5), T(0.5), 1, 1}));
    for (std::size_t c = 0; c < 8; ++c) {
        const auto expect = [&](const MotionData<T> &motion, const std::vector<T> &controls) {
            ASSERT_EQ(motion.controls.size(), controls.size());
            for (std::size_t k = 0; k < controls.size(); ++k)
                EXPECT_EQ((&motion.controls[k].s)[c], controls[k]) << "control " << k << ", coordinate " << c;
        };
        const T p = (&line.controls[0].s)[c], q = (&line.controls[1].s)[c];
        expect(halves.before, {p, (p + q) / 2});
        expect(halves.after, {(p + q) / 2, q});
        const T a = (&parabola.controls[0].s)[c], b = (&parabola.controls[1].s)[c], d = (&parabola.controls[2].s)[c];
        expect(arcs.before, {a, (a + b) / 2, (a + 2 * b + d) / 4});
        expect(arcs.after, {(a + 2 * b + d) / 4, (b + d) / 2, d});
    }
}

// ----------------------------------------------------------------------------------------------------- in general

// The library's own samples of both, which are those of one motion to the rounding of a sample: 3.5 (d + 1) epsilons.
TYPED_TEST(MotionEditTest, compiled_motions_agree)
{
    using T = TypeParam;
    Random random(308);
    for (std::size_t degree = 1; degree <= 5; ++degree) {
        MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 6);
        draw_knots(random, data, Ends::clamped, degree);
        const CompiledMotion<T> original(data, MW_KEEP_SIGNS);
        const std::vector<T> parameters = this->parameters(random, data);
        const std::vector<T> expected = sampled(original, parameters);
        for (const auto &result : {with_knot(data, this->draw_inside(random, data), 1), elevated(data)}) {
            const std::vector<T> samples = sampled(CompiledMotion<T>(result, MW_KEEP_SIGNS), parameters);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                const reference::Motion exact = data.exact(0, MW_KEEP_SIGNS);
                const auto largest = magnitudes(exact, exact.span_of(parameters[i / 8]));
                ASSERT_LE(std::abs(static_cast<long double>(samples[i]) - expected[i]),
                          8 * (degree + 2) * epsilon<T> * largest[i % 8])
                    << result.name() << ", parameter " << parameters[i / 8];
            }
        }
    }
}

TYPED_TEST(MotionEditTest, a_result_may_be_described_where_the_motion_was)
{
    using T = TypeParam;
    Random random(309);
    const MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, 3, 6);
    const auto expected = with_knot(data, T(1.5), 1);
    Room<T> room(expected.controls.size(), expected.knots.size());
    auto motion = data.view();
    ASSERT_EQ(api<T>::insert_knot(&motion, room.arrays, &motion, T(1.5), 1), MW_OK);
    const auto result = data_of<T>(motion);
    EXPECT_EQ(result.knots, expected.knots);
    const std::size_t bytes = sizeof(T[8]) * expected.controls.size();
    EXPECT_EQ(std::memcmp(result.controls.data(), expected.controls.data(), bytes), 0);
}

// --------------------------------------------------------------------------------------------------------- errors

// A motion that can be edited, arrays with room for that, and every edit with what it must return. Nothing is
// written.
template <class T>
class Bench {
public:
    using A = api<T>;

    Bench() : rooms{{100, 100}, {100, 100}}
    {
        Random random(310);
        data = random_motion<T>(random, MW_MOTION_ADDITIVE, 3, 8);
        data.knots = {0, 0, 0, 1, 2, 2, 4, 5, 5, 5};
        data.weights.assign(8, T(1));
        motion = data.view();
        before = rooms[0].arrays;
        after = rooms[1].arrays;
    }

    mw_status insert(T knot = T(1.5), unsigned times = 1)
    {
        return A::insert_knot(&out, before, &motion, knot, times);
    }
    mw_status elevate() { return A::elevate_degree(&out, before, &motion); }
    mw_status split(T at = T(1.5)) { return A::split_motion(&out, before, &second, after, &motion, at); }

    bool is_untouched()
    {
        const typename A::motion none{};
        return rooms[0].is_untouched() && rooms[1].is_untouched() && std::memcmp(&out, &none, sizeof out) == 0 &&
               std::memcmp(&second, &none, sizeof second) == 0;
    }

    MotionData<T> data;
    typename A::motion motion, out{}, second{};
    typename A::motion_arrays before, after;
    Room<T> rooms[2];
};

template <class T, class Spoil>
void expect_from_all(mw_status status, const char *what, const Spoil &spoil)
{
    Bench<T> insert, elevate, split;
    spoil(insert), spoil(elevate), spoil(split);
    EXPECT_EQ(insert.insert(), status) << what;
    EXPECT_EQ(elevate.elevate(), status) << what;
    EXPECT_EQ(split.split(), status) << what;
    EXPECT_TRUE(insert.is_untouched() && elevate.is_untouched() && split.is_untouched()) << what;
}

TYPED_TEST(MotionEditTest, descriptions_are_checked)
{
    using T = TypeParam;
    const auto expect = [](mw_status status, const char *what, void (*spoil)(Bench<T> &)) {
        expect_from_all<T>(status, what, spoil);
    };
    expect(MW_ERROR_NULL, "no controls", [](Bench<T> &b) { b.motion.controls = nullptr; });
    expect(MW_ERROR_NULL, "no knots", [](Bench<T> &b) { b.motion.knots = nullptr; });
    expect(MW_ERROR_NULL, "no array of controls", [](Bench<T> &b) { b.before.controls = nullptr; });
    expect(MW_ERROR_NULL, "no array of knots", [](Bench<T> &b) { b.before.knots = nullptr; });
    expect(MW_ERROR_MOTION_KIND, "kind 0", [](Bench<T> &b) { b.motion.kind = static_cast<mw_motion_kind>(0); });
    expect(MW_ERROR_MOTION_KIND, "cumulative",
           [](Bench<T> &b) { b.motion.kind = MW_MOTION_CUMULATIVE, b.motion.weights = nullptr; });
    expect(MW_ERROR_MOTION_KIND, "closed",
           [](Bench<T> &b) { b.motion.closed = 1, b.motion.knots = nullptr, b.motion.knot_count = 0; });
    expect(MW_ERROR_MOTION_KIND, "two motions", [](Bench<T> &b) { b.motion.motion_count = 2; });
    expect(MW_ERROR_DEGREE, "degree 0", [](Bench<T> &b) { b.motion.degree = 0; });
    expect(MW_ERROR_DEGREE, "degree 32", [](Bench<T> &b) { b.motion.degree = 32; });
    expect(MW_ERROR_CONTROL_COUNT, "three controls", [](Bench<T> &b) { b.motion.control_count = 3; });
    expect(MW_ERROR_KNOT_COUNT, "a knot too few", [](Bench<T> &b) { --b.motion.knot_count; });
    expect(MW_ERROR_KNOTS, "knots that decrease", [](Bench<T> &b) { b.data.knots[4] = T(0.5); });
    expect(MW_ERROR_WEIGHTS, "weight 0", [](Bench<T> &b) { b.data.weights[2] = 0; });
    expect(MW_ERROR_OVERLAP, "controls in place",
           [](Bench<T> &b) { b.before.controls = const_cast<typename api<T>::motor *>(b.motion.controls); });
    expect(MW_ERROR_OVERLAP, "knots in place", [](Bench<T> &b) { b.before.knots = const_cast<T *>(b.motion.knots); });
    expect(MW_ERROR_OVERLAP, "knots on the weights",
           [](Bench<T> &b) { b.before.knots = const_cast<T *>(b.motion.weights); });
    expect(MW_ERROR_OVERLAP, "knots on the new controls",
           [](Bench<T> &b) { b.before.knots = reinterpret_cast<T *>(b.before.controls) + 3; });
}

TYPED_TEST(MotionEditTest, a_description_and_a_place_for_the_result_are_needed)
{
    using T = TypeParam;
    using A = api<T>;
    Bench<T> b;
    EXPECT_EQ(A::insert_knot(nullptr, b.before, &b.motion, T(1.5), 1), MW_ERROR_NULL);
    EXPECT_EQ(A::insert_knot(&b.out, b.before, nullptr, T(1.5), 1), MW_ERROR_NULL);
    EXPECT_EQ(A::elevate_degree(nullptr, b.before, &b.motion), MW_ERROR_NULL);
    EXPECT_EQ(A::elevate_degree(&b.out, b.before, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(A::split_motion(nullptr, b.before, &b.second, b.after, &b.motion, T(1.5)), MW_ERROR_NULL);
    EXPECT_EQ(A::split_motion(&b.out, b.before, nullptr, b.after, &b.motion, T(1.5)), MW_ERROR_NULL);
    EXPECT_EQ(A::split_motion(&b.out, b.before, &b.second, b.after, nullptr, T(1.5)), MW_ERROR_NULL);
    b.after.controls = nullptr;
    EXPECT_EQ(b.split(), MW_ERROR_NULL);
    b.after = b.rooms[1].arrays;
    b.after.controls = b.before.controls;
    EXPECT_EQ(b.split(), MW_ERROR_OVERLAP);
    EXPECT_TRUE(b.is_untouched());
}

TYPED_TEST(MotionEditTest, a_knot_must_be_inside_the_domain_and_have_room)
{
    using T = TypeParam;
    const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    Bench<T> b;
    for (T outside : {T(0), T(5), T(-1), T(6), -infinity, infinity, nan}) {
        EXPECT_EQ(b.insert(outside), MW_ERROR_PARAMETER) << outside;
        EXPECT_EQ(b.split(outside), MW_ERROR_PARAMETER) << outside;
    }
    EXPECT_EQ(b.insert(T(1.5), 5), MW_ERROR_KNOTS);
    EXPECT_EQ(b.insert(T(2), 3), MW_ERROR_KNOTS);
    EXPECT_EQ(b.insert(T(2), std::numeric_limits<unsigned>::max()), MW_ERROR_KNOTS);
    // Knots that are not equal are a normal number apart.
    b.data.knots = {0, 0, 0, std::numeric_limits<T>::min(), 2, 2, 4, 5, 5, 5};
    EXPECT_EQ(b.insert(std::numeric_limits<T>::min() / 2), MW_ERROR_KNOTS);
    EXPECT_EQ(b.split(std::numeric_limits<T>::min() / 2), MW_ERROR_KNOTS);
    EXPECT_EQ(b.insert(std::numeric_limits<T>::min() * T(1.5)), MW_ERROR_KNOTS);
    EXPECT_TRUE(b.is_untouched());
    EXPECT_EQ(b.insert(std::numeric_limits<T>::min(), 3), MW_OK);
}

// The numbers of controls and knots are given, whichever of the arrays is too small, and nothing else is written.
TYPED_TEST(MotionEditTest, arrays_that_are_too_small_are_told_what_they_need)
{
    using T = TypeParam;
    Bench<T> b;
    const auto expect = [&](const typename api<T>::motion &out, std::size_t controls, std::size_t knots) {
        EXPECT_EQ(out.control_count, controls);
        EXPECT_EQ(out.knot_count, knots);
        EXPECT_TRUE(b.rooms[0].is_untouched() && b.rooms[1].is_untouched());
    };
    b.before.control_capacity = 9;
    EXPECT_EQ(b.insert(T(1.5), 2), MW_ERROR_MEMORY);
    expect(b.out, 10, 12);
    b.before.control_capacity = 10, b.before.knot_capacity = 11;
    EXPECT_EQ(b.insert(T(1.5), 2), MW_ERROR_MEMORY);
    expect(b.out, 10, 12);
    EXPECT_EQ(b.elevate(), MW_ERROR_MEMORY);  // each of five knots once more
    expect(b.out, 12, 15);
    b.before = b.rooms[0].arrays;
    b.after.control_capacity = 3;
    EXPECT_EQ(b.split(T(4)), MW_ERROR_MEMORY);
    expect(b.out, 7, 9);
    expect(b.second, 4, 6);
}

TYPED_TEST(MotionEditTest, the_highest_degree_is_not_elevated)
{
    using T = TypeParam;
    Random random(311);
    const MotionData<T> data = random_motion<T>(random, MW_MOTION_ADDITIVE, MW_MAX_DEGREE, MW_MAX_DEGREE + 1);
    const auto motion = data.view();
    typename api<T>::motion out{};
    Room<T> room(100, 100);
    EXPECT_EQ(api<T>::elevate_degree(&out, room.arrays, &motion), MW_ERROR_DEGREE);
    EXPECT_TRUE(room.is_untouched());
}

}  // namespace
}  // namespace motorway::testing
