#include "picture_scene.h"

#include <set>

#include "error.h"
#include "normals.h"
#include "pose.h"
#include "simplify.h"

namespace motorway::tool {
namespace {

bool is_closed(const Mesh &mesh)
{
    std::set<Edge> open;
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t begin = mesh.face_starts[face], end = mesh.face_starts[face + 1];
        for (std::size_t corner = begin; corner < end; ++corner) {
            const std::uint32_t a = mesh.corners[corner], b = mesh.corners[corner + 1 < end ? corner + 1 : begin];
            if (open.erase({b, a}) == 0 && !open.insert({a, b}).second)
                return false;
        }
    }
    return open.empty();
}

Box3 box_of(const std::vector<Vec3> &points)
{
    Box3 box = {points.front(), points.front()};
    for (Vec3 p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    return box;
}

/* How far the mesh has travelled up to each of many motors: the mean over the corners of its bounding box, so that
 * turning on the spot counts as well. */
std::vector<double> travelled(const Mesh &mesh, const std::vector<mw_motor_f64> &motors)
{
    const Box box = bounding_box(mesh);
    std::vector<double> distances(motors.size(), 0.0);
    for (int corner = 0; corner < 8; ++corner) {
        std::array<double, 3> point;
        for (std::size_t axis = 0; axis < 3; ++axis)
            point[axis] = corner >> axis & 1 ? box.high[axis] : box.low[axis];
        const std::vector<double> path = trace(motors, point);
        double distance = 0;
        for (std::size_t i = 1; i < motors.size(); ++i) {
            distance += length(vector_at(path, i) - vector_at(path, i - 1)) / 8;
            distances[i] += distance;
        }
    }
    return distances;
}

/* `count` parameters, both ends included, between which the mesh travels about equally far: a motion that dawdles
 * would otherwise pile its figures up. */
std::vector<double> evenly_travelled_parameters(const Mesh &mesh, const Motion &motion, std::size_t count,
                                                const std::string &path)
{
    const std::vector<double> fine = even_parameters(motion, 1000);
    const std::vector<double> distances = travelled(mesh, sample(motion, fine, path));
    std::vector<double> parameters = even_parameters(motion, count);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double wanted = distances.back() * static_cast<double>(i) / static_cast<double>(count - 1);
        const auto reached = std::lower_bound(distances.begin(), distances.end(), wanted);
        parameters[i] = fine[static_cast<std::size_t>(reached - distances.begin())];
    }
    return parameters;
}

std::vector<Figure> pose_figures(const Mesh &mesh, const Motion &motion, std::size_t count, const std::string &path)
{
    const std::vector<double> parameters = evenly_travelled_parameters(mesh, motion, count, path);
    const std::vector<mw_motor_f64> motors = sample(motion, parameters, path);
    std::vector<Figure> figures(count);
    for (std::size_t i = 0; i < count; ++i) {
        figures[i].share = (parameters[i] - motion.start()) / (motion.end() - motion.start());
        pose_mesh(figures[i].pose, mesh, motors[i]);
        check_finite(figures[i].pose, mesh, path);
        figures[i].pose.normals = vertex_normals(mesh, figures[i].pose.normals);
        std::vector<Vec3> points;
        for (std::size_t k = 0; k < mesh.vertex_count(); ++k)
            points.push_back(vector_at(figures[i].pose.positions, k));
        figures[i].box = box_of(points);
    }
    return figures;
}

/* The control poses as frames with axes of this length. */
std::vector<std::array<Vec3, 4>> control_frames(const Motion &motion, const std::array<double, 3> &origin,
                                                double length)
{
    std::vector<std::array<Vec3, 4>> frames(motion.controls.size());
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<double, 3> tip = origin;
        if (k > 0)
            tip[k - 1] += length;
        const std::vector<double> path = trace(motion.controls, tip);
        for (std::size_t i = 0; i < frames.size(); ++i)
            frames[i][k] = vector_at(path, i);
    }
    return frames;
}

/* How many of `count` things must be passed over for each that is drawn, so that at most so many are. */
std::size_t step_between(std::size_t count, std::size_t most)
{
    return (count + most - 1) / most;
}

/* Of a cloud some of its points, and of other meshes some of their lines, spread evenly over the file. */
void choose_points_and_lines(Scene &scene, const Mesh &mesh, std::size_t most)
{
    const std::size_t point_step = step_between(mesh.vertex_count(), most);
    for (std::size_t vertex = 0; vertex < mesh.vertex_count() && mesh.is_cloud(); vertex += point_step)
        scene.points.push_back(static_cast<std::uint32_t>(vertex));
    const std::size_t line_step = step_between(mesh.lines.size(), most);
    for (std::size_t line = 0; line < mesh.lines.size(); line += line_step)
        scene.lines.push_back(mesh.lines[line]);
    scene.simplified = line_step > 1 || (mesh.is_cloud() && point_step > 1);
}

} // namespace

std::vector<Vec3> outermost_points(const Scene &scene)
{
    std::vector<Vec3> points;
    for (const Figure &figure : scene.figures)
        for (int corner = 0; corner < 8; ++corner)
            points.push_back({corner & 1 ? figure.box.high.x : figure.box.low.x,
                              corner & 2 ? figure.box.high.y : figure.box.low.y,
                              corner & 4 ? figure.box.high.z : figure.box.low.z});
    for (std::size_t i = 0; i <= PATH_STEPS; ++i)
        points.push_back(vector_at(scene.path, i));
    for (const auto &frame : scene.control_frames)
        points.insert(points.end(), frame.begin(), frame.end());
    return points;
}

Scene make_scene(const Mesh &whole, const Motion &motion, std::size_t pose_count, const std::string &path)
{
    constexpr std::size_t MOST_DRAWN = 35000; /* of all figures together: keeps the file below 2 MB */
    constexpr double LARGEST = 1e100;           /* whose square is finite */
    Scene scene;
    scene.closed = is_closed(whole); /* then only about half of the triangles face the eye */
    const Mesh mesh = simplified(whole, (scene.closed ? 2 : 1) * MOST_DRAWN / pose_count);
    scene.figures = pose_figures(mesh, motion, pose_count, path);
    const std::array<double, 3> origin = far_origin(mesh);
    scene.path = trace(sample(motion, even_parameters(motion, PATH_STEPS + 1), path), origin);
    choose_points_and_lines(scene, mesh, MOST_DRAWN / pose_count);
    scene.simplified = scene.simplified || mesh.face_count() < whole.face_count();
    scene.triangles = triangles(mesh);
    for (Triangle &triangle : scene.triangles)
        for (std::uint32_t &corner : triangle)
            corner = mesh.corners[corner];
    scene.control_frames = control_frames(motion, origin, 0);
    const double size = box_of(outermost_points(scene)).longest_side();
    if (!(size < LARGEST))
        throw Error(path, "the mesh goes too far away to be drawn; use smaller lengths");
    scene.control_frames = control_frames(motion, origin, 0.055 * size);
    scene.box = box_of(outermost_points(scene));
    return scene;
}

} // namespace motorway::tool
