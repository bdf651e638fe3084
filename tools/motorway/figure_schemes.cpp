#include "figure_schemes.h"

#include <algorithm>
#include <cstdio>

#include "figure_drawing.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr double UNIT = 0.75;

Poses four_poses()
{
    const auto pose = [](double tilt, Vec3 axis, double angle, Vec3 place) {
        return product(product(rotation({1, 0, 0}, tilt), rotation(axis, angle)), translation(place));
    };
    return {
        pose(PI / 6, {0, 0, 1}, -PI / 6, {0, 0, 0}),
        pose(PI / 2, {0, 1, 0}, -PI / 4, {2, 2, 2}),
        pose(PI / 3, {0, 1, 1}, PI / 3, {7, 2, 2}),
        pose(PI / 6, {0, 0, 1}, PI / 2, {9, 0, 0}),
    };
}

} // namespace

std::vector<Scheme> schemes_of_four_poses()
{
    const Poses poses = four_poses();
    std::vector<Scheme> schemes;
    schemes.push_back({"Additive Bézier", {MW_MOTION_ADDITIVE, 3, poses}});
    schemes.push_back({"Multiplicative Bézier", {MW_MOTION_MULTIPLICATIVE, 3, poses}});
    schemes.push_back({"Cumulative Bézier", {MW_MOTION_CUMULATIVE, 3, poses}});
    schemes.push_back({"Generator Bézier", {MW_MOTION_GENERATOR, 3, poses}});
    schemes.push_back({"Additive B-spline", {MW_MOTION_ADDITIVE, 2, poses}});
    schemes.push_back({"Additive, through keys", CompiledMotion::through(poses, {0, 1, 2, 3}, 3)});
    schemes.push_back({"Piecewise screw", {MW_MOTION_MULTIPLICATIVE, 1, poses}});
    schemes.push_back({"Generator keys", {MW_MOTION_GENERATOR_KEYS, 0, poses}});
    return schemes;
}

double plate_distance(const CompiledMotion &first, const CompiledMotion &second)
{
    return first.distance(second, plate_corners({{1, 0, 0, 0, 0, 0, 0, 0}}, UNIT));
}

/* --------------------------------------------------------------------------------------------------- motions --- */

namespace {

void draw_scheme(Svg &svg, const View &view, const Path &floor, const Scheme &scheme)
{
    const Path path = scheme.motion.path(161);
    const Poses keys = four_poses();
    Drawing drawing(svg, view);
    drawing.floor(floor, 1);
    drawing.shadow(path, floor);
    drawing.coloured_line(path, 2.5);
    drawing.plates(scheme.motion.poses(13), UNIT);
    for (std::size_t k = 0; k < keys.size(); ++k)
        drawing.plate(keys[k], UNIT, static_cast<double>(k) / 3, true, 1);
    drawing.finish();
}

} // namespace

std::string draw_schemes()
{
    constexpr double TOP = 100, WIDTH = 430, HEIGHT = 218;
    const std::vector<Scheme> schemes = schemes_of_four_poses();
    Path content;
    for (const Scheme &scheme : schemes)
        append(content, plate_corners(scheme.motion.poses(31), UNIT));
    const Path floor = floor_under(content, 1);
    append(content, floor);

    Svg svg = page(TOP + 4 * HEIGHT + 46, "The same four poses under every scheme",
                   "Dark: the four poses. Light: the motion at twelve equal steps of the parameter. Bézier: degree "
                   "3; B-spline: degree 2. Squares of 1 unit.");
    for (std::size_t i = 0; i < schemes.size(); ++i) {
        const double left = 15 + static_cast<double>(i % 2) * (WIDTH + 10);
        const double top = TOP + static_cast<double>(i / 2) * HEIGHT;
        const View view(-82, 24, content, {left, top + 20, left + WIDTH, top + HEIGHT - 14});
        draw_scheme(svg, view, floor, schemes[i]);
        svg.text({left + 10, top + 14}, label_font(15, INK) + ";font-weight:600", schemes[i].name);
    }
    draw_parameter_key(svg, {375, TOP + 4 * HEIGHT + 26}, 150, "first", "last parameter");
    return svg.finish();
}

/* ---------------------------------------------------------------------------------------------------- speeds --- */

namespace {

constexpr std::size_t STEPS = 121;

/* With two decimals. */
std::string fixed(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

/* Speeds a whole motion, so that the area under the curve is the length of the path. */
std::vector<double> speeds_of(const Scheme &scheme)
{
    std::vector<double> speeds = scheme.motion.speeds(STEPS);
    for (double &speed : speeds)
        speed *= scheme.motion.end() - scheme.motion.start();
    return speeds;
}

class Chart {
public:
    Chart(Svg &svg, const Rectangle &frame, double highest) : svg_(svg), frame_(frame), highest_(highest) {}

    Point2 at(double share, double speed) const
    {
        return {frame_.left + share * (frame_.right - frame_.left),
                frame_.bottom - speed / highest_ * (frame_.bottom - frame_.top)};
    }

    void axes(bool has_numbers) const
    {
        for (double speed = 0; speed <= highest_; speed += 10) {
            svg_.line(at(0, speed), at(1, speed), stroke(speed > 0 ? "#e3e7ee" : PALE, 1));
            if (has_numbers)
                svg_.text({frame_.left - 7, at(0, speed).y + 4}, font(12, GREY, "end"), brief(speed));
        }
        svg_.text({frame_.left, frame_.bottom + 16}, font(12, GREY), "0");
        svg_.text({frame_.right, frame_.bottom + 16}, font(12, GREY, "end"), "1");
    }

    void curve(const std::vector<double> &speeds, const std::string &style) const
    {
        std::vector<Point2> points;
        for (std::size_t i = 0; i < speeds.size(); ++i)
            points.push_back(at(static_cast<double>(i) / static_cast<double>(speeds.size() - 1), speeds[i]));
        svg_.add("<path class=\"" + svg_.style(style) + "\" d=\"" + path_data(points) + "\"/>");
    }

private:
    Svg &svg_;
    Rectangle frame_;
    double highest_;
};

} // namespace

std::string draw_speeds()
{
    constexpr double TOP = 110, LEFT = 50, WIDTH = 210, HEIGHT = 205;
    const std::vector<Scheme> schemes = schemes_of_four_poses();
    std::vector<std::vector<double>> speeds;
    double highest = 0;
    for (const Scheme &scheme : schemes) {
        speeds.push_back(speeds_of(scheme));
        highest = std::max(highest, *std::max_element(speeds.back().begin(), speeds.back().end()));
    }
    highest = 10 * std::ceil(highest / 10);
    Svg svg = page(TOP + 2 * HEIGHT + 8, "The speed of the origin along the same motions",
                   "Across: the parameter, as a part of its domain. Up: units a whole motion. Grey: the other "
                   "schemes. The area under a curve is the length of its path.");
    for (std::size_t i = 0; i < schemes.size(); ++i) {
        const double left = LEFT + static_cast<double>(i % 4) * WIDTH;
        const double top = TOP + static_cast<double>(i / 4) * HEIGHT;
        const Chart chart(svg, {left, top + 20, left + WIDTH - 30, top + HEIGHT - 45}, highest);
        chart.axes(i % 4 == 0);
        for (const std::vector<double> &others : speeds)
            chart.curve(others, stroke("#d5dbe6", 1));
        chart.curve(speeds[i], stroke(BLUE, 2.5));
        svg.text({left, top + 2}, font(13, INK) + ";font-weight:600", schemes[i].name);
        svg.text({left + WIDTH - 30, top + 18}, label_font(12, GREY, "end"),
                 "length " + fixed(schemes[i].motion.length()));
    }
    return svg.finish();
}

} // namespace motorway::tool
