// The choice of the instruction set: by the CPU, by MOTORWAY_ISA, and what happens when that cannot run.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "isas.h"

namespace motorway::testing {
namespace {

struct Probe {
    int exit_code;
    std::string output;
};

// Runs isa_probe in a process of its own, for the choice is made once a process. Null: MOTORWAY_ISA is not set.
Probe probe(const char *isa)
{
    isa ? setenv("MOTORWAY_ISA", isa, 1) : unsetenv("MOTORWAY_ISA");
    FILE *pipe = popen("\"" MOTORWAY_TEST_ISA_PROBE "\"", "r");
    if (!pipe)
        throw std::runtime_error("cannot start " MOTORWAY_TEST_ISA_PROBE);
    Probe result{-1, ""};
    char line[1024];
    while (std::fgets(line, sizeof line, pipe))
        result.output += line;
    const int status = pclose(pipe);
    unsetenv("MOTORWAY_ISA");
    if (WIFEXITED(status))
        result.exit_code = WEXITSTATUS(status);
    while (!result.output.empty() && result.output.back() == '\n')
        result.output.pop_back();
    return result;
}

// Otherwise all the tests of kernels together show nothing about the vector code.
TEST(Isa, one_that_is_not_scalar_runs_here)
{
    EXPECT_GT(running_isas().size(), 1u) << "only these can run here: " << mw_isas();
}

// One test that is skipped, whose name says which could not be tested here, and none that would be for each kernel.
std::vector<std::string> those_that_do_not_run()
{
    const std::vector<std::string> running = running_isas();
    std::string missing;
    for (const std::string &isa : compiled_isas())
        if (std::find(running.begin(), running.end(), isa) == running.end())
            missing += (missing.empty() ? "" : "_and_") + isa;
    return missing.empty() ? std::vector<std::string>() : std::vector<std::string>{missing};
}

class NotRunHere : public ::testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(NotRunHere);

TEST_P(NotRunHere, because_of_this_CPU) { GTEST_SKIP() << "This CPU has only " << mw_isas(); }

INSTANTIATE_TEST_SUITE_P(, NotRunHere, ::testing::ValuesIn(those_that_do_not_run()),
                         [](const auto &each) { return each.param; });

TEST(Isa, the_list_names_those_that_run_best_first)
{
    std::string expected;
    for (const std::string &isa : running_isas())
        expected += (expected.empty() ? "" : ", ") + isa;
    EXPECT_EQ(mw_isas(), expected);
}

TEST(Isa, every_one_that_runs_can_be_selected_and_says_its_name)
{
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        EXPECT_EQ(mw_isa(), isa);
    }
}

TEST(Isa, selecting_one_that_cannot_run_changes_nothing)
{
    const std::string before = mw_isa();
    EXPECT_FALSE(select_isa("avx3"));
    EXPECT_FALSE(select_isa(""));
    EXPECT_EQ(mw_isa(), before);
}

TEST(IsaVariable, without_it_the_best_is_used)
{
    const Probe result = probe(nullptr);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.output, running_isas().front());
}

TEST(IsaVariable, each_name_selects_itself)
{
    for (const std::string &isa : running_isas()) {
        const Probe result = probe(isa.c_str());
        EXPECT_EQ(result.exit_code, 0) << isa;
        EXPECT_EQ(result.output, isa);
    }
}

TEST(IsaVariable, takes_any_case_of_letters)
{
    for (const char *isa : {"SCALAR", "Scalar", "sCALaR"})
        EXPECT_EQ(probe(isa).output, "scalar") << isa;
}

void expect_refusal(const char *isa)
{
    const Probe result = probe(isa);
    EXPECT_EQ(result.exit_code, 1) << isa << ": " << result.output;
    EXPECT_NE(result.output.find(mw_isas()), std::string::npos) << result.output;
}

TEST(IsaVariable, an_unknown_name_is_an_error_that_names_those_that_run)
{
    for (const char *isa : {"avx3", "AVX", "scalar ", "sse", "SSE22", "avx2,scalar"})
        expect_refusal(isa);
}

// Of another architecture, or compiled in and not of this CPU.
TEST(IsaVariable, an_instruction_set_this_cpu_lacks_is_an_error)
{
    bool tried = false;
    for (const char *isa : {"avx512", "avx2", "sse2", "neon64"}) {
        const auto running = running_isas();
        if (std::find(running.begin(), running.end(), isa) != running.end())
            continue;
        tried = true;
        expect_refusal(isa);
    }
    EXPECT_TRUE(tried) << "no CPU runs both AVX2 and NEON";
}

}  // namespace
}  // namespace motorway::testing
