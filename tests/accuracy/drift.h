// What is left of S̄S = 1 in long products.
#ifndef MOTORWAY_TESTS_ACCURACY_DRIFT_H
#define MOTORWAY_TESTS_ACCURACY_DRIFT_H

#include <cstddef>
#include <string>
#include <vector>

namespace motorway::accuracy {

constexpr std::size_t drift_products = 1000000, drift_renormalised_every = 64;

// The largest |α - 1| of S̄S = α + βω: how much longer than they should be rotated vectors are.
struct Drift {
    std::string isa_class;
    double before, after;  // renormalising
    double pseudoscalar;   // the largest |β| after it, relative to the translation
};

// Of a few products at once, each of as many motors.
template <class T>
std::vector<Drift> measure_drift();

}  // namespace motorway::accuracy

#endif
