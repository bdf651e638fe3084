// Mesh files as people have them, end to end: what is in data/ and short ones that are written here.

#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "files.h"
#include "gltf_file.h"
#include "mesh.h"
#include "run_tool.h"
#include "values.h"

namespace motorway::tool {
namespace {

const std::string DATA = std::string(MOTORWAY_TEST_DATA) + "/";
const std::string STILL = R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []}, {"steps": []}]})";

class MeshFiles : public ::testing::Test {
protected:
    MeshFiles() { folder_.write("still.json", STILL); }

    /* Poses a file; the last frame is then last.KIND, or the animation is all.glb. */
    ToolResult pose(const std::string &mesh, const std::string &kind, std::vector<std::string> more = {},
                    const std::string &motion = "still.json")
    {
        std::vector<std::string> arguments = {"pose", mesh, "--motion", motion, "--frames", "2", "--out"};
        arguments.push_back(kind == ".glb" ? "all.glb" : "frame" + kind);
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ToolResult result = run_tool(folder_.path(), arguments);
        EXPECT_EQ(result.exit_code, 0) << mesh << ": " << result.err;
        return result;
    }

    std::string last(const std::string &kind) const { return folder_.read("frame-0001" + kind); }
    Mesh last_mesh(const std::string &kind) const
    {
        return read_mesh((folder_.path() / ("frame-0001" + kind)).string());
    }

    /* The file that a test writes, posed. */
    ToolResult pose_text(const std::string &name, const std::string &contents, const std::string &kind,
                         std::vector<std::string> more = {})
    {
        folder_.write(name, contents);
        return pose(name, kind, more);
    }

    const TemporaryFolder folder_;
};

bool has(const std::string &text, const std::string &words)
{
    return text.find(words) != std::string::npos;
}

TEST_F(MeshFiles, CoordinatesOfMapsKeepTheirDigits)
{
    pose(DATA + "utm_cube.obj", ".obj", {}, DATA + "rot.json");
    const Mesh cube = last_mesh(".obj");
    ASSERT_EQ(cube.vertex_count(), 8u);
    /* 30 degrees about the first corner: (10, 0) becomes (8.66, 5), and (10, 10) becomes (3.66, 13.66). */
    const double fifth[] = {388104.7832540378, 3949001.456}, eighth[] = {388099.7832540378, 3949010.1162540378};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(cube.positions[12 + axis], fifth[axis], 2e-9);
        EXPECT_NEAR(cube.positions[21 + axis], eighth[axis], 2e-9);
    }
    EXPECT_EQ(cube.positions[23], 20);

    pose(DATA + "utm_double.ply", ".ply", {}, DATA + "id.json");
    const Mesh triangle = last_mesh(".ply");
    const std::array<double, 9> expected = {0.123, 0.456, 10.789, 0.133, 0.456, 10.789, 0.123, 0.466, 10.789};
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_NEAR(triangle.positions[i], expected[i], 1e-9) << i;
    EXPECT_TRUE(has(last(".ply"), "property double x\n"));
}

// A motion of doubles on a mesh of floats: the offset is gone before anything is rounded.
TEST_F(MeshFiles, FloatsUnderLargeOffsetsAreRoundedOnce)
{
    folder_.write("back.json", R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls": [{"steps": []},
        {"steps": [{"translate": [1e9, 1, 0]}, {"rotate": {"axis": [0, 0, 1], "degrees": 180}},
                   {"translate": [1e9, 1, 0]}]}]})");
    folder_.write("cloud.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                               "property float z\nend_header\n0.5 0.25 3\n");
    pose("cloud.ply", ".ply", {}, "back.json");
    const Mesh cloud = last_mesh(".ply");
    EXPECT_NEAR(cloud.positions[0], -0.5, 1e-6);
    EXPECT_NEAR(cloud.positions[1], -0.25, 1e-6);
}

/* The same text, whatever ends its lines: four vertices and four triangles. */
TEST_F(MeshFiles, LineEndsAndByteOrderMarksAreRead)
{
    for (const char *name : {"cr_only.obj", "cr_only.ply", "bom.obj", "bom.ply", "cont_glued.obj", "fo.obj"}) {
        const ToolResult result = pose(DATA + name, extension(name));
        EXPECT_EQ(result.err, "") << name;
        const Mesh mesh = last_mesh(extension(name));
        EXPECT_EQ(mesh.positions, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})) << name;
        EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2})) << name;
        const std::string file = read_file(DATA + name);
        EXPECT_EQ(last(extension(name)), file.substr(file.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0)) << name;
    }
}

TEST_F(MeshFiles, WhatIsNoGeometryIsKept)
{
    for (const char *name : {"uv.obj", "cloud.ply", "unknown_vw.obj", "two_corner_face.obj", "two_corner_face.ply",
                             "face0_noprop.ply", "nan_point.ply", "tristrips.ply", "onepoint.obj"}) {
        pose(DATA + name, extension(name));
        EXPECT_EQ(last(extension(name)), read_file(DATA + name)) << name;
    }
}

TEST_F(MeshFiles, RemarksNameWhatIsUnusual)
{
    EXPECT_TRUE(has(pose(DATA + "unknown_vw.obj", ".obj").out, "unknown statements, passed over: 1 \"vw\" in line 9"));
    EXPECT_TRUE(has(pose(DATA + "two_corner_face.obj", ".obj").err,
                    "two_corner_face.obj: 1 face of fewer than three corners, the first in line 9"));
    EXPECT_TRUE(has(pose(DATA + "two_corner_face.ply", ".ply").err,
                    "two_corner_face.ply: 1 face of fewer than three corners"));
    EXPECT_TRUE(has(pose(DATA + "nan_point.ply", ".ply").err, "nan_point.ply: 1 vertex with coordinates that are not"));
    EXPECT_TRUE(has(pose(DATA + "cloud.ply", ".ply").out, "a cloud of 3 points"));
    const std::string one_point = pose(DATA + "onepoint.obj", ".obj").out;
    EXPECT_TRUE(has(one_point, "all vertices are at one point")) << one_point;
    EXPECT_FALSE(has(one_point, "nan")) << one_point;
    EXPECT_FALSE(has(pose(DATA + "uv.obj", ".obj").out, "left out"));
}

TEST_F(MeshFiles, UnknownStatementsAreListedOncePerKeyword)
{
    std::string text = "v 0 0 0\nzz 1\nzz 2\naa 3\n";
    for (char c = 'a'; c < 'k'; ++c)
        text += std::string("x") + c + "\n";
    const std::string summary = pose_text("mesh.obj", text, ".obj").out;
    EXPECT_TRUE(has(summary, "passed over: 2 \"zz\" from line 2, 1 \"aa\" in line 4, 1 \"xa\" in line 5, ")) << summary;
    EXPECT_TRUE(has(summary, " and 4 of other kinds\n")) << summary;
}

TEST_F(MeshFiles, PropertyTwiceIsAnErrorWithItsLine)
{
    const ToolResult result = run_tool(folder_.path(), {"pose", DATA + "dup_prop.ply", "--motion", "still.json",
                                                        "--frames", "1", "--out", "x.ply"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(has(result.err, "dup_prop.ply:8: a second property \"scalar\"")) << result.err;
}

TEST_F(MeshFiles, TriangleStripsAlternateTheirSense)
{
    const Mesh mesh = read_mesh(DATA + "tristrips.ply");
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 1, 3, 2}));
    pose_text("strips.ply",
              "ply\nformat ascii 1.0\nelement tristrips 2\nproperty list uchar uint vertex_index\nproperty int id\n"
              "element vertex 5\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
              "8 0 1 2 2 3 4 4294967295 0 7\n3 4 3 2 8\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n",
              ".obj");
    EXPECT_EQ(last_mesh(".obj").corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 4, 4, 3, 2}))
        << "and a triangle without area only joins two others";
}

/* ----------------------------------------------------------------------------------------- to another format --- */

const std::string COLOURED = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                             "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                             "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\n"
                             "property float t\nproperty float intensity\nelement face 1\n"
                             "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
                             "property int vertex2\nend_header\n0 0 0 0 0 1 255 0 0 0.25 0 7\n"
                             "1 0 0 0 0 1 0 255 0 1 0.5 8\n0 1 0.1 0 0 1 0 51 255 0 1 9\n3 0 1 2\n0 2\n";

TEST_F(MeshFiles, PlyBecomesObjWithAllThatObjHolds)
{
    const ToolResult result = pose_text("mesh.ply", COLOURED, ".obj");
    EXPECT_EQ(last(".obj"), "# motorway\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0.1 0 0.2 1\nvt 0.25 0\nvt 1 0.5\n"
                            "vt 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1/1/1 2/2/2 3/3/3\nl 1 3\n");
    EXPECT_TRUE(has(result.out, "left out: vertex \"intensity\"\n")) << result.out;
}

TEST_F(MeshFiles, ObjBecomesPlyWithAllThatPlyHolds)
{
    pose_text("mesh.ply", COLOURED, ".obj");
    folder_.write("mesh.obj", last(".obj"));
    pose("mesh.obj", ".ply");
    const std::string file = last(".ply");
    EXPECT_TRUE(has(file, "property double x\nproperty double y\nproperty double z\nproperty double nx\n"
                          "property double ny\nproperty double nz\nproperty uchar red\nproperty uchar green\n"
                          "property uchar blue\nproperty float s\nproperty float t\nelement face 1\n"))
        << file;
    const Mesh mesh = last_mesh(".ply"), expected = read_mesh((folder_.path() / "mesh.obj").string());
    EXPECT_EQ(mesh.positions, expected.positions);
    EXPECT_EQ(mesh.normals, expected.normals);
    EXPECT_EQ(mesh.uvs, expected.uvs);
    EXPECT_EQ(mesh.corners, expected.corners);
    EXPECT_EQ(mesh.lines, expected.lines);
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_FLOAT_EQ(mesh.colours.at(i), expected.colours.at(i)) << i;
}

TEST_F(MeshFiles, ObjBecomesPlyWithTextureCoordinatesOfCorners)
{
    const std::string seam = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt .5 .5\n"
                             "usemtl red\nf 1/1 2/2 3/3\nf 3/4 2/2 4\nf 1 2\n";
    const ToolResult result = pose_text("seam.obj", seam, ".ply");
    EXPECT_TRUE(has(result.out, "left out: materials\n")) << result.out;
    const Mesh mesh = last_mesh(".ply");
    EXPECT_EQ(mesh.uvs, (std::vector<float>{0, 0, 1, 0, 0, 1, .5, .5, 1, 0, 0, 0}));
    EXPECT_EQ(mesh.corner_uvs, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.face_count(), 2u) << "and not the one of two corners";
}

TEST_F(MeshFiles, ColoursOfObjMayBeBytesOrFloats)
{
    pose_text("a.obj", "v 0 0 0 255 128 0\nv 1 0 0\n", ".ply");
    EXPECT_TRUE(has(last(".ply"), "property uchar red\n"));
    pose_text("b.obj", "v 0 0 0 0.1234 0.5 0 0.25\n", ".ply");
    EXPECT_TRUE(has(last(".ply"), "property float blue\nproperty float alpha\n"));
    EXPECT_EQ(last_mesh(".ply").colours, (std::vector<float>{0.1234f, 0.5f, 0, 0.25f}));
}

/* ---------------------------------------------------------------------------------------------------- to glTF --- */

TEST_F(MeshFiles, GlbHasColoursTextureCoordinatesAndLines)
{
    const ToolResult result = pose_text("mesh.ply", COLOURED, ".glb");
    EXPECT_TRUE(has(result.out, "left out: vertex \"intensity\"\n")) << result.out;
    const Gltf gltf(folder_.path() / "all.glb");
    const auto &primitives = gltf.model.meshes.at(0).primitives;
    ASSERT_EQ(primitives.size(), 2u);
    EXPECT_EQ(primitives[0].mode, TINYGLTF_MODE_TRIANGLES);
    EXPECT_EQ(primitives[1].mode, TINYGLTF_MODE_LINE);
    EXPECT_EQ(gltf.model.accessors.at(static_cast<std::size_t>(primitives[1].indices)).count, 2u);
    EXPECT_EQ(gltf.floats(primitives[0].attributes.at("TEXCOORD_0")), (std::vector<float>{.25f, 1, 1, .5f, 0, 0}))
        << "v counts downwards";
    const std::vector<float> colours = gltf.floats(primitives[0].attributes.at("COLOR_0"));
    ASSERT_EQ(colours.size(), 9u);
    EXPECT_EQ(std::vector<float>(colours.begin(), colours.begin() + 6), (std::vector<float>{1, 0, 0, 0, 1, 0}));
    EXPECT_NEAR(colours[7], 0.033105, 1e-5) << "the light of an sRGB component of 0.2";
}

TEST_F(MeshFiles, GlbOfACloudHasPoints)
{
    pose(DATA + "cloud.ply", ".glb", {"--picture", "cloud.svg"});
    const Gltf gltf(folder_.path() / "all.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    EXPECT_EQ(primitive.mode, TINYGLTF_MODE_POINTS);
    EXPECT_EQ(primitive.indices, -1);
    EXPECT_EQ(primitive.attributes.count("NORMAL"), 0u);
    EXPECT_EQ(gltf.floats(primitive.attributes.at("POSITION")), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(gltf.floats(primitive.attributes.at("COLOR_0")), (std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
}

TEST_F(MeshFiles, PictureOfACloudHasItsPoints)
{
    const auto dots = [&](const std::string &contents) {
        pose_text("cloud.obj", contents, ".obj", {"--picture", "cloud.svg", "--picture-poses", "1"});
        const std::string svg = folder_.read("cloud.svg");
        EXPECT_FALSE(has(svg, "nan"));
        std::size_t count = 0;
        for (std::size_t at = svg.find("l0 0"); at != std::string::npos; at = svg.find("l0 0", at + 1))
            ++count;
        return count;
    };
    const std::size_t two = dots("v 0 0 0\nv 1 2 3\n");
    EXPECT_EQ(dots("v 0 0 0\nv 1 2 3\nv 1 0 2\nv nan 0 0\nv 0 0 1\n"), two + 2) << "and none where there is no place";
}

TEST_F(MeshFiles, GlbLeavesOutPointsWithoutAPlace)
{
    pose_text("holes.obj", "v 0 0 0\nv nan 0 0\nv 1 0 0\nv 0 1 0\nv inf 1 1\nvn 0 0 1\nf 1//1 3//1 4//1\nf 1 2 3\n",
              ".glb", {"--picture", "holes.svg"});
    const Gltf gltf(folder_.path() / "all.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    EXPECT_EQ(gltf.floats(primitive.attributes.at("POSITION")), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(gltf.model.accessors.at(static_cast<std::size_t>(primitive.indices)).count, 3u);
    const auto &bounds = gltf.model.accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
    EXPECT_EQ(bounds.maxValues, (std::vector<double>{1, 1, 0}));
    EXPECT_FALSE(has(folder_.read("holes.svg"), "nan"));
}

TEST_F(MeshFiles, GlbGivesNormalsToCornersThatHaveNone)
{
    pose_text("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\nf 3 2 4\n", ".glb");
    const Gltf gltf(folder_.path() / "all.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    const std::vector<float> normals = gltf.floats(primitive.attributes.at("NORMAL"));
    EXPECT_EQ(normals, (std::vector<float>{1, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 1}));
}

// glTF has no numbers that are none.
TEST_F(MeshFiles, GlbHasFiniteNumbersOnly)
{
    pose_text("mesh.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "property float nx\nproperty float ny\nproperty float nz\nproperty double s\nproperty double t\n"
              "property float red\nproperty float green\nproperty float blue\nelement face 1\n"
              "property list uchar int vertex_indices\nend_header\n0 0 0 nan 0 0 nan 0 nan 1 1\n"
              "1 0 0 0 inf 0 1e300 1 1 inf 1\n0 1 0 0 0 0 -inf 1 1 1 -nan\n3 0 1 2\n",
              ".glb");
    const Gltf gltf(folder_.path() / "all.glb");
    for (const auto &[name, accessor] : gltf.model.meshes.at(0).primitives.at(0).attributes)
        for (float value : gltf.floats(accessor))
            EXPECT_TRUE(std::isfinite(value)) << name;
}

TEST_F(MeshFiles, GlbHasTangents)
{
    pose_text("mesh.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "property float nx\nproperty float ny\nproperty float nz\nproperty float tx\nproperty float ty\n"
              "property float tz\nproperty float tw\nelement face 1\nproperty list uchar int vertex_indices\n"
              "end_header\n0 0 0 0 0 1 2 0 0 -1\n1 0 0 0 0 1 0 1 0 1\n0 1 0 0 0 1 0 3 4 1\n3 0 1 2\n",
              ".glb");
    const Gltf gltf(folder_.path() / "all.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    EXPECT_EQ(gltf.floats(primitive.attributes.at("TANGENT")),
              (std::vector<float>{1, 0, 0, -1, 0, 1, 0, 1, 0, .6f, .8f, 1}));
}

// 4 million units from the origin a float has no digit below 1/4: the shape must survive, and the place.
TEST_F(MeshFiles, GlbFarFromTheOriginKeepsItsShape)
{
    pose(DATA + "utm_cube.obj", ".glb", {"--picture", "cube.svg"}, DATA + "rot.json");
    const Gltf gltf(folder_.path() / "all.glb");
    const tinygltf::Primitive &primitive = gltf.model.meshes.at(0).primitives.at(0);
    const std::vector<float> positions = gltf.floats(primitive.attributes.at("POSITION"));
    const auto &place = gltf.model.nodes.at(1);
    EXPECT_EQ(place.children, std::vector<int>{0});
    EXPECT_EQ(gltf.model.scenes.at(0).nodes, std::vector<int>{1});
    const std::vector<float> q = gltf.channel("rotation").second, t = gltf.channel("translation").second;
    const Vector v = gltf_transform(&q[4], &t[3], {positions[21], positions[22], positions[23]});
    EXPECT_NEAR(v[0] + place.translation.at(0), 388099.783254, 1e-5);
    EXPECT_NEAR(v[1] + place.translation.at(1), 3949010.116254, 1e-5);
    EXPECT_FALSE(has(folder_.read("cube.svg"), "nan"));
}

/* ---------------------------------------------------------------------------------------------------- remarks --- */

TEST_F(MeshFiles, FacesWithoutCornersAreKept)
{
    const std::string file = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                             "property float z\nelement face 1\nproperty int id\nend_header\n0 0 0\n7\n";
    const ToolResult result = pose_text("mesh.ply", file, ".ply");
    EXPECT_EQ(last(".ply"), file);
    EXPECT_TRUE(has(result.err, "the element \"face\" has no list vertex_indices of whole numbers")) << result.err;
}

TEST_F(MeshFiles, OtherElementsWithPositionsStayAndAreNamed)
{
    const std::string file = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                             "property float z\nelement target 1\nproperty float x\nproperty float y\n"
                             "property float z\nend_header\n0 0 0\n7 7 7\nmore\n";
    const ToolResult result = pose_text("mesh.ply", file, ".ply");
    EXPECT_EQ(last(".ply"), file);
    EXPECT_TRUE(has(result.out, "the element \"target\" has x, y and z too")) << result.out;
    EXPECT_TRUE(has(result.err, "5 bytes behind the last element")) << result.err;
}

TEST_F(MeshFiles, CompareCountsVerticesAsTheFileDoes)
{
    folder_.write("a.json", R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls": [{"steps": []},
        {"axis": [0, 0, 1], "degrees": 90}]})");
    folder_.write("cloud.obj", "v nan 0 0\nv 1 0 0\nv nan nan nan\nv 3 0 0\n");
    const ToolResult result =
        run_tool(folder_.path(), {"compare", "still.json", "a.json", "--mesh", "cloud.obj", "--samples", "2"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(has(result.out, "vertex 3 (counting from 0)")) << result.out;
    EXPECT_TRUE(has(result.err, "2 vertices with coordinates that are not finite")) << result.err;
}

} // namespace
} // namespace motorway::tool
