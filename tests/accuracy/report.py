#!/usr/bin/env python3
"""What a run of motorway_accuracy has found.

    report.py RESULTS                         tables, on the terminal
    report.py RESULTS --images DIR            and charts, accuracy-<function>.svg; needs matplotlib
    report.py RESULTS --document ACCURACY.md  and writes the tables into that page, between the comments
                                              <!-- begin NAME --> and <!-- end NAME -->
"""

import argparse
import os
import re
import sys

from results import load
import tables


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS")
    parser.add_argument("--images", metavar="DIR")
    parser.add_argument("--document", metavar="ACCURACY.md")
    arguments = parser.parse_args()
    try:
        results = load(arguments.results)
        parts = tables.parts(results)
        print("\n\n".join(parts.values()))
        if arguments.images:
            import charts  # pylint: disable=import-outside-toplevel
            os.makedirs(arguments.images, exist_ok=True)
            charts.draw(results, arguments.images)
        if arguments.document:
            write_into(arguments.document, parts)
    except (OSError, ValueError, ImportError) as error:
        print(f"report.py: {error}", file=sys.stderr)
        return 2
    return 0


def write_into(path: str, parts) -> None:
    """Each part takes the place of what was between its two comments."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for name, part in parts.items():
        between = re.compile(f"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
        text, found = between.subn(lambda match, part=part: f"{match[1]}\n{part}\n\n{match[2]}", text)
        if found != 1:
            raise ValueError(f"{path} has {found} places for the part {name}, not one")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    sys.exit(main())
