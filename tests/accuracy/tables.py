"""The tables of docs/accuracy.md, as Markdown."""

import math
import textwrap
from typing import Callable, Dict, Iterable, List

from results import PARTS, PRECISIONS, Figure, Results

OWN_SIZE = ", of its own size"  # ends the names of functions that are measured by a size which may vanish
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def parts(results: Results) -> Dict[str, str]:
    """By the names that the page has for them."""
    return {
        "run": run(results),
        "bounds": bounds(results, ("functions",)),
        "identities": bounds(results, ("identities", "chains")),
        "conversions": bounds(results, ("conversions",)),
        "drift": drift(results),
        "missed": missed(results),
        "truth": truth(results),
        "details": details(results),
    }


# --------------------------------------------------------------------------------------------------------- numbers

def power_of_ten(number: float, digits: int = 0) -> str:
    exponent = math.floor(math.log10(number))
    leading = f"{number / 10 ** exponent:.{digits}f}"
    if float(leading) == 10:
        leading, exponent = f"{1:.{digits}f}", exponent + 1
    return f"{leading}·10{str(exponent).translate(SUPERSCRIPTS)}"


def number(value: float) -> str:
    if math.isinf(value):
        return "∞"
    if value >= 1000:
        return power_of_ten(value)
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def bound(value: float) -> str:
    """Up to the next half, or to the next in one digit."""
    if math.isinf(value):
        return "∞"
    if value >= 1000:
        unit = 10 ** math.floor(math.log10(value))
        return power_of_ten(math.ceil(value / unit) * unit)
    return f"{math.ceil(2 * value) / 2:g}"


def paragraph(text: str) -> str:
    return textwrap.fill(text, 118)


def table(header: List[str], rows: Iterable[List[str]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


# --------------------------------------------------------------------------------------------------------- choosing

def functions(figures: List[Figure]) -> List[str]:
    """Each once, in order."""
    return list(dict.fromkeys(figure.function for figure in figures))


def by_class(results: Results, figures: List[Figure], show: Callable[[float], str], what: str = "worst") -> str:
    """The largest; that of the instruction sets that do not fuse apart where it is larger."""
    largest = [max(getattr(figure, what) for figure in figures if figure.isa_class == name)
               for name in results.classes()]
    if largest[-1] <= largest[0]:
        largest = largest[:1]
    return " / ".join(dict.fromkeys(map(show, largest)))


def cells(results: Results, figures: List[Figure], show: Callable[[List[Figure]], str]) -> List[str]:
    """Rotation in both precisions, then translation."""
    return [show([figure for figure in figures if (figure.part, figure.precision) == (part, precision)])
            for part in PARTS for precision in PRECISIONS]


def relative_to(figures: List[Figure], part: str) -> str:
    return "; ".join(dict.fromkeys(figure.relative_to for figure in figures if figure.part == part))


# ------------------------------------------------------------------------------------------------------ the tables

def run(results: Results) -> str:
    names = {"fused": "with fused multiply-adds", "unfused": "without"}
    isas = "; ".join(f"{names[name]} {results.isas[name]}" for name in results.classes())
    of = {section: max(figure.count for figure in results.figures if figure.section == section)
          for section in ("functions", "chains", "conversions")}
    short = "" if results.truth["run"] == "full" else " **This was a quick run, with few inputs.**"
    return paragraph(f"Instruction sets: {isas}. Each row of the last table is {of['functions']:,} inputs "
                     f"(n-fold products {of['chains']:,}, conversions {of['conversions']:,}).{short}")


def bounds(results: Results, sections) -> str:
    """The worst over all inputs."""
    figures = [figure for figure in results.figures
               if figure.section in sections and not figure.function.endswith(OWN_SIZE)]
    asked = any(figure.asked for figure in figures)
    rows = []
    for function in functions(figures):
        of = [figure for figure in figures if figure.function == function]
        row = [function] + cells(results, of, lambda chosen: by_class(results, chosen, bound))
        row += [relative_to(of, part) for part in PARTS]
        rows.append(row + ([f"{of[0].asked:g}" if of[0].asked else ""] if asked else []))
    header = ["", "rotation f32", "f64", "translation f32", "f64", "rotation relative to", "translation relative to"]
    return table(header + (["asked"] if asked else []), rows)


def drift(results: Results) -> str:
    rows = []
    for line in results.drifts:
        with_or_without = "with" if line["class"] == "fused" else "without"
        rows.append([f"{line['precision']}, {with_or_without} fused multiply-adds"] +
                    [power_of_ten(line[key], 1) for key in ("after", "before", "pseudoscalar")])
    return table(["", "\\|α - 1\\| after renormalising", "before", "\\|β\\| after, of the translation"], rows)


def missed(results: Results) -> str:
    """Where the worst is more than was asked."""
    rows = []
    for function in functions(results.figures):
        for part in PARTS:
            of = [figure for figure in results.figures if (figure.function, figure.part) == (function, part)]
            if part == "rotation" and function.endswith(OWN_SIZE):
                continue  # the same as by another size
            if not any(figure.asked and figure.worst > figure.asked for figure in of):
                continue
            row = [function, part, relative_to(of, part), f"{of[0].asked:g}"]
            for precision in PRECISIONS:
                chosen = [figure for figure in of if figure.precision == precision]
                row.append(by_class(results, chosen, number))
            rows.append(row + [by_class(results, of, number, "median")])
    return table(["", "part", "relative to", "asked", "f32", "f64", "median"], rows)


def truth(results: Results) -> str:
    apart = max(figure.disagreement for figure in results.figures)
    series = results.truth["difference"]
    return paragraph(
        f"In this run the two kinds of true values differed by no more than {power_of_ten(apart)} epsilons of what "
        f"they judge, and the closed forms from the power series by no more than {power_of_ten(series)}.")


def details(results: Results) -> str:
    """A row for every kind of inputs; conversions have too many for that."""
    figures = [figure for figure in results.figures if figure.section != "conversions"]
    rows = []
    for function in functions(figures):
        of_function = [figure for figure in figures if figure.function == function]
        for inputs in dict.fromkeys(figure.inputs for figure in of_function):
            of = [figure for figure in of_function if figure.inputs == inputs]
            rows.append([function, inputs] + cells(results, of, lambda chosen: worst_and_median(results, chosen)))
    return table(["", "inputs", "rotation f32", "f64", "translation f32", "f64"], rows)


def worst_and_median(results: Results, figures: List[Figure]) -> str:
    return f"{by_class(results, figures, number)} ({number(max(figure.median for figure in figures))})"
