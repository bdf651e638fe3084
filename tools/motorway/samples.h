/* Samples of a motion, as a table of numbers and as text. */
#ifndef MOTORWAY_TOOL_SAMPLES_H
#define MOTORWAY_TOOL_SAMPLES_H

#include <optional>
#include <string>
#include <vector>

#include "motion.h"

namespace motorway::tool {

enum class Frame { SPACE, BODY };

struct Samples {
    /* What belongs together: "translation", of the columns tx, ty and tz; the values of one sample after the other.
     */
    struct Quantity {
        std::string name;
        std::vector<std::string> columns;
        std::vector<double> values;
    };

    std::vector<double> parameters;
    std::vector<Quantity> quantities;
    std::optional<Frame> frame; /* of the velocities, if there are any */
};

/* The motor of each, its quaternion and translation, and, if a frame is given, how fast the body turns and its origin
 * moves. */
Samples take_samples(const Motion &motion, const std::vector<double> &parameters, std::optional<Frame> velocities);

/* Numbers are written so that they read back as the same doubles. */
std::string write_csv(const Samples &samples);
std::string write_json(const Samples &samples, const Motion &motion);

} // namespace motorway::tool

#endif
