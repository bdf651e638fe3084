// The C API: validate, look up, call, return a status.
#include "kernel_call.h"
#include "motion/description.h"
#include "motorway.h"
#include "scalar_math.h"
#include "view.h"

#include <algorithm>
#include <cmath>

namespace motorway {
namespace {

// Whether the library can run at all.
mw_status check_call() { return kernels() ? MW_OK : MW_ERROR_ISA; }

// ------------------------------------------------------------------------------------------------------ blends

template <class T> struct blend_weights {
    const T *const *terms;
    std::size_t stride;

    view<const T, 1> of_term(std::size_t k) const { return {{terms[k]}, stride}; }
    stream<const T> as_stream() const
    {
        return {terms, stride, stride == sizeof(T) ? layout::soa : layout::interleaved};
    }
};

template <class T>
mw_status check_weights(const view<T, 8> &out, const blend_weights<T> &weights, std::size_t terms, std::size_t count)
{
    if (terms > 0 && !weights.terms)
        return MW_ERROR_NULL;
    mw_status status = MW_OK;
    for (std::size_t k = 0; k < terms && status == MW_OK; ++k)
        status = first_error(check_view(weights.of_term(k), count),
                             [&] { return check_overlap(out, weights.of_term(k), count); });
    return status;
}

template <class T>
mw_status blend_one(const view<T, 8> &out, const T *controls, const blend_weights<T> &weights, std::size_t terms,
                    std::size_t count)
{
    const mw_status called = check_call();
    if (called != MW_OK || count == 0)
        return called;
    if (terms > PTRDIFF_MAX / (8 * sizeof(T)))
        return MW_ERROR_SIZE;
    const mw_status status = first_error(
        check_view(out, count), [&] { return terms ? check_array(controls, 8 * terms) : MW_OK; },
        [&] { return check_weights(out, weights, terms, count); },
        [&] { return check_overlap(out, controls, 8 * terms, count); });
    if (status != MW_OK)
        return status;
    const stream<const T> in = weights.as_stream();
    run_blend(*kernels(), kernel_id::blend_motor_one, out, &in, controls, terms, count);
    return MW_OK;
}

template <class T, class Motors>
mw_status blend_each(const view<T, 8> &out, const Motors *controls, const blend_weights<T> &weights,
                     std::size_t terms, std::size_t count)
{
    const mw_status called = check_call();
    if (called != MW_OK || count == 0)
        return called;
    if (terms > MW_MAX_TERMS)
        return MW_ERROR_TERM_COUNT;
    if (terms > 0 && !controls)
        return MW_ERROR_NULL;
    mw_status status = first_error(check_view(out, count), [&] { return check_weights(out, weights, terms, count); });
    view<const T, 8> views[MW_MAX_TERMS];
    stream<const T> in[1 + MW_MAX_TERMS] = {weights.as_stream()};
    for (std::size_t k = 0; k < terms && status == MW_OK; ++k) {
        views[k] = view_of_motors<const T>(controls[k]);
        in[1 + k] = views[k].as_stream();
        status = first_error(check_view(views[k], count), [&] { return check_overlap(out, views[k], count); });
    }
    if (status == MW_OK)
        run_blend<T>(*kernels(), kernel_id::blend_motor_each, out, in, nullptr, terms, count);
    return status;
}

// ------------------------------------------------------------------------------------------------ single motors

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

// ---------------------------------------------------------------------------------------------------- C functions

using namespace motorway;

const char *mw_status_text(mw_status status)
{
    switch (status) {
    case MW_OK: return "success";
    case MW_ERROR_NULL: return "a pointer is null; only a call with count 0 may pass null";
    case MW_ERROR_STRIDE:
        return "a stride is smaller than the element, or components of one view or rows of a grid share bytes; strides "
               "are in bytes";
    case MW_ERROR_SIZE: return "count times stride is larger than the address space";
    case MW_ERROR_OVERLAP:
        return "the output shares bytes with another element of an input, or with what is read as a whole; in place, "
               "elements of both lie over each other with the same stride, else keep them apart";
    case MW_ERROR_FLAGS:
        return "a flag that this function does not know, or two that contradict each other; pass MW_DEFAULT or flags "
               "named in its text";
    case MW_ERROR_INDEX: return "an index is not below the number of motors in the palette";
    case MW_ERROR_INDEX_TYPE: return "the type of indices is MW_INDEX_U8, MW_INDEX_U16 or MW_INDEX_U32";
    case MW_ERROR_DEGENERATE_MOTOR:
        return "a motor whose alpha (s^2 + b12^2 + b13^2 + b23^2) is zero, subnormal, infinite or NaN moves nothing";
    case MW_ERROR_AXIS: return "the rotation axis has length zero, or a number is not finite";
    case MW_ERROR_MOTION_KIND: return "a kind of motion is one of mw_motion_kind, and here one that the function takes";
    case MW_ERROR_DEGREE: return "the degree of a motion is from 1 to 31";
    case MW_ERROR_CONTROL_COUNT: return "a motion of degree d needs at least d + 1 control poses, and keys at least 2";
    case MW_ERROR_KNOT_COUNT:
        return "an open motion has exactly control_count + degree - 1 knots, a closed one control_count + 1, and keys one "
               "a control";
    case MW_ERROR_KNOTS:
        return "knots must be finite, must not decrease, may be repeated degree + 1 times at most, and must span a domain; "
               "times of keys must increase";
    case MW_ERROR_WEIGHTS: return "weights are positive and finite, and only additive motions have them";
    case MW_ERROR_VANISHING:
        return "controls cancel somewhere on the way, so that the motion has no pose there; without MW_KEEP_SIGNS they are "
               "taken with the signs of the shortest way, and rotations less than a half turn apart cannot cancel";
    case MW_ERROR_PARAMETER:
        return "a parameter is outside the domain of the motion, or not finite; MW_CLAMP_PARAMETERS and "
               "MW_WRAP_PARAMETERS take any finite one";
    case MW_ERROR_MEMORY:
        return "the memory passed is too small, or not aligned to 8 bytes; ask for the size that it takes";
    case MW_ERROR_MOTION: return "this is no compiled motion, or one of the other precision or of another version";
    case MW_ERROR_MOTION_INDEX: return "the index of a motion is not below the number of motions that were compiled";
    case MW_ERROR_CONVERGENCE:
        return "no control poses were found whose motion passes through the keys; add keys where rotations are large";
    case MW_ERROR_PARENT: return "the parent of a joint must come before it, or be negative for a root";
    case MW_ERROR_MATRIX:
        return "a matrix is no rotation and translation: it scales, shears, reflects or projects, or is not finite; keep "
               "its scale beside the motor, or take the nearest rotation by MW_NEAREST_ROTATION, which a mirror image, a "
               "projection and what is not finite do not have";
    case MW_ERROR_MATRIX_LAYOUT: return "a matrix layout is one of mw_matrix_layout";
    case MW_ERROR_EULER_ORDER: return "an order of Euler angles is one of mw_euler_order";
    case MW_ERROR_SCALE: return "a length scale must be finite and not zero, and its inverse too";
    case MW_ERROR_TERM_COUNT: return "a blend of separate control arrays has at most 256 terms";
    case MW_ERROR_ISA: return isa_error();
    }
    return "not a status of this library";
}

const char *mw_isa(void) { return kernels() ? kernels()->isa : nullptr; }
const char *mw_isas(void) { return isa_names(); }

// Everything that comes in two precisions.
#define MOTORWAY_API(P, T)                                                                                            \
    mw_status mw_translation_##P(mw_motor_##P *out, const T offset[3]) { return translation<T>(out, offset); }        \
    mw_status mw_rotation_##P(mw_motor_##P *out, const T axis[3], T angle, const T point[3])                          \
    {                                                                                                                 \
        return rotation<T>(out, axis, angle, point);                                                                  \
    }                                                                                                                 \
    mw_status mw_check_motors_##P(mw_const_motors_##P motors, size_t count, size_t *first_bad)                        \
    {                                                                                                                 \
        return check_motors<T>(view_of_motors<const T>(motors), count, first_bad);                                    \
    }                                                                                                                 \
    mw_status mw_blend_motor_one_##P(mw_motors_##P out, const mw_motor_##P *controls, mw_weights_##P weights,         \
                                     size_t term_count, size_t count)                                                 \
    {                                                                                                                 \
        return blend_one<T>(view_of_motors<T>(out), numbers_of<T>(controls), {weights.terms, weights.stride},         \
                            term_count, count);                                                                       \
    }                                                                                                                 \
    mw_status mw_blend_motor_each_##P(mw_motors_##P out, const mw_const_motors_##P *controls,                         \
                                      mw_weights_##P weights, size_t term_count, size_t count)                        \
    {                                                                                                                 \
        return blend_each<T>(view_of_motors<T>(out), controls, {weights.terms, weights.stride}, term_count, count);   \
    }

MOTORWAY_API(f32, float)
MOTORWAY_API(f64, double)
