/* What the CPU calls itself. */
#ifndef MOTORWAY_TOOL_CPU_NAME_H
#define MOTORWAY_TOOL_CPU_NAME_H

#include <string>

namespace motorway::tool {

/* "unknown" where the system does not tell. */
std::string cpu_name();

} // namespace motorway::tool

#endif
