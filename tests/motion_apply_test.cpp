// Motions straight onto elements: for every operand what mw_apply_<operand>_grid makes of the samples, to the bit.

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apply_api.h"
#include "guarded_buffer.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

template <class T>
struct MotionCall {
    View<T> out, in;
    std::size_t row_stride = 0;
    const typename api<T>::compiled_motion *motion = nullptr;
    std::size_t index = 0;
    const T *parameters = nullptr;
    std::size_t parameter_count = 0, count = 0;
    unsigned flags = MW_DEFAULT;
};

template <class T>
struct MotionFunction {
    const char *operand;
    Moved moved;
    Operand views;
    mw_status (*run)(const MotionCall<T> &);

    std::size_t components() const { return components_of(views); }
};

template <class T>
std::vector<MotionFunction<T>> motion_functions();

#define MOTORWAY_TEST_MOTION(operand, views, P)                                                                      \
    {#operand, Moved::operand, Operand::views, [](const MotionCall<scalar_##P> &c) {                                 \
         return api<scalar_##P>::apply_##operand##_motion(api_view<mw_##views##_##P>(c.out), c.row_stride, c.motion, c.index,  \
                                                c.parameters, c.parameter_count,                                     \
                                                api_view<mw_const_##views##_##P>(c.in), c.count, c.flags);           \
     }},

template <>
std::vector<MotionFunction<float>> motion_functions()
{
    return {MW_OPERANDS(MOTORWAY_TEST_MOTION, f32)};
}

template <>
std::vector<MotionFunction<double>> motion_functions()
{
    return {MW_OPERANDS(MOTORWAY_TEST_MOTION, f64)};
}

#undef MOTORWAY_TEST_MOTION

template <class T>
View<T> packed(T *first, std::size_t components)
{
    View<T> view;
    for (std::size_t c = 0; c < components; ++c)
        view.component.push_back(first + c);
    view.stride = components * sizeof(T);
    return view;
}

template <class T>
class MotionApplyTest : public ::testing::Test {
protected:
    // Of multiplicative motions, whose samples are normalised, and of additive ones, whose samples are not.
    static MotionData<T> crowd(Random &random, mw_motion_kind kind)
    {
        auto data = random_motion<T>(random, kind, 2, 5);
        data.motion_count = 3;
        draw_controls(random, data, 5);
        return data;
    }

    static std::vector<T> elements(Random &random, const MotionFunction<T> &function, std::size_t count)
    {
        std::vector<T> numbers(count * function.components());
        for (T &number : numbers)
            number = static_cast<T>(random.uniform(-2, 2));
        return numbers;
    }
};

TYPED_TEST_SUITE(MotionApplyTest, Precisions, PrecisionName);

// Rows one after the other, with a gap between, and the images of each element side by side; more parameters than are
// made at a time; with the flags of apply and those of parameters.
TYPED_TEST(MotionApplyTest, is_apply_grid_of_the_samples_to_the_bit)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(141);
        for (const MotionFunction<T> &function : motion_functions<T>()) {
            const ApplyFunctions<T> apply = apply_functions_of<T>(function.moved);
            for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE}) {
                const CompiledMotion<T> motion(this->crowd(random, kind));
                for (std::size_t rows : {1, 5, 64, 130})
                    for (std::size_t count : {1, 3, 37}) {
                        const std::size_t n = function.components(), index = rows % 3;
                        std::vector<T> parameters;
                        for (std::size_t m = 0; m < rows; ++m)
                            parameters.push_back(static_cast<T>(random.uniform(-1, 4)));
                        std::vector<T> poses = sampled(motion, parameters, MW_CLAMP_PARAMETERS, index);
                        std::vector<T> in = this->elements(random, function, count);
                        const std::size_t gap = rows % 2 ? 7 : 0, numbers = rows * (count * n + gap);
                        for (bool point_major : {false, true})
                            for (unsigned flags : {MW_DEFAULT, MW_STREAMING_STORES, MW_UNIT_MOTORS}) {
                                if (flags == MW_UNIT_MOTORS && is_additive(kind))
                                    continue;
                                std::vector<T> expected(numbers, T(7)), out(numbers, T(7));
                                ApplyCall<T> grid;
                                grid.out = packed(expected.data(), n);
                                grid.row_stride = point_major ? n * sizeof(T) : (count * n + gap) * sizeof(T);
                                if (point_major)
                                    grid.out.stride = rows * n * sizeof(T);
                                grid.in = packed(in.data(), n);
                                grid.motors = packed(poses.data(), 8);
                                grid.motor_count = rows;
                                grid.count = count;
                                grid.flags = flags;
                                ASSERT_EQ(apply.grid(grid), MW_OK);
                                MotionCall<T> call;
                                call.out = packed(out.data(), n);
                                call.out.stride = grid.out.stride;
                                call.row_stride = grid.row_stride;
                                call.in = grid.in;
                                call.motion = motion.get();
                                call.index = index;
                                call.parameters = parameters.data();
                                call.parameter_count = rows;
                                call.count = count;
                                call.flags = flags | MW_CLAMP_PARAMETERS;
                                ASSERT_EQ(function.run(call), MW_OK) << function.operand;
                                ASSERT_TRUE(same_bits(out, expected))
                                    << isa << ": " << function.operand << ", " << rows << " x " << count << ", flags "
                                    << flags << (point_major ? ", side by side" : "");
                            }
                    }
            }
        }
    }
}

// The last byte of the results, of the elements and of the parameters is the last before a forbidden page, or the
// first is the first behind one.
TYPED_TEST(MotionApplyTest, touches_nothing_else)
{
    using T = TypeParam;
    GuardedBuffer out(65536), in(65536), at(4096);
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        Random random(142);
        const CompiledMotion<T> motion(this->crowd(random, MW_MOTION_ADDITIVE));
        for (const MotionFunction<T> &function : motion_functions<T>())
            for (Guard guard : {Guard::after, Guard::before})
                for (std::size_t rows : {1, 3, 17})
                    for (std::size_t count : {1, 7, 16, 33}) {
                        const std::size_t n = function.components();
                        const std::vector<T> parameters(rows, T(1.5));
                        const std::vector<T> numbers = this->elements(random, function, count);
                        MotionCall<T> call;
                        call.out = packed(reinterpret_cast<T *>(out.place(rows * count * n * sizeof(T), guard)), n);
                        call.in = packed(in.place_copy(numbers.data(), numbers.size(), guard), n);
                        call.row_stride = count * n * sizeof(T);
                        call.motion = motion.get();
                        call.parameters = at.place_copy(parameters.data(), rows, guard);
                        call.parameter_count = rows;
                        call.count = count;
                        ASSERT_EQ(function.run(call), MW_OK) << function.operand;
                    }
    }
}

// A sound call of every operand, spoilt.
TYPED_TEST(MotionApplyTest, errors)
{
    using T = TypeParam;
    constexpr std::size_t rows = 5, count = 4, most = std::numeric_limits<std::size_t>::max();
    Random random(143);
    const CompiledMotion<T> compiled(this->crowd(random, MW_MOTION_ADDITIVE));
    for (const MotionFunction<T> &function : motion_functions<T>()) {
        const std::size_t n = function.components(), row = count * n * sizeof(T);
        // The motion, parameters, elements, results.
        const std::size_t motion_numbers = (compiled.size() + 63) / 64 * 64 / sizeof(T);
        std::vector<T> memory(motion_numbers + rows + (rows + 2) * count * n, T(0.5));
        T *const parameters = memory.data() + motion_numbers, *const in = parameters + rows;
        T *const out = in + count * n;
        std::memcpy(static_cast<void *>(memory.data()), compiled.get(), compiled.size());
        MotionCall<T> sound;
        sound.out = packed(out, n);
        sound.in = packed(in, n);
        sound.row_stride = row;
        sound.motion = reinterpret_cast<const typename api<T>::compiled_motion *>(memory.data());
        sound.parameters = parameters;
        sound.parameter_count = rows;
        sound.count = count;
        MotionCall<T> call = sound;
        const auto expect = [&](mw_status status, const char *what) {
            const std::vector<T> before = memory;
            EXPECT_EQ(function.run(call), status) << function.operand << ", " << what;
            EXPECT_EQ(std::memcmp(before.data(), memory.data(), memory.size() * sizeof(T)), 0)
                << function.operand << ", " << what << ": bytes changed";
            call = sound;
        };
        call.motion = nullptr;
        expect(MW_ERROR_NULL, "motion");
        call.parameters = nullptr;
        expect(MW_ERROR_NULL, "parameters");
        call.in.component[1] = nullptr;
        expect(MW_ERROR_NULL, "in");
        call.out.component[0] = nullptr;
        expect(MW_ERROR_NULL, "out");
        call.in.stride = sizeof(T);
        expect(MW_ERROR_STRIDE, "in");
        call.out.stride = sizeof(T);
        expect(MW_ERROR_STRIDE, "out");
        call.row_stride = sizeof(T);
        expect(MW_ERROR_STRIDE, "rows that share bytes");
        call.parameter_count = most / 4;
        expect(MW_ERROR_SIZE, "parameters");
        call.count = most / 4;
        expect(MW_ERROR_SIZE, "elements");
        for (unsigned flags : {unsigned(MW_BODY_FRAME), unsigned(MW_LONG_WAY), unsigned(MW_KEEP_SIGNS), 1u << 31,
                               MW_CLAMP_PARAMETERS | MW_WRAP_PARAMETERS | 0u,
                               MW_STREAMING_STORES | MW_NO_STREAMING_STORES | 0u}) {
            call.flags = flags;
            expect(MW_ERROR_FLAGS, "flags");
        }
        call.index = 3;
        expect(MW_ERROR_MOTION_INDEX, "index");
        call.motion = reinterpret_cast<const typename api<T>::compiled_motion *>(memory.data() + 64 / sizeof(T) * 2);
        expect(MW_ERROR_MOTION, "motion");
        for (T bad : {T(-1), T(4), std::numeric_limits<T>::quiet_NaN()}) {
            parameters[rows - 1] = bad;
            expect(MW_ERROR_PARAMETER, "parameter");
        }
        parameters[rows - 1] = T(0.5);
        // The results begin in the elements, the parameters and the motion.
        for (T *first : {in + count * n - 1, parameters + rows - 1, memory.data()}) {
            call.out = packed(first, n);
            expect(MW_ERROR_OVERLAP, "out");
        }
        call.out = call.in;
        expect(MW_ERROR_OVERLAP, "in place");
        call = MotionCall<T>{};
        call.out.component.clear();
        expect(MW_OK, "nothing");
        EXPECT_EQ(function.run(sound), MW_OK) << function.operand;
    }
}

}  // namespace
}  // namespace motorway::testing
