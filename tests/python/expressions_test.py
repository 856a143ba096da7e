# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions of Python are those of the library."""
import math
import random
import unittest

import numpy as np
import radcert as rc

from module import ModuleTest

FUNCTIONS = {"exp": math.exp, "sin": math.sin, "cos": math.cos, "atan": math.atan}


class Expressions(ModuleTest):
    def test_texts_are_as_one_would_write_them(self):
        x, y, z = rc.xyz()
        for expression, text in [
            (rc.exp(x / 2 + y / 3 - z / 4), "exp(x/2 + y/3 - z/4)"),
            (x - (y - z), "x - (y - z)"),
            (x / (y * z), "x/(y*z)"),
            (x / y * z, "x/y*z"),
            (-x**2, "-x^2"),
            ((-x) ** 2, "(-x)^2"),
            (x**y**2, "x^y^2"),
            ((x**y) ** 2, "(x^y)^2"),
            (x**-1, "x^-1"),
            (x ** rc.Q(1, 2), "x^(1/2)"),
            (2 * x, "2*x"),
            (x * -2, "x*-2"),
            (rc.Q(1, 3) * x, "1/3*x"),
            (x * rc.Q(1, 3), "x*(1/3)"),
            (x - rc.Q(-1, 3), "x - -1/3"),
            (np.float64(0.5) * x, "1/2*x"),
            (1 / rc.sqrt(x**2 + 1), "1/sqrt(x^2 + 1)"),
            (abs(x - 1), "abs(x - 1)"),
            (rc.maximum(x, 0) + rc.pi, "max(x, 0) + pi"),
        ]:
            self.assertEqual(str(expression), text)

    def test_a_float_is_the_double_that_it_is(self):
        x, _, _ = rc.xyz()
        self.assertEqual(str(0.1 * x), "3602879701896397/36028797018963968*x")

    def test_every_function_is_that_of_numpy(self):
        x, y, _ = rc.xyz()
        points = np.random.default_rng(1).uniform(0.1, 1.5, (50, 3))
        for ours, theirs in [(rc.sqrt, np.sqrt), (rc.exp, np.exp), (rc.log, np.log), (rc.sin, np.sin), (rc.cos, np.cos),
                             (rc.tan, np.tan), (rc.atan, np.arctan)]:
            np.testing.assert_allclose(ours(x)(points), theirs(points[:, 0]), rtol=1e-15, atol=1e-16, err_msg=theirs.__name__)
        for ours, theirs in [(rc.minimum, np.minimum), (rc.maximum, np.maximum)]:
            np.testing.assert_array_equal(ours(x, y)(points), theirs(points[:, 0], points[:, 1]))

    def test_values_are_those_of_python(self):
        # Random trees: Python's own operators on floats against the text that the library parses and evaluates.
        numbers = random.Random(5)
        x = rc.xyz()

        def tree(depth):
            if depth == 0 or numbers.random() < 0.2:
                if numbers.random() < 0.6:
                    axis = numbers.randrange(3)
                    return x[axis], lambda p: p[axis]
                value = rc.Q(numbers.randint(-9, 9), numbers.choice([1, 2, 4]))
                return rc.sqrt(0) + value if numbers.random() < 0.3 else value + 0 * x[0], lambda p: float(value)
            left, f = tree(depth - 1)
            kind = numbers.choice("+-*/^fn")
            if kind == "f":
                name = numbers.choice(list(FUNCTIONS))
                return getattr(rc, name)(left), lambda p: FUNCTIONS[name](f(p))
            if kind == "n":
                return -left, lambda p: -f(p)
            if kind == "^":
                power = numbers.randint(0, 3)
                return left**power, lambda p: f(p) ** power
            right, g = tree(depth - 1)
            if kind == "+":
                return left + right, lambda p: f(p) + g(p)
            if kind == "-":
                return left - right, lambda p: f(p) - g(p)
            if kind == "*":
                return left * right, lambda p: f(p) * g(p)
            return left / right, lambda p: f(p) / g(p)

        compared = 0
        for _ in range(600):
            expression, function = tree(4)
            points = np.array([[numbers.uniform(-2, 2) for _ in range(3)] for _ in range(4)])
            found = expression(points)
            for point, value in zip(points.tolist(), found):
                try:
                    expected = function(point)
                except (ZeroDivisionError, OverflowError, ValueError):
                    continue
                if not math.isfinite(expected) or abs(expected) > 1e12:
                    continue
                self.assertTrue(math.isclose(value, expected, rel_tol=1e-7, abs_tol=1e-7),
                                f"{expression} at {point}: {value}, {expected}")
                compared += 1
        self.assertGreater(compared, 1000)

    def test_points_of_any_layout_give_the_same_values(self):
        x, y, z = rc.xyz()
        f = x + 10 * y + 100 * z
        points = np.arange(24.0).reshape(8, 3)
        expected = f(points)
        self.assertEqual(expected.tolist(), (points @ [1, 10, 100]).tolist())
        self.assertEqual(f(np.asfortranarray(points)).tolist(), expected.tolist())
        self.assertEqual(f(points[::-2]).tolist(), expected[::-2].tolist())
        self.assertEqual(f(points.astype(np.float32)).tolist(), expected.tolist())
        self.assertEqual(f(points.astype(int)).tolist(), expected.tolist())
        self.assertEqual(f(points.tolist()).tolist(), expected.tolist())
        self.assertEqual(f(points.astype(">f8")).tolist(), expected.tolist())
        self.assertEqual(f(np.empty((0, 3))).tolist(), [])

    def test_what_is_no_expression_is_refused(self):
        x, _, _ = rc.xyz()
        x1, _, _ = rc.barycentric()
        self.refused(lambda: x + x1, "beside barycentric ones")
        self.refused(lambda: rc.expression("x +"), "is no expression: column 4")
        self.refused(lambda: x + float("nan"), "is not finite")

        def squared(f, times):
            for _ in range(times):
                f = f * f
            return f

        self.assertLess(len(squared(x, 10).text), 4097)
        self.refused(lambda: squared(x, 60), "characters; allowed: at most 4096")
        with self.assertRaises(TypeError):
            rc.exp("x")
        with self.assertRaises(TypeError):
            x + "y"
        with self.assertRaises(TypeError):
            bool(x)


if __name__ == "__main__":
    unittest.main()
