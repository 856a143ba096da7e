# SPDX-License-Identifier: GPL-3.0-or-later
"""radcert edge: exponents against another program's quadrature and roots."""
import json
import unittest

import jsonschema
from mpmath import mp, mpc, mpf

from program import ProgramTest


def symbol(b, degrees):
    """The symbol by its integral, continued by what the integrand is like at infinity."""
    w = mp.pi * mpf(degrees) / 180
    c = mp.cos(w)
    terms = [mpf(1), 3 * c]
    while len(terms) < 12:
        n = len(terms) - 1
        terms.append(((2 * n + 3) * c * terms[n] - (n + 2) * terms[n - 1]) / (n + 1))

    def g(t):
        return (1 - 2 * c * t + t * t) ** mpf("-1.5")

    inner = mp.quad(lambda t: t ** (1 + b) * g(t), [0, 0.5, 1])
    count = 8
    rest = mp.quad(lambda t: t ** -b * (g(t) - sum(p * t ** n for n, p in enumerate(terms[:count]))), [0.2, 0.5, 1])
    # Below 1/5 by more terms of the series.
    while len(terms) < 60:
        n = len(terms) - 1
        terms.append(((2 * n + 3) * c * terms[n] - (n + 2) * terms[n - 1]) / (n + 1))
    below = sum(p * mpf("0.2") ** (n + 1 - b) / (n + 1 - b) for n, p in enumerate(terms) if n >= count)
    return mp.sin(w) ** 2 / 2 * (inner + rest + below + sum(p / (n + 1 - b) for n, p in enumerate(terms[:count])))


class Edge(ProgramTest):
    def refused(self, code, *words):
        done = self.run_program(*words)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, b"")
        return done.stderr.decode()

    def setUp(self):
        super().setUp()
        mp.dps = 25

    def edge(self, *words, code=0):
        return json.loads(self.expect(code, "edge", *words, "--json", "-"))

    def test_exponents_solve_the_equation_and_fit_the_schema(self):
        schema = json.loads(self.expect(0, "schema", "edge"))
        for angle, rho, other in ((90, "9/10", "9/10"), (60, "1/2", "1/4"), (135, "1/2", "1/2")):
            found = self.edge("--angle", str(angle), "--rho", rho, "--rho-other", other, "--up-to", "4", "--digits", "15")
            jsonschema.validate(found, schema)
            scale = mp.sqrt(eval_fraction(rho) * eval_fraction(other))
            self.assertGreaterEqual(len(found["exponents"]), 3)
            for exponent in found["exponents"]:
                imaginary = exponent["imaginary"]
                b = mpc(mpf(exponent["real"]["midpoint"]), mpf(imaginary["midpoint"]) if imaginary else 0)
                sign = 1 if exponent["symmetry"] == "symmetric" else -1
                self.assertLess(abs(scale * symbol(b, angle) - sign), mpf("1e-10"), (angle, b))
                self.assertLessEqual(mpf(exponent["real"]["radius"]), mpf("1e-15"))

    def test_the_exponents_of_right_angles_are_known(self):
        for rho, digits in (("1/2", "0.7633620752195"), ("0.9", "0.58199259417")):
            found = self.edge("--angle", "90", "--rho", rho)
            self.assertTrue(found["smallest"]["midpoint"].startswith(digits), found["smallest"])
            self.assertAlmostEqual(found["degrees"][1]["grading"], 2 / float(digits), places=9)
            self.assertAlmostEqual(found["degrees"][3]["uniform_order"], float(digits), places=9)

    def test_faces_that_do_not_see_each_other_or_do_not_reflect_have_no_exponent(self):
        for angle in ("180", "270", "359.5"):
            found = self.edge("--angle", angle, "--rho", "1/2")
            self.assertFalse(found["faces_see_each_other"])
            self.assertEqual((found["exponents"], found["smallest"]), ([], None))
            self.assertEqual(found["degrees"][4], {"degree": 4, "uniform_order": 5, "grading": 1})
            self.assertIn("do not see each other", self.expect(0, "edge", "--angle", angle, "--rho", "1/2"))
        black = self.edge("--angle", "90", "--rho", "1/2", "--rho-other", "0")
        self.assertTrue(black["logarithms"])
        self.assertEqual(black["degrees"][2]["uniform_order"], 1)
        self.assertFalse(self.edge("--angle", "90", "--rho", "0")["logarithms"])

    def test_exponents_that_coincide_are_not_counted(self):
        # At a right angle k(4) = 4/3: for rho = 3/4 the exponent 4 and a zero that is none fall together.
        found = self.edge("--angle", "90", "--rho", "3/4", "--up-to", "5", code=1)
        self.assertIsNone(found["exponents"])
        self.assertIn("not counted", found["not_counted"])
        self.assertIsNotNone(found["smallest"])

    def test_results_say_what_each_edge_and_corner_asks_for(self):
        schema = json.loads(self.expect(0, "schema", "solution"))
        base = {"schema": "radcert/problem/1", "basis": {"family": "inset", "degree": 1, "alpha": "1/10"}, "emission": "1"}
        for surface, rho, grading, counts in (("two_squares", {"xy": "9/10", "xz": "1/4"}, "edges", (1, 0)),
                                              ("cube", "1/2", "edges", (12, 8)), ("cube", "1/2", 3, (12, 8))):
            self.write("graded.json", {**base, "surface": {"name": surface}, "reflectivity": rho,
                                       "triangulation": {"levels": [0], "grading": grading}})
            result = json.loads(self.expect(0, "solve", "graded.json", "--json", "-"))
            jsonschema.validate(result, schema)
            asked = result["edge_grading"]
            self.assertEqual((len(asked["edges"]), len(asked["corners"])), counts)
            taken = result["problem"]["triangulation"]["grading"]
            self.assertEqual(taken, asked["grading"] if grading == "edges" else 3)
            for edge in asked["edges"]:
                self.assertAlmostEqual(edge["degrees"], 90)
                number = float(eval_fraction(str(edge["grading"])))
                self.assertTrue(0 <= number - 2 / edge["exponent"] <= 1 / 64, edge)
            if surface == "two_squares":
                edge = asked["edges"][0]
                self.assertEqual(dict(zip(edge["pieces"], edge["reflectivities"])), rho)
                smallest = self.edge("--angle", "90", "--rho", "9/10", "--rho-other", "1/4")["smallest"]["midpoint"]
                self.assertAlmostEqual(asked["edges"][0]["exponent"], float(smallest), places=10)
            else:
                largest = max(float(eval_fraction(str(corner["grading"]))) for corner in asked["corners"])
                self.assertAlmostEqual(largest, float(eval_fraction(str(asked["grading"]))))
        self.write("uniform.json", {**base, "surface": {"name": "cube"}, "reflectivity": "1/2",
                                    "triangulation": {"levels": [0]}})
        self.assertNotIn("edge_grading", json.loads(self.expect(0, "solve", "uniform.json", "--json", "-")))

    def test_what_is_proved_of_a_graded_triangulation_is_about_the_vertices_of_double(self):
        schema = json.loads(self.expect(0, "schema", "solution"))
        base = {"schema": "radcert/problem/1", "surface": {"name": "cube"}, "basis": {"family": "inset", "degree": 0},
                "reflectivity": "1/2", "emission": {"floor": "1", "*": "0"}}

        def graded(grading, solver, *levels):
            return self.write("graded.json", {**base, "triangulation": {"levels": [*levels], "grading": grading},
                                              "solver": {"name": solver}})
        for grading, levels, rounded in (("3/2", (1, 2), [2]), (3, (1, 2), [])):
            file = graded(grading, "verified", *levels)
            result = json.loads(self.expect(0, "solve", file, "--json", "-"))
            jsonschema.validate(result, schema)
            self.assertEqual(result["rounded_levels"], rounded)
            said = "rounded to double (levels 2)" in self.expect(0, "solve", file)
            self.assertEqual(said, bool(rounded))
        # The vertex beside 1 is a quarter of the width of the elements off there.
        done = self.run_program("solve", graded("51.6", "verified", 2))
        self.assertEqual(done.returncode, 2)
        message = done.stderr.decode()
        for words in ("/triangulation/grading", "258/5", "up to 32", "up to 52"):
            self.assertIn(words, message)
        self.assertIn("Remark: the grading 81/2 makes elements of the width 3.2e-13 at level 2",
                      self.expect(0, "solve", graded("40.5", "direct", 2)))

    def test_small_angles_are_refused_before_the_work(self):
        found = self.edge("--angle", "3", "--rho", "1/2", code=1)
        self.assertIsNone(found["exponents"])
        self.assertIn("the angle is too small", found["not_counted"])
        self.assertIsNotNone(found["smallest"])

    def test_bad_input_is_named(self):
        for words, named in ((("--angle", "0", "--rho", "1/2"), "--angle"), (("--angle", "360", "--rho", "1/2"), "--angle"),
                             (("--angle", "x", "--rho", "1/2"), "--angle"), (("--angle", "90", "--rho", "1"), "--rho"),
                             (("--angle", "90", "--rho", "-1/2"), "--rho"), (("--angle", "90"), "--rho"),
                             (("--angle", "90", "--rho", "1/2", "--rho-other", "2"), "--rho-other"),
                             (("--angle", "90", "--rho", "1/2", "--up-to", "0"), "--up-to"),
                             (("--angle", "90", "--rho", "1/2", "--digits", "0"), "--digits")):
            self.assertIn(named, self.refused(2, "edge", *words), words)


def eval_fraction(text):
    """A fraction as a number of mpmath."""
    numerator, _, denominator = text.partition("/")
    return mpf(numerator) / mpf(denominator or "1")


if __name__ == "__main__":
    unittest.main()
