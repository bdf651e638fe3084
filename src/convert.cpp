// Motors from and into what other libraries hold. Validate, look up, call, return a status.
#include "motorway.h"
#include "stream_calls.h"

#include <cmath>

namespace motorway {
namespace {

// ------------------------------------------------------------------------------------------------------ quaternions

// Whether w is next to x, and comes first: then a view in the order w x y z is of adjacent components.
template <class Pointer> bool is_wxyz(Pointer w, Pointer x) { return x && w + 1 == x; }

template <class T> view<T, 4> with_w_first(const view<T, 4> &q)
{
    const auto &c = q.component;
    return {{c[3], c[0], c[1], c[2]}, q.stride};
}
template <class T> view<T, 8> with_w_first(const view<T, 8> &q)
{
    const auto &c = q.component;
    return {{c[3], c[0], c[1], c[2], c[7], c[4], c[5], c[6]}, q.stride};
}

template <class T>
mw_status convert_motor_to_pose(const view<T, 4> &quaternions, const view<T, 3> &translations, const view<const T, 8> &motors,
                        std::size_t count)
{
    if (is_wxyz(quaternions.component[3], quaternions.component[0]))
        return run_streams(kernel_id::convert_motor_to_pose_wxyz_each, into(with_w_first(quaternions), translations),
                           count, motors);
    return run_streams(kernel_id::convert_motor_to_pose_each, into(quaternions, translations), count, motors);
}

template <class T>
mw_status convert_pose_to_motor(const view<T, 8> &out, const view<const T, 4> &quaternions,
                        const view<const T, 3> &translations, std::size_t count)
{
    if (is_wxyz(quaternions.component[3], quaternions.component[0]))
        return run_streams(kernel_id::convert_pose_wxyz_to_motor_each, into(out), count, with_w_first(quaternions),
                           translations);
    return run_streams(kernel_id::convert_pose_to_motor_each, into(out), count, quaternions, translations);
}

template <class T>
mw_status convert_motor_to_dual_quaternion(const view<T, 8> &out, const view<const T, 8> &motors, std::size_t count)
{
    if (is_wxyz(out.component[3], out.component[0]))
        return run_streams(kernel_id::convert_motor_to_dual_quaternion_wxyz_each, into(with_w_first(out)), count, motors);
    return run_streams(kernel_id::convert_motor_to_dual_quaternion_each, into(out), count, motors);
}

template <class T>
mw_status convert_dual_quaternion_to_motor(const view<T, 8> &out, const view<const T, 8> &in, std::size_t count)
{
    if (is_wxyz(in.component[3], in.component[0]))
        return run_streams(kernel_id::convert_dual_quaternion_wxyz_to_motor_each, into(out), count, with_w_first(in));
    return run_streams(kernel_id::convert_dual_quaternion_to_motor_each, into(out), count, in);
}

// ----------------------------------------------------------------------------------------------------- Euler angles

// The axes of the three rotations: 0, 1, 2 for x, y, z.
struct euler_axes {
    int first, second, third;

    bool is_proper() const { return first == third; }
    // Whether the first axis, the second and the remaining one are right-handed.
    bool is_cyclic() const { return second == (first + 1) % 3; }
};
constexpr euler_axes axes_of_order[] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0},
                                        {0, 1, 0}, {0, 2, 0}, {1, 0, 1}, {1, 2, 1}, {2, 0, 2}, {2, 1, 2}};

bool is_order(mw_euler_order order) { return order >= MW_EULER_XYZ && order <= MW_EULER_ZYZ; }

// What the kernels take: three vectors, and a sign of the angles.
template <class T> struct euler_frame {
    T numbers[10] = {};

    T &axis(int k, int component) { return numbers[3 * k + component]; }
    T &sign() { return numbers[9]; }
};

template <class T>
mw_status convert_euler_to_motor(const view<T, 8> &out, const view<const T, 3> &angles, const view<const T, 3> &translations,
                         std::size_t count, mw_euler_order order)
{
    if (!is_order(order))
        return kernels() ? MW_ERROR_EULER_ORDER : MW_ERROR_ISA;
    const euler_axes axes = axes_of_order[order];
    euler_frame<T> frame;
    frame.axis(0, axes.first) = frame.axis(1, axes.second) = frame.axis(2, axes.third) = 1;
    const T *const fixed = frame.numbers;
    return run_streams_of(kernel_id::convert_euler_to_motor_each, fixed, into(out), count, angles, translations);
}

// The kernels take the first axis, the second and the remaining one to be right-handed. Where they are not, of three
// different axes all are turned round, and the angles with them; of a proper order the remaining axis is.
template <class T>
mw_status convert_motor_to_euler(const view<T, 3> &angles, const view<T, 3> &translations, const view<const T, 8> &motors,
                         std::size_t count, mw_euler_order order)
{
    if (!is_order(order))
        return kernels() ? MW_ERROR_EULER_ORDER : MW_ERROR_ISA;
    const euler_axes axes = axes_of_order[order];
    const T hand = axes.is_cyclic() ? 1 : -1;
    euler_frame<T> frame;
    frame.sign() = axes.is_proper() ? T(1) : hand;
    frame.axis(0, axes.first) = frame.axis(1, axes.second) = frame.sign();
    frame.axis(2, 3 - axes.first - axes.second) = hand;
    const T *const fixed = frame.numbers;
    return run_streams_of(axes.is_proper() ? kernel_id::convert_motor_to_euler_proper_each
                                        : kernel_id::convert_motor_to_euler_each,
                       fixed, into(angles, translations), count, motors);
}

// ----------------------------------------------------------------------------------------------- screws and rotors

template <class T>
mw_status reverse_scaled(const view<T, 8> &out, const view<const T, 8> &in, std::size_t count, T lambda, T scale)
{
    if (kernels() && !(std::isfinite(lambda) && std::isfinite(1 / lambda) && lambda != 0))
        return MW_ERROR_SCALE;
    const T *const fixed = &scale;
    return run_streams_of(kernel_id::convert_rotor_to_motor_each, fixed, into(out), count, in);
}

template <class T>
mw_status convert_motor_to_rotor(const view<T, 8> &out, const view<const T, 8> &in, std::size_t count, T lambda)
{
    return reverse_scaled(out, in, count, lambda, 1 / lambda);
}

template <class T>
mw_status convert_rotor_to_motor(const view<T, 8> &out, const view<const T, 8> &in, std::size_t count, T lambda)
{
    return reverse_scaled(out, in, count, lambda, lambda);
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/convert.inc"
