#include "scalar_math.h"

#include "exact_angle.h"

namespace motorway {
namespace {

std::uint64_t bits_of_double(double x)
{
    std::uint64_t bits;
    __builtin_memcpy(&bits, &x, sizeof x);
    return bits;
}

double double_of_bits(std::uint64_t bits)
{
    double x;
    __builtin_memcpy(&x, &bits, sizeof x);
    return x;
}

// 2^n, for a normal result.
double power_of_two(int n) { return double_of_bits(static_cast<std::uint64_t>(n + 1023) << 52); }

// The upper 26 bits of a number: the product of two such is exact.
double upper_half(double x) { return double_of_bits(bits_of_double(x) & ~((std::uint64_t(1) << 27) - 1)); }

// ------------------------------------------------------------------------------------- sine and cosine

constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

// The power series: their next terms are below 2^-60 of them for angles up to π/4.
double sine_of(double high, double low)
{
    constexpr double terms[] = {-1 / factorial(3), 1 / factorial(5), -1 / factorial(7), 1 / factorial(9),
                                -1 / factorial(11), 1 / factorial(13), -1 / factorial(15), 1 / factorial(17)};
    const double square = high * high;
    double sum = terms[7];
    for (int k = 6; k >= 0; --k)
        sum = sum * square + terms[k];
    return high + (high * square * sum + low * (1 - square / 2));
}

double cosine_of(double high, double low)
{
    constexpr double terms[] = {1 / factorial(4), -1 / factorial(6), 1 / factorial(8), -1 / factorial(10),
                                1 / factorial(12), -1 / factorial(14), 1 / factorial(16), -1 / factorial(18)};
    const double square = high * high, upper = upper_half(high);
    const double rest = (upper * upper - square) + (high - upper) * (high + upper); // of the square, rounded
    double sum = terms[7];
    for (int k = 6; k >= 0; --k)
        sum = sum * square + terms[k];
    const double most = 1 - square / 2;
    return most + (((1 - most) - square / 2) + (square * square * sum - (rest / 2 + high * low)));
}

// --------------------------------------------------------------------------------------------- angles

// The arcs of k/8, in two parts.
constexpr double arcs[][2] = {{0, 0},
                              {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                              {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                              {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                              {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                              {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                              {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                              {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                              {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
constexpr double pi = 0x1.921fb54442d18p+1, pi_rest = 0x1.1a62633145c07p-53;

struct two_parts {
    double high, low;
};

// of - a, where of is the larger.
two_parts difference(const two_parts &of, const two_parts &a)
{
    const double high = of.high - a.high;
    return {high, ((of.high - high) - a.high) + (of.low - a.low)};
}

// atan(smaller / larger), of numbers above 0: the arc of the nearest k/8, and the rest by its power series.
two_parts arc_of(double smaller, double larger)
{
    const double ratio = smaller / larger;
    const int k = ratio > 0 ? static_cast<int>(8 * ratio + 0.5) : 0;
    const double c = k / 8.0, upper = upper_half(larger); // c times it is exact
    const double rest = ((smaller - c * upper) - c * (larger - upper)) / (larger + c * smaller);
    const double square = rest * rest;
    double sum = 0;
    for (int n = 15; n > 1; n -= 2)
        sum = square * ((n % 4 == 1 ? 1.0 : -1.0) / n + sum);
    const double more = arcs[k][1] + rest * sum;
    const double high = arcs[k][0] + rest;
    return {high, (rest - (high - arcs[k][0])) + more};
}

} // namespace

sine_cosine sine_and_cosine(double angle)
{
    if (!__builtin_isfinite(angle))
        return {angle - angle, angle - angle};
    if (angle == 0)
        return {angle, 1};
    const quadrant_angle r = __builtin_fabs(angle) < 0.75 ? quadrant_angle{0, angle, 0} : in_quadrant(angle);
    const double s = sine_of(r.high, r.low), c = cosine_of(r.high, r.low);
    switch (r.quadrant & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
    }
}

double angle_of(double x, double y)
{
    const double across = __builtin_fabs(x);
    if (across == 0 && y == 0)
        return 0;
    two_parts angle = y > across ? difference({pi / 2, pi_rest / 2}, arc_of(across, y)) : arc_of(y, across);
    if (x < 0)
        angle = difference({pi, pi_rest}, angle);
    return angle.high + angle.low;
}

double length_of(double x, double y, double z)
{
    const double a = __builtin_fabs(x), b = __builtin_fabs(y), c = __builtin_fabs(z);
    const double most = a < b ? b : a, largest = most < c ? c : most;
    const bool finite = __builtin_isfinite(a) && __builtin_isfinite(b) && __builtin_isfinite(c);
    if (largest == 0 || !finite)
        return a + b + c;
    const int n = exponent_of(largest);
    const double p = times_power_of_two(a, -n), q = times_power_of_two(b, -n), r = times_power_of_two(c, -n);
    return times_power_of_two(square_root(p * p + q * q + r * r), n);
}

int exponent_of(double x)
{
    const auto biased = [](double of) { return static_cast<int>(bits_of_double(of) >> 52 & 0x7ff); };
    return biased(x) ? biased(x) - 1022 : biased(x * 0x1p54) - 1022 - 54;
}

double times_power_of_two(double x, int n) { return x * power_of_two(n / 2) * power_of_two(n - n / 2); }

} // namespace motorway
