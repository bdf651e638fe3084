// Both precisions, as the types of a typed test suite whose tests are then called f32 and f64.
#ifndef MOTORWAY_TESTS_PRECISIONS_H
#define MOTORWAY_TESTS_PRECISIONS_H

#include <string>

#include <gtest/gtest.h>

#include "api.h"

namespace motorway::testing {

using Precisions = ::testing::Types<float, double>;

struct PrecisionName {
    template <class T>
    static std::string GetName(int)
    {
        return api<T>::name;
    }
};

}  // namespace motorway::testing

#endif
