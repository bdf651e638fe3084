"""Motors applied to points, directions, vertices, lines and whatever else they move."""

from __future__ import annotations

from dataclasses import replace
from typing import Tuple

from api import (
    COUNT,
    FIRST_BAD,
    FLAGS,
    MIXED,
    OPERANDS,
    WITHOUT,
    Function,
    Group,
    Parameter,
    given,
    motor,
    motors_of_calls,
    motors_side_by_side,
    out,
    size,
)

# What the pairings do, for the operand `of`.
PAIRINGS = {
    "one": "all {of} under one motor",
    "each": "each {a} under a motor of its own",
    "grid": "all {of} under every motor",
    "indexed": "each {a} under the motor of a palette that its index names",
    "indexed_checked": "the same after a look at all indices",
}
PLURALS = {"vertex": "vertices"}

INDICES = Parameter(
    "indices", "input indices", "const mw_indices *{name}", "indices_of({name})", cpp="mw_indices {name}",
    argument="&indices", is_view=True, plain=("const void *{name}", "size_t index_stride", "mw_index_type index_type"),
    plain_inner="mw_indices{{{name}, index_stride, index_type}}",
)
NO_SHIFT = Parameter("shift", "", "", "no_shift()")
SHIFT = Parameter("shift", "shift", "const mw_shift *{name}", "some_shift({name})", cpp="const mw_shift &{name}",
                  argument="&shift", default="{{}}")


def elements(parameter: Parameter) -> Parameter:
    plain = f"elements_of({parameter.plain_inner})"
    return replace(parameter, inner=f"elements_of({parameter.name})", plain_inner=plain)


def kernels(operand: str, *names: str, mixed: bool = False) -> str:
    enumeration = "mixed_kernel_id" if mixed else "kernel_id"
    return ", ".join(f"{enumeration}::apply_{operand}_{name}" for name in names)


def apply_functions(operand: str, views: str, shift: Parameter, of: str, **more) -> Tuple[Function, ...]:
    """Of one operand, every pairing. A mixed kernel has no variant for normalised motors."""
    mixed = bool(shift.c)
    to, from_ = elements(out(views)), elements(given(views, of))
    palette = (motors_side_by_side("palette"), size("palette_count"), INDICES, shift, from_, COUNT, FLAGS)
    motors, motor_count = motors_of_calls(), size("motor_count")
    shapes = {
        "one": ((to, motor("motor"), shift, from_, COUNT, FLAGS), ("one",)),
        "each": ((to, motors, shift, from_, COUNT, FLAGS), ("each", "each" if mixed else "each_unit")),
        "grid": ((to, size("row_stride"), motors, motor_count, shift, from_, COUNT, FLAGS), ("one", "grid")),
        "indexed": ((to, *palette), ("indexed", "indexed" if mixed else "indexed_unit")),
        "indexed_checked": (
            (to, *palette, FIRST_BAD), ("indexed", "indexed" if mixed else "indexed_unit"),
        ),
    }
    plural = PLURALS.get(operand, operand + "s")
    return tuple(
        Function(
            f"apply_{operand}_{pairing}", parameters, PAIRINGS[pairing].format(of=plural, a=operand),
            through=f"apply_{pairing}", first=kernels(operand, *names, mixed=mixed), **more,
        )
        for pairing, (parameters, names) in shapes.items()
    )


APPLY = Group(
    """\
mw_apply_<operand>_<pairing>_<precision>: every operand in every pairing.

    operand     numbers       what becomes of an element under the motor S (the paper's section 3)
    point       x y z         F_S(p): rotated and translated
    direction   x y z         rotated: normals, velocities
    tangent     x y z w       x y z rotated, w passed through, as glTF and engines store tangents
    vertex      2 of x y z    a point and a direction in one pass: the position and the normal
    vector      e0 ... e3 ei  moved as a whole: of a point, a sphere or a plane the same of its image
    line        d, then m     Plücker: the direction, and the moment p × d of any point p on it. The line through the
                              images of its points; its length is kept
    motor       mw_motor      T^-1 M T of the motor M under T: the same motion about the moved place
    bivector    b12 ... b3i   S^-1 B S: the logarithm of a motor, or a twist, moved likewise (the adjoint action).
                              In Plücker coordinates, as a twist (ω, velocity of the origin) or a wrench (force,
                              torque about the origin), it is a line

    pairing     out[i] is element i ...
    one         under `motor`, the same for all
    each        under motors[i]
    indexed     under palette[indices[i]]: rigid parts, instances
    grid        under motors[m], for every m: out holds motor_count rows of count elements, and row m begins
                m * row_stride bytes after row 0. Rows one after the other (motor-major) have row_stride >= count *
                out_stride; elements one after the other (point-major), each with its motor_count images side by
                side, have out_stride >= motor_count * row_stride. One of the two must hold.

Motors need not be normalised, in any of them. Flags: MW_UNIT_MOTORS, MW_STREAMING_STORES, MW_NO_STREAMING_STORES.

A degenerate motor is an error of `one`. The others do not look for one: it makes results that are not finite or
meaningless, of its own elements alone (mw_check_motors finds it). A grid is never in place: the range of its output,
gaps included, meets no input; and its rows may not run into each other (MW_ERROR_STRIDE).

Indices are not looked at either: one past the palette reads outside of it. Call mw_check_indices once per mesh, or
mw_apply_<operand>_indexed_checked, which looks at all of them first and writes nothing if one is out of range:
MW_ERROR_INDEX, and *first_bad (unless that pointer is null) is the number of the first such element.

Cost: `one` and `grid` expand a motor into a matrix once, and then take 9 fused multiply-adds per point; the others
take 25 and a division per point, 21 with MW_UNIT_MOTORS. generated/kernel_list.inc has the counts of all.""",
    tuple(
        function
        for operand, views in OPERANDS.items()
        for function in apply_functions(operand, views, NO_SHIFT, "in")
    ),
    "apply",
    (
        "NULL", "STRIDE", "SIZE", "OVERLAP", "FLAGS", "DEGENERATE_MOTOR (one)", "INDEX (indexed_checked)",
        "INDEX_TYPE (indexed, indexed_checked)",
    ),
)

MIXED_POINTS = Group(
    """\
Large worlds: motors of double on points of float. out[i] = F_S(points[i] - before) + after, all of it computed in
double and rounded once. So points may be stored near an origin of their own, and come out near another, such as
the camera: before = -(the origin of the points), after = -(the camera). `shift` null: both are zero.
Pairings, flags and errors as above. (Directions need no double: round the motor, and use the f32 functions.)""",
    apply_functions("point", "xyz", SHIFT, "points", precisions=MIXED),
    "apply",
    APPLY.errors,
)

CHECK_INDICES = Group(
    """\
One pass over the indices: MW_ERROR_INDEX if one is not below palette_count, and then *first_bad (unless that
pointer is null) is the number of the first such element.""",
    (
        Function(
            "check_indices", (INDICES, COUNT, size("palette_count"), FIRST_BAD), precisions=WITHOUT,
            through="check_indices",
        ),
    ),
    "apply",
    ("NULL", "STRIDE", "SIZE", "INDEX", "INDEX_TYPE"),
)
