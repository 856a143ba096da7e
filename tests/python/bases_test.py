# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases on triangles: named, from files, and with nodes and functions of Python's own."""
import json
import unittest
from fractions import Fraction

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
