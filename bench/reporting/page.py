"""The page that shows a run, and the table that a terminal shows."""

import re
from typing import Dict, List, Optional

from .bars import bars
from .results import Results, Row


def rate(value: float) -> str:
    """12.3 G, 456 M."""
    for size, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:.3g} {letter}"
    return f"{value:.3g}"


def percentage(results: Results, row: Optional[Row]) -> str:
    part = results.part_of_limit(row) if row else None
    return f"{100 * part[0]:.0f} % {part[1]}" if part else ""


# ------------------------------------------------------------------------------------------------------ terminal

def terminal(results: Results) -> str:
    """Every row as a percentage of its limit, and the bars."""
    rows = [[row.name, rate(row.items_per_second) + "/s", rate(row.bytes_per_second) + "B/s",
             percentage(results, row)] for row in results.rows]
    text = _columns(["benchmark", "results", "bytes", "of its limit"], rows)
    reached = bars(results)
    if reached:
        text += "\n\n" + _columns(["bar", "against", "asked", "reached", ""],
                                  [[bar.shape, bar.rival, f"{bar.asked:g}", f"{bar.reached:.2f}",
                                    "pass" if bar.passed else "FAIL"] for bar in reached])
    return text


def _columns(head: List[str], rows: List[List[str]]) -> str:
    widths = [max(len(line[column]) for line in [head] + rows) for column in range(len(head))]
    lines = ["  ".join(cell.ljust(width) if column == 0 or width > 24 else cell.rjust(width)
                       for column, (cell, width) in enumerate(zip(line, widths))).rstrip()
             for line in [head] + rows]
    lines.insert(1, "-" * max(map(len, lines)))
    return "\n".join(lines)


# ---------------------------------------------------------------------------------------------------------- page

def page(results: Results, charts: Dict[str, List[str]], command: str) -> str:
    """index.md. `charts` has file names by kernel."""
    parts = [_heading(results, command), _bars(results), _how_to_read(), _charts(charts), _percentages(results),
             _limits(results)]
    return "\n\n".join(part for part in parts if part) + "\n"


def _heading(results: Results, command: str) -> str:
    context = results.context
    caches = ", ".join(f"{name} {_size(size)}" for name, size in results.cache_sizes())
    facts = [("CPU", f"{context['cpu']}, {context['num_cpus']} CPUs, {caches}"), ("Date", context["date"]),
             ("Instruction sets", context["isas"]), ("Library built by", context["compiler"]),
             ("Plain loops built by", context["baseline_compilers"]),
             ("Other libraries", context["baseline_libraries"] + ", libm, stream"), ("Left out", context["skipped"]),
             ("Command", f"`{command}`"), ("Length", "quick" if context["quick"] == "yes" else "full")]
    load = context.get("load_avg")
    if load:
        facts.insert(2, ("Load when it began", ", ".join(f"{value:.2f}" for value in load)))
    return "# Benchmarks\n\n" + _table(["", ""], [[name, value] for name, value in facts if value])


def _bars(results: Results) -> str:
    reached = bars(results)
    if not reached:
        return ""
    rows = [[f"`{bar.shape}`", bar.rival, f"{bar.asked:g}", f"{bar.reached:.2f}",
             "pass" if bar.passed else "**fail**"] for bar in reached]
    return "## Bars\n\nRatios of medians.\n\n" + _table(["shape", "against", "asked", "reached", ""], rows)


def _how_to_read() -> str:
    return """## How to read this

All rows of a shape - every instruction set, every baseline, the machine's limits - run in turns, in random order, on
the same data in one process; a number is the median of the repetitions. All of them gave the same results before
anything was timed. Matrices, quaternions and dual quaternions of the baselines are made beforehand; what the library
makes of a motor in a call is in its time.

A `grid` is 64 motors on as many elements as the count says; its rates are of results, 64 an element. They lie motor
after motor, or (`aos-columns`) element after element. An `indexed` kernel has a palette of 64 motors and an index of
two bytes an element, in runs of 32 equal ones, as the rigid parts of a mesh have. A `vertex` is a position and a
normal in 24 bytes, in 32 bytes, or in six arrays; `two-passes` is the library in two calls, positions first. `mixed`
is motors of double on points of float, with a shift before and after; its operations are measured against the
`limit_fma` of double.

What is computed of motors has unit motors that turn by any angle, generators that turn by up to a half turn and
parameters from 0 to 1. `libm` is the same in scalar code that calls the C library. Of `slerp_motor_each`, `eigen`
interpolates the rotations alone, in quaternions. `compose_motor_hierarchy` is skeletons of 64 joints, each the child
of the one before, and its count is that of skeletons: side by side in `soa`, one after the other in `aos`. Matrices
and quaternions `wxyz` have no `soa`.

Motions are of degree three over [0, 1]: B-splines of 16 controls, and multiplicative ones Bézier curves of four.
`sample_<kind>_one` is one motion at sorted parameters, `one_random` at others; `each` is many motions, each at its
own parameter, and `each_shared` at one for all, of which the weights are not among the operations. Operations of
velocities (`twist`) are not counted. Of many motions a sample reads four controls. `six-slerps` is the library in six
calls of slerp on arrays of controls, which are packed otherwise. `apply_point_motion` is 1,000 frames of an additive
motion on as many vertices as the bunny has, and `poses` is apply_point_grid on the poses of these frames, made
beforehand. `compile_<kind>` is one motion of 1,000 controls.

The limit of a row is the larger of two times: its operations (`generated/kernel_list.inc`, and of motions
`bench/motions.cpp`; divisions and square roots are not among them) at the rate of `limit_fma`, and its bytes at the
rates of `limit_copy`, `limit_read` and `limit_fill` at the same footprint - as many bytes as are both read and
written count as a copy, the rest as a read or a fill. Beyond the first cache the gaps of strided arrays count, too.
The rate of a memory limit is that of the best of the C library, a loop of the widest vectors and one of non-temporal
stores. `scalar` and `sse2` cannot fuse: their operation is a product and a sum. Compilers may make vectors of a
`scalar` kernel, which can then pass its limit. A baseline is measured against the limit of the kernel, on the best
instruction set; it may move or compute less, as a plain loop over quaternions and translations does, and can pass
it."""


def _charts(charts: Dict[str, List[str]]) -> str:
    sections = [f"### {kernel}\n\n" + "\n\n".join(f"![{_caption(name)}]({name})" for name in names)
                for kernel, names in charts.items() if names]
    return "## Charts\n\n" + "\n\n".join(sections) if sections else ""


def _caption(file_name: str) -> str:
    return re.sub(r"[_-]+", " ", file_name[:-len(".svg")])


def _percentages(results: Results) -> str:
    """Of the best instruction set, by count."""
    isa = results.isas[0]
    counts = sorted({row.count for row in results.rows if row.isa})
    shapes = dict.fromkeys((row.kernel, row.layout, row.precision) for row in results.rows if row.isa == isa)
    rows = [[f"`{'/'.join(shape)}`"] + [percentage(results, results.find(*shape, count, isa)) for count in counts]
            for shape in shapes]
    head = [isa] + [f"{count:,}" for count in counts]
    return "## Percentages of the limit\n\n" + _table(head, rows) if rows else ""


def _limits(results: Results) -> str:
    rows = [[f"`limit_fma/{precision}/{isa}`", rate(value) + "/s"]
            for (precision, isa), value in sorted(results.fma.items())]
    for name, size in results.cache_sizes():
        for kind, limit in results.memory.items():
            value = limit.at(size / 2)
            if value:
                rows.append([f"`limit_{kind}`, half of {name}", rate(value) + "B/s"])
    return "## Limits\n\n" + _table(["", ""], rows) if rows else ""


def _size(size: int) -> str:
    return f"{size / (1 << 20):g} MiB" if size >= 1 << 20 else f"{size / (1 << 10):g} KiB"


def _table(head: List[str], rows: List[List[str]]) -> str:
    lines = [head, ["---"] * len(head)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
