#include "figures_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "error.h"
#include "figure_hunt.h"
#include "figure_schemes.h"
#include "figure_wareham.h"
#include "files.h"
#include "motorway_views.h"
#include "summary.h"

namespace fs = std::filesystem;

namespace motorway::tool {
namespace {

struct Figure {
    const char *file;
    std::string (*draw)();
};

constexpr Figure FIGURES[] = {
    {"hunt-figure-1.svg", draw_hunt_figure_1},       {"hunt-figure-2.svg", draw_hunt_figure_2},
    {"hunt-figure-3.svg", draw_hunt_figure_3},       {"hunt-figure-4.svg", draw_hunt_figure_4},
    {"hunt-figure-5.svg", draw_hunt_figure_5},       {"wareham-figure-5.svg", draw_wareham_figure_5},
    {"wareham-figure-7.svg", draw_wareham_figure_7}, {"schemes.svg", draw_schemes},
    {"speeds.svg", draw_speeds},
};

std::string path_of(const FiguresOptions &options, const Figure &figure)
{
    return (fs::path(options.out) / figure.file).string();
}

void make_directory(const FiguresOptions &options)
{
    std::error_code problem;
    fs::create_directories(options.out, problem);
    if (problem)
        throw Error("--out", "the directory cannot be made: " + problem.message() + "; give another one");
    for (const Figure &figure : FIGURES)
        OutputFiles::check(path_of(options, figure));
}

/* What the eye cannot tell of schemes.svg and speeds.svg. */
void print_schemes()
{
    const std::vector<Scheme> schemes = schemes_of_four_poses();
    std::printf("%10s %13s %15s\n%10s %13s %15s\n", "length of", "its fastest", "distance from", "the path",
                "by slowest", "the first");
    for (const Scheme &scheme : schemes) {
        const std::vector<double> speeds = scheme.motion.speeds(1001);
        const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
        std::printf("%10.3f %13.3f %15.3f   %s\n", scheme.motion.length(), *fastest / *slowest,
                    plate_distance(scheme.motion, schemes.front().motion), scheme.name.c_str());
    }
}

} // namespace

void run_figures(const FiguresOptions &options)
{
    if (!mw_isa())
        throw Error("MOTORWAY_ISA", mw_status_text(MW_ERROR_ISA));
    make_directory(options);
    OutputFiles out;
    for (const Figure &figure : FIGURES)
        out.write(path_of(options, figure), figure.draw());
    out.commit();
    print_schemes();
    print_files(out.files());
}

} // namespace motorway::tool
