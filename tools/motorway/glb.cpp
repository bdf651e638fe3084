#include "glb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include <tiny_gltf.h>

#include "error.h"
#include "motion.h"
#include "status.h"

namespace motorway::tool {
namespace {

/* One vertex of the file: glTF has one normal a vertex, a Mesh may have one a corner. */
struct Vertices {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices; /* three a triangle */
};

Vertices split_vertices(const Mesh &mesh)
{
    Vertices out;
    std::vector<std::uint32_t> vertex_of_corner = mesh.corners;
    if (mesh.corner_normals.empty()) {
        out.positions = mesh.positions;
        out.normals = unit_vectors({mesh.normals.begin(), mesh.normals.end()});
    } else {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
        for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner)
            numbers[{mesh.corners[corner], mesh.corner_normals[corner]}] = 0;
        std::uint32_t next = 0;
        std::vector<double> normals;
        for (auto &[pair, number] : numbers) {
            number = next++;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                out.positions.push_back(mesh.positions[3 * std::size_t{pair.first} + axis]);
                normals.push_back(mesh.normals[3 * std::size_t{pair.second} + axis]);
            }
        }
        out.normals = unit_vectors(normals);
        for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner)
            vertex_of_corner[corner] = numbers[{mesh.corners[corner], mesh.corner_normals[corner]}];
    }
    for (const Triangle &triangle : triangles(mesh))
        for (std::uint32_t corner : triangle)
            out.indices.push_back(vertex_of_corner[corner]);
    return out;
}

/* The rotations of the motors as glTF's quaternions x y z w. A motor's rotor is cos θ/2 + sin θ/2 (a3 e12 - a2 e13 +
 * a1 e23), because a e123 is that bivector: so x, y, z are b23, -b13, b12. q and -q are the same rotation; each is
 * given the sign that is nearer to the one before, so that viewers take the short way between them. */
std::vector<float> quaternions(const std::vector<mw_motor_f32> &motors)
{
    std::vector<mw_motor_f32> unit(motors.size());
    check(mw_normalize_motor_each_f32(mw_motors_f32_aos(unit.data(), sizeof unit[0]),
                                      mw_const_motors_f32_aos(motors.data(), sizeof motors[0]), motors.size()),
          "normalising the motors");
    std::vector<float> out;
    for (const mw_motor_f32 &motor : unit) {
        float q[4] = {motor.b23, -motor.b13, motor.b12, motor.s};
        float dot = 0;
        for (std::size_t k = 0; k < 4 && !out.empty(); ++k)
            dot += q[k] * out[out.size() - 4 + k];
        for (float component : q)
            out.push_back(dot < 0 ? -component : component);
    }
    return out;
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

void add_mesh(Model &model, const Mesh &mesh)
{
    const Vertices vertices = split_vertices(mesh);
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
    primitive.attributes["POSITION"] =
        model.add(vertices.positions, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER, true);
    primitive.attributes["NORMAL"] =
        model.add(vertices.normals, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER, false);
    primitive.indices = model.add_indices(vertices.indices, vertices.positions.size() / 3);
    tinygltf::Mesh out;
    out.primitives.push_back(primitive);
    model.gltf.meshes.push_back(out);

    tinygltf::Material material;
    material.pbrMetallicRoughness.baseColorFactor = {0.8, 0.76, 0.7, 1.0};
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = 0.6;
    model.gltf.materials.push_back(material);
}

void add_animation(Model &model, const std::vector<mw_motor_f32> &motors, double frames_per_second)
{
    const float origin[3] = {0, 0, 0};
    std::vector<float> times;
    for (std::size_t frame = 0; frame < motors.size(); ++frame)
        times.push_back(static_cast<float>(static_cast<double>(frame) / frames_per_second));
    const std::vector<float> rotations = quaternions(motors), translations = trace(motors, origin);
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

std::string write_glb(const Mesh &mesh, const std::vector<mw_motor_f32> &motors, double frames_per_second,
                      const std::string &path)
{
    Model model;
    model.gltf.asset.version = "2.0";
    model.gltf.asset.generator = "motorway";
    tinygltf::Node node;
    node.mesh = 0;
    model.gltf.nodes.push_back(node);
    tinygltf::Scene scene;
    scene.nodes.push_back(0);
    model.gltf.scenes.push_back(scene);
    model.gltf.defaultScene = 0;
    add_mesh(model, mesh);
    add_animation(model, motors, frames_per_second);
    if (model.gltf.buffers[0].data.size() > std::numeric_limits<std::int32_t>::max())
        throw Error(path, "a .glb file of this mesh would be larger than 2 GB; write .ply or .obj frames instead");
    std::ostringstream out;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model.gltf, out, false, true))
        throw Error(path, "cannot be written as glTF; write .ply or .obj frames instead");
    return out.str();
}

} // namespace motorway::tool
