// The numbers that the fuzzer computes in: of many more digits than those it judges, and of so many more exponents
// that products of eight of the largest or of the smallest are nothing special.
#ifndef MOTORWAY_TESTS_FUZZ_WIDE_H
#define MOTORWAY_TESTS_FUZZ_WIDE_H

#include <cfloat>
#include <cmath>
#include <limits>

#if LDBL_MANT_DIG < 113
#include <quadmath.h>
#endif

namespace motorway::fuzz {

#if LDBL_MANT_DIG < 113
__extension__ typedef __float128 Quad;
inline Quad sqrt(Quad x) { return sqrtq(x); }
inline Quad sin(Quad x) { return sinq(x); }
inline Quad cos(Quad x) { return cosq(x); }
inline Quad atan2(Quad y, Quad x) { return atan2q(y, x); }
inline Quad abs(Quad x) { return fabsq(x); }
inline Quad remainder(Quad x, Quad y) { return remainderq(x, y); }
inline Quad scaled(Quad x, int exponent) { return scalbnq(x, exponent); }
inline bool is_finite(Quad x) { return finiteq(x); }
#else
using Quad = long double;
#endif

inline long double sqrt(long double x) { return std::sqrt(x); }
inline long double sin(long double x) { return std::sin(x); }
inline long double cos(long double x) { return std::cos(x); }
inline long double atan2(long double y, long double x) { return std::atan2(y, x); }
inline long double abs(long double x) { return std::fabs(x); }
inline long double remainder(long double x, long double y) { return std::remainder(x, y); }
inline long double scaled(long double x, int exponent) { return std::scalbn(x, exponent); }
inline bool is_finite(long double x) { return std::isfinite(x); }

static_assert(LDBL_MAX_EXP >= 8 * FLT_MAX_EXP && LDBL_MANT_DIG >= 64, "long double is too narrow to judge floats");

template <class T>
struct WideOf;
template <>
struct WideOf<float> {
    using type = long double;
};
template <>
struct WideOf<double> {
    using type = Quad;
};
template <class T>
using Wide = typename WideOf<T>::type;

// π to 128 bits, as a sum of two numbers that both types hold.
template <class R>
R pi()
{
    return R(0x1.921fb54442d18468p+1L) + R(0x1.898cc51701b839a2p-63L);
}

template <class R>
R larger(R a, R b)
{
    return a < b ? b : a;
}
template <class R>
R smaller(R a, R b)
{
    return b < a ? b : a;
}

template <class T>
Wide<T> epsilon()
{
    return std::numeric_limits<T>::epsilon();
}
template <class T>
Wide<T> smallest()
{
    return std::numeric_limits<T>::denorm_min();
}
template <class T>
Wide<T> largest()
{
    return std::numeric_limits<T>::max();
}

// Where motors may have any length formulas take α times lengths, and the library leaves an α as it is that is no
// further from 1 than 2^20, in double 2^200. By how much lengths must stay below the largest number, and by how much
// more than usual is lost of those near the smallest.
template <class T>
Wide<T> headroom()
{
    return scaled(Wide<T>(1), sizeof(T) == 4 ? 26 : 208);
}
template <class T>
Wide<T> footroom()
{
    return scaled(Wide<T>(1), sizeof(T) == 4 ? 22 : 202);
}

}  // namespace motorway::fuzz

#endif
