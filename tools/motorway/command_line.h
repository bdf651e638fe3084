/* A command line in the words of the tool: which values options take, and what is wrong with it. */
#ifndef MOTORWAY_TOOL_COMMAND_LINE_H
#define MOTORWAY_TOOL_COMMAND_LINE_H

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace motorway::tool {

/* Checks of the value of an option, before it is converted. */
CLI::Validator whole_number();
CLI::Validator number();
CLI::Validator one_of(const std::vector<std::string> &words);

/* What is wrong, and what to do: an unknown word with the one that is near, all that is missing at once. */
std::string describe_mistake(const CLI::App &app, const CLI::ParseError &problem);

} // namespace motorway::tool

#endif
