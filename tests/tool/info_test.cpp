// motorway info, --help and --version.

#include <gtest/gtest.h>

#include "motorway_views.h"
#include "run_tool.h"

namespace motorway::tool {
namespace {

TEST(Info, NamesTheIsasAndEveryKernel)
{
    const TemporaryFolder folder;
    const ToolResult result = run_tool(folder.path(), {"info"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find(std::string("ISAs      ") + mw_isas() + "\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("CPU       "), std::string::npos) << result.out;
    const char *const KERNELS[] = {
#define MOTORWAY_KERNEL(verb, operand, pairing, inputs, outputs, operations, divisions) #verb, #operand, #pairing,
#include "kernel_list.inc"
    };
    std::size_t from = result.out.find("kernels");
    ASSERT_NE(from, std::string::npos) << result.out;
    for (const char *word : KERNELS) {
        from = result.out.find(word, from);
        ASSERT_NE(from, std::string::npos) << "no " << word << " in its place:\n" << result.out;
    }
}

TEST(Info, ShowsTheIsaThatIsAskedFor)
{
    const TemporaryFolder folder;
    ToolLimits limits;
    limits.isa = "scalar";
    const ToolResult result = run_tool(folder.path(), {"info"}, limits);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("in use    scalar\n"), std::string::npos) << result.out;
}

TEST(Help, IsEnoughToStart)
{
    const TemporaryFolder folder;
    const ToolResult result = run_tool(folder.path(), {"--help"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char *word :
         {"pose", "sample", "compare", "info", "--motion", "--frames", "--out", "--picture", "MOTORWAY_ISA"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.out;
    for (const char *option : {"--motion", "--frames", "--out", "--picture", "--picture-poses", "--scale", "--fps"})
        EXPECT_NE(run_tool(folder.path(), {"pose", "--help"}).out.find(option), std::string::npos) << option;
}

TEST(Version, IsThatOfTheLibrary)
{
    const TemporaryFolder folder;
    const std::string expected = "motorway " + std::to_string(MW_VERSION_MAJOR) + "." +
                                 std::to_string(MW_VERSION_MINOR) + "." + std::to_string(MW_VERSION_PATCH) + "\n";
    EXPECT_EQ(run_tool(folder.path(), {"--version"}).out, expected);
}

} // namespace
} // namespace motorway::tool
