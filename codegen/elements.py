"""The named element types: which basis blades an element has, in which order, and what it is called in code."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Tuple

from algebra import Multivector


@dataclass(frozen=True)
class Element:
    """An ordered list of components, each the coefficient of one basis blade.

    `constant` holds blades whose coefficient is fixed and not stored, such as the e0 of a Euclidean point.
    """

    name: str
    components: Tuple[Tuple[str, str], ...]  # ((name in code, blade), ...)
    constant: Tuple[Tuple[str, int], ...] = ()
    meaning: str = ""

    @property
    def size(self) -> int:
        return len(self.components)

    @property
    def blades(self) -> Tuple[str, ...]:
        return tuple(blade for _, blade in self.components)

    def multivector(self, coefficient: Callable[[str], object]) -> Multivector:
        """The multivector whose component called `name` is `coefficient(name)`."""
        parts = {blade: coefficient(name) for name, blade in self.components}
        return Multivector({**dict(self.constant), **parts})


MOTOR = Element(
    "motor",
    (
        ("s", ""),
        ("b12", "12"),
        ("b13", "13"),
        ("b23", "23"),
        ("b1i", "1i"),
        ("b2i", "2i"),
        ("b3i", "3i"),
        ("w", "123i"),
    ),
    meaning="even-grade 0-free element: a rotation and a translation (Hunt et al., equation 3)",
)
POINT = Element(
    "point", (("x", "1"), ("y", "2"), ("z", "3")), (("0", 1),), "a Euclidean point, e0 + x e1 + y e2 + z e3"
)
DIRECTION = Element(
    "direction", (("x", "1"), ("y", "2"), ("z", "3")), meaning="a Euclidean direction, x e1 + y e2 + z e3"
)
VECTOR = Element(
    "vector",
    (("e0", "0"), ("e1", "1"), ("e2", "2"), ("e3", "3"), ("ei", "i")),
    meaning="any element of grade 1: a point, a sphere or a plane",
)

ELEMENTS = (MOTOR, POINT, DIRECTION, VECTOR)
