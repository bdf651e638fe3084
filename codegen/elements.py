"""The named element types: which basis blades an element has, in which order, and what it is called in code."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Dict, List, Tuple

from algebra import Multivector, e, multivector


@dataclass(frozen=True)
class Element:
    """An ordered list of components, each the coefficient of one product of basis vectors.

    The vectors of a product may be in any order: the coefficient of "31" is minus that of "13". `constant` holds
    blades whose coefficient is fixed and not stored, such as the e0 of a Euclidean point.
    """

    name: str
    components: Tuple[Tuple[str, str], ...]  # ((name in code, product), ...)
    constant: Tuple[Tuple[str, int], ...] = ()
    meaning: str = ""

    @property
    def size(self) -> int:
        return len(self.components)

    @property
    def blades(self) -> Tuple[str, ...]:
        """The basis blade of every component."""
        return tuple(blade for blade, _ in map(signed_blade, self.components))

    def multivector(self, coefficient: Callable[[str], object]) -> Multivector:
        """The multivector whose component called `name` is `coefficient(name)`."""
        parts = {}
        for component in self.components:
            blade, sign = signed_blade(component)
            parts[blade] = coefficient(component[0]) if sign > 0 else -coefficient(component[0])
        return Multivector({**dict(self.constant), **parts})

    def coefficients(self, value) -> List[object]:
        """The components of a multivector, in order."""
        value = multivector(value)
        signed = map(signed_blade, self.components)
        return [value[blade] if sign > 0 else -value[blade] for blade, sign in signed]


@dataclass(frozen=True)
class Numbers:
    """An ordered list of numbers that are no coefficients of the algebra, in formulas a dictionary by their names."""

    name: str
    names: Tuple[str, ...]
    meaning: str = ""

    @property
    def size(self) -> int:
        return len(self.names)

    @property
    def components(self) -> Tuple[Tuple[str, str], ...]:
        return tuple((name, "") for name in self.names)

    def multivector(self, coefficient: Callable[[str], object]) -> Dict[str, object]:
        return {name: coefficient(name) for name in self.names}

    def coefficients(self, value: Dict[str, object]) -> List[object]:
        return [value[name] for name in self.names]


def signed_blade(component: Tuple[str, str]) -> Tuple[str, int]:
    (blade, sign), = e(component[1]).parts.items()
    return blade, sign


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
TANGENT = Element(
    "tangent",
    (("x", "1"), ("y", "2"), ("z", "3"), ("w", "")),
    meaning="a Euclidean direction, and a number that no motor changes",
)
VECTOR = Element(
    "vector",
    (("e0", "0"), ("e1", "1"), ("e2", "2"), ("e3", "3"), ("ei", "i")),
    meaning="any element of grade 1: a point, a sphere or a plane",
)
LINE = Element(
    "line",
    (("dx", "23"), ("dy", "31"), ("dz", "12"), ("mx", "1i"), ("my", "2i"), ("mz", "3i")),
    meaning="a line in Plücker coordinates: d e123 + m e∞, the generator of the rotations about it (lemma 3.11)",
)
BIVECTOR = Element(
    "bivector",
    MOTOR.components[1:7],
    meaning="the generator of a motor: its logarithm; a twist, or a wrench",
)



def numbers(name: str, names: str, meaning: str) -> Numbers:
    return Numbers(name, tuple(names.split()), meaning)


def matrix(name: str, order: Tuple[Tuple[int, int], ...]) -> Numbers:
    return Numbers(name, tuple(f"m{row}{column}" for row, column in order), "R and t, where p' = R p + t")


QUATERNION = numbers("quaternion", "x y z w", "w + (x e1 + y e2 + z e3) e123")
QUATERNION_WXYZ = numbers("quaternion_wxyz", "w x y z", QUATERNION.meaning)
DUAL_QUATERNION = numbers("dual_quaternion", "rx ry rz rw dx dy dz dw", "r + εd with d = ½ t r")
DUAL_QUATERNION_WXYZ = numbers("dual_quaternion_wxyz", "rw rx ry rz dw dx dy dz", DUAL_QUATERNION.meaning)
ANGLES = numbers("angles", "x y z", "the first, second and third Euler angle")
EULER_AXES = numbers("axes", "x0 y0 z0 x1 y1 z1 x2 y2 z2", "the axes of the three rotations")
SIGN = numbers("sign", "sign", "of the angles")
SCALE = numbers("scale", "scale", "the unit of length")
SCREW = numbers("screw", "ax ay az px py pz angle distance", "axis, point on it, angle about it, way along it")
ROWS_3X4 = matrix("rows_3x4", tuple((r, c) for r in range(3) for c in range(4)))
ROWS_4X4 = matrix("rows_4x4", tuple((r, c) for r in range(4) for c in range(4)))
COLUMNS_3X4 = matrix("columns_3x4", tuple((r, c) for c in range(4) for r in range(3)))
COLUMNS_4X4 = matrix("columns_4x4", tuple((r, c) for c in range(4) for r in range(4)))

ELEMENTS = (MOTOR, POINT, DIRECTION, TANGENT, VECTOR, LINE, BIVECTOR)
