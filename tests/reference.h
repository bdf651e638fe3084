// The reference: G(4,1) with all of its 32 components, written from the definitions and nothing else.
//
// An element is dense over the products of the orthonormal vectors e1 e2 e3 e+ e- (e+² = 1, e-² = -1), and products
// find their signs by counting exchanges. The paper's null vectors are e0 = ½(e- - e+) and e∞ = e- + e+. Nothing
// here is generated, simplified or fast: it judges what is.
#ifndef MOTORWAY_TESTS_REFERENCE_H
#define MOTORWAY_TESTS_REFERENCE_H

#include <array>
#include <cstddef>
#include <vector>

#include "extended.h"

namespace motorway::reference {

using Real = Extended;
using Vector3 = std::array<Real, 3>;
using Motor = std::array<Real, 8>;   // s b12 b13 b23 b1i b2i b3i w: equation (3)
using Vector5 = std::array<Real, 5>;  // grade 1: e0 e1 e2 e3 e∞
using Line = std::array<Real, 6>;     // Plücker: the direction d, and the moment p × d of any point p on it
using Bivector = std::array<Real, 6>;  // b12 b13 b23 b1i b2i b3i

class Element {
public:
    Element() = default;
    Element(const Real &scalar) { parts_[0] = scalar; }

    // The product of the orthonormal vectors whose bits are set, in the order e1 e2 e3 e+ e-.
    static Element blade(unsigned bits);

    const Real &operator[](unsigned bits) const { return parts_[bits]; }
    Real &operator[](unsigned bits) { return parts_[bits]; }

private:
    std::array<Real, 32> parts_{};
};

Element operator+(const Element &a, const Element &b);
Element operator-(const Element &a, const Element &b);
Element operator*(const Element &a, const Element &b);  // the geometric product
Element reverse(const Element &a);

// The paper's basis: products of e0 e1 e2 e3 e∞ named by their subscripts in any order, e∞ written `i`: e("123i").
Element e(const char *subscripts);

// The coordinate of `a` on e_σ in the paper's basis, whose 32 elements are the sorted products.
Real coordinate(const Element &a, const char *sigma);

// The paper's P: the part on e0, e1, e2, e3 of its basis. That is not the grade 1 part, for e_{01∞} has one as well.
Element project(const Element &a);

Element element(const Motor &motor);
Element element(const Vector5 &vector);
Element element(const Line &line);  // b + (b∧q) e∞ with b = d e123: the axis of lemma 3.11, of any length
Motor motor(const Element &a);             // the eight coordinates
Real outside_of_motors(const Element &a);  // the largest coordinate that is none of the eight

Element translation(const Vector3 &offset);                                     // lemma 3.10
Element rotation(const Vector3 &unit_axis, const Real &cosine, const Real &sine,  // of half the angle
                 const Vector3 &point);                                           // lemma 3.11

Vector3 apply_point(const Motor &motor, const Vector3 &point);          // P(S̄ p S) over its e0 part
Vector3 apply_direction(const Motor &motor, const Vector3 &direction);  // likewise, over the e0 part of P(S̄ e0 S)
Vector5 apply_vector(const Motor &motor, const Vector5 &vector);         // Ū v U with the motor normalised
Line apply_line(const Motor &motor, const Line &line);                  // Ū L U, likewise
Motor apply_motor(const Motor &by, const Motor &moved);                 // T^-1 M T, with no root
Motor compose(const Motor &first, const Motor &then);
Motor reverse(const Motor &motor);
Motor normalize(const Motor &motor);  // corollary 3.7
Motor blend(const std::vector<Real> &weights, const std::vector<Motor> &controls);

struct Square {
    Real alpha, beta;  // S̄S = alpha + beta ω
};
Square square(const Motor &motor);
Real alpha(const Motor &motor);
Real beta(const Motor &motor);

// The group, from its product alone. A power series and its inverse by iteration know nothing of angles, axes or
// dual numbers, except that the iteration needs a first guess.
Motor inverse(const Motor &motor);
Motor exp(const Bivector &bivector);
enum class Branch { shortest, principal };  // the logarithm of S or -S with s >= 0, or that of S itself
Bivector log(const Motor &motor, Branch branch);  // of the motor normalised; where it does not turn always shortest
Motor power(const Motor &motor, const Real &exponent);                        // by the shortest logarithm
Motor slerp(const Motor &first, const Motor &second, const Real &parameter);  // likewise
Bivector multiple(const Real &factor, const Bivector &bivector);

// For each coordinate of the product of two motors the sum of the magnitudes of the products that make it up: what
// the rounding errors of any way to compute it are relative to.
Motor product_magnitudes(const Motor &first, const Motor &then);

// The additive B-spline by the paper's blossom recursion. Its printed line has an index wrong; with the right ones
//     S(t_{i-r+1}..t_i, t.., t_{i+1}..t_{i+s}) =
//         [(t_{i+s+1} - t) S(t_{i-r}..) + (t - t_{i-r}) S(..t_{i+s+1})] / (t_{i+s+1} - t_{i-r}).
Motor sample_bspline(const std::vector<Motor> &controls, const std::vector<Real> &knots, std::size_t degree,
                     const Real &t);

// The basis functions of the same motion by their own definition (Cox and de Boor), one a control.
std::vector<Real> bspline_basis(std::size_t control_count, const std::vector<Real> &knots, std::size_t degree,
                                const Real &t);

// The i with t_i <= t < t_{i+1}; at the end of the domain the last i with t_i < t_{i+1}.
std::size_t knot_span(std::size_t control_count, const std::vector<Real> &knots, std::size_t degree, const Real &t);

}  // namespace motorway::reference

#endif
