// motorway sample, end to end: its numbers read back and compared with an independent reference, under every scheme.

#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dual_quaternion.h"
#include "run_tool.h"

namespace motorway::tool {
namespace {

const std::string FIGURE_5 = std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-5.json";
const std::string POSE_COLUMNS = "t,s,b12,b13,b23,b1i,b2i,b3i,w,qx,qy,qz,qw,tx,ty,tz";

using Row = std::vector<double>;

struct Table {
    std::string header;
    std::vector<Row> rows;

    explicit Table(const std::string &csv)
    {
        std::istringstream lines(csv);
        std::getline(lines, header);
        for (std::string line; std::getline(lines, line);) {
            rows.emplace_back();
            std::istringstream words(line);
            for (std::string word; std::getline(words, word, ',');)
                rows.back().push_back(std::stod(word));
        }
    }
};

std::string sampled(const TemporaryFolder &folder, const std::string &motion, std::vector<std::string> more)
{
    std::vector<std::string> arguments = {"sample", motion};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run_tool(folder.path(), arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
}

/* The numbers of a pose as the tool writes them, of q or -q, whichever is nearer to the row. */
Row expected_pose(DualQuaternion pose, double t, const Row &actual)
{
    pose = reference_normalized(pose);
    Row row = {t};
    for (double c : coefficients(pose))
        row.push_back(c);
    row.insert(row.end(), {pose.real[1], pose.real[2], pose.real[3], pose.real[0]});
    double agreement = 0;
    for (std::size_t k = 1; k < 5; ++k)
        agreement += actual[k] * row[k];
    for (std::size_t k = 1; k < row.size(); ++k)
        row[k] *= agreement < 0 ? -1 : 1;
    for (double c : reference_translation_of(pose))
        row.push_back(c);
    return row;
}

void expect_near(const Row &actual, const Row &expected, double tolerance, const std::string &what)
{
    ASSERT_EQ(actual.size(), expected.size()) << what;
    for (std::size_t k = 0; k < actual.size(); ++k)
        EXPECT_NEAR(actual[k], expected[k], tolerance) << what << ", column " << k;
}

/* ---------------------------------------------------------------------------------------------- every scheme --- */

/* Four poses, none of them special, as a motion file and for the reference. */
const std::string POSES = R"([{"axis": [0, 0, 1], "degrees": 20, "translate": [1, 0, 0]},
    {"axis": [1, 2, -1], "degrees": 70, "translate": [3, 1, -1]},
    {"axis": [0, 1, 1], "degrees": 100, "translate": [4, 3, 0.5]},
    {"axis": [1, 1, 0], "degrees": 60, "translate": [2, 4, 2]}])";

std::vector<DualQuaternion> poses()
{
    return {reference_sequence({reference_rotation({0, 0, 1}, 20), reference_translation({1, 0, 0})}),
            reference_sequence({reference_rotation({1, 2, -1}, 70), reference_translation({3, 1, -1})}),
            reference_sequence({reference_rotation({0, 1, 1}, 100), reference_translation({4, 3, 0.5})}),
            reference_sequence({reference_rotation({1, 1, 0}, 60), reference_translation({2, 4, 2})})};
}

const DualQuaternion IDENTITY = {{1, 0, 0, 0}, {0, 0, 0, 0}};
const DualQuaternion BASE = reference_sequence({reference_rotation({1, 0, 0}, 40), reference_translation({2, 2, 0})});

struct Scheme {
    std::string name, file; /* what the file says besides the version */
    std::function<DualQuaternion(double)> pose;
    double start, end;
};

void PrintTo(const Scheme &scheme, std::ostream *out)
{
    *out << scheme.name;
}

std::vector<Scheme> schemes()
{
    const std::vector<double> quadratic = {0, 0, 1, 3, 3}, cubic = {0, 0, 0, 1, 1, 1}, times = {0, 1, 2, 5};
    const std::string controls = R"(, "controls": )" + POSES, keys = R"(, "times": [0, 1, 2, 5], "keys": )" + POSES;
    const std::string knots = R"(, "degree": 2, "knots": [0, 0, 1, 3, 3])";
    const std::string base = R"(, "base": {"axis": [1, 0, 0], "degrees": 40, "translate": [2, 2, 0]})";
    std::vector<DualQuaternion> weighted = poses();
    for (double &c : weighted[1].real)
        c *= 3;
    for (double &c : weighted[1].dual)
        c *= 3;
    return {
        {"Additive", R"("scheme": "additive")" + knots + controls,
         [=](double t) { return reference_bspline(poses(), quadratic, 2, t); }, 0, 3},
        {"Rational", R"("scheme": "additive", "weights": [1, 3, 1, 1])" + knots + controls,
         [=](double t) { return reference_bspline(weighted, quadratic, 2, t); }, 0, 3},
        {"Bezier", R"("scheme": "additive", "degree": 3)" + controls,
         [=](double t) { return reference_bspline(poses(), cubic, 3, t); }, 0, 1},
        {"Multiplicative", R"("scheme": "multiplicative")" + knots + controls,
         [=](double t) { return reference_multiplicative(poses(), quadratic, 2, t); }, 0, 3},
        {"MultiplicativeBezier", R"("scheme": "multiplicative", "degree": 3)" + controls,
         [=](double t) { return reference_multiplicative(poses(), cubic, 3, t); }, 0, 1},
        {"PiecewiseScrew", R"("scheme": "multiplicative", "degree": 1, "knots": [0, 1, 2, 5])" + controls,
         [=](double t) { return reference_multiplicative(poses(), times, 1, t); }, 0, 5},
        {"Cumulative", R"("scheme": "cumulative")" + knots + controls,
         [=](double t) { return reference_cumulative(poses(), quadratic, 2, t); }, 0, 3},
        {"Generator", R"("scheme": "generator")" + knots + controls,
         [=](double t) { return reference_generator(poses(), quadratic, 2, IDENTITY, t); }, 0, 3},
        {"GeneratorWithABase", R"("scheme": "generator")" + knots + base + controls,
         [=](double t) { return reference_generator(poses(), quadratic, 2, BASE, t); }, 0, 3},
        {"GeneratorKeys", R"("scheme": "generator_keys")" + keys,
         [=](double t) { return reference_generator_keys(poses(), times, IDENTITY, t); }, 0, 5},
        {"GeneratorKeysWithABase", R"("scheme": "generator_keys")" + base + keys,
         [=](double t) { return reference_generator_keys(poses(), times, BASE, t); }, 0, 5},
    };
}

class SampleSchemes : public ::testing::TestWithParam<Scheme> {
protected:
    void SetUp() override { folder_.write("motion.json", R"({"motorway": 2, )" + GetParam().file + "}"); }

    const TemporaryFolder folder_;
};

TEST_P(SampleSchemes, PosesAreThoseOfTheReference)
{
    const Scheme &scheme = GetParam();
    const Table table(sampled(folder_, "motion.json", {"--count", "31"}));
    EXPECT_EQ(table.header, POSE_COLUMNS);
    ASSERT_EQ(table.rows.size(), 31u);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double t = scheme.start + (scheme.end - scheme.start) * static_cast<double>(i) / 30;
        expect_near(table.rows[i], expected_pose(scheme.pose(t), t, table.rows[i]), 1e-13,
                    "sample " + std::to_string(i));
    }
}

/* Of 9 samples none but the ends is at a knot, where a motion is not smooth. */
TEST_P(SampleSchemes, VelocitiesAreThoseOfTheReference)
{
    const Scheme &scheme = GetParam();
    const Table space(sampled(folder_, "motion.json", {"--count", "9", "--velocity"}));
    const Table body(sampled(folder_, "motion.json", {"--count", "9", "--velocity", "--frame", "body"}));
    EXPECT_EQ(space.header, POSE_COLUMNS + ",omega_x,omega_y,omega_z,vx,vy,vz");
    EXPECT_EQ(body.header, space.header);
    ASSERT_EQ(space.rows.size(), 9u);
    ASSERT_EQ(body.rows.size(), 9u);
    for (std::size_t i = 1; i < 8; ++i) {
        const double t = space.rows[i].at(0);
        const Velocity velocity = reference_velocity(scheme.pose, t, 1e-5);
        const DualQuaternion pose = scheme.pose(t);
        const DualQuaternion back = {{pose.real[0], -pose.real[1], -pose.real[2], -pose.real[3]}, {0, 0, 0, 0}};
        const Vector turned = reference_direction(back, velocity.angular),
                     moved = reference_direction(back, velocity.linear);
        const auto last_six = [](const Row &row) { return Row(row.end() - 6, row.end()); };
        expect_near(last_six(space.rows[i]),
                    {velocity.angular[0], velocity.angular[1], velocity.angular[2], velocity.linear[0],
                     velocity.linear[1], velocity.linear[2]},
                    2e-8, "in space, sample " + std::to_string(i));
        expect_near(last_six(body.rows[i]), {turned[0], turned[1], turned[2], moved[0], moved[1], moved[2]}, 2e-8,
                    "in the body, sample " + std::to_string(i));
        expect_near(Row(body.rows[i].begin(), body.rows[i].end() - 6),
                    Row(space.rows[i].begin(), space.rows[i].end() - 6), 0, "the poses");
    }
}

INSTANTIATE_TEST_SUITE_P(, SampleSchemes, ::testing::ValuesIn(schemes()),
                         [](const auto &scheme) { return scheme.param.name; });

/* ------------------------------------------------------------------------------------------------------ keys --- */

class SampleKeys : public ::testing::TestWithParam<const char *> {};

TEST_P(SampleKeys, ThePosesAreMetAtTheirTimes)
{
    const TemporaryFolder folder;
    folder.write("keys.json", R"({"motorway": 2, "scheme": ")" + std::string(GetParam()) +
                                  R"(", "degree": 2, "times": [0, 1, 2, 5], "keys": )" + POSES + "}");
    const Table table(sampled(folder, "keys.json", {"--count", "6"}));
    const std::size_t times[] = {0, 1, 2, 5};
    ASSERT_EQ(table.rows.size(), 6u);
    for (std::size_t k = 0; k < 4; ++k) {
        const Row &row = table.rows[times[k]];
        expect_near(row, expected_pose(poses()[k], static_cast<double>(times[k]), row), 1e-12,
                    "key " + std::to_string(k));
    }
}

INSTANTIATE_TEST_SUITE_P(, SampleKeys, ::testing::Values("additive", "cumulative"),
                         [](const auto &scheme) { return std::string(scheme.param); });

/* --------------------------------------------------------------------------------------- options and formats --- */

/* An arc that is walked unevenly: the angle of an additive rotation is not proportional to the parameter. */
const std::string ARC = R"({"motorway": 2, "name": "an \"arc\"", "scheme": "additive", "degree": 1, "controls":
    [{"steps": []}, {"axis": [0, 0, 1], "degrees": 150, "through": [1, 1, 0]}]})";

TEST(Sample, EvenSamplesAreEquallyFarApart)
{
    const TemporaryFolder folder;
    folder.write("arc.json", ARC);
    const DualQuaternion end = reference_rotation({0, 0, 1}, 150, {1, 1, 0});
    const Table table(sampled(folder, "arc.json", {"--count", "11", "--even=-3,2.5,7"}));
    ASSERT_EQ(table.rows.size(), 11u);
    for (std::size_t i = 0; i < 11; ++i) {
        const double half = 75 * std::acos(-1.0) / 180, angle = half * static_cast<double>(i) / 10;
        /* The angle of (1 - t) + t (cos + sin b) is that of the point of a chord. */
        const double t = std::sin(angle) / (std::sin(angle) + std::sin(half - angle));
        expect_near(table.rows[i], expected_pose(reference_bspline({IDENTITY, end}, {0, 1}, 1, t), t, table.rows[i]),
                    1e-9, "sample " + std::to_string(i));
    }
}

TEST(Sample, JsonHasTheNumbersOfCsv)
{
    const TemporaryFolder folder;
    folder.write("arc.json", ARC);
    const Table table(sampled(folder, "arc.json", {"--count", "5", "--velocity"}));
    const auto json =
        nlohmann::json::parse(sampled(folder, "arc.json", {"--count", "5", "--velocity", "--format", "json"}));
    EXPECT_EQ(json.at("name"), "an \"arc\"");
    EXPECT_EQ(json.at("scheme"), "additive");
    EXPECT_EQ(json.at("frame"), "space");
    EXPECT_EQ(json.at("domain"), (std::vector<double>{0, 1}));
    ASSERT_EQ(json.at("samples").size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto &sample = json.at("samples")[i];
        Row row = {sample.at("t").get<double>()};
        for (const char *key : {"motor", "quaternion", "translation", "angular_velocity", "velocity"})
            for (double number : sample.at(key).get<Row>())
                row.push_back(number);
        EXPECT_EQ(row, table.rows.at(i));
    }
}

TEST(Sample, JsonWithoutVelocitiesHasNoFrame)
{
    const TemporaryFolder folder;
    folder.write("arc.json", ARC);
    const auto json = nlohmann::json::parse(sampled(folder, "arc.json", {"--count", "2", "--format", "json"}));
    EXPECT_FALSE(json.contains("frame"));
    EXPECT_FALSE(json.at("samples")[0].contains("velocity"));
}

TEST(Sample, WritesAFile)
{
    const TemporaryFolder folder;
    folder.write("arc.json", ARC);
    const std::string csv = sampled(folder, "arc.json", {"--count", "7"});
    const std::string json = sampled(folder, "arc.json", {"--count", "7", "--format", "json"});
    const std::string summary = sampled(folder, "arc.json", {"--count", "7", "-o", "samples.csv"});
    EXPECT_NE(summary.find("additive motion of degree 1, 2 control poses, t from 0 to 1"), std::string::npos)
        << summary;
    EXPECT_NE(summary.find("written   samples.csv"), std::string::npos) << summary;
    sampled(folder, "arc.json", {"--count", "7", "--out", "samples.json"});
    sampled(folder, "arc.json", {"--count", "7", "--out", "json.txt", "--format", "json"});
    EXPECT_EQ(folder.read("samples.csv"), csv);
    EXPECT_EQ(folder.read("samples.json"), json);
    EXPECT_EQ(folder.read("json.txt"), json);
    EXPECT_EQ(folder.list(), (std::vector<std::string>{"arc.json", "json.txt", "samples.csv", "samples.json"}));
}

TEST(Sample, OneIsTheStart)
{
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> cases = {{"--count", "1"}, {"--count", "1", "--even", "1,0,0"}};
    for (const std::vector<std::string> &arguments : cases) {
        const Table table(sampled(folder, FIGURE_5, arguments));
        ASSERT_EQ(table.rows.size(), 1u);
        expect_near(table.rows[0], expected_pose(figure_5_controls()[0], 0, table.rows[0]), 1e-14, "the start");
    }
}

TEST(Sample, SaysHowToUseIt)
{
    const TemporaryFolder folder;
    const ToolResult result = run_tool(folder.path(), {"sample", "--help"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char *option : {"MOTION", "--count", "--velocity", "--frame", "--even", "--format", "--out"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option << "\n" << result.out;
}

} // namespace
} // namespace motorway::tool
