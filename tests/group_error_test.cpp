// What can be wrong with calls of the group's functions beyond their views, which error_test.cpp spoils for every
// kernel: flags, fixed motors, numbers, hierarchies. And that nothing is written then.

#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();

template <class T>
class GroupErrorTest : public ::testing::Test {
protected:
    using Motor = typename api<T>::motor;
    static constexpr std::size_t motor_count = 6;

    GroupErrorTest() : numbers_(8 * 3 * motor_count + 64, T(1)) {}

    T *first() { return &numbers_[0]; }
    T *second() { return &numbers_[8 * motor_count]; }
    T *out() { return &numbers_[16 * motor_count]; }
    T *parameters() { return &numbers_[24 * motor_count]; }  // 64
    static const Motor *motor(const T *components) { return reinterpret_cast<const Motor *>(components); }
    static auto motors(T *components) { return packed_view(components, 8).motors(); }
    static auto const_motors(T *components) { return packed_view(components, 8).const_motors(); }

    template <class Call>
    void expect(mw_status status, Call call)
    {
        const std::vector<T> before = numbers_;
        const mw_status got = call();
        EXPECT_EQ(got, status) << mw_status_text(got);
        EXPECT_EQ(std::memcmp(before.data(), numbers_.data(), before.size() * sizeof(T)), 0) << "bytes changed";
    }

private:
    std::vector<T> numbers_;
};

TYPED_TEST_SUITE(GroupErrorTest, Precisions, PrecisionName);

TYPED_TEST(GroupErrorTest, flags_that_logarithms_do_not_know)
{
    using A = api<TypeParam>;
    for (const auto function : {A::log_motor_each, A::log_principal_motor_each}) {
        const auto run = [&](unsigned flags, std::size_t count) {
            return function(packed_view(this->out(), 6).bivectors(), this->const_motors(this->first()), count, flags);
        };
        for (unsigned flags : {unsigned(MW_STREAMING_STORES), unsigned(MW_NO_STREAMING_STORES),
                               unsigned(MW_UNIT_MOTORS | MW_STREAMING_STORES), unsigned(MW_LONG_WAY), 1u << 20, ~0u})
            this->expect(MW_ERROR_FLAGS, [&] { return run(flags, this->motor_count); });
        EXPECT_EQ(run(MW_DEFAULT, this->motor_count), MW_OK);
        EXPECT_EQ(run(MW_UNIT_MOTORS, this->motor_count), MW_OK);
    }
}

TYPED_TEST(GroupErrorTest, flags_that_interpolation_does_not_know)
{
    using A = api<TypeParam>;
    const auto out = this->motors(this->out());
    const auto in = this->const_motors(this->first()), then = this->const_motors(this->second());
    const auto *const a = this->motor(this->first()), *const b = this->motor(this->second());
    const std::size_t stride = sizeof(TypeParam), count = this->motor_count;
    const auto each_of_them = [&](auto body) {
        for (const auto each : {A::slerp_motor_each, A::nlerp_motor_each})
            body([&, each](unsigned flags) { return each(out, in, then, this->parameters(), stride, count, flags); });
        for (const auto one : {A::slerp_motor_one, A::nlerp_motor_one})
            body([&, one](unsigned flags) { return one(out, a, b, this->parameters(), stride, count, flags); });
    };
    each_of_them([&](auto run) {
        for (unsigned flags : {unsigned(MW_UNIT_MOTORS), unsigned(MW_STREAMING_STORES), unsigned(MW_NEAREST_ROTATION),
                               unsigned(MW_LONG_WAY | MW_UNIT_MOTORS), 1u << 20, ~0u})
            this->expect(MW_ERROR_FLAGS, [&] { return run(flags); });
    });
    each_of_them([&](auto run) {
        EXPECT_EQ(run(MW_DEFAULT), MW_OK);
        EXPECT_EQ(run(MW_LONG_WAY), MW_OK);
    });
}

TYPED_TEST(GroupErrorTest, flags_that_ratios_do_not_know)
{
    using A = api<TypeParam>;
    const auto run = [&](unsigned flags) {
        return A::ratio_motor_each(this->motors(this->out()), this->const_motors(this->first()),
                                   this->const_motors(this->second()), this->motor_count, flags);
    };
    for (unsigned flags : {unsigned(MW_STREAMING_STORES), unsigned(MW_LONG_WAY), unsigned(MW_NEAREST_ROTATION),
                           unsigned(MW_UNIT_MOTORS | MW_LONG_WAY), 1u << 20, ~0u})
        this->expect(MW_ERROR_FLAGS, [&] { return run(flags); });
    EXPECT_EQ(run(MW_DEFAULT), MW_OK);
    EXPECT_EQ(run(MW_UNIT_MOTORS), MW_OK);
}

TYPED_TEST(GroupErrorTest, no_fixed_motor)
{
    using A = api<TypeParam>;
    const auto out = this->motors(this->out());
    const auto in = this->const_motors(this->first());
    const auto *const motor = this->motor(this->second());
    const std::size_t count = this->motor_count, stride = sizeof(TypeParam);
    this->expect(MW_ERROR_NULL, [&] { return A::compose_motor_one_first(out, nullptr, in, count); });
    this->expect(MW_ERROR_NULL, [&] { return A::compose_motor_one_then(out, in, nullptr, count); });
    for (const auto function : {A::slerp_motor_one, A::nlerp_motor_one})
        for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
            const auto run = [&](const auto *first, const auto *second) {
                return function(out, first, second, this->parameters(), stride, count, flags);
            };
            this->expect(MW_ERROR_NULL, [&] { return run(decltype(motor)(nullptr), motor); });
            this->expect(MW_ERROR_NULL, [&] { return run(motor, decltype(motor)(nullptr)); });
        }
    EXPECT_EQ(A::compose_motor_one_first(out, motor, in, count), MW_OK);
    EXPECT_EQ(A::compose_motor_one_then(out, in, motor, count), MW_OK);
}

// By its first number or its last; and that the one that is read is right in front of the output is none.
TYPED_TEST(GroupErrorTest, an_output_over_a_fixed_motor)
{
    using T = TypeParam;
    using A = api<T>;
    const std::size_t count = this->motor_count, stride = sizeof(T);
    const auto in = this->const_motors(this->first());
    T *const out = this->out();
    const auto *const other = this->motor(this->second());
    for (T *place : {out, out - 7, out + 8 * (count - 1), out + 8 * count - 1}) {
        const auto *const fixed = this->motor(place);
        this->expect(MW_ERROR_OVERLAP,
                     [&] { return A::compose_motor_one_first(this->motors(out), fixed, in, count); });
        this->expect(MW_ERROR_OVERLAP,
                     [&] { return A::compose_motor_one_then(this->motors(out), in, fixed, count); });
        for (const auto function : {A::slerp_motor_one, A::nlerp_motor_one})
            for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
                const auto run = [&](const auto *a, const auto *b) {
                    return function(this->motors(out), a, b, this->parameters() + 8, stride, count, flags);
                };
                this->expect(MW_ERROR_OVERLAP, [&] { return run(fixed, other); });
                this->expect(MW_ERROR_OVERLAP, [&] { return run(other, fixed); });
            }
    }
    EXPECT_EQ(A::compose_motor_one_first(this->motors(out), this->motor(out - 8), in, count), MW_OK);
    EXPECT_EQ(A::compose_motor_one_then(this->motors(out), in, this->motor(out + 8 * count), count), MW_OK);
}

// With a stride of 0 there is one, which may be null or under the output no more than many.
TYPED_TEST(GroupErrorTest, one_number_for_all_that_is_wrong)
{
    using T = TypeParam;
    using A = api<T>;
    const std::size_t count = this->motor_count;
    T *const out = this->out();
    const auto to = this->motors(out);
    const auto in = this->const_motors(this->first()), then = this->const_motors(this->second());
    const auto *const a = this->motor(this->first()), *const b = this->motor(this->second());
    const auto expect_all = [&](mw_status status, const T *number, std::size_t stride) {
        this->expect(status, [&] { return A::power_motor_each(to, in, number, stride, count); });
        for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
            for (const auto each : {A::slerp_motor_each, A::nlerp_motor_each})
                this->expect(status, [&] { return each(to, in, then, number, stride, count, flags); });
            for (const auto one : {A::slerp_motor_one, A::nlerp_motor_one})
                this->expect(status, [&] { return one(to, a, b, number, stride, count, flags); });
        }
    };
    expect_all(MW_ERROR_NULL, nullptr, 0);
    expect_all(MW_ERROR_NULL, nullptr, sizeof(T));
    for (std::size_t stride : {std::size_t(1), sizeof(T) - 1})
        expect_all(MW_ERROR_STRIDE, this->parameters(), stride);
    expect_all(MW_ERROR_SIZE, this->parameters(), most / 4);
    for (const T *number : {out, out + 3, out + 8 * count - 1})
        expect_all(MW_ERROR_OVERLAP, number, 0);
    EXPECT_EQ(A::power_motor_each(to, in, out - 1, 0, count), MW_OK);
    EXPECT_EQ(A::power_motor_each(to, in, out + 8 * count, 0, count), MW_OK);
}

TYPED_TEST(GroupErrorTest, a_count_of_0_takes_null_pointers)
{
    using T = TypeParam;
    using A = api<T>;
    const auto out = A::motors_aos(nullptr, 0);
    const auto in = A::const_motors_aos(nullptr, 0);
    EXPECT_EQ(A::compose_motor_one_first(out, nullptr, in, 0), MW_OK);
    EXPECT_EQ(A::compose_motor_one_then(out, in, nullptr, 0), MW_OK);
    EXPECT_EQ(A::inverse_motor_each(out, in, 0), MW_OK);
    EXPECT_EQ(A::exp_motor_each(out, {}, 0), MW_OK);
    EXPECT_EQ(A::log_motor_each({}, in, 0, MW_DEFAULT), MW_OK);
    EXPECT_EQ(A::log_principal_motor_each({}, in, 0, MW_UNIT_MOTORS), MW_OK);
    EXPECT_EQ(A::sqrt_motor_each(out, in, 0), MW_OK);
    EXPECT_EQ(A::power_motor_each(out, in, nullptr, 0, 0), MW_OK);
    EXPECT_EQ(A::ratio_motor_each(out, in, in, 0, MW_UNIT_MOTORS), MW_OK);
    for (unsigned flags : {MW_DEFAULT, MW_LONG_WAY}) {
        EXPECT_EQ(A::slerp_motor_each(out, in, in, nullptr, 0, 0, flags), MW_OK);
        EXPECT_EQ(A::slerp_motor_one(out, nullptr, nullptr, nullptr, 0, 0, flags), MW_OK);
        EXPECT_EQ(A::nlerp_motor_each(out, in, in, nullptr, 0, 0, flags), MW_OK);
        EXPECT_EQ(A::nlerp_motor_one(out, nullptr, nullptr, nullptr, 0, 0, flags), MW_OK);
    }
    EXPECT_EQ(A::compose_motor_hierarchy(out, in, 0, nullptr, 5, 0, nullptr), MW_OK);
    EXPECT_EQ(A::compose_motor_hierarchy(out, in, 0, nullptr, 0, 5, nullptr), MW_OK);
}

// Two instances of three joints, side by side: six motors.
template <class T>
struct Hierarchy {
    using A = api<T>;
    typename A::motors out;
    typename A::const_motors locals;
    std::size_t joint_stride = 2 * sizeof(T[8]), joints = 3, instances = 2;
    std::int32_t parent[3] = {-1, 0, 1};
    const std::int32_t *parents = parent;
    std::size_t bad = 1234;

    mw_status run()
    {
        return A::compose_motor_hierarchy(out, locals, joint_stride, parents, joints, instances, &bad);
    }
};

TYPED_TEST(GroupErrorTest, a_parent_that_does_not_come_before_its_joint)
{
    using T = TypeParam;
    for (std::size_t joint : {0, 1, 2})
        for (std::int32_t parent : {static_cast<std::int32_t>(joint), static_cast<std::int32_t>(joint) + 1, 3,
                                    std::numeric_limits<std::int32_t>::max()}) {
            Hierarchy<T> hierarchy{this->motors(this->out()), this->const_motors(this->first())};
            hierarchy.parent[joint] = parent;
            this->expect(MW_ERROR_PARENT, [&] { return hierarchy.run(); });
            EXPECT_EQ(hierarchy.bad, joint);
            this->expect(MW_ERROR_PARENT, [&] {
                return api<T>::compose_motor_hierarchy(hierarchy.out, hierarchy.locals, hierarchy.joint_stride,
                                                       hierarchy.parents, 3, 2, nullptr);
            });
        }
    Hierarchy<T> two{this->motors(this->out()), this->const_motors(this->first())};
    two.parent[1] = 1;
    two.parent[2] = 2;
    this->expect(MW_ERROR_PARENT, [&] { return two.run(); });
    EXPECT_EQ(two.bad, 1u) << "the first of two";
    Hierarchy<T> sound{this->motors(this->out()), this->const_motors(this->first())};
    EXPECT_EQ(sound.run(), MW_OK);
    EXPECT_EQ(sound.bad, 1234u) << "written though nothing is wrong";
}

TYPED_TEST(GroupErrorTest, null_pointers_in_a_hierarchy)
{
    using T = TypeParam;
    const Hierarchy<T> sound{this->motors(this->out()), this->const_motors(this->first())};
    for (auto component : {&api<T>::motors::s, &api<T>::motors::b23, &api<T>::motors::w}) {
        Hierarchy<T> spoilt = sound;
        spoilt.out.*component = nullptr;
        this->expect(MW_ERROR_NULL, [&] { return spoilt.run(); });
    }
    for (auto component : {&api<T>::const_motors::s, &api<T>::const_motors::b1i, &api<T>::const_motors::w}) {
        Hierarchy<T> spoilt = sound;
        spoilt.locals.*component = nullptr;
        this->expect(MW_ERROR_NULL, [&] { return spoilt.run(); });
    }
    Hierarchy<T> spoilt = sound;
    spoilt.parents = nullptr;
    this->expect(MW_ERROR_NULL, [&] { return spoilt.run(); });
}

// Too small for a motor, or for the joints of one instance not to run into those of the next.
TYPED_TEST(GroupErrorTest, strides_of_a_hierarchy_that_share_bytes)
{
    using T = TypeParam;
    const std::size_t motor = sizeof(T[8]);
    const Hierarchy<T> sound{this->motors(this->out()), this->const_motors(this->first())};
    for (std::size_t joint_stride : {std::size_t(0), std::size_t(1), sizeof(T), motor - 1, motor, 2 * motor - 1}) {
        Hierarchy<T> spoilt = sound;
        spoilt.joint_stride = joint_stride;
        this->expect(MW_ERROR_STRIDE, [&] { return spoilt.run(); });
    }
    for (std::size_t stride : {std::size_t(0), sizeof(T), motor - 1, motor + 1, 2 * motor}) {
        Hierarchy<T> spoilt = sound;
        spoilt.locals.stride = stride;
        this->expect(MW_ERROR_STRIDE, [&] { return spoilt.run(); });
        spoilt = sound;
        spoilt.out.stride = stride;
        this->expect(MW_ERROR_STRIDE, [&] { return spoilt.run(); });
    }
    // Skeletons one after the other: three motors from one to the next.
    Hierarchy<T> skeletons = sound;
    skeletons.joint_stride = motor;
    skeletons.locals.stride = skeletons.out.stride = 3 * motor;
    EXPECT_EQ(skeletons.run(), MW_OK);
    skeletons.locals.stride = 3 * motor - 1;
    this->expect(MW_ERROR_STRIDE, [&] { return skeletons.run(); });
}

TYPED_TEST(GroupErrorTest, a_hierarchy_beyond_the_address_space)
{
    using T = TypeParam;
    const Hierarchy<T> sound{this->motors(this->out()), this->const_motors(this->first())};
    for (std::size_t large : {most, most / 2, most / sizeof(T[8]) + 1}) {
        Hierarchy<T> spoilt = sound;
        spoilt.joints = large;
        this->expect(MW_ERROR_SIZE, [&] { return spoilt.run(); });
        spoilt = sound;
        spoilt.instances = large;
        this->expect(MW_ERROR_SIZE, [&] { return spoilt.run(); });
    }
    for (std::size_t joint_stride : {most, most / 2, most / 4}) {
        Hierarchy<T> spoilt = sound;
        spoilt.joint_stride = joint_stride;
        this->expect(MW_ERROR_SIZE, [&] { return spoilt.run(); });
    }
}

// In place is fine; an element further, or with the parents under the result, is not.
TYPED_TEST(GroupErrorTest, a_hierarchy_whose_output_overlaps_its_inputs)
{
    using T = TypeParam;
    const std::size_t all = 6 * 8;
    for (T *out : {this->first() + 1, this->first() + 8, this->first() + 16, this->first() + all - 1}) {
        Hierarchy<T> spoilt{this->motors(out), this->const_motors(this->first())};
        this->expect(MW_ERROR_OVERLAP, [&] { return spoilt.run(); });
    }
    Hierarchy<T> parents{this->motors(this->out()), this->const_motors(this->first())};
    for (T *place : {this->out(), this->out() + all - 2}) {
        std::memcpy(place, parents.parent, 2 * sizeof parents.parent[0]);
        parents.parents = reinterpret_cast<const std::int32_t *>(place);
        parents.joints = 2;
        parents.joint_stride = 4 * sizeof(T[8]);
        this->expect(MW_ERROR_OVERLAP, [&] { return parents.run(); });
    }
    Hierarchy<T> in_place{this->motors(this->first()), this->const_motors(this->first())};
    EXPECT_EQ(in_place.run(), MW_OK);
}

}  // namespace
}  // namespace motorway::testing
