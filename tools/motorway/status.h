/* What the library answers, as an error of the tool. */
#ifndef MOTORWAY_TOOL_STATUS_H
#define MOTORWAY_TOOL_STATUS_H

#include <string>

#include "error.h"
#include "motorway_views.h"

namespace motorway::tool {

inline void check(mw_status status, const std::string &where)
{
    if (status == MW_ERROR_ISA)
        throw Error("MOTORWAY_ISA", mw_status_text(status));
    if (status != MW_OK)
        throw Error(where, mw_status_text(status));
}

} // namespace motorway::tool

#endif
