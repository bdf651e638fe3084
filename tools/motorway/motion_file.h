/* Motion files: docs/motion-format.md. */
#ifndef MOTORWAY_TOOL_MOTION_FILE_H
#define MOTORWAY_TOOL_MOTION_FILE_H

#include <string>

#include "motion.h"

namespace motorway::tool {

/* The motion of a file, compiled; with a scheme, read as if that stood in the file in place of its own. Throws an
 * Error with the file, the line and the path of the field, such as controls[3].steps[1].translate[0]. */
Motion read_motion(const std::string &path, const std::string &scheme = "");

/* The same from the contents of a file; `path` is only named in errors. */
Motion parse_motion(const std::string &contents, const std::string &path, const std::string &scheme = "");

} // namespace motorway::tool

#endif
