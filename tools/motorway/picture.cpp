#include "picture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "camera.h"
#include "colour.h"
#include "picture_scene.h"
#include "summary.h"
#include "svg.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr double WIDTH = 1600, HEIGHT = 940;
constexpr Rectangle FRAME = {120, 130, WIDTH - 120, HEIGHT - 150};
constexpr double ELEVATION = 18;

/* Something that hides what is farther away. */
struct Shape {
    double distance; /* from the eye */
    std::string style, path;
};

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
    const auto lines = [](double first, double last) { return std::min(last - first, 100.0); };
    for (double i = 0; i <= lines(left, right); ++i)
        svg.line(camera.project({(left + i) * step, b.low.y, back * step}),
                 camera.project({(left + i) * step, b.low.y, front * step}), style);
    for (double i = 0; i <= lines(back, front); ++i)
        svg.line(camera.project({left * step, b.low.y, (back + i) * step}),
                 camera.project({right * step, b.low.y, (back + i) * step}), style);
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

/* The points of a cloud, and the lines of a mesh. */
void add_points_and_lines(std::vector<Shape> &shapes, Svg &svg, const Scene &scene, const Figure &figure,
                          const Camera &camera)
{
    const std::string ink = "fill:none;stroke-linecap:round;stroke:" + hex(gradient(figure.share));
    const std::string dot = svg.style(ink + ";stroke-width:24"), stroke = svg.style(ink + ";stroke-width:14");
    for (std::uint32_t vertex : scene.points) {
        const Vec3 p = vector_at(figure.pose.positions, vertex);
        const Point2 at = camera.project(p);
        shapes.push_back({camera.distance(p), dot, svg_tenths({at, at}, false)});
    }
    for (const Edge &line : scene.lines) {
        const Vec3 a = vector_at(figure.pose.positions, line.first), b = vector_at(figure.pose.positions, line.second);
        shapes.push_back({camera.distance(0.5 * (a + b)), stroke,
                          svg_tenths({camera.project(a), camera.project(b)}, false)});
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
    for (const Figure &figure : scene.figures) {
        add_figure(shapes, svg, scene, figure, camera);
        add_points_and_lines(shapes, svg, scene, figure, camera);
    }
    add_path(shapes, svg, scene, camera);
    add_control_polygon(shapes, svg, scene, camera);
    draw_shapes(svg, shapes);
    draw_controls(svg, scene, motion, camera);
    draw_caption(svg, scene, mesh, motion);
    return svg.finish();
}

} // namespace motorway::tool
