// The same bits on every instruction set that fuses multiply and add, and the same on every one that does not.

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_list.h"
#include "kernel_tester.h"

namespace motorway::testing {
namespace {

class BitsTest : public ::testing::TestWithParam<KernelRow> {};

// Two runs of the same pool: every element of either alone and, since KernelTest holds for both, in any batch.
template <class T>
void expect_same_bits(const Subject<T> &subject, const std::vector<std::string> &isas)
{
    Pool<T> pool = make_pool(subject, 200, 7, Specials::some);
    std::vector<T> first;
    for (const std::string &isa : isas) {
        ScopedIsa scope(isa);
        run_alone(subject, pool);
        if (first.empty())
            first = pool.alone;
        for (std::size_t k = 0; k < first.size(); ++k)
            ASSERT_TRUE(same(first[k], pool.alone[k]))
                << subject.name() << " " << api<T>::name << ", element " << k / pool.output_components
                << ", component " << k % pool.output_components << ": " << std::hexfloat << first[k] << " on "
                << isas.front() << " and " << pool.alone[k] << " on " << isa;
    }
}

// Those that run here, in classes within which bits must agree.
std::vector<std::vector<std::string>> classes_of_isas()
{
    std::vector<std::vector<std::string>> classes(2);
    for (const std::string &isa : running_isas())
        classes[fuses(isa)].push_back(isa);
    return classes;
}

TEST_P(BitsTest, agree_within_a_class)
{
    for (const auto &isas : classes_of_isas()) {
        for (const auto &subject : GetParam().subjects<float>())
            expect_same_bits(*subject, isas);
        for (const auto &subject : GetParam().subjects<double>())
            expect_same_bits(*subject, isas);
    }
}

INSTANTIATE_TEST_SUITE_P(every, BitsTest, ::testing::ValuesIn(kernel_rows()),
                         [](const auto &each) { return each.param.name; });

// Otherwise the tests above compare nothing.
TEST(Bits, two_instruction_sets_of_one_class_run_here)
{
    const auto classes = classes_of_isas();
    if (classes[0].size() < 2 && classes[1].size() < 2)
        GTEST_SKIP() << "these cannot be compared with any other: " << mw_isas();
}

}  // namespace
}  // namespace motorway::testing
