"""The lecture notes on interpolating rotations: the worked slerp example and the formulas around it.

A quaternion is a tuple (x, y, z, w) with the scalar last, as in the notes; a rotation by θ about the unit vector k is
(sin(½θ) k, cos(½θ)). Decimals are compared with values of 50 digits. "Printed:" marks what does not hold as written;
docs/errata.md lists it.
"""

import math
import unittest
from fractions import Fraction

from polynomial import variables
from tests.trigonometry import DIGITS, PI, cosine, decimal, sine

TINY = Fraction(1, 10 ** (DIGITS - 5))
DEGREE = PI / 180


def about_z(theta):
    return (Fraction(0), Fraction(0), sine(theta / 2), cosine(theta / 2))


def slerp(first, last, omega, t):
    """Ω is given, as in the worked example: cos Ω = q1·q2."""
    weights = sine(omega * (1 - t)) / sine(omega), sine(omega * t) / sine(omega)
    return tuple(weights[0] * x + weights[1] * y for x, y in zip(first, last))


def rotate(q, v):
    """The rotation of a vector by a unit quaternion: q v q⁻¹, multiplied out."""
    x, y, z, w = q
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return tuple(sum(m * n for m, n in zip(row, v)) for row in rows)


class SlerpNotesTest(unittest.TestCase):
    def assert_close(self, a, b):
        for x, y in zip(a, b):
            self.assertLess(abs(x - y), TINY)

    def test_step_1_quaternions(self):
        # Printed, in our copy: q1 = [sin(ω) k, cos(ω)] for the rotation of 0 degrees. It is [sin(0) k, cos(0)].
        self.assertEqual(about_z(Fraction(0)), (0, 0, 0, 1))
        self.assertNotEqual(about_z(2 * 45 * DEGREE), (0, 0, 0, 1))  # ω = 45 degrees
        quarter = about_z(90 * DEGREE)
        self.assert_close((2 * quarter[2] ** 2, 2 * quarter[3] ** 2), (1, 1))  # both are √2/2
        self.assert_close(rotate(quarter, (1, 0, 0)), (0, 1, 0))

    def test_step_2_angle(self):
        first, last = about_z(Fraction(0)), about_z(90 * DEGREE)
        scalar_product = sum(x * y for x, y in zip(first, last))
        self.assert_close((scalar_product,), (cosine(45 * DEGREE),))
        self.assert_close((2 * scalar_product**2,), (1,))

    def test_step_3_slerp_half_way(self):
        first, last = about_z(Fraction(0)), about_z(90 * DEGREE)
        q = slerp(first, last, 45 * DEGREE, Fraction(1, 2))
        self.assertEqual([decimal(x, 4) for x in q[2:]], ["0.3827", "0.9239"])
        self.assertEqual(q[:2], (0, 0))
        # The displayed last line: √2 sin 22.5° (q1 + q2), with 1/sin 45° for √2.
        factor = sine(Fraction(45, 2) * DEGREE) / sine(45 * DEGREE)
        self.assert_close(q, [factor * (x + y) for x, y in zip(first, last)])
        self.assert_close((sine(45 * DEGREE) ** -2,), (2,))
        self.assert_close(q, about_z(45 * DEGREE))

    def test_check_of_the_result(self):
        # arccos 0.9239 ≈ 22.5°: the cosine is decreasing, and 22.49° and 22.51° are on either side.
        self.assertGreater(cosine(Fraction(2249, 100) * DEGREE), Fraction("0.9239"))
        self.assertLess(cosine(Fraction(2251, 100) * DEGREE), Fraction("0.9239"))
        self.assertEqual(decimal(sine(Fraction(45, 2) * DEGREE), 4), "0.3827")
        self.assertEqual(decimal(Fraction("0.9239") ** 2 + Fraction("0.3827") ** 2, 4), "1.0001")

    def test_slerp_keeps_unit_length(self):
        first, last = about_z(Fraction(0)), about_z(90 * DEGREE)
        for k in range(9):
            q = slerp(first, last, 45 * DEGREE, Fraction(k, 8))
            self.assert_close((sum(x * x for x in q),), (1,))
            self.assert_close(q, about_z(Fraction(90 * k, 8) * DEGREE))  # and constant speed

    def test_normalised_linear_interpolation_has_no_constant_speed(self):
        first, last = about_z(Fraction(0)), about_z(90 * DEGREE)
        q = [Fraction(3, 4) * x + Fraction(1, 4) * y for x, y in zip(first, last)]
        length_squared = sum(x * x for x in q)
        constant_speed = about_z(Fraction(90, 4) * DEGREE)
        self.assertGreater(abs(q[2] ** 2 / length_squared - constant_speed[2] ** 2), Fraction(1, 1000))

    def test_clamping(self):
        # Printed: "potential NaN when cos(q1, q2) ∈ [-1, 1]". It is outside of [-1, 1] that arccos has no value.
        for inside in (-1.0, 0.0, 1.0):
            self.assertFalse(math.isnan(math.acos(inside)))
        for outside in (1.0 + 2.0**-52, -1.0 - 2.0**-52):
            with self.assertRaises(ValueError):
                math.acos(outside)

    def test_negated_quaternion_is_the_same_rotation(self):
        q, v = variables("x y z w"), variables("a b c")
        self.assertEqual(rotate(q, v), rotate(tuple(-x for x in q), v))

    def test_euler_angles_take_the_long_way(self):
        # From -170 to 160 degrees about z: 330 degrees by the numbers, 30 degrees the other way.
        start, end = about_z(-170 * DEGREE), about_z(160 * DEGREE)
        back = about_z(-30 * DEGREE)
        self.assert_close(rotate(back, rotate(start, (1, 0, 0))), rotate(end, (1, 0, 0)))
        self.assertLess(sum(x * y for x, y in zip(start, end)), 0)  # q1·q2 < 0: negate one of them

    def test_origin_of_a_frame(self):
        # Printed: d = (5, 2, 0), R = I, and the origin p of F1 is (10, 0, 0) in F1 and (5, 2, 0) in F0.
        def in_frame_0(p):
            return tuple(x + d for x, d in zip(p, (5, 2, 0)))

        self.assertNotEqual(in_frame_0((10, 0, 0)), (5, 2, 0))
        self.assertEqual(in_frame_0((0, 0, 0)), (5, 2, 0))

    def test_homogeneous_coordinates(self):
        a, b, c, x, y, z = variables("a b c x y z")
        matrix = ((1, 0, 0, a), (0, 1, 0, b), (0, 0, 1, c), (0, 0, 0, 1))

        def times(column):
            return [sum((m * n for m, n in zip(row, column)), 0) for row in matrix]

        self.assertEqual(times((x, y, z, 1)), [x + a, y + b, z + c, 1])
        self.assertEqual(times((x, y, z, 0)), [x, y, z, 0])


if __name__ == "__main__":
    unittest.main()
