// Ways to pass over memory. The machine's limit at a size is the fastest of them. Sizes are multiples of 256 bytes,
// and pointers begin a cache line.
#pragma once

#include <cstddef>
#include <vector>

namespace motorway::bench {

struct copy_method {
    const char *name;
    void (*run)(void *to, const void *from, std::size_t size);
};
struct fill_method {
    const char *name;
    void (*run)(void *to, std::size_t size);
};
struct read_method {
    const char *name;
    void (*run)(const void *from, std::size_t size);
};
std::vector<copy_method> copy_methods();
std::vector<fill_method> fill_methods();
std::vector<read_method> read_methods();

} // namespace motorway::bench
