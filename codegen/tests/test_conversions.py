"""What the conversions mean, proved for all values of their numbers: of motors that need not be normalised."""

from __future__ import annotations

import unittest
from fractions import Fraction

from algebra import transform
from conversions import (
    dual_quaternion_to_motor,
    motor_to_dual_quaternion,
    motor_to_matrix,
    motor_to_pose,
    motor_to_translation,
    pose_to_motor,
    rotor,
    rotor_to_motor,
    translation_to_motor,
    vector_of,
)
from elements import DIRECTION, LINE, MOTOR, POINT
from expression import expand, node, symbol
from formulas import alpha
from motor_group import half_beta_of_square, ratio

W, X, Y, Z = (symbol(name) for name in "wxyz")
QUATERNION = {"w": W, "x": X, "y": Y, "z": Z}
T = DIRECTION.multivector(lambda name: symbol("t" + name))
S = MOTOR.multivector(symbol)
P = POINT.multivector(lambda name: symbol("p" + name))
SQUARE = W * W + X * X + Y * Y + Z * Z
# R of p' = R p, times the square of the quaternion, as every textbook has it.
ROTATION = (
    (W * W + X * X - Y * Y - Z * Z, 2 * (X * Y - W * Z), 2 * (X * Z + W * Y)),
    (2 * (X * Y + W * Z), W * W - X * X + Y * Y - Z * Z, 2 * (Y * Z - W * X)),
    (2 * (X * Z - W * Y), 2 * (Y * Z + W * X), W * W - X * X - Y * Y + Z * Z),
)


def let(name, value):
    return value


class ConversionsTest(unittest.TestCase):
    def assert_equal(self, a, b):
        self.assertTrue(expand(node(a)).equals(expand(node(b))), f"{a!r} is not {b!r}")

    def assert_same(self, A, B):
        for blade in {**A.parts, **B.parts}:
            self.assert_equal(A[blade], B[blade])

    def test_a_quaternion_turns_as_its_matrix_does_and_then_the_translation_follows(self):
        image = transform(pose_to_motor(QUATERNION, T, let), P)
        for row in range(3):
            turned = sum(ROTATION[row][k] * symbol("p" + name) for k, name in enumerate("xyz"))
            self.assert_equal(image[str(row + 1)], turned + SQUARE * T[str(row + 1)])
        self.assert_equal(image["0"], SQUARE)

    def test_the_vector_of_a_rotation_is_that_of_the_quaternion(self):
        for found, expected in zip(vector_of(rotor(W, (X, Y, Z))), (X, Y, Z)):
            self.assert_equal(found, expected)

    def test_a_pose_comes_back(self):
        q, t = motor_to_pose(pose_to_motor(QUATERNION, T, let), let)
        for name in "123":
            self.assert_equal(t[name], T[name])
        for name in "xyzw":
            self.assert_equal(q[name] * q[name] * SQUARE, QUATERNION[name] * QUATERNION[name])

    def test_a_dual_quaternion_is_r_and_half_t_r(self):
        q = motor_to_dual_quaternion(pose_to_motor(QUATERNION, T, let), let)
        t = T["1"], T["2"], T["3"]
        self.assert_equal(2 * q["dw"], -(t[0] * X + t[1] * Y + t[2] * Z))
        self.assert_equal(2 * q["dx"], W * t[0] + t[1] * Z - t[2] * Y)
        self.assert_equal(2 * q["dy"], W * t[1] + t[2] * X - t[0] * Z)
        self.assert_equal(2 * q["dz"], W * t[2] + t[0] * Y - t[1] * X)
        for name in "wxyz":
            self.assert_equal(q["r" + name], QUATERNION[name])

    def test_a_dual_quaternion_comes_back(self):
        self.assert_same(dual_quaternion_to_motor(motor_to_dual_quaternion(S, let), let), S)

    def test_a_matrix_moves_points_as_the_motor_does(self):
        m, image = motor_to_matrix(S, let), transform(S, P)
        for row in range(3):
            moved = sum(m[f"m{row}{k}"] * symbol("p" + name) for k, name in enumerate("xyz")) + m[f"m{row}3"]
            self.assert_equal(moved * alpha(S), image[str(row + 1)])
        self.assertEqual([m[f"m3{k}"] for k in range(4)], [0, 0, 0, 1])

    def test_the_four_rows_that_a_quaternion_is_taken_from(self):
        """Each is the quaternion times 4 times one of its components, of the matrix of a unit quaternion."""
        m = {f"m{r}{c}": ROTATION[r][c] for r in range(3) for c in range(3)}
        one = SQUARE
        rows = {
            "w": (one + m["m00"] + m["m11"] + m["m22"], m["m21"] - m["m12"], m["m02"] - m["m20"], m["m10"] - m["m01"]),
            "x": (m["m21"] - m["m12"], one + m["m00"] - m["m11"] - m["m22"], m["m10"] + m["m01"], m["m02"] + m["m20"]),
        }
        for name, row in rows.items():
            for component, found in zip("wxyz", row):
                self.assert_equal(found, 4 * QUATERNION[name] * QUATERNION[component])

    def test_a_translation(self):
        moved = transform(translation_to_motor(T, let), P)
        self.assert_same(moved, P + T)
        self.assert_same(motor_to_translation(W * translation_to_motor(T, let), let).only("123"), T)

    def test_a_rotor_of_wareham_and_lasenby_acts_as_r_x_r_reversed(self):
        """With λ = 2 their F(x/λ) stands for x, so a translation by t is T_a of t/λ."""
        R = rotor_to_motor({"scale": Fraction(1, 2)}, S, let)
        unscaled = rotor_to_motor({"scale": 1}, S, let)
        self.assert_same(unscaled, ~S)
        self.assert_same(rotor_to_motor({"scale": 2}, R, let), S)

    def test_the_ratio_is_what_is_left_to_do(self):
        other = MOTOR.multivector(lambda name: symbol("o_" + name))
        self.assert_same(S * ratio(S, other, let), other)

    def test_half_beta_of_a_square(self):
        B = S.only(LINE.blades)
        square = B * B
        self.assert_equal(square["123i"], 2 * half_beta_of_square(B))
        self.assert_equal(square[""], -(B["12"] * B["12"] + B["13"] * B["13"] + B["23"] * B["23"]))


if __name__ == "__main__":
    unittest.main()
