// --picture: what must be in it. Whether it is worth looking at is for people.

#include <cstdio>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "colour.h"
#include "run_tool.h"
#include "svg.h"

namespace motorway::tool {
namespace {

const std::string BUNNY = std::string(MOTORWAY_EXAMPLES) + "/data/bunny.ply";
const std::string FIGURE_5 = std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-5.json";

std::string picture_of(const TemporaryFolder &folder, std::vector<std::string> more)
{
    std::vector<std::string> arguments = {"pose", BUNNY,   "--motion",  FIGURE_5,    "--frames",
                                          "2",    "--out", "bunny.glb", "--picture", "bunny.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run_tool(folder.path(), arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return folder.read("bunny.svg");
}

std::size_t occurrences(const std::string &text, const std::string &part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

/* Every element is closed in its order. */
bool is_balanced(const std::string &xml)
{
    std::vector<std::string> open;
    for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
        const std::size_t end = xml.find_first_of("<>", at + 1);
        if (end == std::string::npos || xml[end] == '<')
            return false;
        const bool closes = xml[at + 1] == '/', is_empty = xml[end - 1] == '/';
        const std::size_t name = at + (closes ? 2 : 1);
        const std::string element = xml.substr(name, xml.find_first_of(" \n/>", name) - name);
        if (element.empty() || (closes && (open.empty() || open.back() != element)))
            return false;
        if (closes)
            open.pop_back();
        else if (!is_empty)
            open.push_back(element);
    }
    return open.empty() && xml.find('<') != std::string::npos;
}

TEST(Picture, HasAFigureForEachPoseAndAFrameForEachControl)
{
    const TemporaryFolder folder;
    const std::string nine = picture_of(folder, {}), four = picture_of(folder, {"--picture-poses", "4"});
    EXPECT_EQ(occurrences(nine, "<circle"), 9u) << "the marks of the poses on the scale of the parameter";
    EXPECT_EQ(occurrences(four, "<circle"), 4u);
    for (const char *name : {"S(0, 0)", "S(0, 1)", "S(1, 2)", "S(2, 3)", "S(3, 4)", "S(4, 4)"})
        EXPECT_EQ(occurrences(nine, name), 1u) << name;
    EXPECT_NE(nine.find("figure 5</text>"), std::string::npos);
    for (const auto &[svg, poses] : {std::pair(nine, 9u), std::pair(four, 4u)}) {
        EXPECT_GT(occurrences(svg, "z"), poses * 3674u * 2 / 5) << "about half of the triangles face the eye";
        EXPECT_LT(occurrences(svg, "z"), poses * 3674u * 3 / 5);
    }
}

TEST(Picture, IsSmallAndWellFormed)
{
    const TemporaryFolder folder;
    const std::string svg = picture_of(folder, {});
    EXPECT_LT(svg.size(), 2000000u);
    EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
    EXPECT_TRUE(is_balanced(svg));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Picture, StaysInsideItsPaper)
{
    const TemporaryFolder folder;
    const std::string svg = picture_of(folder, {});
    const std::regex start("d=\"M(-?[0-9]+) (-?[0-9]+)l[^\"]*z\"");
    std::size_t triangles = 0;
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), start); it != std::sregex_iterator();
         ++it, ++triangles) {
        const int x = std::stoi((*it)[1]), y = std::stoi((*it)[2]);
        EXPECT_TRUE(x > -2000 && x < 18000 && y > -2000 && y < 14000) << x << " " << y;
    }
    EXPECT_GT(triangles, 9u * 1000u);
}

TEST(Picture, IsTheSameTwice)
{
    const TemporaryFolder folder;
    EXPECT_EQ(picture_of(folder, {}), picture_of(folder, {}));
}

TEST(Picture, OfOnePoseIsOne)
{
    const TemporaryFolder folder;
    const std::string svg = picture_of(folder, {"--picture-poses", "1"});
    EXPECT_EQ(occurrences(svg, "<circle"), 1u);
    EXPECT_TRUE(is_balanced(svg));
}

TEST(Picture, NumbersControlsThatHaveNoKnotsToShow)
{
    const TemporaryFolder folder;
    folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("keys.json", R"({"motorway": 2, "scheme": "generator_keys", "closed": true, "keys":
        [{"steps": []}, {"steps": [{"translate": [3, 0, 0]}]}, {"steps": [{"translate": [3, 3, 0]}]}]})");
    const ToolResult result = run_tool(folder.path(), {"pose", "flat.obj", "--motion", "keys.json", "--frames", "1",
                                                       "--out", "flat.glb", "--picture", "flat.svg"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string svg = folder.read("flat.svg");
    for (const char *words : {">S0<", ">S1<", ">S2<", "Closed generator_keys motion, 3 key poses", "t = 3"})
        EXPECT_EQ(occurrences(svg, words), 1u) << words;
}

TEST(Picture, OfAFlatOpenMeshAtRest)
{
    const TemporaryFolder folder;
    folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("still.json", R"({"motorway": 1, "name": "a <b> & \"c\"", "kind": "linear", "controls":
        [{"steps": []}, {"steps": []}]})");
    const ToolResult result = run_tool(folder.path(), {"pose", "flat.obj", "--motion", "still.json", "--frames", "1",
                                                       "--out", "flat.glb", "--picture", "flat.svg"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string svg = folder.read("flat.svg");
    EXPECT_TRUE(is_balanced(svg));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_NE(svg.find("a &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
}

TEST(SvgPaths, AreRelativeWholeTenths)
{
    EXPECT_EQ(svg_tenths({{1.04, 2}, {2, 1.5}, {0, 0}}, true), "M10 20l10-5l-20-15z");
}

TEST(Colours, AreThoseOfOklch)
{
    EXPECT_EQ(hex({1, 0, 0}), "#ffffff");
    EXPECT_EQ(hex({0, 0, 0}), "#000000");
    EXPECT_EQ(hex({0.627955, 0.257683, 29.2339}), "#ff0000");
    EXPECT_EQ(hex({0.452014, 0.313214, 264.052}), "#0000ff");
}

TEST(Figures, AreAllWrittenAndSound)
{
    const TemporaryFolder folder;
    const ToolResult result = run_tool(folder.path(), {"figures", "--out", "pictures"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const char *name : {"hunt-figure-1", "hunt-figure-2", "hunt-figure-3", "hunt-figure-4", "hunt-figure-5",
                             "wareham-figure-5", "wareham-figure-7", "schemes", "speeds"}) {
        const std::string picture = folder.read(std::string("pictures/") + name + ".svg");
        EXPECT_TRUE(is_balanced(picture)) << name;
        EXPECT_GT(occurrences(picture, "<path"), 3u) << name;
        EXPECT_EQ(picture.find("nan"), std::string::npos) << name;
        EXPECT_EQ(picture.find("inf"), std::string::npos) << name;
    }
    EXPECT_NE(result.out.find("Piecewise screw"), std::string::npos) << "the table of lengths and speeds";
}

TEST(Figures, NeedAFolder)
{
    const TemporaryFolder folder;
    folder.write("file", "");
    const ToolResult result = run_tool(folder.path(), {"figures", "--out", "file/pictures"});
    EXPECT_NE(result.exit_code, 0);
    EXPECT_NE(result.err.find("--out"), std::string::npos) << result.err;
}

} // namespace
} // namespace motorway::tool
