#include "files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

#include "error.h"

namespace fs = std::filesystem;

namespace motorway::tool {

std::string read_file(const std::string &path)
{
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw Error(path, "is a folder; name a file");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(path, std::string("cannot be opened (") + std::strerror(errno) + "); check the path");
    std::string contents;
    char block[1 << 16];
    while (file.read(block, sizeof block) || file.gcount() > 0)
        contents.append(block, static_cast<std::size_t>(file.gcount()));
    if (file.bad())
        throw Error(path, std::string("cannot be read (") + std::strerror(errno) + "); check the file");
    return contents;
}

std::string extension(const std::string &path)
{
    std::string suffix = fs::path(path).extension().string();
    for (char &c : suffix)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return suffix;
}

/* A name beside `path` that nobody else has: another run of the tool may be writing to the same place. */
static std::string temporary_beside(const std::string &path)
{
    static std::random_device random;
    std::string name;
    std::error_code ignored;
    do {
        char suffix[16];
        std::snprintf(suffix, sizeof suffix, ".%08x.tmp", static_cast<unsigned>(random()));
        name = path + suffix;
    } while (fs::exists(name, ignored));
    return name;
}

static void remove_quietly(const std::string &path)
{
    std::error_code ignored;
    fs::remove(path, ignored);
}

static Error cannot_write(const std::string &path, const char *reason)
{
    return Error(path, std::string("cannot be written (") + reason + "); check the folder and the space on the disk");
}

static void write_now(const std::string &path, const std::string &temporary, const std::string &contents)
{
    errno = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    file.close();
    if (!file)
        throw cannot_write(path, errno ? std::strerror(errno) : "the disk refused it");
}

OutputFiles::~OutputFiles()
{
    if (committed_)
        return;
    for (const File &file : files_)
        remove_quietly(file.temporary);
}

void OutputFiles::check(const std::string &path)
{
    const fs::path folder = fs::path(path).parent_path();
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw Error(path, "is a folder; name a file to write");
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw Error(path, "the folder " + folder.string() + " does not exist; make it first");
    const std::string temporary = temporary_beside(path);
    try {
        write_now(path, temporary, "");
    } catch (const Error &) {
        remove_quietly(temporary);
        throw;
    }
    remove_quietly(temporary);
}

void OutputFiles::write(const std::string &path, const std::string &contents)
{
    files_.push_back({path, temporary_beside(path), contents.size()});
    write_now(path, files_.back().temporary, contents);
}

void OutputFiles::commit()
{
    for (std::size_t k = 0; k < files_.size(); ++k) {
        std::error_code failure;
        fs::rename(files_[k].temporary, files_[k].path, failure);
        if (!failure)
            continue;
        for (std::size_t done = 0; done < k; ++done)
            remove_quietly(files_[done].path);
        throw cannot_write(files_[k].path, failure.message().c_str());
    }
    committed_ = true;
}

} // namespace motorway::tool
