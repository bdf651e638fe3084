// A number of twice the precision of long double, for the reference: about 128 bits on x86-64, 106 at the least.
//
// The dense reference multiplies in the basis e+ e-, where e∞² = 0 is the cancellation of two large products, so
// long double alone would not be exact enough to judge doubles. A number is the unevaluated sum high + low; sums and
// products are those of Dekker (1971) and Knuth, whose errors are found exactly.
#ifndef MOTORWAY_TESTS_EXTENDED_H
#define MOTORWAY_TESTS_EXTENDED_H

#include <cmath>
#include <limits>

namespace motorway::reference {

struct Extended {
    long double high = 0;
    long double low = 0;

    Extended() = default;
    Extended(long double value) : high(value) {}
    Extended(long double h, long double l) : high(h), low(l) {}

    explicit operator long double() const { return high + low; }
};

inline Extended quick_two_sum(long double large, long double small)
{
    const long double sum = large + small;
    return {sum, small - (sum - large)};
}

inline Extended two_sum(long double a, long double b)
{
    const long double sum = a + b;
    const long double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

// The halves of a significand: products of two halves are exact.
inline Extended split(long double a)
{
    constexpr int half = (std::numeric_limits<long double>::digits + 1) / 2;
    constexpr long double factor = static_cast<long double>(1ull << (half < 63 ? half : 63)) + 1;
    const long double scaled = factor * a;
    const long double high = scaled - (scaled - a);
    return {high, a - high};
}

inline Extended two_product(long double a, long double b)
{
    const long double product = a * b;
    const Extended x = split(a), y = split(b);
    return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

inline Extended operator-(const Extended &a) { return {-a.high, -a.low}; }

inline Extended operator+(const Extended &a, const Extended &b)
{
    const Extended high = two_sum(a.high, b.high);
    const Extended low = two_sum(a.low, b.low);
    const Extended sum = quick_two_sum(high.high, high.low + low.high);
    return quick_two_sum(sum.high, sum.low + low.low);
}

inline Extended operator-(const Extended &a, const Extended &b) { return a + (-b); }

inline Extended operator*(const Extended &a, const Extended &b)
{
    const Extended product = two_product(a.high, b.high);
    return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline Extended operator/(const Extended &a, const Extended &b)
{
    const long double first = a.high / b.high;
    const Extended rest = a - b * Extended(first);
    const long double second = rest.high / b.high;
    const Extended last = rest - b * Extended(second);
    return quick_two_sum(first, second) + Extended(last.high / b.high);
}

inline Extended &operator+=(Extended &a, const Extended &b) { return a = a + b; }

inline bool operator==(const Extended &a, const Extended &b) { return a.high == b.high && a.low == b.low; }
inline bool operator!=(const Extended &a, const Extended &b) { return !(a == b); }
inline bool operator<(const Extended &a, const Extended &b)
{
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}

inline Extended abs(const Extended &a) { return a < Extended(0) ? -a : a; }

inline Extended sqrt(const Extended &a)
{
    if (a == Extended(0))
        return a;
    const long double root = std::sqrt(a.high);
    return Extended(root) + (a - two_product(root, root)) / Extended(2 * root);
}

}  // namespace motorway::reference

#endif
