"""The stages of the generator, from expressions to files."""

from __future__ import annotations

import io
import tempfile
import unittest
from contextlib import redirect_stdout
from fractions import Fraction
from pathlib import Path

try:
    import jinja2  # noqa: F401
except ModuleNotFoundError:
    raise unittest.SkipTest("the generator's own tests need jinja2; the proofs do not")

import emit
import generate
from expression import constant, expand, named, node, root, symbol
from golden import golden_inputs, golden_rows
from algebra import OMEGA, VECTORS, Multivector, e
from elements import LINE, MOTOR, VECTOR
from formulas import alpha, beta, normalized_but_for_alpha
from kernels import KERNELS, UNIT
from plan import Operation, make_plan
from polynomial import Quotient, variables
from simplify import Form, choose, common_pairs, linear_coefficients, prove_equal, share_common_sums

A, B, C, D, X = map(symbol, "abcdx")


class Expressions(unittest.TestCase):
    def test_building_twice_gives_the_same_object(self):
        self.assertIs(A * B + C, A * B + C)
        self.assertIs(A * B, B * A)
        self.assertIs(2 * (A + B) / 2, A + B)

    def test_terms_cancel_and_merge(self):
        self.assertEqual(A * B - B * A, 0)
        self.assertIs(A + A, 2 * A)

    def test_products_of_sums_are_not_multiplied_out(self):
        product = (A + B) * (C + D)
        self.assertEqual(len(product.terms), 1)
        self.assertEqual(len(expand(product).numerator.terms), 4)

    def test_expansions_decide_equality(self):
        self.assertTrue(expand((A + B) * (A - B)).equals(expand(A * A - B * B)))
        self.assertFalse(expand((A + B) * (A - B)).equals(expand(A * A + B * B)))
        self.assertTrue(expand(A / B + C / D).equals(expand((A * D + C * B) / (B * D))))

    def test_square_roots_square_to_what_is_inside(self):
        r = root(A * A + B)
        self.assertTrue(expand(r * r).equals(expand(A * A + B)))
        self.assertTrue(expand(1 / r).equals(expand(r / (A * A + B))))
        self.assertFalse(expand(r).equals(expand(-r)))

    def test_square_roots_of_rationals_are_exact_or_an_error(self):
        self.assertEqual(root(Fraction(9, 16)), Fraction(3, 4))
        with self.assertRaises(ValueError):
            root(2)

    def test_nothing_is_merged_across_a_name(self):
        self.assertEqual(len((named("sum", A + B) + A).terms), 2)
        self.assertTrue(expand(named("sum", A + B) + A).equals(expand(2 * A + B)))

    def test_division_by_zero(self):
        with self.assertRaises(ZeroDivisionError):
            A / 0


class Simplification(unittest.TestCase):
    def test_forms_that_differ_are_refused(self):
        with self.assertRaisesRegex(ArithmeticError, 'form "wrong" differs from "right" in output 1'):
            prove_equal([Form("right", (A, A * B)), Form("wrong", (A, A * C))], {})

    def test_forms_may_be_equal_modulo_a_relation(self):
        s, b12, b13, b23 = map(symbol, ("s", "b12", "b13", "b23"))
        forms = [Form("one", (constant(1),)), Form("norm", (s * s + b12 * b12 + b13 * b13 + b23 * b23,))]
        prove_equal(forms, UNIT)
        with self.assertRaises(ArithmeticError):
            prove_equal(forms, {})

    def test_a_relation_may_be_a_quotient(self):
        s, w, b = map(symbol, ("s", "w", "b"))
        relation = {"w": Quotient(variables("b")[0], variables("s")[0])}
        prove_equal([Form("product", (s * w,)), Form("known", (b,))], relation)
        prove_equal([Form("square", (w * w * s,)), Form("known", (b * w,))], relation)
        with self.assertRaises(ArithmeticError):
            prove_equal([Form("product", (s * w,)), Form("wrong", (2 * b,))], relation)

    def test_normalised_motors_satisfy_what_is_said_of_them(self):
        S = MOTOR.multivector(symbol)
        product = ~S * S
        prove_equal([Form("alpha", (node(product[""]),)), Form("one", (constant(1),))], UNIT)
        prove_equal([Form("beta", (node(product[OMEGA]),)), Form("nothing", (constant(0),))], UNIT)

    def test_what_a_motor_makes_of_a_vector_is_a_vector_and_of_a_line_a_line(self):
        S, v, line = (element.multivector(symbol) for element in (MOTOR, VECTOR, LINE))
        N = normalized_but_for_alpha(S, lambda name, value: value)
        for name, value, blades in (
            ("vector", ~N * v * N, VECTORS),
            ("line", ~S * line * S * Multivector({"": alpha(S), OMEGA: -beta(S)}), LINE.blades),
        ):
            for blade in set(value.parts) - set(blades):
                with self.subTest(of=name, blade=blade):
                    prove_equal([Form("part", (node(value[blade]),)), Form("nothing", (constant(0),))], {})

    def test_components_may_be_products_in_any_order(self):
        self.assertEqual(LINE.multivector({n: n == "dy" for n, _ in LINE.components}.__getitem__), e("31"))
        self.assertEqual(LINE.coefficients(e("13")), [0, -1, 0, 0, 0, 0])

    def test_the_cheapest_form_is_chosen(self):
        forms = [Form("expanded", (A * C + A * D + B * C + B * D,)), Form("factored", ((A + B) * (C + D),))]
        self.assertEqual(choose(forms, frozenset("abcd"), {}).form.name, "factored")

    def test_common_sums_are_computed_once(self):
        form = Form("", (A * A + B * B + C, A * A + B * B + D, A * A + B * B + X))
        self.assertEqual(len(common_pairs(form.outputs)), 1)
        varying = frozenset("abcdx")
        self.assertEqual(make_plan(form.outputs, varying).cost[0], 6)
        shared = share_common_sums(form, varying)
        self.assertEqual(make_plan(shared.outputs, varying).cost[0], 5)
        prove_equal([form, shared], {})

    def test_linear_coefficients(self):
        coefficients = linear_coefficients((A + B) * X + C, ["x"])
        self.assertTrue(expand(coefficients["x"]).equals(expand(A + B)))
        self.assertTrue(expand(coefficients[""]).equals(expand(C)))
        with self.assertRaises(ValueError):
            linear_coefficients(X * X, ["x"])


class Plans(unittest.TestCase):
    def operations(self, output, varying="abcdx"):
        return [operation.op for operation in make_plan([node(output)], frozenset(varying)).body]

    def test_sums_of_products_are_chains_of_fused_operations(self):
        self.assertEqual(self.operations(A * B + C * D), ["mul", "fma"])
        self.assertEqual(self.operations(A * B - C * D), ["mul", "fnma"])
        self.assertEqual(self.operations(A + B * C), ["fma"])
        self.assertEqual(self.operations(A * B - C), ["fms"])
        self.assertEqual(self.operations(A - B), ["sub"])
        self.assertEqual(self.operations(-A), ["negate"])

    def test_a_sign_moves_into_the_fused_operation(self):
        self.assertEqual(self.operations(A - B * (C + D)), ["add", "fnma"])
        self.assertEqual(self.operations(A + B * named("n", -C - D)), ["add", "fnma"])

    def test_what_does_not_vary_is_computed_once(self):
        plan = make_plan([A * B * X + A + C], frozenset("x"))
        self.assertEqual([o.op for o in plan.prologue], ["mul", "add"])
        self.assertEqual([o.op for o in plan.body], ["fma"])
        self.assertEqual(len(plan.constants), 2)

    def test_every_chosen_plan_computes_the_definition(self):
        """Its operations, over the rationals, on the golden inputs."""
        for kernel in KERNELS:
            for variant in generate.variants_of(kernel) if kernel.is_rational else ():
                if variant.unit:
                    continue  # holds for α = 1 only; proved symbolically when the form is chosen
                for values, (_, expected) in zip(golden_inputs(kernel), golden_rows(kernel)):
                    computed = [evaluate(o, values) for o in variant.choice.plan.outputs]
                    self.assertEqual(computed, expected, variant.name)

    def test_instruction_budgets(self):
        budgets = {"apply_point_one": (9, 0), "apply_point_each": (28, 1), "apply_point_each_unit": (24, 0)}
        budgets["compose_motor_each"] = (48, 0)
        for kernel in KERNELS:
            for variant in generate.variants_of(kernel):
                count = variant.choice.plan.count("body")
                if variant.name in budgets:
                    operations, divisions = budgets.pop(variant.name)
                    self.assertLessEqual(count.operations, operations)
                    self.assertEqual(count.divisions, divisions)
        self.assertFalse(budgets)


def evaluate(operation: Operation, values) -> Fraction:
    if operation.op == "input":
        return values[operation.name]
    if operation.op == "constant":
        return operation.value
    meaning = {
        "mul": lambda a, b: a * b,
        "add": lambda a, b: a + b,
        "sub": lambda a, b: a - b,
        "div": lambda a, b: a / b,
        "fma": lambda a, b, c: a * b + c,
        "fnma": lambda a, b, c: c - a * b,
        "fms": lambda a, b, c: a * b - c,
        "negate": lambda a: -a,
        "sqrt": root,
    }
    return Fraction(meaning[operation.op](*[evaluate(operand, values) for operand in operation.operands]))


class Text(unittest.TestCase):
    def test_numbers_must_be_exact_in_binary(self):
        self.assertEqual(emit.number(Fraction(1, 2)), "0.5")
        self.assertEqual(emit.number(Fraction(3)), "3")
        with self.assertRaises(ValueError):
            emit.number(Fraction(1, 3))

    def test_no_generated_line_of_code_is_too_long(self):
        for name, text in generate.render_all().items():
            if name.endswith(".inl"):
                self.assertLessEqual(max(map(len, text.split("\n"))), emit.WIDTH, name)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(setattr, generate, "OUTPUT", generate.OUTPUT)
        self.addCleanup(setattr, generate, "ROOT", generate.ROOT)
        self.files = generate.render_all()
        generate.ROOT = Path(folder.name)
        generate.OUTPUT = generate.ROOT / "generated"
        with redirect_stdout(io.StringIO()):
            generate.write(self.files)

    def check(self):
        with redirect_stdout(io.StringIO()) as output:
            current = generate.check(self.files)
        return current, output.getvalue()

    def test_what_was_written_is_current(self):
        self.assertEqual(self.check(), (True, ""))

    def test_a_changed_file_fails_with_the_difference_and_the_mending_command(self):
        path = generate.OUTPUT / "kernel_list.inc"
        path.write_text(path.read_text(encoding="utf-8").replace("point, one, 3", "point, one, 4"), encoding="utf-8")
        current, output = self.check()
        self.assertFalse(current)
        self.assertIn("-MOTORWAY_KERNEL(apply, point, one, 4, 3, 9, 0)", output)
        self.assertIn("+MOTORWAY_KERNEL(apply, point, one, 3, 3, 9, 0)", output)
        self.assertIn("python3 codegen/generate.py", output)

    def test_a_missing_file_and_an_orphan_fail(self):
        (generate.OUTPUT / "kernel_list.inc").unlink()
        self.assertFalse(self.check()[0])
        with redirect_stdout(io.StringIO()):
            generate.write(self.files)
        orphan = generate.OUTPUT / "kernels" / "apply_banana.inl"
        orphan.write_text("")
        current, output = self.check()
        self.assertFalse(current)
        self.assertIn("orphan: generated/kernels/apply_banana.inl", output)
        with redirect_stdout(io.StringIO()):
            generate.write(self.files)
        self.assertFalse(orphan.exists())

    def test_rendering_twice_gives_the_same_bytes(self):
        self.assertEqual(generate.render_all(), self.files)


if __name__ == "__main__":
    unittest.main()
