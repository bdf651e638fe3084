"""The table of public functions: that what it says of them can be."""

import re
import unittest
from pathlib import Path

from api import BOTH, F32, PLAIN, VIEWED
from api_text import FUNCTIONS, GROUPS, documentation, head, listed, overload
from generate import variants_of
from kernels import KERNELS

ROOT = Path(__file__).resolve().parent.parent.parent


class Table(unittest.TestCase):
    def test_no_function_is_there_twice(self):
        symbols = [f.symbol(p) for f in FUNCTIONS for p in f.precisions]
        self.assertEqual(len(symbols), len(set(symbols)))

    def test_every_error_is_a_status(self):
        template = (ROOT / "codegen/templates/motorway.h.j2").read_text(encoding="utf-8")
        statuses = set(re.findall(r"^    MW_ERROR_(\w+)", template, flags=re.MULTILINE))
        self.assertGreater(len(statuses), 25)
        named = {error.split()[0] for group in GROUPS for error in group.errors}
        self.assertEqual(named - statuses, set())
        self.assertEqual(statuses - named, {"ISA"})  # of every function that works on a batch

    def test_every_kernel_that_is_called_is_one(self):
        names = {v.name.replace("_mixed", "") for kernel in KERNELS for v in variants_of(kernel)}
        called = [name for f in FUNCTIONS for name in re.findall(r"kernel_id::(\w+)", f.first)]
        self.assertGreater(len(called), 50)
        self.assertEqual(set(called) - names, set())

    def test_functions_that_take_flags_have_an_error_for_unknown_ones(self):
        for group in GROUPS:
            takes = any(p.name == "flags" for f in group.functions for p in f.parameters)
            self.assertEqual(takes, any(e.split()[0] == "FLAGS" for e in group.errors), group.functions[0].name)

    def test_functions_that_say_where_an_error_is_have_one_to_say_it_of(self):
        for group in GROUPS:
            if any(p.role == "where the error is" for f in group.functions for p in f.parameters):
                self.assertTrue(group.errors, group.functions[0].name)

    def test_batches_have_a_count(self):
        for f in FUNCTIONS:
            views = [p for p in f.parameters if " view " in p.role]
            self.assertTrue(not views or any(p.name == "count" for p in f.parameters), f.name)

    def test_what_has_a_default_in_cpp_comes_last(self):
        for f in FUNCTIONS:
            defaults = [bool(p.default) for p in f.in_cpp]
            self.assertEqual(defaults, sorted(defaults), f.name)

    def test_texts_fit_the_page(self):
        for group in GROUPS:
            for line in documentation(group).splitlines():
                self.assertLessEqual(len(line), 117, line)


class Text(unittest.TestCase):
    def test_a_list_is_aligned_and_breaks_between_its_items(self):
        items = [f"const float *argument{k}" for k in range(8)]
        lines = listed("mw_status mw_f(", items, ");")
        self.assertGreater(len(lines), 1)
        self.assertTrue(all(len(line) <= 118 for line in lines))
        self.assertTrue(all(line.startswith(" " * len("mw_status mw_f(")) for line in lines[1:]))
        self.assertEqual(" ".join(line.strip() for line in lines), "mw_status mw_f(" + ", ".join(items) + ");")

    def test_prototypes_and_overloads(self):
        compose = function("compose_motor_one_first")
        self.assertEqual(compose.precisions, BOTH)
        self.assertEqual(
            one_line(head(compose, F32, PLAIN, ";")),
            "mw_status mw_compose_motor_one_first_f32(mw_motor_f32 *out, size_t out_stride, const mw_motor_f32 *first, "
            "const mw_motor_f32 *then, size_t then_stride, size_t count);",
        )
        self.assertEqual(
            one_line(head(compose, F32, VIEWED, ";")),
            "mw_status mw_compose_motor_one_first_views_f32(const mw_motors_f32 *out, const mw_motor_f32 *first, "
            "const mw_const_motors_f32 *then, size_t count);",
        )
        self.assertIn(
            "return mw_compose_motor_one_first_views_f32(&out, &first, &then, count);", overload(compose, F32)
        )

    def test_functions_without_views_have_one_form_and_some_with_views_no_other(self):
        self.assertEqual(function("rotation").forms, (PLAIN,))
        self.assertEqual(function("reverse_motor_each").forms, (PLAIN, VIEWED))
        self.assertEqual(function("blend_motor_each").forms, (VIEWED,))

    def test_no_struct_is_passed_by_value(self):
        for f in FUNCTIONS:
            for form in f.forms:
                for precision in f.precisions:
                    for text in f.declarations(form, precision):
                        by_value = text.startswith("mw_") and "*" not in text
                        self.assertTrue(not by_value or text.split()[0] in ENUMERATIONS, text)


ENUMERATIONS = {"mw_status", "mw_index_type", "mw_matrix_layout", "mw_euler_order", "mw_motion_kind"}


def function(name):
    return next(f for f in FUNCTIONS if f.name == name)


def one_line(lines):
    return " ".join(line.strip() for line in lines)


if __name__ == "__main__":
    unittest.main()
