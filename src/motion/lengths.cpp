// Lengths of the ways of points, parameters equally far apart along them, and velocities.
#include "evenly.h"
#include "measured_span.h"

namespace motorway {
namespace {

// Kahan's sum, of any number of spans.
class long_sum {
    double sum = 0, excess = 0;

public:
    double value() const { return sum; }
    void add(double x)
    {
        const double corrected = x - excess, grown = sum + corrected;
        excess = (grown - sum) - corrected;
        sum = grown;
    }
};

// --------------------------------------------------------------------------------------------------- validation

// `out` shares no byte with the point or the motion.
template <class T>
mw_status check_moving_point(const T *out, std::size_t count, const typename c_types<T>::compiled *motion,
                             std::size_t index, const T *point)
{
    const mw_status status =
        first_error(check_array(out, count), [&] { return check_array(point, 3); },
                    [&] { return check_compiled<T>(motion, index); });
    if (status != MW_OK)
        return status;
    const byte_range range = range_of(out, count);
    return range.meets(compiled_of<T>(motion).range()) || range.meets(range_of(point, 3)) ? MW_ERROR_OVERLAP : MW_OK;
}

// In the domain, and not decreasing; the lengths may take the place of the parameters.
template <class T>
mw_status check_parameters(const T *lengths, const T *parameters, std::size_t count, const compiled<T> &motion)
{
    const mw_status status = check_array(parameters, count);
    if (status != MW_OK)
        return status;
    if (lengths != parameters && range_of(lengths, count).meets(range_of(parameters, count)))
        return MW_ERROR_OVERLAP;
    T least = motion.begin();
    for (std::size_t i = 0; i < count; ++i) {
        if (!(parameters[i] >= least && parameters[i] <= motion.end()))
            return MW_ERROR_PARAMETER;
        least = parameters[i];
    }
    return MW_OK;
}

// ------------------------------------------------------------------------------------------------------ lengths

template <class T>
mw_status motion_lengths(T *lengths, const typename c_types<T>::compiled *motion, std::size_t index, const T *place,
                         const T *parameters, std::size_t count)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (count == 0)
        return MW_OK;
    const mw_status status = first_error(check_moving_point(lengths, count, motion, index, place), [&] {
        return check_parameters(lengths, parameters, count, compiled_of<T>(motion));
    });
    if (status != MW_OK)
        return status;

    const compiled<T> moving = compiled_of<T>(motion);
    const moving_point<T> point(moving, index, place);
    const T *const starts = moving.starts();
    long_sum before;
    for (std::size_t span = 0, i = 0; i < count; ++span) {
        measured_span<T> way(point, starts[span], starts[span + 1]);
        const bool is_last = span + 1 == moving->span_count;
        for (std::size_t some; i < count && (is_last || parameters[i] < starts[span + 1]); i += some) {
            for (some = 1; some < stretches_at_once && i + some < count; ++some)
                if (!is_last && !(parameters[i + some] < starts[span + 1]))
                    break;
            double inside[stretches_at_once];
            way.lengths_until(parameters + i, some, inside);
            for (std::size_t k = 0; k < some; ++k)
                lengths[i + k] = static_cast<T>(before.value() + inside[k]);
        }
        before.add(way.length());
    }
    return MW_OK;
}

// The whole length, and what it may be off by.
struct whole_way {
    double length, uncertainty;
};
template <class T> whole_way measure(const moving_point<T> &point, const compiled<T> &motion)
{
    long_sum length, uncertainty;
    for (std::size_t span = 0; span < motion->span_count; ++span) {
        const measured_span<T> way(point, motion.starts()[span], motion.starts()[span + 1]);
        length.add(way.length());
        uncertainty.add(way.uncertainty());
    }
    return {length.value(), uncertainty.value()};
}

// All but the last.
template <class T>
void divide(T *parameters, std::size_t count, const moving_point<T> &point, const compiled<T> &motion, double length)
{
    const T *const starts = motion.starts();
    const double tolerance = length * static_cast<double>(std::numeric_limits<T>::epsilon());
    long_sum before;
    std::size_t i = 1;
    for (std::size_t span = 0; span < motion->span_count && i + 1 < count; ++span) {
        measured_span<T> way(point, starts[span], starts[span + 1]);
        for (; i + 1 < count; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(count - 1);
            const double inside = part * length - before.value();
            if (!(inside <= way.length()))
                break;
            const T parameter = static_cast<T>(way.parameter_at(inside, tolerance));
            parameters[i] = std::max(parameters[i - 1], parameter);
        }
        before.add(way.length());
    }
    for (; i + 1 < count; ++i)
        parameters[i] = motion.end();
}

template <class T>
mw_status motion_even_parameters(T *parameters, const typename c_types<T>::compiled *motion, std::size_t index,
                                 const T *place, std::size_t count)
{
    if (!kernels())
        return MW_ERROR_ISA;
    if (count == 0)
        return MW_OK;
    const mw_status status = check_moving_point(parameters, count, motion, index, place);
    if (status != MW_OK)
        return status;

    const compiled<T> moving = compiled_of<T>(motion);
    const moving_point<T> point(moving, index, place);
    const whole_way way = measure(point, moving);
    if (way.length > way.uncertainty && std::isfinite(way.length)) {
        parameters[0] = moving.begin();
        divide(parameters, count, point, moving, way.length);
        if (count > 1)
            parameters[count - 1] = moving.end();
    } else // the point does not move, or is not finite
        for (std::size_t i = 0; i < count; ++i)
            parameters[i] = evenly_spaced(moving.begin(), moving.end(), i, count);
    return MW_OK;
}

template <class T> mw_status twist_velocity(T *velocity, const T *twist, const T *place)
{
    if (!velocity || !twist || !place)
        return MW_ERROR_NULL;
    const vector3 v = velocity_of(twist, {place[0], place[1], place[2]});
    velocity[0] = static_cast<T>(v.x), velocity[1] = static_cast<T>(v.y), velocity[2] = static_cast<T>(v.z);
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../../generated/calls/motion_lengths.inc"
