// Inputs: numbers of every exponent, angles that are hard to reduce, and motors in all the ways that they can be near
// the edge of something.
#ifndef MOTORWAY_TESTS_FUZZ_DRAW_H
#define MOTORWAY_TESTS_FUZZ_DRAW_H

#include <cstddef>
#include <limits>

#include "exact.h"
#include "random.h"

namespace motorway::fuzz {

using testing::Random;

template <class T>
class Draw {
public:
    using R = Wide<T>;
    using Limits = std::numeric_limits<T>;

    explicit Draw(Random &random) : random_(random) {}

    bool chance(std::size_t one_in) { return random_.chance(one_in); }
    std::size_t below(std::size_t bound) { return random_.below(bound); }
    double uniform(double low, double high) { return random_.uniform(low, high); }
    int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1))); }

    // 1 to 2 in size, of either sign: half of them of few bits.
    T mantissa()
    {
        const double fraction = chance(2) ? uniform(0, 1) : static_cast<double>(below(8)) / 8;
        const T size = chance(8) ? 2 - Limits::epsilon() : chance(8) ? 1 + Limits::epsilon() : T(1 + fraction);
        return chance(2) ? size : -size;
    }

    // The exponent evenly between these.
    T power_of_two(int low, int high) { return std::scalbn(mantissa(), between(low, high)); }
    T any() { return power_of_two(Limits::min_exponent - Limits::digits - 1, Limits::max_exponent - 1); }
    T usual() { return power_of_two(-10, 12); }

    T special()
    {
        const T numbers[] = {0,
                             T(-0.0),
                             1,
                             -1,
                             1 + Limits::epsilon(),
                             1 - Limits::epsilon() / 2,
                             Limits::min(),
                             Limits::denorm_min(),
                             Limits::max(),
                             Limits::lowest(),
                             Limits::min() / 2,
                             T(0.5)};
        return numbers[below(sizeof numbers / sizeof numbers[0])];
    }

    T not_finite() { return chance(2) ? Limits::quiet_NaN() : chance(2) ? Limits::infinity() : -Limits::infinity(); }

    // Mostly usual numbers.
    T number()
    {
        const std::size_t kind = below(16);
        return kind < 11 ? usual() : kind < 14 ? any() : kind < 15 ? special() : T(0);
    }

    // Of every size, near multiples of a quarter turn and not.
    T angle()
    {
        const T sign = chance(2) ? T(1) : T(-1);
        switch (below(8)) {
        case 0: return sign * static_cast<T>(uniform(0, 2 * 3.14159265358979));
        case 1: return sign * static_cast<T>(uniform(0, 100));
        case 2: return sign * near_multiple(static_cast<double>(below(9)));
        case 3: return sign * near_multiple(std::floor(std::exp2(uniform(0, Limits::digits - 1))));
        case 4: return sign * hard_angle();
        case 5: return any();
        case 6: return power_of_two(0, 80);
        default: return special();
        }
    }

    // A unit vector: in any direction, near an axis of coordinates or a plane of them, or in it.
    Vector<R> axis()
    {
        R v[3];
        for (R &component : v) {
            component = R(uniform(-1, 1));
            if (chance(6))
                component *= R(std::scalbn(1.0, -between(1, 60)));
            if (chance(6))
                component = 0;
        }
        if (chance(6))
            v[0] = v[1] = v[2] = 0;
        const std::size_t k = below(3);
        if (abs(v[k]) < R(0.01))
            v[k] = chance(2) ? R(1) : R(-1);
        const Vector<R> direction{v[0], v[1], v[2]};
        return R(1 / length(direction)) * direction;
    }

    // How far something moves. Squares of it do not overflow in a product with a few others, but for the `far` ones.
    R distance()
    {
        switch (below(8)) {
        case 0: return 0;
        case 1: return R(power_of_two(-Limits::max_exponent / 2, Limits::max_exponent / 2 - 4));
        case 2: return R(power_of_two(10, 40));
        default: return R(usual());
        }
    }

    // Half of an angle of rotation within two turns: anything, near a multiple of a quarter turn, or tiny.
    R half_turn()
    {
        switch (below(6)) {
        case 0: return R(power_of_two(Limits::min_exponent - Limits::digits, 0));
        case 1:
        case 2: {
            const R near = pi<R>() / 4 * R(static_cast<int>(below(9)));
            return chance(4) ? near : near + R(power_of_two(-2 * Limits::digits, -2));
        }
        case 3: return R(uniform(0, 1e-2));
        default: return R(uniform(-1, 1)) * pi<R>();
        }
    }

    Motor<R> unit_motor()
    {
        const Quaternion<R> r = chance(24) ? Quaternion<R>{axis(), R(0)} : turn_about(axis(), half_turn());
        if (chance(3)) {  // about an axis that is so far away
            const Motor<R> there = translator(distance() * axis());
            const Motor<R> turned = compose(compose(conjugate(there), Motor<R>{r, {}}), there);
            if (chance(2))
                return turned;
            const R size = length(r.v);
            return size == 0 ? turned : compose(turned, translator(R(distance() / size) * r.v));
        }
        return pose(r, distance() * axis());
    }

    // Normalised up to rounding, of either sign, also of that of a zero.
    void unit_motor(T *components)
    {
        R exact[8];
        do {
            components_of(unit_motor(), exact);
            round_to(components, exact, 8);
        } while (!finite(components, 8));
        if (chance(2))
            for (int k = 0; k < 8; ++k)
                components[k] = -components[k];
    }

    // Any motor whose α is legal: in three of eight normalised, or off it by any factor, or with a pseudoscalar part,
    // or of components of any size.
    void motor(T *components)
    {
        const std::size_t kind = below(8);
        if (kind < 3)
            return unit_motor(components);
        R exact[8];
        do {
            if (kind == 7) {
                for (int k = 0; k < 8; ++k)
                    components[k] = k < 4 ? power_of_two(Limits::min_exponent / 2, Limits::max_exponent / 2 - 2)
                                          : number();
                continue;
            }
            Motor<R> m = unit_motor();
            if (kind > 4)
                m.d = m.d + R(usual()) * m.r;
            const int half = Limits::max_exponent / 2;
            components_of(R(kind == 3 ? usual() : power_of_two(-half + 2, half - 1)) * m, exact);
            round_to(components, exact, 8);
        } while (!finite(components, 8) || !legal(components));
    }

    // The generator of a screw by an angle of any size.
    void bivector(T *components)
    {
        const R half = chance(2) ? half_turn() : R(angle()) / (chance(2) ? 2 : 1);
        const Vector<R> direction = axis();
        Motor<R> b{{half * direction, R(0)}, {distance() * axis(), R(0)}};
        if (chance(3))
            b.d.v = distance() * direction;
        R exact[6];
        bivector_components_of(b, exact);
        round_to(components, exact, 6);
        if (chance(16))
            for (int k = 0; k < 3; ++k)
                components[k] = any();
        for (int k = 0; k < 6; ++k)
            if (!std::isfinite(components[k]))
                components[k] = usual();
    }

    void vector(T *components, std::size_t count)
    {
        const bool alike = chance(4);
        const T one = any();
        for (std::size_t k = 0; k < count; ++k)
            components[k] = alike ? one * T(0.25) * mantissa() : number();
    }

    // In a small part of the inputs a number that is none: it must stay in its element.
    void spoil(T *components, std::size_t count)
    {
        if (chance(100))
            components[below(count)] = not_finite();
    }

    static void round_to(T *components, const R *exact, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k)
            components[k] = static_cast<T>(exact[k]);
    }

    static bool finite(const T *components, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k)
            if (!std::isfinite(components[k]))
                return false;
        return true;
    }

    // Whether α is one that the library takes, whichever way its last bits are rounded.
    static bool legal(const T *components)
    {
        const R square = alpha(motor_of<R>(components)), margin = 1 + 8 * epsilon<T>();
        return square >= R(Limits::min()) * margin && square * margin <= R(Limits::max());
    }

private:
    T near_multiple(double count)
    {
        T near = static_cast<T>(R(count) * pi<R>() / 2);
        for (std::size_t steps = below(3); steps > 0; --steps)
            near = std::nextafter(near, chance(2) ? Limits::infinity() : T(0));
        return near;
    }

    // As near to a multiple of a quarter turn as numbers of its exponent come: m 2^e, where m is the denominator of a
    // convergent of the continued fraction of 2^e / (π/2).
    T hard_angle()
    {
        const Quad unit = scaled(Quad(1), between(0, Limits::max_exponent - Limits::digits));
        Quad rest = abs(Quad(atan2(sin(unit), cos(unit)) / (pi<Quad>() / 2)));
        const Quad most = scaled(Quad(1), Limits::digits);
        Quad before = 0, last = 1;
        rest -= Quad(static_cast<long long>(rest));
        for (int k = 0; k < 64 && rest > scaled(Quad(1), -100); ++k) {
            const Quad inverse = 1 / rest;
            if (inverse > most)
                break;
            const Quad whole = Quad(static_cast<long long>(inverse));
            const Quad next = whole * last + before;
            if (next >= most)
                break;
            before = last, last = next;
            rest = inverse - whole;
        }
        return static_cast<T>((chance(3) ? before : last) * unit);
    }

    Random &random_;
};

}  // namespace motorway::fuzz

#endif
