/* The poses of a motion file, in every form that docs/motion-format.md describes. */
#ifndef MOTORWAY_TOOL_POSE_FIELD_H
#define MOTORWAY_TOOL_POSE_FIELD_H

#include <vector>

#include "json_field.h"
#include "motorway_views.h"

namespace motorway::tool {

/* Throws an Error that names the field. */
mw_motor_f64 read_pose(const Field &pose);
std::vector<mw_motor_f64> read_poses(const Field &poses);

} // namespace motorway::tool

#endif
