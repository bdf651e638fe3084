// Motors made one at a time, and looked at.
#include "motion/description.h"
#include "motorway.h"
#include "scalar_math.h"
#include "view.h"

#include <algorithm>
#include <cmath>

namespace motorway {
namespace {

template <class T, class Motor> mw_status translation(Motor *out, const T *offset)
{
    if (!out || !offset)
        return MW_ERROR_NULL;
    *out = {1, 0, 0, 0, offset[0] / 2, offset[1] / 2, offset[2] / 2, 0};
    return MW_OK;
}

// Lemma 3.11 written out: with a = (x, y, z) and q the point, b = z e12 - y e13 + x e23, and b∧q is -(a × q).
template <class T, class Motor> mw_status rotation(Motor *out, const T *axis, T angle, const T *point)
{
    if (!out || !axis)
        return MW_ERROR_NULL;
    const double p[3] = {point ? point[0] : 0.0, point ? point[1] : 0.0, point ? point[2] : 0.0};
    const bool finite = std::isfinite(axis[0]) && std::isfinite(axis[1]) && std::isfinite(axis[2]) &&
                        std::isfinite(angle) && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    // Scaled by its largest component first, so that no square over- or underflows.
    const double largest = double(std::max(std::max(std::fabs(axis[0]), std::fabs(axis[1])), std::fabs(axis[2])));
    if (!finite || largest == 0)
        return MW_ERROR_AXIS;
    const double a[3] = {axis[0] / largest, axis[1] / largest, axis[2] / largest};
    const double length = square_root(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    const auto [sine, c] = sine_and_cosine(0.5 * angle);
    const double s = sine / length, x = s * a[0], y = s * a[1], z = s * a[2];
    *out = {T(c),
            T(z),
            T(-y),
            T(x),
            T(z * p[1] - y * p[2]),
            T(x * p[2] - z * p[0]),
            T(y * p[0] - x * p[1]),
            T(0)};
    return MW_OK;
}

template <class T> mw_status check_motors(const view<const T, 8> &motors, std::size_t count, std::size_t *first_bad)
{
    const mw_status status = count ? check_view(motors, count) : MW_OK;
    if (status != MW_OK)
        return status;
    for (std::size_t i = 0; i < count; ++i) {
        const view<const T, 8> here = motors.from(i);
        T motor[4];
        for (int c = 0; c < 4; ++c)
            __builtin_memcpy(&motor[c], here.component[c], sizeof(T));
        if (is_degenerate(motor)) {
            if (first_bad)
                *first_bad = i;
            return MW_ERROR_DEGENERATE_MOTOR;
        }
    }
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/single_motors.inc"
