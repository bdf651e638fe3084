#include "nearest_rotation.h"

#include "scalar_math.h"

#include <algorithm>
#include <cmath>

namespace motorway {
namespace {

constexpr int order = 4;
using square = double[order][order];

// The quaternion (w, x, y, z) of the nearest rotation is the eigenvector of this matrix to its largest eigenvalue: its
// quadratic form is the sum of the products of the elements of R and the given matrix (Horn; Davenport).
void quadratic_form(const double (&m)[3][3], square &k)
{
    const square full = {
        {m[0][0] + m[1][1] + m[2][2], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]},
        {m[2][1] - m[1][2], m[0][0] - m[1][1] - m[2][2], m[1][0] + m[0][1], m[0][2] + m[2][0]},
        {m[0][2] - m[2][0], m[1][0] + m[0][1], m[1][1] - m[0][0] - m[2][2], m[2][1] + m[1][2]},
        {m[1][0] - m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2], m[2][2] - m[0][0] - m[1][1]}};
    __builtin_memcpy(k, full, sizeof full);
}

// One of Jacobi's rotations: makes k[p][q] zero, and turns the columns of `vectors` likewise.
void rotate(square &k, square &vectors, int p, int q)
{
    constexpr double negligible = 0x1p-60;
    if (std::fabs(k[p][q]) <= negligible * (std::fabs(k[p][p]) + std::fabs(k[q][q])))
        return;
    const double cotangent = (k[q][q] - k[p][p]) / (2 * k[p][q]);
    const double tangent = 1 / (std::fabs(cotangent) + length_of(1, cotangent, 0));
    const double t = std::signbit(cotangent) ? -tangent : tangent;
    const double c = 1 / square_root(1 + t * t), s = t * c;
    const auto turn = [c, s](double &a, double &b) {
        const double old = a;
        a = c * old - s * b;
        b = s * old + c * b;
    };
    for (int i = 0; i < order; ++i)
        turn(k[i][p], k[i][q]);
    for (int i = 0; i < order; ++i)
        turn(k[p][i], k[q][i]);
    for (int i = 0; i < order; ++i)
        turn(vectors[i][p], vectors[i][q]);
}

// To numbers of about 1, exactly.
void scale(const double (&m)[3][3], double (&scaled)[3][3])
{
    double largest = 0;
    for (const auto &row : m)
        for (double value : row)
            largest = std::max(largest, std::fabs(value));
    const int exponent = largest > 0 ? exponent_of(largest) : 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            scaled[r][c] = times_power_of_two(m[r][c], -exponent);
}

// The largest of the four eigenvalues, and how far the next one is below it.
struct top_eigenvalue {
    int index = 0;
    double value = 0, gap = 0;

    explicit top_eigenvalue(const square &diagonal)
    {
        for (int i = 1; i < order; ++i)
            index = diagonal[i][i] > diagonal[index][index] ? i : index;
        value = diagonal[index][index];
        gap = INFINITY;
        for (int i = 0; i < order; ++i)
            gap = i == index ? gap : std::min(gap, value - diagonal[i][i]);
    }
};

} // namespace

bool nearest_motor(const double (&matrix)[3][3], const double (&translation)[3], double tolerance, double (&motor)[8])
{
    double scaled[3][3];
    scale(matrix, scaled);
    square k, vectors = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    quadratic_form(scaled, k);
    for (int sweep = 0; sweep < 8; ++sweep) // converges quadratically: five are enough
        for (int p = 0; p < order; ++p)
            for (int q = p + 1; q < order; ++q)
                rotate(k, vectors, p, q);
    const top_eigenvalue top(k);
    const int best = top.index;
    const double sign = vectors[0][best] < 0 ? -1 : 1;
    const double w = sign * vectors[0][best], x = sign * vectors[1][best], y = sign * vectors[2][best],
                 z = sign * vectors[3][best];
    // The rotation, and then half the translation: R (1 + ½ t e∞).
    const double tx = translation[0] / 2, ty = translation[1] / 2, tz = translation[2] / 2;
    const double result[8] = {w, z, -y, x, w * tx + ty * z - tz * y, w * ty + tz * x - tx * z,
                              w * tz + tx * y - ty * x, tx * x + ty * y + tz * z};
    __builtin_memcpy(motor, result, sizeof result);
    return top.gap > tolerance * top.value;
}

} // namespace motorway
