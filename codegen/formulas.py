"""The formulas of the kernels, written as the papers write them.

A formula takes the kernel's inputs as multivectors and a function `let(name, value)` that names a value for the
reader of the generated code and returns it. It is evaluated over expressions to generate code, and over
rationals to make golden vectors, so it may use nothing but the algebra, + - * / and `root`. It returns one
multivector, or a tuple of one an output.

Every operand has several forms, which the generator proves equal:

    sandwich      the definition, S̄ x S over S̄S, or P(S̄ p S) over α
    commutator    x + (2/α) S̄ (x∧S): since xS = Sx + 2 x∧S, this is the same, and x∧S is sparse
    matrix        the commutator with the coefficients of x expanded, for one motor and many elements
"""

from __future__ import annotations

from algebra import OMEGA, VECTORS, Multivector, e, project, transform
from elements import DIRECTION, LINE, VECTOR
from expression import node, root, symbol
from simplify import linear_coefficients


def alpha(S: Multivector):
    """The e0 part of the image of e0, S̄S = α + βω (lemma 3.3)."""
    return (~S * S)[""]


def beta(S: Multivector):
    return (~S * S)[OMEGA]


def two_over_alpha(S, let):
    return let("k", 2 / let("alpha", alpha(S)))


# ------------------------------------------------------------------------------------------- points and directions


def point_sandwich(S, p, let):
    """The definition: P(S̄ p S), divided by its e0 part."""
    return transform(S, p) / let("alpha", alpha(S))


def point_sandwich_unit(S, p, let):
    return transform(S, p)


def half_commutator_image(S, p, let):
    """P(S̄ (p∧S)): since S̄ p S = S̄S p + 2 S̄ (p∧S), this is half of what S moves p by, times α."""
    return project(~S * let("c", p.outer(S)))


def point_commutator(S, p, let):
    return p + two_over_alpha(S, let) * half_commutator_image(S, p, let)


def point_commutator_unit(S, p, let):
    return p + 2 * half_commutator_image(S, p, let)


def unnamed(name, value):
    return value


def point_matrix(S, p, let, before=Multivector(), after=Multivector()):
    """p -> M (p - before) + t + after, as M p and a constant."""
    k = two_over_alpha(S, let)
    columns = {"1": "x", "2": "y", "3": "z"}
    image = half_commutator_image(S, p.only("0") + DIRECTION.multivector(symbol), unnamed)
    moved = {"0": p["0"]}
    for row in columns:
        coefficients = linear_coefficients(node(image[row]), tuple(columns.values()))
        entries = {
            column: let(f"m{row}{column}", (1 if row == column else 0) + k * coefficients.get(name, 0))
            for column, name in columns.items()
        }
        constant = k * coefficients.get("", 0) + after[row]
        constant = constant - sum(entry * before[column] for column, entry in entries.items())
        moved[row] = sum(entry * p[column] for column, entry in entries.items())
        moved[row] += let(f"t{row}", constant) if constant != 0 else 0
    return Multivector(moved)


POINT_FORMS = (("sandwich", point_sandwich), ("commutator", point_commutator), ("matrix", point_matrix))
POINT_UNIT_FORMS = (("sandwich", point_sandwich_unit), ("commutator", point_commutator_unit))


def tangent_form(form):
    """A direction moved by one of its forms, and a scalar that stays."""

    def moved(S, t, let):
        return form(S, t.only("123"), let) + t[""]

    return moved


def vertex_form(form):
    """A point and a direction by the same form, which share what depends on the motor alone."""

    def moved(S, p, n, let):
        return form(S, p, let), form(S, n, lambda name, value: let("d" if name == "c" else name, value))

    return moved


def shifted_form(form):
    """F_S(p - before) + after."""

    def moved(S, before, after, p, let):
        return form(S, let("p", p - before), let) + after

    return moved


def shifted_matrix(S, before, after, p, let):
    return point_matrix(S, p, let, before, after)


def each_form(make, forms):
    return tuple((name, make(form)) for name, form in forms)


# ---------------------------------------------------------------------------------------------------------- vectors


def normalized_but_for_alpha(S, let):
    """S divided by the square root of S̄S/α = 1 + (β/α)ω: what is left is √α times a normalised motor."""
    return S - S * Multivector({OMEGA: let("r", beta(S) / (2 * let("alpha", alpha(S))))})


def vector_sandwich(S, v, let):
    N = normalized_but_for_alpha(S, let)
    return (~N * v * N).only(VECTORS) / let("alpha", alpha(S))


def vector_sandwich_unit(S, v, let):
    return (~S * v * S).only(VECTORS)


def vector_half_image(S, v, let):
    return (~S * let("c", v.outer(S))).only(VECTORS)


def vector_commutator(S, v, let):
    """βω, the rest of S̄S, adds ½ v0 (β/α)² to the e∞ part of S̄ v S over α: that is taken off."""
    k = two_over_alpha(S, let)
    r = let("r", beta(S) * k)  # twice β/α
    return v + k * vector_half_image(S, v, let) - Multivector({"i": v["0"] * let("excess", r * r / 8)})


def vector_commutator_unit(S, v, let):
    return v + 2 * vector_half_image(S, v, let)


def vector_matrix(S, v, let):
    k = two_over_alpha(S, let)
    r = let("r", beta(S) * k)
    image = vector_half_image(S, VECTOR.multivector(symbol), unnamed)
    moved = {"0": v["0"], **{row: 0 for row in "123"}, "i": v["i"]}
    for row in "123i":
        coefficients = linear_coefficients(node(image[row]), [name for name, _ in VECTOR.components])
        for name, column in VECTOR.components[:-1]:
            entry = (1 if row == column else 0) + k * coefficients.get(name, 0)
            if row + column == "i0":
                entry = entry - r * r / 8
            moved[row] += let(f"m{row}{column}", entry) * v[column] if entry != 0 else 0
    return Multivector(moved)


VECTOR_FORMS = (("sandwich", vector_sandwich), ("commutator", vector_commutator), ("matrix", vector_matrix))
VECTOR_UNIT_FORMS = (("sandwich", vector_sandwich_unit), ("commutator", vector_commutator_unit))

# ------------------------------------------------------------------------------------------------- lines and motors
#
# A line is the bivector of a motor, and a motor is a scalar, a line and an ω; scalar and ω commute with S.


def line_sandwich(S, line, let):
    """S^-1 ℓ S, with S^-1 = S̄ (1 - (β/α) ω) / α."""
    a = let("alpha", alpha(S))
    return (~S * line * S * Multivector({"": 1, OMEGA: -(beta(S) / a)})).only(LINE.blades) / a


def line_sandwich_unit(S, line, let):
    return (~S * line * S).only(LINE.blades)


def line_half_image(S, line, let):
    return (~S * let("c", line.outer(S))).only(LINE.blades)


def line_commutator(S, line, let):
    k = two_over_alpha(S, let)
    image = let("i", line_half_image(S, line, let))
    turned = (image * Multivector({OMEGA: let("r", beta(S) * k)})).only(LINE.blades) / 2
    return line + k * (image - turned)


def line_commutator_unit(S, line, let):
    return line + 2 * line_half_image(S, line, let)


def line_matrix(S, line, let):
    """d' = M d and m' = M m + N d, where M is the rotation and N d = t × M d."""
    k = two_over_alpha(S, let)
    r = let("r", beta(S) * k)
    half_image = line_half_image(S, LINE.multivector(symbol), unnamed)
    names = [name for name, _ in LINE.components]
    image, turned = (
        [linear_coefficients(node(c), names) for c in LINE.coefficients(value)]
        for value in (half_image, (half_image * e(OMEGA)).only(LINE.blades))
    )
    given, moved = LINE.coefficients(line), {name: 0 for name in names}
    for i, row in enumerate("123"):
        for j, column in enumerate("123"):
            d = names[j]
            rotation = let(f"m{row}{column}", (1 if i == j else 0) + k * image[i].get(d, 0))
            offset = let(f"n{row}{column}", k * image[3 + i].get(d, 0) - k * r * turned[3 + i].get(d, 0) / 2)
            moved[names[i]] += rotation * given[j]
            moved[names[3 + i]] += rotation * given[3 + j] + offset * given[j]
    return LINE.multivector(moved.__getitem__)


LINE_FORMS = (("sandwich", line_sandwich), ("commutator", line_commutator), ("matrix", line_matrix))
LINE_UNIT_FORMS = (("sandwich", line_sandwich_unit), ("commutator", line_commutator_unit))


def motor_form(form):
    """The line of a motor moved by one of its forms; its scalar and its ω stay."""

    def moved(S, M, let):
        return form(S, M.only(LINE.blades), let) + M.only(("", OMEGA))

    return moved


# --------------------------------------------------------------------------------------------------------- motors


def normalize_quotient(S, let):
    """S divided by the square root of S̄S = α + βω (lemma 3.4 ii, then i)."""
    a, b = let("alpha", alpha(S)), let("beta", beta(S))
    return S * Multivector({"": 1, OMEGA: -(b / (2 * a))}) / root(a)


def normalize_reciprocal(S, let):
    """The same from one reciprocal r = 1/√α: the inverse of the root is (1 - ½βr²ω) r."""
    r = let("r", 1 / root(let("alpha", alpha(S))))
    q = let("q", let("half_beta", beta(S) / 2) * r * r)
    return (S - S * Multivector({OMEGA: q})) * r


def reverse_over(S, let):
    """S̄ / (S̄S) = S̄ (1 - (β/α) ω) / α."""
    a = let("alpha", alpha(S))
    k = let("k", 1 / a)
    r = let("r", beta(S) * k)
    return k * (~S - (~S * Multivector({OMEGA: r})))
