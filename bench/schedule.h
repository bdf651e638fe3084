// What a run measures: every shape at every count would take half a day.
#pragma once

#include "shape.h"

#include <cstddef>
#include <vector>

namespace motorway::bench {

// In ascending order: from data in the first cache to data in memory alone.
std::vector<std::size_t> counts(bool quick);

// What of a shape the schedule depends on.
struct scheduled_shape {
    const kernel_row &row;
    layout kind;
    std::size_t count;
    bool f32; // neither f64 nor mixed
};
bool is_scheduled(const scheduled_shape &shape, bool quick);
bool is_threaded(const scheduled_shape &shape, bool quick);

template <class T, class M> scheduled_shape to_schedule(const shape<T, M> &shape)
{
    return {shape.row, shape.kind, shape.count, std::is_same_v<M, float>};
}
template <class T, class M> bool is_scheduled(const shape<T, M> &shape, bool quick)
{
    return is_scheduled(to_schedule(shape), quick);
}

// Whether it is measured on two threads, too.
template <class T, class M> bool is_threaded(const shape<T, M> &shape, bool quick)
{
    return is_threaded(to_schedule(shape), quick);
}

} // namespace motorway::bench
