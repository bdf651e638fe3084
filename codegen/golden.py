"""Golden vectors: the definition of a kernel evaluated over the rationals."""

from __future__ import annotations

from fractions import Fraction
from typing import Dict, Iterator, List, Tuple

from kernels import Kernel, as_tuple

# Rotation parts (s, b12, b13, b23) whose squares sum to a square, so that a normalised motor is rational: the
# identity, half turns, quarter turns in quarters, and unnormalised ones.
SQUARE_ROTATIONS = (
    (1, 0, 0, 0),
    (-1, 0, 0, 0),
    (0, 1, 0, 0),
    (0, 0, -1, 0),
    (0, 0, 0, 1),
    (1, 1, 1, 1),
    (-1, 1, 1, -1),
    (1, 2, -2, 4),
    (2, -4, 5, 6),
    (3, 0, 4, 0),
    (0, 0, 8, -6),
    (1, 1, -3, 5),
)
LARGEST_EXACT = 2**53


class Sequence:
    """A fixed sequence of dyadic rationals, exact in float: multiples of 1/8 between -8 and 8."""

    def __init__(self) -> None:
        self.state = 1

    def next(self) -> Fraction:
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return Fraction((self.state >> 33) % 129 - 64, 8)


def golden_rows(kernel: Kernel) -> List[Tuple[List[Fraction], List[Fraction]]]:
    rows = []
    for values in golden_inputs(kernel):
        flat = [values[name] for i in kernel.inputs for name in i.symbols]
        rows.append((flat, evaluate(kernel, values)))
    return rows


def golden_inputs(kernel: Kernel) -> Iterator[Dict[str, Fraction]]:
    sequence = Sequence()
    for rotation in SQUARE_ROTATIONS:
        values = {name: sequence.next() for i in kernel.inputs for name in i.symbols}
        for i in kernel.inputs:
            if i.element.name == "motor":
                values.update(zip(i.symbols, map(Fraction, rotation)))
        yield values


def evaluate(kernel: Kernel, values: Dict[str, Fraction]) -> List[Fraction]:
    _, definition = kernel.forms[0]
    operands = [i.multivector(values.__getitem__) for i in kernel.inputs]
    results = as_tuple(definition(*operands, lambda name, value: value))
    outputs = [Fraction(c) for o, r in zip(kernel.outputs, results) for c in o.coefficients(r)]
    if any(max(abs(o.numerator), o.denominator) > LARGEST_EXACT for o in outputs):
        raise ValueError(f"{kernel.name}: a golden result is not exact in double")
    return outputs
