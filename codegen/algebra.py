"""The conformal geometric algebra G(4,1), from its metric alone.

The basis vectors are e0 e1 e2 e3 e∞ (written `i` in identifiers) of Hunt et al. (2017), section 2. A basis
*blade* is the geometric product of a subset of them in that order, written as the string of its subscripts:
"" is 1, "12" is e1 e2, "123i" is ω. (e0 and e∞ are not orthogonal, so e0∞ = e0 e∞ is not of one grade in the
usual sense; this is the paper's basis, and its definition.)

Products are found by sorting: neighbours that are out of order are exchanged by `ba = 2 a·b - ab`, equal
neighbours are replaced by their square. Everything is exact. Coefficients may be of any ring whose elements
add, multiply and compare with 0: integers, fractions, polynomials or the expressions of `expression.py`.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from typing import Dict, Iterable, Mapping, Tuple

VECTORS = "0123i"

# The metric: a·b for every pair of basis vectors with a nonzero inner product. e∞·e0 = -1 is the paper's
# e∞ e0 = -2 - e0 e∞.
METRIC: Dict[Tuple[str, str], int] = {("1", "1"): 1, ("2", "2"): 1, ("3", "3"): 1, ("0", "i"): -1, ("i", "0"): -1}

BLADES: Tuple[str, ...] = tuple(
    "".join(subset) for size in range(len(VECTORS) + 1) for subset in combinations(VECTORS, size)
)

OMEGA = "123i"  # the paper's ω


def inner_of_vectors(a: str, b: str) -> int:
    return METRIC.get((a, b), 0)


@lru_cache(maxsize=None)
def sort_word(word: str) -> Tuple[Tuple[str, int], ...]:
    """A product of basis vectors in any order, as integer multiples of basis blades."""
    for k in range(len(word) - 1):
        a, b = word[k], word[k + 1]
        before, after = word[:k], word[k + 2 :]
        if a == b:
            return _scale(sort_word(before + after), inner_of_vectors(a, a))
        if VECTORS.index(a) > VECTORS.index(b):
            swapped = _scale(sort_word(before + b + a + after), -1)
            contracted = _scale(sort_word(before + after), 2 * inner_of_vectors(a, b))
            return _add(swapped, contracted)
    return ((word, 1),)


def _scale(terms, factor: int):
    return tuple((blade, factor * c) for blade, c in terms) if factor else ()


def _add(left, right):
    total: Dict[str, int] = {}
    for blade, c in left + right:
        total[blade] = total.get(blade, 0) + c
    return tuple((blade, c) for blade, c in total.items() if c)


def blade_product(a: str, b: str) -> Tuple[Tuple[str, int], ...]:
    """The geometric product of two basis blades: ((blade, integer), ...)."""
    return sort_word(a + b)


def blade_reverse(a: str) -> Tuple[Tuple[str, int], ...]:
    """The reverse of a basis blade. Of e0∞ it is -2 - e0∞ (the paper's equation 2)."""
    return sort_word(a[::-1])


class Multivector:
    """A linear combination of basis blades, with coefficients of one ring."""

    __slots__ = ("parts",)

    def __init__(self, parts: Mapping[str, object] = {}):
        self.parts: Dict[str, object] = {b: parts[b] for b in BLADES if b in parts and parts[b] != 0}
        if len(self.parts) != sum(1 for c in parts.values() if c != 0):
            raise ValueError(f"not basis blades: {sorted(set(parts) - set(BLADES))}")

    def __getitem__(self, blade: str):
        return self.parts.get(blade, 0)

    def __add__(self, other) -> "Multivector":
        return _collect([*self.parts.items(), *multivector(other).parts.items()])

    __radd__ = __add__

    def __neg__(self) -> "Multivector":
        return Multivector({b: -c for b, c in self.parts.items()})

    def __sub__(self, other) -> "Multivector":
        return self + (-multivector(other))

    def __rsub__(self, other) -> "Multivector":
        return multivector(other) - self

    def __mul__(self, other) -> "Multivector":
        """The geometric product (with another multivector, or with an element of the coefficient ring)."""
        other = multivector(other)
        return _collect(
            (blade, c * (x * y))
            for a, x in self.parts.items()
            for b, y in other.parts.items()
            for blade, c in blade_product(a, b)
        )

    def __rmul__(self, other) -> "Multivector":
        return multivector(other) * self

    def __truediv__(self, scalar) -> "Multivector":
        return Multivector({b: c / scalar for b, c in self.parts.items()})

    def __invert__(self) -> "Multivector":
        """The reverse, written S̄ in the paper and ~S here."""
        return _collect((blade, c * x) for a, x in self.parts.items() for blade, c in blade_reverse(a))

    def inner(self, other) -> "Multivector":
        """The paper's inner product, a·b = ½(ab + ba)."""
        return (self * other + multivector(other) * self) * Fraction(1, 2)

    def outer(self, other) -> "Multivector":
        """The paper's outer product, a∧b = ½(ab - ba): the commutator product elsewhere."""
        return (self * other - multivector(other) * self) * Fraction(1, 2)

    def only(self, blades: Iterable[str]) -> "Multivector":
        """The part on the given blades."""
        return Multivector({b: self.parts[b] for b in blades if b in self.parts})

    def map(self, function) -> "Multivector":
        """The multivector with `function` applied to every coefficient."""
        return Multivector({b: function(c) for b, c in self.parts.items()})

    def __eq__(self, other) -> bool:
        return not (self - multivector(other)).parts

    __hash__ = None

    def __repr__(self) -> str:
        if not self.parts:
            return "0"
        return " + ".join(f"({c})" + (f" e{b}" if b else "") for b, c in self.parts.items())


def _collect(terms) -> Multivector:
    sums: Dict[str, object] = {}
    for blade, c in terms:
        sums[blade] = sums[blade] + c if blade in sums else c
    return Multivector(sums)


def multivector(value) -> Multivector:
    """The value itself if it is a multivector, else the scalar multivector of that ring element."""
    return value if isinstance(value, Multivector) else Multivector({"": value})


def e(subscripts: str) -> Multivector:
    """A product of basis vectors by its subscripts, in any order: e("12"), e("31"), e("i0")."""
    return _collect(sort_word(subscripts))


def project(a: Multivector) -> Multivector:
    """The paper's P: the part on e0 e1 e2 e3."""
    return a.only("0123")


def transform(motor: Multivector, v: Multivector) -> Multivector:
    """The paper's F_S(v) = P(S̄ v S)."""
    return project(~motor * v * motor)
