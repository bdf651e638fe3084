"""The foundations of every other proof: the product of the algebra, and polynomials as a canonical form."""

import unittest
from fractions import Fraction
from itertools import combinations, product

from algebra import (
    BLADES,
    METRIC,
    OMEGA,
    VECTORS,
    Multivector,
    blade_product,
    blade_reverse,
    e,
    multivector,
    project,
    transform,
)
from polynomial import Polynomial, variables
from tests.symbols import differentiated, general, modulo, motor, substituted
from tests.trigonometry import DIGITS, PI, cosine, decimal, sine


class Orthonormal:
    """The same algebra in the basis e1 e2 e3 e+ e-, squares 1 1 1 1 -1, where a blade is a set of bits.

    Nothing here is shared with algebra.py: a product is the number of exchanges that sorts it.
    """

    SQUARES = (1, 1, 1, 1, -1)
    # e0 = ½(e- - e+) and e∞ = e+ + e-, so that e0·e∞ = -1.
    VECTORS = {
        "0": {8: Fraction(-1, 2), 16: Fraction(1, 2)},
        "1": {1: Fraction(1)},
        "2": {2: Fraction(1)},
        "3": {4: Fraction(1)},
        "i": {8: Fraction(1), 16: Fraction(1)},
    }

    @classmethod
    def multiply(cls, left, right):
        total = {}
        for (a, x), (b, y) in product(left.items(), right.items()):
            exchanges = sum(bin(a >> k).count("1") for k in range(1, 6) if b >> (k - 1) & 1)
            value = x * y * (-1) ** exchanges
            for k, square in enumerate(cls.SQUARES):
                value *= square if (a & b) >> k & 1 else 1
            total[a ^ b] = total.get(a ^ b, 0) + value
        return {blade: value for blade, value in total.items() if value}

    @classmethod
    def of(cls, a: Multivector):
        total = {}
        for blade, coefficient in a.parts.items():
            image = {0: Fraction(coefficient)}
            for subscript in blade:
                image = cls.multiply(image, cls.VECTORS[subscript])
            for bits, value in image.items():
                total[bits] = total.get(bits, 0) + value
        return {bits: value for bits, value in total.items() if value}


class BladeTest(unittest.TestCase):
    def test_the_32_blades(self):
        self.assertEqual(len(BLADES), 32)
        self.assertEqual(len(set(BLADES)), 32)
        self.assertEqual(BLADES[0], "")
        self.assertEqual(BLADES[-1], "0123i")
        self.assertIn(OMEGA, BLADES)

    def test_the_paper_s_multiplication_rules(self):
        for vector in "123":
            self.assertEqual(e(vector) * e(vector), 1)
        for vector in "0i":
            self.assertEqual(e(vector) * e(vector), 0)
        self.assertEqual(e("i") * e("0"), -2 - e("0") * e("i"))
        for a, b in combinations(VECTORS, 2):
            if (a, b) != ("0", "i"):
                self.assertEqual(e(a) * e(b), -e(b) * e(a))

    def test_symmetric_products_of_vectors_are_the_metric(self):
        for a, b in product(VECTORS, repeat=2):
            self.assertEqual(e(a).inner(e(b)), METRIC.get((a, b), 0))

    def test_products_are_associative(self):
        # (x a) b = x (a b) for every basis vector x. Every blade is a product of basis vectors, so that by induction
        # on their number (A a) b = A (a b) for every blade A.
        for x, a, b in product(VECTORS, BLADES, BLADES):
            self.assertEqual((e(x) * e(a)) * e(b), e(x) * (e(a) * e(b)), (x, a, b))

    def test_products_agree_with_an_orthonormal_basis(self):
        for a, b in product(BLADES, repeat=2):
            image = Orthonormal.multiply(Orthonormal.of(e(a)), Orthonormal.of(e(b)))
            self.assertEqual(Orthonormal.of(e(a) * e(b)), image, (a, b))

    def test_blade_product_and_reverse_are_integer_sums(self):
        self.assertEqual(dict(blade_product("i", "0")), {"": -2, "0i": -1})
        self.assertEqual(dict(blade_reverse("0i")), {"": -2, "0i": -1})
        self.assertEqual(blade_product("i", "i"), ())

    def test_reverse_of_a_product_is_the_product_of_reverses(self):
        for a, b in product(BLADES, repeat=2):
            self.assertEqual(~(e(a) * e(b)), ~e(b) * ~e(a), (a, b))

    def test_parity_is_kept_by_products_and_the_reverse(self):
        for a, b in product(BLADES, repeat=2):
            odd = (len(a) + len(b)) % 2
            self.assertTrue(all(len(blade) % 2 == odd for blade in (e(a) * e(b)).parts), (a, b))
            self.assertTrue(all(len(blade) % 2 == len(a) % 2 for blade in (~e(a)).parts), a)


class MultivectorTest(unittest.TestCase):
    def test_zero_coefficients_are_dropped(self):
        self.assertEqual(Multivector({"1": 0, "2": 3}).parts, {"2": 3})
        self.assertEqual((e("1") - e("1")).parts, {})
        self.assertEqual(repr(Multivector()), "0")

    def test_what_is_no_basis_blade_is_refused(self):
        for name in ("21", "11", "4", "i0"):
            with self.assertRaises(ValueError):
                Multivector({name: 1})

    def test_numbers_and_polynomials_mix_with_multivectors_on_either_side(self):
        x, y = variables("x y")
        a = e("1") + e("23")
        for k in (2, Fraction(2, 3), x):
            self.assertEqual(k * a, a * k)
            self.assertEqual(k + a, a + k)
            self.assertEqual(k - a, -(a - k))
            self.assertEqual((k + a)[""], k)
        self.assertEqual(multivector(x) * y, x * y)

    def test_coefficients_are_of_any_commutative_ring(self):
        a, b = motor("a"), motor("b")
        values = {name: k + 2 for k, name in enumerate(f"{m}{x or 's'}" for m in "ab" for x in a.parts)}
        numbers = [substituted(m, values).map(Polynomial.constant) for m in (a, b)]
        self.assertEqual(substituted(a * b, values), numbers[0] * numbers[1])

    def test_division_only_map_and_equality(self):
        a = 2 * e("1") + 4 * e("2")
        self.assertEqual(a / Fraction(2), e("1") + 2 * e("2"))
        self.assertEqual(a.only(("2", "3")), 4 * e("2"))
        self.assertEqual(a.map(lambda x: x - 2), 2 * e("2"))
        self.assertEqual(a["2"], 4)
        self.assertEqual(a["3"], 0)
        self.assertNotEqual(a, e("1"))

    def test_inner_and_outer_products_add_up_to_the_product(self):
        a, b = general("a", BLADES[:12]), general("b", BLADES[8:20])
        self.assertEqual(a.inner(b) + a.outer(b), a * b)
        self.assertEqual(a.inner(b), b.inner(a))
        self.assertEqual(a.outer(b), -b.outer(a))

    def test_project_and_transform(self):
        a = general("a", BLADES)
        self.assertEqual(project(a), general("a", "0123"))
        self.assertEqual(transform(multivector(3), a), 9 * project(a))


class PolynomialTest(unittest.TestCase):
    x, y, z = variables("x y z")

    def test_equal_polynomials_are_equal_however_they_were_made(self):
        x, y = self.x, self.y
        self.assertEqual((x + y) ** 2 - (x - y) ** 2, 4 * x * y)
        self.assertEqual(hash((x + y) * (x - y)), hash(x * x - y * y))
        self.assertNotEqual(x, y)
        self.assertEqual(x - x, 0)
        self.assertFalse(x - x)
        self.assertEqual(1 - x, -(x - 1))
        self.assertEqual(x / 3 + Fraction(2, 3) * x, x)
        self.assertEqual(x**0, 1)

    def test_reduce_replaces_every_square(self):
        c, s = variables("c s")
        relation = {"s": 1 - c * c}
        self.assertEqual((c * c + s * s).reduce(relation), 1)
        self.assertEqual((s**5).reduce(relation), s * (1 - c * c) ** 2)
        self.assertEqual((c * s).reduce(relation), c * s)

    def test_reduce_follows_rules_that_lead_to_one_another(self):
        x, y, z = self.x, self.y, self.z
        self.assertEqual((x**3).reduce({"x": y * y, "y": z}), x * z)

    def test_substitute(self):
        x, y = self.x, self.y
        self.assertEqual((x * x + y).substitute({"x": y + 1}), y * y + 3 * y + 1)
        self.assertEqual((x * y).substitute({"x": 2, "y": Fraction(1, 2)}).constant(), 1)
        self.assertEqual((x * y).substitute({"x": y, "y": x}), x * y)

    def test_constant_refuses_variables(self):
        self.assertEqual(Polynomial.of(7).constant(), 7)
        self.assertEqual(Polynomial().constant(), 0)
        with self.assertRaises(ValueError):
            self.x.constant()

    def test_collect(self):
        x, y = self.x, self.y
        collected = (x * x * y + 2 * x * x + y).collect(["x"])
        self.assertEqual(collected, {(("x", 2),): y + 2, (): y})

    def test_what_is_no_polynomial_is_refused(self):
        for operation in (lambda: self.x + "1", lambda: self.x - "1", lambda: self.x * "1"):
            with self.assertRaises(TypeError):
                operation()


class HelperTest(unittest.TestCase):
    """The helpers of the proofs must themselves be right."""

    def test_cosine_and_sine_to_fifty_digits(self):
        self.assertEqual(decimal(PI, 40), "3.1415926535897932384626433832795028841972")
        tolerance = Fraction(1, 10 ** (DIGITS - 2))
        self.assertLess(abs(cosine(PI / 3) - Fraction(1, 2)), tolerance)
        self.assertLess(abs(sine(PI / 6) - Fraction(1, 2)), tolerance)
        self.assertLess(abs(cosine(PI) + 1), tolerance)
        for k in range(1, 12):
            x = k * PI / 12
            self.assertLess(abs(cosine(x) ** 2 + sine(x) ** 2 - 1), tolerance)
            self.assertLess(abs(sine(2 * x) - 2 * sine(x) * cosine(x)), tolerance)

    def test_decimal_rounds_as_a_paper_prints(self):
        self.assertEqual(decimal(Fraction(-1, 3), 3), "-0.333")
        self.assertEqual(decimal(Fraction(2, 3), 4), "0.6667")
        self.assertEqual(decimal(Fraction(25, 2), 1), "12.5")
        self.assertEqual(decimal(Fraction(-1, 10**6), 3), "0.000")

    def test_derivatives(self):
        x, c, s = variables("x c s")
        rates = {"x": Polynomial.of(1), "c": -s, "s": c}
        self.assertEqual(differentiated(x**3 * e("1"), rates), 3 * x * x * e("1"))
        self.assertEqual(differentiated(multivector(x * c * c), rates), c * c - 2 * x * c * s)
        self.assertEqual(modulo(differentiated(multivector(c * c + s * s), rates), {}), 0)


if __name__ == "__main__":
    unittest.main()
