# SPDX-License-Identifier: GPL-3.0-or-later
"""Exponents at edges: those of the program."""
import unittest
from decimal import Decimal

import radcert as rc

from module import ModuleTest, without


class Edges(ModuleTest):
    def test_the_numbers_are_those_of_the_program(self):
        edge = rc.edge(90, "1/2")
        self.assertEqual(without(edge.to_json(), "command"), without(self.program("edge", "--angle", 90, "--rho", "1/2"), "command"))
        other = rc.edge(rc.Q(135), rc.Q(1, 2), "0.3", up_to=2, digits=20)
        self.assertEqual(without(other.to_json(), "command"),
                         without(self.program("edge", "--angle", 135, "--rho", "1/2", "--rho-other", "0.3", "--up-to", 2, "--digits", 20),
                                 "command"))
        self.assertIn("135 degrees", repr(other))

    def test_an_edge_says_what_it_asks_of_a_mesh(self):
        edge = rc.edge(90, "1/2")
        first = edge.exponents[0]
        self.assertEqual(edge.smallest[0][:10], first.real[0][:10])
        self.assertEqual(first.value.real, float(first.real[0]))
        self.assertLess(Decimal(first.real[1]), Decimal("1e-12"))
        self.assertAlmostEqual(edge.order(1), min(2, first.value.real), places=12)
        self.assertAlmostEqual(edge.grading(1), max(1, 2 / first.value.real), places=12)
        self.assertFalse(edge.logarithms)
        self.assertTrue(rc.edge(90, "1/2", 0).logarithms)
        self.assertIsNone(rc.edge(90, "1/2", 0).smallest)
        self.assertEqual(rc.edge(270, "1/2").exponents, [])

    def test_what_is_no_edge_is_refused(self):
        for arguments, words in [((0, "1/2"), "angle"), ((360, "1/2"), "angle"), (("a", "1/2"), "angle"), ((float("nan"), "1/2"), "angle"),
                                 ((90, 1), "rho"), ((90, -1), "rho"), ((90, None), "rho"), ((90, "1/2", 2), "rho_other")]:
            self.refused(lambda arguments=arguments: rc.edge(*arguments), words)
        self.refused(lambda: rc.edge(90, "1/2", up_to=21), "up_to")
        self.refused(lambda: rc.edge(90, "1/2", digits=0), "digits")
        self.refused(lambda: rc.edge(90, "1/2").order(5), "degree", "from 0 to 4")


if __name__ == "__main__":
    unittest.main()
