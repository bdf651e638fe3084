// Numbers that carry their derivative: a generated body over jets computes the derivative of its result as well, by the
// chain rule. What is constant between its jumps, such as a sign, has the derivative zero.
#pragma once

#include "simd.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

template <class V> struct jet {
    V value, derivative;

    jet() = default;
    explicit jet(const V &constant) : value(constant), derivative(scalar_of<V>(0)) {}
    template <class T = scalar_of<V>, class = std::enable_if_t<!std::is_same_v<T, V>>>
    explicit jet(T constant) : value(constant), derivative(T(0))
    {
    }
    jet(const V &v, const V &d) : value(v), derivative(d) {}
};

template <class V> struct scalar_type<jet<V>> { using type = scalar_of<V>; };

template <class V> inline jet<V> operator+(const jet<V> &a, const jet<V> &b)
{
    return {a.value + b.value, a.derivative + b.derivative};
}
template <class V> inline jet<V> operator-(const jet<V> &a, const jet<V> &b)
{
    return {a.value - b.value, a.derivative - b.derivative};
}
template <class V> inline jet<V> operator*(const jet<V> &a, const jet<V> &b)
{
    return {a.value * b.value, fma(a.derivative, b.value, a.value * b.derivative)};
}
template <class V> inline jet<V> fma(const jet<V> &a, const jet<V> &b, const jet<V> &c)
{
    return {fma(a.value, b.value, c.value), fma(a.derivative, b.value, fma(a.value, b.derivative, c.derivative))};
}
template <class V> inline jet<V> fnma(const jet<V> &a, const jet<V> &b, const jet<V> &c)
{
    return {fnma(a.value, b.value, c.value), fnma(a.derivative, b.value, fnma(a.value, b.derivative, c.derivative))};
}
template <class V> inline jet<V> fms(const jet<V> &a, const jet<V> &b, const jet<V> &c)
{
    return {fms(a.value, b.value, c.value), fma(a.derivative, b.value, fms(a.value, b.derivative, c.derivative))};
}
template <class V> inline jet<V> magnitude(const jet<V> &a)
{
    return {magnitude(a.value), a.derivative * with_sign(V(scalar_of<V>(1)), a.value)};
}
template <class V> inline jet<V> with_sign(const jet<V> &a, const jet<V> &sign)
{
    const V factor = with_sign(V(scalar_of<V>(1)), a.value) * with_sign(V(scalar_of<V>(1)), sign.value);
    return {with_sign(a.value, sign.value), a.derivative * factor};
}

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
