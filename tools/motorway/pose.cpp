#include "pose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "error.h"
#include "status.h"

namespace motorway::tool {
namespace {

constexpr std::size_t STRIDE = 3 * sizeof(double), FLOAT_STRIDE = 3 * sizeof(float);

void pose_points(std::vector<double> &out, const std::vector<double> &points, const mw_motor_f64 &motor)
{
    out.resize(points.size());
    check(mw_apply_point_one_f64(out.data(), STRIDE, &motor, points.data(), STRIDE, points.size() / 3, MW_DEFAULT),
          "posing the vertices");
}

void pose_directions(std::vector<double> &out, const std::vector<double> &directions, const mw_motor_f64 &motor)
{
    out.resize(directions.size());
    check(mw_apply_direction_one_f64(out.data(), STRIDE, &motor, directions.data(), STRIDE, directions.size() / 3,
                                     MW_DEFAULT),
          "posing the normals");
}

void round_to_floats(std::vector<double> &numbers)
{
    for (double &number : numbers)
        number = static_cast<float>(number);
}

double distance(const std::vector<double> &positions, const Edge &edge)
{
    const double *p = &positions[3 * std::size_t{edge.first}], *q = &positions[3 * std::size_t{edge.second}];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

mw_motor_f32 rounded(const mw_motor_f64 &m)
{
    const auto narrow = [](double component) { return static_cast<float>(component); };
    return {narrow(m.s),   narrow(m.b12), narrow(m.b13), narrow(m.b23),
            narrow(m.b1i), narrow(m.b2i), narrow(m.b3i), narrow(m.w)};
}

/* One pass over the mesh by one motor, in the precision of its file. Directions need no double on floats: a motor's
 * rotation is rounded without harm. */
std::function<void(const mw_motor_f64 &)> one_pass(const Mesh &mesh)
{
    if (mesh.in_double)
        return [&mesh, pose = Pose()](const mw_motor_f64 &motor) mutable {
            pose_points(pose.positions, mesh.positions, motor);
            pose_directions(pose.normals, mesh.normals, motor);
        };
    const std::vector<float> points(mesh.positions.begin(), mesh.positions.end());
    const std::vector<float> directions(mesh.normals.begin(), mesh.normals.end());
    return [points, directions, posed_points = points, posed_directions = directions](const mw_motor_f64 &m) mutable {
        const mw_motor_f32 narrow = rounded(m);
        check(mw_apply_point_one_mixed(posed_points.data(), FLOAT_STRIDE, &m, nullptr, points.data(),
                                       FLOAT_STRIDE, points.size() / 3, MW_DEFAULT),
              "posing the vertices");
        check(mw_apply_direction_one_f32(posed_directions.data(), FLOAT_STRIDE, &narrow, directions.data(),
                                         FLOAT_STRIDE, directions.size() / 3, MW_DEFAULT),
              "posing the normals");
    };
}

} // namespace

void pose_mesh(Pose &out, const Mesh &mesh, const mw_motor_f64 &motor)
{
    pose_points(out.positions, mesh.positions, motor);
    pose_directions(out.normals, mesh.normals, motor);
    pose_directions(out.tangents, mesh.tangents, motor);
    pose_directions(out.bitangents, mesh.bitangents, motor);
    pose_directions(out.face_normals, mesh.face_normals, motor);
    if (!mesh.in_double)
        for (auto *numbers : {&out.positions, &out.normals, &out.tangents, &out.bitangents, &out.face_normals})
            round_to_floats(*numbers);
}

void check_finite(const Pose &pose, const Mesh &mesh, const std::string &where)
{
    for (std::size_t i = 0; i < pose.positions.size(); ++i)
        if (!std::isfinite(pose.positions[i]) && mesh.has_finite_position(i / 3))
            throw Error(where, "vertex " + std::to_string(i / 3) + " (counting from 0) lands too far away for " +
                                   (mesh.in_double ? "doubles" : "floats") + "; use smaller lengths");
}

double edge_deviation(const Mesh &mesh, const std::vector<Edge> &edges, const Pose &pose)
{
    double largest = 0;
    for (const Edge &edge : edges)
        largest = std::max(largest, std::abs(distance(pose.positions, edge) - distance(mesh.positions, edge)));
    return largest;
}

Speed measure_speed(const Mesh &mesh, const std::vector<mw_motor_f64> &motors)
{
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds ENOUGH(250);
    constexpr std::size_t MOST_PASSES = 10000;
    std::vector<double> seconds;
    auto pose_once = one_pass(mesh);
    pose_once(motors.front()); /* the first pass should not pay for new memory */
    const Clock::time_point start = Clock::now();
    Clock::time_point now = start;
    do {
        const Clock::time_point begin = now;
        for (const mw_motor_f64 &motor : motors)
            pose_once(motor);
        now = Clock::now();
        seconds.push_back(std::chrono::duration<double>(now - begin).count());
    } while (now - start < ENOUGH && seconds.size() < MOST_PASSES);
    const auto median = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), median, seconds.end());
    const double vertices = static_cast<double>(mesh.vertex_count()) * static_cast<double>(motors.size());
    return {vertices / std::max(*median, 1e-9), seconds.size()};
}

} // namespace motorway::tool
