// The numbers in which true values are computed.
#ifndef MOTORWAY_TESTS_ACCURACY_NUMBERS_H
#define MOTORWAY_TESTS_ACCURACY_NUMBERS_H

#include <limits>

#include <boost/multiprecision/cpp_bin_float.hpp>
#if defined(__SIZEOF_FLOAT128__) && __has_include(<quadmath.h>)
#define MOTORWAY_ACCURACY_HAS_FLOAT128
#include <boost/multiprecision/float128.hpp>
#endif

namespace motorway::accuracy {

// 34 digits, of which double leaves 18 to spare: every element is judged by these.
#ifdef MOTORWAY_ACCURACY_HAS_FLOAT128
using Quad = boost::multiprecision::float128;
#else
using Quad = boost::multiprecision::cpp_bin_float_quad;  // the same, many times as slow
#endif
static_assert(std::numeric_limits<Quad>::digits == 113, "quadruple precision");

// 50 digits, slow: some of the elements are judged by these as well, and both must agree.
using Deep = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

}  // namespace motorway::accuracy

#endif
