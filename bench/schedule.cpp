#include "schedule.h"

#include <algorithm>

namespace motorway::bench {
namespace {

constexpr std::size_t largest_count = 8388608;

bool is_one_of(std::size_t count, std::initializer_list<std::size_t> counts)
{
    return std::find(counts.begin(), counts.end(), count) != counts.end();
}

bool applies_to(const kernel_row &row, std::initializer_list<operand> operands)
{
    return row.verb == "apply" && std::find(operands.begin(), operands.end(), row.arguments.out) != operands.end();
}

bool moves_points(const kernel_row &row) { return applies_to(row, {operand::point}); }

// Those that few people need, and for which there are no baselines.
bool is_uncommon(const kernel_row &row)
{
    return applies_to(row, {operand::tangent, operand::vector, operand::line, operand::motor});
}

// The results of a grid are as many as the largest count of the others.
bool is_too_large(const scheduled_shape &shape)
{
    return shape.count * shape.row.arguments.images > largest_count;
}

// Enough for the bars of the report, and of every shape something in the caches and something beyond the first two.
bool is_scheduled_quick(const scheduled_shape &shape)
{
    switch (shape.count) {
    case 64: return moves_points(shape.row) && shape.f32;
    case 256: return moves_points(shape.row) || shape.row.verb != "apply";
    case 1024: return shape.f32 || !is_uncommon(shape.row);
    case 65536: return shape.f32;
    default: return shape.row.name == "apply_point_one" && shape.f32;
    }
}

} // namespace

std::vector<std::size_t> counts(bool quick)
{
    if (quick)
        return {64, 256, 1024, 65536, largest_count};
    return {64, 256, 1024, 4096, 16384, 65536, 262144, 1048576, largest_count};
}

bool is_scheduled(const scheduled_shape &shape, bool quick)
{
    if (is_too_large(shape))
        return false;
    if (quick)
        return is_scheduled_quick(shape);
    return !is_uncommon(shape.row) || is_one_of(shape.count, {64, 1024, 65536, 1048576});
}

bool is_threaded(const scheduled_shape &shape, bool quick)
{
    return quick ? moves_points(shape.row) && shape.f32 : !is_uncommon(shape.row);
}

} // namespace motorway::bench
