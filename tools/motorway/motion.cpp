#include "motion.h"

#include <algorithm>

#include "error.h"
#include "status.h"

namespace motorway::tool {

mw_status Motion::compile(std::size_t *where)
{
    mw_motion_f64 motion = {};
    motion.kind = kind;
    motion.degree = degree;
    motion.controls = controls.data();
    motion.control_count = controls.size();
    motion.knots = knots.data();
    motion.knot_count = knots.size();
    motion.weights = weights.empty() ? nullptr : weights.data();
    motion.closed = closed;
    motion.base = base ? &*base : nullptr;
    std::size_t size = 0;
    const mw_status status = mw_motion_size_f64(&size, &motion, where);
    if (status != MW_OK)
        return status;
    memory.resize((size + sizeof memory[0] - 1) / sizeof memory[0]);
    const mw_compiled_motion_f64 *result = nullptr;
    return mw_compile_motion_f64(&result, memory.data(), memory.size() * sizeof memory[0], &motion,
                                 keep_signs ? MW_KEEP_SIGNS : MW_DEFAULT, where);
}

static std::array<double, 2> domain(const Motion &motion)
{
    std::array<double, 2> ends;
    check(mw_motion_domain_f64(ends.data(), motion.compiled()), "the domain of a motion");
    return ends;
}

double Motion::start() const
{
    return domain(*this)[0];
}

double Motion::end() const
{
    return domain(*this)[1];
}

const char *scheme_name(mw_motion_kind kind)
{
    switch (kind) {
    case MW_MOTION_ADDITIVE:
        return "additive";
    case MW_MOTION_MULTIPLICATIVE:
        return "multiplicative";
    case MW_MOTION_CUMULATIVE:
        return "cumulative";
    case MW_MOTION_GENERATOR:
        return "generator";
    case MW_MOTION_GENERATOR_KEYS:
        return "generator_keys";
    }
    return "unknown";
}

std::vector<double> even_parameters(const Motion &motion, std::size_t count)
{
    const auto [start, end] = domain(motion);
    std::vector<double> parameters(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        parameters[i] = std::clamp((1 - share) * start + share * end, start, end);
    }
    return parameters;
}

std::vector<mw_motor_f64> sample(const Motion &motion, const std::vector<double> &parameters,
                                 const std::string &where)
{
    std::vector<mw_motor_f64> motors(parameters.size());
    check(mw_sample_motion_one_f64(motors.data(), sizeof motors[0], motion.compiled(), 0,
                                   parameters.data(), parameters.size(), MW_DEFAULT),
          where);
    normalize(motors);
    return motors;
}

void normalize(std::vector<mw_motor_f64> &motors)
{
    check(mw_normalize_motor_each_f64(motors.data(), sizeof motors[0],
                                      motors.data(), sizeof motors[0], motors.size()),
          "normalised motors");
}

std::vector<double> trace(const std::vector<mw_motor_f64> &motors, const std::array<double, 3> &point)
{
    std::vector<double> path(3 * motors.size());
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i] = point[i % 3];
    constexpr std::size_t STRIDE = 3 * sizeof(double);
    check(mw_apply_point_each_f64(path.data(), STRIDE,
                                  motors.data(), sizeof motors[0],
                                  path.data(), STRIDE, motors.size(), MW_DEFAULT),
          "the path of a point");
    return path;
}

} // namespace motorway::tool
