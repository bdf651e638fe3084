// The version, what a status means, and which instruction sets there are.
#include "dispatch.h"
#include "motorway.h"

namespace motorway {
namespace {

unsigned version() { return MW_VERSION; }

const char *status_text(mw_status status)
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

const char *isa() { return kernels() ? kernels()->isa : nullptr; }
const char *isas() { return isa_names(); }

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/status.inc"
