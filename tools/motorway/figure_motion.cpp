#include "figure_motion.h"

#include "status.h"

namespace motorway::tool {
namespace {

constexpr Vec3 ORIGIN = {0, 0, 0};

} // namespace

mw_motor_f64 rotation(Vec3 axis, double angle)
{
    mw_motor_f64 motor;
    check(mw_rotation_f64(&motor, &axis.x, angle, nullptr), "a rotation");
    return motor;
}

mw_motor_f64 translation(Vec3 offset)
{
    mw_motor_f64 motor;
    check(mw_translation_f64(&motor, &offset.x), "a translation");
    return motor;
}

mw_motor_f64 product(const mw_motor_f64 &first, const mw_motor_f64 &then)
{
    mw_motor_f64 both;
    check(mw_compose_motor_each_f64(&both, sizeof both, &first, sizeof first, &then, sizeof then, 1),
          "a product of motors");
    return both;
}

Poses blends(const Poses &controls, const std::vector<std::vector<double>> &weights)
{
    std::vector<double> rows;
    for (const std::vector<double> &row : weights)
        rows.insert(rows.end(), row.begin(), row.end());
    std::vector<const double *> terms;
    for (std::size_t k = 0; k < controls.size(); ++k)
        terms.push_back(rows.data() + k);
    Poses poses(weights.size());
    const mw_motors_f64 out = mw_motors_f64_aos(poses.data(), sizeof poses[0]);
    const mw_weights_f64 by_terms = {terms.data(), controls.size() * sizeof(double)};
    check(mw_blend_motor_one_views_f64(&out, controls.data(), &by_terms, controls.size(), poses.size()),
          "a sum of motors");
    return poses;
}

Path images(const mw_motor_f64 &pose, const Path &points)
{
    Path moved(points.size());
    check(mw_apply_point_one_f64(&moved[0].x, sizeof moved[0], &pose, &points[0].x, sizeof points[0], points.size(),
                                 MW_DEFAULT), "points of a figure");
    return moved;
}

Path images(const Poses &poses, Vec3 point)
{
    Path path(poses.size());
    check(mw_apply_point_grid_f64(&path[0].x, sizeof point, sizeof point, poses.data(), sizeof poses[0], poses.size(),
                                  &point.x, sizeof point, 1, MW_DEFAULT),
          "the path of a point");
    return path;
}

std::vector<double> spread(double first, double last, std::size_t count)
{
    std::vector<double> numbers(count, first);
    for (std::size_t i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        numbers[i] = (1 - share) * first + share * last;
    }
    return numbers;
}

CompiledMotion::CompiledMotion(mw_motion_kind kind, unsigned degree, const Poses &controls,
                               const std::vector<double> &knots)
{
    mw_motion_f64 description = {};
    description.kind = kind;
    description.degree = degree;
    description.controls = controls.data();
    description.control_count = controls.size();
    description.knots = knots.data();
    description.knot_count = knots.size();
    compile(description, MW_DEFAULT);
}

CompiledMotion CompiledMotion::through(const Poses &keys, const std::vector<double> &times, unsigned degree)
{
    Poses controls(keys.size());
    std::vector<double> knots(keys.size() + degree - 1);
    const mw_motion_arrays_f64 arrays = {controls.data(), controls.size(), knots.data(), knots.size()};
    mw_motion_f64 description;
    const auto solve = [&](void *memory, std::size_t &size) {
        check(mw_interpolate_keys_f64(&description, &arrays, MW_MOTION_ADDITIVE, degree, keys.data(), times.data(),
                                      keys.size(), memory, &size, nullptr),
              "a motion through keys");
    };
    std::size_t size = 0;
    solve(nullptr, size);
    std::vector<double> memory(size / sizeof(double) + 1);
    size = memory.size() * sizeof(double);
    solve(memory.data(), size);
    /* The controls may be further apart than the keys, and another sign would make another motion. */
    return CompiledMotion(description, MW_KEEP_SIGNS);
}

void CompiledMotion::compile(const mw_motion_f64 &description, unsigned flags)
{
    std::size_t size;
    check(mw_motion_size_f64(&size, &description, nullptr), "a motion");
    memory_.resize(size / sizeof(double) + 1);
    const mw_compiled_motion_f64 *compiled;
    check(mw_compile_motion_f64(&compiled, memory_.data(), memory_.size() * sizeof(double), &description, flags,
                                nullptr),
          "a motion");
    check(mw_motion_domain_f64(domain_, compiled), "a motion");
}

const mw_compiled_motion_f64 *CompiledMotion::compiled() const
{
    return reinterpret_cast<const mw_compiled_motion_f64 *>(memory_.data());
}

Poses CompiledMotion::poses(std::size_t count) const
{
    Poses poses(count);
    check(mw_sample_motion_one_f64(poses.data(), sizeof poses[0], compiled(), 0, parameters(count).data(), count,
                                   MW_DEFAULT),
          "the poses of a motion");
    return poses;
}

Path CompiledMotion::path(std::size_t count) const
{
    Path path(count);
    check(mw_apply_point_motion_f64(&path[0].x, sizeof ORIGIN, sizeof ORIGIN, compiled(), 0, parameters(count).data(),
                                    count, &ORIGIN.x, sizeof ORIGIN, 1, MW_DEFAULT),
          "the path of a motion");
    return path;
}

std::vector<double> CompiledMotion::speeds(std::size_t count) const
{
    Poses poses(count);
    std::vector<double> twists(6 * count), speeds(count);
    check(mw_sample_motion_twist_one_f64(poses.data(), sizeof poses[0], twists.data(), 6 * sizeof(double), compiled(), 0, parameters(count).data(), count, MW_DEFAULT),
          "the velocities of a motion");
    const Path places = images(poses, ORIGIN);
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 velocity;
        check(mw_twist_velocity_f64(&velocity.x, &twists[6 * i], &places[i].x), "a velocity");
        speeds[i] = tool::length(velocity);
    }
    return speeds;
}

double CompiledMotion::length() const
{
    double length;
    check(mw_motion_lengths_f64(&length, compiled(), 0, &ORIGIN.x, &domain_[1], 1), "the length of a motion");
    return length;
}

double CompiledMotion::distance(const CompiledMotion &other, const Path &points) const
{
    constexpr std::size_t SAMPLES = 1001;
    mw_motion_distance_f64 largest;
    check(mw_compare_motions_f64(&largest, compiled(), 0, other.compiled(), 0, &points[0].x, sizeof points[0], points.size(), SAMPLES),
          "the distance of two motions");
    return largest.distance;
}

} // namespace motorway::tool
