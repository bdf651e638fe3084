/* motorway info: the CPU, its instruction sets and the kernels. */
#ifndef MOTORWAY_TOOL_INFO_COMMAND_H
#define MOTORWAY_TOOL_INFO_COMMAND_H

namespace motorway::tool {

/* Throws an Error if MOTORWAY_ISA asks for what cannot run here. */
void run_info();

} // namespace motorway::tool

#endif
