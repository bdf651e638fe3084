// Which matrices are rotations and translations, and how far others are from being one.
#pragma once

#include "matrix_view.h"

namespace motorway {

// How far a matrix may be from a rotation and a translation to be taken for one (motorway.h says why so much).
template <class T> inline constexpr T matrix_tolerance = MW_MATRIX_TOLERANCE_F64;
template <> inline constexpr float matrix_tolerance<float> = MW_MATRIX_TOLERANCE_F32;

// Whether the last row of a matrix of four rows is 0 0 0 1, to the tolerance, and all of its numbers are finite.
template <class T> bool is_affine(const matrices<const T> &m, std::size_t i);

// The largest element of |RᵀR - 1|, and how far the last number of the last row is from 1. Infinite of a reflection, of
// a projection and of what is not finite.
template <class T> double deviation_of(const matrices<const T> &m, std::size_t i);

// MW_ERROR_MATRIX and the number of the first whose deviation is above the tolerance, if there is one. Fast.
template <class T> mw_status check_rotations(const matrices<const T> &m, std::size_t count, std::size_t *first_bad);

} // namespace motorway
