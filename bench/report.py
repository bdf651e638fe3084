#!/usr/bin/env python3
"""What a run of motorway_bench has found.

    report.py RESULTS.json                  every row as a percentage of its limit, on the terminal
    report.py RESULTS.json --output DIR     a page (index.md) and SVG charts; needs matplotlib

RESULTS.json is written by motorway_bench --benchmark_out=RESULTS.json.
"""

import argparse
import os
import sys

from reporting.page import page, terminal
from reporting.results import Results, ResultsError, load

CHART_COUNT = 1024


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS.json")
    parser.add_argument("--output", metavar="DIR", help="the folder of the page; it is made if need be")
    parser.add_argument("--command", default="tools/bench", help="what the page says the run was started with")
    arguments = parser.parse_args()
    try:
        results = load(arguments.results)
        if arguments.output:
            write_page(results, arguments.output, arguments.command)
        else:
            print(terminal(results))
    except (OSError, ResultsError) as error:
        print(f"report.py: {error}", file=sys.stderr)
        return 2
    return 0


def write_page(results: Results, directory: str, command: str) -> None:
    try:
        from reporting import charts  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise ResultsError("the charts need matplotlib, which is not installed (Debian: apt-get install "
                           f"python3-matplotlib): {error}") from error
    os.makedirs(directory, exist_ok=True)
    drawn = {}
    for kernel in results.kernels():
        if kernel.endswith("-unit"):
            continue
        names = [charts.throughput(results, kernel, directory)]
        names += [charts.against_baselines(results, kernel, precision, CHART_COUNT, directory)
                  for precision in ("f32", "f64", "mixed")]
        drawn[kernel] = [name for name in names if name]
    with open(os.path.join(directory, "index.md"), "w", encoding="utf-8") as file:
        file.write(page(results, drawn, command))


if __name__ == "__main__":
    sys.exit(main())
