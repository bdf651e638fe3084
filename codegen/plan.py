"""From expressions to operations: FMA contraction, the split into prologue and body, and operation counts.

A sum of products becomes a chain of fused multiply-adds. Whatever does not depend on the elements of the batch
is moved to the prologue, which runs once a motor; the rest is the body, which runs once an element.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction
from typing import Dict, FrozenSet, List, Sequence, Tuple

from approximate import TABLE
from expression import Node, sum_of

# fma(a, b, c) = a b + c, fnma = c - a b, fms = a b - c: one operation each, as on every CPU that fuses.
ARITHMETIC = ("mul", "add", "sub", "fma", "fnma", "fms", "negate")
# Steps that are not arithmetic: a comparison and a choice are two instructions, and so are a comparison and the branch
# that is hardly ever taken, after what is compared.
STEPS = {
    "at_least": 1, "nearest": 1, "magnitude": 1, "with_sign": 1, "if_less": 2, "less_half_turns": 1,
    "flip_if_odd": 3, "refine": 3, "trim": 9, "trim_unless_fused": 0, "unwind": 5, "unwind_angle": 3,
}
# Steps that make more than one value: the type that holds them.
SEVERAL_VALUES = {"unwind": "bivector", "trim": "rotor", "trim_unless_fused": "rotor"}
SLOW = ("div", "sqrt")
# A 512-bit division or square root keeps its unit busy for as long as about 32 fused multiply-adds take.
SLOW_WEIGHT = 32
COUNTED = (*ARITHMETIC, *STEPS, *SLOW, *TABLE)


def operations_of(op: str, precision: str) -> int:
    """Instructions of the class of a fused multiply-add: of a polynomial its degree."""
    if op in TABLE:
        return TABLE[op].degree(precision)
    return 1 if op in ARITHMETIC else STEPS.get(op, 0)


class Operation:
    """One operation, an input (`op` is "input") or a number ("constant": a value, or the name of a real number).

    Equal operations are one object, so that comparing them does not compare all that they depend on.
    """

    __slots__ = ("op", "operands", "name", "value", "in_body")
    _made: Dict[tuple, "Operation"] = {}

    def __new__(cls, op: str, operands: Tuple["Operation", ...] = (), name: str = "", value: Fraction = Fraction(0),
                in_body: bool = False):
        key = (op, operands, name, value, in_body)
        made = cls._made.get(key)
        if made is None:
            made = cls._made[key] = super().__new__(cls)
            made.op, made.operands, made.name, made.value, made.in_body = key
        return made

    @property
    def counted(self) -> bool:
        return self.op in COUNTED


@dataclass(frozen=True)
class Plan:
    """What a kernel computes: one operation an output, and the operations of each stage in order of execution."""

    outputs: Tuple[Operation, ...]
    prologue: Tuple[Operation, ...]
    body: Tuple[Operation, ...]
    names: Dict[Operation, str]

    @property
    def constants(self) -> Tuple[Operation, ...]:
        """What the prologue hands to the body, sorted by name: a matrix by rows, then its translation."""
        used: Dict[Operation, None] = {}
        for operation in self.body:
            for operand in operation.operands:
                if not operand.in_body and operand.op != "constant":
                    used.setdefault(operand)
        for output in self.outputs:
            if not output.in_body and output.op != "constant":
                used.setdefault(output)
        return tuple(sorted(used, key=lambda operation: self.names.get(operation, operation.name)))

    def count(self, stage: str) -> "Count":
        return Count(Counter(operation.op for operation in getattr(self, stage)))

    @property
    def cost(self) -> Tuple[int, int]:
        return (self.count("body").cost, self.count("prologue").cost)


@dataclass(frozen=True)
class Count:
    """Operations by kind."""

    by_kind: Counter

    def operations_in(self, precision: str) -> int:
        """Operations of the class of a fused multiply-add: all but divisions and square roots."""
        return sum(operations_of(op, precision) * n for op, n in self.by_kind.items())

    @property
    def operations(self) -> int:
        return self.operations_in("f32")

    @property
    def divisions(self) -> int:
        """Divisions and square roots."""
        return sum(self.by_kind[op] for op in SLOW)

    @property
    def cost(self) -> int:
        return self.operations + SLOW_WEIGHT * self.divisions

    def __str__(self) -> str:
        text = " + ".join(f"{self.by_kind[op]} {op}" for op in COUNTED if self.by_kind[op]) or "nothing"
        single, double = self.operations_in("f32"), self.operations_in("f64")
        return text if single == double else f"{text}: {single} operations in float, {double} in double"


def make_plan(outputs: Sequence[Node], element_symbols: FrozenSet[str]) -> Plan:
    """Lower the outputs. `element_symbols` are the inputs that vary from element to element."""
    lowering = _Lowering(outputs, element_symbols)
    lowered = tuple(lowering.lower(output) for output in outputs)
    stages: Dict[bool, Dict[Operation, None]] = {False: {}, True: {}}

    def visit(operation: Operation) -> None:
        if operation.op == "component":
            visit(operation.operands[0])
        if operation.counted and operation not in stages[operation.in_body]:
            for operand in operation.operands:
                visit(operand)
            stages[operation.in_body].setdefault(operation)

    for output in lowered:
        visit(output)
    return Plan(lowered, tuple(stages[False]), tuple(stages[True]), lowering.names)


class _Lowering:
    def __init__(self, outputs: Sequence[Node], element_symbols: FrozenSet[str]):
        self.element_symbols = element_symbols
        self.done: Dict[Node, Operation] = {}
        self.names: Dict[Operation, str] = {}
        # How often each product occurs: a product that several sums share is best computed once, as their start.
        self.occurrences = Counter(
            factors for n in reachable(outputs) if n.kind == "sum" for _, factors in n.terms if len(factors) > 1
        )

    def lower(self, n: Node) -> Operation:
        if n not in self.done:
            self.done[n] = self._lower(n)
        return self.done[n]

    def _lower(self, n: Node) -> Operation:
        if n.kind == "symbol":
            return Operation("input", name=n.name, in_body=n.name in self.element_symbols)
        if n.kind == "named":
            value = self.lower(n.operands[0])
            self.names.setdefault(value, n.name)
            if value.op == "negate":
                self.names.setdefault(value.operands[0], f"minus_{n.name}")
            return value
        if n.kind == "quotient":
            return operation("div", *map(self.lower, n.operands))
        if n.kind == "root":
            return operation("sqrt", *map(self.lower, n.operands))
        if n.kind == "function":
            return operation(n.name, *map(self.lower, n.operands))
        if n.kind == "component":
            values = self.lower(n.operands[0])
            return Operation("component", (values,), name=n.name, in_body=values.in_body)
        if n.kind == "precise":
            return Operation("constant", name=n.name)
        invariant = [t for t in n.terms if not self._varies(t)]
        if 1 < len(invariant) < len(n.terms):  # the invariant part is a sum of its own, for the prologue
            part = sum_of(invariant)
            return self._lower_sum(((Fraction(1), (part,)),) + tuple(t for t in n.terms if self._varies(t)))
        return self._lower_sum(n.terms)

    def _varies(self, term) -> bool:
        return any(self.lower(factor).in_body for factor in term[1])

    def _lower_sum(self, terms) -> Operation:
        if not terms:
            return Operation("constant")
        items = [self._lower_term(term) for term in terms]
        start = self._choose_start(items, terms)
        sign, accumulator = items[start][0], operation_of_product(items[start][1])
        for k, (term_sign, factors) in enumerate(items):
            if k != start:
                sign, accumulator = accumulate(sign, accumulator, term_sign, factors)
        return accumulator if sign > 0 else negate(accumulator)

    def _choose_start(self, items, terms) -> int:
        """The term that a chain starts with: a lone positive value, a shared product, a positive product."""

        def preference(k: int):
            sign, factors = items[k]
            return (len(factors) > 1, -self.occurrences[terms[k][1]] if len(factors) > 1 else 0, sign < 0, k)

        return min(range(len(items)), key=preference)

    def _lower_term(self, term) -> Tuple[int, Tuple[Operation, ...]]:
        """A term as a sign and at most two factors."""
        coefficient, factors = term
        sign, magnitude = (1 if coefficient > 0 else -1), abs(coefficient)
        lowered = sorted(map(self.lower, factors), key=lambda o: o.in_body)
        for k, factor in enumerate(lowered):
            if factor.op == "negate" and factor.in_body:  # the sign moves into the fused operation
                lowered[k], sign = factor.operands[0], -sign
        if magnitude != 1 or not lowered:
            lowered.insert(0, Operation("constant", value=magnitude))
        while len(lowered) > 2:  # invariant factors are first and are multiplied first
            lowered[0:2] = [operation("mul", *lowered[0:2])]
        return sign, tuple(lowered)


def operation(op: str, *operands: Operation) -> Operation:
    return Operation(op, operands, in_body=any(operand.in_body for operand in operands))


def operation_of_product(factors: Tuple[Operation, ...]) -> Operation:
    return factors[0] if len(factors) == 1 else operation("mul", *factors)


def negate(value: Operation) -> Operation:
    return operation("negate", value)


def accumulate(sign: int, value: Operation, term_sign: int, factors: Tuple[Operation, ...]):
    """sign·value + term_sign·product, as a sign and one operation."""
    if len(factors) == 2:
        if sign == term_sign:
            return sign, operation("fma", *factors, value)
        if sign > 0:
            return 1, operation("fnma", *factors, value)
        return 1, operation("fms", *factors, value)
    if sign == term_sign:
        return sign, operation("add", value, factors[0])
    return 1, operation("sub", *((value, factors[0]) if sign > 0 else (factors[0], value)))


def reachable(outputs: Sequence[Node]) -> List[Node]:
    """All nodes that the outputs depend on, operands first."""
    seen: Dict[Node, None] = {}

    def visit(n: Node) -> None:
        if n in seen:
            return
        for operand in n.operands:
            visit(operand)
        for _, factors in n.terms:
            for factor in factors:
                visit(factor)
        seen.setdefault(n)

    for output in outputs:
        visit(output)
    return list(seen)
