// Matrices as they are given: where each of their numbers is.
#pragma once

#include "view.h"

namespace motorway {

template <class T> struct matrices {
    T *first;
    std::size_t stride;
    mw_matrix_layout layout;

    constexpr bool are_columns() const { return layout == MW_MATRIX_COLUMNS_3X4 || layout == MW_MATRIX_COLUMNS_4X4; }
    constexpr int rows() const { return layout == MW_MATRIX_ROWS_4X4 || layout == MW_MATRIX_COLUMNS_4X4 ? 4 : 3; }
    std::size_t numbers() const { return static_cast<std::size_t>(4 * rows()); }
    constexpr int place(int row, int column) const { return are_columns() ? rows() * column + row : 4 * row + column; }

    // The first N numbers of each.
    template <int N> view<T, N> adjacent() const
    {
        view<T, N> result{{}, stride};
        for (int k = 0; k < N; ++k)
            result.component[k] = first + k;
        return result;
    }

    const char *bytes(std::size_t i) const { return reinterpret_cast<const char *>(first) + i * stride; }
    double at(std::size_t i, int row, int column) const
    {
        std::remove_const_t<T> value;
        __builtin_memcpy(&value, bytes(i) + static_cast<std::size_t>(place(row, column)) * sizeof(T), sizeof value);
        return value;
    }
};

// Of the public ones. A null one is of a layout that there is, so that the null is what is found.
template <class Matrices> auto matrices_of(const Matrices *m) -> matrices<std::remove_pointer_t<decltype(m->first)>>
{
    return {m ? m->first : nullptr, m ? m->stride : 0, m ? m->layout : MW_MATRIX_ROWS_3X4};
}

} // namespace motorway
