"""Motors made, combined, interpolated and blended."""

from __future__ import annotations

from api import (
    COUNT,
    FIRST_BAD,
    FLAGS,
    Function,
    Group,
    Parameter,
    array_of,
    given,
    made,
    made_array_of,
    motor,
    motors_side_by_side,
    out,
    scalar,
    size,
    streams,
    strided,
    struct,
    struct_of_views,
    with_shared_motors,
)

VIEWS = ("NULL", "STRIDE", "SIZE", "OVERLAP")
DEGENERATE = "Degenerate motors: see mw_check_motors."

TRANSLATION = Group(
    """\
The translation by `offset`: 1 + ½ t e∞ (the paper's lemma 3.10).""",
    (Function("translation", (made("motor"), array_of("offset"))),),
    "single_motors",
    ("NULL",),
)

ROTATION = Group(
    """\
The rotation by `angle` about the axis through `point` (null: the origin) along `axis`, of any length but zero:
cos θ/2 + sin θ/2 (b + (b∧q) e∞) with b = a e123 (lemma 3.11). Computed in double, rounded once.""",
    (
        Function(
            "rotation", (made("motor"), array_of("axis"), scalar("angle"), array_of("point", default="{{0, 0, 0}}")),
        ),
    ),
    "single_motors",
    ("NULL", "AXIS (the axis has length zero, or a number is not finite)"),
)

CHECK_MOTORS = Group(
    """\
One pass over the motors: MW_ERROR_DEGENERATE_MOTOR if one is degenerate, and then *first_bad (unless that
pointer is null) is the index of the first. The batched functions below do not make this pass: they turn a
degenerate motor into results that are not finite or meaningless, in that element alone.""",
    (Function("check_motors", (given("motors", "motors"), COUNT, FIRST_BAD)),),
    "single_motors",
    ("NULL", "STRIDE", "SIZE", "DEGENERATE_MOTOR"),
)

COMPOSE = Group(
    """\
out[i] = first[i] then[i], the geometric product: the motor that does `first` and then `then` (F_UV = F_V F_U,
lemma 3.5).""",
    (streams("compose_motor_each", out("motors"), given("motors", "first"), given("motors", "then"), COUNT),),
    "motors",
    VIEWS,
)

COMPOSE_ONE = Group(
    """\
The same where one factor is the same for all: out[i] = first then[i], and out[i] = first[i] then.""",
    (
        with_shared_motors(
            streams("compose_motor_one_first", out("motors"), motor("first"), given("motors", "then"), COUNT)
        ),
        with_shared_motors(
            streams("compose_motor_one_then", out("motors"), given("motors", "first"), motor("then"), COUNT)
        ),
    ),
    "motors",
    VIEWS,
)

HIERARCHY = Group(
    """\
Poses along a hierarchy, of many instances at once: out[j][i] = locals[j][i] out[parents[j]][i], the motor that moves
from the space of joint j to that of its root, for joints j < joint_count in order and instances i < count.
parents[j] < j, or negative for a root, of which out[j][i] = locals[j][i]. The motors of joint j begin
j * joint_stride bytes after those of joint 0, of locals and of out alike: instances side by side
(joint_stride >= count * out_stride) are a lane each, which is the fast way; skeletons one after the other have
out_stride >= joint_count * joint_stride. Joints may not run into each other (MW_ERROR_STRIDE).
In place if locals is out; or if a motor of each, such as two fields of a joint, lies within the smaller of the two
strides. On MW_ERROR_PARENT *first_bad (unless that pointer is null) is the joint.""",
    (
        Function(
            "compose_motor_hierarchy",
            (
                out("motors"), given("motors", "locals"), size("joint_stride", "stride"),
                Parameter("parents", "input parents", "const int32_t *{name}"), size("joint_count"), COUNT, FIRST_BAD,
            ),
        ),
    ),
    "motors",
    VIEWS + ("PARENT (parents[j] >= j)",),
)

REVERSE = Group(
    """\
out[i] = the reverse of motors[i]: the opposite motion, and for a normalised motor its inverse.""",
    (streams("reverse_motor_each", out("motors"), given("motors", "motors"), COUNT),),
    "motors",
    VIEWS,
)

NORMALIZE = Group(
    """\
out[i] = the motor of the same motion with S̄S = 1: motors[i] divided by the square root of the pseudoscalar
S̄S = α + βω (lemma 3.4, corollary 3.7), so that the translation is right as well. The sign of s is kept.""",
    (streams("normalize_motor_each", out("motors"), given("motors", "motors"), COUNT),),
    "motors",
    VIEWS,
    DEGENERATE,
)

INVERSE = Group(
    """\
out[i] = motors[i]^-1 = S̄ / (S̄S), the opposite motion, of motors that need not be normalised (lemma 3.4).""",
    (streams("inverse_motor_each", out("motors"), given("motors", "motors"), COUNT),),
    "motors",
    VIEWS,
    DEGENERATE,
)

RATIO = Group(
    """\
out[i] = from[i]^-1 to[i], the relative motor: what is to be done after from[i] to come to to[i], so that composing
from[i] and then out[i] gives to[i]. The left factor acts first: as matrices, which act on columns, out is T1 T0^-1,
with T0 that of `from` and T1 that of `to`. T0^-1 T1, the pose of `to` as seen from `from`, is another one:
mw_inverse_motor_each of `from`, and then mw_compose_motor_each of `to` and that.
With MW_UNIT_MOTORS from[i] must be normalised.""",
    (
        streams(
            "ratio_motor_each", out("motors"), given("motors", "from"), given("motors", "to"), COUNT, FLAGS,
            flag="MW_UNIT_MOTORS", flagged="ratio_motor_each_unit",
        ),
    ),
    "motors",
    VIEWS + ("FLAGS",),
    DEGENERATE,
)

# ------------------------------------------------------------------------------------------------------- exponentials

EXP = Group(
    """\
out[i] = exp(generators[i]), normalised for every finite angle: |α - 1| is at most 4 epsilons.
About a coordinate axis the result is that of libm's sine and cosine to a few epsilons, up to the largest finite
angle. About other axes the angle is also rounded, by less than its last bit.
Large angles cost more: a register that holds |b| above 8192 (2^27 in double; above 4 where the instruction set does
not fuse) takes some 50 ns for each lane that does.""",
    (streams("exp_motor_each", out("motors"), given("bivectors", "generators"), COUNT),),
    "motors",
    VIEWS,
)

LOG = Group(
    """\
out[i] = the logarithm of motors[i] or of -motors[i], which move alike, whichever turns by no more than a half turn:
exp(out[i]) is the motor with s >= 0. Translations are exact.
Motors need not be normalised; with MW_UNIT_MOTORS they must be, which saves two thirds of the time.

log_principal is the same for the motor itself: exp(out[i]) = motors[i], which turns by less than a full turn. Near
s = -1 (a full turn) the axis is lost to rounding and the moment grows as 1/sin; where |b| <= 2^-40, as at -1 itself,
there is none, and the result is that of mw_log_motor_each.""",
    tuple(
        streams(
            f"{verb}_motor_each", out("bivectors"), given("motors", "motors"), COUNT, FLAGS,
            flag="MW_UNIT_MOTORS", flagged=f"{verb}_motor_each_unit",
        )
        for verb in ("log", "log_principal")
    ),
    "motors",
    VIEWS + ("FLAGS",),
    DEGENERATE,
)

SQRT = Group(
    """\
out[i] = the normalised motor that does half of what motors[i], which must be normalised, does the short way.""",
    (streams("sqrt_motor_each", out("motors"), given("motors", "motors"), COUNT),),
    "motors",
    VIEWS,
)

POWER = Group(
    """\
out[i] = exp(t log S), the power t = exponents[i] of S = motors[i], which must be normalised, by its shortest
logarithm: for every t for which t times that is finite. exponents[i] is at byte offset i * exponent_stride;
exponent_stride 0: one exponent for all.""",
    (streams("power_motor_each", out("motors"), given("motors", "motors"), *strided("exponents"), COUNT),),
    "motors",
    VIEWS,
)


def interpolations(verb: str):
    """Between motors of each element, and between two that all share."""
    choice = {"flag": "MW_LONG_WAY"}
    of_each = (out("motors"), given("motors", "first"), given("motors", "second"), *strided("parameters"), COUNT, FLAGS)
    of_one = (out("motors"), motor("first"), motor("second"), *strided("parameters"), COUNT, FLAGS)
    return (
        streams(f"{verb}_motor_each", *of_each, flagged=f"{verb}_long_motor_each", **choice),
        with_shared_motors(
            streams(f"{verb}_motor_one", *of_one, text="between the same two poses, at many parameters",
                    flagged=f"{verb}_long_motor_one", **choice)
        ),
    )


SLERP = Group(
    """\
out[i] = first[i] (first[i]^-1 second[i])^t, the screw between two poses at t = parameters[i]: first[i] at 0 and
±second[i] at 1, to rounding. Both normalised. parameter_stride as above.
It goes the short way, towards second or -second, whichever is nearer. With MW_LONG_WAY it goes the other one, which
turns on by what is missing to a full turn (a translation has no long way and takes the short one).
The short way is meant for 0 <= t <= 1, and loses little for -1 <= t <= 2. DO NOT USE IT BEYOND: for such t the
result is no motion. The long way, and mw_power_motor_each of mw_ratio_motor_each, take any t.
The long way between poses that are near to each other is about an axis that they hardly determine: with φ the angle
between them, rotations are right within 7 epsilons (8 where nothing fuses) for φ >= 0.1, and within 1/φ epsilons
below that.""",
    interpolations("slerp"),
    "motors",
    VIEWS + ("FLAGS",),
)

NLERP = Group(
    """\
out[i] = (1-t) first[i] ± t second[i], normalised ("method 1" of the lecture notes; equation (5) of the paper): the
same poses at both ends and almost the same path as slerp, at less than half the cost and at a speed that is not
constant. Both normalised; for every t of which the square, times the translations, is finite. The long way
(MW_LONG_WAY) is the sum with the other sign, which is degenerate where the two cancel: halfway between equal poses.
mw_blend_motor_* is the same without normalising.""",
    interpolations("nlerp"),
    "motors",
    VIEWS + ("FLAGS",),
)

# -------------------------------------------------------------------------------------------------------------- twists

SPLIT_BIVECTOR = Group(
    """\
The parts of a generator b12 b13 b23 b1i b2i b3i; of one without rotation angle 0, axis z, and all of it in `along`
and `across` of that axis. Computed in double, rounded once.""",
    (Function("split_bivector", (made("twist"), array_of("bivector", 6))),),
    "twist",
    ("NULL", "AXIS (a number is not finite)"),
)

TWIST = Group(
    """\
The pose exp(λB), as the sum of a twist and what `across` adds (their equation (2)), and the position r_λ of what
is at the origin when λ = 0, a helix in closed form (section 4.1, errata.md). Computed in double, rounded once.""",
    (
        Function("twist_pose", (made("motor"), struct("twist", "twist"), scalar("lambda"))),
        Function("twist_position", (made_array_of("out"), struct("twist", "twist"), scalar("lambda"))),
    ),
    "twist",
    ("NULL", "AXIS (the axis does not have length 1, to 2^-10, or a number is not finite)"),
)

# -------------------------------------------------------------------------------------------------------------- blends

WEIGHTS = struct_of_views("weights_{P}", "weights", "weights", "weights_of({name})")
TERM_COUNT = size("term_count")

BLEND_ONE = Group(
    """\
out[i] = Σk weights[i][k] controls[k]: weighted sums of the same control motors, term after term in the order
k = 0, 1, ... The result is not normalised and need not be (the paper's section 4). It is degenerate where
controls of opposite sign cancel. Without terms (term_count = 0) every sum is the zero motor.
Time: count * term_count.""",
    (Function("blend_motor_one", (out("motors"), motors_side_by_side("controls"), WEIGHTS, TERM_COUNT, COUNT)),),
    "blend",
    VIEWS,
)

BLEND_EACH = Group(
    """\
out[i] = Σk weights[i][k] controls[k][i]: as above, each element with control motors of its own; controls[k] is
the view of all elements' k-th control. At most MW_MAX_TERMS terms.""",
    (
        Function(
            "blend_motor_each",
            (
                out("motors"),
                Parameter("controls", "views of motors, one per term", "const mw_const_motors_{P} *{name}", "{name}",
                          is_view=True),
                WEIGHTS, TERM_COUNT, COUNT,
            ),
        ),
    ),
    "blend",
    VIEWS + ("TERM_COUNT",),
)
