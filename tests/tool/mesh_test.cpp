// Reading and writing OBJ and PLY, normals and edges.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "error.h"
#include "files.h"
#include "mesh.h"
#include "normals.h"
#include "obj.h"
#include "ply.h"
#include "simplify.h"
#include "values.h"

namespace motorway::tool {
namespace {

using Numbers = std::vector<double>;
using Indices = std::vector<std::uint32_t>;

Pose at_rest(const Mesh &mesh)
{
    return {mesh.positions, mesh.normals, mesh.tangents, mesh.bitangents, mesh.face_normals};
}

TEST(Obj, ReadsEveryFormOfACorner)
{
    const Mesh mesh = read_obj("# comment\nv 0 0 0\nv 1 0 0 # x\nv 1 1 0 1.0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                               "f 1 2 3\nf 1/1 3/1 4/1\nf -4 -3 -2 -1\n",
                               "test");
    EXPECT_EQ(mesh.positions, (Numbers{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 0, 2, 3, 0, 1, 2, 3}));
    EXPECT_EQ(mesh.face_starts, (std::vector<std::size_t>{0, 3, 6, 10}));
    EXPECT_EQ(mesh.normals, (Numbers{0, 0, 1}));
    EXPECT_EQ(mesh.corner_normals, Indices(10, NONE)) << "no corner has a normal";
    EXPECT_EQ(mesh.corner_uvs, (Indices{NONE, NONE, NONE, 0, 0, 0, NONE, NONE, NONE, NONE}));
    EXPECT_TRUE(mesh.in_double);
}

TEST(Obj, ReadsNormalsByCorner)
{
    const Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nvn 1 0 0\n"
                               "f 1//2 2//1 3//-1\nf 1/1/1 2/1/1 3/1/2\n",
                               "test");
    EXPECT_EQ(mesh.normals, (Numbers{0, 0, 1, 1, 0, 0}));
    EXPECT_EQ(mesh.corner_normals, (Indices{1, 0, 1, 0, 0, 1}));
    EXPECT_EQ(mesh.corner_uvs, (Indices{NONE, NONE, NONE, 0, 0, 0}));
    EXPECT_TRUE(mesh.beyond.empty());
}

TEST(Obj, JoinsContinuedLinesAndTakesWindowsLineEnds)
{
    const Mesh mesh = read_obj("v 0 0 0\r\nv 1 0 \\\r\n 0\r\nv 0 1 0\r\nf 1 2 \\\r\n3\r\n", "test");
    EXPECT_EQ(mesh.positions, (Numbers{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2}));
}

TEST(Obj, LetsFacesComeBeforeTheirVertices)
{
    EXPECT_EQ(read_obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0", "test").corners, (Indices{0, 1, 2}));
}

TEST(Obj, ReadsBackWhatItWrites)
{
    Mesh mesh = read_obj("v 0.1 -2e-9 3\nv 16777217 0 0\nv 0 1 0.333333343\nv 1 1 1\nf 1 2 3\nf 1 2 4 3\n", "test");
    add_missing_normals(mesh);
    const Mesh again = read_obj(write_obj(mesh, at_rest(mesh)), "test");
    EXPECT_EQ(again.positions, mesh.positions);
    EXPECT_EQ(again.normals, mesh.normals);
    EXPECT_EQ(again.corners, mesh.corners);
    EXPECT_EQ(again.face_starts, mesh.face_starts);
}

TEST(Ply, ReadsAscii)
{
    const Mesh mesh = read_ply("ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float x\n"
                               "property float y\nproperty float z\nelement face 1\n"
                               "property list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0.1 1 0\n3 0 1 2",
                               "test");
    EXPECT_EQ(mesh.positions, (Numbers{0, 0, 0, 1, 0, 0, 0.1f, 1, 0}));
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2}));
    EXPECT_TRUE(mesh.beyond.empty());
}

TEST(Ply, ReadsPropertiesOfAnyOrderAndType)
{
    const Mesh mesh = read_ply("ply\r\nformat ascii 1.0\r\nelement camera 2\r\nproperty list uint double view\r\n"
                               "element empty 9999999999\r\nelement face 2\r\nproperty uchar red\r\n"
                               "property list ushort uint vertex_indices\r\nproperty list uchar float uv\r\n"
                               "element vertex 4\r\nproperty short z\r\nproperty list uchar uchar tags\r\n"
                               "property double y\r\nproperty float nz\r\nproperty int8 x\r\nproperty float nx\r\n"
                               "property float ny\r\nend_header\r\n2 0.5 0.5\r\n0\r\n7 3 0 1 2 6 0 0 1 0 0 1\r\n"
                               "8 4 0 1 2 3 0\r\n3 0 2.5 1 -1 0 0\r\n3 2 9 9 1.5 1 2 0 0\r\n3 0 0 1 4 0 0\r\n"
                               "5 1 1 2 0 -7 1 0\r\n",
                               "test");
    EXPECT_EQ(mesh.positions, (Numbers{-1, 2.5f, 3, 2, 1.5f, 3, 4, 0, 3, -7, 2, 5}));
    EXPECT_EQ(mesh.normals, (Numbers{0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0}));
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 0, 1, 2, 3}));
    EXPECT_EQ(mesh.face_starts, (std::vector<std::size_t>{0, 3, 7}));
    EXPECT_EQ(mesh.beyond, (std::vector<std::string>{"element \"camera\"", "element \"empty\"", "face \"red\"",
                                                       "face \"uv\"", "vertex \"tags\""}));
}

class PlyBinary : public ::testing::TestWithParam<bool> {};

TEST_P(PlyBinary, ReadsPropertiesOfAnyOrderAndType)
{
    const bool big = GetParam();
    std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty uchar red\nproperty double z\nproperty int16 y\n"
                       "property list int float extra\nproperty float x\nelement other 2\nproperty int value\n"
                       "element face 1\nproperty list uint16 int32 vertex_indices\nproperty uchar flag\nend_header\n";
    for (int i = 0; i < 3; ++i) {
        file += bytes<std::uint8_t>(static_cast<std::uint8_t>(200 + i), big) + bytes<double>(i + 0.25, big) +
                bytes<std::int16_t>(static_cast<std::int16_t>(-300 * i), big) + bytes<std::int32_t>(i, big);
        for (int k = 0; k < i; ++k)
            file += bytes<float>(9.5f, big);
        file += bytes<float>(0.1f * static_cast<float>(i), big);
    }
    file +=
        bytes<std::int32_t>(10, big) + bytes<std::int32_t>(13, big); /* 10 and 13: bytes that look like line ends */
    file += bytes<std::uint16_t>(3, big) + bytes<std::int32_t>(2, big) + bytes<std::int32_t>(0, big) +
            bytes<std::int32_t>(1, big) + bytes<std::uint8_t>(1, big);
    const Mesh mesh = read_ply(file, "test");
    EXPECT_EQ(mesh.positions, (Numbers{0, 0, 0.25f, 0.1f, -300, 1.25f, 0.2f, -600, 2.25f}));
    EXPECT_EQ(mesh.corners, (Indices{2, 0, 1}));
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_THROW(read_ply(file.substr(0, size), "test"), Error) << "cut off after " << size << " bytes";
}

INSTANTIATE_TEST_SUITE_P(, PlyBinary, ::testing::Bool(),
                         [](const auto &byte_order) { return byte_order.param ? "BigEndian" : "LittleEndian"; });

TEST(Ply, ReadsBackWhatItWrites)
{
    Mesh mesh = read_obj("v 0.1 -2e-9 3\nv 16777217 0 0\nv 0 1 0.333333343\nv 1 1 1\nf 1 2 3\nf 1 2 4 3\n", "test");
    add_missing_normals(mesh);
    const Mesh again = read_ply(write_ply(mesh, at_rest(mesh)), "test");
    EXPECT_EQ(again.positions, mesh.positions);
    EXPECT_EQ(again.normals, mesh.normals);
    EXPECT_EQ(again.corners, mesh.corners);
    EXPECT_EQ(again.face_starts, mesh.face_starts);
}

TEST(Ply, WritesFacesOfManyCorners)
{
    Mesh mesh;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const double angle = i * 2 * std::acos(-1.0) / 300;
        for (double coordinate : {std::cos(angle), std::sin(angle), 0.0})
            mesh.positions.push_back(coordinate);
        mesh.corners.push_back(i);
    }
    mesh.face_starts.push_back(300);
    add_missing_normals(mesh);
    EXPECT_EQ(read_ply(write_ply(mesh, at_rest(mesh)), "test").corners, mesh.corners);
}

TEST(Bunny, HasTheCountsOfItsSource)
{
    const Mesh bunny = read_mesh(std::string(MOTORWAY_EXAMPLES) + "/data/bunny.ply");
    EXPECT_EQ(bunny.vertex_count(), 1839u);
    EXPECT_EQ(bunny.face_count(), 3674u);
    EXPECT_EQ(bunny.corners.size(), 3u * 3674u);
    EXPECT_EQ(edges(bunny).size(), 5511u) << "a closed surface of genus 0: vertices - edges + faces = 2";
    EXPECT_EQ(bunny.positions[0], 1.301895f);
    EXPECT_EQ(bunny.positions[2], 2.550061f);
    EXPECT_EQ((Indices{bunny.corners[0], bunny.corners[1], bunny.corners[2]}), (Indices{2, 1661, 3}));
}

TEST(Normals, AreWeightedByArea)
{
    // Vertex 0 has a square of area 4 in the plane z = 0 and a triangle of area 1/2 in the plane x = 0.
    Mesh mesh =
        read_obj("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 -1 0\nv 0 0 1\nv 9 9 9\nf 1 2 3 4\nf 1 5 6\n", "test");
    add_missing_normals(mesh);
    const double size = std::hypot(8.0, 1.0);
    EXPECT_NEAR(mesh.normals[0], -1 / size, 1e-7);
    EXPECT_NEAR(mesh.normals[1], 0, 1e-7);
    EXPECT_NEAR(mesh.normals[2], 8 / size, 1e-7);
    EXPECT_EQ((Numbers{mesh.normals.begin() + 6, mesh.normals.begin() + 9}), (Numbers{0, 0, 1}));
    EXPECT_EQ((Numbers{mesh.normals.begin() + 18, mesh.normals.end()}), (Numbers{0, 0, 1}))
        << "of a vertex without faces";
}

TEST(Normals, OfAConcavePolygonPointTheRightWay)
{
    Mesh mesh = read_obj("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 2 3 4 1\nf 3 4 1 2\n", "test");
    add_missing_normals(mesh);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(mesh.normals[3 * i + 2], 1) << "vertex " << i;
}

TEST(Normals, OfTheFileAreKept)
{
    Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n", "test");
    add_missing_normals(mesh);
    EXPECT_EQ(mesh.normals, (Numbers{0, 0, -1}));
}

TEST(Normals, ByVertexAreTheMeanOfThoseByCorner)
{
    const Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\n"
                               "f 1//2 3//2 4//2\n",
                               "test");
    const Numbers normals = vertex_normals(mesh, mesh.normals);
    const double half = std::sqrt(0.5);
    const Numbers expected = {half, 0, half, 0, 0, 1, half, 0, half, 1, 0, 0};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(normals.at(i), expected[i], 1e-15);
}

TEST(Edges, AreThereOnce)
{
    const Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 3 4 1\nf 1 2 3 4\n", "test");
    EXPECT_EQ(edges(mesh), (std::vector<Edge>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}));
}

TEST(Simplified, KeepsTheShapeAndTheLimit)
{
    Mesh bunny = read_mesh(std::string(MOTORWAY_EXAMPLES) + "/data/bunny.ply");
    add_missing_normals(bunny);
    EXPECT_EQ(simplified(bunny, 3674).positions, bunny.positions);
    const Mesh coarse = simplified(bunny, 1000);
    EXPECT_LE(coarse.face_count(), 1000u);
    EXPECT_GT(coarse.face_count(), 300u);
    EXPECT_NEAR(bounding_box(coarse).diagonal(), bounding_box(bunny).diagonal(),
                0.1 * bounding_box(bunny).diagonal());
    for (std::uint32_t corner : coarse.corners)
        EXPECT_LT(corner, coarse.vertex_count());
}

} // namespace
} // namespace motorway::tool
