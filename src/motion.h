// Motions over the kernels: what can be wrong with one, and its samples.
#pragma once

#include "view.h"

#include <limits>

namespace motorway {

// mw_bspline_f32 and mw_bspline_f64 as one type.
template <class T> struct bspline {
    const T *controls; // eight numbers each
    std::size_t control_count;
    const T *knots;
    std::size_t knot_count;
    unsigned degree;

    T domain_begin() const { return knots[degree - 1]; }
    T domain_end() const { return knots[control_count - 1]; }
};

// Whether α is outside the normal range, so that the motor has no inverse.
template <class T> bool is_degenerate(const T *motor)
{
    const T alpha = motor[0] * motor[0] + motor[1] * motor[1] + motor[2] * motor[2] + motor[3] * motor[3];
    return !(alpha >= std::numeric_limits<T>::min() && alpha <= std::numeric_limits<T>::max());
}

template <class T> mw_status check_bspline(const bspline<T> &motion, std::size_t *where);

// Everything but the parameters' domain is checked already.
template <class T>
mw_status sample_bspline(const kernel_table &table, const view<T, 8> &out, const bspline<T> &motion,
                         const T *parameters, std::size_t count);

} // namespace motorway
