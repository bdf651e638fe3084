/* motorway sample: the poses of a motion, as numbers. */
#ifndef MOTORWAY_TOOL_SAMPLE_COMMAND_H
#define MOTORWAY_TOOL_SAMPLE_COMMAND_H

#include <string>

namespace motorway::tool {

struct SampleOptions {
    std::string motion;
    long long count = 0;
    bool velocity = false;
    std::string frame = "space"; /* or "body" */
    std::string even;            /* X,Y,Z: the point whose way the samples divide evenly; empty: even parameters */
    std::string format;          /* "csv", "json"; empty: what the extension of `out` says, else csv */
    std::string out;             /* empty: the standard output */
};

/* Throws an Error, and then has written nothing. */
void run_sample(const SampleOptions &options);

} // namespace motorway::tool

#endif
