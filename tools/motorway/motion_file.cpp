#include "motion_file.h"

#include <algorithm>
#include <iterator>

#include "error.h"
#include "files.h"
#include "json_field.h"
#include "pose_field.h"
#include "status.h"
#include "summary.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr long long VERSION = 2;

/* -------------------------------------------------------------------------------- other versions and schemes --- */

/* Files of version 1 hold additive motions whose controls keep their signs, as files of version 2. */
void upgrade(Document &document)
{
    const Field root(document);
    const std::string kind = root["kind"].string();
    nlohmann::json &value = document.value;
    if (kind == "bspline") {
        root.check_object({"motorway", "name", "mesh_size", "kind", "degree", "knots", "controls"});
        static_cast<void>(root["knots"]); /* which version 2 does without */
    } else if (kind == "bezier" || kind == "linear") {
        root.check_object({"motorway", "name", "mesh_size", "kind", "controls"});
        const std::size_t count = root["controls"].array().size();
        if (count < 2 || (kind == "bezier" && count > MW_MAX_DEGREE + 1))
            throw root["controls"].error("holds " + counted(count, "control") + ", and a motion needs 2 or more" +
                                         (count < 2 ? "; add some"
                                                    : ", if it is a Bézier motion at most " +
                                                          std::to_string(MW_MAX_DEGREE + 1) + "; use a B-spline"));
        value["degree"] = kind == "linear" ? 1 : count - 1;
    } else {
        throw root["kind"].error("must be \"bspline\", \"bezier\" or \"linear\"; correct it");
    }
    value.erase("kind");
    value["scheme"] = "additive";
    value["keep_signs"] = true;
    value["motorway"] = VERSION;
}

/* What says how the old scheme works, and the new one does not take, goes with it. */
void change_scheme(Document &document, const std::string &scheme)
{
    document.value["scheme"] = scheme;
    if (scheme != scheme_name(MW_MOTION_GENERATOR) && scheme != scheme_name(MW_MOTION_GENERATOR_KEYS))
        document.value.erase("base");
    if (scheme == scheme_name(MW_MOTION_GENERATOR_KEYS))
        document.value.erase("degree");
    if (scheme == scheme_name(MW_MOTION_MULTIPLICATIVE))
        document.value.erase("keep_signs");
}

/* ------------------------------------------------------------------------------------------------ the fields --- */

mw_motion_kind read_scheme(const Field &scheme)
{
    constexpr mw_motion_kind KINDS[] = {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                        MW_MOTION_GENERATOR, MW_MOTION_GENERATOR_KEYS};
    const std::string name = scheme.string();
    const auto found = std::find_if(std::begin(KINDS), std::end(KINDS),
                                    [&](mw_motion_kind kind) { return name == scheme_name(kind); });
    if (found == std::end(KINDS))
        throw scheme.error(in_quotes(name) + " is none; it is additive, multiplicative, cumulative, generator or "
                                             "generator_keys");
    return *found;
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

/* Keys that some schemes take and others do not. */
void check_keys(const Field &root, mw_motion_kind kind)
{
    const bool through_keys = root.has("keys");
    const bool by_generators = kind == MW_MOTION_GENERATOR || kind == MW_MOTION_GENERATOR_KEYS;
    if (kind == MW_MOTION_GENERATOR_KEYS)
        refuse(root, "controls", true, "of this scheme the poses are \"keys\", which it passes through; rename them");
    if (through_keys == root.has("controls"))
        throw root.error("a motion has either \"controls\" or \"keys\"; give one of them");
    refuse(root, "keys", kind == MW_MOTION_MULTIPLICATIVE || kind == MW_MOTION_GENERATOR,
           "belong to the schemes additive, cumulative and generator_keys; give \"controls\"");
    refuse(root, "knots", through_keys, "belong to controls; \"times\" belong to keys");
    refuse(root, "times", !through_keys, "belong to keys; \"knots\" belong to controls");
    refuse(root, "degree", kind == MW_MOTION_GENERATOR_KEYS, "this scheme has none; leave it out");
    refuse(root, "weights", kind != MW_MOTION_ADDITIVE || through_keys,
           "belong to controls of the additive scheme; leave them out");
    refuse(root, "base", !by_generators, "belongs to the schemes generator and generator_keys; leave it out");
    refuse(root, "closed", is_solved(root, kind), "of keys only generator_keys is closed; leave it out");
    refuse(root, "keep_signs", is_solved(root, kind), "keys go the shortest way; leave it out");
    refuse(root, "keep_signs", kind == MW_MOTION_MULTIPLICATIVE, "this scheme goes the shortest way; leave it out");
}

unsigned read_degree(const Field &degree)
{
    const long long value = degree.integer();
    if (value < 1 || value > MW_MAX_DEGREE)
        throw degree.error(mw_status_text(MW_ERROR_DEGREE));
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

std::size_t needed_knots(const Motion &motion)
{
    const std::size_t count = motion.controls.size();
    if (motion.closed)
        return count + 1;
    return motion.kind == MW_MOTION_GENERATOR_KEYS ? count : count + motion.degree - 1;
}

/* The library says what is wrong; this says which field it means. */
void check_motion(mw_status status, std::size_t where, const Motion &motion, const Field &root)
{
    const char *const poses = root.has("keys") ? "keys" : "controls";
    const char *const knots = root.has("keys") ? "times" : "knots";
    const std::string text = mw_status_text(status);
    switch (status) {
    case MW_ERROR_CONTROL_COUNT:
        throw root[poses].error("there are " + std::to_string(motion.controls.size()) + ": " + text);
    case MW_ERROR_KNOT_COUNT:
        throw root[knots].error("there are " + std::to_string(motion.knots.size()) + ", and " +
                                std::to_string(needed_knots(motion)) + " are needed (" + description(motion) +
                                "): " + text);
    case MW_ERROR_KNOTS:
        throw root[knots].array().at(where).error(text);
    case MW_ERROR_WEIGHTS:
        throw root["weights"].array().at(where).error(text);
    case MW_ERROR_VANISHING:
        throw root[poses].array().at(where).error(text);
    case MW_ERROR_CONVERGENCE:
        throw root[poses].error(text);
    default:
        check(status, "the motion");
    }
}

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
        return mw_interpolate_keys_f64(&result, arrays, motion.kind, motion.degree, keys.data(), times.data(),
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
    if (motion.kind != MW_MOTION_GENERATOR_KEYS)
        motion.degree = read_degree(root["degree"]);
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

Motion read_fields(const Field &root)
{
    root.check_object({"motorway", "name", "mesh_size", "scheme", "degree", "controls", "knots", "weights", "keys",
                       "times", "closed", "keep_signs", "base"});
    Motion motion;
    if (root.has("name"))
        motion.name = root["name"].string();
    if (root.has("mesh_size")) {
        motion.mesh_size = root["mesh_size"].number();
        if (!(*motion.mesh_size > 0))
            throw root["mesh_size"].error("must be above 0; correct it");
    }
    motion.kind = read_scheme(root["scheme"]);
    check_keys(root, motion.kind);
    motion.closed = root.has("closed") && root["closed"].boolean();
    motion.keep_signs = root.has("keep_signs") && root["keep_signs"].boolean();
    if (root.has("base"))
        motion.base = read_pose(root["base"]);
    if (root.has("weights"))
        motion.weights = read_numbers_of_poses(root["weights"], root["controls"].array().size());
    read_course(root, motion);
    return motion;
}

} // namespace

Motion parse_motion(const std::string &contents, const std::string &path, const std::string &scheme)
{
    Document document = parse_json(contents, path);
    const Field root(document);
    const Field version = root["motorway"];
    if (version.integer() == 1)
        upgrade(document);
    else if (version.integer() != VERSION)
        throw version.error("unknown version of the motion format; this tool reads versions 1 and 2");
    if (!scheme.empty())
        change_scheme(document, scheme);
    return read_fields(root);
}

Motion read_motion(const std::string &path, const std::string &scheme)
{
    return parse_motion(read_file(path), path, scheme);
}

} // namespace motorway::tool
