"""The formulas of the group of motors: exp, log, powers, interpolation.

With B² = -(x + yω), x = |b|², the exponential of a bivector is C(x̂) + S(x̂) B for the entire functions C(x) = cos √x
and S(x) = sin √x / √x of the dual number x̂ = x + yω; and a function of a dual number is f(x) + f'(x) yω. The logarithm
of a normalised motor is f(ŝ) times its bivector, ŝ = s + wω, f(s) = acos(s)/√(1-s²). What approximates C, S and f is in
approximate.py. (Wareham and Lasenby's theorems 3 and 9 are these, in another form: see errata.md.)

Rounding errors are part of these formulas: a value under a name is computed as it stands.
"""

from __future__ import annotations

from fractions import Fraction

from algebra import OMEGA, Multivector
from elements import BIVECTOR
from expression import component, function, precise, root
from formulas import alpha, beta, normalize_reciprocal, reverse_over

ROTOR = {"": "s", "12": "b12", "13": "b13", "23": "b23"}
SMALLEST_ANGLE = Fraction(1, 2**40)  # its square is no rounding error of 1 in either precision


def dual(real, pseudoscalar) -> Multivector:
    """The dual number real + pseudoscalar ω; it commutes with every motor."""
    return Multivector({"": real, OMEGA: pseudoscalar})


def half_beta_of_square(B):
    """h with B² = -|b|² + 2hω."""
    return (B * B)[OMEGA] / 2


def lost_in_sum(a, b, total, name, let):
    """The rounding error of total = b b + a, to twice the precision. (Exactly, it is 0.)"""
    part = let(f"{name}_part", total - a)
    rest = let(f"{name}_rest", total - part)
    return let(f"{name}_a", a - rest) + let(f"{name}_b", b * b - part)


def unwind(B, let):
    """A bivector with the exponential of B, and not too large an angle for what follows: hardly ever another than B."""
    values = let("unwound", function("unwind", *BIVECTOR.coefficients(B)))
    return BIVECTOR.multivector(lambda name: component(values, name))


def sinc_and_slope(r, half_turns, prefix, let):
    """sin r / r and cos r less that, with the sign of what r + half_turns π has."""
    y = let(f"{prefix}y", r * r)
    sinc = let(f"{prefix}sinc_r", function("short_sinc", y))
    slope = let(f"{prefix}slope_r", y * function("short_sinc_slope", y))
    return (
        let(f"{prefix}signed_sinc", function("flip_if_odd", sinc, half_turns)),
        let(f"{prefix}signed_slope", function("flip_if_odd", slope, half_turns)),
    )


def exp_bivector(B, let):
    """exp(B). The angle is reduced by multiples of π, of which the odd ones change the sign, and kept to twice the
    precision: an error of it is one of the motor, and grows with the angle otherwise."""
    B = unwind(B, let)
    b12, b13, b23 = B["12"], B["13"], B["23"]
    x1 = let("x1", b12 * b12)
    x2 = let("x2", x1 + b13 * b13)
    x = let("x", x2 + b23 * b23)
    low = let("low", let("lost1", b12 * b12 - x1) + let("lost2", lost_in_sum(x1, b13, x2, "two", let))
              + let("lost3", lost_in_sum(x2, b23, x, "three", let)))
    near = let("near", root(x))
    theta = let("theta", function("at_least", near, SMALLEST_ANGLE))
    rough = let("rough_i", 1 / theta)
    halves = let("half_turns", function("nearest", theta * precise("inverse_pi")))
    rest = let("rest", let("missing", let("square_rest", x - near * near) + low) * let("half_i", rough / 2))
    i = let("i", function("refine", rough, theta, rest))
    reduced = let("reduced", theta - halves * precise("pi"))
    r = let("r", reduced + let("correction", rest - halves * precise("pi_rest")))
    sinc, slope = sinc_and_slope(r, halves, "", let)
    q = let("q", i * sinc)
    f = let("f", r * q)  # sin θ / θ
    h = let("h", half_beta_of_square(B))
    # h (cos θ - sin θ / θ) / θ²; nothing cancels where the angle is small
    g = let("g", let("ii", i * i) * let("bend", slope + let("turned", halves * precise("pi")) * q) * h)
    S = dual(sinc + slope, f * h) + (dual(f, -g) * B).only(BIVECTOR.blades)
    return trim(S, let, unless_fused=True)


def trim(S, let, unless_fused=False):
    """The motor with the last epsilons off the length of its rotation."""
    name = "trim_unless_fused" if unless_fused else "trim"
    values = let("trimmed", function(name, *(S[blade] for blade in ROTOR)))
    return Multivector({**S.parts, **{blade: component(values, name) for blade, name in ROTOR.items()}})


def log_parts(S, let):
    """Of a normalised motor: z = 1 - |s|, and f(|s|) with the sign of s."""
    z = let("z", 1 - function("magnitude", S[""]))
    return z, function("with_sign", function("arc", z), S[""])


def log_shortest(S, let):
    """The logarithm of S or of -S, whichever turns by no more than a half turn."""
    z, f = log_parts(S, let)
    g = let("g", function("arc_slope", z) * S[OMEGA])
    return (dual(let("f", f), g) * S.only(BIVECTOR.blades)).only(BIVECTOR.blades)


def turn_over_angle(S, let):
    """π/√(1-s²), and its 1/√(1-s²); 0 where that is lost to rounding."""
    square = let("square", S["12"] * S["12"] + S["13"] * S["13"] + S["23"] * S["23"])
    near = let("near", root(square))
    rough = let("rough", function("if_less", SMALLEST_ANGLE, near, 1 / near, 0))
    # One step of Newton's, for an inverse of |b| that is right to half an ulp.
    i = let("i", rough + let("half_rough", rough / 2) * let("off", 1 - let("scaled", square * rough) * rough))
    return let("pi_over", i * precise("pi") + i * precise("pi_rest")), i


def long_slope(S, z, turn, i, let):
    """df/ds where f(s) = turn - f(|s|), turn = π/√(1-s²) or 0."""
    return let("slope", function("arc_slope", z) - let("bend", turn * function("magnitude", S[""])) * let("ii", i * i))


def log_principal(S, let):
    """The logarithm of S itself, which turns by less than a full turn: for s < 0, f(s) = π/√(1-s²) - f(-s)."""
    z, f = log_parts(S, let)
    full, i = turn_over_angle(S, let)
    turn = let("turn", function("if_less", f, 0, full, 0))  # f is negative for s = -0 too
    g = let("g", long_slope(S, z, turn, i, let) * S[OMEGA])
    return (dual(let("f", f + turn), g) * S.only(BIVECTOR.blades)).only(BIVECTOR.blades)


def normalized(form):
    """The same of a motor that need not be normalised."""
    return lambda S, let: form(let("n", normalize_reciprocal(S, let)), let)


def square_root(S, let):
    """The motor halfway, of S or of -S: (1 + S) / √(its pseudoscalar), with s >= 0."""
    a = let("a", function("magnitude", S[""]) + 1)
    r = let("r", 1 / root(a + a))
    c = let("c", function("with_sign", r, S[""]))
    q = let("q", S[OMEGA] * let("rc", r * c))
    turned = let("t", (dual(1, -q) * S.only(BIVECTOR.blades)).only(BIVECTOR.blades))
    return dual(a * r, let("half_w", S[OMEGA] / 2) * c) + c * turned


def slerp_weight(t, factor, shared, name, let):
    """The dual number sin(t θ̂)/sin θ̂ times factor/t, for the dual angle θ̂ between two motors."""
    f, ff, slope, x, w = shared
    square = let(f"{name}_tt", t * t)
    y = let(f"{name}_y", square * x)
    sinc = let(f"{name}_sinc", function("sinc", y))
    bend = let(f"{name}_bend", let(f"{name}_fft", ff * square) * function("sinc_slope", y))
    real = let(f"{name}_real", factor * let(f"{name}_arc", f * sinc))
    return real, let(f"{name}_dual", let(f"{name}_w", factor * w) * let(f"{name}_slope", slope * sinc - bend))


def slerp(first, second, t, let):
    """first (first^-1 second)^t the short way, as sin((1-t)θ̂)/sin θ̂ first + sin(tθ̂)/sin θ̂ second: Shoemake's slerp, in
    dual numbers. Both weights are analytic where the motors meet; nothing is divided."""
    between = ~first * second
    s, w = let("s", between[""]), let("w", between[OMEGA])
    a = let("a", function("magnitude", s))
    z = let("z", 1 - a)
    sign = let("sign", function("with_sign", 1, s))
    f, slope = let("f", function("arc", z)), let("slope", function("arc_slope", z))
    ff = let("ff", f * f)
    shared = (f, ff, slope, let("xx", ff * let("sines", 1 - a * a)), let("short_w", sign * w))
    u = let("u", 1 - t[""])
    p = slerp_weight(u, u, shared, "p", let)
    q = slerp_weight(t[""], let("signed_t", sign * t[""]), shared, "q", let)
    return dual(*p) * first + dual(*q) * second


def log_long(S, let):
    """The logarithm of S or of -S, whichever turns by no less than a half turn; the shortest of a translation."""
    z = let("z", 1 - function("magnitude", S[""]))
    full, i = turn_over_angle(S, let)
    f = let("f", function("with_sign", 1, S[""]) * let("missing", function("arc", z) - full))
    g = let("g", long_slope(S, z, full, i, let) * S[OMEGA])
    return (dual(f, g) * S.only(BIVECTOR.blades)).only(BIVECTOR.blades)


def slerp_long(first, second, t, let):
    """first exp(t log(first^-1 second)), of the logarithm that goes the long way."""
    between = let("b", ~first * second)
    return first * let("p", exp_multiple(log_long(between, let), t[""], let))


def exp_multiple(B, factor, let):
    """exp(factor B)."""
    scaled = let("l", factor * let("g", B))
    return exp_bivector(scaled, lambda name, value: let(f"e_{name}", value))


def nlerp(way):
    """(1-t) first ± t second, normalised: with way 1 the sign of the short way, with way -1 of the long."""

    def form(first, second, t, let):
        s = let("s", sum(first[blade] * second[blade] for blade in ("", "12", "13", "23")))
        signed = let("signed_t", t[""] * let("sign", function("with_sign", 1, s)))
        return normalize_reciprocal(let("n", let("u", 1 - t[""]) * first + way * signed * second), let)

    return form


def power(S, exponent, let):
    """S^t = exp(t log S), by the shortest logarithm."""
    return exp_multiple(log_shortest(S, let), exponent[""], let)


def ratio(first, second, let):
    """first^-1 second."""
    return let("i", reverse_over(first, let)) * second

