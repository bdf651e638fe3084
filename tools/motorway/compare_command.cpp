#include "compare_command.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "error.h"
#include "mesh.h"
#include "motion.h"
#include "motion_file.h"
#include "progress.h"
#include "scaling.h"
#include "status.h"
#include "summary.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr long long MOST_SAMPLES = 1000000;
constexpr std::size_t STRIDE = 3 * sizeof(double);

/* Everything that can be refused before a file is read. */
void check_options(const CompareOptions &options)
{
    if (options.second.empty() == options.against.empty())
        throw Error("SECOND", "give either a second motion, or --against and a scheme for the first one");
    if (options.samples < 1 || options.samples > MOST_SAMPLES)
        throw Error("--samples", std::to_string(options.samples) + " will not do; give 1 to " +
                                     grouped(std::uint64_t{MOST_SAMPLES}));
    check_scale(options.scale);
    if (!mw_isa())
        throw Error("MOTORWAY_ISA", mw_status_text(MW_ERROR_ISA));
}

/* Some points at a time, so that there is progress to show. */
mw_motion_distance_f64 largest_distance(const Motion &first, const Motion &second, const std::vector<double> &points,
                                        std::size_t sample_count)
{
    const std::size_t count = points.size() / 3, block = std::max<std::size_t>(64, 4000000 / sample_count);
    Progress progress("comparing block", (count + block - 1) / block);
    mw_motion_distance_f64 largest = {};
    for (std::size_t begin = 0; begin < count; begin += block) {
        mw_motion_distance_f64 found;
        check(mw_compare_motions_f64(&found, first.compiled(), 0, second.compiled(), 0,
                                     points.data() + 3 * begin, STRIDE, std::min(block, count - begin), sample_count),
              "the distance between the motions");
        found.point += begin;
        if (begin == 0 || found.distance > largest.distance)
            largest = found;
        progress.step();
    }
    return largest;
}

/* (1, 2, 3): where a motion brings a point. */
std::string image(const Motion &motion, double parameter, const double *point)
{
    const mw_motor_f64 motor = sample(motion, {parameter}, "a sample")[0];
    double moved[3];
    check(mw_apply_point_one_f64(moved, STRIDE, &motor, point, STRIDE, 1, MW_DEFAULT),
          "the image of a point");
    return "(" + brief(moved[0], 6) + ", " + brief(moved[1], 6) + ", " + brief(moved[2], 6) + ")";
}

void print_distance(const mw_motion_distance_f64 &largest, double diagonal)
{
    print_line("distance", brief(largest.distance, 6) + " at most");
    if (diagonal > 0)
        print_line("", brief(largest.distance / diagonal, 6) + " of the diagonal of the bounding box of the mesh");
}

void print_place(const mw_motion_distance_f64 &largest, const Motion &first, const Motion &second,
                 const std::vector<double> &points, std::size_t vertex)
{
    const double *const point = &points[3 * largest.point];
    print_line("where", "vertex " + std::to_string(vertex) + " (counting from 0)");
    print_line("",
               "first: " + image(first, largest.parameters[0], point) + " at t = " + brief(largest.parameters[0], 6));
    print_line("", "second: " + image(second, largest.parameters[1], point) +
                       " at t = " + brief(largest.parameters[1], 6));
}

/* The number in the mesh of a vertex of its finite part. */
std::size_t finite_vertex(const Mesh &mesh, std::size_t number)
{
    std::size_t vertex = 0;
    for (;; ++vertex)
        if (mesh.has_finite_position(vertex) && number-- == 0)
            return vertex;
}

} // namespace

void run_compare(const CompareOptions &options)
{
    check_options(options);
    const Motion first = read_motion(options.first);
    const Motion second =
        options.against.empty() ? read_motion(options.second) : read_motion(options.first, options.against);
    Mesh mesh = read_mesh(options.mesh);
    const Scaling scaling = choose_scale(options.scale, first, mesh);
    scale_mesh(mesh, scaling.factor, options.mesh);
    const std::vector<double> points = finite_part(mesh).positions;
    const auto sample_count = static_cast<std::size_t>(options.samples);
    const mw_motion_distance_f64 largest = largest_distance(first, second, points, sample_count);

    print_motion("first", options.first, first);
    print_motion("second", options.against.empty() ? options.second : options.first, second);
    print_mesh(options.mesh, mesh, scaling);
    print_line("samples", grouped(static_cast<std::uint64_t>(options.samples)) +
                              ", spread evenly over the parameter of each motion");
    print_distance(largest, bounding_box(mesh).diagonal());
    if (largest.distance > 0)
        print_place(largest, first, second, points, finite_vertex(mesh, largest.point));
    print_warnings(options.mesh, mesh);
}

} // namespace motorway::tool
