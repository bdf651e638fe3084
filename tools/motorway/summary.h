/* The summary that a command prints: labels, and what they stand for. */
#ifndef MOTORWAY_TOOL_SUMMARY_H
#define MOTORWAY_TOOL_SUMMARY_H

#include <string>
#include <vector>

#include "files.h"
#include "mesh.h"
#include "motion.h"
#include "scaling.h"

namespace motorway::tool {

/* "multiplicative motion of degree 3, 4 control poses". */
std::string description(const Motion &motion);

/* A line; without a label, one more of what the last label stands for. */
void print_line(const char *label, const std::string &text);

/* `left_out` is what the files that are written do not hold of it. */
void print_mesh(const std::string &path, const Mesh &mesh, const Scaling &scaling,
                const std::vector<std::string> &left_out = {});

/* What may be a mistake in the mesh, on the standard error. */
void print_warnings(const std::string &path, const Mesh &mesh);

void print_motion(const char *label, const std::string &path, const Motion &motion);

/* A few files by name, a long sequence by its ends. */
void print_files(const std::vector<OutputFiles::File> &files);

} // namespace motorway::tool

#endif
