// Inputs to measure with: screws of every angle, pitch and distance from the origin.
#ifndef MOTORWAY_TESTS_ACCURACY_INPUTS_H
#define MOTORWAY_TESTS_ACCURACY_INPUTS_H

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "numbers.h"
#include "random.h"
#include "screws.h"
#include "truth.h"

namespace motorway::accuracy {

using testing::Random;

constexpr double turn = 2 * 3.14159265358979323846;

// Where the angles of rotations come from, and how the tables name it.
struct Angles {
    std::string name;
    std::function<double(Random &)> draw;
};

inline double draw_size(Random &random, double low, double high) { return std::abs(random.magnitude(low, high)); }

inline Angles evenly(const std::string &name, double low, double high)
{
    return {name, [=](Random &random) { return random.uniform(low, high); }};
}

inline Angles logarithmically(const std::string &name, double low, double high)
{
    return {name, [=](Random &random) { return draw_size(random, low, high); }};
}

// At an angle, just below it and just above.
inline Angles around(const std::string &name, double angle)
{
    return {name, [=](Random &random) { return angle + (random.chance(8) ? 0 : random.magnitude(1e-10, 0.1)); }};
}

inline const Angles tiny_angles = logarithmically("10⁻³⁰ to 1 rad", 1e-30, 1);
inline const Angles to_a_half_turn = evenly("to a half turn", 0, turn / 2);
inline const Angles around_a_half_turn = around("at and around a half turn", turn / 2);
inline const Angles to_a_turn = evenly("to a full turn", 0, turn);
inline const Angles around_a_turn = around("at and around a full turn", turn);
inline const Angles around_two_turns = around("at and around two turns", 2 * turn);
inline const Angles a_half_to_two_turns = evenly("a half turn to two turns", turn / 2, 2 * turn);
inline const Angles two_to_many_turns = logarithmically("two turns to 10⁶ rad", 2 * turn, 1e6);
inline const Angles nothing = {"0: translations, 1 and -1", [](Random &) { return 0; }};

using Direction = std::array<double, 3>;

inline Direction draw_direction(Random &random)
{
    const reference::Vector3 axis = testing::draw_axis(random);
    Direction direction;
    for (std::size_t k = 0; k < 3; ++k)
        direction[k] = static_cast<double>(static_cast<long double>(axis[k]));
    return direction;
}

// How far motions lie from the origin and reach along their axes.
struct Lengths {
    double shortest, longest, longest_slide;
};
constexpr Lengths all_lengths = {1e-3, 1e4, 1e12};
constexpr Lengths usual_lengths = {1e-3, 1e4, 1e4};

// The generator of a screw by `angle`: about an axis as far from the origin as `lengths` say, or in a quarter of all
// cases as far as it takes to move the origin that much; with no pitch in a third of them, and else any.
inline Bivector<double> draw_generator(Random &random, double angle, const Lengths &lengths = all_lengths)
{
    const Direction a = draw_direction(random), q = draw_direction(random);
    const double half = angle / 2;
    const double arm = random.chance(6) ? 0 : draw_size(random, lengths.shortest, lengths.longest);
    const double across = random.chance(4) ? arm : half * arm;
    const double furthest = random.chance(8) ? lengths.longest_slide : lengths.longest;
    const double along = random.chance(3) ? 0 : random.magnitude(1e-3 * lengths.shortest, furthest);
    return {half * a[2], -half * a[1], half * a[0],
            across * (a[1] * q[2] - a[2] * q[1]) + along * a[0],
            across * (a[2] * q[0] - a[0] * q[2]) + along * a[1],
            across * (a[0] * q[1] - a[1] * q[0]) + along * a[2]};
}

template <class T, class R, std::size_t N>
void round_to(const std::array<R, N> &exact, T *components)
{
    for (std::size_t k = 0; k < N; ++k)
        components[k] = static_cast<T>(exact[k]);
}

inline Motor<Quad> draw_exact_motor(Random &random, double angle, const Lengths &lengths = all_lengths)
{
    return exp(exactly<Quad, 6>(draw_generator(random, angle, lengths).data()));
}

}  // namespace motorway::accuracy

#endif
