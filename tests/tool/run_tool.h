/* Runs the real binary, in a folder of its own that goes away afterwards. */
#ifndef MOTORWAY_TESTS_RUN_TOOL_H
#define MOTORWAY_TESTS_RUN_TOOL_H

#include <filesystem>
#include <string>
#include <vector>

namespace motorway::tool {

struct ToolResult {
    int exit_code; /* -1 if it crashed */
    std::string out, err;
};

struct ToolLimits {
    std::string isa;             /* MOTORWAY_ISA, unless empty */
    long long largest_file = -1; /* bytes: writing more fails as on a full disk; -1: any */
};

/* Runs `motorway` with these arguments inside `folder`. */
ToolResult run_tool(const std::filesystem::path &folder, const std::vector<std::string> &arguments,
                    const ToolLimits &limits = {});

class TemporaryFolder {
public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;
    ~TemporaryFolder();

    const std::filesystem::path &path() const { return path_; }
    void write(const std::string &name, const std::string &contents) const;
    std::string read(const std::string &name) const;

    /* The names of all files and folders in it, sorted. */
    std::vector<std::string> list() const;

private:
    std::filesystem::path path_;
};

} // namespace motorway::tool

#endif
