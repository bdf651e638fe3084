// A motor as other libraries hold it: a rotation matrix or a unit quaternion, with a translation; or a dual
// quaternion.
#pragma once

#include <array>
#include <cmath>

namespace motorway::bench {

struct rigid {
    double quaternion[4]; // w x y z
    double translation[3];
    double rotation[3][3];
};

// The dual quaternion r + ε d that moves points as a motor does: w x y z of r, then of d. And back.
template <class T> std::array<T, 8> dual_quaternion_of(const std::array<T, 8> &m)
{
    return {m[0], m[3], -m[2], m[1], -m[7], m[4], m[5], m[6]};
}
template <class T> std::array<T, 8> motor_of(const std::array<T, 8> &q)
{
    return {q[0], q[3], -q[2], q[1], q[5], q[6], q[7], -q[4]};
}

inline rigid rigid_of(const std::array<double, 8> &motor)
{
    const auto [w, x, y, z, dw, dx, dy, dz] = dual_quaternion_of(motor);
    const double alpha = w * w + x * x + y * y + z * z, k = 2 / alpha, length = std::sqrt(alpha);
    return {{w / length, x / length, y / length, z / length},
            {k * (w * dx - x * dw + y * dz - z * dy), k * (w * dy - y * dw + z * dx - x * dz),
             k * (w * dz - z * dw + x * dy - y * dx)},
            {{1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y)},
             {k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x)},
             {k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y)}}};
}

} // namespace motorway::bench
