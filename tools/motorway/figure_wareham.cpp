#include "figure_wareham.h"

#include "figure_drawing.h"
#include "status.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr std::size_t STEPS = 161;
constexpr double UNIT = 0.75;

void draw_through_keys(Svg &svg, const View &view, const Path &floor, const CompiledMotion &motion, const Poses &keys)
{
    const Path path = motion.path(STEPS);
    Drawing drawing(svg, view);
    drawing.floor(floor, 1);
    drawing.shadow(path, floor);
    drawing.coloured_line(path, 3);
    const Poses poses = motion.poses(9);
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (i % 4 != 0) /* no key */
            drawing.plate(poses[i], UNIT, static_cast<double>(i) / 8);
    for (std::size_t k = 0; k < keys.size(); ++k)
        drawing.plate(keys[k], UNIT, 0.5 * static_cast<double>(k), true);
    drawing.finish();
}

} // namespace

std::string draw_wareham_figure_5()
{
    const auto pose = [](Vec3 axis, double angle, Vec3 place) {
        return product(rotation(axis, angle), translation(place));
    };
    const Poses keys = {
        pose({0, 0, 1}, -PI / 6, {0, 0, 0}),
        pose({2, 1, 0}, PI / 3, {3, 3, 2.5}),
        pose({0, 0, 1}, 2 * PI / 3, {7, 1, 0}),
    };
    const CompiledMotion linear(MW_MOTION_MULTIPLICATIVE, 1, keys, {-1, 0, 1});
    const CompiledMotion quadratic(MW_MOTION_GENERATOR_KEYS, 0, keys, {-1, 0, 1});
    Path content = plate_corners(linear.poses(41), UNIT);
    append(content, plate_corners(quadratic.poses(41), UNIT));
    const Path floor = floor_under(content, 1);
    append(content, floor);

    Svg svg = page(470, "Three poses, interpolated piece by piece and by a quadratic",
                   "a) Linear interpolation of the relative motors: two screws, and an abrupt change at the middle "
                   "pose. b) The quadratic through the three generators is smooth there. Dark: the key poses. "
                   "Wareham and Lasenby, figure 5, with poses of our own.");
    draw_through_keys(svg, View(-80, 32, content, {20, 100, 440, 410}), floor, linear, keys);
    draw_through_keys(svg, View(-80, 32, content, {460, 100, 880, 410}), floor, quadratic, keys);
    svg.text({30, 120}, font(16, INK) + ";font-weight:600", "a");
    svg.text({470, 120}, font(16, INK) + ";font-weight:600", "b");
    draw_parameter_key(svg, {375, 450}, 150, "-1", "1");
    return svg.finish();
}

/* -------------------------------------------------------------------------------------------------- figure 7 --- */

namespace {

constexpr double PSI = 9 * PI;
constexpr Vec3 PARALLEL = {4, 6, 0}, PERPENDICULAR = {0, 0, -1}; /* t∥ = 4a + 6b and t⊥, with a = e1, b = e2 */

/* exp(λB) with B = ½ψ ab + ½ (t∥ + t⊥) n is the rotor as they have it, which acts as R x R~: turned into motors. */
Poses twisted_poses(const std::vector<double> &lambdas)
{
    std::vector<double> generators;
    for (double lambda : lambdas)
        for (double coefficient : {PSI, 0.0, 0.0, PARALLEL.x, PARALLEL.y, PERPENDICULAR.z})
            generators.push_back(0.5 * lambda * coefficient);
    Poses poses(lambdas.size());
    mw_motor_f64 *const rotors = poses.data();
    constexpr std::size_t SIZE = sizeof *rotors;
    check(mw_exp_motor_each_f64(rotors, SIZE, generators.data(), 6 * sizeof(double), poses.size()), "exponentials");
    check(mw_convert_rotor_to_motor_each_f64(rotors, SIZE, rotors, SIZE, poses.size(), 1), "rotors");
    return poses;
}

struct Helix {
    Path path;
    Vec3 middle; /* of its first turn */

    Vec3 end() const { return path.back(); }
    Vec3 above_start() const { return {0, 0, end().z}; }
    double radius() const { return length(Vec3{middle.x, middle.y, 0}); }
};

/* Where the arrows at the start end: a, b, and the direction of -t∥. */
const Vec3 TIPS[] = {{0.3, 0, 0}, {0, 0.3, 0}, -0.5 * unit(PARALLEL)};

Helix make_helix()
{
    constexpr std::size_t STEPS_A_TURN = 120;
    const Path path = images(twisted_poses(spread(0, 1, 9 * STEPS_A_TURN / 2 + 1)), {0, 0, 0});
    return {path, 0.5 * (path[0] + path[STEPS_A_TURN / 2])};
}

void draw_helix(Svg &svg, const View &view, const Helix &helix, const Path &axis)
{
    Drawing drawing(svg, view);
    drawing.line(axis, stroke(GREY, 1, "stroke-dasharray:6 4"));
    drawing.line({{0, 0, 0}, helix.above_start()}, stroke(PALE, 1.6));
    drawing.coloured_line(helix.path, 3.5);
    drawing.arrow({0, 0, 0}, TIPS[0], GREY, 1.2);
    drawing.arrow({0, 0, 0}, TIPS[1], GREY, 1.2);
    drawing.arrow({0, 0, 0}, TIPS[2], BLUE, 2.4, 1);
    drawing.arrow(helix.above_start(), helix.end(), ORANGE, 2.4, 1);
    drawing.dot({0, 0, 0}, INK, 9, 1);
    drawing.dot(helix.end(), INK, 9, 1);
    drawing.finish();
}

void name_parts(Svg &svg, const View &view, const Helix &helix)
{
    const auto write = [&](Vec3 place, Point2 offset, const std::string &colour, const std::string &words) {
        const Point2 at = view.project(place);
        svg.text({at.x + offset.x, at.y + offset.y}, label_font(14, colour, "middle"), words);
    };
    write(TIPS[0], {10, 5}, GREY, "a");
    write(TIPS[1], {8, -4}, GREY, "b");
    write(TIPS[2], {-22, 8}, BLUE, "-t∥");
    write(0.5 * (helix.above_start() + helix.end()), {34, 0}, ORANGE, "t'∥");
    write({0, 0, 0}, {0, 26}, INK, "λ = 0");
    write(helix.end(), {-34, 6}, INK, "λ = 1");
}

} // namespace

std::string draw_wareham_figure_7()
{
    const Helix helix = make_helix();
    const Path axis = {helix.middle - Vec3{0, 0, 0.18}, helix.middle + Vec3{0, 0, helix.end().z + 0.06}};
    const View view(-70, 20, axis, {100, 115, 800, 555});

    Svg svg = page(620, "The helix of a linear interpolation",
                   "The path of the origin under exp(λB), 0 ≤ λ ≤ 1, with t∥ = 4a + 6b, ψ = 9π, |t⊥| = 1: four and a "
                   "half turns of radius " + brief(helix.radius()) + " = |t∥| / ψ. It starts towards -t∥ and ends "
                   "t'∥ beside the point above its start. Wareham and Lasenby, figure 7.");
    draw_helix(svg, view, helix, axis);
    name_parts(svg, view, helix);
    return svg.finish();
}

} // namespace motorway::tool
