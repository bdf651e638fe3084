"""Motors from and into what other libraries hold."""

from __future__ import annotations

from api import COUNT, FIRST_BAD, FLAGS, Function, Group, Parameter, given, number, out, scalar, streams
from functions.motors import VIEWS

MOTORS = given("motors", "motors")


def conversion(name: str, *parameters, **more) -> Function:
    """Through a function of the library of that name: where there is more to do than to call one kernel."""
    return Function(f"convert_{name}_each", parameters, through=f"convert_{name}", **more)


POSES = Group(
    """\
Unit quaternions and translations. The sign of the motor is that of the quaternion, and a quaternion of any other
length but zero makes a motor of that length, of the same motion: w + z e12 - y e13 + x e23, and then 1 + ½ t e∞.""",
    (
        conversion("motor_to_pose", out("xyzw", "quaternions"), out("xyz", "translations"), MOTORS, COUNT),
        conversion("pose_to_motor", out("motors"), given("xyzw", "quaternions"), given("xyz", "translations"), COUNT),
    ),
    "convert",
    VIEWS,
)

DUAL_QUATERNIONS = Group(
    """\
Dual quaternions r + εd with d = ½ t r, as engines and skinning have them: r = (b23, -b13, b12; s) and
d = (b1i, b2i, b3i; -w). Exact. Of any length, and also where r and d are not orthogonal, as in sums of dual
quaternions: the motor turns as r does and then moves by the vector part of 2 d r* / |r|², as in skinning.""",
    (
        conversion("motor_to_dual_quaternion", out("dual_quaternions"), MOTORS, COUNT),
        conversion("dual_quaternion_to_motor", out("motors"), given("dual_quaternions", "in"), COUNT),
    ),
    "convert",
    VIEWS,
)

MATRICES = Group(
    """\
Matrices. All are looked at before any is converted, and one that is no rotation and translation is
MW_ERROR_MATRIX: then *first_bad (unless that pointer is null) is the number of the first, and nothing is written.
What is meant is the distance of mw_check_matrices, and MW_MATRIX_TOLERANCE_F32 or _F64. That costs about 4 ns per
matrix of floats and 7 of doubles, where the conversion takes 2 and 5. With MW_ROTATION_MATRICES none is looked at.
With MW_NEAREST_ROTATION comes the rotation nearest to R, in the sum of the squares of the differences: that of a
matrix with scale and shear, and of one that reflects as long as a single rotation is nearest. MW_ERROR_MATRIX where
none is (a mirror image, which is as near to all its half turns; what leaves no plane of space), of projections, and
of numbers that are not finite. Slower by far: one after the other, twice each, by Jacobi's method in double.
MW_ERROR_FLAGS also for both flags together.""",
    (
        conversion("motor_to_matrix", out("matrices"), MOTORS, COUNT),
        conversion("matrix_to_motor", out("motors"), given("matrices", "matrices"), COUNT, FLAGS, FIRST_BAD),
    ),
    "matrices",
    VIEWS + ("MATRIX_LAYOUT", "MATRIX (matrix_to_motor)", "FLAGS (matrix_to_motor)"),
)

CHECK_MATRICES = Group(
    """\
One pass over the matrices: MW_ERROR_MATRIX if one is further from a rotation than `tolerance`, and then *first_bad
is the number of the first such. Its distance is the largest element of |RᵀR - 1|; of 4 x 4 matrices also how far
the last number is from 1. It is infinite if R is a reflection, if the last row does not begin with three zeros (to
16 epsilons: the matrix projects) or if any number is not finite. *deviation is the largest distance of all. Both
pointers may be null.""",
    (
        Function(
            "check_matrices",
            (
                given("matrices", "matrices"), COUNT, scalar("tolerance"), FIRST_BAD,
                Parameter("deviation", "output number", "{T} *{name}", default="nullptr"),
            ),
        ),
    ),
    "matrices",
    ("NULL", "STRIDE", "SIZE", "MATRIX", "MATRIX_LAYOUT"),
)

AXIS_ANGLE = Group(
    """\
Axis and angle, and translations: x y z is the axis through the origin, and w the angle, of any finite size. THE AXIS
MUST HAVE LENGTH 1, which is not looked at: with another length a it turns by another angle φ, tan φ/2 = a tan θ/2.
(mw_rotation takes an axis of any length.) From motors come angles in [0, π]; where it is 0, the axis is z.""",
    (
        streams(
            "convert_motor_to_axis_angle_each", out("xyzw", "rotations"), out("xyz", "translations"), MOTORS, COUNT
        ),
        streams(
            "convert_axis_angle_to_motor_each", out("motors"), given("xyzw", "rotations"),
            given("xyz", "translations"), COUNT,
        ),
    ),
    "convert",
    VIEWS,
)

ORDER = number("order", "mw_euler_order", "order of Euler angles")
EULER = Group(
    """\
Euler angles, and translations: x is the first angle, y the second, z the third, of any finite size. From motors
come the first and third angle in [-π, π]. Where these two are about the same axis (gimbal lock: the second angle
is ±π/2, or in orders that begin and end with the same axis 0 or π), only their sum or their difference is
determined. Then the third is 0 and the first has all of it, on every instruction set: as scipy has it, and
engines. That begins where the second angle is within 16 epsilons of those, and costs the rotation as much.""",
    (
        conversion("motor_to_euler", out("xyz", "angles"), out("xyz", "translations"), MOTORS, COUNT, ORDER),
        conversion("euler_to_motor", out("motors"), given("xyz", "angles"), given("xyz", "translations"), COUNT, ORDER),
    ),
    "convert",
    VIEWS + ("EULER_ORDER",),
)

TRANSLATIONS = Group(
    """\
Translations alone: 1 + ½ t e∞ (the paper's lemma 3.10); and of any motor where it takes the origin.""",
    (
        streams("convert_translation_to_motor_each", out("motors"), given("xyz", "translations"), COUNT),
        streams("convert_motor_to_translation_each", out("xyz", "translations"), MOTORS, COUNT),
    ),
    "convert",
    VIEWS,
)

SCREWS = Group(
    """\
Screws (Chasles): a rotation by `angle` about the axis of direction a, of length 1, through the point p, and a
translation by `distance` along it, in any order. The pitch is distance / angle. With distance 0 that is the
rotation about a point of lemma 3.11. From motors come angles in [0, π], and the point of the axis that is nearest
to the origin. A translation has angle 0, its own direction for the axis, and the origin for the point; so has what
turns by less than 2^-59. The identity has the axis z. INTO MOTORS THE AXIS MUST HAVE LENGTH 1, which is not looked
at: with another length the angle is wrong as above, and so is the way along the axis.""",
    (
        streams("convert_motor_to_screw_each", out("screws"), MOTORS, COUNT),
        streams("convert_screw_to_motor_each", out("motors"), given("screws", "screws"), COUNT),
    ),
    "convert",
    VIEWS,
)

LAMBDA = scalar("lambda", default="1")
ROTORS = Group(
    """\
Rotors as Wareham and Lasenby write them, which act as R x R̃ and in which lengths are measured in units of `lambda`
(their embedding, section 1): R = S̃ with its e∞ part divided by lambda, and n for e∞. The components of rotors are
in the order of a motor's, e1∞ standing for e1 n. Sign and length are kept, and rotors need not be normalised; exact
up to the rounding of 1 / lambda.""",
    (
        conversion("motor_to_rotor", out("motors", "rotors"), MOTORS, COUNT, LAMBDA),
        conversion("rotor_to_motor", out("motors"), given("motors", "rotors"), COUNT, LAMBDA),
    ),
    "convert",
    VIEWS + ("SCALE (lambda is 0 or not finite, or its inverse is not)",),
)
