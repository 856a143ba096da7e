# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases on triangles: named, from files, and with nodes and functions of Python's own."""
import json
import unittest
from fractions import Fraction

import numpy as np
import radcert as rc

from module import EXAMPLES, ModuleTest, without


def radon(label="Radon"):
    """Radon's rule of degree 5 with seven nodes, for the quadratic polynomials and a bubble."""
    x1, x2, x3 = rc.barycentric()
    r = rc.sqrt(15)
    return rc.Basis(space=[x1, x2, x3, x1 * x2, x2 * x3, x3 * x1, 27 * x1 * x2 * x3],
                    nodes=[(rc.Q(1, 3),) * 3, *rc.orbit((6 - r) / 21), *rc.orbit((6 + r) / 21)], label=label)


class Bases(ModuleTest):
    def test_irrational_nodes_are_exact(self):
        basis = radon()
        self.assertEqual(basis.precision, {"triangle": 5, "parallelogram": 5, "proof": "algebraic"})
        self.assertEqual(basis.degree, 3)
        # Of Radon's weights 9/40, (155 -+ sqrt(15))/1200 twice: of the nodes beside, to 60 digits.
        self.assertLess(abs(2 * basis.weights[0] - Fraction(9, 40)), Fraction(1, 10**60))
        self.assertLess(abs(sum(basis.weights) - Fraction(1, 2)), Fraction(1, 10**60))

    def test_rational_nodes_are_polynomials_of_a_degree(self):
        basis = rc.Basis(nodes=rc.orbit(rc.Q(1, 6)))
        named = rc.inset(1, "1/6")
        self.assertEqual(basis.degree, 1)
        self.assertEqual(sorted(basis.nodes), sorted(named.nodes))
        self.assertEqual(basis.precision, {"triangle": 2, "parallelogram": 3, "proof": "exact"})
        self.assertEqual(basis.precision, named.precision)
        self.assertEqual(basis.weights, [Fraction(1, 6)] * 3)
        self.assertEqual(basis.orders, named.orders)

    def test_a_square_root_that_is_rational_is_that_number(self):
        basis = rc.Basis(nodes=rc.orbit(1 / rc.sqrt(36)))
        self.assertEqual(basis.precision["proof"], "exact")
        self.assertEqual(sorted(basis.nodes), sorted(rc.inset(1, "1/6").nodes))

    def test_facts_are_those_of_the_program(self):
        for basis, words in [(rc.inset(2, "1/10"), ["inset", "--degree", 2, "--alpha", "1/10"]),
                             (rc.inset(1, "superconvergent"), ["inset", "--degree", 1, "--alpha", "superconvergent"]),
                             (rc.symmetric(2), ["symmetric", "--degree", 2]),
                             (rc.Basis(EXAMPLES / "04_own_basis" / "enriched.json"),
                              [EXAMPLES / "04_own_basis" / "enriched.json"])]:
            self.assertEqual(without(basis.to_json(), "command"), without(self.program("basis", *words), "command"))

    def test_a_file_and_the_same_nodes_in_python_solve_alike(self):
        x1, x2, x3 = rc.barycentric()
        fifth = rc.Q(1, 5)
        nodes = [(3 * fifth, fifth, fifth), (fifth, 3 * fifth, fifth), (fifth, fifth, 3 * fifth), (rc.Q(1, 3),) * 3]
        own = rc.Basis(space=[x1, x2, x3, 27 * x1 * x2 * x3], nodes=nodes)
        of_file = rc.Basis(EXAMPLES / "04_own_basis" / "enriched.json")
        problem = rc.Problem(rc.cube(), reflectivity="1/2", solution="x*y + z", basis=own, levels=[0, 1])
        first, second = problem.solve(), problem.replace(basis=of_file).solve()
        for name in first.errors:
            self.assertEqual(first.errors[name].value.tolist(), second.errors[name].value.tolist())
        written = problem.to_json()["basis"]
        self.assertEqual(set(written), {"file", "digest"})

    def test_functions_of_python_are_taken_as_the_polynomials_that_they_are(self):
        x1, x2, x3 = rc.barycentric()
        fifth = rc.Q(1, 5)
        nodes = [(3 * fifth, fifth, fifth), (fifth, 3 * fifth, fifth), (fifth, fifth, 3 * fifth), (rc.Q(1, 3),) * 3]
        functions = [lambda b: b[:, 0], lambda b: b[:, 1], lambda b: b[:, 2].tolist(), lambda b: 27 * b[:, 0] * b[:, 1] * b[:, 2]]
        own = rc.Basis(functions=functions, nodes=nodes, label="bubble")
        self.assertEqual(own.polynomials, ["x1", "x2", "x3", "27*x1*x2*x3"])
        self.assertTrue(own.by_functions)
        self.assertLess(own.residual, 1e-15)
        exact = rc.Basis(space=[x1, x2, x3, 27 * x1 * x2 * x3], nodes=nodes)
        self.assertEqual((exact.by_functions, exact.polynomials, exact.residual), (False, None, None))
        self.assertFalse(rc.inset(1, "1/6").by_functions)
        self.assertEqual(own.weights, exact.weights)
        problem = rc.Problem(rc.cube(), reflectivity="1/2", solution="x*y + z", basis=own, levels=[0, 1])
        found, expected = problem.solve(), problem.replace(basis=exact).solve()
        self.assertEqual((found.by_functions, expected.by_functions), (["basis"], []))
        for name, error in expected.errors.items():
            self.assertEqual(found.errors[name].value.tolist(), error.value.tolist())
            self.assertFalse(found.errors[name].guaranteed.any())
        self.assertIn("estimated, by functions of Python: bubble", json.dumps(problem.to_json()["basis"]))
        # Nothing is proved and nothing kept; with the polynomials stated it is.
        error = self.refused(lambda: problem.replace(solver="verified"), "made of functions of Python")
        self.assertEqual(error.place, "/solver/name")
        self.refused(lambda: problem.solve(solver="verified"), "/solver/name")
        problem.solve(store=self.folder / "kept")
        self.assertFalse((self.folder / "kept").exists())
        self.refused(lambda: problem.write(self.folder / "p.json"), "/basis", "which no file has")
        stated = rc.Basis(space=own.polynomials, nodes=nodes)
        self.assertTrue(problem.replace(basis=stated, levels=[0]).solve(solver="verified")[0].values.guaranteed.all())

    def test_coefficients_are_simple_where_they_can_be(self):
        third = rc.Q(1, 3)
        thirds = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (third, third, third)]

        def polynomial(function):
            return rc.Basis(functions=[lambda b: b[:, 0], lambda b: b[:, 1], lambda b: b[:, 2], function], nodes=thirds).polynomials[3]

        self.assertEqual(polynomial(lambda b: b[:, 0] * b[:, 1] / 3), "1/3*x1*x2")
        self.assertEqual(polynomial(lambda b: 0.1 * b[:, 0] * b[:, 1]), "1/10*x1*x2")
        exact = Fraction(2 ** 0.5)
        self.assertLess(abs(Fraction(polynomial(lambda b: 2 ** 0.5 * b[:, 0] * b[:, 1]).split("*")[0]) - exact), 1e-15)
        # Equal as polynomials of a sum of 1, of the least degree.
        self.assertEqual(polynomial(lambda b: b[:, 0] * b[:, 1] * (b.sum(axis=1))), "x1*x2")
        self.assertEqual(polynomial(lambda b: (b[:, 0] - b[:, 1])**8).count("x1^4*x2^4"), 1)

    def test_functions_that_are_no_polynomials_are_refused(self):
        nodes = rc.orbit(rc.Q(1, 6))

        def refused(function, *words):
            given = [lambda b: b[:, 0], lambda b: b[:, 1], function]
            error = self.refused(lambda: rc.Basis(functions=given, nodes=nodes), *words)
            self.assertEqual(error.place, "functions/2")

        for function in (lambda b: np.exp(b[:, 2]), lambda b: b[:, 2]**9, lambda b: np.abs(b[:, 2] - 0.5), lambda b: 1 / (1 + b[:, 2])):
            refused(function, "is no polynomial of degree 8 or less", "off by")
        for wrong, words in [(lambda b: 1.0, "has another shape"), (lambda b: b, "has another shape"), (lambda b: b[:-1, 2], "has another shape"),
                             (lambda b: b[:, 2] * 1j, "is no array of doubles"), (lambda b: None, "is None"), (lambda b: "1", "is of the type str"),
                             (lambda b: b[:, 2].astype(np.longdouble), "is no array of doubles"), (1, "cannot be called"),
                             (lambda b: np.where(b[:, 2] == 1, np.nan, b[:, 2]), "is not finite at (0, 0, 1)"),
                             (lambda b: 0 * b[:, 2], "is zero")]:
            refused(wrong, words)
        self.refused(lambda: rc.Basis(functions=[lambda b: b[:, 0]] * 2, nodes=nodes[:2]), "linearly dependent")
        with self.assertRaises(ZeroDivisionError):
            rc.Basis(functions=[lambda b: 1 / 0], nodes=[(rc.Q(1, 3),) * 3])
        with self.assertRaises(KeyboardInterrupt):
            def stopped(b):
                raise KeyboardInterrupt
            rc.Basis(functions=[stopped], nodes=[(rc.Q(1, 3),) * 3])
        with self.assertRaises(TypeError):
            rc.Basis(functions=[lambda b: b[:, 0]], space=["x1"], nodes=nodes)
        with self.assertRaises(TypeError):
            rc.Basis(functions=[lambda b: b[:, 0]])

    def test_what_is_no_basis_is_refused(self):
        x1, x2, x3 = rc.barycentric()
        third = rc.Q(1, 3)
        self.assertEqual(self.refused(lambda: rc.Basis(nodes=[(third, third)]), "2 coordinates").place, "nodes/0")
        self.refused(lambda: rc.Basis(nodes=[(third, third, third)] * 2), "1, 3, 6, 10")
        self.refused(lambda: rc.Basis(nodes=[(third, third, third)] * 3), "same point")
        self.refused(lambda: rc.Basis(nodes=[(0.1, 0.2, 0.7)]), "/nodes/0")
        self.refused(lambda: rc.Basis(nodes=[(float("nan"), 0, 1)]), "nodes/0/0", "is not finite")
        self.refused(lambda: rc.Basis(space=[x1, x2], nodes=[(1, 0, 0), (0, 1, 0)]), "constants")
        self.refused(lambda: rc.Basis(nodes=[(rc.exp(x1), 0, 0)]), "square roots")
        self.refused(lambda: rc.Basis(nodes=[(rc.sqrt(-2), 0, 0)]), "square roots of numbers >= 0")
        a, b, c, d = (rc.sqrt(n) / 10 for n in (2, 3, 5, 7))
        self.refused(lambda: rc.Basis(nodes=[(a, b, 1 - a - b), (c, d, 1 - c - d), (1, 0, 0)]), "three other square roots")
        self.refused(lambda: rc.inset(1).facts, "alpha: is missing")
        self.refused(lambda: rc.inset(1, "1/3").facts, "alpha")
        self.refused(lambda: rc.inset(13, "1/6").facts, "from 0 to 12")
        self.refused(lambda: rc.symmetric(7).facts, "degree")
        self.refused(lambda: rc.Basis("nothing.json"), "nothing.json")
        with self.assertRaises(TypeError):
            rc.Basis()
        (self.folder / "nodes.json").write_text(json.dumps({"schema": "radcert/nodes/1", "degree": 9}), encoding="utf-8")
        self.refused(lambda: rc.Basis(self.folder / "nodes.json"), "/nodes")


if __name__ == "__main__":
    unittest.main()
