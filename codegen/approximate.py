"""Minimax polynomials with proven error bounds, for the functions that the motor group needs.

    polynomial("sinc", "f32")     the coefficients, from the constant upwards, each exact in the precision
    error_bound("sinc", "f32")    a proven bound of |polynomial - function| on the interval of the table

Kernels have no mathematical library under them: exp, log and slerp of motors are made of five functions, and the
velocity of exp of two more,

    cosine        C(x) = cos √x                   entire, though √x is not
    sinc          S(x) = sin √x / √x              entire
    sinc_slope    D(x) = (C - S) / x = 2 S'(x)    entire; so C = S + x D needs no polynomial of its own
    arc           f(z) = acos(s) / √(1 - s²)      analytic in z = 1 - s as far as z = 2, where s = -1
    arc_slope     df/ds = (s f - 1) / (1 - s²)    likewise
    adjoint       Q(x) = (1 - S C) / 4x           entire
    adjoint_slope Q'(x)                           entire

none of them above π/2 in magnitude on its interval, so that absolute errors below half an epsilon are what is wanted.
A constant term is the function's own value at 0, rounded: exp of a pure translation, and the log of one, are exact
because S(0) = 1 and f(0) = 1 are.

Coefficients come from a Remez exchange in 60-digit arithmetic. They are rounded one after the other, from the
constant upwards, and after each the exchange finds the best of those that are left. The bound of the error is then
proved, without trust in any of that: the function is its Taylor polynomial and a remainder below a geometric
series, and the difference of the two polynomials is bounded piece by piece, in exact arithmetic.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from functools import lru_cache
from math import factorial
from typing import Callable, Dict, List, Sequence, Tuple

MANTISSA_BITS = {"f32": 24, "f64": 53}
DIGITS = 60  # of the exchange


@dataclass(frozen=True)
class Function:
    """A power series Σ a_k x^k, and what bounds its remainder: |a_(j+1) / a_j| <= growth(k) for all j >= k."""

    name: str
    meaning: str
    coefficient: Callable[[int], Fraction]
    growth: Callable[[int], Fraction]


def _arc_coefficient(k: int) -> Fraction:
    return Fraction(2**k * factorial(k) ** 2, factorial(2 * k + 1))


def _adjoint_coefficient(k: int) -> Fraction:
    return Fraction((-4) ** k, factorial(2 * k + 3))


FUNCTIONS: Dict[str, Function] = {
    function.name: function
    for function in (
        Function(
            "cosine",
            "cos √x",
            lambda k: Fraction((-1) ** k, factorial(2 * k)),
            lambda k: Fraction(1, (2 * k + 1) * (2 * k + 2)),
        ),
        Function(
            "sinc",
            "sin √x / √x",
            lambda k: Fraction((-1) ** k, factorial(2 * k + 1)),
            lambda k: Fraction(1, (2 * k + 2) * (2 * k + 3)),
        ),
        Function(
            "sinc_slope",
            "(cos √x - sin √x / √x) / x",
            lambda k: Fraction((-1) ** (k + 1) * (2 * k + 2), factorial(2 * k + 3)),
            lambda k: Fraction(1, (2 * k + 2) * (2 * k + 5)),
        ),
        Function("arc", "acos(s) / √(1 - s²), x = 1 - s", _arc_coefficient, lambda k: Fraction(1, 2)),
        Function(
            "arc_slope",
            "(s acos(s) / √(1 - s²) - 1) / (1 - s²), x = 1 - s",
            lambda k: -(k + 1) * _arc_coefficient(k + 1),
            lambda k: Fraction((k + 2) ** 2, (k + 1) * (2 * k + 5)),
        ),
        Function(
            "adjoint",
            "(1 - sin(2√x) / 2√x) / 4x",
            _adjoint_coefficient,
            lambda k: Fraction(4, (2 * k + 4) * (2 * k + 5)),
        ),
        Function(
            "adjoint_slope",
            "the derivative of (1 - sin(2√x) / 2√x) / 4x",
            lambda k: (k + 1) * _adjoint_coefficient(k + 1),
            lambda k: Fraction(4 * (k + 2), (k + 1) * (2 * k + 6) * (2 * k + 7)),
        ),
    )
}


@dataclass(frozen=True)
class Approximation:
    """A row of the table: the interval is [0, end], the degree one a precision.

    The largest |x^weight (polynomial - function)| is made small: with weight 0 the absolute error, with weight 1
    that of x times the polynomial, where x is large and it is used in no other way.
    """

    function: Function
    end: Fraction
    weight: int
    degrees: Tuple[Tuple[str, int], ...]

    def degree(self, precision: str) -> int:
        return dict(self.degrees)[precision]


# A degree is the smallest whose best error is below a third of u, half an epsilon: tested.
# Angles are reduced to [-π/2, π/2], so x <= π²/4 = 2.47: the rest is room for a reduction that is itself rounded. The
# weights of slerp and the velocities of motions take angles up to π, x <= π² = 9.87, as they are.
# Beyond x = 1 the adjoint functions are taken from S and C. On the shortest path 0 <= s <= 1; where rounding makes s
# exceed 1 a little the polynomials run on smoothly.
HALF_CIRCLE = Fraction(21, 2)
QUARTER_CIRCLE = Fraction(13, 5)

TABLE: Dict[str, Approximation] = {
    name: Approximation(FUNCTIONS[name.replace("short_", "")], end, weight, (("f32", single), ("f64", double)))
    for name, end, weight, single, double in (
        ("cosine", HALF_CIRCLE, 0, 6, 11),
        ("sinc", HALF_CIRCLE, 0, 6, 10),
        ("sinc_slope", HALF_CIRCLE, 1, 5, 10),
        ("short_sinc", QUARTER_CIRCLE, 0, 4, 8),
        ("short_sinc_slope", QUARTER_CIRCLE, 1, 4, 7),
        ("arc", Fraction(1), 0, 9, 21),
        ("arc_slope", Fraction(1), 0, 10, 22),
        ("adjoint", Fraction(1), 0, 4, 7),
        ("adjoint_slope", Fraction(1), 0, 3, 7),
    )
}


@lru_cache(maxsize=None)
def polynomial(name: str, precision: str) -> Tuple[Fraction, ...]:
    """The coefficients of an approximation, from the constant upwards, exact in the precision."""
    return Search(TABLE[name], precision).rounded_minimax()


@lru_cache(maxsize=None)
def error_bound(name: str, precision: str, weight: int = 0) -> Fraction:
    """A proven bound of |x^weight (polynomial(x) - function(x))| for 0 <= x <= end."""
    row = TABLE[name]
    return prove_bound(row.function, row.end, polynomial(name, precision), weight, MANTISSA_BITS[precision] + 40)


# ------------------------------------------------------------------------------------------------- real numbers

PI_DIGITS = 500  # more than the bits of 1/(2π) below take


def pi_by_machin() -> Fraction:
    def arctan_of_inverse(n: int) -> Decimal:
        power, total, k = 1 / Decimal(n), Decimal(0), 0
        while total + power / (2 * k + 1) != total:
            total += (-1) ** k * power / (2 * k + 1)
            power /= n * n
            k += 1
        return total

    with localcontext() as context:
        context.prec = PI_DIGITS
        return Fraction(16 * arctan_of_inverse(5) - 4 * arctan_of_inverse(239))


PI = pi_by_machin()


def parts(value: Fraction, precision: str) -> Tuple[Fraction, Fraction]:
    """A real number as the sum of the nearest number of the precision and of what that lacks, rounded."""
    first = round_to(value, MANTISSA_BITS[precision])
    return first, round_to(value - first, MANTISSA_BITS[precision])


SMALLEST_LENGTHS = {"f32": 120, "f64": 1000}

# Those that kernels use, by name: what they are, and their value in a precision.
REAL_NUMBERS: Dict[str, Tuple[str, Callable[[str], Fraction]]] = {
    "pi": ("π", lambda precision: parts(PI, precision)[0]),
    "half_pi": ("π/2", lambda precision: parts(PI / 2, precision)[0]),
    "pi_rest": ("π - pi", lambda precision: parts(PI, precision)[1]),
    "two_pi": ("2π", lambda precision: parts(2 * PI, precision)[0]),
    "two_pi_rest": ("2π - two_pi", lambda precision: parts(2 * PI, precision)[1]),
    "pi_high": ("the first half of the bits of pi", lambda precision: halves_of_pi(precision)[0]),
    "pi_low": ("the second half", lambda precision: halves_of_pi(precision)[1]),
    # Of two vectors, one that is shorter by this (squared) has no direction but that of rounding.
    "gimbal_lock": ("the square of 8 epsilons", lambda precision: Fraction(64, 4 ** (MANTISSA_BITS[precision] - 1))),
    # By its inverse, which does not overflow, it brings the smallest numbers so far up that their squares are normal.
    "smallest_length": ("less than other lengths", lambda precision: Fraction(1, 2 ** SMALLEST_LENGTHS[precision])),
    "inverse_pi": ("1/π", lambda precision: parts(1 / PI, precision)[0]),
    "inverse_two_pi": ("1/(2π)", lambda precision: parts(1 / (2 * PI), precision)[0]),
}


def halves_of_pi(precision: str) -> Tuple[Fraction, Fraction]:
    pi = parts(PI, precision)[0]
    high = round_to(pi, MANTISSA_BITS[precision] // 2)
    return high, pi - high


# Of 1/(2π), for angles up to the largest double: those of a mantissa that stand for whole turns are skipped, and 320
# more are enough for the nearest that any double comes to a whole turn.
TURN_WORDS = 42


def inverse_two_pi_words() -> List[int]:
    """The bits of 1/(2π) behind the point, in words of 32, the highest first."""
    bits = int(2 ** (32 * TURN_WORDS) / (2 * PI))
    return [bits >> (32 * (TURN_WORDS - 1 - k)) & 0xFFFFFFFF for k in range(TURN_WORDS)]


# ------------------------------------------------------------------------------------------------------ rounding


def round_to(value: Fraction, bits: int) -> Fraction:
    """The nearest number with a mantissa of so many bits; ties to even. (Nothing here is near under- or overflow.)"""
    if not value:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length()
    if abs(value) < Fraction(2) ** exponent:
        exponent -= 1
    unit = Fraction(2) ** (exponent - bits + 1)
    return round(value / unit) * unit


def literal(value: Fraction, precision: str) -> str:
    """A coefficient as the shortest decimal literal that reads back as the same number of that precision."""
    bits = MANTISSA_BITS[precision]
    if round_to(value, bits) != value:
        raise ValueError(f"{value} is not exact in {precision}")
    for digits in range(1, 18):
        text = f"{float(value):.{digits}g}"
        if round_to(Fraction(text), bits) == value:
            return text if any(c in text for c in ".e") else text + ".0"
    raise AssertionError("17 digits tell all doubles apart")


# --------------------------------------------------------------------------------------------- the Remez exchange


def taylor(function: Function, end: Fraction, bits: int) -> Tuple[List[Fraction], Fraction]:
    """Coefficients of a Taylor polynomial on [0, end], and a bound of the remainder, below 2^-bits."""
    coefficients: List[Fraction] = []
    while True:
        k = len(coefficients)
        ratio = function.growth(k) * end
        if ratio < 1:
            remainder = abs(function.coefficient(k)) * end**k / (1 - ratio)
            if remainder < Fraction(1, 2**bits):
                return coefficients, remainder
        coefficients.append(function.coefficient(k))


def evaluate(coefficients: Sequence, x):
    """Horner's scheme."""
    value = x * 0
    for c in reversed(coefficients):
        value = value * x + c
    return value


def solve(matrix: List[List[Decimal]], right: List[Decimal]) -> List[Decimal]:
    """Gaussian elimination with partial pivoting."""
    rows = [row + [value] for row, value in zip(matrix, right)]
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, size):
            factor = rows[i][k] / rows[k][k]
            if factor:
                rows[i][k:] = [a - factor * b for a, b in zip(rows[i][k:], rows[k][k:])]
    result = [Decimal(0)] * size
    for k in reversed(range(size)):
        known = sum(rows[k][j] * result[j] for j in range(k + 1, size))
        result[k] = (rows[k][size] - known) / rows[k][k]
    return result


def alternating_extrema(errors: Sequence[Decimal], count: int) -> List[int]:
    """Where a function sampled on a grid is extreme with alternating signs: `count` places, the largest."""
    places: List[int] = []
    for i, error in enumerate(errors):
        if places and (errors[places[-1]] < 0) == (error < 0):
            if abs(error) > abs(errors[places[-1]]):
                places[-1] = i
        else:
            places.append(i)
    while len(places) > count:
        places.pop(0 if abs(errors[places[0]]) < abs(errors[places[-1]]) else -1)
    return places


def _decimal(value: Fraction) -> Decimal:
    with localcontext() as context:
        context.prec = DIGITS
        return Decimal(value.numerator) / value.denominator


class Search:
    """One row of the table in one precision: the state of the search for its coefficients."""

    GRID_PER_EXTREMUM = 24

    def __init__(self, row: Approximation, precision: str):
        self.degree, self.bits = row.degree(precision), MANTISSA_BITS[precision]
        self.constant = row.function.coefficient(0)
        series, _ = taylor(row.function, row.end, self.bits + 40)
        with localcontext() as context:
            context.prec = DIGITS
            grid = self._chebyshev_grid(row.end)
            self.values = [x**row.weight * evaluate([_decimal(c) for c in series], x) for x in grid]
            self.powers = [[x ** (row.weight + k) for k in range(self.degree + 1)] for x in grid]

    def _chebyshev_grid(self, end: Fraction) -> List[Decimal]:
        """Points of (0, end], dense towards both ends: extrema of a polynomial are."""
        count = self.GRID_PER_EXTREMUM * (self.degree + 2)
        shape = [Fraction(i, count) for i in range(1, count + 1)]
        smooth = [u * u * (3 - 2 * u) * end for u in shape]  # quadratic at both ends, as Chebyshev's points are
        return [_decimal(x) for x in smooth]

    def minimax(self, fixed: Sequence[Fraction]) -> List[Decimal]:
        """The best coefficients after those that are fixed already, by exchange of the points of largest error."""
        first, count = len(fixed), self.degree + 2 - len(fixed)
        with localcontext() as context:
            context.prec = DIGITS
            wanted = [-error for error in self.errors([_decimal(c) for c in fixed], self.values, 0)]
            last = len(wanted) - 1
            places = [round(last * Fraction(2 * i + 1, 2 * count)) for i in range(count)]
            best, smallest = [], None
            for _ in range(12):
                matrix = [self.powers[i][first:] + [Decimal((-1) ** j)] for j, i in enumerate(places)]
                free = solve(matrix, [wanted[i] for i in places])[:-1]
                errors = self.errors(free, wanted, first)
                largest = max(map(abs, errors))
                if smallest is None or largest < smallest:
                    best, smallest = free, largest
                places, before = alternating_extrema(errors, count), places
                if len(places) < count or places == before:
                    break
        return best

    def errors(self, coefficients: Sequence[Decimal], wanted: Sequence[Decimal], first: int) -> List[Decimal]:
        """Σ c_k x^(first + k) less what it should be, on the grid, both times x^weight."""
        with localcontext() as context:
            context.prec = DIGITS
            rows = (zip(coefficients, powers[first:]) for powers in self.powers)
            return [sum(c * power for c, power in row) - value for row, value in zip(rows, wanted)]

    def largest_error(self, coefficients: Sequence[Fraction]) -> Decimal:
        return max(map(abs, self.errors([_decimal(c) for c in coefficients], self.values, 0)))

    def rounded_minimax(self) -> Tuple[Fraction, ...]:
        """The constant is the function's own; each further coefficient is rounded and the rest found anew.

        Now and then rounding all at once happens to be better: then that is taken.
        """
        fixed = [round_to(self.constant, self.bits)]
        at_once = fixed + [round_to(Fraction(c), self.bits) for c in self.minimax(fixed)]
        while len(fixed) <= self.degree:
            fixed.append(round_to(Fraction(self.minimax(fixed)[0]), self.bits))
        return tuple(min(fixed, at_once, key=self.largest_error))


# ------------------------------------------------------------------------------------------------------ the proof

FRACTION_BITS = 192  # of the integers that stand for numbers
PIECE_TOLERANCE = 32  # a piece is split while its bound is more than 1/32 above the largest error seen


def prove_bound(
    function: Function, end: Fraction, coefficients: Sequence[Fraction], weight: int = 0, bits: int = 93
) -> Fraction:
    """A number that |x^weight (Σ c_k x^k - function(x))| nowhere exceeds for 0 <= x <= end.

    The function is its Taylor polynomial to within 2^-bits. With x = end · u the difference of the two polynomials is
    a polynomial in u on [0, 1]. Its coefficients are taken as multiples of 2^-FRACTION_BITS; what that neglects is
    added to the bound, as the remainder of the series is. On a piece of centre m and radius r a polynomial with the
    coefficients c_k about m is at most |c_0| + |c_1| r + |c_2| r² + ...
    """
    series, remainder = taylor(function, end, bits)
    size = max(len(series), len(coefficients))
    padded = [list(c) + [Fraction(0)] * (size - len(c)) for c in (coefficients, series)]
    scaled = [(p - t) * end ** (weight + k) * 2**FRACTION_BITS for k, (p, t) in enumerate(zip(*padded))]
    difference = [round(c) for c in scaled]
    neglected = sum(abs(c - i) for c, i in zip(scaled, difference))
    bound = _bound_of_polynomial([0] * weight + difference) + neglected
    return bound / 2**FRACTION_BITS + end**weight * remainder


def _bound_of_polynomial(coefficients: Sequence[int]) -> Fraction:
    """A bound of |Σ c_k u^k| on [0, 1], not more than 1/PIECE_TOLERANCE above the truth but for integer roundings."""
    pieces = [(Fraction(1, 2), Fraction(1, 2))]
    seen = max(abs(coefficients[0]), abs(sum(coefficients)))
    accepted = Fraction(0)
    while pieces:
        centre, radius = pieces.pop()
        local = _about(coefficients, centre)
        seen = max(seen, abs(local[0]))
        bound = evaluate([abs(c) for c in local], radius)
        if bound * PIECE_TOLERANCE <= seen * (PIECE_TOLERANCE + 1) or bound <= accepted:
            accepted = max(accepted, bound)
        else:
            pieces += [(centre - radius / 2, radius / 2), (centre + radius / 2, radius / 2)]
    return accepted


def _about(coefficients: Sequence[int], centre: Fraction) -> List[Fraction]:
    """The coefficients about another point, exactly: Horner's scheme again and again, over the power of two below."""
    shift = centre.denominator.bit_length() - 1
    size = len(coefficients)
    local = [c << (shift * (size - 1 - k)) for k, c in enumerate(coefficients)]  # about 0, in units of 2^-shift
    for start in range(size):
        for k in reversed(range(start, size - 1)):
            local[k] += centre.numerator * local[k + 1]
    return [Fraction(c, 1 << (shift * (size - 1 - k))) for k, c in enumerate(local)]


def main() -> None:
    """Print every approximation, for people."""
    for name, row in TABLE.items():
        for precision, _ in row.degrees:
            print(f"{name} {precision}: {row.function.meaning} on [0, {row.end}]")
            for weight in sorted({0, row.weight}):
                bound = float(error_bound(name, precision, weight))
                ulps = bound * 2 ** MANTISSA_BITS[precision]
                print(f"    error{' times x' * weight} < {bound:.3g} = {ulps:.3f} u")
            for c in polynomial(name, precision):
                print(f"    {literal(c, precision)}")


if __name__ == "__main__":
    main()
