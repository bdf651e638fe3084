// What is wrong with a call that samples a compiled motion, or that applies one: the status, and that nothing is
// written then. Every function is spoilt in every way that it has.

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apply_api.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();

// The arguments of all functions that sample motions, of which each takes its own.
template <class T>
struct SampleCall {
    View<T> out, twists;
    const typename api<T>::compiled_motion *motion = nullptr;
    std::size_t index = 0;
    const T *parameters = nullptr;
    std::size_t parameter_stride = sizeof(T), count = 0;
    unsigned flags = MW_DEFAULT;
};

template <class T>
struct SampleFunction {
    const char *name;
    bool has_twists, is_each;
    mw_status (*run)(const SampleCall<T> &);
};

template <class T>
std::vector<SampleFunction<T>> sample_functions()
{
    using A = api<T>;
    using Call = SampleCall<T>;
    return {{"sample_motion_one", false, false,
             [](const Call &c) {
                 return A::sample_motion_one(c.out.motors(), c.motion, c.index, c.parameters, c.count, c.flags);
             }},
            {"sample_motion_each", false, true,
             [](const Call &c) {
                 return A::sample_motion_each(c.out.motors(), c.motion, c.index, c.parameters, c.parameter_stride,
                                              c.count, c.flags);
             }},
            {"sample_motion_twist_one", true, false,
             [](const Call &c) {
                 return A::sample_motion_twist_one(c.out.motors(), c.twists.bivectors(), c.motion, c.index,
                                                   c.parameters, c.count, c.flags);
             }},
            {"sample_motion_twist_each", true, true, [](const Call &c) {
                 return A::sample_motion_twist_each(c.out.motors(), c.twists.bivectors(), c.motion, c.index,
                                                    c.parameters, c.parameter_stride, c.count, c.flags);
             }}};
}

// A sound call in one block of memory: the compiled motion, parameters, poses and twists, with gaps between.
template <class T>
class Samples {
public:
    static constexpr std::size_t count = 20, stride = 16 * sizeof(T), motions = 30;

    explicit Samples(const SampleFunction<T> &function) : function_(function)
    {
        MotionData<T> data;
        data.degree = 2;
        data.motion_count = motions;
        data.controls.assign(4 * motions, {1, 0, 0, 0, 1, 2, 3, 0});
        const CompiledMotion<T> compiled(data);
        motion_bytes = (compiled.size() + 63) / 64 * 64;
        memory_.assign((motion_bytes + 64 + count * sizeof(T) + 2 * count * stride + 512) / 8, 0xcdcdcdcdcdcdcdcd);
        std::memcpy(memory_.data(), compiled.get(), compiled.size());
        call.motion = reinterpret_cast<const typename api<T>::compiled_motion *>(memory_.data());
        call.parameters = numbers(motion_bytes + 64);
        for (std::size_t i = 0; i < count; ++i)
            numbers(motion_bytes + 64)[i] = static_cast<T>(i) / T(10);
        call.out = view(motion_bytes + 128 + count * sizeof(T), 8);
        call.twists = view(motion_bytes + 256 + count * sizeof(T) + count * stride, 6);
        call.count = count;
    }

    T *numbers(std::size_t offset)
    {
        return reinterpret_cast<T *>(reinterpret_cast<unsigned char *>(memory_.data()) + offset);
    }

    View<T> view(std::size_t offset, std::size_t components)
    {
        View<T> view;
        for (std::size_t c = 0; c < components; ++c)
            view.component.push_back(numbers(offset) + c);
        view.stride = stride;
        return view;
    }

    void set_parameter(std::size_t i, T value) { numbers(motion_bytes + 64)[i] = value; }

    void expect(mw_status status, const std::string &what)
    {
        const std::vector<std::uint64_t> before = memory_;
        const mw_status got = function_.run(call);
        EXPECT_EQ(got, status) << function_.name << " " << api<T>::name << ", " << what << ": "
                               << mw_status_text(got);
        EXPECT_TRUE(memory_ == before) << function_.name << ", " << what << ": bytes changed";
    }

    SampleCall<T> call;
    std::size_t motion_bytes = 0;

private:
    SampleFunction<T> function_;
    std::vector<std::uint64_t> memory_;
};

template <class T>
class MotionCallErrorTest : public ::testing::Test {
protected:
    // Each time with a call of its own, which is sound.
    static void for_every_function(const std::function<void(const SampleFunction<T> &, Samples<T> &)> &body)
    {
        for (const SampleFunction<T> &function : sample_functions<T>()) {
            Samples<T> sound(function), samples(function);
            EXPECT_EQ(function.run(sound.call), MW_OK) << function.name;
            body(function, samples);
        }
    }
};

TYPED_TEST_SUITE(MotionCallErrorTest, Precisions, PrecisionName);

TYPED_TEST(MotionCallErrorTest, null_pointers)
{
    using T = TypeParam;
    this->for_every_function([](const SampleFunction<T> &function, Samples<T> &samples) {
        const SampleCall<T> sound = samples.call;
        samples.call.motion = nullptr;
        samples.expect(MW_ERROR_NULL, "motion");
        samples.call = sound;
        samples.call.parameters = nullptr;
        samples.expect(MW_ERROR_NULL, "parameters");
        for (std::size_t c = 0; c < 14; ++c) {
            samples.call = sound;
            (c < 8 ? samples.call.out.component[c] : samples.call.twists.component[c - 8]) = nullptr;
            if (c < 8 || function.has_twists)
                samples.expect(MW_ERROR_NULL, "component " + std::to_string(c));
        }
        // Nothing is needed for nothing.
        samples.call = SampleCall<T>{};
        samples.call.out.component.assign(8, nullptr);
        samples.call.twists.component.assign(6, nullptr);
        samples.expect(MW_OK, "a count of 0");
    });
}

TYPED_TEST(MotionCallErrorTest, strides_and_sizes)
{
    using T = TypeParam;
    this->for_every_function([](const SampleFunction<T> &function, Samples<T> &samples) {
        const SampleCall<T> sound = samples.call;
        for (std::size_t stride : {std::size_t(0), sizeof(T), 8 * sizeof(T) - 1}) {
            samples.call.out.stride = stride;
            samples.expect(MW_ERROR_STRIDE, "out");
        }
        samples.call = sound;
        samples.call.out.stride = most / 4;
        samples.expect(MW_ERROR_SIZE, "out");
        samples.call = sound;
        if (function.has_twists) {
            samples.call.twists.stride = 6 * sizeof(T) - 1;
            samples.expect(MW_ERROR_STRIDE, "twists");
            samples.call.twists.stride = most / 4;
            samples.expect(MW_ERROR_SIZE, "twists");
            samples.call = sound;
        }
        if (function.is_each) {
            for (std::size_t stride : {std::size_t(1), sizeof(T) - 1}) {
                samples.call.parameter_stride = stride;
                samples.expect(MW_ERROR_STRIDE, "parameters");
            }
            samples.call.parameter_stride = most / 4;
            samples.expect(MW_ERROR_SIZE, "parameters");
        } else {
            for (std::size_t count : {most, most / 8, most / Samples<T>::stride}) {
                samples.call.count = count;
                samples.expect(MW_ERROR_SIZE, "count");
            }
        }
    });
}

TYPED_TEST(MotionCallErrorTest, overlaps)
{
    using T = TypeParam;
    this->for_every_function([](const SampleFunction<T> &function, Samples<T> &samples) {
        const SampleCall<T> sound = samples.call;
        const std::size_t out_bytes = (samples.count - 1) * samples.stride + 8 * sizeof(T);
        const std::size_t parameters_at = samples.motion_bytes + 64;
        const auto overlap = [&](View<T> SampleCall<T>::*view, std::size_t components, const char *what) {
            // The first number of the view is the last of the motion or of the parameters.
            for (std::size_t at : {std::size_t(0), samples.motion_bytes / 2,
                                   parameters_at + (samples.count - 1) * sizeof(T)}) {
                samples.call.*view = samples.view(at, components);
                samples.expect(MW_ERROR_OVERLAP, what);
            }
            // The last of the view is the first parameter.
            samples.call.*view = samples.view(parameters_at - (out_bytes - 8 * sizeof(T)) -
                                              (components - 1) * sizeof(T), components);
            samples.expect(MW_ERROR_OVERLAP, what);
            samples.call = sound;
        };
        overlap(&SampleCall<T>::out, 8, "out");
        if (!function.has_twists)
            return;
        overlap(&SampleCall<T>::twists, 6, "twists");
        for (std::size_t c : {std::size_t(0), std::size_t(7)}) {  // one number of a pose and of a twist in common
            samples.call.twists.component[5] = samples.call.out.component[c];
            samples.expect(MW_ERROR_OVERLAP, "twists and out");
        }
        samples.call.twists = samples.call.out;
        samples.call.twists.component.resize(6);
        samples.expect(MW_ERROR_OVERLAP, "twists are out");
    });
}

TYPED_TEST(MotionCallErrorTest, flags)
{
    using T = TypeParam;
    this->for_every_function([](const SampleFunction<T> &function, Samples<T> &samples) {
        for (unsigned bit = 0; bit < 32; ++bit) {
            const unsigned flag = 1u << bit;
            if (flag == MW_CLAMP_PARAMETERS || flag == MW_WRAP_PARAMETERS)
                continue;
            if (flag == MW_BODY_FRAME && function.has_twists)
                continue;
            samples.call.flags = flag;
            samples.expect(MW_ERROR_FLAGS, "bit " + std::to_string(bit));
        }
        samples.call.flags = MW_CLAMP_PARAMETERS | MW_WRAP_PARAMETERS;
        samples.expect(MW_ERROR_FLAGS, "both at once");
    });
}

TYPED_TEST(MotionCallErrorTest, what_is_no_compiled_motion)
{
    using T = TypeParam;
    using Other = std::conditional_t<sizeof(T) == sizeof(float), double, float>;
    MotionData<Other> data;
    data.controls.assign(2, {1, 0, 0, 0, 0, 0, 0, 0});
    const CompiledMotion<Other> other(data);
    const std::vector<std::uint64_t> zero(100), garbage(100, 0x123456789abcdef0);
    this->for_every_function([&](const SampleFunction<T> &, Samples<T> &samples) {
        for (const void *wrong : {static_cast<const void *>(other.get()), static_cast<const void *>(zero.data()),
                                  static_cast<const void *>(garbage.data())}) {
            samples.call.motion = static_cast<const typename api<T>::compiled_motion *>(wrong);
            samples.expect(MW_ERROR_MOTION, "not a motion");
            T domain[2] = {7, 7};
            EXPECT_EQ(api<T>::motion_domain(domain, samples.call.motion), MW_ERROR_MOTION);
            EXPECT_EQ(domain[0], T(7));
        }
    });
    T domain[2] = {7, 7};
    EXPECT_EQ(api<T>::motion_domain(domain, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(api<T>::motion_domain(nullptr, Samples<T>(sample_functions<T>()[0]).call.motion), MW_ERROR_NULL);
}

TYPED_TEST(MotionCallErrorTest, motions_beyond_the_last)
{
    using T = TypeParam;
    this->for_every_function([](const SampleFunction<T> &function, Samples<T> &samples) {
        for (std::size_t index : {Samples<T>::motions, most}) {
            samples.call.index = index;
            samples.expect(MW_ERROR_MOTION_INDEX, std::to_string(index));
        }
        samples.call.index = Samples<T>::motions - Samples<T>::count + 1;
        if (function.is_each)
            samples.expect(MW_ERROR_MOTION_INDEX, "one too many");
        samples.call.index -= 1;
        EXPECT_EQ(function.run(samples.call), MW_OK) << function.name;
    });
}

// The first, one in the middle and the last, so that nothing may be written before all are known to be good.
TYPED_TEST(MotionCallErrorTest, parameters_outside_of_the_domain)
{
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    this->for_every_function([](const SampleFunction<T> &function, Samples<T> &samples) {
        for (std::size_t i : {std::size_t(0), std::size_t(9), Samples<T>::count - 1}) {
            const T sound = samples.call.parameters[i];
            for (T bad : {std::nextafter(T(2), T(3)), -Limits::denorm_min(), T(-1), Limits::max()}) {
                samples.set_parameter(i, bad);
                samples.call.flags = MW_DEFAULT;
                samples.expect(MW_ERROR_PARAMETER, std::to_string(bad));
                for (unsigned flag : {MW_CLAMP_PARAMETERS, MW_WRAP_PARAMETERS}) {
                    samples.call.flags = flag;
                    Samples<T> other(function);
                    other.set_parameter(i, bad);
                    other.call.flags = flag;
                    EXPECT_EQ(function.run(other.call), MW_OK) << function.name << ", " << bad;
                }
            }
            for (T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()})
                for (unsigned flags : {0u, unsigned(MW_CLAMP_PARAMETERS), unsigned(MW_WRAP_PARAMETERS)}) {
                    samples.set_parameter(i, bad);
                    samples.call.flags = flags;
                    samples.expect(MW_ERROR_PARAMETER, std::to_string(bad));
                }
            samples.set_parameter(i, sound);
        }
    });
}

TYPED_TEST(MotionCallErrorTest, velocities_of_nothing)
{
    using T = TypeParam;
    const T twist[6] = {1, 2, 3, 4, 5, 6}, place[3] = {1, 2, 3};
    T velocity[3] = {7, 7, 7};
    EXPECT_EQ(api<T>::twist_velocity(nullptr, twist, place), MW_ERROR_NULL);
    EXPECT_EQ(api<T>::twist_velocity(velocity, nullptr, place), MW_ERROR_NULL);
    EXPECT_EQ(api<T>::twist_velocity(velocity, twist, nullptr), MW_ERROR_NULL);
    for (T v : velocity)
        EXPECT_EQ(v, T(7));
}

}  // namespace
}  // namespace motorway::testing
