# SPDX-License-Identifier: GPL-3.0-or-later
"""Configuration factors: against closed forms, sums and the program."""
import unittest
import warnings
from fractions import Fraction

import numpy as np
import radcert as rc

from module import EXAMPLES, ModuleTest, unit_cube

ATTIC = EXAMPLES / "08_factors_of_an_stl" / "attic.stl"


class FactorsOfScenes(ModuleTest):
    def test_the_cube_has_its_closed_forms(self):
        opposite = rc.reference("cube_opposite_faces", 20).ball
        for certified in (False, True):
            factors = rc.Mesh(unit_cube()).factors(by="group", certified=certified)
            self.assertEqual(factors.guaranteed, certified)
            names = factors.names
            value, radius = factors.value, factors.radius
            self.assertEqual(value.shape, (6, 6))
            i, j = names.index("floor"), names.index("ceiling")
            self.assertLessEqual(abs(value[i, j] - float(opposite)), radius[i, j] + 1e-16)
            self.assertEqual(np.diag(value).tolist(), [0] * 6)
            self.assertEqual(np.diag(radius).tolist(), [0] * 6)
            self.assertTrue((factors.closure <= factors.row_sum.radius).all())
            np.testing.assert_array_less(np.abs(factors.area.value - 1), factors.area.radius + 1e-300)
            self.assertLess(factors.reciprocity, 1e-15)
            self.assertIsNone(factors.to_space)
            self.assertEqual(factors.failures, [])

    def test_entries_are_those_of_the_square_array(self):
        factors = rc.Mesh(unit_cube()).factors(by="triangle")
        rows, columns, value, radius = factors.entries()
        square = np.zeros((12, 12))
        square[rows, columns] = value
        np.testing.assert_array_equal(square, factors.value)
        self.assertEqual(len(value), np.count_nonzero(factors.value))
        self.assertTrue((radius > 0).all())

    def test_the_numbers_are_those_of_the_program(self):
        factors = rc.Mesh(ATTIC).factors(by="piece", certified=True)
        theirs = self.program("factors", ATTIC, "--by", "piece", "--certified")
        names = [surface["name"] for surface in theirs["surfaces"]]
        self.assertEqual(factors.names, names)
        value, radius = factors.value, factors.radius
        for entry in theirs["factors"]:
            i, j = names.index(entry["from"]), names.index(entry["to"])
            self.assertEqual((value[i, j], radius[i, j]), (entry["factor"], entry["radius"]))
        self.assertEqual(len(theirs["factors"]), np.count_nonzero(value))
        # Rows and columns are told apart.
        self.assertGreater(np.abs(value - value.T).max(), 0.01)

    def test_a_surface_of_the_catalogue(self):
        factors = rc.box(1, 2, 3).factors(by="piece", certified=True)
        self.assertEqual(sorted(factors.names), sorted(rc.box().pieces))
        self.assertTrue((factors.closure <= factors.row_sum.radius).all())
        # What leaves a large face arrives at a small one, and less of it than the other way.
        exchange = factors.area.value[:, None] * factors.value
        np.testing.assert_allclose(exchange, exchange.T, rtol=1e-13)
        # Another box has other factors.
        self.assertNotEqual(factors.value.tolist(), rc.box(1, 1, 3).factors(by="piece").value.tolist())
        self.assertEqual(rc.cube().factors(by="triangle", level=1).value.shape, (48, 48))
        # Sides that are no doubles are not rounded, or nothing is proved of them.
        box = rc.box("21/11", "51/86", "7/12").factors(by="triangle", certified=True)
        at = box.names.index("west/1")
        self.assertTrue(box.guaranteed)
        self.assertLessEqual(abs(Fraction(357, 2064) - Fraction(float(box.area.value[at]))),
                             Fraction(float(box.area.radius[at])))
        long = rc.box("1/3", "0.12345678901234567890123", 1)
        self.refused(lambda: long.factors(certified=True), "that no doubles hold")
        with self.assertWarnsRegex(rc.FactorWarning, "those of the rounded ones"):
            long.factors()
        self.refused(lambda: rc.sphere().factors(), "is curved")
        self.refused(lambda: rc.cube().factors(level=9), "from 0 to 8")

    def test_rays_agree_with_contours(self):
        mesh = rc.Mesh(unit_cube())
        rays, exact = mesh.factors(rays=True, accuracy=1e-3), mesh.factors()
        self.assertTrue((np.abs(rays.value - exact.value) <= rays.radius + exact.radius).all())
        self.refused(lambda: mesh.factors(rays=True, certified=True), "proves nothing")

    def test_an_open_scene_says_what_leaves_it(self):
        points, triangles, groups = unit_cube()
        lamp = rc.Mesh((points, triangles[:-2], groups[:-2]), name="open cube")
        self.refused(lamp.factors, "open cube", "is open: 4 edges", "space for what leaves it")
        factors = lamp.factors(space=True, certified=True)
        self.assertTrue(factors.open)
        sums = factors.row_sum.value + factors.to_space.value
        self.assertTrue((np.abs(sums - 1) <= factors.row_sum.radius + factors.to_space.radius + 1e-15).all())
        self.refused(lambda: rc.Mesh(unit_cube()).factors(space=True), "is for open scenes")

    def test_scenes_of_which_factors_mean_nothing_are_refused(self):
        points, triangles, groups = unit_cube()
        turned = [triangles[0][::-1], *triangles[1:]]
        self.refused(rc.Mesh((points, turned, groups)).factors, "has reversed normals")
        crossing = ([*points, (0.5, 0.5, -1), (0.5, 0.5, 2), (0.6, 0.7, 0.5)], [*triangles, (8, 9, 10)])
        self.refused(rc.Mesh(crossing).factors)
        thin = ([*points, (0.25, 0, 0), (0.5, 0, 0), (0.75, 0, 0)], [*triangles, (8, 9, 10)])
        self.refused(rc.Mesh(thin).factors, "corners on one line")
        mesh = rc.Mesh(unit_cube())
        self.refused(lambda: mesh.factors(by="wall"), "triangle, piece, group")
        self.refused(lambda: mesh.factors(accuracy=0), "from 1e-12 to 0.1")
        self.refused(lambda: mesh.factors(accuracy=float("nan")), "from 1e-12 to 0.1")
        self.refused(lambda: rc.Mesh(unit_cube(), two_sided=["floor"]).factors(certified=True), "two_sided")
        self.refused(lambda: rc.Mesh(unit_cube(), two_sided=["roof"]).factors(), "roof")

    def test_a_matrix_that_sees_nothing_warns(self):
        points, triangles, groups = unit_cube()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            rc.Mesh((points, triangles, groups), front="left-hand").factors(space=True)
        self.assertTrue(caught)
        self.assertTrue(all(issubclass(each.category, rc.FactorWarning) for each in caught))
        self.assertIn("sees nothing", str(caught[0].message) + str(caught[-1].message))
        self.assertIn("front right-hand", "".join(str(each.message) for each in caught))

    def test_pieces_are_those_of_the_mesh(self):
        points, triangles, _ = unit_cube()
        for angle, count in ((30, 6), (91, 1)):
            mesh = rc.Mesh((points, triangles), angle=angle)
            self.assertEqual(len(mesh.pieces), count)
            self.assertEqual(mesh.factors(by="piece").names, [piece.name for piece in mesh.pieces])

    def test_finished_work_is_kept_and_gives_the_same_bits(self):
        mesh = rc.Mesh(unit_cube())
        first = mesh.factors(by="triangle", store=self.folder / "kept")
        self.assertTrue(any((self.folder / "kept").rglob("*")))
        second = mesh.factors(by="triangle", store=self.folder / "kept")
        self.assertEqual(first.value.tolist(), second.value.tolist())


class Comparisons(ModuleTest):
    def setUp(self):
        super().setUp()
        self.factors = rc.Mesh(unit_cube()).factors(certified=True)

    def test_what_agrees_and_what_differs(self):
        value = self.factors.value
        self.assertTrue(self.factors.compare(value, tolerance=1e-12).agrees)
        wrong = value.copy()
        i, j = self.factors.names.index("floor"), self.factors.names.index("east")
        wrong[i, j] += 0.01
        comparison = self.factors.compare(wrong, tolerance=1e-4)
        self.assertFalse(comparison.agrees)
        (worst,) = comparison.worst(1)
        self.assertEqual((worst.from_, worst.to, worst.verdict), ("floor", "east", "differs"))
        self.assertAlmostEqual(worst.difference, 0.01)
        self.assertEqual(comparison.counts()["differs"], 1)
        self.assertTrue(self.factors.compare(np.round(value, 3), halfwidth=5.1e-4).agrees)
        self.assertTrue(self.factors.compare(value * 1.009, relative=0.01).agrees)
        comparison.to_csv(self.folder / "pairs.csv")
        self.assertIn("floor,east", (self.folder / "pairs.csv").read_text(encoding="utf-8"))
        comparison.to_svg(self.folder / "pairs.svg")
        self.assertIn("<svg", (self.folder / "pairs.svg").read_text(encoding="utf-8"))

    def test_a_file_of_its_own_agrees(self):
        self.factors.to_csv(self.folder / "factors.csv")
        comparison = self.factors.compare(self.folder / "factors.csv")
        self.assertTrue(comparison.agrees)
        self.assertEqual(comparison.counts()["differs"], 0)
        self.factors.surfaces_to_csv(self.folder / "surfaces.csv")
        self.assertIn("area", (self.folder / "surfaces.csv").read_text(encoding="utf-8"))

    def test_a_cause_is_guessed(self):
        factors = rc.Mesh(ATTIC).factors(by="group")
        self.assertIn("without 1/pi", " ".join(pair.cause for pair in factors.compare(factors.value * np.pi).pairs))

    def test_wrong_input_is_refused_with_its_place(self):
        value = self.factors.value
        bad = value.copy()
        bad[3, 5] = np.nan
        self.assertEqual(self.refused(lambda: self.factors.compare(bad), "is not finite").place, "other/3/5")
        for wrong in (value[:5], value.ravel(), value.astype(object), value + 0j, None, 3):
            self.assertEqual(self.refused(lambda wrong=wrong: self.factors.compare(wrong)).place, "other")
        self.refused(lambda: self.factors.compare("nothing.csv"), "nothing.csv")
        self.refused(lambda: self.factors.compare(value, tolerance=-1), "tolerance")
        self.refused(lambda: self.factors.compare(value, tolerance=float("nan")), "tolerance")

    def test_a_cupboard_without_a_bottom_is_told_what_it_lacks(self):
        points, triangles, groups = unit_cube()
        low, high = np.array([0.375, 0.375, 0]), np.array([0.625, 0.75, 0.5])
        corners = low + np.array(points) * (high - low)
        outwards = [(c + 8, b + 8, a + 8) for a, b, c in triangles]
        with_bottom = rc.Mesh((points + corners.tolist(), triangles + outwards, groups + ["cupboard"] * 12))
        bottom = [k for k, (a, b, c) in enumerate(outwards) if corners[[a - 8, b - 8, c - 8], 2].max() == 0]
        sides = [triangle for k, triangle in enumerate(outwards) if k not in bottom]
        with self.assertWarnsRegex(rc.FactorWarning, "contact of floor and cupboard"):
            found = with_bottom.factors(by="group")
        self.assertLess(found.closure.max(), 1e-4)
        for front in ("auto", "right-hand"):
            without = rc.Mesh((points + corners.tolist(), triangles + sides, groups + ["cupboard"] * 10), front=front)
            self.refused(lambda without=without: without.factors(by="group"), "needs a bottom of its own")


if __name__ == "__main__":
    unittest.main()
