// What the API hands to the kernels: the same whatever the stack held before, and no stores past the caches where
// nobody asked for them. Spies take the places of all kernels, look at the call, and pass it on.

#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_list.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

// The fields of a call that only some pairings take, and what becomes of its stores.
struct Seen {
    unsigned char streaming;
    unsigned index_size;
    std::array<std::size_t, 6> numbers;
    std::array<const void *, 4> pointers;
};

const kernel_table *spied_on;
std::vector<Seen> calls;
std::size_t fences;

template <class T, class E>
void see(const call<T, E> &c)
{
    Seen seen{0,
              c.indices.size,
              {c.count, c.terms, c.rows, c.row_stride, c.motors.stride, c.indices.stride},
              {c.fixed, c.motors.component, c.palette, c.indices.first}};
    std::memcpy(&seen.streaming, &c.streaming, 1);  // which may be no bool
    calls.push_back(seen);
}

// The spy in the place of kernel number K.
template <std::size_t K>
struct Spy {
    static void f32(const call<float> &c) { see(c), spied_on->f32[K](c); }
    static void f64(const call<double> &c) { see(c), spied_on->f64[K](c); }
    static void mixed(const call<double, float> &c) { see(c), spied_on->mixed[K](c); }
};

void see_fence() { ++fences, spied_on->fence(); }

// All kernels in use are spied on until the end of the scope.
class Spies {
public:
    Spies() : table_(*kernels())
    {
        spied_on = kernels();
        table_.fence = see_fence;
        place(std::make_index_sequence<static_cast<std::size_t>(kernel_id::count)>(),
              std::make_index_sequence<static_cast<std::size_t>(mixed_kernel_id::count)>());
        selected_kernels.store(&table_);
        calls.clear();
        fences = 0;
    }
    ~Spies() { selected_kernels.store(spied_on); }
    Spies(const Spies &) = delete;

private:
    template <std::size_t... K, std::size_t... Mixed>
    void place(std::index_sequence<K...>, std::index_sequence<Mixed...>)
    {
        ((table_.f32[K] = Spy<K>::f32, table_.f64[K] = Spy<K>::f64), ...);
        ((table_.mixed[Mixed] = Spy<Mixed>::mixed), ...);
    }

    kernel_table table_;
};

// Fills the stack that the next call takes.
__attribute__((noinline)) void spoil_stack(unsigned char byte)
{
    volatile unsigned char spoilt[1 << 15];
    for (volatile unsigned char &each : spoilt)
        each = byte;
}

template <class Field>
Field spoilt(unsigned char byte)
{
    Field field;
    std::memset(&field, byte, sizeof field);
    return field;
}

// Not even a field that no kernel of the pairing should read.
template <class Call>
void expect_no_field_of_chance(const std::string &name, const Call &call)
{
    for (const unsigned char byte : {0xa5, 0x3c}) {
        calls.clear();
        spoil_stack(byte);
        ASSERT_EQ(call(), MW_OK) << name;
        ASSERT_FALSE(calls.empty()) << name << " calls no kernel";
        for (const Seen &seen : calls) {
            EXPECT_EQ(seen.streaming, 0) << name;
            EXPECT_NE(seen.index_size, spoilt<unsigned>(byte)) << name;
            for (std::size_t number : seen.numbers)
                EXPECT_NE(number, spoilt<std::size_t>(byte)) << name;
            for (const void *pointer : seen.pointers)
                EXPECT_NE(pointer, spoilt<const void *>(byte)) << name;
        }
    }
    EXPECT_EQ(fences, 0u) << name;
}

// Enough for stores past the caches, and for the loops that are only for many.
constexpr std::size_t enough = 300;

template <class T>
void check_row(const KernelRow &row)
{
    for (const auto &subject : row.subjects<T>()) {
        Pool<T> pool = make_pool(*subject, enough, 5, Specials::none);
        std::vector<T> results(enough * pool.output_components);
        std::vector<View<T>> inputs;
        for (std::size_t k = 0; k < pool.inputs.size(); ++k)
            inputs.push_back(packed_view(pool.element(k, 0), pool.operands[k].components, pool.operands[k].scalar));
        const View<T> out = packed_view(results.data(), pool.output_components);
        const Spies spies;
        expect_no_field_of_chance(row.name, [&] { return subject->run(out, inputs, enough); });
    }
}

TEST(CallTest, no_field_is_left_to_chance)
{
    for (const KernelRow &row : kernel_rows()) {
        check_row<float>(row);
        if (row.variant != Variant::mixed)
            check_row<double>(row);
    }
}

template <class T>
class HierarchyCallTest : public ::testing::Test {
};
TYPED_TEST_SUITE(HierarchyCallTest, Precisions, PrecisionName);

TYPED_TEST(HierarchyCallTest, no_field_is_left_to_chance)
{
    using T = TypeParam;
    using A = api<T>;
    const std::vector<typename A::motor> locals(2 * enough, {1, 0, 0, 0, 0, 0, 0, 0});
    std::vector<typename A::motor> out(locals);
    const std::int32_t parents[] = {-1, 0};
    const std::size_t stride = sizeof locals[0];
    const Spies spies;
    expect_no_field_of_chance("hierarchy", [&] {
        return A::compose_motor_hierarchy(A::motors_aos(out.data(), stride), A::const_motors_aos(locals.data(), stride),
                                          enough * stride, parents, 2, enough, nullptr);
    });
}

// That the spies see what there is to see.
TYPED_TEST(HierarchyCallTest, stores_past_the_caches_are_fenced)
{
    using T = TypeParam;
    using A = api<T>;
    const typename A::motor motor{1, 0, 0, 0, 0, 0, 0, 0};
    std::vector<T> in(3 * enough, T(1)), out(3 * enough);
    for (unsigned flags : {unsigned(MW_STREAMING_STORES), unsigned(MW_NO_STREAMING_STORES), unsigned(MW_DEFAULT)}) {
        const Spies spies;
        ASSERT_EQ(A::apply_point_one(A::xyz_aos(out.data(), sizeof(T[3])), &motor,
                                     A::const_xyz_aos(in.data(), sizeof(T[3])), enough, flags),
                  MW_OK);
        const bool streaming = flags == MW_STREAMING_STORES;
        ASSERT_EQ(calls.size(), 1u);
        EXPECT_EQ(calls[0].streaming, streaming);
        EXPECT_EQ(fences, streaming);
    }
}

}  // namespace
}  // namespace motorway::testing
