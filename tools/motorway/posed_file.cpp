#include "posed_file.h"

#include "normals.h"
#include "obj.h"
#include "ply.h"

namespace motorway::tool {

static bool is_own_kind(const Mesh &mesh, const std::string &kind)
{
    return mesh.source && kind == mesh.source->kind();
}

std::string write_posed(const Mesh &mesh, const Pose &pose, const std::string &kind)
{
    if (is_own_kind(mesh, kind))
        return mesh.source->write(pose);
    return kind == ".obj" ? write_obj(mesh, pose) : write_ply(mesh, pose);
}

std::vector<std::string> left_out(const Mesh &mesh, const std::string &kind)
{
    if (is_own_kind(mesh, kind))
        return {};
    std::vector<std::string> names = mesh.beyond;
    const auto add = [&](bool lost, const char *name) {
        if (lost)
            names.push_back(name);
    };
    const bool as_glb = kind == ".glb", as_ply = kind == ".ply";
    add(as_ply && !mesh.normals.empty() && !has_all_normals(mesh), "normals (not every corner has one)");
    add(as_ply && has_all_normals(mesh) && !mesh.corner_normals.empty(),
        "normals of corners (each vertex gets their mean)");
    add(as_ply && !mesh.uvs.empty() && mesh.corner_uvs.empty() && !mesh.has_vertex_uvs(), "texture coordinates");
    add(!as_glb && !mesh.tangents.empty(), "tangents");
    add(!mesh.bitangents.empty(), "bitangents");
    add(!mesh.face_normals.empty(), "normals of faces");
    add(kind == ".obj" && mesh.has_alpha, "the alpha of colours");
    return names;
}

} // namespace motorway::tool
