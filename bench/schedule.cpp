#include "schedule.h"

#include <algorithm>

namespace motorway::bench {
namespace {

constexpr std::size_t largest_count = 8388608;

template <class Value> bool is_one_of(const Value &value, std::initializer_list<Value> values)
{
    return std::find(values.begin(), values.end(), value) != values.end();
}

bool applies_to(const kernel_row &row, std::initializer_list<operand> operands)
{
    return row.verb == "apply" && is_one_of(row.arguments.out[0], operands);
}

bool moves_points(const kernel_row &row) { return applies_to(row, {operand::point}); }

// What is computed of motors, and conversions: many kernels, of a kind each.
bool is_of_group(const kernel_row &row)
{
    return !is_one_of<std::string>(row.verb, {"apply", "reverse", "normalize", "blend"}) &&
           row.name != "compose_motor_each";
}

bool samples_motions(const kernel_row &row) { return row.verb == "sample"; }

// Those of which few sizes tell all.
bool is_uncommon(const kernel_row &row)
{
    return is_of_group(row) || applies_to(row, {operand::tangent, operand::vector, operand::line, operand::motor,
                                                operand::bivector});
}

// The results of a grid are as many as the largest count of the others.
bool is_too_large(const scheduled_shape &shape)
{
    return shape.count * shape.row.arguments.images > largest_count;
}

// Counts that belong to some rows are those of no other.
bool has_its_count(const scheduled_shape &shape)
{
    const std::size_t own = shape.row.arguments.natural_count;
    return own ? shape.count == own : !is_one_of(shape.count, {skeletons, compiled_controls, mesh_vertices});
}

// There are many of them: velocities in one layout and precision, poses in three of the four.
bool is_scheduled_quick_of_motions(const scheduled_shape &shape)
{
    const bool with_velocity = shape.row.arguments.out.size() > 1;
    return with_velocity ? shape.f32 && shape.kind == layout::soa : shape.f32 || shape.kind == layout::soa;
}

// Enough for the bars of the report, and of every shape something in the caches and something beyond the first two.
bool is_scheduled_quick(const scheduled_shape &shape)
{
    if (is_of_group(shape.row) && shape.kind == layout::strided)
        return false;
    if (samples_motions(shape.row))
        return shape.count == 1024 && is_scheduled_quick_of_motions(shape);
    switch (shape.count) {
    case 64: return moves_points(shape.row) && shape.f32;
    case 256: return moves_points(shape.row) || (shape.row.verb != "apply" && !is_uncommon(shape.row));
    case mesh_vertices: return shape.f32 && is_one_of(shape.kind, {layout::packed, layout::soa});
    case skeletons: // as many as compiled_controls
        return shape.f32 || shape.row.verb != "compile";
    case 1024: return shape.f32 || is_of_group(shape.row) || !is_uncommon(shape.row);
    case 65536: return shape.f32;
    default: return shape.row.name == "apply_point_one" && shape.f32;
    }
}

} // namespace

std::vector<std::size_t> counts(bool quick)
{
    if (quick)
        return {64, 256, skeletons, 1024, mesh_vertices, 65536, largest_count};
    return {64, 256, skeletons, 1024, mesh_vertices, 4096, 16384, 65536, 262144, 1048576, largest_count};
}

bool is_scheduled(const scheduled_shape &shape, bool quick)
{
    if (is_too_large(shape) || !has_its_count(shape))
        return false;
    if (quick)
        return is_scheduled_quick(shape);
    if (samples_motions(shape.row))
        return is_one_of<std::size_t>(shape.count, {64, 1024, 65536});
    return !is_uncommon(shape.row) || shape.row.arguments.natural_count ||
           is_one_of<std::size_t>(shape.count, {64, 1024, 65536, 1048576});
}

bool is_threaded(const scheduled_shape &shape, bool quick)
{
    if (shape.row.arguments.natural_count)
        return false;
    return quick ? moves_points(shape.row) && shape.f32 : !is_uncommon(shape.row);
}

} // namespace motorway::bench
