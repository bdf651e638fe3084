// Samples of motions of every kind against the reference: degrees, knots, closed motions, weights, both ends, and
// parameters in any order.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

using reference::DualQuaternion;

// The weights of an additive motion lie between 0 and 1, and each level of the recursion splits them by a quotient of
// two differences: at most 6 roundings of numbers up to 1, so after d levels a weight is off by no more than 3dε; the
// sum over d + 1 controls adds ½(d + 1)ε, and their own weights 1ε. The error is relative to the controls of the
// span: a weight may be close to 0 because two numbers cancel, and then its own relative error is not small. The sign
// is the same all along the motion.
template <class T>
void expect_additive(const MotionData<T> &data, const std::vector<T> &parameters, const std::vector<T> &out,
                     unsigned flags)
{
    const reference::Motion exact = data.exact(0, flags);
    const long double sign = dot_of_rotations(exact_pose(out.data()), exact.at(parameters[0])) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const std::size_t span = exact.span_of(parameters[i]);
        const auto expected = motor_numbers(sign * exact.at(parameters[i], span));
        for (std::size_t c = 0; c < 8; ++c) {
            long double magnitude = 0;
            for (const DualQuaternion &control : exact.controls_of(span))
                magnitude += std::abs(motor_numbers(control)[c]);
            const long double epsilons = 1 + 3.5L * static_cast<long double>(data.degree + 1);
            ASSERT_LE(std::abs(static_cast<long double>(out[8 * i + c]) - expected[c]),
                      epsilons * (epsilon<T> * magnitude + underflow<T>))
                << data.name() << ", parameter " << parameters[i] << ", component " << c;
        }
    }
}

// A logarithm, an exponential and a product have a few epsilons each; the errors of the d levels of a tableau, or of
// the d factors of a product, add up. Lengths are a few times those of the controls and the base.
template <class T>
void expect_poses(const MotionData<T> &data, const std::vector<T> &parameters, const std::vector<T> &out)
{
    const reference::Motion exact = data.exact();
    const long double reach = reach_of(data);
    const long double levels = is_of_keys(data.kind) ? 3 + swing_of(exact) : static_cast<long double>(data.degree);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        ASSERT_LE(pose_error(&out[8 * i], exact.at(parameters[i]), reach), 8 * (1 + levels))
            << data.name() << ", parameter " << parameters[i];
    }
}

template <class T>
void expect_reference(const MotionData<T> &data, const std::vector<T> &parameters, unsigned flags = MW_DEFAULT)
{
    const CompiledMotion<T> motion(data, flags);
    if (::testing::Test::HasFailure())
        return;
    const std::vector<T> out = sampled(motion, parameters);
    if (is_additive(data.kind))
        expect_additive(data, parameters, out, flags);
    else
        expect_poses(data, parameters, out);
}

template <class T>
class MotionTest : public ::testing::Test {
protected:
    // The body once for every instruction set, with the same numbers, until one fails.
    template <class Body>
    void on_every_isa(Body body)
    {
        for (const std::string &isa : running_isas()) {
            SCOPED_TRACE(isa);
            ScopedIsa scope(isa);
            body();
            if (this->HasFailure())
                return;
        }
    }
};

TYPED_TEST_SUITE(MotionTest, Precisions, PrecisionName);

TYPED_TEST(MotionTest, every_kind_and_degree_with_knots_of_all_sorts)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(51);
        for (mw_motion_kind kind : all_motion_kinds)
            for (std::size_t degree : {1, 2, 3, 4, 5, 8})
                for (int repetition = 0; repetition < 6; ++repetition) {
                    const std::size_t controls = degree + 1 + random.below(8);
                    auto data = random_motion<T>(random, kind, degree, controls, repetition % 3 == 2);
                    draw_knots(random, data, repetition % 3 ? Ends::clamped : Ends::free,
                               is_additive(kind) ? degree + 1 : degree);
                    expect_reference(data, parameters_of<T>(random, data.exact(), 6));
                    if (this->HasFailure())
                        return;
                }
    });
}

// They are copied and stored, gaps included: what was in the memory before must not be.
TYPED_TEST(MotionTest, every_byte_is_written)
{
    using T = TypeParam;
    using A = api<T>;
    Random random(54);
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t degree : {1, 2, 3, 7})
            for (bool closed : {false, true}) {
                const auto data = random_motion<T>(random, kind, degree, degree + 2, closed);
                const auto description = data.view();
                std::size_t size = 0;
                ASSERT_EQ(A::motion_size(&size, &description, nullptr), MW_OK);
                std::vector<double> memory[2];
                for (const int before : {0, 1}) {
                    memory[before].resize((size + 7) / 8);
                    std::memset(memory[before].data(), before ? 0xa5 : 0x5a, size);
                    const typename A::compiled_motion *compiled;
                    ASSERT_EQ(A::compile_motion(&compiled, memory[before].data(), size, &description, MW_DEFAULT,
                                                nullptr),
                              MW_OK);
                }
                EXPECT_EQ(std::memcmp(memory[0].data(), memory[1].data(), size), 0) << data.name();
            }
}

TYPED_TEST(MotionTest, default_knots)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(52);
        for (mw_motion_kind kind : all_motion_kinds)
            for (std::size_t degree : {1, 2, 3, 6})
                for (std::size_t extra : {1, 2, 5})
                    for (bool closed : {false, true}) {
                        const auto data = random_motion<T>(random, kind, degree, degree + extra, closed);
                        expect_reference(data, parameters_of<T>(random, data.exact(), 4));
                        if (this->HasFailure())
                            return;
                    }
    });
}

// The largest degree, whose binomial coefficients go up to 3e8; and an additive motion of a wide range of knots.
TYPED_TEST(MotionTest, the_largest_degree)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(53);
        for (mw_motion_kind kind : all_motion_kinds)
            for (std::size_t extra : {1, 4}) {
                auto data = random_motion<T>(random, kind, MW_MAX_DEGREE, MW_MAX_DEGREE + extra);
                draw_knots(random, data, extra == 1 ? Ends::clamped : Ends::free, 3);
                expect_reference(data, parameters_of<T>(random, data.exact(), 4));
            }
    });
}

// Spans are found in a table of equal cells. Cubes are very unequal: many knots in one cell, and many cells in one
// span; at the start or at the end of the domain.
TYPED_TEST(MotionTest, spans_of_very_different_lengths)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(62);
        for (bool at_end : {false, true}) {
            auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 2, 200);
            for (int k = 0; k <= 200; ++k) {
                const int from_end = at_end ? 200 - k : k;
                data.knots.push_back(static_cast<T>((at_end ? -1 : 1) * from_end * from_end * from_end));
            }
            expect_reference(data, parameters_of<T>(random, data.exact(), 200));
        }
    });
}

TYPED_TEST(MotionTest, rational_motions)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(54);
        for (std::size_t degree : {1, 2, 3, 5})
            for (bool closed : {false, true}) {
                auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 4, closed);
                for (std::size_t k = 0; k < data.control_count(); ++k)
                    data.weights.push_back(static_cast<T>(std::abs(random.magnitude(0.1, 10))));
                draw_knots(random, data, Ends::clamped, degree);
                expect_reference(data, parameters_of<T>(random, data.exact(), 10));
            }
    });
}

// Weights are factors of the controls, and one weight for all is a factor of the motion: the same poses.
TYPED_TEST(MotionTest, weights_are_factors_of_the_controls)
{
    using T = TypeParam;
    Random random(55);
    const auto plain = random_motion<T>(random, MW_MOTION_ADDITIVE, 3, 8);
    auto weighted = plain, scaled = plain, even = plain;
    for (std::size_t k = 0; k < plain.control_count(); ++k) {
        const T weight = std::ldexp(T(1), static_cast<int>(random.below(5)) - 2);  // a power of two is exact
        weighted.weights.push_back(weight);
        even.weights.push_back(4);
        for (std::size_t c = 0; c < 8; ++c)
            (&scaled.controls[k].s)[c] *= weight;
    }
    const auto parameters = parameters_of<T>(random, plain.exact(), 50);
    const auto of = [&](const MotionData<T> &data) { return sampled(CompiledMotion<T>(data), parameters); };
    EXPECT_TRUE(same_bits(of(weighted), of(scaled)));
    std::vector<T> four_times = of(plain);
    for (T &number : four_times)
        number *= 4;
    EXPECT_TRUE(same_bits(of(even), four_times));
}

// Controls whose signs are as they come: sums that nearly cancel are further off, but not of their controls.
TYPED_TEST(MotionTest, additive_motions_that_keep_signs)
{
    using T = TypeParam;
    Random random(56);
    for (std::size_t degree : {1, 3, 4}) {
        auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, degree, degree + 4);
        for (auto &control : data.controls)
            for (std::size_t c = 0; random.chance(2) && c < 8; ++c)
                (&control.s)[c] *= -1;
        expect_reference(data, parameters_of<T>(random, data.exact(0, MW_KEEP_SIGNS), 20), MW_KEEP_SIGNS);
    }
}

// Where a knot is repeated degree + 1 times the motion jumps, and the knot itself belongs to what comes after.
TYPED_TEST(MotionTest, is_taken_from_the_right_at_a_knot)
{
    using T = TypeParam;
    Random random(57);
    auto data = random_motion<T>(random, MW_MOTION_ADDITIVE, 2, 6);
    data.knots = {0, 0, 1, 1, 1, 2, 2};
    const std::vector<T> out = sampled(CompiledMotion<T>(data), {T(1), std::nextafter(T(1), T(0))});
    EXPECT_LE(pose_error(&out[0], exact_pose(&data.controls[3].s), reach_of(data)), 2);
    EXPECT_LE(pose_error(&out[8], exact_pose(&data.controls[2].s), reach_of(data)), 40);
}

// ----------------------------------------------------------------------------------------------------- ends and keys

// How far from its control an end pose or a key pose may be, in epsilons. A sum has it to the bit, and so has a
// cumulative motion where a span begins, which it is based on. A tableau adds a quarter of an epsilon a level where
// it has many. Generators go through a logarithm and an exponential, which leave three; the last pose of a cumulative
// motion of degree d goes through d of these and d products.
template <class T>
long double most_epsilons(const MotionData<T> &data, bool is_last)
{
    const long double degree = static_cast<long double>(data.degree);
    switch (data.kind) {
    case MW_MOTION_ADDITIVE: return 0;
    case MW_MOTION_MULTIPLICATIVE: return data.degree > 3 ? 2 + degree / 4 : 2;
    case MW_MOTION_CUMULATIVE: return is_last ? 3 + 1.5L * degree : 0;
    default: return 3.5L;
    }
}

TYPED_TEST(MotionTest, clamped_motions_meet_their_end_poses)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(58);
        for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                    MW_MOTION_GENERATOR})
            for (std::size_t degree : {1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 4, 5, 6, 11, 31}) {
                auto data = random_motion<T>(random, kind, degree, degree + 3);
                const T first_knot = static_cast<T>(random.uniform(0, 0.3));
                data.knots.assign(degree, first_knot);
                data.knots.push_back(first_knot + static_cast<T>(random.uniform(0.1, 0.2)));
                data.knots.push_back(first_knot + static_cast<T>(random.uniform(0.2, 0.4)));
                data.knots.resize(2 * degree + 2, T(0.7));
                const std::vector<T> out = sampled(CompiledMotion<T>(data), {first_knot, T(0.7)});
                const auto first = exact_pose(&data.controls.front().s), last = exact_pose(&data.controls.back().s);
                const long double reach = reach_of(data);
                EXPECT_LE(pose_error(&out[0], first, reach), most_epsilons(data, false)) << data.name();
                EXPECT_LE(pose_error(&out[8], last, reach), most_epsilons(data, true)) << data.name();
                if (is_additive(kind)) {
                    EXPECT_EQ(motor_error(&out[0], first), 0) << data.name();
                    EXPECT_EQ(motor_error(&out[8], last), 0) << data.name();
                }
            }
    });
}

// Knots of multiplicity d, keys, and every pose of a motion of degree 1.
TYPED_TEST(MotionTest, motions_meet_their_key_poses)
{
    using T = TypeParam;
    this->on_every_isa([&] {
        Random random(59);
        for (mw_motion_kind kind : all_motion_kinds)
            for (std::size_t degree : {1, 3})
                for (bool closed : {false, true}) {
                    const std::size_t keys = 6, between = is_of_keys(kind) ? 1 : degree;
                    if (closed && between > 1)
                        continue;
                    auto data = random_motion<T>(random, kind, degree, (keys - 1) * between + 1, closed);
                    std::vector<T> times;
                    for (std::size_t k = 0; k < keys; ++k) {
                        times.push_back(static_cast<T>(k * k) / 4 + static_cast<T>(k) / 8);
                        data.knots.insert(data.knots.end(), between, times.back());
                    }
                    if (closed)
                        data.knots.push_back(T(10));
                    const std::vector<T> out = sampled(CompiledMotion<T>(data), times);
                    for (std::size_t k = 0; k < keys; ++k) {
                        const auto key = exact_pose(&data.controls[k * between].s);
                        EXPECT_LE(pose_error(&out[8 * k], key, reach_of(data)),
                                  most_epsilons(data, k + 1 == keys && !closed))
                            << data.name() << ", key " << k;
                    }
                }
    });
}

// Of one or two floating-point numbers, at 1 and where numbers are as small as they may be.
TYPED_TEST(MotionTest, the_shortest_domains)
{
    using T = TypeParam;
    Random random(63);
    for (mw_motion_kind kind : all_motion_kinds)
        for (bool at_one : {false, true}) {
            auto data = random_motion<T>(random, kind, 1, 2);
            data.knots = {0, std::numeric_limits<T>::min()};
            if (at_one)
                data.knots = {1, 1 + std::numeric_limits<T>::epsilon()};
            const std::vector<T> out = sampled(CompiledMotion<T>(data), data.knots);
            for (std::size_t k : {0, 1})
                EXPECT_LE(pose_error(&out[8 * k], exact_pose(&data.controls[k].s), reach_of(data)),
                          most_epsilons(data, k == 1))
                    << data.name();
        }
}

TYPED_TEST(MotionTest, the_domain)
{
    using T = TypeParam;
    Random random(60);
    for (mw_motion_kind kind : all_motion_kinds)
        for (bool closed : {false, true})
            for (bool knots : {false, true}) {
                auto data = random_motion<T>(random, kind, 3, 7, closed);
                if (knots)
                    draw_knots(random, data, Ends::free, 2);
                const CompiledMotion<T> motion(data);
                EXPECT_EQ(motion.first(), data.exact().first()) << data.name();
                EXPECT_EQ(motion.last(), data.exact().last()) << data.name();
            }
}

// The end of a closed motion is its start, of one sign or the other.
TYPED_TEST(MotionTest, closed_motions_come_back)
{
    using T = TypeParam;
    Random random(61);
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t degree : {1, 2, 3}) {
            auto data = random_motion<T>(random, kind, degree, 6, true);
            draw_knots(random, data, Ends::free, 1);
            const CompiledMotion<T> motion(data);
            const std::vector<T> out = sampled(motion, {motion.first(), motion.last()});
            EXPECT_LE(pose_error(&out[8], exact_pose(&out[0]), reach_of(data)), 4) << data.name();
        }
}

// A motion that turns once about an axis until it is closed: the controls come back with the other sign, and the
// motion goes on as if nothing were.
TYPED_TEST(MotionTest, a_closed_motion_that_turns_once)
{
    using T = TypeParam;
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE}) {
        MotionData<T> data;
        data.kind = kind;
        data.degree = 3;
        data.closed = true;
        for (int k = 0; k < 5; ++k) {
            const double half = 3.14159265358979323846 * k / 5;
            const T c = static_cast<T>(std::cos(half)), s = static_cast<T>(std::sin(half));
            data.controls.push_back({c, s, 0, 0, 0, 0, 0, 0});
        }
        std::vector<T> parameters;
        for (int k = 0; k <= 40; ++k)
            parameters.push_back(static_cast<T>(k) / 8);
        expect_reference(data, parameters);
        // It turns the same way everywhere, at a speed that is almost constant.
        const Twists<T> all = twisted(CompiledMotion<T>(data), parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            EXPECT_NEAR(all.twists[6 * i], 3.14159265358979323846 / 5, 0.02)
                << name_of(kind) << ", " << parameters[i];
    }
}

}  // namespace
}  // namespace motorway::testing
