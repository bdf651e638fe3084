"""A plan as C++ text. Knows operations and names, and nothing of the algebra they come from."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import Dict, List, Sequence

from approximate import TABLE
from plan import SEVERAL_VALUES, STEPS, Operation, Plan

WIDTH = 118
INFIX = {"mul": "*", "add": "+", "sub": "-"}
FUNCTIONS = {"fma", "fnma", "fms", "negate", "sqrt", *STEPS, *TABLE}


class Writer:
    """Writes the statements of one stage. Values that are named or used twice become variables, others are nested."""

    def __init__(self, plan: Plan, stage: str):
        self.plan = plan
        self.operations = getattr(plan, stage)
        self.in_body = stage == "body"
        self.results = plan.outputs if self.in_body else plan.constants
        self.uses = Counter(operand for operation in self.operations for operand in operation.operands)
        self.uses.update(self.results)
        self.variables: Dict[Operation, str] = {}
        self.taken = set()

    def declare_inputs(self, array: str, names: Sequence[str], values: Sequence[Operation]) -> List[str]:
        """`const V a = array[0], ...` for those values that the stage uses."""
        used = []
        for k, (name, value) in enumerate(zip(names, values)):
            self.taken.add(name)
            if self.uses[value] or (not self.in_body and value in self.results):
                self.variables[value] = name
                used.append(f"{name} = {array}[{k}]")
        return wrap("const V " + ", ".join(used) + ";") if used else []

    def statements(self, result_array: str) -> List[str]:
        lines = []
        for operation in self.operations:
            name = self.plan.names.get(operation)
            if operation in self.results and not name and self.uses[operation] == 1:
                continue
            if name or self.uses[operation] > 1:
                name = self.fresh(name or "shared")
                lines += wrap(f"const {self.type_of(operation)} {name} = {self.text(operation)};")
                self.variables[operation] = name
        for k, result in enumerate(self.results):
            lines += wrap(f"{result_array}[{k}] = {self.text(result)};")
        return lines

    @staticmethod
    def type_of(operation: Operation) -> str:
        several = SEVERAL_VALUES.get(operation.op)
        return f"{several}<V>" if several else "V"

    def fresh(self, name: str) -> str:
        candidate, k = name, 1
        while candidate in self.taken or candidate == "shared":
            candidate, k = f"{name}{k}", k + 1
        self.taken.add(candidate)
        return candidate

    def text(self, operation: Operation, nested: bool = False) -> str:
        if operation in self.variables:
            return self.variables[operation]
        if operation.op == "component":
            return f"{self.text(operation.operands[0])}.{operation.name}"
        if operation.op == "constant":
            return f"{operation.name}<V>()" if operation.name else f"V({number(operation.value)})"
        operands = [self.text(operand, operation.op not in FUNCTIONS) for operand in operation.operands]
        if operation.op in FUNCTIONS:
            return f"{operation.op}({', '.join(operands)})"
        sign = INFIX.get(operation.op, "/")
        text = f" {sign} ".join(operands)
        return f"({text})" if nested else text


def constant_names(plan: Plan) -> List[str]:
    """Names of what the prologue hands to the body."""
    names = [plan.names.get(c, c.name) for c in plan.constants]
    if not all(names):
        raise ValueError("what the prologue hands to the body needs a name: let(...)")
    return names


def number(value: Fraction) -> str:
    if value.denominator & (value.denominator - 1):
        raise ValueError(f"{value} is not exact in binary")
    return str(value.numerator) if value.denominator == 1 else repr(float(value))


def wrap(statement: str, indent: int = 8) -> List[str]:
    """Break a statement after commas so that its lines, indented, fit the page."""
    width = WIDTH - indent
    lines = fill(statement.replace(", ", ",\n").split("\n"), width, width - 4)
    return [lines[0]] + ["    " + rest for rest in lines[1:]]


def fill(pieces: Sequence[str], width: int, further: int) -> List[str]:
    """Lines of whole pieces: the first of that width, and the further ones."""
    lines, line = [], ""
    for piece in pieces:
        if line and len(line) + 1 + len(piece) > (further if lines else width):
            lines.append(line)
            line = piece
        else:
            line = f"{line} {piece}" if line else piece
    return lines + [line]
