// Bad input, case by case: exit code 2, one line that says where, and nothing written.

#include <algorithm>
#include <map>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "run_tool.h"

namespace motorway::tool {
namespace {

using Files = std::map<std::string, std::string>;

struct BadInput {
    std::string name;
    Files files;                        /* besides the good ones below, or instead of them */
    std::vector<std::string> arguments; /* instead of the usual ones, if there are any */
    std::string expected;               /* how the message begins, after "motorway: error: " */
    std::string also = "";              /* what else it says */
    ToolLimits limits = {};
};

void PrintTo(const BadInput &bad, std::ostream *out)
{
    *out << bad.name;
}

const std::string GOOD_OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string GOOD_MOTION = R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []}, {"steps": []}]})";
const std::string PLY_VERTICES = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string PLY_FACES = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string PLY_HEADER = "ply\nformat ascii 1.0\n" + PLY_VERTICES + PLY_FACES; /* 9 lines */

BadInput obj(const std::string &name, const std::string &contents, const std::string &expected,
             const std::string &also = "")
{
    return {"Obj" + name, {{"mesh.obj", contents}}, {}, expected, also};
}

BadInput ply(const std::string &name, const std::string &contents, const std::string &expected,
             const std::string &also = "")
{
    return {"Ply" + name,
            {{"mesh.ply", contents}},
            {"pose", "mesh.ply", "--motion", "motion.json", "--frames", "3", "--out", "out.glb"},
            expected,
            also};
}

BadInput motion(const std::string &name, const std::string &contents, const std::string &expected,
                const std::string &also = "")
{
    return {"Motion" + name, {{"motion.json", contents}}, {}, expected, also};
}

/* A motion whose first control is this. */
BadInput control(const std::string &name, const std::string &contents, const std::string &expected,
                 const std::string &also = "")
{
    return motion("Control" + name,
                  R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls": [)" + contents +
                      R"(, {"steps": []}]})",
                  expected, also);
}

/* A motion of four poses at rest, which are in the third line, with these fields in the second. */
BadInput scheme(const std::string &name, const std::string &fields, const std::string &expected,
                const std::string &also = "", const std::string &poses = "controls")
{
    return motion("Scheme" + name,
                  "{\"motorway\": 2,\n" + fields + ",\n\"" + poses +
                      R"(": [{"steps": []}, {"steps": []}, {"steps": []}, {"steps": []}]})",
                  expected, also);
}

BadInput keys(const std::string &name, const std::string &fields, const std::string &expected,
              const std::string &also = "")
{
    return scheme("Keys" + name, fields, expected, also, "keys");
}

BadInput knots(const std::string &name, const std::string &degree_and_knots, const std::string &expected,
               const std::string &also = "")
{
    return scheme("Knots" + name, R"("scheme": "additive", )" + degree_and_knots, expected, also);
}

BadInput options(const std::string &name, const std::vector<std::string> &arguments, const std::string &expected,
                 const std::string &also = "")
{
    return {name, {}, arguments, expected, also};
}

std::vector<std::string> pose(const std::string &frames, const std::string &out, std::vector<std::string> more = {})
{
    std::vector<std::string> arguments = {"pose",     "mesh.obj", "--motion", "motion.json",
                                          "--frames", frames,     "--out",    out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::string floats(std::initializer_list<const char *> patterns)
{
    std::string bytes;
    for (const char *pattern : patterns)
        bytes.append(pattern, 4);
    return bytes;
}

std::vector<BadInput> obj_cases()
{
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    return {
        obj("Empty", "", "mesh.obj: has no vertices"),
        obj("TruncatedVertex", "v 0 0 0\nv 1 0\n", "mesh.obj:2: a vertex needs 3 numbers", "truncated"),
        obj("NotANumber", "v 0 0 0\nv 1 zwei 0\n", "mesh.obj:2: \"zwei\" is not a number"),
        obj("HalfANumber", "v 0 0 0\nv 1 2x 0\n", "mesh.obj:2: \"2x\" is not a number"),
        obj("FacePastTheLastVertex", three + "f 1 2 3\nf 1 2 4\n", "mesh.obj:5: the face has vertex 4",
            "the last is 3"),
        obj("FaceBeforeTheFirstVertex", three + "f 1 2 -4\n", "mesh.obj:4: the face has vertex -4"),
        obj("FacePastTheLastNormal", three + "vn 0 0 1\nf 1//1 2//1 3//2\n", "mesh.obj:5: the face has normal 2"),
        obj("FaceAtZero", three + "f 0 1 2\n", "mesh.obj:4: the corner \"0\" has no vertex number"),
        obj("FaceFarPastTheLastVertex", three + "f 1 2 9223372036854775807\n",
            "mesh.obj:4: the face has vertex 9223372036854775807"),
        obj("FaceBeyondAnyNumber", three + "f 1 2 99999999999999999999\n", "mesh.obj:4: the corner "),
        obj("FaceFarBeforeTheFirst", three + "f 1 2 -9223372036854775808\n", "mesh.obj:4: the face has vertex -92"),
        obj("FaceWithManySlashes", three + "f 1/1/1/1 2 3\n", "mesh.obj:4: \"1/1/1/1\" has too many slashes"),
        obj("FaceOfWords", three + "f a b c\n", "mesh.obj:4: the corner \"a\""),
        obj("Garbage",
            std::string("\x7f"
                        "ELF\0\1\2\nxyz",
                        11),
            "mesh.obj: has no vertices", "an OBJ file"),
        obj("Utf16", std::string("\xff\xfev\0 \0", 6), "mesh.obj: is written in UTF-16", "UTF-8"),
        obj("VertexTooLarge", "v 0 1e400 0\n", "mesh.obj:1: \"1e400\" is too large for a double"),
        obj("NormalTooLarge", three + "vn 0 -1e400 0\n", "mesh.obj:4: \"-1e400\" is too large for a double"),
        obj("VertexWithANul", std::string("v 0 1\0 2\n", 10), "mesh.obj:1: \"1?\" is not a number"),
        obj("NothingFinite", "v nan 0 0\nv 0 inf 0\n", "mesh.obj: has no vertex whose coordinates are finite"),
        obj("TooLargeForGlb", "v 1e39 0 0\n" + three, "out.glb: the mesh is too large for the floats of a .glb"),
        obj("LineAfterContinuation", three + "f 1 \\\n 2 3\nf 1 2 9\n", "mesh.obj:6: the face has vertex 9"),
    };
}

std::vector<BadInput> ply_cases()
{
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string little = "ply\nformat binary_little_endian 1.0\n" + PLY_VERTICES + PLY_FACES;
    const std::string big = "ply\nformat binary_big_endian 1.0\n" + PLY_VERTICES + PLY_FACES;
    const std::string zeros(36, '\0'), face("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    const std::string not_a_number = floats({"\0\0\0\0", "\0\0\xc0\x7f", "\0\0\0\0"}) + std::string(24, '\0');
    return {
        ply("Empty", "", "mesh.ply:1: does not begin with \"ply\""),
        ply("SomethingElse", "solid cube\nfacet\n", "mesh.ply:1: does not begin with \"ply\""),
        ply("HeaderWithoutEnd", "ply\nformat ascii 1.0\nelement vertex 3\n",
            "mesh.ply:3: the header has no \"end_header\"", "truncated"),
        ply("NoFormat", "ply\n" + PLY_VERTICES + PLY_FACES + vertices, "mesh.ply:8: the header has no \"format\""),
        ply("UnknownFormat", "ply\nformat ebcdic 1.0\n", "mesh.ply:2: unknown format"),
        ply("UnknownKeyword", "ply\nformat ascii 1.0\nelephant vertex 3\n", "mesh.ply:3: \"elephant\""),
        ply("UnknownType", "ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n",
            "mesh.ply:4: unknown type \"quad\""),
        ply("PropertyWithoutElement", "ply\nformat ascii 1.0\nproperty float x\n", "mesh.ply:3: a property before"),
        ply("NegativeCount", "ply\nformat ascii 1.0\nelement vertex -3\n", "mesh.ply:3: an element needs"),
        ply("PropertyTwice", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty int x\n",
            "mesh.ply:5: a second property \"x\""),
        ply("ElementTwice", "ply\nformat ascii 1.0\nelement vertex 3\nelement vertex 3\n",
            "mesh.ply:4: a second element \"vertex\""),
        ply("HugeCount",
            "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000000\nproperty float x\n"
            "property float y\nproperty float z\n" +
                PLY_FACES + zeros,
            "mesh.ply:3: 4000000000000 times \"vertex\" cannot be in the 36 bytes", "truncated"),
        ply("NoCoordinates",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float u\n" + PLY_FACES + "1\n3 0 0 0\n",
            "mesh.ply:3: the vertices have no x, y and z"),
        ply("NoVertices",
            "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
            "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
            "mesh.ply: has no vertices"),
        ply("Truncated", PLY_HEADER + "0 0 0\n1 0 0\n0 1 0\n3 0 1", "mesh.ply:13: in face 0", "truncated"),
        ply("TruncatedVertices", PLY_HEADER + "0 0 0\n1 0 0 1 1 0", "mesh.ply:", "truncated"),
        ply("TruncatedBinary", little + zeros + face.substr(0, 9), "mesh.ply: in face 0", "truncated"),
        ply("TruncatedBigEndian", big + zeros + face.substr(0, 9), "mesh.ply: in face 0", "truncated"),
        ply("HugeList",
            "ply\nformat binary_little_endian 1.0\n" + PLY_VERTICES +
                "element face 1\nproperty list uint int vertex_indices\nend_header\n" + zeros + "\xff\xff\xff\xff" +
                std::string(12, '\0'),
            "mesh.ply: in face 0", "truncated"),
        ply("NegativeList",
            "ply\nformat ascii 1.0\n" + PLY_VERTICES +
                "element face 1\nproperty list int int vertex_indices\nend_header\n" + vertices + "-3 0 1 2\n",
            "mesh.ply:13: in face 0", "negative"),
        ply("FacePastTheLastVertex", PLY_HEADER + vertices + "3 0 1 3\n", "mesh.ply:13: face 0 has vertex 3"),
        ply("NegativeVertex", PLY_HEADER + vertices + "3 0 1 -1\n", "mesh.ply:13: in face 0", "vertex -1"),
        ply("BinaryFacePastTheLastVertex", big + zeros + std::string("\3\0\0\0\0\0\0\0\1\0\0\0\3", 13),
            "mesh.ply: face 0 has vertex 3"),
        ply("NotANumber", PLY_HEADER + "0 0 0\n1 zwei 0\n0 1 0\n3 0 1 2\n", "mesh.ply:11: in vertex 1",
            "\"zwei\" is not a number"),
        ply("VertexTooLarge", PLY_HEADER + "0 0 0\n1 0 1e39\n0 1 0\n3 0 1 2\n", "mesh.ply:11: in vertex 1",
            "\"1e39\" is too large for its type"),
        ply("NothingFinite", PLY_HEADER + "nan 0 0\ninf 0 0\n0 nan 0\n3 0 1 2\n",
            "mesh.ply: has no vertex whose coordinates are finite"),
        ply("StripPastTheLastVertex",
            "ply\nformat ascii 1.0\n" + PLY_VERTICES +
                "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + vertices + "4 0 1 2 3\n",
            "mesh.ply:13: face 0 has vertex 3"),
        ply("StripWithANegativeVertex",
            "ply\nformat ascii 1.0\n" + PLY_VERTICES +
                "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + vertices + "4 0 1 -1 -2\n",
            "mesh.ply:13: in tristrips 0", "vertex -2"),
        ply("NoVertexElement", "ply\nformat ascii 1.0\nelement point 1\nproperty float x\nend_header\n1\n",
            "mesh.ply: has no vertices"),
        ply("ListOfCoordinates",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float x\nproperty float y\n"
            "property float z\nend_header\n1 0 0 0\n",
            "mesh.ply:3: the vertices have no x, y and z"),
        {"PlyScaleBeyondFloat",
         {{"mesh.ply", PLY_HEADER + vertices + "3 0 1 2\n"}},
         {"pose", "mesh.ply", "--motion", "motion.json", "--frames", "3", "--out", "out.ply", "--scale", "1e39"},
         "mesh.ply: is too large for floats when it is scaled"},
    };
}

std::vector<BadInput> motion_cases()
{
    const std::string two = R"("controls": [{"steps": []}, {"steps": []}]})";
    return {
        motion("Empty", "", "motion.json:1:1: the file is empty"),
        motion("Truncated", "{\"motorway\": 1,\n\"kind\": \"linear\",\n\"controls\": [{\"steps\"",
               "motion.json:3:22: controls[0]: the file ends here", "the '{' of line 3 is open"),
        motion("NotAnObject", "[]", "motion.json:1: must be an object"),
        motion("KeyTwice", "{\"motorway\": 1, \"kind\": \"linear\",\n\"kind\": \"bezier\", \"controls\": []}",
               "motion.json:2:1: the key \"kind\" comes twice"),
        motion("KeyTwiceInside", "{\"motorway\": 2, \"controls\": [{},\n{\"motor\": 1, \"motor\": 2}]}",
               "motion.json:2:14: controls[1]: the key \"motor\" comes twice"),
        motion("NoVersion", R"({"kind": "linear", "controls": []})",
               "motion.json:1: the key \"motorway\" is missing"),
        motion("UnknownVersion", R"({"motorway": 3, "scheme": "additive", "degree": 1, )" + two,
               "motion.json:1: motorway: unknown version", "versions 1 and 2"),
        motion("NoScheme", R"({"motorway": 2, )" + two, "motion.json:1: the key \"scheme\" is missing"),
        motion("NoPoses", R"({"motorway": 2, "scheme": "additive", "degree": 1})",
               "motion.json:1: a motion has either \"controls\" or \"keys\""),
        motion("ControlsAndKeys", R"({"motorway": 2, "scheme": "additive", "degree": 1, "keys": [], )" + two,
               "motion.json:1: a motion has either \"controls\" or \"keys\""),
        motion("EmptyControls", R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls": []})",
               "motion.json:1: controls: there are 0, and degree 1 needs 2 or more"),
        motion("OneControl", R"({"motorway": 2, "scheme": "additive", "degree": 1, "controls": [{"steps": []}]})",
               "motion.json:1: controls: there are 1, and degree 1 needs 2 or more"),
        motion("CancellingControls",
               "{\"motorway\": 2, \"scheme\": \"additive\", \"degree\": 1, \"keep_signs\": true, \"controls\": [\n"
               "{\"steps\": []},\n{\"steps\": []},\n{\"motor\": [-1, 0, 0, 0, 0, 0, 0, 0]}]}",
               "motion.json:3: controls[1]: this control and the next one cancel", "leave out \"keep_signs\""),
        motion("Version1UnknownKey", "{\"motorway\": 1, \"kind\": \"linear\",\n\"speed\": 2, " + two,
               "motion.json:2: unknown key \"speed\""),
        motion("Version1WithAKeyOfVersion2", R"({"motorway": 1, "kind": "linear", "closed": true, )" + two,
               "motion.json:1: unknown key \"closed\""),
        motion("Version1NoKind", R"({"motorway": 1, )" + two, "motion.json:1: the key \"kind\" is missing"),
        motion("Version1UnknownKind", R"({"motorway": 1, "kind": "cubic", )" + two, "motion.json:1: kind: must be"),
        motion("Version1NoControls", R"({"motorway": 1, "kind": "linear"})",
               "motion.json:1: the key \"controls\" is missing"),
        motion("Version1EmptyControls", R"({"motorway": 1, "kind": "linear", "controls": []})",
               "motion.json:1: controls: holds 0 controls"),
        motion("Version1OneControl", R"({"motorway": 1, "kind": "bezier", "controls": [{"steps": []}]})",
               "motion.json:1: controls: holds 1 control"),
        motion("Version1NoKnots", R"({"motorway": 1, "kind": "bspline", "degree": 1, )" + two,
               "motion.json:1: the key \"knots\" is missing"),
        motion("Version1LinearWithKnots", R"({"motorway": 1, "kind": "linear", "knots": [0, 1], )" + two,
               "motion.json:1: unknown key \"knots\""),
        motion("Version1CancellingControls", R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []},
               {"motor": [-1, 0, 0, 0, 0, 0, 0, 0]}]})",
               "motion.json:1: controls[0]: this control and the next one cancel", "write version 2"),
    };
}

std::vector<BadInput> pose_cases()
{
    const std::string rotate = R"({"steps": [{"rotate": )";
    return {
        control("Nan", R"({"steps": [{"translate": [0, NaN, 0]}]})",
                "motion.json:1:94: controls[0].steps[0].translate[1]: \"NaN\" is no number"),
        control("Infinity", "{\"steps\": [\n{\"translate\": [Infinity, 0, 0]}]}",
                "motion.json:2:16: controls[0].steps[0].translate[0]: \"Infinity\" is no number"),
        control("NumberBeyondDouble", R"({"steps": [{"translate": [0, 0, 1e999]}]})",
                "motion.json:1:97: controls[0].steps[0].translate[2]: ", "too large"),
        control("NumberBeyondFloat", "{\"steps\": [\n{\"translate\": [0,\n0, 1e99\n]}]}",
                "motion.json:3: controls[0].steps[0].translate[2]: is too large"),
        control("PoseBeyondFloat", R"({"steps": [{"translate": [3e38, 0, 0]}, {"translate": [3e38, 0, 0]},
                {"translate": [3e38, 0, 0]}]})",
                "motion.json:1: controls[0]: the pose is too large"),
        control("NotAnObject", "5", "motion.json:1: controls[0]: must be an object"),
        control("WithNothing", "{}", "motion.json:1: controls[0]: a pose is one of"),
        control("WithBoth", R"({"steps": [], "motor": [1, 0, 0, 0, 0, 0, 0, 0]})",
                "motion.json:1: controls[0]: a pose is one of"),
        control("OfUnknownForm", "{\n\"euler\": [0, 0, 0]}", "motion.json:2: controls[0]: unknown key \"euler\""),
        control("UnknownStep", R"({"steps": [{"translate": [0, 0, 0]}, {"shear": 1}]})",
                "motion.json:1: controls[0].steps[1]: unknown key \"shear\""),
        control("StepWithBoth", R"({"steps": [{"translate": [0, 0, 0], "rotate": {}}]})",
                "motion.json:1: controls[0].steps[0]: a step is one"),
        control("TextForANumber", R"({"steps": [{"translate": ["0", 0, 0]}]})",
                "motion.json:1: controls[0].steps[0].translate[0]: must be a number"),
        control("NullForAList", R"({"steps": [{"translate": null}]})",
                "motion.json:1: controls[0].steps[0].translate: must be a list"),
        control("TwoCoordinates", R"({"steps": [{"translate": [0, 0]}]})",
                "motion.json:1: controls[0].steps[0].translate: must hold 3 numbers"),
        control("NoAngle", rotate + R"({"axis": [0, 0, 1]}}]})", "motion.json:1: controls[0].steps[0].rotate: needs"),
        control("TwoAngles", rotate + R"({"axis": [0, 0, 1], "degrees": 1, "radians": 1}}]})",
                "motion.json:1: controls[0].steps[0].rotate: needs"),
        control("NoAxis", rotate + R"({"degrees": 1}}]})",
                "motion.json:1: controls[0].steps[0].rotate: the key \"axis\" is missing"),
        control("AxisOfLengthZero", rotate + R"({"axis": [0, 0, 0], "degrees": 1}}]})",
                "motion.json:1: controls[0].steps[0].rotate.axis: has length zero"),
        control("AlongInAStep", rotate + R"({"axis": [0, 0, 1], "degrees": 1, "along": 1}}]})",
                "motion.json:1: controls[0].steps[0].rotate: unknown key \"along\""),
        control("SevenCoefficients", R"({"motor": [1, 0, 0, 0, 0, 0, 0]})",
                "motion.json:1: controls[0].motor: must hold 8 numbers"),
        control("AlphaOfZero", "{\n\"motor\": [0, 0, 0, 0, 1, 2, 3, 4]}",
                "motion.json:2: controls[0].motor: its first four numbers are zero"),
        control("MatrixOfTwoRows", R"({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0]]})",
                "motion.json:1: controls[0].matrix: must hold 3 or 4 rows of 4 numbers, and holds 2"),
        control("MatrixOfThreeColumns", "{\"matrix\": [[1, 0, 0, 0],\n[0, 1, 0], [0, 0, 1, 0]]}",
                "motion.json:2: controls[0].matrix[1]: must hold 4 numbers"),
        control("MatrixThatActsOnRows", R"({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [5, 6, 7, 1]]})",
                "motion.json:1: controls[0].matrix[3]: must be [0, 0, 0, 1]", "transpose"),
        control("MatrixWithScale", R"({"matrix": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]})",
                "motion.json:1: controls[0].matrix: its columns deviate by 3 from orthonormal ones"),
        control("MatrixThatReflects", R"({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0]]})",
                "motion.json:1: controls[0].matrix: is a reflection"),
        control("QuaternionOfThree", R"({"quaternion": [0, 0, 1]})",
                "motion.json:1: controls[0].quaternion: must hold 4 numbers"),
        control("QuaternionOfZero", R"({"quaternion": [0, 0, 0, 0], "translation": [1, 0, 0]})",
                "motion.json:1: controls[0].quaternion: has length zero"),
        control("QuaternionWithSteps", R"({"quaternion": [0, 0, 0, 1], "translate": [1, 0, 0]})",
                "motion.json:1: controls[0]: unknown key \"translate\"", "quaternion, translation"),
        control("TranslationAlone", R"({"translation": [1, 0, 0]})", "motion.json:1: controls[0]: a pose is one of"),
        control("AxisWithoutAnAngle", R"({"axis": [0, 0, 1], "along": 2})", "motion.json:1: controls[0]: needs"),
        control("AxisOfZero", R"({"axis": [0, 0, 0], "degrees": 20, "along": 2})",
                "motion.json:1: controls[0].axis: has length zero"),
        control("AxisWithATranslation", R"({"axis": [0, 0, 1], "degrees": 20, "translation": [1, 0, 0]})",
                "motion.json:1: controls[0]: unknown key \"translation\"", "translate"),
    };
}

std::vector<BadInput> scheme_cases()
{
    const std::string additive = R"("scheme": "additive", "degree": 2)";
    return {
        scheme("UnknownKey", additive + ", \n\"speed\": 2", "motion.json:3: unknown key \"speed\""),
        scheme("Unknown", R"("scheme": "spherical")", "motion.json:2: scheme: \"spherical\" is none",
               "multiplicative"),
        scheme("OfAnotherType", R"("scheme": 1)", "motion.json:2: scheme: must be a text"),
        scheme("KindOfVersion1", R"("kind": "linear")", "motion.json:2: unknown key \"kind\""),
        scheme("NameOfAnotherType", additive + R"(, "name": 5)", "motion.json:2: name: must be a text"),
        scheme("MeshSizeOfZero", additive + R"(, "mesh_size": 0)", "motion.json:2: mesh_size: must be above 0"),
        scheme("ClosedOfAnotherType", additive + R"(, "closed": 1)", "motion.json:2: closed: must be true or false"),
        scheme("KeepSignsOfMultiplicative", R"("scheme": "multiplicative", "degree": 2, "keep_signs": true)",
               "motion.json:2: keep_signs: "),
        scheme("BaseOfAdditive", additive + R"(, "base": {"steps": []})", "motion.json:2: base: belongs to"),
        scheme("BaseOfNoForm", R"("scheme": "generator", "degree": 2, "base": {})", "motion.json:2: base: a pose is"),
        scheme("BaseWithoutAPose",
               R"("scheme": "generator", "degree": 2, "base": {"motor": [0, 0, 0, 0, 1, 0, 0, 0]})",
               "motion.json:2: base.motor: its first four numbers are zero"),
        scheme("TimesOfControls", additive + R"(, "times": [0, 1, 2, 3])", "motion.json:2: times: belong to keys"),
        scheme("ControlsOfGeneratorKeys", R"("scheme": "generator_keys")", "motion.json:3: controls: ", "\"keys\""),
        scheme("WeightsOfMultiplicative", R"("scheme": "multiplicative", "degree": 2, "weights": [1, 1, 1, 1])",
               "motion.json:2: weights: belong to controls of the additive scheme"),
        scheme("ThreeWeights", additive + R"(, "weights": [1, 1, 1])",
               "motion.json:2: weights: holds 3 numbers, and there are 4 poses"),
        scheme("WeightOfZero", additive + R"(, "weights": [1, 1, 0, 1])",
               "motion.json:2: weights[2]: is 0, and weights are above 0"),
        scheme("WeightTooSmall", additive + R"(, "weights": [1, 1, 1, 1e-200])",
               "motion.json:2: weights[3]: times its control is too small"),
        scheme("NegativeWeight", additive + R"(, "weights": [1, -1, 1, 1])",
               "motion.json:2: weights[1]: is -1, and weights are above 0"),
        knots("NoDegree", R"("knots": [0, 0, 1, 2, 2])", "motion.json:1: the key \"degree\" is missing"),
        knots("DegreeZero", R"("degree": 0, "knots": [0, 0, 1])",
              "motion.json:2: degree: is 0, and degrees are from 1"),
        knots("DegreeOfAHalf", R"("degree": 1.5, "knots": [0, 0, 1])", "motion.json:2: degree: must be a whole"),
        knots("DegreeTooHigh", R"("degree": 32, "knots": [0, 0, 1])", "motion.json:2: degree: is 32, and degrees are"),
        knots("DegreeForMoreControls", R"("degree": 4, "knots": [0, 0, 0, 0, 1, 1, 1])",
              "motion.json:3: controls: there are 4, and degree 4 needs 5"),
        knots("Empty", R"("degree": 2, "knots": [])", "motion.json:2: knots: there are 0"),
        knots("TooFew", R"("degree": 2, "knots": [0, 0, 1, 2])", "motion.json:2: knots: there are 4",
              "5 are needed (additive motion of degree 2, 4 control poses)"),
        knots("TooMany", R"("degree": 2, "knots": [0, 0, 1, 2, 2, 2])", "motion.json:2: knots: there are 6"),
        knots("TooFewIfClosed", R"("degree": 2, "closed": true, "knots": [0, 1, 2, 3])",
              "motion.json:2: knots: there are 4",
              "5 are needed (closed additive motion of degree 2, 4 control poses)"),
        knots("Decreasing", R"("degree": 2, "knots": [0, 0, 2, 1, 2])",
              "motion.json:2: knots[3]: is 1, and the knot before it is 2"),
        knots("DomainOfLengthZero", R"("degree": 2, "knots": [1, 1, 1, 1, 1])",
              "motion.json:2: knots[3]: is 1, and so is knots[1]"),
        knots("AllEqual", R"("degree": 3, "knots": [1, 1, 1, 1, 1, 1])",
              "motion.json:2: knots[3]: is 1, and so is knots[2]", "last no time"),
        knots("AllEqualIfClosed", R"("degree": 2, "closed": true, "knots": [5, 5, 5, 5, 5])",
              "motion.json:2: knots[4]: is 5, and so is knots[0]"),
        knots("RepeatedTooOften", R"("degree": 1, "knots": [0, 0, 0, 1])",
              "motion.json:2: knots[2]: 0 comes too often", "2 times at most"),
        knots("RepeatedTooOftenAcrossTheEnd", R"("degree": 2, "closed": true, "knots": [0, 0, 1, 1, 1])",
              "motion.json:2: knots[", "counted on from the last knot"),
        knots("TooNear", R"("degree": 2, "knots": [0, 0, 1e-310, 1, 1])", "motion.json:2: knots[2]: is too near"),
        knots("OfOtherLibraries", R"("degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2])",
              "motion.json:2: knots: there are 7, and 5 are needed", "leave out the first and the last"),
        knots("OfText", R"("degree": 2, "knots": [0, 0, "1", 2, 2])", "motion.json:2: knots[2]: must be a number"),
        keys("OfMultiplicative", R"("scheme": "multiplicative", "degree": 1)", "motion.json:3: keys: belong to"),
        keys("OfGenerator", R"("scheme": "generator", "degree": 2)", "motion.json:3: keys: belong to"),
        keys("WithKnots", R"("scheme": "generator_keys", "knots": [0, 1, 2, 3])", "motion.json:2: knots: belong to"),
        keys("WithWeights", additive + R"(, "weights": [1, 1, 1, 1])", "motion.json:2: weights: belong to"),
        keys("Closed", additive + R"(, "times": [0, 1, 2, 3], "closed": true)", "motion.json:2: closed: "),
        keys("KeepSigns", additive + R"(, "times": [0, 1, 2, 3], "keep_signs": true)", "motion.json:2: keep_signs: "),
        keys("WithADegree", R"("scheme": "generator_keys", "degree": 2)", "motion.json:2: degree: "),
        keys("NoTimes", additive, "motion.json:1: the key \"times\" is missing"),
        keys("TooFewTimes", additive + R"(, "times": [0, 1, 2])",
             "motion.json:2: times: holds 3 numbers, and there are 4 poses"),
        keys("TimesThatDoNotIncrease", additive + R"(, "times": [0, 1, 1, 2])",
             "motion.json:2: times[2]: is 1, and the time before it is 1"),
        motion(
            "KeysHalfTurnsApart",
            "{\"motorway\": 2, \"scheme\": \"cumulative\", \"degree\": 3, \"times\": [0, 1, 2, 3, 4, 5],\n\"keys\": ["
            R"({"steps": []}, {"axis": [1, 0, 0], "degrees": 170}, {"axis": [0, 1, 0], "degrees": 170},
               {"axis": [0, 0, 1], "degrees": 170}, {"axis": [1, 0, 0], "degrees": -170},
               {"axis": [0, 1, 0], "degrees": -170}]})",
            "motion.json:2: keys: no motion was found", "put keys in between"),
        keys("DegreeForMoreKeys", R"("scheme": "cumulative", "degree": 4, "times": [0, 1, 2, 3])",
             "motion.json:3: keys: there are 4, and degree 4 needs 5"),
        keys("TooFewTimesOfGenerators", R"("scheme": "generator_keys", "times": [0, 1, 2])",
             "motion.json:2: times: there are 3", "4 are needed"),
        keys("TooFewTimesIfClosed", R"("scheme": "generator_keys", "closed": true, "times": [0, 1, 2, 3])",
             "motion.json:2: times: there are 4", "5 are needed"),
        keys("TimesTooNear", additive + R"(, "times": [0, 1e-310, 1, 2])", "motion.json:2: times[1]: is too near"),
        motion("OneKey", R"({"motorway": 2, "scheme": "generator_keys", "keys": [{"steps": []}]})",
               "motion.json:1: keys: there are 1, and a motion needs 2"),
        keys("TimesOfGeneratorsThatDoNotIncrease", R"("scheme": "generator_keys", "times": [0, 1, 1, 2])",
             "motion.json:2: times[2]: is 1, and the time before it is 1"),
    };
}

std::vector<std::string> sample(std::vector<std::string> more)
{
    more.insert(more.begin(), {"sample", "motion.json"});
    return more;
}

std::vector<std::string> compare(std::vector<std::string> more)
{
    more.insert(more.begin(), {"compare", "motion.json"});
    return more;
}

std::vector<BadInput> sample_cases()
{
    ToolLimits nonsense, small_disk;
    nonsense.isa = "pentium";
    small_disk.largest_file = 200;
    const std::string even = "--even: ";
    return {
        options("SampleNoMotion", {"sample", "--count", "3"}, "", "MOTION"),
        options("SampleNoCount", sample({}), "", "--count"),
        options("SampleZero", sample({"--count", "0"}), "--count: 0 will not do"),
        options("SampleTooMany", sample({"--count", "1000001"}), "--count: 1000001 will not do", "1,000,000"),
        options("SampleFrameOfNothing", sample({"--count", "3", "--frame", "body"}), "", "--velocity"),
        options("SampleUnknownFrame", sample({"--count", "3", "--velocity", "--frame", "moon"}), "", "--frame"),
        options("SampleUnknownFormat", sample({"--count", "3", "--format", "xml"}), "", "--format"),
        options("SampleEvenOfTwo", sample({"--count", "3", "--even", "1,2"}), even + "\"1,2\" is no point"),
        options("SampleEvenOfFour", sample({"--count", "3", "--even", "1,2,3,4"}), even + "\"1,2,3,4\" is no point"),
        options("SampleEvenOfWords", sample({"--count", "3", "--even", "1,two,3"}), even + "\"1,two,3\" is no point"),
        options("SampleEvenOfNan", sample({"--count", "3", "--even", "1,2,nan"}), even + "\"1,2,nan\" is no point"),
        options("SampleEvenWithAGap", sample({"--count", "3", "--even", "1,,3"}), even + "\"1,,3\" is no point"),
        options("SampleMotionMissing", {"sample", "no.json", "--count", "3"}, "no.json: cannot be opened"),
        options("SampleFolderMissing", sample({"--count", "3", "-o", "nowhere/s.csv"}), "nowhere/s.csv: the folder"),
        {"SampleIsaThatCannotRun", {}, sample({"--count", "3"}), "MOTORWAY_ISA: ", "", nonsense},
        {"SampleDiskFull", {}, sample({"--count", "9", "-o", "s.csv"}), "s.csv: cannot be written", "", small_disk},
    };
}

std::vector<BadInput> compare_cases()
{
    ToolLimits nonsense;
    nonsense.isa = "pentium";
    return {
        options("CompareNoMotion", {"compare", "--mesh", "mesh.obj"}, "", "FIRST"),
        options("CompareNoMesh", compare({"motion.json"}), "", "--mesh"),
        options("CompareWithNothing", compare({"--mesh", "mesh.obj"}), "SECOND: give either", "--against"),
        options("CompareWithBoth", compare({"motion.json", "--against", "generator", "--mesh", "mesh.obj"}),
                "SECOND: give either"),
        options("CompareUnknownScheme", compare({"--against", "linear", "--mesh", "mesh.obj"}), "", "--against"),
        options("CompareKeysOfControls", compare({"--against", "generator_keys", "--mesh", "mesh.obj"}),
                "motion.json:1: controls: ", "\"keys\""),
        options("CompareNoSamples", compare({"motion.json", "--mesh", "mesh.obj", "--samples", "0"}), "--samples: "),
        options("CompareScaleOfZero", compare({"motion.json", "--mesh", "mesh.obj", "--scale", "0"}), "--scale: "),
        {"CompareScaleBeyondDouble",
         {{"mesh.obj", "v 1e10 0 0\n"}},
         compare({"motion.json", "--mesh", "mesh.obj", "--scale", "1e300"}),
         "mesh.obj: is too large for doubles"},
        options("CompareSecondMissing", compare({"no.json", "--mesh", "mesh.obj"}), "no.json: cannot be opened"),
        options("CompareMeshMissing", compare({"motion.json", "--mesh", "no.obj"}), "no.obj: cannot be opened"),
        {"CompareIsaThatCannotRun",
         {},
         compare({"motion.json", "--mesh", "mesh.obj"}),
         "MOTORWAY_ISA: ",
         "",
         nonsense},
    };
}

std::vector<BadInput> option_cases()
{
    ToolLimits nonsense, small_disk;
    nonsense.isa = "pentium";
    small_disk.largest_file = 200; /* enough for the message, which goes into a file as well */
    return {
        options("NoCommand", {"--"}, "", "--help"),
        options("UnknownCommand", {"dance"}, "", "--help"),
        options("UnknownOption", pose("3", "out.glb", {"--quickly"}), "", "--quickly"),
        options("NoMesh", {"pose", "--motion", "motion.json", "--frames", "3", "--out", "out.glb"}, "", "MESH"),
        options("NoFrames", {"pose", "mesh.obj", "--motion", "motion.json", "--out", "out.glb"}, "", "--frames"),
        options("ZeroFrames", pose("0", "out.glb"), "--frames: "),
        options("NegativeFrames", pose("-1", "out.glb"), "--frames: "),
        options("TooManyFrames", pose("1000001", "out.glb"), "--frames: "),
        options("FramesOfWords", pose("many", "out.glb"), "", "--frames"),
        options("ScaleOfZero", pose("3", "out.glb", {"--scale", "0"}), "--scale: "),
        options("ScaleOfNan", pose("3", "out.glb", {"--scale", "nan"}), "--scale: "),
        {"ScaleBeyondDouble",
         {{"mesh.obj", "v 1e10 0 0\n"}},
         pose("3", "out.obj", {"--scale", "1e300"}),
         "mesh.obj: is too large for doubles"},
        options("ScaleBeyondThePicture", pose("3", "out.obj", {"--scale", "1e200", "--picture", "p.svg"}),
                "motion.json: the mesh goes too far away to be drawn"),
        options("FpsOfZero", pose("3", "out.glb", {"--fps", "0"}), "--fps: "),
        options("NoPicturePoses", pose("3", "out.glb", {"--picture", "p.svg", "--picture-poses", "0"}),
                "--picture-poses: "),
        options("OutOfUnknownKind", pose("3", "out.fbx"), "--out: \"out.fbx\" has an unknown extension"),
        options("OutWithoutKind", pose("3", "out"), "--out: \"out\" has an unknown extension"),
        options("PictureOfUnknownKind", pose("3", "out.glb", {"--picture", "p.png"}), "--picture: \"p.png\""),
        options("OutFolderMissing", pose("3", "nowhere/out.glb"),
                "nowhere/out.glb: the folder nowhere does not exist"),
        options("FrameFolderMissing", pose("3", "nowhere/out.obj"), "nowhere/out-0000.obj: the folder nowhere"),
        options("PictureFolderMissing", pose("3", "out.glb", {"--picture", "nowhere/p.svg"}), "nowhere/p.svg: "),
        options("OutFolderIsAFile", pose("3", "mesh.obj/out.glb"), "mesh.obj/out.glb: "),
        options("OutFolderCannotBeWritten", pose("3", "/proc/out.glb"), "/proc/out.glb: "),
        {"OutIsAFolder", {{"out.glb/keep", ""}}, {}, "out.glb: is a folder"},
        {"AFrameIsAFolder", {{"out-0002.ply/keep", ""}}, pose("3", "out.ply"), "out-0002.ply: cannot be written"},
        options("MeshMissing", {"pose", "no.obj", "--motion", "motion.json", "--frames", "3", "--out", "out.glb"},
                "no.obj: cannot be opened"),
        options("MeshIsAFolder", {"pose", "..", "--motion", "motion.json", "--frames", "3", "--out", "out.glb"},
                "..: "),
        {"MeshOfAFolder",
         {{"m.obj/keep", ""}},
         {"pose", "m.obj", "--motion", "motion.json", "--frames", "3", "--out", "out.glb"},
         "m.obj: is a folder"},
        options("MeshOfUnknownKind",
                {"pose", "motion.json", "--motion", "motion.json", "--frames", "3", "--out", "o.glb"},
                "motion.json: unknown kind of mesh"),
        options("MotionMissing", {"pose", "mesh.obj", "--motion", "no.json", "--frames", "3", "--out", "out.glb"},
                "no.json: cannot be opened"),
        {"PoseBeyondFloat",
         {{"motion.json", R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []},
             {"steps": [{"translate": [3.4e38, 0, 0]}]}]})"},
          {"mesh.ply", PLY_HEADER + "3e38 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"}},
         {"pose", "mesh.ply", "--motion", "motion.json", "--frames", "2", "--out", "out.obj"},
         "frame 1: vertex 0 ",
         "for floats"},
        {"PoseBeyondOneFloat",
         {{"motion.json", R"({"motorway": 1, "kind": "linear", "controls": [{"steps": []},
             {"steps": [{"translate": [3.4e38, 0, 0]}]}]})"},
          {"mesh.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty double y\n"
                       "property float z\nend_header\n3e38 0 0\n"}},
         {"pose", "mesh.ply", "--motion", "motion.json", "--frames", "2", "--out", "out.ply"},
         "vertex 0 (counting from 0): x lands too far away for a float"},
        {"IsaThatCannotRun", {}, {}, "MOTORWAY_ISA: ", "", nonsense},
        {"IsaThatCannotRunForInfo", {}, {"info"}, "MOTORWAY_ISA: ", "", nonsense},
        {"DiskFull", {}, {}, "out.glb: cannot be written", "", small_disk},
        {"DiskFullForFrames", {}, pose("3", "out.ply"), "out-0000.ply: cannot be written", "", small_disk},
        {"DiskFullForThePicture",
         {},
         pose("3", "out.obj", {"--picture", "p.svg"}),
         "p.svg: cannot be written",
         "",
         small_disk},
    };
}

std::vector<BadInput> all_cases()
{
    std::vector<BadInput> all;
    for (const auto &cases : {obj_cases(), ply_cases(), motion_cases(), pose_cases(), scheme_cases(), sample_cases(),
                              compare_cases(), option_cases()})
        all.insert(all.end(), cases.begin(), cases.end());
    return all;
}

class BadInputTest : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, IsOneLineAndLeavesNothing)
{
    const BadInput &bad = GetParam();
    const TemporaryFolder folder;
    Files files = {{"mesh.obj", GOOD_OBJ}, {"motion.json", GOOD_MOTION}};
    for (const auto &[name, contents] : bad.files)
        files[name] = contents;
    for (const auto &[name, contents] : files) {
        std::filesystem::create_directories((folder.path() / name).parent_path());
        folder.write(name, contents);
    }
    const std::vector<std::string> before = folder.list();
    const ToolResult result =
        run_tool(folder.path(), bad.arguments.empty() ? pose("3", "out.glb") : bad.arguments, bad.limits);

    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.rfind("motorway: error: " + bad.expected, 0), 0u) << result.err;
    EXPECT_NE(result.err.find(bad.also), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << "one line: " << result.err;
    EXPECT_FALSE(result.err.empty() || result.err.back() != '\n');
    EXPECT_EQ(result.err.find("MW_"), result.err.npos) << "a name of the C API, which users of the command lack";
    EXPECT_EQ(result.err.find("mw_"), result.err.npos) << "a name of the C API, which users of the command lack";
    EXPECT_EQ(folder.list(), before) << "nothing written";
}

INSTANTIATE_TEST_SUITE_P(, BadInputTest, ::testing::ValuesIn(all_cases()),
                         [](const auto &bad) { return bad.param.name; });

TEST(BadInputs, TheirGoodCounterpartIsGood)
{
    const TemporaryFolder folder;
    folder.write("mesh.obj", GOOD_OBJ);
    folder.write("motion.json", GOOD_MOTION);
    const ToolResult result = run_tool(folder.path(), pose("3", "out.glb"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(folder.list(), (std::vector<std::string>{"mesh.obj", "motion.json", "out.glb"}));
}

} // namespace
} // namespace motorway::tool
