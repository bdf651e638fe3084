#include "picture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "camera.h"
#include "colour.h"
#include "pose.h"
#include "simplify.h"
#include "summary.h"
#include "svg.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr double WIDTH = 1600, HEIGHT = 940;
constexpr Rectangle FRAME = {120, 130, WIDTH - 120, HEIGHT - 150};
constexpr double ELEVATION = 18;
constexpr std::size_t PATH_STEPS = 240;
constexpr float ORIGIN[3] = {0, 0, 0};

/* Something that hides what is farther away. */
struct Shape {
    double distance; /* from the eye */
    std::string style, path;
};

struct Box3 {
    Vec3 low, high;

    Vec3 middle() const { return 0.5 * (low + high); }
    double longest_side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-30}); }
};

/* The mesh at one parameter. */
struct Figure {
    double share; /* of the way along the motion, 0 to 1 */
    Pose pose;
    Box3 box;
};

/* What there is to see, in space. */
struct Scene {
    std::vector<Figure> figures;
    std::vector<float> path;                         /* of the origin, PATH_STEPS + 1 points */
    std::vector<std::array<Vec3, 4>> control_frames; /* the origin of each, and the tips of its axes */
    std::vector<Triangle> triangles;                 /* of vertices */
    bool closed;                                     /* nobody sees the inside of a closed mesh */
    bool simplified;                                 /* the mesh has more details than are drawn */
    Box3 box;
};

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
std::vector<double> travelled(const Mesh &mesh, const std::vector<mw_motor_f32> &motors)
{
    const Box box = bounding_box(mesh);
    std::vector<double> distances(motors.size(), 0.0);
    for (int corner = 0; corner < 8; ++corner) {
        float point[3];
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = static_cast<float>(corner >> axis & 1 ? box.high[axis] : box.low[axis]);
        const std::vector<float> path = trace(motors, point);
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
    const std::vector<double> distances = travelled(mesh, rounded(sample(motion, fine, path)));
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
    const std::vector<mw_motor_f32> motors = rounded(sample(motion, parameters, path));
    std::vector<Figure> figures(count);
    for (std::size_t i = 0; i < count; ++i) {
        figures[i].share = (parameters[i] - motion.start()) / (motion.end() - motion.start());
        pose_mesh(figures[i].pose, mesh, motors[i]);
        check_finite(figures[i].pose, path);
        figures[i].pose.normals = vertex_normals(mesh, figures[i].pose.normals);
        std::vector<Vec3> points;
        for (std::size_t k = 0; k < mesh.vertex_count(); ++k)
            points.push_back(vector_at(figures[i].pose.positions, k));
        figures[i].box = box_of(points);
    }
    return figures;
}

/* Points that hold the whole scene between them: the corners of each figure's box, the path, the control poses. */
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

/* The control poses as frames with axes of this length. */
std::vector<std::array<Vec3, 4>> control_frames(const Motion &motion, double length)
{
    const float size = static_cast<float>(length);
    const float tips[4][3] = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    const std::vector<mw_motor_f32> controls = rounded(motion.controls);
    std::vector<std::array<Vec3, 4>> frames(controls.size());
    for (std::size_t k = 0; k < 4; ++k) {
        const std::vector<float> path = trace(controls, tips[k]);
        for (std::size_t i = 0; i < frames.size(); ++i)
            frames[i][k] = vector_at(path, i);
    }
    return frames;
}

Scene make_scene(const Mesh &whole, const Motion &motion, std::size_t pose_count, const std::string &path)
{
    constexpr std::size_t MOST_DRAWN = 35000; /* of all figures together: keeps the file below 2 MB */
    Scene scene;
    scene.closed = is_closed(whole); /* then only about half of the triangles face the eye */
    const Mesh mesh = simplified(whole, (scene.closed ? 2 : 1) * MOST_DRAWN / pose_count);
    scene.figures = pose_figures(mesh, motion, pose_count, path);
    scene.path = trace(rounded(sample(motion, even_parameters(motion, PATH_STEPS + 1), path)), ORIGIN);
    scene.simplified = mesh.face_count() < whole.face_count();
    scene.triangles = triangles(mesh);
    for (Triangle &triangle : scene.triangles)
        for (std::uint32_t &corner : triangle)
            corner = mesh.corners[corner];
    scene.control_frames = control_frames(motion, 0);
    scene.control_frames = control_frames(motion, 0.055 * box_of(outermost_points(scene)).longest_side());
    scene.box = box_of(outermost_points(scene));
    return scene;
}

/* How much the figures get in each other's way: pairs count by the inverse square of their distance on paper. */
double crowding(const Scene &scene, const Camera &camera)
{
    double sum = 0;
    for (const Figure &a : scene.figures)
        for (const Figure &b : scene.figures) {
            const Point2 p = camera.project(a.box.middle()), q = camera.project(b.box.middle());
            if (&a < &b)
                sum += 1 / ((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + 1);
        }
    return sum;
}

/* From a little above, and from the side from which the figures are best apart. */
Camera make_camera(const Scene &scene)
{
    const std::vector<Vec3> points = outermost_points(scene);
    Camera best(points, 0, ELEVATION, FRAME);
    for (int azimuth = -60; azimuth <= 60; azimuth += 5) {
        const Camera camera(points, azimuth, ELEVATION, FRAME);
        if (crowding(scene, camera) < crowding(scene, best))
            best = camera;
    }
    return best;
}

/* ------------------------------------------------------------------------------------------------ the ground --- */

/* 1, 2 or 5 times a power of ten: about a tenth of the extent. */
double grid_step(double extent)
{
    const double power = std::pow(10.0, std::floor(std::log10(extent / 10)));
    for (double step : {1.0, 2.0, 5.0})
        if (step * power >= 0.75 * extent / 10)
            return step * power;
    return 10 * power;
}

void draw_ground(Svg &svg, const Scene &scene, const Camera &camera)
{
    const Box3 &b = scene.box;
    const double step = grid_step(b.longest_side()), margin = 4 * step;
    const double left = std::floor((b.low.x - margin) / step), right = std::ceil((b.high.x + margin) / step);
    const double back = std::floor((b.low.z - margin) / step), front = std::ceil((b.high.z + margin) / step);
    const Point2 middle = camera.project({0.5 * (b.low.x + b.high.x), b.low.y, 0.5 * (b.low.z + b.high.z)});
    svg.add("<radialGradient id=\"fade\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1\" "
            "gradientTransform=\"translate(" +
            svg_number(middle.x) + " " + svg_number(middle.y) +
            ") scale(820 330)\"><stop offset=\".35\" stop-color=\"#fff\"/>"
            "<stop offset=\"1\" stop-color=\"#000\"/></radialGradient>");
    svg.add("<mask id=\"near\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" width=\"" + svg_number(WIDTH) +
            "\" height=\"" + svg_number(HEIGHT) + "\"><rect width=\"" + svg_number(WIDTH) + "\" height=\"" +
            svg_number(HEIGHT) + "\" fill=\"url(#fade)\"/></mask>\n<g mask=\"url(#near)\">");
    const std::string style = "stroke:#b9c1d0;stroke-width:1;fill:none";
    for (double i = left; i <= right; ++i)
        svg.line(camera.project({i * step, b.low.y, back * step}), camera.project({i * step, b.low.y, front * step}),
                 style);
    for (double i = back; i <= front; ++i)
        svg.line(camera.project({left * step, b.low.y, i * step}), camera.project({right * step, b.low.y, i * step}),
                 style);
    svg.add("</g>");
}

/* The convex hull, counter-clockwise (Andrew's monotone chain). */
std::vector<Point2> convex_hull(std::vector<Point2> points)
{
    std::sort(points.begin(), points.end(),
              [](Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Point2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (Point2 p : points) {
            while (hull.size() >= start + 2) {
                const Point2 a = hull[hull.size() - 2], b = hull.back();
                if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0)
                    break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/* Soft shadows straight below: wider and fainter the higher the figure is. */
void draw_shadows(Svg &svg, const Scene &scene, const Camera &camera)
{
    const double height = std::max(scene.box.high.y - scene.box.low.y, 1e-30);
    for (const Figure &figure : scene.figures) {
        std::vector<Point2> below;
        double lowest = scene.box.high.y;
        for (std::size_t i = 0; i < figure.pose.positions.size() / 3; ++i) {
            const Vec3 p = vector_at(figure.pose.positions, i);
            lowest = std::min(lowest, p.y);
            below.push_back(camera.project({p.x, scene.box.low.y, p.z}));
        }
        const double lift = (lowest - scene.box.low.y) / height;
        const std::string blur = svg_number(7 + 22 * lift);
        const std::string id = "blur" + std::to_string(&figure - scene.figures.data());
        svg.add("<filter id=\"" + id +
                "\" x=\"-50%\" y=\"-100%\" width=\"200%\" height=\"300%\">"
                "<feGaussianBlur stdDeviation=\"" +
                blur + "\"/></filter>");
        char opacity[16];
        std::snprintf(opacity, sizeof opacity, "%.2f", 0.42 - 0.30 * lift);
        svg.add("<g filter=\"url(#" + id + ")\" opacity=\"" + opacity + "\"><path transform=\"scale(.1)\" class=\"" +
                svg.style("fill:#3a4260") + "\" d=\"" + svg_tenths(convex_hull(below), true) + "\"/></g>");
    }
}

/* ----------------------------------------------------------------------------------------------- the figures --- */

/* Clay under a lamp over the left shoulder of the viewer, a bright sky, and a rim of light from behind. */
Colour shade(const Camera &camera, double share, Vec3 normal, Vec3 towards_eye)
{
    constexpr double LEVELS = 48;
    const Vec3 front = cross(camera.right(), camera.up());
    const Vec3 lamp = unit(-0.55 * camera.right() + 0.75 * camera.up() + 0.62 * front);
    const double lit = std::max(0.0, (dot(normal, lamp) + 0.2) / 1.2);
    const double sky = 0.5 + 0.5 * normal.y;
    const double rim = std::pow(1 - std::max(0.0, dot(normal, towards_eye)), 3);
    const double gloss = std::pow(std::max(0.0, dot(normal, unit(lamp + towards_eye))), 28);
    const double light = 0.54 + 0.42 * lit * lit * (3 - 2 * lit) + 0.10 * sky + 0.10 * rim + 0.16 * gloss;
    const double level = std::round(light * LEVELS) / LEVELS; /* few colours make a small file */
    Colour colour = gradient(share);
    colour.lightness = std::clamp(colour.lightness * level, 0.15, 0.97);
    colour.chroma *= 1 - 0.9 * std::max(0.0, level - 1);
    return colour;
}

void add_figure(std::vector<Shape> &shapes, Svg &svg, const Scene &scene, const Figure &figure, const Camera &camera)
{
    for (const Triangle &triangle : scene.triangles) {
        Vec3 p[3], normal = {0, 0, 0};
        std::vector<Point2> outline;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = vector_at(figure.pose.positions, triangle[k]);
            normal = normal + vector_at(figure.pose.normals, triangle[k]);
            outline.push_back(camera.project(p[k]));
        }
        const Vec3 middle = (1.0 / 3) * (p[0] + p[1] + p[2]);
        const Vec3 towards_eye = camera.towards_eye(middle);
        const bool faces_away = dot(cross(p[1] - p[0], p[2] - p[0]), towards_eye) <= 0;
        if (faces_away && scene.closed)
            continue;
        const Vec3 outward = faces_away ? -1 * unit(normal) : unit(normal);
        const std::string colour = hex(shade(camera, figure.share, outward, towards_eye));
        /* The stroke closes the hairlines that antialiasing leaves between neighbours. */
        const std::string style = svg.style("fill:" + colour + ";stroke:" + colour);
        shapes.push_back({camera.distance(middle), style, svg_tenths(outline, true)});
    }
}

void add_path(std::vector<Shape> &shapes, Svg &svg, const Scene &scene, const Camera &camera)
{
    for (std::size_t i = 0; i < PATH_STEPS; ++i) {
        const Vec3 a = vector_at(scene.path, i), b = vector_at(scene.path, i + 1);
        Colour colour = gradient(std::round(48 * (static_cast<double>(i) + 0.5) / PATH_STEPS) / 48);
        colour.lightness -= 0.14;
        const std::string style =
            svg.style("fill:none;stroke:" + hex(colour) + ";stroke-width:45;stroke-linecap:round");
        shapes.push_back(
            {camera.distance(0.5 * (a + b)), style, svg_tenths({camera.project(a), camera.project(b)}, false)});
    }
}

/* The polygon of the control poses' origins, dotted. */
void add_control_polygon(std::vector<Shape> &shapes, Svg &svg, const Scene &scene, const Camera &camera)
{
    const std::string style = svg.style("fill:none;stroke:#77809a;stroke-width:22;stroke-linecap:round");
    const double gap = scene.box.longest_side() / 110;
    for (std::size_t i = 0; i + 1 < scene.control_frames.size(); ++i) {
        const Vec3 a = scene.control_frames[i][0], b = scene.control_frames[i + 1][0];
        const int dots = static_cast<int>(std::min(length(b - a) / gap, 1000.0));
        for (int k = 1; k < dots; ++k) {
            const Vec3 dot = a + (static_cast<double>(k) / dots) * (b - a);
            const Point2 at = camera.project(dot);
            shapes.push_back({camera.distance(dot), style, svg_tenths({at, at}, false)});
        }
    }
}

void draw_shapes(Svg &svg, std::vector<Shape> &shapes)
{
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const Shape &a, const Shape &b) { return a.distance > b.distance; });
    svg.add("<g transform=\"scale(.1)\" stroke-width=\"7\" stroke-linejoin=\"round\">");
    for (std::size_t i = 0; i < shapes.size();) {
        std::string path;
        const std::string &style = shapes[i].style;
        for (; i < shapes.size() && shapes[i].style == style; ++i)
            path += shapes[i].path;
        svg.add("<path class=\"" + style + "\" d=\"" + path + "\"/>");
    }
    svg.add("</g>");
}

/* ---------------------------------------------------------------------------------- control poses and caption --- */

/* The blossom's name of control i, S of the knots that it belongs to; where there are none to show, its number. */
std::string control_name(const Motion &motion, std::size_t i)
{
    const bool has_blossom = motion.kind == MW_MOTION_ADDITIVE || motion.kind == MW_MOTION_MULTIPLICATIVE;
    if (!has_blossom || motion.knots.empty() || motion.closed || motion.degree > 4)
        return "S" + std::to_string(i);
    std::string name = "S(";
    for (unsigned k = 0; k < motion.degree; ++k)
        name += (k ? ", " : "") + brief(motion.knots[i + k]);
    return name + ")";
}

void draw_controls(Svg &svg, const Scene &scene, const Motion &motion, const Camera &camera)
{
    const char *const colours[] = {"#d6455d", "#2f9e62", "#3565d6"};
    for (std::size_t i = 0; i < scene.control_frames.size(); ++i) {
        const auto &frame = scene.control_frames[i];
        const Point2 origin = camera.project(frame[0]);
        for (const char *pass : {"halo", "axis"})
            for (std::size_t k = 0; k < 3; ++k) {
                const Point2 tip = camera.project(frame[k + 1]);
                const bool halo = pass[0] == 'h';
                svg.line(origin, tip,
                         std::string("fill:none;stroke-linecap:round;stroke:") + (halo ? "#fff" : colours[k]) +
                             ";stroke-width:" + (halo ? "8" : "4"));
            }
        svg.text({origin.x + 14, origin.y + 26},
                 "font-size:17px;fill:#38405a;font-style:italic;paint-order:stroke;stroke:#fff;stroke-width:4px;"
                 "stroke-linejoin:round",
                 control_name(motion, i));
    }
}

void draw_caption(Svg &svg, const Scene &scene, const Mesh &mesh, const Motion &motion)
{
    std::string what = description(motion);
    what[0] = static_cast<char>(std::toupper(what[0]));
    svg.text({60, 74}, "font-size:30px;font-weight:600;fill:#1f2540", motion.name.empty() ? what : motion.name);
    svg.text({60, 106}, "font-size:19px;fill:#5b6479",
             (motion.name.empty() ? "" : what + " · ") + counted(mesh.vertex_count(), "vertex") + " at " +
                 counted(scene.figures.size(), "pose") + (scene.simplified ? ", simplified for the picture" : ""));
    constexpr double LEFT = WIDTH - 360, RIGHT = WIDTH - 60, TOP = HEIGHT - 62;
    std::string stops;
    for (int k = 0; k <= 12; ++k)
        stops += "<stop offset=\"" + brief(k / 12.0) + "\" stop-color=\"" + hex(gradient(k / 12.0)) + "\"/>";
    svg.add("<linearGradient id=\"parameter\">" + stops + "</linearGradient>\n<rect x=\"" + svg_number(LEFT) +
            "\" y=\"" + svg_number(TOP) + "\" width=\"" + svg_number(RIGHT - LEFT) +
            "\" height=\"10\" rx=\"5\" fill=\"url(#parameter)\"/>");
    for (const Figure &figure : scene.figures)
        svg.add("<circle cx=\"" + svg_number(LEFT + 5 + figure.share * (RIGHT - LEFT - 10)) + "\" cy=\"" +
                svg_number(TOP + 5) + "\" r=\"3\" fill=\"#fff\"/>");
    const std::string style = "font-size:17px;fill:#5b6479;text-anchor:";
    svg.text({LEFT, TOP + 32}, style + "start", "t = " + brief(motion.start()));
    svg.text({RIGHT, TOP + 32}, style + "end", "t = " + brief(motion.end()));
}

void draw_background(Svg &svg)
{
    svg.add("<linearGradient id=\"air\" x2=\"0\" y2=\"1\"><stop stop-color=\"#fdfdfe\"/>"
            "<stop offset=\"1\" stop-color=\"#e9edf4\"/></linearGradient>\n<rect width=\"" +
            svg_number(WIDTH) + "\" height=\"" + svg_number(HEIGHT) + "\" fill=\"url(#air)\"/>");
}

} // namespace

std::string draw_picture(const Mesh &mesh, const Motion &motion, std::size_t pose_count, const std::string &path)
{
    const Scene scene = make_scene(mesh, motion, pose_count, path);
    const Camera camera = make_camera(scene);
    Svg svg(WIDTH, HEIGHT, motion.name.empty() ? "A motion" : motion.name);
    draw_background(svg);
    draw_ground(svg, scene, camera);
    draw_shadows(svg, scene, camera);
    std::vector<Shape> shapes;
    for (const Figure &figure : scene.figures)
        add_figure(shapes, svg, scene, figure, camera);
    add_path(shapes, svg, scene, camera);
    add_control_polygon(shapes, svg, scene, camera);
    draw_shapes(svg, shapes);
    draw_controls(svg, scene, motion, camera);
    draw_caption(svg, scene, mesh, motion);
    return svg.finish();
}

} // namespace motorway::tool
