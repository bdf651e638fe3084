"""The library itself: its version, what a status means, and which instruction sets there are."""

from __future__ import annotations

from api import WITHOUT, Function, Group, number


def text(name: str, *parameters) -> Function:
    return Function(name, parameters, precisions=WITHOUT, returns="const char *")


VERSION = Group(
    """\
The version of the library that is linked, as 10000 * major + 100 * minor + patch. MW_VERSION is that of the header.""",
    (Function("version", (), precisions=WITHOUT, returns="unsigned"),),
    "status",
)

STATUS_TEXT = Group(
    """\
What a status means and what to do about it: one line of English without a line end, never null, valid forever.
For MW_ERROR_ISA it names the instruction sets that can run here.""",
    (text("status_text", number("of", "mw_status", "status")),),
    "status",
)

ISA = Group(
    """\
The name of the instruction set in use, "avx2" say; null if MOTORWAY_ISA asked for one that cannot run here.""",
    (text("isa"),),
    "status",
)

ISAS = Group(
    """\
The names of all instruction sets that are compiled in and that this CPU runs, best first, separated by ", ".""",
    (text("isas"),),
    "status",
)
