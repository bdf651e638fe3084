// A mesh that is written in its own format is the file that was read with other positions, normals and tangents.

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh.h"
#include "obj.h"
#include "ply.h"
#include "pose.h"
#include "posed_file.h"
#include "values.h"

namespace motorway::tool {
namespace {

// Half a turn about the z axis, and then (10, 20, 30): of small whole numbers every result is exact.
constexpr mw_motor_f64 HALF_TURN = {0, 1, 0, 0, 0, 0, 0, 0};

mw_motor_f64 half_turn_and_shift()
{
    const double offset[3] = {10, 20, 30};
    mw_motor_f64 shift, both;
    EXPECT_EQ(mw_translation_f64(&shift, offset), MW_OK);
    EXPECT_EQ(mw_compose_motor_each_f64(&both, sizeof both,
                                        &HALF_TURN, sizeof HALF_TURN,
                                        &shift, sizeof shift, 1),
              MW_OK);
    return both;
}

std::string posed(const Mesh &mesh, const std::string &kind)
{
    Pose pose;
    pose_mesh(pose, mesh, half_turn_and_shift());
    return write_posed(mesh, pose, kind);
}

std::string posed_obj(const std::string &contents)
{
    return posed(read_obj(contents, "test"), ".obj");
}

std::string posed_ply(const std::string &contents)
{
    return posed(read_ply(contents, "test"), ".ply");
}

TEST(ObjRoundTrip, ChangesNothingButNumbers)
{
    const std::string before = "# made by hand\n\nmtllib a b.mtl\no cube #1\n"
                               "v 1 2 3\n  v\t4  5 \t6   # a comment\nv 1 2 3 0.5\nv 1 2 3 1 .50 0\n"
                               "vt 0.250 1\nvt 0 0 0\nvn 1 2 3\n"
                               "g left \\\n  right\ns off\nusemtl red\nf 1/1/1 2//1 3 4/2\nvp 1 2\n"
                               "l 1 2 3\np 1\nf -1 -2 -3\nv 1 \\\n 2 \\\n 3\nunknown 1 2 3\nv 7 8 9";
    const std::string after = "# made by hand\n\nmtllib a b.mtl\no cube #1\n"
                              "v 9 18 33\n  v\t6  15 \t36   # a comment\nv 9 18 33 0.5\nv 9 18 33 1 .50 0\n"
                              "vt 0.250 1\nvt 0 0 0\nvn -1 -2 3\n"
                              "g left \\\n  right\ns off\nusemtl red\nf 1/1/1 2//1 3 4/2\nvp 1 2\n"
                              "l 1 2 3\np 1\nf -1 -2 -3\nv 9 \\\n 18 \\\n 33\nunknown 1 2 3\nv 3 12 39";
    EXPECT_EQ(posed_obj(before), after);
}

TEST(ObjRoundTrip, KeepsLineEnds)
{
    EXPECT_EQ(posed_obj("v 1 2 3\r\n\r\n# x\r\nv 4 5 6\r\n"), "v 9 18 33\r\n\r\n# x\r\nv 6 15 36\r\n");
    EXPECT_EQ(posed_obj("v 1 2 3\r\r# x\rv 4 5 6"), "v 9 18 33\r\r# x\rv 6 15 36");
    EXPECT_EQ(posed_obj("v 1 2 3\r\nv 4 5 6\n# x\r"), "v 9 18 33\nv 6 15 36\n# x\n") << "unless they are mixed";
    EXPECT_EQ(posed_obj("\xef\xbb\xbfv 1 2 3\n"), "v 9 18 33\n") << "and a byte order mark goes";
}

TEST(ObjRoundTrip, JoinsNumbersThatABackslashParts)
{
    EXPECT_EQ(posed_obj("v 1\\\n2\\ \n3\n"), "v 9\\\n18\\ \n33\n");
    EXPECT_EQ(posed_obj("v 1 2 3 \\"), "v 9 18 33 \\") << "at the end of the file";
    EXPECT_EQ(posed_obj("# no joint \\\nv 1 2 3\n"), "# no joint \\\nv 9 18 33\n") << "a comment ends with its line";
}

TEST(ObjRoundTrip, WritesEveryDigit)
{
    const Mesh mesh = read_obj("v 388096.123 3948996.456 0.1\nv 1e-300 4e-320 1e300\n", "test");
    const Pose pose = {mesh.positions, {}, {}, {}, {}};
    EXPECT_EQ(write_posed(mesh, pose, ".obj"), "v 388096.123 3948996.456 0.1\nv 1e-300 4e-320 1e+300\n");
}

TEST(ObjRoundTrip, KeepsWhatIsNoNumberInItsPoint)
{
    EXPECT_EQ(posed_obj("v nan nan nan\nv 1 2 3\n"), "v nan nan nan\nv 9 18 33\n");
    EXPECT_EQ(posed_obj("v 1 NaN 3\nv 1 2 3\n"), "v nan nan nan\nv 9 18 33\n");
}

TEST(ObjRoundTrip, KeepsNormalsThatNoCornerHas)
{
    EXPECT_EQ(posed_obj("v 1 2 3\nv 1 2 4\nv 2 2 3\nvn 1 2 3\nf 1 2 3\n"),
              "v 9 18 33\nv 9 18 34\nv 8 18 33\nvn -1 -2 3\nf 1 2 3\n");
}

const char *const PLY_VERTEX = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";

TEST(PlyRoundTrip, ChangesNothingButNumbers)
{
    const std::string header = "ply\nformat ascii 1.0\ncomment by  hand\nobj_info  7 \nelement camera 1\n"
                               "property float view\nelement vertex 2\nproperty uchar red\n"
                               "property list uchar int tags\nproperty float x\nproperty double nx\nproperty double y\n"
                               "property float ny\nproperty float z\nproperty float nz\nproperty float intensity\n"
                               "element face 1\nproperty list uchar int vertex_indices\nproperty short label\n"
                               "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty uchar sharp\n"
                               "element nothing 7\nelement none 0\nproperty int value\nend_header\n";
    EXPECT_EQ(posed_ply(header + "1.50\n255 2  7 8\t1 1 2 2 3 3 0.250\n0 0 4 0 5 0 6 1 nan\n2 0 1 -7\n0 1 001\n\n"),
              header + "1.50\n255 2  7 8\t9 -1 18 -2 33 3 0.250\n0 0 6 0 15 0 36 1 nan\n2 0 1 -7\n0 1 001\n\n");
}

TEST(PlyRoundTrip, MovesTangentsAndNoOtherVectors)
{
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                               "property float z\nproperty float tx\nproperty float ty\nproperty float tz\n"
                               "property float tw\nproperty float bitangent_x\nproperty float bitangent_y\n"
                               "property float bitangent_z\nproperty float vx\nproperty float vy\n"
                               "property float vz\nproperty float nx\nproperty float nz\nend_header\n";
    EXPECT_EQ(posed_ply(header + "1 2 3 4 5 6 -1 1 1 1 7 8 9 1 1\n"),
              header + "9 18 33 -4 -5 6 -1 -1 -1 1 7 8 9 1 1\n");
}

TEST(PlyRoundTrip, MovesTheNormalsOfFaces)
{
    const std::string before = std::string("ply\nformat ascii 1.0\nelement face 2\nproperty float nx\n"
                                           "property list uchar int vertex_indices\nproperty float ny\n"
                                           "property char nz\n") +
                               PLY_VERTEX + "end_header\n1 2 0 1 2 3\n4 2 1 0 5 6\n1 2 3\n4 5 6\n";
    const std::string after = std::string("ply\nformat ascii 1.0\nelement face 2\nproperty float nx\n"
                                    "property list uchar int vertex_indices\nproperty float ny\n"
                                    "property double nz\n") +
                        PLY_VERTEX + "end_header\n-1 2 0 1 -2 3\n-4 2 1 0 -5 6\n9 18 33\n6 15 36\n";
    EXPECT_EQ(posed_ply(before), after);
}

TEST(PlyRoundTrip, KeepsLineEnds)
{
    const std::string file = std::string("ply\nformat ascii 1.0\n") + PLY_VERTEX + "end_header\n";
    for (const char *line_end : {"\r\n", "\r", "\n"}) {
        const auto with = [&](std::string text) {
            for (std::size_t at = text.find('\n'); at != std::string::npos;
                 at = text.find('\n', at + std::strlen(line_end)))
                text.replace(at, 1, line_end);
            return text;
        };
        EXPECT_EQ(posed_ply(with(file + "1 2 3\n4 5 6\n")), with(file + "9 18 33\n6 15 36\n"));
    }
}

// A number is written in its own precision: the sums below need more digits than a float has.
TEST(PlyRoundTrip, KeepsPrecision)
{
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
                               "property float z\nend_header\n";
    EXPECT_EQ(posed_ply(header + "-388086.123 -3948976.456 0.1\n"), header + "388096.123 3948996.456 30.1\n");
}

TEST(PlyRoundTrip, WritesWholeNumbersAsDoubles)
{
    const std::string before = "ply\nformat ascii 1.0\nelement vertex 1\nproperty  short x\nproperty short";
    const std::string after = "ply\nformat ascii 1.0\nelement vertex 1\nproperty  double x\nproperty short";
    const Mesh mesh = read_ply(before + " red\nproperty int y\nproperty double z\nend_header\n-1 7 2 0.5\n", "test");
    EXPECT_EQ(posed(mesh, ".ply"),
              after + " red\nproperty double y\nproperty double z\nend_header\n11 7 18 30.5\n");
    ASSERT_EQ(mesh.notes.size(), 1u);
    EXPECT_EQ(mesh.notes[0], "whole numbers that a pose cannot stay in, written as double: x, y");
}

class PlyBinaryRoundTrip : public ::testing::TestWithParam<bool> {};

TEST_P(PlyBinaryRoundTrip, ChangesNothingButNumbers)
{
    const bool big = GetParam();
    const auto file = [&](const char *short_type, bool is_posed) {
        std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                           "_endian 1.0\ncomment \xff\xfe\nelement vertex 2\nproperty uchar red\nproperty double z\n"
                           "property list ushort float extra\nproperty " +
                           short_type + " y\nproperty float x\nproperty int64 id\nelement face 1\n"
                           "property list int uint vertex_indices\nend_header\n";
        for (std::uint16_t i = 0; i < 2; ++i) {
            const double x = 0.25 + i, y = i, z = 3;
            text += bytes<std::uint8_t>(0x0d, big) + bytes(is_posed ? 30 + z : z, big) + bytes(i, big);
            text += i ? bytes(9.5f, big) : "";
            text += is_posed ? bytes(20 - y, big) : bytes<std::int16_t>(static_cast<std::int16_t>(i), big);
            text += bytes(static_cast<float>(is_posed ? 10 - x : x), big) + bytes<std::int64_t>(-7, big);
        }
        return text + bytes<std::int32_t>(2, big) + bytes<std::uint32_t>(0, big) + bytes<std::uint32_t>(1, big) +
               "trailing\r\n";
    };
    const Mesh mesh = read_ply(file("short", false), "test");
    EXPECT_EQ(posed(mesh, ".ply"), file("double", true));
    EXPECT_EQ(mesh.face_count(), 0u);
    EXPECT_EQ(mesh.warnings.size(), 2u) << "of a face with two corners, and of what follows";
}

INSTANTIATE_TEST_SUITE_P(, PlyBinaryRoundTrip, ::testing::Bool(),
                         [](const auto &byte_order) { return byte_order.param ? "BigEndian" : "LittleEndian"; });

// The data may begin with a byte that would belong to the line end of another header.
TEST(PlyRoundTrip, FindsTheDataBehindAnyLineEnd)
{
    for (const std::string line_end : {"\n", "\r\n", "\r"})
        for (const char first : {'\n', '\r', '\0'}) {
            std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar c\n"
                                 "property float x\nproperty float y\nproperty float z\nend_header\n";
            for (std::size_t at = header.find('\n'); at != std::string::npos;
                 at = header.find('\n', at + line_end.size()))
                header.replace(at, 1, line_end);
            const auto vector = [](float x, float y, float z) {
                return bytes(x, false) + bytes(y, false) + bytes(z, false);
            };
            EXPECT_EQ(posed_ply(header + first + vector(1, 2, 3)), header + first + vector(9, 18, 33));
        }
}

TEST(PlyRoundTrip, TakesAHeaderThatMixesLineEnds)
{
    const std::string vertex = "property float x\nproperty float y\r\nproperty float z\r";
    EXPECT_EQ(posed_ply("ply\rformat ascii 1.0\relement vertex 1\n" + vertex + "end_header\n1 2 3\rend_header\r"),
              "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
              "end_header\n9 18 33\nend_header\n");
}

TEST(PlyRoundTrip, KeepsNotANumberInItsPoint)
{
    const std::string header = std::string("ply\nformat ascii 1.0\n") + PLY_VERTEX + "end_header\n";
    EXPECT_EQ(posed_ply(header + "nan NaN -nan\n1 2 3\n"), header + "nan nan nan\n9 18 33\n");
}

} // namespace
} // namespace motorway::tool
