"""The public functions as text: C prototypes, the definitions below them, C++ overloads, and rows for programs."""

from __future__ import annotations

import json
import re
import textwrap
from typing import Callable, Dict, Iterable, List, Sequence

from api import OPERANDS, PLAIN, SCALARS, VIEWED, VIEWS, Function, Group, Parameter, Precision, typed
from emit import WIDTH, fill
from functions import apply, library, motions, motors, representations

SUBJECTS = {
    "library": library,
    "apply": apply,
    "motors": motors,
    "representations": representations,
    "motions": motions,
}
GROUPS = tuple(
    group for module in SUBJECTS.values() for group in vars(module).values() if isinstance(group, Group)
)
FUNCTIONS = tuple(function for group in GROUPS for function in group.functions)
TYPES = ("motor", "matrices", "const_matrices", "vertices", "const_vertices", "weights", "twist", "motion",
         "compiled_motion", "motion_arrays", "motion_distance")
STREAM_CALLS = ("run_streams", "run_with_shared_motors")  # these take what is written first


def listed(beginning: str, items: Sequence[str], end: str) -> List[str]:
    """`beginning(a, b, c)end`, its lines aligned behind the parenthesis or, where they do not fit, indented."""
    pieces = [item + "," for item in items[:-1]] + [(items[-1] if items else "") + end]
    indent = len(beginning)
    if indent + max(map(len, items), default=0) + len(end) > WIDTH:
        return [beginning, *indented(fill(pieces, WIDTH - 4, WIDTH - 4))]
    lines = fill(pieces, WIDTH - indent, WIDTH - indent)
    return [beginning + lines[0]] + [" " * indent + line for line in lines[1:]]


def calling(head: Sequence[str], name: str, arguments: Sequence[str]) -> List[str]:
    """A function that returns what another returns."""
    return [*head, "{", *indented(listed(f"return {name}(", arguments, ");")), "}"]


def indented(lines: Iterable[str]) -> List[str]:
    return ["    " + line for line in lines]


def comment(text: str) -> List[str]:
    first, *others = text.splitlines()
    lines = [f"/* {first}", *(f" * {line}".rstrip() for line in others)]
    return lines[:-1] + [lines[-1] + " */"]


def spelled(status: str) -> str:
    """MW_ERROR_NAME, and its remark if there is one."""
    name, _, remark = status.partition(" ")
    return f"MW_ERROR_{name}" + (f" {remark}" if remark else "")


def documentation(group: Group) -> str:
    errors = "Errors: " + ", ".join(spelled(status) for status in group.errors) + "." if group.errors else ""
    return "\n".join(part for part in (group.text, "\n".join(textwrap.wrap(errors, WIDTH - 3)), group.also) if part)


# -------------------------------------------------------------------------------------------------------------------- C


def head(function: Function, precision: Precision, form: str, end: str) -> List[str]:
    name = function.symbol(precision, form)
    return listed(typed(function.returns, name) + "(", function.declarations(form, precision) or ["void"], ")" + end)


def prototypes(group: Group) -> str:
    """The plain functions of a group, with what the manual says of it."""
    return "\n".join(comment(documentation(group)) + declared(group, PLAIN))


def prototypes_of_views(group: Group) -> str:
    """Those that take views. The manual has their text, but for what has no plain form."""
    lines = [] if PLAIN in group.functions[0].forms else comment(documentation(group))
    return "\n".join(lines + declared(group, VIEWED))


def declared(group: Group, form: str) -> List[str]:
    lines = []
    for function in group.functions:
        if form not in function.forms:
            continue
        if function.text and form == PLAIN:
            lines += ["", *comment(function.text[0].upper() + function.text[1:] + ".")]
        for precision in function.precisions:
            lines += head(function, precision, form, ";")
    return lines


def definition(function: Function, precision: Precision, form: str) -> str:
    def handed(parameters: Iterable[Parameter]) -> List[str]:
        return [text for text in (p.handed_on(form, precision.values) for p in parameters) if text]

    arguments, parameters = ([function.first] if function.first else []), function.parameters
    if function.through in STREAM_CALLS:
        arguments += in_stream_order(function, handed)
    else:
        arguments += handed(parameters)
    name = function.through or function.name
    if not function.first and precision.suffix:
        name += f"<{SCALARS[precision.elements]}>"
    return "\n".join(calling(head(function, precision, form, ""), name, arguments))


def in_stream_order(function: Function, handed) -> List[str]:
    """What is written, the count, the motors that all share, the numbers, the views."""

    def of_role(*beginnings: str) -> List[str]:
        return handed(p for p in function.parameters if p.role.startswith(beginnings))

    shared = of_role("one motor")
    outputs = ", ".join(of_role("output view"))
    return [f"into({outputs})", *of_role("count"), *(2 * shared)[:2], *of_role("input numbers"), *of_role("input view")]


# ------------------------------------------------------------------------------------------------------------------ C++


def overloads(group: Group) -> str:
    return "\n".join(overload(f, p) for f in group.functions for p in f.precisions)


def overload(function: Function, precision: Precision) -> str:
    def declared(p: Parameter) -> str:
        text = p.in_cpp(precision.values)
        return text + (" = " + p.default.format() if p.default else "")

    returns = "status" if function.returns == "mw_status" else function.returns
    parameters = [declared(p) for p in function.in_cpp]
    arguments = [p.argument or p.name for p in function.in_c]
    prototype = listed(f"[[nodiscard]] inline {typed(returns, function.name)}(", parameters, ")")
    return "\n".join(calling(prototype, function.symbol(precision, function.forms[-1]), arguments))


def by_address(p: Parameter) -> bool:
    """What C++ passes by value or reference, and C by address."""
    return bool(p.argument) and (p.is_view or p.role == "motion arrays")


def by_reference(function: Function, precision: Precision) -> List[str]:
    """For tests: the function of views, which it takes by reference, so that they may be made on the way."""
    form = function.forms[-1]
    if not any(by_address(p) for p in function.in_c):
        return [f"static constexpr auto {function.name} = {function.symbol(precision)};"]
    declarations = [
        p.c.format(name=p.name, **precision.values).replace(" *", " &") if by_address(p)
        else p.declarations(form, precision.values)[0]
        for p in function.in_c
    ]
    arguments = [f"&{p.name}" if by_address(p) else p.name for p in function.in_c]
    prototype = listed(f"static {typed(function.returns, function.name)}(", declarations, ")")
    return calling(prototype, function.symbol(precision, form), arguments)


# --------------------------------------------------------------------------------------------------- for programs


def api_files(render: Callable[..., str]) -> Dict[str, str]:
    """Every file that is written from the table of public functions."""
    shared = {"views": VIEWS, "scalars": SCALARS, "groups": GROUPS, **SUBJECTS}
    files = {
        "src/motorway.h": with_contents(
            render("motorway.h.j2", prototypes=prototypes, **shared)
        ),
        "src/motorway_views.h": render(
            "motorway_views.h.j2", prototypes_of_views=prototypes_of_views, components_macro=components_macro,
            operand_list=operand_list, **shared,
        ),
        "src/motorway.hpp": render("motorway.hpp.j2", overloads=overloads, **shared),
        "generated/views.inc": render("views.inc.j2", **shared),
        "generated/api.inc": render(
            "api.inc.j2", types=[*(c + v for v in VIEWS for c in ("", "const_")), *TYPES],
            by_precision={scalar: [by_reference(f, p) for f in FUNCTIONS for p in f.precisions if p.suffix == suffix]
                          for suffix, scalar in [*SCALARS.items(), ("mixed", "mixed")]},
            **shared,
        ),
        "generated/api.json": json.dumps(json_rows(), indent=1, ensure_ascii=False) + "\n",
    }
    for unit in sorted({group.unit for group in GROUPS}):
        functions = [f for group in GROUPS if group.unit == unit for f in group.functions]
        definitions = [definition(f, p, form) for f in functions for form in f.forms for p in f.precisions]
        files[f"generated/calls/{unit.replace('/', '_')}.inc"] = render(
            "calls.inc.j2", unit=unit, functions=definitions
        )
    return files


def with_contents(header: str) -> str:
    """The titles of the sections in place of CONTENTS."""
    titles = re.findall(r"^/\* -+ (.*) --- \*/$", header, flags=re.MULTILINE)
    return header.replace(" *     CONTENTS\n", "".join(f" *     {title}\n" for title in titles))


def operand_list() -> List[str]:
    """MW_OPERANDS, the lines of the macro."""
    return unbroken([f"use({operand}, {views}, P)" for operand, views in OPERANDS.items()])


def components_macro(name: str) -> List[str]:
    return unbroken([f"use({component}, T)" for component in VIEWS[name]])


def unbroken(pieces: Sequence[str]) -> List[str]:
    """Lines of whole pieces."""
    lines = textwrap.wrap(" ".join(piece.replace(" ", "~") for piece in pieces), WIDTH - 6)
    return [line.replace("~", " ") for line in lines]


def json_rows() -> List[Dict[str, object]]:
    return [
        json_row(function, precision, form, group)
        for group in GROUPS
        for function in group.functions
        for form in function.forms
        for precision in function.precisions
    ]


def json_row(function: Function, precision: Precision, form: str, group: Group) -> Dict[str, object]:
    return {
        "name": function.symbol(precision, form),
        "function": function.name,
        "form": form,
        "precision": precision.suffix,
        "returns": function.returns,
        "parameters": [
            {"name": p.name, "role": p.role, "c": list(p.declarations(form, precision.values))} for p in function.in_c
        ],
        "errors": [spelled(status).partition(" ")[0] for status in group.errors],
        "text": function.text or group.text.split("\n\n")[0].replace("\n", " "),
    }
