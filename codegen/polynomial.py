"""Exact polynomials: the canonical form in which two expressions are shown to be equal.

A polynomial is a finite sum of rational coefficients times monomials in named variables. Two polynomials
are equal exactly when their dictionaries are, so `==` is a proof and not a test.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Dict, Mapping, Tuple, Union

Monomial = Tuple[Tuple[str, int], ...]  # ((variable, exponent), ...), sorted by variable
Number = Union[int, Fraction]
ONE: Monomial = ()


class Polynomial:
    """An immutable polynomial over the rationals."""

    __slots__ = ("terms", "_hash")

    def __init__(self, terms: Mapping[Monomial, Number] = {}):
        self.terms: Dict[Monomial, Fraction] = {m: Fraction(c) for m, c in terms.items() if c}
        self._hash = None

    @staticmethod
    def variable(name: str) -> "Polynomial":
        return Polynomial({((name, 1),): 1})

    @staticmethod
    def of(value) -> "Polynomial":
        """The value itself if it is a polynomial, the constant polynomial if it is a number."""
        return value if isinstance(value, Polynomial) else Polynomial({ONE: Fraction(value)})

    def __add__(self, other) -> "Polynomial":
        if not isinstance(other, (Polynomial, int, Fraction)):
            return NotImplemented
        terms = dict(self.terms)
        for monomial, coefficient in Polynomial.of(other).terms.items():
            terms[monomial] = terms.get(monomial, Fraction(0)) + coefficient
        return Polynomial(terms)

    __radd__ = __add__

    def __neg__(self) -> "Polynomial":
        return Polynomial({m: -c for m, c in self.terms.items()})

    def __sub__(self, other) -> "Polynomial":
        return self + -1 * other

    def __rsub__(self, other) -> "Polynomial":
        return -self + other

    def __mul__(self, other) -> "Polynomial":
        if not isinstance(other, (Polynomial, int, Fraction)):
            return NotImplemented
        terms: Dict[Monomial, Fraction] = {}
        for m, c in self.terms.items():
            for n, d in Polynomial.of(other).terms.items():
                mn = multiply_monomials(m, n)
                terms[mn] = terms.get(mn, Fraction(0)) + c * d
        return Polynomial(terms)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> "Polynomial":
        return self * (1 / Fraction(other))

    def __pow__(self, exponent: int) -> "Polynomial":
        result = Polynomial.of(1)
        for _ in range(exponent):
            result = result * self
        return result

    def __eq__(self, other) -> bool:
        if not isinstance(other, (Polynomial, int, Fraction)):
            return NotImplemented
        return self.terms == Polynomial.of(other).terms

    def __hash__(self) -> int:
        if self._hash is None:
            self._hash = hash(frozenset(self.terms.items()))
        return self._hash

    def __bool__(self) -> bool:
        return bool(self.terms)

    def reduce(self, rules: Mapping[str, "Polynomial"]) -> "Polynomial":
        """Replace v² by rules[v] wherever a rule is given, until no such square is left.

        `reduce({"s": 1 - c * c})` is arithmetic modulo s² = 1 - c²; it ends as long as no rule leads back to
        its own variable.
        """
        result = Polynomial()
        for monomial, coefficient in self.terms.items():
            kept = Polynomial({ONE: coefficient})
            changed = False
            for name, exponent in monomial:
                if name in rules and exponent >= 2:
                    kept = kept * rules[name] ** (exponent // 2)
                    exponent, changed = exponent % 2, True
                if exponent:
                    kept = kept * Polynomial({((name, exponent),): 1})
            result = result + (kept.reduce(rules) if changed else kept)
        return result

    def substitute(self, values: Mapping[str, Union["Polynomial", Number]]) -> "Polynomial":
        """Replace variables by polynomials or numbers."""
        result = Polynomial()
        for monomial, coefficient in self.terms.items():
            term = Polynomial({ONE: coefficient})
            for name, exponent in monomial:
                term = term * Polynomial.of(values.get(name, Polynomial.variable(name))) ** exponent
            result = result + term
        return result

    def replace_by_quotient(self, name: str, quotient: "Quotient") -> "Polynomial":
        """The variable replaced by a quotient, times the power of its denominator that makes a polynomial of it."""
        powers = {dict(monomial).get(name, 0) for monomial in self.terms}
        degree = max(powers, default=0)
        result = Polynomial()
        for monomial, coefficient in self.terms.items():
            power = dict(monomial).get(name, 0)
            rest = Polynomial({tuple(factor for factor in monomial if factor[0] != name): coefficient})
            result = result + rest * quotient.numerator**power * quotient.denominator ** (degree - power)
        return result

    def is_constant(self) -> bool:
        return all(monomial == ONE for monomial in self.terms)

    def constant(self) -> Fraction:
        """The value of a polynomial without variables."""
        if not self.is_constant():
            raise ValueError(f"not a constant: {self}")
        return self.terms.get(ONE, Fraction(0))

    def collect(self, names) -> Dict[Monomial, "Polynomial"]:
        """The coefficients of the monomials in `names`, as polynomials in everything else."""
        wanted = set(names)
        collected: Dict[Monomial, Polynomial] = {}
        for monomial, coefficient in self.terms.items():
            inside = tuple(f for f in monomial if f[0] in wanted)
            outside = tuple(f for f in monomial if f[0] not in wanted)
            collected[inside] = collected.get(inside, Polynomial()) + Polynomial({outside: coefficient})
        return collected

    def __repr__(self) -> str:
        if not self.terms:
            return "0"
        text = []
        for monomial, coefficient in sorted(self.terms.items()):
            factors = [f"{n}^{e}" if e > 1 else n for n, e in monomial]
            sign = "-" if coefficient < 0 else "+"
            if abs(coefficient) != 1 or not factors:
                factors.insert(0, str(abs(coefficient)))
            text.append(f"{sign} {'*'.join(factors)}")
        return " ".join(text).lstrip("+ ")


@dataclass(frozen=True)
class Quotient:
    """What a variable is equal to wherever the denominator is not zero."""

    numerator: Polynomial
    denominator: Polynomial


def multiply_monomials(m: Monomial, n: Monomial) -> Monomial:
    exponents: Dict[str, int] = {}
    for name, exponent in m + n:
        exponents[name] = exponents.get(name, 0) + exponent
    return tuple(sorted(exponents.items()))


def variables(names: str) -> Tuple[Polynomial, ...]:
    """`x, y = variables("x y")`."""
    return tuple(Polynomial.variable(name) for name in names.split())
