"""The formulas between motors and what other libraries hold: quaternions, matrices, angles, screws.

Rotations act first and translations then, so a motor is R T with T = 1 + ½ t e∞. The rotation by θ about the unit axis
a is cos θ/2 + sin θ/2 a e123 (Hunt et al., lemma 3.11), so the quaternion (x, y, z; w) is w + (x, y, z) e123.
What is not an element of the algebra is a dictionary of numbers by their names (elements.Numbers).
"""

from __future__ import annotations

from fractions import Fraction

from algebra import OMEGA, Multivector, e
from elements import DUAL_QUATERNION, SCREW
from expression import function, precise, root
from formulas import alpha, half_commutator_image, unnamed
from motor_group import log_shortest, normalized, sinc_and_slope, trim

SMALLEST_LENGTH = precise("smallest_length")
SMALLEST_ROTATION = Fraction(1, 2**60)  # its square is a normal number in both
AXES = ("23", "31", "12")  # of the rotations about e1, e2 and e3


def vector_of(B):
    """The numbers x, y, z of x e23 + y e31 + z e12, which is (x e1 + y e2 + z e3) e123."""
    return B["23"], -B["13"], B["12"]


def rotor(w, xyz):
    return sum((c * e(axis) for c, axis in zip(xyz, AXES)), Multivector({"": w}))


def translator(t):
    return 1 + t * e("i") / 2


def reciprocal_root(S, let):
    return let("r", 1 / root(let("alpha", alpha(S))))


def image_of_origin(S):
    """Where S takes the origin, times α/2."""
    return half_commutator_image(S, e("0"), unnamed)


# ------------------------------------------------------------------------------------------------------ quaternions


def motor_to_pose(S, let):
    r = reciprocal_root(S, let)
    q = dict(zip("xyz", (r * c for c in vector_of(S))), w=r * S[""])
    return q, let("k", 2 * r * r) * image_of_origin(S)


def pose_to_motor(q, t, let):
    return rotor(q["w"], (q["x"], q["y"], q["z"])) * translator(t)


def motor_to_dual_quaternion(S, let):
    numbers = (*vector_of(S), S[""], S["1i"], S["2i"], S["3i"], -S[OMEGA])
    return dict(zip(DUAL_QUATERNION.names, numbers))


def dual_quaternion_to_motor(q, let):
    real = rotor(q["rw"], (q["rx"], q["ry"], q["rz"]))
    return real + Multivector({"1i": q["dx"], "2i": q["dy"], "3i": q["dz"], OMEGA: -q["dw"]})


# --------------------------------------------------------------------------------------------------------- matrices


def motor_to_matrix(S, let):
    k = let("k", 2 / let("alpha", alpha(S)))
    m = {"m30": 0, "m31": 0, "m32": 0, "m33": 1}
    for column in range(3):
        image = half_commutator_image(S, e(str(column + 1)), unnamed)
        for row in range(3):
            m[f"m{row}{column}"] = (1 if row == column else 0) + k * image[str(row + 1)]
    origin = image_of_origin(S)
    m.update({f"m{row}3": k * origin[str(row + 1)] for row in range(3)})
    return m


def matrix_to_motor(m, let):
    """Each row of 4qqᵀ is the quaternion times 4 of its components: the row of one that is at least a quarter in
    square is taken (Shepperd), chosen by three comparisons (Day), and normalised."""

    def pick(name, condition, then, otherwise):
        return [let(f"{name}{c}", function("if_less", *condition, a, b)) for c, a, b in zip("wxyz", then, otherwise)]

    m00, m11, m22 = m["m00"], m["m11"], m["m22"]
    wx, wy, wz = let("wx", m["m21"] - m["m12"]), let("wy", m["m02"] - m["m20"]), let("wz", m["m10"] - m["m01"])
    yz, zx, xy = let("yz", m["m21"] + m["m12"]), let("zx", m["m02"] + m["m20"]), let("xy", m["m10"] + m["m01"])
    sum, difference = let("sum", m00 + m11), let("difference", m00 - m11)
    of_x = (wx, let("xx", 1 + difference - m22), xy, zx)
    of_y = (wy, xy, let("yy", 1 - difference - m22), yz)
    of_z = (wz, zx, yz, let("zz", 1 - sum + m22))
    of_w = (let("ww", 1 + sum + m22), wx, wy, wz)
    flat = pick("p", (m11, m00), of_x, of_y)
    upright = pick("q", (sum, 0), of_z, of_w)
    w, *xyz = pick("c", (m22, 0), flat, upright)
    square = w * w + xyz[0] * xyz[0] + xyz[1] * xyz[1] + xyz[2] * xyz[2]
    r = let("r", function("with_sign", 1 / root(let("square", square)), w))
    R = let("n", rotor(r * w, [r * c for c in xyz]))
    return R * translator(Multivector({str(row + 1): m[f"m{row}3"] for row in range(3)}))


# ----------------------------------------------------------------------------------------------------------- angles


def cosine_and_sine(angle, name, let):
    """Of half an angle of any size, reduced by multiples of π."""

    def named(part, value):
        return let(f"{name}_{part}", value)

    half = named("half", function("unwind_angle", angle / 2))
    halves = named("half_turns", function("nearest", half * precise("inverse_pi")))
    r = named("r", named("rough", function("less_half_turns", half, halves)) - halves * precise("pi_rest"))
    sinc, slope = sinc_and_slope(r, halves, f"{name}_", let)
    return named("cos", sinc + slope), named("sin", r * sinc)


def arc_tangent(y, x, name, let):
    """The angle of (x, y), in [-π, π]; of (0, 0) it is 0."""

    def named(part, value):
        return let(f"{name}_{part}", value)

    length = named("length", root(named("square", x * x + y * y)))
    i = named("i", function("if_less", 0, length, 1 / length, 0))
    rest = named("arc", y * i * function("arc", 1 - function("magnitude", x * i)))
    return named("angle", function("if_less", x, 0, function("with_sign", precise("pi"), y) - rest, rest))


def to_half_turn(angle, name, let):
    """An angle of at most two turns, in [-π, π]."""
    turns = let(f"{name}_turns", function("nearest", angle * precise("inverse_two_pi")))
    rough = let(f"{name}_rough", angle - turns * precise("two_pi"))
    return at_most(precise("pi"), let(name, rough - turns * precise("two_pi_rest")))


def larger(a, b):
    return function("if_less", a, b, b, a)


def at_most(bound, value):
    """The value, or the bound with its sign if rounding made it larger than that."""
    return function("if_less", bound, function("magnitude", value), function("with_sign", bound, value), value)


def motor_to_axis_angle(S, let):
    r = reciprocal_root(S, let)
    s = let("unit_s", r * S[""])
    f = let("f", r * function("with_sign", function("arc", 1 - function("magnitude", s)), s))
    v = [let(f"v{name}", f * c) for name, c in zip("xyz", vector_of(S))]  # the axis times half the angle
    # Scaled, so that no square underflows: nothing is too small an angle.
    x, y, z = (function("magnitude", c) for c in v)
    scale = let("scale", function("at_least", larger(larger(x, y), z), SMALLEST_LENGTH))
    inverse = let("inverse", 1 / scale)
    x, y, z = (let(f"d{name}", c * inverse) for name, c in zip("xyz", v))
    length = let("length", root(let("square", x * x + y * y + z * z)))
    i = let("i", function("if_less", 0, length, 1 / length, 0))
    axis = {"x": x * i, "y": y * i, "z": function("if_less", 0, length, z * i, 1)}
    angle = let("angle", 2 * scale * length)
    return dict(axis, w=at_most(precise("pi"), angle)), let("k", 2 * r * r) * image_of_origin(S)


def axis_angle_to_motor(a, t, let):
    c, s = cosine_and_sine(a["w"], "half", let)
    return let("r", rotor(c, [s * a[name] for name in "xyz"])) * translator(t)


def euler_to_motor(axes, angles, t, let):
    """About the three given axes, each turned by the rotations before it: the last one named acts first."""
    R = Multivector({"": 1})
    for k, name in enumerate("xyz"):
        c, s = cosine_and_sine(angles[name], f"of_{name}", let)
        R = let(f"r{k}", rotor(c, [s * axes[f"{name}{k}"] for name in "xyz"]) * R)
    return trim(R, let) * translator(t)


def in_axes(S, axes):
    """w and the components of the vector part along three axes."""
    xyz = vector_of(S)
    return S[""], *(sum(axes[f"{name}{k}"] * c for name, c in zip("xyz", xyz)) for k in range(3))


def first_and_third(a, b, c, d, sign, let):
    """The sum and the difference of the halves that (a, b) and (c, d) show, and what of those two is left of length:
    the squares of both. Where one is nothing but rounding, its angle is taken to be that of the other, so that the third
    angle is 0 (gimbal lock)."""
    plus, minus = arc_tangent(b, a, "plus", let), arc_tangent(d, c, "minus", let)
    ab, cd = let("ab", a * a + b * b), let("cd", c * c + d * d)
    locked_plus = let("locked_plus", function("if_less", ab, let("small_ab", cd * precise("gimbal_lock")), minus, plus))
    locked_minus = let("locked_minus", function("if_less", cd, let("small_cd", ab * precise("gimbal_lock")), plus, minus))
    first, third = let("sum", locked_plus + locked_minus), let("difference", locked_plus - locked_minus)
    return sign * to_half_turn(first, "first", let), sign * to_half_turn(third, "third", let), ab, cd


def motor_to_euler(axes, sign, S, let):
    """About three different axes i, j, k. w ± q_j and q_i ± q_k are cos and sin of half the sum and half the difference
    of the first and third angle, times cos θ/2 ± sin θ/2 of the second (Bernardes and Viollet)."""
    w, q1, q2, q3 = (let(name, c) for name, c in zip(("q0", "q1", "q2", "q3"), in_axes(S, axes)))
    a, b, c, d = let("a", w + q2), let("b", q1 + q3), let("c", w - q2), let("d", q1 - q3)
    first, third, ab, cd = first_and_third(a, b, c, d, sign["sign"], let)
    cosine = let("cosine", root(ab * cd))
    sine = let("sine", 2 * (w * q2 + q1 * q3))
    second = sign["sign"] * at_most(precise("half_pi"), arc_tangent(sine, cosine, "second", let))
    return {"x": first, "y": second, "z": third}, let("k", 2 / let("alpha", alpha(S))) * image_of_origin(S)


def motor_to_euler_proper(axes, sign, S, let):
    """About i, j and i again: (w, q_i) and (q_j, q_k) have half the sum and half the difference of the first and third
    angle, and their lengths are cos θ/2 and sin θ/2 of the second."""
    a, b, c, d = (let(name, c) for name, c in zip("abcd", in_axes(S, axes)))
    first, third, ab, cd = first_and_third(a, b, c, d, sign["sign"], let)
    second = arc_tangent(let("sine", 2 * root(ab * cd)), let("cosine", ab - cd), "second", let)
    return {"x": first, "y": second, "z": third}, let("k", 2 / let("alpha", alpha(S))) * image_of_origin(S)


# ----------------------------------------------------------------------------------- translations, screws and rotors


def translation_to_motor(t, let):
    return translator(t)


def motor_to_translation(S, let):
    return let("k", 2 / let("alpha", alpha(S))) * image_of_origin(S)


def motor_to_screw(S, let):
    """The logarithm is ½θ (a + q × a ω') + ½ d a ω' in vectors: its direction is the axis, and what of the moment is
    normal to that has the nearest point of the axis."""
    B = let("g", normalized(log_shortest)(S, let))
    turn, moment = vector_of(B), (B["1i"], B["2i"], B["3i"])
    half_angle = let("half_angle", root(let("square", sum(c * c for c in turn))))

    def if_it_turns(then, otherwise):
        return function("if_less", SMALLEST_ROTATION, half_angle, then, otherwise)

    u = [let(f"u{name}", if_it_turns(a, m)) for name, a, m in zip("xyz", turn, moment)]
    # Scaled, so that no square underflows or overflows: no translation is too short or too long.
    x, y, z = (function("magnitude", c) for c in u)
    scale = let("scale", function("at_least", larger(larger(x, y), z), SMALLEST_LENGTH))
    inverse = let("inverse", 1 / scale)
    u = [let(f"d{name}", c * inverse) for name, c in zip("xyz", u)]
    length = let("length", root(let("length_square", sum(c * c for c in u))))
    i = let("i", function("if_less", 0, length, 1 / length, 0))
    axis = [u[0] * i, u[1] * i, function("if_less", 0, length, u[2] * i, 1)]
    ax, ay, az = axis = [let(f"axis_{name}", c) for name, c in zip("xyz", axis)]
    along = let("along", sum(a * m for a, m in zip(axis, moment)))
    mx, my, mz = (let(f"m{name}", m - along * a) for name, a, m in zip("xyz", axis, moment))
    lever = let("lever", if_it_turns(i * inverse, 0))
    arm = let("px", ay * mz - az * my), let("py", az * mx - ax * mz), let("pz", ax * my - ay * mx)
    point = (lever * c for c in arm)
    angle = let("angle", 2 * if_it_turns(half_angle, 0))
    return dict(zip(SCREW.names, (*axis, *point, at_most(precise("pi"), angle), 2 * along)))


def screw_to_motor(screw, let):
    """The rotation of lemma 3.11, cos + sin (b + (b∧q) e∞), and the translation along the axis."""
    c, s = cosine_and_sine(screw["angle"], "half", let)
    ax, ay, az = (screw[f"a{name}"] for name in "xyz")
    px, py, pz = (screw[f"p{name}"] for name in "xyz")
    half = let("half_distance", screw["distance"] / 2)
    shift = let("shift", c * half)
    moments = (py * az - pz * ay, pz * ax - px * az, px * ay - py * ax)
    ideal = {
        f"{k}i": s * let(f"m{name}", m) + shift * a
        for k, name, m, a in zip("123", "xyz", moments, (ax, ay, az))
    }
    return rotor(c, (s * ax, s * ay, s * az)) + Multivector({**ideal, OMEGA: s * half})


def rotor_to_motor(scale, R, let):
    """The reverse, with lengths in other units."""
    S = ~R
    return Multivector({blade: scale["scale"] * c if "i" in blade else c for blade, c in S.parts.items()})
