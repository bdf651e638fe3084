"""Wareham and Lasenby, "Rigid-Body Pose and Position Interpolation using Geometric Algebra".

Every lemma and theorem, and the formulas around them that can be checked. Where a line is wrong as printed, the test
shows that it fails and that the corrected one holds; a comment "Printed:" marks the place, and docs/errata.md lists
them.

The paper's vectors in the basis of algebra.py: n = e∞, n̄ = -2 e0, so e = ½(n + n̄) = ½e∞ - e0 and
ē = ½(n - n̄) = ½e∞ + e0. Then F(x) = ½(x²n + 2x - n̄) is e0 + x + ½x² e∞, the null point of Hunt et al. A rotor R
acts as R x R̃, so R is the reverse of the motor of Hunt et al. that moves points alike.

The exponential is proved to all orders, not to some order of its series. exp(yB) is the one function G of y with
G(0) = 1 and G' = BG; a closed form in y, cos y and sin y is differentiated by the rules y' = 1, cos' = -sin and
sin' = cos. In the same way powers are proved by induction with the exponent a variable. To keep within polynomials,
t is written φu: both sides of every equation are power series in φ and t, so nothing is lost by φ ≠ 0.
"""

import unittest
from fractions import Fraction
from math import factorial

from algebra import Multivector, e, multivector
from polynomial import Polynomial, variables
from tests.symbols import (
    AXIS,
    E123,
    HALF,
    INFINITY,
    SPACE,
    UNIT,
    c,
    differentiated,
    general,
    modulo,
    null_point,
    s,
    substituted,
    unit_motor,
)

N = INFINITY
N_BAR = -2 * e("0")
E_PLUS = HALF * (N + N_BAR)
E_MINUS = HALF * (N - N_BAR)

PHI, Y = variables("phi y")
P = AXIS * E123  # the general 2-blade with P² = -1 of Euclidean space: its plane is normal to the axis
P_REVERSE = -P
RATES = {"y": Polynomial.of(1), "c": -s, "s": c}  # derivatives with respect to y of y, cos y and sin y


def split(v: Multivector):
    """The parts of a Euclidean vector in the plane of P and normal to it."""
    normal = v.inner(AXIS) * AXIS
    return v - normal, normal


U = general("u", SPACE)
U_IN, U_OUT = split(U)
X = general("x", SPACE)


def act(rotor: Multivector, x: Multivector) -> Multivector:
    return rotor * x * ~rotor


def displacement(a: Multivector) -> Multivector:
    """The paper's T_a."""
    return 1 + HALF * N * a


def twist(a: Multivector) -> Multivector:
    """Definition 4, with c and s the cosine and sine of ½ψ."""
    return (c + s * P) * displacement(a)


def exponential() -> Multivector:
    """Theorem 3: exp(φP + tn) with t = φu, c = cos φ and s = sin φ."""
    return (c + s * P) * (1 + PHI * U_OUT * N) + s * U_IN * N


def at_origin(a: Multivector) -> Multivector:
    """The value at y = 0 of a function of y, cos y and sin y."""
    return substituted(a, {"y": 0, "c": 1, "s": 0})


class AlgebraicTestCase(unittest.TestCase):
    """Equality modulo c² + s² = 1 and |a| = 1, which is the meaning of = in the paper's equations."""

    def assert_same(self, a, b, relations=UNIT):
        self.assertEqual(modulo(a, relations), modulo(b, relations))

    def assert_different(self, a, b, relations=UNIT):
        self.assertNotEqual(modulo(a, relations), modulo(b, relations))


class ConventionsTest(AlgebraicTestCase):
    """Sections 1 and 2.1 to 2.3."""

    def test_basis_vectors(self):
        self.assertEqual(E_PLUS * E_PLUS, 1)
        self.assertEqual(E_MINUS * E_MINUS, -1)
        self.assertEqual(E_PLUS.inner(E_MINUS), 0)
        self.assertEqual(N, E_PLUS + E_MINUS)
        self.assertEqual(N_BAR, E_PLUS - E_MINUS)
        for null in (N, N_BAR):
            self.assertEqual(null * null, 0)
        for k in SPACE:
            self.assertEqual(e(k).inner(E_PLUS), 0)
            self.assertEqual(e(k).inner(E_MINUS), 0)

    def embedded(self, x, scale):
        """2λ² F(x)."""
        return x * x * N + 2 * scale * x - scale**2 * N_BAR

    def test_hestenes_mapping_gives_null_vectors(self):
        scale = Polynomial.variable("lambda")
        image = self.embedded(X, scale)
        self.assertEqual(image * image, 0)
        self.assertEqual(HALF * self.embedded(X, 1), null_point(X))

    def test_translation_rotor(self):
        a, scale = general("t", SPACE), Polynomial.variable("lambda")
        T = displacement(a)
        self.assertEqual((N * a) * (N * a), 0)  # so that exp(na/2) = 1 + na/2
        self.assertEqual(act(T, null_point(X)), null_point(X + a))
        # Printed for every λ: F(x + a) = T_a F(x) T̃_a with T_a = 1 + na/2. That is a translation by λa.
        self.assertNotEqual(act(T, self.embedded(X, scale)), self.embedded(X + a, scale))
        self.assertEqual(act(T, self.embedded(X, scale)), self.embedded(X + scale * a, scale))

    def test_rotation_in_a_plane(self):
        e1, e2, B3 = e("1"), e("2"), e("12")
        self.assertEqual(e1 * B3, e2)
        self.assertEqual((e1 + e2) * B3, e2 - e1)
        self.assertEqual(B3 * B3, -1)
        self.assertEqual(c * e1 + s * e2, e1 * (c + s * B3))
        self.assertEqual(e1 * e("21"), -e2)
        self.assertEqual(-e("21") * e1, -e2)
        self.assertEqual(e1 * e("23"), e("23") * e1)

    def test_exponential_of_a_unit_bivector(self):
        G = c + s * P
        self.assertEqual(at_origin(G), 1)
        self.assert_same(differentiated(G, RATES), P * G)

    def test_rotation_rotor(self):
        R = c - s * P  # e^(-Pφ/2)
        plane, normal = split(X)
        self.assert_same(act(R, X), plane * (c * c - s * s + 2 * c * s * P) + normal)
        self.assert_same(~R * R, 1)

    def test_quaternion_units(self):
        # B1, B2, B3 multiply as i, -j, k do: ij = k gives i(-j) = -k, and round the cycle.
        B1, B2, B3 = e("23"), e("31"), e("12")
        for i, minus_j, k in ((B1, B2, B3), (B2, B3, B1), (B3, B1, B2)):
            self.assertEqual(i * i, -1)
            self.assertEqual(i * minus_j, -k)

    def test_quaternion_interpolation_is_rotor_interpolation(self):
        # q0 (q0⁻¹ q1)^λ = (q1 q0⁻¹)^λ q0. With q0⁻¹ q1 = c + sP, q1 q0⁻¹ is c + sQ with Q = q0 P q0⁻¹, of square -1;
        # and a power changes only the angle of c and s, on both sides alike.
        q0, relation = unit_motor("p")
        q0 = q0.only(("", "12", "13", "23"))
        relations = {**relation, **UNIT}
        power, Q = c + s * P, q0 * P * ~q0
        self.assert_same(Q * Q, -1, relations)
        self.assert_same(q0 * power, (c + s * Q) * q0, relations)


class ExponentialTest(AlgebraicTestCase):
    """Sections 2.4 and 2.5."""

    t = general("t", SPACE)
    B = PHI * P + t * N

    def test_relations_used_in_the_proofs(self):
        t, (t_in, t_out) = self.t, split(self.t)
        self.assert_same(P * P, -1)
        self.assertEqual((t * N) * (t * N), 0)
        self.assertEqual(N * P * t, P * N * t)
        self.assertEqual(N * P * t, -P * t * N)
        self.assertEqual(t * N * P * t * N, 0)
        self.assert_same(t * N * P + P * t * N, 2 * P * t_out * N)
        self.assert_same(P * t * N * P, (t_in - t_out) * N)

    def of_powers_of_p(self, name):
        """x + yP: what φ^k P^k and the α of lemma 1 are."""
        x, y = variables(f"{name}x {name}y")
        return x + y * P

    def form_of_lemma_1(self, power, alphas):
        one, two, three, four = alphas
        t = self.t
        return (
            power
            + one * PHI * P * t * N
            + two * PHI**2 * P * t * N * P
            + three * PHI * t * N * P
            + four * t * N
        )

    def test_lemma_1_recurrence_for_the_powers(self):
        zero = [Multivector()] * 4
        self.assertEqual(self.form_of_lemma_1(1, zero), 1)  # k = 0
        self.assertEqual(self.form_of_lemma_1(PHI * P, [*zero[:3], multivector(1)]), self.B)  # k = 1
        # The step: whatever B^(k-1) = power + ..., multiplied by B it has the same form with the new coefficients.
        power = self.of_powers_of_p("q")
        one, two, three, four = (self.of_powers_of_p(f"alpha{k}") for k in range(1, 5))
        before = self.form_of_lemma_1(power, (one, two, three, four))
        after = (-1 * PHI**2 * two, one, four, power - PHI**2 * three)
        self.assert_same(before * self.B, self.form_of_lemma_1(power * PHI * P, after))

    def test_lemma_1_s_first_displayed_step(self):
        power, tn = self.of_powers_of_p("q"), self.t * N
        one, two, three, four = (self.of_powers_of_p(f"alpha{k}") for k in range(1, 5))
        displayed = (
            power * PHI * P
            + one * PHI**2 * P * tn * P
            + two * PHI**3 * P * tn * P * P
            + three * PHI**2 * tn * P * P
            + four * PHI * tn * P
            + power * tn
            + one * PHI * P * tn * tn
            + two * PHI**2 * P * tn * P * tn
            + three * PHI * tn * P * tn
            + four * tn * tn
        )
        self.assert_same(self.form_of_lemma_1(power, (one, two, three, four)) * self.B, displayed)

    def test_lemma_2_coefficients_satisfy_the_recurrence(self):
        # α⁽⁴⁾_k = (φP)^(k-1) - φ² α⁽⁴⁾_(k-2), with (φP)^(k-1) = Q = (φP)² (φP)^(k-3): for k even and for k odd, with k
        # a variable.
        k, Q_before = Polynomial.variable("k"), self.of_powers_of_p("q")  # (φP)^(k-3)
        Q = PHI**2 * P * P * Q_before

        def even(k):
            return k * HALF

        def odd(k):
            return (k + 1) * HALF

        for factor, first, start in ((even, 0, 0), (odd, 1, 1)):
            self.assertEqual(factor(first), start)  # α⁽⁴⁾_0 = 0 and α⁽⁴⁾_1 = 1
            self.assert_same(factor(k) * Q, Q - PHI**2 * (factor(k - 2) * Q_before))

    def even_power(self, k):
        """B^2k of lemma 2 without its factor (-1)^k φ^2k; t = φu."""
        return 1 - k * (U * N * P + P * U * N)

    def odd_power(self, k):
        """B^(2k+1) of lemma 2 without its factor (-1)^k φ^(2k+1)."""
        return P + k * (U * N - P * U * N * P) + U * N

    def test_lemma_2_powers(self):
        # Induction with k a variable: B^0 = 1, B^2k B = B^(2k+1) and B^(2k+1) B = B^(2k+2).
        k, B = Polynomial.variable("k"), P + U * N
        self.assertEqual(self.even_power(0), 1)
        self.assert_same(self.even_power(k) * B, self.odd_power(k))
        self.assert_same(self.odd_power(k) * B, -self.even_power(k + 1))

    def test_theorem_3_s_power_series(self):
        # The coefficients of z^2k of z sin z and of cos z - sinc z, from z f'(z) = Σ 2k f_k z^2k for f = Σ f_k z^2k.
        for k in range(1, 40):
            sign = (-1) ** k
            sine = Fraction((-1) ** (k - 1), factorial(2 * k - 1))  # of z^(2k-1) in sin z
            self.assertEqual(-sine, 2 * k * Fraction(sign, factorial(2 * k)))
            cos, sinc = Fraction(sign, factorial(2 * k)), Fraction(sign, factorial(2 * k + 1))
            self.assertEqual(cos - sinc, 2 * k * Fraction(sign, factorial(2 * k + 1)))

    def test_theorem_3_exponential(self):
        # With B = φ(P + un), exp(B) is the value at y = φ of exp(y(P + un)).
        G = (c + s * P) * (1 + Y * U_OUT * N) + s * U_IN * N
        self.assertEqual(at_origin(G), 1)
        self.assert_same(differentiated(G, RATES), (P + U * N) * G)
        self.assertEqual(substituted(G, {"y": PHI}), exponential())
        # φ = 0 is the translation: sinc 0 = 1, and (tn)² = 0 ends the series.
        self.assertEqual((self.t * N) * (self.t * N), 0)

    def test_theorem_3_s_displayed_steps(self):
        tn = PHI * U * N  # and sinc φ = s/φ
        first = (
            c
            + HALF * s * (tn * P + P * tn)
            + s * (P + U * N)
            + HALF * c * (tn - P * tn * P)
            - HALF * s * (U * N - P * U * N * P)
        )
        second = c + s * PHI * P * U_OUT * N + s * (P + U * N) + (c * PHI - s) * U_OUT * N
        third = c * (1 + PHI * U_OUT * N) + s * P * (1 + PHI * U_OUT * N) + s * U_IN * N
        for line in (first, second, third):
            self.assert_same(line, exponential())

    # From definition 4 on, φ = ½ψ and the bivector is ½ψP + ½tn: with u for ½t/φ = t/ψ. So ½t is φu below.

    def test_definition_4_sense_of_the_twist(self):
        a = Polynomial.variable("h") * AXIS
        plane, normal = split(X)
        backward = plane * (c * c - s * s - 2 * c * s * P) + normal + a
        forward = plane * (c * c - s * s + 2 * c * s * P) + normal + a
        image = act(twist(a), null_point(X))
        # Printed: it rotates by ψ in the plane of P. In the sense of section 2.1, e^(-Pψ/2), it rotates by -ψ.
        self.assert_different(image, null_point(forward))
        self.assert_same(image, null_point(backward))
        self.assert_same(twist(a) * ~twist(a), 1)

    def test_lemma_5_exponential_by_a_twist(self):
        tau = twist(-2 * PHI * U_OUT)
        self.assert_same(exponential(), tau + s * U_IN * N)  # equation (2): sinc(ψ/2) t∥n/2 = s u∥n
        self.assert_same(exponential(), (1 + s * U_IN * N * ~tau) * tau)

    def test_lemma_6_translation_in_the_plane(self):
        tau = twist(-2 * PHI * U_OUT)
        factor = 1 + s * U_IN * N * ~tau
        shift = -2 * s * U_IN * (c - s * P)  # -sinc(ψ/2) t∥ (cos ψ/2 - sin ψ/2 P)
        self.assert_same(shift, modulo(shift, UNIT).only(SPACE))
        self.assert_same(factor, displacement(shift))
        self.assert_same(act(factor, null_point(X)), null_point(X + shift))
        # Its length is that of sinc(ψ/2) t∥ = 2s u∥: t∥ is turned by -½ψ, scaled and reversed.
        self.assert_same(shift * shift, (2 * s) ** 2 * U_IN * U_IN)

    def test_lemma_6_s_proof_multiplies_on_the_right(self):
        # Printed: "multiplying t∥ on the left by P is just a rotation". The formula has P on the right, where the
        # rotation by ½π is the one of section 2.1; on the left it is the opposite one.
        self.assert_same(P * U_IN, -U_IN * P)
        self.assert_different(P * U_IN, U_IN * P)

    def test_action_of_the_exponential(self):
        shift = -2 * s * U_IN * (c - s * P)
        plane, normal = split(X)
        t_out = 2 * PHI * U_OUT
        image = act(exponential(), null_point(X))
        turned = {sign: plane * (c * c - s * s + sign * 2 * c * s * P) + normal for sign in (1, -1)}
        # Printed: it translates along t⊥ and rotates by ψ. It translates by -t⊥ and rotates by -ψ.
        self.assert_different(image, null_point(turned[1] + t_out + shift))
        self.assert_different(image, null_point(turned[-1] + t_out + shift))
        self.assert_different(image, null_point(turned[1] - t_out + shift))
        self.assert_same(image, null_point(turned[-1] - t_out + shift))

    def test_theorem_7_exponential_times_its_reverse_is_one(self):
        R = exponential()
        self.assert_same(R * ~R, 1)

    def test_theorem_7_s_proof_needs_a_half(self):
        R, tau = exponential(), twist(-2 * PHI * U_OUT)
        T = 2 * tau * N * U_IN  # τ n t∥ times φ⁻¹, since t∥ = 2φu∥
        cross = R * ~R - tau * ~tau
        # Each of the cross terms, which cancel: printed sinc T, in fact ½ sinc T. sinc(ψ/2) = s/φ.
        term = tau * ~(s * U_IN * N)
        self.assert_different(term, s * T)
        self.assert_same(term, HALF * s * T)
        self.assert_same(T + ~T, 0)
        self.assert_same(cross, HALF * s * (T + ~T))
        self.assert_same(P * U_IN - U_IN * P_REVERSE, 0)

    def test_theorem_8_exponential_fixes_n(self):
        R = exponential()
        self.assert_same(R * N, (c + s * P) * N)
        self.assert_same(N * R, (c + s * P) * N)
        self.assert_same(act(R, N), N)

    def test_theorem_8_s_proof_names_the_wrong_translation(self):
        # Printed: nτ = n R_(P,ψ) (1 + tn/2). The twist has t⊥; n annihilates the difference.
        tau, R = twist(-2 * PHI * U_OUT), c + s * P
        self.assert_same(tau, R * (1 + PHI * U_OUT * N))
        self.assert_different(tau, R * (1 + PHI * U * N))
        self.assert_same(N * tau, N * R * (1 + PHI * U * N))


class LogarithmTest(AlgebraicTestCase):
    """Section 2.6."""

    def grade(self, a, size):
        """The part of one grade. Rotors have no e0, and the basis vectors e1 e2 e3 n are orthogonal."""
        a = modulo(a, UNIT)
        self.assertFalse(any("0" in blade for blade in a.parts))
        return a.only([blade for blade in a.parts if len(blade) == size])

    def test_grades_of_the_exponential(self):
        R = exponential()  # c, s of ψ/2 = φ; ½t = φu
        t_in_over_phi, t_out = 2 * U_IN, 2 * PHI * U_OUT
        self.assert_same(self.grade(R, 0), c)
        # Printed without the ½: sin(ψ/2)P + cos(ψ/2) t⊥n + sinc(ψ/2) t∥n, and sin(ψ/2) P t⊥n.
        self.assert_different(self.grade(R, 2), s * P + c * t_out * N + s * t_in_over_phi * N)
        self.assert_different(self.grade(R, 4), s * P * t_out * N)
        self.assert_same(self.grade(R, 2), s * P + HALF * c * t_out * N + HALF * s * t_in_over_phi * N)
        self.assert_same(self.grade(R, 4), HALF * s * P * t_out * N)

    def test_theorem_9_logarithm(self):
        # ab = φP, c⊥ = φu⊥ and c∥ = φu∥; ‖ab‖ = φ for 0 <= φ <= π, and sinc‖ab‖ = s/φ. Each formula is multiplied
        # by its denominator.
        R, ab = exponential(), PHI * P
        two, four = self.grade(R, 2), self.grade(R, 4)
        self.assert_same(-1 * ab * ab, PHI**2)
        self.assert_same(self.grade(R, 0), c)
        # A trivector's product with a vector that lowers the grade is the symmetric one, the inner product here.
        self.assert_same((two * N).inner(E_PLUS), s * P)
        self.assert_same(-1 * ab * four, PHI * s * PHI * U_OUT * N)
        self.assert_same(-1 * ab * self.grade(ab * two, 2), PHI * s * PHI * U_IN * N)
        # The sum is the bivector: ℓ(exp B) = B.
        self.assert_same(ab + PHI * U_OUT * N + PHI * U_IN * N, PHI * (P + U * N))

    def test_theorem_9_s_displayed_steps(self):
        R, ab = exponential(), PHI * P
        sinc_times_phi = s
        two, four = self.grade(R, 2), self.grade(R, 4)
        self.assert_same(PHI * two, c * PHI * PHI * U_OUT * N + sinc_times_phi * (ab + PHI * U_IN * N))
        self.assert_same(PHI * two * N, sinc_times_phi * ab * N)
        self.assert_same(PHI * four, sinc_times_phi * ab * PHI * U_OUT * N)
        bracket = ab * PHI * U_IN * N - PHI**2
        self.assert_same(PHI * ab * two, PHI * c * ab * PHI * U_OUT * N + sinc_times_phi * bracket)
        self.assert_same(PHI * self.grade(ab * two, 2), sinc_times_phi * ab * PHI * U_IN * N)

    def test_theorem_9_says_nothing_about_translations(self):
        # Printed for every displacement rotor. With ab = 0 both c⊥n and c∥n are 0/0; the logarithm is ⟨R⟩_2 there.
        tn = general("t", SPACE) * N
        R, ab = 1 + tn, Multivector()
        self.assertEqual((self.grade(R, 2) * N).inner(E_PLUS), ab)
        self.assertEqual(ab * self.grade(R, 4), 0)
        self.assertEqual(ab * self.grade(ab * self.grade(R, 2), 2), 0)
        self.assertEqual(self.grade(R, 2), tn)
        self.assertEqual(tn * tn, 0)  # exp(⟨R⟩_2) = 1 + ⟨R⟩_2 = R


class InterpolationTest(AlgebraicTestCase):
    """Sections 3 and 4."""

    def chain(self):
        pairs = [unit_motor(name) for name in ("p", "q")]
        relations = {name: square for _, relation in pairs for name, square in relation.items()}
        return [rotor for rotor, _ in pairs], relations

    def test_chained_rotors(self):
        # ΔR_i R_i is R_(i+1). Printed: n poses are {R1, ΔR1 R1, ..., ΔRn Rn}; the last is ΔR_(n-1) R_(n-1). Printed:
        # exp(λ ℓ(ΔR_(i-1))) R_(i-1) lies between R_i and R_(i+1); it goes from R_(i-1) to R_i.
        (before, now), relations = self.chain()
        step = now * ~before
        self.assert_same(step * before, now, relations)  # λ = 1
        self.assert_different(step * before, before, relations)
        self.assert_different(step * now, now, relations)
        self.assert_same(step * ~step, 1, relations)

    def test_quadratic_interpolation(self):
        B1, B2, B3 = (general(name, ("12", "13", "23", "1i", "2i", "3i")) for name in ("B1_", "B2_", "B3_"))
        x = Polynomial.variable("lambda")
        B = (HALF * (B3 + B1) - B2) * x**2 + HALF * (B3 - B1) * x + B2
        for value, expected in ((-1, B1), (0, B2), (1, B3)):
            self.assertEqual(substituted(B, {"lambda": value}), expected)

    def test_section_4_1_translations_do_not_commute_with_the_exponential(self):
        # Printed: "any Euclidean pure-translation rotor will commute with it". Only those normal to P do.
        a = general("t", SPACE)
        a_in, a_out = split(a)
        R, T = exponential(), displacement(a)
        self.assert_different(T * R, R * T)
        self.assert_same(T * R - R * T, s * N * a_in * P)
        self.assert_same(displacement(a_out) * R, R * displacement(a_out))
        # Moving the origin changes the bivector: t becomes t - ψ a∥P, here ½t and φ = ½ψ.
        t = general("u", SPACE)
        self.assert_same(act(T, PHI * P + HALF * t * N), PHI * P + HALF * (t - 2 * PHI * a_in * P) * N)

    # Of section 4.1: P = ab with orthonormal a, b; t∥ = t^a a + t^b b; c, s of ½λψ. WLOG a, b, t⊥ along e1, e2, e3.
    # 1/ψ is written r, and t^a = α cos β1, t^b = -α sin β1.

    a, b = e("1"), e("2")
    alpha, r, h, x = variables("alpha r h lambda")
    cos_beta, sin_beta = variables("cb sb")
    t_a, t_b = alpha * cos_beta, -1 * alpha * sin_beta
    unit = {"s": 1 - c * c, "sb": 1 - cos_beta * cos_beta}

    def path(self):
        """t'∥ at λ, from the formula of lemma 6: 2 s r λ⁻¹ is sinc(½λψ)."""
        return -2 * s * self.r * (self.t_a * self.a + self.t_b * self.b) * (c - s * self.a * self.b)

    def test_section_4_1_position_of_the_frame(self):
        # exp(λB) with ½λψ the angle of c and s: as exponential() for P = ab, with λt⊥ = λh e3.
        a, b, t_in, t_out = self.a, self.b, self.t_a * self.a + self.t_b * self.b, self.x * self.h * e("3")
        R = (c + s * a * b) * (1 + HALF * t_out * N) + s * self.r * t_in * N
        image = act(R, null_point(Multivector()))
        # Printed: r_λ = ... + λt⊥. It is ... - λt⊥.
        self.assert_different(image, null_point(self.path() + t_out), self.unit)
        self.assert_same(image, null_point(self.path() - t_out), self.unit)

    def test_section_4_1_missing_brackets(self):
        a, b, t_a, t_b = self.a, self.b, self.t_a, self.t_b
        first, second = c * (t_a * a + t_b * b), s * (t_b * a - t_a * b)
        by_axes = a * (t_a * c + t_b * s), b * (t_b * c - t_a * s)
        factor = -2 * s * self.r
        for left, right in ((first, second), by_axes):
            # Printed without the brackets round the sum.
            self.assert_different(self.path(), factor * left + right, self.unit)
            self.assert_same(self.path(), factor * (left + right), self.unit)

    def test_section_4_1_harmonic_addition(self):
        a, b, cb, sb = self.a, self.b, self.cos_beta, self.sin_beta
        # The angle β2 = β1 + ½π, as the paper says below, has tan β2 = +t^a/t^b.
        cos_beta_2, sin_beta_2 = -sb, cb
        factor = -2 * s * self.r * self.alpha
        line = factor * ((c * cb - s * sb) * a + (c * cos_beta_2 - s * sin_beta_2) * b)
        self.assert_same(self.path(), line, self.unit)
        # Printed: tan β2 = -t^a/t^b.
        self.assert_different(sin_beta_2 * self.t_b, -1 * cos_beta_2 * self.t_a, self.unit)
        self.assert_same(sin_beta_2 * self.t_b, cos_beta_2 * self.t_a, self.unit)
        self.assert_same(sb * self.t_a, -1 * cb * self.t_b, self.unit)  # tan β1 = -t^b/t^a

    def test_section_4_1_path_is_a_helix(self):
        a, b, cb, sb = self.a, self.b, self.cos_beta, self.sin_beta
        cos, sin = c * c - s * s, 2 * c * s  # of λψ
        turned = (sin * cb + cos * sb) * a + (cos * cb - sin * sb) * b
        centre = self.alpha * self.r * (sb * a + cb * b)
        self.assert_same(self.path(), centre - self.alpha * self.r * turned, self.unit)
        from_axis = self.path() - centre
        self.assert_same(from_axis * from_axis, (self.alpha * self.r) ** 2, self.unit)

    def test_section_4_1_limit_without_rotation(self):
        # Printed: r_λ = λt⊥ as ψ → 0. The exponential is 1 + ½λtn there: a translation by -λ(t∥ + t⊥).
        t = general("t", SPACE)
        t_in, t_out = t.only("12"), t.only("3")  # P = e12
        R = 1 + HALF * self.x * t * N
        image = act(R, null_point(Multivector()))
        self.assertNotEqual(image, null_point(self.x * t_out))
        self.assertEqual(image, null_point(-1 * self.x * (t_in + t_out)))
        # The path formula has this limit: the derivative at y = ½λψ = 0 of -2 s (...), with r = λ/2y.
        path = differentiated(self.path(), RATES)
        limit = HALF * self.x * substituted(path, {"c": 1, "s": 0, "r": 1})
        self.assertEqual(limit, -1 * self.x * (self.t_a * self.a + self.t_b * self.b))

    def test_section_4_2_pose_of_the_frame(self):
        direction = general("x", SPACE)
        R = exponential()
        turned = act(c + s * P, direction)
        image = modulo(act(R, direction), UNIT)
        self.assertEqual(image, image.only((*SPACE, "i")))
        self.assert_same(image.only(SPACE), turned)


if __name__ == "__main__":
    unittest.main()
