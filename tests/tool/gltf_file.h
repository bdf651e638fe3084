/* A .glb file as a test sees it. */
#ifndef MOTORWAY_TESTS_GLTF_FILE_H
#define MOTORWAY_TESTS_GLTF_FILE_H

#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "dual_quaternion.h"

namespace motorway::tool {

struct Gltf {
    tinygltf::Model model;

    explicit Gltf(const std::filesystem::path &path)
    {
        std::string errors, warnings;
        EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &errors, &warnings, path.string())) << errors;
        EXPECT_EQ(errors + warnings, "");
    }

    std::vector<float> floats(int accessor) const
    {
        const tinygltf::Accessor &a = model.accessors.at(static_cast<std::size_t>(accessor));
        const tinygltf::BufferView &view = model.bufferViews.at(static_cast<std::size_t>(a.bufferView));
        EXPECT_EQ(a.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
        std::vector<float> values(view.byteLength / sizeof(float));
        std::memcpy(values.data(), model.buffers.at(0).data.data() + view.byteOffset, view.byteLength);
        EXPECT_EQ(values.size(), a.count * static_cast<std::size_t>(
                                               tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type))));
        return values;
    }

    /* The times and values of the channel with this target. */
    std::pair<std::vector<float>, std::vector<float>> channel(const std::string &target) const
    {
        for (const tinygltf::AnimationChannel &channel : model.animations.at(0).channels)
            if (channel.target_path == target) {
                EXPECT_EQ(channel.target_node, 0);
                const auto &sampler = model.animations[0].samplers.at(static_cast<std::size_t>(channel.sampler));
                EXPECT_EQ(sampler.interpolation, "LINEAR");
                return {floats(sampler.input), floats(sampler.output)};
            }
        ADD_FAILURE() << "no channel " << target;
        return {};
    }
};

/* glTF 2.0: a node's matrix is T R, and a rotation is the unit quaternion x y z w. */
inline Vector gltf_transform(const float *q, const float *t, const Vector &v)
{
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    return {(1 - 2 * (y * y + z * z)) * v[0] + 2 * (x * y - z * w) * v[1] + 2 * (x * z + y * w) * v[2] + t[0],
            2 * (x * y + z * w) * v[0] + (1 - 2 * (x * x + z * z)) * v[1] + 2 * (y * z - x * w) * v[2] + t[1],
            2 * (x * z - y * w) * v[0] + 2 * (y * z + x * w) * v[1] + (1 - 2 * (x * x + y * y)) * v[2] + t[2]};
}

} // namespace motorway::tool

#endif
