// The list of baselines. The build writes baseline_list.inc: MOTORWAY_LIBRARY for every library that it found, and
// MOTORWAY_PLAIN for every compiler and set of flags.
#include "baseline.h"
#include "baseline_plain.h"

namespace motorway::bench {

#define MOTORWAY_LIBRARY(library, name) template <class T> work bind_##library(const problem<T> &);
#define MOTORWAY_PLAIN(table, name) extern "C" const plain_table table;
#include "baseline_list.inc"
#undef MOTORWAY_LIBRARY
#undef MOTORWAY_PLAIN

template <class T> void add_libraries(std::vector<baseline<T>> &list)
{
#define MOTORWAY_LIBRARY(library, name) list.push_back({name, bind_##library<T>});
#define MOTORWAY_PLAIN(table, name)
#include "baseline_list.inc"
#undef MOTORWAY_LIBRARY
#undef MOTORWAY_PLAIN
}

// None of the libraries has motions of double for points of float.
void add_libraries(std::vector<baseline<float, double>> &) {}

template <class T, class M> const std::vector<baseline<T, M>> &baselines()
{
    static const std::vector<baseline<T, M>> all = [] {
        std::vector<baseline<T, M>> list;
        add_libraries(list);
#define MOTORWAY_LIBRARY(library, name)
#define MOTORWAY_PLAIN(table, name)                                                                                  \
    if (can_run(table))                                                                                              \
        list.push_back({name, [](const problem<T, M> &p) { return bind_plain(table, p); }});
#include "baseline_list.inc"
#undef MOTORWAY_LIBRARY
#undef MOTORWAY_PLAIN
        return list;
    }();
    return all;
}

template const std::vector<baseline<float>> &baselines();
template const std::vector<baseline<double>> &baselines();
template const std::vector<baseline<float, double>> &baselines();

std::vector<std::string> skipped_baselines()
{
    std::vector<std::string> skipped;
#define MOTORWAY_LIBRARY(library, name)
#define MOTORWAY_PLAIN(table, name)                                                                                  \
    if (!can_run(table))                                                                                             \
        skipped.push_back(name);
#include "baseline_list.inc"
#undef MOTORWAY_LIBRARY
#undef MOTORWAY_PLAIN
    return skipped;
}

} // namespace motorway::bench
