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

TEST(Budget, a_product_of_motors_takes_at_most_48)
{
    EXPECT_LE(row("compose_motor_each").operations, 48);
    EXPECT_EQ(row("compose_motor_each").divisions, 0);
}

TEST(Budget, a_term_of_a_blend_takes_8)
{
    EXPECT_LE(row("blend_motor_one").operations, 8);
    EXPECT_LE(row("blend_motor_each").operations, 8);
}

// What benchmarks turn into bytes: of a blend, an element and term.
TEST(Budget, the_list_counts_the_components_of_every_operand)
{
    for (const KernelRow &r : kernel_rows()) {
        const auto subjects = r.subjects<float>();
        const Subject<float> &subject = *subjects.front();
        EXPECT_EQ(r.outputs, static_cast<int>(subject.output_components())) << r.name;
        int inputs = 0, terms = 1;
        for (const auto &input : subject.inputs()) {
            inputs += static_cast<int>(input.components);
            if (input.operand == Operand::weights)
                terms = static_cast<int>(input.components);
        }
        EXPECT_EQ(r.inputs * terms, inputs) << r.name;
    }
}

}  // namespace
}  // namespace motorway::testing
