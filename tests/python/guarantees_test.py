# SPDX-License-Identifier: GPL-3.0-or-later
"""Enclosures of solutions of the equation itself, and their certificates."""
import json
import unittest
from fractions import Fraction

import numpy as np
import radcert as rc

from module import ModuleTest, without


class Guarantees(ModuleTest):
    def setUp(self):
        super().setUp()
        self.cube = rc.Problem(rc.cube(), reflectivity="1/2", emission={"floor": 1, "*": 0}, levels=[0])

    def test_words_that_are_true_or_false_are_nothing_else(self):
        problem = rc.Problem("cube", reflectivity="1/2", emission=1)
        for wrong in ("no", "c.json", 1, 0, None, [], np.ones(1)):
            with self.assertRaisesRegex(TypeError, "certificate is True or False"):
                problem.guarantee("0.5", certificate=wrong)
        for name in ("certified", "rays", "space"):
            with self.assertRaisesRegex(TypeError, f"{name} is True or False, not str"):
                rc.cube().factors(**{name: "no"})
        self.assertTrue(rc.cube().factors(certified=np.bool_(True)).guaranteed)

    def test_means_are_proved_and_those_of_the_program(self):
        enclosure = self.cube.guarantee("0.2")
        self.assertTrue(enclosure.reached)
        self.assertEqual((enclosure.wanted, enclosure.hindrance), (rc.Q("0.2"), ""))
        self.assertLessEqual(enclosure.width, 0.2)
        self.assertEqual(set(enclosure.means), set(rc.cube().pieces))
        for mean in enclosure.means.values():
            self.assertTrue(mean.guaranteed)
            self.assertLessEqual(2 * mean.radius, 0.2)
        # Another route: certificates inside the library.
        known = rc.reference("continuous_mean_cube_floor_rho_1/2")
        floor = enclosure.means["floor"]
        self.assertLessEqual(abs(floor.value - float(known)), floor.radius + float(known.ball.radius))
        self.cube.write(self.folder / "cube.json")
        theirs = self.program("solve", self.folder / "cube.json", "--guarantee", "0.2")
        self.assertEqual(without(enclosure.to_json(), "command", "timing"), without(theirs, "command", "timing"))

    def test_a_furnace_is_known_everywhere(self):
        # u = E/(1 - rho) = 2.
        furnace = rc.Problem(rc.ellipsoid(1, "5/4", "3/2"), reflectivity="1/2", emission=1, levels=[0])
        values = furnace.guarantee("1e-6", of="values", points=[(1, 0, 0), (0, 0, "3/2")]).points
        self.assertEqual([value["at"] for value in values], [(1, 0, 0), (0, 0, rc.Q("3/2"))])
        for value in values:
            self.assertTrue(value["guaranteed"])
            self.assertLessEqual(abs(value["value"] - 2), value["radius"])
        enclosure = furnace.guarantee("1e-6", of="function")
        self.assertLessEqual(enclosure.function["sup"], 1e-6)
        enclosure.to_vtu(self.folder / "u.vtu")
        self.assertIn("bound", (self.folder / "u.vtu").read_text(encoding="utf-8"))
        self.refused(lambda: self.cube.guarantee("1").to_vtu(self.folder / "u.vtu"), "these are means")

    def test_a_certificate_is_verified_and_a_changed_one_refused(self):
        enclosure = self.cube.guarantee("0.5", certificate=True)
        path = self.folder / "means.json"
        enclosure.certificate_to(path)
        # That without a number all elements are looked at, the certificates of ellipsoids show.
        check = rc.check_certificate(path, 3, seed="a")
        self.assertTrue(check.verified)
        self.assertEqual((check.looked_at, check.elements > 3), (3, True))
        self.assertEqual(set(check.means), set(enclosure.means))
        for piece, (midpoint, radius) in check.means.items():
            mean = enclosure.means[piece]
            self.assertLessEqual(abs(float(midpoint) - mean.value), float(radius) + mean.radius)
        document = json.loads(path.read_text(encoding="utf-8"))
        document["means"][0]["midpoint"] = "1/7"
        path.write_text(json.dumps(document), encoding="utf-8")
        check = rc.check_certificate(path)
        self.assertFalse(check.verified)
        self.assertIn("/digest", check.refusal)
        self.assertEqual(check.means, {})
        self.refused(lambda: rc.check_certificate(path, 0), "from 1 on")
        self.refused(lambda: rc.check_certificate(self.folder / "nothing.json"), "nothing.json")
        with self.assertRaises(TypeError):
            self.cube.guarantee("0.5").certificate_to(path)

    def test_values_have_certificates(self):
        face = rc.Problem(rc.tetrahedron(), reflectivity="3/10", emission="7/10", levels=[0])
        enclosure = face.guarantee(3, of="values", certificate=True)
        path = self.folder / "values.json"
        enclosure.certificate_to(path)
        check = rc.check_certificate(path, 2)
        self.assertTrue(check.verified)
        self.assertEqual(check.means, {})
        self.assertEqual([point["at"] for point in check.points], [point["at"] for point in enclosure.points])
        for point in check.points:
            midpoint, radius = point["value"]
            self.assertLessEqual(abs(midpoint - 1), radius)

    def test_polyhedra_have_certificates_of_functions(self):
        face = rc.Problem(rc.tetrahedron(), reflectivity="3/10", emission="7/10", levels=[0])
        path = self.folder / "function.json"
        face.guarantee(1, of="function", outside="1/7", certificate=True).certificate_to(path)
        check = rc.check_certificate(path, 2)
        self.assertTrue(check.verified)
        self.assertLessEqual(2 * check.function, 1)
        self.assertIn(check.outside, (0, Fraction(1, 7)))

    def test_ellipsoids_have_certificates_of_functions(self):
        room = rc.Problem(rc.ellipsoid(1, "6/5", "3/2"), reflectivity="1/2 + x/8", emission="1/2 - x/8", levels=[0])
        path = self.folder / "function.json"
        room.guarantee("1e-4", of="function", certificate=True).certificate_to(path)
        check = rc.check_certificate(path)
        self.assertTrue(check.verified)
        self.assertEqual(check.elements, check.looked_at)
        self.assertLessEqual(2 * check.function, 1e-4)
        self.assertEqual(check.outside, 0)
        room.guarantee("1e-4", certificate=True).certificate_to(path)
        check = rc.check_certificate(path, 5)
        self.assertTrue(check.verified)
        self.assertIsNone(check.function)
        [(midpoint, radius)] = check.means.values()
        self.assertLessEqual(abs(midpoint - 1), radius)

    def test_several_emissions_add_up(self):
        # u = 1 where E = 1 - rho, and u is linear in E.
        faces = rc.tetrahedron().pieces
        halves = {name: {piece: "7/10" if (k < 2) == (name == "first") else 0 for k, piece in enumerate(faces)}
                  for name in ("first", "second")}
        room = rc.Problem(rc.tetrahedron(), reflectivity="3/10", emission="7/10", levels=[0])
        enclosure = room.guarantee("1", emissions=halves)
        self.assertEqual(set(enclosure.emissions), {"first", "second"})
        for piece in faces:
            parts = [enclosure.emissions[name].means[piece] for name in halves]
            self.assertLessEqual(abs(sum(part.value for part in parts) - 1), sum(part.radius for part in parts))
        by_piece = room.guarantee("1", emissions="by piece").emissions
        self.assertEqual(set(by_piece), set(faces))
        self.refused(lambda: room.guarantee("0.5", emissions={"one": "no"}), "emissions")

    def test_what_cannot_be_enclosed_is_refused(self):
        self.refused(lambda: self.cube.guarantee(0), "/width")
        self.refused(lambda: self.cube.guarantee(float("nan")), "is not finite")
        self.refused(lambda: self.cube.guarantee("0.1", of="mean"), "/of")
        self.refused(lambda: self.cube.guarantee("0.1", of="values", points=[(2, 2, 2)]), "/points")
        self.refused(lambda: self.cube.guarantee("0.1", of="values", points=[(float("inf"), 0, 0)]), "points/0/0")
        self.refused(lambda: self.cube.replace(emission=None, solution=1).guarantee("0.1"), "emission")
        self.refused(lambda: self.cube.replace(surface="two_piece").guarantee("0.1"))

    def test_finished_work_is_kept(self):
        first = self.cube.guarantee("0.5", store=self.folder / "kept")
        self.assertEqual(first.means, self.cube.guarantee("0.5", store=self.folder / "kept").means)
        self.assertTrue(any((self.folder / "kept").rglob("*")))

    def test_a_mesh_of_arrays_is_enclosed_like_the_surface_that_it_is(self):
        from module import unit_cube

        points, triangles, _ = unit_cube()
        mesh = rc.Mesh((points, triangles))
        enclosure = rc.Problem(mesh, reflectivity="1/2", emission=1, levels=[0]).guarantee("0.2")
        for mean in enclosure.means.values():
            self.assertLessEqual(abs(mean.value - 2), mean.radius)


if __name__ == "__main__":
    unittest.main()
