"""π, cosine and sine to 50 digits as fractions, by their power series: for comparing decimals printed in papers."""

from fractions import Fraction

DIGITS = 50
_TINY = Fraction(1, 10 ** (DIGITS + 5))


def _alternating(first: Fraction, ratio) -> Fraction:
    """first - first ratio(0) + first ratio(0) ratio(1) - ..., until a term is below the last digit."""
    total, term, k = Fraction(0), first, 0
    while abs(term) > _TINY:
        total += term
        term, k = -term * ratio(k), k + 1
    return total


def _arccotangent(x: int) -> Fraction:
    return _alternating(Fraction(1, x), lambda k: Fraction(2 * k + 1, (2 * k + 3) * x * x))


# Machin's formula.
PI = round(4 * (4 * _arccotangent(5) - _arccotangent(239)), DIGITS + 3)


def cosine(x: Fraction) -> Fraction:
    return round(_alternating(Fraction(1), lambda k: x * x / ((2 * k + 1) * (2 * k + 2))), DIGITS)


def sine(x: Fraction) -> Fraction:
    return round(_alternating(x, lambda k: x * x / ((2 * k + 2) * (2 * k + 3))), DIGITS)


def decimal(x: Fraction, places: int) -> str:
    """The number rounded to so many places, as a paper prints it."""
    scaled = round(abs(x) * 10**places)
    digits = str(scaled).rjust(places + 1, "0")
    return ("-" if x < 0 and scaled else "") + digits[:-places] + "." + digits[-places:]
