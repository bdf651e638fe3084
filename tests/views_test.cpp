// The views of the header: where the components of an element are, however a view was made.

#include <cstring>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "apply_api.h"

namespace motorway::testing {
namespace {

// The pointers of a view, and its stride behind them.
template <class V>
std::vector<const char *> pointers_of(const V &view)
{
    std::vector<const char *> pointers(sizeof view / sizeof(void *) - 1);
    std::memcpy(pointers.data(), &view, pointers.size() * sizeof(void *));
    return pointers;
}

// `first` is what a packed array of such elements is an array of.
template <class T, class V, class Element>
void expect_views(V (*aos)(Element *, std::size_t), V (*soa)(T *const *), V (*from)(V, std::size_t), Element *first)
{
    const std::size_t components = sizeof(V) / sizeof(void *) - 1;
    const char *const begin = reinterpret_cast<const char *>(first);
    const V packed = aos(first, 77);
    EXPECT_EQ(packed.stride, 77u);
    for (std::size_t c = 0; c < components; ++c)
        EXPECT_EQ(pointers_of(packed)[c], begin + c * sizeof(T)) << "component " << c;
    const V range = from(packed, 3);
    EXPECT_EQ(range.stride, 77u);
    for (std::size_t c = 0; c < components; ++c)
        EXPECT_EQ(pointers_of(range)[c], begin + c * sizeof(T) + 3 * 77) << "component " << c;
    T arrays[8] = {};
    T *pointers[8];
    for (std::size_t c = 0; c < components; ++c)
        pointers[c] = const_cast<T *>(&arrays[components - 1 - c]);
    const V separate = soa(pointers);
    EXPECT_EQ(separate.stride, sizeof(T));
    for (std::size_t c = 0; c < components; ++c)
        EXPECT_EQ(pointers_of(separate)[c], reinterpret_cast<const char *>(pointers[c])) << "component " << c;
    for (const char *pointer : pointers_of(from(aos(nullptr, 77), 3)))
        EXPECT_EQ(pointer, nullptr);
    for (const char *pointer : pointers_of(aos(nullptr, 77)))
        EXPECT_EQ(pointer, nullptr);
}

// The one view, of mutable and of const numbers.
#define MOTORWAY_TEST_VIEW(view, P, element, soa)                                                                    \
    {                                                                                                                \
        SCOPED_TRACE(#view);                                                                                         \
        element numbers[8] = {};                                                                                     \
        expect_views<scalar_##P>(mw_##view##_##P##_aos, mw_##view##_##P##soa, mw_##view##_##P##_from, numbers);      \
        expect_views<const scalar_##P>(mw_const_##view##_##P##_aos, mw_const_##view##_##P##soa,                      \
                                       mw_const_##view##_##P##_from, static_cast<const element *>(numbers));         \
    }

#define MOTORWAY_TEST_VIEWS(P)                                                                                       \
    MOTORWAY_TEST_VIEW(xyz, P, scalar_##P, _soa_of)                                                                  \
    MOTORWAY_TEST_VIEW(xyzw, P, scalar_##P, _soa)                                                                    \
    MOTORWAY_TEST_VIEW(vectors, P, scalar_##P, _soa)                                                                 \
    MOTORWAY_TEST_VIEW(lines, P, scalar_##P, _soa)                                                                   \
    MOTORWAY_TEST_VIEW(motors, P, mw_motor_##P, _soa)                                                                \
    MOTORWAY_TEST_VIEW(bivectors, P, scalar_##P, _soa)                                                               \
    MOTORWAY_TEST_VIEW(dual_quaternions, P, scalar_##P, _soa)                                                        \
    MOTORWAY_TEST_VIEW(screws, P, scalar_##P, _soa)

TEST(Views, of_f32_point_to_their_components) { MOTORWAY_TEST_VIEWS(f32) }
TEST(Views, of_f64_point_to_their_components) { MOTORWAY_TEST_VIEWS(f64) }

TEST(Views, of_three_arrays_take_them_one_by_one)
{
    float f[3] = {};
    double d[3] = {};
    EXPECT_EQ(pointers_of(mw_xyz_f32_soa(f + 2, f, f + 1)), pointers_of(mw_xyz_f32{f + 2, f, f + 1, 4}));
    EXPECT_EQ(pointers_of(mw_xyz_f64_soa(d + 2, d, d + 1)), pointers_of(mw_xyz_f64{d + 2, d, d + 1, 8}));
    EXPECT_EQ(pointers_of(mw_const_xyz_f32_soa(f + 2, f, f + 1)), pointers_of(mw_xyz_f32{f + 2, f, f + 1, 4}));
    EXPECT_EQ(pointers_of(mw_const_xyz_f64_soa(d + 2, d, d + 1)), pointers_of(mw_xyz_f64{d + 2, d, d + 1, 8}));
    EXPECT_EQ(mw_xyz_f32_soa(f, f + 1, f + 2).stride, 4u);
    EXPECT_EQ(mw_xyz_f64_soa(d, d + 1, d + 2).stride, 8u);
}

// Where w comes first in memory; the names stay with their components.
#define MOTORWAY_TEST_WXYZ(kind, P, scalar, of_numbers)                                                              \
    {                                                                                                                \
        SCOPED_TRACE(#kind #P);                                                                                      \
        of_numbers scalar numbers[8] = {};                                                                           \
        const auto q = mw_##kind##xyzw_##P##_wxyz(numbers, 77);                                                      \
        EXPECT_EQ(std::vector({q.w, q.x, q.y, q.z}), std::vector({numbers, numbers + 1, numbers + 2, numbers + 3})); \
        EXPECT_EQ(q.stride, 77u);                                                                                    \
        const auto d = mw_##kind##dual_quaternions_##P##_wxyz(numbers, 78);                                          \
        EXPECT_EQ(std::vector({d.rw, d.rx, d.ry, d.rz, d.dw, d.dx, d.dy, d.dz}),                                     \
                  std::vector({numbers, numbers + 1, numbers + 2, numbers + 3, numbers + 4, numbers + 5,             \
                               numbers + 6, numbers + 7}));                                                          \
        EXPECT_EQ(d.stride, 78u);                                                                                    \
        for (const char *pointer : pointers_of(mw_##kind##xyzw_##P##_wxyz(nullptr, 77)))                             \
            EXPECT_EQ(pointer, nullptr);                                                                             \
        for (const char *pointer : pointers_of(mw_##kind##dual_quaternions_##P##_wxyz(nullptr, 77)))                 \
            EXPECT_EQ(pointer, nullptr);                                                                             \
    }

TEST(Views, of_quaternions_may_have_w_first)
{
    MOTORWAY_TEST_WXYZ(, f32, float, )
    MOTORWAY_TEST_WXYZ(, f64, double, )
    MOTORWAY_TEST_WXYZ(const_, f32, float, const)
    MOTORWAY_TEST_WXYZ(const_, f64, double, const)
}

TEST(Views, of_vertices_are_two)
{
    float vertices[32] = {};
    const mw_vertices_f32 view = {mw_xyz_f32_aos(vertices, 20), mw_xyz_f32_aos(vertices + 16, 12)};
    const mw_vertices_f32 range = mw_vertices_f32_from(view, 2);
    EXPECT_EQ(range.position.y, vertices + 11);
    EXPECT_EQ(range.normal.z, vertices + 24);
    EXPECT_EQ(mw_vertices_f64_from(mw_vertices_f64{}, 5).normal.y, nullptr);
    EXPECT_EQ(mw_const_vertices_f32_from(mw_const_vertices_f32{}, 5).position.x, nullptr);
}

TEST(Views, of_indices_know_their_type)
{
    const std::uint8_t u8[4] = {};
    const std::uint16_t u16[4] = {};
    const std::uint32_t u32[4] = {};
    EXPECT_EQ(mw_indices_u8(u8, 1).type, MW_INDEX_U8);
    EXPECT_EQ(mw_indices_u16(u16, 2).type, MW_INDEX_U16);
    EXPECT_EQ(mw_indices_u32(u32, 4).type, MW_INDEX_U32);
    EXPECT_EQ(mw_indices_from(mw_indices_u16(u16, 2), 3).first, u16 + 3);
    EXPECT_EQ(mw_indices_from(mw_indices_u32(nullptr, 4), 5).first, nullptr);
}

}  // namespace
}  // namespace motorway::testing
