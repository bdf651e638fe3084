#include "pose_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "error.h"
#include "files.h"
#include "glb.h"
#include "mesh.h"
#include "motion.h"
#include "motion_file.h"
#include "normals.h"
#include "picture.h"
#include "pose.h"
#include "posed_file.h"
#include "progress.h"
#include "scaling.h"
#include "status.h"
#include "summary.h"
#include "text.h"

namespace fs = std::filesystem;

namespace motorway::tool {
namespace {

constexpr long long MOST_FRAMES = 1000000, MOST_PICTURE_POSES = 100;

/* frame.obj as frame-0000.obj, frame-0001.obj and so on, with as many digits as the last one needs. */
std::string numbered(const std::string &path, std::size_t frame, std::size_t count)
{
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(count - 1).size());
    std::string number = std::to_string(frame);
    number.insert(0, digits - number.size(), '0');
    const fs::path whole(path);
    return (whole.parent_path() / (whole.stem().string() + "-" + number + whole.extension().string())).string();
}

bool is_animation(const PoseOptions &options)
{
    return extension(options.out) == ".glb";
}

/* Everything that can be refused before a file is read. */
void check_options(const PoseOptions &options)
{
    const std::string kind = extension(options.out);
    if (options.frames < 1 || options.frames > MOST_FRAMES)
        throw Error("--frames", std::to_string(options.frames) + " will not do; give 1 to " +
                                    grouped(std::uint64_t{MOST_FRAMES}));
    if (kind != ".glb" && kind != ".obj" && kind != ".ply")
        throw Error("--out",
                    in_quotes(options.out) + " has an unknown extension; the tool writes .glb, .obj and .ply");
    check_scale(options.scale);
    if (!(std::isfinite(options.frames_per_second) && options.frames_per_second > 0))
        throw Error("--fps", "must be above 0 and finite; correct it");
    if (options.picture_poses < 1 || options.picture_poses > MOST_PICTURE_POSES)
        throw Error("--picture-poses", std::to_string(options.picture_poses) + " will not do; give 1 to " +
                                           std::to_string(MOST_PICTURE_POSES));
    if (!options.picture.empty() && extension(options.picture) != ".svg")
        throw Error("--picture", in_quotes(options.picture) + " has an unknown extension; pictures are .svg");
    if (!mw_isa())
        throw Error("MOTORWAY_ISA", mw_status_text(MW_ERROR_ISA));
    OutputFiles::check(is_animation(options) ? options.out
                                             : numbered(options.out, 0, static_cast<std::size_t>(options.frames)));
    if (!options.picture.empty())
        OutputFiles::check(options.picture);
}

/* Poses every frame once: measures its edges and, unless the output is an animation, writes it. */
double pose_frames(OutputFiles &out, const PoseOptions &options, const Mesh &mesh,
                   const std::vector<mw_motor_f64> &motors, const std::vector<Edge> &edges)
{
    const std::string kind = extension(options.out);
    Progress progress("posing frame", motors.size());
    double deviation = 0;
    Pose pose;
    for (std::size_t frame = 0; frame < motors.size(); ++frame) {
        pose_mesh(pose, mesh, motors[frame]);
        check_finite(pose, mesh, "frame " + std::to_string(frame));
        deviation = std::max(deviation, edge_deviation(mesh, edges, pose));
        if (!is_animation(options))
            out.write(numbered(options.out, frame, motors.size()), write_posed(mesh, pose, kind));
        progress.step();
    }
    return deviation;
}

/* What can be drawn of a mesh, each corner with a normal. */
Mesh drawable_part(const Mesh &mesh)
{
    Mesh part = finite_part(mesh);
    add_missing_normals(part);
    return part;
}

/* The edges whose length can be measured. */
std::vector<Edge> finite_edges(const Mesh &mesh)
{
    std::vector<Edge> all = edges(mesh);
    const auto touches_nothing = [&](const Edge &edge) {
        return !mesh.has_finite_position(edge.first) || !mesh.has_finite_position(edge.second);
    };
    all.erase(std::remove_if(all.begin(), all.end(), touches_nothing), all.end());
    return all;
}

void print_speed(const Speed &speed, const Mesh &mesh)
{
    const double millions = speed.vertices_per_second / 1e6;
    print_line("posing", (millions < 100 ? brief(millions) : grouped(millions)) + " million vertices/s in " +
                             (mesh.in_double ? "double" : "float") +
                             (mesh.normals.empty() ? "" : ", each with its normal"));
    print_line("", "one thread, without reading and writing; the median of " + counted(speed.passes, "pass") +
                       " over all frames");
}

void print_deviation(double deviation, std::size_t edge_count, const Mesh &mesh)
{
    if (edge_count == 0) {
        print_line("edges", "none, so that there are no lengths to compare");
        return;
    }
    print_line("edges", grouped(static_cast<std::uint64_t>(edge_count)) +
                            ", whose length deviates by at most " + brief(deviation) + " from the rest pose");
    const double diagonal = bounding_box(mesh).diagonal();
    if (diagonal > 0)
        print_line("", brief(deviation / diagonal) + " of the diagonal of the bounding box");
    else
        print_line("", "all vertices are at one point, so that there is no extent to compare that with");
}

} // namespace

void run_pose(const PoseOptions &options)
{
    check_options(options);
    const Motion motion = read_motion(options.motion);
    Mesh mesh = read_mesh(options.mesh);
    const Scaling scaling = choose_scale(options.scale, motion, mesh);
    scale_mesh(mesh, scaling.factor, options.mesh);
    const Mesh drawn = drawable_part(mesh);
    const std::vector<mw_motor_f64> motors =
        sample(motion, even_parameters(motion, static_cast<std::size_t>(options.frames)), options.motion);
    const std::vector<Edge> measured = finite_edges(mesh);

    OutputFiles out;
    const double deviation = pose_frames(out, options, mesh, motors, measured);
    if (is_animation(options))
        out.write(options.out, write_glb(drawn, motors, options.frames_per_second, options.out));
    if (!options.picture.empty())
        out.write(options.picture,
                  draw_picture(drawn, motion, static_cast<std::size_t>(options.picture_poses), options.motion));
    const Speed speed = measure_speed(drawn, motors);
    out.commit();

    print_warnings(options.mesh, mesh);
    print_mesh(options.mesh, mesh, scaling, left_out(mesh, extension(options.out)));
    print_motion("motion", options.motion, motion);
    print_line("frames", grouped(static_cast<std::uint64_t>(motors.size())));
    print_line("ISA", mw_isa());
    print_speed(speed, drawn);
    print_deviation(deviation, measured.size(), mesh);
    print_files(out.files());
}

} // namespace motorway::tool
