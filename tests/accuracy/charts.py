"""SVG charts of the worst error against the angle. Needs matplotlib."""

import io
import math
import os
import re
import sys
from typing import Dict, List

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from reporting.charts import LIMIT, STYLE, plt  # noqa: E402  pylint: disable=wrong-import-position
from results import PARTS, PRECISIONS, Results  # noqa: E402  pylint: disable=wrong-import-position

COLOURS = {("f32", "fused"): "#0b5cad", ("f64", "fused"): "#2f9e8f",
           ("f32", "unfused"): "#b0527a", ("f64", "unfused"): "#d9902f"}
CLASS_NAMES = {"fused": "fused", "unfused": "not fused"}
ASKED = 4
RELATIVE_TO = {"exp": "the moment given", "log": "itself", "slerp": "the larger translation given"}


def draw(results: Results, directory: str) -> None:
    for function in dict.fromkeys(point["function"] for point in results.curves):
        _draw(results, function, os.path.join(directory, f"accuracy-{function}.svg"))


def _draw(results: Results, function: str, path: str) -> None:
    """Rotation above translation; small angles beside all of them."""
    points = [point for point in results.curves if point["function"] == function]
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(2, 2, figsize=(8.6, 5.0), sharex="col", sharey="row")
        for line, part in enumerate(PARTS):
            for column, scale in enumerate(("logarithmic", "linear")):
                handles = _panel(axes[line][column], [point for point in points if point["axis"] == scale], part)
        for line, part in enumerate(PARTS):
            size = "" if part == "rotation" else f", relative to {RELATIVE_TO[function]}"
            axes[line][0].set_title(f"{function}: {part}{size}")
            axes[line][0].set_ylabel("worst error, epsilons")
        _scales(axes)
        figure.tight_layout(rect=(0, 0, 1, 0.94), h_pad=1.4)
        figure.legend(handles.values(), handles.keys(), loc="upper left", ncol=len(handles),
                      bbox_to_anchor=(0.03, 1.0), handlelength=1.8, columnspacing=1.6)
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None}, bbox_inches="tight", pad_inches=0.12)
        plt.close(figure)
    with open(path, "w", encoding="utf-8") as file:
        file.write(re.sub(r"(\d+\.\d)\d+", r"\1", text.getvalue()))  # a tenth of a point is fine enough


def _panel(axis, points: List[Dict], part: str) -> Dict[str, object]:
    handles = {}
    for precision in PRECISIONS:
        for isa_class, name in CLASS_NAMES.items():
            chosen = [point for point in points if (point["precision"], point["class"]) == (precision, isa_class)]
            if chosen:
                handles[f"{precision}, {name}"], = axis.plot(
                    [_middle(point) for point in chosen], [point[part] for point in chosen], linewidth=1.2,
                    color=COLOURS[precision, isa_class], zorder=5 if isa_class == "fused" else 4)
    handles["asked"] = axis.axhline(ASKED, color=LIMIT, linewidth=1.0, zorder=3)
    axis.tick_params(length=0, labelleft=True)
    return handles


def _middle(point: Dict) -> float:
    """Of the angles of a point: in radians on the logarithmic axis, in turns on the other."""
    if point["axis"] == "logarithmic":
        return math.sqrt(point["low"] * point["high"])
    return (point["low"] + point["high"]) / (4 * math.pi)


def _scales(axes) -> None:
    for small, all_angles in axes:
        small.set_xscale("log")
        small.set_ylim(bottom=0)
        all_angles.set_xticks([0, 0.5, 1, 1.5, 2])
    axes[-1][0].set_xlabel("angle, radians")
    axes[-1][1].set_xlabel("angle, turns")
