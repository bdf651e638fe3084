// Parameters equally far apart.
#pragma once

#include <algorithm>
#include <cstddef>

namespace motorway {

// Number i of `count` from `begin` to `end`, which are the first and the last. One alone is the first.
template <class T> T evenly_spaced(T begin, T end, std::size_t i, std::size_t count)
{
    if (count == 1)
        return begin;
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    const double between = (1 - part) * static_cast<double>(begin) + part * static_cast<double>(end);
    return std::clamp(static_cast<T>(between), begin, end);
}

} // namespace motorway
