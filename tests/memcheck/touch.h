// Numbers looked at as memcheck understands it: by a jump that depends on them.
#ifndef MOTORWAY_TESTS_MEMCHECK_TOUCH_H
#define MOTORWAY_TESTS_MEMCHECK_TOUCH_H

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "motorway_views.h"

namespace motorway::memcheck {

inline void touch(const void *bytes, std::size_t size)
{
    unsigned sum = 0;
    for (std::size_t k = 0; k < size; ++k)
        sum += static_cast<const unsigned char *>(bytes)[k];
    if (sum == 256 * 16 + 1)  // more than so few bytes come to
        std::printf(" ");
}

template <class T>
void touch(const T &value)
{
    touch(static_cast<const void *>(&value), sizeof value);
}

template <class T>
void touch_all(const std::vector<T> &values)
{
    for (const T &value : values)
        touch(value);
}

inline void must(mw_status status, const char *what)
{
    if (status != MW_OK) {
        std::printf("%s: %s\n", what, mw_status_text(status));
        std::exit(1);
    }
}

}  // namespace motorway::memcheck

#endif
