// Motors by the C library: one after the other, as one writes them without vectors. Functions of dual numbers
// x + y ω, ω = e123∞, are f(x) + f'(x) y ω, so that the moment costs no further call of the library. Packed alone:
// what is computed dwarfs what is moved.
#include "baseline.h"

#include <cmath>
#include <limits>

namespace motorway::bench {
namespace {

template <class T> struct bivector {
    T b12, b13, b23, b1i, b2i, b3i;
};
template <class T> struct motor {
    T s;
    bivector<T> b;
    T w;
};

// Below this the first terms of the series of a function of the square of an angle are all of it.
template <class T> const T small_square = std::sqrt(std::numeric_limits<T>::epsilon());

template <class T> T square_of_rotation(const bivector<T> &b)
{
    return b.b12 * b.b12 + b.b13 * b.b13 + b.b23 * b.b23;
}

// (real + dual ω) b
template <class T> bivector<T> scaled(T real, T dual, const bivector<T> &b)
{
    return {real * b.b12, real * b.b13, real * b.b23,
            real * b.b1i - dual * b.b23, real * b.b2i + dual * b.b13, real * b.b3i - dual * b.b12};
}

// cos θ + sin θ / θ b, with the dual angle θ² = -b².
template <class T> motor<T> exp(const bivector<T> &b)
{
    const T x = square_of_rotation(b), h = b.b12 * b.b3i - b.b13 * b.b2i + b.b23 * b.b1i;
    T cosine = 1 - x / 2, sinc = 1 - x / 6, slope = x / 30 - T(1) / 3;
    if (x > small_square<T>) {
        const T angle = std::sqrt(x), inverse = 1 / angle;
        cosine = std::cos(angle);
        sinc = std::sin(angle) * inverse;
        slope = (cosine - sinc) * inverse * inverse;
    }
    return {cosine, scaled(sinc, -slope * h, b), sinc * h};
}

// Of the motor or of its opposite, whichever turns less.
template <class T> bivector<T> log(const motor<T> &m)
{
    const T sign = std::copysign(T(1), m.s), s = std::abs(m.s), x = square_of_rotation(m.b);
    T arc = 1 + x / 6, slope = -T(1) / 3 - x * 2 / 15; // acos s / sin(acos s), and its derivative
    if (x > small_square<T>) {
        const T sine = std::sqrt(x), inverse = 1 / sine;
        arc = (s < T(0.7) ? std::acos(s) : std::asin(sine)) * inverse; // each where it loses nothing
        slope = (s * arc - 1) * inverse * inverse;
    }
    return scaled(sign * arc, slope * m.w, m.b);
}

template <class T> motor<T> product(const motor<T> &first, const motor<T> &then)
{
    const auto &[s, p, w] = first;
    const auto &[t, q, v] = then;
    return {s * t - p.b12 * q.b12 - p.b13 * q.b13 - p.b23 * q.b23,
            {s * q.b12 + p.b12 * t - p.b13 * q.b23 + p.b23 * q.b13,
             s * q.b13 + p.b13 * t + p.b12 * q.b23 - p.b23 * q.b12,
             s * q.b23 + p.b23 * t - p.b12 * q.b13 + p.b13 * q.b12,
             s * q.b1i + p.b1i * t + p.b12 * q.b2i - p.b2i * q.b12 + p.b13 * q.b3i - p.b3i * q.b13 - p.b23 * v -
                 w * q.b23,
             s * q.b2i + p.b2i * t - p.b12 * q.b1i + p.b1i * q.b12 + p.b23 * q.b3i - p.b3i * q.b23 + p.b13 * v +
                 w * q.b13,
             s * q.b3i + p.b3i * t - p.b13 * q.b1i + p.b1i * q.b13 - p.b23 * q.b2i + p.b2i * q.b23 - p.b12 * v -
                 w * q.b12},
            s * v + w * t + p.b12 * q.b3i + p.b3i * q.b12 - p.b13 * q.b2i - p.b2i * q.b13 + p.b23 * q.b1i +
                p.b1i * q.b23};
}

template <class T> motor<T> reverse(const motor<T> &m) { return {m.s, scaled(T(-1), T(0), m.b), m.w}; }

// The scalar and the e123∞ part of the reverse of one, and then another.
template <class T> T ratio_s(const motor<T> &m, const motor<T> &n)
{
    return m.s * n.s + m.b.b12 * n.b.b12 + m.b.b13 * n.b.b13 + m.b.b23 * n.b.b23;
}
template <class T> T ratio_w(const motor<T> &m, const motor<T> &n)
{
    const bivector<T> &p = m.b, &q = n.b;
    return m.s * n.w + m.w * n.s - p.b12 * q.b3i - p.b3i * q.b12 + p.b13 * q.b2i + p.b2i * q.b13 - p.b23 * q.b1i -
           p.b1i * q.b23;
}

// The dual angle θ between two motors: what slerp needs of them at every parameter.
template <class T> struct angle_between {
    T cosine, sign, square, sine, inverse, angle, turn; // `turn` is the dual part

    angle_between(const motor<T> &first, const motor<T> &second)
    {
        const T s = ratio_s(first, second);
        cosine = std::abs(s), sign = std::copysign(T(1), s);
        square = (1 - cosine) * (1 + cosine);
        sine = std::sqrt(square), inverse = 1 / sine;
        angle = std::acos(cosine), turn = -sign * ratio_w(first, second) * inverse;
    }
};

// By weights: sin((1-t)θ) / sin θ and sin(tθ) / sin θ.
template <class T> motor<T> slerp(const motor<T> &first, const motor<T> &second, const angle_between<T> &between, T t)
{
    const auto &[cosine, sign, square, sine, inverse, angle, turn] = between;
    if (square < small_square<T>) // here the derivatives of the weights would be differences of all but equal numbers
        return product(first, exp(scaled(t, T(0), log(product(reverse(first), second)))));
    const T part = t * angle;
    const T c = std::cos(part), b = std::sin(part) * inverse, a = c - cosine * b;
    const T slope_b = (t * c - cosine * b) * inverse * turn;
    const T slope_a = (1 - t) * sine * b * turn - cosine * slope_b;
    const bivector<T> p = scaled(a, slope_a, first.b), q = scaled(sign * b, sign * slope_b, second.b);
    return {a * first.s + sign * b * second.s,
            {p.b12 + q.b12, p.b13 + q.b13, p.b23 + q.b23, p.b1i + q.b1i, p.b2i + q.b2i, p.b3i + q.b3i},
            a * first.w + slope_a * first.s + sign * (b * second.w + slope_b * second.s)};
}

template <class T> motor<T> slerp(const motor<T> &first, const motor<T> &second, T t)
{
    return slerp(first, second, angle_between<T>(first, second), t);
}

// De Casteljau's tableau by slerp. The angles between the controls may be known.
template <class T> struct bezier {
    const motor<T> *control;
    angle_between<T> angle[motion_degree];

    explicit bezier(const motor<T> *c) : control(c), angle{{c[0], c[1]}, {c[1], c[2]}, {c[2], c[3]}} {}

    motor<T> at(T t) const
    {
        const motor<T> a = slerp(control[0], control[1], angle[0], t), b = slerp(control[1], control[2], angle[1], t),
                       c = slerp(control[2], control[3], angle[2], t);
        return slerp(slerp(a, b, t), slerp(b, c, t), t);
    }
};
static_assert(motion_degree == 3, "the tableau is written out");

// Element i of the result from number i.
template <class Element, class T> Element *elements_of(const array<T> &a)
{
    return reinterpret_cast<Element *>(a.component()[0]);
}
template <class Result, class T, class F> work for_each_element(const problem<T> &p, F of)
{
    return make_work([=, out = elements_of<Result>(p.out[0]), count = p.count] {
        for (std::size_t i = 0; i < count; ++i)
            out[i] = of(i);
    });
}

} // namespace

template <class T> work bind_libm(const problem<T> &p)
{
    if (p.kind != layout::packed)
        return {};
    if (p.kernel == "exp_motor_each")
        return for_each_element<motor<T>>(p, [in = elements_of<const bivector<T>>(p.in[0])](std::size_t i) {
            return exp(in[i]);
        });
    if (p.kernel == "log_motor_each")
        return for_each_element<bivector<T>>(p, [in = elements_of<const motor<T>>(p.in[0])](std::size_t i) {
            return log(in[i]);
        });
    if (p.kernel == "slerp_motor_each")
        return for_each_element<motor<T>>(
            p, [first = elements_of<const motor<T>>(p.in[0]), second = elements_of<const motor<T>>(p.in[1]),
                t = elements_of<const T>(p.in[2])](std::size_t i) { return slerp(first[i], second[i], t[i]); });
    const auto *const controls = reinterpret_cast<const motor<T> *>(p.controls.data());
    if (p.kernel == "sample_multiplicative_one")
        return for_each_element<motor<T>>(
            p, [motion = bezier<T>(controls), t = elements_of<const T>(p.in[0])](std::size_t i) {
                return motion.at(t[i]);
            });
    if (p.kernel == "sample_multiplicative_each")
        return for_each_element<motor<T>>(p, [controls, t = elements_of<const T>(p.in[0])](std::size_t i) {
            return bezier<T>(controls + bezier_controls * i).at(t[i]);
        });
    return {};
}

template work bind_libm(const problem<float> &);
template work bind_libm(const problem<double> &);

} // namespace motorway::bench
