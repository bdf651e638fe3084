#include "exact_angle.h"

#include "scalar_math.h"

#include <cstdint>

namespace motorway {
namespace {

// The bits of 1/(2π) behind the point, the highest first.
constexpr std::uint32_t inverse_two_pi[] = {
#include "../generated/inverse_two_pi.inc"
};
constexpr int inverse_words = sizeof inverse_two_pi / sizeof *inverse_two_pi;
constexpr double two_pi = 0x1.921fb54442d18p+2, two_pi_rest = 0x1.1a62633145c07p-52;

std::uint64_t inverse_word(int k) { return k < 0 || k >= inverse_words ? 0 : inverse_two_pi[k]; }

struct two_parts {
    double high, low;
};

// The sum of a larger number and a smaller one.
two_parts sum(double large, double small)
{
    const double high = large + small;
    return {high, small - (high - large)};
}

// a b, exactly (Dekker).
two_parts product(double a, double b)
{
    const auto upper_half = [](double x) {
        const double shifted = x * 0x8000001p0;
        return shifted - (shifted - x);
    };
    const double high = a * b, a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
    return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
}

// A part of a turn, in [-1/2, 1/2): the bits behind the point, the highest first, in two's complement.
class turn_part {
    static constexpr int words = 8, mantissa_words = 3;
    std::uint32_t word[words] = {};

    turn_part() = default;

public:
    // Of the angle value 2^exponent >= 0. Bits of 1/(2π) that would make whole turns are left out.
    turn_part(double value, int exponent)
    {
        if (value < 0x1p-1022) // a subnormal number makes no difference
            return;
        std::uint64_t bits;
        __builtin_memcpy(&bits, &value, sizeof bits);
        const std::uint64_t implicit = std::uint64_t(1) << 52, mantissa = (bits & (implicit - 1)) | implicit;
        const int last_bit = exponent_of(value) - 53 + exponent;
        const int first = last_bit >= 0 ? last_bit / 32 : -((31 - last_bit) / 32), shift = last_bit - 32 * first;
        const std::uint64_t low = mantissa << shift, high = shift ? mantissa >> (64 - shift) : 0;
        const std::uint64_t factor[mantissa_words] = {low & 0xffffffff, low >> 32, high};
        for (int a = 0; a < mantissa_words; ++a) {
            std::uint64_t carry = 0;
            for (int k = words - 1; k >= 0; --k, carry >>= 32) {
                carry += factor[a] * inverse_word(first + k + a) + word[k];
                word[k] = static_cast<std::uint32_t>(carry);
            }
        }
    }

    // Adds another, or takes it off.
    void add(const turn_part &other, bool take_off)
    {
        std::uint64_t carry = take_off ? 1 : 0;
        for (int k = words - 1; k >= 0; --k, carry >>= 32) {
            carry += std::uint64_t(word[k]) + (take_off ? ~other.word[k] : other.word[k]);
            word[k] = static_cast<std::uint32_t>(carry);
        }
    }

    // Takes the nearest quarter of a turn off, and returns which it was.
    int take_quarter_off()
    {
        const std::uint32_t quarter = (word[0] + 0x20000000) >> 30;
        word[0] -= quarter << 30;
        return static_cast<int>(quarter);
    }

    // The angle, the high part of which is rounded once.
    two_parts angle() const
    {
        const bool negative = word[0] >> 31;
        turn_part part = *this;
        if (negative) {
            part = turn_part();
            part.add(*this, true);
        }
        int first = 0;
        while (first < words && part.word[first] == 0)
            ++first;
        if (first == words)
            return {0, 0};
        const auto next = [&](int k) { return std::uint64_t(first + k < words ? part.word[first + k] : 0); };
        const int zeros = __builtin_clz(part.word[first]);
        // The leading 53 bits, and 43 more.
        const std::uint64_t leading = (next(0) << 32 | next(1)) << zeros | (next(2) << zeros) >> 32;
        const std::uint64_t following = ((next(2) << 32 | next(3)) << zeros) >> 32;
        const double head = static_cast<double>(leading >> 11);
        const double tail = static_cast<double>((leading & 0x7ff) << 32 | following) * 0x1p-43;
        const two_parts main = product(head, two_pi);
        const two_parts all = sum(main.high, main.low + (head * two_pi_rest + tail * two_pi));
        const double unit = times_power_of_two(negative ? -1 : 1, -53 - zeros - 32 * first);
        return {all.high * unit, all.low * unit};
    }
};

double magnitude(double x) { return __builtin_fabs(x); }

} // namespace

double without_turns(double angle)
{
    const double result = turn_part(magnitude(angle), 0).angle().high;
    return angle < 0 ? -result : result;
}

quadrant_angle in_quadrant(double angle)
{
    turn_part part(magnitude(angle), 0);
    const int quadrant = part.take_quarter_off();
    const two_parts rest = part.angle();
    return angle < 0 ? quadrant_angle{-quadrant, -rest.high, -rest.low} : quadrant_angle{quadrant, rest.high, rest.low};
}

void take_turns_off(double *bivector)
{
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = largest < magnitude(bivector[k]) ? magnitude(bivector[k]) : largest;
    const int exponent = exponent_of(largest);
    // |b|² of what is scaled to 1/2 <= |b| < 2, and its root, to twice the precision.
    double b[3], square = 0, lost = 0;
    for (int k = 0; k < 3; ++k) {
        b[k] = times_power_of_two(bivector[k], -exponent);
        const two_parts next = product(b[k], b[k]);
        const double total = square + next.high, part = total - square;
        lost += ((square - (total - part)) + (next.high - part)) + next.low;
        square = total;
    }
    const double length = square_root(square);
    const two_parts again = product(length, length);
    const double rest = ((square - again.high) - again.low + lost) / (2 * length);

    turn_part turned(length, exponent);
    turned.add(turn_part(magnitude(rest), exponent), rest < 0);
    const double angle = turned.angle().high, shrink = times_power_of_two(angle / length, -exponent);
    const double a12 = b[0] / length, a13 = b[1] / length, a23 = b[2] / length;
    double *const moment = bivector + 3;
    const double along = a12 * moment[2] - a13 * moment[1] + a23 * moment[0];
    const double along_axis[] = {along * a23, -along * a13, along * a12};
    for (int k = 0; k < 3; ++k)
        moment[k] = along_axis[k] + shrink * (moment[k] - along_axis[k]);
    bivector[0] = angle * a12, bivector[1] = angle * a13, bivector[2] = angle * a23;
}

} // namespace motorway
