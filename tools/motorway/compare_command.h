/* motorway compare: how far apart two motions carry a mesh. */
#ifndef MOTORWAY_TOOL_COMPARE_COMMAND_H
#define MOTORWAY_TOOL_COMPARE_COMMAND_H

#include <optional>
#include <string>

namespace motorway::tool {

struct CompareOptions {
    std::string first, second, mesh;
    std::string against; /* a scheme: the second motion is the first file read with it */
    long long samples = 1001;
    std::optional<double> scale; /* nothing: what the first motion file asks for, else 1 */
};

void run_compare(const CompareOptions &options);

} // namespace motorway::tool

#endif
