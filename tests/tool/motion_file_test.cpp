// Motion files: the paper's figure 5 against its printed numbers, and what the format promises.

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "dual_quaternion.h"
#include "motion_file.h"

namespace motorway::tool {
namespace {

using Coefficients = std::array<double, 8>;

const std::string FIGURE_5 = std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-5.json";

Coefficients numbers_of(const mw_motor_f32 &m)
{
    return {m.s, m.b12, m.b13, m.b23, m.b1i, m.b2i, m.b3i, m.w};
}

void expect_near(const Coefficients &actual, const Coefficients &expected, double tolerance, const std::string &what)
{
    for (std::size_t k = 0; k < 8; ++k)
        EXPECT_NEAR(actual[k], expected[k], tolerance) << what << ", coefficient " << k;
}

// A motion with this one control, twice: there is no motion of a single pose.
mw_motor_f32 control(const std::string &json)
{
    const std::string text = R"({"motorway": 1, "kind": "linear", "controls": [)" + json + "," + json + "]}";
    return parse_motion(text, "test").controls[0];
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
    EXPECT_EQ(motion.knots, (std::vector<float>{0, 0, 1, 2, 3, 4, 4}));
    EXPECT_EQ(motion.start(), 0.0f);
    EXPECT_EQ(motion.end(), 4.0f);
}

TEST(MotionFile, Figure5HasTheCoefficientsOfItsFormulas)
{
    const Motion motion = read_motion(FIGURE_5);
    const std::vector<DualQuaternion> expected = figure_5_controls();
    for (std::size_t i = 0; i < expected.size(); ++i)
        expect_near(numbers_of(motion.controls.at(i)), coefficients(expected[i]), 5e-7,
                    "control " + std::to_string(i));
}

TEST(MotionFile, SamplesOfFigure5AreThoseOfTheReference)
{
    const Motion motion = read_motion(FIGURE_5);
    const std::vector<float> parameters = even_parameters(motion, 41);
    const std::vector<mw_motor_f32> motors = sample(motion, parameters, "test");
    EXPECT_EQ(parameters.front(), 0.0f);
    EXPECT_EQ(parameters.back(), 4.0f);
    EXPECT_FLOAT_EQ(parameters[7], 0.7f);
    for (std::size_t i = 0; i < motors.size(); ++i)
        expect_near(numbers_of(motors[i]),
                    coefficients(reference_bspline(figure_5_controls(), {0, 0, 1, 2, 3, 4, 4}, 2,
                                                   static_cast<double>(parameters[i]))),
                    2e-6, "sample " + std::to_string(i));
}

TEST(MotionFile, StepsActInTheirOrder)
{
    const Coefficients turned_first =
        coefficients(reference_sequence({reference_rotation({0, 0, 1}, 90), reference_translation({1, 2, 3})}));
    const Coefficients moved_first =
        coefficients(reference_sequence({reference_translation({1, 2, 3}), reference_rotation({0, 0, 1}, 90)}));
    const std::string turn = R"({"rotate": {"axis": [0, 0, 1], "degrees": 90}})",
                      move = R"({"translate": [1, 2, 3]})";
    expect_near(numbers_of(control("{\"steps\": [" + turn + "," + move + "]}")), turned_first, 1e-6, "turn, move");
    expect_near(numbers_of(control("{\"steps\": [" + move + "," + turn + "]}")), moved_first, 1e-6, "move, turn");
}

TEST(MotionFile, RotationsTakeRadiansAnyAxisAndAPoint)
{
    const Coefficients expected = coefficients(reference_rotation({1, -2, 0.5}, 80, {3, 1, -2}));
    expect_near(numbers_of(control(R"({"steps": [{"rotate":
                    {"axis": [2, -4, 1], "radians": 1.3962634015954636, "through": [3, 1, -2]}}]})")),
                expected, 1e-6, "rotation");
}

TEST(MotionFile, NoStepsAreTheIdentity)
{
    expect_near(numbers_of(control(R"({"steps": []})")), {1, 0, 0, 0, 0, 0, 0, 0}, 0, "identity");
}

TEST(MotionFile, AMotorIsTakenAsItStands)
{
    expect_near(numbers_of(control(R"({"motor": [0.5, 2, -3, 4, 5, -6, 7, 8]})")), {0.5, 2, -3, 4, 5, -6, 7, 8}, 0,
                "motor");
}

TEST(MotionFile, LinearMotionsHaveAKnotForEachControl)
{
    const Motion motion = parse_motion(R"({"motorway": 1, "kind": "linear", "controls":
        [{"steps": []}, {"steps": [{"translate": [1, 0, 0]}]}, {"steps": [{"translate": [1, 2, 0]}]}]})",
                                       "test");
    EXPECT_EQ(motion.degree, 1u);
    EXPECT_EQ(motion.knots, (std::vector<float>{0, 1, 2}));
    const std::vector<mw_motor_f32> motors = sample(motion, {0.5f, 1.0f, 1.75f}, "test");
    const float origin[3] = {0, 0, 0};
    EXPECT_EQ(trace(motors, origin), (std::vector<float>{0.5f, 0, 0, 1, 0, 0, 1, 1.5f, 0}));
}

TEST(MotionFile, BezierMotionsHaveTheirEndsAsKnots)
{
    const Motion motion = parse_motion(R"({"motorway": 1, "kind": "bezier", "controls":
        [{"steps": []}, {"steps": [{"translate": [2, 0, 0]}]}, {"steps": [{"translate": [2, 2, 0]}]},
         {"steps": [{"translate": [0, 2, 0]}]}]})",
                                       "test");
    EXPECT_EQ(motion.degree, 3u);
    EXPECT_EQ(motion.knots, (std::vector<float>{0, 0, 0, 1, 1, 1}));
    const float origin[3] = {0, 0, 0};
    EXPECT_EQ(trace(sample(motion, {0.0f, 0.5f, 1.0f}, "test"), origin),
              (std::vector<float>{0, 0, 0, 1.5f, 1, 0, 0, 2, 0}));
}

TEST(MotionFile, OneParameterIsTheStart)
{
    EXPECT_EQ(even_parameters(read_motion(FIGURE_5), 1), std::vector<float>{0.0f});
}

} // namespace
} // namespace motorway::tool
