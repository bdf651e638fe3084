// Wareham and Lasenby's parts of a generator, and its motion in closed form. Scalar, in double.
#include "motorway.h"
#include "scalar_math.h"

#include <cmath>

namespace motorway {
namespace {

constexpr double unit_tolerance = 1.0 / 1024; // of the length of an axis

struct vector3 {
    double x, y, z;
};
vector3 operator+(const vector3 &a, const vector3 &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
vector3 operator-(const vector3 &a, const vector3 &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
vector3 operator*(double a, const vector3 &b) { return {a * b.x, a * b.y, a * b.z}; }
double dot(const vector3 &a, const vector3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vector3 cross(const vector3 &a, const vector3 &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const vector3 &a) { return length_of(a.x, a.y, a.z); }
bool is_finite(const vector3 &a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

template <class T> vector3 vector_of(const T (&v)[3]) { return {v[0], v[1], v[2]}; }
template <class T> void assign(T *to, const vector3 &v)
{
    to[0] = static_cast<T>(v.x), to[1] = static_cast<T>(v.y), to[2] = static_cast<T>(v.z);
}

// Of length 1. Of very short and very long vectors the inverse of the length would not be a normal number, nor would
// that of a short one have all its digits.
vector3 direction(const vector3 &a)
{
    const double size = std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
    const vector3 b = (size < 0x1p-500 ? 0x1p+600 : size > 0x1p+500 ? 0x1p-600 : 1) * a;
    return (1 / length(b)) * b;
}

template <class T, class Twist> mw_status split_bivector(Twist *out, const T *b)
{
    if (!out || !b)
        return MW_ERROR_NULL;
    const vector3 turn = {b[2], -double(b[1]), b[0]}, moment = {b[3], b[4], b[5]};
    if (!is_finite(turn) || !is_finite(moment))
        return MW_ERROR_AXIS;
    const double half_angle = length(turn);
    const vector3 axis = half_angle > 0 ? direction(turn) : vector3{0, 0, 1};
    const vector3 along = 2 * dot(axis, moment) * axis;
    assign(out->axis, axis);
    out->angle = static_cast<T>(2 * half_angle);
    assign(out->along, along);
    assign(out->across, 2 * moment - along);
    return MW_OK;
}

template <class Twist> mw_status check_twist(const Twist *twist, double lambda)
{
    if (!twist)
        return MW_ERROR_NULL;
    const vector3 axis = vector_of(twist->axis);
    const bool finite = is_finite(vector_of(twist->along)) && is_finite(vector_of(twist->across)) &&
                        std::isfinite(twist->angle) && std::isfinite(lambda);
    return finite && std::fabs(length(axis) - 1) <= unit_tolerance ? MW_OK : MW_ERROR_AXIS;
}

// sin x / x, of the sine that is known.
double sinc(double x, double sine) { return x == 0 ? 1 : sine / x; }

// exp(λB) = τ + sinc(λψ/2) λ across e∞ / 2, with the twist τ = (cos λψ/2 + sin λψ/2 axis e123)(1 + λ along e∞ / 2).
template <class T, class Motor, class Twist> mw_status twist_pose(Motor *out, const Twist *twist, T lambda)
{
    const mw_status status = out ? check_twist(twist, lambda) : MW_ERROR_NULL;
    if (status != MW_OK)
        return status;
    const double half = double(lambda) * twist->angle / 2;
    const auto [s, c] = sine_and_cosine(half);
    const vector3 axis = vector_of(twist->axis), along = vector_of(twist->along), across = vector_of(twist->across);
    const vector3 ideal = lambda / 2.0 * (c * along + sinc(half, s) * across);
    const double w = lambda / 2.0 * s * dot(axis, along);
    const double numbers[8] = {c, s * axis.z, -s * axis.y, s * axis.x, ideal.x, ideal.y, ideal.z, w};
    T *const component = reinterpret_cast<T *>(out);
    for (int k = 0; k < 8; ++k)
        component[k] = static_cast<T>(numbers[k]);
    return MW_OK;
}

// r_λ: `across` turned by half the angle and shortened by the sinc of it, and λ along.
template <class T, class Twist> mw_status twist_position(T *out, const Twist *twist, T lambda)
{
    const mw_status status = out ? check_twist(twist, lambda) : MW_ERROR_NULL;
    if (status != MW_OK)
        return status;
    const double half = double(lambda) * twist->angle / 2;
    const vector3 axis = vector_of(twist->axis), along = vector_of(twist->along), across = vector_of(twist->across);
    const auto [s, c] = sine_and_cosine(half);
    const vector3 turned = c * across + s * cross(axis, across);
    assign(out, double(lambda) * (sinc(half, s) * turned + along));
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/twist.inc"
