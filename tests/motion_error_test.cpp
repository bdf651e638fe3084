// What is wrong with the description of a motion or with the memory for it: the status, the place that it names, and
// that nothing is written then. motion_call_error_test.cpp has what is wrong with calls that sample one.

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "motion_tester.h"

namespace motorway::testing {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();

template <class T>
std::vector<T> not_finite()
{
    using Limits = std::numeric_limits<T>;
    return {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()};
}

// ------------------------------------------------------------------------------------------------------ descriptions

template <class T>
class MotionErrorTest : public ::testing::Test {
protected:
    using Motion = typename api<T>::motion;
    using Compiled = typename api<T>::compiled_motion;

    // A motion of degree 2 along a line, with the knots of the paper's figure 5.
    static MotionData<T> sound(mw_motion_kind kind = MW_MOTION_ADDITIVE)
    {
        MotionData<T> data;
        data.kind = kind;
        data.degree = 2;
        for (int k = 0; k < 6; ++k)
            data.controls.push_back({1, 0, 0, 0, static_cast<T>(k), 0, 0, 0});
        if (is_of_keys(kind))
            data.knots = {0, 1, 2, 3, 4, 5};
        else
            data.knots = {0, 0, 1, 2, 3, 4, 4};
        return data;
    }

    static void expect_compile_error(const Motion &motion, mw_status status, std::size_t where,
                                     unsigned flags = MW_DEFAULT, std::size_t size = 8 * 4096)
    {
        std::vector<std::uint64_t> memory(4096, 0xcdcdcdcdcdcdcdcd);
        const auto before = memory;
        const Compiled *const untouched = reinterpret_cast<const Compiled *>(memory.data());
        const Compiled *compiled = untouched;
        std::size_t got = 1234;
        EXPECT_EQ(api<T>::compile_motion(&compiled, memory.data(), size, &motion, flags, &got), status);
        EXPECT_EQ(got, where) << mw_status_text(status);
        EXPECT_EQ(api<T>::compile_motion(&compiled, memory.data(), size, &motion, flags, nullptr), status);
        EXPECT_EQ(compiled, untouched);
        EXPECT_TRUE(memory == before) << mw_status_text(status) << ": bytes changed";
    }

    // Found without a look at the controls.
    static void expect_error(const Motion &motion, mw_status status, std::size_t where)
    {
        std::size_t size = 77, got = 1234;
        EXPECT_EQ(api<T>::motion_size(&size, &motion, &got), status);
        EXPECT_EQ(got, where) << mw_status_text(status);
        EXPECT_EQ(api<T>::motion_size(&size, &motion, nullptr), status);
        EXPECT_EQ(size, 77u);
        expect_compile_error(motion, status, where);
    }

    static void expect_error(const MotionData<T> &data, mw_status status, std::size_t where)
    {
        SCOPED_TRACE(data.name());
        expect_error(data.view(), status, where);
    }

    static void expect_ok(const MotionData<T> &data, unsigned flags = MW_DEFAULT) { CompiledMotion<T>(data, flags); }
};

TYPED_TEST_SUITE(MotionErrorTest, Precisions, PrecisionName);

TYPED_TEST(MotionErrorTest, null_pointers)
{
    using T = TypeParam;
    using A = api<T>;
    const auto data = this->sound();
    auto motion = data.view();
    std::size_t size = 77;
    std::vector<std::uint64_t> memory(4096);
    const typename A::compiled_motion *compiled = nullptr;
    EXPECT_EQ(A::motion_size(nullptr, &motion, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(A::motion_size(&size, nullptr, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(A::compile_motion(nullptr, memory.data(), 8 * 4096, &motion, MW_DEFAULT, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(A::compile_motion(&compiled, nullptr, 8 * 4096, &motion, MW_DEFAULT, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(A::compile_motion(&compiled, memory.data(), 8 * 4096, nullptr, MW_DEFAULT, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(compiled, nullptr);
    motion.controls = nullptr;
    this->expect_error(motion, MW_ERROR_NULL, 0);
    motion = data.view();
    motion.knots = nullptr;  // with a count of 7
    this->expect_error(motion, MW_ERROR_NULL, 0);
}

TYPED_TEST(MotionErrorTest, kinds_flags_and_degrees)
{
    for (int kind : {0, 6, 7}) {
        auto motion = this->sound().view();
        motion.kind = static_cast<mw_motion_kind>(kind);
        const auto data = this->sound();
        motion.controls = data.controls.data();
        motion.knots = data.knots.data();
        this->expect_error(motion, MW_ERROR_MOTION_KIND, 0);
    }
    for (std::size_t degree : {std::size_t(0), std::size_t(MW_MAX_DEGREE) + 1, std::size_t(0xffffffff)}) {
        auto data = this->sound();
        data.degree = degree;
        this->expect_error(data, MW_ERROR_DEGREE, 0);
        auto keys = this->sound(MW_MOTION_GENERATOR_KEYS);
        keys.degree = degree;
        this->expect_ok(keys);  // it is not read
    }
    for (mw_motion_kind kind : all_motion_kinds) {
        const auto data = this->sound(kind);
        for (unsigned flags : {MW_UNIT_MOTORS, MW_LONG_WAY, MW_CLAMP_PARAMETERS, MW_WRAP_PARAMETERS, MW_BODY_FRAME})
            this->expect_compile_error(data.view(), MW_ERROR_FLAGS, 0, flags | MW_DEFAULT);
        this->expect_compile_error(data.view(), MW_ERROR_FLAGS, 0, 1u << 31);
        if (kind == MW_MOTION_MULTIPLICATIVE)
            this->expect_compile_error(data.view(), MW_ERROR_FLAGS, 0, MW_KEEP_SIGNS);
        else
            this->expect_ok(data, MW_KEEP_SIGNS);
    }
}

TYPED_TEST(MotionErrorTest, too_few_controls)
{
    for (mw_motion_kind kind : all_motion_kinds)
        for (bool closed : {false, true})
            for (std::size_t controls : {0, 1, 2}) {
                auto data = this->sound(kind);
                data.closed = closed;
                data.knots.clear();
                data.controls.resize(controls + 1);
                auto motion = data.view();
                motion.control_count = controls;
                if (is_of_keys(kind) && controls == 2) {
                    data.controls.resize(2);
                    this->expect_ok(data);
                } else {
                    this->expect_error(motion, MW_ERROR_CONTROL_COUNT, 0);
                }
            }
}

TYPED_TEST(MotionErrorTest, knots_of_the_wrong_count)
{
    using T = TypeParam;
    for (mw_motion_kind kind : all_motion_kinds)
        for (bool closed : {false, true}) {
            auto data = this->sound(kind);
            data.closed = closed;
            const std::size_t right = closed ? 7 : is_of_keys(kind) ? 6 : 7;
            std::vector<T> knots;
            for (std::size_t k = 0; k < 12; ++k)
                knots.push_back(static_cast<T>(k));
            for (std::size_t count : {std::size_t(0), right - 1, right, right + 1, right + 4, most}) {
                auto motion = data.view();
                motion.knots = knots.data();
                motion.knot_count = count;
                std::size_t size = 0;
                if (count == right) {
                    EXPECT_EQ(api<T>::motion_size(&size, &motion, nullptr), MW_OK) << data.name();
                } else {
                    this->expect_error(motion, MW_ERROR_KNOT_COUNT, 0);
                }
            }
        }
}

TYPED_TEST(MotionErrorTest, knots_that_decrease_are_not_finite_or_repeat_too_often)
{
    using T = TypeParam;
    for (mw_motion_kind kind : all_motion_kinds)
        for (std::size_t k = 0; k < this->sound(kind).knots.size(); ++k) {
            for (T bad : not_finite<T>()) {
                auto data = this->sound(kind);
                data.knots[k] = bad;
                // Infinity between finite knots is the one to blame, whatever comes behind it.
                this->expect_error(data, MW_ERROR_KNOTS, k);
            }
            auto decreasing = this->sound(kind);
            if (k > 0) {
                decreasing.knots[k] = decreasing.knots[k - 1] - 1;
                this->expect_error(decreasing, MW_ERROR_KNOTS, k);
            }
            if (k > 0 && is_of_keys(kind)) {
                decreasing.knots[k] = decreasing.knots[k - 1];  // times must increase
                this->expect_error(decreasing, MW_ERROR_KNOTS, k);
            }
        }
    auto repeated = this->sound();
    for (std::size_t k : {2, 3, 4, 5})
        repeated.knots[k] = 1;
    this->expect_error(repeated, MW_ERROR_KNOTS, 5);
    auto thrice = this->sound();
    for (std::size_t k : {2, 3, 4})
        thrice.knots[k] = 1;
    this->expect_ok(thrice);
}

// Those of a closed motion also where the period ends and the next begins.
TYPED_TEST(MotionErrorTest, knots_of_closed_motions)
{
    using T = TypeParam;
    for (std::size_t k = 0; k < 7; ++k)
        for (T bad : not_finite<T>()) {
            auto data = this->sound();
            data.closed = true;
            data.knots = {0, 1, 2, 3, 4, 5, 6};
            data.knots[k] = bad;
            std::size_t size = 0;
            const auto motion = data.view();
            EXPECT_EQ(api<T>::motion_size(&size, &motion, nullptr), MW_ERROR_KNOTS) << k;
        }
    auto data = this->sound();
    data.closed = true;
    data.knots = {0, 0, 1, 2, 3, 4, 4};  // 4 is 0 again: three times in all
    this->expect_ok(data);
    data.knots = {0, 0, 1, 2, 4, 4, 4};
    std::size_t size = 0;
    const auto motion = data.view();
    EXPECT_EQ(api<T>::motion_size(&size, &motion, nullptr), MW_ERROR_KNOTS);
}

TYPED_TEST(MotionErrorTest, a_domain_of_length_zero)
{
    auto data = this->sound();
    data.controls.resize(3);
    data.knots = {0, 1, 1, 2};
    this->expect_error(data, MW_ERROR_KNOTS, 2);
    data.closed = true;
    data.knots = {3, 3, 3, 3};
    auto motion = data.view();
    std::size_t size = 0;
    EXPECT_EQ(api<TypeParam>::motion_size(&size, &motion, nullptr), MW_ERROR_KNOTS);
}

TYPED_TEST(MotionErrorTest, weights)
{
    using T = TypeParam;
    std::vector<T> all_bad = not_finite<T>();
    all_bad.insert(all_bad.end(), {T(0), -T(0), T(-1)});
    for (std::size_t k = 0; k < 6; ++k)
        for (T bad : all_bad) {
            auto data = this->sound();
            data.weights.assign(6, T(1));
            data.weights[k] = bad;
            this->expect_error(data, MW_ERROR_WEIGHTS, k);
        }
    for (mw_motion_kind kind : all_motion_kinds) {
        auto data = this->sound(kind);
        data.weights.assign(6, T(1));
        if (is_additive(kind))
            this->expect_ok(data);
        else
            this->expect_error(data, MW_ERROR_WEIGHTS, 0);
    }
}

TYPED_TEST(MotionErrorTest, degenerate_controls_and_bases)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    const T small = std::sqrt(Limits::min()) / 2, large = std::sqrt(Limits::max()) * 2;
    for (mw_motion_kind kind : all_motion_kinds)
        for (T bad : {T(0), small, large, Limits::quiet_NaN()}) {
            for (std::size_t k = 0; k < 12; ++k) {
                auto data = this->sound(kind);
                data.motion_count = 2;
                data.controls.insert(data.controls.end(), data.controls.begin(), data.controls.end());
                data.controls.resize(12, data.controls[0]);
                data.controls[k].s = bad;
                this->expect_compile_error(data.view(), MW_ERROR_DEGENERATE_MOTOR, k);
            }
            if (kind != MW_MOTION_GENERATOR && !is_of_keys(kind))
                continue;
            auto data = this->sound(kind);
            data.base = {{bad, 0, 0, 0, 1, 0, 0, 0}};
            this->expect_compile_error(data.view(), MW_ERROR_DEGENERATE_MOTOR, 0);
        }
}

TYPED_TEST(MotionErrorTest, sizes_beyond_the_address_space)
{
    using T = TypeParam;
    for (std::size_t count : {most, most / 2, most / 8, most / 64}) {
        const auto data = this->sound();
        auto motion = data.view();
        motion.motion_count = count;
        std::size_t size = 77, where = 1234;
        EXPECT_EQ(api<T>::motion_size(&size, &motion, &where), MW_ERROR_SIZE) << count;
        EXPECT_EQ(where, 0u);
        EXPECT_EQ(size, 77u);
        motion = data.view();
        motion.control_count = count;
        const mw_status status = api<T>::motion_size(&size, &motion, nullptr);
        EXPECT_TRUE(status == MW_ERROR_SIZE || status == MW_ERROR_KNOT_COUNT) << count;
    }
}

TYPED_TEST(MotionErrorTest, memory_that_is_too_small_or_not_aligned)
{
    using T = TypeParam;
    const auto data = this->sound();
    const auto motion = data.view();
    std::size_t size = 0;
    ASSERT_EQ(api<T>::motion_size(&size, &motion, nullptr), MW_OK);
    for (std::size_t small : {std::size_t(0), std::size_t(1), size / 2, size - 1})
        this->expect_compile_error(motion, MW_ERROR_MEMORY, 0, MW_DEFAULT, small);
    std::vector<std::uint64_t> memory(size / 8 + 3, 7);
    const auto before = memory;
    const typename api<T>::compiled_motion *compiled = nullptr;
    for (std::size_t offset : {1, 2, 4, 7})
        EXPECT_EQ(api<T>::compile_motion(&compiled, reinterpret_cast<char *>(memory.data()) + offset, size + 8,
                                         &motion, MW_DEFAULT, nullptr),
                  MW_ERROR_MEMORY);
    EXPECT_TRUE(memory == before);
    EXPECT_EQ(api<T>::compile_motion(&compiled, &memory[1], size, &motion, MW_DEFAULT, nullptr), MW_OK);
}

// The first byte of the memory is the last of an array, and the other way round.
TYPED_TEST(MotionErrorTest, memory_that_overlaps_the_description)
{
    using T = TypeParam;
    auto data = this->sound(MW_MOTION_GENERATOR);
    data.base = {{1, 0, 0, 0, 0, 0, 0, 0}};
    for (int which = 0; which < 4; ++which) {
        auto motion = data.view();
        const std::vector<T> weights(6, T(1));
        if (which == 3) {
            motion.kind = MW_MOTION_ADDITIVE;
            motion.weights = weights.data();
        }
        std::size_t size = 0;
        ASSERT_EQ(api<T>::motion_size(&size, &motion, nullptr), MW_OK);
        const void *const arrays[] = {motion.controls, motion.knots, motion.base, motion.weights};
        const std::size_t bytes[] = {6 * sizeof(T[8]), 7 * sizeof(T), sizeof(T[8]), 6 * sizeof(T)};
        for (bool before : {false, true}) {
            std::vector<std::uint64_t> memory(size / 8 + 200, 0);
            unsigned char *const block = reinterpret_cast<unsigned char *>(&memory[60]);
            unsigned char *const array = before ? block + sizeof(T) - bytes[which] : block + size - sizeof(T);
            std::memcpy(array, arrays[which], bytes[which]);
            auto *const numbers = reinterpret_cast<T *>(array);
            auto *const motors = reinterpret_cast<typename api<T>::motor *>(array);
            which == 0 ? motion.controls = motors : which == 2 ? motion.base = motors : nullptr;
            which == 1 ? motion.knots = numbers : which == 3 ? motion.weights = numbers : nullptr;
            const auto untouched = memory;
            const typename api<T>::compiled_motion *compiled = nullptr;
            EXPECT_EQ(api<T>::compile_motion(&compiled, block, size, &motion, MW_DEFAULT, nullptr), MW_ERROR_OVERLAP)
                << "array " << which << (before ? " before" : " behind");
            EXPECT_TRUE(memory == untouched);
        }
    }
}

}  // namespace
}  // namespace motorway::testing
