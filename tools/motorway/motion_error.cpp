#include "motion_error.h"

#include <limits>
#include <string>
#include <vector>

#include "error.h"
#include "status.h"
#include "summary.h"
#include "text.h"

namespace motorway::tool {
namespace {

const char *const TOO_NEAR = "is too near the number before it to divide by their distance; make them equal or move "
                             "them apart";

Error too_few_poses(const Field &poses, const Motion &motion)
{
    const std::string there_are = "there are " + std::to_string(motion.controls.size()) + ", and ";
    if (motion.kind == MW_MOTION_GENERATOR_KEYS)
        return poses.error(there_are + "a motion needs 2 or more; add some");
    return poses.error(there_are + "degree " + std::to_string(motion.degree) + " needs " +
                       std::to_string(motion.degree + 1) + " or more; add some, or lower the degree");
}

Error wrong_knot_count(const Field &knots, const Motion &motion)
{
    const std::size_t poses = motion.controls.size(), given = motion.knots.size();
    const bool keys = motion.kind == MW_MOTION_GENERATOR_KEYS;
    const std::size_t needed = motion.closed ? poses + 1 : keys ? poses : poses + motion.degree - 1;
    const char *const rule = motion.closed && keys ? "one a key, and that of the return to the first"
                             : motion.closed       ? "one more than controls, for one period"
                             : keys                ? "one a key"
                                                   : "as many as controls and degree together, less 1";
    const bool of_other_libraries = !motion.closed && !keys && given == needed + 2;
    return knots.error("there are " + std::to_string(given) + ", and " + std::to_string(needed) + " are needed (" +
                       description(motion) + "): " + rule +
                       (of_other_libraries ? "; leave out the first and the last, which have no effect"
                                           : "; correct them"));
}

Error wrong_time(const Field &times, std::size_t where)
{
    const std::vector<double> values = times.numbers();
    const Field field = times.array().at(where);
    if (where > 0 && values[where] > values[where - 1])
        return field.error(TOO_NEAR);
    return field.error("is " + precise(values[where]) + ", and the time before it is " +
                       precise(values.at(where - 1)) + "; times increase: correct one of them");
}

/* Their number is right, and they are finite. */
Error wrong_knot(const Field &knots, std::size_t where, const Motion &motion)
{
    const std::vector<Field> fields = knots.array();
    const std::vector<double> values = knots.numbers();
    for (std::size_t k = 1; k < values.size(); ++k) {
        const double step = values[k] - values[k - 1];
        if (step < 0)
            return fields[k].error("is " + precise(values[k]) + ", and the knot before it is " +
                                   precise(values[k - 1]) + "; knots do not decrease: correct one of them");
        if (step > 0 && step < std::numeric_limits<double>::min())
            return fields[k].error(TOO_NEAR);
    }
    const std::size_t first = motion.closed ? 0 : motion.degree - 1;
    const std::size_t last = motion.closed ? values.size() - 1 : motion.controls.size() - 1;
    if (values[first] == values[last])
        return fields[last].error("is " + precise(values[last]) + ", and so is knots[" + std::to_string(first) +
                                  "]: the motion goes from that one to this one and would last no time; make this one "
                                  "larger");
    return fields.at(where).error(
        precise(values[where]) + " comes too often" +
        (motion.closed ? ", counted on from the last knot, which is the first again" : "") + ": a knot may come " +
        std::to_string(motion.degree + 1) + " times at most, the degree and 1; remove some, or move them");
}

Error wrong_weight(const Field &weight)
{
    if (weight.number() <= 0)
        return weight.error("is " + precise(weight.number()) + ", and weights are above 0; correct it");
    return weight.error("times its control is too small or too large to compute with; write a weight nearer to 1");
}

Error cancelling(const Field &pose, const Motion &motion, const Field &root)
{
    const std::string others = motion.degree == 1 ? "the next one" : "the next " + std::to_string(motion.degree);
    const std::string remedy =
        root.has("keys")         ? "put keys in between"
        : root.has("keep_signs") && motion.keep_signs
            ? "leave out \"keep_signs\", so that each control takes the sign of the shortest way"
        : motion.keep_signs ? "write version 2, in which each control takes the sign of the shortest way"
                            : "put controls in between: rotations less than a half turn apart cannot cancel";
    return pose.error((root.has("keys") ? "the controls of this key and " : "this control and ") + others +
                      " cancel on the way, so that the motion has no pose there; " + remedy);
}

} // namespace

void check_motion(mw_status status, std::size_t where, const Motion &motion, const Field &root)
{
    const bool through_keys = root.has("keys");
    const char *const poses = through_keys ? "keys" : "controls";
    switch (status) {
    case MW_ERROR_CONTROL_COUNT:
        throw too_few_poses(root[poses], motion);
    case MW_ERROR_KNOT_COUNT:
        throw wrong_knot_count(root[through_keys ? "times" : "knots"], motion);
    case MW_ERROR_KNOTS:
        throw through_keys ? wrong_time(root["times"], where) : wrong_knot(root["knots"], where, motion);
    case MW_ERROR_WEIGHTS:
        throw wrong_weight(root["weights"].array().at(where));
    case MW_ERROR_VANISHING:
        throw cancelling(root[poses].array().at(where), motion, root);
    case MW_ERROR_CONVERGENCE:
        throw root[poses].error("no motion was found that passes through them; put keys in between where they turn "
                                "far, or lower the degree");
    default:
        check(status, "the motion");
    }
}

} // namespace motorway::tool
