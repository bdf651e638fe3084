// Whether the closed forms of truth.h are what they should be.
#ifndef MOTORWAY_TESTS_ACCURACY_CHECK_TRUTH_H
#define MOTORWAY_TESTS_ACCURACY_CHECK_TRUTH_H

namespace motorway::accuracy {

// The largest relative difference from the power series of the dense reference over random screws.
double check_truth();

}  // namespace motorway::accuracy

#endif
