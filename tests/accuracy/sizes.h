// True values by their own sizes, and what the tables call sizes.
#ifndef MOTORWAY_TESTS_ACCURACY_SIZES_H
#define MOTORWAY_TESTS_ACCURACY_SIZES_H

#include <algorithm>

#include "measure.h"
#include "truth.h"

namespace motorway::accuracy {

constexpr const char *of_1 = "1", *itself = "the true one";
constexpr const char *own_size = ", of its own size";  // ends the name of what is also measured by another

template <class R>
Truth<R> by_its_own_size(const Motor<R> &motor)
{
    return {motor, 1, length(motor, 4, 8)};
}

template <class R>
Truth<R> by_its_own_size(const Bivector<R> &bivector)
{
    Truth<R> truth;
    std::copy(bivector.begin(), bivector.end(), truth.value.begin());
    truth.rotation = length(bivector, 0, 3);
    truth.translation = length(bivector, 3, 6);
    return truth;
}

}  // namespace motorway::accuracy

#endif
