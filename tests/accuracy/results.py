"""The results of motorway_accuracy: one JSON object a line, of some kind each."""

import json
from dataclasses import dataclass
from typing import Dict, List

PRECISIONS = ("f32", "f64")
PARTS = ("rotation", "translation")
CLASSES = ("fused", "unfused")


@dataclass(frozen=True)
class Figure:
    """What was found of one part of the results of a function, in one precision and class of instruction sets."""
    section: str
    function: str
    inputs: str
    part: str
    relative_to: str
    asked: float
    precision: str
    isa_class: str
    count: int
    worst: float
    median: float
    disagreement: float


@dataclass
class Results:
    figures: List[Figure]
    curves: List[Dict]
    drifts: List[Dict]
    truth: Dict
    isas: Dict[str, str]  # by class

    def classes(self) -> List[str]:
        return [name for name in CLASSES if name in self.isas]


def load(path: str) -> Results:
    with open(path, encoding="utf-8") as file:
        lines = [json.loads(line) for line in file]
    of_kind = {kind: [line for line in lines if line["kind"] == kind]
               for kind in ("case", "curve", "drift", "truth", "class")}
    if not all(of_kind.values()):
        raise ValueError(f"{path} is not complete")
    figures = [Figure(line["section"], line["function"], line["inputs"], line["part"], line["relative_to"],
                      line["asked"], line["precision"], line["class"], int(line["count"]), line["worst"],
                      line["median"], line["disagreement"]) for line in of_kind["case"]]
    return Results(figures, of_kind["curve"], of_kind["drift"], of_kind["truth"][0],
                   {line["class"]: line["isas"] for line in of_kind["class"]})
