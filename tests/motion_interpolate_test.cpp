// Motions through keys: that the keys are met, as the library and the reference sample the motion that was found, and
// that what it is between them is what it must be.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion_room.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

constexpr mw_motion_kind kinds[] = {MW_MOTION_ADDITIVE, MW_MOTION_CUMULATIVE};

template <class T>
struct Keys {
    std::vector<typename api<T>::motor> poses;
    std::vector<T> times;

    std::size_t count() const { return poses.size(); }
};

// Times that increase by 1 to `uneven`; poses from one to the next by no more than `turn` and `reach`, of any length
// and sign, as motors come.
template <class T>
Keys<T> random_keys(Random &random, std::size_t count, double turn, double reach, double uneven = 3)
{
    Keys<T> keys;
    reference::DualQuaternion pose = random_displacement(random, 3, reach);
    T time = static_cast<T>(random.uniform(-10, 10));
    for (std::size_t i = 0; i < count; ++i) {
        keys.poses.push_back(rounded_pose<T>(static_cast<long double>(random.magnitude(0.5, 2)) * pose));
        keys.times.push_back(time);
        pose = compose(pose, random_displacement(random, turn, reach));
        time += static_cast<T>(random.uniform(1, uneven));
    }
    return keys;
}

// The same along a smooth way, that swings and turns to and fro. A spline of a high degree overshoots by far between
// poses that come from no such way, and then its controls are more than a full turn apart.
template <class T>
Keys<T> smooth_keys(Random &random, std::size_t count, double uneven = 3)
{
    Keys<T> keys = random_keys<T>(random, count, 0, 3, uneven);
    const reference::DualQuaternion start = random_displacement(random, 3, 3);
    double amplitude[6], frequency[6];
    for (std::size_t c = 0; c < 6; ++c)
        amplitude[c] = random.uniform(-1.2, 1.2), frequency[c] = random.uniform(0.05, 0.35);
    for (std::size_t i = 0; i < count; ++i) {
        reference::DualQuaternion generator{{}, {}};
        for (std::size_t c = 0; c < 6; ++c)
            (c < 3 ? generator.real[c] : generator.dual[c - 3]) =
                amplitude[c] * std::sin(frequency[c] * static_cast<double>(keys.times[i]));
        const auto pose = static_cast<long double>(random.magnitude(0.5, 2)) * compose(start, exp(generator));
        keys.poses[i] = rounded_pose<T>(pose);
    }
    return keys;
}

// Memory as large as it must be, between pages that may not be touched.
template <class T>
class Interpolation {
public:
    using A = api<T>;

    Interpolation(mw_motion_kind kind, std::size_t degree, const Keys<T> &keys, Guard guard = Guard::after)
        : kind_(kind), degree_(static_cast<unsigned>(degree)), keys_(keys), size_(ask()), memory_(size_),
          room_(keys.count(), keys.count() + degree - 1, guard), guard_(guard)
    {
    }

    mw_status run()
    {
        return A::interpolate_keys(&out_, room_.arrays, kind_, degree_, keys_.poses.data(), keys_.times.data(),
                                   keys_.count(), memory_.place(size_, guard_), &size_, nullptr);
    }

    MotionData<T> found()
    {
        const mw_status status = run();
        EXPECT_EQ(status, MW_OK) << mw_status_text(status);
        EXPECT_TRUE(room_.is_untouched_elsewhere());
        MotionData<T> data;
        data.kind = out_.kind;
        data.degree = out_.degree;
        EXPECT_EQ(data.kind, kind_);
        EXPECT_EQ(data.degree, degree_);
        EXPECT_EQ(out_.controls, room_.arrays.controls);
        EXPECT_EQ(out_.knots, room_.arrays.knots);
        EXPECT_EQ(out_.control_count, keys_.count());
        EXPECT_EQ(out_.knot_count, keys_.count() + degree_ - 1);
        EXPECT_TRUE(!out_.weights && !out_.closed && !out_.base && out_.motion_count <= 1);
        data.controls.assign(out_.controls, out_.controls + out_.control_count);
        data.knots.assign(out_.knots, out_.knots + out_.knot_count);
        return data;
    }

    bool is_untouched()
    {
        const typename A::motion none{};
        return room_.is_untouched() && std::memcmp(&out_, &none, sizeof none) == 0;
    }

private:
    std::size_t ask() const
    {
        std::size_t size = 0;
        EXPECT_EQ(A::interpolate_keys(nullptr, {}, kind_, degree_, nullptr, nullptr, keys_.count(), nullptr, &size,
                                      nullptr),
                  MW_OK);
        return size;
    }

    mw_motion_kind kind_;
    unsigned degree_;
    const Keys<T> &keys_;
    std::size_t size_;
    GuardedBuffer memory_;
    Room<T> room_;
    Guard guard_;
    typename A::motion out_{};
};

template <class T>
MotionData<T> interpolated(mw_motion_kind kind, std::size_t degree, const Keys<T> &keys)
{
    return Interpolation<T>(kind, degree, keys).found();
}

// The largest coordinates of the controls, of the rotation and of the translation: what rounding errors of a sample
// are relative to. Those of an additive motion may exceed those of its keys by far.
template <class T>
struct Sizes {
    long double rotation = 1, translation = 0;

    explicit Sizes(const MotionData<T> &motion)
    {
        for (const auto &control : motion.controls) {
            const auto numbers = motor_numbers(exact_pose(&control.s));
            for (std::size_t c = 0; c < 4; ++c) {
                rotation = std::max(rotation, std::abs(numbers[c]));
                translation = std::max(translation, std::abs(numbers[c + 4]));
            }
        }
    }
};

// In epsilons of these sizes, how far a sample is from the key, normalised, that it must be: of either sign.
template <class T>
long double miss(const reference::DualQuaternion &sample, const typename api<T>::motor &key, const Sizes<T> &sizes)
{
    const reference::DualQuaternion exact = normalize(exact_pose(&key.s));
    const long double sign = dot_of_rotations(sample, exact) < 0 ? -1 : 1;
    const auto numbers = motor_numbers(sample), expected = motor_numbers(sign * exact);
    long double worst = 0;
    for (std::size_t c = 0; c < 8; ++c) {
        const long double size = c < 4 ? sizes.rotation : sizes.translation;
        const long double error = std::abs(numbers[c] - expected[c]);
        if (error > 0)
            worst = std::max(worst, error / (size * epsilon<T>));
    }
    return worst;
}

// The motion itself, which differs from the exact one by the rounding of its controls, and the library's samples of
// it.
template <class T>
void expect_meets_keys(const MotionData<T> &motion, const Keys<T> &keys, long double exactly, long double sampled_to)
{
    const Sizes<T> sizes(motion);
    const reference::Motion exact = motion.exact(0, MW_KEEP_SIGNS);
    const std::vector<T> samples = sampled(CompiledMotion<T>(motion, MW_KEEP_SIGNS), keys.times);
    for (std::size_t i = 0; i < keys.count(); ++i) {
        const long double missed = miss<T>(exact.at(keys.times[i]), keys.poses[i], sizes);
        const long double missed_sampled = miss<T>(exact_pose(&samples[8 * i]), keys.poses[i], sizes);
        ASSERT_LE(missed, exactly) << motion.name() << ", key " << i;
        ASSERT_LE(missed_sampled, sampled_to) << motion.name() << ", key " << i;
    }
}

template <class T>
class MotionInterpolateTest : public ::testing::Test {};

TYPED_TEST_SUITE(MotionInterpolateTest, Precisions, PrecisionName);


// ---------------------------------------------------------------------------------------------- keys and their poses

// The weights of a sum are all positive, so that its error is a few epsilons of the largest control for every degree.
TYPED_TEST(MotionInterpolateTest, additive_motions_meet_keys)
{
    using T = TypeParam;
    Random random(401);
    for (std::size_t degree = 1; degree <= 5; ++degree)
        for (std::size_t count : {degree + 1, degree + 2, std::size_t(12), std::size_t(100)})
            for (int repetition = 0; repetition < 6; ++repetition) {
                const auto keys = random_keys<T>(random, count, 2.5, 3);
                const auto motion = interpolated(MW_MOTION_ADDITIVE, degree, keys);
                expect_meets_keys(motion, keys, 4, 4);
                if (this->HasFatalFailure())
                    return;
            }
}

TYPED_TEST(MotionInterpolateTest, cumulative_motions_meet_keys)
{
    using T = TypeParam;
    Random random(402);
    const double turns[] = {2.5, 1.2, 0.35};
    for (std::size_t degree = 1; degree <= 5; ++degree)
        for (std::size_t count : {degree + 1, degree + 2, std::size_t(12), std::size_t(100)})
            for (int repetition = 0; repetition < 6; ++repetition) {
                const bool smooth = degree > 3 || repetition % 2;
                const auto keys = smooth ? smooth_keys<T>(random, count)
                                         : random_keys<T>(random, count, turns[degree - 1], 3);
                const auto motion = interpolated(MW_MOTION_CUMULATIVE, degree, keys);
                // An exponential and a product of motors for each degree, each off by some epsilons of the whole.
                expect_meets_keys(motion, keys, 4 * (degree + 1), 4 * (degree + 1));
                if (this->HasFatalFailure())
                    return;
            }
}

// Poses in any order, neighbours at any angle: they are met, or it is said that they are not.
TYPED_TEST(MotionInterpolateTest, wild_keys_are_met_or_refused)
{
    using T = TypeParam;
    Random random(403);
    int met = 0, refused = 0;
    for (std::size_t degree = 2; degree <= 5; ++degree)
        for (int repetition = 0; repetition < 20; ++repetition) {
            const auto keys = random_keys<T>(random, 10, 3.1, 3);
            Interpolation<T> interpolation(MW_MOTION_CUMULATIVE, degree, keys);
            const mw_status status = interpolation.run();
            (status == MW_OK ? met : refused) += 1;
            if (status != MW_OK) {
                ASSERT_EQ(status, MW_ERROR_CONVERGENCE);
                ASSERT_TRUE(interpolation.is_untouched());
                continue;
            }
            // Near a full turn from control to control rounding errors grow as its logarithm does.
            const auto motion = interpolation.found();
            expect_meets_keys(motion, keys, 4000, 4000);
            if (this->HasFatalFailure())
                return;
        }
    EXPECT_GE(met, 10);
    EXPECT_GE(refused, 10);
}

TYPED_TEST(MotionInterpolateTest, keys_far_from_the_origin_are_met)
{
    using T = TypeParam;
    Random random(404);
    for (mw_motion_kind kind : kinds) {
        auto keys = smooth_keys<T>(random, 20);
        const reference::DualQuaternion away{{0, 0, 0, 1}, {4e5L, -3e5L, 1e5L, 0}};
        for (auto &pose : keys.poses)
            pose = rounded_pose<T>(compose(exact_pose(&pose.s), away));
        expect_meets_keys(interpolated(kind, 3, keys), keys, 16, 16);
    }
}

// Times so close that knots, which are their means, fall on them.
TYPED_TEST(MotionInterpolateTest, neighbouring_numbers_are_times)
{
    using T = TypeParam;
    Random random(405);
    for (mw_motion_kind kind : kinds)
        for (std::size_t degree = 1; degree <= 3; ++degree) {
            auto keys = smooth_keys<T>(random, 16);
            for (std::size_t i = 0; i < keys.count(); ++i)
                keys.times[i] = i ? std::nextafter(keys.times[i - 1], T(2)) : T(1);
            expect_meets_keys(interpolated(kind, degree, keys), keys, 4 * (degree + 1), 4 * (degree + 1));
        }
}

// The controls are far outside of the keys then, which rotations would not survive.
TYPED_TEST(MotionInterpolateTest, times_may_be_very_uneven)
{
    using T = TypeParam;
    Random random(406);
    for (std::size_t degree = 1; degree <= 5; ++degree) {
        auto keys = random_keys<T>(random, 30, 0, 3);
        for (std::size_t i = 1; i < keys.count(); ++i)
            keys.times[i] = keys.times[i - 1] + static_cast<T>(std::exp2(random.uniform(-8, 8)));
        expect_meets_keys(interpolated(MW_MOTION_ADDITIVE, degree, keys), keys, 8, 8);
    }
}

// ---------------------------------------------------------------------------------------------- between the keys

TYPED_TEST(MotionInterpolateTest, knots_are_means_of_neighbouring_times)
{
    using T = TypeParam;
    Random random(407);
    auto keys = random_keys<T>(random, 5, 0.1, 3);
    keys.times = {0, 1, 3, 4, 8};
    for (mw_motion_kind kind : kinds) {
        EXPECT_EQ(interpolated(kind, 1, keys).knots, keys.times);
        EXPECT_EQ(interpolated(kind, 2, keys).knots, (std::vector<T>{0, 0, 2, T(3.5), 8, 8}));
        const std::vector<T> knots = interpolated(kind, 3, keys).knots;
        ASSERT_EQ(knots.size(), 7u);
        EXPECT_NEAR(static_cast<double>(knots[3]), 8 / 3., 4 * static_cast<double>(epsilon<T>));
        EXPECT_EQ(interpolated(kind, 4, keys).knots, (std::vector<T>{0, 0, 0, 0, 8, 8, 8, 8}));
    }
}

TYPED_TEST(MotionInterpolateTest, of_degree_1_the_controls_are_the_keys)
{
    using T = TypeParam;
    Random random(408);
    for (mw_motion_kind kind : kinds) {
        const auto keys = random_keys<T>(random, 9, 3, 3);
        const auto motion = interpolated(kind, 1, keys);
        const Sizes<T> sizes(motion);
        for (std::size_t k = 0; k < keys.count(); ++k)
            EXPECT_LE(miss<T>(exact_pose(&motion.controls[k].s), keys.poses[k], sizes), 4);
    }
}

// Neither the length of a motor nor its sign is part of a pose, but the sign of the first remains.
TYPED_TEST(MotionInterpolateTest, signs_and_lengths_of_keys_do_not_count)
{
    using T = TypeParam;
    Random random(409);
    for (mw_motion_kind kind : kinds) {
        const auto keys = smooth_keys<T>(random, 12);
        auto others = keys;
        for (std::size_t i = 1; i < others.count(); ++i) {
            const T factor = random.chance(2) ? T(-0.25) : T(8);
            for (T *number = &others.poses[i].s; number <= &others.poses[i].w; ++number)
                *number *= factor;
        }
        const auto expected = interpolated(kind, 3, keys), motion = interpolated(kind, 3, others);
        EXPECT_EQ(std::memcmp(motion.controls.data(), expected.controls.data(), sizeof(T[8]) * 12), 0);
    }
}

// Translations, and turns about one axis, commute. What a spline of the degree can be, it is then everywhere: here a
// polynomial of that degree. Additive motions of translations are the same.
template <class T>
void expect_polynomial(mw_motion_kind kind, std::size_t degree, bool turns, Random &random)
{
    long double coefficients[6];
    for (std::size_t k = 0; k <= degree; ++k)
        coefficients[k] = random.uniform(-1, 1) / (k + 1);
    const auto pose = [&](long double t) {
        long double value = 0;
        for (std::size_t k = degree + 1; k-- > 0;)
            value = value * t + coefficients[k];
        const reference::Quaternion along{0.6L * value, 0, 0.8L * value, 0};
        return turns ? exp(reference::DualQuaternion{along, {}}) : reference::DualQuaternion{{0, 0, 0, 1}, along};
    };
    Keys<T> keys;
    for (T t = -1; t <= 1; t += T(0.125) * static_cast<T>(1 + random.below(3))) {
        keys.times.push_back(t);
        keys.poses.push_back(rounded_pose<T>(pose(t)));
    }
    const auto motion = interpolated(kind, degree, keys);
    const Sizes<T> sizes(motion);
    const reference::Motion exact = motion.exact(0, MW_KEEP_SIGNS);
    for (int repetition = 0; repetition < 40; ++repetition) {
        const auto t = static_cast<T>(random.uniform(-1, static_cast<double>(keys.times.back())));
        ASSERT_LE(miss<T>(exact.at(t), rounded_pose<T>(pose(t)), sizes), 100)
            << motion.name() << (turns ? ", turning, " : ", moving, ") << t;
    }
}

TYPED_TEST(MotionInterpolateTest, polynomials_are_reproduced)
{
    using T = TypeParam;
    Random random(410);
    for (std::size_t degree = 1; degree <= 5; ++degree)
        for (int repetition = 0; repetition < 5; ++repetition) {
            expect_polynomial<T>(MW_MOTION_ADDITIVE, degree, false, random);
            expect_polynomial<T>(MW_MOTION_CUMULATIVE, degree, false, random);
            expect_polynomial<T>(MW_MOTION_CUMULATIVE, degree, true, random);
            if (this->HasFatalFailure())
                return;
        }
}

// Degree 3 is smooth to the second derivative: continued beyond a knot, the pieces on both sides of it part as the
// third power of the distance. A motion that was less smooth would part as the first or the second.
TYPED_TEST(MotionInterpolateTest, cubic_cumulative_motions_are_twice_differentiable)
{
    using T = TypeParam;
    Random random(411);
    const auto keys = smooth_keys<T>(random, 12);
    const auto motion = interpolated(MW_MOTION_CUMULATIVE, 3, keys).exact(0, MW_KEEP_SIGNS);
    const auto spans = motion.spans();
    ASSERT_EQ(spans.size(), 9u);
    for (std::size_t k = 1; k < spans.size(); ++k) {
        const auto gap = [&](long double h) {
            const long double t = motion.span_begin(spans[k]) + h;
            return motor_error<double>(motion.at(t, spans[k - 1]), motion.at(t, spans[k])) * epsilon<double>;
        };
        const long double order = std::log2(gap(1e-3L) / gap(0.5e-3L));
        EXPECT_NEAR(static_cast<double>(order), 3, 0.05) << "knot " << motion.span_begin(spans[k]);
    }
}

// And so is what the library samples: the slopes of its twist on both sides of a knot, from three values each, agree.
TEST(MotionInterpolate, the_twist_of_a_cubic_cumulative_motion_has_no_corners)
{
    Random random(412);
    const auto keys = smooth_keys<double>(random, 12);
    const auto data = interpolated(MW_MOTION_CUMULATIVE, 3, keys);
    const CompiledMotion<double> motion(data, MW_KEEP_SIGNS);
    const double h = 0x1p-10;
    for (std::size_t span : data.exact().spans()) {
        const auto knot = static_cast<double>(data.exact().span_begin(span));
        if (knot == motion.first())
            continue;
        const auto twists = twisted(motion, {knot - 2 * h, knot - h, knot, knot + h, knot + 2 * h}).twists;
        for (std::size_t c = 0; c < 6; ++c) {
            const auto at = [&](std::size_t i) { return twists[6 * i + c]; };
            const double before = (3 * at(2) - 4 * at(1) + at(0)) / (2 * h);
            const double after = (4 * at(3) - 3 * at(2) - at(4)) / (2 * h);
            // The formula leaves h²/3 times the third derivative, whose jump is not small.
            EXPECT_NEAR(before, after, 1e-4) << "knot " << knot << ", coordinate " << c;
        }
    }
}

// --------------------------------------------------------------------------------------------------- memory, errors

TYPED_TEST(MotionInterpolateTest, touches_nothing_but_its_arrays)
{
    using T = TypeParam;
    Random random(413);
    for (mw_motion_kind kind : kinds)
        for (std::size_t degree : {1, 3, 31})
            for (std::size_t count : {degree + 1, degree + 3, std::size_t(40)}) {
                if (degree == 31 && kind == MW_MOTION_CUMULATIVE)
                    continue;  // what such a motion would need is more than a full turn from control to control
                const auto keys = smooth_keys<T>(random, count);
                const auto first = Interpolation<T>(kind, degree, keys, Guard::after).found();
                const auto second = Interpolation<T>(kind, degree, keys, Guard::before).found();
                EXPECT_EQ(first.knots, second.knots);
                EXPECT_EQ(std::memcmp(first.controls.data(), second.controls.data(), sizeof(T[8]) * count), 0);
            }
}

TYPED_TEST(MotionInterpolateTest, works_in_place)
{
    using T = TypeParam;
    Random random(414);
    for (mw_motion_kind kind : kinds) {
        const auto keys = smooth_keys<T>(random, 10);
        const auto expected = interpolated(kind, 3, keys);
        auto poses = keys.poses;
        auto times = keys.times;
        times.resize(12);
        typename api<T>::motion out{};
        std::size_t size = 0;
        ASSERT_EQ(api<T>::interpolate_keys(&out, {}, kind, 3, nullptr, nullptr, 10, nullptr, &size, nullptr), MW_OK);
        std::vector<std::uint64_t> memory(size / 8);
        ASSERT_EQ(api<T>::interpolate_keys(&out, {poses.data(), 10, times.data(), 12}, kind, 3, poses.data(),
                                           times.data(), 10, memory.data(), &size, nullptr),
                  MW_OK);
        EXPECT_EQ(times, expected.knots);
        EXPECT_EQ(std::memcmp(poses.data(), expected.controls.data(), sizeof(T[8]) * 10), 0);
    }
}

// A call with everything right, of which a test spoils something. Nothing may be written then.
template <class T>
class Call {
public:
    using A = api<T>;
    static constexpr std::size_t no_place = 12345;

    Call() : room(20, 20)
    {
        Random random(415);
        keys = smooth_keys<T>(random, 10);
        arrays = room.arrays;
        poses = keys.poses.data();
        times = keys.times.data();
        size = needed();
        storage.resize(size / 8 + 1);
        memory = storage.data();
    }

    std::size_t needed() const
    {
        std::size_t bytes = 0;
        EXPECT_EQ(A::interpolate_keys(nullptr, {}, kind, degree, nullptr, nullptr, count, nullptr, &bytes, nullptr),
                  MW_OK);
        return bytes;
    }

    template <class Item>
    const Item *in_memory(const std::vector<Item> &items)
    {
        std::memcpy(memory, items.data(), items.size() * sizeof(Item));
        return static_cast<const Item *>(memory);
    }

    mw_status run()
    {
        return A::interpolate_keys(out, arrays, kind, degree, poses, times, count, memory, size_pointer, &where);
    }

    bool is_untouched()
    {
        const typename A::motion none{};
        return room.is_untouched() && std::memcmp(&result, &none, sizeof none) == 0;
    }

    Keys<T> keys;
    Room<T> room;
    typename A::motion_arrays arrays;
    typename A::motion result{}, *out = &result;
    mw_motion_kind kind = MW_MOTION_CUMULATIVE;
    unsigned degree = 3;
    const typename A::motor *poses;
    const T *times;
    std::size_t count = 10, size = 0, *size_pointer = &size, where = no_place;
    std::vector<std::uint64_t> storage;
    void *memory;
};

TYPED_TEST(MotionInterpolateTest, errors)
{
    using T = TypeParam;
    using Motor = typename api<T>::motor;
    const auto expect = [](mw_status status, const char *what, void (*spoil)(Call<T> &), std::size_t where = 0) {
        for (mw_motion_kind kind : kinds) {
            Call<T> call;
            call.kind = kind;
            spoil(call);
            const bool without_where = call.size_pointer == nullptr;
            EXPECT_EQ(call.run(), status) << what;
            EXPECT_TRUE(call.where == where || without_where) << what << ": " << call.where;
            EXPECT_TRUE(call.is_untouched()) << what;
        }
    };
    expect(MW_ERROR_NULL, "no result", [](Call<T> &c) { c.out = nullptr; });
    expect(MW_ERROR_NULL, "no controls", [](Call<T> &c) { c.arrays.controls = nullptr; });
    expect(MW_ERROR_NULL, "no knots", [](Call<T> &c) { c.arrays.knots = nullptr; });
    expect(MW_ERROR_NULL, "no keys", [](Call<T> &c) { c.poses = nullptr; });
    expect(MW_ERROR_NULL, "no times", [](Call<T> &c) { c.times = nullptr; });
    expect(MW_ERROR_NULL, "no size", [](Call<T> &c) { c.size_pointer = nullptr; });
    expect(MW_ERROR_MOTION_KIND, "kind 0", [](Call<T> &c) { c.kind = static_cast<mw_motion_kind>(0); });
    expect(MW_ERROR_MOTION_KIND, "multiplicative", [](Call<T> &c) { c.kind = MW_MOTION_MULTIPLICATIVE; });
    expect(MW_ERROR_MOTION_KIND, "generators", [](Call<T> &c) { c.kind = MW_MOTION_GENERATOR; });
    expect(MW_ERROR_MOTION_KIND, "keys of generators", [](Call<T> &c) { c.kind = MW_MOTION_GENERATOR_KEYS; });
    expect(MW_ERROR_DEGREE, "degree 0", [](Call<T> &c) { c.degree = 0; });
    expect(MW_ERROR_DEGREE, "degree 32", [](Call<T> &c) { c.degree = 32; });
    expect(MW_ERROR_CONTROL_COUNT, "three keys", [](Call<T> &c) { c.count = 3; });
    expect(MW_ERROR_CONTROL_COUNT, "no key", [](Call<T> &c) { c.count = 0; });
    expect(MW_ERROR_SIZE, "more keys than memory", [](Call<T> &c) { c.count = SIZE_MAX / 64; });
    expect(MW_ERROR_KNOTS, "equal times", [](Call<T> &c) { c.keys.times[4] = c.keys.times[3]; }, 4);
    expect(MW_ERROR_KNOTS, "times that decrease", [](Call<T> &c) { c.keys.times[7] = c.keys.times[5]; }, 7);
    expect(MW_ERROR_KNOTS, "no number", [](Call<T> &c) { c.keys.times[0] = std::numeric_limits<T>::quiet_NaN(); }, 0);
    expect(MW_ERROR_KNOTS, "infinite", [](Call<T> &c) { c.keys.times[9] = std::numeric_limits<T>::infinity(); }, 9);
    expect(MW_ERROR_KNOTS, "too far", [](Call<T> &c) { c.keys.times[0] = -std::numeric_limits<T>::max(),
                                                       c.keys.times[9] = std::numeric_limits<T>::max(); }, 9);
    expect(MW_ERROR_DEGENERATE_MOTOR, "a key without a rotation", [](Call<T> &c) { c.keys.poses[6] = Motor{}; }, 6);
    expect(MW_ERROR_DEGENERATE_MOTOR, "a key that is no number",
           [](Call<T> &c) { c.keys.poses[2].b13 = std::numeric_limits<T>::quiet_NaN(); }, 2);
    expect(MW_ERROR_CONVERGENCE, "a key nowhere",
           [](Call<T> &c) { c.keys.poses[2].b2i = std::numeric_limits<T>::quiet_NaN(); });
    expect(MW_ERROR_CONVERGENCE, "a key at infinity",
           [](Call<T> &c) { c.keys.poses[2].b2i = std::numeric_limits<T>::infinity(); });
    expect(MW_ERROR_MEMORY, "a byte too few", [](Call<T> &c) { c.size = c.needed() - 1; });
    expect(MW_ERROR_MEMORY, "odd memory", [](Call<T> &c) { c.memory = static_cast<char *>(c.memory) + 4; });
    expect(MW_ERROR_MEMORY, "few controls", [](Call<T> &c) { c.arrays.control_capacity = 9; });
    expect(MW_ERROR_MEMORY, "few knots", [](Call<T> &c) { c.arrays.knot_capacity = 11; });
    expect(MW_ERROR_OVERLAP, "memory on the keys", [](Call<T> &c) { c.poses = c.in_memory(c.keys.poses); });
    expect(MW_ERROR_OVERLAP, "memory on the times", [](Call<T> &c) { c.times = c.in_memory(c.keys.times); });
    expect(MW_ERROR_OVERLAP, "memory on the controls",
           [](Call<T> &c) { c.arrays.controls = static_cast<Motor *>(c.memory); });
    expect(MW_ERROR_OVERLAP, "memory on the knots", [](Call<T> &c) { c.arrays.knots = static_cast<T *>(c.memory); });
    expect(MW_ERROR_OVERLAP, "knots on the controls",
           [](Call<T> &c) { c.arrays.knots = reinterpret_cast<T *>(c.arrays.controls) + 79; });
    expect(MW_ERROR_OVERLAP, "controls beside the keys",
           [](Call<T> &c) { c.arrays.controls = c.keys.poses.data() + 1; });
    expect(MW_ERROR_OVERLAP, "knots beside the times", [](Call<T> &c) { c.arrays.knots = c.keys.times.data() + 1; });
}

// Half turns about axes in turn, through which nothing passes that is smooth.
TYPED_TEST(MotionInterpolateTest, keys_that_no_motion_meets_are_refused)
{
    using T = TypeParam;
    Call<T> call;
    call.degree = 9;
    call.storage.resize(1 + (call.size = call.needed()) / 8);
    call.memory = call.storage.data();
    for (std::size_t i = 0; i < call.count; ++i) {
        call.keys.poses[i] = {};
        (i % 3 == 0 ? call.keys.poses[i].b12 : i % 3 == 1 ? call.keys.poses[i].b13 : call.keys.poses[i].b23) = 1;
        call.keys.times[i] = static_cast<T>(i * i + 1);
    }
    EXPECT_EQ(call.run(), MW_ERROR_CONVERGENCE);
    EXPECT_EQ(call.where, 0u);
    EXPECT_TRUE(call.is_untouched());
}

// A question for the size asks for nothing else, and `where` may be null.
TYPED_TEST(MotionInterpolateTest, sizes_are_told_without_keys)
{
    using T = TypeParam;
    using A = api<T>;
    std::size_t size = 0;
    for (mw_motion_kind kind : kinds) {
        EXPECT_EQ(A::interpolate_keys(nullptr, {}, kind, 3, nullptr, nullptr, 3, nullptr, &size, nullptr),
                  MW_ERROR_CONTROL_COUNT);
        EXPECT_EQ(size, 0u);
    }
    EXPECT_EQ(A::interpolate_keys(nullptr, {}, MW_MOTION_ADDITIVE, 3, nullptr, nullptr, 4, nullptr, nullptr, nullptr),
              MW_ERROR_NULL);
    EXPECT_EQ(A::interpolate_keys(nullptr, {}, MW_MOTION_ADDITIVE, 3, nullptr, nullptr, 4, nullptr, &size, nullptr),
              MW_OK);
    EXPECT_EQ(size % 8, 0u);
    EXPECT_GT(size, 0u);
}

}  // namespace
}  // namespace motorway::testing
