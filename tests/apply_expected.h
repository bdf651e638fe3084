// What becomes of an element under a motor, exactly, and how far from it a kernel may be: for every operand the sum
// of the magnitudes of the terms that any way to compute it adds up, times the roundings that each goes through.
//
// In terms of vectors the motion is p -> R p + t with
//     R p = p + 2/α (s c + q × c),  c = q × p,                q = (b23, b13, b12),
//     t = 2/α (s d + q × d + w q),                            d = (b1i, b2i, b3i),
// signs aside, which have no part here. A magnitude is that of all terms, multiplied out or not.
#ifndef MOTORWAY_TESTS_APPLY_EXPECTED_H
#define MOTORWAY_TESTS_APPLY_EXPECTED_H

#include <algorithm>
#include <array>
#include <cmath>

#include "apply_api.h"
#include "reference.h"
#include "subject.h"

namespace motorway::testing {

enum class Motors { any, unit };

using Sizes = std::array<long double, 3>;

inline Sizes operator+(const Sizes &a, const Sizes &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Sizes operator*(long double k, const Sizes &a) { return {k * a[0], k * a[1], k * a[2]}; }
inline long double dot(const Sizes &a, const Sizes &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Sizes cross(const Sizes &a, const Sizes &b)
{
    return {a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]};
}

template <class T>
Sizes sizes_of(const T *v)
{
    return {std::abs(static_cast<long double>(v[0])), std::abs(static_cast<long double>(v[1])),
            std::abs(static_cast<long double>(v[2]))};
}

class Magnitudes {
public:
    template <class M>
    explicit Magnitudes(const M *motor)
        : s_(std::abs(static_cast<long double>(motor[0]))), w_(std::abs(static_cast<long double>(motor[7]))),
          d_(sizes_of(motor + 4))
    {
        const M q[] = {motor[3], motor[2], motor[1]};
        q_ = sizes_of(q);
        alpha_ = s_ * s_ + dot(q_, q_);
        two_over_alpha_ = 2 / alpha_;
        beta_ = 2 * (s_ * w_ + dot(q_, d_));
    }

    long double alpha() const { return alpha_; }
    long double beta() const { return beta_ / alpha_; }  // of a motor divided by √α

    Sizes turned(const Sizes &p) const
    {
        const Sizes c = cross(q_, p);
        return p + two_over_alpha_ * (s_ * c + cross(q_, c));
    }

    Sizes offset() const { return two_over_alpha_ * (s_ * d_ + cross(q_, d_) + w_ * q_); }

    // t × R a, which the moment of a line grows by: as that product, and as the derivative of R a in the direction
    // (w, d) of (s, q), less β/α times R a, which is there if the motor is not normalised.
    Sizes arm(const Sizes &a) const
    {
        const Sizes c = cross(q_, a), derivative = cross(d_, a);
        return cross(offset(), turned(a)) + beta() * turned(a) +
               two_over_alpha_ * (w_ * c + s_ * derivative + cross(d_, c) + cross(q_, derivative));
    }

    // t · R p, which is also p times the translation of the reverse motion: its terms are those of t.
    long double along(const Sizes &p) const { return dot(offset(), turned(p)) + dot(offset(), p); }

    // ½ t², as that and as 2 (d² + w²)/α - ½ (β/α)².
    long double half_square() const
    {
        return dot(offset(), offset()) / 2 + two_over_alpha_ * (dot(d_, d_) + w_ * w_) + beta() * beta() / 2;
    }

private:
    long double s_, w_;
    Sizes q_, d_;
    long double alpha_, two_over_alpha_, beta_;
};

// The exact components of the result and what their errors are relative to.
struct Moving {
    std::vector<reference::Real> value;
    std::vector<long double> magnitude;
    std::vector<int> roundings;  // that a term of the component goes through, at most; 0 if it is only copied
    // What the promise of a normalised motor leaves out, relative to the magnitude or absolutely, where it is none.
    std::vector<long double> pseudoscalar;

    template <std::size_t N>
    void add(const std::array<reference::Real, N> &values, const std::array<long double, N> &magnitudes,
             int count_of_roundings, const std::array<long double, N> &promised = {})
    {
        value.insert(value.end(), values.begin(), values.end());
        magnitude.insert(magnitude.end(), magnitudes.begin(), magnitudes.end());
        roundings.insert(roundings.end(), N, count_of_roundings);
        pseudoscalar.insert(pseudoscalar.end(), promised.begin(), promised.end());
    }

    template <class T>
    void copy(T component)
    {
        add<1>({reference::Real(component)}, {0.0L}, 0);
    }
};

// A point or a direction: 3 roundings in c, 4 in the sum over c, 4 in α, a division, a product and the last sum.
constexpr int roundings_of_points = 14;
// Moments and the e∞ part of vectors: a coefficient of R has 9, of t 10, so one of their product 10 + 9 + 2 in the
// sum that it is; and then a sum of six.
constexpr int roundings_of_products = 27;

// The line with this direction and moment; motors have one in them too. `beta` is the exact β/α.
inline void add_line(Moving &moving, const Magnitudes &magnitudes, const reference::Line &image,
                     const Sizes &direction, const Sizes &moment, long double beta)
{
    const Sizes turned = magnitudes.turned(direction);
    moving.add<3>({image[0], image[1], image[2]}, turned, roundings_of_points);
    moving.add<3>({image[3], image[4], image[5]}, magnitudes.turned(moment) + magnitudes.arm(direction),
                  roundings_of_products, beta * turned);
}

// The bivector part of a motor: a line whose direction is in the opposite order.
template <class T>
void add_bivector(Moving &moving, const Magnitudes &magnitudes, const reference::Motor &image, const T *bivector,
                  long double beta)
{
    const T direction[] = {bivector[2], bivector[1], bivector[0]};
    Moving line;
    add_line(line, magnitudes, {image[3], image[2], image[1], image[4], image[5], image[6]}, sizes_of(direction),
             sizes_of(bivector + 3), beta);
    for (std::size_t k : {2, 1, 0, 3, 4, 5})
        moving.add<1>({line.value[k]}, {line.magnitude[k]}, line.roundings[k], {line.pseudoscalar[k]});
}

template <class M, class T>
Moving moving_of(const M *components, const reference::Square &square, const T *element, Moved moved,
                 const mw_shift *shift)
{
    using reference::Real;
    const reference::Motor motor = exact_motor(components);
    const Magnitudes magnitudes(components);
    const long double beta = static_cast<long double>(reference::abs(square.beta / square.alpha));
    const auto turned = [&](const T *v) {
        return std::pair(reference::apply_direction(motor, exact_vector(v)), magnitudes.turned(sizes_of(v)));
    };
    Moving moving;
    switch (moved) {
    case Moved::point:
    case Moved::vertex: {
        reference::Vector3 p = exact_vector(element), after{};
        Sizes size = sizes_of(element), after_size{};
        if (shift) {
            for (std::size_t i = 0; i < 3; ++i)
                p[i] = p[i] - Real(shift->before[i]), after[i] = Real(shift->after[i]);
            size = size + sizes_of(shift->before), after_size = sizes_of(shift->after);
        }
        reference::Vector3 image = reference::apply_point(motor, p);
        for (std::size_t i = 0; i < 3; ++i)
            image[i] = image[i] + after[i];
        // The shift is two sums more.
        moving.add<3>(image, magnitudes.turned(size) + magnitudes.offset() + after_size,
                      roundings_of_points + (shift ? 2 : 0));
        if (moved == Moved::vertex) {
            const auto [normal, normal_size] = turned(element + 3);
            moving.add<3>(normal, normal_size, roundings_of_points);
        }
        break;
    }
    case Moved::direction:
    case Moved::tangent: {
        const auto [image, size] = turned(element);
        moving.add<3>(image, size, roundings_of_points);
        if (moved == Moved::tangent)
            moving.copy(element[3]);
        break;
    }
    case Moved::vector: {
        const reference::Vector5 image = reference::apply_vector(motor, exact_numbers<5>(element));
        const Sizes p = sizes_of(element + 1);
        const long double e0 = std::abs(static_cast<long double>(element[0]));
        const long double ei = std::abs(static_cast<long double>(element[4]));
        moving.copy(element[0]);
        moving.add<3>({image[1], image[2], image[3]}, magnitudes.turned(p) + e0 * magnitudes.offset(),
                      roundings_of_points);
        moving.add<1>({image[4]}, {ei + magnitudes.along(p) + e0 * magnitudes.half_square()}, roundings_of_products,
                      {e0 * beta * beta});
        break;
    }
    case Moved::line: {
        const reference::Line image = reference::apply_line(motor, exact_numbers<6>(element));
        add_line(moving, magnitudes, image, sizes_of(element), sizes_of(element + 3), beta);
        break;
    }
    case Moved::motor: {
        // s and w e123∞ commute with every motor.
        moving.copy(element[0]);
        add_bivector(moving, magnitudes, reference::apply_motor(motor, exact_motor(element)), element + 1, beta);
        moving.copy(element[7]);
        break;
    }
    case Moved::bivector: {
        reference::Motor moved_motor{};
        std::copy_n(exact_bivector(element).begin(), 6, moved_motor.begin() + 1);
        add_bivector(moving, magnitudes, reference::apply_motor(motor, moved_motor), element, beta);
        break;
    }
    }
    return moving;
}

// An error is at most ½ε times the roundings times the magnitude; two roundings more are for those of second order.
// Underflow adds at most half the smallest subnormal in each of some 16 operations, before a division by α or after,
// and what comes of it is then multiplied by the numbers of the element or of the motion. In mixed precision all of
// that is in double, and then comes one rounding to float.
template <class M, class T>
Expected expect_moved(const M *motor, const T *element, Moved moved, Motors motors, const mw_shift *shift = nullptr)
{
    const reference::Square square = reference::square(exact_motor(motor));
    const Moving moving = moving_of(motor, square, element, moved, shift);
    const Magnitudes magnitudes(motor);
    const std::size_t components = moving.value.size();
    const long double small_alpha = std::min(1.0L, magnitudes.alpha());
    // The unit forms take α for 1 and β for 0: that is an error in the input, not in the arithmetic.
    const reference::Real not_unit = reference::abs(square.alpha - reference::Real(1));
    const long double promised = motors == Motors::unit ? static_cast<long double>(not_unit) : 0;
    const Sizes offset = magnitudes.offset();
    long double size = 1 + offset[0] + offset[1] + offset[2] + size_of(element, components);
    for (std::size_t k = 0; k < 3 && shift; ++k)
        size += std::abs(shift->before[k]) + std::abs(shift->after[k]);
    const long double unit_size = size_of(motor, 8) * (1 + magnitudes.beta());
    const long double lost = reference_error(unit_size * unit_size * size);
    Expected expected;
    for (std::size_t k = 0; k < components; ++k) {
        expected.value.push_back(moving.value[k]);
        if (moving.roundings[k] == 0) {
            expected.tolerance.push_back(0);
            continue;
        }
        // What is the product of two coefficients has α in it twice.
        const bool product = moving.roundings[k] == roundings_of_products;
        const long double relative = (moving.roundings[k] + 2) * epsilon<M> / 2 + (product ? 2 : 1) * promised;
        const long double absolute = 16 * underflow<M> * (size + moving.magnitude[k]) + lost;
        long double tolerance = relative * moving.magnitude[k] +
                                absolute / (product ? small_alpha * small_alpha : small_alpha);
        if (motors == Motors::unit)
            tolerance += 1.25L * moving.pseudoscalar[k];
        if (sizeof(M) != sizeof(T))
            tolerance += epsilon<T> / 2 * (std::abs(static_cast<long double>(moving.value[k])) + tolerance) +
                         underflow<T>;
        expected.tolerance.push_back(tolerance);
    }
    return expected;
}

}  // namespace motorway::testing

#endif
