// Indices into a palette as users have them: of one, two or four bytes, packed or a field of something larger, at any
// address. Each array is laid out in another way than the one before and ends or begins at a forbidden page.
#ifndef MOTORWAY_TESTS_INDEX_ARRAY_H
#define MOTORWAY_TESTS_INDEX_ARRAY_H

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "api.h"
#include "guarded_buffer.h"
#include "random.h"

namespace motorway::testing {

class IndexArray {
public:
    // The numbers of a view of one component as an array of indices. Without the numbers, or with more of them than
    // memory has, there is no array to make: then the call is one that must not look at its indices.
    template <class T>
    mw_indices place(const View<T> &numbers, std::size_t count, std::size_t palette_size)
    {
        lay_out(palette_size);
        if (!numbers.component[0] || count > capacity / indices_.stride - 1) {
            expected_.clear();
            block_ = nullptr;
            indices_.first = numbers.component[0] ? buffer_.begin() : nullptr;
            return indices_;
        }
        // A step of the last element is only its own bytes, so that these end at the page.
        const std::size_t size = count ? (count - 1) * indices_.stride + indices_.type : 0;
        block_ = buffer_.place(size, guard_, offset_);
        std::memset(block_, 0xff, size);
        for (std::size_t i = 0; i < count; ++i) {
            T number;
            const char *const from = reinterpret_cast<const char *>(numbers.component[0]) + i * numbers.stride;
            std::memcpy(&number, from, sizeof(T));
            set(i, static_cast<std::uint32_t>(number));
        }
        expected_.assign(block_, block_ + size);
        indices_.first = block_;
        return indices_;
    }

    void expect_unchanged() const
    {
        const bool changed = block_ && std::memcmp(block_, expected_.data(), expected_.size()) != 0;
        EXPECT_FALSE(changed) << describe() << " changed";
    }

    std::string describe() const
    {
        return "u" + std::to_string(8 * indices_.type) + " indices every " + std::to_string(indices_.stride) +
               " bytes, " + std::to_string(offset_) + " bytes from the guard " +
               (guard_ == Guard::after ? "after" : "before");
    }

private:
    static constexpr std::size_t capacity = std::size_t(1) << 17;

    void lay_out(std::size_t palette_size)
    {
        const mw_index_type types[] = {MW_INDEX_U8, MW_INDEX_U16, MW_INDEX_U32};
        do
            indices_.type = types[random_.below(3)];
        while (indices_.type == MW_INDEX_U8 && palette_size > 256);
        const std::size_t gaps[] = {0, 0, 0, 1, 2, 3, 4, 7, 12, 31, 60};
        indices_.stride = indices_.type + gaps[random_.below(std::size(gaps))];
        offset_ = random_.chance(2) ? 0 : random_.below(9);
        guard_ = random_.chance(2) ? Guard::after : Guard::before;
    }

    void set(std::size_t i, std::uint32_t index)
    {
        const auto narrow = static_cast<std::uint8_t>(index);
        const auto middle = static_cast<std::uint16_t>(index);
        unsigned char *const to = block_ + i * indices_.stride;
        switch (indices_.type) {
        case MW_INDEX_U8: std::memcpy(to, &narrow, sizeof narrow); break;
        case MW_INDEX_U16: std::memcpy(to, &middle, sizeof middle); break;
        case MW_INDEX_U32: std::memcpy(to, &index, sizeof index); break;
        }
    }

    Random random_{5};
    GuardedBuffer buffer_{capacity};
    mw_indices indices_{nullptr, 1, MW_INDEX_U8};
    std::size_t offset_ = 0;
    Guard guard_ = Guard::after;
    unsigned char *block_ = nullptr;
    std::vector<unsigned char> expected_;
};

}  // namespace motorway::testing

#endif
