"""THE table: every kernel as a formula over elements.

A kernel has a definition, which is the formula of the paper, and any number of other forms. The generator proves
that all of them are equal and takes the cheapest, pairing by pairing. A new kernel is an entry in KERNELS.

The formulas are in formulas.py.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Callable, Mapping, Optional, Tuple, Union

from algebra import Multivector
from conversions import (
    axis_angle_to_motor,
    dual_quaternion_to_motor,
    euler_to_motor,
    matrix_to_motor,
    motor_to_axis_angle,
    motor_to_dual_quaternion,
    motor_to_euler,
    motor_to_euler_proper,
    motor_to_matrix,
    motor_to_pose,
    motor_to_screw,
    motor_to_translation,
    pose_to_motor,
    rotor_to_motor,
    screw_to_motor,
    translation_to_motor,
)
from elements import (
    ANGLES,
    BIVECTOR,
    COLUMNS_3X4,
    COLUMNS_4X4,
    DIRECTION,
    DUAL_QUATERNION,
    DUAL_QUATERNION_WXYZ,
    EULER_AXES,
    LINE,
    MOTOR,
    POINT,
    QUATERNION,
    QUATERNION_WXYZ,
    ROWS_3X4,
    ROWS_4X4,
    SCALE,
    SCREW,
    SIGN,
    TANGENT,
    VECTOR,
    Element,
    Numbers,
)
from formulas import (
    LINE_FORMS,
    LINE_UNIT_FORMS,
    POINT_FORMS,
    POINT_UNIT_FORMS,
    VECTOR_FORMS,
    VECTOR_UNIT_FORMS,
    each_form,
    motor_form,
    normalize_quotient,
    normalize_reciprocal,
    point_commutator,
    point_sandwich,
    reverse_over,
    shifted_form,
    shifted_matrix,
    tangent_form,
    vertex_form,
)
from motor_group import (
    exp_bivector,
    log_principal,
    log_shortest,
    nlerp,
    normalized,
    power,
    ratio,
    slerp,
    slerp_long,
    square_root,
)
from polynomial import Polynomial, Quotient, variables

Formula = Callable[..., Multivector]


@dataclass(frozen=True)
class Input:
    """One operand: its name in the formula, its element type, and the prefix of its components in code."""

    name: str
    element: Union[Element, Numbers]
    prefix: str = ""

    @property
    def symbols(self) -> Tuple[str, ...]:
        return tuple(self.prefix + component for component, _ in self.element.components)

    def multivector(self, coefficient: Callable[[str], object]):
        """The operand as a formula takes it: of numbers a dictionary."""
        return self.element.multivector(lambda component: coefficient(self.prefix + component))


@dataclass(frozen=True)
class Pairing:
    """How elements meet: which inputs are the same for the whole batch.

    `like` names the pairing whose arithmetic it is: only the way that the motors reach an element is different.
    """

    name: str
    fixed: Tuple[str, ...] = ()
    like: str = ""


@dataclass(frozen=True, eq=False)
class Kernel:
    verb: str
    operand: str
    formula: str  # for people
    source: str
    inputs: Tuple[Input, ...]
    outputs: Tuple[Union[Element, Numbers], ...]
    pairings: Tuple[Pairing, ...]
    forms: Tuple[Tuple[str, Formula], ...]  # the first is the definition
    # The variant for callers who promise S̄S = 1: its forms, and what the promise means for the symbols.
    unit_forms: Tuple[Tuple[str, Formula], ...] = ()
    unit_relations: Mapping[str, Union[Polynomial, Quotient]] = field(default_factory=dict)
    is_rational: bool = True  # a quotient of polynomials and their roots: golden vectors are exact
    mixed: bool = False  # computed in double, with motors of double and all else float
    # Of kernels that take motors of any length (not the variant for normalised ones): the power of the length that the
    # result has. Their first motor is brought near 1 where over- or underflow threatens.
    degree: Optional[int] = None

    @property
    def name(self) -> str:
        return f"{self.verb}_{self.operand}" + ("_mixed" if self.mixed else "")

    @property
    def output_size(self) -> int:
        return sum(output.size for output in self.outputs)


# A motor with S̄S = 1: what s² is, since α = 1; and what w is unless s = 0, since β = 2(s w + ...) = 0. A polynomial
# that vanishes on all such motors with s != 0 vanishes on those with s = 0 as well, their limits.
_s, _b12, _b13, _b23, _b1i, _b2i, _b3i = variables("s b12 b13 b23 b1i b2i b3i")
UNIT = {
    "s": 1 - _b12 * _b12 - _b13 * _b13 - _b23 * _b23,
    "w": Quotient(_b12 * _b3i - _b13 * _b2i + _b23 * _b1i, _s),
}

ONE = Pairing("one", fixed=("motor",))
EACH = Pairing("each")
APPLY_PAIRINGS = (ONE, EACH, Pairing("grid", fixed=("motor",), like="one"), Pairing("indexed", like="each"))
SHIFT = ("before", "after")
SHIFTED_PAIRINGS = tuple(Pairing(p.name, p.fixed + SHIFT, p.like) for p in APPLY_PAIRINGS)
SHARED_CONTROLS = Pairing("one")  # blending accumulates term by term, so nothing is left for a prologue

TRANSLATION = replace(DIRECTION, name="translation")
SCALAR = Element("weight", (("weight", ""),), meaning="a real number")
SHIFTED_FORMS = (
    ("sandwich", shifted_form(point_sandwich)),
    ("commutator", shifted_form(point_commutator)),
    ("matrix", shifted_matrix),
)


def as_tuple(results):
    """What a formula returns, as one multivector an output."""
    return results if isinstance(results, tuple) else (results,)


def apply_kernel(operand, formula, source, inputs, forms, unit_forms) -> Kernel:
    """`inputs` are what the motor is applied to, and the outputs are the same."""
    outputs = tuple(i.element for i in inputs)
    inputs = (Input("motor", MOTOR),) + inputs
    return Kernel("apply", operand, formula, source, inputs, outputs, APPLY_PAIRINGS, forms, unit_forms, UNIT, degree=0)




def interpolation_kernel(verb, formula, source, form) -> Kernel:
    inputs = (Input("first", MOTOR, "f_"), Input("second", MOTOR, "s_"), Input("parameter", SCALAR))
    pairings = (EACH, Pairing("one", fixed=("first", "second")))
    forms = (("weights" if verb == "slerp" else "closed", form),)
    return Kernel(verb, "motor", formula, source, inputs, (MOTOR,), pairings, forms, is_rational=False)


def conversion(operand, elements, outputs, form, formula, fixed=(), is_rational=True) -> Kernel:
    """From `elements`, of which those of `fixed` are the same for all."""
    inputs = tuple(Input(i.name, i, "t" if i is TRANSLATION else "") for i in elements)
    pairings = (Pairing("each", fixed=tuple(i.name for i in fixed)),)
    source = "Hunt et al. (2017), lemmas 3.10 and 3.11"
    # Of a motor's length nothing is left, except in dual quaternions and rotors, which are motors in another order.
    degree = 0 if operand.startswith("motor_to") and "dual_quaternion" not in operand else None
    return Kernel(
        "convert", operand, formula, source, inputs, outputs, pairings, (("closed", form),), is_rational=is_rational,
        degree=degree,
    )


OF_QUATERNION = "S = (w + (x e1 + y e2 + z e3) e123) (1 + ½ t e∞)"
OF_DUAL_QUATERNION = "S = r + ideal(d): r = (b23, -b13, b12; s), d = (b1i, b2i, b3i; -w)"
OF_MATRIX = "p' = R p + t"
OF_EULER = "S = R3 R2 R1 (1 + ½ t e∞)"
OF_SCREW = "S = (cos θ/2 + sin θ/2 (b + (b∧p) e∞)) (1 + ½ d a e∞), b = a e123"

CONVERSIONS: Tuple[Kernel, ...] = (
    *(
        kernel
        for order, quaternion in (("", QUATERNION), ("_wxyz", QUATERNION_WXYZ))
        for kernel in (
            conversion(f"motor_to_pose{order}", (MOTOR,), (quaternion, DIRECTION), motor_to_pose, OF_QUATERNION),
            conversion(f"pose{order}_to_motor", (quaternion, TRANSLATION), (MOTOR,), pose_to_motor, OF_QUATERNION),
        )
    ),
    *(
        kernel
        for order, dual in (("", DUAL_QUATERNION), ("_wxyz", DUAL_QUATERNION_WXYZ))
        for kernel in (
            conversion(
                f"motor_to_dual_quaternion{order}", (MOTOR,), (dual,), motor_to_dual_quaternion, OF_DUAL_QUATERNION
            ),
            conversion(
                f"dual_quaternion{order}_to_motor", (dual,), (MOTOR,), dual_quaternion_to_motor, OF_DUAL_QUATERNION
            ),
        )
    ),
    *(
        conversion(f"motor_to_{matrix.name}", (MOTOR,), (matrix,), motor_to_matrix, OF_MATRIX)
        for matrix in (ROWS_3X4, ROWS_4X4, COLUMNS_3X4, COLUMNS_4X4)
    ),
    *(
        conversion(f"{matrix.name}_to_motor", (matrix,), (MOTOR,), matrix_to_motor, OF_MATRIX, is_rational=False)
        for matrix in (ROWS_3X4, COLUMNS_3X4, COLUMNS_4X4)
    ),
    conversion(
        "motor_to_axis_angle", (MOTOR,), (QUATERNION, DIRECTION), motor_to_axis_angle, OF_QUATERNION, is_rational=False
    ),
    conversion(
        "axis_angle_to_motor", (QUATERNION, TRANSLATION), (MOTOR,), axis_angle_to_motor, OF_QUATERNION,
        is_rational=False,
    ),
    conversion(
        "motor_to_euler", (EULER_AXES, SIGN, MOTOR), (ANGLES, DIRECTION), motor_to_euler, OF_EULER,
        fixed=(EULER_AXES, SIGN), is_rational=False,
    ),
    conversion(
        "motor_to_euler_proper", (EULER_AXES, SIGN, MOTOR), (ANGLES, DIRECTION), motor_to_euler_proper, OF_EULER,
        fixed=(EULER_AXES, SIGN), is_rational=False,
    ),
    conversion(
        "euler_to_motor", (EULER_AXES, ANGLES, TRANSLATION), (MOTOR,), euler_to_motor, OF_EULER,
        fixed=(EULER_AXES,), is_rational=False,
    ),
    conversion("translation_to_motor", (TRANSLATION,), (MOTOR,), translation_to_motor, "1 + ½ t e∞"),
    conversion("motor_to_translation", (MOTOR,), (DIRECTION,), motor_to_translation, "P(S̄ e0 S) / α"),
    conversion("motor_to_screw", (MOTOR,), (SCREW,), motor_to_screw, OF_SCREW, is_rational=False),
    conversion("screw_to_motor", (SCREW,), (MOTOR,), screw_to_motor, OF_SCREW, is_rational=False),
    conversion("rotor_to_motor", (SCALE, MOTOR), (MOTOR,), rotor_to_motor, "the reverse, lengths in other units",
               fixed=(SCALE,)),
)

KERNELS: Tuple[Kernel, ...] = (
    apply_kernel(
        "point",
        "P(S̄ p S) / α",
        "Hunt et al. (2017), section 3, lemmas 3.1 to 3.6",
        (Input("point", POINT),),
        POINT_FORMS,
        POINT_UNIT_FORMS,
    ),
    Kernel(
        "apply",
        "point",
        "P(S̄ (p - before) S) / α + after",
        "Hunt et al. (2017), section 3, lemmas 3.1 to 3.6",
        (Input("motor", MOTOR), Input("before", DIRECTION, "before_"), Input("after", DIRECTION, "after_"),
         Input("point", POINT)),
        (POINT,),
        SHIFTED_PAIRINGS,
        SHIFTED_FORMS,
        mixed=True,
        degree=0,
    ),
    apply_kernel(
        "direction",
        "P(S̄ d S) / α",
        "Hunt et al. (2017), section 3, theorem 3.8",
        (Input("direction", DIRECTION),),
        POINT_FORMS,
        POINT_UNIT_FORMS,
    ),
    apply_kernel(
        "tangent",
        "P(S̄ d S) / α, and w",
        "Hunt et al. (2017), section 3, theorem 3.8",
        (Input("tangent", TANGENT, "t"),),
        each_form(tangent_form, POINT_FORMS),
        each_form(tangent_form, POINT_UNIT_FORMS),
    ),
    apply_kernel(
        "vertex",
        "P(S̄ p S) / α and P(S̄ d S) / α",
        "Hunt et al. (2017), section 3, lemmas 3.1 to 3.6 and theorem 3.8",
        (Input("position", POINT, "p"), Input("normal", DIRECTION, "n")),
        each_form(vertex_form, POINT_FORMS),
        each_form(vertex_form, POINT_UNIT_FORMS),
    ),
    apply_kernel(
        "vector",
        "Ū v U with U = S / √(S̄S)",
        "Hunt et al. (2017), section 3, lemma 3.4 and corollary 3.7",
        (Input("vector", VECTOR),),
        VECTOR_FORMS,
        VECTOR_UNIT_FORMS,
    ),
    apply_kernel(
        "line",
        "S^-1 ℓ S with S^-1 = S̄ / (S̄S)",
        "Hunt et al. (2017), section 3, lemmas 3.4 and 3.11",
        (Input("line", LINE),),
        LINE_FORMS,
        LINE_UNIT_FORMS,
    ),
    apply_kernel(
        "motor",
        "S^-1 M S with S^-1 = S̄ / (S̄S)",
        "Hunt et al. (2017), section 3, lemmas 3.4 and 3.5",
        (Input("moved", MOTOR, "m_"),),
        each_form(motor_form, LINE_FORMS),
        each_form(motor_form, LINE_UNIT_FORMS),
    ),
    apply_kernel(
        "bivector",
        "S^-1 B S with S^-1 = S̄ / (S̄S)",
        "Hunt et al. (2017), section 3, lemmas 3.4 and 3.5; the adjoint action",
        (Input("bivector", BIVECTOR, "b_"),),
        LINE_FORMS,
        LINE_UNIT_FORMS,
    ),
    Kernel(
        "compose",
        "motor",
        "first then: the geometric product, in which the left factor acts first",
        "Hunt et al. (2017), lemma 3.5",
        (Input("first", MOTOR, "f_"), Input("then", MOTOR, "t_")),
        (MOTOR,),
        (EACH, Pairing("one_first", fixed=("first",)), Pairing("one_then", fixed=("then",))),
        (("product", lambda first, then, let: first * then),),
    ),
    Kernel(
        "reverse",
        "motor",
        "S̄",
        "Hunt et al. (2017), section 2",
        (Input("motor", MOTOR),),
        (MOTOR,),
        (EACH,),
        (("reverse", lambda S, let: ~S),),
    ),
    Kernel(
        "normalize",
        "motor",
        "S / √(S̄S)",
        "Hunt et al. (2017), lemma 3.4 and corollary 3.7",
        (Input("motor", MOTOR),),
        (MOTOR,),
        (EACH,),
        (("quotient", normalize_quotient), ("reciprocal", normalize_reciprocal)),
        degree=0,
    ),
    Kernel(
        "blend",
        "motor",
        "sum + weight control: one term of a weighted sum",
        "Hunt et al. (2017), section 4",
        (Input("sum", MOTOR, "sum_"), Input("weight", SCALAR), Input("control", MOTOR)),
        (MOTOR,),
        (SHARED_CONTROLS, EACH),
        (("term", lambda sum, weight, control, let: sum + weight[""] * control),),
    ),
    Kernel(
        "inverse",
        "motor",
        "S̄ / (S̄S)",
        "Hunt et al. (2017), lemma 3.4",
        (Input("motor", MOTOR),),
        (MOTOR,),
        (EACH,),
        (("inverse", reverse_over),),
        degree=-1,
    ),
    Kernel(
        "exp",
        "motor",
        "exp(B) = C(x̂) + S(x̂) B",
        "Wareham and Lasenby, theorem 3, in dual numbers",
        (Input("generator", BIVECTOR),),
        (MOTOR,),
        (EACH,),
        (("reduced", exp_bivector),),
        is_rational=False,
    ),
    Kernel(
        "log",
        "motor",
        "the bivector B with exp(B) = S or -S, whichever is shorter",
        "Wareham and Lasenby, theorem 9, in dual numbers",
        (Input("motor", MOTOR),),
        (BIVECTOR,),
        (EACH,),
        (("dual", normalized(log_shortest)),),
        (("dual", log_shortest),),
        UNIT,
        is_rational=False,
        degree=0,
    ),
    Kernel(
        "log_principal",
        "motor",
        "the bivector B with exp(B) = S",
        "Wareham and Lasenby, theorem 9, in dual numbers",
        (Input("motor", MOTOR),),
        (BIVECTOR,),
        (EACH,),
        (("dual", normalized(log_principal)),),
        (("dual", log_principal),),
        UNIT,
        is_rational=False,
        degree=0,
    ),
    Kernel(
        "sqrt",
        "motor",
        "S^½, of S or of -S, whichever is shorter; S normalised",
        "(1 + S) / √((1 + S)~ (1 + S))",
        (Input("motor", MOTOR),),
        (MOTOR,),
        (EACH,),
        (("closed", square_root),),
        is_rational=False,
    ),
    Kernel(
        "power",
        "motor",
        "exp(t log S); S normalised",
        "Wareham and Lasenby, section 3",
        (Input("motor", MOTOR), Input("exponent", SCALAR)),
        (MOTOR,),
        (EACH,),
        (("logarithm", power),),
        is_rational=False,
    ),
    Kernel(
        "ratio",
        "motor",
        "from^-1 to, with from^-1 = its reverse / (its product with it)",
        "Hunt et al. (2017), lemma 3.4; Wareham and Lasenby, section 3.1",
        (Input("from", MOTOR, "f_"), Input("to", MOTOR, "t_")),
        (MOTOR,),
        (EACH,),
        (("inverse", ratio),),
        (("reverse", lambda first, second, let: ~first * second),),
        degree=-1,
    ),
    interpolation_kernel(
        "slerp",
        "S0 (S0^-1 S1)^t, the short way; both normalised",
        "Wareham and Lasenby, section 3.1; Shoemake, in dual numbers",
        slerp,
    ),
    interpolation_kernel(
        "slerp_long",
        "S0 (S0^-1 S1)^t, the long way; both normalised",
        "Wareham and Lasenby, section 3.1",
        slerp_long,
    ),
    interpolation_kernel(
        "nlerp",
        "N = (1-t) S0 + t S1, the short way, over √(N̄N)",
        "the lecture notes' method 1; Hunt et al. (2017), equation (5)",
        nlerp(1),
    ),
    interpolation_kernel(
        "nlerp_long",
        "N = (1-t) S0 + t S1, the long way, over √(N̄N)",
        "the lecture notes' method 1; Hunt et al. (2017), equation (5)",
        nlerp(-1),
    ),
    *CONVERSIONS,
)
