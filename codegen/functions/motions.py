"""Motions: compiled, sampled, measured, and made of keys."""

from __future__ import annotations

from api import (
    COMPILED,
    COUNT,
    FLAGS,
    OPERANDS,
    WHERE,
    Function,
    Group,
    Parameter,
    array,
    array_of,
    arrays,
    given,
    made,
    made_array_of,
    motors_side_by_side,
    number,
    out,
    packed,
    scalar,
    size,
    strided,
    struct,
)
from functions.apply import elements, kernels


def index(name: str = "index"):
    """Which of the compiled motions: in C++ the first, unless it is said."""
    return Parameter(name, "index", "size_t {name}", default="0")


MOTION = struct("motion", "motion")

SIZE = Group(
    """\
*size = how many bytes the compiled motion takes: about 8 numbers per control and (degree + 1)² per knot. This
looks at everything that mw_compile_motion looks at but the controls, and has its errors.""",
    (
        Function(
            "motion_size",
            (Parameter("size", "output size", "size_t *{name}", cpp="size_t &{name}", argument="&size"), MOTION, WHERE),
        ),
    ),
    "motion/compile",
    (
        "NULL", "MOTION_KIND", "DEGREE", "CONTROL_COUNT", "KNOT_COUNT", "KNOTS (where: the knot)",
        "WEIGHTS (where: the control; or the kind is not additive)", "SIZE",
    ),
)

COMPILE = Group(
    """\
Checks a motion and makes *compiled, which is `memory`. Flags: MW_KEEP_SIGNS (not of multiplicative motions, whose
slerp always goes the shortest way). On an error memory is not touched, and *where (unless that pointer is null) is
the index of what is wrong, else 0.
Time: linear in controls and knots, times degree²; logarithms of the controls where the kind takes them.""",
    (
        Function(
            "compile_motion",
            (
                Parameter("compiled", "output compiled motion", "const mw_compiled_motion_{P} **{name}",
                          cpp="const compiled_motion<{T}> *&{name}", argument="&compiled"),
                number("memory", "void *", "memory"), size("size", "bytes of memory"), MOTION, FLAGS, WHERE,
            ),
        ),
    ),
    "motion/compile",
    (
        "NULL", "FLAGS", "MOTION_KIND", "DEGREE", "CONTROL_COUNT", "KNOT_COUNT", "KNOTS (where: the knot)",
        "WEIGHTS (where: the control; or the kind is not additive)",
        "DEGENERATE_MOTOR (where: the control, counted through all motions; or the base)",
        "VANISHING (where: the first of the degree + 1 controls that cancel; only with weights or MW_KEEP_SIGNS, or "
        "where rotations are more than a half turn apart within a span)",
        "SIZE", "MEMORY", "OVERLAP",
    ),
)

DOMAIN = Group(
    """\
domain[0] and domain[1] = the first and the last parameter.""",
    (Function("motion_domain", (made_array_of("domain", 2), COMPILED)),),
    "motion/compile",
    ("NULL", "MOTION"),
)

SAMPLE_ERRORS = (
    "NULL", "STRIDE", "SIZE", "OVERLAP (with the parameters or the motion)", "FLAGS", "MOTION", "MOTION_INDEX",
    "PARAMETER (outside the domain, unless a flag says what to do, or not finite)",
)


def samples(verb: str, *outputs):
    ways = {
        "one": ("of one motion, at every parameter", (packed("parameters"),)),
        "each": ("of one motion after the other", strided("parameters")),
    }
    return tuple(
        Function(
            f"{verb}_{way}", (*outputs, COMPILED, index(), *parameters, COUNT, FLAGS), text, through=verb,
            first=f"motions_sampled::{way}", after_flags=("index",),
        )
        for way, (text, parameters) in ways.items()
    )


SAMPLE = Group(
    """\
Samples. `one`: out[i] is motion number `index` (0, if there is only one) at parameters[i]. `each`: out[i] is motion
number index + i at a parameter of its own, parameter_stride bytes after that before it; stride 0 is one parameter
for all. At a knot inside the domain a motion is taken from the right.
Runs of parameters between the same two knots are fastest: sorted ones are.
Flags: MW_CLAMP_PARAMETERS, MW_WRAP_PARAMETERS.
Operations per sample (fused multiply-adds and what costs as much), of degree d: 2 d² for the weights, and 8 (d + 1)
additive, ½ d (d + 1) slerps multiplicative, d exponentials and products cumulative, one of each for generators.""",
    samples("sample_motion", out("motors")),
    "motion/sample",
    SAMPLE_ERRORS,
)

SAMPLE_TWIST = Group(
    """\
Samples and velocities. The twist Ω at a parameter is the bivector S^-1 S' of the normalised motion: a moment h
later the pose is S exp(hΩ). It generates motions as logarithms do, so it holds halves: the angular velocity is
2 (b23, -b13, b12), and the velocity of what is at the origin just then is 2 (b1i, b2i, b3i). With MW_BODY_FRAME it
is S' S^-1, in the coordinates of the body. Both are per unit of the parameter, and exact: the same formulas are
evaluated over numbers that carry their derivatives. At a knot where the motion is not smooth: that of the right.
The flags and parameters of mw_sample_motion_*, and MW_BODY_FRAME. `out` and `twists` share no byte.""",
    samples("sample_motion_twist", out("motors"), out("bivectors", "twists")),
    "motion/sample",
    SAMPLE_ERRORS,
)

APPLY_MOTION = Group(
    """\
A motion straight onto elements: row m of out is `in` under the motion at parameters[m], as mw_apply_<operand>_grid
does it of motors. The poses are made some at a time and never leave the first cache.
Flags: those of apply and of mw_sample_motion_one.""",
    tuple(
        Function(
            f"apply_{operand}_motion",
            (
                elements(out(views)), size("row_stride", "stride"), COMPILED, index(), array("parameters"),
                size("parameter_count"), elements(given(views, "in")), COUNT, FLAGS,
            ),
            through="apply_motion", first=kernels(operand, "one", "grid"), after_flags=("index",),
        )
        for operand, views in OPERANDS.items()
    ),
    "apply",
    SAMPLE_ERRORS,
)

TWIST_VELOCITY = Group(
    """\
The velocity of the point of the body that is at `place`, under a twist of the space.""",
    (Function("twist_velocity", (made_array_of("velocity"), array_of("twist", 6), array_of("place"))),),
    "motion/lengths",
    ("NULL",),
)

LENGTHS = Group(
    """\
lengths[i] = the length of the way of a point of the body, from the start of the domain to parameters[i], which must
not decrease (MW_ERROR_PARAMETER). Integrated from the twists, to a few epsilons of the whole length and of the
coordinates. `lengths` may be `parameters`.""",
    (
        Function(
            "motion_lengths",
            (
                Parameter("lengths", "output numbers", "{T} *{name}"), COMPILED, index(), array_of("point"),
                array("parameters"), COUNT,
            ),
        ),
    ),
    "motion/lengths",
    ("NULL", "SIZE", "OVERLAP", "MOTION", "MOTION_INDEX", "PARAMETER"),
)

EVEN_PARAMETERS = Group(
    """\
parameters[i] = where a point of the body has gone the part i / (count - 1) of its whole way: samples there are
equally far apart along it. The first and the last are the ends of the domain; one alone is its start. If the point
never moves, by more than rounding, or is not finite, the parameters are equally far apart instead.""",
    (
        Function(
            "motion_even_parameters",
            (Parameter("parameters", "output numbers", "{T} *{name}"), COMPILED, index(), array_of("point"), COUNT),
        ),
    ),
    "motion/lengths",
    ("NULL", "SIZE", "OVERLAP", "MOTION", "MOTION_INDEX"),
)

FIRST, SECOND = (
    Parameter(name, "compiled motion", "const mw_compiled_motion_{P} *{name}", cpp="const compiled_motion<{T}> *{name}")
    for name in ("first", "second")
)
COMPARE = Group(
    """\
Time: count * sample_count.""",
    (
        Function(
            "compare_motions",
            (
                made("motion_distance", "largest"), FIRST, index("first_index"), SECOND, index("second_index"),
                given("xyz", "points"), COUNT, size("sample_count"),
            ),
        ),
    ),
    "motion/compare",
    ("NULL", "STRIDE", "SIZE", "MOTION", "MOTION_INDEX"),
)

# --------------------------------------------------------------------------------------------------- making and editing

ARRAYS = arrays("arrays")

INTERPOLATE = Group(
    """\
Controls of a motion that passes through `count` keys at times that increase: additive or cumulative, of a degree
below the number of keys. As many controls as keys; knots are means of the times of `degree` neighbours (de Boor),
so that the equations have one solution. Additive: they are solved in one go. Cumulative: by Newton's method, in a
few rounds. Keys are taken with the signs of the shortest way. COMPILE THE RESULT WITH MW_KEEP_SIGNS: neighbouring
controls may be more than a half turn apart even where keys are not.
`memory`: *size bytes of working memory, aligned to 8; null to be told by *size how many, which reads nothing but
kind, degree and count. Arrays may be `keys` and `times` themselves.
Time: count * degree², ten times that per round if cumulative.""",
    (
        Function(
            "interpolate_keys",
            (
                made("motion"), ARRAYS, number("kind", "mw_motion_kind", "kind of motion"),
                number("degree", "unsigned", "degree"), motors_side_by_side("keys", "{name}"), array("times"), COUNT,
                number("memory", "void *", "memory"),
                Parameter("size", "bytes of memory", "size_t *{name}", cpp="size_t &{name}", argument="&size"), WHERE,
            ),
        ),
    ),
    "motion/interpolate",
    (
        "NULL", "MOTION_KIND", "DEGREE", "CONTROL_COUNT", "KNOTS (where: the time)",
        "DEGENERATE_MOTOR (where: the key)",
        "MEMORY (also arrays that are too small)", "SIZE", "OVERLAP",
        "CONVERGENCE (no controls, or none less than a full turn apart from their neighbours: cumulative motions "
        "through keys that turn far between each other, at uneven times, need such ones. Add keys)",
    ),
)

EDIT = Group(
    """\
The same additive motion written with more controls: with a knot inserted `times` times, of one degree more, or in
two parts, before and after a parameter. Weights are multiplied into the controls of the result, which has none. Of
open additive motions with one set of controls: MW_ERROR_MOTION_KIND of others.
Signs are kept as they are: compile the result with MW_KEEP_SIGNS. The arrays share no byte with the motion. If they
are too small, such as {0}, *out says by control_count and knot_count what it takes.""",
    (
        Function(
            "insert_knot",
            (made("motion"), ARRAYS, MOTION, scalar("knot"), number("times", "unsigned", "how often", "1")),
        ),
        Function("elevate_degree", (made("motion"), ARRAYS, MOTION)),
        Function(
            "split_motion",
            (
                made("motion", "before"), arrays("before_arrays"), made("motion", "after"),
                arrays("after_arrays"), MOTION, scalar("at"),
            ),
        ),
    ),
    "motion/edit",
    SIZE.errors + (
        "PARAMETER (the knot is not strictly inside the domain)",
        "KNOTS (it would be repeated more than degree + 1 times, or is less than a normal number from another)",
        "DEGREE (beyond MW_MAX_DEGREE)", "OVERLAP", "MEMORY (the arrays are too small)",
    ),
)
