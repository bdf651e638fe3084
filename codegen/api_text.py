"""The public functions as text: C prototypes, the definitions below them, C++ overloads, and rows for programs."""

from __future__ import annotations

import json
import re
import textwrap
from typing import Callable, Dict, Iterable, List, Sequence

from api import BOTH, OPERANDS, SCALARS, VIEWS, Function, Group, Parameter, Precision
from functions import apply, library, motions, motors, representations

WIDTH = 118
SUBJECTS = {"library": library, "motors": motors, "apply": apply, "representations": representations, "motions": motions}
GROUPS = tuple(
    group for module in SUBJECTS.values() for group in vars(module).values() if isinstance(group, Group)
)
FUNCTIONS = tuple(function for group in GROUPS for function in group.functions)
TYPES = ("motor", "matrices", "const_matrices", "vertices", "const_vertices", "weights", "twist", "motion",
         "compiled_motion", "motion_arrays", "motion_distance")
STREAM_CALLS = ("run_streams", "run_with_shared_motors")  # these take what is written first


def typed(type_name: str, name: str) -> str:
    return type_name + ("" if type_name.endswith("*") else " ") + name


def listed(beginning: str, items: Sequence[str], end: str) -> List[str]:
    """`beginning(a, b, c)end`, its lines aligned behind the parenthesis or, where they do not fit, indented."""
    indent = len(beginning)
    longest = max((len(item) for item in items), default=0) + len(end)
    if indent + longest > WIDTH:
        return [beginning] + ["    " + line for line in filled(items, WIDTH - 4, end)]
    lines = filled(items, WIDTH - indent, end)
    return [beginning + lines[0]] + [" " * indent + line for line in lines[1:]]


def filled(items: Sequence[str], width: int, end: str) -> List[str]:
    lines, line = [], ""
    for k, item in enumerate(items):
        piece = item + (end if k + 1 == len(items) else ",")
        if line and len(line) + 1 + len(piece) > width:
            lines.append(line)
            line = piece
        else:
            line = f"{line} {piece}" if line else piece
    return lines + [line if items else end]


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


def head(function: Function, precision: Precision, end: str) -> List[str]:
    parameters = [p.declaration(precision.values) for p in function.in_c] or ["void"]
    return listed(typed(function.returns, function.symbol(precision)) + "(", parameters, ")" + end)


def prototypes(group: Group) -> str:
    lines = comment(documentation(group))
    for function in group.functions:
        if function.text:
            lines += ["", *comment(function.text[0].upper() + function.text[1:] + ".")]
        for precision in function.precisions:
            lines += head(function, precision, ";")
    return "\n".join(lines)


def definition(function: Function, precision: Precision) -> str:
    return "\n".join([*head(function, precision, ""), "{", *indented(inner_call(function, precision)), "}"])


def inner_call(function: Function, precision: Precision) -> List[str]:
    def handed(parameters: Iterable[Parameter]) -> List[str]:
        return [p.inner.format(name=p.name, **precision.values) for p in parameters if p.inner]

    arguments, parameters = ([function.first] if function.first else []), function.parameters
    if function.through in STREAM_CALLS:
        arguments += in_stream_order(function, handed)
    else:
        arguments += handed(parameters)
    name = function.through or function.name
    if not function.first and precision.suffix:
        name += f"<{SCALARS[precision.elements]}>"
    return listed(f"return {name}(", arguments, ");")


def in_stream_order(function: Function, handed) -> List[str]:
    """What is written, the count, the motors that all share, the numbers, the views."""

    def of_role(*beginnings: str) -> List[str]:
        return handed(p for p in function.parameters if p.role.startswith(beginnings))

    shared = of_role("one motor")
    outputs = ", ".join(of_role("output view"))
    return [f"into({outputs})", *of_role("count"), *(2 * shared)[:2], *of_role("input numbers"), *of_role("input view")]


def indented(lines: Iterable[str]) -> List[str]:
    return ["    " + line for line in lines]


# ------------------------------------------------------------------------------------------------------------------ C++


def overloads(group: Group) -> str:
    return "\n".join(overload(f, p) for f in group.functions for p in f.precisions)


def overload(function: Function, precision: Precision) -> str:
    def declared(p: Parameter) -> str:
        text = p.in_cpp(precision.values)
        return text + (" = " + p.default.format() if p.default else "")

    returns = "status" if function.returns == "mw_status" else function.returns
    arguments = [p.argument or p.name for p in function.in_c]
    return "\n".join(
        [
            *listed(f"[[nodiscard]] inline {typed(returns, function.name)}(", [declared(p) for p in function.in_cpp], ")"),
            "{",
            *indented(listed(f"return {function.symbol(precision)}(", arguments, ");")),
            "}",
        ]
    )


# ---------------------------------------------------------------------------------------------------------- for programs


def api_files(render: Callable[..., str]) -> Dict[str, str]:
    """Every file that is written from the table of public functions."""
    shared = {"views": VIEWS, "scalars": SCALARS, "groups": GROUPS, **SUBJECTS}
    files = {
        "src/motorway.h": with_contents(
            render("motorway.h.j2", prototypes=prototypes, operand_list=operand_list, components_macro=components_macro,
                   **shared)
        ),
        "src/motorway.hpp": render("motorway.hpp.j2", overloads=overloads, **shared),
        "generated/views.inc": render("views.inc.j2", **shared),
        "generated/api.inc": render(
            "api.inc.j2", types=[*(c + v for v in VIEWS for c in ("", "const_")), *TYPES],
            functions=[f.name for f in FUNCTIONS if f.precisions == BOTH], **shared,
        ),
        "generated/api.json": json.dumps(json_rows(), indent=1, ensure_ascii=False) + "\n",
    }
    for unit in sorted({group.unit for group in GROUPS}):
        functions = [f for group in GROUPS if group.unit == unit for f in group.functions]
        definitions = [definition(f, p) for f in functions for p in f.precisions]
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
        json_row(function, precision, group)
        for group in GROUPS
        for function in group.functions
        for precision in function.precisions
    ]


def json_row(function: Function, precision: Precision, group: Group) -> Dict[str, object]:
    return {
        "name": function.symbol(precision),
        "function": function.name,
        "precision": precision.suffix,
        "returns": function.returns,
        "parameters": [
            {"name": p.name, "role": p.role, "c": p.declaration(precision.values)} for p in function.in_c
        ],
        "errors": [spelled(status).partition(" ")[0] for status in group.errors],
        "text": function.text or group.text.split("\n\n")[0].replace("\n", " "),
    }
