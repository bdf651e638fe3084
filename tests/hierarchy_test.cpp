// Poses along a hierarchy: the bits of one product after the other, in every layout, in place or not.

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

// Where the motor of a joint of an instance is, and how large the whole is.
struct Arrangement {
    const char *name;
    std::size_t stride, joint_stride, component_stride, bytes;
};

template <class T>
std::vector<Arrangement> arrangements(std::size_t joints, std::size_t count)
{
    const std::size_t scalar = sizeof(T), motor = 8 * scalar, all = joints * count, gap = 3 * scalar;
    return {
        {"instances side by side, packed", motor, count * motor, scalar, all * motor},
        {"instances side by side, with gaps", motor + gap, count * (motor + gap) + gap, scalar,
         joints * (count * (motor + gap) + gap)},
        {"instances side by side, an array a component", scalar, count * scalar, all * scalar, all * motor},
        {"instances side by side, arrays a joint", scalar, 8 * count * scalar, count * scalar, all * motor},
        {"skeletons one after the other, packed", joints * motor, motor, scalar, all * motor},
        {"skeletons one after the other, with gaps", joints * (motor + gap) + gap, motor + gap, scalar,
         count * (joints * (motor + gap) + gap)},
        {"skeletons one after the other, an array a component", joints * scalar, scalar, all * scalar, all * motor},
    };
}

template <class T>
class Skeletons {
public:
    Skeletons(const Arrangement &arrangement, std::size_t joints, std::size_t count)
        : arrangement_(arrangement), joints_(joints), count_(count), bytes_(arrangement.bytes, 0xa5)
    {
    }

    View<T> view()
    {
        View<T> view;
        for (std::size_t c = 0; c < 8; ++c)
            view.component.push_back(reinterpret_cast<T *>(bytes_.data() + c * arrangement_.component_stride));
        view.stride = arrangement_.stride;
        return view;
    }

    void set(std::size_t joint, std::size_t instance, const T *motor)
    {
        for (std::size_t c = 0; c < 8; ++c)
            std::memcpy(at(joint, instance, c), motor + c, sizeof(T));
    }

    bool operator==(const Skeletons &other) const { return bytes_ == other.bytes_; }

private:
    unsigned char *at(std::size_t joint, std::size_t instance, std::size_t c)
    {
        return bytes_.data() + joint * arrangement_.joint_stride + instance * arrangement_.stride +
               c * arrangement_.component_stride;
    }

    Arrangement arrangement_;
    std::size_t joints_, count_;
    std::vector<unsigned char> bytes_;
};

// Several roots; the parent of any other joint is one before it, mostly the last.
std::vector<std::int32_t> draw_parents(Random &random, std::size_t joints)
{
    std::vector<std::int32_t> parents;
    for (std::size_t j = 0; j < joints; ++j) {
        const auto last = static_cast<std::int32_t>(j) - 1;
        const bool is_root = j == 0 || random.chance(16);
        const std::int32_t root = random.chance(2) ? -1 : std::numeric_limits<std::int32_t>::min();
        parents.push_back(is_root ? root : random.chance(2) ? last : static_cast<std::int32_t>(random.below(j)));
    }
    return parents;
}

// Instance after instance, joint after joint, one product at a time.
template <class T>
std::vector<T> plain_loop(const std::vector<T> &locals, const std::vector<std::int32_t> &parents, std::size_t count)
{
    std::vector<T> poses = locals;
    const auto motor = [&](std::size_t joint, std::size_t i) { return &poses[8 * (joint * count + i)]; };
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t joint = 0; joint < parents.size(); ++joint)
            if (parents[joint] >= 0) {
                T *const parent = motor(static_cast<std::size_t>(parents[joint]), i);
                const View<T> pose = packed_view(motor(joint, i), 8);
                EXPECT_EQ(api<T>::compose_motor_each(pose.motors(), pose.const_motors(),
                                                     packed_view(parent, 8).const_motors(), 1),
                          MW_OK);
            }
    return poses;
}

template <class T>
class HierarchyTest : public ::testing::Test {};

TYPED_TEST_SUITE(HierarchyTest, Precisions, PrecisionName);

template <class T>
void expect_plain_loop(Random &random, std::size_t joints, std::size_t count)
{
    const std::vector<std::int32_t> parents = draw_parents(random, joints);
    std::vector<T> locals(8 * joints * count);
    for (T &number : locals)
        number = static_cast<T>(random.uniform(-1, 1));
    const std::vector<T> poses = plain_loop(locals, parents, count);
    for (const Arrangement &arrangement : arrangements<T>(joints, count)) {
        SCOPED_TRACE(std::string(arrangement.name) + ", " + std::to_string(joints) + " joints, " +
                     std::to_string(count) + " instances");
        Skeletons<T> given(arrangement, joints, count), expected = given, out = given;
        for (std::size_t joint = 0; joint < joints; ++joint)
            for (std::size_t i = 0; i < count; ++i) {
                given.set(joint, i, &locals[8 * (joint * count + i)]);
                expected.set(joint, i, &poses[8 * (joint * count + i)]);
            }
        const auto run = [&](Skeletons<T> &to, Skeletons<T> &from) {
            return api<T>::compose_motor_hierarchy(to.view().motors(), from.view().const_motors(),
                                                   arrangement.joint_stride, parents.data(), joints, count, nullptr);
        };
        ASSERT_EQ(run(out, given), MW_OK);
        EXPECT_TRUE(out == expected) << "into another array";
        ASSERT_EQ(run(given, given), MW_OK);
        EXPECT_TRUE(given == expected) << "in place";
    }
}

TYPED_TEST(HierarchyTest, has_the_bits_of_the_plain_loop)
{
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Random random(91);
        for (std::size_t joints : {1, 2, 5, 64})
            for (std::size_t count : {1, 2, 7, 16, 17, 63, 64, 65, 130, 200})
                expect_plain_loop<TypeParam>(random, joints, count);
    }
}

// Joints of two fields, or of one that is both: `first` is where the world motor begins in a joint of `size` numbers,
// whose local motor begins at 0.
template <class T>
void expect_fields(std::size_t size, std::size_t first, bool backwards, std::size_t joints, std::size_t count)
{
    Random random(92);
    const std::vector<std::int32_t> parents = draw_parents(random, joints);
    std::vector<T> locals(8 * joints * count);
    for (T &number : locals)
        number = static_cast<T>(random.uniform(-1, 1));
    const std::vector<T> poses = plain_loop(locals, parents, count);
    const std::size_t joint = size * sizeof(T);
    for (bool skeletons_in_turn : {false, true}) {
        const std::size_t stride = skeletons_in_turn ? joints * joint : joint;
        const std::size_t joint_stride = skeletons_in_turn ? joint : count * joint;
        std::vector<T> memory(size * joints * count, T(5));
        const auto begin = [&](std::size_t j, std::size_t i) {
            return memory.data() + (j * joint_stride + i * stride) / sizeof(T);
        };
        for (std::size_t j = 0; j < joints; ++j)
            for (std::size_t i = 0; i < count; ++i)
                std::copy_n(&locals[8 * (j * count + i)], 8, begin(j, i));
        View<T> local = packed_view(memory.data(), 8), world = packed_view(memory.data() + first, 8);
        local.stride = world.stride = stride;
        if (backwards)
            std::reverse(world.component.begin(), world.component.end());
        ASSERT_EQ(api<T>::compose_motor_hierarchy(world.motors(), local.const_motors(), joint_stride, parents.data(),
                                                  joints, count, nullptr),
                  MW_OK)
            << size << " " << first;
        for (std::size_t j = 0; j < joints; ++j)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < 8; ++c)
                    ASSERT_EQ(begin(j, i)[first + (backwards ? 7 - c : c)], poses[8 * (j * count + i) + c])
                        << "joint " << j << " of " << i << ", world from number " << first << " of " << size;
    }
}

TYPED_TEST(HierarchyTest, local_and_world_motors_are_fields_of_joints)
{
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        for (std::size_t joints : {1, 2, 33})
            for (std::size_t count : {1, 2, 17, 65}) {
                expect_fields<TypeParam>(16, 8, false, joints, count);
                expect_fields<TypeParam>(19, 8, true, joints, count);
                expect_fields<TypeParam>(8, 0, true, joints, count);
                expect_fields<TypeParam>(11, 3, false, joints, count);
            }
    }
}

// A chain of quarter turns about e3, each a step along e1 from the last: the fourth joint is back at the root.
TYPED_TEST(HierarchyTest, a_parent_moves_its_children)
{
    using T = TypeParam;
    using Motor = typename api<T>::motor;
    const T axis[3] = {0, 0, 1}, offset[3] = {1, 0, 0}, origin[3] = {0, 0, 0};
    Motor turn, step, local;
    ASSERT_EQ(api<T>::rotation(&turn, axis, static_cast<T>(1.57079632679489661923), nullptr), MW_OK);
    ASSERT_EQ(api<T>::translation(&step, offset), MW_OK);
    ASSERT_EQ(api<T>::compose_motor_each(api<T>::motors_aos(&local, sizeof local),
                                         api<T>::const_motors_aos(&turn, sizeof turn),
                                         api<T>::const_motors_aos(&step, sizeof step), 1),
              MW_OK);
    const std::vector<Motor> locals(5, local);
    std::vector<Motor> poses(5);
    const std::int32_t parents[5] = {-1, 0, 1, 2, -1};
    ASSERT_EQ(api<T>::compose_motor_hierarchy(api<T>::motors_aos(poses.data(), sizeof local),
                                              api<T>::const_motors_aos(locals.data(), sizeof local), sizeof local,
                                              parents, 5, 1, nullptr),
              MW_OK);
    const T expected[5][2] = {{1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}};
    for (std::size_t joint = 0; joint < 5; ++joint) {
        T moved[3];
        ASSERT_EQ(api<T>::apply_point_one(api<T>::xyz_aos(moved, sizeof moved), &poses[joint],
                                          api<T>::const_xyz_aos(origin, sizeof origin), 1, MW_DEFAULT),
                  MW_OK);
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(static_cast<double>(moved[k]), static_cast<double>(expected[joint][k]),
                        static_cast<double>(20 * epsilon<T>))
                << "joint " << joint << ", coordinate " << k;
    }
}

}  // namespace
}  // namespace motorway::testing
