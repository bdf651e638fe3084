#include "pose.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "error.h"
#include "status.h"

namespace motorway::tool {

void pose_mesh(Pose &out, const Mesh &mesh, const mw_motor_f32 &motor)
{
    constexpr std::size_t STRIDE = 3 * sizeof(float);
    out.positions.resize(mesh.positions.size());
    out.normals.resize(mesh.normals.size());
    check(mw_apply_point_one_f32(mw_xyz_f32_aos(out.positions.data(), STRIDE), &motor,
                                 mw_const_xyz_f32_aos(mesh.positions.data(), STRIDE), mesh.vertex_count(),
                                 MW_DEFAULT),
          "posing the vertices");
    check(mw_apply_direction_one_f32(mw_xyz_f32_aos(out.normals.data(), STRIDE), &motor,
                                     mw_const_xyz_f32_aos(mesh.normals.data(), STRIDE), mesh.normal_count(),
                                     MW_DEFAULT),
          "posing the normals");
}

void check_finite(const Pose &pose, const std::string &where)
{
    for (std::size_t i = 0; i < pose.positions.size(); ++i)
        if (!std::isfinite(pose.positions[i]))
            throw Error(where, "vertex " + std::to_string(i / 3) +
                                   " (counting from 0) lands too far away for floats; use smaller lengths");
}

static double distance(const std::vector<float> &positions, const Edge &edge)
{
    double squares = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double difference = static_cast<double>(positions[3 * std::size_t{edge.first} + axis]) -
                                  positions[3 * std::size_t{edge.second} + axis];
        squares += difference * difference;
    }
    return std::sqrt(squares);
}

double edge_deviation(const Mesh &mesh, const std::vector<Edge> &edges, const Pose &pose)
{
    double largest = 0;
    for (const Edge &edge : edges)
        largest = std::max(largest, std::abs(distance(pose.positions, edge) - distance(mesh.positions, edge)));
    return largest;
}

Speed measure_speed(const Mesh &mesh, const std::vector<mw_motor_f32> &motors)
{
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds ENOUGH(250);
    constexpr std::size_t MOST_PASSES = 10000;
    std::vector<double> seconds;
    Pose pose;
    pose_mesh(pose, mesh, motors.front()); /* the first pass should not pay for new memory */
    const Clock::time_point start = Clock::now();
    Clock::time_point now = start;
    do {
        const Clock::time_point begin = now;
        for (const mw_motor_f32 &motor : motors)
            pose_mesh(pose, mesh, motor);
        now = Clock::now();
        seconds.push_back(std::chrono::duration<double>(now - begin).count());
    } while (now - start < ENOUGH && seconds.size() < MOST_PASSES);
    const auto median = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), median, seconds.end());
    const double vertices = static_cast<double>(mesh.vertex_count()) * static_cast<double>(motors.size());
    return {vertices / std::max(*median, 1e-9), seconds.size()};
}

} // namespace motorway::tool
