/* What figures are drawn of: a view of space with z up, paths, plates that show a pose, axes, a floor, and the page
 * around them. */
#ifndef MOTORWAY_TOOL_FIGURE_DRAWING_H
#define MOTORWAY_TOOL_FIGURE_DRAWING_H

#include <string>
#include <vector>

#include "colour.h"
#include "figure_motion.h"
#include "svg.h"

namespace motorway::tool {

/* Colours that people tell apart whatever their eyes (Okabe and Ito), and greys. */
constexpr const char *BLUE = "#0072b2", *ORANGE = "#d55e00", *INK = "#1f2540", *GREY = "#5b6479", *PALE = "#c3cad6";

/* CSS of text of this size, in the middle of its place, before or after it: anchor is start, middle or end. */
std::string font(double size, const std::string &colour, const std::string &anchor = "start");

/* The same with a white rim, to be read on top of lines. */
std::string label_font(double size, const std::string &colour, const std::string &anchor = "start");

/* CSS of a line. `more` is further declarations. */
std::string stroke(const std::string &colour, double width, const std::string &more = "");

/* The d of an SVG path: a polyline through the points, closed or not. */
std::string path_data(const std::vector<Point2> &points, bool closed = false);

constexpr double PAGE_WIDTH = 900;

/* A white page with a title and a caption below it, which is broken into lines. */
Svg page(double height, const std::string &title, const std::string &caption);

/* A bar from first to last in the colours of paths and poses. */
void draw_parameter_key(Svg &svg, Point2 at, double width, const std::string &first, const std::string &last);

/* A sample of a line, and what it means. */
void draw_line_key(Svg &svg, Point2 at, const std::string &style, const std::string &words);

/* The shape of what moves: a plate of 0.9 x 1.2 x 0.25 units with a letter F on top and a disc below; the origin is a
 * corner of it. The eight corners of all poses. */
Path plate_corners(const Poses &poses, double unit);

void append(Path &all, const Path &more);

/* The corners of a floor of squares of this size under the content, lowest and highest ones first and last. */
Path floor_under(const Path &content, double step);

/* Orthographic: all of `content`, as large as the frame takes it. At azimuth 0 the eye is on the x axis, at 90
 * degrees on the y axis. */
class View {
public:
    View(double azimuth, double elevation, const Path &content, const Rectangle &frame);

    Point2 project(Vec3 point) const;
    double nearness(Vec3 point) const { return tool::dot(point, towards_eye_); }
    Vec3 towards_eye() const { return towards_eye_; }
    Vec3 right() const { return right_; }
    Vec3 up() const { return up_; }
    double scale() const { return scale_; } /* pixels a unit */

private:
    Vec3 towards_eye_, right_, up_;
    double scale_ = 1;
    Point2 shift_ = {0, 0};
};

/* Shapes in space, drawn from back to front within each layer, and layer upon layer, by finish(). */
class Drawing {
public:
    Drawing(Svg &svg, const View &view) : svg_(svg), view_(view) {}

    void face(const Path &outline, const std::string &style, int layer = 0);
    void line(const Path &path, const std::string &style, int layer = 0);
    void dot(Vec3 point, const std::string &colour, double diameter, int layer = 0);

    /* In the colours of the parameter, from `first` to `last` of its way from 0 to 1. */
    void coloured_line(const Path &path, double width, double first = 0, double last = 1, int layer = 0);

    /* A plate in the colour of a parameter; bold ones stand for control poses. */
    void plate(const mw_motor_f64 &pose, double unit, double share, bool bold = false, int layer = 0);

    /* Plates at equal steps of the parameter. */
    void plates(const Poses &poses, double unit);

    void arrow(Vec3 from, Vec3 to, const std::string &colour, double width, int layer = 0);

    /* Three arrows from the origin, with letters. */
    void axes(double length, int layer = 0);

    /* A grid of squares of this size, and the shadow that a path casts on it. */
    void floor(const Path &floor, double step);
    void shadow(const Path &path, const Path &floor);

    void finish();

private:
    struct Shape {
        int layer;
        double nearness;
        std::string style, path;
    };
    struct Label {
        Point2 at;
        std::string words;
    };

    void add(const Path &points, bool closed, const std::string &style, int layer);

    Svg &svg_;
    View view_;
    std::vector<Shape> shapes_;
    std::vector<Label> labels_;
};

} // namespace motorway::tool

#endif
