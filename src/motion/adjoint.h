// How motors turn bivectors: the maps x -> f(ad b) x, where ad b takes x to bx - xb.
//
// They are linear over the dual numbers with ω = e123∞: by e3∞ = -e12 ω, e2∞ = e13 ω and e1∞ = -e23 ω a bivector is a
// triple of these, ad b is the cross product with -2 (b12, b13, b23), and (ad b)³ = -φ² ad b. A matrix here is the
// part of such a map without ω, which acts on both halves of x. That is all of it if b does not move the origin.
#pragma once

#include "scalar_motor.h"

namespace motorway {

struct matrix3 {
    double at[3][3];
};

inline matrix3 operator-(const matrix3 &a, const matrix3 &b)
{
    matrix3 difference;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            difference.at[i][j] = a.at[i][j] - b.at[i][j];
    return difference;
}
inline matrix3 operator*(const matrix3 &a, const matrix3 &b)
{
    matrix3 product;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            product.at[i][j] = a.at[i][0] * b.at[0][j] + a.at[i][1] * b.at[1][j] + a.at[i][2] * b.at[2][j];
    return product;
}

// By its cofactors.
inline matrix3 inverse(const matrix3 &a)
{
    matrix3 result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int r = (j + 1) % 3, s = (j + 2) % 3, u = (i + 1) % 3, v = (i + 2) % 3;
            result.at[i][j] = a.at[r][u] * a.at[s][v] - a.at[r][v] * a.at[s][u];
        }
    const double determinant =
        a.at[0][0] * result.at[0][0] + a.at[0][1] * result.at[1][0] + a.at[0][2] * result.at[2][0];
    for (auto &row : result.at)
        for (double &entry : row)
            entry /= determinant;
    return result;
}

inline scalar_bivector<double> apply(const matrix3 &map, const scalar_bivector<double> &x)
{
    const auto row = [&](int i, double a, double b, double c) {
        return map.at[i][0] * a + map.at[i][1] * b + map.at[i][2] * c;
    };
    return {row(0, x.b12, x.b13, x.b23),    row(1, x.b12, x.b13, x.b23),   row(2, x.b12, x.b13, x.b23),
            -row(2, -x.b3i, x.b2i, -x.b1i), row(1, -x.b3i, x.b2i, -x.b1i), -row(0, -x.b3i, x.b2i, -x.b1i)};
}

// The angle φ that exp(b) turns by: ad b has the eigenvalues 0 and ±iφ.
inline double turning_angle(const scalar_bivector<double> &b)
{
    return 2 * square_root(b.b12 * b.b12 + b.b13 * b.b13 + b.b23 * b.b23);
}

// f(ad b) = f(0) + (Im f(iφ) / φ) ad b + ((f(0) - Re f(iφ)) / φ²) (ad b)². Where φ is all but zero, f(0).
inline matrix3 function_of_adjoint(const scalar_bivector<double> &b, double at_zero, double real, double imaginary)
{
    const double phi = turning_angle(b), p = phi > 0x1p-100 ? imaginary / phi : 0.0;
    const double q = phi > 0x1p-100 ? (at_zero - real) / (phi * phi) : 0.0;
    const double x = -2 * b.b12, y = -2 * b.b13, z = -2 * b.b23, squares = x * x + y * y + z * z;
    return {{{at_zero + q * (x * x - squares), q * x * y - p * z, q * x * z + p * y},
             {q * x * y + p * z, at_zero + q * (y * y - squares), q * y * z - p * x},
             {q * x * z - p * y, q * y * z + p * x, at_zero + q * (z * z - squares)}}};
}

// x -> D x D^-1 with D = exp(power b).
inline matrix3 conjugation(const scalar_bivector<double> &b, double power)
{
    const auto [sine, cosine] = sine_and_cosine(power * turning_angle(b));
    return function_of_adjoint(b, 1, cosine, sine);
}

// The derivative of a power: to first order (exp(x) exp(b))^c = exp(map x) exp(cb). The map is
// (e^(c ad b) - 1) / (e^(ad b) - 1).
inline matrix3 power_derivative(const scalar_bivector<double> &b, double c)
{
    const double half = turning_angle(b) / 2, rest = (c - 1) * half;
    const double ratio = half > 0x1p-100 ? sine_and_cosine(c * half).sine / sine_and_cosine(half).sine : c;
    const auto [sine, cosine] = sine_and_cosine(rest);
    return function_of_adjoint(b, c, ratio * cosine, ratio * sine);
}

} // namespace motorway
