"""The results of a run: rows by what they measure, and the limits of the machine that belong to a row."""

import bisect
import json
import math
import re
from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

KERNEL = re.compile(r"(?P<kernel>[a-z][a-z0-9_]*(?:-unit)?)/(?P<layout>aos\d*|aos-columns|soa)/"
                    r"(?P<precision>f\d+|mixed)/(?P<isa>[a-z0-9]+)/(?P<count>\d+)"
                    r"(?:/real_time/threads:(?P<threads>\d+))?$")
BASELINE = re.compile(r"baseline_(?P<rival>[^/]+)/(?P<kernel>[^/]+)/(?P<layout>[^/]+)/(?P<precision>[^/]+)/"
                      r"(?P<count>\d+)$")
MEMORY_LIMIT = re.compile(r"limit_(?P<kind>copy|fill|read)/[^/]+/(?P<bytes>\d+)$")
FMA_LIMIT = re.compile(r"limit_fma/(?P<precision>[^/]+)/(?P<isa>[^/]+)$")


class ResultsError(Exception):
    """A file that holds no results of motorway_bench."""


@dataclass(frozen=True)
class Row:
    """A kernel on an instruction set (rival is None) or a baseline (isa is None): medians."""
    name: str
    kernel: str
    layout: str
    precision: str
    count: int
    isa: Optional[str]
    rival: Optional[str]
    threads: int
    items_per_second: float
    bytes_per_second: float
    results: float  # of one thread: as many as the count, or of a grid for every motor
    bytes_read: float
    bytes_written: float
    span_read: float
    span_written: float
    operations: float

    @property
    def footprint(self) -> float:
        return self.span_read + self.span_written

    @property
    def seconds(self) -> float:
        """For all results of all threads once."""
        return self.results * self.threads / self.items_per_second

    @property
    def is_plain(self) -> bool:
        """A plain loop."""
        return bool(self.rival) and self.rival.startswith("plain-")

    @property
    def is_own(self) -> bool:
        """The library itself, in another way."""
        return self.rival in ("two-passes", "six-slerps", "poses")


class MemoryLimit:
    """Bytes a second at any footprint: the best method at the sizes measured, between them by their logarithms."""

    def __init__(self) -> None:
        self._best: Dict[int, float] = {}

    def add(self, size: int, rate: float) -> None:
        self._best[size] = max(rate, self._best.get(size, 0.0))

    def at(self, size: float) -> Optional[float]:
        sizes = sorted(self._best)
        if not sizes:
            return None
        above = bisect.bisect_left(sizes, size)
        if above == len(sizes) or above == 0 or sizes[above] == size:
            return self._best[sizes[min(above, len(sizes) - 1)]]
        low, high = sizes[above - 1], sizes[above]
        part = math.log(size / low) / math.log(high / low)
        return math.exp((1 - part) * math.log(self._best[low]) + part * math.log(self._best[high]))


class Results:
    """Everything that one run has measured."""

    def __init__(self, document: dict) -> None:
        self.context: dict = document["context"]
        self.rows: List[Row] = []
        self.memory = {kind: MemoryLimit() for kind in ("copy", "fill", "read")}
        self.fma: Dict[Tuple[str, str], float] = {}
        for entry in _medians(document["benchmarks"]):
            self._add(entry)

    def _add(self, entry: dict) -> None:
        name = entry["run_name"]
        memory, fma = MEMORY_LIMIT.match(name), FMA_LIMIT.match(name)
        if memory:
            self.memory[memory["kind"]].add(int(memory["bytes"]), entry["bytes_per_second"])
        elif fma:
            self.fma[fma["precision"], fma["isa"]] = entry["items_per_second"]
        else:
            match = KERNEL.match(name) or BASELINE.match(name)
            if match:
                self.rows.append(_row(name, match.groupdict(), entry))

    @property
    def isas(self) -> List[str]:
        """Best first."""
        return self.context["isas"].split(", ")

    def cache_sizes(self) -> List[Tuple[str, int]]:
        """("L1", bytes) and so on, as one core sees them."""
        return [(f"L{cache['level']}", cache["size"]) for cache in self.context["caches"]
                if cache["type"] in ("Data", "Unified")]

    def find(self, kernel: str, layout: str, precision: str, count: int, isa: Optional[str] = None,
             rival: Optional[str] = None, threads: int = 1) -> Optional[Row]:
        wanted = (kernel, layout, precision, count, isa, rival, threads)
        return self._index().get(wanted)

    def _index(self) -> Dict[tuple, Row]:
        if not hasattr(self, "_rows_by_key"):
            self._rows_by_key = {(row.kernel, row.layout, row.precision, row.count, row.isa, row.rival,
                                  row.threads): row for row in self.rows}
        return self._rows_by_key

    def baselines(self, kernel: str, layout: str, precision: str, count: int) -> List[Row]:
        """Those of a variant for normalised motors are those of the kernel itself."""
        kernel = kernel.replace("-unit", "")
        return [row for row in self.rows if row.rival and (row.kernel, row.layout, row.precision, row.count) ==
                (kernel, layout, precision, count)]

    # ------------------------------------------------------------------------------------------------- limits

    def fma_seconds(self, row: Row) -> Optional[float]:
        """What the operations of the kernel would take at best: of a baseline, on the best instruction set."""
        precision = "f64" if row.precision == "mixed" else row.precision
        rate = self.fma.get((precision, row.isa or self.isas[0]))
        return row.operations / rate if rate else None

    def memory_seconds(self, row: Row) -> Optional[float]:
        """What moving the data would take at best: what is both read and written as a copy, the rest as a read or a
        fill. Beyond the first cache, memory moves in lines, so that there the gaps of a strided array move, too."""
        first_cache = self.cache_sizes()[0][1] if self.cache_sizes() else 0
        in_first = row.footprint <= first_cache
        read, written = ((row.bytes_read, row.bytes_written) if in_first else (row.span_read, row.span_written))
        both = min(read, written)
        rates = {kind: limit.at(row.footprint) for kind, limit in self.memory.items()}
        if None in rates.values():
            return None
        return 2 * both / rates["copy"] + (read - both) / rates["read"] + (written - both) / rates["fill"]

    def copy_seconds(self, row: Row) -> Optional[float]:
        """What copying as many bytes as the arrays span would take."""
        rate = self.memory["copy"].at(row.footprint)
        return row.footprint / rate if rate else None

    def limit_seconds(self, row: Row) -> Optional[Tuple[float, str]]:
        """The limit that binds one thread, and which it is."""
        fma, memory = self.fma_seconds(row), self.memory_seconds(row)
        return max((fma, "fma"), (memory, "memory")) if fma and memory else None

    def part_of_limit(self, row: Row) -> Optional[Tuple[float, str]]:
        """How much of it is reached: of two threads, of twice the limit."""
        limit = self.limit_seconds(row)
        return (limit[0] / row.seconds, limit[1]) if limit else None

    def kernels(self) -> List[str]:
        """In the order of the run; those with -unit are the variants for normalised motors."""
        return list(dict.fromkeys(row.kernel for row in self.rows if row.isa))


def _medians(entries: List[dict]) -> List[dict]:
    """One entry a benchmark: its median, or its only run."""
    chosen: Dict[str, dict] = {}
    for entry in entries:
        is_median = entry.get("aggregate_name") == "median"
        if is_median or (entry["run_type"] == "iteration" and entry["run_name"] not in chosen):
            if not entry.get("error_occurred"):
                chosen[entry["run_name"]] = entry
    return list(chosen.values())


def _row(name: str, parts: dict, entry: dict) -> Row:
    counters = ("items_per_second", "bytes_per_second", "results", "bytes_read", "bytes_written", "span_read",
                "span_written", "operations")
    return Row(name=name, kernel=parts["kernel"], layout=parts["layout"], precision=parts["precision"],
               count=int(parts["count"]), isa=parts.get("isa"), rival=parts.get("rival"),
               threads=int(parts.get("threads") or 1), **{counter: entry[counter] for counter in counters})


def load(path: str) -> Results:
    """Reads a file that --benchmark_out has written."""
    try:
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
        results = Results(document)
        results.context["isas"]  # pylint: disable=pointless-statement
    except (ValueError, KeyError, TypeError) as error:
        raise ResultsError(f"{path} holds no results of motorway_bench ({error})") from error
    return results
