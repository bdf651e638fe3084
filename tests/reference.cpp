#include "reference.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace motorway::reference {
namespace {

constexpr unsigned vector_count = 5, blade_count = 32;
constexpr unsigned minus = 4;  // e-, the one vector that squares to -1
constexpr const char *subscripts_in_order = "0123i";
constexpr std::array<const char *, 8> motor_blades = {"", "12", "13", "23", "1i", "2i", "3i", "123i"};

unsigned count_bits(unsigned bits)
{
    unsigned count = 0;
    for (; bits; bits &= bits - 1)
        ++count;
    return count;
}

// The sign of the product of two blades: one exchange for every pair that is out of order, and the squares.
int product_sign(unsigned a, unsigned b)
{
    unsigned exchanges = 0;
    for (unsigned k = 0; k < vector_count; ++k)
        if (b & (1u << k))
            exchanges += count_bits(a >> (k + 1));
    const bool negative_square = (a & b & (1u << minus)) != 0;
    return ((exchanges % 2) != 0) != negative_square ? -1 : 1;
}

Element basis_vector(char subscript)
{
    const Element plus_vector = Element::blade(1u << 3), minus_vector = Element::blade(1u << minus);
    switch (subscript) {
    case '0': return Element(Real(0.5L)) * (minus_vector - plus_vector);
    case '1': return Element::blade(1u << 0);
    case '2': return Element::blade(1u << 1);
    case '3': return Element::blade(1u << 2);
    case 'i': return minus_vector + plus_vector;
    default: throw std::invalid_argument("a subscript is one of 0 1 2 3 i");
    }
}

unsigned sigma_bits(const char *sigma)
{
    unsigned bits = 0;
    for (; *sigma; ++sigma)
        bits |= 1u << (std::strchr(subscripts_in_order, *sigma) - subscripts_in_order);
    return bits;
}

std::string sigma_name(unsigned bits)
{
    std::string name;
    for (unsigned k = 0; k < vector_count; ++k)
        if (bits & (1u << k))
            name += subscripts_in_order[k];
    return name;
}

using Matrix = std::array<std::array<Real, blade_count>, blade_count>;

Matrix invert(Matrix a)
{
    Matrix inverse{};
    for (unsigned k = 0; k < blade_count; ++k)
        inverse[k][k] = Real(1);
    for (unsigned column = 0; column < blade_count; ++column) {
        unsigned pivot = column;
        while (a[pivot][column] == Real(0))
            ++pivot;
        std::swap(a[pivot], a[column]);
        std::swap(inverse[pivot], inverse[column]);
        const Real scale = Real(1) / a[column][column];
        for (unsigned k = 0; k < blade_count; ++k) {
            a[column][k] = a[column][k] * scale;
            inverse[column][k] = inverse[column][k] * scale;
        }
        for (unsigned row = 0; row < blade_count; ++row) {
            const Real factor = a[row][column];
            if (row == column || factor == Real(0))
                continue;
            for (unsigned k = 0; k < blade_count; ++k) {
                a[row][k] = a[row][k] - factor * a[column][k];
                inverse[row][k] = inverse[row][k] - factor * inverse[column][k];
            }
        }
    }
    return inverse;
}

// Row σ gives the coordinate on e_σ as a combination of orthonormal components. Found by writing every e_σ out in
// the orthonormal basis and inverting: all entries are small multiples of ½, so it is exact.
const Matrix &to_paper_basis()
{
    static const Matrix matrix = [] {
        Matrix columns{};
        for (unsigned sigma = 0; sigma < blade_count; ++sigma) {
            const Element blade = e(sigma_name(sigma).c_str());
            for (unsigned bits = 0; bits < blade_count; ++bits)
                columns[bits][sigma] = blade[bits];
        }
        return invert(columns);
    }();
    return matrix;
}

Real coordinate(const Element &a, unsigned sigma)
{
    Real sum;
    for (unsigned bits = 0; bits < blade_count; ++bits)
        if (a[bits] != Real(0) && to_paper_basis()[sigma][bits] != Real(0))
            sum += to_paper_basis()[sigma][bits] * a[bits];
    return sum;
}

Element vector_element(const Vector3 &v)
{
    return Element(v[0]) * e("1") + Element(v[1]) * e("2") + Element(v[2]) * e("3");
}

Element transform(const Motor &motor, const Element &v)
{
    const Element s = element(motor);
    return project(reverse(s) * v * s);
}

// The part on the products of k vectors, which does not depend on the basis.
Element grade(const Element &a, unsigned k)
{
    Element part;
    for (unsigned bits = 0; bits < blade_count; ++bits)
        if (count_bits(bits) == k)
            part[bits] = a[bits];
    return part;
}

Motor as_motor(const Bivector &b) { return {Real(0), b[0], b[1], b[2], b[3], b[4], b[5], Real(0)}; }

Bivector bivector_of(const Motor &m) { return {m[1], m[2], m[3], m[4], m[5], m[6]}; }

// Lengths in another unit: a multiple of e∞ takes its place and every product stays. A power of two is exact.
Motor in_units_of(long double unit, Motor motor)
{
    for (std::size_t k = 4; k < 8; ++k)
        motor[k] = motor[k] * Real(1 / unit);
    return motor;
}

// A power of two in whose units the lengths of a motor are so small that what rounding leaves of e∞² is nothing beside
// any rotation.
long double large_unit(const Motor &motor)
{
    long double largest = 0;
    for (std::size_t k = 4; k < 8; ++k)
        largest = std::fmax(largest, std::abs(static_cast<long double>(motor[k])));
    return largest > 0 ? std::ldexp(1.0L, std::ilogb(largest) + 200) : 1;
}

// The power series, of the argument halved until it is short; then squared as often.
Element exp(Element a)
{
    long double size = 0;
    for (unsigned bits = 0; bits < blade_count; ++bits)
        size += std::abs(static_cast<long double>(a[bits]));
    const int halvings = size > 0 ? std::max(0, std::ilogb(size) + 6) : 0;
    a = Element(Real(std::ldexp(1.0L, -halvings))) * a;
    Element sum(Real(1)), term(Real(1));
    for (int k = 1; k <= 18; ++k) {  // (1/32)^19 / 19! < 2^-150
        term = Element(Real(1) / Real(k)) * (term * a);
        sum = sum + term;
    }
    for (int k = 0; k < halvings; ++k)
        sum = sum * sum;
    return sum;
}

Vector3 euclidean(const Element &v, const Real &weight)
{
    return {coordinate(v, "1") / weight, coordinate(v, "2") / weight, coordinate(v, "3") / weight};
}

}  // namespace

Element Element::blade(unsigned bits)
{
    Element a;
    a[bits] = Real(1);
    return a;
}

Element operator+(const Element &a, const Element &b)
{
    Element sum;
    for (unsigned bits = 0; bits < blade_count; ++bits)
        sum[bits] = b[bits] == Real(0) ? a[bits] : a[bits] + b[bits];
    return sum;
}

Element operator-(const Element &a, const Element &b)
{
    Element difference;
    for (unsigned bits = 0; bits < blade_count; ++bits)
        difference[bits] = a[bits] - b[bits];
    return difference;
}

Element operator*(const Element &a, const Element &b)
{
    Element product;
    for (unsigned x = 0; x < blade_count; ++x) {
        if (a[x] == Real(0))
            continue;
        for (unsigned y = 0; y < blade_count; ++y) {
            if (b[y] == Real(0))
                continue;
            const Real term = a[x] * b[y];
            product[x ^ y] += product_sign(x, y) < 0 ? -term : term;
        }
    }
    return product;
}

Element reverse(const Element &a)
{
    Element reversed;
    for (unsigned bits = 0; bits < blade_count; ++bits) {
        const unsigned grade = count_bits(bits);
        const bool negative = grade * (grade - (grade > 0)) / 2 % 2 != 0;
        reversed[bits] = negative ? -a[bits] : a[bits];
    }
    return reversed;
}

Element e(const char *subscripts)
{
    static std::map<std::string, Element> known;
    const auto found = known.find(subscripts);
    if (found != known.end())
        return found->second;
    Element product(Real(1));
    for (const char *subscript = subscripts; *subscript; ++subscript)
        product = product * basis_vector(*subscript);
    return known[subscripts] = product;
}

Real coordinate(const Element &a, const char *sigma) { return coordinate(a, sigma_bits(sigma)); }

Element project(const Element &a)
{
    Element projected;
    for (const char *sigma : {"0", "1", "2", "3"})
        projected = projected + Element(coordinate(a, sigma)) * e(sigma);
    return projected;
}

Element element(const Motor &motor)
{
    static const std::array<Element, 8> blades = [] {
        std::array<Element, 8> b;
        for (std::size_t k = 0; k < 8; ++k)
            b[k] = e(motor_blades[k]);
        return b;
    }();
    Element sum;
    for (std::size_t k = 0; k < 8; ++k)
        sum = sum + Element(motor[k]) * blades[k];
    return sum;
}

Element element(const Vector5 &v)
{
    return Element(v[0]) * e("0") + vector_element({v[1], v[2], v[3]}) + Element(v[4]) * e("i");
}

// The moment is that of b∧q = -(d × q), component by component on e1∞, e2∞ and e3∞.
Element element(const Line &line)
{
    return vector_element({line[0], line[1], line[2]}) * e("123") +
           vector_element({line[3], line[4], line[5]}) * e("i");
}

Motor motor(const Element &a)
{
    Motor coordinates;
    for (std::size_t k = 0; k < 8; ++k)
        coordinates[k] = coordinate(a, motor_blades[k]);
    return coordinates;
}

Real outside_of_motors(const Element &a)
{
    Real largest;
    for (unsigned sigma = 0; sigma < blade_count; ++sigma) {
        bool of_motors = false;
        for (const char *blade : motor_blades)
            of_motors = of_motors || sigma_bits(blade) == sigma;
        const Real size = abs(coordinate(a, sigma));
        if (!of_motors && largest < size)
            largest = size;
    }
    return largest;
}

Element translation(const Vector3 &offset)
{
    return Element(Real(1)) + Element(Real(0.5L)) * vector_element(offset) * e("i");
}

Element rotation(const Vector3 &unit_axis, const Real &cosine, const Real &sine, const Vector3 &point)
{
    const Element b = vector_element(unit_axis) * e("123"), q = vector_element(point);
    const Element outer = Element(Real(0.5L)) * (b * q - q * b);  // the paper's outer product
    return Element(cosine) + Element(sine) * (b + outer * e("i"));
}

Vector3 apply_point(const Motor &motor, const Vector3 &point)
{
    const Element moved = transform(motor, e("0") + vector_element(point));
    return euclidean(moved, coordinate(moved, "0"));
}

Vector3 apply_direction(const Motor &motor, const Vector3 &direction)
{
    const Element s = element(motor), reversed = reverse(s);
    return euclidean(project(reversed * vector_element(direction) * s), coordinate(reversed * e("0") * s, "0"));
}

Vector5 apply_vector(const Motor &motor, const Vector5 &vector)
{
    const Element u = element(normalize(motor));
    const Element moved = grade(reverse(u) * element(vector) * u, 1);
    return {coordinate(moved, "0"), coordinate(moved, "1"), coordinate(moved, "2"), coordinate(moved, "3"),
            coordinate(moved, "i")};
}

Line apply_line(const Motor &motor, const Line &line)
{
    const Element u = element(normalize(motor));
    const Element moved = reverse(u) * element(line) * u;
    return {coordinate(moved, "23"), -coordinate(moved, "13"), coordinate(moved, "12"),
            coordinate(moved, "1i"), coordinate(moved, "2i"),  coordinate(moved, "3i")};
}

Motor apply_motor(const Motor &by, const Motor &moved)
{
    const Element t = element(by);
    const auto [al, be] = square(by);
    const Element inverse = (Element(Real(1) / al) - Element(be / (al * al)) * e("123i")) * reverse(t);
    return motor(inverse * element(moved) * t);
}

Motor compose(const Motor &first, const Motor &then) { return motor(element(first) * element(then)); }

Motor reverse(const Motor &a) { return motor(reverse(element(a))); }

Motor normalize(const Motor &a)
{
    const auto [al, be] = square(a);
    // The inverse of the root √α (1 + ½ β/α ω) of lemma 3.4; ω² = 0.
    const Element inverse_root =
        Element(Real(1) / sqrt(al)) * (Element(Real(1)) - Element(be / (Real(2) * al)) * e("123i"));
    return motor(element(a) * inverse_root);
}

Motor blend(const std::vector<Real> &weights, const std::vector<Motor> &controls)
{
    Element sum;
    for (std::size_t k = 0; k < controls.size(); ++k)
        sum = sum + Element(weights[k]) * element(controls[k]);
    return motor(sum);
}

Square square(const Motor &a)
{
    const Element s = element(a), product = reverse(s) * s;
    return {coordinate(product, ""), coordinate(product, "123i")};
}

Real alpha(const Motor &a) { return square(a).alpha; }

Real beta(const Motor &a) { return square(a).beta; }

// X (2 - S X) with X = S̄/α: the error of X is a multiple of ω, whose square is 0.
Motor inverse(const Motor &a)
{
    const Element s = element(a), near = Element(Real(1) / alpha(a)) * reverse(s);
    return motor(near * (Element(Real(2)) - s * near));
}

Motor exp(const Bivector &bivector)
{
    const long double unit = large_unit(as_motor(bivector));
    return in_units_of(1 / unit, motor(exp(element(in_units_of(unit, as_motor(bivector))))));
}

// The error of an approximation X that commutes with S is the logarithm of exp(-X) S, of which the bivector part is
// all but for the third power. Every multiple of the bivector part of S commutes with S; that by angle over sine
// lacks no more than the part along the axis.
Bivector log(const Motor &a, Branch branch)
{
    const long double unit = large_unit(a);
    Motor s = normalize(in_units_of(unit, a));
    const Real sine = sqrt(s[1] * s[1] + s[2] * s[2] + s[3] * s[3]);
    if (s[0] < Real(0) && (branch == Branch::shortest || sine == Real(0)))
        for (Real &component : s)
            component = -component;
    const long double angle = std::atan2(static_cast<long double>(sine), static_cast<long double>(s[0]));
    const Real factor = sine == Real(0) ? Real(1) : Real(angle) / sine;
    Element x = Element(factor) * element(as_motor(bivector_of(s)));
    for (int k = 0; k < 3; ++k) {
        const Motor rest = motor(exp(Element(Real(-1)) * x) * element(s));
        x = x + element(as_motor(bivector_of(rest)));
    }
    return bivector_of(in_units_of(1 / unit, motor(x)));
}

Bivector multiple(const Real &factor, const Bivector &bivector)
{
    Bivector product;
    for (std::size_t k = 0; k < product.size(); ++k)
        product[k] = factor * bivector[k];
    return product;
}

Motor power(const Motor &a, const Real &exponent) { return exp(multiple(exponent, log(a, Branch::shortest))); }

Motor slerp(const Motor &first, const Motor &second, const Real &parameter)
{
    const Motor from = normalize(first);
    return compose(from, power(compose(reverse(from), normalize(second)), parameter));
}

Motor product_magnitudes(const Motor &first, const Motor &then)
{
    static const auto products = [] {
        std::array<std::array<Motor, 8>, 8> table;
        for (std::size_t i = 0; i < 8; ++i)
            for (std::size_t j = 0; j < 8; ++j)
                table[i][j] = motor(e(motor_blades[i]) * e(motor_blades[j]));
        return table;
    }();
    Motor magnitudes;
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = 0; j < 8; ++j)
            for (std::size_t k = 0; k < 8; ++k)
                magnitudes[k] += abs(products[i][j][k] * first[i] * then[j]);
    return magnitudes;
}

std::size_t knot_span(std::size_t control_count, const std::vector<Real> &knots, std::size_t degree, const Real &t)
{
    const std::size_t first = degree - 1, last = control_count - 1;  // the domain is [knots[first], knots[last]]
    std::size_t span = last;
    for (std::size_t i = first; i < last; ++i) {
        const bool at_end = knots[i + 1] == knots[last] && t == knots[last];
        if (knots[i] < knots[i + 1] && !(t < knots[i]) && (t < knots[i + 1] || at_end))
            span = i;
    }
    if (span == last)
        throw std::domain_error("the parameter is outside the domain");
    return span;
}

Motor sample_bspline(const std::vector<Motor> &controls, const std::vector<Real> &knots, std::size_t degree,
                     const Real &t)
{
    const std::size_t i = knot_span(controls.size(), knots, degree, t);
    // blossom[r] is S with r knots up to t_i, then t, then s = given - r knots from t_{i+1}; no t at first.
    std::vector<Element> blossom;
    for (std::size_t r = 0; r <= degree; ++r)
        blossom.push_back(element(controls[i + 1 - r]));
    for (std::size_t given = degree; given-- > 0;)
        for (std::size_t r = 0; r <= given; ++r) {
            const std::size_t s = given - r;
            const Real before = knots[i - r], after = knots[i + s + 1], width = after - before;
            blossom[r] = Element((after - t) / width) * blossom[r + 1] + Element((t - before) / width) * blossom[r];
        }
    return motor(blossom[0]);
}

std::vector<Real> bspline_basis(std::size_t control_count, const std::vector<Real> &knots, std::size_t degree,
                                const Real &t)
{
    // The definition uses one knot more at either end, which no value in the domain depends on.
    std::vector<Real> all(knots);
    all.insert(all.begin(), knots.front());
    all.push_back(knots.back());
    const std::size_t span = knot_span(control_count, knots, degree, t) + 1;
    std::vector<Real> basis(all.size() - 1);
    basis[span] = Real(1);
    for (std::size_t d = 1; d <= degree; ++d)
        for (std::size_t k = 0; k + d + 1 < all.size(); ++k) {
            const Real left = all[k + d] - all[k], right = all[k + d + 1] - all[k + 1];
            const Real rising = left == Real(0) ? Real(0) : (t - all[k]) / left * basis[k];
            const Real falling = right == Real(0) ? Real(0) : (all[k + d + 1] - t) / right * basis[k + 1];
            basis[k] = rising + falling;
        }
    basis.resize(control_count);
    return basis;
}

}  // namespace motorway::reference
