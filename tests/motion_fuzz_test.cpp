// Descriptions at random, most of them wrong in some way: a status and nothing else, and what compiles can be sampled
// all over. Arrays lie against forbidden pages, so that reading past the counts that were given ends the test.

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "guarded_buffer.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

template <class T>
class MotionFuzzTest : public ::testing::Test {
protected:
    using Motion = typename api<T>::motion;
    using Motor = typename api<T>::motor;

    // Any number that is none, or huge, or tiny, and now and then one that is sound.
    static T strange_number(Random &random)
    {
        using Limits = std::numeric_limits<T>;
        const T numbers[] = {0, 1, -1, Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
                             Limits::lowest(), Limits::min(), Limits::denorm_min()};
        return random.chance(3) ? static_cast<T>(random.uniform(-4, 4)) : numbers[random.below(10)];
    }

    static std::vector<T> knots(Random &random, std::size_t count)
    {
        std::vector<T> knots;
        T knot = random.chance(4) ? std::numeric_limits<T>::lowest() / 4 : static_cast<T>(random.uniform(-4, 4));
        const int exponent = static_cast<int>(random.below(60)) - 40;
        for (std::size_t k = 0; k < count; ++k) {
            knots.push_back(knot);
            knot += std::ldexp(static_cast<T>(random.below(3)), exponent);
        }
        if (count && random.chance(4))
            knots[random.below(count)] = strange_number(random);
        return knots;
    }

    // Of every angle, near and far, and of lengths from 1e-3 to 1e3.
    static std::vector<Motor> controls(Random &random, std::size_t count)
    {
        std::vector<Motor> controls;
        for (std::size_t k = 0; k < count; ++k) {
            const auto pose = random_displacement(random, random.chance(4) ? 1e-6 : 6.3, random.chance(4) ? 1e5 : 3);
            controls.push_back(rounded_pose<T>(static_cast<long double>(random.magnitude(1e-3, 1e3)) * pose));
        }
        if (count && random.chance(6))
            (&controls[random.below(count)].s)[random.below(8)] = strange_number(random);
        return controls;
    }
};

TYPED_TEST_SUITE(MotionFuzzTest, Precisions, PrecisionName);

TYPED_TEST(MotionFuzzTest, descriptions)
{
    using T = TypeParam;
    using A = api<T>;
    Random random(151);
    GuardedBuffer controls(65536), knots(65536), weights(65536), bases(4096), memory(1 << 20);
    std::size_t sound = 0, refused = 0;
    for (int repetition = 0; repetition < 2000; ++repetition) {
        const Guard guard = random.chance(2) ? Guard::after : Guard::before;
        typename A::motion motion{};
        motion.kind = static_cast<mw_motion_kind>(1 + random.below(random.chance(10) ? 7 : 5));
        motion.degree = static_cast<unsigned>(random.chance(8) ? random.below(40) : 1 + random.below(4));
        motion.control_count = random.chance(8) ? random.below(3) : motion.degree + 1 + random.below(6);
        motion.closed = random.chance(3);
        motion.motion_count = random.below(3);
        const bool of_keys = motion.kind == MW_MOTION_GENERATOR_KEYS;
        const std::size_t motions = motion.motion_count ? motion.motion_count : 1;
        const auto some_controls = this->controls(random, motions * motion.control_count);
        motion.controls = controls.place_copy(some_controls.data(), some_controls.size(), guard);
        if (!random.chance(3)) {
            std::size_t count = motion.closed ? motion.control_count + 1
                                : of_keys     ? motion.control_count
                                              : motion.control_count + motion.degree - 1;
            count = random.chance(10) ? random.below(50) : count % 1000;
            auto some_knots = this->knots(random, count);
            if (of_keys && random.chance(2))
                for (std::size_t k = 0; k < count; ++k)
                    some_knots[k] = static_cast<T>(k * k);
            motion.knots = knots.place_copy(some_knots.data(), count, guard);
            motion.knot_count = count;
        }
        if (random.chance(4)) {
            std::vector<T> some_weights(motion.control_count, T(1));
            if (motion.control_count && random.chance(3))
                some_weights[random.below(motion.control_count)] = this->strange_number(random);
            motion.weights = weights.place_copy(some_weights.data(), motion.control_count, guard);
        }
        if (random.chance(4)) {
            const auto base = this->controls(random, 1);
            motion.base = bases.place_copy(base.data(), 1, guard);
        }
        const unsigned flags = random.chance(4) ? MW_KEEP_SIGNS : MW_DEFAULT;

        std::size_t size = 0, where = 1u << 30;
        mw_status status = A::motion_size(&size, &motion, &where);
        const typename A::compiled_motion *compiled = nullptr;
        if (status == MW_OK) {
            ASSERT_LE(size, std::size_t(1) << 20);
            void *const block = memory.place((size + 7) / 8 * 8, guard);
            status = A::compile_motion(&compiled, block, size, &motion, flags, &where);
        }
        if (status != MW_OK) {
            ++refused;
            EXPECT_LT(where, std::max(motions * motion.control_count, motion.knot_count) + 1)
                << mw_status_text(status);
            continue;
        }
        ++sound;
        T domain[2];
        ASSERT_EQ(A::motion_domain(domain, compiled), MW_OK);
        EXPECT_LT(domain[0], domain[1]);
        const std::vector<T> parameters = {domain[0], domain[1], domain[0] / 2 + domain[1] / 2, 0,
                                           std::numeric_limits<T>::max(), -1, std::nextafter(domain[1], domain[0])};
        for (unsigned treatment : {MW_CLAMP_PARAMETERS, MW_WRAP_PARAMETERS}) {
            Twists<T> out{std::vector<T>(56), std::vector<T>(42)};
            EXPECT_EQ(A::sample_motion_twist_one(packed_motors(out.poses.data()), packed_bivectors(out.twists.data()),
                                                 compiled, motions - 1, parameters.data(), parameters.size(),
                                                 treatment),
                      MW_OK);
            for (std::size_t i = 0; i < 2 && !motion.weights; ++i)  // the ends are poses, unless weights underflow
                EXPECT_GT(std::abs(out.poses[8 * i]) + std::abs(out.poses[8 * i + 1]) +
                              std::abs(out.poses[8 * i + 2]) + std::abs(out.poses[8 * i + 3]), T(0));
        }
    }
    // Both happen often enough to mean something.
    EXPECT_GT(sound, 300u);
    EXPECT_GT(refused, 300u);
}

// Counts that are nonsense, beside which the arrays are short: nothing is read that the counts do not agree on.
TYPED_TEST(MotionFuzzTest, counts)
{
    using T = TypeParam;
    using A = api<T>;
    Random random(152);
    GuardedBuffer controls(4096), knots(4096), weights(4096);
    const std::vector<T> numbers(8 * 6, T(1));
    for (int repetition = 0; repetition < 3000; ++repetition) {
        const auto nonsense = [&]() -> std::size_t { return random.bits() >> random.below(20); };
        typename A::motion motion{};
        motion.kind = all_motion_kinds[random.below(5)];
        motion.degree = 3;
        motion.controls = reinterpret_cast<const typename A::motor *>(controls.place_copy(numbers.data(), 48,
                                                                                          Guard::after));
        motion.control_count = random.chance(2) ? 6 : nonsense();
        const T some_knots[] = {0, 0, 0, 1, 2, 3, 3, 3};
        motion.knots = knots.place_copy(some_knots, 8, Guard::after);
        motion.knot_count = motion.control_count == 6 ? nonsense() : 8;
        motion.closed = random.chance(2);
        if (is_additive(motion.kind) && motion.control_count == 6)
            motion.weights = weights.place_copy(numbers.data(), 6, Guard::after);
        motion.motion_count = random.chance(2) ? 1 : nonsense();
        std::size_t size = 77, where = 0;
        EXPECT_NE(A::motion_size(&size, &motion, &where), MW_OK);
        EXPECT_EQ(size, 77u);
    }
}

// Bytes that are no compiled motion.
TYPED_TEST(MotionFuzzTest, compiled_memory)
{
    using T = TypeParam;
    Random random(153);
    std::vector<std::uint64_t> garbage(32);
    for (int repetition = 0; repetition < 1000; ++repetition) {
        for (auto &word : garbage)
            word = random.bits();
        const auto *motion = reinterpret_cast<const typename api<T>::compiled_motion *>(garbage.data());
        T domain[2] = {7, 7}, pose[8] = {7};
        const T at = 0;
        EXPECT_EQ(api<T>::motion_domain(domain, motion), MW_ERROR_MOTION);
        EXPECT_EQ(api<T>::sample_motion_one(packed_motors(pose), motion, 0, &at, 1, MW_DEFAULT), MW_ERROR_MOTION);
        EXPECT_EQ(domain[0], T(7));
        EXPECT_EQ(pose[0], T(7));
    }
}

}  // namespace
}  // namespace motorway::testing
