#!/usr/bin/env python3
"""Writes everything in generated/ and the public headers, and nothing else does.

    python3 codegen/generate.py            write them
    python3 codegen/generate.py --check    compare instead: print the differences and fail if there are any

The output depends on codegen/ alone, to the byte. Needs Python 3.9 and jinja2 (Debian: python3-jinja2).
"""

from __future__ import annotations

import argparse
import difflib
import sys
import textwrap
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Dict, List, Sequence, Set, Tuple

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

try:
    import jinja2
except ModuleNotFoundError:
    sys.exit("generate.py needs jinja2: install it (Debian: apt-get install python3-jinja2) for this python3")

from algebra import BLADES, METRIC, Multivector, blade_product, blade_reverse, e
from api_text import api_files
from approximate import (
    MANTISSA_BITS,
    REAL_NUMBERS,
    TABLE,
    error_bound,
    inverse_two_pi_words,
    literal,
    polynomial,
)
from elements import MOTOR, VECTOR
from emit import WIDTH, Writer, constant_names
from expression import named, node, symbol
from golden import golden_rows
from kernels import KERNELS, Kernel, Pairing, as_tuple
from plan import Operation
from simplify import Choice, Form, choose

ROOT = Path(__file__).resolve().parent.parent
TEMPLATES = ROOT / "codegen" / "templates"
OUTPUT = ROOT / "generated"
MENDING = "python3 codegen/generate.py"


@dataclass(frozen=True)
class Variant:
    """A kernel in one pairing, with or without the promise of normalised motors, and how it will be computed."""

    kernel: Kernel
    pairing: Pairing
    unit: bool
    choice: Choice

    @property
    def name(self) -> str:
        return variant_name(self.kernel, self.pairing.name, self.unit)

    @property
    def like(self) -> str:
        """The struct whose arithmetic it is, if it has none of its own."""
        return variant_name(self.kernel, self.pairing.like, self.unit) if self.pairing.like else ""

    @property
    def fixed(self):
        return [i for i in self.kernel.inputs if i.name in self.pairing.fixed]

    @property
    def streams(self):
        return [i for i in self.kernel.inputs if i.name not in self.pairing.fixed]


def variant_name(kernel: Kernel, pairing: str, unit: bool) -> str:
    suffix = "_unit" if unit else "_mixed" if kernel.mixed else ""
    return f"{kernel.verb}_{kernel.operand}_{pairing}{suffix}"


def derive(kernel: Kernel, pairing: Pairing, unit: bool) -> Variant:
    forms = kernel.unit_forms if unit else kernel.forms
    varying = frozenset(s for i in kernel.inputs if i.name not in pairing.fixed for s in i.symbols)
    built = [build_form(kernel, name, formula) for name, formula in forms]
    return Variant(kernel, pairing, unit, choose(built, varying, kernel.unit_relations if unit else {}))


def build_form(kernel: Kernel, name: str, formula) -> Form:
    """Evaluate a formula over expressions."""

    def let(name, value):
        if not isinstance(value, Multivector):
            return named(name, node(value))
        return Multivector({blade: named(name + blade, node(part)) for blade, part in value.parts.items()})

    results = as_tuple(formula(*[i.multivector(symbol) for i in kernel.inputs], let))
    pairs = zip(kernel.outputs, results)
    return Form(name, tuple(node(c) for output, result in pairs for c in output.coefficients(result)))


@lru_cache(maxsize=None)
def variants_of(kernel: Kernel) -> List[Variant]:
    variants: Dict[str, Variant] = {}
    for pairing in kernel.pairings:
        # once a motor, a division does not count
        for unit in (False, True) if kernel.unit_forms and "motor" not in pairing.fixed else (False,):
            variant = variants.get(variant_name(kernel, pairing.like, unit)) or derive(kernel, pairing, unit)
            variants[variant_name(kernel, pairing.name, unit)] = replace(variant, pairing=pairing)
    return list(variants.values())


# ------------------------------------------------------------------------------------------------- what is written


def render_all() -> Dict[str, str]:
    """Every file that is written, by its path."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(str(TEMPLATES)),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        newline_sequence="\n",
    )

    def render(template: str, **values) -> str:
        return environment.get_template(template).render(**values)

    files, rows = {}, []
    for kernel in KERNELS:
        variants = variants_of(kernel)
        files[f"generated/kernels/{kernel.name}.inl"] = render("kernel.inl.j2", **kernel_values(kernel, variants))
        if kernel.is_rational:
            files[f"generated/golden/{kernel.name}.inc"] = render("golden.inc.j2", **golden_values(kernel))
        rows += [list_row(variant) for variant in variants]
    files["generated/kernels.inc"] = render("kernels.inc.j2", names=sorted(kernel.name for kernel in KERNELS))
    files["generated/kernels/approximations.inl"] = render("approximations.inl.j2", **approximation_values())
    files["generated/inverse_two_pi.inc"] = render("inverse_two_pi.inc.j2", lines=inverse_two_pi_lines())
    files["generated/kernel_list.inc"] = render("kernel_list.inc.j2", rows=rows)
    files["generated/product_tables.md"] = render("product_tables.md.j2", **product_table_values())
    return {**files, **api_files(render)}


def kernel_values(kernel: Kernel, variants: Sequence[Variant]) -> Dict[str, object]:
    return {
        "title": kernel.name.replace("_", " "),
        "formula": kernel.formula,
        "source": kernel.source,
        "variants": [variant_values(variant) for variant in variants],
    }


def variant_values(variant: Variant) -> Dict[str, object]:
    kernel, plan = variant.kernel, variant.choice.plan
    blends = kernel.verb == "blend"
    motors = [i for i in variant.streams if kernel.verb == "apply" and i.name == "motor"]
    inputs = [i.element.size for i in variant.streams[len(motors) + blends :]]
    outputs = [output.size for output in kernel.outputs]
    return {
        "title": f"{kernel.verb} {kernel.operand} {variant.pairing.name}"
        + (", for motors with S̄S = 1" if variant.unit else ", computed in double" if kernel.mixed else ""),
        "struct": variant.name,
        "like": variant.like,
        "forms": [
            {"name": name, "cost": form_cost(candidate, bool(variant.fixed)), "chosen": candidate is plan}
            for name, candidate in variant.choice.considered
        ],
        "has_prologue": bool(variant.fixed),
        "fixed_size": sum(i.element.size for i in variant.fixed),
        "constant_size": len(plan.constants),
        "motor_size": sum(i.element.size for i in motors),
        "input_sizes": inputs,
        "output_sizes": outputs,
        "affine": variant.choice.form.name == "matrix" and inputs == outputs and set(outputs) == {3},
        "accumulates": blends,
        "degree": None if variant.unit else kernel.degree,
        "has_fixed_motor": any(i.element is MOTOR for i in variant.fixed),
        "prologue_count": comment(str(plan.count("prologue"))),
        "prologue": write_prologue(variant),
        "body_count": comment(str(plan.count("body"))),
        "body": write_body(variant),
    }


def comment(text: str) -> List[str]:
    return textwrap.wrap(text, WIDTH - len("    // "))


def form_cost(plan, has_prologue: bool) -> str:
    def text(stage: str) -> str:
        count = plan.count(stage)
        return f"{count.operations}" + (f" + {count.divisions} div or sqrt" if count.divisions else "")

    return text("body") + (f"  ({text('prologue')})" if has_prologue else "")


def input_values(inputs, in_body: bool) -> Tuple[List[str], List[Operation]]:
    names = [name for i in inputs for name in i.symbols]
    return names, [Operation("input", name=name, in_body=in_body) for name in names]


def write_prologue(variant: Variant) -> List[str]:
    writer = Writer(variant.choice.plan, "prologue")
    return writer.declare_inputs("fixed", *input_values(variant.fixed, False)) + writer.statements("constant")


def write_body(variant: Variant) -> List[str]:
    plan = variant.choice.plan
    writer = Writer(plan, "body")
    lines = writer.declare_inputs("constant", constant_names(plan), plan.constants)
    lines += writer.declare_inputs("in", *input_values(variant.streams, True))
    return lines + writer.statements("out")


def list_row(variant: Variant) -> Dict[str, object]:
    kernel, count = variant.kernel, variant.choice.plan.count("body")
    inputs = sum(i.element.size for i in variant.streams)
    if kernel.verb == "blend":  # the sum stays in registers, and shared controls are not read an element
        inputs = 1 if variant.pairing.name == "one" else 1 + kernel.output_size
    columns = [kernel.verb, kernel.operand, variant.pairing.name]
    columns += [inputs, kernel.output_size, count.operations, count.divisions]
    kind = "_UNIT" if variant.unit else "_MIXED" if kernel.mixed else ""
    return {"macro": "MOTORWAY_KERNEL" + kind, "columns": columns}


def golden_values(kernel: Kernel) -> Dict[str, object]:
    def decimal(value) -> str:
        return f"{float(value):g}"

    return {
        "title": kernel.name.replace("_", " "),
        "inputs": [name for i in kernel.inputs for name in i.symbols],
        "outputs": [name for output in kernel.outputs for name, _ in output.components],
        "rows": [
            {"inputs": [decimal(v) for v in inputs], "outputs": outputs} for inputs, outputs in golden_rows(kernel)
        ],
    }


def approximation_values() -> Dict[str, object]:
    def polynomial_values(name: str, row) -> Dict[str, object]:
        rows = []
        for precision in MANTISSA_BITS:
            suffix = "f" if precision == "f32" else ""
            literals = [literal(c, precision) + suffix for c in polynomial(name, precision)]
            bound = float(error_bound(name, precision, row.weight))
            lines = textwrap.wrap(", ".join(literals) + ",", WIDTH - 8)
            rows.append({"literals": lines, "degree": row.degree(precision), "bound": f"{bound:.2g}"})
        return {"name": name, "meaning": row.function.meaning, "end": row.end, "weight": row.weight, "rows": rows}

    return {
        "numbers": [
            {"name": name, "meaning": meaning, "literals": [literal(value(p), p) for p in MANTISSA_BITS]}
            for name, (meaning, value) in REAL_NUMBERS.items()
        ],
        "polynomials": [polynomial_values(name, row) for name, row in TABLE.items() if name in used_functions()],
    }


def inverse_two_pi_lines() -> List[str]:
    return textwrap.wrap(", ".join(f"0x{word:08x}" for word in inverse_two_pi_words()) + ",", WIDTH)


def used_functions() -> Set[str]:
    """Those of the kernels, and those that only the velocities of motions take (src/kernel/motion.h)."""
    return {"adjoint", "adjoint_slope"} | {op for kernel in KERNELS for v in variants_of(kernel) for op in v.choice.plan.count("body").by_kind}


def product_table_values() -> Dict[str, object]:
    def table(title: str, text: str, left: Sequence[str], right: Sequence[str], product) -> Dict[str, object]:
        rows = [{"label": label(a), "cells": [combination(product(a, b)) for b in right]} for a in left]
        return {"title": title, "text": text, "columns": [label(b) for b in right], "rows": rows}

    def outer(a: str, b: str):
        return [(blade, c) for blade, c in e(a).outer(e(b)).parts.items()]

    motor, vector = MOTOR.blades, VECTOR.blades
    squares = ", ".join(f"e{a}·e{b} = {value}" for (a, b), value in METRIC.items() if a <= b)
    return {
        "metric": squares,
        "reverses": [
            {"blade": label(b), "reverse": combination(blade_reverse(b))} for b in BLADES if len(b) % 2 == 0
        ],
        "tables": [
            table("Motor times motor", "Row times column; `compose`.", motor, motor, blade_product),
            table("Vector times motor", "Row times column; the first half of S̄ p S.", vector, motor, blade_product),
            table("Motor times vector", "Row times column.", motor, vector, blade_product),
            table(
                "Vector ∧ motor",
                "½(ab - ba) with the row on the left: the sparse commutator that `apply` is made of.",
                vector,
                motor,
                outer,
            ),
        ],
    }


def label(blade: str) -> str:
    return f"e{blade}" if blade else "1"


def combination(terms) -> str:
    """A linear combination of blades, as text."""
    text = ""
    for blade, c in terms:
        factor = "" if abs(c) == 1 and blade else f"{abs(c)}"
        sign = ("-" if c < 0 else "") if not text else (" - " if c < 0 else " + ")
        text += sign + factor + (label(blade) if blade else "")
    return text


# ---------------------------------------------------------------------------------------------- writing and checking


def write(files: Dict[str, str]) -> None:
    for path in orphans(files):
        path.unlink()
    written = 0
    for name, text in files.items():
        path, data = ROOT / name, text.encode("utf-8")
        if not path.exists() or path.read_bytes() != data:  # else what depends on it would be built again
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
            written += 1
    print(f"generate.py: wrote {written} of {len(files)} files, the others are as they were")


def orphans(files: Dict[str, str]) -> List[Path]:
    """Files in generated/ that the generator does not write."""
    known = {ROOT / name for name in files}
    return sorted(path for path in OUTPUT.rglob("*") if path.is_file() and path not in known)


def check(files: Dict[str, str]) -> bool:
    """Print how generated/ differs from what would be written, and how to mend it."""
    current = True
    for name, text in files.items():
        path = ROOT / name
        found = path.read_text(encoding="utf-8") if path.exists() else ""
        if found != text:
            current = False
            sys.stdout.writelines(
                difflib.unified_diff(
                    found.splitlines(keepends=True),
                    text.splitlines(keepends=True),
                    f"{name} (checked in)",
                    f"{name} (what codegen/ writes)",
                )
            )
    for path in orphans(files):
        current = False
        print(f"orphan: {path.relative_to(ROOT)} is not written by the generator")
    if not current:
        print(f"what is checked in is not what codegen/ writes; to mend it, run:  {MENDING}")
    return current


def main() -> int:
    parser = argparse.ArgumentParser(description="Write generated/ and the public headers.")
    parser.add_argument("--check", action="store_true", help="compare instead of writing; fail on any difference")
    arguments = parser.parse_args()
    files = render_all()
    if arguments.check:
        return 0 if check(files) else 1
    write(files)
    return 0


if __name__ == "__main__":
    sys.exit(main())
