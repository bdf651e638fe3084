// Mistakes in the command line: one line that names what is wrong, what was meant, and what there is.

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "run_tool.h"

namespace motorway::tool {
namespace {

struct Mistake {
    std::string name;
    std::vector<std::string> arguments;
    std::string expected; /* how the message begins, after "motorway: error: " */
    std::string also = "";
};

void PrintTo(const Mistake &mistake, std::ostream *out)
{
    *out << mistake.name;
}

const std::string COMMANDS = "pose, sample, compare, figures and info";

const std::vector<Mistake> MISTAKES = {
    {"Nothing", {}, "there is no command; give one of " + COMMANDS, "; see motorway --help"},
    {"OnlyDashes", {"--"}, "there is no command"},
    {"CommandAfterDashes", {"--", "pose"}, "there is no command"},
    {"UnknownCommand", {"fooo"}, "\"fooo\" is no command; there are " + COMMANDS, "; see motorway --help"},
    {"UnknownCommandWithArguments", {"poze", "m.obj", "--frames", "3"}, "\"poze\" is no command, but pose is"},
    {"CommandCutShort", {"pos"}, "\"pos\" is no command, but pose is; there are " + COMMANDS},
    {"CommandWithLettersSwapped", {"smaple"}, "\"smaple\" is no command, but sample is"},
    {"CommandInCapitals", {"Info"}, "\"Info\" is no command, but info is"},
    {"CommandForAnOption", {"help"}, "\"help\" is no command, but --help is"},
    {"UnknownOptionInFront", {"--hlep"}, "\"--hlep\" is no option, but --help is; there are --help and --version"},
    {"OptionOfACommandInFront", {"--frames", "3", "pose"}, "\"--frames\" is no option", "come after it"},
    {"MisspeltOption", {"pose", "--fames", "3"}, "\"--fames\" is no option, but --frames is", "--picture"},
    {"MisspeltOptionWithAValue",
     {"pose", "m.obj", "--picture-pose=3"},
     "\"--picture-pose=3\" is no option, but --picture-poses is"},
    {"OptionOfOneDash", {"pose", "-frames", "3"}, "\"-frames\" is no option, but --frames is"},
    {"UnknownOption", {"info", "--verbose"}, "\"--verbose\" is no option; there is --help; see motorway info --help"},
    {"OneArgumentTooMany",
     {"pose", "a.obj", "b.obj", "--motion", "m.json", "--frames", "3", "--out", "o.glb"},
     "\"b.obj\" is one argument too many"},
    {"EverythingMissing",
     {"pose"},
     "MESH, --motion, --frames and --out are missing; write motorway pose MESH --motion FILE --frames N --out PATH",
     "; see motorway pose --help"},
    {"OneMissing", {"sample", "m.json"}, "--count is missing; write motorway sample MOTION --count N"},
    {"ValueMissingAtTheEnd", {"sample", "m.json", "--count"}, "--count: its value is missing; write --count N"},
    {"ValueMissingAfterAnEqualsSign", {"sample", "m.json", "--count="}, "--count: its value is missing"},
    {"ValueMissingBeforeAnOption",
     {"pose", "a.obj", "--motion", "--frames", "3", "--out", "o.glb"},
     "--motion: its value is missing, for --frames follows; write --motion FILE"},
    {"ValueOfAFlag",
     {"sample", "m.json", "--count", "3", "--velocity=much"},
     "--velocity: takes no value; write --velocity alone"},
    {"OptionTwice", {"sample", "m.json", "--count", "3", "--count", "4"}, "--count: is given 2 times; give it once"},
    {"WordForANumber", {"sample", "m.json", "--count", "many"}, "--count: \"many\" is no whole number"},
    {"HalfAFrame", {"sample", "m.json", "--count", "1.5"}, "--count: \"1.5\" is no whole number"},
    {"FarTooLarge", {"sample", "m.json", "--count", "99999999999999999999"}, "--count: \"9999", "far too large"},
    {"WordForAReal", {"pose", "a.obj", "--scale", "big"}, "--scale: \"big\" is no number"},
    {"UnknownWord",
     {"compare", "m.json", "--mesh", "a.obj", "--against", "foo"},
     "--against: \"foo\" is none; give additive, multiplicative, cumulative, generator or generator_keys"},
    {"OptionThatNeedsAnother",
     {"sample", "m.json", "--count", "3", "--frame", "body"},
     "--frame requires --velocity; add that"},
};

class CommandLineMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(CommandLineMistakes, AreOneLineThatHelps)
{
    const TemporaryFolder folder;
    const ToolResult result = run_tool(folder.path(), GetParam().arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.rfind("motorway: error: " + GetParam().expected, 0), 0u) << result.err;
    EXPECT_NE(result.err.find(GetParam().also), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << "one line: " << result.err;
}

INSTANTIATE_TEST_SUITE_P(, CommandLineMistakes, ::testing::ValuesIn(MISTAKES),
                         [](const auto &mistake) { return mistake.param.name; });

} // namespace
} // namespace motorway::tool
