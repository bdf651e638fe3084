#include "motion.h"

#include <algorithm>

#include "error.h"
#include "status.h"
#include "text.h"

namespace motorway::tool {

std::vector<float> even_parameters(const Motion &motion, std::size_t count)
{
    const double start = motion.start(), end = motion.end();
    std::vector<float> parameters(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        parameters[i] = std::clamp(static_cast<float>(start + share * (end - start)), motion.start(), motion.end());
    }
    return parameters;
}

std::vector<mw_motor_f32> sample(const Motion &motion, const std::vector<float> &parameters, const std::string &where)
{
    std::vector<mw_motor_f32> motors(parameters.size());
    const mw_bspline_f32 spline = motion.spline();
    check(mw_sample_bspline_f32(mw_motors_f32_aos(motors.data(), sizeof motors[0]), &spline, parameters.data(),
                                parameters.size()),
          where);
    std::size_t bad = 0;
    const mw_status status =
        mw_check_motors_f32(mw_const_motors_f32_aos(motors.data(), sizeof motors[0]), motors.size(), &bad);
    if (status == MW_ERROR_DEGENERATE_MOTOR)
        throw Error(where, "the motion has no pose at t = " + brief(static_cast<double>(parameters[bad])) +
                               ", where its controls cancel; give neighbouring controls the same sign");
    check(status, where);
    return motors;
}

std::vector<float> trace(const std::vector<mw_motor_f32> &motors, const float point[3])
{
    std::vector<float> path(3 * motors.size());
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i] = point[i % 3];
    constexpr std::size_t STRIDE = 3 * sizeof(float);
    check(mw_apply_point_each_f32(mw_xyz_f32_aos(path.data(), STRIDE),
                                  mw_const_motors_f32_aos(motors.data(), sizeof motors[0]),
                                  mw_const_xyz_f32_aos(path.data(), STRIDE), motors.size(), MW_DEFAULT),
          "the path of a point");
    return path;
}

} // namespace motorway::tool
