// The subjects nlerp motor each and nlerp motor one, and nlerp_long motor likewise.
#ifndef MOTORWAY_TESTS_NLERP_TESTER_H
#define MOTORWAY_TESTS_NLERP_TESTER_H

#include <cmath>

#include "slerp_tester.h"

namespace motorway::testing {

// The sum before it is normalised.
template <class T>
reference::Motor sum_of_poses(Way way, const T *first, const T *second, T parameter)
{
    using reference::Real;
    const reference::Motor from = exact_motor(first);
    return reference::blend({Real(1) - Real(parameter), Real(parameter)},
                            {from, end_of(way, from, exact_motor(second))});
}

// Any. Only where the poses all but cancel another one is taken: there is no sum there to compare with.
template <class T>
T draw_nlerp_parameter(Random &random, Way way, const T *first, const T *second)
{
    const T parameter = draw_parameter<T>(random, -20, 20);
    const bool cancels = length_of(sum_of_poses(way, first, second, parameter), 0, 4) < 0.01L;
    return cancels ? T(0.25) : parameter;
}

// A component of the sum has 3 roundings of its terms, the root of its square and the quotient another 3: 3ε in all,
// which become as much larger as the sum is shorter than its terms. The translation has those of its own terms, and
// what is taken from it, so that the sum becomes a motor, as many once more.
template <class T>
Expected expect_nlerp(Way way, const T *first, const T *second, T parameter)
{
    const reference::Motor sum = sum_of_poses(way, first, second, parameter);
    const long double from = std::abs(1 - static_cast<long double>(parameter));
    const long double to = std::abs(static_cast<long double>(parameter));
    const long double length = length_of(sum, 0, 4);
    const long double terms = (from + to) / length;
    const long double offsets = (from * length_of(first, 4, 8) + to * length_of(second, 4, 8)) / length;
    return expect_parts(reference::normalize(sum), 3 * epsilon<T> * terms,
                        6 * epsilon<T> * terms * offsets + 8 * underflow<T>);
}

template <class T>
Interpolation<T> nlerp(Way way)
{
    return {"nlerp", api<T>::nlerp_motor_each, api<T>::nlerp_motor_one, way, draw_nlerp_parameter<T>,
            expect_nlerp<T>};
}

template <class T>
Subjects<T> subjects_of_nlerp_motor_each()
{
    return InterpolateEach<T>::all(nlerp<T>(Way::shorter));
}
template <class T>
Subjects<T> subjects_of_nlerp_motor_one()
{
    return InterpolateOne<T>::all(nlerp<T>(Way::shorter));
}
template <class T>
Subjects<T> subjects_of_nlerp_long_motor_each()
{
    return InterpolateEach<T>::all(nlerp<T>(Way::longer));
}
template <class T>
Subjects<T> subjects_of_nlerp_long_motor_one()
{
    return InterpolateOne<T>::all(nlerp<T>(Way::longer));
}

}  // namespace motorway::testing

#endif
