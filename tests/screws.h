// Screws to test exp, log and slerp with: bivectors and normalised motors of every angle, pitch and distance from the
// origin, most of them where the functions are hard.
#ifndef MOTORWAY_TESTS_SCREWS_H
#define MOTORWAY_TESTS_SCREWS_H

#include <array>
#include <cmath>

#include "motors.h"
#include "random.h"
#include "reference.h"

namespace motorway::testing {

constexpr long double pi = 3.141592653589793238462643383279502884L;

// A screw by half its angle: it turns by twice `angle` about an axis along `axis` through `point` and moves by twice
// `slide` along it.
struct Screw {
    reference::Vector3 axis, point;
    long double angle, slide;
};

// Half the angle of a rotation that is just below, at or just above a multiple of a quarter turn.
inline long double angle_near(Random &random, long double centre)
{
    return centre + (random.chance(8) ? 0 : random.magnitude(1e-10, 0.1));
}

// From 0 to π, so that s is of either sign: at 0 and next to it, at half turns and next to them, and anywhere.
inline long double draw_turn(Random &random)
{
    switch (random.below(8)) {
    case 0: return 0;
    case 1: return std::abs(random.magnitude(1e-30, 1));
    case 2: return angle_near(random, pi / 2);
    case 3: return pi - std::abs(random.magnitude(1e-4, 0.5));
    default: return random.uniform(0, static_cast<double>(pi));
    }
}

// Any angle at all, for exp: to a million, and close to where the rotation is 1 or -1 again.
inline long double draw_many_turns(Random &random)
{
    switch (random.below(8)) {
    case 0: return angle_near(random, pi);
    case 1: return angle_near(random, 2 * pi);
    case 2: return random.uniform(0, 20);
    case 3: return std::abs(random.magnitude(20, 1e6));
    default: return draw_turn(random);
    }
}

// In all directions, a third of them in a plane or along an axis of coordinates.
inline reference::Vector3 draw_axis(Random &random)
{
    using reference::Real;
    reference::Vector3 axis = random_unit_vector(random);
    if (!random.chance(3))
        return axis;
    axis[random.below(3)] = Real(0);
    if (random.chance(2))
        axis[random.below(3)] = Real(0);
    const Real length = reference::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (length == Real(0))
        return {Real(0), Real(0), Real(1)};
    return {axis[0] / length, axis[1] / length, axis[2] / length};
}

inline Screw draw_screw(Random &random, long double angle)
{
    Screw screw;
    screw.axis = draw_axis(random);
    const double arm = std::abs(random.magnitude(1e-3, 1e4));
    screw.point = random.chance(6) ? reference::Vector3{} : random_vector(random, arm / 10, arm);
    screw.angle = angle;
    screw.slide = random.chance(3) ? 0 : random.magnitude(1e-6, random.chance(8) ? 1e12 : 1e4);
    return screw;
}

// angle (b + (b∧q) e∞) + slide e∞ along the axis, with b = a e123: see motorway.h on exponentials.
inline reference::Bivector bivector_of(const Screw &screw)
{
    using reference::Element;
    using reference::Real;
    const Element turn = reference::rotation(screw.axis, Real(0), Real(1), screw.point);  // b + (b∧q) e∞
    const Element moved = reference::translation(screw.axis) - Element(Real(1));          // ½ a e∞
    const reference::Motor sum = reference::motor(Element(Real(screw.angle)) * turn +
                                                  Element(Real(2 * screw.slide)) * moved);
    return {sum[1], sum[2], sum[3], sum[4], sum[5], sum[6]};
}

inline reference::Motor motor_of(const Screw &screw)
{
    using reference::Real;
    const Real distance(2 * screw.slide);
    const reference::Vector3 &a = screw.axis;
    return reference::motor(reference::rotation(a, Real(std::cos(screw.angle)), Real(std::sin(screw.angle)),
                                                screw.point) *
                            reference::translation({distance * a[0], distance * a[1], distance * a[2]}));
}

template <class T, std::size_t N>
void round_to(const std::array<reference::Real, N> &exact, T *components)
{
    for (std::size_t k = 0; k < N; ++k)
        components[k] = static_cast<T>(static_cast<long double>(exact[k]));
}

template <class T>
void draw_unit_motor(Random &random, T *components)
{
    round_to(motor_of(draw_screw(random, draw_turn(random))), components);
}

// The length of the vector of some components.
template <class Components>
long double length_of(const Components &components, std::size_t begin, std::size_t end)
{
    long double sum = 0;
    for (std::size_t k = begin; k < end; ++k) {
        const long double c = static_cast<long double>(components[k]);
        sum += c * c;
    }
    return std::sqrt(sum);
}

}  // namespace motorway::testing

#endif
