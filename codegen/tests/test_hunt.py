"""Hunt, Mullineux, Cripps and Cross, "Free-form additive motions using conformal geometric algebra" (2017).

Every lemma, corollary and theorem of sections 2 to 4 and every decimal printed with the figures, one test a
statement. Coefficients are polynomials in named variables, so that `assertEqual` is a proof for all values of them.
Where the paper's line is wrong as printed, the test shows that it fails and that the corrected line holds; a comment
"Printed:" marks the place, and docs/errata.md lists them.
"""

import unittest
from fractions import Fraction
from itertools import product
from math import comb

from algebra import BLADES, OMEGA, Multivector, e, multivector, project, transform
from polynomial import Polynomial, variables
from tests.symbols import (
    AXIS,
    E123,
    HALF,
    INFINITY,
    MOTOR,
    SPACE,
    UNIT,
    c,
    general,
    modulo,
    motor,
    null_point,
    point,
    s,
    substituted,
    translation,
    unit_motor,
)
from tests.trigonometry import PI, cosine, decimal, sine

W = e(OMEGA)  # the paper's ω
E0 = e("0")
ODD = tuple(blade for blade in BLADES if len(blade) % 2)
EVEN = tuple(blade for blade in BLADES if len(blade) % 2 == 0)
ROTATION = ("", "12", "13", "23")
TURN = modulo(multivector(c * c - s * s), {})[""], 2 * c * s  # cos θ, sin θ from c = cos ½θ, s = sin ½θ


def cross(a: Multivector, b: Multivector) -> Multivector:
    """The vector product of Euclidean space, by coordinates."""
    return Multivector(
        {
            "1": a["2"] * b["3"] - a["3"] * b["2"],
            "2": a["3"] * b["1"] - a["1"] * b["3"],
            "3": a["1"] * b["2"] - a["2"] * b["1"],
        }
    )


def dot(a: Multivector, b: Multivector):
    """The scalar product of Euclidean space, by coordinates."""
    return sum(a[k] * b[k] for k in SPACE)


def rotated(p: Multivector) -> Multivector:
    """p turned about the axis a by Rodrigues' formula, right-handed, through the angle of c and s."""
    cos, sin = TURN
    return cos * p + sin * cross(AXIS, p) + (1 - cos) * dot(AXIS, p) * AXIS


def determinant(rows):
    if not rows:
        return Polynomial.of(1)
    first, *rest = rows
    minors = ([row[:k] + row[k + 1 :] for row in rest] for k in range(len(first)))
    return sum((-1) ** k * x * determinant(minor) for k, (x, minor) in enumerate(zip(first, minors)))


class ConformalGeometricAlgebraTest(unittest.TestCase):
    """Section 2."""

    def assert_in_span(self, elements, blades):
        for element in elements:
            self.assertEqual(element, element.only(blades))

    def test_lemma_2_1_inner_and_outer_products_are_the_scalar_and_vector_products(self):
        a, b = general("a", SPACE), general("b", SPACE)
        self.assertEqual(a.inner(b), dot(a, b))
        self.assertEqual(-a.outer(b) * E123, cross(a, b))

    def test_lemma_2_1_inner_product_does_not_see_e_infinity(self):
        a, b = general("a", (*SPACE, "i")), general("b", (*SPACE, "i"))
        self.assertEqual(a.inner(b), dot(a, b))

    def test_reverse_of_a_product(self):
        a, b = general("a", BLADES[:16]), general("b", BLADES[16:])
        self.assertEqual(~(a * b), ~b * ~a)

    def test_equation_2_reverse_of_e0i(self):
        self.assertEqual(~e("0i"), -2 - e("0i"))

    def test_lemma_2_2_reverse_preserves_parity(self):
        self.assert_in_span([~general("a", EVEN)], EVEN)

    def test_lemma_2_2_i_reverse_of_an_odd_element_is_odd(self):
        self.assert_in_span([~general("a", ODD)], ODD)

    # In (ii) to (iv): an element with ā = a is ½(a + ā), and one with ā = -a is ½(a - ā). So the elements with
    # ā = ±a among the combinations of some blades are the span of A ± Ā for these blades A.

    def test_lemma_2_2_ii_odd_elements_equal_to_their_reverse(self):
        fixed = [e(blade) + ~e(blade) for blade in ODD]
        self.assert_in_span(fixed, ("0", "1", "2", "3", "i", "123", "0123i"))
        # Sharper: e123 and e0123∞ occur only together, as in the paper's example.
        example = e("123") - e("0123i")
        self.assertEqual(~example, example)
        self.assertNotEqual(~e("123"), e("123"))
        for element in fixed:
            self.assertEqual(element["123"], -element["0123i"])

    def test_lemma_2_2_iii_odd_0_free_elements_equal_to_their_reverse_are_vectors(self):
        blades = [blade for blade in ODD if "0" not in blade]
        self.assert_in_span([e(blade) + ~e(blade) for blade in blades], (*SPACE, "i"))

    def test_lemma_2_2_iv_odd_0_free_elements_equal_to_minus_their_reverse_are_trivectors(self):
        blades = [blade for blade in ODD if "0" not in blade]
        self.assert_in_span([e(blade) - ~e(blade) for blade in blades], ("123", "12i", "13i", "23i"))

    def test_embedding_e_1_is_null(self):
        x, y, z = variables("x y z")
        p = x * e("1") + y * e("2") + z * e("3")
        square = x * x + y * y + z * z
        # Printed: E_1(x, y, z) = e0 + x e1 + y e2 + z e3 + ½(x² + y² + z²)² e∞.
        printed = E0 + p + HALF * square**2 * INFINITY
        corrected = E0 + p + HALF * square * INFINITY
        self.assertNotEqual(printed * printed, 0)
        self.assertEqual(corrected * corrected, 0)
        self.assertEqual(corrected, null_point(p))

    def test_lemma_2_3_i_equivalent_vectors_differ_by_a_multiple_of_e_infinity(self):
        u, v = general("u", "0123i"), general("v", "0123i")
        self.assertEqual(project(u) - project(v), project(u - v))
        self.assertEqual((u - v) - project(u - v), (u["i"] - v["i"]) * INFINITY)
        self.assertEqual(project(INFINITY), 0)

    def test_lemma_2_3_ii_a_finite_vector_has_one_equivalent_null_vector(self):
        v, beta = general("v", "0123"), Polynomial.variable("beta")
        w = v + beta * INFINITY
        self.assertEqual(v.inner(INFINITY), -v["0"])
        self.assertEqual(w * w, v * v + 2 * beta * v.inner(INFINITY))
        # w² = v² - 2βα0 is linear in β, and the factor of β is not zero: one solution, β = v²/2α0.
        self.assertEqual(w * w, v * v - 2 * beta * v["0"])
        self.assertEqual(v * v, dot(v, v))
        solution = 2 * v["0"] * v + v * v * INFINITY  # 2α0 w
        self.assertEqual(solution * solution, 0)


class TransformTest(unittest.TestCase):
    """Section 3."""

    def test_image_of_a_vector_equals_its_own_reverse(self):
        S, v = general("S", EVEN), general("v", "0123i")
        image = ~S * v * S
        self.assertEqual(~image, image)
        self.assertEqual(image, image.only(ODD))
        # Printed, in our copy: the reverse of S̄vS is first written with both bars on the left factor: S v̄ S̄.
        self.assertNotEqual(~image, S * ~v * ~S)
        self.assertEqual(~image, ~S * ~v * S)

    def test_lemma_3_1_transform_is_linear(self):
        S, u, v = general("S", EVEN), general("u", "0123i"), general("v", "0123i")
        x, y = variables("x y")
        self.assertEqual(transform(S, x * u + y * v), x * transform(S, u) + y * transform(S, v))

    def test_equation_4_is_equation_3(self):
        S = motor("S")
        mu, nu, b = S[""], S[OMEGA], S.only(("12", "13", "23"))
        v = S["1i"] * e("1") + S["2i"] * e("2") + S["3i"] * e("3")
        self.assertEqual(S, mu + b + v * INFINITY + nu * W)
        self.assertEqual(~S, mu - b - v * INFINITY + nu * W)

    def test_lemma_3_2_e_infinity_is_mapped_to_a_multiple_of_itself(self):
        S = motor("S")
        p = S.only(ROTATION)
        self.assertEqual(~S * INFINITY * S, (~p * p) * INFINITY)
        self.assertEqual(~p * p, (~S * S)[""])  # so that the lemma's a is the scalar α of lemma 3.3
        self.assertEqual(transform(S, INFINITY), 0)

    def test_lemma_3_2_equivalent_vectors_have_equivalent_images(self):
        S, u = motor("S"), general("u", "0123i")
        v = u + Polynomial.variable("x") * INFINITY
        self.assertEqual(transform(S, u), transform(S, v))

    def test_lemma_3_3_reverse_times_element_is_a_pseudoscalar(self):
        S = motor("S")
        mu, nu, b = S[""], S[OMEGA], S.only(("12", "13", "23"))
        v = S["1i"] * e("1") + S["2i"] * e("2") + S["3i"] * e("3")
        zeta = b.inner(v)["123"]
        self.assertEqual(b.inner(v), zeta * E123)
        self.assertEqual(~S * S, mu * mu - b * b + 2 * mu * nu * W - 2 * b.inner(v) * INFINITY)
        alpha = sum(S[blade] ** 2 for blade in ROTATION)  # a sum of squares: never negative
        beta = 2 * mu * nu - 2 * zeta
        self.assertEqual(~S * S, alpha + beta * W)
        self.assertEqual(S * ~S, alpha + beta * W)

    def test_lemma_3_3_zero_alpha_is_the_zero_map(self):
        # α is a sum of squares: it is zero only if the scalar and the bivector part are.
        v, nu = general("v", SPACE), Polynomial.variable("nu")
        a = v + nu * E123
        S = a * INFINITY
        self.assertEqual(S, v * INFINITY + nu * W)
        self.assertEqual(~S * S, 0)
        self.assertEqual(~S * E0 * S, 2 * (~a * a) * INFINITY)
        for vector in (*SPACE, "i"):
            self.assertEqual(~S * e(vector) * S, 0)
        self.assertEqual(transform(S, general("u", "0123i")), 0)

    def test_lemma_3_4_i_inverse_of_a_pseudoscalar(self):
        alpha, beta = variables("alpha beta")
        inverse_times_alpha_squared = alpha - beta * W
        self.assertEqual((alpha + beta * W) * inverse_times_alpha_squared, alpha**2)

    def test_lemma_3_4_ii_square_root_of_a_pseudoscalar(self):
        r, beta = variables("r beta")  # r = √α
        alpha = r * r
        root_times_r = alpha + HALF * beta * W
        self.assertEqual(root_times_r * root_times_r, r * r * (alpha + beta * W))

    def test_lemma_3_5_transform_of_a_product_is_the_composition(self):
        U, V, v = motor("U"), motor("V"), general("v", "0123i")
        self.assertEqual(transform(U * V, v), transform(V, transform(U, v)))  # U acts first
        self.assertNotEqual(transform(U * V, v), transform(U, transform(V, v)))

    def test_lemma_3_5_what_the_projection_discards_stays_discarded(self):
        V = motor("V")
        p = V.only(ROTATION)
        q = V["1i"] * e("1") + V["2i"] * e("2") + V["3i"] * e("3") + V[OMEGA] * E123
        self.assertEqual(V, p + q * INFINITY)
        self.assertEqual(~V, ~p - ~q * INFINITY)
        self.assertEqual(~V * INFINITY * V, ~p * p * INFINITY)
        trivector = ~V * E123 * V
        self.assertEqual(~trivector, -trivector)
        self.assertEqual(trivector, trivector.only(("123", "12i", "13i", "23i")))
        # Printed: p̄p e0123∞ + 2 q̄q e123∞, of which the second term is even and the rest odd.
        image = ~V * e("0123i") * V
        self.assertNotEqual(image, ~p * p * e("0123i") + 2 * ~q * q * W)
        self.assertEqual(image, ~p * p * e("0123i") + 2 * ~q * p * W)
        for discarded in (INFINITY, E123, e("0123i")):
            self.assertEqual(transform(V, discarded), 0)

    def test_lemma_3_6_pseudoscalars_act_as_the_identity(self):
        alpha, beta = variables("alpha beta")
        S, v = alpha + beta * W, general("v", "0123")
        for k in SPACE:
            self.assertEqual(e(k).inner(W), 0)
            self.assertEqual(W * e(k) * W, 0)
        self.assertEqual(E0.inner(W), -E123 + e("0123i"))
        self.assertEqual(W * E0 * W, 2 * INFINITY)
        image = ~S * v * S
        first_terms = alpha**2 * v + 2 * alpha * beta * v["0"] * (-E123 + e("0123i"))
        # Printed: the last term is 2βγ0 e∞.
        self.assertNotEqual(image, first_terms + 2 * beta * v["0"] * INFINITY)
        self.assertEqual(image, first_terms + 2 * beta**2 * v["0"] * INFINITY)
        self.assertEqual(transform(S, v), alpha**2 * v)  # (i), and (ii) after division by the e0 part
        zero = beta * W
        self.assertEqual(transform(zero, general("u", "0123i")), 0)  # (iii)

    def test_pseudoscalars_commute_with_motors(self):
        alpha, beta = variables("alpha beta")
        S = motor("S")
        self.assertEqual((alpha + beta * W) * S, S * (alpha + beta * W))

    def test_corollary_3_7_normalisation_by_a_pseudoscalar(self):
        S, v = motor("S"), general("v", "0123i")
        square = ~S * S
        alpha, beta = square[""], square[OMEGA]
        # λ = (α - ½βω) α^(-3/2) is the inverse of the square root: lemma 3.4. Without the power of α:
        unscaled = alpha - HALF * beta * W
        self.assertEqual(~(unscaled * S) * (unscaled * S), alpha**3)
        self.assertEqual(transform(unscaled * S, v), alpha**2 * transform(S, v))

    def test_normalised_motors_are_rotation_times_translation(self):
        S = motor("S")
        square = ~S * S
        p = S.only(ROTATION)
        rest = ~p * S - square[""] - HALF * square[OMEGA] * W
        self.assertEqual(rest, rest.only(("1i", "2i", "3i")))
        # With S̄S = 1, that is α = 1 and β = 0, this reads p̄S = 1 + t e∞, so S = p (1 + t e∞) with p̄p = 1.
        self.assertEqual(~p * p, square[""])

    def test_theorem_3_8_motors_are_rigid_body_transforms(self):
        S = motor("S")
        alpha = (~S * S)[""]
        columns = [transform(S, e(k)) for k in SPACE]
        for column in columns:
            self.assertEqual(column["0"], 0)
        self.assertEqual(transform(S, E0)["0"], alpha)
        # After division by the e0 part α: orthogonal and, which the paper leaves out, not a reflection.
        for i, j in product(range(3), repeat=2):
            self.assertEqual(dot(columns[i], columns[j]), alpha**2 if i == j else 0)
        self.assertEqual(determinant([[column[k] for k in SPACE] for column in columns]), alpha**3)

    def test_theorem_3_8_s_proof_for_normalised_motors(self):
        S, unit = unit_motor("S")
        a, b = general("a", SPACE), general("b", SPACE)
        image_of_a, image_of_b = modulo(~S * a * S, unit), modulo(~S * b * S, unit)
        self.assertEqual(image_of_a, image_of_a.only((*SPACE, "i")))
        self.assertEqual(modulo(image_of_a.inner(image_of_b), unit), dot(a, b))

    def test_lemma_3_9_rotation_about_an_axis_through_the_origin(self):
        b = AXIS * E123
        R = c + s * b
        p = general("p", SPACE)
        self.assertEqual(E123 * E123, -1)
        self.assertEqual(modulo(~b * b, UNIT), 1)
        image = modulo(~R * point(p) * R, UNIT)
        cos, sin = TURN
        lines = (
            E0 + c * c * p + s * s * AXIS * p * AXIS + 2 * c * s * p.outer(AXIS) * E123,
            E0 + cos * p + 2 * s * s * p.inner(AXIS) * AXIS + sin * p.outer(AXIS) * E123,
            E0 + rotated(p),
        )
        for line in lines:
            self.assertEqual(image, modulo(line, UNIT))
        self.assertEqual(p.outer(AXIS) * E123, cross(AXIS, p))
        gamma = Polynomial.variable("gamma")
        self.assertEqual(modulo(~R * point(gamma * AXIS) * R, UNIT), point(gamma * AXIS))

    def test_lemma_3_9_perpendicular_vectors_turn_through_theta(self):
        R = c + s * AXIS * E123
        p = cross(AXIS, general("u", SPACE))  # any vector perpendicular to the axis
        cos, sin = TURN
        self.assertEqual(modulo(~R * point(p) * R, UNIT), modulo(E0 + cos * p + sin * cross(AXIS, p), UNIT))

    def test_lemma_3_10_translation(self):
        t, p = general("t", SPACE), general("p", SPACE)
        T = translation(t)
        self.assertEqual(~T * T, 1)
        self.assertEqual(transform(T, point(p)), point(p + t))
        image = ~T * point(p) * T
        # Printed: e0 + p + t + [t² + (p·t)] e∞.
        self.assertNotEqual(image, E0 + p + t + (t * t + p.inner(t)) * INFINITY)
        self.assertEqual(image, E0 + p + t + (HALF * t * t + p.inner(t)) * INFINITY)

    def test_lemma_3_11_rotation_about_any_axis(self):
        b, q, p = AXIS * E123, general("q", SPACE), general("p", SPACE)
        n = INFINITY
        R = c + s * (b + b.outer(q) * n)
        lines = (
            translation(-q) * (c + s * b) * translation(q),
            (1 - HALF * q * n) * (c + HALF * c * q * n + s * b + HALF * s * b * q * n),
            c
            + (HALF * c * q * n + s * b + HALF * s * b * q * n - HALF * c * q * n)
            - (Fraction(1, 4) * c * q * n * q * n + HALF * s * q * n * b + Fraction(1, 4) * s * q * n * b * q * n),
            c + s * b + HALF * s * b * q * n - HALF * s * q * n * b,
            c + s * b + HALF * s * b * q * n - HALF * s * q * b * n,
        )
        for line in lines:
            self.assertEqual(R, line)
        self.assertEqual(R, R.only(MOTOR))
        self.assertEqual(modulo(~R * R, UNIT), 1)
        self.assertEqual(modulo(transform(R, point(p)), UNIT), modulo(point(q + rotated(p - q)), UNIT))

    def test_lemma_3_12_normalised_motors_map_null_vectors_to_null_vectors(self):
        S, unit = unit_motor("S")
        v = null_point(general("p", SPACE))
        image = modulo(~S * v * S, unit)
        self.assertEqual(image, image.only("0123i"))
        self.assertEqual(modulo(image * image, unit), 0)
        # Printed: "F_S maps null vectors (in RP³ ...) to null vectors". F_S = P(S̄vS) drops the e∞ part and with it
        # the null square; and a vector of RP³, which has no e∞ part, is null only as a multiple of e0.
        projected = project(image)
        self.assertNotEqual(modulo(projected * projected, unit), 0)
        u = general("u", "0123")
        self.assertEqual(u * u, dot(u, u))

    def test_lemma_3_12_s_proof_needs_the_other_product(self):
        # Printed: "By lemma 3.3, S̄v is unity". It is SS̄ that is 1 there.
        S, unit = unit_motor("S")
        v = null_point(general("p", SPACE))
        self.assertNotEqual(modulo(~S * v, unit), 1)
        self.assertEqual(modulo(S * ~S, unit), 1)


def linear(first, last, t):
    """Equation (5)."""
    return (1 - t) * first + t * last


def bezier(controls, t):
    """The Bézier combination Σ (n over i) (1-t)^(n-i) t^i S_i."""
    n = len(controls) - 1
    return sum((comb(n, i) * (1 - t) ** (n - i) * t**i * S for i, S in enumerate(controls)), Multivector())


def de_casteljau(controls, t):
    while len(controls) > 1:
        controls = [linear(a, b, t) for a, b in zip(controls, controls[1:])]
    return controls[0]


def degree_in(name: str, a: Multivector) -> int:
    monomials = (monomial for x in a.parts.values() for monomial in Polynomial.of(x).terms)
    return max(dict(monomial).get(name, 0) for monomial in monomials)


T = Polynomial.variable("t")


class LinearMotionTest(unittest.TestCase):
    """Section 4, equation (5) and figures 1 and 2."""

    def test_equation_5_joins_its_poses(self):
        S = linear(motor("A"), motor("B"), T)
        self.assertEqual(S, S.only(MOTOR))
        self.assertEqual(substituted(S, {"t": 0}), motor("A"))
        self.assertEqual(substituted(S, {"t": 1}), motor("B"))

    def test_lemma_4_1_reduction_to_a_motion_from_the_identity(self):
        # Printed without a condition: with U = S1 S̄0 the motion is (1-t) + tU followed by S0. This needs S̄0S0 = 1.
        S1, p = motor("B"), general("p", "0123")
        S0, unit = unit_motor("A")
        motion = linear(S0, S1, T)
        U = S1 * ~S0
        self.assertEqual(modulo(motion, unit), modulo(linear(1, U, T) * S0, unit))
        bracket = (1 - T) ** 2 * p + (1 - T) * T * (p * U + ~U * p) + T**2 * ~U * p * U
        self.assertEqual(modulo(~motion * p * motion, unit), modulo(~S0 * bracket * S0, unit))
        S0 = motor("A")
        self.assertNotEqual(linear(S0, S1, T), linear(1, S1 * ~S0, T) * S0)

    def screw(self):
        """U = λRT: by Chasles's theorem the general motor, its axis taken as the z axis."""
        x, y, h = variables("x y h")
        scale, R, slide = x + y * W, c + s * e("12"), translation(h * e("3"))
        for left, right in ((R, slide), (scale, R), (scale, slide)):
            self.assertEqual(left * right, right * left)
        return scale * R * slide

    def test_lemma_4_1_paths_lie_on_circular_cylinders(self):
        S, p = linear(1, self.screw(), T), general("p", SPACE)
        image = transform(S, point(p))
        distance = image["1"] ** 2 + image["2"] ** 2
        self.assertEqual(distance, image["0"] ** 2 * (p["1"] ** 2 + p["2"] ** 2))

    def test_lemma_4_1_s_proof_the_axis_is_mapped_to_itself(self):
        S, z = linear(1, self.screw(), T), Polynomial.variable("z")
        on_axis, R = point(z * e("3")), c + s * e("12")
        self.assertEqual(on_axis * R, R * on_axis)
        image = transform(S, on_axis)
        self.assertEqual(image, image.only("03"))

    def test_lemma_4_1_s_proof_points_on_any_axis_commute_with_the_rotation(self):
        b, q, gamma = AXIS * E123, general("q", SPACE), Polynomial.variable("gamma")
        R, on_axis = c + s * (b + b.outer(q) * INFINITY), point(q + gamma * AXIS)
        self.assertEqual(modulo(on_axis * R, UNIT), modulo(R * on_axis, UNIT))

    def test_lemma_4_2_paths_are_quadratic_bezier_curves(self):
        S0, S1, q = motor("A"), motor("B"), general("q", "0123i")
        middle = project(HALF * (~S0 * q * S1 + ~S1 * q * S0))
        curve = bezier([transform(S0, q), middle, transform(S1, q)], T)
        self.assertEqual(transform(linear(S0, S1, T), q), curve)

    def figure_2(self):
        """Its two poses; c and s are the cosine and sine of ½α."""
        cos, sin = TURN
        S0 = 1 + 5 * e("1i") + e("3i")
        S1 = (c + s * e("12")) * (1 + 5 * cos * e("1i") + 5 * sin * e("2i") + 11 * e("3i"))
        return S0, S1

    def test_figure_2_path_of_the_origin_is_a_planar_slice_of_a_cylinder(self):
        S0, S1 = self.figure_2()
        cos, sin = TURN
        self.assertEqual(modulo(transform(S0, E0), UNIT), point(10 * e("1") + 2 * e("3")))
        end = point(10 * cos * e("1") + 10 * sin * e("2") + 22 * e("3"))
        self.assertEqual(modulo(transform(S1, E0), UNIT), modulo(end, UNIT))
        path = modulo(transform(linear(S0, S1, T), E0), UNIT)
        on_cylinder = path["1"] ** 2 + path["2"] ** 2 - 100 * path["0"] ** 2
        self.assertEqual(modulo(multivector(on_cylinder), UNIT), 0)
        self.assertEqual(modulo(multivector(determinant(self.plane_of_figure_2() + [self.row(path)])), UNIT), 0)

    def row(self, p):
        return [p[k] for k in "0123"]

    def plane_of_figure_2(self):
        S0, S1 = self.figure_2()
        middle = project(HALF * (~S0 * E0 * S1 + ~S1 * E0 * S0))
        return [self.row(p) for p in (transform(S0, E0), middle, transform(S1, E0))]

    def test_figure_2_true_helix_is_not_in_that_plane(self):
        angle = 5 * PI / 6
        half = {"c": cosine(angle / 2), "s": sine(angle / 2)}
        rows = [[Polynomial.of(x).substitute(half) for x in row] for row in self.plane_of_figure_2()]
        quarter = [1, 10 * cosine(angle / 4), 10 * sine(angle / 4), 2 + Fraction(20, 4)]
        self.assertGreater(abs(determinant(rows + [quarter]).constant()), 1)
        last = [1, 10 * cosine(angle), 10 * sine(angle), 22]
        self.assertLess(abs(determinant(rows + [last]).constant()), Fraction(1, 10**40))


class FreeFormMotionTest(unittest.TestCase):
    """Section 4, Bézier and B-spline motions and figures 3 to 5."""

    def test_de_casteljau_s_algorithm_is_the_bezier_combination(self):
        for n in range(1, 6):
            controls = [motor(f"S{k}_") for k in range(n + 1)]
            self.assertEqual(de_casteljau(controls, T), bezier(controls, T))

    def test_paths_of_a_motion_of_degree_n_have_degree_2n(self):
        for n in (1, 2):
            controls = [motor(f"S{k}_") for k in range(n + 1)]
            self.assertEqual(degree_in("t", bezier(controls, T)), n)
            self.assertEqual(degree_in("t", transform(bezier(controls, T), E0)), 2 * n)

    def test_figure_3_path_of_the_origin_is_the_viviani_curve(self):
        half = HALF * (e("12") + e("13") + e("2i") + e("3i"))
        S = bezier([multivector(1), 1 + half, 1 + 2 * half + e("23")], T)
        path = transform(S, E0)
        w, x, y, z = (path[k] for k in "0123")
        # The sphere of radius 1 about (-1, 0, 0), and the cylinder through its centre that touches it at the origin.
        self.assertEqual((x + w) ** 2 + y * y + z * z, w * w)
        self.assertEqual((x + HALF * w) ** 2 + y * y, HALF**2 * w * w)
        self.assertEqual(substituted(path, {"t": 0}), E0)
        self.assertEqual(substituted(path, {"t": 1}), 4 * point(e("3") - e("1")))  # the north pole

    def planar(self, name):
        return general(name, ("", "12", "1i", "2i"))

    def test_figure_4_linear_motions_in_a_plane_are_circular_arcs(self):
        S = linear(self.planar("A"), self.planar("B"), T)
        path = transform(S, E0)
        w, x, y = (path[k] for k in "012")
        norm = 4 * (S["1i"] ** 2 + S["2i"] ** 2)
        # x² + y² = w·norm, and w, x, y and norm are quadratic in t: four of them in a space of dimension three. So
        # some A norm + Bx + Cy + Dw is zero: with x/w and y/w, the equation of a circle, or of a line if A = 0.
        self.assertEqual(x * x + y * y, w * norm)
        for quadratic in (w, x, y, norm):
            self.assertEqual(degree_in("t", multivector(quadratic)), 2)

    def test_figure_4_motion_between_poses_of_the_same_rotation_is_straight(self):
        R = c + s * e("12")
        ends = [R * translation(general(name, "12")) for name in "ab"]
        path = modulo(transform(linear(*ends, T), E0), UNIT)
        self.assertEqual(path["0"], 1)
        self.assertEqual(degree_in("t", path), 1)


def b_spline_basis(knots, degree, interval, t):
    """The B-spline basis functions on [t_i, t_i+1], by the recursion of Cox and de Boor.

    That recursion has a superfluous knot more at either end; it is given a repeated one.
    """
    u = [knots[0], *knots, knots[-1]]

    def weight(first, last, numerator):
        return numerator / (last - first) if last != first else Polynomial()

    values = [Polynomial.of(int(k == interval + 1)) for k in range(len(u) - 1)]
    for d in range(1, degree + 1):
        values = [
            weight(u[k], u[k + d], t - u[k]) * values[k]
            + weight(u[k + 1], u[k + d + 1], u[k + d + 1] - t) * values[k + 1]
            for k in range(len(values) - 1)
        ]
    return values


def blossom(controls, knots, degree, interval, t, lower_knot):
    """S(t, ..., t) on the interval [t_i, t_i+1], by the recursion of section 4.

    `lower_knot(i, r)` is the index of the knot in the second weight and in the denominator.
    """
    i = interval

    def pose(below, above):
        """S(t_i-r+1, ..., t_i, t, ..., t, t_i+1, ..., t_i+s) with r knots below and s above."""
        if below + above == degree:
            return controls[i - below + 1]
        first, last = knots[lower_knot(i, below)], knots[i + above + 1]
        return ((last - t) * pose(below + 1, above) + (t - first) * pose(below, above + 1)) / (last - first)

    return pose(0, 0)


def corrected_knot(i, r):
    return i - r


def printed_knot(i, r):
    return i - 1


FIGURE_5_KNOTS = [Fraction(k) for k in (0, 0, 1, 2, 3, 4, 4)]
UNEVEN_KNOTS = [Fraction(k, 2) for k in (0, 1, 1, 4, 5, 9, 9, 12)]


def intervals(knots, degree):
    """The nontrivial intervals on which a motion of that degree is defined."""
    return [i for i in range(degree - 1, len(knots) - degree) if knots[i] < knots[i + 1]]


class BlossomTest(unittest.TestCase):
    """Section 4, the recursion that generates a B-spline motion."""

    cases = tuple(product((FIGURE_5_KNOTS, UNEVEN_KNOTS), (1, 2, 3)))

    def test_number_of_control_poses(self):
        # Printed: "n control poses are required where n = m - d + 1". The labels are those for 0 <= i <= n: n + 1.
        for knots, degree in self.cases:
            m = len(knots) - 1
            labels = [knots[i : i + degree] for i in range(m + 1) if i + degree - 1 <= m]
            n = m - degree + 1
            self.assertNotEqual(len(labels), n)
            self.assertEqual(len(labels), n + 1)
        self.assertEqual(len(figure_5_poses()), len(FIGURE_5_KNOTS) - 2 + 1)

    def test_recursion_is_the_b_spline(self):
        # Printed: the second weight is t - t_(i-1) and the denominator t_(i+s+1) - t_(i-1). Both need t_(i-r).
        for knots, degree in self.cases:
            controls = [Polynomial.variable(f"S{k}") for k in range(len(knots) - degree + 1)]
            for i in intervals(knots, degree):
                basis = b_spline_basis(knots, degree, i, T)
                expected = sum(weight * S for weight, S in zip(basis, controls))
                self.assertEqual(blossom(controls, knots, degree, i, T, corrected_knot), expected)
        knots, degree, i = FIGURE_5_KNOTS, 2, 2
        controls = [Polynomial.variable(f"S{k}") for k in range(6)]
        expected = sum(weight * S for weight, S in zip(b_spline_basis(knots, degree, i, T), controls))
        self.assertNotEqual(blossom(controls, knots, degree, i, T, printed_knot), expected)

    def test_recursion_reproduces_polynomial_motions(self):
        # The labels mean what they say: if the controls are S(u, v) = A + B(u + v) + C uv, then S(t, t) comes out.
        A, B, C = (motor(name) for name in "ABC")
        knots = UNEVEN_KNOTS
        controls = [A + B * (u + v) + C * (u * v) for u, v in zip(knots, knots[1:])]
        for i in intervals(knots, 2):
            self.assertEqual(blossom(controls, knots, 2, i, T, corrected_knot), A + 2 * T * B + T * T * C)
            if knots[i - 1] < knots[i]:
                self.assertNotEqual(blossom(controls, knots, 2, i, T, printed_knot), A + 2 * T * B + T * T * C)

    def test_recursion_on_bezier_knots_is_de_casteljau_s_algorithm(self):
        for degree in range(1, 5):
            knots = [Fraction(0)] * degree + [Fraction(1)] * degree
            controls = [motor(f"S{k}_") for k in range(degree + 1)]
            result = blossom(controls, knots, degree, degree - 1, T, corrected_knot)
            self.assertEqual(result, de_casteljau(controls, T))

    def test_figure_5_starts_and_ends_at_its_first_and_last_pose(self):
        poses = figure_5_poses()
        first, last = intervals(FIGURE_5_KNOTS, 2)[0], intervals(FIGURE_5_KNOTS, 2)[-1]
        for i, t, pose in ((first, 0, poses[0]), (last, 4, poses[-1])):
            self.assertEqual(blossom(poses, FIGURE_5_KNOTS, 2, i, Fraction(t), corrected_knot), pose)


def turn(half_angle: Fraction, plane: str) -> Multivector:
    return cosine(half_angle) + sine(half_angle) * e(plane)


def shift(*offset: int) -> Multivector:
    """The paper's T(p, q, r)."""
    return translation(sum((Fraction(x) * e(k) for x, k in zip(offset, SPACE)), Multivector()))


def figure_5_poses():
    """The control poses of figure 5, from the paper's definitions of R_x, R_y, R_z and T."""

    def about(plane):
        return lambda numerator, denominator: turn(numerator * PI / denominator / 2, plane)

    x, y, z = about("23"), about("31"), about("12")
    return [
        shift(1, 1, 0),
        z(1, 6) * shift(6, 1, 0),
        z(1, 2) * shift(8, 4, 2),
        z(1, 2) * x(1, 4) * shift(8, 6, 4),
        z(1, 2) * y(1, 3) * shift(4, 6, 6),
        z(1, 2) * y(1, 2) * shift(1, 6, 2),
    ]


class PrintedCoefficientsTest(unittest.TestCase):
    """Every decimal printed with the figures, against 50 digits."""

    def assert_printed(self, pose, printed):
        for blade in BLADES:
            if blade in printed:
                places = len(printed[blade].split(".")[1])
                self.assertEqual(decimal(pose[blade], places), printed[blade], f"e{blade}")
            else:
                self.assertEqual(round(pose[blade], 40), 0, f"e{blade}")

    def figure_1(self):
        S0 = turn(PI / 6, "12") * (1 + 4 * e("1i"))
        S1 = turn(-PI / 3, "23") * (1 + 3 * e("2i"))
        return S0, S1

    def test_figure_1(self):
        S0, S1 = self.figure_1()
        self.assert_printed(S0, {"": "0.866", "12": "0.500", "1i": "3.464", "2i": "-2.000"})
        self.assert_printed(S1, {"": "0.500", "23": "-0.866", "2i": "1.500", "3i": "2.598"})

    def test_figure_1_sense_of_the_rotations(self):
        S0, S1 = self.figure_1()
        tiny = Fraction(1, 10**40)

        def assert_close(a, b):
            self.assertTrue(all(abs(x) < tiny for x in (a - b).parts.values()), f"{a} is not {b}")

        third = cosine(PI / 3), sine(PI / 3)
        assert_close(transform(S0, e("1")), third[0] * e("1") + third[1] * e("2"))
        assert_close(transform(S0, E0), point(8 * e("1")))
        # Printed: S1 is a rotation through 2π/3 about the x axis. With lemma 3.9 it is one through -2π/3.
        two_thirds = cosine(2 * PI / 3), sine(2 * PI / 3)
        with self.assertRaises(AssertionError):
            assert_close(transform(S1, e("2")), two_thirds[0] * e("2") + two_thirds[1] * e("3"))
        assert_close(transform(S1, e("2")), two_thirds[0] * e("2") - two_thirds[1] * e("3"))
        assert_close(transform(S1, E0), point(6 * e("2")))

    def figure_4(self):
        half = HALF
        return [
            1 + half * (e("1i") + e("2i")),
            turn(-PI / 12, "12") * (1 + half * (2 * e("1i") + 6 * e("2i"))),
            turn(-PI / 4, "12") * (1 + half * (5 * e("1i") + 6 * e("2i"))),
            turn(-PI / 4, "12") * (1 + half * (8 * e("1i") + 2 * e("2i"))),
        ]

    def test_figure_4(self):
        _, S001, S011, S111 = self.figure_4()
        self.assert_printed(S001, {"": "0.9659", "12": "-0.2588", "1i": "0.1895", "2i": "3.1566"})
        self.assert_printed(S011, {"": "0.7071", "12": "-0.7071", "1i": "-0.3536", "2i": "3.8891"})
        # Printed: the last coefficient is 3.5356. It is 5/√2 = 3.53553...
        last = {"": "0.7071", "12": "-0.7071", "1i": "2.1213", "2i": "3.5355"}
        self.assert_printed(S111, last)
        with self.assertRaises(AssertionError):
            self.assert_printed(S111, {**last, "2i": "3.5356"})

    def test_figure_5(self):
        # Printed: "The control poses for the motion in Figure 4 are the following". They are figure 5's: six, with
        # labels S(0, 0) to S(4, 4) of the knots 0 0 1 2 3 4 4.
        printed = (
            {"": "1.000", "1i": "0.500", "2i": "0.500"},
            {"": "0.966", "12": "0.259", "1i": "3.027", "2i": "-0.293"},
            {"": "0.707", "12": "0.707", "1i": "4.243", "2i": "-1.414", "3i": "0.707", "123i": "0.707"},
            {
                **{"": "0.653", "12": "0.653", "13": "0.271", "23": "0.271"},
                **{"1i": "5.114", "2i": "-0.112", "3i": "-0.588", "123i": "1.577"},
            },
            {
                **{"": "0.612", "12": "0.612", "13": "-0.354", "23": "0.354"},
                **{"1i": "2.001", "2i": "1.673", "3i": "1.484", "123i": "3.605"},
            },
            {
                **{"": "0.500", "12": "0.500", "13": "-0.500", "23": "0.500"},
                **{"1i": "1.250", "2i": "1.750", "3i": "-0.750", "123i": "2.250"},
            },
        )
        for pose, coefficients in zip(figure_5_poses(), printed):
            self.assert_printed(pose, coefficients)
        labels = [(a, b) for a, b in zip(FIGURE_5_KNOTS, FIGURE_5_KNOTS[1:])]
        self.assertEqual(labels, [(0, 0), (0, 1), (1, 2), (2, 3), (3, 4), (4, 4)])
        self.assertEqual(len(labels), len(printed))
        planar = ("", "12", "1i", "2i")
        self.assertTrue(all(pose == pose.only(planar) for pose in self.figure_4()))
        self.assertFalse(all(pose == pose.only(planar) for pose in figure_5_poses()))

    def test_figure_5_s_rotations_are_those_of_lemma_3_9(self):
        for axis, plane in (("1", "23"), ("2", "31"), ("3", "12")):
            self.assertEqual(e(axis) * E123, e(plane))


if __name__ == "__main__":
    unittest.main()
