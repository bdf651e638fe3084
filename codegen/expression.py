"""Immutable, hash-consed expressions with exact rational coefficients.

There are eight kinds of node: a symbol, a sum of products, a quotient, a square root, a named value, a function
whose values are all that is known of it, a component of one that has several, and a real number that each precision
rounds in its own way. A sum
holds terms, each a rational coefficient times a product of nodes; a single product and a constant are sums of one
term. Building the same expression twice gives the same object, so equality of nodes is identity, and a node that
occurs in two places is computed once. A named value is computed as it stands: nothing is merged across its border.

Products of sums are *not* multiplied out: how a formula is written decides what is computed. `expand` multiplies
out, into the canonical form in which two ways of writing a formula are shown to be equal.
"""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from functools import lru_cache
from math import gcd, isqrt
from typing import Dict, Iterable, Tuple, Union

from polynomial import Polynomial, Quotient

Number = Union[int, Fraction]
Term = Tuple[Fraction, Tuple["Node", ...]]


class Node:
    """One node; made by the functions of this module only."""

    __slots__ = ("kind", "name", "terms", "operands", "index")
    _table: Dict[tuple, "Node"] = {}

    def __new__(cls, kind: str, name: str = "", terms: Tuple[Term, ...] = (), operands: Tuple["Node", ...] = ()):
        key = (kind, name, terms, operands)
        node = cls._table.get(key)
        if node is None:
            node = super().__new__(cls)
            node.kind, node.name, node.terms, node.operands = key
            node.index = len(cls._table)  # the order of creation, which is the same in every run
            cls._table[key] = node
        return node

    def __add__(self, other):
        return add(self, node(other))

    __radd__ = __add__

    def __neg__(self):
        return sum_of((-c, factors) for c, factors in terms_of(self))

    def __sub__(self, other):
        return add(self, -node(other))

    def __rsub__(self, other):
        return add(node(other), -self)

    def __mul__(self, other):
        if not isinstance(other, (Node, int, Fraction)):
            return NotImplemented
        return multiply(self, node(other))

    __rmul__ = __mul__

    def __truediv__(self, other):
        return divide(self, node(other))

    def __rtruediv__(self, other):
        return divide(node(other), self)

    def __eq__(self, other) -> bool:
        if isinstance(other, (int, Fraction)):
            other = constant(other)
        return self is other

    __hash__ = object.__hash__

    def __repr__(self) -> str:
        if self.kind in ("symbol", "precise"):
            return self.name
        if self.kind == "function":
            return f"{self.name}{self.operands}"
        if self.kind == "named":
            return f"{self.name}:={self.operands[0]}"
        if self.kind == "sum":
            return "(" + " + ".join("*".join([str(c), *map(repr, f)]) for c, f in self.terms) + ")"
        return f"{self.kind}{self.operands}"


def symbol(name: str) -> Node:
    return Node("symbol", name=name)


def constant(value: Number) -> Node:
    return _sum({(): Fraction(value)})


def named(name: str, value: Node) -> Node:
    """The value under a name, for the reader of the generated code. Symbols and constants have theirs already."""
    return value if value.kind in ("symbol", "precise") or is_constant(value) else Node("named", name, operands=(value,))


def node(value) -> Node:
    return value if isinstance(value, Node) else constant(value)


def is_constant(n: Node) -> bool:
    return n.kind == "sum" and all(not factors for _, factors in n.terms)


def terms_of(n: Node) -> Tuple[Term, ...]:
    """A node as the terms of a sum."""
    return n.terms if n.kind == "sum" else ((Fraction(1), (n,)),)


def as_term(n: Node) -> Term:
    """A node as one coefficient times a product. A sum of several terms becomes its content times a sum with
    coprime coefficients, not all of them negative, so that multiples of a sum share one node."""
    terms = terms_of(n)
    if len(terms) == 1:
        return terms[0]
    if not terms:
        return (Fraction(0), ())
    numerator, denominator = 0, 1
    for c, _ in terms:
        numerator = gcd(numerator, c.numerator)
        denominator = denominator * c.denominator // gcd(denominator, c.denominator)
    content = Fraction(numerator, denominator) * (-1 if all(c < 0 for c, _ in terms) else 1)
    return (content, (Node("sum", terms=tuple((c / content, f) for c, f in terms)),))


def _sum(terms: Dict[Tuple[Node, ...], Fraction]) -> Node:
    kept = tuple((c, factors) for factors, c in terms.items() if c)
    if len(kept) == 1 and kept[0][0] == 1 and len(kept[0][1]) == 1:
        return kept[0][1][0]
    return Node("sum", terms=kept)


def sum_of(terms: Iterable[Term]) -> Node:
    """A sum from its terms; equal products are merged, the order of first occurrence is kept."""
    merged: Dict[Tuple[Node, ...], Fraction] = {}
    for c, factors in terms:
        merged[factors] = merged.get(factors, Fraction(0)) + c
    return _sum(merged)


def add(a: Node, b: Node) -> Node:
    return sum_of(terms_of(a) + terms_of(b))


def scale(a: Node, factor: Fraction) -> Node:
    return multiply(a, constant(factor))


def multiply(a: Node, b: Node) -> Node:
    (c, f), (d, g) = as_term(a), as_term(b)
    return sum_of([(c * d, tuple(sorted(f + g, key=lambda n: n.index)))])


def divide(a: Node, b: Node) -> Node:
    if is_constant(b):
        if b == 0:
            raise ZeroDivisionError("division by the constant 0")
        return scale(a, 1 / b.terms[0][0])
    return Node("quotient", operands=(a, b))


def root(value):
    """The square root: a node for an expression; exact, or an error, for a rational number."""
    if isinstance(value, Node):
        return Node("root", operands=(value,))
    value = Fraction(value)
    numerator, denominator = isqrt(value.numerator), isqrt(value.denominator)
    if numerator * numerator != value.numerator or denominator * denominator != value.denominator:
        raise ValueError(f"{value} has no rational square root")
    return Fraction(numerator, denominator)


def function(name: str, *operands) -> Node:
    """An analytic function by its approximation, or a step that is none: rounding, a magnitude, a choice."""
    return Node("function", name, operands=tuple(map(node, operands)))


def component(values: Node, name: str) -> Node:
    """One of the values of a function that has several, by its name in the generated code."""
    return Node("component", name, operands=(values,))


def precise(name: str) -> Node:
    """A real number that is not rational, by its name in the generated code."""
    return Node("precise", name)


# --------------------------------------------------------------------------------------------- the canonical form


class Expansion:
    """A quotient of polynomials. Square roots are further variables, with the rule that says what they square to.

    The denominator is kept as powers of its factors, so that sums over the same few denominators stay small.
    """

    def __init__(self, numerator: Polynomial, factors: Dict[Polynomial, int], rules: Dict[str, Polynomial]):
        self.numerator, self.factors, self.rules = numerator, factors, rules

    @property
    def denominator(self) -> Polynomial:
        return power_product(self.factors)

    def over(self, factors: Dict[Polynomial, int]) -> Polynomial:
        """The numerator over a common denominator."""
        missing = {factor: power - self.factors.get(factor, 0) for factor, power in factors.items()}
        return self.numerator * power_product(missing)

    def equals(self, other: "Expansion", relations: Dict[str, object] = {}) -> bool:
        """Exact equality, modulo the roots' rules and further relations: v² = polynomial, or v = Quotient."""
        common = common_factors(self.factors, other.factors)
        difference = self.over(common) - other.over(common)
        squares = {**self.rules, **other.rules}
        for name, relation in relations.items():
            if isinstance(relation, Quotient):
                difference = difference.replace_by_quotient(name, relation)
            else:
                squares[name] = relation
        return difference.reduce(squares) == 0


def common_factors(a: Dict[Polynomial, int], b: Dict[Polynomial, int]) -> Dict[Polynomial, int]:
    return {factor: max(a.get(factor, 0), b.get(factor, 0)) for factor in {**a, **b}}


def power_product(factors: Dict[Polynomial, int]) -> Polynomial:
    result = Polynomial.of(1)
    for factor, power in factors.items():
        result = result * factor**power
    return result


@lru_cache(maxsize=None)
def expand(n: Node) -> Expansion:
    if n.kind in ("symbol", "precise"):
        return Expansion(Polynomial.variable(n.name), {}, {})
    if n.kind == "named":
        return expand(n.operands[0])
    if n.kind == "quotient":
        return expand_quotient(*map(expand, n.operands))
    if n.kind == "root":
        inside = expand(n.operands[0])
        if inside.factors:
            raise ValueError("the square root of a quotient: write it as a quotient of roots")
        name = f"sqrt({inside.numerator!r})"
        return Expansion(Polynomial.variable(name), {}, {**inside.rules, name: inside.numerator})
    if n.kind == "function":  # the same function of equal operands is the same variable
        operands = map(expand, n.operands)
        name = f"{n.name}({', '.join(f'{o.numerator!r} / {o.denominator!r}' for o in operands)})"
        return Expansion(Polynomial.variable(name), {}, {})
    if n.kind == "component":
        return Expansion(Polynomial.variable(f"{expand(n.operands[0]).numerator!r}.{n.name}"), {}, {})
    total = Expansion(Polynomial(), {}, {})
    for coefficient, factors in n.terms:
        term = expand_product(coefficient, list(map(expand, factors)))
        common = common_factors(total.factors, term.factors)
        total = Expansion(total.over(common) + term.over(common), common, {**total.rules, **term.rules})
    return total


def expand_product(coefficient, factors) -> Expansion:
    numerator, powers, rules = Polynomial.of(coefficient), Counter(), {}
    for factor in factors:
        numerator = numerator * factor.numerator
        powers.update(factor.factors)
        rules.update(factor.rules)
    return Expansion(numerator, dict(powers), rules)


def expand_quotient(a: Expansion, b: Expansion) -> Expansion:
    numerator = a.numerator * b.denominator
    if b.numerator.is_constant():
        return Expansion(numerator / b.numerator.constant(), a.factors, {**a.rules, **b.rules})
    powers = Counter(a.factors)
    powers[b.numerator] += 1
    return Expansion(numerator, dict(powers), {**a.rules, **b.rules})


def from_polynomial(p: Polynomial) -> Node:
    """The expression that computes a polynomial monomial by monomial."""
    terms = []
    for monomial, coefficient in p.terms.items():
        factors = tuple(symbol(name) for name, exponent in monomial for _ in range(exponent))
        terms.append((coefficient, tuple(sorted(factors, key=lambda n: n.index))))
    return sum_of(terms)
