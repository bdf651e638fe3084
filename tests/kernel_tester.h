// Runs a kernel through the public API on operands laid out in every way, each against a forbidden page, and
// compares every byte: the results with those of each element alone, and all other bytes with what they were.
#ifndef MOTORWAY_TESTS_KERNEL_TESTER_H
#define MOTORWAY_TESTS_KERNEL_TESTER_H

#include <cmath>
#include <cstring>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "guarded_buffer.h"
#include "layout.h"
#include "subject.h"

namespace motorway::testing {

// The same bits, or both NaN. (0 and -0 differ.)
template <class T>
bool same(T a, T b)
{
    return std::memcmp(&a, &b, sizeof(T)) == 0 || (a != a && b != b);
}

// Inputs for a kernel, the exact results, and what the instruction set in use makes of each element alone. Some
// inputs are NaN, infinite or huge, and then only the bits can be compared.
template <class T>
struct Pool {
    std::size_t count = 0, output_components = 0;
    std::vector<typename Subject<T>::Input> operands;
    std::vector<std::vector<T>> inputs;  // [input][element * operands[input].size() + ...]
    std::vector<std::optional<Expected>> expected;  // of those that have been judged
    std::vector<bool> special;
    std::vector<T> alone;

    const T *element(std::size_t input, std::size_t i) const { return &inputs[input][i * operands[input].size()]; }
    T *element(std::size_t input, std::size_t i) { return &inputs[input][i * operands[input].size()]; }
    std::vector<const T *> elements(std::size_t i) const
    {
        std::vector<const T *> all;
        for (std::size_t k = 0; k < inputs.size(); ++k)
            all.push_back(element(k, i));
        return all;
    }
    const T *result(std::size_t i) const { return &alone[i * output_components]; }
};

enum class Specials { none, some };

// Sets one of `count` components, wherever they lie, to a number of the kind that breaks arithmetic.
template <class T>
void make_special(Random &random, void *components, std::size_t count)
{
    using Limits = std::numeric_limits<T>;
    const T values[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
                        Limits::denorm_min(), -T(0), T(0)};
    const std::size_t place = random.below(count);
    const T value = values[random.below(std::size(values))];
    std::memcpy(static_cast<unsigned char *>(components) + place * sizeof(T), &value, sizeof(T));
}

template <class T>
Pool<T> make_pool(const Subject<T> &subject, std::size_t count, std::uint64_t seed, Specials specials)
{
    Random random(seed);
    Pool<T> pool;
    pool.count = count;
    pool.output_components = subject.output_components();
    pool.operands = subject.inputs();
    for (const auto &input : pool.operands)
        pool.inputs.emplace_back(count * input.size() + 1);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<T *> element;
        for (std::size_t k = 0; k < pool.inputs.size(); ++k)
            element.push_back(pool.element(k, i));
        subject.draw(random, element.data());
        pool.special.push_back(specials == Specials::some && random.chance(6));
        const std::size_t k = random.below(element.size());
        const auto &input = pool.operands[k];
        if (!pool.special.back() || input.components == 0 || input.operand == Operand::indices)
            continue;
        if (input.scalar == sizeof(double))
            make_special<double>(random, element[k], input.components);
        else
            make_special<float>(random, element[k], input.components);
    }
    pool.expected.resize(count);
    return pool;
}

// Finds the exact results of the first elements.
template <class T>
void judge(const Subject<T> &subject, Pool<T> &pool, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        if (!pool.special[i])
            pool.expected[i] = subject.expect(pool.elements(i).data());
}

// The components of one element, adjacent at `first`.
template <class T>
View<T> packed_view(T *first, std::size_t components, std::size_t scalar = sizeof(T))
{
    View<T> view;
    for (std::size_t c = 0; c < components; ++c)
        view.component.push_back(first + c * scalar / sizeof(T));
    view.stride = std::max<std::size_t>(1, components) * scalar;
    return view;
}

// Fills pool.alone: one call an element, all components adjacent.
template <class T>
void run_alone(const Subject<T> &subject, Pool<T> &pool)
{
    pool.alone.assign(pool.count * pool.output_components, T(0));
    for (std::size_t i = 0; i < pool.count; ++i) {
        std::vector<View<T>> inputs;
        for (std::size_t k = 0; k < pool.inputs.size(); ++k)
            inputs.push_back(packed_view(pool.element(k, i), pool.operands[k].components, pool.operands[k].scalar));
        const View<T> out = packed_view(&pool.alone[i * pool.output_components], pool.output_components);
        ASSERT_EQ(subject.run(out, inputs, 1), MW_OK) << subject.name();
    }
}

// The message about a component that is not within its tolerance, or nothing.
template <class T>
std::optional<std::string> compare(const Expected &expected, const T *result)
{
    for (std::size_t c = 0; c < expected.value.size(); ++c) {
        const long double error = static_cast<long double>(reference::Real(result[c]) - expected.value[c]);
        if (std::abs(error) <= expected.tolerance[c])
            continue;
        std::ostringstream text;
        text << std::setprecision(20) << "component " << c << " is " << result[c] << " and should be "
             << static_cast<long double>(expected.value[c]) << ": off by " << error << ", tolerance "
             << expected.tolerance[c];
        return text.str();
    }
    return std::nullopt;
}

// One case: how many elements, and where they lie. The buffers outlive the cases.
template <class T>
class KernelTester {
public:
    KernelTester(const Subject<T> &subject, const Pool<T> &pool, std::string isa)
        : subject_(subject), pool_(pool), isa_(std::move(isa)),
          input_layouts_(subject.inputs().size(), Layout::aos()), output_layout_(Layout::aos())
    {
        for (const auto &input : subject.inputs()) {
            components_.push_back(input.components);
            scalars_.push_back(input.scalar);
        }
        components_.push_back(pool.output_components);
        scalars_.push_back(sizeof(T));
    }

    KernelTester &count(std::size_t count) { return count_ = count, *this; }
    KernelTester &first(std::size_t index) { return first_ = index, *this; }  // the element of the pool to start at
    KernelTester &input_layout(std::size_t input, Layout layout) { return input_layouts_[input] = layout, *this; }
    KernelTester &input_layout(Layout layout)
    {
        input_layouts_.assign(input_layouts_.size(), layout);
        return *this;
    }
    KernelTester &output_layout(Layout layout) { return output_layout_ = layout, *this; }
    KernelTester &guard(Guard guard) { return guard_ = guard, *this; }
    // Bytes between the guard and the blocks.
    KernelTester &input_offset(std::size_t bytes) { return input_offset_ = bytes, *this; }
    KernelTester &output_offset(std::size_t bytes) { return output_offset_ = bytes, *this; }
    // The output is this input.
    KernelTester &in_place_of(std::size_t input) { return in_place_of_ = input, *this; }
    // All operands in one buffer, element by element.
    KernelTester &interleaved() { return interleaved_ = true, *this; }

    // Fails, once, with a description of the case. After a failure the cases that follow are left out.
    void test()
    {
        if (::testing::Test::HasFailure())
            return;
        lay_out();
        fill();
        const std::vector<View<T>> inputs(views_.begin(), views_.end() - 1);
        const mw_status status = subject_.run(views_.back(), inputs, count_);
        if (status != MW_OK)
            fail(std::string("status: ") + mw_status_text(status));
        else
            check_results();
        check_other_bytes();
    }

private:
    struct Block {
        unsigned char *begin;
        std::size_t size;
        std::vector<unsigned char> before;  // what was in [low, high), which is the block and a margin around it
        unsigned char *low, *high;
    };

    // The inputs, and then the output.
    std::size_t operands() const { return components_.size(); }

    static GuardedBuffer &buffer(std::size_t index)
    {
        static std::vector<GuardedBuffer> buffers;
        while (buffers.size() <= index)
            buffers.emplace_back(std::size_t(1) << 20);
        return buffers[index];
    }

    void lay_out()
    {
        blocks_.clear();
        views_.clear();
        if (interleaved_)
            return lay_out_interleaved();
        for (std::size_t operand = 0; operand < operands(); ++operand) {
            const bool is_output = operand + 1 == operands();
            if (is_output && in_place_of_) {
                views_.push_back(views_[*in_place_of_]);
                continue;
            }
            const Operand kind = is_output ? subject_.output() : pool_.operands[operand].operand;
            const Layout asked = is_output ? output_layout_ : input_layouts_[operand];
            const Layout layout = is_matrix(kind) ? asked.with_components_adjacent() : asked;
            const Placement placement = layout.place(components_[operand], count_, scalars_[operand]);
            const std::size_t first_block = blocks_.size();
            for (std::size_t size : placement.block_sizes)
                add_block(size, is_output ? output_offset_ : input_offset_);
            View<T> view;
            view.stride = placement.stride;
            for (const auto &[block, offset] : placement.component)
                view.component.push_back(reinterpret_cast<T *>(blocks_[first_block + block].begin + offset));
            views_.push_back(view);
        }
    }

    void lay_out_interleaved()
    {
        std::size_t all = 0;
        for (std::size_t operand = 0; operand < operands(); ++operand)
            all += components_[operand] * scalars_[operand];
        add_block(count_ * all, input_offset_);
        unsigned char *next = blocks_[0].begin;
        for (std::size_t operand = 0; operand < operands(); ++operand) {
            View<T> view;
            view.stride = all;
            for (std::size_t c = 0; c < components_[operand]; ++c, next += scalars_[operand])
                view.component.push_back(reinterpret_cast<T *>(next));
            views_.push_back(view);
        }
    }

    void add_block(std::size_t size, std::size_t offset)
    {
        constexpr std::size_t margin = 64;
        GuardedBuffer &memory = buffer(blocks_.size());
        Block block;
        block.begin = memory.place(size, guard_, offset);
        block.size = size;
        block.low = block.begin - std::min<std::size_t>(margin, block.begin - memory.begin());
        block.high = block.begin + size + std::min<std::size_t>(margin, memory.end() - block.begin - size);
        blocks_.push_back(std::move(block));
    }

    // Canaries everywhere, then the inputs.
    void fill()
    {
        unsigned char canary = 0x5a;
        for (Block &block : blocks_)
            for (unsigned char *byte = block.low; byte != block.high; ++byte)
                *byte = canary = static_cast<unsigned char>(canary * 5 + 1);
        for (std::size_t k = 0; k + 1 < operands(); ++k)
            for (std::size_t i = 0; i < count_; ++i)
                for (std::size_t c = 0; c < components_[k]; ++c) {
                    const auto *element = reinterpret_cast<const unsigned char *>(pool_.element(k, first_ + i));
                    std::memcpy(address(k, i, c), element + c * scalars_[k], scalars_[k]);
                }
        for (Block &block : blocks_)
            block.before.assign(block.low, block.high);
    }

    unsigned char *address(std::size_t operand, std::size_t i, std::size_t c) const
    {
        return reinterpret_cast<unsigned char *>(views_[operand].component[c]) + i * views_[operand].stride;
    }

    void check_results()
    {
        for (std::size_t i = 0; i < count_; ++i) {
            T result[16];
            for (std::size_t c = 0; c < pool_.output_components; ++c)
                std::memcpy(&result[c], address(operands() - 1, i, c), sizeof(T));
            for (std::size_t c = 0; c < pool_.output_components; ++c)
                if (!same(result[c], pool_.result(first_ + i)[c]))
                    return fail_bits(i, c, result[c]);
            const auto &expected = pool_.expected[first_ + i];
            if (!expected)
                continue;
            if (const auto message = compare(*expected, result))
                return fail("element " + std::to_string(i) + ": " + *message);
        }
    }

    void fail_bits(std::size_t i, std::size_t c, T result)
    {
        std::ostringstream text;
        text << std::hexfloat << "element " << i << ", component " << c << " is " << result << ", but "
             << pool_.result(first_ + i)[c] << " when it is computed alone";
        fail(text.str());
    }

    // Puts back what the kernel was to write; then everything must be as before.
    void check_other_bytes()
    {
        const auto offset = [](const Block &block, const unsigned char *byte) { return byte - block.low; };
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t c = 0; c < pool_.output_components; ++c) {
                unsigned char *byte = address(operands() - 1, i, c);
                for (const Block &block : blocks_)
                    if (block.begin <= byte && byte < block.begin + block.size)
                        std::memcpy(byte, block.before.data() + offset(block, byte), sizeof(T));
            }
        for (std::size_t b = 0; b < blocks_.size(); ++b)
            for (const unsigned char *byte = blocks_[b].low; byte != blocks_[b].high; ++byte)
                if (*byte != blocks_[b].before[static_cast<std::size_t>(offset(blocks_[b], byte))])
                    return fail("block " + std::to_string(b) + ": the byte at offset " +
                                std::to_string(byte - blocks_[b].begin) + " changed");
    }

    void fail(const std::string &message)
    {
        std::ostringstream text;
        text << subject_.name() << " " << api<T>::name << " on " << isa_ << ", count " << count_
             << ", pool elements from " << first_ << ", inputs";
        for (const Layout &layout : input_layouts_)
            text << " " << layout.name();
        text << " at offset " << input_offset_ << ", output " << output_layout_.name() << " at offset "
             << output_offset_ << ", guard " << (guard_ == Guard::after ? "after" : "before");
        if (in_place_of_)
            text << ", in place of input " << *in_place_of_;
        if (interleaved_)
            text << ", all interleaved";
        ADD_FAILURE() << text.str() << ":\n" << message;
    }

    const Subject<T> &subject_;
    const Pool<T> &pool_;
    std::string isa_;
    std::vector<std::size_t> components_, scalars_;  // of each operand: how many, and of how many bytes
    std::size_t count_ = 1, first_ = 0, input_offset_ = 0, output_offset_ = 0;
    std::vector<Layout> input_layouts_;
    Layout output_layout_;
    Guard guard_ = Guard::after;
    std::optional<std::size_t> in_place_of_;
    bool interleaved_ = false;
    std::vector<Block> blocks_;
    std::vector<View<T>> views_;  // of the inputs, then of the output
};

}  // namespace motorway::testing

#endif
