// Mesh files with random damage: each is refused with one line, or read, posed and written so that it reads back.

#include <cmath>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "error.h"
#include "files.h"
#include "glb.h"
#include "mesh.h"
#include "motion_file.h"
#include "normals.h"
#include "obj.h"
#include "ply.h"
#include "pose.h"
#include "posed_file.h"

namespace motorway::tool {
namespace {

const char *const WORDS[] = {"-1", "0", "nan", "1e400", "1e-320", "4294967295", "99999999999", "\\\n", "\r", "\n", "//",
                             "#", " ", "element vertex 1000000\n", "property list uchar int a\n",
                             "property double x\n", "end_header\n", "ascii", "binary_big_endian", "int64", "uchar",
                             "tristrips", "edge", "texcoord", "f 1 2 3\n", "l 1 -1\n", "v 1 2 3 4 5 6 7\n",
                             "vn 1 2 3\n", "\xef\xbb\xbf"};

class Damage {
public:
    explicit Damage(unsigned seed) : random_(seed) {}

    std::string operator()(std::string file)
    {
        for (std::size_t k = below(3) + 1; k > 0 && !file.empty(); --k) {
            const std::size_t at = below(file.size());
            const std::string word = WORDS[below(std::size(WORDS))];
            switch (below(6)) {
            case 0:
                file[at] = static_cast<char>(below(256));
                break;
            case 1:
                file.erase(at, below(20));
                break;
            case 2:
                file.insert(at, word);
                break;
            case 3:
                file.replace(at, below(5), word);
                break;
            case 4:
                file.insert(at, file.substr(below(file.size()), below(60)));
                break;
            default:
                file.replace(at, 4, "\xff\xff\xff\xff");
            }
        }
        return file;
    }

private:
    std::size_t below(std::size_t end) { return random_() % end; }

    std::mt19937 random_; /* whose numbers are the same everywhere */
};

Mesh read(const std::string &contents, const std::string &kind)
{
    return kind == ".obj" ? read_obj(contents, "damaged") : read_ply(contents, "damaged");
}

bool same_number(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b)) || static_cast<float>(a) == static_cast<float>(b);
}

void expect_same(const Mesh &mesh, const Mesh &again, const Pose &pose, const std::string &file)
{
    ASSERT_EQ(again.positions.size(), pose.positions.size()) << file;
    for (std::size_t i = 0; i < pose.positions.size(); ++i)
        ASSERT_TRUE(same_number(again.positions[i], pose.positions[i])) << i << " of\n" << file;
    EXPECT_EQ(again.corners, mesh.corners) << file;
    EXPECT_EQ(again.lines, mesh.lines) << file;
}

/* Whether the file could be read. */
bool survives(const std::string &file, const std::string &kind, const std::vector<mw_motor_f64> &motors)
{
    try {
        const Mesh mesh = read(file, kind);
        if (mesh.vertex_count() == 0)
            return false;
        Pose pose;
        pose_mesh(pose, mesh, motors[1]);
        check_finite(pose, mesh, "damaged");
        expect_same(mesh, read(write_posed(mesh, pose, kind), kind), pose, file);
        const std::string other = kind == ".obj" ? ".ply" : ".obj";
        expect_same(mesh, read(write_posed(mesh, pose, other), other), pose, file);
        Mesh drawn = finite_part(mesh);
        add_missing_normals(drawn);
        if (drawn.vertex_count() > 0)
            write_glb(drawn, motors, 30, "damaged");
        return true;
    } catch (const Error &error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return false;
    }
}

TEST(MutatedMeshes, AreRefusedOrReadBack)
{
    const Motion motion = parse_motion(R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls":
        [{"steps": []}, {"axis": [1, 2, 1], "degrees": 30, "translate": [5, 6, 7]}]})", "test");
    const std::vector<mw_motor_f64> motors = sample(motion, even_parameters(motion, 2), "test");
    constexpr std::size_t EACH = 150;
    std::size_t read_count = 0, file_count = 0;
    Damage damage(1);
    const std::filesystem::directory_iterator folder(MOTORWAY_TEST_DATA);
    for (const std::filesystem::path &path : std::set<std::filesystem::path>(begin(folder), end(folder))) {
        const std::string kind = path.extension().string();
        if (kind != ".obj" && kind != ".ply")
            continue;
        ++file_count;
        const std::string file = read_file(path.string());
        for (std::size_t k = 0; k < EACH && !HasFailure(); ++k)
            read_count += survives(damage(file), kind, motors);
    }
    EXPECT_GT(file_count, 15u);
    EXPECT_GT(read_count, EACH * file_count / 10) << "the damage is not so great that nothing is tested";
}

// Of a file that claims more than it has, nothing is allocated.
TEST(MutatedMeshes, CountsThatCannotBeAreRefusedAtOnce)
{
    const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
    for (const char *format : {"ascii", "binary_little_endian", "binary_big_endian"})
        for (const char *count : {"1000000000", "4294967296", "9223372036854775807"}) {
            const std::string start = std::string("ply\nformat ") + format + " 1.0\n";
            EXPECT_THROW(read_ply(start + "element vertex " + count + "\n" + vertices + "end_header\n0 0 0\n", "test"),
                         Error);
            EXPECT_THROW(read_ply(start + "element vertex 0\n" + vertices + "element a " + count +
                                      "\nproperty list int int b\nend_header\n0 0 0\n",
                                  "test"),
                         Error);
        }
}

} // namespace
} // namespace motorway::tool
