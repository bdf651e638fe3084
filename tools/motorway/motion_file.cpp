#include "motion_file.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>

#include "error.h"
#include "files.h"
#include "json_field.h"
#include "motion_error.h"
#include "pose_field.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr long long VERSION = 2;

/* ------------------------------------------------------------------------------------------------ the fields --- */

/* Nothing if there is no such scheme. */
std::optional<mw_motion_kind> kind_of(const std::string &scheme)
{
    constexpr mw_motion_kind KINDS[] = {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                        MW_MOTION_GENERATOR, MW_MOTION_GENERATOR_KEYS};
    const auto found = std::find_if(std::begin(KINDS), std::end(KINDS),
                                    [&](mw_motion_kind kind) { return scheme == scheme_name(kind); });
    return found == std::end(KINDS) ? std::nullopt : std::optional<mw_motion_kind>(*found);
}

mw_motion_kind read_scheme(const Field &scheme)
{
    const std::optional<mw_motion_kind> kind = kind_of(scheme.string());
    if (!kind)
        throw scheme.error(in_quotes(scheme.string()) + " is none; it is additive, multiplicative, cumulative, "
                                                        "generator or generator_keys");
    return *kind;
}

bool takes_base(mw_motion_kind kind)
{
    return kind == MW_MOTION_GENERATOR || kind == MW_MOTION_GENERATOR_KEYS;
}

/* The others go the shortest way by their nature. */
bool takes_signs(mw_motion_kind kind)
{
    return kind != MW_MOTION_MULTIPLICATIVE;
}

/* Keys that an additive or cumulative motion is made to pass through, by solving for its controls. */
bool is_solved(const Field &root, mw_motion_kind kind)
{
    return root.has("keys") && kind != MW_MOTION_GENERATOR_KEYS;
}

void refuse(const Field &root, const char *key, bool refused, const char *why)
{
    if (refused && root.has(key))
        throw root[key].error(why);
}

/* Keys that some schemes take and others do not. In a file that is read under another scheme than its own, what says
 * how its own one works is passed over. */
void check_keys(const Field &root, mw_motion_kind kind, bool is_own_scheme)
{
    const bool through_keys = root.has("keys");
    if (kind == MW_MOTION_GENERATOR_KEYS)
        refuse(root, "controls", true, "of this scheme the poses are \"keys\", which it passes through; rename them");
    if (through_keys == root.has("controls"))
        throw root.error("a motion has either \"controls\" or \"keys\"; give one of them");
    refuse(root, "keys", kind == MW_MOTION_MULTIPLICATIVE || kind == MW_MOTION_GENERATOR,
           "belong to the schemes additive, cumulative and generator_keys; give \"controls\"");
    refuse(root, "knots", through_keys, "belong to controls; \"times\" belong to keys");
    refuse(root, "times", !through_keys, "belong to keys; \"knots\" belong to controls");
    refuse(root, "degree", is_own_scheme && kind == MW_MOTION_GENERATOR_KEYS, "this scheme has none; leave it out");
    refuse(root, "weights", kind != MW_MOTION_ADDITIVE || through_keys,
           "belong to controls of the additive scheme; leave them out");
    refuse(root, "base", is_own_scheme && !takes_base(kind),
           "belongs to the schemes generator and generator_keys; leave it out");
    refuse(root, "closed", is_solved(root, kind), "of keys only generator_keys is closed; leave it out");
    refuse(root, "keep_signs", is_solved(root, kind), "keys go the shortest way; leave it out");
    refuse(root, "keep_signs", is_own_scheme && !takes_signs(kind), "this scheme goes the shortest way; leave it out");
}

unsigned read_degree(const Field &degree)
{
    const long long value = degree.integer();
    if (value < 1 || value > MW_MAX_DEGREE)
        throw degree.error("is " + std::to_string(value) + ", and degrees are from 1 to " +
                           std::to_string(MW_MAX_DEGREE) + "; correct it");
    return static_cast<unsigned>(value);
}

/* One number for each of `count` poses. */
std::vector<double> read_numbers_of_poses(const Field &numbers, std::size_t count)
{
    std::vector<double> values = numbers.numbers();
    if (values.size() != count)
        throw numbers.error("holds " + counted(values.size(), "number") + ", and there are " +
                            counted(count, "pose") + "; give one for each");
    return values;
}

/* ------------------------------------------------------------------------------ what the library makes of it --- */

/* The keys are in motion.controls, their times in motion.knots; both become those of the motion. */
mw_status solve(Motion &motion, std::size_t *where)
{
    const std::vector<mw_motor_f64> keys = motion.controls;
    const std::vector<double> times = motion.knots;
    motion.knots.resize(keys.size() + motion.degree - 1);
    mw_motion_f64 result;
    const mw_motion_arrays_f64 arrays = {motion.controls.data(), keys.size(), motion.knots.data(),
                                         motion.knots.size()};
    const auto call = [&](void *memory, std::size_t *size) {
        return mw_interpolate_keys_f64(&result, &arrays, motion.kind, motion.degree, keys.data(), times.data(),
                                       keys.size(), memory, size, where);
    };
    std::size_t size = 0;
    const mw_status status = call(nullptr, &size);
    if (status != MW_OK)
        return status;
    std::vector<std::uint64_t> memory((size + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    size = memory.size() * sizeof memory[0];
    return call(memory.data(), &size);
}

/* The fields of poses and knots, and what becomes of them. */
void read_course(const Field &root, Motion &motion)
{
    const bool through_keys = root.has("keys");
    motion.controls.reserve(1); /* so that none at all is a wrong number to the library, and not a null pointer */
    for (const mw_motor_f64 &pose : read_poses(root[through_keys ? "keys" : "controls"]))
        motion.controls.push_back(pose);
    std::size_t where = 0;
    if (is_solved(root, motion.kind)) {
        motion.knots = read_numbers_of_poses(root["times"], motion.controls.size());
        const mw_status status = solve(motion, &where);
        check_motion(status, where, motion, root);
        motion.keep_signs = true; /* of the controls that were solved for */
    } else if (const char *knots = through_keys ? "times" : "knots"; root.has(knots)) {
        motion.knots = root[knots].numbers();
        if (motion.knots.empty()) /* which to the library is none given */
            check_motion(MW_ERROR_KNOT_COUNT, 0, motion, root);
    }
    const mw_status status = motion.compile(&where);
    check_motion(status, where, motion, root);
}

/* What is the same in all versions. */
Motion read_fields(const Field &root, Motion motion, bool is_own_scheme)
{
    if (root.has("name"))
        motion.name = root["name"].string();
    if (root.has("mesh_size")) {
        motion.mesh_size = root["mesh_size"].number();
        if (!(*motion.mesh_size > 0))
            throw root["mesh_size"].error("must be above 0; correct it");
    }
    check_keys(root, motion.kind, is_own_scheme);
    motion.closed = root.has("closed") && root["closed"].boolean();
    if (root.has("keep_signs"))
        motion.keep_signs = root["keep_signs"].boolean();
    motion.keep_signs = motion.keep_signs && takes_signs(motion.kind);
    if (root.has("base") && takes_base(motion.kind))
        motion.base = read_pose(root["base"]);
    if (root.has("weights"))
        motion.weights = read_numbers_of_poses(root["weights"], root["controls"].array().size());
    read_course(root, motion);
    return motion;
}

/* ---------------------------------------------------------------------------------------------- the versions --- */

/* Additive motions whose controls keep their signs. Their degree may follow from their kind. */
Motion read_version_1(const Field &root, std::optional<mw_motion_kind> other_scheme)
{
    Motion motion;
    motion.kind = other_scheme.value_or(MW_MOTION_ADDITIVE);
    motion.keep_signs = true;
    const std::string kind = root["kind"].string();
    if (kind == "bspline") {
        root.check_object({"motorway", "name", "mesh_size", "kind", "degree", "knots", "controls"});
        static_cast<void>(root["knots"]); /* which version 2 does without */
        motion.degree = read_degree(root["degree"]);
    } else if (kind == "bezier" || kind == "linear") {
        root.check_object({"motorway", "name", "mesh_size", "kind", "controls"});
        const std::size_t count = root["controls"].array().size();
        if (count < 2 || (kind == "bezier" && count > MW_MAX_DEGREE + 1))
            throw root["controls"].error("holds " + counted(count, "control") + ", and a motion needs 2 or more" +
                                         (count < 2 ? "; add some"
                                                    : ", if it is a Bézier motion at most " +
                                                          std::to_string(MW_MAX_DEGREE + 1) + "; use a B-spline"));
        motion.degree = kind == "linear" ? 1 : static_cast<unsigned>(count - 1);
    } else {
        throw root["kind"].error("must be \"bspline\", \"bezier\" or \"linear\"; correct it");
    }
    return motion;
}

Motion read_version_2(const Field &root, std::optional<mw_motion_kind> other_scheme)
{
    root.check_object({"motorway", "name", "mesh_size", "scheme", "degree", "controls", "knots", "weights", "keys",
                       "times", "closed", "keep_signs", "base"});
    Motion motion;
    motion.kind = other_scheme ? *other_scheme : read_scheme(root["scheme"]);
    if (motion.kind != MW_MOTION_GENERATOR_KEYS)
        motion.degree = read_degree(root["degree"]);
    return motion;
}

} // namespace

Motion parse_motion(const std::string &contents, const std::string &path, const std::string &scheme)
{
    const Document document = parse_json(contents, path);
    const Field root(document), version = root["motorway"];
    const std::optional<mw_motion_kind> other_scheme = kind_of(scheme);
    if (version.integer() != 1 && version.integer() != VERSION)
        throw version.error("unknown version of the motion format; this tool reads versions 1 and 2");
    const Motion begun =
        version.integer() == 1 ? read_version_1(root, other_scheme) : read_version_2(root, other_scheme);
    return read_fields(root, begun, !other_scheme);
}

Motion read_motion(const std::string &path, const std::string &scheme)
{
    return parse_motion(read_file(path), path, scheme);
}

} // namespace motorway::tool
