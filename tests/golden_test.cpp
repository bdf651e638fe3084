// Exact results from the generator's rational arithmetic, on every instruction set. Reference and kernels come from
// the same paper but not from the same code; these vectors say what the generator itself takes the formulas for.

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "kernel_list.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

struct Golden {
    std::vector<double> inputs;                    // exact in float
    std::vector<std::array<double, 2>> outputs;    // numerator and denominator
};

const std::vector<Golden> golden_apply_point = {
#include "../generated/golden/apply_point.inc"
};
const std::vector<Golden> golden_apply_direction = {
#include "../generated/golden/apply_direction.inc"
};
const std::vector<Golden> golden_apply_tangent = {
#include "../generated/golden/apply_tangent.inc"
};
const std::vector<Golden> golden_apply_vertex = {
#include "../generated/golden/apply_vertex.inc"
};
const std::vector<Golden> golden_apply_vector = {
#include "../generated/golden/apply_vector.inc"
};
const std::vector<Golden> golden_apply_line = {
#include "../generated/golden/apply_line.inc"
};
const std::vector<Golden> golden_apply_motor = {
#include "../generated/golden/apply_motor.inc"
};
const std::vector<Golden> golden_apply_bivector = {
#include "../generated/golden/apply_bivector.inc"
};
// The motor, what is subtracted before and added after, and the point.
const std::vector<Golden> golden_apply_point_mixed = {
#include "../generated/golden/apply_point_mixed.inc"
};
const std::vector<Golden> golden_compose_motor = {
#include "../generated/golden/compose_motor.inc"
};
const std::vector<Golden> golden_reverse_motor = {
#include "../generated/golden/reverse_motor.inc"
};
const std::vector<Golden> golden_normalize_motor = {
#include "../generated/golden/normalize_motor.inc"
};
// One term of a blend: the sum so far, a weight, a control.
const std::vector<Golden> golden_blend_motor = {
#include "../generated/golden/blend_motor.inc"
};

const std::vector<Golden> golden_inverse_motor = {
#include "../generated/golden/inverse_motor.inc"
};
const std::vector<Golden> golden_ratio_motor = {
#include "../generated/golden/ratio_motor.inc"
};
const std::vector<Golden> golden_convert_motor_to_pose = {
#include "../generated/golden/convert_motor_to_pose.inc"
};
const std::vector<Golden> golden_convert_pose_to_motor = {
#include "../generated/golden/convert_pose_to_motor.inc"
};
const std::vector<Golden> golden_convert_motor_to_pose_wxyz = {
#include "../generated/golden/convert_motor_to_pose_wxyz.inc"
};
const std::vector<Golden> golden_convert_pose_wxyz_to_motor = {
#include "../generated/golden/convert_pose_wxyz_to_motor.inc"
};
const std::vector<Golden> golden_convert_motor_to_dual_quaternion = {
#include "../generated/golden/convert_motor_to_dual_quaternion.inc"
};
const std::vector<Golden> golden_convert_dual_quaternion_to_motor = {
#include "../generated/golden/convert_dual_quaternion_to_motor.inc"
};
const std::vector<Golden> golden_convert_motor_to_dual_quaternion_wxyz = {
#include "../generated/golden/convert_motor_to_dual_quaternion_wxyz.inc"
};
const std::vector<Golden> golden_convert_dual_quaternion_wxyz_to_motor = {
#include "../generated/golden/convert_dual_quaternion_wxyz_to_motor.inc"
};
const std::vector<Golden> golden_convert_motor_to_rows_3x4 = {
#include "../generated/golden/convert_motor_to_rows_3x4.inc"
};
const std::vector<Golden> golden_convert_motor_to_rows_4x4 = {
#include "../generated/golden/convert_motor_to_rows_4x4.inc"
};
const std::vector<Golden> golden_convert_motor_to_columns_3x4 = {
#include "../generated/golden/convert_motor_to_columns_3x4.inc"
};
const std::vector<Golden> golden_convert_motor_to_columns_4x4 = {
#include "../generated/golden/convert_motor_to_columns_4x4.inc"
};
const std::vector<Golden> golden_convert_translation_to_motor = {
#include "../generated/golden/convert_translation_to_motor.inc"
};
const std::vector<Golden> golden_convert_motor_to_translation = {
#include "../generated/golden/convert_motor_to_translation.inc"
};
// The scale, and then the rotor.
const std::vector<Golden> golden_convert_rotor_to_motor = {
#include "../generated/golden/convert_rotor_to_motor.inc"
};
// Rational arithmetic has no exact results of these; the reference alone judges them.
const std::vector<Golden> irrational;
const std::vector<Golden> &golden_exp_motor = irrational, &golden_log_motor = irrational,
                          &golden_log_principal_motor = irrational, &golden_sqrt_motor = irrational,
                          &golden_power_motor = irrational, &golden_slerp_motor = irrational,
                          &golden_slerp_long_motor = irrational, &golden_nlerp_motor = irrational,
                          &golden_nlerp_long_motor = irrational, &golden_convert_rows_3x4_to_motor = irrational,
                          &golden_convert_columns_3x4_to_motor = irrational,
                          &golden_convert_columns_4x4_to_motor = irrational,
                          &golden_convert_motor_to_axis_angle = irrational,
                          &golden_convert_axis_angle_to_motor = irrational,
                          &golden_convert_motor_to_euler = irrational,
                          &golden_convert_motor_to_euler_proper = irrational,
                          &golden_convert_euler_to_motor = irrational,
                          &golden_convert_motor_to_screw = irrational,
                          &golden_convert_screw_to_motor = irrational;

// Every row of the kernel list needs its vectors, or this does not compile.
const std::vector<const std::vector<Golden> *> golden_of_every_row = {
#define MOTORWAY_KERNEL(verb, operand, pairing, ...) &golden_##verb##_##operand,
#define MOTORWAY_KERNEL_MIXED(verb, operand, pairing, ...) &golden_##verb##_##operand##_mixed,
#include "../generated/kernel_list.inc"
};

template <class T>
using Result = std::array<T, 16>;  // of a 4 x 4 matrix

template <class T>
std::vector<T> components(const Golden &golden)
{
    return {golden.inputs.begin(), golden.inputs.end()};
}

const std::vector<Golden> &golden_of(Moved moved, bool mixed)
{
    if (mixed)
        return golden_apply_point_mixed;
    switch (moved) {
#define MOTORWAY_GOLDEN_CASE(operand, views, P)                                                                      \
    case Moved::operand: return golden_apply_##operand;
        MW_OPERANDS(MOTORWAY_GOLDEN_CASE, )
#undef MOTORWAY_GOLDEN_CASE
    }
    throw std::invalid_argument("no such operand");
}

template <class T>
const typename api<T>::motor *motor_at(const T *components)
{
    return reinterpret_cast<const typename api<T>::motor *>(components);
}

template <class T>
View<T> view_at(T *components, std::size_t count)
{
    return packed_view(components, count);
}

// The magnitudes of these inputs are at most about 10 and α is at least 1, so no sum of products of two of them, nor
// of four over α, exceeds some thousands; what has a factor more has one power more. Results that are no rounding
// away from exact pass as well.
template <class T, class Run>
void expect_golden(const std::vector<Golden> &vectors, Run run, int power = 2)
{
    ASSERT_GE(vectors.size(), 8u);
    for (const Golden &golden : vectors) {
        std::vector<T> inputs = components<T>(golden);
        for (std::size_t k = 0; k < inputs.size(); ++k)
            ASSERT_EQ(static_cast<double>(inputs[k]), golden.inputs[k]) << "input " << k << " is not exact";
        Result<T> result{};
        ASSERT_EQ(run(inputs, result), MW_OK);
        long double largest = 1;
        for (double input : golden.inputs)
            largest = std::max(largest, std::abs(static_cast<long double>(input)));
        for (std::size_t k = 0; k < golden.outputs.size(); ++k) {
            const auto [numerator, denominator] = golden.outputs[k];
            const long double exact = static_cast<long double>(numerator) / denominator;
            EXPECT_NEAR(static_cast<double>(result[k]), static_cast<double>(exact),
                        static_cast<double>(8 * epsilon<T> * std::pow(largest, power)))
                << "component " << k << " of vector " << &golden - vectors.data();
        }
    }
}

// One call of an apply function for the numbers of a golden vector, which has the motor first.
template <class T>
mw_status apply_golden(const ApplyFunctions<T> &functions, Pairing pairing, std::vector<T> &in, Result<T> &out)
{
    static const unsigned char index = 0;
    double motor[8];
    std::copy_n(in.begin(), 8, motor);
    mw_shift shift{};
    if (functions.is_mixed()) {
        std::copy_n(in.begin() + 8, 3, shift.before);
        std::copy_n(in.begin() + 11, 3, shift.after);
    }
    ApplyCall<T> call;
    call.out = view_at(out.data(), functions.components());
    call.in = view_at(&in[functions.is_mixed() ? 14 : 8], functions.components());
    call.motors = functions.is_mixed() ? packed_view(motor, 8).template as<T>() : view_at(in.data(), 8);
    call.motor = call.motors.component[0];
    call.motor_count = 1;
    call.indices = mw_indices_u8(&index, 1);
    call.row_stride = call.out.stride;
    call.shift = &shift;
    call.count = 1;
    return functions.run(pairing, call);
}

template <class T>
class GoldenTest : public ::testing::Test {
protected:
    // Runs a test once on each instruction set that can run.
    template <class Body>
    void on_every_isa(Body body)
    {
        for (const std::string &isa : running_isas()) {
            SCOPED_TRACE(isa);
            ScopedIsa scope(isa);
            body();
        }
    }
};

TYPED_TEST_SUITE(GoldenTest, Precisions, PrecisionName);

TYPED_TEST(GoldenTest, apply)
{
    using T = TypeParam;
    this->on_every_isa([] {
        for (const ApplyFunctions<T> &functions : apply_functions<T>())
            for (Pairing pairing : all_pairings) {
                SCOPED_TRACE(functions.name(pairing));
                const bool has_products = functions.moved == Moved::vector || functions.moved == Moved::line ||
                                          functions.moved == Moved::motor || functions.moved == Moved::bivector;
                expect_golden<T>(
                    golden_of(functions.moved, functions.is_mixed()),
                    [&](std::vector<T> &in, Result<T> &out) { return apply_golden(functions, pairing, in, out); },
                    has_products ? 3 : 2);
            }
    });
}

TYPED_TEST(GoldenTest, compose_motor)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(golden_compose_motor, [](std::vector<T> &in, Result<T> &out) {
            return api<T>::compose_motor_each(view_at(out.data(), 8).motors(), view_at(in.data(), 8).const_motors(),
                                              view_at(&in[8], 8).const_motors(), 1);
        });
    });
}

TYPED_TEST(GoldenTest, compose_motor_with_one_factor_fixed)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(golden_compose_motor, [](std::vector<T> &in, Result<T> &out) {
            return api<T>::compose_motor_one_first(view_at(out.data(), 8).motors(), motor_at(in.data()),
                                                   view_at(&in[8], 8).const_motors(), 1);
        });
        expect_golden<T>(golden_compose_motor, [](std::vector<T> &in, Result<T> &out) {
            return api<T>::compose_motor_one_then(view_at(out.data(), 8).motors(),
                                                  view_at(in.data(), 8).const_motors(), motor_at(&in[8]), 1);
        });
    });
}

TYPED_TEST(GoldenTest, inverse_motor)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(golden_inverse_motor, [](std::vector<T> &in, Result<T> &out) {
            return api<T>::inverse_motor_each(view_at(out.data(), 8).motors(), view_at(in.data(), 8).const_motors(),
                                              1);
        });
    });
}

TYPED_TEST(GoldenTest, ratio_motor)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(
            golden_ratio_motor,
            [](std::vector<T> &in, Result<T> &out) {
                return api<T>::ratio_motor_each(view_at(out.data(), 8).motors(), view_at(in.data(), 8).const_motors(),
                                                view_at(&in[8], 8).const_motors(), 1, MW_DEFAULT);
            },
            3);
    });
}

// A conversion by its numbers, each of its operands adjacent.
#define MOTORWAY_GOLDEN_CONVERSION(P, function, ...)                                                                 \
    [](std::vector<scalar_##P> &in, Result<scalar_##P> &out) {                                                       \
        (void)in, (void)out;                                                                                         \
        return api<scalar_##P>::convert_##function##_each(__VA_ARGS__);                                                        \
    }
#define MOTORWAY_GOLDEN_OUT(views, P, order, at) mw_##views##_##P##_##order(&out[at], 64)
#define MOTORWAY_GOLDEN_IN(views, P, order, at) mw_const_##views##_##P##_##order(&in[at], 64)
#define MOTORWAY_GOLDEN_CONST_MOTORS(P, at) view_at(&in[at], 8).const_motors()

#define MOTORWAY_GOLDEN_CONVERSIONS(P)                                                                               \
    using T = scalar_##P;                                                                                            \
    const auto matrix = [](mw_matrix_layout layout) {                                                                \
        return [layout](std::vector<T> &in, Result<T> &out) {                                                        \
            const mw_matrices_##P matrices = {out.data(), sizeof out, layout};                                       \
            return api<scalar_##P>::convert_motor_to_matrix_each(matrices, MOTORWAY_GOLDEN_CONST_MOTORS(P, 0), 1);             \
        };                                                                                                           \
    };                                                                                                               \
    expect_golden<T>(golden_convert_motor_to_rows_3x4, matrix(MW_MATRIX_ROWS_3X4));                                  \
    expect_golden<T>(golden_convert_motor_to_rows_4x4, matrix(MW_MATRIX_ROWS_4X4));                                  \
    expect_golden<T>(golden_convert_motor_to_columns_3x4, matrix(MW_MATRIX_COLUMNS_3X4));                            \
    expect_golden<T>(golden_convert_motor_to_columns_4x4, matrix(MW_MATRIX_COLUMNS_4X4));                            \
    MOTORWAY_GOLDEN_QUATERNIONS(P, aos, )                                                                            \
    MOTORWAY_GOLDEN_QUATERNIONS(P, wxyz, _wxyz)                                                                      \
    expect_golden<T>(golden_convert_translation_to_motor,                                                            \
                     MOTORWAY_GOLDEN_CONVERSION(P, translation_to_motor, view_at(out.data(), 8).motors(),            \
                                                MOTORWAY_GOLDEN_IN(xyz, P, aos, 0), 1));                             \
    expect_golden<T>(golden_convert_motor_to_translation,                                                            \
                     MOTORWAY_GOLDEN_CONVERSION(P, motor_to_translation, MOTORWAY_GOLDEN_OUT(xyz, P, aos, 0),        \
                                                MOTORWAY_GOLDEN_CONST_MOTORS(P, 0), 1));                             \
    expect_golden<T>(golden_convert_rotor_to_motor,                                                                  \
                     MOTORWAY_GOLDEN_CONVERSION(P, rotor_to_motor, view_at(out.data(), 8).motors(),                  \
                                                MOTORWAY_GOLDEN_CONST_MOTORS(P, 1), 1, in[0]));

#define MOTORWAY_GOLDEN_QUATERNIONS(P, order, name)                                                                  \
    expect_golden<T>(golden_convert_motor_to_pose##name,                                                             \
                     MOTORWAY_GOLDEN_CONVERSION(P, motor_to_pose, MOTORWAY_GOLDEN_OUT(xyzw, P, order, 0),            \
                                                MOTORWAY_GOLDEN_OUT(xyz, P, aos, 4),                                 \
                                                MOTORWAY_GOLDEN_CONST_MOTORS(P, 0), 1));                             \
    expect_golden<T>(golden_convert_pose##name##_to_motor,                                                           \
                     MOTORWAY_GOLDEN_CONVERSION(P, pose_to_motor, view_at(out.data(), 8).motors(),                   \
                                                MOTORWAY_GOLDEN_IN(xyzw, P, order, 0),                               \
                                                MOTORWAY_GOLDEN_IN(xyz, P, aos, 4), 1));                             \
    expect_golden<T>(golden_convert_motor_to_dual_quaternion##name,                                                  \
                     MOTORWAY_GOLDEN_CONVERSION(P, motor_to_dual_quaternion,                                         \
                                                MOTORWAY_GOLDEN_OUT(dual_quaternions, P, order, 0),                  \
                                                MOTORWAY_GOLDEN_CONST_MOTORS(P, 0), 1));                             \
    expect_golden<T>(golden_convert_dual_quaternion##name##_to_motor,                                                \
                     MOTORWAY_GOLDEN_CONVERSION(P, dual_quaternion_to_motor, view_at(out.data(), 8).motors(),        \
                                                MOTORWAY_GOLDEN_IN(dual_quaternions, P, order, 0), 1));

TEST(Golden, conversions)
{
    for (const std::string &isa : running_isas()) {
        SCOPED_TRACE(isa);
        ScopedIsa scope(isa);
        [] { MOTORWAY_GOLDEN_CONVERSIONS(f32) }();
        [] { MOTORWAY_GOLDEN_CONVERSIONS(f64) }();
    }
}

#undef MOTORWAY_GOLDEN_CONVERSION
#undef MOTORWAY_GOLDEN_CONVERSIONS
#undef MOTORWAY_GOLDEN_QUATERNIONS
#undef MOTORWAY_GOLDEN_OUT
#undef MOTORWAY_GOLDEN_IN
#undef MOTORWAY_GOLDEN_CONST_MOTORS

TYPED_TEST(GoldenTest, reverse_motor)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(golden_reverse_motor, [](std::vector<T> &in, Result<T> &out) {
            return api<T>::reverse_motor_each(view_at(out.data(), 8).motors(), view_at(in.data(), 8).const_motors(),
                                              1);
        });
    });
}

TYPED_TEST(GoldenTest, normalize_motor)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(golden_normalize_motor, [](std::vector<T> &in, Result<T> &out) {
            return api<T>::normalize_motor_each(view_at(out.data(), 8).motors(), view_at(in.data(), 8).const_motors(),
                                                1);
        });
    });
}

TYPED_TEST(GoldenTest, blend_motor)
{
    using T = TypeParam;
    this->on_every_isa([] {
        expect_golden<T>(golden_blend_motor, [](std::vector<T> &in, Result<T> &out) {
            T weights[2] = {1, in[8]}, controls[16];
            std::copy_n(in.begin(), 8, controls);
            std::copy_n(in.begin() + 9, 8, controls + 8);
            return api<T>::blend_motor_one(view_at(out.data(), 8).motors(), motor_at(controls),
                                           view_at(weights, 2).weights(), 2, 1);
        });
        expect_golden<T>(golden_blend_motor, [](std::vector<T> &in, Result<T> &out) {
            T weights[2] = {1, in[8]};
            const typename api<T>::const_motors controls[] = {view_at(in.data(), 8).const_motors(),
                                                             view_at(&in[9], 8).const_motors()};
            return api<T>::blend_motor_each(view_at(out.data(), 8).motors(), controls,
                                            view_at(weights, 2).weights(), 2, 1);
        });
    });
}

TEST(Golden, every_kernel_has_vectors)
{
    for (const auto *vectors : golden_of_every_row)
        EXPECT_TRUE(!vectors->empty() || vectors == &irrational);
}

}  // namespace
}  // namespace motorway::testing
