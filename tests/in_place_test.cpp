// In place: an element of the output over the same element of any inputs, in every way that views can say, of every
// kernel on every instruction set. The bits are those of each element alone.

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_list.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

// Where the numbers of an element can be: in slots, which lie next to each other or are arrays of their own.
struct Slots {
    enum class Kind { side_by_side, arrays } kind;
    std::size_t number;  // of slots an element
    std::size_t gap;     // bytes behind the slots of an element, or behind a number of an array
};

// Which slots the components of an operand take: from `first` on in order, backwards, or at random.
enum class Order { forwards, backwards, shuffled };

constexpr const char *names_of_orders_of_slots[] = {"forwards", "backwards", "shuffled"};

// One call of a subject, in place of some of its inputs.
template <class T>
class InPlace {
public:
    InPlace(const Subject<T> &subject, const Pool<T> &pool, Random &random)
        : subject_(subject), pool_(pool), random_(random)
    {
    }

    // Of operands that can lie in slots: those of the precision of the output, which are no arrays of the subject's.
    bool takes_slots(std::size_t k) const
    {
        const auto &input = pool_.operands[k];
        return input.operand != Operand::indices && input.scalar == sizeof(T) && input.components > 0;
    }

    // The inputs in `over` have slots of their own, one behind the other; the output takes any slots, from `first` on.
    void test(const std::vector<std::size_t> &over, Slots slots, Order order, std::size_t first, std::size_t count)
    {
        if (::testing::Test::HasFailure())
            return;
        describe(over, slots, order, first, count);
        const std::size_t stride =
            (slots.kind == Slots::Kind::arrays ? 1 : slots.number) * sizeof(T) + slots.gap;
        memory_.assign(slots.number * stride * std::max<std::size_t>(count, 1), 0x5a);
        const auto slot = [&](std::size_t s) {
            return reinterpret_cast<T *>(memory_.data() +
                                         s * (slots.kind == Slots::Kind::arrays ? stride * count : sizeof(T)));
        };
        std::vector<View<T>> inputs(pool_.operands.size());
        std::size_t next = 0;
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            const std::size_t components = pool_.operands[k].components;
            if (std::find(over.begin(), over.end(), k) == over.end()) {
                inputs[k] = packed_view(const_cast<T *>(pool_.element(k, 0)), components, pool_.operands[k].scalar);
                continue;
            }
            for (std::size_t c = 0; c < components; ++c)
                inputs[k].component.push_back(slot(next++));
            inputs[k].stride = stride;
            fill(inputs[k], k, count);
        }
        View<T> out;
        for (std::size_t s : slots_of_output(slots, order, first))
            out.component.push_back(slot(s));
        out.stride = stride;
        const mw_status status = subject_.run(out, inputs, count);
        ASSERT_EQ(status, MW_OK) << name_ << ": " << mw_status_text(status);
        compare(out, count);
    }

private:
    void fill(const View<T> &view, std::size_t k, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < view.component.size(); ++c)
                std::memcpy(reinterpret_cast<unsigned char *>(view.component[c]) + i * view.stride,
                            pool_.element(k, i) + c, sizeof(T));
    }

    std::vector<std::size_t> slots_of_output(const Slots &slots, Order order, std::size_t first)
    {
        std::vector<std::size_t> places(slots.number);
        std::iota(places.begin(), places.end(), std::size_t(0));
        if (order == Order::shuffled)
            for (std::size_t k = places.size(); k > 1; --k)
                std::swap(places[k - 1], places[random_.below(k)]);
        std::rotate(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(first), places.end());
        places.resize(subject_.output_components());
        if (order == Order::backwards)
            std::reverse(places.begin(), places.end());
        return places;
    }

    void compare(const View<T> &out, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < out.component.size(); ++c) {
                T result;
                std::memcpy(&result, reinterpret_cast<unsigned char *>(out.component[c]) + i * out.stride,
                            sizeof result);
                ASSERT_TRUE(same(result, pool_.result(i)[c])) << name_ << ": element " << i << ", component " << c;
            }
    }

    void describe(const std::vector<std::size_t> &over, const Slots &slots, Order order, std::size_t first,
                  std::size_t count)
    {
        name_ = subject_.name() + " " + api<T>::name + " on " + mw_isa() + ", count " + std::to_string(count) +
                ", output " + names_of_orders_of_slots[static_cast<int>(order)] + " from slot " +
                std::to_string(first) + " of " + std::to_string(slots.number) +
                (slots.kind == Slots::Kind::arrays ? " arrays" : "") + ", gap " + std::to_string(slots.gap) +
                ", over inputs";
        for (std::size_t k : over)
            name_ += " " + std::to_string(k);
    }

    const Subject<T> &subject_;
    const Pool<T> &pool_;
    Random &random_;
    std::vector<unsigned char> memory_;
    std::string name_;
};

constexpr std::size_t pool_size = 300;

template <class T>
void check_subject(const Subject<T> &subject)
{
    Random random(71);
    Pool<T> pool = make_pool(subject, pool_size, 72, Specials::some);
    run_alone(subject, pool);
    InPlace<T> call(subject, pool, random);
    const bool in_order = is_matrix(subject.output());
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < pool.operands.size(); ++k)
        if (call.takes_slots(k))
            all.push_back(k);
    std::vector<std::vector<std::size_t>> choices;
    for (std::size_t k : all)
        choices.push_back({k});
    if (all.size() > 1)
        choices.push_back(all);
    for (const auto &over : choices) {
        std::size_t taken = 0;
        bool any_in_order = in_order;
        for (std::size_t k : over)
            taken += pool.operands[k].components, any_in_order |= is_matrix(pool.operands[k].operand);
        const std::size_t needed = std::max(taken, subject.output_components());
        for (std::size_t count : {0, 1, 2, 5, 16, 17, 33, 64, 131, 300})
            for (std::size_t more : {0, 1, 3})
                for (std::size_t gap : {std::size_t(0), sizeof(T), std::size_t(1)})
                    for (Slots::Kind kind : {Slots::Kind::side_by_side, Slots::Kind::arrays})
                        for (Order order : {Order::forwards, Order::backwards, Order::shuffled}) {
                            if ((any_in_order && kind == Slots::Kind::arrays) || (in_order && order != Order::forwards))
                                continue;
                            const Slots slots{kind, needed + more, gap};
                            const std::size_t last = slots.number - subject.output_components();
                            for (std::size_t first : {std::size_t(0), last, random.below(last + 1)})
                                call.test(over, slots, order, first, count);
                        }
    }
}

struct InPlaceCase {
    const KernelRow *row;
    std::string isa;
};

std::string name_of(const InPlaceCase &c) { return c.row->name + "_" + c.isa; }
void PrintTo(const InPlaceCase &c, std::ostream *out) { *out << name_of(c); }

std::vector<InPlaceCase> all_cases()
{
    std::vector<InPlaceCase> cases;
    for (const KernelRow &row : kernel_rows())
        for (const std::string &isa : running_isas())
            cases.push_back({&row, isa});
    return cases;
}

class InPlaceTest : public ::testing::TestWithParam<InPlaceCase> {
};

template <class T>
void check_row(const KernelRow &row)
{
    for (const auto &subject : row.subjects<T>()) {
        if (!subject->keeps_apart())
            check_subject(*subject);
        break;  // those that follow differ by numbers
    }
}

TEST_P(InPlaceTest, gives_the_bits_of_each_element_alone)
{
    const ScopedIsa isa(GetParam().isa);
    ASSERT_TRUE(isa.runs());
    check_row<float>(*GetParam().row);
    if (GetParam().row->variant != Variant::mixed)
        check_row<double>(*GetParam().row);
}

INSTANTIATE_TEST_SUITE_P(every, InPlaceTest, ::testing::ValuesIn(all_cases()),
                         [](const auto &each) { return name_of(each.param); });

// ------------------------------------------------------------------------------------------------ as they are written

template <class T>
class InPlaceConversionTest : public ::testing::Test {
};
TYPED_TEST_SUITE(InPlaceConversionTest, Precisions, PrecisionName);

// Motors in slots of 16 numbers become matrices and motors again.
TYPED_TEST(InPlaceConversionTest, matrices_over_their_motors)
{
    using T = TypeParam;
    using C = api<T>;
    using Motor = typename api<T>::motor;
    const std::size_t count = 37, stride = sizeof(T[16]);
    for (mw_matrix_layout layout : all_matrix_layouts) {
        std::vector<T> memory(16 * count, T(3)), motors(8 * count), matrices(16 * count), back(8 * count);
        Random random(73);
        for (std::size_t i = 0; i < count; ++i) {
            draw_motor(random, Regime::general, &motors[8 * i]);
            std::copy_n(&motors[8 * i], 8, &memory[16 * i]);
        }
        const auto slots = [&] { return reinterpret_cast<Motor *>(memory.data()); };
        const auto alone = [&](std::vector<T> &numbers) { return reinterpret_cast<Motor *>(numbers.data()); };
        ASSERT_EQ(C::convert_motor_to_matrix_each({matrices.data(), stride, layout},
                                     api<T>::const_motors_aos(alone(motors), sizeof(Motor)), count), MW_OK);
        ASSERT_EQ(C::convert_motor_to_matrix_each({memory.data(), stride, layout}, api<T>::const_motors_aos(slots(), stride), count),
                  MW_OK);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_TRUE(std::equal(&memory[16 * i], &memory[16 * i] + numbers_of(layout), &matrices[16 * i]));
        for (unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_NEAREST_ROTATION), unsigned(MW_ROTATION_MATRICES)}) {
            memory = matrices;
            ASSERT_EQ(C::convert_matrix_to_motor_each(api<T>::motors_aos(alone(back), sizeof(Motor)),
                                         {matrices.data(), stride, layout}, count, flags, nullptr),
                      MW_OK);
            ASSERT_EQ(C::convert_matrix_to_motor_each(api<T>::motors_aos(slots(), stride), {memory.data(), stride, layout}, count,
                                         flags, nullptr),
                      MW_OK);
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_TRUE(std::equal(&back[8 * i], &back[8 * i] + 8, &memory[16 * i])) << flags;
        }
    }
}

TYPED_TEST(InPlaceConversionTest, dual_quaternions_over_their_motors)
{
    using T = TypeParam;
    using C = api<T>;
    using Motor = typename api<T>::motor;
    std::vector<T> motors(8 * 21);
    Random random(74);
    for (std::size_t k = 0; k < motors.size(); k += 8)
        draw_motor(random, Regime::general, &motors[k]);
    for (const auto &places : {x_first, w_first}) {
        std::vector<T> memory = motors;
        auto *const first = reinterpret_cast<Motor *>(memory.data());
        const View<T> view = packed_view(memory.data(), 8);
        ASSERT_EQ(C::convert_motor_to_dual_quaternion_each(dual_quaternions<typename C::dual_quaternions>(view, places),
                                              api<T>::const_motors_aos(first, sizeof(Motor)), 21), MW_OK);
        EXPECT_NE(memory, motors);
        ASSERT_EQ(C::convert_dual_quaternion_to_motor_each(api<T>::motors_aos(first, sizeof(Motor)),
                                              dual_quaternions<typename C::const_dual_quaternions>(view, places), 21),
                  MW_OK);
        EXPECT_EQ(memory, motors);
    }
}

// Other strides, or a step of an element, are not in place, and a batch of one is, whatever the strides.
TYPED_TEST(InPlaceConversionTest, over_other_elements_is_none)
{
    using T = TypeParam;
    using A = api<T>;
    using Motor = typename A::motor;
    std::vector<T> memory(16 * 40, T(0.25));
    const std::vector<T> before = memory;
    const View<T> bivectors = packed_view(memory.data(), 6);
    auto *const first = reinterpret_cast<Motor *>(memory.data());
    auto *const second = reinterpret_cast<Motor *>(memory.data() + 8);
    EXPECT_EQ(A::exp_motor_each(A::motors_aos(first, sizeof(Motor)), bivectors.const_bivectors(), 9), MW_ERROR_OVERLAP);
    EXPECT_EQ(A::log_motor_each(bivectors.bivectors(), A::const_motors_aos(first, sizeof(Motor)), 9, MW_DEFAULT),
              MW_ERROR_OVERLAP);
    EXPECT_EQ(A::reverse_motor_each(A::motors_aos(second, sizeof(Motor)), A::const_motors_aos(first, sizeof(Motor)), 9),
              MW_ERROR_OVERLAP);
    EXPECT_EQ(A::reverse_motor_each(A::motors_aos(first, sizeof(Motor)), A::const_motors_aos(second, sizeof(Motor)), 9),
              MW_ERROR_OVERLAP);
    // An array a component, of which two are exchanged and one is an element further.
    View<T> arrays, moved;
    for (std::size_t c = 0; c < 8; ++c)
        arrays.component.push_back(memory.data() + 16 * c), moved.component.push_back(memory.data() + 16 * c);
    arrays.stride = moved.stride = sizeof(T);
    std::swap(moved.component[2], moved.component[5]);
    moved.component[7] += 1;
    EXPECT_EQ(A::reverse_motor_each(moved.motors(), arrays.const_motors(), 9), MW_ERROR_OVERLAP);
    EXPECT_EQ(memory, before);
    EXPECT_EQ(A::exp_motor_each(A::motors_aos(first, sizeof(Motor)), bivectors.const_bivectors(), 1), MW_OK);
}

// Two outputs share no byte, in whatever way they are in place of the input.
TYPED_TEST(InPlaceConversionTest, two_outputs_are_apart)
{
    using T = TypeParam;
    using C = api<T>;
    std::vector<T> memory(8 * 20, T(0.5));
    const std::vector<T> before = memory;
    View<T> pose = packed_view(memory.data(), 8);
    const auto run = [&](std::size_t translation) {
        return C::convert_motor_to_pose_each(quaternions<typename C::xyzw>(pose, x_first),
                                vectors<typename api<T>::xyz>(pose, translation), pose.const_motors(), 20);
    };
    for (std::size_t translation : {0, 1, 3})
        EXPECT_EQ(run(translation), MW_ERROR_OVERLAP);
    EXPECT_EQ(memory, before);
    EXPECT_EQ(run(4), MW_OK);
}

}  // namespace
}  // namespace motorway::testing
