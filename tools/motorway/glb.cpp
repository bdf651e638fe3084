#include "glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include <tiny_gltf.h>

#include "error.h"
#include "glb_vertices.h"
#include "motion.h"

namespace motorway::tool {
namespace {

/* The rotations of the motors as glTF's quaternions x y z w. A motor's rotor is cos θ/2 + sin θ/2 (a3 e12 - a2 e13 +
 * a1 e23), because a e123 is that bivector: so x, y, z are b23, -b13, b12. q and -q are the same rotation; each is
 * given the sign that is nearer to the one before, so that viewers take the short way between them. */
std::vector<float> quaternions(const std::vector<mw_motor_f64> &motors)
{
    std::vector<float> out;
    std::array<double, 4> before = {};
    for (const mw_motor_f64 &motor : motors) {
        std::array<double, 4> q = {motor.b23, -motor.b13, motor.b12, motor.s};
        double dot = 0;
        for (std::size_t k = 0; k < 4; ++k)
            dot += q[k] * before[k];
        for (double &component : q) {
            component = dot < 0 ? -component : component;
            out.push_back(static_cast<float>(component));
        }
        before = q;
    }
    return out;
}

/* Where a motion brings the origin of the vertices, relative to that origin. */
std::vector<float> translations(const std::vector<mw_motor_f64> &motors, const std::array<double, 3> &origin)
{
    const std::vector<double> path = trace(motors, origin);
    std::vector<float> out(path.size());
    for (std::size_t i = 0; i < path.size(); ++i)
        out[i] = static_cast<float>(path[i] - origin[i % 3]);
    return out;
}

/* What a float cannot hold. */
void check_floats(const std::vector<float> &values, const std::string &path)
{
    for (float value : values)
        if (!std::isfinite(value))
            throw Error(path, "the mesh is too large for the floats of a .glb file; use smaller lengths");
}

/* Fills one buffer, a view and an accessor for each array. */
class Model {
public:
    int add(const std::vector<float> &values, int type, int target, bool with_bounds)
    {
        const int accessor = add(values.data(), values.size() * sizeof(float), values.size(), type,
                                 TINYGLTF_COMPONENT_TYPE_FLOAT, target);
        if (with_bounds)
            set_bounds(gltf.accessors.back(), values);
        return accessor;
    }

    /* 65535 itself is not an index: it restarts a strip. */
    int add_indices(const std::vector<std::uint32_t> &indices, std::size_t vertex_count)
    {
        if (vertex_count > std::numeric_limits<std::uint16_t>::max())
            return add(indices.data(), indices.size() * sizeof indices[0], indices.size(), TINYGLTF_TYPE_SCALAR,
                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
        return add(narrow.data(), narrow.size() * sizeof narrow[0], narrow.size(), TINYGLTF_TYPE_SCALAR,
                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    }

    tinygltf::Model gltf;

private:
    int add(const void *data, std::size_t bytes, std::size_t values, int type, int component_type, int target)
    {
        if (gltf.buffers.empty())
            gltf.buffers.emplace_back();
        std::vector<unsigned char> &buffer = gltf.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = buffer.size();
        view.byteLength = bytes;
        view.target = target;
        buffer.insert(buffer.end(), static_cast<const unsigned char *>(data),
                      static_cast<const unsigned char *>(data) + bytes);
        buffer.resize((buffer.size() + 3) / 4 * 4); /* glTF wants every array aligned */
        gltf.bufferViews.push_back(view);

        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(gltf.bufferViews.size()) - 1;
        accessor.componentType = component_type;
        accessor.type = type;
        accessor.count =
            values / static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
        gltf.accessors.push_back(accessor);
        return static_cast<int>(gltf.accessors.size()) - 1;
    }

    static void set_bounds(tinygltf::Accessor &accessor, const std::vector<float> &values)
    {
        const std::size_t width = values.size() / accessor.count;
        accessor.minValues.assign(width, std::numeric_limits<double>::infinity());
        accessor.maxValues.assign(width, -std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < values.size(); ++i) {
            double &low = accessor.minValues[i % width], &high = accessor.maxValues[i % width];
            low = std::min(low, static_cast<double>(values[i]));
            high = std::max(high, static_cast<double>(values[i]));
        }
    }
};

void add_material(Model &model, bool has_colours)
{
    tinygltf::Material material;
    material.pbrMetallicRoughness.baseColorFactor = {0.8, 0.76, 0.7, 1.0};
    if (has_colours)
        material.pbrMetallicRoughness.baseColorFactor = {1.0, 1.0, 1.0, 1.0};
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = 0.6;
    model.gltf.materials.push_back(material);
}

/* Triangles, lines, or, of a cloud, the points: all of the same vertices. */
void add_mesh(Model &model, const GlbVertices &vertices, bool has_alpha)
{
    tinygltf::Primitive primitive;
    primitive.material = 0;
    const auto add = [&](const char *name, const std::vector<float> &values, int type) {
        if (!values.empty())
            primitive.attributes[name] =
                model.add(values, type, TINYGLTF_TARGET_ARRAY_BUFFER, name == std::string("POSITION"));
    };
    add("POSITION", vertices.positions, TINYGLTF_TYPE_VEC3);
    add("NORMAL", vertices.normals, TINYGLTF_TYPE_VEC3);
    add("TANGENT", vertices.tangents, TINYGLTF_TYPE_VEC4);
    add("TEXCOORD_0", vertices.uvs, TINYGLTF_TYPE_VEC2);
    add("COLOR_0", vertices.colours, has_alpha ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
    tinygltf::Mesh mesh;
    const auto add_primitive = [&](int mode, const std::vector<std::uint32_t> &indices) {
        primitive.mode = mode;
        primitive.indices = indices.empty() ? -1 : model.add_indices(indices, vertices.count());
        mesh.primitives.push_back(primitive);
    };
    if (!vertices.triangles.empty())
        add_primitive(TINYGLTF_MODE_TRIANGLES, vertices.triangles);
    if (!vertices.lines.empty())
        add_primitive(TINYGLTF_MODE_LINE, vertices.lines);
    if (mesh.primitives.empty())
        add_primitive(TINYGLTF_MODE_POINTS, {});
    model.gltf.meshes.push_back(mesh);
    add_material(model, !vertices.colours.empty());
}

void add_animation(Model &model, const std::vector<float> &rotations, const std::vector<float> &translations,
                   double frames_per_second)
{
    std::vector<float> times;
    for (std::size_t frame = 0; frame < rotations.size() / 4; ++frame)
        times.push_back(static_cast<float>(static_cast<double>(frame) / frames_per_second));
    const int time = model.add(times, TINYGLTF_TYPE_SCALAR, 0, true);

    tinygltf::Animation animation;
    animation.name = "motion";
    const auto add_channel = [&](const char *path, const std::vector<float> &values, int type) {
        tinygltf::AnimationSampler sampler;
        sampler.input = time;
        sampler.output = model.add(values, type, 0, false);
        sampler.interpolation = "LINEAR";
        tinygltf::AnimationChannel channel;
        channel.sampler = static_cast<int>(animation.samplers.size());
        channel.target_node = 0;
        channel.target_path = path;
        animation.samplers.push_back(sampler);
        animation.channels.push_back(channel);
    };
    add_channel("rotation", rotations, TINYGLTF_TYPE_VEC4);
    add_channel("translation", translations, TINYGLTF_TYPE_VEC3);
    model.gltf.animations.push_back(animation);

    /* A viewer that plays no animation shows the first pose. */
    tinygltf::Node &node = model.gltf.nodes[0];
    node.rotation.assign(rotations.begin(), rotations.begin() + 4);
    node.translation.assign(translations.begin(), translations.begin() + 3);
}

} // namespace

std::string write_glb(const Mesh &mesh, const std::vector<mw_motor_f64> &motors, double frames_per_second,
                      const std::string &path)
{
    /* Vertices far away have no digits left for their shape when they are rounded to floats: they are stored near to
     * zero, and a second node brings them to their place. */
    const std::array<double, 3> origin = far_origin(mesh);
    const GlbVertices vertices = glb_vertices(mesh, origin);
    const std::vector<float> moved = translations(motors, origin);
    check_floats(vertices.positions, path);
    check_floats(moved, path);

    Model model;
    model.gltf.asset.version = "2.0";
    model.gltf.asset.generator = "motorway";
    tinygltf::Node node;
    node.mesh = 0;
    model.gltf.nodes.push_back(node);
    tinygltf::Scene scene;
    scene.nodes.push_back(0);
    if (origin != std::array<double, 3>{}) {
        tinygltf::Node place;
        place.translation.assign(origin.begin(), origin.end());
        place.children.push_back(0);
        model.gltf.nodes.push_back(place);
        scene.nodes[0] = 1;
    }
    model.gltf.scenes.push_back(scene);
    model.gltf.defaultScene = 0;
    add_mesh(model, vertices, mesh.has_alpha);
    add_animation(model, quaternions(motors), moved, frames_per_second);
    if (model.gltf.buffers[0].data.size() > std::numeric_limits<std::int32_t>::max())
        throw Error(path, "a .glb file of this mesh would be larger than 2 GB; write .ply or .obj frames instead");
    std::ostringstream out;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model.gltf, out, false, true))
        throw Error(path, "cannot be written as glTF; write .ply or .obj frames instead");
    return out.str();
}

} // namespace motorway::tool
