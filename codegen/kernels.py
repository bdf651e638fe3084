"""THE table: every kernel as a formula over elements.

A kernel has a definition, which is the formula of the paper, and any number of other forms. The generator proves
that all of them are equal and takes the cheapest, pairing by pairing. A new kernel is an entry in KERNELS.

A formula takes the kernel's inputs as multivectors and a function `let(name, value)` that names a value for the
reader of the generated code and returns it. It is evaluated over expressions to generate code, and over
rationals to make golden vectors, so it may use nothing but the algebra, + - * / and `root`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable, Mapping, Tuple

from algebra import OMEGA, Multivector, multivector, project, transform
from elements import DIRECTION, MOTOR, POINT, Element
from expression import root
from polynomial import Polynomial, variables
from simplify import linear_coefficients

Formula = Callable[..., Multivector]


@dataclass(frozen=True)
class Input:
    """One operand: its name in the formula, its element type, and the prefix of its components in code."""

    name: str
    element: Element
    prefix: str = ""

    @property
    def symbols(self) -> Tuple[str, ...]:
        return tuple(self.prefix + component for component, _ in self.element.components)

    def multivector(self, coefficient: Callable[[str], object]) -> Multivector:
        return self.element.multivector(lambda component: coefficient(self.prefix + component))


@dataclass(frozen=True)
class Pairing:
    """How elements meet: which inputs are the same for the whole batch."""

    name: str
    fixed: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Kernel:
    verb: str
    operand: str
    formula: str  # for people
    source: str
    inputs: Tuple[Input, ...]
    output: Element
    pairings: Tuple[Pairing, ...]
    forms: Tuple[Tuple[str, Formula], ...]  # the first is the definition
    # The variant for callers who promise S̄S = 1: its forms, and what the promise means for the symbols.
    unit_forms: Tuple[Tuple[str, Formula], ...] = ()
    unit_relations: Mapping[str, Polynomial] = field(default_factory=dict)

    @property
    def name(self) -> str:
        return f"{self.verb}_{self.operand}"


# ------------------------------------------------------------------------------------------------------- formulas


def alpha(S: Multivector):
    """The e0 part of the image of e0, S̄S = α + βω (lemma 3.3)."""
    return (~S * S)[""]


def beta(S: Multivector):
    return (~S * S)[OMEGA]


def apply_sandwich(S, p, let):
    """The definition: P(S̄ p S), divided by its e0 part."""
    return transform(S, p) / let("alpha", alpha(S))


def apply_sandwich_unit(S, p, let):
    return transform(S, p)


def half_commutator_image(S, p, let):
    """P(S̄ (p∧S)): since S̄ p S = S̄S p + 2 S̄ (p∧S), this is half of what S moves p by, times α. Sparse."""
    return project(~S * let("c", p.outer(S)))


def apply_commutator(S, p, let):
    return p + let("k", 2 / let("alpha", alpha(S))) * half_commutator_image(S, p, let)


def apply_commutator_unit(S, p, let):
    return p + 2 * half_commutator_image(S, p, let)


def apply_matrix(S, p, let):
    """The commutator form, expanded into an affine map: twelve coefficients of S, then a product with p."""
    k = let("k", 2 / let("alpha", alpha(S)))
    image = half_commutator_image(S, p, lambda name, value: value)
    columns = {"1": "x", "2": "y", "3": "z"}
    moved = {"0": p["0"]}
    for row in columns:
        coefficients = linear_coefficients(multivector(image[row])[""], tuple(columns.values()))
        entries = [
            let(f"m{row}{column}", (1 if row == column else 0) + k * coefficients.get(name, 0)) * p[column]
            for column, name in columns.items()
        ]
        moved[row] = sum(entries, let(f"t{row}", k * coefficients[""]) if "" in coefficients else 0)
    return Multivector(moved)


def normalize_quotient(S, let):
    """S divided by the square root of S̄S = α + βω (lemma 3.4 ii, then i)."""
    a, b = let("alpha", alpha(S)), let("beta", beta(S))
    return S * Multivector({"": 1, OMEGA: -(b / (2 * a))}) / root(a)


def normalize_reciprocal(S, let):
    """The same from one reciprocal r = 1/√α: the inverse of the root is (1 - ½βr²ω) r."""
    r = let("r", 1 / root(let("alpha", alpha(S))))
    q = let("q", let("half_beta", beta(S) / 2) * r * r)
    return (S - S * Multivector({OMEGA: q})) * r


_s, _b12, _b13, _b23 = variables("s b12 b13 b23")
UNIT = {"s": 1 - _b12 * _b12 - _b13 * _b13 - _b23 * _b23}  # s² in a motor with α = 1

ONE = Pairing("one", fixed=("motor",))
EACH = Pairing("each")
SHARED_CONTROLS = Pairing("one")  # blending accumulates term by term, so nothing is left for a prologue

APPLY_FORMS = (("sandwich", apply_sandwich), ("commutator", apply_commutator), ("matrix", apply_matrix))
APPLY_UNIT_FORMS = (("sandwich", apply_sandwich_unit), ("commutator", apply_commutator_unit))
SCALAR = Element("weight", (("weight", ""),), meaning="a real number")

KERNELS: Tuple[Kernel, ...] = (
    Kernel(
        "apply",
        "point",
        "P(S̄ p S) / α",
        "Hunt et al. (2017), section 3, lemmas 3.1 to 3.6",
        (Input("motor", MOTOR), Input("point", POINT)),
        POINT,
        (ONE, EACH),
        APPLY_FORMS,
        APPLY_UNIT_FORMS,
        UNIT,
    ),
    Kernel(
        "apply",
        "direction",
        "P(S̄ d S) / α",
        "Hunt et al. (2017), section 3, theorem 3.8",
        (Input("motor", MOTOR), Input("direction", DIRECTION)),
        DIRECTION,
        (ONE, EACH),
        APPLY_FORMS,
        APPLY_UNIT_FORMS,
        UNIT,
    ),
    Kernel(
        "compose",
        "motor",
        "first then: the geometric product, in which the left factor acts first",
        "Hunt et al. (2017), lemma 3.5",
        (Input("first", MOTOR, "f_"), Input("then", MOTOR, "t_")),
        MOTOR,
        (EACH,),
        (("product", lambda first, then, let: first * then),),
    ),
    Kernel(
        "reverse",
        "motor",
        "S̄",
        "Hunt et al. (2017), section 2",
        (Input("motor", MOTOR),),
        MOTOR,
        (EACH,),
        (("reverse", lambda S, let: ~S),),
    ),
    Kernel(
        "normalize",
        "motor",
        "S / √(S̄S)",
        "Hunt et al. (2017), lemma 3.4 and corollary 3.7",
        (Input("motor", MOTOR),),
        MOTOR,
        (EACH,),
        (("quotient", normalize_quotient), ("reciprocal", normalize_reciprocal)),
    ),
    Kernel(
        "blend",
        "motor",
        "sum + weight control: one term of a weighted sum",
        "Hunt et al. (2017), section 4",
        (Input("sum", MOTOR, "sum_"), Input("weight", SCALAR), Input("control", MOTOR)),
        MOTOR,
        (SHARED_CONTROLS, EACH),
        (("term", lambda sum, weight, control, let: sum + weight[""] * control),),
    ),
)
