// The group of motors: what is exact, what functions are to each other, and strides of 0.

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_tester.h"
#include "precisions.h"
#include "screws.h"
#include "slerp_tester.h"
#include "subject.h"

namespace motorway::testing {
namespace {

template <class T>
class GroupTest : public ::testing::Test {
protected:
    using A = api<T>;
    using Numbers = std::vector<T>;  // eight a motor, six a bivector

    static auto out_motors(Numbers &n) { return packed_view(n.data(), 8).motors(); }
    static auto in_motors(const Numbers &n) { return packed_view(const_cast<T *>(n.data()), 8).const_motors(); }
    static auto out_bivectors(Numbers &n) { return packed_view(n.data(), 6).bivectors(); }
    static auto in_bivectors(const Numbers &n) { return packed_view(const_cast<T *>(n.data()), 6).const_bivectors(); }
    static const typename A::motor *motor(const Numbers &n)
    {
        return reinterpret_cast<const typename A::motor *>(n.data());
    }

    static Numbers exp(const Numbers &bivectors)
    {
        Numbers result(bivectors.size() / 6 * 8);
        EXPECT_EQ(A::exp_motor_each(out_motors(result), in_bivectors(bivectors), bivectors.size() / 6), MW_OK);
        return result;
    }

    static Numbers log(const Numbers &motors, reference::Branch branch, unsigned flags = MW_UNIT_MOTORS)
    {
        Numbers result(motors.size() / 8 * 6);
        const auto function =
            branch == reference::Branch::shortest ? A::log_motor_each : A::log_principal_motor_each;
        EXPECT_EQ(function(out_bivectors(result), in_motors(motors), motors.size() / 8, flags), MW_OK);
        return result;
    }

    static Numbers sqrt(const Numbers &motors)
    {
        Numbers result(motors.size());
        EXPECT_EQ(A::sqrt_motor_each(out_motors(result), in_motors(motors), motors.size() / 8), MW_OK);
        return result;
    }

    static Numbers inverse(const Numbers &motors)
    {
        Numbers result(motors.size());
        EXPECT_EQ(A::inverse_motor_each(out_motors(result), in_motors(motors), motors.size() / 8), MW_OK);
        return result;
    }

    static Numbers compose(const Numbers &first, const Numbers &then)
    {
        Numbers result(first.size());
        EXPECT_EQ(A::compose_motor_each(out_motors(result), in_motors(first), in_motors(then), first.size() / 8),
                  MW_OK);
        return result;
    }

    static Numbers power(const Numbers &motors, T exponent)
    {
        Numbers result(motors.size());
        EXPECT_EQ(A::power_motor_each(out_motors(result), in_motors(motors), &exponent, 0, motors.size() / 8), MW_OK);
        return result;
    }

    static Numbers ratio(const Numbers &from, const Numbers &to, unsigned flags = MW_DEFAULT)
    {
        Numbers result(from.size());
        EXPECT_EQ(A::ratio_motor_each(out_motors(result), in_motors(from), in_motors(to), from.size() / 8, flags),
                  MW_OK);
        return result;
    }

    static Numbers slerp(const Numbers &first, const Numbers &second, T parameter, unsigned flags = MW_DEFAULT)
    {
        return interpolate(A::slerp_motor_each, first, second, parameter, flags);
    }

    static Numbers nlerp(const Numbers &first, const Numbers &second, T parameter, unsigned flags = MW_DEFAULT)
    {
        return interpolate(A::nlerp_motor_each, first, second, parameter, flags);
    }

    static Numbers interpolate(decltype(A::slerp_motor_each) function, const Numbers &first, const Numbers &second,
                               T parameter, unsigned flags)
    {
        Numbers result(first.size());
        EXPECT_EQ(function(out_motors(result), in_motors(first), in_motors(second), &parameter, 0, first.size() / 8,
                           flags),
                  MW_OK);
        return result;
    }

    static Numbers negated(Numbers numbers)
    {
        for (T &number : numbers)
            number = -number;
        return numbers;
    }

    // S or -S, whichever is nearer to the other.
    static Numbers with_signs_of(const Numbers &others, Numbers motors)
    {
        for (std::size_t i = 0; i < motors.size(); i += 8) {
            long double between = 0;
            for (std::size_t k = 0; k < 4; ++k)
                between += static_cast<long double>(others[i + k]) * motors[i + k];
            for (std::size_t k = 0; k < 8; ++k)
                motors[i + k] = between < 0 ? -motors[i + k] : motors[i + k];
        }
        return motors;
    }

    // Halves of `size` numbers each, rotation and translation: each to so many ε of a size, of the whole half.
    static void expect_close(const Numbers &a, const Numbers &b, std::size_t size, long double rotation,
                             long double translation, const std::function<long double(const T *)> &moment)
    {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); i += size) {
            const long double turn = size == 8 ? 1 : length_of(&b[i], 0, 3);
            for (std::size_t k = 0; k < size; ++k) {
                const bool turns = k < size / 2;
                const long double tolerance =
                    epsilon<T> * (turns ? rotation * turn : translation * moment(&b[i])) + 8 * underflow<T>;
                ASSERT_LE(std::abs(static_cast<long double>(a[i + k]) - b[i + k]), tolerance)
                    << "component " << k << " of element " << i / size << ": " << a[i + k] << " and " << b[i + k];
            }
        }
    }

    static long double translation_of(const T *motor) { return length_of(motor, 4, 8); }
    static long double moment_of(const T *bivector) { return length_of(bivector, 3, 6); }

    static Numbers draw_motors(Random &random, std::size_t count)
    {
        Numbers motors(8 * count);
        for (std::size_t i = 0; i < count; ++i)
            draw_unit_motor(random, &motors[8 * i]);
        return motors;
    }

    struct Pairs {
        Numbers first, second;

        // The longer translation of the pair that an element of either array is of.
        std::function<long double(const T *)> larger_of(const Numbers &of) const
        {
            return [this, begin = of.data()](const T *motor) {
                const auto i = static_cast<std::size_t>(motor - begin);
                return std::max(length_of(&first[i], 4, 8), length_of(&second[i], 4, 8));
            };
        }
    };

    // Poses whose relative motor turns by an angle far from 0 and from half turns, where both ways are well defined.
    static Pairs draw_pairs(Random &random, std::size_t count)
    {
        Pairs pairs{Numbers(8 * count), Numbers(8 * count)};
        for (std::size_t i = 0; i < count; ++i) {
            const long double angle = random.uniform(0.5, 1.5);
            draw_poses(random, Way::longer, random.chance(2) ? angle : pi - angle, &pairs.first[8 * i],
                       &pairs.second[8 * i]);
        }
        return pairs;
    }

    static Numbers draw_bivectors(Random &random, std::size_t count, long double angle)
    {
        Numbers bivectors(6 * count);
        for (std::size_t i = 0; i < count; ++i) {
            const bool tiny = random.chance(3);
            const double size = static_cast<double>(angle);
            const double half = tiny ? std::abs(random.magnitude(1e-30, size)) : random.uniform(0, size);
            round_to(bivector_of(draw_screw(random, half)), &bivectors[6 * i]);
        }
        return bivectors;
    }

    template <class Body>
    static void on_every_isa(Body body)
    {
        for (const std::string &isa : running_isas()) {
            SCOPED_TRACE(isa);
            ScopedIsa scope(isa);
            body();
        }
    }

    // A register and a half of any width, so that both the loop and its tail see each element.
    static Numbers repeated(const Numbers &element)
    {
        Numbers many;
        for (int k = 0; k < 24; ++k)
            many.insert(many.end(), element.begin(), element.end());
        return many;
    }

    static inline const Numbers one = {1, 0, 0, 0, 0, 0, 0, 0};
    static inline const Numbers step = {1, 0, 0, 0, T(0.1), T(-1e20), T(3e-30), 0};
    static inline const Numbers step_log = {0, 0, 0, T(0.1), T(-1e20), T(3e-30)};
    static inline const Numbers nothing = {0, 0, 0, 0, 0, 0};
    static constexpr reference::Branch branches[] = {reference::Branch::shortest, reference::Branch::principal};
};

TYPED_TEST_SUITE(GroupTest, Precisions, PrecisionName);

TYPED_TEST(GroupTest, exp_of_nothing_is_1_and_of_a_translation_exact)
{
    this->on_every_isa([] {
        EXPECT_EQ(TestFixture::exp(TestFixture::repeated(TestFixture::nothing)),
                  TestFixture::repeated(TestFixture::one));
        EXPECT_EQ(TestFixture::exp(TestFixture::repeated(TestFixture::step_log)),
                  TestFixture::repeated(TestFixture::step));
    });
}

// 1, -1 and translations move without turning, whatever their sign; also multiples of them.
TYPED_TEST(GroupTest, log_of_1_and_of_translations_is_exact)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        for (reference::Branch branch : Group::branches)
            for (unsigned flags : {MW_DEFAULT, MW_UNIT_MOTORS})
                for (const auto &[motor, log] : {std::pair(Group::one, Group::nothing),
                                                 std::pair(Group::step, Group::step_log)}) {
                    const auto motors = Group::repeated(motor), logs = Group::repeated(log);
                    EXPECT_EQ(Group::log(motors, branch, flags), logs);
                    EXPECT_EQ(Group::log(Group::negated(motors), branch, flags), logs);
                    auto twice = motors;
                    for (auto &number : twice)
                        number *= -2;
                    EXPECT_EQ(Group::log(twice, branch, MW_DEFAULT), logs);
                }
    });
}

TYPED_TEST(GroupTest, sqrt_and_inverse_of_1_and_of_translations_are_exact)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        auto half = Group::step, back = Group::step;
        for (std::size_t k = 4; k < 8; ++k) {
            half[k] /= 2;
            back[k] = -back[k];
        }
        EXPECT_EQ(Group::sqrt(Group::repeated(Group::one)), Group::repeated(Group::one));
        EXPECT_EQ(Group::sqrt(Group::repeated(Group::negated(Group::one))), Group::repeated(Group::one));
        EXPECT_EQ(Group::sqrt(Group::repeated(Group::step)), Group::repeated(half));
        EXPECT_EQ(Group::sqrt(Group::repeated(Group::negated(Group::step))), Group::repeated(half));
        EXPECT_EQ(Group::inverse(Group::repeated(Group::one)), Group::repeated(Group::one));
        EXPECT_EQ(Group::inverse(Group::repeated(Group::negated(Group::one))),
                  Group::repeated(Group::negated(Group::one)));
        EXPECT_EQ(Group::inverse(Group::repeated(Group::step)), Group::repeated(back));
    });
}

// Half the angle is no more than 1e-30, and less than the root of any number: to the last bit the motor is 1 + B.
TYPED_TEST(GroupTest, rotations_too_small_for_their_square_are_kept)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        for (T size : {T(1e-30), T(1e-25), std::numeric_limits<T>::min()}) {
            const auto bivectors = Group::repeated({size, 0, -2 * size, 1, 2, 3});
            const auto motors = Group::exp(bivectors);
            for (std::size_t i = 0; 8 * i < motors.size(); ++i) {
                EXPECT_EQ(motors[8 * i], T(1));
                for (std::size_t k = 0; k < 6; ++k)
                    EXPECT_EQ(motors[8 * i + 1 + k], bivectors[6 * i + k]) << "component " << k;
            }
            for (reference::Branch branch : Group::branches)
                EXPECT_EQ(Group::log(motors, branch), bivectors);
        }
    });
}

// s is 0 or -0, where S and -S are as short: the logarithm is that of one of them.
TYPED_TEST(GroupTest, half_turns_have_the_logarithm_of_a_quarter_of_a_circle)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        for (T s : {T(0), -T(0)})
            for (reference::Branch branch : Group::branches) {
                const typename Group::Numbers turn = {s, T(0.6), 0, T(-0.8), 0, 2, 0, 0};
                const auto log = Group::log(Group::repeated(turn), branch);
                EXPECT_NEAR(static_cast<double>(length_of(log, 0, 3)), static_cast<double>(pi / 2),
                            static_cast<double>(4 * epsilon<T>));
                auto again = Group::exp(log);
                if (again[1] < 0)
                    again = Group::negated(again);
                Group::expect_close(again, Group::repeated(turn), 8, 6, 6, Group::translation_of);
            }
    });
}

TYPED_TEST(GroupTest, slerp_begins_with_the_first_and_ends_with_the_second)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(71);
        const auto first = Group::draw_motors(random, 300), second = Group::draw_motors(random, 300);
        const auto nearer = Group::with_signs_of(first, second);
        const auto larger = [&](const auto *motor) {
            const bool is_first = first.data() <= motor && motor < first.data() + first.size();
            const auto i = static_cast<std::size_t>(motor - (is_first ? first.data() : nearer.data()));
            return std::max(length_of(&first[i], 4, 8), length_of(&second[i], 4, 8));
        };
        Group::expect_close(Group::slerp(first, second, 0), first, 8, 2, 2, larger);
        Group::expect_close(Group::slerp(first, second, 1), nearer, 8, 2, 2, larger);
        EXPECT_EQ(Group::slerp(first, Group::negated(second), 0.25f), Group::slerp(first, second, 0.25f));
    });
}

TYPED_TEST(GroupTest, slerp_between_translations_is_linear)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        const auto first = Group::repeated({1, 0, 0, 0, -1, 4, 0, 0});
        const auto second = Group::repeated({1, 0, 0, 0, 1, 2, 3, 0});
        EXPECT_EQ(Group::slerp(first, second, 0), first);
        EXPECT_EQ(Group::slerp(first, second, 1), second);
        EXPECT_EQ(Group::slerp(first, second, 0.25f), Group::repeated({1, 0, 0, 0, -0.5f, 3.5f, 0.75f, 0}));
        EXPECT_EQ(Group::slerp(first, Group::negated(second), 0.25f),
                  Group::repeated({1, 0, 0, 0, -0.5f, 3.5f, 0.75f, 0}));
    });
}

TYPED_TEST(GroupTest, slerp_of_a_motor_and_itself_stays_there)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(72);
        const auto motors = Group::draw_motors(random, 300);
        for (float t : {0.f, 0.3f, 0.5f, 1.f})
            Group::expect_close(Group::slerp(motors, motors, t), motors, 8, 4, 4, Group::translation_of);
    });
}

TYPED_TEST(GroupTest, the_long_way_begins_with_the_first_and_ends_with_the_second_turned_once_more)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(84);
        const auto pairs = Group::draw_pairs(random, 300);
        const auto further = Group::negated(Group::with_signs_of(pairs.first, pairs.second));
        const auto &first = pairs.first, &second = pairs.second;
        Group::expect_close(Group::slerp(first, second, 0, MW_LONG_WAY), first, 8, 2, 2, pairs.larger_of(first));
        Group::expect_close(Group::slerp(first, second, 1, MW_LONG_WAY), further, 8, 12, 40,
                            pairs.larger_of(further));
        EXPECT_EQ(Group::slerp(first, Group::negated(second), 0.25f, MW_LONG_WAY),
                  Group::slerp(first, second, 0.25f, MW_LONG_WAY));
    });
}

// Half the angle between the poses is h on the short way and π - h, the other way round, on the long one: halfway
// there its half, where s = cos(½(π - h)) = sin(½h).
TYPED_TEST(GroupTest, the_long_way_turns_by_what_is_missing_to_a_full_turn)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        Random random(85);
        const auto pairs = Group::draw_pairs(random, 300);
        const auto nearer = Group::with_signs_of(pairs.first, pairs.second);
        const auto halfway = Group::slerp(pairs.first, pairs.second, 0.5f, MW_LONG_WAY);
        for (std::size_t i = 0; i < halfway.size(); i += 8) {
            const reference::Motor back = reference::reverse(exact_motor(&pairs.first[i]));
            const reference::Motor whole = reference::compose(back, exact_motor(&nearer[i]));
            const reference::Motor half = reference::compose(back, exact_motor(&halfway[i]));
            const long double h = std::atan2(length_of(whole, 1, 4), static_cast<long double>(whole[0]));
            const reference::Real along = whole[1] * half[1] + whole[2] * half[2] + whole[3] * half[3];
            ASSERT_NEAR(static_cast<double>(static_cast<long double>(half[0])), static_cast<double>(std::sin(h / 2)),
                        static_cast<double>(12 * epsilon<T>))
                << "element " << i / 8;
            ASSERT_LT(static_cast<long double>(along), 0) << "element " << i / 8 << " turns the short way";
        }
    });
}

// There any axis will do, and which one it is rounding decides; what goes about it is a rotation all the same.
TYPED_TEST(GroupTest, the_long_way_from_a_pose_to_itself_is_about_some_axis)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        Random random(90);
        const auto motors = Group::draw_motors(random, 300);
        for (float t : {0.25f, 0.5f, 1.f}) {
            const auto between = Group::slerp(motors, motors, t, MW_LONG_WAY);
            for (std::size_t i = 0; i < between.size(); i += 8)
                ASSERT_NEAR(static_cast<double>(length_of(&between[i], 0, 4)), 1, static_cast<double>(8 * epsilon<T>))
                    << "element " << i / 8 << " at " << t;
        }
    });
}

// They have no long way.
TYPED_TEST(GroupTest, slerp_between_translations_is_linear_the_long_way_too)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        const auto first = Group::repeated({1, 0, 0, 0, -1, 4, 0, 0});
        const auto second = Group::repeated({1, 0, 0, 0, 1, 2, 3, 0});
        const auto quarter = Group::repeated({1, 0, 0, 0, -0.5f, 3.5f, 0.75f, 0});
        EXPECT_EQ(Group::slerp(first, second, 0.25f, MW_LONG_WAY), quarter);
        EXPECT_EQ(Group::slerp(first, Group::negated(second), 0.25f, MW_LONG_WAY), quarter);
    });
}

TYPED_TEST(GroupTest, nlerp_begins_with_the_first_and_ends_with_the_second)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(86);
        const auto pairs = Group::draw_pairs(random, 300);
        const auto &first = pairs.first, &second = pairs.second;
        const auto nearer = Group::with_signs_of(first, second), further = Group::negated(nearer);
        for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
            const auto &last = flags == MW_LONG_WAY ? further : nearer;
            Group::expect_close(Group::nlerp(first, second, 0, flags), first, 8, 3, 6, pairs.larger_of(first));
            Group::expect_close(Group::nlerp(first, second, 1, flags), last, 8, 3, 6, pairs.larger_of(last));
            EXPECT_EQ(Group::nlerp(first, Group::negated(second), 0.25f, flags),
                      Group::nlerp(first, second, 0.25f, flags));
        }
        Group::expect_close(Group::nlerp(first, first, 0.3f), first, 8, 3, 6, Group::translation_of);
    });
}

TYPED_TEST(GroupTest, nlerp_is_the_same_from_either_end)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(87);
        const auto pairs = Group::draw_pairs(random, 300);
        for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY})
            for (float t : {0.125f, 0.25f, 0.5f}) {
                const auto there = Group::nlerp(pairs.first, pairs.second, t, flags);
                const auto back = Group::nlerp(pairs.second, pairs.first, 1 - t, flags);
                const auto same_sign = Group::with_signs_of(there, back);
                Group::expect_close(there, same_sign, 8, 8, 24, pairs.larger_of(same_sign));
            }
    });
}

// The root of a motor is 1 + S, normalised, whatever S is.
TYPED_TEST(GroupTest, nlerp_halfway_is_slerp_halfway)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(88);
        const auto pairs = Group::draw_pairs(random, 300);
        for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
            const auto slerp = Group::slerp(pairs.first, pairs.second, 0.5f, flags);
            Group::expect_close(Group::nlerp(pairs.first, pairs.second, 0.5f, flags), slerp, 8, 12, 40,
                                pairs.larger_of(slerp));
        }
    });
}

TYPED_TEST(GroupTest, nlerp_between_translations_is_linear)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        const auto first = Group::repeated({1, 0, 0, 0, -1, 4, 0, 0});
        const auto second = Group::repeated({1, 0, 0, 0, 1, 2, 3, 0});
        const auto quarter = Group::repeated({1, 0, 0, 0, -0.5f, 3.5f, 0.75f, 0});
        EXPECT_EQ(Group::nlerp(first, second, 0.25f), quarter);
        EXPECT_EQ(Group::nlerp(first, Group::negated(second), 0.25f), quarter);
    });
}

// The product has the errors of three motors, each as large as the longer translation.
TYPED_TEST(GroupTest, the_first_and_then_the_ratio_is_the_second)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(89);
        const auto pairs = Group::draw_pairs(random, 300);
        for (unsigned flags : {MW_DEFAULT, MW_UNIT_MOTORS}) {
            const auto ratio = Group::ratio(pairs.first, pairs.second, flags);
            Group::expect_close(Group::compose(pairs.first, ratio), pairs.second, 8, 4, 10,
                                pairs.larger_of(pairs.second));
        }
        auto multiples = pairs.first;  // of a motor any multiple will do
        for (std::size_t i = 0; i < multiples.size(); ++i)
            multiples[i] *= i / 8 % 2 ? 8 : -0.5f;
        Group::expect_close(Group::compose(multiples, Group::ratio(multiples, pairs.second)), pairs.second, 8, 4, 10,
                            pairs.larger_of(pairs.second));
    });
}

TYPED_TEST(GroupTest, exp_of_the_shortest_logarithm_is_the_motor_up_to_its_sign)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(73);
        const auto motors = Group::draw_motors(random, 2000);
        const auto again = Group::exp(Group::log(motors, reference::Branch::shortest));
        for (std::size_t i = 0; i < again.size(); i += 8)
            ASSERT_GE(again[i], -6 * epsilon<TypeParam>) << "element " << i / 8;
        Group::expect_close(again, Group::with_signs_of(again, motors), 8, 6, 6, Group::translation_of);
    });
}

// For s < 0 the rotation of the logarithm is of a size of up to π, and what it is rounded by, 2ε of that, turns the
// motor. The moment is that of the accuracy tests.
TYPED_TEST(GroupTest, exp_of_the_principal_logarithm_is_the_motor_itself)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(74);
        const auto motors = Group::draw_motors(random, 2000);
        const auto again = Group::exp(Group::log(motors, reference::Branch::principal));
        const auto grows = [](const auto *motor) {
            const long double sine = length_of(motor, 1, 4);
            return length_of(motor, 4, 8) * (motor[0] < -0.1f ? 2 + 2 / sine : 1);
        };
        Group::expect_close(again, motors, 8, 8, 6, grows);
    });
}

// Up to half turns; principal a little further.
TYPED_TEST(GroupTest, log_of_exp_is_the_bivector)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(75);
        const auto shorter = Group::draw_bivectors(random, 2000, pi / 2 - 1e-5L);
        Group::expect_close(Group::log(Group::exp(shorter), reference::Branch::shortest), shorter, 6, 6, 6,
                           Group::moment_of);
        const auto longer = Group::draw_bivectors(random, 2000, pi / 2 + 0.1L);
        Group::expect_close(Group::log(Group::exp(longer), reference::Branch::principal), longer, 6, 6, 6,
                           Group::moment_of);
    });
}

// The error of exp(b), and of rounding it, becomes n times as large: within nε for half the angle up to ½. The last
// product alone may cost the translation one more.
TYPED_TEST(GroupTest, the_nth_power_of_exp_is_exp_of_the_multiple)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        Random random(76);
        const auto bivectors = Group::draw_bivectors(random, 40, 0.5L);
        const auto base = Group::exp(bivectors);
        auto product = base;
        for (int n = 2; n <= 1000; ++n) {
            product = Group::compose(product, base);
            if (n != 2 && n != 10 && n != 100 && n != 1000)
                continue;
            SCOPED_TRACE(n);
            for (std::size_t i = 0; 6 * i < bivectors.size(); ++i) {
                const auto multiple = reference::multiple(reference::Real(n), exact_bivector(&bivectors[6 * i]));
                const reference::Motor exact = reference::exp(multiple);
                const long double moment = length_of(multiple, 3, 6);
                const Expected expected =
                    expect_parts(exact, n * epsilon<T>, (n + 1) * epsilon<T> * moment + n * underflow<T>);
                const auto message = compare(expected, &product[8 * i]);
                ASSERT_FALSE(message) << "bivector " << i << ": " << *message;
            }
        }
    });
}

TYPED_TEST(GroupTest, powers_with_simple_exponents)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(77);
        const auto motors = Group::draw_motors(random, 300);
        typename Group::Numbers ones;
        for (std::size_t i = 0; i < motors.size(); i += 8)
            ones.insert(ones.end(), Group::one.begin(), Group::one.end());
        EXPECT_EQ(Group::power(motors, 0), ones);
        const auto translation = Group::translation_of;
        EXPECT_EQ(Group::power(motors, 1), Group::exp(Group::log(motors, reference::Branch::shortest)));
        Group::expect_close(Group::power(motors, 0.5f), Group::sqrt(motors), 8, 6, 12, translation);
        const auto back = Group::power(motors, -1);
        Group::expect_close(back, Group::with_signs_of(back, Group::inverse(motors)), 8, 8, 8, translation);
    });
}

TYPED_TEST(GroupTest, the_square_of_the_root_is_the_motor_up_to_its_sign)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(78);
        const auto motors = Group::draw_motors(random, 2000);
        const auto roots = Group::sqrt(motors);
        for (std::size_t i = 0; i < roots.size(); i += 8)
            ASSERT_GE(roots[i], 0.7f) << "element " << i / 8;
        const auto squares = Group::compose(roots, roots);
        Group::expect_close(squares, Group::with_signs_of(squares, motors), 8, 6, 10, Group::translation_of);
    });
}

// Of motors of any size; the product has errors relative to that of both translations.
TYPED_TEST(GroupTest, a_motor_times_its_inverse_is_1)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        Random random(79);
        auto motors = Group::draw_motors(random, 300);
        for (std::size_t i = 0; i < motors.size(); i += 8) {
            const auto factor = static_cast<TypeParam>(random.magnitude(1e-3, 1e3));
            for (std::size_t k = 0; k < 8; ++k)
                motors[i + k] *= factor;
        }
        typename Group::Numbers ones;
        for (std::size_t i = 0; i < motors.size(); i += 8)
            ones.insert(ones.end(), Group::one.begin(), Group::one.end());
        const auto size = [&](const auto *unit) {
            const auto *motor = &motors[static_cast<std::size_t>(unit - ones.data())];
            return length_of(motor, 4, 8) / length_of(motor, 0, 4);
        };
        Group::expect_close(Group::compose(motors, Group::inverse(motors)), ones, 8, 6, 12, size);
        Group::expect_close(Group::compose(Group::inverse(motors), motors), ones, 8, 6, 12, size);
    });
}

// The bits of an array that holds the same number everywhere.
TYPED_TEST(GroupTest, a_stride_of_0_is_one_number_for_all)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        Random random(80);
        for (std::size_t count : {1, 2, 7, 16, 33, 100, 255, 256, 257, 600}) {
            const auto first = Group::draw_motors(random, count), second = Group::draw_motors(random, count);
            const std::vector<T> numbers(count, T(0.3));
            typename Group::Numbers many(8 * count), once(8 * count);
            const auto expect_same = [&](auto function) {
                std::fill(many.begin(), many.end(), T(7));
                std::fill(once.begin(), once.end(), T(8));
                ASSERT_EQ(function(Group::out_motors(many), numbers.data(), sizeof(T)), MW_OK);
                ASSERT_EQ(function(Group::out_motors(once), &numbers[0], std::size_t(0)), MW_OK);
                EXPECT_EQ(std::memcmp(many.data(), once.data(), many.size() * sizeof(T)), 0) << count;
            };
            expect_same([&](auto out, const T *number, std::size_t stride) {
                return api<T>::power_motor_each(out, Group::in_motors(first), number, stride, count);
            });
            for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
                for (const auto interpolate : {api<T>::slerp_motor_each, api<T>::nlerp_motor_each})
                    expect_same([&](auto out, const T *number, std::size_t stride) {
                        return interpolate(out, Group::in_motors(first), Group::in_motors(second), number, stride,
                                           count, flags);
                    });
                for (const auto interpolate : {api<T>::slerp_motor_one, api<T>::nlerp_motor_one})
                    expect_same([&](auto out, const T *number, std::size_t stride) {
                        return interpolate(out, Group::motor(first), Group::motor(second), number, stride, count,
                                           flags);
                    });
            }
        }
    });
}

TYPED_TEST(GroupTest, slerp_between_two_fixed_motors_is_that_of_each)
{
    using Group = TestFixture;
    using T = TypeParam;
    this->on_every_isa([] {
        Random random(81);
        const auto first = Group::draw_motors(random, 1), second = Group::draw_motors(random, 1);
        std::vector<T> parameters;
        for (int k = 0; k < 24; ++k)
            parameters.push_back(static_cast<T>(random.uniform(0, 1)));
        const auto firsts = Group::repeated(first), seconds = Group::repeated(second);
        typename Group::Numbers each(firsts.size()), fixed(firsts.size());
        ASSERT_EQ(api<T>::slerp_motor_each(Group::out_motors(each), Group::in_motors(firsts),
                                           Group::in_motors(seconds), parameters.data(), sizeof(T),
                                           parameters.size(), MW_DEFAULT),
                  MW_OK);
        ASSERT_EQ(api<T>::slerp_motor_one(Group::out_motors(fixed), Group::motor(first), Group::motor(second),
                                          parameters.data(), sizeof(T), parameters.size(), MW_DEFAULT),
                  MW_OK);
        const auto larger = [&](const T *) { return std::max(length_of(first, 4, 8), length_of(second, 4, 8)); };
        Group::expect_close(fixed, each, 8, 4, 4, larger);
    });
}

// No result looks sound: a NaN or an infinity in any component spoils its own element, and no other.
TYPED_TEST(GroupTest, what_is_not_finite_stays_in_its_element_and_shows)
{
    using Group = TestFixture;
    using T = TypeParam;
    using Batch = std::vector<T>;
    using Limits = std::numeric_limits<T>;
    const auto expect_spoilt = [](const Batch &clean, std::size_t size, auto function) {
        const Batch before = function(clean);
        const std::size_t count = clean.size() / size, out_size = before.size() / count;
        for (T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()})
            for (std::size_t place : {std::size_t(0), std::size_t(16), count - 1})
                for (std::size_t k = 0; k < size; ++k) {
                    Batch spoilt = clean;
                    spoilt[place * size + k] = bad;
                    const Batch after = function(spoilt);
                    bool shows = false;
                    for (std::size_t c = 0; c < after.size(); ++c)
                        if (c / out_size == place)
                            shows = shows || !std::isfinite(after[c]);
                        else
                            ASSERT_TRUE(same(after[c], before[c])) << "number " << c;
                    EXPECT_TRUE(shows) << bad << " in component " << k << " of element " << place;
                }
    };
    this->on_every_isa([&] {
        Random random(82);
        const Batch motors = Group::draw_motors(random, 37), bivectors = Group::draw_bivectors(random, 37, pi);
        const Batch others = Group::draw_motors(random, 37);
        expect_spoilt(bivectors, 6, Group::exp);
        for (reference::Branch branch : Group::branches)
            for (unsigned flags : {MW_DEFAULT, MW_UNIT_MOTORS})
                expect_spoilt(motors, 8, [&](const Batch &n) { return Group::log(n, branch, flags); });
        expect_spoilt(motors, 8, Group::sqrt);
        expect_spoilt(motors, 8, Group::inverse);
        expect_spoilt(motors, 8, [](const Batch &n) { return Group::power(n, T(0.3)); });
        for (const auto function : {Group::slerp, Group::nlerp})
            for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
                expect_spoilt(motors, 8, [&](const Batch &n) { return function(n, others, T(0.3), flags); });
                expect_spoilt(motors, 8, [&](const Batch &n) { return function(others, n, T(0.3), flags); });
            }
        for (unsigned flags : {MW_DEFAULT, MW_UNIT_MOTORS}) {
            expect_spoilt(motors, 8, [&](const Batch &n) { return Group::ratio(n, others, flags); });
            expect_spoilt(motors, 8, [&](const Batch &n) { return Group::ratio(others, n, flags); });
        }
    });
}

// s above all: a rotation by NaN is no 1.
TYPED_TEST(GroupTest, exp_of_an_angle_that_is_nan_is_nan_in_every_rotation_component_it_reaches)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        for (std::size_t k = 0; k < 3; ++k) {
            auto bivector = Group::nothing;
            bivector[k] = std::numeric_limits<TypeParam>::quiet_NaN();
            const auto motors = Group::exp(Group::repeated(bivector));
            for (std::size_t i = 0; i < motors.size(); i += 8) {
                ASSERT_TRUE(std::isnan(motors[i])) << "s of element " << i / 8;
                ASSERT_TRUE(std::isnan(motors[i + 1 + k])) << "component " << k + 1 << " of element " << i / 8;
            }
        }
    });
}

TYPED_TEST(GroupTest, a_degenerate_motor_has_no_logarithm_or_inverse_and_is_reported)
{
    using Group = TestFixture;
    this->on_every_isa([] {
        const auto zeros = Group::repeated({0, 0, 0, 0, 1, 2, 3, 4});
        std::size_t bad = 7;
        EXPECT_EQ(api<TypeParam>::check_motors(Group::in_motors(zeros), 24, &bad), MW_ERROR_DEGENERATE_MOTOR);
        EXPECT_EQ(bad, 0u);
        for (const auto &result : {Group::inverse(zeros), Group::log(zeros, reference::Branch::shortest, MW_DEFAULT),
                                   Group::log(zeros, reference::Branch::principal, MW_DEFAULT)})
            for (std::size_t i = 0, size = result.size() / 24; i < 24; ++i) {
                bool finite = true;
                for (std::size_t k = 0; k < size; ++k)
                    finite = finite && std::isfinite(result[i * size + k]);
                EXPECT_FALSE(finite) << "element " << i;
            }
    });
}

// The product of all motors so far, 64 at a time. Sixteen such products at once, one a lane.
TYPED_TEST(GroupTest, a_million_products_with_renormalisation_every_64_stay_rigid)
{
    using Group = TestFixture;
    using T = TypeParam;
    Random random(83);
    const std::size_t lanes = 16, length = 1000000 / lanes;
    typename Group::Numbers product = Group::draw_motors(random, lanes);
    typename Group::Numbers factors(8 * 64 * lanes);
    for (std::size_t i = 0; i < 64 * lanes; ++i)
        draw_motor(random, Regime::general, &factors[8 * i]);
    long double worst = 0;
    for (std::size_t n = 0; n < length; ++n) {
        const typename Group::Numbers factor(&factors[8 * lanes * (n * 37 % 64)],
                                            &factors[8 * lanes * (n * 37 % 64)] + 8 * lanes);
        product = Group::compose(product, factor);
        if (n % 64 != 63 && n + 1 != length)
            continue;
        ASSERT_EQ(api<T>::normalize_motor_each(Group::out_motors(product), Group::in_motors(product), lanes), MW_OK);
        for (std::size_t i = 0; i < lanes; ++i) {
            const long double size = length_of(&product[8 * i], 0, 4);
            worst = std::max(worst, std::abs(size * size - 1));
        }
    }
    EXPECT_LE(worst, sizeof(T) == sizeof(float) ? 1e-6L : 1e-14L);
    for (T number : product)
        EXPECT_TRUE(std::isfinite(number));
    for (std::size_t i = 0; i < lanes; ++i) {
        const long double beta = static_cast<long double>(reference::beta(exact_motor(&product[8 * i])));
        EXPECT_LE(std::abs(beta), 8 * epsilon<T> * length_of(&product[8 * i], 4, 8));
    }
}

}  // namespace
}  // namespace motorway::testing
