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
                << subject.name() << " " << Api<T>::name << ", element " << k / pool.output_components
                << ", component " << k % pool.output_components << ": " << std::hexfloat << first[k] << " on "
                << isas.front() << " and " << pool.alone[k] << " on " << isa;
    }
}

TEST_P(BitsTest, agree_within_a_class)
{
    std::vector<std::string> fusing, not_fusing;
    for (const std::string &isa : running_isas())
        (fuses(isa) ? fusing : not_fusing).push_back(isa);
    if (fusing.size() < 2 && not_fusing.size() < 2)
        GTEST_SKIP() << "no two instruction sets of one class can run here: " << mw_isas();
    for (const auto &isas : {fusing, not_fusing}) {
        for (const auto &subject : GetParam().subjects<float>())
            expect_same_bits(*subject, isas);
        for (const auto &subject : GetParam().subjects<double>())
            expect_same_bits(*subject, isas);
    }
}

INSTANTIATE_TEST_SUITE_P(every, BitsTest, ::testing::ValuesIn(kernel_rows()),
                         [](const auto &each) { return each.param.name; });

}  // namespace
}  // namespace motorway::testing
