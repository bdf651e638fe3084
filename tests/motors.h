// Motors and points to test with: one regime for each way in which they are special.
#ifndef MOTORWAY_TESTS_MOTORS_H
#define MOTORWAY_TESTS_MOTORS_H

#include <array>
#include <cmath>
#include <limits>

#include "random.h"
#include "reference.h"

namespace motorway::testing {

enum class Regime {
    general,        // normalised: any rotation about any axis, offsets around 1
    identity,
    translation,
    rotation,       // about an axis through the origin
    tiny_angle,     // 1e-12 to 1e-3
    half_turn,      // s is 0 to rounding
    far,            // offsets of 1e4 to 1e6
    scaled,         // a multiple, 1e-3 to 1e3, of a normalised motor
    pseudoscalar,   // times 1 + βω: still the same motion
    scaled_pseudoscalar,
    arbitrary,      // eight numbers from [-1, 1]
    tiny_offset,    // an offset of subnormal numbers
    count
};

constexpr Regime first_that_is_not_unit = Regime::scaled;

inline Regime any_regime(Random &random)
{
    return static_cast<Regime>(random.below(static_cast<std::size_t>(Regime::count)));
}

inline Regime any_unit_regime(Random &random)
{
    return static_cast<Regime>(random.below(static_cast<std::size_t>(first_that_is_not_unit)));
}

inline reference::Vector3 random_unit_vector(Random &random)
{
    for (;;) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        const long double square = static_cast<long double>(x) * x + static_cast<long double>(y) * y +
                                   static_cast<long double>(z) * z;
        if (square > 1 || square < 0.01L)
            continue;
        const reference::Real length = reference::sqrt(reference::Real(square));
        return {reference::Real(x) / length, reference::Real(y) / length, reference::Real(z) / length};
    }
}

inline reference::Vector3 random_vector(Random &random, double low, double high)
{
    return {reference::Real(random.magnitude(low, high)), reference::Real(random.magnitude(low, high)),
            reference::Real(random.magnitude(low, high))};
}

inline reference::Element random_turn(Random &random, long double angle)
{
    return reference::rotation(random_unit_vector(random), reference::Real(std::cos(angle / 2)),
                               reference::Real(std::sin(angle / 2)), {});
}

// A turn and then a translation whose components are from `low` to `high` in magnitude.
inline reference::Element random_screw(Random &random, long double angle, double low, double high)
{
    const reference::Element turn = random_turn(random, angle);
    return turn * reference::translation(random_vector(random, low, high));
}

inline reference::Motor exact_random_motor(Random &random, Regime regime)
{
    using reference::Element;
    using reference::Real;
    constexpr double pi = 3.14159265358979323846;
    const long double angle = random.uniform(-pi, pi);
    const Element scale(Real(random.magnitude(1e-3, 1e3)));
    const Element pseudoscalar = Element(Real(1)) + Element(Real(random.uniform(-3, 3))) * reference::e("123i");
    switch (regime) {
    case Regime::general: return motor(random_screw(random, angle, 0.1, 3));
    case Regime::identity: return motor(Element(Real(random.chance(2) ? -1 : 1)));
    case Regime::translation: return motor(reference::translation(random_vector(random, 0.1, 10)));
    case Regime::rotation: return motor(random_turn(random, angle));
    case Regime::tiny_angle: return motor(random_screw(random, random.magnitude(1e-12, 1e-3), 0.1, 3));
    case Regime::half_turn: return motor(random_screw(random, pi, 0.1, 3));
    case Regime::far: return motor(random_screw(random, angle, 1e4, 1e6));
    case Regime::scaled: return motor(scale * random_screw(random, angle, 0.1, 3));
    case Regime::pseudoscalar: return motor(random_screw(random, angle, 0.1, 3) * pseudoscalar);
    case Regime::scaled_pseudoscalar: return motor(scale * random_screw(random, angle, 0.1, 3) * pseudoscalar);
    case Regime::tiny_offset: return motor(random_screw(random, angle, 1e-44, 1e-39));
    default: break;
    }
    reference::Motor arbitrary;
    for (Real &component : arbitrary)
        component = Real(random.uniform(-1, 1));
    return arbitrary;
}

// Rounded once to T.
template <class T>
void draw_motor(Random &random, Regime regime, T *components)
{
    const reference::Motor exact = exact_random_motor(random, regime);
    for (std::size_t k = 0; k < 8; ++k)
        components[k] = static_cast<T>(static_cast<long double>(exact[k]));
}

template <class T>
void draw_vector(Random &random, T *components)
{
    for (std::size_t k = 0; k < 3; ++k)
        components[k] = static_cast<T>(random.uniform(-2, 2));
    switch (random.below(8)) {
    case 0:  // of very different magnitudes
        for (std::size_t k = 0; k < 3; ++k)
            components[k] = static_cast<T>(random.magnitude(1e-9, 1e9));
        break;
    case 1:  // far from the origin
        for (std::size_t k = 0; k < 3; ++k)
            components[k] = static_cast<T>(random.magnitude(1e4, 1e6));
        break;
    case 2:  // on an axis
        components[random.below(3)] = 0;
        components[random.below(3)] = 0;
        break;
    case 3:  // subnormal
        components[random.below(3)] = std::numeric_limits<T>::denorm_min() * static_cast<T>(random.below(1000));
        break;
    default: break;
    }
}

}  // namespace motorway::testing

#endif
