#include "motion_file.h"

#include <cmath>

#include "error.h"
#include "files.h"
#include "json_field.h"
#include "status.h"

namespace motorway::tool {
namespace {

constexpr double PI = 3.14159265358979323846;

mw_motor_f64 read_rotation(const Field &rotation)
{
    rotation.check_object({"axis", "degrees", "radians", "through"});
    const std::vector<double> axis = rotation["axis"].numbers(3);
    if (rotation.has("degrees") == rotation.has("radians"))
        throw rotation.error("needs either \"degrees\" or \"radians\"; give one of them");
    const double angle =
        rotation.has("degrees") ? rotation["degrees"].number() * (PI / 180) : rotation["radians"].number();
    const std::vector<double> point =
        rotation.has("through") ? rotation["through"].numbers(3) : std::vector<double>(3, 0.0);
    mw_motor_f64 motor;
    const mw_status status = mw_rotation_f64(&motor, axis.data(), angle, point.data());
    if (status == MW_ERROR_AXIS)
        throw rotation["axis"].error(mw_status_text(status));
    check(status, "a rotation");
    return motor;
}

mw_motor_f64 read_step(const Field &step)
{
    step.check_object({"rotate", "translate"});
    if (step.has("rotate") == step.has("translate"))
        throw step.error("a step is one \"rotate\" or one \"translate\"; write a step for each");
    if (step.has("rotate"))
        return read_rotation(step["rotate"]);
    mw_motor_f64 motor;
    check(mw_translation_f64(&motor, step["translate"].numbers(3).data()), "a translation");
    return motor;
}

/* The first step acts first: the paper's product R T, read from left to right. */
mw_motor_f64 read_steps(const Field &steps)
{
    mw_motor_f64 pose = {1, 0, 0, 0, 0, 0, 0, 0};
    for (const Field &field : steps.array()) {
        const mw_motor_f64 step = read_step(field);
        mw_motor_f64 both;
        check(mw_compose_motor_each_f64(mw_motors_f64_aos(&both, sizeof both),
                                        mw_const_motors_f64_aos(&pose, sizeof pose),
                                        mw_const_motors_f64_aos(&step, sizeof step), 1),
              "a product of motors");
        pose = both;
    }
    return pose;
}

mw_motor_f64 read_motor(const Field &field)
{
    const std::vector<double> c = field.numbers(8);
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
}

mw_motor_f32 read_control(const Field &control)
{
    control.check_object({"steps", "motor"});
    if (control.has("steps") == control.has("motor"))
        throw control.error("a control pose is either \"steps\" or a \"motor\"; give one of them");
    const mw_motor_f64 wide = control.has("steps") ? read_steps(control["steps"]) : read_motor(control["motor"]);
    const mw_motor_f32 motor = {
        static_cast<float>(wide.s),   static_cast<float>(wide.b12), static_cast<float>(wide.b13),
        static_cast<float>(wide.b23), static_cast<float>(wide.b1i), static_cast<float>(wide.b2i),
        static_cast<float>(wide.b3i), static_cast<float>(wide.w),
    };
    for (float component : {motor.s, motor.b12, motor.b13, motor.b23, motor.b1i, motor.b2i, motor.b3i, motor.w})
        if (!std::isfinite(component))
            throw control.error("the pose is too large for floats; use smaller lengths");
    return motor;
}

unsigned read_degree(const Field &degree)
{
    const long long value = degree.integer();
    if (value < 1 || value > MW_MAX_DEGREE)
        throw degree.error(mw_status_text(MW_ERROR_DEGREE));
    return static_cast<unsigned>(value);
}

/* Degree and knots: written out for a B-spline, implied by the number of controls for the other kinds. */
void read_scheme(const Field &root, Motion &motion)
{
    const std::string kind = root["kind"].string();
    const std::size_t count = motion.controls.size();
    if (kind == "bspline") {
        root.check_object({"motorway", "name", "mesh_size", "kind", "degree", "knots", "controls"});
        motion.degree = read_degree(root["degree"]);
        for (const Field &knot : root["knots"].array())
            motion.knots.push_back(static_cast<float>(knot.number()));
        return;
    }
    if (kind != "bezier" && kind != "linear")
        throw root["kind"].error("must be \"bspline\", \"bezier\" or \"linear\"; correct it");
    root.check_object({"motorway", "name", "mesh_size", "kind", "controls"});
    if (count < 2)
        throw root["controls"].error("holds " + std::to_string(count) + ", and a motion needs 2 or more; add some");
    if (kind == "linear") {
        motion.degree = 1;
        for (std::size_t i = 0; i < count; ++i)
            motion.knots.push_back(static_cast<float>(i));
        return;
    }
    if (count - 1 > MW_MAX_DEGREE)
        throw root["controls"].error(mw_status_text(MW_ERROR_DEGREE));
    motion.degree = static_cast<unsigned>(count - 1);
    motion.knots.assign(motion.degree, 0.0f);
    motion.knots.insert(motion.knots.end(), motion.degree, 1.0f);
}

/* The library says what is wrong; this says which field it means. */
void check_spline(const Motion &motion, const Field &root)
{
    const mw_bspline_f32 spline = motion.spline();
    std::size_t where = 0;
    const mw_status status = mw_check_bspline_f32(&spline, &where);
    const std::string text = mw_status_text(status);
    switch (status) {
    case MW_ERROR_CONTROL_COUNT:
        throw root["controls"].error("there are " + std::to_string(spline.control_count) + ": " + text);
    case MW_ERROR_KNOT_COUNT:
        throw root["knots"].error("there are " + std::to_string(spline.knot_count) + ", and degree " +
                                  std::to_string(motion.degree) + " with " + std::to_string(spline.control_count) +
                                  " controls needs " + std::to_string(spline.control_count + motion.degree - 1) +
                                  ": " + text);
    case MW_ERROR_KNOTS:
        throw root["knots"].array().at(where).error(text);
    case MW_ERROR_DEGENERATE_MOTOR:
        throw root["controls"].array().at(where).error(text);
    default:
        check(status, "the motion");
    }
}

} // namespace

Motion parse_motion(const std::string &contents, const std::string &path)
{
    const nlohmann::json document = parse_json(contents, path);
    const Field root(document, path);
    root.check_object({"motorway", "name", "mesh_size", "kind", "degree", "knots", "controls"});
    if (root["motorway"].integer() != 1)
        throw root["motorway"].error("unknown version of the motion format; this tool reads version 1");
    Motion motion;
    motion.controls.reserve(1); /* so that none at all is a wrong number to the library, and not a null pointer */
    motion.knots.reserve(1);
    if (root.has("name"))
        motion.name = root["name"].string();
    if (root.has("mesh_size")) {
        motion.mesh_size = root["mesh_size"].number();
        if (!(*motion.mesh_size > 0))
            throw root["mesh_size"].error("must be above 0; correct it");
    }
    for (const Field &control : root["controls"].array())
        motion.controls.push_back(read_control(control));
    read_scheme(root, motion);
    check_spline(motion, root);
    return motion;
}

Motion read_motion(const std::string &path)
{
    return parse_motion(read_file(path), path);
}

} // namespace motorway::tool
