// Motors from and into matrices. Validate, look up, call, return a status.
#include "nearest_rotation.h"
#include "rotation_check.h"
#include "stream_calls.h"

#include <algorithm>
#include <cmath>

namespace motorway {
namespace {

template <class T> mw_status check_layout(const matrices<T> &m, std::size_t count)
{
    if (m.layout < MW_MATRIX_ROWS_3X4 || m.layout > MW_MATRIX_COLUMNS_4X4)
        return MW_ERROR_MATRIX_LAYOUT;
    if (count == 0)
        return MW_OK;
    if (!m.first)
        return MW_ERROR_NULL;
    return m.stride < m.numbers() * sizeof(T) ? MW_ERROR_STRIDE : MW_OK;
}

template <class T>
mw_status convert_motor_to_matrix(const matrices<T> &out, const view<const T, 8> &motors, std::size_t count)
{
    const mw_status status = check_layout(out, count);
    if (!kernels() || status != MW_OK)
        return kernels() ? status : MW_ERROR_ISA;
    switch (out.layout) {
    case MW_MATRIX_ROWS_3X4:
        return run_streams(kernel_id::convert_motor_to_rows_3x4_each, into(out.template adjacent<12>()), count, motors);
    case MW_MATRIX_ROWS_4X4:
        return run_streams(kernel_id::convert_motor_to_rows_4x4_each, into(out.template adjacent<16>()), count, motors);
    case MW_MATRIX_COLUMNS_3X4:
        return run_streams(kernel_id::convert_motor_to_columns_3x4_each, into(out.template adjacent<12>()), count,
                           motors);
    default:
        return run_streams(kernel_id::convert_motor_to_columns_4x4_each, into(out.template adjacent<16>()), count,
                           motors);
    }
}

// ------------------------------------------------------------------------------------------------ nearest rotations

// False if no rotation is nearest to the matrix.
template <class T> bool nearest_motor_of(const matrices<const T> &m, std::size_t i, double (&motor)[8])
{
    double rotation[3][3], translation[3];
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            rotation[row][column] = m.at(i, row, column);
        translation[row] = m.at(i, row, 3);
    }
    return nearest_motor(rotation, translation, matrix_tolerance<T>, motor);
}

// Everything is looked at before anything is written, and so made twice.
template <class T>
mw_status check_nearest(const matrices<const T> &in, std::size_t count, std::size_t *first_bad)
{
    for (std::size_t i = 0; i < count; ++i) {
        double motor[8];
        if (!is_affine(in, i) || !nearest_motor_of(in, i, motor)) {
            if (first_bad)
                *first_bad = i;
            return MW_ERROR_MATRIX;
        }
    }
    return MW_OK;
}

// Validated. In place the matrix is read before the motor is written.
template <class T>
void nearest_motors(const view<T, 8> &out, const matrices<const T> &in, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) {
        double motor[8];
        nearest_motor_of(in, i, motor);
        for (int c = 0; c < 8; ++c) {
            const T value = static_cast<T>(motor[c]);
            __builtin_memcpy(out.from(i).component[c], &value, sizeof value);
        }
    }
}

// ------------------------------------------------------------------------------------------------- from matrices

constexpr unsigned matrix_flags = MW_NEAREST_ROTATION | MW_ROTATION_MATRICES;

// A matrix has Size numbers, of which the kernel reads Read.
template <int Size, int Read, class T>
mw_status matrix_to_motor(kernel_id id, const view<T, 8> &out, const matrices<const T> &in, std::size_t count,
                          unsigned flags, std::size_t *first_bad)
{
    if (count == 0)
        return MW_OK;
    const mw_status status = first_error(check_call(into(out), count, in.template adjacent<Size>()), [&] {
        return flags & MW_NEAREST_ROTATION    ? check_nearest(in, count, first_bad)
               : flags & MW_ROTATION_MATRICES ? MW_OK
                                              : check_rotations(in, count, first_bad);
    });
    if (status != MW_OK)
        return status;
    if (flags & MW_NEAREST_ROTATION)
        nearest_motors(out, in, count);
    else
        call_streams(id, static_cast<const T *>(nullptr), into(out), count, in.template adjacent<Read>());
    return MW_OK;
}

template <class T>
mw_status convert_matrix_to_motor(const view<T, 8> &out, const matrices<const T> &in, std::size_t count, unsigned flags,
                          std::size_t *first_bad)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if ((flags & ~matrix_flags) || (flags & matrix_flags) == matrix_flags)
        return MW_ERROR_FLAGS;
    const mw_status status = check_layout(in, count);
    if (status != MW_OK)
        return status;
    switch (in.layout) {
    case MW_MATRIX_ROWS_3X4:
        return matrix_to_motor<12, 12>(kernel_id::convert_rows_3x4_to_motor_each, out, in, count, flags, first_bad);
    case MW_MATRIX_ROWS_4X4:
        return matrix_to_motor<16, 12>(kernel_id::convert_rows_3x4_to_motor_each, out, in, count, flags, first_bad);
    case MW_MATRIX_COLUMNS_3X4:
        return matrix_to_motor<12, 12>(kernel_id::convert_columns_3x4_to_motor_each, out, in, count, flags, first_bad);
    default:
        return matrix_to_motor<16, 16>(kernel_id::convert_columns_4x4_to_motor_each, out, in, count, flags, first_bad);
    }
}

template <class T>
mw_status check_matrices(const matrices<const T> &in, std::size_t count, T tolerance, std::size_t *first_bad,
                         T *deviation)
{
    mw_status status = check_layout(in, count);
    if (status == MW_OK && count > 0)
        status = in.rows() == 4 ? check_view(in.template adjacent<16>(), count)
                                : check_view(in.template adjacent<12>(), count);
    if (status != MW_OK)
        return status;
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double distance = deviation_of(in, i);
        largest = std::max(largest, distance);
        if (status == MW_OK && !(distance <= tolerance)) {
            status = MW_ERROR_MATRIX;
            if (first_bad)
                *first_bad = i;
        }
    }
    if (deviation)
        *deviation = static_cast<T>(largest);
    return status;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/matrices.inc"
