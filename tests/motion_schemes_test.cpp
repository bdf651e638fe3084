// Motions against the library's other functions: what a scheme is when its degree is 1, and what it does with many
// motions and with parameters outside the domain.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

template <class T>
class MotionSchemesTest : public ::testing::Test {
protected:
    using A = api<T>;
    using Pose = typename A::motor;

    static std::vector<Pose> normalized(std::vector<Pose> poses)
    {
        EXPECT_EQ(A::normalize_motor_each(A::motors_aos(poses.data(), sizeof(Pose)),
                                          A::const_motors_aos(poses.data(), sizeof(Pose)), poses.size()),
                  MW_OK);
        return poses;
    }

    static std::vector<T> slerp(const Pose &first, const Pose &second, const std::vector<T> &parameters)
    {
        const std::vector<Pose> from(parameters.size(), first), to(parameters.size(), second);
        std::vector<T> out(8 * parameters.size());
        EXPECT_EQ(A::slerp_motor_each(packed_motors(out.data()), A::const_motors_aos(from.data(), sizeof(Pose)),
                                      A::const_motors_aos(to.data(), sizeof(Pose)), parameters.data(), sizeof(T),
                                      parameters.size(), MW_DEFAULT),
                  MW_OK);
        return out;
    }
};

TYPED_TEST_SUITE(MotionSchemesTest, Precisions, PrecisionName);

// Also of poses that are more than a half turn apart, and of either sign.
TYPED_TEST(MotionSchemesTest, multiplicative_linear_is_slerp_to_the_bit)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(91);
        for (int repetition = 0; repetition < 50; ++repetition) {
            MotionData<T> data;
            data.kind = MW_MOTION_MULTIPLICATIVE;
            data.controls.resize(2);
            for (auto &control : data.controls)
                draw_motor(random, any_unit_regime(random), &control.s);
            data.controls = this->normalized(data.controls);
            const auto parameters = unit_interval<TypeParam>(39);
            EXPECT_TRUE(same_bits(sampled(CompiledMotion<T>(data), parameters),
                                  this->slerp(data.controls[0], data.controls[1], parameters)))
                << isa << ", repetition " << repetition;
        }
    }
}

// Wareham and Lasenby's section 3.1: from each key to the next a screw of its own, and so is the cumulative motion.
TYPED_TEST(MotionSchemesTest, motions_of_degree_1_are_screws_from_pose_to_pose)
{
    using T = TypeParam;
    Random random(92);
    for (mw_motion_kind kind : {MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE}) {
        auto data = random_motion<T>(random, kind, 1, 5);
        data.knots = {0, 1, 2, 4, 8};
        const CompiledMotion<T> motion(data);
        for (std::size_t k = 0; k < 4; ++k) {
            const T begin = data.knots[k], width = data.knots[k + 1] - begin;
            const auto parts = unit_interval<TypeParam>(9);
            std::vector<T> parameters;
            for (T part : parts)
                parameters.push_back(begin + part * width);
            const std::vector<T> out = sampled(motion, parameters);
            const std::vector<T> screw = this->slerp(data.controls[k], data.controls[k + 1], parts);
            for (std::size_t i = 0; i < parts.size(); ++i)
                EXPECT_LE(pose_error(&out[8 * i], exact_pose(&screw[8 * i]), reach_of(data)), 8)
                    << name_of(kind) << ", " << parameters[i];
        }
    }
}

// Equation (5) of the paper; normalised, it is nlerp.
TYPED_TEST(MotionSchemesTest, additive_linear_is_equation_5)
{
    using T = TypeParam;
    using Motor = typename TestFixture::Pose;
    Random random(93);
    const auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 1, 2);
    const auto parameters = unit_interval<TypeParam>(9);
    const std::vector<T> out = sampled(CompiledMotion<T>(data), parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const long double t = parameters[i];
        const auto expected = (1 - t) * exact_pose(&data.controls[0].s) + t * exact_pose(&data.controls[1].s);
        EXPECT_LE(motor_error(&out[8 * i], expected, reach_of(data)), 4);
    }
    auto unit = data;
    unit.controls = this->normalized(data.controls);
    std::vector<Motor> samples(parameters.size()), expected(parameters.size());
    const std::vector<T> of_unit = sampled(CompiledMotion<T>(unit), parameters);
    std::memcpy(static_cast<void *>(samples.data()), of_unit.data(), of_unit.size() * sizeof(T));
    samples = this->normalized(samples);
    EXPECT_EQ(api<T>::nlerp_motor_one(api<T>::motors_aos(expected.data(), sizeof(Motor)), &unit.controls[0],
                                      &unit.controls[1], parameters.data(), sizeof(T), parameters.size(), MW_DEFAULT),
              MW_OK);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        EXPECT_LE(pose_error(&samples[i].s, exact_pose(&expected[i].s), reach_of(data)), 8);
}

// A base of any length and sign moves as the base does, and none is the identity.
TYPED_TEST(MotionSchemesTest, bases_of_generators)
{
    using T = TypeParam;
    Random random(94);
    for (mw_motion_kind kind : {MW_MOTION_GENERATOR, MW_MOTION_GENERATOR_KEYS}) {
        auto data = random_motion<T>(random, kind, 2, 5);
        data.base.clear();
        draw_controls(random, data, 5);
        auto identity = data;
        identity.base = {{1, 0, 0, 0, 0, 0, 0, 0}};
        const auto parameters = parameters_of<T>(random, data.exact(), 20);
        EXPECT_TRUE(same_bits(sampled(CompiledMotion<T>(data), parameters),
                              sampled(CompiledMotion<T>(identity), parameters)));
        identity.base = {rounded_pose<T>(random_displacement(random, 3, 4))};
        draw_controls(random, identity, 5);
        auto multiple = identity;
        for (std::size_t c = 0; c < 8; ++c)
            (&multiple.base[0].s)[c] *= -2;
        const std::vector<T> out = sampled(CompiledMotion<T>(multiple), parameters);
        const std::vector<T> expected = sampled(CompiledMotion<T>(identity), parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            EXPECT_LE(pose_error(&out[8 * i], exact_pose(&expected[8 * i]), reach_of(identity)), 16) << name_of(kind);
    }
}

// Wareham and Lasenby's section 3.2: through three keys, of which the one in the middle is the base (relative) or
// none is (direct).
TYPED_TEST(MotionSchemesTest, three_keys_are_the_quadratic_of_their_generators)
{
    using T = TypeParam;
    using reference::log;
    Random random(95);
    for (bool relative : {false, true}) {
        MotionData<T> data;
        data.kind = MW_MOTION_GENERATOR_KEYS;
        draw_controls(random, data, 3);
        data.knots = {-1, 0, 1};
        if (relative)
            data.base = {data.controls[1]};
        const auto base = relative ? exact_pose(&data.base[0].s) : reference::DualQuaternion();
        reference::DualQuaternion b[3];
        for (std::size_t k = 0; k < 3; ++k)
            b[k] = log(compose(inverse(base), exact_pose(&data.controls[k].s)));
        const std::vector<T> parameters = {-1, T(-0.75), T(-0.25), 0, T(0.5), 1};
        const std::vector<T> out = sampled(CompiledMotion<T>(data), parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const long double t = parameters[i];
            const auto generator = (t * t - t) / 2 * b[0] + (1 - t * t) * b[1] + (t * t + t) / 2 * b[2];
            EXPECT_LE(pose_error(&out[8 * i], compose(base, exp(generator)), reach_of(data)), 16) << parameters[i];
        }
    }
}

// ------------------------------------------------------------------------------------------------------ many motions

template <class T>
MotionData<T> crowd_of(Random &random, mw_motion_kind kind, std::size_t motions, bool closed = false)
{
    auto data = random_motion<T>(random, kind, 3, 6, closed);
    draw_knots(random, data, Ends::clamped, 1);
    if (is_additive(kind))
        data.weights = {1, 2, T(0.5), 1, 3, 1};
    data.motion_count = motions;
    draw_controls(random, data, 6);
    return data;
}

template <class T>
MotionData<T> motion_of(const MotionData<T> &crowd, std::size_t index)
{
    auto data = crowd;
    data.motion_count = 1;
    const auto first = crowd.controls.begin() + static_cast<std::ptrdiff_t>(index * crowd.control_count());
    data.controls.assign(first, first + static_cast<std::ptrdiff_t>(crowd.control_count()));
    return data;
}

// Each as if it were compiled alone: at many parameters, each at its own, all at one, and all at one with a stride.
TYPED_TEST(MotionSchemesTest, many_motions)
{
    using T = TypeParam;
    constexpr std::size_t motions = 37, skipped = 5;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        for (mw_motion_kind kind : all_motion_kinds) {
            Random random(96);
            const auto crowd = crowd_of<T>(random, kind, motions, kind != MW_MOTION_GENERATOR);
            const CompiledMotion<T> together(crowd);
            std::vector<T> parameters;
            for (std::size_t m = 0; m < motions; ++m)
                parameters.push_back(static_cast<T>(random.uniform(together.first(), together.last())));
            const std::size_t count = motions - skipped;
            std::vector<T> each(8 * count), shared(8 * count), poses(8 * count), twists(6 * count);
            EXPECT_EQ(api<T>::sample_motion_each(packed_motors(each.data()), together.get(), skipped,
                                                 parameters.data(), sizeof(T), count, MW_DEFAULT),
                      MW_OK);
            EXPECT_EQ(api<T>::sample_motion_each(packed_motors(shared.data()), together.get(), skipped,
                                                 &parameters[3], 0, count, MW_DEFAULT),
                      MW_OK);
            EXPECT_EQ(api<T>::sample_motion_twist_each(packed_motors(poses.data()), packed_bivectors(twists.data()),
                                                       together.get(), skipped, parameters.data(), sizeof(T), count,
                                                       MW_DEFAULT),
                      MW_OK);
            for (std::size_t i = 0; i < count; ++i) {
                const CompiledMotion<T> alone(motion_of(crowd, skipped + i));
                const std::vector<T> at = {parameters[i], parameters[3]};
                const std::vector<T> expected = sampled(alone, at);
                const Twists<T> moving = twisted(alone, at);
                EXPECT_TRUE(same_bits(sampled(together, at, MW_DEFAULT, skipped + i), expected)) << name_of(kind);
                EXPECT_EQ(std::memcmp(&each[8 * i], &expected[0], sizeof(T[8])), 0) << name_of(kind) << ", " << i;
                EXPECT_EQ(std::memcmp(&shared[8 * i], &expected[8], sizeof(T[8])), 0) << name_of(kind) << ", " << i;
                EXPECT_EQ(std::memcmp(&poses[8 * i], &moving.poses[0], sizeof(T[8])), 0) << name_of(kind);
                EXPECT_EQ(std::memcmp(&twists[6 * i], &moving.twists[0], sizeof(T[6])), 0) << name_of(kind);
            }
        }
    }
}

// Strides between parameters are bytes: every third of an array, and at addresses that are not aligned; one for all.
TYPED_TEST(MotionSchemesTest, strides_of_parameters)
{
    using T = TypeParam;
    Random random(97);
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_CUMULATIVE}) {
        const auto crowd = crowd_of<T>(random, kind, 300);
        const CompiledMotion<T> motion(crowd);
        std::vector<T> parameters;
        for (std::size_t m = 0; m < 300; ++m)
            parameters.push_back(static_cast<T>(random.uniform(motion.first(), motion.last())));
        const auto samples_at = [&](const void *first, std::size_t stride) {
            std::vector<T> out(8 * 300);
            EXPECT_EQ(api<T>::sample_motion_each(packed_motors(out.data()), motion.get(), 0,
                                                 static_cast<const T *>(first), stride, 300, MW_DEFAULT),
                      MW_OK);
            return out;
        };
        const std::vector<T> expected = samples_at(parameters.data(), sizeof(T));
        for (std::size_t stride : {sizeof(T) + 1, 3 * sizeof(T)}) {
            std::vector<unsigned char> bytes(300 * stride + 1);
            for (std::size_t i = 0; i < 300; ++i)
                std::memcpy(&bytes[1 + i * stride], &parameters[i], sizeof(T));
            EXPECT_TRUE(same_bits(samples_at(&bytes[1], stride), expected)) << name_of(kind) << ", stride " << stride;
        }
        const std::vector<T> same(300, parameters[7]);
        EXPECT_TRUE(same_bits(samples_at(&parameters[7], 0), samples_at(same.data(), sizeof(T)))) << name_of(kind);
    }
}

// --------------------------------------------------------------------------------------------- outside of the domain

TYPED_TEST(MotionSchemesTest, clamped_parameters)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(98);
        for (mw_motion_kind kind : all_motion_kinds) {
            const CompiledMotion<T> motion(crowd_of<T>(random, kind, 1));
            const T first = motion.first(), last = motion.last(), middle = (first + last) / 2;
            const T most = std::numeric_limits<T>::max();
            const std::vector<T> outside = {std::nextafter(first, -most), std::nextafter(last, most), middle, -most,
                                            most, first, last};
            const std::vector<T> inside = {first, last, middle, first, last, first, last};
            EXPECT_TRUE(same_bits(sampled(motion, outside, MW_CLAMP_PARAMETERS), sampled(motion, inside)));
            EXPECT_TRUE(same_bits(twisted(motion, outside, MW_CLAMP_PARAMETERS).twists,
                                  twisted(motion, inside).twists));
        }
    }
}

// The domain repeated for ever. Knots, and so periods, are multiples of 1/16, so that every sum here is exact.
TYPED_TEST(MotionSchemesTest, wrapped_parameters)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(99);
        for (mw_motion_kind kind : all_motion_kinds) {
            const CompiledMotion<T> motion(crowd_of<T>(random, kind, 1));
            const T first = motion.first(), last = motion.last(), period = last - first;
            std::vector<T> inside, outside;
            for (int k = 0; k < 50; ++k) {
                const int steps = static_cast<int>(period * 16);
                inside.push_back(first + static_cast<T>(random.below(static_cast<std::size_t>(steps))) / 16);
                outside.push_back(inside.back() + period * static_cast<T>(static_cast<int>(random.below(21)) - 10));
            }
            inside.insert(inside.end(), {first, last});  // both ends are in the domain
            outside.insert(outside.end(), {first, last});
            EXPECT_TRUE(same_bits(sampled(motion, outside, MW_WRAP_PARAMETERS), sampled(motion, inside)))
                << name_of(kind);
        }
    }
}

// Next to the ends, and where a parameter is so large that its neighbours are periods apart: somewhere in the domain.
TYPED_TEST(MotionSchemesTest, wrapped_parameters_that_are_rounded)
{
    using T = TypeParam;
    const T most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::denorm_min();
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        MotionData<T> data;  // along a line, so that b1∞ is half the parameter
        data.controls = {{1, 0, 0, 0, T(0.5), 0, 0, 0}, {1, 0, 0, 0, T(1.5), 0, 0, 0}};
        data.knots = {1, 3};
        const CompiledMotion<T> motion(data);
        const std::vector<T> parameters = {std::nextafter(T(1), T(0)), std::nextafter(T(3), T(4)), least, -least,
                                           most, -most, T(1e30), T(-1e9), T(0.1), T(-0.1), T(4096.3)};
        const std::vector<T> out = sampled(motion, parameters, MW_WRAP_PARAMETERS);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const T at = 2 * out[8 * i + 4];
            EXPECT_TRUE(at >= 1 && at <= 3) << parameters[i] << " became " << at;
            if (std::abs(parameters[i]) < 1e4) {
                const long double exact = 1 + std::fmod(std::fmod(parameters[i] - 1.0L, 2.0L) + 2, 2.0L);
                const long double error = std::abs(at - exact);
                EXPECT_LE(std::min(error, std::abs(error - 2)), (4 + std::abs(parameters[i])) * epsilon<T>)
                    << parameters[i] << " became " << at;
            }
        }
        data.knots = {1, T(1.125)};  // more periods than there are numbers
        for (T half : {sampled(CompiledMotion<T>(data), {most}, MW_WRAP_PARAMETERS)[4],
                       sampled(CompiledMotion<T>(data), {-most}, MW_WRAP_PARAMETERS)[4]})
            EXPECT_TRUE(half >= T(0.5) && half <= T(1.5)) << half;
    }
}

}  // namespace
}  // namespace motorway::testing
