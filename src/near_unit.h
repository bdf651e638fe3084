// Motors whose α = s² + b12² + b13² + b23² is far from 1. It may be any normal number, but formulas take it times other
// numbers, so such a motor is scaled by a power of two first: that changes no bit of a result, but keeps what is made on
// the way to it from over- and underflowing. Compiled for every CPU and called by all kernels for rare lanes; so this
// header has declarations alone.
#pragma once

namespace motorway {

// α is near to 1 from the inverse of this up to it.
constexpr float near_unit_f32 = 0x1p20f;
constexpr double near_unit_f64 = 0x1p200;

// The power of two by which a motor comes near 1: 1 of one that is, or that is degenerate.
float factor_near_unit(float alpha);
double factor_near_unit(double alpha);

} // namespace motorway
