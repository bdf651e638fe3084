// What may lie over what, byte by byte, without the case distinctions of the library.
#ifndef MOTORWAY_TESTS_OVERLAP_H
#define MOTORWAY_TESTS_OVERLAP_H

#include <cstddef>
#include <cstdint>

#include "api.h"

namespace motorway::testing {

// Whether an element of `out` has a byte in common with another element of `in`; if they are of different precisions,
// which is never in place, also with the same one.
template <class T>
bool lies_over_another_element(const View<T> &out, const View<T> &in, std::size_t in_scalar, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            if (i == j && in_scalar == sizeof(T))
                continue;
            for (const T *to : out.component)
                for (const T *from : in.component) {
                    const auto a = reinterpret_cast<std::uintptr_t>(to) + i * out.stride;
                    const auto b = reinterpret_cast<std::uintptr_t>(from) + j * in.stride;
                    if (a < b + in_scalar && b < a + sizeof(T))
                        return true;
                }
        }
    return false;
}

}  // namespace motorway::testing

#endif
