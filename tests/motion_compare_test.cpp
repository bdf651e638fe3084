// The largest distance between two motions: known ones, and against every sample and point looked at on its own.

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "layout.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

template <class T>
using Compiled = const typename api<T>::compiled_motion *;
template <class T>
using Distance = typename api<T>::motion_distance;

template <class T>
typename api<T>::const_xyz packed(const std::vector<T> &points)
{
    return api<T>::const_xyz_aos(points.data(), sizeof(T[3]));
}

template <class T>
Distance<T> compared(const CompiledMotion<T> &first, const CompiledMotion<T> &second, const std::vector<T> &points,
                     std::size_t samples)
{
    Distance<T> largest{};
    const mw_status status = api<T>::compare_motions(&largest, first.get(), 0, second.get(), 0, packed(points),
                                                     points.size() / 3, samples);
    EXPECT_EQ(status, MW_OK) << mw_status_text(status);
    return largest;
}

// From the origin to a place and back, by translations, over a domain of its own.
template <class T>
MotionData<T> there_and_back(T x, T y, T z, T begin, T end)
{
    MotionData<T> data;
    data.knots = {begin, begin + (end - begin) / 4, end};
    const T nothing[] = {0, 0, 0}, offset[] = {x, y, z};
    data.controls.resize(3);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(api<T>::translation(&data.controls[k], k == 1 ? offset : nothing), MW_OK);
    return data;
}

template <class T>
MotionData<T> as_kind(MotionData<T> data, mw_motion_kind kind)
{
    data.kind = kind;
    return data;
}

template <class T>
std::vector<T> random_points(Random &random, std::size_t count)
{
    std::vector<T> points(3 * count);
    for (T &coordinate : points)
        coordinate = static_cast<T>(random.uniform(-2, 2));
    return points;
}

template <class T>
T even(T first, T last, std::size_t i, std::size_t count)
{
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    return i == 0 ? first : i + 1 == count ? last : static_cast<T>((1 - part) * first + part * last);
}

// Of one point at one sample, by the reference.
template <class T>
long double distance_at(const reference::Motion &first, const reference::Motion &second, T s, T t, const T *point)
{
    const std::array<long double, 3> p = {point[0], point[1], point[2]};
    const auto a = apply_point(first.at(s), p), b = apply_point(second.at(t), p);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

template <class T>
class MotionCompareTest : public ::testing::Test {};

TYPED_TEST_SUITE(MotionCompareTest, Precisions, PrecisionName);

TYPED_TEST(MotionCompareTest, a_motion_does_not_differ_from_itself)
{
    using T = TypeParam;
    Random random(161);
    const std::vector<T> points = random_points<T>(random, 50);
    for (mw_motion_kind kind : all_motion_kinds) {
        const CompiledMotion<T> motion(random_motion<T>(random, kind, 3, 6));
        const auto largest = compared(motion, motion, points, 100);
        EXPECT_EQ(largest.distance, T(0)) << name_of(kind);
        EXPECT_EQ(largest.parameters[0], motion.first());
        EXPECT_EQ(largest.parameters[1], motion.first());
        EXPECT_EQ(largest.point, 0u);
    }
}

// The same times of two domains meet: both are farthest out at their second knot, a quarter of the way.
TYPED_TEST(MotionCompareTest, domains_of_their_own)
{
    using T = TypeParam;
    const CompiledMotion<T> first(there_and_back<T>(3, 0, 0, 0, 8)), second(there_and_back<T>(0, 4, 0, -10, 30));
    const std::vector<T> points = {1, 2, 3};
    for (std::size_t samples : {5, 9, 17, 401}) {
        const auto largest = compared(first, second, points, samples);
        EXPECT_EQ(largest.distance, T(5)) << samples;
        EXPECT_EQ(largest.parameters[0], T(2)) << samples;
        EXPECT_EQ(largest.parameters[1], T(0)) << samples;
    }
    // One sample is at the start, two are at both ends, where nothing differs; three have one halfway.
    EXPECT_EQ(compared(first, second, points, 1).distance, T(0));
    EXPECT_EQ(compared(first, second, points, 2).distance, T(0));
    const auto halfway = compared(first, second, points, 3);
    EXPECT_NEAR(static_cast<double>(halfway.distance), 10.0 / 3, static_cast<double>(8 * epsilon<T>));
    EXPECT_EQ(halfway.parameters[0], T(4));
    EXPECT_EQ(halfway.parameters[1], T(10));
}

TYPED_TEST(MotionCompareTest, both_ends_are_among_the_samples)
{
    using T = TypeParam;
    // Apart at one end alone, which is no sum of steps.
    MotionData<T> towards, away;
    const T nothing[] = {0, 0, 0}, offset[] = {1, 0, 0};
    towards.controls.resize(2), away.controls.resize(2);
    ASSERT_EQ(api<T>::translation(&towards.controls[0], offset), MW_OK);
    ASSERT_EQ(api<T>::translation(&towards.controls[1], nothing), MW_OK);
    ASSERT_EQ(api<T>::translation(&away.controls[0], nothing), MW_OK);
    ASSERT_EQ(api<T>::translation(&away.controls[1], offset), MW_OK);
    towards.knots = away.knots = {T(0.1), T(0.7)};
    MotionData<T> resting = away;
    resting.controls[1] = resting.controls[0];
    const CompiledMotion<T> first(towards), second(away), rest(resting);
    for (std::size_t samples : {2, 3, 7, 16, 17, 50, 1000}) {
        const auto at_start = compared(first, rest, {0, 0, 0}, samples);
        const auto at_end = compared(rest, second, {0, 0, 0}, samples);
        EXPECT_EQ(at_start.distance, T(1));
        EXPECT_EQ(at_start.parameters[0], T(0.1));
        EXPECT_EQ(at_end.distance, T(1));
        EXPECT_EQ(at_end.parameters[0], T(0.7));
        EXPECT_EQ(at_end.parameters[1], T(0.7));
    }
}

// Additive against multiplicative, which is what the function is for.
TYPED_TEST(MotionCompareTest, matches_the_reference_for_every_point_and_sample)
{
    using T = TypeParam;
    Random random(162);
    for (int repetition = 0; repetition < 2; ++repetition)
        for (std::size_t count : {1, 2, 127, 128, 129, 300})
            for (std::size_t samples : {1, 2, 7, 8, 9, 30}) {
                const auto data = random_motion<T>(random, MW_MOTION_MULTIPLICATIVE, 3, 5);
                const auto other = as_kind(data, repetition % 2 ? MW_MOTION_ADDITIVE : MW_MOTION_CUMULATIVE);
                const CompiledMotion<T> first(data), second(other);
                const reference::Motion a = data.exact(), b = other.exact();
                const std::vector<T> points = random_points<T>(random, count);
                const auto largest = compared(first, second, points, samples);
                long double expected = 0;
                for (std::size_t i = 0; i < samples; ++i) {
                    const T t = even(first.first(), first.last(), i, samples);
                    for (std::size_t k = 0; k < count; ++k)
                        expected = std::max(expected, distance_at(a, b, t, t, &points[3 * k]));
                }
                const double tolerance = static_cast<double>(60 * epsilon<T> * reach_of(data));
                EXPECT_NEAR(static_cast<double>(largest.distance), static_cast<double>(expected), tolerance)
                    << other.name() << ", " << count << " points, " << samples << " samples";
                // Where it says that it is, it is.
                ASSERT_LT(largest.point, count);
                EXPECT_NEAR(static_cast<double>(distance_at(a, b, largest.parameters[0], largest.parameters[1],
                                                            &points[3 * largest.point])),
                            static_cast<double>(largest.distance), tolerance);
            }
}

TYPED_TEST(MotionCompareTest, one_of_many_motions)
{
    using T = TypeParam;
    Random random(163);
    auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 2, 4);
    data.motion_count = 3;
    draw_controls(random, data, 4);
    const CompiledMotion<T> all(data);
    const std::vector<T> points = random_points<T>(random, 5);
    for (std::size_t index = 0; index < 3; ++index) {
        MotionData<T> alone = data;
        alone.motion_count = 1;
        alone.controls.assign(data.controls.begin() + static_cast<std::ptrdiff_t>(4 * index),
                              data.controls.begin() + static_cast<std::ptrdiff_t>(4 * index + 4));
        const CompiledMotion<T> one(alone);
        for (std::size_t other = 0; other < 3; ++other) {
            Distance<T> largest{}, reversed{};
            const auto view = packed(points);
            ASSERT_EQ(api<T>::compare_motions(&largest, one.get(), 0, all.get(), other, view, 5, 20), MW_OK);
            ASSERT_EQ(api<T>::compare_motions(&reversed, all.get(), other, one.get(), 0, view, 5, 20), MW_OK);
            EXPECT_EQ(largest.distance, reversed.distance);
            EXPECT_EQ(largest.distance == T(0), index == other);
        }
    }
}

TYPED_TEST(MotionCompareTest, points_in_every_layout)
{
    using T = TypeParam;
    Random random(164);
    const auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 3, 5);
    const CompiledMotion<T> first(data), second(as_kind(data, MW_MOTION_MULTIPLICATIVE));
    constexpr std::size_t count = 145;
    const std::vector<T> points = random_points<T>(random, count);
    const auto expected = compared(first, second, points, 40);
    for (const Layout &layout : Layout::all(3, sizeof(T))) {
        const Placement placement = layout.place(3, count, sizeof(T));
        std::vector<std::vector<unsigned char>> blocks;
        for (std::size_t size : placement.block_sizes)
            blocks.emplace_back(size, static_cast<unsigned char>(0xff));
        View<T> view;
        view.stride = placement.stride;
        for (const auto &[block, offset] : placement.component)
            view.component.push_back(reinterpret_cast<T *>(blocks[block].data() + offset));
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                std::memcpy(reinterpret_cast<unsigned char *>(view.component[c]) + i * view.stride,
                            &points[3 * i + c], sizeof(T));
        Distance<T> largest{};
        ASSERT_EQ(api<T>::compare_motions(&largest, first.get(), 0, second.get(), 0, view.const_xyz(), count, 40),
                  MW_OK)
            << layout.name();
        EXPECT_EQ(largest.distance, expected.distance) << layout.name();
        EXPECT_EQ(largest.parameters[0], expected.parameters[0]) << layout.name();
        EXPECT_EQ(largest.point, expected.point) << layout.name();
    }
}

// A point that is not finite has no distance, and does not hide that of others.
TYPED_TEST(MotionCompareTest, points_that_are_not_finite)
{
    using T = TypeParam;
    const CompiledMotion<T> first(there_and_back<T>(3, 0, 0, 0, 8)), second(there_and_back<T>(0, 4, 0, 0, 8));
    for (T bad : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity()}) {
        const auto largest = compared<T>(first, second, {bad, bad, bad, 1, 2, 3, bad, bad, bad}, 9);
        EXPECT_EQ(largest.distance, T(5));
        EXPECT_EQ(largest.point, 1u);
        EXPECT_EQ(compared<T>(first, second, {bad, bad, bad}, 9).distance, T(0));
    }
}

TYPED_TEST(MotionCompareTest, nothing_to_compare)
{
    using T = TypeParam;
    const CompiledMotion<T> first(there_and_back<T>(3, 0, 0, 1, 8)), second(there_and_back<T>(0, 4, 0, -2, 8));
    const typename api<T>::const_xyz none{};
    for (std::size_t samples : {0, 1, 100})
        for (std::size_t count : {0, 1}) {
            if (samples && count)
                continue;
            Distance<T> largest{-1, {-1, -1}, 7};
            ASSERT_EQ(api<T>::compare_motions(&largest, first.get(), 0, second.get(), 0, none, count, samples),
                      MW_OK);
            EXPECT_EQ(largest.distance, T(0));
            EXPECT_EQ(largest.parameters[0], T(1));
            EXPECT_EQ(largest.parameters[1], T(-2));
            EXPECT_EQ(largest.point, 0u);
        }
}

// ----------------------------------------------------------------------------------------------------------- errors

TYPED_TEST(MotionCompareTest, errors)
{
    using T = TypeParam;
    using Other = std::conditional_t<std::is_same_v<T, float>, double, float>;
    const CompiledMotion<T> motion(there_and_back<T>(3, 0, 0, 0, 8));
    const CompiledMotion<Other> other(there_and_back<Other>(3, 0, 0, 0, 8));
    const auto *of_other = reinterpret_cast<Compiled<T>>(other.get());
    const std::vector<std::uint64_t> zeros(64);
    const auto *none = reinterpret_cast<Compiled<T>>(zeros.data());
    const std::vector<T> points(30, T(1));
    Distance<T> largest, before;
    std::memset(static_cast<void *>(&largest), 0x5a, sizeof largest);
    std::memcpy(static_cast<void *>(&before), &largest, sizeof largest);
    const auto fails = [&](mw_status status, Compiled<T> first, std::size_t first_index, Compiled<T> second,
                           std::size_t second_index, typename api<T>::const_xyz view, std::size_t count) {
        const mw_status got =
            api<T>::compare_motions(&largest, first, first_index, second, second_index, view, count, 9);
        EXPECT_EQ(got, status) << mw_status_text(got);
        EXPECT_EQ(std::memcmp(&largest, &before, sizeof largest), 0) << "bytes changed";
    };
    const auto view = packed(points);
    EXPECT_EQ(api<T>::compare_motions(nullptr, motion.get(), 0, motion.get(), 0, view, 10, 9), MW_ERROR_NULL);
    fails(MW_ERROR_NULL, nullptr, 0, motion.get(), 0, view, 10);
    fails(MW_ERROR_NULL, motion.get(), 0, nullptr, 0, view, 10);
    fails(MW_ERROR_MOTION, of_other, 0, motion.get(), 0, view, 10);
    fails(MW_ERROR_MOTION, motion.get(), 0, of_other, 0, view, 10);
    fails(MW_ERROR_MOTION, none, 0, motion.get(), 0, view, 10);
    fails(MW_ERROR_MOTION, motion.get(), 0, none, 0, view, 10);
    fails(MW_ERROR_MOTION_INDEX, motion.get(), 1, motion.get(), 0, view, 10);
    fails(MW_ERROR_MOTION_INDEX, motion.get(), 0, motion.get(), 1, view, 10);
    for (int component = 0; component < 3; ++component) {
        auto missing = view;
        (component == 0 ? missing.x : component == 1 ? missing.y : missing.z) = nullptr;
        fails(MW_ERROR_NULL, motion.get(), 0, motion.get(), 0, missing, 10);
    }
    auto narrow = view;
    narrow.stride = sizeof(T[2]);
    fails(MW_ERROR_STRIDE, motion.get(), 0, motion.get(), 0, narrow, 10);
    fails(MW_ERROR_SIZE, motion.get(), 0, motion.get(), 0, view, std::numeric_limits<std::size_t>::max() / 2);
    // Motions are looked at where there is nothing else to do.
    fails(MW_ERROR_MOTION_INDEX, motion.get(), 1, motion.get(), 0, view, 0);
}

}  // namespace
}  // namespace motorway::testing
