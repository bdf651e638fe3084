// motorway compare, end to end: motions whose distance is known.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dual_quaternion.h"
#include "run_tool.h"

namespace motorway::tool {
namespace {

const std::string BUNNY = std::string(MOTORWAY_EXAMPLES) + "/data/bunny.ply";
const std::string FIGURE_5 = std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-5.json";

/* The corners of its bounding box are (0, 0, 0) and (3, 4, 0): a diagonal of 5. */
const std::string TRIANGLE = "v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n";

std::string linear(const std::string &from, const std::string &to, const std::string &more = "")
{
    return R"({"motorway": 2, "scheme": "additive", "degree": 1, )" + more + R"("controls": [)" + from + ", " + to +
           "]}";
}

std::string translation(const std::string &vector)
{
    return R"({"steps": [{"translate": )" + vector + "}]}";
}

class Compare : public ::testing::Test {
protected:
    Compare() { folder_.write("mesh.obj", TRIANGLE); }

    std::string compared(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), "compare");
        const ToolResult result = run_tool(folder_.path(), arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return result.out;
    }

    static void expect_line(const std::string &summary, const std::string &line)
    {
        EXPECT_NE(summary.find("\n" + line + "\n"), std::string::npos) << line << "\nin\n" << summary;
    }

    static double distance(const std::string &summary)
    {
        const std::string before = "\ndistance  ";
        const std::size_t at = summary.find(before);
        EXPECT_NE(at, std::string::npos) << summary;
        return at == std::string::npos ? -1 : std::stod(summary.substr(at + before.size()));
    }

    const TemporaryFolder folder_;
};

TEST_F(Compare, AMotionIsNotFarFromItself)
{
    const std::string summary = compared({FIGURE_5, FIGURE_5, "--mesh", BUNNY, "--samples", "101"});
    expect_line(summary, "distance  0 at most");
    EXPECT_EQ(summary.find("where"), std::string::npos) << summary;
    EXPECT_EQ(distance(compared({FIGURE_5, "--against", "additive", "--mesh", BUNNY, "--samples", "101"})), 0);
}

TEST_F(Compare, TranslationsAreAsFarApartAsTheirEnds)
{
    folder_.write("a.json", linear(translation("[0, 0, 0]"), translation("[1, 0, 0]")));
    folder_.write("b.json", linear(translation("[0, 0, 0]"), translation("[1, 3, 4]")));
    const std::string summary = compared({"a.json", "b.json", "--mesh", "mesh.obj"});
    expect_line(summary, "samples   1,001, spread evenly over the parameter of each motion");
    expect_line(summary, "distance  5 at most");
    expect_line(summary, "          1 of the diagonal of the bounding box of the mesh");
}

/* By 0 and by 90 degrees about z: farthest for the vertex (0, 4, 0), at the end. */
TEST_F(Compare, NamesThePlace)
{
    folder_.write("a.json", linear(R"({"steps": []})", R"({"axis": [0, 0, 1], "degrees": 0})"));
    folder_.write("b.json", linear(R"({"steps": []})", R"({"axis": [0, 0, 1], "degrees": 90})"));
    const std::string summary = compared({"a.json", "b.json", "--mesh", "mesh.obj", "--samples", "5"});
    EXPECT_NEAR(distance(summary), 4 * std::sqrt(2.0), 1e-5);
    expect_line(summary, "where     vertex 2 (counting from 0)");
    expect_line(summary, "          first: (0, 4, 0) at t = 1");
    EXPECT_NE(summary.find("second: (-4, "), std::string::npos) << summary;
}

TEST_F(Compare, DomainsNeedNotBeTheSame)
{
    folder_.write("a.json", linear(translation("[0, 0, 0]"), translation("[1, 0, 0]")));
    folder_.write("b.json", linear(translation("[0, 0, 0]"), translation("[1, 0, 2]"), R"("knots": [10, 30], )"));
    const std::string summary = compared({"a.json", "b.json", "--mesh", "mesh.obj"});
    EXPECT_EQ(distance(summary), 2);
    EXPECT_NE(summary.find(" at t = 1\n"), std::string::npos) << summary;
    EXPECT_NE(summary.find(" at t = 30\n"), std::string::npos) << summary;
}

/* Between two rotations the schemes agree on the way, and not on how fast it is walked. */
TEST_F(Compare, AdditiveAgainstMultiplicative)
{
    folder_.write("turn.json", linear(R"({"steps": []})", R"({"axis": [0, 0, 1], "degrees": 160})"));
    const double whole = 160 * std::acos(-1.0) / 180;
    double expected = 0;
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        const double additive = 2 * std::atan2(t * std::sin(whole / 2), 1 - t + t * std::cos(whole / 2));
        expected = std::max(expected, 4 * 2 * std::abs(std::sin((additive - t * whole) / 2)));
    }
    const std::string summary =
        compared({"turn.json", "--against", "multiplicative", "--mesh", "mesh.obj", "--samples", "201"});
    EXPECT_NEAR(distance(summary), expected, 1e-5 * expected);
    expect_line(summary, "          additive motion of degree 1, 2 control poses, t from 0 to 1");
    expect_line(summary, "          multiplicative motion of degree 1, 2 control poses, t from 0 to 1");
}

TEST_F(Compare, TheMeshIsScaledAsForPosing)
{
    folder_.write("a.json", linear(R"({"steps": []})", R"({"steps": []})", R"("mesh_size": 8, )"));
    folder_.write("b.json", linear(R"({"steps": []})", R"({"axis": [0, 0, 1], "degrees": 180})"));
    const auto scaled = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"a.json", "b.json", "--mesh", "mesh.obj", "--samples", "2"});
        return distance(compared(more));
    };
    EXPECT_NEAR(scaled({}), 16, 1e-4) << "(0, 4, 0) becomes (0, 8, 0), and half a turn takes that to (0, -8, 0)";
    EXPECT_NEAR(scaled({"--scale", "1"}), 8, 1e-4);
}

/* Every vertex counts, also in meshes that are compared in several blocks. */
TEST_F(Compare, FindsTheOneVertexThatIsFarAway)
{
    std::string mesh;
    for (int i = 0; i < 300; ++i)
        mesh += i == 290 ? "v 0 0 7\n" : "v 0 0 " + std::to_string(i % 5) + "\n";
    folder_.write("many.obj", mesh + "f 1 2 3\n");
    folder_.write("a.json", linear(R"({"steps": []})", R"({"steps": []})"));
    folder_.write("b.json", linear(R"({"steps": []})", R"({"axis": [1, 0, 0], "degrees": 180})"));
    const std::string summary = compared({"a.json", "b.json", "--mesh", "many.obj", "--samples", "100000"});
    EXPECT_NEAR(distance(summary), 14, 1e-4);
    expect_line(summary, "where     vertex 290 (counting from 0)");
}

TEST_F(Compare, SaysHowToUseIt)
{
    const ToolResult result = run_tool(folder_.path(), {"compare", "--help"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char *option : {"FIRST", "SECOND", "--against", "--mesh", "--samples", "--scale", "multiplicative"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option << "\n" << result.out;
}

} // namespace
} // namespace motorway::tool
