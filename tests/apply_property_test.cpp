// What must hold of moved things whatever the numbers are: laws of geometry, and promises of the header, through the
// public API alone.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "apply_api.h"
#include "isas.h"
#include "kernel_tester.h"
#include "motors.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

template <class T>
class ApplyPropertyTest : public ::testing::Test {
protected:
    static constexpr std::size_t count = 111;
    using Numbers = std::vector<T>;  // the components of element after element

    // Of ordinary sizes, so that errors are small multiples of epsilon and the laws can be seen to hold.
    static Numbers draw_motors(Random &random)
    {
        const Regime regimes[] = {Regime::general, Regime::scaled, Regime::half_turn, Regime::rotation,
                                  Regime::pseudoscalar};
        Numbers motors(8 * count);
        for (std::size_t i = 0; i < count; ++i)
            draw_motor(random, regimes[i % std::size(regimes)], &motors[8 * i]);
        return motors;
    }

    static Numbers draw(Random &random, std::size_t components)
    {
        Numbers numbers(components * count);
        for (T &number : numbers)
            number = static_cast<T>(random.uniform(-2, 2));
        return numbers;
    }

    static Numbers moved(Moved what, const Numbers &motors, const Numbers &elements)
    {
        const ApplyFunctions<T> functions = apply_functions_of<T>(what);
        Numbers out(elements.size()), in(elements), by(motors);
        ApplyCall<T> call;
        call.in = packed_view(in.data(), functions.components());
        call.out = packed_view(out.data(), functions.components());
        call.motors = packed_view(by.data(), 8);
        call.count = count;
        EXPECT_EQ(functions.each(call), MW_OK);
        return out;
    }

    static void expect_close(const Numbers &a, const Numbers &b, double epsilons)
    {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k)
            ASSERT_NEAR(static_cast<double>(a[k]), static_cast<double>(b[k]),
                        epsilons * static_cast<double>(epsilon<T>))
                << "number " << k;
    }

    // Element by element, from the components of a to those that `make` finds for them.
    template <class Make>
    static Numbers made(const Numbers &a, const Numbers &b, std::size_t components, Make make)
    {
        Numbers result(components * count);
        for (std::size_t i = 0; i < count; ++i)
            make(&a[a.size() / count * i], &b[b.size() / count * i], &result[components * i]);
        return result;
    }
};

TYPED_TEST_SUITE(ApplyPropertyTest, Precisions, PrecisionName);

// Rounded as it is: e0 + p + ½ (p² - r²) e∞.
template <class T>
void make_sphere(const T *p, const T *radius, T *sphere)
{
    sphere[0] = 1;
    std::copy_n(p, 3, sphere + 1);
    sphere[4] = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - radius[0] * radius[0]) / 2;
}

template <class T>
void make_line(const T *p, const T *q, T *line)
{
    for (std::size_t k = 0; k < 3; ++k)
        line[k] = q[k] - p[k];
    for (std::size_t k = 0; k < 3; ++k)
        line[3 + k] = p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
}

TYPED_TEST(ApplyPropertyTest, a_sphere_moves_with_its_centre)
{
    using T = TypeParam;
    Random random(71);
    const auto motors = this->draw_motors(random), centres = this->draw(random, 3), radii = this->draw(random, 3);
    const auto spheres = this->made(centres, radii, 5, make_sphere<T>);
    const auto images = this->moved(Moved::point, motors, centres);
    // Centres are up to about 20 away, and squares of that are in the e∞ part.
    this->expect_close(this->moved(Moved::vector, motors, spheres), this->made(images, radii, 5, make_sphere<T>),
                       8000);
}

TYPED_TEST(ApplyPropertyTest, a_line_moves_with_its_points)
{
    using T = TypeParam;
    Random random(72);
    const auto motors = this->draw_motors(random), p = this->draw(random, 3), q = this->draw(random, 3);
    const auto lines = this->made(p, q, 6, make_line<T>);
    const auto images = this->made(this->moved(Moved::point, motors, p), this->moved(Moved::point, motors, q), 6,
                                   make_line<T>);
    this->expect_close(this->moved(Moved::line, motors, lines), images, 4000);
}

// T^-1 M T does to F_T(p) what M did to p.
TYPED_TEST(ApplyPropertyTest, a_moved_motor_does_the_same_at_the_moved_place)
{
    Random random(73);
    const auto by = this->draw_motors(random), motors = this->draw_motors(random), p = this->draw(random, 3);
    const auto there = this->moved(Moved::point, this->moved(Moved::motor, by, motors),
                                   this->moved(Moved::point, by, p));
    this->expect_close(there, this->moved(Moved::point, by, this->moved(Moved::point, motors, p)), 8000);
}

TYPED_TEST(ApplyPropertyTest, directions_do_not_feel_the_translation)
{
    Random random(74);
    auto motors = this->draw_motors(random);
    const auto directions = this->draw(random, 3);
    const auto before = this->moved(Moved::direction, motors, directions);
    for (std::size_t i = 0; i < this->count; ++i)
        for (std::size_t k = 4; k < 8; ++k)
            motors[8 * i + k] = static_cast<TypeParam>(random.uniform(-1e3, 1e3));
    EXPECT_EQ(this->moved(Moved::direction, motors, directions), before);
}

// The bits of w are the bits that were there: of every sign, size and NaN, quiet or not. Loads and stores of the test
// itself are of integers.
template <class T>
void expect_w_unchanged(const ApplyFunctions<T> &functions, Pairing pairing, Layout layout)
{
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr std::size_t count = 37;
    constexpr Bits infinity = Bits(sizeof(T) == 4 ? 0x7f800000 : 0x7ff0000000000000);
    constexpr Bits sign = Bits(1) << (sizeof(T) * 8 - 1);
    const Bits patterns[] = {0,           sign,        1,           sign | 1,     infinity, sign | infinity,
                             infinity | 1, sign | infinity | 5, infinity | (infinity >> 1), Bits(0x12345678)};
    Random random(75);
    const Placement placement = layout.place(4, count, sizeof(T));
    const std::size_t block_size = placement.block_sizes[0] / sizeof(T) + 16, blocks = placement.block_sizes.size();
    std::vector<T> in(blocks * block_size), out(in.size());
    for (T &number : in)
        number = static_cast<T>(random.uniform(-2, 2));
    ApplyCall<T> call;
    for (const auto &[block, offset] : placement.component) {
        call.in.component.push_back(&in[block * block_size + offset / sizeof(T)]);
        call.out.component.push_back(&out[block * block_size + offset / sizeof(T)]);
    }
    call.in.stride = call.out.stride = placement.stride;
    const auto w_of = [&](const View<T> &view, std::size_t i) {
        return reinterpret_cast<char *>(view.component[3]) + i * view.stride;
    };
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(w_of(call.in, i), &patterns[i % std::size(patterns)], sizeof(T));
    T motors[8 * count];
    for (std::size_t i = 0; i < count; ++i)
        draw_motor(random, Regime::scaled, &motors[8 * i]);
    const unsigned char indices[count] = {};
    call.motors = packed_view(motors, 8);
    call.motor = motors;
    call.motor_count = 1;
    call.indices = mw_indices_u8(indices, 1);
    call.row_stride = count * call.out.stride;
    call.count = count;
    ASSERT_EQ(functions.run(pairing, call), MW_OK);
    for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(std::memcmp(w_of(call.out, i), &patterns[i % std::size(patterns)], sizeof(T)), 0)
            << functions.name(pairing) << " on " << mw_isa() << ", " << layout.name() << ", element " << i;
}

TYPED_TEST(ApplyPropertyTest, the_w_of_a_tangent_passes_through_bit_for_bit)
{
    using T = TypeParam;
    for (const std::string &isa : running_isas()) {
        ScopedIsa scope(isa);
        for (Pairing pairing : all_pairings)
            for (const Layout &layout : {Layout::aos(), Layout::soa(), Layout::aos(2 * sizeof(T)), Layout::split()})
                expect_w_unchanged(apply_functions_of<T>(Moved::tangent), pairing, layout);
    }
}

// Positions and normals that lie apart, each with a stride of its own, have the bits of those side by side.
template <class T>
class Vertices {
public:
    static constexpr std::size_t count = 67;
    using Api_ = api<T>;

    Vertices()
    {
        Random random(76);
        for (std::size_t i = 0; i < count; ++i) {
            draw_motor(random, any_regime(random), &motors_[8 * i]);
            indices_[i] = static_cast<unsigned char>(random.below(count));
            for (T *p : {&together_[6 * i], &together_[6 * i + 3]})
                draw_vector(random, p);
            std::copy_n(&together_[6 * i], 3, &positions_[3 * i]);
            std::copy_n(&together_[6 * i + 3], 3, &normals_[5 * i]);
        }
    }

    void test(Pairing pairing, unsigned flags)
    {
        std::vector<T> expected(6 * count), positions(4 * count, T(-7)), normals(3 * count, T(-7));
        run(pairing, flags, xyz(&expected[0], 6), xyz(&expected[3], 6), xyz(together_, 6), xyz(together_ + 3, 6));
        run(pairing, flags, xyz(positions.data(), 4), xyz(normals.data(), 3), xyz(positions_, 3), xyz(normals_, 5));
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(std::memcmp(&expected[6 * i], &positions[4 * i], sizeof(T[3])), 0) << "position " << i;
            ASSERT_EQ(std::memcmp(&expected[6 * i + 3], &normals[3 * i], sizeof(T[3])), 0) << "normal " << i;
            ASSERT_EQ(positions[4 * i + 3], T(-7)) << "behind position " << i;
        }
    }

private:
    struct Xyz {
        typename Api_::xyz out;
        typename Api_::const_xyz in;
    };
    static Xyz xyz(T *first, std::size_t step)
    {
        return {Api_::xyz_aos(first, step * sizeof(T)), Api_::const_xyz_aos(first, step * sizeof(T))};
    }

    void run(Pairing pairing, unsigned flags, Xyz out_p, Xyz out_n, Xyz in_p, Xyz in_n)
    {
        const auto *motor = reinterpret_cast<const typename Api_::motor *>(motors_);
        const auto motors = Api_::const_motors_aos(motor, sizeof *motor);
        const mw_indices indices = mw_indices_u8(indices_, 1);
        mw_status status = MW_ERROR_ISA;
        if constexpr (sizeof(T) == sizeof(float)) {
            const mw_vertices_f32 out = {out_p.out, out_n.out};
            const mw_const_vertices_f32 in = {in_p.in, in_n.in};
            if (pairing == Pairing::one)
                status = api<float>::apply_vertex_one(out, motor, in, count, flags);
            else if (pairing == Pairing::each)
                status = api<float>::apply_vertex_each(out, motors, in, count, flags);
            else
                status = api<float>::apply_vertex_indexed(out, motor, count, indices, in, count, flags);
        } else {
            const mw_vertices_f64 out = {out_p.out, out_n.out};
            const mw_const_vertices_f64 in = {in_p.in, in_n.in};
            if (pairing == Pairing::one)
                status = api<double>::apply_vertex_one(out, motor, in, count, flags);
            else if (pairing == Pairing::each)
                status = api<double>::apply_vertex_each(out, motors, in, count, flags);
            else
                status = api<double>::apply_vertex_indexed(out, motor, count, indices, in, count, flags);
        }
        ASSERT_EQ(status, MW_OK);
    }

    T motors_[8 * count], together_[6 * count], positions_[3 * count], normals_[5 * count];
    unsigned char indices_[count];
};

TYPED_TEST(ApplyPropertyTest, positions_and_normals_may_lie_apart)
{
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        Vertices<TypeParam> vertices;
        for (Pairing pairing : {Pairing::one, Pairing::each, Pairing::indexed})
            for (unsigned flags : {MW_DEFAULT + 0u, MW_UNIT_MOTORS + 0u, MW_STREAMING_STORES + 0u})
                vertices.test(pairing, flags);
    }
}

// ------------------------------------------------------------------------------------------------ mixed precision

struct MixedCall {
    static constexpr std::size_t count = 53;
    ApplyFunctions<float> functions = apply_functions_of<float>(Moved::point, true);
    std::vector<double> motors = std::vector<double>(8 * count);
    std::vector<float> points = std::vector<float>(3 * count);
    unsigned char indices[count];

    explicit MixedCall(Regime regime)
    {
        Random random(77);
        for (std::size_t i = 0; i < count; ++i) {
            draw_motor(random, regime, &motors[8 * i]);
            draw_vector(random, &points[3 * i]);
            indices[i] = static_cast<unsigned char>(random.below(count));
        }
    }

    std::vector<float> run(Pairing pairing, const mw_shift *shift)
    {
        std::vector<float> out(3 * count);
        ApplyCall<float> call;
        call.in = packed_view(points.data(), 3);
        call.out = packed_view(out.data(), 3);
        call.motors = packed_view(motors.data(), 8).as<float>();
        call.motor = motors.data();
        call.motor_count = pairing == Pairing::grid ? 1 : count;
        call.indices = mw_indices_u8(indices, 1);
        call.row_stride = count * call.out.stride;
        call.shift = shift;
        call.count = count;
        EXPECT_EQ(functions.run(pairing, call), MW_OK);
        return out;
    }
};

TEST(Mixed, without_a_shift_it_is_zero)
{
    const mw_shift zero = {{0, 0, 0}, {0, 0, 0}};
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        MixedCall call(Regime::scaled);
        for (Pairing pairing : all_pairings) {
            const auto with = call.run(pairing, &zero), without = call.run(pairing, nullptr);
            EXPECT_EQ(std::memcmp(with.data(), without.data(), with.size() * sizeof(float)), 0) << name_of(pairing);
        }
    }
}

// A city 5000 km from the origin, seen from a camera in it: floats there are half a metre apart, and results are
// right to the last bit of a float of their own hundred metres.
TEST(Mixed, a_world_far_from_the_origin_keeps_its_millimetres)
{
    const double city[3] = {4e6 + 0.123, -3e6 - 0.5, 1234.5678};
    const mw_shift shift = {{-city[0], -city[1], -city[2]}, {-city[0] - 10.25, -city[1] + 3.5, -city[2] - 1.7}};
    MixedCall call(Regime::general);
    for (std::size_t i = 0; i < call.count; ++i) {
        // A turn about a vertical axis in the city.
        const double angle = 0.01 * static_cast<double>(i), up[3] = {0, 0, 1};
        mw_motor_f64 motor;
        ASSERT_EQ(mw_rotation_f64(&motor, up, angle, city), MW_OK);
        std::memcpy(&call.motors[8 * i], &motor, sizeof motor);
        const float here[3] = {100.f + static_cast<float>(i), -50.f, 7.f};
        std::copy_n(here, 3, &call.points[3 * i]);
    }
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        const auto seen = call.run(Pairing::each, &shift);
        for (std::size_t i = 0; i < call.count; ++i) {
            const double angle = 0.01 * static_cast<double>(i), x = call.points[3 * i], y = call.points[3 * i + 1];
            const double expected[3] = {x * std::cos(angle) - y * std::sin(angle) - 10.25,
                                        x * std::sin(angle) + y * std::cos(angle) + 3.5, 7 - 1.7};
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(seen[3 * i + k], expected[k], 1e-5) << "point " << i << ", coordinate " << k;
        }
    }
}

}  // namespace
}  // namespace motorway::testing
