// motorway pose, end to end: every vertex of every frame against an independent reference.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dual_quaternion.h"
#include "gltf_file.h"
#include "mesh.h"
#include "normals.h"
#include "run_tool.h"

namespace motorway::tool {
namespace {

const std::string BUNNY = std::string(MOTORWAY_EXAMPLES) + "/data/bunny.ply";
const std::string FIGURE_5 = std::string(MOTORWAY_EXAMPLES) + "/motions/hunt-figure-5.json";
constexpr std::size_t FRAMES = 13;

template <class T> Vector vector_of(const std::vector<T> &xyz, std::size_t i)
{
    return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

double distance(const Vector &a, const Vector &b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::string frame_name(std::size_t frame, const std::string &kind)
{
    const std::string number = std::to_string(frame);
    return "frame-" + std::string(4 - number.size(), '0') + number + kind;
}

DualQuaternion reference_pose(std::size_t frame)
{
    return reference_bspline(figure_5_controls(), {0, 0, 1, 2, 3, 4, 4}, 2,
                             4.0 * static_cast<double>(frame) / (FRAMES - 1));
}

ToolResult pose_bunny(const TemporaryFolder &folder, const std::string &out, std::vector<std::string> more = {})
{
    std::vector<std::string> arguments = {"pose",  BUNNY, "--motion", FIGURE_5, "--frames", std::to_string(FRAMES),
                                          "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run_tool(folder.path(), arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result;
}

/* The bunny as the tool poses it: scaled to the mesh_size of the motion file, 1.5. */
Mesh rest_bunny(double scale = 0)
{
    Mesh bunny = read_mesh(BUNNY);
    const double factor = scale > 0 ? scale : 1.5 / bounding_box(bunny).longest_side();
    for (double &coordinate : bunny.positions)
        coordinate *= factor;
    return bunny;
}

void expect_posed(const Mesh &posed, const Mesh &rest, const DualQuaternion &pose, const std::string &what)
{
    ASSERT_EQ(posed.vertex_count(), rest.vertex_count()) << what;
    ASSERT_EQ(posed.normal_count(), rest.normal_count()) << what;
    EXPECT_EQ(posed.corners, rest.corners) << what;
    double point_error = 0, normal_error = 0;
    for (std::size_t i = 0; i < rest.vertex_count(); ++i)
        point_error = std::max(point_error, distance(vector_of(posed.positions, i),
                                                     reference_point(pose, vector_of(rest.positions, i))));
    for (std::size_t i = 0; i < rest.normal_count(); ++i)
        normal_error = std::max(normal_error, distance(vector_of(posed.normals, i),
                                                       reference_direction(pose, vector_of(rest.normals, i))));
    /* Coordinates up to 10, rounded to float once. */
    EXPECT_LT(point_error, 1e-6) << what;
    EXPECT_LT(normal_error, 1e-7) << what;
}

class PoseFrames : public ::testing::TestWithParam<const char *> {};

TEST_P(PoseFrames, AreThoseOfTheReference)
{
    const TemporaryFolder folder;
    const std::string kind = GetParam();
    pose_bunny(folder, "frame" + kind);
    const Mesh rest = rest_bunny();
    std::vector<std::string> expected_files;
    for (std::size_t frame = 0; frame < FRAMES; ++frame) {
        expected_files.push_back(frame_name(frame, kind));
        const Mesh posed = read_mesh((folder.path() / frame_name(frame, kind)).string());
        expect_posed(posed, rest, reference_pose(frame), frame_name(frame, kind));
    }
    EXPECT_EQ(folder.list(), expected_files) << "and nothing else is left behind";
}

INSTANTIATE_TEST_SUITE_P(, PoseFrames, ::testing::Values(".obj", ".ply"),
                         [](const auto &kind) { return std::string(kind.param) == ".obj" ? "Obj" : "Ply"; });

/* Frames of a motion that is no additive one: the tableau of de Casteljau with slerp. */
TEST(Pose, TakesAnyScheme)
{
    const TemporaryFolder folder;
    folder.write("slerps.json", R"({"motorway": 2, "scheme": "multiplicative", "degree": 2, "mesh_size": 1.5,
        "controls": [{"steps": []}, {"axis": [1, 2, 0], "degrees": 80, "translate": [3, 0, 1]},
                     {"axis": [0, 0, 1], "degrees": 150, "translate": [4, 4, 0]}]})");
    const ToolResult result =
        run_tool(folder.path(), {"pose", BUNNY, "--motion", "slerps.json", "--frames", "5", "--out", "frame.ply"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("multiplicative motion of degree 2, 3 control poses"), std::string::npos) << result.out;
    const std::vector<DualQuaternion> controls = {
        reference_translation({0, 0, 0}),
        reference_sequence({reference_rotation({1, 2, 0}, 80), reference_translation({3, 0, 1})}),
        reference_sequence({reference_rotation({0, 0, 1}, 150), reference_translation({4, 4, 0})})};
    for (std::size_t frame = 0; frame < 5; ++frame)
        expect_posed(read_mesh((folder.path() / frame_name(frame, ".ply")).string()), rest_bunny(),
                     reference_multiplicative(controls, {0, 0, 1, 1}, 2, static_cast<double>(frame) / 4),
                     "frame " + std::to_string(frame));
}

TEST(Pose, ScalesOnlyAsAsked)
{
    const TemporaryFolder folder;
    EXPECT_NE(pose_bunny(folder, "frame.ply").out.find("scaled by 0.151"), std::string::npos);
    EXPECT_NE(pose_bunny(folder, "frame.ply", {"--scale", "2"}).out.find("scaled by 2 "), std::string::npos);
    expect_posed(read_mesh((folder.path() / frame_name(5, ".ply")).string()), rest_bunny(2), reference_pose(5),
                 "scaled by 2");
    folder.write("still.json", R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []}, {"steps": []}]})");
    const ToolResult result =
        run_tool(folder.path(), {"pose", BUNNY, "--motion", "still.json", "--frames", "1", "--out", "still.ply"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out.find("scaled"), std::string::npos) << "nobody asked for a scale:\n" << result.out;
    EXPECT_EQ(read_mesh((folder.path() / "still-0000.ply").string()).positions, read_mesh(BUNNY).positions);
}

TEST(Pose, SummaryHasCountsIsaSpeedAndDeviation)
{
    const TemporaryFolder folder;
    const std::string summary = pose_bunny(folder, "bunny.glb").out;
    for (const char *words : {"1,839 vertices, 3,674 faces", "frames    13", "ISA       ", "million vertices/s",
                              "edges     5,511, whose length deviates by at most ", "bunny.glb  "})
        EXPECT_NE(summary.find(words), std::string::npos) << words << "\n" << summary;
    const std::string before = "deviates by at most ";
    const double deviation = std::stod(summary.substr(summary.find(before) + before.size()));
    EXPECT_GT(deviation, 0) << "floats do round";
    EXPECT_LT(deviation, 1e-5);
}

TEST(Pose, KeepsTheNormalsOfCorners)
{
    const TemporaryFolder folder;
    folder.write("wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\n"
                              "f 1//2 3//2 4//2\n");
    folder.write("turn.json", R"({"motorway": 1, "kind": "linear", "controls":
        [{"steps": []}, {"steps": [{"rotate": {"axis": [0, 0, 1], "degrees": 90}}, {"translate": [5, 0, 0]}]}]})");
    const ToolResult result =
        run_tool(folder.path(), {"pose", "wedge.obj", "--motion", "turn.json", "--frames", "2", "--out", "out.obj"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Mesh posed = read_mesh((folder.path() / "out-0001.obj").string());
    EXPECT_EQ(posed.corner_normals, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1}));
    EXPECT_LT(distance(vector_of(posed.normals, 0), {0, 0, 1}), 1e-6);
    EXPECT_LT(distance(vector_of(posed.normals, 1), {0, 1, 0}), 1e-6) << "rotated, and not translated";
    EXPECT_LT(distance(vector_of(posed.positions, 1), {5, 1, 0}), 1e-6);
}

/* ---------------------------------------------------------------------------------------------------- glTF --- */

TEST(PoseGlb, MovesTheNodeAsTheFramesMoveTheirVertices)
{
    const TemporaryFolder folder;
    pose_bunny(folder, "bunny.glb");
    pose_bunny(folder, "frame.ply");
    const Gltf gltf(folder.path() / "bunny.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    const std::vector<float> positions = gltf.floats(primitive.attributes.at("POSITION"));
    const auto [times, rotations] = gltf.channel("rotation");
    const auto [same_times, translations] = gltf.channel("translation");
    ASSERT_EQ(rotations.size(), 4 * FRAMES);
    ASSERT_EQ(translations.size(), 3 * FRAMES);
    const std::vector<double> rest = rest_bunny().positions;
    EXPECT_EQ(positions, std::vector<float>(rest.begin(), rest.end()));
    EXPECT_EQ(times, same_times);
    double error = 0;
    for (std::size_t frame = 0; frame < FRAMES; ++frame) {
        EXPECT_FLOAT_EQ(times[frame], static_cast<float>(frame) / 30);
        const Mesh posed = read_mesh((folder.path() / frame_name(frame, ".ply")).string());
        for (std::size_t i = 0; i < posed.vertex_count(); ++i)
            error = std::max(error, distance(vector_of(posed.positions, i),
                                             gltf_transform(&rotations[4 * frame], &translations[3 * frame],
                                                            vector_of(positions, i))));
    }
    EXPECT_LT(error, 1e-5);
}

TEST(PoseGlb, HasUnitQuaternionsThatTakeTheShortWay)
{
    const TemporaryFolder folder;
    /* At its controls, four frames, this motion jumps from one hemisphere to the other. */
    folder.write("turns.json", R"({"motorway": 1, "kind": "linear", "controls": [{"motor": [1, 0, 0, 0, 0, 0, 0, 0]},
        {"motor": [-3, 1, 0, 0, 0, 0, 0, 0]}, {"motor": [1, 0, 0.2, 0, 0, 0, 0, 0]},
        {"motor": [0.1, 0, 0, 2, 0, 0, 0, 0]}]})");
    const ToolResult result =
        run_tool(folder.path(), {"pose", BUNNY, "--motion", "turns.json", "--frames", "4", "--out", "out.glb"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::vector<float> q = Gltf(folder.path() / "out.glb").channel("rotation").second;
    ASSERT_EQ(q.size(), 16u);
    for (std::size_t i = 0; i < q.size(); i += 4) {
        EXPECT_NEAR(std::hypot(std::hypot(q[i], q[i + 1]), std::hypot(q[i + 2], q[i + 3])), 1, 1e-6) << i / 4;
        for (std::size_t before = i - 4; i > 0 && before < i; before += 4)
            EXPECT_GE(
                q[i] * q[before] + q[i + 1] * q[before + 1] + q[i + 2] * q[before + 2] + q[i + 3] * q[before + 3], 0)
                << i / 4;
    }
}

TEST(PoseGlb, IsCompleteAndSmall)
{
    const TemporaryFolder folder;
    pose_bunny(folder, "bunny.glb", {"--fps", "10"});
    const Gltf gltf(folder.path() / "bunny.glb");
    EXPECT_EQ(gltf.model.asset.version, "2.0");
    EXPECT_TRUE(gltf.model.images.empty());
    EXPECT_EQ(gltf.model.buffers.size(), 1u);
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    const auto &indices = gltf.model.accessors.at(static_cast<std::size_t>(primitive.indices));
    EXPECT_EQ(indices.count, 3u * 3674u);
    EXPECT_EQ(indices.componentType, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
    const auto &position = gltf.model.accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
    EXPECT_EQ(position.count, 1839u);
    const Box box = bounding_box(rest_bunny());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_FLOAT_EQ(static_cast<float>(position.minValues.at(axis)), static_cast<float>(box.low[axis]));
        EXPECT_FLOAT_EQ(static_cast<float>(position.maxValues.at(axis)), static_cast<float>(box.high[axis]));
    }
    EXPECT_FLOAT_EQ(gltf.channel("rotation").first.back(), 1.2f);
    EXPECT_LT(std::filesystem::file_size(folder.path() / "bunny.glb"), 80000u);
}

TEST(PoseGlb, SplitsVerticesWithSeveralNormals)
{
    const TemporaryFolder folder;
    folder.write("wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\n"
                              "f 1//2 3//2 4//2\n");
    folder.write("still.json", R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []}, {"steps": []}]})");
    const ToolResult result =
        run_tool(folder.path(), {"pose", "wedge.obj", "--motion", "still.json", "--frames", "1", "--out", "out.glb"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Gltf gltf(folder.path() / "out.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    EXPECT_EQ(gltf.floats(primitive.attributes.at("POSITION")),
              (std::vector<float>{0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(gltf.floats(primitive.attributes.at("NORMAL")),
              (std::vector<float>{0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0}));
}

} // namespace
} // namespace motorway::tool
