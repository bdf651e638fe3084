/* Files in and out: whole or not at all. */
#ifndef MOTORWAY_TOOL_FILES_H
#define MOTORWAY_TOOL_FILES_H

#include <cstdint>
#include <string>
#include <vector>

namespace motorway::tool {

/* The whole file. Throws an Error that names it. */
std::string read_file(const std::string &path);

/* The extension of a path in lower case, with its dot: ".ply". Empty if there is none. */
std::string extension(const std::string &path);

/* A set of files that appear together or not at all: each is written under a temporary name beside its place, and
 * commit() renames them all. What was not committed is removed by the destructor. */
class OutputFiles {
public:
    struct File {
        std::string path;
        std::string temporary;
        std::uintmax_t bytes;
    };

    OutputFiles() = default;
    OutputFiles(const OutputFiles &) = delete;
    OutputFiles &operator=(const OutputFiles &) = delete;
    ~OutputFiles();

    /* Throws an Error unless a file could be written at `path`. Made for asking before any work is done. */
    static void check(const std::string &path);

    void write(const std::string &path, const std::string &contents);
    void commit();

    const std::vector<File> &files() const { return files_; }

private:
    std::vector<File> files_;
    bool committed_ = false;
};

} // namespace motorway::tool

#endif
