#include "samples.h"

#include <cstddef>
#include <utility>

#include <nlohmann/json.hpp>

#include "progress.h"
#include "status.h"
#include "text.h"

namespace motorway::tool {
namespace {

using Quantity = Samples::Quantity;

constexpr std::size_t VECTOR = 3 * sizeof(double), QUATERNION = 4 * sizeof(double), TWIST = 6 * sizeof(double);

Quantity motor_quantity(const std::vector<mw_motor_f64> &motors)
{
    Quantity quantity = {"motor", {"s", "b12", "b13", "b23", "b1i", "b2i", "b3i", "w"}, {}};
    for (const mw_motor_f64 &m : motors)
        quantity.values.insert(quantity.values.end(), {m.s, m.b12, m.b13, m.b23, m.b1i, m.b2i, m.b3i, m.w});
    return quantity;
}

void add_poses(Samples &samples, const std::vector<mw_motor_f64> &motors)
{
    Quantity rotation = {"quaternion", {"qx", "qy", "qz", "qw"}, std::vector<double>(4 * motors.size())};
    Quantity translation = {"translation", {"tx", "ty", "tz"}, std::vector<double>(3 * motors.size())};
    check(mw_convert_motor_to_pose_each_f64(rotation.values.data(), QUATERNION,
                                            translation.values.data(), VECTOR,
                                            motors.data(), sizeof motors[0], motors.size()),
          "the poses of motors");
    samples.quantities = {motor_quantity(motors), std::move(rotation), std::move(translation)};
}

/* The origin of the body is at its translation in the space, and at zero in its own coordinates. */
void add_velocities(Samples &samples, const std::vector<double> &twists, Frame frame)
{
    constexpr double ZERO[3] = {0, 0, 0};
    Quantity angular = {"angular_velocity", {"omega_x", "omega_y", "omega_z"}, {}};
    Quantity linear = {"velocity", {"vx", "vy", "vz"}, {}};
    const std::vector<double> &translations = samples.quantities.back().values;
    for (std::size_t i = 0; i < samples.parameters.size(); ++i) {
        const double *const twist = &twists[6 * i];
        double velocity[3];
        check(mw_twist_velocity_f64(velocity, twist, frame == Frame::SPACE ? &translations[3 * i] : ZERO),
              "the velocity of a point");
        angular.values.insert(angular.values.end(), {2 * twist[2], -2 * twist[1], 2 * twist[0]});
        linear.values.insert(linear.values.end(), velocity, velocity + 3);
    }
    samples.quantities.push_back(std::move(angular));
    samples.quantities.push_back(std::move(linear));
    samples.frame = frame;
}

/* The values of a quantity in one sample. */
void append_values(std::string &text, const Quantity &quantity, std::size_t sample, const char *separator)
{
    const std::size_t width = quantity.columns.size();
    for (std::size_t k = 0; k < width; ++k) {
        text += k ? separator : "";
        append_number(text, quantity.values[width * sample + k] + 0.0); /* which makes a 0 of -0 */
    }
}

} // namespace

Samples take_samples(const Motion &motion, const std::vector<double> &parameters, std::optional<Frame> velocities)
{
    Samples samples;
    samples.parameters = parameters;
    if (!velocities) {
        add_poses(samples, sample(motion, parameters, "a sample"));
        return samples;
    }
    std::vector<mw_motor_f64> motors(parameters.size());
    std::vector<double> twists(6 * parameters.size());
    check(mw_sample_motion_twist_one_f64(motors.data(), sizeof motors[0],
                                         twists.data(), TWIST, motion.compiled(), 0,
                                         parameters.data(), parameters.size(),
                                         *velocities == Frame::BODY ? MW_BODY_FRAME : MW_DEFAULT),
          "a sample");
    normalize(motors);
    add_poses(samples, motors);
    add_velocities(samples, twists, *velocities);
    return samples;
}

std::string write_csv(const Samples &samples)
{
    std::string text = "t";
    for (const Quantity &quantity : samples.quantities)
        for (const std::string &column : quantity.columns)
            text += "," + column;
    text += "\n";
    Progress progress("writing sample", samples.parameters.size());
    for (std::size_t i = 0; i < samples.parameters.size(); ++i) {
        append_number(text, samples.parameters[i]);
        for (const Quantity &quantity : samples.quantities) {
            text += ",";
            append_values(text, quantity, i, ",");
        }
        text += "\n";
        progress.step();
    }
    return text;
}

std::string write_json(const Samples &samples, const Motion &motion)
{
    std::string text = "{\n  \"name\": " + nlohmann::json(motion.name).dump() + ",\n  \"scheme\": \"" +
                       scheme_name(motion.kind) + "\",\n  \"domain\": [" + precise(motion.start()) + ", " +
                       precise(motion.end()) + "],\n";
    if (samples.frame)
        text += std::string("  \"frame\": \"") + (*samples.frame == Frame::SPACE ? "space" : "body") + "\",\n";
    text += "  \"samples\": [";
    Progress progress("writing sample", samples.parameters.size());
    for (std::size_t i = 0; i < samples.parameters.size(); ++i) {
        text += i ? ",\n    {\"t\": " : "\n    {\"t\": ";
        append_number(text, samples.parameters[i]);
        for (const Quantity &quantity : samples.quantities) {
            text += ", \"" + quantity.name + "\": [";
            append_values(text, quantity, i, ", ");
            text += "]";
        }
        text += "}";
        progress.step();
    }
    return text + "\n  ]\n}\n";
}

} // namespace motorway::tool
