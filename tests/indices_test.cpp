// Palettes as large as their indices reach, and the check of indices.

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <sys/mman.h>

#include "apply_api.h"
#include "isas.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();

template <class T>
class PaletteTest : public ::testing::Test {
protected:
    // A palette in which the index can be seen in the result: motor k moves the origin by (k, k / 3, -k). One scalar
    // of motors is M.
    template <class M>
    static void set_motor(M *motor, std::size_t k)
    {
        const double offset[3] = {double(k), double(k) / 3, -double(k)};
        motor[0] = 1;
        for (std::size_t c = 0; c < 3; ++c)
            motor[4 + c] = static_cast<M>(offset[c] / 2);
    }

    // The results under palette[index] as the same function gives them with that motor alone.
    template <class M>
    static void expect_picked(const ApplyFunctions<T> &functions, const M *palette, std::size_t palette_count,
                              mw_indices indices, const std::vector<std::uint32_t> &numbers)
    {
        const std::size_t components = functions.components(), count = numbers.size();
        std::vector<T> in(count * components), out(count * components), alone(components);
        Random random(51);
        for (T &number : in)
            number = static_cast<T>(random.uniform(-2, 2));
        ApplyCall<T> call;
        call.in = packed_view(in.data(), components);
        call.out = packed_view(out.data(), components);
        call.motor = palette;
        call.motor_count = palette_count;
        call.indices = indices;
        call.count = count;
        for (Pairing pairing : {Pairing::indexed, Pairing::indexed_checked}) {
            std::fill(out.begin(), out.end(), T(-7));
            ASSERT_EQ(functions.run(pairing, call), MW_OK) << functions.name(pairing);
            for (std::size_t i = 0; i < count; ++i) {
                ApplyCall<T> each;
                each.in = packed_view(&in[i * components], components);
                each.out = packed_view(alone.data(), components);
                M *const motor = const_cast<M *>(palette + 8 * std::size_t(numbers[i]));
                each.motors = packed_view(reinterpret_cast<T *>(motor), 8, sizeof(M));
                each.count = 1;
                ASSERT_EQ(functions.each(each), MW_OK);
                ASSERT_EQ(std::memcmp(alone.data(), &out[i * components], components * sizeof(T)), 0)
                    << functions.name(pairing) << " on " << mw_isa() << ", element " << i << ", index " << numbers[i];
            }
        }
    }

    template <class Body>
    static void on_every_isa(Body body)
    {
        for (const std::string &isa : running_isas()) {
            ScopedIsa scope(isa);
            for (const ApplyFunctions<T> &functions : apply_functions<T>())
                functions.is_mixed() ? body(functions, double()) : body(functions, T());
        }
    }
};

TYPED_TEST_SUITE(PaletteTest, Precisions, PrecisionName);

TYPED_TEST(PaletteTest, every_u8_index)
{
    this->on_every_isa([](const auto &functions, auto scalar) {
        std::vector<decltype(scalar)> palette(8 * 256);
        std::vector<std::uint8_t> indices;
        std::vector<std::uint32_t> numbers;
        for (std::size_t k = 0; k < 256; ++k) {
            TestFixture::set_motor(&palette[8 * k], k);
            indices.push_back(static_cast<std::uint8_t>(k * 77));
            numbers.push_back(indices.back());
        }
        TestFixture::expect_picked(functions, palette.data(), 256, mw_indices_u8(indices.data(), 1), numbers);
    });
}

TYPED_TEST(PaletteTest, the_whole_range_of_u16_indices)
{
    this->on_every_isa([](const auto &functions, auto scalar) {
        std::vector<decltype(scalar)> palette(8 * 65536);
        for (std::size_t k = 0; k < 65536; ++k)
            TestFixture::set_motor(&palette[8 * k], k);
        std::vector<std::uint16_t> indices;
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t index = 0; index < 65536; index += 1 + index / 3) {
            numbers.push_back(index);
            numbers.push_back(65535 - index);
        }
        for (std::uint32_t number : numbers)
            indices.push_back(static_cast<std::uint16_t>(number));
        TestFixture::expect_picked(functions, palette.data(), 65536, mw_indices_u16(indices.data(), 2), numbers);
    });
}

// Indices that are negative as an int, and byte offsets of more than 32 bits: a palette of which only the pages in
// question are there.
TYPED_TEST(PaletteTest, u32_indices_beyond_two_billion)
{
    const std::vector<std::uint32_t> known = {0,          1,          0x07ffffff, 0x08000000, 0x0fffffff,
                                              0x10000000, 0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe};
    this->on_every_isa([&](const auto &functions, auto scalar) {
        using M = decltype(scalar);
        constexpr std::size_t bytes = (std::size_t(1) << 32) * sizeof(M[8]);
        void *const memory = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (memory == MAP_FAILED)
            GTEST_SKIP() << "this system does not give away addresses in such an amount";
        M *const palette = static_cast<M *>(memory);
        const std::size_t page = 1 << 16;
        for (std::uint32_t index : known) {
            const std::size_t at = index * sizeof(M[8]) / page * page;
            ASSERT_EQ(mprotect(static_cast<char *>(memory) + at, page, PROT_READ | PROT_WRITE), 0);
            TestFixture::set_motor(palette + 8 * std::size_t(index), index % 1009);
        }
        std::vector<std::uint32_t> numbers;
        for (std::size_t k = 0; k < 70; ++k)
            numbers.push_back(known[k * k % known.size()]);
        TestFixture::expect_picked(functions, palette, std::size_t(1) << 32, mw_indices_u32(numbers.data(), 4),
                                   numbers);
        munmap(memory, bytes);
    });
}

// ------------------------------------------------------------------------------------------------ mw_check_indices

struct IndexType {
    mw_index_type type;
    std::uint64_t largest;
};

constexpr IndexType all_types[] = {
    {MW_INDEX_U8, 0xff}, {MW_INDEX_U16, 0xffff}, {MW_INDEX_U32, 0xffffffff}};

void put(unsigned char *to, mw_index_type type, std::uint64_t index)
{
    for (int byte = 0; byte < static_cast<int>(type); ++byte, index >>= 8)
        to[byte] = static_cast<unsigned char>(index);
}

// Whatever lies between the indices is no index.
TEST(CheckIndices, finds_the_first_that_is_past_the_palette)
{
    GuardedBuffer buffer(1 << 14);
    for (const IndexType &t : all_types)
        for (std::size_t gap : {0, 1, 3, 12})
            for (std::size_t count : {1, 2, 5, 16, 31, 64, 67, 130})
                for (Guard guard : {Guard::after, Guard::before}) {
                    const std::size_t stride = t.type + gap, size = (count - 1) * stride + t.type;
                    unsigned char *const first = buffer.place(size, guard);
                    std::memset(first, 0xff, size);
                    const mw_indices indices = {first, stride, t.type};
                    for (std::size_t i = 0; i < count; ++i)
                        put(first + i * stride, t.type, i % 100);
                    std::size_t bad = 1234;
                    EXPECT_EQ(check_indices(indices, count, 100, &bad), MW_OK);
                    EXPECT_EQ(bad, 1234u);
                    for (std::size_t place = 0; place < count; ++place) {
                        put(first + (count - 1) * stride, t.type, t.largest);
                        put(first + place * stride, t.type, 100);
                        EXPECT_EQ(check_indices(indices, count, 100, &bad), MW_ERROR_INDEX);
                        EXPECT_EQ(bad, place) << "of " << count << ", stride " << stride;
                        EXPECT_EQ(check_indices(indices, count, 100, nullptr), MW_ERROR_INDEX);
                        put(first + (count - 1) * stride, t.type, 99);
                        put(first + place * stride, t.type, 99);
                    }
                }
}

TEST(CheckIndices, takes_the_largest_index_for_what_it_is)
{
    unsigned char index[4];
    for (const IndexType &t : all_types) {
        put(index, t.type, t.largest);
        const mw_indices indices = {index, std::size_t(t.type), t.type};
        std::size_t bad = 1234;
        EXPECT_EQ(check_indices(indices, 1, t.largest, &bad), MW_ERROR_INDEX);
        EXPECT_EQ(bad, 0u);
        EXPECT_EQ(check_indices(indices, 1, t.largest + 1, &bad), MW_OK);
        EXPECT_EQ(check_indices(indices, 1, most, &bad), MW_OK);
    }
}

TEST(CheckIndices, says_what_else_is_wrong)
{
    const unsigned char numbers[64] = {};
    std::size_t bad = 1234;
    for (const IndexType &t : all_types) {
        const std::size_t size = t.type;
        EXPECT_EQ(check_indices({nullptr, size, t.type}, 3, 5, &bad), MW_ERROR_NULL);
        EXPECT_EQ(check_indices({numbers, size - 1, t.type}, 3, 5, &bad), MW_ERROR_STRIDE);
        EXPECT_EQ(check_indices({numbers, 0, t.type}, 3, 5, &bad), MW_ERROR_STRIDE);
        EXPECT_EQ(check_indices({numbers, size, t.type}, most, 5, &bad), MW_ERROR_SIZE);
        EXPECT_EQ(check_indices({numbers, most / 4, t.type}, 20, 5, &bad), MW_ERROR_SIZE);
        EXPECT_EQ(check_indices({nullptr, 0, t.type}, 0, 5, &bad), MW_OK);
    }
    for (int type : {0, 3, 5, 6, 7})
        EXPECT_EQ(check_indices({numbers, 8, static_cast<mw_index_type>(type)}, 3, 5, &bad), MW_ERROR_INDEX_TYPE);
    EXPECT_EQ(bad, 1234u);
    EXPECT_EQ(check_indices({numbers, 1, MW_INDEX_U8}, 3, 0, &bad), MW_ERROR_INDEX);
    EXPECT_EQ(bad, 0u);
}

}  // namespace
}  // namespace motorway::testing
