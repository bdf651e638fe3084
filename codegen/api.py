"""What a public function is: its name, its parameters with their roles, and what the manual says of it.

THE table of public functions is in functions/, by subject. From it come the prototypes of motorway.h with their
documentation, the definitions down to the library's own functions, the C++ face, the table by precision that tests and
benchmarks use, and api.json. A new function is an entry in that table.

Names in braces stand for what depends on the precision: {P} is the suffix of the elements' types and {T} their scalar,
{M} and {U} are those of motors, which are double in mixed functions. A brace that is meant is doubled.
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
    inner: str = "{name}"  # what the library's own function is handed; empty: another parameter says it
    cpp: str = ""  # its declaration in C++, if it differs
    argument: str = ""  # what C++ hands to C; the name, if empty
    default: str = ""  # in C++, where parameters with one come last
    # Of a view: what plain functions take instead, and what they hand on; or nothing, if there is no such function.
    plain: Tuple[str, ...] = ()
    plain_inner: str = ""
    is_view: bool = False

    def declarations(self, form: str, values: Dict[str, str]) -> Tuple[str, ...]:
        texts = self.plain if self.is_view and form == PLAIN else (self.c,) if self.c else ()
        return tuple(text.format(name=self.name, **values) for text in texts)

    def handed_on(self, form: str, values: Dict[str, str]) -> str:
        text = self.plain_inner if self.is_view and form == PLAIN else self.inner
        return text.format(name=self.name, **values)

    def in_cpp(self, values: Dict[str, str]) -> str:
        return (self.cpp or self.c).format(name=self.name, **values)


# The two forms of a function that takes arrays of elements: by pointers and strides, and by views of any layout.
PLAIN, VIEWED = "plain", "views"


# --------------------------------------------------------------------------------------------------- arrays and views

SINGULARS = {"matrices": "matrix", "indices": "index", "vertices": "vertex"}


def one_of(name: str) -> str:
    """`motors` -> `motor`."""
    return SINGULARS.get(name) or (name[:-1] if name.endswith("s") else name)


def view_parameter(name: str, kind: str, is_input: bool) -> Parameter:
    """An array of elements: in plain functions a pointer to the first, and the bytes from one to the next."""
    const, prefix = ("const ", "const_") if is_input else ("", "")
    stride = f"{one_of(name)}_stride"
    viewed = {
        "role": f"{'input' if is_input else 'output'} view {kind}",
        "c": f"const mw_{prefix}{kind}_{{P}} *{{name}}",
        "cpp": f"const_{kind}<{{T}}> {{name}}" if is_input else f"mw_{kind}_{{P}} {{name}}",
        "argument": f"&{name}",
        "is_view": True,
    }
    if kind == "matrices":
        layout = f"{one_of(name)}_layout"
        return Parameter(
            name, inner="matrices_of({name})", **viewed,
            plain=(f"{const}{{T}} *{{name}}", f"size_t {stride}", f"mw_matrix_layout {layout}"),
            plain_inner=f"motorway::matrices<{const}{{T}}>{{{{{{name}}, {stride}, {layout}}}}}",
        )
    if kind == "vertices":
        parts = tuple(f"{name}_{part}" for part in ("positions", "normals"))
        return Parameter(
            name, inner="view_of({name})", **viewed,
            plain=(*(f"{const}{{T}} *{part}" for part in parts), f"size_t {stride}"),
            plain_inner=", ".join(f"adjacent<3>({part}, {stride})" for part in parts),
        )
    first = f"{const}mw_motor_{{P}} *{{name}}" if kind == "motors" else f"{const}{{T}} *{{name}}"
    numbers = "numbers_of({name})" if kind == "motors" else "{name}"
    return Parameter(
        name, inner="view_of({name})", **viewed, plain=(first, f"size_t {stride}"),
        plain_inner=f"adjacent<{len(VIEWS[kind])}>({numbers}, {stride})",
    )


def out(kind: str, name: str = "out") -> Parameter:
    return view_parameter(name, kind, is_input=False)


def given(kind: str, name: str) -> Parameter:
    return view_parameter(name, kind, is_input=True)


def motors_of_calls(name: str = "motors") -> Parameter:
    """Of functions that are mixed as well: motors are of their own precision."""
    motors = given("motors", name)

    def own(text: str) -> str:
        return text.replace("{P}", "{M}").replace("{T}", "{U}")

    return replace(motors, c=own(motors.c), cpp=own(motors.cpp), plain=tuple(map(own, motors.plain)))


def struct_of_views(kind: str, name: str, role: str, inner: str) -> Parameter:
    """What only functions of views take: it has no plain form."""
    return Parameter(name, role, f"const mw_{kind} *{{name}}", inner, cpp=f"{kind}<{{T}}> {{name}}".replace("_{P}", ""),
                     argument=f"&{name}", is_view=True)


def array(name: str) -> Parameter:
    """Numbers side by side."""
    return Parameter(name, "input numbers", "const {T} *{name}")


def packed(name: str) -> Parameter:
    """Numbers side by side, for functions that also take them with a stride."""
    return Parameter(name, "input numbers", "const {T} *{name}", "numbers<{T}>{{{name}, sizeof({T})}}")


def strided(name: str) -> Tuple[Parameter, Parameter]:
    """Numbers, and the bytes from one to the next; 0: one for all."""
    stride = f"{one_of(name)}_stride"
    return (
        Parameter(name, "input numbers", "const {T} *{name}", f"numbers<{{T}}>{{{{{{name}}, {stride}}}}}"),
        Parameter(stride, "stride", "size_t {name}", ""),
    )


def size(name: str, role: str = "size") -> Parameter:
    return Parameter(name, role, "size_t {name}")


COUNT = size("count", "count")


# ---------------------------------------------------------------------------------------------------- single values


def motor(name: str) -> Parameter:
    """One motor that all elements share."""
    return Parameter(name, "one motor", "const mw_motor_{M} *{name}", "numbers_of({name})",
                     cpp="const motor<{U}> &{name}", argument=f"&{name}")


def motors_side_by_side(name: str, inner: str = "numbers_of({name})") -> Parameter:
    return Parameter(name, "motors side by side", "const mw_motor_{M} *{name}", inner, cpp="const motor<{U}> *{name}")


def made(struct: str, name: str = "out") -> Parameter:
    return Parameter(name, f"output {struct}", f"mw_{struct}_{{P}} *{{name}}", cpp=f"{struct}<{{T}}> &{{name}}",
                     argument=f"&{name}")


def struct(kind: str, name: str) -> Parameter:
    return Parameter(name, f"input {kind}", f"const mw_{kind}_{{P}} *{{name}}", cpp=f"const {kind}<{{T}}> &{{name}}",
                     argument=f"&{name}")


def arrays(name: str) -> Parameter:
    """Where the controls and knots of a motion go."""
    return Parameter(name, "motion arrays", "const mw_motion_arrays_{P} *{name}", "arrays_of({name})",
                     cpp="const motion_arrays<{T}> &{name}", argument=f"&{name}")


def array_of(name: str, length: int = 3, default: str = "") -> Parameter:
    return Parameter(name, f"input {length} numbers", f"const {{T}} {{name}}[{length}]",
                     cpp=f"const {{T}} (&{{name}})[{length}]", default=default)


def made_array_of(name: str, length: int = 3) -> Parameter:
    return Parameter(name, f"output {length} numbers", f"{{T}} {{name}}[{length}]", cpp=f"{{T}} (&{{name}})[{length}]")


def scalar(name: str, default: str = "") -> Parameter:
    return Parameter(name, "number", "{T} {name}", default=default)


def number(name: str, type_name: str, role: str, default: str = "") -> Parameter:
    return Parameter(name, role, typed(type_name, "{name}"), default=default)


def typed(type_name: str, name: str) -> str:
    return type_name + ("" if type_name.endswith("*") else " ") + name


def place(name: str) -> Parameter:
    """Where the number of the first bad thing goes, if anybody wants it."""
    return Parameter(name, "where the error is", "size_t *{name}", default="nullptr")


FLAGS = number("flags", "unsigned", "flags", "MW_DEFAULT")
FIRST_BAD = place("first_bad")
WHERE = place("where")
COMPILED = Parameter("motion", "compiled motion", "const mw_compiled_motion_{P} *{name}",
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

    @property
    def forms(self) -> Tuple[str, ...]:
        """Without views there is one form, which is plain."""
        views = [p for p in self.parameters if p.is_view]
        has_plain = all(p.plain for p in views)
        return ((PLAIN,) if has_plain else ()) + ((VIEWED,) if views else ())

    def symbol(self, precision: Precision, form: str = PLAIN) -> str:
        parts = ("mw", self.name, "views" if form == VIEWED else "", precision.suffix)
        return "_".join(part for part in parts if part)

    @property
    def in_c(self) -> Tuple[Parameter, ...]:
        return tuple(p for p in self.parameters if p.c)

    def declarations(self, form: str, precision: Precision) -> Tuple[str, ...]:
        return tuple(text for p in self.in_c for text in p.declarations(form, precision.values))

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

    @property
    def has_views(self) -> bool:
        return any(VIEWED in f.forms for f in self.functions)

    @property
    def only_views(self) -> bool:
        return all(f.forms == (VIEWED,) for f in self.functions)

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
