// Every kernel of the list, in both precisions, on every instruction set that runs here. isa_test.cpp names those that do not.

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_list.h"
#include "kernel_tester.h"

namespace motorway::testing {
namespace {

struct KernelCase {
    const KernelRow *row;
    std::string precision, isa;
};

std::vector<KernelCase> all_cases()
{
    std::vector<KernelCase> cases;
    for (const KernelRow &row : kernel_rows())
        for (const std::string &precision : row.precisions())
            for (const std::string &isa : running_isas())
                cases.push_back({&row, precision, isa});
    return cases;
}

std::string name_of(const KernelCase &c)
{
    const bool said = c.row->variant == Variant::mixed;
    return c.row->name + (said ? "" : "_" + c.precision) + "_" + c.isa;
}

void PrintTo(const KernelCase &c, std::ostream *out) { *out << name_of(c); }

class KernelTest : public ::testing::TestWithParam<KernelCase> {
protected:
    void SetUp() override { ASSERT_TRUE(isa_.runs()); }

    bool is_f64() const { return GetParam().precision == "f64"; }

private:
    ScopedIsa isa_{GetParam().isa};
};

// Sizes below, at and above one to four registers of any width from 1 to 16, and the 48 floats of a block of packed
// points; then some that take the loop many times.
std::vector<std::size_t> all_counts()
{
    std::vector<std::size_t> counts;
    for (std::size_t count = 0; count <= 50; ++count)
        counts.push_back(count);
    counts.insert(counts.end(), {63, 64, 65, 95, 96, 97, 100, 1000});
    return counts;
}

constexpr std::size_t pool_size = 1100;
constexpr std::uint64_t seed = 20170807;

template <class T>
void check_accuracy(const KernelCase &c)
{
    const auto subjects = c.row->subjects<T>();
    const std::size_t elements = std::min<std::size_t>(300, 720 / subjects.size());
    for (const auto &subject : subjects) {
        Pool<T> pool = make_pool(*subject, elements, seed, Specials::none);
        judge(*subject, pool, pool.count);
        run_alone(*subject, pool);
        for (std::size_t i = 0; i < pool.count; ++i)
            if (const auto message = compare(*pool.expected[i], pool.result(i)))
                FAIL() << subject->name() << ", element " << i << " of seed " << seed << ": " << *message;
    }
}

// One subject of a row, with the pool of its elements, in every shape.
template <class T>
class Shapes {
public:
    Shapes(const Subject<T> &subject, const std::string &isa)
        : subject_(subject), isa_(isa), pool_(make_pool(subject, pool_size, seed, Specials::some))
    {
        judge(subject_, pool_, 100);
        run_alone(subject_, pool_);
    }

    // Every layout of the inputs with every layout of the output.
    void layouts()
    {
        for (const Layout &in : layouts_of_input(pool_.operands.size() - 1))
            for (const Layout &out : layouts_of_output())
                for (std::size_t count : {1, 2, 5, 17, 49, 70})
                    for (Guard guard : {Guard::after, Guard::before})
                        tester(count).input_layout(in).output_layout(out).guard(guard).test();
    }

    void counts()
    {
        for (const Layout &layout : layouts_of_output())
            for (std::size_t count : all_counts())
                for (Guard guard : {Guard::after, Guard::before})
                    tester(count).input_layout(layout).output_layout(layout).guard(guard).test();
    }

    // Every offset from a cache line that a T can have, and some that it should not.
    void alignments()
    {
        std::vector<std::size_t> offsets = {1, 2, 3, 7, 33, 62};
        for (std::size_t offset = 0; offset < 64; offset += sizeof(T))
            offsets.push_back(offset);
        for (const Layout &layout : layouts_of_output())
            for (std::size_t offset : offsets)
                for (const auto &[in, out] : {std::pair(offset, offset), std::pair(offset, std::size_t(0)),
                                              std::pair(std::size_t(0), offset)})
                    tester(37).input_layout(layout).output_layout(layout).guard(Guard::before).input_offset(in)
                        .output_offset(out).test();
    }

    void in_place()
    {
        for (std::size_t input = 0; input < subject_.inputs().size(); ++input) {
            if (!can_be_in_place_of(input))
                continue;
            for (const Layout &layout : layouts_of_output())
                for (std::size_t count : all_counts())
                    tester(count).input_layout(layout).in_place_of(input).test();
        }
    }

    void interleaved()
    {
        if (subject_.keeps_apart())
            return;
        for (std::size_t count : all_counts())
            for (Guard guard : {Guard::after, Guard::before})
                tester(count).interleaved().guard(guard).test();
    }

    // Layouts, counts, offsets and places at random, each input with its own.
    void mixed()
    {
        Random random(seed);
        for (int repetition = 0; repetition < 500; ++repetition) {
            KernelTester<T> tester(subject_, pool_, isa_);
            tester.count(random.below(80)).first(random.below(1000));
            tester.guard(random.chance(2) ? Guard::after : Guard::before);
            for (std::size_t k = 0; k < subject_.inputs().size(); ++k)
                tester.input_layout(k, pick(random, layouts_of_input(k)));
            tester.output_layout(pick(random, layouts_of_output()));
            tester.input_offset(random.below(70)).output_offset(random.below(70));
            const std::size_t input = random.below(subject_.inputs().size());
            if (can_be_in_place_of(input) && random.chance(3))
                tester.in_place_of(input);
            tester.test();
        }
    }

private:
    // A different part of the pool for each count, so that the place in the batch differs from the one in the pool.
    KernelTester<T> tester(std::size_t count) const
    {
        return KernelTester<T>(subject_, pool_, isa_).count(count).first(count % 97);
    }

    bool can_be_in_place_of(std::size_t input) const
    {
        return !subject_.keeps_apart() && pool_.operands[input].operand == subject_.output() &&
               pool_.operands[input].scalar == sizeof(T);
    }

    std::vector<Layout> layouts_of_input(std::size_t k) const
    {
        return Layout::all(pool_.operands[k].components, pool_.operands[k].scalar);
    }

    std::vector<Layout> layouts_of_output() const { return Layout::all(subject_.output_components(), sizeof(T)); }

    static Layout pick(Random &random, const std::vector<Layout> &layouts)
    {
        return layouts[random.below(layouts.size())];
    }

    const Subject<T> &subject_;
    std::string isa_;
    Pool<T> pool_;
};

template <class T>
void check_shapes(const KernelCase &c)
{
    const auto subjects = c.row->subjects<T>();
    for (std::size_t k = 0; k < subjects.size() && k < 3; ++k) {
        Shapes<T> shapes(*subjects[k], c.isa);
        if (k == 0) {
            shapes.layouts();
            shapes.counts();
            shapes.alignments();
            shapes.in_place();
            shapes.interleaved();
        }
        shapes.mixed();
    }
}

TEST_P(KernelTest, matches_the_reference)
{
    is_f64() ? check_accuracy<double>(GetParam()) : check_accuracy<float>(GetParam());
}

TEST_P(KernelTest, gives_the_same_bits_in_every_shape_and_touches_nothing_else)
{
    is_f64() ? check_shapes<double>(GetParam()) : check_shapes<float>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(every, KernelTest, ::testing::ValuesIn(all_cases()),
                         [](const auto &each) { return name_of(each.param); });

}  // namespace
}  // namespace motorway::testing
