"""The approximations: the functions are what they are called, the coefficients good, and the bounds bounds."""

from __future__ import annotations

import math
import struct
import unittest
from dataclasses import replace
from fractions import Fraction

from approximate import (
    FUNCTIONS,
    MANTISSA_BITS,
    TABLE,
    Approximation,
    Function,
    Search,
    error_bound,
    evaluate,
    literal,
    polynomial,
    prove_bound,
    round_to,
    taylor,
)

ROWS = [(name, precision) for name in TABLE for precision in MANTISSA_BITS]


def coefficient(name: str, k: int) -> Fraction:
    return FUNCTIONS[name].coefficient(k) if k >= 0 else Fraction(0)


def unit_of(precision: str) -> Fraction:
    """Half an epsilon: the largest relative error of one rounding."""
    return Fraction(1, 2 ** MANTISSA_BITS[precision])


def sampled_errors(name: str, precision: str, weight: int = 0, count: int = 250):
    """The errors at many places, those of a 40-digit Taylor polynomial; exact otherwise."""
    row = TABLE[name]
    series, remainder = taylor(row.function, row.end, 133)
    assert remainder < Fraction(1, 10**40)
    for i in range(count + 1):
        x = row.end * i / count
        yield x**weight * (evaluate(polynomial(name, precision), x) - evaluate(series, x))


def least_error(row: Approximation, precision: str) -> Fraction:
    """The largest error, on the grid, of the best polynomial before any rounding."""
    search = Search(row, precision)
    return Fraction(max(map(abs, search.errors(search.minimax([]), search.values, 0))))


class Functions(unittest.TestCase):
    """The series against identities that hold for the functions alone, coefficient by coefficient."""

    def test_they_are_the_functions(self):
        definitions = {
            "cosine": lambda x: math.cos(math.sqrt(x)),
            "sinc": lambda x: math.sin(math.sqrt(x)) / math.sqrt(x),
            "sinc_slope": lambda x: (math.cos(math.sqrt(x)) - math.sin(math.sqrt(x)) / math.sqrt(x)) / x,
            "arc": lambda z: math.acos(1 - z) / math.sqrt(z * (2 - z)),
            "adjoint": lambda x: (1 - math.sin(2 * math.sqrt(x)) / (2 * math.sqrt(x))) / (4 * x),
            "adjoint_slope": lambda x: (
                1.5 * math.sin(2 * math.sqrt(x)) / (2 * math.sqrt(x)) - 0.5 * math.cos(2 * math.sqrt(x)) - 1
            )
            / (4 * x * x),
            "arc_slope": lambda z: ((1 - z) * math.acos(1 - z) / math.sqrt(z * (2 - z)) - 1) / (z * (2 - z)),
        }
        self.assertEqual(set(definitions), set(FUNCTIONS))
        for name, definition in definitions.items():
            series, _ = taylor(TABLE[name].function, TABLE[name].end, 80)
            for i in range(1, 20):
                x = TABLE[name].end * i / 20
                self.assertAlmostEqual(float(evaluate(series, x)), definition(float(x)), delta=1e-13, msg=name)

    def test_the_cosine_needs_no_polynomial_of_its_own(self):
        for k in range(40):  # C = S + x D
            self.assertEqual(coefficient("cosine", k), coefficient("sinc", k) + coefficient("sinc_slope", k - 1))

    def test_slopes_are_derivatives(self):
        for k in range(40):  # C' = -S/2, S' = D/2, and of f by s = 1 - z
            self.assertEqual((k + 1) * coefficient("cosine", k + 1), -coefficient("sinc", k) / 2)
            self.assertEqual((k + 1) * coefficient("sinc", k + 1), coefficient("sinc_slope", k) / 2)
            self.assertEqual((k + 1) * coefficient("adjoint", k + 1), coefficient("adjoint_slope", k))
            self.assertEqual(-(k + 1) * coefficient("arc", k + 1), coefficient("arc_slope", k))

    def test_the_arc_satisfies_its_differential_equation(self):
        for k in range(40):  # (1 - s²) f' = s f - 1 with s = 1 - z
            left = 2 * coefficient("arc_slope", k - 1) - coefficient("arc_slope", k - 2)
            right = coefficient("arc", k) - coefficient("arc", k - 1) - (1 if k == 0 else 0)
            self.assertEqual(left, right)

    def test_the_growth_bounds_all_later_ratios(self):
        for function in FUNCTIONS.values():
            ratios = [abs(function.coefficient(k + 1) / function.coefficient(k)) for k in range(120)]
            for k in range(60):
                self.assertLessEqual(max(ratios[k:]), function.growth(k), (function.name, k))


class Rounding(unittest.TestCase):
    def test_to_float_as_the_machine_rounds(self):
        for value in (Fraction(1, 3), Fraction(-2, 7), Fraction(2**25 + 1), Fraction(2**24 + 1), Fraction(2**24 + 3)):
            machine = struct.unpack("f", struct.pack("f", float(value)))[0]
            self.assertEqual(round_to(value, 24), Fraction(machine))
        for value in (Fraction(1, 3), Fraction(10**30, 7), Fraction(-1, 10**20)):
            self.assertEqual(round_to(value, 53), Fraction(float(value)))
        self.assertEqual(round_to(Fraction(0), 24), 0)

    def test_literals_read_back(self):
        self.assertEqual(literal(Fraction(1), "f32"), "1.0")
        self.assertEqual(literal(round_to(Fraction(1, 10), 24), "f32"), "0.1")
        self.assertEqual(literal(Fraction(1, 2**40), "f64"), "9.094947017729282e-13")
        with self.assertRaises(ValueError):
            literal(Fraction(1, 3), "f64")
        for name, precision in ROWS:
            for c in polynomial(name, precision):
                read = float(literal(c, precision))
                if precision == "f32":
                    read = struct.unpack("f", struct.pack("f", read))[0]
                self.assertEqual(Fraction(read), c)


class Exchange(unittest.TestCase):
    def test_the_best_line_through_a_parabola(self):
        parabola = Function("x²", "", lambda k: Fraction(k == 2), lambda k: Fraction(4 if k < 2 else 0))
        line = Search(Approximation(parabola, Fraction(1), 0, (("f64", 1),)), "f64").minimax([])
        self.assertAlmostEqual(float(line[0]), -0.125, delta=1e-3)  # x - 1/8
        self.assertAlmostEqual(float(line[1]), 1.0, delta=1e-3)

    def test_the_error_swings_between_equal_extremes(self):
        for name, precision in ROWS:
            row = TABLE[name]
            search = Search(row, precision)
            errors = search.errors(search.minimax([]), search.values, 0)
            extremes = []
            for error in errors:
                if extremes and (extremes[-1] < 0) == (error < 0):
                    extremes[-1] = max(extremes[-1], error, key=abs)
                else:
                    extremes.append(error)
            # A polynomial with that many alternations is the best there is, up to how unequal they are.
            self.assertEqual(len(extremes), row.degree(precision) + 2, (name, precision))
            self.assertLess(max(map(abs, extremes)), min(map(abs, extremes)) * type(errors[0])("1.05"))


class Coefficients(unittest.TestCase):
    def test_they_are_exact_in_their_precision(self):
        for name, precision in ROWS:
            coefficients = polynomial(name, precision)
            self.assertEqual(len(coefficients), TABLE[name].degree(precision) + 1)
            for c in coefficients:
                self.assertEqual(round_to(c, MANTISSA_BITS[precision]), c)

    def test_the_constant_is_the_value_at_0(self):
        for name, precision in ROWS:
            self.assertEqual(
                polynomial(name, precision)[0], round_to(TABLE[name].function.coefficient(0), MANTISSA_BITS[precision])
            )
        for name in ("cosine", "sinc", "arc"):  # on which the exactness of pure translations rests
            self.assertEqual(polynomial(name, "f32")[0], 1)

    def test_the_error_is_less_than_half_a_rounding(self):
        for name, precision in ROWS:
            bound = error_bound(name, precision, TABLE[name].weight)
            self.assertLess(bound, unit_of(precision) / 2, (name, precision))

    def test_degrees_are_the_smallest_that_are_good_to_a_third_of_a_rounding(self):
        for name, precision in ROWS:
            row = TABLE[name]
            shorter = replace(row, degrees=((precision, row.degree(precision) - 1),))
            limit = unit_of(precision) / 3
            self.assertLess(least_error(row, precision), limit, (name, precision))
            self.assertGreater(least_error(shorter, precision), limit, (name, precision))


class Bounds(unittest.TestCase):
    def test_no_sample_exceeds_the_bound_and_the_bound_is_close(self):
        for name, precision in ROWS:
            for weight in {0, TABLE[name].weight}:
                bound = error_bound(name, precision, weight)
                largest = max(map(abs, sampled_errors(name, precision, weight)))
                self.assertLessEqual(largest, bound, (name, precision))
                self.assertLess(bound, largest * Fraction(11, 10), (name, precision))

    def test_a_wrong_coefficient_is_caught(self):
        for name, precision in (("sinc", "f32"), ("sinc_slope", "f64"), ("arc", "f32"), ("arc_slope", "f64")):
            row, bound = TABLE[name], error_bound(name, precision)
            for k in (0, 1, row.degree(precision) // 2, row.degree(precision)):
                wrong = list(polynomial(name, precision))
                wrong[k] += 4 * bound / row.end**k
                self.assertGreater(prove_bound(row.function, row.end, wrong), 2 * bound, (name, precision, k))

    def test_another_function_is_caught(self):
        row = TABLE["sinc"]
        self.assertGreater(prove_bound(FUNCTIONS["cosine"], row.end, polynomial("sinc", "f64")), Fraction(1, 2))

    def test_the_bound_of_a_polynomial_that_is_known(self):
        # Against 0 the bound of x (1 - x) is 1/4, and times x, at 2/3, 4/27.
        zero = Function("0", "", lambda k: Fraction(0), lambda k: Fraction(0))
        for weight, truth in ((0, Fraction(1, 4)), (1, Fraction(4, 27))):
            bound = prove_bound(zero, Fraction(1), [Fraction(0), Fraction(1), Fraction(-1)], weight)
            self.assertLessEqual(truth, bound)
            self.assertLess(bound, truth * Fraction(33, 32) + Fraction(1, 10**20))


if __name__ == "__main__":
    unittest.main()
