// Ranges, as job systems take them: however a batch is cut, by the _from of its views, the parts have the bits of the
// whole.

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apply_api.h"
#include "isas.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

// A batch of one function: its arrays, in one of three layouts.
template <class T>
class Batch {
public:
    static constexpr std::size_t count = 613, motor_count = 11;

    enum class Shape { packed, strided, soa };

    Batch(const ApplyFunctions<T> &functions, Pairing pairing, Shape shape)
        : functions_(functions), pairing_(pairing), shape_(shape)
    {
        Random random(61);
        const std::size_t motors = std::max(count, motor_count);
        motors_.resize(motors * functions.motor_size() + 64);
        for (std::size_t k = 0; k < 8 * motors; ++k) {
            const double precise = random.uniform(-1, 1);
            const float single = static_cast<float>(precise);
            if (functions.motor_scalar == sizeof precise)
                std::memcpy(&motors_[k * sizeof precise], &precise, sizeof precise);
            else
                std::memcpy(&motors_[k * sizeof single], &single, sizeof single);
        }
        in_.resize(2 * count * functions.components());
        for (T &number : in_)
            number = static_cast<T>(random.uniform(-2, 2));
        for (std::size_t i = 0; i < 3 * count; ++i)
            indices_.push_back(static_cast<unsigned char>(random.below(motor_count)));
    }

    std::vector<T> whole()
    {
        std::vector<T> out = empty();
        EXPECT_EQ(functions_.run(pairing_, call(out, 0, count)), MW_OK) << functions_.name(pairing_);
        return out;
    }

    // Cut at these elements; the parts from last to first, as if by several threads.
    std::vector<T> parts(const std::vector<std::size_t> &cuts)
    {
        std::vector<T> out = empty();
        for (std::size_t k = cuts.size() - 1; k-- > 0;)
            EXPECT_EQ(functions_.run(pairing_, call(out, cuts[k], cuts[k + 1] - cuts[k])), MW_OK)
                << functions_.name(pairing_);
        return out;
    }

    // A grid cut by its motors.
    std::vector<T> rows(const std::vector<std::size_t> &cuts)
    {
        std::vector<T> out = empty();
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            ApplyCall<T> rows = call(out, 0, count);
            rows.motor_count = cuts[k + 1] - cuts[k];
            for (T *&component : rows.motors.component)
                component = moved(component, cuts[k] * rows.motors.stride);
            for (T *&component : rows.out.component)
                component = moved(component, cuts[k] * rows.row_stride);
            EXPECT_EQ(functions_.run(pairing_, rows), MW_OK) << functions_.name(pairing_);
        }
        return out;
    }

private:
    static T *moved(T *pointer, std::size_t bytes)
    {
        return reinterpret_cast<T *>(reinterpret_cast<char *>(pointer) + bytes);
    }

    std::size_t rows_count() const { return pairing_ == Pairing::grid ? motor_count : 1; }
    std::vector<T> empty() const { return std::vector<T>(2 * rows_count() * count * functions_.components(), T(-7)); }

    View<T> view(T *first, std::size_t elements) const
    {
        View<T> result = packed_view(first, functions_.components());
        if (shape_ == Shape::strided)
            result.stride += (functions_.components() - 1) * sizeof(T);
        if (shape_ != Shape::soa)
            return result;
        result.stride = sizeof(T);
        for (std::size_t c = 0; c < functions_.components(); ++c)
            result.component[c] = first + c * elements;
        return result;
    }

    ApplyCall<T> call(std::vector<T> &out, std::size_t begin, std::size_t elements)
    {
        ApplyCall<T> arguments;
        arguments.in = view(in_.data(), count);
        arguments.out = view(out.data(), rows_count() * count);
        arguments.row_stride = count * arguments.out.stride;
        arguments.motor = motors_.data();
        arguments.motors = packed_view(reinterpret_cast<T *>(motors_.data()), 8, functions_.motor_scalar);
        arguments.motor_count = motor_count;
        arguments.indices = {indices_.data(), shape_ == Shape::packed ? 1u : 3u, MW_INDEX_U8};
        arguments.begin = begin;
        arguments.count = elements;
        return arguments;
    }

    ApplyFunctions<T> functions_;
    Pairing pairing_;
    Shape shape_;
    std::vector<unsigned char> motors_, indices_;
    std::vector<T> in_;
};

std::vector<std::size_t> random_cuts(Random &random, std::size_t count)
{
    std::vector<std::size_t> cuts = {0};
    while (cuts.back() < count)
        cuts.push_back(std::min(count, cuts.back() + random.below(random.chance(3) ? 200 : 20)));
    return cuts;
}

template <class T>
bool same_bits(const std::vector<T> &a, const std::vector<T> &b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class T>
class SplitTest : public ::testing::Test {
protected:
    template <class Body>
    static void for_every_batch(Body body)
    {
        for (const std::string &isa : running_isas()) {
            SCOPED_TRACE(isa);
            ScopedIsa scope(isa);
            for (const ApplyFunctions<T> &functions : apply_functions<T>())
                for (Pairing pairing : all_pairings)
                    for (auto shape : {Batch<T>::Shape::packed, Batch<T>::Shape::strided, Batch<T>::Shape::soa}) {
                        SCOPED_TRACE(functions.name(pairing));
                        body(pairing, Batch<T>(functions, pairing, shape));
                    }
        }
    }
};

TYPED_TEST_SUITE(SplitTest, Precisions, PrecisionName);

TYPED_TEST(SplitTest, ranges_of_elements_give_the_bits_of_the_whole)
{
    Random random(62);
    this->for_every_batch([&](Pairing, auto batch) {
        const auto whole = batch.whole();
        for (int repetition = 0; repetition < 5; ++repetition)
            EXPECT_TRUE(same_bits(batch.parts(random_cuts(random, batch.count)), whole));
    });
}

TYPED_TEST(SplitTest, ranges_of_motors_give_the_bits_of_the_whole_grid)
{
    this->for_every_batch([](Pairing pairing, auto batch) {
        if (pairing != Pairing::grid)
            return;
        const auto whole = batch.whole();
        EXPECT_TRUE(same_bits(batch.rows({0, 1, 4, 4, 9, 11}), whole));
        EXPECT_TRUE(same_bits(batch.rows({0, 8, 11}), whole));
    });
}

}  // namespace
}  // namespace motorway::testing
