// What can be wrong with a call of an apply function beyond its views of elements (error_test.cpp): flags, motors,
// palettes, indices and the rows of a grid. Every operand in every pairing, and nothing is written.

#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apply_api.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();

// A call without fault, whose arguments a test then spoils. The motors are as many as the elements, and a grid has
// room for rows with gaps.
template <class T>
class SoundCall {
public:
    static constexpr std::size_t count = 24, motor_count = 24;

    SoundCall(const ApplyFunctions<T> &functions, Pairing pairing)
        : functions_(functions), pairing_(pairing), motors_(motor_count * functions.motor_size(), 0),
          in_(count * element_size()),
          out_((pairing == Pairing::grid ? 2 * motor_count : 1) * count * element_size()), indices_(2 * count)
    {
        for (std::size_t m = 0; m < motor_count; ++m)
            set_motor(m, 0, 1);
        for (std::size_t k = 0; k < in_.size() / sizeof(T); ++k)
            reinterpret_cast<T *>(in_.data())[k] = T(k % 7);
        for (std::size_t i = 0; i < count; ++i)
            set_index(i, static_cast<std::uint16_t>(i * 5 % motor_count));
        call.in = packed_view(reinterpret_cast<T *>(in_.data()), functions.components());
        call.out = packed_view(reinterpret_cast<T *>(out_.data()), functions.components());
        call.motors = packed_view(reinterpret_cast<T *>(motors_.data()), 8, functions.motor_scalar);
        call.motor = motors_.data();
        call.motor_count = motor_count;
        call.indices = {indices_.data(), 2, MW_INDEX_U16};
        call.row_stride = count * element_size();
        call.shift = &shift_;
        call.count = count;
    }

    Pairing pairing() const { return pairing_; }
    bool is_indexed() const { return pairing_ == Pairing::indexed || pairing_ == Pairing::indexed_checked; }
    bool is_grid() const { return pairing_ == Pairing::grid; }
    // The motors are a view, and else they are an array.
    bool has_motors() const { return pairing_ == Pairing::each || is_grid(); }
    const ApplyFunctions<T> &functions() const { return functions_; }
    std::size_t element_size() const { return functions_.components() * sizeof(T); }
    unsigned char *motors() { return motors_.data(); }
    unsigned char *in() { return in_.data(); }
    unsigned char *indices() { return indices_.data(); }

    template <class M>
    void set(std::size_t m, std::size_t component, M number)
    {
        std::memcpy(&motors_[m * functions_.motor_size() + component * sizeof(M)], &number, sizeof number);
    }
    void set_motor(std::size_t m, std::size_t component, double number)
    {
        if (functions_.motor_scalar == sizeof(double))
            set(m, component, number);
        else
            set(m, component, static_cast<float>(number));
    }
    void set_index(std::size_t i, std::uint16_t index) { std::memcpy(&indices_[2 * i], &index, sizeof index); }

    // The output at these bytes, packed.
    void put_output_at(unsigned char *first)
    {
        call.out = packed_view(reinterpret_cast<T *>(first), functions_.components());
    }

    mw_status run() const { return functions_.run(pairing_, call); }

    void expect(mw_status status, const std::string &what) const
    {
        const auto before = bytes();
        const mw_status got = run();
        EXPECT_EQ(got, status) << functions_.name(pairing_) << ", " << what << ": " << mw_status_text(got);
        EXPECT_TRUE(status == MW_OK || bytes() == before) << functions_.name(pairing_) << ", " << what
                                                          << ": bytes changed";
    }

    ApplyCall<T> call;

private:
    std::vector<std::vector<unsigned char>> bytes() const { return {motors_, in_, out_, indices_}; }

    ApplyFunctions<T> functions_;
    Pairing pairing_;
    std::vector<unsigned char> motors_, in_, out_, indices_;
    mw_shift shift_{{1, 2, 3}, {4, 5, 6}};
};

template <class T>
class ApplyErrorTest : public ::testing::Test {
protected:
    // Once for every operand and pairing, with a call of its own.
    static void for_every_function(const std::function<void(SoundCall<T> &)> &body)
    {
        for (const ApplyFunctions<T> &functions : apply_functions<T>())
            for (Pairing pairing : all_pairings) {
                SoundCall<T> call(functions, pairing);
                ASSERT_EQ(call.run(), MW_OK) << functions.name(pairing) << ": the call is not even valid";
                body(call);
            }
    }
};

TYPED_TEST_SUITE(ApplyErrorTest, Precisions, PrecisionName);

TYPED_TEST(ApplyErrorTest, known_flags)
{
    this->for_every_function([](auto &call) {
        for (unsigned flags : {MW_UNIT_MOTORS + 0u, MW_STREAMING_STORES + 0u, MW_NO_STREAMING_STORES + 0u,
                               MW_UNIT_MOTORS | MW_STREAMING_STORES | 0u,
                               MW_UNIT_MOTORS | MW_NO_STREAMING_STORES | 0u}) {
            call.call.flags = flags;
            call.expect(MW_OK, "flags " + std::to_string(flags));
        }
    });
}

TYPED_TEST(ApplyErrorTest, flags_that_are_unknown_or_contradict_each_other)
{
    this->for_every_function([](auto &call) {
        for (unsigned flags : {8u, 9u, 1u << 16, 1u << 31, ~0u, MW_STREAMING_STORES | MW_NO_STREAMING_STORES | 0u,
                               MW_UNIT_MOTORS | MW_STREAMING_STORES | MW_NO_STREAMING_STORES | 0u}) {
            call.call.flags = flags;
            call.expect(MW_ERROR_FLAGS, "flags " + std::to_string(flags));
        }
    });
}

TYPED_TEST(ApplyErrorTest, a_count_of_0_takes_null_pointers)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : all_pairings)
            for (std::size_t motor_count : {0, 1, 5}) {
                ApplyCall<T> call;
                call.motor_count = motor_count;
                EXPECT_EQ(functions.run(pairing, call), MW_OK) << functions.name(pairing);
                call.flags = MW_UNIT_MOTORS | MW_STREAMING_STORES;
                EXPECT_EQ(functions.run(pairing, call), MW_OK) << functions.name(pairing);
            }
}

// Positions and normals are views of their own. Both may be read from the same numbers, but not written to them.
TYPED_TEST(ApplyErrorTest, positions_that_share_bytes_with_normals)
{
    using T = TypeParam;
    const ApplyFunctions<T> functions = apply_functions_of<T>(Moved::vertex);
    for (Pairing pairing : all_pairings)
        for (std::ptrdiff_t bytes : {std::ptrdiff_t(0), std::ptrdiff_t(1), std::ptrdiff_t(3 * sizeof(T) - 1),
                                     1 - std::ptrdiff_t(3 * sizeof(T)), std::ptrdiff_t(12 * sizeof(T) - 1)}) {
            SoundCall<T> call(functions, pairing);
            const auto put_normals = [&](View<T> &view) {
                for (std::size_t c = 0; c < 3; ++c) {
                    auto *const position = reinterpret_cast<unsigned char *>(view.component[c] + 6);
                    view.component[c] = reinterpret_cast<T *>(position);
                    view.component[3 + c] = reinterpret_cast<T *>(position + bytes);
                }
            };
            call.call.count -= 4;
            if (pairing != Pairing::grid)
                put_normals(call.call.in);
            call.expect(MW_OK, "normals read " + std::to_string(bytes) + " bytes behind the positions");
            put_normals(call.call.out);
            // In a grid that is found with its rows.
            call.expect(pairing == Pairing::grid ? MW_ERROR_STRIDE : MW_ERROR_OVERLAP,
                        "normals " + std::to_string(bytes) + " bytes behind the positions");
        }
}

// An array a component and a packed one, as an allocator may have them: the output lies behind the first array of the
// input, or of the motors, and before the others, and has no byte in common with any.
TYPED_TEST(ApplyErrorTest, an_output_between_the_arrays_of_an_input_is_no_overlap)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : all_pairings)
            for (bool of_motors : {false, true}) {
                SoundCall<T> call(functions, pairing);
                if (of_motors && !call.has_motors())
                    continue;
                View<T> &input = of_motors ? call.call.motors : call.call.in;
                const std::size_t scalar = of_motors ? functions.motor_scalar : sizeof(T);
                const std::size_t array = scalar * call.count;
                const std::size_t out_bytes = call.motor_count * call.count * call.element_size();
                std::vector<double> memory((8 * array + out_bytes) / sizeof(double) + 2);
                unsigned char *next = reinterpret_cast<unsigned char *>(memory.data());
                for (std::size_t c = 0; c < input.component.size(); ++c) {
                    if (c == 1) {
                        call.put_output_at(next);
                        next += out_bytes;
                    }
                    const char *const from = reinterpret_cast<char *>(input.component[c]);
                    for (std::size_t i = 0; i < call.count; ++i)
                        std::memcpy(next + i * scalar, from + i * input.stride, scalar);
                    input.component[c] = reinterpret_cast<T *>(next);
                    next += array;
                }
                input.stride = scalar;
                call.expect(MW_OK, std::string("between the arrays of the ") + (of_motors ? "motors" : "input"));
            }
}

// ------------------------------------------------------------------------------------------------------- motors

TYPED_TEST(ApplyErrorTest, motors_that_are_null)
{
    this->for_every_function([](auto &call) {
        if (!call.has_motors()) {
            call.call.motor = nullptr;
            call.expect(MW_ERROR_NULL, "no motor");
            return;
        }
        for (auto *&component : call.call.motors.component) {
            auto *const kept = std::exchange(component, nullptr);
            call.expect(MW_ERROR_NULL, "no component of the motors");
            component = kept;
        }
    });
}

// Under one motor alone that is an error; else it is left to mw_check_motors.
TYPED_TEST(ApplyErrorTest, a_degenerate_motor)
{
    using T = TypeParam;
    this->for_every_function([](SoundCall<T> &sound) {
        const bool f64 = sound.functions().motor_scalar == sizeof(double);
        const double least = f64 ? std::numeric_limits<double>::min() : std::numeric_limits<float>::min();
        const double largest = f64 ? std::numeric_limits<double>::max() : std::numeric_limits<float>::max();
        for (double bad : {0.0, std::sqrt(least) / 2, std::sqrt(largest) * 2, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
            SoundCall<T> call(sound.functions(), sound.pairing());
            call.set_motor(0, 0, bad);
            call.expect(call.pairing() == Pairing::one ? MW_ERROR_DEGENERATE_MOTOR : MW_OK,
                        "s " + std::to_string(bad));
        }
        SoundCall<T> call(sound.functions(), sound.pairing());
        call.set_motor(0, 2, std::numeric_limits<double>::quiet_NaN());
        call.expect(call.pairing() == Pairing::one ? MW_ERROR_DEGENERATE_MOTOR : MW_OK, "b13 that is NaN");
    });
}

TYPED_TEST(ApplyErrorTest, an_output_over_the_motors)
{
    using T = TypeParam;
    this->for_every_function([](SoundCall<T> &call) {
        // An output from the first motor on or the second, or one that ends in the first byte of the first.
        const std::size_t out_bytes = (call.is_grid() ? call.motor_count : 1) * call.count * call.element_size();
        const std::size_t motor = call.functions().motor_size();
        const bool in_place = call.pairing() == Pairing::each && call.functions().moved == Moved::motor;
        const auto expect_overlap = [&](unsigned char *first, const std::string &what) {
            call.put_output_at(first);
            call.expect(MW_ERROR_OVERLAP, "the output is " + what);
        };
        if (!in_place)
            expect_overlap(call.motors(), "over the motors");
        expect_overlap(call.motors() + 1, "a byte behind the first of the motors");
        expect_overlap(call.motors() + motor - 1, "over the end of the first motor");
        expect_overlap(call.motors() - out_bytes + 1, "before the motors and over their first byte");
        if (call.is_indexed())
            expect_overlap(call.motors() + motor * call.motor_count - 1, "over the end of the palette");
    });
}

// A palette is read where its indices say, so all of it counts; an output right behind it or before it is none.
TYPED_TEST(ApplyErrorTest, an_output_that_touches_the_palette_is_no_overlap)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : {Pairing::one, Pairing::indexed, Pairing::indexed_checked}) {
            SoundCall<T> call(functions, pairing);
            const std::size_t motors = pairing == Pairing::one ? 1 : 4, out_bytes = call.count * call.element_size();
            std::vector<unsigned char> memory(2 * out_bytes + motors * functions.motor_size());
            std::memcpy(&memory[out_bytes], call.motors(), motors * functions.motor_size());
            for (std::size_t i = 0; i < call.count; ++i)
                call.set_index(i, static_cast<std::uint16_t>(i % motors));
            call.call.motor = &memory[out_bytes];
            call.call.motor_count = motors;
            for (std::size_t at : {std::size_t(0), out_bytes + motors * functions.motor_size()}) {
                call.put_output_at(&memory[at]);
                call.expect(MW_OK, "the output touches the motors");
            }
        }
}

// ------------------------------------------------------------------------------------------------------ indices

TYPED_TEST(ApplyErrorTest, indices_in_a_wrong_place)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : {Pairing::indexed, Pairing::indexed_checked}) {
            const SoundCall<T> sound(functions, pairing);
            const auto expect = [&](mw_status status, mw_indices indices, const std::string &what) {
                SoundCall<T> call(functions, pairing);
                call.call.indices = indices;
                call.expect(status, what);
            };
            const mw_indices good = sound.call.indices;
            expect(MW_ERROR_NULL, {nullptr, 2, MW_INDEX_U16}, "no indices");
            expect(MW_ERROR_STRIDE, {good.first, 1, MW_INDEX_U16}, "stride 1 of u16");
            expect(MW_ERROR_STRIDE, {good.first, 0, MW_INDEX_U8}, "stride 0 of u8");
            expect(MW_ERROR_STRIDE, {good.first, 3, MW_INDEX_U32}, "stride 3 of u32");
            expect(MW_ERROR_SIZE, {good.first, most / 4, MW_INDEX_U16}, "a stride of a quarter of the address space");
            for (int type : {0, 3, 5, 6, 7})  // what fits the enumeration
                expect(MW_ERROR_INDEX_TYPE, {good.first, 8, static_cast<mw_index_type>(type)},
                       "type " + std::to_string(type));
        }
}

TYPED_TEST(ApplyErrorTest, an_output_over_the_indices)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : {Pairing::indexed, Pairing::indexed_checked}) {
            SoundCall<T> call(functions, pairing);
            const std::size_t out_bytes = call.count * call.element_size();
            for (std::ptrdiff_t at : {std::ptrdiff_t(0), std::ptrdiff_t(2 * call.count - 1),
                                      1 - std::ptrdiff_t(out_bytes)}) {
                call.put_output_at(call.indices() + at);
                call.expect(MW_ERROR_OVERLAP, "the output is " + std::to_string(at) + " bytes behind the indices");
            }
        }
}

// As a vertex has them: its index between its components, in place or not.
TYPED_TEST(ApplyErrorTest, indices_among_the_elements_are_no_overlap)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : {Pairing::indexed, Pairing::indexed_checked}) {
            SoundCall<T> call(functions, pairing);
            const std::size_t stride = call.element_size() + sizeof(T);
            std::vector<unsigned char> vertices(call.count * stride);
            call.call.in = packed_view(reinterpret_cast<T *>(vertices.data()), functions.components());
            call.call.in.stride = stride;
            call.call.out = call.call.in;
            call.call.indices = {vertices.data() + call.element_size(), stride, MW_INDEX_U8};
            call.expect(MW_OK, "indices in the elements");
        }
}

TYPED_TEST(ApplyErrorTest, a_palette_beyond_the_address_space)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : {Pairing::indexed, Pairing::indexed_checked})
            for (std::size_t size : {most, most / 16, most / functions.motor_size() + 2}) {
                SoundCall<T> call(functions, pairing);
                call.call.motor_count = size;
                call.expect(MW_ERROR_SIZE, "a palette of " + std::to_string(size));
            }
}

// The first of those that are too large, wherever it is; nothing is written, not even before it.
TYPED_TEST(ApplyErrorTest, an_index_past_the_palette)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (std::size_t place = 0; place < SoundCall<T>::count; ++place)
            for (std::uint16_t bad : {std::uint16_t(SoundCall<T>::motor_count), std::uint16_t(0xffff)}) {
                SoundCall<T> call(functions, Pairing::indexed_checked);
                call.set_index(place, bad);
                call.set_index(call.count - 1, 0x8000);  // the last is wrong too, and not the first
                std::size_t first_bad = 1234;
                call.call.first_bad = &first_bad;
                call.expect(MW_ERROR_INDEX, "index " + std::to_string(bad));
                EXPECT_EQ(first_bad, place) << functions.name(Pairing::indexed_checked);
                call.call.first_bad = nullptr;
                call.expect(MW_ERROR_INDEX, "index " + std::to_string(bad) + ", and nobody asks where");
            }
}

TYPED_TEST(ApplyErrorTest, an_empty_palette_has_no_index)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>()) {
        SoundCall<T> call(functions, Pairing::indexed_checked);
        std::size_t first_bad = 1234;
        call.call.first_bad = &first_bad;
        call.call.motor_count = 0;
        call.expect(MW_ERROR_INDEX, "an empty palette");
        EXPECT_EQ(first_bad, 0u);
    }
}

// Other errors say nothing of indices, and neither does success.
TYPED_TEST(ApplyErrorTest, first_bad_is_written_for_an_index_alone)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>()) {
        SoundCall<T> call(functions, Pairing::indexed_checked);
        std::size_t first_bad = 1234;
        call.call.first_bad = &first_bad;
        call.expect(MW_OK, "nothing wrong");
        call.call.flags = 1u << 20;
        call.expect(MW_ERROR_FLAGS, "an unknown flag");
        EXPECT_EQ(first_bad, 1234u);
    }
}

// -------------------------------------------------------------------------------------------------------- grids

// Runs every operand as a grid, with what `body` makes of the call.
template <class T>
void for_every_grid(const std::function<void(SoundCall<T> &)> &body)
{
    for (const ApplyFunctions<T> &functions : apply_functions<T>()) {
        SoundCall<T> call(functions, Pairing::grid);
        body(call);
    }
}

TYPED_TEST(ApplyErrorTest, rows_that_run_into_each_other)
{
    using T = TypeParam;
    for_every_grid<T>([](SoundCall<T> &call) {
        const std::size_t element = call.element_size(), motors = call.motor_count, count = call.count;
        const auto expect = [&](std::size_t stride, std::size_t row_stride) {
            call.call.out.stride = stride;
            call.call.row_stride = row_stride;
            call.expect(MW_ERROR_STRIDE, "stride " + std::to_string(stride) + ", rows every " +
                                             std::to_string(row_stride) + " bytes");
        };
        expect(element, 0);
        expect(element, count * element - 1);                // the last element and the first of the next row
        expect(element, element);                            // row m is row 0 from element m on
        expect(2 * element, count * 2 * element - 1);        // no byte is shared, yet neither is above the other
        expect(motors * element - 1, element);               // point-major, and a byte short of it
        expect(motors * element, element - 1);               // the images of one point
        expect(motors * element, 0);
    });
}

// Rows of arrays: each of the components fits, and one is where the next row of another is.
TYPED_TEST(ApplyErrorTest, rows_that_run_into_another_component)
{
    using T = TypeParam;
    for_every_grid<T>([](SoundCall<T> &call) {
        T *const first = call.call.out.component[0];
        const std::size_t row = call.count * sizeof(T);
        call.call.out.stride = sizeof(T);
        for (std::size_t c = 0; c < call.functions().components(); ++c)
            call.call.out.component[c] = first + c * call.count;
        call.call.row_stride = row;
        call.expect(MW_ERROR_STRIDE, "an array a component, and rows every array");
        call.call.row_stride = 2 * row;
        call.expect(MW_ERROR_STRIDE, "an array a component, and rows every two");
        call.call.row_stride = call.functions().components() * row;
        call.expect(MW_OK, "an array a component, and rows behind them all");
    });
}

TYPED_TEST(ApplyErrorTest, a_grid_beyond_the_address_space)
{
    using T = TypeParam;
    for_every_grid<T>([](SoundCall<T> &call) {
        const std::size_t row = call.call.row_stride;
        for (std::size_t row_stride : {most / 2, most / 8, most / call.motor_count, most - call.element_size()}) {
            call.call.row_stride = row_stride;
            call.expect(MW_ERROR_SIZE, "rows every " + std::to_string(row_stride) + " bytes");
        }
        call.call.row_stride = row;
        for (std::size_t motor_count : {most, most / 2, most / row + 1}) {
            call.call.motor_count = motor_count;
            call.expect(MW_ERROR_SIZE, std::to_string(motor_count) + " motors");
        }
    });
}

TYPED_TEST(ApplyErrorTest, motors_of_a_grid_or_each_in_a_wrong_stride)
{
    using T = TypeParam;
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (Pairing pairing : {Pairing::each, Pairing::grid}) {
            SoundCall<T> call(functions, pairing);
            const std::size_t motor = functions.motor_size();
            for (std::size_t stride : {motor - 1, functions.motor_scalar, std::size_t(0)}) {
                call.call.motors.stride = stride;
                call.expect(MW_ERROR_STRIDE, "motors every " + std::to_string(stride) + " bytes");
            }
            call.call.motors.stride = most / 8;
            call.expect(MW_ERROR_SIZE, "motors every eighth of the address space");
        }
}

// Its bytes are those from the first to the last, gaps included, so it is never in place.
TYPED_TEST(ApplyErrorTest, a_grid_over_its_input)
{
    using T = TypeParam;
    for_every_grid<T>([](SoundCall<T> &call) {
        const std::size_t out_bytes = call.motor_count * call.count * call.element_size();
        const std::size_t in_bytes = call.count * call.element_size();
        for (std::ptrdiff_t at : {std::ptrdiff_t(0), std::ptrdiff_t(1), std::ptrdiff_t(in_bytes - 1),
                                  1 - std::ptrdiff_t(out_bytes), -std::ptrdiff_t(out_bytes / 2)}) {
            call.put_output_at(call.in() + at);
            call.expect(MW_ERROR_OVERLAP, "the output is " + std::to_string(at) + " bytes behind the input");
        }
        call.call.motor_count = 1;
        call.put_output_at(call.in());
        call.expect(MW_ERROR_OVERLAP, "one row in place");
    });
    // The input between two rows.
    for (const ApplyFunctions<T> &functions : apply_functions<T>()) {
        SoundCall<T> call(functions, Pairing::grid);
        const std::size_t row = call.count * call.element_size();
        std::vector<unsigned char> memory(2 * row * call.motor_count, 0x77);
        call.put_output_at(memory.data());
        call.call.row_stride = 2 * row;
        call.expect(MW_OK, "rows with gaps");
        call.call.in = packed_view(reinterpret_cast<T *>(&memory[row]), functions.components());
        const auto before = memory;
        call.expect(MW_ERROR_OVERLAP, "the input between two rows");
        EXPECT_TRUE(memory == before) << functions.name(Pairing::grid);
    }
}

TYPED_TEST(ApplyErrorTest, a_grid_of_no_motors)
{
    using T = TypeParam;
    for_every_grid<T>([](SoundCall<T> &call) {
        call.call.motor_count = 0;
        const std::vector<unsigned char> out(reinterpret_cast<unsigned char *>(call.call.out.component[0]),
                                             reinterpret_cast<unsigned char *>(call.call.out.component[0]) +
                                                 call.count * call.element_size());
        call.expect(MW_OK, "no motors");
        EXPECT_EQ(std::memcmp(out.data(), call.call.out.component[0], out.size()), 0) << "bytes changed";
        ApplyCall<T> nothing;
        nothing.count = 5;
        EXPECT_EQ(call.functions().run(Pairing::grid, nothing), MW_OK) << "no motors, and so nothing at all";
    });
}

}  // namespace
}  // namespace motorway::testing
