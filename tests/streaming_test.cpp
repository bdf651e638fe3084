// Stores past the caches: whether they are asked for, forbidden or chosen by the size of a call, the bits are the
// same and nothing else is touched.

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_list.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

struct StreamingCase {
    const KernelRow *row;
    std::string precision, isa;
};

std::string name_of(const StreamingCase &c)
{
    const bool said = c.row->variant == Variant::mixed;
    return c.row->name + (said ? "" : "_" + c.precision) + "_" + c.isa;
}

void PrintTo(const StreamingCase &c, std::ostream *out) { *out << name_of(c); }

std::vector<StreamingCase> all_cases()
{
    std::vector<StreamingCase> cases;
    for (const KernelRow &row : kernel_rows())
        if (row.name.rfind("apply_", 0) == 0)
            for (const std::string &precision : row.precisions())
                for (const std::string &isa : running_isas())
                    cases.push_back({&row, precision, isa});
    return cases;
}

class StreamingTest : public ::testing::TestWithParam<StreamingCase> {
protected:
    void SetUp() override { ASSERT_TRUE(isa_.runs()); }

private:
    ScopedIsa isa_{GetParam().isa};
};

// The pool's results are those without the flag; each case is one call with it.
template <class T>
class Streaming {
public:
    Streaming(Subject<T> &subject, const std::string &isa)
        : subject_(subject), isa_(isa), pool_(make_pool(subject, 1100, 77, Specials::some))
    {
        run_alone(subject_, pool_);
        subject_.add_flags(MW_STREAMING_STORES);
    }

    void counts()
    {
        for (std::size_t count = 0; count <= 70; ++count)
            for (const Layout &layout : layouts())
                for (Guard guard : {Guard::after, Guard::before})
                    tester(count).input_layout(layout).output_layout(layout).guard(guard).test();
        for (std::size_t count : {127, 128, 129, 500, 1000})
            for (const Layout &layout : layouts())
                tester(count).input_layout(Layout::aos(3)).output_layout(layout).test();
    }

    // A block that begins at any address a T can have in a cache line, and at some that it cannot.
    void alignments()
    {
        std::vector<std::size_t> offsets = {1, 3, 62};
        for (std::size_t offset = 0; offset < 64; offset += sizeof(T))
            offsets.push_back(offset);
        for (const Layout &layout : layouts())
            for (std::size_t offset : offsets)
                for (std::size_t count : {5, 16, 33, 61, 129})
                    tester(count).output_layout(layout).guard(Guard::before).input_offset(offset % 7)
                        .output_offset(offset).test();
    }

    // The flag is no error where it can have no effect.
    void in_place()
    {
        if (subject_.keeps_apart())
            return;
        const std::size_t last = pool_.operands.size() - 1;
        for (const Layout &layout : layouts())
            for (std::size_t count : {1, 16, 47, 64, 500})
                tester(count).input_layout(layout).in_place_of(last).test();
        for (std::size_t count : {1, 17, 64})
            tester(count).interleaved().test();
    }

private:
    static std::vector<Layout> layouts()
    {
        return {Layout::aos(), Layout::soa(), Layout::rows(), Layout::aos(sizeof(T)), Layout::soa(sizeof(T)),
                Layout::split()};
    }

    KernelTester<T> tester(std::size_t count) const
    {
        return KernelTester<T>(subject_, pool_, isa_).count(count).first(count % 97);
    }

    Subject<T> &subject_;
    std::string isa_;
    Pool<T> pool_;
};

template <class T>
void check_forced(const StreamingCase &c)
{
    const auto subjects = c.row->subjects<T>();
    Streaming<T> streaming(*subjects.front(), c.isa);
    streaming.counts();
    streaming.alignments();
    streaming.in_place();
}

TEST_P(StreamingTest, gives_the_same_bits_and_touches_nothing_else)
{
    GetParam().precision == "f64" ? check_forced<double>(GetParam()) : check_forced<float>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(every, StreamingTest, ::testing::ValuesIn(all_cases()),
                         [](const auto &each) { return name_of(each.param); });

// A call of more than MW_STREAMING_BYTES. Elements repeat after some hundred, so that few results are compared with
// many.
template <class T>
class LargeCall {
public:
    LargeCall(const ApplyFunctions<T> &functions, Pairing pairing)
        : functions_(functions), pairing_(pairing), components_(functions.components())
    {
        const std::size_t bytes = std::size_t(MW_STREAMING_BYTES) + (MW_STREAMING_BYTES >> 3);
        count_ = bytes / (2 * components_ * sizeof(T));
        motor_count_ = 1;
        if (pairing == Pairing::grid) {
            motor_count_ = 7;
            count_ = bytes / ((motor_count_ + 1) * components_ * sizeof(T));
        }
        draw();
    }

    void test(bool soa, bool in_place)
    {
        ApplyCall<T> call = arguments(soa);
        std::vector<T> out = in_place ? in_ : std::vector<T>(motor_count_ * count_ * components_ + 1, T(-77));
        call.out = in_place ? view(out.data(), count_, soa) : view(out.data(), motor_count_ * count_, soa);
        if (in_place)
            call.in = call.out;
        call.row_stride = count_ * call.out.stride;
        ASSERT_EQ(functions_.run(pairing_, call), MW_OK) << functions_.name(pairing_);
        for (std::size_t m = 0; m < motor_count_; ++m)
            compare(call, m, soa);
        EXPECT_TRUE(in_place || out.back() == T(-77)) << functions_.name(pairing_) << ": past the end";
    }

private:
    static constexpr std::size_t period = 499;

    void draw()
    {
        Random random(78);
        in_.resize(count_ * components_ + 1);
        for (std::size_t k = 0; k < period * components_; ++k)
            period_.push_back(static_cast<T>(random.uniform(-2, 2)));
        motors_.resize(std::max(period, motor_count_) * functions_.motor_size());
        for (std::size_t k = 0; k < motors_.size() / functions_.motor_scalar; ++k)
            set_motor(k, random.uniform(-1, 1));
        // Motors repeat like the elements.
        if (pairing_ == Pairing::each) {
            const std::vector<unsigned char> once = motors_;
            for (std::size_t bytes = once.size(); bytes < count_ * functions_.motor_size(); bytes += once.size())
                motors_.insert(motors_.end(), once.begin(), once.end());
        }
        for (std::size_t i = 0; i < count_; ++i)
            indices_.push_back(static_cast<std::uint16_t>(i % period));
        expect();
    }

    void set_motor(std::size_t k, double number)
    {
        const float single = static_cast<float>(number);
        unsigned char *const to = &motors_[k * functions_.motor_scalar];
        if (functions_.motor_scalar == sizeof number)
            std::memcpy(to, &number, sizeof number);
        else
            std::memcpy(to, &single, sizeof single);
    }

    // The results of one period a motor, without stores past the caches.
    void expect()
    {
        expected_.resize(motor_count_ * period * components_);
        ApplyCall<T> call;
        call.in = packed_view(period_.data(), components_);
        call.out = packed_view(expected_.data(), components_);
        call.row_stride = period * components_ * sizeof(T);
        call.flags = MW_NO_STREAMING_STORES;
        fill_motors(call, period);
        ASSERT_EQ(functions_.run(pairing_, call), MW_OK);
    }

    void fill_motors(ApplyCall<T> &call, std::size_t count)
    {
        call.motor = motors_.data();
        call.motors = packed_view(reinterpret_cast<T *>(motors_.data()), 8, functions_.motor_scalar);
        call.motor_count = pairing_ == Pairing::grid ? motor_count_ : period;
        call.indices = {indices_.data(), sizeof indices_[0], MW_INDEX_U16};
        call.count = count;
    }

    View<T> view(T *first, std::size_t count, bool soa) const
    {
        View<T> result = packed_view(first, components_);
        if (!soa)
            return result;
        result.stride = sizeof(T);
        for (std::size_t c = 0; c < components_; ++c)
            result.component[c] = first + c * count;
        return result;
    }

    ApplyCall<T> arguments(bool soa)
    {
        ApplyCall<T> call;
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t c = 0; c < components_; ++c)
                in_[soa ? c * count_ + i : i * components_ + c] = period_[i % period * components_ + c];
        call.in = view(in_.data(), count_, soa);
        fill_motors(call, count_);
        return call;
    }

    void compare(const ApplyCall<T> &call, std::size_t m, bool soa) const
    {
        const std::size_t step = soa ? 1 : components_;
        for (std::size_t c = 0; c < components_; ++c) {
            const T *const results = call.out.component[c] + m * count_ * step;
            for (std::size_t i = 0; i < count_; ++i)
                ASSERT_TRUE(same(results[i * step], expected_[(m * period + i % period) * components_ + c]))
                    << functions_.name(pairing_) << (soa ? " soa" : " packed") << ", motor " << m << ", element " << i
                    << ", component " << c;
        }
    }

    ApplyFunctions<T> functions_;
    Pairing pairing_;
    std::size_t components_, count_, motor_count_;
    std::vector<T> in_, period_, expected_;
    std::vector<unsigned char> motors_;
    std::vector<std::uint16_t> indices_;
};

template <class T>
class LargeTest : public ::testing::Test {
};

TYPED_TEST_SUITE(LargeTest, Precisions, PrecisionName);

template <class T>
void test_large(Pairing pairing)
{
    for (const ApplyFunctions<T> &functions : apply_functions<T>()) {
        LargeCall<T> call(functions, pairing);
        for (bool soa : {false, true}) {
            call.test(soa, false);
            if (pairing != Pairing::grid)
                call.test(soa, true);
        }
    }
}

TYPED_TEST(LargeTest, calls_under_one_motor) { test_large<TypeParam>(Pairing::one); }
TYPED_TEST(LargeTest, calls_with_a_motor_each) { test_large<TypeParam>(Pairing::each); }
TYPED_TEST(LargeTest, calls_with_a_palette) { test_large<TypeParam>(Pairing::indexed); }
TYPED_TEST(LargeTest, grids) { test_large<TypeParam>(Pairing::grid); }

// On every instruction set the choice is made for itself.
TYPED_TEST(LargeTest, points_on_every_instruction_set)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        LargeCall<T> call(apply_functions_of<T>(Moved::point), Pairing::one);
        call.test(false, false);
        call.test(true, false);
    }
}

}  // namespace
}  // namespace motorway::testing
