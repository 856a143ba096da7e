# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact numbers, balls and reference values."""
import sys
import types
import unittest
from decimal import Decimal
from fractions import Fraction
from unittest import mock

import numpy as np
import radcert as rc
from mpmath import mp, mpf

from module import ModuleTest, without


class ExactNumbers(ModuleTest):
    def test_what_python_has_enters_exactly(self):
        self.assertEqual(rc.Q(1, 3), Fraction(1, 3))
        self.assertEqual(rc.Q("0.1"), Fraction(1, 10))
        self.assertEqual(rc.Q("1/3"), Fraction(1, 3))
        self.assertEqual(rc.Q(Decimal("0.25")), Fraction(1, 4))
        self.assertEqual(rc.Q(0.1), Fraction(0.1))
        self.assertEqual(rc.Q(np.float32(0.1)), Fraction(float(np.float32(0.1))))
        self.assertEqual(rc.Q(np.int16(-7), np.uint8(3)), Fraction(-7, 3))
        self.assertEqual(rc.Q(10**300, 7), Fraction(10**300, 7))

    def test_what_is_no_number_is_refused_with_its_place(self):
        for wrong in (float("nan"), float("inf"), "", "one", "0x1", None, [1], True, 1j, np.longdouble("nan")):
            with self.subTest(wrong=wrong):
                self.assertEqual(self.refused(lambda wrong=wrong: rc.Q(wrong)).place, "numerator")
        self.assertIn("zero", str(self.refused(lambda: rc.Q(1, 0))))

    def test_what_a_float_does_not_hold_is_no_float(self):
        for wide in (np.longdouble("0.1"), np.longdouble(0.5)):
            self.assertIn("which no float holds", self.refused(lambda wide=wide: rc.Q(wide)).problem)
            self.assertEqual(rc.Q(float(wide)), Fraction(float(wide)))


class References(ModuleTest):
    def setUp(self):
        super().setUp()
        mp.dps = 80
        s = mp.sqrt(2)
        self.cube = 2 / mp.pi * (mp.log(mpf(4) / 3) / 2 + 2 * s * mp.atan(1 / s) - mp.pi / 2)  # Howell C-11

    def test_every_form_of_a_value_encloses_the_truth(self):
        truth = self.cube
        for digits in (1, 15, 40, 70):
            value = rc.reference("cube_opposite_faces", digits)
            self.assertEqual(value.digits, digits)
            self.assertTrue(value.guaranteed)
            self.assertLessEqual(mpf(value.radius), mpf(10) ** -digits)
            self.assertLessEqual(abs(mpf(value.midpoint) - truth), mpf(value.radius))
            ball = value.ball
            radius = mpf(ball.radius.numerator) / ball.radius.denominator
            self.assertLessEqual(abs(value.to_mpf() - truth), radius)
            interval = value.to_iv()
            self.assertTrue(interval.a <= truth <= interval.b)
            middle, off = ball.float_ball()
            self.assertLessEqual(abs(mpf(middle) - truth), mpf(off))
            lower, upper = ball.bounds()
            self.assertTrue(lower <= truth <= upper)
            middle, off = (mpf(part) for part in ball.decimal(9))
            self.assertLessEqual(abs(middle - truth), off)
            mantissa, exponent = ball.midpoint_binary
            self.assertEqual(ball.midpoint, Fraction(mantissa) * Fraction(2) ** exponent)
            self.assertAlmostEqual(float(value), float(truth), delta=2 * 10.0**-digits)

    def test_exact_forms_agree_with_each_other(self):
        ball = rc.reference("cube_opposite_faces", 50).ball
        self.assertTrue(ball.contains(ball.midpoint))
        self.assertTrue(ball.contains(ball.midpoint + ball.radius))
        self.assertFalse(ball.contains(ball.midpoint + 2 * ball.radius + Fraction(1, 10**70)))
        self.assertTrue(ball.overlaps(rc.reference("cube_opposite_faces", 5).ball))

    def test_a_family_takes_parameters_of_any_exact_kind(self):
        expected = rc.reference("coaxial_disks", 20, to_radius=2, distance=rc.Q(1, 2))
        x = mpf(1) + 4 + mpf("0.25")
        truth = (x - mp.sqrt(x * x - 16)) / 2
        self.assertLess(abs(expected.to_mpf() - truth), mpf("1e-20"))
        self.assertEqual(expected.parameters, {"from_radius": 1, "to_radius": 2, "distance": Fraction(1, 2)})
        for half in ("1/2", "0.5", 0.5, Decimal("0.5"), np.float64(0.5)):
            self.assertEqual(rc.reference("coaxial_disks", 20, to_radius=2, distance=half).midpoint, expected.midpoint)

    def test_a_value_is_that_of_the_program(self):
        ours = rc.reference("perpendicular_rectangles", 30, edge=5).to_json()
        theirs = self.program("reference", "perpendicular_rectangles", "--set", "edge=5", "--digits", 30)
        self.assertEqual(without(ours, "command"), without(theirs, "command"))

    def test_the_mean_of_a_continuous_solution_comes_with_its_certificates(self):
        value = rc.reference("continuous_mean_cube_floor_rho_1/2")
        self.assertTrue(value.guaranteed)
        self.assertEqual(len({route.certificate for route in value.routes}), 2)
        self.refused(lambda: rc.reference(value.name, 15), "is not proved by its certificate",
                     error=rc.AccuracyNotReached)
        self.refused(lambda: rc.reference(value.name, rho=1), "is one value")

    def test_all_names_are_listed_and_known(self):
        names = [entry["name"] for entry in rc.references()]
        self.assertEqual(len(names), len(set(names)))
        self.assertGreater(len(names), 80)
        for entry in rc.references():
            if entry["kind"] == "family":
                for default, allowed in entry["parameters"].values():
                    self.assertIsInstance(default, Fraction)
                    self.assertTrue(allowed)
        self.assertIn("perpendicular_rectangles", names)

    def test_wrong_input_is_named(self):
        error = self.refused(lambda: rc.reference("cube_oposite_faces"), "did you mean cube_opposite_faces?")
        self.assertEqual((error.source, error.value), ("reference", "cube_oposite_faces"))
        self.assertIsInstance(error, ValueError)
        for digits in (0, 1001, -3):
            self.refused(lambda digits=digits: rc.reference("cube_opposite_faces", digits), "from 1 to 1000")
        error = self.refused(lambda: rc.reference("coaxial_disks", distance=0), "a number > 0")
        self.assertEqual((error.source, error.value), ("distance", "0"))
        self.refused(lambda: rc.reference("coaxial_disks", distance=float("nan")), "is not finite")
        self.refused(lambda: rc.reference("coaxial_disks", height=1), "from_radius, to_radius, distance")
        self.refused(lambda: rc.reference("coaxial_disks_1_1_1", distance=1), "is one value")
        self.refused(lambda: rc.reference("edge_exponent_90", 10, rho="1e-30"), "was not reached",
                     error=rc.AccuracyNotReached)

    def test_python_flint_is_given_the_ball_exactly(self):
        # A stand-in that keeps what flint.arb takes: pairs (mantissa, exponent).
        given = []
        with mock.patch.dict(sys.modules, {"flint": types.SimpleNamespace(arb=lambda middle, radius: given.append((middle, radius)))}):
            value = rc.reference("cube_opposite_faces", 40)
            value.to_arb()
            exact = [rc.Q(mantissa) * rc.Q(2) ** exponent for mantissa, exponent in given.pop()]
            self.assertEqual(exact, [value.ball.midpoint, value.ball.radius])
        with mock.patch.dict(sys.modules, {"flint": None}), self.assertRaises(ImportError):
            value.to_arb()

    def test_python_flint_takes_a_ball_where_it_is_there(self):
        try:
            import flint  # noqa: F401
        except ImportError:
            self.skipTest("no python-flint")
        value = rc.reference("cube_opposite_faces", 40)
        arb = value.to_arb()
        self.assertTrue(arb.contains(flint.arb(value.ball.midpoint_binary)))
        self.assertLess(float(arb.rad()), 1e-39)


if __name__ == "__main__":
    unittest.main()
