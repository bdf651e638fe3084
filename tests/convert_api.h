// Views of any components as those that conversions take.
#ifndef MOTORWAY_TESTS_CONVERT_API_H
#define MOTORWAY_TESTS_CONVERT_API_H

#include <array>
#include <cstddef>

#include "api.h"
#include "motorway_views.h"

namespace motorway::testing {

// The quaternion whose x, y, z and w are these components of the view.
template <class Quaternions, class T>
Quaternions quaternions(const View<T> &view, const std::array<std::size_t, 4> &xyzw)
{
    const auto &c = view.component;
    return {c[xyzw[0]], c[xyzw[1]], c[xyzw[2]], c[xyzw[3]], view.stride};
}

// Likewise, of both quaternions, the second of which is behind the first.
template <class DualQuaternions, class T>
DualQuaternions dual_quaternions(const View<T> &view, const std::array<std::size_t, 4> &xyzw)
{
    const auto &c = view.component;
    return {c[xyzw[0]],     c[xyzw[1]],     c[xyzw[2]],     c[xyzw[3]],    c[4 + xyzw[0]],
            c[4 + xyzw[1]], c[4 + xyzw[2]], c[4 + xyzw[3]], view.stride};
}

constexpr std::array<std::size_t, 4> x_first{0, 1, 2, 3}, w_first{1, 2, 3, 0};

// Three components from number `first` on.
template <class Xyz, class T>
Xyz vectors(const View<T> &view, std::size_t first)
{
    const auto &c = view.component;
    return {c[first], c[first + 1], c[first + 2], view.stride};
}

template <class Screws, class T>
Screws screws(const View<T> &view)
{
    const auto &c = view.component;
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], view.stride};
}

// Where the number of a row and column is in a matrix; column 3 is the translation.
inline std::size_t place_in_matrix(mw_matrix_layout layout, std::size_t row, std::size_t column)
{
    switch (layout) {
    case MW_MATRIX_COLUMNS_3X4: return 3 * column + row;
    case MW_MATRIX_COLUMNS_4X4: return 4 * column + row;
    default: return 4 * row + column;
    }
}

inline std::size_t numbers_of(mw_matrix_layout layout)
{
    return layout == MW_MATRIX_ROWS_4X4 || layout == MW_MATRIX_COLUMNS_4X4 ? 16 : 12;
}

constexpr mw_matrix_layout all_matrix_layouts[] = {MW_MATRIX_ROWS_3X4, MW_MATRIX_ROWS_4X4, MW_MATRIX_COLUMNS_3X4,
                                                   MW_MATRIX_COLUMNS_4X4};
inline const char *name_of(mw_matrix_layout layout)
{
    static const char *const names[] = {"rows 3x4", "rows 4x4", "columns 3x4", "columns 4x4"};
    return names[layout - MW_MATRIX_ROWS_3X4];
}

// In the order of mw_euler_order.
constexpr const char *names_of_orders[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx",
                                           "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"};

// The axis of the k-th rotation: 0, 1, 2 for x, y, z.
inline std::size_t axis_of(mw_euler_order order, std::size_t k)
{
    return static_cast<std::size_t>(names_of_orders[order][k] - 'x');
}

}  // namespace motorway::testing

#endif
