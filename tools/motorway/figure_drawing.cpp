#include "figure_drawing.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "text.h"

namespace motorway::tool {
namespace {

constexpr double DEGREE = PI / 180;
constexpr Vec3 PLATE = {0.9, 1.2, 0.25};

/* Corner i of the plate has bit 0 for x, 1 for y, 2 for z. */
Path plate_at_rest(double unit)
{
    Path corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(unit * Vec3{i & 1 ? PLATE.x : 0, i & 2 ? PLATE.y : 0, i & 4 ? PLATE.z : 0});
    return corners;
}

/* The letter on top of it. */
Path letter_at_rest(double unit)
{
    Path letter;
    for (Point2 p : {Point2{0.22, 0.18}, {0.40, 0.18}, {0.40, 0.55}, {0.62, 0.55}, {0.62, 0.71}, {0.40, 0.71},
                     {0.40, 0.86}, {0.70, 0.86}, {0.70, 1.02}, {0.22, 1.02}})
        letter.push_back(unit * Vec3{p.x, p.y, PLATE.z});
    return letter;
}

/* And a disc below. */
Path disc_at_rest(double unit)
{
    Path disc;
    for (double angle : spread(0, 2 * PI, 25))
        disc.push_back(unit * Vec3{PLATE.x / 2 + 0.2 * std::cos(angle), PLATE.y / 2 + 0.2 * std::sin(angle), 0});
    return disc;
}

/* The corners of the sides, counter-clockwise seen from outside; the top first, then the bottom. */
constexpr std::array<std::size_t, 4> SIDES[] = {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

Colour darkened(double share)
{
    Colour colour = gradient(share);
    colour.lightness -= 0.15;
    return colour;
}

} // namespace

std::string font(double size, const std::string &colour, const std::string &anchor)
{
    return "font-size:" + svg_number(size) + "px;fill:" + colour + ";text-anchor:" + anchor;
}

std::string label_font(double size, const std::string &colour, const std::string &anchor)
{
    return font(size, colour, anchor) + ";paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round";
}

std::string stroke(const std::string &colour, double width, const std::string &more)
{
    return "fill:none;stroke-linecap:round;stroke-linejoin:round;stroke:" + colour +
           ";stroke-width:" + svg_number(width) + (more.empty() ? "" : ";" + more);
}

std::string path_data(const std::vector<Point2> &points, bool closed)
{
    std::string path;
    for (const Point2 &p : points)
        path += (path.empty() ? "M" : "L") + svg_number(p.x) + " " + svg_number(p.y);
    return closed ? path + "z" : path;
}

/* Into lines of at most so many characters. */
static std::vector<std::string> lines_of(const std::string &words, std::size_t most)
{
    std::vector<std::string> lines(1);
    std::size_t length = 0;
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
        const auto letters = static_cast<std::size_t>(std::count_if(word.begin(), word.end(), is_first_byte));
        if (length > 0 && length + 1 + letters > most) {
            lines.emplace_back();
            length = 0;
        }
        lines.back() += (length > 0 ? " " : "") + word;
        length += letters + (length > 0 ? 1 : 0);
    }
    return lines;
}

Svg page(double height, const std::string &title, const std::string &caption)
{
    Svg svg(PAGE_WIDTH, height, title);
    svg.add("<rect width=\"" + svg_number(PAGE_WIDTH) + "\" height=\"" + svg_number(height) + "\" fill=\"#fff\"/>");
    svg.text({24, 34}, font(19, INK) + ";font-weight:600", title);
    double y = 57;
    for (const std::string &line : lines_of(caption, 124)) {
        svg.text({24, y}, font(13, GREY), line);
        y += 18;
    }
    return svg;
}

void draw_parameter_key(Svg &svg, Point2 at, double width, const std::string &first, const std::string &last)
{
    std::string stops;
    for (int k = 0; k <= 12; ++k)
        stops += "<stop offset=\"" + brief(k / 12.0) + "\" stop-color=\"" + hex(gradient(k / 12.0)) + "\"/>";
    svg.add("<linearGradient id=\"parameter\">" + stops + "</linearGradient>\n<rect x=\"" + svg_number(at.x) +
            "\" y=\"" + svg_number(at.y - 9) + "\" width=\"" + svg_number(width) +
            "\" height=\"8\" rx=\"4\" fill=\"url(#parameter)\"/>");
    svg.text({at.x - 8, at.y}, font(13, GREY, "end"), first);
    svg.text({at.x + width + 8, at.y}, font(13, GREY), last);
}

void draw_line_key(Svg &svg, Point2 at, const std::string &style, const std::string &words)
{
    svg.line({at.x, at.y - 4}, {at.x + 26, at.y - 4}, style);
    svg.text({at.x + 34, at.y}, font(13, GREY), words);
}

Path plate_corners(const Poses &poses, double unit)
{
    Path corners;
    for (const mw_motor_f64 &pose : poses)
        append(corners, images(pose, plate_at_rest(unit)));
    return corners;
}

void append(Path &all, const Path &more)
{
    all.insert(all.end(), more.begin(), more.end());
}

Path floor_under(const Path &content, double step)
{
    Vec3 low = content.front(), high = content.front();
    for (Vec3 p : content) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), low.z};
    }
    low = {step * std::floor(low.x / step), step * std::floor(low.y / step), low.z};
    high = {step * std::ceil(high.x / step), step * std::ceil(high.y / step), low.z};
    return {low, {high.x, low.y, low.z}, {low.x, high.y, low.z}, high};
}

/* ------------------------------------------------------------------------------------------------------ view --- */

View::View(double azimuth, double elevation, const Path &content, const Rectangle &frame)
{
    const double a = azimuth * DEGREE, e = elevation * DEGREE;
    towards_eye_ = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    right_ = {-std::sin(a), std::cos(a), 0};
    up_ = cross(towards_eye_, right_);
    Rectangle seen = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (Vec3 p : content) {
        const Point2 q = project(p);
        seen = {std::min(seen.left, q.x), std::min(seen.top, q.y), std::max(seen.right, q.x),
                std::max(seen.bottom, q.y)};
    }
    scale_ = std::min((frame.right - frame.left) / std::max(seen.right - seen.left, 1e-30),
                      (frame.bottom - frame.top) / std::max(seen.bottom - seen.top, 1e-30));
    shift_ = {0.5 * (frame.left + frame.right - scale_ * (seen.left + seen.right)),
              0.5 * (frame.top + frame.bottom - scale_ * (seen.top + seen.bottom))};
}

Point2 View::project(Vec3 point) const
{
    return {shift_.x + scale_ * dot(point, right_), shift_.y - scale_ * dot(point, up_)};
}

/* --------------------------------------------------------------------------------------------------- drawing --- */

void Drawing::add(const Path &points, bool closed, const std::string &style, int layer)
{
    std::vector<Point2> outline;
    double nearness = 0;
    for (Vec3 p : points) {
        outline.push_back(view_.project(p));
        nearness += view_.nearness(p) / static_cast<double>(points.size());
    }
    shapes_.push_back({layer, nearness, svg_.style(style), path_data(outline, closed)});
}

void Drawing::face(const Path &outline, const std::string &style, int layer)
{
    add(outline, true, style, layer);
}

void Drawing::line(const Path &path, const std::string &style, int layer)
{
    add(path, false, style, layer);
}

void Drawing::dot(Vec3 point, const std::string &colour, double diameter, int layer)
{
    add({point, point}, false, stroke(colour, diameter), layer);
}

void Drawing::coloured_line(const Path &path, double width, double first, double last, int layer)
{
    constexpr double LEVELS = 48; /* few colours make a small file */
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(path.size() - 1);
        const double level = std::round(LEVELS * (first + share * (last - first))) / LEVELS;
        add({path[i], path[i + 1]}, false, stroke(hex(darkened(level)), width), layer);
    }
}

/* All of a plate is as near as its middle, so that plates that do not touch hide one another as they should. It is
 * convex, and only the sides that face the eye are drawn. */
void Drawing::plate(const mw_motor_f64 &pose, double unit, double share, bool bold, int layer)
{
    const Path corners = images(pose, plate_at_rest(unit));
    const Path marks[] = {images(pose, letter_at_rest(unit)), images(pose, disc_at_rest(unit))};
    const Vec3 lamp = tool::unit(-0.5 * view_.right() + view_.up() + 0.8 * view_.towards_eye());
    const double nearness = view_.nearness(0.5 * (corners.front() + corners.back()));
    const std::string edge = bold ? INK : hex(darkened(share));
    for (std::size_t side = 0; side < std::size(SIDES); ++side) {
        Path outline;
        for (std::size_t corner : SIDES[side])
            outline.push_back(corners[corner]);
        const Vec3 normal = tool::unit(cross(outline[1] - outline[0], outline[2] - outline[1]));
        if (tool::dot(normal, view_.towards_eye()) <= 0)
            continue;
        Colour fill = gradient(share);
        fill.lightness = 0.86 + 0.10 * tool::dot(normal, lamp);
        fill.chroma *= 0.45;
        face(outline, stroke(edge, bold ? 2.2 : 1) + ";fill:" + hex(fill), layer);
        shapes_.back().nearness = nearness;
        if (side < std::size(marks)) {
            face(marks[side], "stroke:none;fill:" + edge, layer);
            shapes_.back().nearness = nearness;
        }
    }
}

void Drawing::plates(const Poses &poses, double unit)
{
    for (std::size_t i = 0; i < poses.size(); ++i)
        plate(poses[i], unit, static_cast<double>(i) / static_cast<double>(poses.size() - 1));
}

void Drawing::arrow(Vec3 from, Vec3 to, const std::string &colour, double width, int layer)
{
    const Vec3 along = tool::unit(to - from), across = tool::unit(cross(along, view_.towards_eye()));
    const double head = (6 + 2 * width) / view_.scale();
    const Vec3 neck = to - head * along;
    line({from, neck}, stroke(colour, width), layer);
    face({to, neck + 0.4 * head * across, neck - 0.4 * head * across}, "stroke:none;fill:" + colour, layer);
}

void Drawing::axes(double length, int layer)
{
    const Vec3 tips[] = {{length, 0, 0}, {0, length, 0}, {0, 0, length}};
    const char *const names[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) {
        arrow({0, 0, 0}, tips[k], GREY, 1.2, layer);
        const Vec3 beyond = (1 + 11 / (length * view_.scale())) * tips[k];
        labels_.push_back({view_.project(beyond), names[k]});
    }
}

void Drawing::floor(const Path &floor, double step)
{
    const Vec3 low = floor.front(), high = floor.back();
    for (double x = low.x; x <= high.x; x += step)
        line({{x, low.y, low.z}, {x, high.y, low.z}}, stroke("#e3e7ee", 1), -2);
    for (double y = low.y; y <= high.y; y += step)
        line({{low.x, y, low.z}, {high.x, y, low.z}}, stroke("#e3e7ee", 1), -2);
}

void Drawing::shadow(const Path &path, const Path &floor)
{
    Path below = path;
    for (Vec3 &p : below)
        p.z = floor.front().z;
    line(below, stroke(PALE, 1.6), -1);
}

void Drawing::finish()
{
    std::stable_sort(shapes_.begin(), shapes_.end(), [](const Shape &a, const Shape &b) {
        return a.layer != b.layer ? a.layer < b.layer : a.nearness < b.nearness;
    });
    for (std::size_t i = 0; i < shapes_.size();) {
        std::string path;
        const std::string &style = shapes_[i].style;
        const bool merges = shapes_[i].path.back() != 'z'; /* faces that overlap are not one shape */
        do
            path += shapes_[i++].path;
        while (merges && i < shapes_.size() && shapes_[i].style == style && shapes_[i].path.back() != 'z');
        svg_.add("<path class=\"" + style + "\" d=\"" + path + "\"/>");
    }
    for (const Label &label : labels_)
        svg_.text({label.at.x, label.at.y + 4}, label_font(13, GREY, "middle") + ";font-style:italic", label.words);
}

} // namespace motorway::tool
