"""What a public function is: its name, its parameters with their roles, and what the manual says of it.

THE table of public functions is in functions/, by subject. From it come the prototypes of motorway.h with their
documentation, the definitions down to the library's own functions, the C++ face, the table by precision that tests and
benchmarks use, and api.json. A new function is an entry in that table.

Texts in braces depend on the precision: {P} is the suffix of the elements' types and {T} their scalar, {M} and {U} those
of motors, which are double in mixed functions. A brace that stays is doubled.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Dict, Tuple

from elements import (
    BIVECTOR,
    DUAL_QUATERNION,
    LINE,
    MOTOR,
    POINT,
    QUATERNION,
    SCREW,
    VECTOR,
)


@dataclass(frozen=True)
class Precision:
    suffix: str  # of function names
    elements: str
    motors: str

    @property
    def values(self) -> Dict[str, str]:
        return {"P": self.elements, "T": SCALARS[self.elements], "M": self.motors, "U": SCALARS[self.motors]}


SCALARS = {"f32": "float", "f64": "double"}
F32, F64 = Precision("f32", "f32", "f32"), Precision("f64", "f64", "f64")
BOTH = (F32, F64)
MIXED = (Precision("mixed", "f32", "f64"),)
WITHOUT = (Precision("", "f32", "f32"),)  # functions that no number is passed to

# The views: the components that each has a pointer to.
VIEWS = {
    name: tuple(component for component, _ in element.components)
    for name, element in (
        ("xyz", POINT),
        ("xyzw", QUATERNION),
        ("vectors", VECTOR),
        ("lines", LINE),
        ("motors", MOTOR),
        ("bivectors", BIVECTOR),
        ("dual_quaternions", DUAL_QUATERNION),
        ("screws", SCREW),
    )
}

# What motors are applied to, and the views of it.
OPERANDS = {
    "point": "xyz",
    "direction": "xyz",
    "tangent": "xyzw",
    "vertex": "vertices",
    "vector": "vectors",
    "line": "lines",
    "motor": "motors",
    "bivector": "bivectors",
}


@dataclass(frozen=True)
class Parameter:
    name: str
    role: str  # for bindings: what it is, not how C declares it
    c: str  # its declaration; empty: C has no such parameter, the library's own function alone
    inner: str  # what the library's own function is handed; empty: another parameter says it
    cpp: str = ""  # its declaration in C++, if it differs
    argument: str = ""  # what C++ hands to C; the name, if empty
    default: str = ""  # in C++, where parameters with one come last

    def declaration(self, values: Dict[str, str]) -> str:
        return self.c.format(name=self.name, **values)

    def in_cpp(self, values: Dict[str, str]) -> str:
        return (self.cpp or self.c).format(name=self.name, **values)


def parameter(name: str, role: str, c: str, inner: str = "{name}", **more) -> Parameter:
    return Parameter(name, role, c, inner.replace("{name}", name), **more)


# --------------------------------------------------------------------------------------------------- arrays and views


def out(view: str, name: str = "out", inner: str = "view_of({name})") -> Parameter:
    return parameter(name, f"output view {view}", f"mw_{view}_{{P}} {{name}}", inner)


def given(view: str, name: str, inner: str = "view_of({name})") -> Parameter:
    return parameter(name, f"input view {view}", f"mw_const_{view}_{{P}} {{name}}", inner,
                     cpp=f"const_{view}<{{T}}> {{name}}")


def matrices(name: str) -> Parameter:
    return given("matrices", name, "matrices_of({name})")


def motors_of_calls(name: str = "motors") -> Parameter:
    """Of functions that are mixed as well: motors are of their own precision."""
    return parameter(name, "input view motors", "mw_const_motors_{M} {name}", "view_of({name})",
                     cpp="const_motors<{U}> {name}")


def array(name: str) -> Parameter:
    """Numbers side by side."""
    return parameter(name, "input numbers", "const {T} *{name}")


def packed(name: str) -> Parameter:
    """Numbers side by side, for functions that also take them with a stride."""
    return parameter(name, "input numbers", "const {T} *{name}", "numbers<{T}>{{" + name + ", sizeof({T})}}")


def strided(name: str) -> Tuple[Parameter, Parameter]:
    """Numbers, and the bytes from one to the next; 0: one for all."""
    stride = name[:-1] + "_stride"
    return (
        parameter(name, "input numbers", "const {T} *{name}", "numbers<{T}>{{" + name + ", " + stride + "}}"),
        parameter(stride, "stride", "size_t {name}", ""),
    )


def size(name: str, role: str = "size") -> Parameter:
    return parameter(name, role, "size_t {name}")


COUNT = size("count", "count")


# ---------------------------------------------------------------------------------------------------- single values


def motor(name: str) -> Parameter:
    """One motor that all elements share."""
    return parameter(name, "one motor", "const mw_motor_{M} *{name}", "numbers_of({name})",
                     cpp="const motor<{U}> &{name}", argument=f"&{name}")


def motors_side_by_side(name: str, inner: str = "numbers_of({name})") -> Parameter:
    return parameter(name, "motors side by side", "const mw_motor_{M} *{name}", inner, cpp="const motor<{U}> *{name}")


def made(struct: str, name: str = "out") -> Parameter:
    return parameter(name, f"output {struct}", f"mw_{struct}_{{P}} *{{name}}", cpp=f"{struct}<{{T}}> &{{name}}",
                     argument=f"&{name}")


def struct(kind: str, name: str) -> Parameter:
    return parameter(name, f"input {kind}", f"const mw_{kind}_{{P}} *{{name}}", cpp=f"const {kind}<{{T}}> &{{name}}",
                     argument=f"&{name}")


def by_value(kind: str, name: str, inner: str = "{name}") -> Parameter:
    return parameter(name, f"input {kind}", f"mw_{kind}_{{P}} {{name}}", inner, cpp=f"{kind}<{{T}}> {{name}}")


def triple(name: str, length: int = 3, default: str = "") -> Parameter:
    return parameter(name, f"input {length} numbers", f"const {{T}} {{name}}[{length}]",
                     cpp=f"const {{T}} (&{{name}})[{length}]", default=default)


def made_triple(name: str, length: int = 3) -> Parameter:
    return parameter(name, f"output {length} numbers", f"{{T}} {{name}}[{length}]", cpp=f"{{T}} (&{{name}})[{length}]")


def scalar(name: str, default: str = "") -> Parameter:
    return parameter(name, "number", "{T} {name}", default=default)


def number(name: str, type_name: str, role: str, default: str = "") -> Parameter:
    return parameter(name, role, f"{type_name}{'' if type_name.endswith('*') else ' '}{{name}}", default=default)


def place(name: str) -> Parameter:
    """Where the number of the first bad thing goes, if anybody wants it."""
    return parameter(name, "where the error is", "size_t *{name}", default="nullptr")


FLAGS = number("flags", "unsigned", "flags", "MW_DEFAULT")
FIRST_BAD = place("first_bad")
WHERE = place("where")
COMPILED = parameter("motion", "compiled motion", "const mw_compiled_motion_{P} *{name}",
                     cpp="const compiled_motion<{T}> *{name}")


@dataclass(frozen=True)
class Function:
    name: str
    parameters: Tuple[Parameter, ...]
    text: str = ""  # what it does that its group does not say
    precisions: Tuple[Precision, ...] = BOTH
    # The library's own function, and what it is handed first: the numbers of kernels, say.
    through: str = ""
    first: str = ""
    # In C++, parameters with a default that come after the flags.
    after_flags: Tuple[str, ...] = ()
    returns: str = "mw_status"

    def symbol(self, precision: Precision) -> str:
        return f"mw_{self.name}_{precision.suffix}" if precision.suffix else f"mw_{self.name}"

    @property
    def in_c(self) -> Tuple[Parameter, ...]:
        return tuple(p for p in self.parameters if p.c)

    @property
    def in_cpp(self) -> Tuple[Parameter, ...]:
        def rank(p: Parameter) -> int:
            return 0 if not p.default else 2 if p.name in self.after_flags else 1

        return tuple(sorted(self.in_c, key=rank))


@dataclass(frozen=True)
class Group:
    """Functions that the manual describes together."""

    text: str
    functions: Tuple[Function, ...]
    unit: str  # the file of src/ that has what they call
    errors: Tuple[str, ...] = ()  # statuses, some with a remark in parentheses
    also: str = ""  # a paragraph after the errors

    def __post_init__(self):
        names = [f.name for f in self.functions]
        if len(set(names)) != len(names):
            raise ValueError(f"a function is in its group twice: {names}")


def streams(name: str, *parameters: Parameter, flag: str = "", flagged: str = "", **more) -> Function:
    """A function that hands its views to the kernel of its name; with `flag`, to that which is called `flagged`."""
    kernel = f"kernel_id::{name}"
    if flag:
        kernel = f"kernel_choice({kernel}, kernel_id::{flagged}, {flag}, flags)"
    return Function(name, parameters, through="run_streams", first=kernel, **more)


def with_shared_motors(function: Function) -> Function:
    return replace(function, through="run_with_shared_motors")
