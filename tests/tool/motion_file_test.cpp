// Motion files: the paper's figure 5 against its printed numbers, and what the format promises.

#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dual_quaternion.h"
#include "files.h"
#include "motion_file.h"

namespace motorway::tool {
namespace {

using Coefficients = std::array<double, 8>;

const std::string FIGURE_5 = std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-5.json";

Coefficients numbers_of(const mw_motor_f64 &m)
{
    return {m.s, m.b12, m.b13, m.b23, m.b1i, m.b2i, m.b3i, m.w};
}

void expect_near(const Coefficients &actual, const Coefficients &expected, double tolerance, const std::string &what)
{
    for (std::size_t k = 0; k < 8; ++k)
        EXPECT_NEAR(actual[k], expected[k], tolerance) << what << ", coefficient " << k;
}

/* A motion with this one control, twice: there is no motion of a single pose. */
Coefficients control(const std::string &json)
{
    const std::string text =
        R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls": [)" + json + "," + json + "]}";
    return numbers_of(parse_motion(text, "test").controls[0]);
}

/* Where a motion takes the origin, x y z, at each of the parameters. */
std::vector<float> path_of_origin(const Motion &motion, const std::vector<double> &parameters)
{
    const std::vector<double> path = trace(sample(motion, parameters, "test"), {0, 0, 0});
    return {path.begin(), path.end()};
}

TEST(MotionFile, Figure5HasTheCoefficientsThatThePaperPrints)
{
    // Typed from the paper: s b12 b13 b23 b1i b2i b3i w, to three decimals.
    const Coefficients PRINTED[] = {
        {1.000, 0, 0, 0, 0.500, 0.500, 0, 0},
        {0.966, 0.259, 0, 0, 3.027, -0.293, 0, 0},
        {0.707, 0.707, 0, 0, 4.243, -1.414, 0.707, 0.707},
        {0.653, 0.653, 0.271, 0.271, 5.114, -0.112, -0.588, 1.577},
        {0.612, 0.612, -0.354, 0.354, 2.001, 1.673, 1.484, 3.605},
        {0.500, 0.500, -0.500, 0.500, 1.250, 1.750, -0.750, 2.250},
    };
    const Motion motion = read_motion(FIGURE_5);
    ASSERT_EQ(motion.controls.size(), std::size(PRINTED));
    for (std::size_t i = 0; i < motion.controls.size(); ++i)
        expect_near(numbers_of(motion.controls[i]), PRINTED[i], 0.0005 + 1e-6, "control " + std::to_string(i));
    EXPECT_EQ(motion.degree, 2u);
    EXPECT_EQ(motion.knots, (std::vector<double>{0, 0, 1, 2, 3, 4, 4}));
    EXPECT_EQ(motion.start(), 0);
    EXPECT_EQ(motion.end(), 4);
}

TEST(MotionFile, Figure5HasTheCoefficientsOfItsFormulas)
{
    const Motion motion = read_motion(FIGURE_5);
    const std::vector<DualQuaternion> expected = figure_5_controls();
    for (std::size_t i = 0; i < expected.size(); ++i)
        expect_near(numbers_of(motion.controls.at(i)), coefficients(expected[i]), 1e-14,
                    "control " + std::to_string(i));
}

TEST(MotionFile, SamplesOfFigure5AreThoseOfTheReference)
{
    const Motion motion = read_motion(FIGURE_5);
    const std::vector<double> parameters = even_parameters(motion, 41);
    const std::vector<mw_motor_f64> motors = sample(motion, parameters, "test");
    EXPECT_EQ(parameters.front(), 0);
    EXPECT_EQ(parameters.back(), 4);
    EXPECT_DOUBLE_EQ(parameters[7], 0.7);
    for (std::size_t i = 0; i < motors.size(); ++i)
        expect_near(numbers_of(motors[i]),
                    coefficients(reference_normalized(
                        reference_bspline(figure_5_controls(), {0, 0, 1, 2, 3, 4, 4}, 2, parameters[i]))),
                    1e-13, "sample " + std::to_string(i));
}

/* ----------------------------------------------------------------------------------------------------- poses --- */

TEST(PoseField, StepsActInTheirOrder)
{
    const Coefficients turned_first =
        coefficients(reference_sequence({reference_rotation({0, 0, 1}, 90), reference_translation({1, 2, 3})}));
    const Coefficients moved_first =
        coefficients(reference_sequence({reference_translation({1, 2, 3}), reference_rotation({0, 0, 1}, 90)}));
    const std::string turn = R"({"rotate": {"axis": [0, 0, 1], "degrees": 90}})",
                      move = R"({"translate": [1, 2, 3]})";
    expect_near(control("{\"steps\": [" + turn + "," + move + "]}"), turned_first, 1e-15, "turn, move");
    expect_near(control("{\"steps\": [" + move + "," + turn + "]}"), moved_first, 1e-15, "move, turn");
}

TEST(PoseField, NoStepsAreTheIdentity)
{
    expect_near(control(R"({"steps": []})"), {1, 0, 0, 0, 0, 0, 0, 0}, 0, "identity");
}

TEST(PoseField, AMotorIsTakenAsItStands)
{
    expect_near(control(R"({"motor": [0.5, 2, -3, 4, 5, -6, 7, 8]})"), {0.5, 2, -3, 4, 5, -6, 7, 8}, 0, "motor");
}

TEST(PoseField, RotationsTakeRadiansAnyAxisAndAPoint)
{
    const Coefficients expected = coefficients(reference_rotation({1, -2, 0.5}, 80, {3, 1, -2}));
    const std::string rotation = R"("axis": [2, -4, 1], "radians": 1.3962634015954636, "through": [3, 1, -2]})";
    expect_near(control(R"({"steps": [{"rotate": {)" + rotation + "}]}"), expected, 1e-14, "a step");
    expect_near(control("{" + rotation), expected, 1e-14, "a pose");
}

/* A third of a turn about (1, 1, 1), which takes x to y, y to z and z to x, and then (1, -2, 0.5). */
class PoseForms : public ::testing::TestWithParam<const char *> {};

TEST_P(PoseForms, AreTheSamePose)
{
    const DualQuaternion expected =
        reference_sequence({reference_rotation({1, 1, 1}, 120), reference_translation({1, -2, 0.5})});
    expect_near(control(GetParam()), coefficients(expected), 1e-14, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    , PoseForms,
    ::testing::Values(
        R"({"motor": [0.5, 0.5, -0.5, 0.5, -0.375, -0.625, 0.875, -0.125]})",
        R"({"steps": [{"rotate": {"axis": [2, 2, 2], "degrees": 120}}, {"translate": [1, -2, 0.5]}]})",
        R"({"matrix": [[0, 0, 1, 1], [1, 0, 0, -2], [0, 1, 0, 0.5]]})",
        R"({"matrix": [[0, 0, 1, 1], [1, 0, 0, -2], [0, 1, 0, 0.5], [0, 0, 0, 1]]})",
        R"({"quaternion": [0.5, 0.5, 0.5, 0.5], "translation": [1, -2, 0.5]})",
        R"({"quaternion": [3, 3, 3, 3], "translation": [1, -2, 0.5]})",
        R"({"axis": [1, 1, 1], "degrees": 120, "translate": [1, -2, 0.5]})",
        R"({"axis": [1, 1, 1], "radians": 2.0943951023931953, "through": [5, 5, 5], "translate": [1, -2, 0.5]})",
        /* (1, -2, 0.5) is -1/6 (1, 1, 1), along the axis, and a rest, normal to it. */
        R"({"axis": [1, 1, 1], "degrees": 120, "along": -0.28867513459481287,
            "translate": [1.1666666666666667, -1.8333333333333333, 0.6666666666666667]})"),
    [](const auto &form) { return "Form" + std::to_string(form.index); });

TEST(PoseField, QuaternionsKeepTheirSign)
{
    expect_near(control(R"({"quaternion": [0, 0, 0.6, -0.8]})"), {-0.8, 0.6, 0, 0, 0, 0, 0, 0}, 1e-15, "sign");
}

TEST(PoseField, ScrewsGoAlongTheirAxis)
{
    const DualQuaternion expected =
        reference_sequence({reference_rotation({0, 3, 4}, 50, {7, -1, 2}), reference_translation({0, 1.2, 1.6})});
    expect_near(control(R"({"axis": [0, 3, 4], "degrees": 50, "through": [7, -1, 2], "along": 2})"),
                coefficients(expected), 1e-14, "screw");
}

TEST(PoseField, MatricesOfFewDecimalsBecomeRotations)
{
    const Coefficients m = control(R"({"matrix": [[0.866, -0.5, 0, 1], [0.5, 0.866, 0, 2], [0, 0, 1, 3]]})");
    EXPECT_NEAR(m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3], 1, 1e-15);
    expect_near(
        m, coefficients(reference_sequence({reference_rotation({0, 0, 1}, 30), reference_translation({1, 2, 3})})),
        1e-4, "matrix");
}

/* ------------------------------------------------------------------------------------------------- version 1 --- */

TEST(MotionFileVersion1, LinearMotionsReachAControlAtEachWholeNumber)
{
    const Motion motion = parse_motion(R"({"motorway": 1, "kind": "linear", "controls":
        [{"steps": []}, {"steps": [{"translate": [1, 0, 0]}]}, {"steps": [{"translate": [1, 2, 0]}]}]})",
                                       "test");
    EXPECT_EQ(motion.kind, MW_MOTION_ADDITIVE);
    EXPECT_EQ(motion.degree, 1u);
    EXPECT_EQ(motion.start(), 0);
    EXPECT_EQ(motion.end(), 2);
    EXPECT_EQ(path_of_origin(motion, {0.5, 1.0, 1.75}), (std::vector<float>{0.5f, 0, 0, 1, 0, 0, 1, 1.5f, 0}));
}

TEST(MotionFileVersion1, BezierMotionsGoFrom0To1)
{
    const Motion motion = parse_motion(R"({"motorway": 1, "kind": "bezier", "controls":
        [{"steps": []}, {"steps": [{"translate": [2, 0, 0]}]}, {"steps": [{"translate": [2, 2, 0]}]},
         {"steps": [{"translate": [0, 2, 0]}]}]})",
                                       "test");
    EXPECT_EQ(motion.degree, 3u);
    EXPECT_EQ(motion.start(), 0);
    EXPECT_EQ(motion.end(), 1);
    EXPECT_EQ(path_of_origin(motion, {0.0, 0.5, 1.0}), (std::vector<float>{0, 0, 0, 1.5f, 1, 0, 0, 2, 0}));
}

TEST(MotionFileVersion1, BsplineMotionsAreAdditive)
{
    const std::string rest = R"("degree": 2, "knots": [0, 0, 1, 3, 3], "controls": [{"steps": []},
        {"steps": [{"translate": [1, 0, 0]}]}, {"steps": [{"translate": [1, 2, 0]}]},
        {"steps": [{"translate": [3, 0, 1]}]}]})";
    const Motion old = parse_motion(R"({"motorway": 1, "kind": "bspline", )" + rest, "test");
    const Motion now = parse_motion(R"({"motorway": 2, "scheme": "additive", )" + rest, "test");
    EXPECT_EQ(path_of_origin(old, {0.25, 1.5, 2.75}), path_of_origin(now, {0.25, 1.5, 2.75}));
}

/* By 120 degrees and by -120: the short way between the two is through 180. */
TEST(MotionFileVersion1, KeepsTheSignsOfControls)
{
    const std::string controls =
        R"("controls": [{"axis": [0, 0, 1], "degrees": 120}, {"axis": [0, 0, 1], "degrees": -120}]})";
    const std::string steps = R"("controls": [{"steps": [{"rotate": {"axis": [0, 0, 1], "degrees": 120}}]},
        {"steps": [{"rotate": {"axis": [0, 0, 1], "degrees": -120}}]}]})";
    const std::string version_2 = R"({"motorway": 2, "scheme": "additive", "degree": 1, )";
    const Coefficients long_way = {1, 0, 0, 0, 0, 0, 0, 0}, short_way = {0, 1, 0, 0, 0, 0, 0, 0};
    const auto middle = [](const std::string &file) {
        return numbers_of(sample(parse_motion(file, "test"), {0.5}, "test")[0]);
    };
    expect_near(middle(R"({"motorway": 1, "kind": "linear", )" + steps), long_way, 1e-15, "version 1");
    expect_near(middle(version_2 + R"("keep_signs": true, )" + controls), long_way, 1e-15, "version 2, keep_signs");
    expect_near(middle(version_2 + controls), short_way, 1e-15, "version 2");
}

/* ------------------------------------------------------------------------------------------------- version 2 --- */

TEST(MotionFile, EveryExampleIsGood)
{
    std::size_t count = 0;
    for (const auto &file : std::filesystem::directory_iterator(std::string(MOTORWAY_EXAMPLES) + "/motions")) {
        const Motion motion = read_motion(file.path().string());
        EXPECT_NE(motion.name, "") << file.path();
        EXPECT_TRUE(motion.mesh_size) << file.path() << ": the bunny should fit";
        ++count;
    }
    EXPECT_GE(count, 5u);
}

/* The first block of JSON in the documentation is a motion, the second one pose in every form, a line each. */
TEST(MotionFile, TheExamplesOfTheDocumentationAreGood)
{
    std::istringstream lines(read_file(std::string(MOTORWAY_EXAMPLES) + "/../docs/motion-format.md"));
    std::vector<std::string> blocks;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line == "```json")
            blocks.emplace_back();
        if (line == "```json" || line == "```")
            inside = line != "```";
        else if (inside)
            blocks.back() += line + "\n";
    }
    ASSERT_EQ(blocks.size(), 2u);
    EXPECT_EQ(parse_motion(blocks[0], "documentation").name, "A quarter turn");
    const DualQuaternion pose =
        reference_sequence({reference_rotation({0, 0, 1}, 90), reference_translation({3, 0, 0})});
    std::istringstream poses(blocks[1]);
    std::size_t count = 0;
    for (std::string line; std::getline(poses, line); ++count)
        expect_near(control(line), coefficients(pose), 1e-15, line);
    EXPECT_EQ(count, 5u);
}

TEST(MotionFile, Figures1And4HaveTheCoefficientsThatThePaperPrints)
{
    const Coefficients FIGURE_1[] = {{0.866, 0.500, 0, 0, 3.464, -2.000, 0, 0},
                                     {0.500, 0, 0, -0.866, 0, 1.500, 2.598, 0}};
    const Coefficients FIGURE_4[] = {{1, 0, 0, 0, 0.5, 0.5, 0, 0},
                                     {0.9659, -0.2588, 0, 0, 0.1895, 3.1566, 0, 0},
                                     {0.7071, -0.7071, 0, 0, -0.3536, 3.8891, 0, 0},
                                     {0.7071, -0.7071, 0, 0, 2.1213, 3.5356, 0, 0}};
    const Motion figure_1 = read_motion(std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-1.json");
    const Motion figure_4 = read_motion(std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-4.json");
    for (std::size_t i = 0; i < 2; ++i)
        expect_near(numbers_of(figure_1.controls.at(i)), FIGURE_1[i], 0.0005 + 1e-6, "figure 1");
    for (std::size_t i = 0; i < 4; ++i)
        expect_near(numbers_of(figure_4.controls.at(i)), FIGURE_4[i], 0.0001, "figure 4");
}

TEST(MotionFile, DegreeAboveTheFourthAndLongListsAreFine)
{
    std::string controls;
    for (int i = 0; i <= 1000; ++i)
        controls += (i ? ", " : "") + (R"({"steps": [{"translate": [)" + std::to_string(i)) + ", 0, 0]}]}";
    const Motion motion = parse_motion(
        R"({"motorway": 2, "scheme": "additive", "degree": 31, "controls": [)" + controls + "]}", "test");
    EXPECT_EQ(motion.end(), 970);
    EXPECT_EQ(path_of_origin(motion, {970}), (std::vector<float>{1000, 0, 0}));
}

TEST(MotionFile, KnotsAreOptional)
{
    const Motion motion = parse_motion(R"({"motorway": 2, "scheme": "additive", "degree": 2, "controls":
        [{"steps": []}, {"steps": [{"translate": [2, 0, 0]}]}, {"steps": [{"translate": [2, 4, 0]}]},
         {"steps": [{"translate": [0, 4, 0]}]}]})",
                                       "test");
    EXPECT_EQ(motion.start(), 0);
    EXPECT_EQ(motion.end(), 2);
    EXPECT_EQ(path_of_origin(motion, {0.0, 1.0, 2.0}), (std::vector<float>{0, 0, 0, 2, 2, 0, 0, 4, 0}));
}

TEST(MotionFile, WeightsPull)
{
    const Motion motion = parse_motion(R"({"motorway": 2, "scheme": "additive", "degree": 1, "weights": [1, 3],
        "controls": [{"steps": []}, {"steps": [{"translate": [4, 0, 0]}]}]})",
                                       "test");
    EXPECT_EQ(path_of_origin(motion, {0.5}), (std::vector<float>{3, 0, 0}));
}

TEST(MotionFile, ClosedMotionsComeBack)
{
    const Motion motion = parse_motion(R"({"motorway": 2, "scheme": "additive", "degree": 1, "closed": true,
        "knots": [0, 1, 2, 4], "controls": [{"steps": []}, {"steps": [{"translate": [2, 0, 0]}]},
        {"steps": [{"translate": [2, 4, 0]}]}]})",
                                       "test");
    EXPECT_EQ(motion.end(), 4);
    EXPECT_EQ(path_of_origin(motion, {0.0, 0.5, 1.5, 3.0, 4.0}),
              (std::vector<float>{0, 0, 0, 1, 0, 0, 2, 2, 0, 1, 2, 0, 0, 0, 0}));
}

TEST(MotionFile, ASchemeMayBeReadInPlaceOfItsOwn)
{
    EXPECT_EQ(read_motion(FIGURE_5, "multiplicative").kind, MW_MOTION_MULTIPLICATIVE);
    EXPECT_EQ(read_motion(FIGURE_5, "multiplicative").knots, read_motion(FIGURE_5).knots);
    const std::string keys = R"({"motorway": 2, "scheme": "additive", "degree": 2, "times": [0, 1, 3],
        "keys": [{"steps": []}, {"steps": [{"translate": [2, 0, 0]}]}, {"steps": [{"translate": [2, 4, 0]}]}]})";
    EXPECT_EQ(path_of_origin(parse_motion(keys, "test"), {1.0}), (std::vector<float>{2, 0, 0}));
    EXPECT_EQ(path_of_origin(parse_motion(keys, "test", "generator_keys"), {1.0}), (std::vector<float>{2, 0, 0}));
    const std::string based = R"({"motorway": 2, "scheme": "generator", "degree": 1, "base": {"steps": []},
        "keep_signs": true, "controls": [{"steps": []}, {"steps": [{"translate": [2, 0, 0]}]}]})";
    EXPECT_FALSE(parse_motion(based, "test", "multiplicative").base);
}

TEST(MotionFile, OneParameterIsTheStart)
{
    EXPECT_EQ(even_parameters(read_motion(FIGURE_5), 1), std::vector<double>{0.0});
}

} // namespace
} // namespace motorway::tool
