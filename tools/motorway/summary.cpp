#include "summary.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "text.h"

namespace motorway::tool {

std::string description(const Motion &motion)
{
    std::string words = std::string(motion.closed ? "closed " : "") + scheme_name(motion.kind) + " motion";
    if (motion.kind == MW_MOTION_GENERATOR_KEYS)
        return words + ", " + counted(motion.controls.size(), "key pose");
    words += " of degree " + std::to_string(motion.degree) + ", " + counted(motion.controls.size(), "control pose");
    return words + (motion.weights.empty() ? "" : " with weights");
}

void print_line(const char *label, const std::string &text)
{
    std::printf("%-9s %s\n", label, text.c_str());
}

void print_mesh(const std::string &path, const Mesh &mesh, const Scaling &scaling,
                const std::vector<std::string> &left_out)
{
    print_line("mesh", path);
    std::string counts = counted(mesh.vertex_count(), "vertex") + ", " + counted(mesh.face_count(), "face");
    if (!mesh.lines.empty())
        counts += ", " + counted(mesh.lines.size(), "line");
    print_line("", mesh.is_cloud() ? "a cloud of " + counted(mesh.vertex_count(), "point") : counts);
    if (!scaling.reason.empty())
        print_line("", "scaled by " + precise(scaling.factor) + " (" + scaling.reason + ")");
    for (const std::string &note : mesh.notes)
        print_line("", note);
    constexpr std::size_t MOST_LISTED = 12;
    std::string listed;
    for (std::size_t k = 0; k < std::min(left_out.size(), MOST_LISTED); ++k)
        listed += (k ? ", " : "left out: ") + left_out[k];
    if (left_out.size() > MOST_LISTED)
        listed += " and " + grouped(std::uint64_t{left_out.size() - MOST_LISTED}) + " others";
    if (!listed.empty())
        print_line("", listed);
}

void print_warnings(const std::string &path, const Mesh &mesh)
{
    for (const std::string &warning : mesh.warnings)
        std::fprintf(stderr, "motorway: warning: %s: %s\n", path.c_str(), warning.c_str());
}

void print_motion(const char *label, const std::string &path, const Motion &motion)
{
    print_line(label, path);
    if (!motion.name.empty())
        print_line("", motion.name);
    print_line("", description(motion) + ", t from " + brief(motion.start()) + " to " + brief(motion.end()));
}

void print_files(const std::vector<OutputFiles::File> &files)
{
    constexpr std::size_t FEW = 4;
    const char *label = "written";
    std::uintmax_t total = 0;
    for (std::size_t k = 0; k < files.size(); ++k) {
        total += files[k].bytes;
        if (files.size() > FEW && k == 1)
            print_line("", "...");
        if (files.size() > FEW && k > 0 && k + 2 < files.size())
            continue;
        print_line(label, files[k].path + "  " + byte_size(files[k].bytes));
        label = "";
    }
    if (files.size() > FEW)
        print_line("", counted(files.size(), "file") + ", " + byte_size(total));
}

} // namespace motorway::tool
