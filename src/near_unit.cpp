#include "near_unit.h"

#include <cstdint>

namespace motorway {
namespace {

template <class T, class Bits, int mantissa_bits> T factor_of(T alpha, T near)
{
    constexpr Bits infinite = (Bits(1) << (8 * sizeof(T) - 1 - mantissa_bits)) - 1, bias = infinite / 2;
    Bits bits;
    __builtin_memcpy(&bits, &alpha, sizeof bits);
    const Bits exponent = bits >> mantissa_bits; // α has no sign
    if ((alpha >= 1 / near && alpha <= near) || exponent == 0 || exponent >= infinite)
        return 1;
    const Bits halved = exponent > bias ? bias - (exponent - bias) / 2 : bias + (bias - exponent) / 2;
    bits = halved << mantissa_bits;
    T factor;
    __builtin_memcpy(&factor, &bits, sizeof factor);
    return factor;
}

} // namespace

float factor_near_unit(float alpha) { return factor_of<float, std::uint32_t, 23>(alpha, near_unit_f32); }
double factor_near_unit(double alpha) { return factor_of<double, std::uint64_t, 52>(alpha, near_unit_f64); }

} // namespace motorway
