// Geometric algebras by definition, to state what other libraries do with them: dense over the products of a few
// orthogonal vectors, of which only the squares are given. A metric has `squares`, and `first`, the digit by which
// its first vector is called.
#ifndef MOTORWAY_TESTS_CONVENTIONS_ALGEBRA_H
#define MOTORWAY_TESTS_CONVENTIONS_ALGEBRA_H

#include <array>
#include <cstddef>

namespace motorway::testing::conventions {

// Projective geometric algebra, PGA(3,0,1): e0 e1 e2 e3.
struct Projective {
    static constexpr std::array<double, 4> squares{0, 1, 1, 1};
    static constexpr char first = '0';
};

// Conformal geometric algebra as Wareham and Lasenby have it: e1 e2 e3, and e and ē for 4 and 5.
struct Conformal {
    static constexpr std::array<double, 5> squares{1, 1, 1, 1, -1};
    static constexpr char first = '1';
};

// Part `bits` is the coefficient of the product, in ascending order, of the vectors whose bits are set.
template <class Metric>
struct Multivector {
    static constexpr unsigned size = 1u << Metric::squares.size();
    std::array<double, size> part{};
};

// The sign that sorts the product of two products, times the squares of the vectors that both have.
template <class Metric>
double sign_of_product(unsigned a, unsigned b)
{
    double sign = 1;
    for (unsigned k = 0; k < Metric::squares.size(); ++k) {
        if (!(b >> k & 1))
            continue;
        for (unsigned passed = k + 1; passed < Metric::squares.size(); ++passed)
            sign = a >> passed & 1 ? -sign : sign;
        if (a >> k & 1)
            sign *= Metric::squares[k];
        a ^= 1u << k;
    }
    return sign;
}

template <class Metric>
Multivector<Metric> operator*(const Multivector<Metric> &a, const Multivector<Metric> &b)
{
    Multivector<Metric> product;
    for (unsigned i = 0; i < product.size; ++i)
        for (unsigned j = 0; j < product.size; ++j)
            product.part[i ^ j] += sign_of_product<Metric>(i, j) * a.part[i] * b.part[j];
    return product;
}

template <class Metric>
Multivector<Metric> operator*(double factor, Multivector<Metric> a)
{
    for (double &part : a.part)
        part *= factor;
    return a;
}

template <class Metric>
Multivector<Metric> operator+(Multivector<Metric> a, const Multivector<Metric> &b)
{
    for (unsigned i = 0; i < a.size; ++i)
        a.part[i] += b.part[i];
    return a;
}

// The product of the vectors called by these digits, in this order: e31 is -e13, and no digits are the number 1.
template <class Metric>
Multivector<Metric> blade(const char *digits)
{
    Multivector<Metric> product;
    product.part[0] = 1;
    for (; *digits; ++digits) {
        Multivector<Metric> vector;
        vector.part[1u << (*digits - Metric::first)] = 1;
        product = product * vector;
    }
    return product;
}

template <class Metric>
double coefficient(const Multivector<Metric> &a, const char *digits)
{
    const Multivector<Metric> unit = blade<Metric>(digits);
    double sum = 0;
    for (unsigned i = 0; i < a.size; ++i)
        sum += a.part[i] * unit.part[i];
    return sum;
}

// Every product of vectors the other way round.
template <class Metric>
Multivector<Metric> reverse(Multivector<Metric> a)
{
    for (unsigned i = 0; i < a.size; ++i) {
        unsigned grade = 0;
        for (unsigned bits = i; bits; bits >>= 1)
            grade += bits & 1;
        if (grade * (grade - 1) / 2 % 2)
            a.part[i] = -a.part[i];
    }
    return a;
}

}  // namespace motorway::testing::conventions

#endif
