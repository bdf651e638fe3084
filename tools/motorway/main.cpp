/* The command line of `motorway`. */
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include "command_line.h"
#include "compare_command.h"
#include "error.h"
#include "figures_command.h"
#include "info_command.h"
#include "motorway_views.h"
#include "pose_command.h"
#include "sample_command.h"

using namespace motorway::tool;

namespace {

constexpr int BAD_INPUT = 2;

const char *const EXAMPLES = R"(Examples:
  motorway pose bunny.ply --motion hunt-figure-5.json --frames 120 --out bunny.glb --picture bunny.svg
  motorway pose part.obj --motion motion.json --frames 60 --out frames/part.obj
  motorway sample motion.json --count 100 --velocity -o motion.csv
  motorway compare hunt-figure-5.json --against multiplicative --mesh bunny.ply
  motorway figures --out figures
  motorway info

MOTORWAY_ISA=scalar|sse2|avx2|avx512|neon64 chooses the instruction set; the default is the widest that runs here.
A mistake in the input ends with one line on the standard error, exit code 2, and nothing written.)";

void add_pose_command(CLI::App &app, PoseOptions &options)
{
    CLI::App *pose =
        app.add_subcommand("pose", "Move a mesh or cloud of points along a motion, into an animation or numbered files");
    pose->add_option("MESH", options.mesh, "the mesh or cloud of points, .obj or .ply (docs/mesh-files.md)")
        ->required();
    pose->add_option("--motion", options.motion, "the motion, a .json file (docs/motion-format.md)")
        ->required()
        ->type_name("FILE");
    pose->add_option("--frames", options.frames, "how many poses, spread evenly over the motion")
        ->required()
        ->check(whole_number())
        ->type_name("N");
    pose->add_option("--out", options.out,
                     ".glb: one animated file; .obj or .ply: a file a frame, frame.obj becoming frame-0000.obj ...")
        ->required()
        ->type_name("PATH");
    pose->add_option("--picture", options.picture, "also draw the mesh along its path, as .svg")->type_name("FILE");
    pose->add_option("--picture-poses", options.picture_poses, "how many poses the picture shows; 9 if not given")
        ->check(whole_number())
        ->type_name("N");
    pose->add_option(
            "--scale", options.scale,
            "multiply the mesh by this first; if not given, it gets the mesh_size of the motion file, if any")
        ->check(number())
        ->type_name("X");
    pose->add_option("--fps", options.frames_per_second, "frames a second of a .glb; 30 if not given")
        ->check(number())
        ->type_name("X");
    pose->callback([&options] { run_pose(options); });
}

void add_sample_command(CLI::App &app, SampleOptions &options)
{
    CLI::App *sample =
        app.add_subcommand("sample", "Write the poses of a motion as numbers: motors, quaternions, translations");
    sample->add_option("MOTION", options.motion, "the motion, a .json file (docs/motion-format.md)")->required();
    sample->add_option("--count", options.count, "how many samples, from the first parameter to the last")
        ->required()
        ->check(whole_number())
        ->type_name("N");
    CLI::Option *velocity = sample->add_flag(
        "--velocity", options.velocity,
        "also the angular velocity, and the velocity of the origin of the body, a unit of the parameter");
    sample
        ->add_option("--frame", options.frame,
                     "the coordinates of velocities: of the space (if not given) or the body")
        ->needs(velocity)
        ->check(one_of({"space", "body"}))
        ->type_name("FRAME");
    sample
        ->add_option("--even", options.even,
                     "samples equally far apart along the way of this point of the body, not in the parameter")
        ->type_name("X,Y,Z");
    sample->add_option("--format", options.format, "if not given: json if FILE ends so, else csv")
        ->check(one_of({"csv", "json"}))
        ->type_name("FORMAT");
    sample->add_option("-o,--out", options.out, "where to write; if not given, the standard output")
        ->type_name("FILE");
    sample->callback([&options] { run_sample(options); });
}

void add_compare_command(CLI::App &app, CompareOptions &options)
{
    CLI::App *compare = app.add_subcommand("compare", "Find how far apart two motions carry a mesh at the most");
    compare->add_option("FIRST", options.first, "a motion, a .json file (docs/motion-format.md)")->required();
    compare->add_option("SECOND", options.second, "another motion; or give --against");
    compare
        ->add_option("--against", options.against,
                     "in place of SECOND: the controls, or keys, of FIRST under another scheme")
        ->check(one_of({"additive", "multiplicative", "cumulative", "generator", "generator_keys"}))
        ->type_name("SCHEME");
    compare->add_option("--mesh", options.mesh, "the mesh, .obj or .ply")->required()->type_name("FILE");
    compare->add_option("--samples", options.samples, "how many poses of each to compare; 1001 if not given")
        ->check(whole_number())
        ->type_name("N");
    compare
        ->add_option("--scale", options.scale,
                     "multiply the mesh by this first; if not given, it gets the mesh_size of FIRST, if any")
        ->check(number())
        ->type_name("X");
    compare->callback([&options] { run_compare(options); });
}

void add_figures_command(CLI::App &app, FiguresOptions &options)
{
    CLI::App *figures =
        app.add_subcommand("figures", "Draw the figures of the papers, and all schemes side by side, as .svg");
    figures->add_option("--out", options.out, "the directory to write them to")->required()->type_name("DIR");
    figures->callback([&options] { run_figures(options); });
}

int run(int argc, char **argv)
{
    CLI::App app("Motors in every lane: rigid motions of meshes by conformal geometric algebra.", "motorway");
    PoseOptions pose;
    SampleOptions sample;
    CompareOptions compare;
    FiguresOptions figures;
    app.set_version_flag("--version", "motorway " + std::to_string(MW_VERSION_MAJOR) + "." +
                                          std::to_string(MW_VERSION_MINOR) + "." + std::to_string(MW_VERSION_PATCH));
    app.require_subcommand(1);
    app.footer(EXAMPLES);
    add_pose_command(app, pose);
    add_sample_command(app, sample);
    add_compare_command(app, compare);
    add_figures_command(app, figures);
    app.add_subcommand("info", "Show the CPU, its instruction sets and the kernels")->callback(run_info);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &problem) {
        if (problem.get_exit_code() == 0)
            return app.exit(problem);
        std::fprintf(stderr, "motorway: error: %s\n", describe_mistake(app, problem).c_str());
        return BAD_INPUT;
    }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const Error &problem) {
        std::fprintf(stderr, "motorway: error: %s\n", problem.what());
    } catch (const std::bad_alloc &) {
        std::fprintf(stderr, "motorway: error: out of memory; use a smaller mesh or fewer frames or samples\n");
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "motorway: error: %s\n", problem.what());
    }
    return BAD_INPUT;
}
