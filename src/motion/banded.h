// Systems of linear equations whose matrix has a band, in memory of the caller's.
#pragma once

#include <algorithm>
#include <cstddef>

namespace motorway {

inline double inverse(double x) { return 1 / x; }
template <class Row> Row apply(double factor, const Row &row) { return row * factor; }

// Entries are numbers or matrices, with an inverse(), and apply() to multiply a row of what is unknown. Row i has
// them in the columns i - reach ... i + reach.
template <class Entry> class banded {
    Entry *entries;
    std::size_t size, reach;

    std::size_t past_band(std::size_t row) const { return std::min(row + reach + 1, size); }

public:
    static std::size_t entry_count(std::size_t size, std::size_t reach) { return size * (2 * reach + 1); }

    banded(void *memory, std::size_t rows, std::size_t to_reach)
        : entries(static_cast<Entry *>(memory)), size(rows), reach(to_reach)
    {
    }

    void clear() { std::fill_n(entries, entry_count(size, reach), Entry{}); }
    bool has(std::size_t row, std::size_t column) const { return column + reach >= row && column <= row + reach; }
    Entry &operator()(std::size_t row, std::size_t column) const
    {
        return entries[row * (2 * reach + 1) + (column + reach - row)];
    }

    // Gauss's elimination without pivots, of the right sides as well, which become the solution.
    template <class Row> void solve(Row *rows) const
    {
        const banded &a = *this;
        for (std::size_t k = 0; k < size; ++k) {
            a(k, k) = inverse(a(k, k));
            for (std::size_t i = k + 1; i < past_band(k); ++i) {
                const Entry factor = a(i, k) * a(k, k);
                for (std::size_t j = k + 1; j < past_band(k); ++j)
                    a(i, j) = a(i, j) - factor * a(k, j);
                rows[i] = rows[i] - apply(factor, rows[k]);
            }
        }
        for (std::size_t k = size; k-- > 0;) {
            for (std::size_t j = k + 1; j < past_band(k); ++j)
                rows[k] = rows[k] - apply(a(k, j), rows[j]);
            rows[k] = apply(a(k, k), rows[k]);
        }
    }
};

} // namespace motorway
