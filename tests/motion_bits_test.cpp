// A sample depends on its motion and its parameter alone: not on the layout, on the place in the batch, on what comes
// before it, on where the compiled motion lies, or on the instruction set within its class. And no byte is touched
// that is not the caller's to give.

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "guarded_buffer.h"
#include "layout.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

// Elements of a few components in a layout, each block of it against a forbidden page, filled with a pattern.
template <class T>
class GuardedView {
public:
    GuardedView(std::vector<GuardedBuffer> &buffers, const Layout &layout, std::size_t components, std::size_t count,
                Guard guard)
        : count_(count), placement_(layout.place(components, count, sizeof(T)))
    {
        for (std::size_t size : placement_.block_sizes) {
            blocks_.push_back(buffers[blocks_.size()].place(size, guard));
            std::memset(blocks_.back(), pattern, size);
        }
        view.stride = placement_.stride;
        for (const auto &[block, offset] : placement_.component)
            view.component.push_back(reinterpret_cast<T *>(blocks_[block] + offset));
    }

    // The elements are those expected, which are adjacent, and all other bytes as they were.
    void expect(const T *expected, const std::string &what)
    {
        const std::size_t components = view.component.size();
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t c = 0; c < components; ++c) {
                auto *address = reinterpret_cast<unsigned char *>(view.component[c]) + i * view.stride;
                ASSERT_EQ(std::memcmp(address, &expected[components * i + c], sizeof(T)), 0)
                    << what << ", count " << count_ << ", element " << i << ", component " << c;
                std::memset(address, pattern, sizeof(T));
            }
        for (std::size_t b = 0; b < blocks_.size(); ++b)
            for (std::size_t k = 0; k < placement_.block_sizes[b]; ++k)
                ASSERT_EQ(blocks_[b][k], pattern) << what << ", count " << count_ << ", byte " << k;
    }

    View<T> view;

private:
    static constexpr unsigned char pattern = 0xa7;
    std::size_t count_;
    Placement placement_;
    std::vector<unsigned char *> blocks_;
};

std::vector<GuardedBuffer> guarded_buffers(std::size_t count)
{
    std::vector<GuardedBuffer> buffers;
    for (std::size_t k = 0; k < count; ++k)
        buffers.emplace_back(32768);
    return buffers;
}

template <class T>
class MotionBitsTest : public ::testing::Test {
protected:
    static MotionData<T> motion_of(Random &random, mw_motion_kind kind)
    {
        auto data = random_motion<T>(random, kind, 3, 9);
        draw_knots(random, data, Ends::clamped, 2);
        return data;
    }

    // One call a parameter.
    static Twists<T> alone(const CompiledMotion<T> &motion, const std::vector<T> &parameters)
    {
        Twists<T> all;
        for (T t : parameters) {
            const Twists<T> one = twisted(motion, {t});
            all.poses.insert(all.poses.end(), one.poses.begin(), one.poses.end());
            all.twists.insert(all.twists.end(), one.twists.begin(), one.twists.end());
        }
        return all;
    }
};

TYPED_TEST_SUITE(MotionBitsTest, Precisions, PrecisionName);

// Counts below, at and above every width; poses and twists in layouts of their own; parameters, and the compiled
// motion itself, against pages of theirs, on either side.
TYPED_TEST(MotionBitsTest, every_layout_and_count_and_nothing_else_is_touched)
{
    using T = TypeParam;
    auto poses = guarded_buffers(8), twists = guarded_buffers(6);
    GuardedBuffer placed_parameters(4096), placed_motion(32768);
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(131);
        for (mw_motion_kind kind : all_motion_kinds) {
            const auto data = this->motion_of(random, kind);
            const CompiledMotion<T> motion(data);
            std::vector<T> parameters = parameters_of<T>(random, data.exact(), 70);
            const Twists<T> expected = this->alone(motion, parameters);
            for (Guard guard : {Guard::after, Guard::before}) {
                const std::vector<Layout> layouts = Layout::all(8, sizeof(T));
                const std::vector<Layout> twist_layouts = Layout::all(6, sizeof(T));
                for (std::size_t k = 0; k < layouts.size(); ++k)
                    for (std::size_t count : {0, 1, 3, 8, 17, 33, 70}) {
                        const std::string what = isa + ": " + data.name() + ", " + layouts[k].name();
                        const T *from = placed_parameters.place_copy(parameters.data(), count, guard);
                        // Aligned to 8 bytes, as it must be.
                        auto *memory = placed_motion.place((motion.size() + 7) / 8 * 8, guard);
                        std::memcpy(memory, motion.get(), motion.size());
                        const auto *compiled = reinterpret_cast<const typename api<T>::compiled_motion *>(memory);
                        GuardedView<T> out(poses, layouts[k], 8, count, guard);
                        GuardedView<T> rates(twists, twist_layouts[(k + count) % 10], 6, count, guard);
                        ASSERT_EQ(api<T>::sample_motion_one(out.view.motors(), compiled, 0, from, count, MW_DEFAULT),
                                  MW_OK);
                        out.expect(expected.poses.data(), what);
                        ASSERT_EQ(api<T>::sample_motion_twist_one(out.view.motors(), rates.view.bivectors(), compiled,
                                                                  0, from, count, MW_DEFAULT),
                                  MW_OK);
                        out.expect(expected.poses.data(), what + ", with twists");
                        rates.expect(expected.twists.data(), what + ", twists");
                        if (this->HasFatalFailure())
                            return;
                    }
            }
        }
    }
}

// Sorted, as they come, backwards, and cut into ranges.
TYPED_TEST(MotionBitsTest, samples_do_not_depend_on_one_another)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(132);
        for (mw_motion_kind kind : all_motion_kinds) {
            const auto data = this->motion_of(random, kind);
            const CompiledMotion<T> motion(data);
            std::vector<T> parameters = parameters_of<T>(random, data.exact(), 300);
            for (int order = 0; order < 3; ++order) {
                if (order)
                    std::sort(parameters.begin(), parameters.end());
                if (order == 2)
                    std::reverse(parameters.begin(), parameters.end());
                const Twists<T> expected = this->alone(motion, parameters);
                const Twists<T> together = twisted(motion, parameters);
                EXPECT_TRUE(same_bits(together.poses, expected.poses)) << isa << ": " << name_of(kind) << order;
                EXPECT_TRUE(same_bits(together.twists, expected.twists)) << isa << ": " << name_of(kind) << order;
                std::vector<T> parts;
                for (std::size_t begin = 0, count = 1; begin < parameters.size(); begin += count, count += 3) {
                    const std::size_t end = std::min(begin + count, parameters.size());
                    const auto first = parameters.begin();
                    const std::vector<T> part(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end));
                    const std::vector<T> out = sampled(motion, part);
                    parts.insert(parts.end(), out.begin(), out.end());
                }
                EXPECT_TRUE(same_bits(parts, expected.poses)) << isa << ": " << name_of(kind) << order;
            }
        }
    }
}

TYPED_TEST(MotionBitsTest, agree_within_a_class_of_instruction_sets)
{
    using T = TypeParam;
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t degree : {1, 3, 5}) {
            Random random(133);
            auto data = random_motion<T>(random, kind, degree, degree + 6);
            draw_knots(random, data, Ends::clamped, degree);
            const std::vector<T> parameters = parameters_of<T>(random, data.exact(), 100);
            const auto period = static_cast<T>(data.exact().last() - data.exact().first());
            std::vector<T> beyond = parameters;
            for (T &t : beyond)
                t += period * T(2.5);
            Twists<T> of_class[2], wrapped_of_class[2];
            for (const std::string &isa : running_isas()) {
                ScopedIsa scope(isa);
                const CompiledMotion<T> motion(data);
                const Twists<T> out = twisted(motion, parameters);
                const Twists<T> wrapped = twisted(motion, beyond, MW_WRAP_PARAMETERS);
                Twists<T> &first = of_class[fuses(isa)], &first_wrapped = wrapped_of_class[fuses(isa)];
                if (first.poses.empty()) {
                    first = out;
                    first_wrapped = wrapped;
                }
                EXPECT_TRUE(same_bits(first.poses, out.poses)) << isa << ": " << data.name();
                EXPECT_TRUE(same_bits(first.twists, out.twists)) << isa << ": " << data.name();
                EXPECT_TRUE(same_bits(first_wrapped.poses, wrapped.poses)) << isa << ": " << data.name();
            }
        }
}

// Compiling is not a matter of the instruction set: a motion compiled on one is sampled on another.
TYPED_TEST(MotionBitsTest, a_motion_is_compiled_to_the_same_bytes_everywhere)
{
    using T = TypeParam;
    Random random(134);
    for (mw_motion_kind kind : all_motion_kinds) {
        const auto data = this->motion_of(random, kind);
        std::vector<unsigned char> first;
        for (const std::string &isa : running_isas()) {
            ScopedIsa scope(isa);
            const CompiledMotion<T> motion(data);
            const auto *bytes = reinterpret_cast<const unsigned char *>(motion.get());
            const std::vector<unsigned char> compiled(bytes, bytes + motion.size());
            if (first.empty())
                first = compiled;
            EXPECT_EQ(first, compiled) << isa << ": " << name_of(kind);
        }
    }
}

// It holds no pointers: a copy elsewhere works when all that it was made of is gone.
TYPED_TEST(MotionBitsTest, a_copy_of_a_compiled_motion_is_one)
{
    using T = TypeParam;
    Random random(135);
    for (mw_motion_kind kind : all_motion_kinds) {
        std::vector<std::uint64_t> copy;
        std::vector<T> parameters, expected, out;
        {
            const auto data = this->motion_of(random, kind);
            CompiledMotion<T> motion(data);
            parameters = parameters_of<T>(random, data.exact(), 20);
            expected = sampled(motion, parameters);
            copy.resize((motion.size() + 7) / 8 + 1);
            std::memcpy(&copy[1], motion.get(), motion.size());
            std::memset(const_cast<void *>(static_cast<const void *>(motion.get())), 0xcd, motion.size());
        }
        out.resize(expected.size());
        EXPECT_EQ(api<T>::sample_motion_one(packed_motors(out.data()),
                                            reinterpret_cast<const typename api<T>::compiled_motion *>(&copy[1]), 0,
                                            parameters.data(), parameters.size(), MW_DEFAULT),
                  MW_OK);
        EXPECT_TRUE(same_bits(out, expected)) << name_of(kind);
    }
}

// Exactly as much memory as was asked for, at either end of it, and not a byte of the description beyond its counts.
TYPED_TEST(MotionBitsTest, compiling_touches_nothing_else)
{
    using T = TypeParam;
    Random random(136);
    GuardedBuffer memory(65536), controls(65536), knots(4096), weights(4096), bases(4096);
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t degree : {1, 2, 3, 4, 7})
            for (bool closed : {false, true})
                for (Guard guard : {Guard::after, Guard::before}) {
                    auto data = random_motion<T>(random, kind, degree, degree + 1 + random.below(5), closed);
                    data.motion_count = 2;
                    draw_controls(random, data, data.controls.size());
                    draw_knots(random, data, Ends::free, degree);
                    if (is_additive(kind))
                        data.weights.assign(data.control_count(), T(1));
                    auto motion = data.view();
                    motion.controls = controls.place_copy(data.controls.data(), data.controls.size(), guard);
                    motion.knots = knots.place_copy(data.knots.data(), data.knots.size(), guard);
                    if (motion.weights)
                        motion.weights = weights.place_copy(data.weights.data(), data.weights.size(), guard);
                    if (motion.base)
                        motion.base = bases.place_copy(data.base.data(), 1, guard);
                    std::size_t size = 0;
                    ASSERT_EQ(api<T>::motion_size(&size, &motion, nullptr), MW_OK) << data.name();
                    ASSERT_EQ(size % 4, 0u);  // so that the block below can be aligned
                    const typename api<T>::compiled_motion *compiled = nullptr;
                    void *const block = memory.place(size, guard, guard == Guard::after ? size % 8 : 0);
                    ASSERT_EQ(api<T>::compile_motion(&compiled, block, size, &motion, MW_DEFAULT, nullptr), MW_OK);
                    EXPECT_EQ(static_cast<const void *>(compiled), block);
                }
}

}  // namespace
}  // namespace motorway::testing
