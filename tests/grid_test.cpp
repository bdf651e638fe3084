// Grids: every result is that of mw_apply_<operand>_one for its motor and its element, to the last bit, in whatever
// order rows and elements lie, and not a byte between or past them is touched.

#include <cstring>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apply_tester.h"
#include "isas.h"
#include "kernel_tester.h"

namespace motorway::testing {
namespace {

// How the rows of a grid lie. The gaps are bytes between what would else be adjacent.
enum class Order {
    motor_major,   // row after row of whole elements
    point_major,   // element after element, each with its images side by side
    arrays,        // an array a component, in which row comes after row
    point_arrays,  // an array a component, in which element comes after element
    rows_of_arrays // in each row an array a component
};

constexpr Order all_orders[] = {Order::motor_major, Order::point_major, Order::arrays, Order::point_arrays,
                                Order::rows_of_arrays};

struct GridLayout {
    Order order = Order::motor_major;
    std::size_t element_gap = 0, row_gap = 0;
    bool reversed = false;  // the components in the opposite order

    std::string name() const
    {
        static const char *const names[] = {"motor-major", "point-major", "arrays", "point-major arrays",
                                            "rows of arrays"};
        return std::string(names[static_cast<int>(order)]) + ", gaps " + std::to_string(element_gap) + " and " +
               std::to_string(row_gap) + (reversed ? ", reversed" : "");
    }

    struct Place {
        std::vector<std::size_t> component, block;  // byte offset of each in its block
        std::size_t stride, row_stride, blocks;
    };

    Place place(std::size_t components, std::size_t count, std::size_t rows, std::size_t scalar) const
    {
        Place place{};
        const bool separate = order == Order::arrays || order == Order::point_arrays;
        const std::size_t element = (separate ? scalar : components * scalar) + element_gap;
        switch (order) {
        case Order::motor_major:
        case Order::arrays:
            place.stride = element;
            place.row_stride = count * place.stride + row_gap;
            break;
        case Order::point_major:
        case Order::point_arrays:
            place.row_stride = element;
            place.stride = rows * element + row_gap;
            break;
        case Order::rows_of_arrays:
            place.stride = scalar + element_gap;
            place.row_stride = components * count * place.stride + row_gap;
            break;
        }
        for (std::size_t c = 0; c < components; ++c) {
            const std::size_t slot = reversed ? components - 1 - c : c;
            place.block.push_back(separate ? slot : 0);
            place.component.push_back(separate                        ? 0
                                      : order == Order::rows_of_arrays ? slot * count * place.stride
                                                                       : slot * scalar);
        }
        place.blocks = separate ? components : 1;
        return place;
    }
};

// Elements and motors, and all their results by apply one.
template <class T>
struct GridPool {
    static constexpr std::size_t count = 60, motor_count = 24;

    explicit GridPool(const ApplyFunctions<T> &f) : functions(f), in(count * f.components())
    {
        Random random(9);
        for (std::size_t i = 0; i < count; ++i)
            draw_operand(random, f.moved, &in[i * f.components()]);
        for (std::size_t m = 0; m < motor_count; ++m)
            add_motor(random);
        // Bad numbers in a few elements: they stay there.
        for (std::size_t i = 5; i < count; i += 11)
            make_special<T>(random, &in[i * f.components()], f.components());
        for (std::size_t m = 0; m < motor_count; ++m)
            run_row(m);
    }

    const T *result(std::size_t m, std::size_t i) const { return &results[(m * count + i) * functions.components()]; }

    ApplyFunctions<T> functions;
    std::vector<T> in, results;
    std::vector<unsigned char> motors;
    mw_shift shift{{1000.125, -3e6, 0.1}, {-1e-3, 3e6, 7}};

private:
    void add_motor(Random &random)
    {
        const Regime regime = any_regime(random);
        float single[8];
        double precise[8];
        draw_motor(random, regime, single);
        draw_motor(random, regime, precise);
        const auto *bytes = functions.motor_scalar == sizeof(float) ? reinterpret_cast<unsigned char *>(single)
                                                                    : reinterpret_cast<unsigned char *>(precise);
        motors.insert(motors.end(), bytes, bytes + functions.motor_size());
    }

    void run_row(std::size_t m)
    {
        results.resize((m + 1) * count * functions.components());
        ApplyCall<T> call;
        call.in = packed_view(in.data(), functions.components());
        call.out = packed_view(&results[m * count * functions.components()], functions.components());
        call.motor = &motors[m * functions.motor_size()];
        call.shift = &shift;
        call.count = count;
        ASSERT_EQ(functions.one(call), MW_OK);
    }
};

// One case: the sizes and how everything lies. All blocks end at a forbidden page, or begin at one.
template <class T>
class GridTester {
public:
    explicit GridTester(const GridPool<T> &pool) : pool_(pool) {}

    std::size_t count = 1, motor_count = 1, first = 0, first_motor = 0, offset = 0;
    GridLayout out_layout;
    Layout in_layout = Layout::aos(), motor_layout = Layout::aos();
    Guard guard = Guard::after;
    unsigned flags = MW_DEFAULT;

    void test()
    {
        if (::testing::Test::HasFailure())
            return;
        const ApplyFunctions<T> &functions = pool_.functions;
        const std::size_t components = functions.components();
        ApplyCall<T> call;
        call.in = place_input(0, in_layout, components, sizeof(T), count,
                              reinterpret_cast<const unsigned char *>(&pool_.in[first * components]));
        call.motors = place_input(8, motor_layout, 8, functions.motor_scalar, motor_count,
                                  &pool_.motors[first_motor * functions.motor_size()]);
        call.motor_count = motor_count;
        call.count = count;
        call.shift = &pool_.shift;
        call.flags = flags;
        place_output(call);
        const mw_status status = functions.grid(call);
        if (status != MW_OK)
            return fail(std::string("status: ") + mw_status_text(status));
        check(call);
    }

private:
    // In the order of their addresses, so that the arrays of an operand lie together and none of another's between.
    static GuardedBuffer &buffer(std::size_t index)
    {
        static std::map<unsigned char *, GuardedBuffer> buffers;
        while (buffers.size() < 3 * 8) {
            GuardedBuffer made(std::size_t(1) << 20);
            unsigned char *const begin = made.begin();
            buffers.emplace(begin, std::move(made));
        }
        return std::next(buffers.begin(), static_cast<std::ptrdiff_t>(index))->second;
    }

    View<T> place_input(std::size_t first_buffer, const Layout &layout, std::size_t components, std::size_t scalar,
                        std::size_t elements, const unsigned char *values)
    {
        const Placement placement = layout.place(components, elements, scalar);
        std::vector<unsigned char *> blocks;
        for (std::size_t size : placement.block_sizes)
            blocks.push_back(buffer(first_buffer + blocks.size()).place(size, guard));
        View<T> view;
        view.stride = placement.stride;
        for (const auto &[block, at] : placement.component)
            view.component.push_back(reinterpret_cast<T *>(blocks[block] + at));
        for (std::size_t i = 0; i < elements; ++i)
            for (std::size_t c = 0; c < components; ++c)
                std::memcpy(reinterpret_cast<unsigned char *>(view.component[c]) + i * view.stride,
                            values + (i * components + c) * scalar, scalar);
        return view;
    }

    // From the first byte that is written to past the last, or nothing.
    void place_output(ApplyCall<T> &call)
    {
        const std::size_t components = pool_.functions.components();
        const auto place = out_layout.place(components, count, motor_count, sizeof(T));
        std::vector<std::size_t> sizes(place.blocks);
        for (std::size_t c = 0; c < components && count && motor_count; ++c) {
            const std::size_t end = place.component[c] + (count - 1) * place.stride +
                                    (motor_count - 1) * place.row_stride + sizeof(T);
            sizes[place.block[c]] = std::max(sizes[place.block[c]], end);
        }
        blocks_.clear();
        for (std::size_t b = 0; b < place.blocks; ++b) {
            unsigned char *const begin = buffer(16 + b).place(sizes[b], guard, offset);
            const std::size_t margin = std::min<std::size_t>(offset, 64);
            Block block{guard == Guard::before ? begin - margin : begin,
                        guard == Guard::after ? begin + sizes[b] + margin : begin + sizes[b]};
            std::memset(block.low, canary, static_cast<std::size_t>(block.high - block.low));
            blocks_.push_back(block);
            begins_.resize(b + 1);
            begins_[b] = begin;
        }
        call.out.component.clear();
        for (std::size_t c = 0; c < components; ++c)
            call.out.component.push_back(reinterpret_cast<T *>(begins_[place.block[c]] + place.component[c]));
        call.out.stride = place.stride;
        call.row_stride = place.row_stride;
    }

    // Compares every result, puts a canary in its place, and then looks for anything else.
    void check(const ApplyCall<T> &call)
    {
        for (std::size_t m = 0; m < motor_count; ++m)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < pool_.functions.components(); ++c) {
                    auto *byte = reinterpret_cast<unsigned char *>(call.out.component[c]) + m * call.row_stride +
                                 i * call.out.stride;
                    T result;
                    std::memcpy(&result, byte, sizeof(T));
                    std::memset(byte, canary, sizeof(T));
                    if (!same(result, pool_.result(first_motor + m, first + i)[c]))
                        return fail_bits(m, i, c, result);
                }
        for (const Block &block : blocks_)
            for (const unsigned char *byte = block.low; byte != block.high; ++byte)
                if (*byte != canary)
                    return fail("a byte between or past the results changed");
    }

    void fail_bits(std::size_t m, std::size_t i, std::size_t c, T result) const
    {
        std::ostringstream text;
        text << std::hexfloat << "motor " << m << ", element " << i << ", component " << c << " is " << result
             << ", but " << pool_.result(first_motor + m, first + i)[c] << " by mw_apply_..._one";
        fail(text.str());
    }

    void fail(const std::string &message) const
    {
        ADD_FAILURE() << pool_.functions.name(Pairing::grid) << " on " << mw_isa() << ", " << motor_count
                      << " motors from " << first_motor << ", " << count << " elements from " << first << ", output "
                      << out_layout.name() << " at offset " << offset << ", input " << in_layout.name() << ", motors "
                      << motor_layout.name() << ", guard " << (guard == Guard::after ? "after" : "before")
                      << ", flags " << flags << ":\n" << message;
    }

    struct Block {
        unsigned char *low, *high;
    };
    static constexpr unsigned char canary = 0x5a;

    const GridPool<T> &pool_;
    std::vector<Block> blocks_;
    std::vector<unsigned char *> begins_;
};

struct GridCase {
    std::string operand, precision, isa;
};

void PrintTo(const GridCase &c, std::ostream *out) { *out << c.operand << "_" << c.precision << "_" << c.isa; }

template <class T>
void add_cases(std::vector<GridCase> &cases)
{
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        for (const std::string &isa : running_isas())
            cases.push_back({functions.operand, functions.precision, isa});
}

std::vector<GridCase> all_cases()
{
    std::vector<GridCase> cases;
    add_cases<float>(cases);
    add_cases<double>(cases);
    return cases;
}

class GridTest : public ::testing::TestWithParam<GridCase> {
protected:
    void SetUp() override { ASSERT_TRUE(isa_.runs()); }

    // body(functions) for the functions of this case.
    template <class Body>
    void with_functions(Body body)
    {
        for (const auto &functions : apply_functions<float>())
            if (functions.operand == GetParam().operand && functions.precision == GetParam().precision)
                body(functions);
        for (const auto &functions : apply_functions<double>())
            if (functions.operand == GetParam().operand && functions.precision == GetParam().precision)
                body(functions);
    }

private:
    ScopedIsa isa_{GetParam().isa};
};

template <class T>
void test_sizes(const ApplyFunctions<T> &functions)
{
    const GridPool<T> pool(functions);
    for (std::size_t count = 0; count <= 50; ++count)
        for (std::size_t motor_count : {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 20})
            for (Order order : all_orders) {
                GridTester<T> tester(pool);
                tester.count = count;
                tester.motor_count = motor_count;
                tester.first = count % 9;
                tester.first_motor = motor_count % 4;
                tester.out_layout.order = order;
                tester.guard = (count + motor_count) % 2 ? Guard::after : Guard::before;
                tester.test();
            }
}

template <class T>
void test_mixtures(const ApplyFunctions<T> &functions)
{
    const GridPool<T> pool(functions);
    Random random(10);
    const std::size_t gaps[] = {0, 0, 1, sizeof(T), 2 * sizeof(T), 20, 64};
    const auto in_layouts = Layout::all(functions.components(), sizeof(T));
    const auto motor_layouts = Layout::all(8, functions.motor_scalar);
    const unsigned flags[] = {MW_DEFAULT, MW_UNIT_MOTORS, MW_STREAMING_STORES, MW_NO_STREAMING_STORES};
    for (int repetition = 0; repetition < 1500; ++repetition) {
        GridTester<T> tester(pool);
        tester.first = random.below(10);
        tester.first_motor = random.below(4);
        tester.count = random.below(51);
        tester.motor_count = random.below(21);
        tester.out_layout = {all_orders[random.below(std::size(all_orders))], gaps[random.below(std::size(gaps))],
                             gaps[random.below(std::size(gaps))], random.chance(4)};
        tester.in_layout = in_layouts[random.below(in_layouts.size())];
        tester.motor_layout = motor_layouts[random.below(motor_layouts.size())];
        tester.guard = random.chance(2) ? Guard::after : Guard::before;
        tester.offset = random.chance(2) ? sizeof(T) * random.below(17) : random.below(70);
        tester.flags = flags[random.below(std::size(flags))];
        tester.test();
    }
}

TEST_P(GridTest, gives_the_bits_of_one_motor_and_one_element_for_all_sizes)
{
    with_functions([](const auto &functions) { test_sizes(functions); });
}

TEST_P(GridTest, gives_the_bits_of_one_motor_and_one_element_wherever_they_lie)
{
    with_functions([](const auto &functions) { test_mixtures(functions); });
}

// Many blocks of elements and of motors: more than any part of it that fits in a cache.
template <class T>
void test_large(const ApplyFunctions<T> &functions)
{
    for (const auto &[count, motor_count] : {std::pair(1000, 3), std::pair(5000, 2), std::pair(3, 700),
                                             std::pair(257, 65), std::pair(64, 64)})
        for (bool point_major : {false, true}) {
            const std::size_t n = count, m = motor_count, components = functions.components();
            Random random(11);
            std::vector<T> in(n * components), out(m * n * components), row(n * components);
            // Zeros among them: what cancels shows by its sign in which order it was computed.
            const auto zero = [&] { return random.chance(2) ? 0.0 : -0.0; };
            for (T &number : in)
                number = static_cast<T>(random.chance(3) ? zero() : random.uniform(-2, 2));
            std::vector<unsigned char> motors(m * functions.motor_size());
            for (std::size_t k = 0; k < m * 8; ++k) {
                const bool rotates = k % 8 < 4;
                const double precise = !rotates && random.chance(2) ? zero() : random.uniform(-1, 1);
                const float single = static_cast<float>(precise);
                std::memcpy(&motors[k * functions.motor_scalar],
                            functions.motor_scalar == sizeof single ? static_cast<const void *>(&single) : &precise,
                            functions.motor_scalar);
            }
            ApplyCall<T> call;
            call.in = packed_view(in.data(), components);
            call.out = packed_view(out.data(), components);
            call.motors = packed_view(reinterpret_cast<T *>(motors.data()), 8, functions.motor_scalar);
            call.motor_count = m;
            call.count = n;
            call.row_stride = (point_major ? 1 : n) * components * sizeof(T);
            call.out.stride = (point_major ? m : 1) * components * sizeof(T);
            ASSERT_EQ(functions.grid(call), MW_OK);
            for (std::size_t k = 0; k < m; ++k) {
                ApplyCall<T> one;
                one.in = call.in;
                one.out = packed_view(row.data(), components);
                one.motor = &motors[k * functions.motor_size()];
                one.count = n;
                ASSERT_EQ(functions.one(one), MW_OK);
                for (std::size_t i = 0; i < n; ++i) {
                    const T *const image = &out[(point_major ? i * m + k : k * n + i) * components];
                    ASSERT_EQ(std::memcmp(&row[i * components], image, components * sizeof(T)), 0)
                        << "motor " << k << " of " << m << ", element " << i << " of " << n;
                }
            }
        }
}

TEST_P(GridTest, gives_the_same_bits_when_it_is_large)
{
    with_functions([](const auto &functions) { test_large(functions); });
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(every, GridTest, ::testing::ValuesIn(all_cases()), [](const auto &each) {
    return each.param.operand + "_" + each.param.precision + "_" + each.param.isa;
});

}  // namespace motorway::testing
