/* The command line of `motorway`. */
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include "error.h"
#include "info_command.h"
#include "motorway.h"
#include "pose_command.h"

using namespace motorway::tool;

namespace {

constexpr int BAD_INPUT = 2;

const char *const EXAMPLES = R"(Examples:
  motorway pose bunny.ply --motion hunt-figure-5.json --frames 120 --out bunny.glb --picture bunny.svg
  motorway pose part.obj --motion motion.json --frames 60 --out frames/part.obj
  motorway info

MOTORWAY_ISA=scalar|sse2|avx2|avx512|neon64 chooses the instruction set; the default is the widest that runs here.
A mistake in the input ends with one line on the standard error, exit code 2, and nothing written.)";

void add_pose_command(CLI::App &app, PoseOptions &options)
{
    CLI::App *pose = app.add_subcommand("pose", "Move a mesh along a motion, into an animation or numbered files");
    pose->add_option("MESH", options.mesh, "the mesh, .obj or .ply (ascii or binary)")->required();
    pose->add_option("--motion", options.motion, "the motion, a .json file (docs/motion-format.md)")
        ->required()
        ->type_name("FILE");
    pose->add_option("--frames", options.frames, "how many poses, spread evenly over the motion")
        ->required()
        ->type_name("N");
    pose->add_option("--out", options.out,
                     ".glb: one animated file; .obj or .ply: a file a frame, frame.obj becoming frame-0000.obj ...")
        ->required()
        ->type_name("PATH");
    pose->add_option("--picture", options.picture, "also draw the mesh along its path, as .svg")->type_name("FILE");
    pose->add_option("--picture-poses", options.picture_poses, "how many poses the picture shows; 9 if not given")
        ->type_name("N");
    pose->add_option(
            "--scale", options.scale,
            "multiply the mesh by this first; if not given, it gets the mesh_size of the motion file, if any")
        ->type_name("X");
    pose->add_option("--fps", options.frames_per_second, "frames a second of a .glb; 30 if not given")
        ->type_name("X");
    pose->callback([&options] { run_pose(options); });
}

int run(int argc, char **argv)
{
    CLI::App app("Motors in every lane: rigid motions of meshes by conformal geometric algebra.", "motorway");
    PoseOptions options;
    app.set_version_flag("--version", "motorway " + std::to_string(MW_VERSION_MAJOR) + "." +
                                          std::to_string(MW_VERSION_MINOR) + "." + std::to_string(MW_VERSION_PATCH));
    app.require_subcommand(1);
    app.footer(EXAMPLES);
    add_pose_command(app, options);
    app.add_subcommand("info", "Show the CPU, its instruction sets and the kernels")->callback(run_info);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &problem) {
        if (problem.get_exit_code() == 0)
            return app.exit(problem);
        std::fprintf(stderr, "motorway: error: %s; see motorway --help\n", problem.what());
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
        std::fprintf(stderr, "motorway: error: out of memory; use a smaller mesh or fewer frames\n");
    } catch (const std::exception &problem) {
        std::fprintf(stderr, "motorway: error: %s\n", problem.what());
    }
    return BAD_INPUT;
}
