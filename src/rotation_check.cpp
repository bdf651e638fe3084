#include "rotation_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace motorway {
namespace {

// What products and inverses may leave where the last row of a matrix of T has zeros. Little: it grows with the size
// of the scene, for points are divided by 1 + this times their coordinates.
template <class T> constexpr T projection_tolerance = 16 * std::numeric_limits<T>::epsilon();

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class T> bool all_are_finite(const matrices<const T> &m, std::size_t i)
{
    bool finite = true;
    for (int row = 0; row < m.rows(); ++row)
        for (int column = 0; column < 4; ++column)
            finite &= std::isfinite(m.at(i, row, column));
    return finite;
}

// Of the last row, where there is one.
template <class T> double deviation_of_last_row(const matrices<const T> &m, std::size_t i)
{
    if (m.rows() == 3)
        return 0;
    bool projects = false;
    for (int column = 0; column < 3; ++column)
        projects |= !(std::fabs(m.at(i, 3, column)) <= projection_tolerance<T>);
    return projects ? infinite : std::fabs(m.at(i, 3, 3) - 1);
}

} // namespace

template <class T> bool is_affine(const matrices<const T> &m, std::size_t i)
{
    return all_are_finite(m, i) && deviation_of_last_row(m, i) <= matrix_tolerance<T>;
}

template <class T> double deviation_of(const matrices<const T> &m, std::size_t i)
{
    double column[3][3], largest = deviation_of_last_row(m, i);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            column[c][r] = m.at(i, r, c);
    const auto dot = [](const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b)
            largest = std::max(largest, std::fabs(dot(column[a], column[b]) - (a == b ? 1 : 0)));
    const double *x = column[0], *y = column[1];
    const double normal[3] = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    return all_are_finite(m, i) && dot(normal, column[2]) > 0 ? largest : infinite;
}

// ------------------------------------------------------------------------------------------------------- many, fast

namespace {

// Matrices that are looked at together, each in a lane of its own: loops over lanes become vectors.
constexpr int lanes = 8;

template <class T> struct lane_numbers {
    T number[3][4][lanes], last[4][lanes];

    // Those from number i on, of which there are `some`; the other lanes repeat the last one.
    template <mw_matrix_layout Layout> void load(const matrices<const T> &m, std::size_t i, std::size_t some)
    {
        constexpr matrices<const T> shape{nullptr, 0, Layout};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const char *const from = m.bytes(i + std::min(lane, some - 1));
            for (int row = 0; row < shape.rows(); ++row)
                for (int column = 0; column < 4; ++column)
                    __builtin_memcpy(row < 3 ? &number[row][column][lane] : &last[column][lane],
                                     from + static_cast<std::size_t>(shape.place(row, column)) * sizeof(T), sizeof(T));
        }
    }
};

// True only if no deviation is above the tolerance; false also if one is very near to it.
template <class T, bool has_last_row> bool are_surely_rotations(const lane_numbers<T> &m)
{
    constexpr T rounding = 16 * std::numeric_limits<T>::epsilon(), most = matrix_tolerance<T> - rounding;
    const auto within = [](T difference, T limit) { return int(std::fabs(difference) <= limit); };
    T bad[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        const auto at = [&](int row, int column) { return m.number[row][column][lane]; };
        const T ax = at(0, 0), ay = at(1, 0), az = at(2, 0), bx = at(0, 1), by = at(1, 1), bz = at(2, 1);
        const T cx = at(0, 2), cy = at(1, 2), cz = at(2, 2), tx = at(0, 3), ty = at(1, 3), tz = at(2, 3);
        int good = within(ax * ax + ay * ay + az * az - 1, most) & within(ax * bx + ay * by + az * bz, most) &
                   within(bx * bx + by * by + bz * bz - 1, most) & within(ax * cx + ay * cy + az * cz, most) &
                   within(cx * cx + cy * cy + cz * cz - 1, most) & within(bx * cx + by * cy + bz * cz, most);
        good &= int(ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx) > 0);
        good &= within((tx - tx) + (ty - ty) + (tz - tz), 0); // NaN if one is not finite
        if constexpr (has_last_row)
            good &= within(m.last[0][lane], projection_tolerance<T>) &
                    within(m.last[1][lane], projection_tolerance<T>) &
                    within(m.last[2][lane], projection_tolerance<T>) & within(m.last[3][lane] - 1, most);
        bad[lane] = good ? T(0) : T(1);
    }
    return std::all_of(bad, bad + lanes, [](T each) { return each == 0; });
}

template <mw_matrix_layout Layout, class T>
mw_status check_rotations_of(const matrices<const T> &m, std::size_t count, std::size_t *first_bad)
{
    constexpr bool has_last_row = Layout == MW_MATRIX_ROWS_4X4 || Layout == MW_MATRIX_COLUMNS_4X4;
    for (std::size_t begin = 0; begin < count; begin += lanes) {
        const std::size_t end = std::min<std::size_t>(count, begin + lanes);
        lane_numbers<T> some;
        some.template load<Layout>(m, begin, end - begin);
        for (std::size_t i = are_surely_rotations<T, has_last_row>(some) ? end : begin; i < end; ++i)
            if (!(deviation_of(m, i) <= matrix_tolerance<T>)) {
                if (first_bad)
                    *first_bad = i;
                return MW_ERROR_MATRIX;
            }
    }
    return MW_OK;
}

} // namespace

template <class T> mw_status check_rotations(const matrices<const T> &m, std::size_t count, std::size_t *first_bad)
{
    switch (m.layout) {
    case MW_MATRIX_ROWS_3X4: return check_rotations_of<MW_MATRIX_ROWS_3X4>(m, count, first_bad);
    case MW_MATRIX_ROWS_4X4: return check_rotations_of<MW_MATRIX_ROWS_4X4>(m, count, first_bad);
    case MW_MATRIX_COLUMNS_3X4: return check_rotations_of<MW_MATRIX_COLUMNS_3X4>(m, count, first_bad);
    default: return check_rotations_of<MW_MATRIX_COLUMNS_4X4>(m, count, first_bad);
    }
}

#define MOTORWAY_ROTATION_CHECK(T)                                                                                    \
    template bool is_affine(const matrices<const T> &, std::size_t);                                                  \
    template double deviation_of(const matrices<const T> &, std::size_t);                                             \
    template mw_status check_rotations(const matrices<const T> &, std::size_t, std::size_t *);

MOTORWAY_ROTATION_CHECK(float)
MOTORWAY_ROTATION_CHECK(double)

} // namespace motorway
