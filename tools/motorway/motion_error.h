/* What the library says is wrong with a motion, in the words of its file: which field, which number, what to do. */
#ifndef MOTORWAY_TOOL_MOTION_ERROR_H
#define MOTORWAY_TOOL_MOTION_ERROR_H

#include <cstddef>

#include "json_field.h"
#include "motion.h"
#include "motorway_views.h"

namespace motorway::tool {

/* Throws an Error unless the status is MW_OK; `where` is the number that the library said. */
void check_motion(mw_status status, std::size_t where, const Motion &motion, const Field &root);

} // namespace motorway::tool

#endif
