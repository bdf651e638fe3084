// What is right: motors as dual quaternions over wide numbers, by Hamilton's product and the closed forms of screws.
// Nothing here knows of the algebra that the library is generated from, nor how it computes.
#ifndef MOTORWAY_TESTS_FUZZ_EXACT_H
#define MOTORWAY_TESTS_FUZZ_EXACT_H

#include "wide.h"

namespace motorway::fuzz {

template <class R>
struct Vector {
    R x = 0, y = 0, z = 0;
};

template <class R>
Vector<R> operator+(const Vector<R> &a, const Vector<R> &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class R>
Vector<R> operator-(const Vector<R> &a, const Vector<R> &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class R>
Vector<R> operator*(R k, const Vector<R> &a) { return {k * a.x, k * a.y, k * a.z}; }
template <class R>
R dot(const Vector<R> &a, const Vector<R> &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class R>
R length(const Vector<R> &a) { return sqrt(dot(a, a)); }
template <class R>
Vector<R> cross(const Vector<R> &a, const Vector<R> &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class R>
struct Quaternion {
    Vector<R> v;
    R w = 0;
};

template <class R>
Quaternion<R> operator+(const Quaternion<R> &a, const Quaternion<R> &b) { return {a.v + b.v, a.w + b.w}; }
template <class R>
Quaternion<R> operator*(R k, const Quaternion<R> &a) { return {k * a.v, k * a.w}; }
template <class R>
Quaternion<R> operator*(const Quaternion<R> &a, const Quaternion<R> &b)
{
    return {a.w * b.v + b.w * a.v + cross(a.v, b.v), a.w * b.w - dot(a.v, b.v)};
}
template <class R>
R dot(const Quaternion<R> &a, const Quaternion<R> &b) { return dot(a.v, b.v) + a.w * b.w; }
template <class R>
R length(const Quaternion<R> &a) { return sqrt(dot(a, a)); }
template <class R>
Quaternion<R> conjugate(const Quaternion<R> &a) { return {R(-1) * a.v, a.w}; }

// r + εd with d = ½ t r: it rotates by r and then moves by t.
template <class R>
struct Motor {
    Quaternion<R> r, d;
};

// docs/conventions.md: r = (b23, -b13, b12; s) and d = (b1i, b2i, b3i; -w).
template <class R, class T>
Motor<R> motor_of(const T *m)
{
    return {{{R(m[3]), -R(m[2]), R(m[1])}, R(m[0])}, {{R(m[4]), R(m[5]), R(m[6])}, -R(m[7])}};
}
template <class R>
void components_of(const Motor<R> &m, R *components)
{
    const R all[] = {m.r.w, m.r.v.z, -m.r.v.y, m.r.v.x, m.d.v.x, m.d.v.y, m.d.v.z, -m.d.w};
    for (int k = 0; k < 8; ++k)
        components[k] = all[k];
}
// Of a bivector: b12 b13 b23 b1i b2i b3i.
template <class R, class T>
Motor<R> bivector_of(const T *b)
{
    return {{{R(b[2]), -R(b[1]), R(b[0])}, R(0)}, {{R(b[3]), R(b[4]), R(b[5])}, R(0)}};
}
template <class R>
void bivector_components_of(const Motor<R> &b, R *components)
{
    const R all[] = {b.r.v.z, -b.r.v.y, b.r.v.x, b.d.v.x, b.d.v.y, b.d.v.z};
    for (int k = 0; k < 6; ++k)
        components[k] = all[k];
}
template <class R, class T>
Vector<R> vector_of(const T *v)
{
    return {R(v[0]), R(v[1]), R(v[2])};
}

template <class R>
Motor<R> operator*(R k, const Motor<R> &m) { return {k * m.r, k * m.d}; }
template <class R>
Motor<R> operator+(const Motor<R> &a, const Motor<R> &b) { return {a.r + b.r, a.d + b.d}; }
template <class R>
Motor<R> conjugate(const Motor<R> &m) { return {conjugate(m.r), conjugate(m.d)}; }

// The right factor of a product of dual quaternions acts first.
template <class R>
Motor<R> compose(const Motor<R> &first, const Motor<R> &then)
{
    return {then.r * first.r, then.r * first.d + then.d * first.r};
}

template <class R>
R alpha(const Motor<R> &m) { return dot(m.r, m.r); }

// Divided by the dual number |r| + ε (r·d) / |r|.
template <class R>
Motor<R> normalized(const Motor<R> &m)
{
    const R size = length(m.r);
    const R part = dot(m.r, m.d) / (size * size);
    return R(1 / size) * Motor<R>{m.r, m.d + (-part) * m.r};
}

// The conjugate over the dual number |r|² + 2ε (r·d).
template <class R>
Motor<R> inverse(const Motor<R> &m)
{
    const R square = alpha(m);
    const Motor<R> c = conjugate(m);
    return R(1 / square) * Motor<R>{c.r, c.d + (-2 * dot(m.r, m.d) / square) * c.r};
}

template <class R>
Vector<R> rotate(const Motor<R> &m, const Vector<R> &p)
{
    return R(1 / alpha(m)) * (m.r * Quaternion<R>{p, 0} * conjugate(m.r)).v;
}
template <class R>
Vector<R> translation(const Motor<R> &m)
{
    return R(2 / alpha(m)) * (m.d * conjugate(m.r)).v;
}
template <class R>
Motor<R> translator(const Vector<R> &t)
{
    return {{{}, R(1)}, {R(0.5) * t, R(0)}};
}
// r and then a translation by t.
template <class R>
Motor<R> pose(const Quaternion<R> &r, const Vector<R> &t)
{
    return {r, R(0.5) * (Quaternion<R>{t, 0} * r)};
}
template <class R>
Quaternion<R> turn_about(const Vector<R> &axis, R half_angle)
{
    return {sin(half_angle) * axis, cos(half_angle)};
}

// sin x / x, and (cos x - sin x / x) / x², which is its slope over x. Both of x² near 0, as power series.
template <class R>
struct Sinc {
    R value, slope;
};
template <class R>
Sinc<R> sinc(R x)
{
    const R square = x * x;
    if (square > R(0.25))
        return {sin(x) / x, (cos(x) - sin(x) / x) / square};
    Sinc<R> result{0, 0};
    R term = 1;  // (-x²)^k / (2k + 1)!
    for (int k = 0; k < 18; ++k) {
        result.value += term;
        term *= -square / R((2 * k + 2) * (2 * k + 3));
        result.slope += square == 0 ? R(k == 0 ? -1 : 0) / 3 : R(2 * k + 2) * term / square;
    }
    return result;
}

// Of a vector v + εm: cos + sinc (v + εm), and its derivative in the direction of m.
template <class R>
Motor<R> exp(const Motor<R> &b)
{
    const R size = length(b.r.v), along = dot(b.r.v, b.d.v);
    const Sinc<R> s = sinc(size);
    return {{s.value * b.r.v, cos(size)}, {s.value * b.d.v + (along * s.slope) * b.r.v, -s.value * along}};
}

enum class Way { shortest, principal };  // of m or of -m, whichever turns by no more than a half turn; or of m itself

template <class R>
Motor<R> log(const Motor<R> &motor, Way way)
{
    Motor<R> m = normalized(motor);
    const R sine = length(m.r.v);
    if (m.r.w < 0 && (way == Way::shortest || sine == 0))
        m = R(-1) * m;
    const R angle = atan2(sine, m.r.w);
    R factor, slope;  // angle / sine, and its derivative by the cosine
    if (m.r.w > 0 && sine < R(0.1)) {
        const Sinc<R> s = sinc(angle);
        factor = 1 / s.value;
        // f = 1 / sinc, d angle = -d cosine / sine, and sinc' = slope · angle.
        slope = s.slope * factor * factor * factor;
    } else {
        factor = angle / sine;
        slope = (m.r.w * factor - 1) / (sine * sine);
    }
    return {{factor * m.r.v, R(0)}, {factor * m.d.v + (slope * m.d.w) * m.r.v, R(0)}};
}

template <class R>
Motor<R> power(const Motor<R> &motor, R exponent, Way way = Way::shortest)
{
    return exp(exponent * log(motor, way));
}

// The screw from `from` to `to` itself, not to its negative.
template <class R>
Motor<R> slerp(const Motor<R> &from, const Motor<R> &to, R t)
{
    const Motor<R> start = normalized(from);
    return compose(start, power(compose(conjugate(start), normalized(to)), t, Way::principal));
}

template <class R>
Motor<R> lerp(const Motor<R> &from, const Motor<R> &to, R t)
{
    return R(1 - t) * from + t * to;
}

}  // namespace motorway::fuzz

#endif
