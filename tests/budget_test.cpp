// The operations an element that each kernel may take, in the class of a fused multiply-add. The counts are those the
// generator made of the code it wrote.

#include <gtest/gtest.h>

#include "kernel_list.h"

namespace motorway::testing {
namespace {

const KernelRow &row(const std::string &name)
{
    for (const KernelRow &candidate : kernel_rows())
        if (candidate.name == name)
            return candidate;
    throw std::invalid_argument("no kernel " + name);
}

TEST(Budget, a_point_under_one_motor_takes_9_operations)
{
    EXPECT_EQ(row("apply_point_one").operations, 9);
    EXPECT_EQ(row("apply_point_one").divisions, 0);
    EXPECT_EQ(row("apply_direction_one").operations, 9);
    EXPECT_EQ(row("apply_direction_one").divisions, 0);
}

TEST(Budget, a_point_under_a_normalised_motor_of_its_own_takes_at_most_24)
{
    EXPECT_LE(row("apply_point_each_unit").operations, 24);
    EXPECT_EQ(row("apply_point_each_unit").divisions, 0);
    EXPECT_LE(row("apply_direction_each_unit").operations, 24);
    EXPECT_EQ(row("apply_direction_each_unit").divisions, 0);
}

TEST(Budget, any_motor_costs_4_more_and_a_division)
{
    EXPECT_LE(row("apply_point_each").operations, 24 + 4);
    EXPECT_LE(row("apply_point_each").operations, row("apply_point_each_unit").operations + 4);
    EXPECT_EQ(row("apply_point_each").divisions, 1);
    EXPECT_LE(row("apply_direction_each").operations, row("apply_direction_each_unit").operations + 4);
    EXPECT_EQ(row("apply_direction_each").divisions, 1);
}

// R p alone; R p and R n; R p + e0 t, and e∞ grows by three terms of p and one of e0.
TEST(Budget, one_motor_costs_an_element_no_more_than_its_matrix)
{
    const std::pair<const char *, int> most[] = {{"point", 9},   {"direction", 9}, {"tangent", 9}, {"vertex", 18},
                                                 {"vector", 16}, {"line", 27},     {"motor", 27},
                                                 {"bivector", 27}};
    for (const auto &[operand, operations] : most)
        for (const char *pairing : {"one", "grid"}) {
            const KernelRow &r = row(std::string("apply_") + operand + "_" + pairing);
            EXPECT_LE(r.operations, operations) << r.name;
            EXPECT_EQ(r.divisions, 0) << r.name;
        }
    for (const char *name : {"apply_point_one_mixed", "apply_point_grid_mixed"}) {
        EXPECT_EQ(row(name).operations, 9) << name;  // the shift is part of the translation
        EXPECT_EQ(row(name).divisions, 0) << name;
    }
}

// A w that is copied costs nothing, a second vector no more than it does alone, and none of it a second division. A
// line takes the terms of two vectors, those that couple them, and the rest of S̄S; a grade 1 vector lacks most of
// these. In mixed precision the shift is six sums.
TEST(Budget, a_motor_each_costs_what_its_forms_do)
{
    EXPECT_EQ(row("apply_tangent_each").operations, row("apply_direction_each").operations);
    EXPECT_LE(row("apply_vertex_each").operations,
              row("apply_point_each").operations + row("apply_direction_each").operations - 4);
    EXPECT_LE(row("apply_point_each_mixed").operations, row("apply_point_each").operations + 6);
    EXPECT_LE(row("apply_vector_each_unit").operations, 40);
    EXPECT_LE(row("apply_vector_each").operations, 53);
    EXPECT_LE(row("apply_line_each_unit").operations, 51);
    EXPECT_LE(row("apply_line_each").operations, 68);
    EXPECT_LE(row("apply_motor_each").operations, row("apply_line_each").operations);
    EXPECT_LE(row("apply_bivector_each").operations, row("apply_line_each").operations);
    for (const char *operand : {"point", "direction", "tangent", "vertex", "vector", "line", "motor", "bivector"}) {
        const std::string each = std::string("apply_") + operand + "_each";
        EXPECT_EQ(row(each).divisions, 1) << each;
        EXPECT_EQ(row(each + "_unit").divisions, 0) << each;
        EXPECT_LT(row(each + "_unit").operations, row(each).operations) << each;
    }
}

// A palette only says where the motor is.
TEST(Budget, an_indexed_motor_costs_what_one_each_costs)
{
    for (const KernelRow &each : kernel_rows()) {
        const std::size_t place = each.name.find("_each");
        if (each.name.rfind("apply_", 0) != 0 || place == std::string::npos)
            continue;
        const KernelRow &indexed = row(std::string(each.name).replace(place, 5, "_indexed"));
        EXPECT_EQ(indexed.operations, each.operations) << indexed.name;
        EXPECT_EQ(indexed.divisions, each.divisions) << indexed.name;
        EXPECT_EQ(indexed.inputs, each.inputs) << indexed.name;
    }
}

TEST(Budget, a_product_of_motors_takes_at_most_48)
{
    EXPECT_LE(row("compose_motor_each").operations, 48);
    EXPECT_EQ(row("compose_motor_each").divisions, 0);
}

TEST(Budget, a_product_with_one_factor_fixed_takes_no_more)
{
    EXPECT_LE(row("compose_motor_one_first").operations, row("compose_motor_each").operations);
    EXPECT_LE(row("compose_motor_one_then").operations, row("compose_motor_each").operations);
    EXPECT_EQ(row("compose_motor_one_first").divisions + row("compose_motor_one_then").divisions, 0);
}

TEST(Budget, exponentials_and_logarithms)
{
    // 60, and 11 more for angles of every size: to find those that are too large, signs of half turns, and the last bit
    // of the inverse of the angle.
    EXPECT_LE(row("exp_motor_each").operations, 71);
    EXPECT_LE(row("exp_motor_each").divisions, 2);
    EXPECT_LE(row("log_motor_each_unit").operations, 50);
    EXPECT_EQ(row("log_motor_each_unit").divisions, 0);
    EXPECT_LE(row("log_principal_motor_each_unit").operations, 50);
    EXPECT_LE(row("log_principal_motor_each_unit").divisions, 2);
}

// Normalising is all that a motor which is not normalised costs more.
TEST(Budget, a_logarithm_of_any_motor_costs_no_more_than_normalising_it_first)
{
    const KernelRow &normalize = row("normalize_motor_each");
    for (const std::string name : {"log_motor_each", "log_principal_motor_each"}) {
        EXPECT_LE(row(name).operations, row(name + "_unit").operations + normalize.operations) << name;
        EXPECT_LE(row(name).divisions, row(name + "_unit").divisions + normalize.divisions) << name;
    }
}

TEST(Budget, interpolation_and_powers)
{
    EXPECT_LE(row("slerp_motor_each").operations, 220);
    EXPECT_EQ(row("slerp_motor_each").divisions, 0);
    EXPECT_LT(row("slerp_motor_one").operations, row("slerp_motor_each").operations);
    EXPECT_EQ(row("slerp_motor_one").divisions, 0);
    EXPECT_LE(row("slerp_long_motor_each").operations, 221);
    EXPECT_LT(row("slerp_long_motor_one").operations, row("slerp_long_motor_each").operations);
    EXPECT_LE(row("sqrt_motor_each").operations, 18);
    EXPECT_LE(row("power_motor_each").operations,
              row("log_motor_each_unit").operations + 6 + row("exp_motor_each").operations);
}

// Either way round, less than half of slerp; and no way costs more than the other, for it is one sign.
TEST(Budget, a_normalised_blend_costs_less_than_half_of_slerp)
{
    EXPECT_LT(2 * row("nlerp_motor_each").operations, row("slerp_motor_each").operations);
    for (const std::string pairing : {"each", "one"}) {
        const KernelRow &shorter = row("nlerp_motor_" + pairing), &longer = row("nlerp_long_motor_" + pairing);
        EXPECT_EQ(shorter.operations, longer.operations) << pairing;
        EXPECT_EQ(shorter.divisions, 2) << pairing;
        EXPECT_EQ(longer.divisions, 2) << pairing;
    }
    EXPECT_LT(row("nlerp_motor_one").operations, row("nlerp_motor_each").operations);
}

TEST(Budget, a_ratio_costs_no_more_than_inverting_and_a_product)
{
    const KernelRow &product = row("compose_motor_each"), &inverse = row("inverse_motor_each");
    EXPECT_LE(row("ratio_motor_each_unit").operations, product.operations);
    EXPECT_EQ(row("ratio_motor_each_unit").divisions, 0);
    EXPECT_LE(row("ratio_motor_each").operations, inverse.operations + product.operations);
    EXPECT_EQ(row("ratio_motor_each").divisions, 1);
}

// What they take now, and no more. Another order of the components, or the last row of a matrix, is free.
TEST(Budget, conversions)
{
    struct Cost {
        const char *name;
        int operations, divisions;
    };
    const Cost most[] = {{"motor_to_pose", 26, 2},          {"pose_to_motor", 17, 0},
                         {"motor_to_dual_quaternion", 2, 0}, {"dual_quaternion_to_motor", 2, 0},
                         {"motor_to_rows_3x4", 43, 1},      {"rows_3x4_to_motor", 63, 2},
                         {"motor_to_axis_angle", 67, 5},    {"axis_angle_to_motor", 45, 0},
                         {"motor_to_euler", 133, 8},        {"motor_to_euler_proper", 122, 8},
                         {"euler_to_motor", 161, 0},        {"translation_to_motor", 3, 0},
                         {"motor_to_translation", 19, 1},   {"motor_to_screw", 111, 6},
                         {"screw_to_motor", 45, 0},         {"rotor_to_motor", 10, 0}};
    for (const Cost &cost : most) {
        const KernelRow &r = row("convert_" + std::string(cost.name) + "_each");
        EXPECT_LE(r.operations, cost.operations) << r.name;
        EXPECT_LE(r.divisions, cost.divisions) << r.name;
    }
    const std::pair<const char *, const char *> orders[] = {
        {"motor_to_pose", "motor_to_pose_wxyz"},
        {"pose_to_motor", "pose_wxyz_to_motor"},
        {"motor_to_dual_quaternion", "motor_to_dual_quaternion_wxyz"},
        {"dual_quaternion_to_motor", "dual_quaternion_wxyz_to_motor"},
        {"motor_to_rows_3x4", "motor_to_rows_4x4"},
        {"motor_to_rows_3x4", "motor_to_columns_3x4"},
        {"motor_to_rows_3x4", "motor_to_columns_4x4"},
        {"rows_3x4_to_motor", "columns_3x4_to_motor"},
        {"rows_3x4_to_motor", "columns_4x4_to_motor"}};
    for (const auto &[one, other] : orders) {
        const KernelRow &a = row("convert_" + std::string(one) + "_each");
        const KernelRow &b = row("convert_" + std::string(other) + "_each");
        EXPECT_EQ(a.operations, b.operations) << b.name;
        EXPECT_EQ(a.divisions, b.divisions) << b.name;
    }
}

TEST(Budget, a_term_of_a_blend_takes_8)
{
    EXPECT_LE(row("blend_motor_one").operations, 8);
    EXPECT_LE(row("blend_motor_each").operations, 8);
}

// What benchmarks turn into bytes: of a blend, an element and term. Where there is an index, what it picks counts.
TEST(Budget, the_list_counts_the_components_of_every_operand)
{
    for (const KernelRow &r : kernel_rows()) {
        const auto subjects = r.subjects<float>();
        const Subject<float> &subject = *subjects.front();
        EXPECT_EQ(r.outputs, static_cast<int>(subject.output_components())) << r.name;
        int inputs = 0, terms = 1;
        for (const auto &input : subject.inputs()) {
            inputs += input.operand == Operand::indices ? 8 : static_cast<int>(input.components);
            if (input.operand == Operand::weights)
                terms = static_cast<int>(input.components);
        }
        EXPECT_EQ(r.inputs * terms, inputs) << r.name;
    }
}

}  // namespace
}  // namespace motorway::testing
