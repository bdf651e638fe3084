#include "figure_hunt.h"

#include "figure_drawing.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr Vec3 X = {1, 0, 0}, Y = {0, 1, 0}, Z = {0, 0, 1};
constexpr std::size_t STEPS = 161;

} // namespace

/* -------------------------------------------------------------------------------------------------- figure 1 --- */

std::string draw_hunt_figure_1()
{
    /* The paper's text has 2π/3; its coefficients turn by -2π/3 (docs/errata.md). */
    const Poses controls = {product(rotation(Z, PI / 3), translation({8, 0, 0})),
                            product(rotation(X, -2 * PI / 3), translation({0, 6, 0}))};
    const CompiledMotion motion(MW_MOTION_ADDITIVE, 1, controls);
    constexpr double UNIT = 1.2;
    const Path path = motion.path(STEPS);
    const Poses poses = motion.poses(9);
    Path content = plate_corners(poses, UNIT);
    append(content, path);
    append(content, {{0, 0, 0}, {2.5, 0, 0}, {0, 2.5, 0}, {0, 0, 2.5}});
    const Path floor = floor_under(content, 2);
    append(content, floor);

    Svg svg = page(540, "A linear additive motion between two poses",
                   "S(t) = (1-t) S0 + t S1 at nine equal steps of t. The curve is the path of the origin, a "
                   "corner of the plate, with its shadow on squares of 2 units. Hunt et al., figure 1.");
    const View view(-125, 30, content, {40, 100, 860, 500});
    Drawing drawing(svg, view);
    drawing.floor(floor, 2);
    drawing.shadow(path, floor);
    drawing.axes(2.5);
    drawing.coloured_line(path, 3);
    drawing.plates(poses, UNIT);
    drawing.finish();
    draw_parameter_key(svg, {660, 525}, 150, "t = 0", "t = 1");
    return svg.finish();
}

/* -------------------------------------------------------------------------------------------------- figure 2 --- */

namespace {

constexpr double CYLINDER_RADIUS = 10, CYLINDER_LOW = 0, CYLINDER_HIGH = 24;

/* Half of the wall, from one angle to another. */
Path wall(double from, double to)
{
    Path outline;
    for (double angle : spread(from, to, 61))
        outline.push_back({CYLINDER_RADIUS * std::cos(angle), CYLINDER_RADIUS * std::sin(angle), CYLINDER_LOW});
    for (double angle : spread(to, from, 61))
        outline.push_back({CYLINDER_RADIUS * std::cos(angle), CYLINDER_RADIUS * std::sin(angle), CYLINDER_HIGH});
    return outline;
}

/* Layers: the far wall, lines on it, the near wall, lines on that. A path is cut where it goes round the edge. */
void draw_on_cylinder(Drawing &drawing, const Path &path, const std::string &style, const View &view)
{
    const auto layer = [&](Vec3 p) { return p.x * view.towards_eye().x + p.y * view.towards_eye().y > 0 ? 3 : 1; };
    Path piece;
    for (const Vec3 &p : path) {
        piece.push_back(p);
        if (layer(p) != layer(piece.front()) || &p == &path.back()) {
            drawing.line(piece, style, layer(piece.front()));
            piece = {p};
        }
    }
}

void draw_cylinder(Drawing &drawing, double azimuth)
{
    const std::string style = stroke("#9aa4b8", 1) + ";fill-opacity:.55;fill:";
    drawing.face(wall(azimuth + PI / 2, azimuth + 3 * PI / 2), style + "#e9edf4", 0);
    drawing.face(wall(azimuth - PI / 2, azimuth + PI / 2), style + "#f6f8fb", 2);
}

struct Figure2 {
    Path planar, ellipse, helix;
};

const std::string DOTTED = "stroke-dasharray:.1 6";

void draw_figure_2_view(Svg &svg, const Figure2 &figure, double azimuth, double elevation, const Rectangle &frame)
{
    const View view(azimuth, elevation, wall(0, 2 * PI), frame);
    Drawing drawing(svg, view);
    draw_cylinder(drawing, azimuth * PI / 180);
    draw_on_cylinder(drawing, figure.ellipse, stroke(BLUE, 1), view);
    draw_on_cylinder(drawing, figure.helix, stroke(ORANGE, 3.5, DOTTED), view);
    draw_on_cylinder(drawing, figure.planar, stroke(BLUE, 3.5), view);
    for (const Path *path : {&figure.helix, &figure.planar})
        for (std::size_t quarter = 0; quarter <= 4; ++quarter)
            drawing.dot((*path)[quarter * (STEPS - 1) / 4], path == &figure.planar ? BLUE : ORANGE, 9, 4);
    drawing.finish();
}

} // namespace

std::string draw_hunt_figure_2()
{
    const double alpha = 5 * PI / 6;
    const Poses controls = {
        translation({10, 0, 2}),
        product(rotation(Z, alpha), translation({10 * std::cos(alpha), 10 * std::sin(alpha), 22})),
    };
    const CompiledMotion additive(MW_MOTION_ADDITIVE, 1, controls);
    const CompiledMotion multiplicative(MW_MOTION_MULTIPLICATIVE, 1, controls);
    std::vector<std::vector<double>> all_parameters; /* 1 - t and t, but for a common factor */
    for (double angle : spread(0, PI, STEPS))
        all_parameters.push_back({std::cos(angle), std::sin(angle)});
    const Figure2 figure = {additive.path(STEPS), images(blends(controls, all_parameters), {0, 0, 0}),
                            multiplicative.path(STEPS)};

    Svg svg = page(555, "The planar path of a linear additive motion, and the true helix",
                   "Both stay on the cylinder of the screw between the poses (lemma 4.1). Dots: t = 0, ¼, ½, ¾, 1. "
                   "Thin line: the ellipse of all t. Right: along its plane. At the same t the two are at most " +
                       brief(additive.distance(multiplicative, {{0, 0, 0}})) + " apart. Hunt et al., figure 2.");
    draw_figure_2_view(svg, figure, 50, 24, {40, 100, 430, 500});
    draw_figure_2_view(svg, figure, 75, 0, {500, 125, 860, 475});
    draw_line_key(svg, {190, 535}, stroke(BLUE, 3.5), "additive: part of an ellipse");
    draw_line_key(svg, {480, 535}, stroke(ORANGE, 3.5, DOTTED), "multiplicative: part of a helix");
    return svg.finish();
}

/* -------------------------------------------------------------------------------------------------- figure 3 --- */

namespace {

constexpr Vec3 SPHERE_CENTRE = {-1, 0, 0}; /* of radius 1 */

/* The quadratic Bernstein functions at t = tan(angle), times cos² of the angle: so t passes through all real numbers
 * and infinity, and the sum is the same motor but for its length. */
std::vector<std::vector<double>> bernstein_at_tangents(double first, double last, std::size_t count)
{
    std::vector<std::vector<double>> weights;
    for (double angle : spread(first, last, count)) {
        const double t = std::sin(angle), rest = std::cos(angle) - t;
        weights.push_back({rest * rest, 2 * rest * t, t * t});
    }
    return weights;
}

/* Circles of latitude and longitude, and the outline. */
std::vector<Path> sphere_lines()
{
    std::vector<Path> lines;
    const auto point = [](double longitude, double latitude) {
        return SPHERE_CENTRE + Vec3{std::cos(latitude) * std::cos(longitude),
                                    std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
    };
    for (int k = 0; k < 6; ++k) {
        lines.emplace_back();
        for (double angle : spread(0, 2 * PI, 73))
            lines.back().push_back(point(k * PI / 6, angle));
    }
    for (int k = -2; k <= 2; ++k) {
        lines.emplace_back();
        for (double angle : spread(0, 2 * PI, 73))
            lines.back().push_back(point(angle, k * PI / 6));
    }
    return lines;
}

bool is_in_front(Vec3 point, const View &view)
{
    return dot(point - SPHERE_CENTRE, view.towards_eye()) > 0;
}

void draw_sphere(Drawing &drawing, const View &view)
{
    for (const Path &line : sphere_lines())
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            drawing.line({line[i], line[i + 1]}, stroke("#d5dbe6", 1), is_in_front(line[i], view) ? 3 : 1);
    Path outline;
    for (double angle : spread(0, 2 * PI, 121))
        outline.push_back(SPHERE_CENTRE + std::cos(angle) * view.right() + std::sin(angle) * view.up());
    drawing.face(outline, stroke("#9aa4b8", 1) + ";fill:#f3f5f9;fill-opacity:.75", 2);
}

} // namespace

std::string draw_hunt_figure_3()
{
    const Poses controls = {
        {1, 0, 0, 0, 0, 0, 0, 0}, {1, 0.5, 0.5, 0, 0, 0.5, 0.5, 0}, {1, 1, 1, 1, 0, 1, 1, 0}};
    constexpr double UNIT = 0.22;
    const Path path = images(blends(controls, bernstein_at_tangents(-PI / 2, PI / 2, 193)), {0, 0, 0});
    const Poses poses = blends(controls, bernstein_at_tangents(-PI / 2, PI / 2, 25));
    const CompiledMotion motion(MW_MOTION_ADDITIVE, 2, controls);

    Svg svg = page(600, "A quadratic additive motion along Viviani's curve",
                   "t passes through all real numbers, in equal steps of its arc tangent. The thick part, from t = "
                   "0 to t = 1, is the Bézier motion of the control poses. The origin stays on the sphere. Hunt et "
                   "al., figure 3.");
    const View view(-30, 12, {SPHERE_CENTRE + Z, SPHERE_CENTRE - 1 * Z}, {150, 160, 750, 540});
    Drawing drawing(svg, view);
    draw_sphere(drawing, view);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(path.size() - 1);
        drawing.coloured_line({path[i], path[i + 1]}, 2, share, share, is_in_front(path[i], view) ? 4 : 1);
    }
    drawing.coloured_line(motion.path(65), 5, 0.5, 0.75, 4);
    for (std::size_t i = 1; i < poses.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(poses.size() - 1);
        const Vec3 place = images(poses[i], {{0, 0, 0}}).front();
        drawing.plate(poses[i], UNIT, share, false, is_in_front(place, view) ? 4 : 1);
    }
    drawing.finish();
    const Point2 start = view.project({0, 0, 0}), pole = view.project(SPHERE_CENTRE + Z);
    svg.line({start.x + 4, start.y + 1}, {start.x + 112, start.y + 21}, stroke(INK, 1));
    svg.text({start.x + 116, start.y + 26}, label_font(14, INK), "t = 0 and ±∞");
    svg.text({pole.x - 4, pole.y + 24}, label_font(14, INK, "middle"), "t = 1");
    draw_parameter_key(svg, {660, 585}, 150, "t = -∞", "t = ∞");
    return svg.finish();
}

/* -------------------------------------------------------------------------------------------------- figure 4 --- */

namespace {

/* A flat letter F, the body that moves in the plane. */
Path letter(const mw_motor_f64 &pose)
{
    return images(pose, {{0, 0, 0}, {0.24, 0, 0}, {0.24, 0.48, 0}, {0.6, 0.48, 0}, {0.6, 0.7, 0}, {0.24, 0.7, 0},
                         {0.24, 0.9, 0}, {0.72, 0.9, 0}, {0.72, 1.12, 0}, {0, 1.12, 0}});
}

void draw_letter(Drawing &drawing, const mw_motor_f64 &pose, double share, bool bold, int layer)
{
    Colour fill = gradient(share), edge = fill;
    fill.lightness = 0.93;
    fill.chroma *= 0.45;
    edge.lightness -= 0.15;
    drawing.face(letter(pose), stroke(bold ? INK : hex(edge), bold ? 2.4 : 1) + ";fill:" + hex(fill), layer);
}

/* Both combinations of two neighbours in de Casteljau's tableau. */
Poses next_column(const Poses &column, double t)
{
    Poses next;
    for (std::size_t k = 0; k + 1 < column.size(); ++k)
        next.push_back(blends({column[k], column[k + 1]}, {{1 - t, t}}).front());
    return next;
}

/* The name of a pose of the tableau, where it is written beside the pose, and how it is anchored. */
struct Blossom {
    const char *name;
    Point2 offset;
    const char *anchor;
};
const std::vector<std::vector<Blossom>> BLOSSOMS = {
    {{"S(0,0,0)", {0, 20}, "middle"}, {"S(0,0,1)", {-8, -6}, "end"}, {"S(0,1,1)", {12, -14}, "start"},
     {"S(1,1,1)", {-10, 14}, "end"}},
    {{"S(0,0,t)", {-10, 4}, "end"}, {"S(0,t,1)", {2, -52}, "middle"}, {"S(t,1,1)", {12, -8}, "start"}},
    {{"S(0,t,t)", {-10, -2}, "end"}, {"S(t,t,1)", {-10, 44}, "middle"}},
    {{"S(t,t,t)", {8, 24}, "start"}},
};

void write_names(Svg &svg, const View &view, const Poses &poses, const std::vector<Blossom> &blossoms,
                 const std::string &colour)
{
    const Path places = images(poses, {0, 0, 0});
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Point2 at = view.project(places[k]), by = blossoms[k].offset;
        svg.text({at.x + by.x, at.y + by.y}, label_font(13, colour, blossoms[k].anchor) + ";font-style:italic",
                 blossoms[k].name);
    }
}

void draw_motion_in_plane(Svg &svg, const View &view, const Poses &controls)
{
    const CompiledMotion motion(MW_MOTION_ADDITIVE, 3, controls);
    const Poses poses = motion.poses(11);
    Drawing drawing(svg, view);
    for (std::size_t i = 1; i + 1 < poses.size(); ++i)
        draw_letter(drawing, poses[i], 0.1 * static_cast<double>(i), false, 0);
    for (std::size_t k = 0; k < controls.size(); ++k)
        draw_letter(drawing, controls[k], static_cast<double>(k) / 3, true, 1);
    drawing.coloured_line(motion.path(STEPS), 3, 0, 1, 2);
    drawing.finish();
    write_names(svg, view, controls, BLOSSOMS[0], INK);
}

void draw_construction(Svg &svg, const View &view, const Poses &controls)
{
    constexpr double T = 0.4;
    const std::string colours[] = {GREY, BLUE, ORANGE, "#000"};
    std::vector<Poses> tableau = {controls};
    while (tableau.back().size() > 1)
        tableau.push_back(next_column(tableau.back(), T));
    Drawing drawing(svg, view);
    drawing.coloured_line(CompiledMotion(MW_MOTION_ADDITIVE, 3, controls).path(STEPS), 4, 0, 1, 0);
    for (std::size_t r = 0; r < tableau.size(); ++r) {
        const Poses &column = tableau[r];
        for (std::size_t k = 0; k < column.size(); ++k)
            drawing.face(letter(column[k]), stroke(colours[r], r == 3 ? 2.4 : 1.2) + ";fill:#fff;fill-opacity:.7",
                         static_cast<int>(r));
        for (std::size_t k = 0; k + 1 < column.size(); ++k)
            drawing.line(CompiledMotion(MW_MOTION_ADDITIVE, 1, {column[k], column[k + 1]}).path(STEPS),
                         stroke(colours[r], 1.6), 5);
        for (Vec3 place : images(column, {0, 0, 0}))
            drawing.dot(place, colours[r], 8, 6);
    }
    drawing.finish();
    for (std::size_t r = 0; r < tableau.size(); ++r)
        write_names(svg, view, tableau[r], BLOSSOMS[r], colours[r]);
}

} // namespace

std::string draw_hunt_figure_4()
{
    const auto pose = [](double angle, Vec3 place) { return product(rotation(Z, angle), translation(place)); };
    const Poses controls = {pose(0, {1, 1, 0}), pose(-PI / 6, {2, 6, 0}), pose(-PI / 2, {5, 6, 0}),
                            pose(-PI / 2, {8, 2, 0})};
    Path content;
    for (const mw_motor_f64 &control : controls)
        append(content, letter(control));
    append(content, {{0, 0.4, 0}});

    Svg svg = page(520, "A planar cubic additive motion, and its construction at t = 0.4",
                   "Left: control poses (dark) and the motion in steps of 0.1. Right: de Casteljau's construction; "
                   "each pose is (1-t) A + t B of two before it, and the path between these is an arc of a "
                   "circle. Hunt et al., figure 4.");
    const View left(-90, 90, content, {40, 140, 340, 450}), right(-90, 90, content, {385, 140, 880, 480});
    draw_motion_in_plane(svg, left, controls);
    draw_construction(svg, right, controls);
    draw_parameter_key(svg, {120, 500}, 150, "t = 0", "t = 1");
    return svg.finish();
}

/* -------------------------------------------------------------------------------------------------- figure 5 --- */

namespace {

Poses figure_5_controls()
{
    const auto turned = [](Vec3 axis, double angle) { return product(rotation(Z, PI / 2), rotation(axis, angle)); };
    return {
        translation({1, 1, 0}),
        product(rotation(Z, PI / 6), translation({6, 1, 0})),
        product(rotation(Z, PI / 2), translation({8, 4, 2})),
        product(turned(X, PI / 4), translation({8, 6, 4})),
        product(turned(Y, PI / 3), translation({4, 6, 6})),
        product(turned(Y, PI / 2), translation({1, 6, 2})),
    };
}

} // namespace

std::string draw_hunt_figure_5()
{
    const Poses controls = figure_5_controls();
    const std::vector<double> knots = {0, 0, 1, 2, 3, 4, 4};
    const CompiledMotion motion(MW_MOTION_ADDITIVE, 2, controls, knots);
    constexpr double UNIT = 0.9;
    const Path path = motion.path(STEPS);
    const Poses poses = motion.poses(17);
    Path content = plate_corners(poses, UNIT);
    append(content, plate_corners(controls, UNIT));
    const Path floor = floor_under(content, 1);
    append(content, floor);

    Svg svg = page(600, "A quadratic additive B-spline motion",
                   "Knots 0 0 1 2 3 4 4, six control poses (dark), the motion in steps of ¼. Squares of 1 unit. "
                   "Hunt et al., figure 5.");
    const View view(-60, 24, content, {40, 80, 860, 560});
    Drawing drawing(svg, view);
    drawing.floor(floor, 1);
    drawing.shadow(path, floor);
    drawing.coloured_line(path, 3);
    drawing.plates(poses, UNIT);
    for (std::size_t k = 0; k < controls.size(); ++k)
        drawing.plate(controls[k], UNIT, std::min((0.5 * (knots[k] + knots[k + 1])) / 4, 1.0), true, 1);
    drawing.finish();
    const Path places = images(controls, {0, 0, 0});
    const Point2 offsets[] = {{0, 20}, {-10, 20}, {26, 18}, {28, 16}, {-30, 4}, {0, 20}};
    for (std::size_t k = 0; k < controls.size(); ++k) {
        const Point2 at = view.project(places[k]);
        svg.text({at.x + offsets[k].x, at.y + offsets[k].y}, label_font(13, INK, "middle") + ";font-style:italic",
                 "S(" + brief(knots[k]) + "," + brief(knots[k + 1]) + ")");
    }
    draw_parameter_key(svg, {660, 580}, 150, "t = 0", "t = 4");
    return svg.finish();
}

} // namespace motorway::tool
