// All that is measured.
#ifndef MOTORWAY_TESTS_ACCURACY_CASES_H
#define MOTORWAY_TESTS_ACCURACY_CASES_H

#include <functional>
#include <string>
#include <vector>

#include "measure.h"

namespace motorway::accuracy {

// exp, log, roots and powers; products, interpolation and normalising; against their true values.
template <class T>
std::vector<Case<T>> exponential_cases();
template <class T>
std::vector<Case<T>> product_cases();

// Functions that should undo each other, against what went in.
template <class T>
std::vector<Case<T>> identity_cases();

// To another representation and back.
template <class T>
std::vector<Case<T>> conversion_cases();

// What is drawn against the angle: the case for any angles.
template <class T>
struct Curve {
    std::string name;
    std::function<Case<T>(const Angles &)> at;
};
template <class T>
std::vector<Curve<T>> exponential_curves();
template <class T>
std::vector<Curve<T>> product_curves();

}  // namespace motorway::accuracy

#endif
