"""SVG charts of a run. Needs matplotlib."""

import os
from typing import Dict, List, Optional

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  pylint: disable=wrong-import-position
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator  # noqa: E402

from . import labels  # noqa: E402
from .results import Results, Row  # noqa: E402

INK, FAINT, GRID = "#22272e", "#8b949e", "#e4e8ec"
ISA_COLOURS = {"avx512": "#0b5cad", "avx2": "#2f9e8f", "sse2": "#d9902f", "scalar": "#b0527a", "neon64": "#0b5cad"}
PLAIN, LIBRARY, LIMIT = "#57606a", "#a3acb5", "#cf222e"

STYLE = {
    "font.family": "sans-serif", "font.size": 9, "axes.edgecolor": FAINT, "axes.labelcolor": INK,
    "axes.titlesize": 9.5, "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.spines.top": False,
    "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True, "grid.color": GRID, "text.color": INK,
    "xtick.color": INK, "ytick.color": INK, "legend.frameon": False, "svg.hashsalt": "motorway", "svg.fonttype": "none",
}


def short(number: float) -> str:
    """1k is 1024."""
    for size, letter in ((1 << 20, "M"), (1 << 10, "k")):
        if number >= size:
            return f"{number / size:g}{letter}"
    return f"{number:g}"


def _decimal(value: float, _=None) -> str:
    return f"{value:g}"


def _save(figure, directory: str, name: str) -> str:
    figure.savefig(os.path.join(directory, name), metadata={"Date": None}, bbox_inches="tight", pad_inches=0.12)
    plt.close(figure)
    return name


# ------------------------------------------------------------------------------------------ throughput against size

def throughput(results: Results, kernel: str, directory: str) -> Optional[str]:
    """A panel for every layout, a line of panels for every precision. None if one size alone was measured."""
    ours = [row for row in results.rows if row.kernel == kernel and row.isa and row.threads == 1]
    if len({row.count for row in ours}) < 2:
        return None
    precisions = sorted({row.precision for row in ours})
    panels = {precision: _layouts(ours, precision) for precision in precisions}
    columns = max(map(len, panels.values()))
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(len(precisions), columns, figsize=(4.1 * columns, 3.1 * len(precisions) + 0.6),
                                    squeeze=False, sharex=True, sharey="row")
        handles: Dict[str, object] = {}
        for line, precision in enumerate(precisions):
            for column, layout in enumerate(panels[precision]):
                handles.update(_throughput_panel(axes[line][column], results, kernel, layout, precision))
            axes[line][0].set_ylabel(f"billions of {labels.elements(kernel)} a second")
        for axis in axes[-1]:
            axis.set_xlabel(f"{labels.elements(kernel)} in a call (1k is 1,024)")
        figure.tight_layout(rect=(0, 0, 1, 1 - 1.05 / figure.get_figheight()), h_pad=1.6)
        _title(figure, labels.title(kernel), "One thread; higher is faster.")
        figure.legend(handles.values(), handles.keys(), loc="upper left", ncol=(len(handles) + 1) // 2,
                      bbox_to_anchor=(0, 1 - 0.42 / figure.get_figheight()), handlelength=1.8, columnspacing=1.6)
        return _save(figure, directory, f"throughput_{kernel}.svg")


def _title(figure, title: str, text: str) -> None:
    left, inch = 0.1 / figure.get_figwidth(), 1 / figure.get_figheight()
    figure.text(left, 1, title, va="top", fontsize=11, fontweight="bold")
    figure.text(left, 1 - 0.23 * inch, text, va="top")


def _layouts(rows: List[Row], precision: str) -> List[str]:
    """aos, strided, soa."""
    found = {row.layout for row in rows if row.precision == precision}
    return sorted(found, key=lambda layout: (layout == "soa", len(layout), layout))


def _throughput_panel(axis, results: Results, kernel: str, layout: str, precision: str) -> Dict[str, object]:
    handles = {}
    for isa in results.isas:
        rows = _series(results.rows, kernel, layout, precision, isa)
        if rows:
            handles[labels.instruction_set(isa)] = _line(
                axis, rows, color=ISA_COLOURS.get(isa, INK), marker="o", markersize=3.2,
                linewidth=2.2 if isa == results.isas[0] else 1.4, zorder=5)
    best_isa = labels.instruction_set(results.isas[0])
    unit = _series(results.rows, kernel + "-unit", layout, precision, results.isas[0])
    if unit:
        handles[f"{best_isa}, unit motors"] = _line(axis, unit, color=ISA_COLOURS.get(results.isas[0], INK),
                                                    linewidth=1.4, linestyle=(0, (1, 1)), zorder=5)
    for label, colour, wanted in (("best loop in C", PLAIN, True), ("best other library", LIBRARY, False)):
        rows = _best_baselines(results, kernel, layout, precision, wanted)
        if rows:
            handles[label] = _line(axis, rows, color=colour, linewidth=1.3, linestyle=(0, (4, 2)), zorder=4)
    best = _series(results.rows, kernel, layout, precision, results.isas[0])
    limited = [row for row in best if results.limit_seconds(row)]
    if limited:
        handles["limit of this machine"], = axis.plot(
            [row.count for row in limited], [row.results / results.limit_seconds(row)[0] / 1e9 for row in limited],
            color=LIMIT, linewidth=1.2, zorder=3)
    _decorate(axis, results, best, f"{labels.layout(layout)}, {labels.precision(precision)}")
    return handles


def _series(rows: List[Row], kernel: str, layout: str, precision: str, isa: str) -> List[Row]:
    return sorted((row for row in rows if (row.kernel, row.layout, row.precision, row.isa, row.threads) ==
                   (kernel, layout, precision, isa, 1)), key=lambda row: row.count)


def _best_baselines(results: Results, kernel: str, layout: str, precision: str, plain: bool) -> List[Row]:
    """The best at every count."""
    best: Dict[int, Row] = {}
    for row in results.rows:
        if row.rival and (row.kernel, row.layout, row.precision) == (kernel, layout, precision) and \
                row.is_plain == plain and not row.is_own:
            if row.count not in best or best[row.count].items_per_second < row.items_per_second:
                best[row.count] = row
    return [best[count] for count in sorted(best)]


def _line(axis, rows: List[Row], **style):
    handle, = axis.plot([row.count for row in rows], [row.items_per_second / 1e9 for row in rows], **style)
    return handle


def _decorate(axis, results: Results, rows: List[Row], title: str) -> None:
    axis.set_title(title, pad=14)
    axis.set_xscale("log", base=2)
    axis.set_yscale("log")
    axis.xaxis.set_major_locator(LogLocator(base=2, numticks=40))
    counts = [row.count for row in rows]
    axis.set_xticks(counts[::2] if len(counts) > 6 else counts)
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: short(value)))
    axis.xaxis.set_minor_locator(NullLocator())
    axis.yaxis.set_major_locator(LogLocator(base=10, subs=(1, 2, 5)))
    axis.yaxis.set_major_formatter(FuncFormatter(_decimal))
    axis.yaxis.set_minor_locator(NullLocator())
    axis.tick_params(length=0, labelleft=True, labelbottom=True)
    _mark_caches(axis, results, rows)


def _mark_caches(axis, results: Results, rows: List[Row]) -> None:
    """A line where the data of all arrays together fills a cache."""
    if not rows:
        return
    bytes_per_element = rows[0].footprint / rows[0].count
    low, high = rows[0].count, rows[-1].count
    for name, size in results.cache_sizes():
        count = size / bytes_per_element
        if low < count < high:
            axis.axvline(count, color=FAINT, linewidth=0.8, linestyle=(0, (1, 2)), zorder=1)
            axis.annotate(f"{name} cache full", (count, 1), xycoords=("data", "axes fraction"), xytext=(0, 2),
                          textcoords="offset points", ha="center", va="bottom", fontsize=7.5, color=FAINT)


# ------------------------------------------------------------------------------------------- bars against baselines

def against_baselines(results: Results, kernel: str, precision: str, count: int, directory: str) -> Optional[str]:
    """A panel for every layout, fastest first. None if nothing was measured there."""
    ours = [row for row in results.rows if (row.kernel, row.precision, row.count, row.threads) ==
            (kernel, precision, count, 1) and row.isa]
    layouts = [layout for layout in _layouts(ours, precision) if results.baselines(kernel, layout, precision, count)]
    if not layouts:
        return None
    panels = [_competitors(results, ours, kernel, layout, precision, count) for layout in layouts]
    with plt.rc_context(STYLE):
        height = 0.235 * max(len(panel) for panel in panels) + 1.5
        figure, axes = plt.subplots(1, len(layouts), figsize=(max(5 * len(layouts), 7), height), squeeze=False)
        for axis, layout, panel in zip(axes[0], layouts, panels):
            _bar_panel(axis, results, panel, labels.layout(layout))
            axis.set_xlabel(f"billions of {labels.elements(kernel)} a second")
        figure.tight_layout(rect=(0, 0, 1, 1 - 0.55 / height), w_pad=2.0)
        _title(figure, labels.title(kernel),
               f"{count:,} {labels.elements(kernel)} of {labels.precision(precision)} in a call, one thread; "
               "longer is faster. In colour: Motorway; grey: other libraries; dark: loops in C.")
        return _save(figure, directory, f"baselines_{kernel}_{precision}.svg")


def _competitors(results: Results, ours: List[Row], kernel: str, layout: str, precision: str,
                 count: int) -> List[Row]:
    rows = [row for row in ours if row.layout == layout] + results.baselines(kernel, layout, precision, count)
    return sorted(rows, key=lambda row: row.items_per_second)


def _colour(results: Results, row: Row) -> str:
    if row.isa or row.is_own:
        return ISA_COLOURS.get(row.isa or results.isas[0], INK)
    return PLAIN if row.is_plain else LIBRARY


def _bar_panel(axis, results: Results, rows: List[Row], title: str) -> None:
    rates = [row.items_per_second / 1e9 for row in rows]
    colours = [_colour(results, row) for row in rows]
    axis.barh(range(len(rows)), rates, color=colours, height=0.72)
    axis.set_yticks(range(len(rows)))
    axis.set_yticklabels([labels.instruction_set(row.isa) if row.isa else labels.baseline(row.rival) for row in rows])
    for label, row in zip(axis.get_yticklabels(), rows):
        label.set_fontweight("bold" if row.isa else "normal")
    for place, rate in enumerate(rates):
        axis.text(rate, place, f" {rate:.2f}", va="center", fontsize=8)
    best = max((row for row in rows if row.isa), key=lambda row: row.items_per_second)
    seconds = results.limit_seconds(best)
    limit = best.results / seconds[0] / 1e9 if seconds else 0
    axis.set_xlim(0, 1.14 * max(rates + [limit]))
    if limit:
        axis.axvline(limit, color=LIMIT, linewidth=1.2)
        axis.annotate("limit of this machine", (limit, 1), xycoords=("data", "axes fraction"), xytext=(0, 2),
                      textcoords="offset points", ha="center", va="bottom", fontsize=7.5, color=LIMIT)
    axis.set_title(title, pad=14)
    axis.grid(axis="y", visible=False)
    axis.tick_params(length=0)
