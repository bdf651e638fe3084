#include "run_tool.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace motorway::tool {

static std::string contents_of(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream contents;
    contents << file.rdbuf();
    return contents.str();
}

/* In the child: files for its output, then the limits, then the tool. Returns only if that fails. */
static void become_tool(const fs::path &folder, const std::vector<std::string> &arguments, const ToolLimits &limits,
                        const fs::path &capture)
{
    const int out = open((capture / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = open((capture / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0 || err < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(err, STDERR_FILENO) < 0 ||
        chdir(folder.c_str()) != 0)
        return;
    unsetenv("MOTORWAY_ISA");
    if (!limits.isa.empty())
        setenv("MOTORWAY_ISA", limits.isa.c_str(), 1);
    if (limits.largest_file >= 0) {
        const rlimit limit = {static_cast<rlim_t>(limits.largest_file), static_cast<rlim_t>(limits.largest_file)};
        std::signal(SIGXFSZ, SIG_IGN); /* so that the write fails instead of ending the process */
        if (setrlimit(RLIMIT_FSIZE, &limit) != 0)
            return;
    }
    std::string program = MOTORWAY_TOOL;
    std::vector<std::string> copies = arguments;
    std::vector<char *> pointers = {program.data()};
    for (std::string &argument : copies)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
}

ToolResult run_tool(const fs::path &folder, const std::vector<std::string> &arguments, const ToolLimits &limits)
{
    const TemporaryFolder capture;
    const pid_t child = fork();
    if (child == 0) {
        become_tool(folder, arguments, limits, capture.path());
        _exit(126);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        throw std::runtime_error("cannot run the tool");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents_of(capture.path() / "out"),
            contents_of(capture.path() / "err")};
}

TemporaryFolder::TemporaryFolder()
{
    std::string name = (fs::temp_directory_path() / "motorway-test-XXXXXX").string();
    if (!mkdtemp(name.data()))
        throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string &name, const std::string &contents) const
{
    std::ofstream(path_ / name, std::ios::binary) << contents;
}

std::string TemporaryFolder::read(const std::string &name) const
{
    return contents_of(path_ / name);
}

std::vector<std::string> TemporaryFolder::list() const
{
    std::vector<std::string> names;
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator(path_))
        names.push_back(entry.path().lexically_relative(path_).string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace motorway::tool
