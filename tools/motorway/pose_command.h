/* motorway pose: a mesh along a motion, into files. */
#ifndef MOTORWAY_TOOL_POSE_COMMAND_H
#define MOTORWAY_TOOL_POSE_COMMAND_H

#include <optional>
#include <string>

namespace motorway::tool {

struct PoseOptions {
    std::string mesh, motion, out;
    long long frames = 0;
    std::optional<double> scale; /* nothing: what the motion file asks for, else 1 */
    double frames_per_second = 30;
    std::string picture; /* empty: none */
    long long picture_poses = 9;
};

/* Throws an Error, and then has written nothing. */
void run_pose(const PoseOptions &options);

} // namespace motorway::tool

#endif
