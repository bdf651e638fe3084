#include "pose_field.h"

#include <algorithm>
#include <cmath>

#include "status.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr double PI = 3.14159265358979323846;
constexpr double MATRIX_TOLERANCE = 1e-3; /* three decimals, as papers print them, are near enough to be meant */

mw_motor_f64 translation(const std::vector<double> &offset)
{
    mw_motor_f64 motor;
    check(mw_translation_f64(&motor, offset.data()), "a translation");
    return motor;
}

mw_motor_f64 sequence(const mw_motor_f64 &first, const mw_motor_f64 &then)
{
    mw_motor_f64 both;
    check(mw_compose_motor_each_f64(&both, sizeof both, &first, sizeof first, &then, sizeof then, 1),
          "a product of motors");
    return both;
}

std::vector<double> vector_or_zero(const Field &object, const char *key)
{
    return object.has(key) ? object[key].numbers(3) : std::vector<double>(3, 0.0);
}

/* The keys "axis", "degrees" or "radians", and "through". */
mw_motor_f64 read_rotation(const Field &rotation)
{
    const std::vector<double> axis = rotation["axis"].numbers(3);
    if (rotation.has("degrees") == rotation.has("radians"))
        throw rotation.error("needs either \"degrees\" or \"radians\"; give one of them");
    const double angle =
        rotation.has("degrees") ? rotation["degrees"].number() * (PI / 180) : rotation["radians"].number();
    mw_motor_f64 motor;
    const mw_status status = mw_rotation_f64(&motor, axis.data(), angle, vector_or_zero(rotation, "through").data());
    if (status == MW_ERROR_AXIS)
        throw rotation["axis"].error("has length zero and no direction; [0, 0, 1] is the z axis");
    check(status, "a rotation");
    return motor;
}

mw_motor_f64 read_step(const Field &step)
{
    step.check_object({"rotate", "translate"});
    if (step.has("rotate") == step.has("translate"))
        throw step.error("a step is one \"rotate\" or one \"translate\"; write a step for each");
    if (step.has("translate"))
        return translation(step["translate"].numbers(3));
    step["rotate"].check_object({"axis", "degrees", "radians", "through"});
    return read_rotation(step["rotate"]);
}

/* The first step acts first: the paper's product R T, read from left to right. */
mw_motor_f64 read_steps(const Field &pose)
{
    pose.check_object({"steps"});
    mw_motor_f64 motor = {1, 0, 0, 0, 0, 0, 0, 0};
    for (const Field &step : pose["steps"].array())
        motor = sequence(motor, read_step(step));
    return motor;
}

mw_motor_f64 read_motor(const Field &pose)
{
    pose.check_object({"motor"});
    const std::vector<double> c = pose["motor"].numbers(8);
    const mw_motor_f64 motor = {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
    const mw_status status = mw_check_motors_f64(&motor, sizeof motor, 1, nullptr);
    if (status == MW_ERROR_DEGENERATE_MOTOR)
        throw pose["motor"].error("its first four numbers are zero, or all but, so that it is no pose; "
                                  "[1, 0, 0, 0, 0, 0, 0, 0] is the one that moves nothing");
    check(status, "a motor");
    return motor;
}

/* 3 rows of 4 numbers, or 4 of which the last is 0 0 0 1. */
std::vector<double> read_rows(const Field &matrix)
{
    constexpr double LAST_ROW[] = {0, 0, 0, 1};
    const std::vector<Field> rows = matrix.array();
    if (rows.size() != 3 && rows.size() != 4)
        throw matrix.error("must hold 3 or 4 rows of 4 numbers, and holds " + std::to_string(rows.size()) +
                           "; correct it");
    std::vector<double> numbers;
    for (const Field &row : rows)
        for (double number : row.numbers(4))
            numbers.push_back(number);
    if (rows.size() == 4 && !std::equal(numbers.begin() + 12, numbers.end(), LAST_ROW))
        throw rows[3].error("must be [0, 0, 0, 1], for the matrix acts on columns; transpose it if they are rows");
    numbers.resize(12);
    return numbers;
}

mw_motor_f64 read_matrix(const Field &pose)
{
    pose.check_object({"matrix"});
    const std::vector<double> rows = read_rows(pose["matrix"]);
    constexpr std::size_t SIZE = 12 * sizeof(double);
    double deviation = 0;
    const mw_status status = mw_check_matrices_f64(rows.data(), SIZE, MW_MATRIX_ROWS_3X4, 1, MATRIX_TOLERANCE,
                                                   nullptr, &deviation);
    if (status == MW_ERROR_MATRIX)
        throw pose["matrix"].error(
            std::isfinite(deviation) ? "its columns deviate by " + brief(deviation) + " from orthonormal ones, and " +
                                           brief(MATRIX_TOLERANCE) + " is allowed; take scale and shear out"
                                     : "is a reflection, which no motion reaches; change the sign of a column");
    check(status, "a matrix");
    mw_motor_f64 motor;
    check(mw_convert_matrix_to_motor_each_f64(&motor, sizeof motor, rows.data(), SIZE, MW_MATRIX_ROWS_3X4, 1,
                                              MW_NEAREST_ROTATION, nullptr),
          "a matrix");
    return motor;
}

mw_motor_f64 read_quaternion(const Field &pose)
{
    pose.check_object({"quaternion", "translation"});
    std::vector<double> xyzw = pose["quaternion"].numbers(4);
    const double length = std::hypot(std::hypot(xyzw[0], xyzw[1]), std::hypot(xyzw[2], xyzw[3]));
    if (!(length > 0))
        throw pose["quaternion"].error("has length zero and is no rotation; [0, 0, 0, 1] is the one by 0 degrees");
    for (double &component : xyzw)
        component /= length;
    const std::vector<double> offset = vector_or_zero(pose, "translation");
    mw_motor_f64 motor;
    check(mw_convert_pose_to_motor_each_f64(&motor, sizeof motor, xyzw.data(), 4 * sizeof(double), offset.data(),
                                            3 * sizeof(double), 1),
          "a quaternion");
    return motor;
}

/* A rotation, and then a translation: along its axis, or any. */
mw_motor_f64 read_axis(const Field &pose)
{
    pose.check_object({"axis", "degrees", "radians", "through", "along", "translate"});
    const mw_motor_f64 rotation = read_rotation(pose);
    std::vector<double> offset = vector_or_zero(pose, "translate");
    if (pose.has("along")) {
        const std::vector<double> axis = pose["axis"].numbers(3);
        const double length = std::hypot(axis[0], axis[1], axis[2]);
        for (std::size_t k = 0; k < 3; ++k)
            offset[k] += pose["along"].number() * (axis[k] / length);
    }
    return sequence(rotation, translation(offset));
}

struct Form {
    const char *key;
    mw_motor_f64 (*read)(const Field &pose);
};
constexpr Form FORMS[] = {{"steps", read_steps},
                          {"motor", read_motor},
                          {"matrix", read_matrix},
                          {"quaternion", read_quaternion},
                          {"axis", read_axis}};

const Form &form_of(const Field &pose)
{
    pose.check_object({"steps", "motor", "matrix", "quaternion", "translation", "axis", "degrees", "radians",
                       "through", "along", "translate"});
    const auto is_there = [&](const Form &form) { return pose.has(form.key); };
    if (std::count_if(std::begin(FORMS), std::end(FORMS), is_there) != 1)
        throw pose.error(
            "a pose is one of \"steps\", \"motor\", \"matrix\", \"quaternion\" and \"axis\"; give one of "
            "them");
    return *std::find_if(std::begin(FORMS), std::end(FORMS), is_there);
}

} // namespace

mw_motor_f64 read_pose(const Field &pose)
{
    const mw_motor_f64 motor = form_of(pose).read(pose);
    for (double component : {motor.s, motor.b12, motor.b13, motor.b23, motor.b1i, motor.b2i, motor.b3i, motor.w})
        if (!std::isfinite(static_cast<float>(component)))
            throw pose.error("the pose is too large for floats; use smaller lengths");
    return motor;
}

std::vector<mw_motor_f64> read_poses(const Field &poses)
{
    std::vector<mw_motor_f64> motors;
    for (const Field &pose : poses.array())
        motors.push_back(read_pose(pose));
    return motors;
}

} // namespace motorway::tool
