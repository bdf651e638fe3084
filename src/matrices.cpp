// Motors from and into matrices, and what is to be said of matrices that are not quite rotations.
#include "nearest_rotation.h"
#include "stream_calls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace motorway {
namespace {

// A view of matrices as it was given.
template <class T> struct matrices {
    T *first;
    std::size_t stride;
    mw_matrix_layout layout;

    bool are_columns() const { return layout == MW_MATRIX_COLUMNS_3X4 || layout == MW_MATRIX_COLUMNS_4X4; }
    std::size_t numbers() const { return layout == MW_MATRIX_ROWS_4X4 || layout == MW_MATRIX_COLUMNS_4X4 ? 16 : 12; }

    // The first N numbers of each.
    template <int N> view<T, N> adjacent() const
    {
        view<T, N> result{{}, stride};
        for (int k = 0; k < N; ++k)
            result.component[k] = first + k;
        return result;
    }

    std::size_t place(int row, int column) const
    {
        return are_columns() ? (numbers() / 4) * column + row : 4 * row + column;
    }
    double at(std::size_t i, int row, int column) const
    {
        std::remove_const_t<T> value;
        const char *const matrix = reinterpret_cast<const char *>(first) + i * stride;
        __builtin_memcpy(&value, matrix + place(row, column) * sizeof(T), sizeof value);
        return value;
    }
};

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
mw_status motor_to_matrix(const matrices<T> &out, const view<const T, 8> &motors, std::size_t count)
{
    const mw_status status = check_layout(out, count);
    if (!kernels() || status != MW_OK)
        return kernels() ? status : MW_ERROR_ISA;
    switch (out.layout) {
    case MW_MATRIX_ROWS_3X4:
        return run_streams(kernel_id::convert_motor_to_rows_3x4_each, to(out.template adjacent<12>()), count, motors);
    case MW_MATRIX_ROWS_4X4:
        return run_streams(kernel_id::convert_motor_to_rows_4x4_each, to(out.template adjacent<16>()), count, motors);
    case MW_MATRIX_COLUMNS_3X4:
        return run_streams(kernel_id::convert_motor_to_columns_3x4_each, to(out.template adjacent<12>()), count,
                           motors);
    default:
        return run_streams(kernel_id::convert_motor_to_columns_4x4_each, to(out.template adjacent<16>()), count,
                           motors);
    }
}

// ------------------------------------------------------------------------------------------------ nearest rotations

// Validated. In place the matrix is read before the motor is written.
template <class T>
void nearest_motors(const view<T, 8> &out, const matrices<const T> &in, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) {
        double rotation[3][3], translation[3], motor[8];
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                rotation[row][column] = in.at(i, row, column);
            translation[row] = in.at(i, row, 3);
        }
        nearest_motor(rotation, translation, motor);
        for (int c = 0; c < 8; ++c) {
            const T value = static_cast<T>(motor[c]);
            __builtin_memcpy(out.from(i).component[c], &value, sizeof value);
        }
    }
}

template <class T, int N>
mw_status matrix_to_motor(kernel_id id, const view<T, 8> &out, const matrices<const T> &in, std::size_t count,
                          unsigned flags)
{
    const view<const T, N> numbers = in.template adjacent<N>();
    if (flags == MW_DEFAULT)
        return run_streams(id, to(out), count, numbers);
    const mw_status status = count == 0 ? MW_OK : check_streams(to(out), count, numbers);
    if (status == MW_OK)
        nearest_motors(out, in, count);
    return status;
}

template <class T>
mw_status matrix_to_motor(const view<T, 8> &out, const matrices<const T> &in, std::size_t count, unsigned flags)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (flags & ~static_cast<unsigned>(MW_NEAREST_ROTATION))
        return MW_ERROR_FLAGS;
    const mw_status status = check_layout(in, count);
    if (status != MW_OK)
        return status;
    switch (in.layout) {
    case MW_MATRIX_COLUMNS_3X4:
        return matrix_to_motor<T, 12>(kernel_id::convert_columns_3x4_to_motor_each, out, in, count, flags);
    case MW_MATRIX_COLUMNS_4X4:
        return matrix_to_motor<T, 16>(kernel_id::convert_columns_4x4_to_motor_each, out, in, count, flags);
    default: return matrix_to_motor<T, 12>(kernel_id::convert_rows_3x4_to_motor_each, out, in, count, flags);
    }
}

// -------------------------------------------------------------------------------------------------------- deviation

// How far R of a matrix is from a rotation: the largest element of |RᵀR - 1|, infinite if it reflects or is not finite.
template <class T> double deviation_of(const matrices<const T> &m, std::size_t i)
{
    double column[3][3], largest = 0;
    bool finite = true;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            column[c][r] = m.at(i, r, c);
            finite &= std::isfinite(column[c][r]) && std::isfinite(m.at(i, r, 3));
        }
    const auto dot = [](const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b)
            largest = std::max(largest, std::fabs(dot(column[a], column[b]) - (a == b ? 1 : 0)));
    const double *x = column[0], *y = column[1];
    const double normal[3] = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    const bool is_rotation = finite && dot(normal, column[2]) > 0;
    return is_rotation ? largest : std::numeric_limits<double>::infinity();
}

template <class T>
mw_status check_matrices(const matrices<const T> &in, std::size_t count, T tolerance, std::size_t *first_bad,
                         T *deviation)
{
    mw_status status = check_layout(in, count);
    if (status == MW_OK && count > 0)
        status = check_view(in.template adjacent<12>(), count);
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

#define MOTORWAY_MATRICES(P, T)                                                                                       \
    mw_status mw_convert_motor_to_matrix_each_##P(mw_matrices_##P out, mw_const_motors_##P motors, size_t count)      \
    {                                                                                                                 \
        return motor_to_matrix<T>({out.first, out.stride, out.layout}, view_of_motors<const T>(motors), count);       \
    }                                                                                                                 \
    mw_status mw_convert_matrix_to_motor_each_##P(mw_motors_##P out, mw_const_matrices_##P matrices, size_t count,    \
                                                  unsigned flags)                                                     \
    {                                                                                                                 \
        return matrix_to_motor<T>(view_of_motors<T>(out), {matrices.first, matrices.stride, matrices.layout}, count,  \
                                  flags);                                                                             \
    }                                                                                                                 \
    mw_status mw_check_matrices_##P(mw_const_matrices_##P matrices, size_t count, T tolerance, size_t *first_bad,     \
                                    T *deviation)                                                                     \
    {                                                                                                                 \
        return check_matrices<T>({matrices.first, matrices.stride, matrices.layout}, count, tolerance, first_bad,     \
                                 deviation);                                                                          \
    }

MOTORWAY_MATRICES(f32, float)
MOTORWAY_MATRICES(f64, double)
