# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes from files and from arrays."""
import unittest

import numpy as np
import radcert as rc

from module import EXAMPLES, ModuleTest, unit_cube, without


class Meshes(ModuleTest):
    def test_arrays_and_a_file_are_one_mesh(self):
        points, triangles, groups = unit_cube()
        lines = [f"v {x} {y} {z}" for x, y, z in points]
        for (a, b, c), group in zip(triangles, groups):
            lines += [f"g {group}", f"f {a + 1} {b + 1} {c + 1}"]
        (self.folder / "cube.obj").write_text("\n".join(lines) + "\n", encoding="utf-8")
        of_file = rc.Mesh(self.folder / "cube.obj")
        of_arrays = rc.Mesh((points, triangles, groups))
        self.assertEqual(of_file.points.tolist(), of_arrays.points.tolist())
        self.assertEqual(of_file.triangles.tolist(), of_arrays.triangles.tolist())
        self.assertEqual(of_file.face_groups, of_arrays.face_groups)
        ours, theirs = of_arrays.factors(), of_file.factors()
        self.assertEqual(ours.names, theirs.names)
        self.assertEqual(ours.value.tolist(), theirs.value.tolist())
        self.assertEqual(ours.radius.tolist(), theirs.radius.tolist())

    def test_pieces_have_their_measures(self):
        mesh = rc.Mesh(unit_cube())
        for pieces in (mesh.groups, mesh.pieces):
            self.assertEqual(len(pieces), 6)
            for piece in pieces:
                self.assertEqual(piece.triangles, 2)
                self.assertLessEqual(abs(piece.area - 1), piece.area_radius)
                self.assertLess(piece.area_radius, 1e-14)
        floor = next(group for group in mesh.groups if group.name == "floor")
        np.testing.assert_allclose(floor.normal, [0, 0, 1])
        np.testing.assert_allclose(floor.centroid, [0.5, 0.5, 0])

    def test_the_survey_is_that_of_the_program(self):
        file = EXAMPLES / "08_factors_of_an_stl" / "attic.stl"
        ours = rc.Mesh(file).survey()
        theirs = self.program("surface", file)
        self.assertEqual(without(ours, "command", "file"), without(theirs, "command", "file"))

    def test_a_unit_is_told_and_nothing_converted(self):
        plain, metres = rc.Mesh(unit_cube()), rc.Mesh(unit_cube(), unit="mm")
        self.assertEqual((plain.unit, metres.unit), (None, "mm"))
        self.assertEqual(metres.groups[0].area, plain.groups[0].area)
        file = EXAMPLES / "03_own_surface" / "house.obj"
        self.assertEqual(without(rc.Mesh(file, unit="in").survey(), "command"),
                         without(self.program("surface", file, "--unit", "in"), "command"))
        for mesh, area_unit in ((plain, ""), (metres, "mm^2")):
            mesh.factors().surfaces_to_csv(self.folder / "surfaces.csv")
            rows = (self.folder / "surfaces.csv").read_text(encoding="utf-8").splitlines()
            self.assertEqual({row.split(",")[-1] for row in rows[1:]}, {area_unit})
        for source in (unit_cube(), file):
            self.refused(lambda source=source: rc.Mesh(source, unit="km", repair=["align"], two_sided=["floor"]),
                         "unit", "mm, cm, m, in")
            self.refused(lambda source=source: rc.Mesh(source, angle=None, repair=["align"], two_sided=["floor"]),
                         "angle", "an angle in degrees")

    def test_a_room_that_was_turned_is_aligned(self):
        points, triangles, groups = unit_cube()
        turn = np.array([[np.cos(0.3), -np.sin(0.3), 0], [np.sin(0.3), np.cos(0.3), 0], [0, 0, 1]])
        turned = np.round(np.array(points) @ turn.T, 6)
        with self.assertWarnsRegex(rc.FactorWarning, "mended: turned by 17.1887 degrees"):
            factors = rc.Mesh((turned, triangles, groups), repair="align").factors(certified=True)
        self.assertTrue(factors.guaranteed)
        np.testing.assert_allclose(factors.value, rc.Mesh(unit_cube()).factors().value, atol=1e-6)
        self.refused(lambda: rc.Mesh(unit_cube(), repair="alignment"), "repair", "align, triangulate")

    def test_arrays_of_any_layout_give_one_mesh(self):
        points, triangles, groups = unit_cube()
        plain = rc.Mesh((points, triangles, groups))
        array = np.array(points, dtype=float)
        corners = np.array(triangles)
        wide = np.zeros((16, 3))
        wide[::2] = array
        for other_points in (array, np.asfortranarray(array), array.astype(np.float32), array.astype(int), wide[::2],
                             array.astype(">f8")):
            for other_corners in (corners, np.asfortranarray(corners), corners.astype(np.uint8), corners.astype(">i4")):
                mesh = rc.Mesh((other_points, other_corners, np.array(groups)))
                self.assertEqual(mesh._mesh.digest, plain._mesh.digest)

    def test_a_mesh_keeps_its_numbers_when_the_arrays_change_or_go(self):
        points, triangles, _ = unit_cube()
        array, corners = np.array(points, dtype=float), np.array(triangles)
        mesh = rc.Mesh((array, corners))
        before = mesh.points.copy()
        array[:] = np.nan
        corners[:] = 77
        del array, corners
        np.testing.assert_array_equal(mesh.points, before)
        # What a mesh gives outlives it.
        kept, numbers = mesh.points, mesh.triangles
        del mesh
        np.testing.assert_array_equal(kept, before)
        self.assertEqual(numbers.shape, (12, 3))

    def test_wrong_arrays_are_refused_with_place_and_value(self):
        points, triangles, groups = unit_cube()
        array, corners = np.array(points, dtype=float), np.array(triangles)

        def changed(source, place, value):
            out = source.copy()
            out[place] = value
            return out

        for mesh, place, words in [
            ((changed(array, (3, 1), np.nan), corners), "point 3", "is not finite"),
            ((changed(array, (3, 1), np.inf), corners), "point 3", "is not finite"),
            ((changed(array, (0, 2), 1e61), corners), "point 0", "is too large"),
            ((array, changed(corners, (7, 0), 8)), "triangle 7", "of a vertex that is not there"),
            ((array, changed(corners, (7, 0), -1)), "triangle 7", "is no index"),
            ((array, changed(corners, 5, [1, 1, 2])), "triangle 5", "of two corners of one face"),
            ((array[:, :2], corners), "points", "has another shape"),
            ((array.ravel(), corners), "points", "has another shape"),
            ((array + 0j, corners), "points", "is no array of doubles"),
            ((array.astype(str), corners), "points", "is no array of doubles"),
            ((array.astype(object), corners), "points", "is no array of doubles"),
            ((array.astype(np.longdouble), corners), "points", "is no array of doubles"),
            ((array.astype(bool), corners), "points", "is no array of doubles"),
            ((np.array([[2**53 + 1, 0, 0]] * 8), corners), "points", "from 2^53 on"),
            ((np.array([[-(2**63), 0, 0]] * 8), corners), "points", "from 2^53 on"),
            ((np.array([[2**64 - 1, 0, 0]] * 8, dtype=np.uint64), corners), "points", "from 2^53 on"),
            (([[0, 0, 0], [1, 0]], corners), "points", "is no array"),
            ((None, corners), "points", "is None"),
            ((array, corners + 0.5), "triangles", "is no array of whole numbers"),
            ((array, corners[:, :2]), "triangles", "has another shape"),
            ((array, np.full((12, 3), 2**64 - 1, dtype=np.uint64)), "triangle 0", "is no index"),
            ((array, corners, groups[:-1]), "groups", "are not one a triangle"),
        ]:
            with self.subTest(place=place, words=words):
                error = self.refused(lambda mesh=mesh: rc.Mesh(mesh, name="room"), words)
                self.assertEqual((error.source, error.place), ("room", place))
        self.refused(lambda: rc.Mesh((array, np.empty((0, 3), dtype=int))), "has no faces")
        self.refused(lambda: rc.Mesh((np.empty((0, 3)), corners)), "has no vertices")
        self.refused(lambda: rc.Mesh((array, corners), front="front"), "auto, right-hand, left-hand")
        self.refused(lambda: rc.Mesh((array, corners), repair=["all"]), "triangulate, vertices")
        self.refused(lambda: rc.Mesh((array, corners), angle=181), "from 0 to 180")
        self.refused(lambda: rc.Mesh((array, corners), name="room", repair="all"), "triangulate, vertices")
        self.refused(lambda: rc.Mesh("room.stl"), "room.stl")
        self.refused(lambda: rc.Mesh("room.txt"), "room.txt")
        for wrong in (3, None, (array,), (1, 2, 3, 4)):
            with self.assertRaises(TypeError):
                rc.Mesh(wrong)

    def test_a_bent_face_is_refused_by_its_file(self):
        path = self.folder / "bent.off"
        path.write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n4 0 1 2 3\n", encoding="utf-8")
        mesh = rc.Mesh(path)
        for action in (lambda: mesh.pieces, mesh.survey, lambda: mesh.factors(space=True)):
            error = self.refused(action, "do not lie in one plane")
            self.assertEqual(error.source, str(path))
        self.assertIsNone(mesh.triangles)
        self.assertEqual(rc.Mesh(path, repair="triangulate").groups[0].triangles, 2)

    def test_a_mesh_is_the_surface_of_a_problem(self):
        mesh = rc.Mesh(unit_cube())
        # A closed surface of one reflectivity and one emission: u = E/(1 - rho), at every node.
        problem = rc.Problem(mesh, reflectivity="1/2", emission=1, levels=[1], basis=rc.inset(0))
        np.testing.assert_allclose(problem.solve()[0].values.value, 2, atol=1e-11)
        self.assertEqual(problem.to_json()["surface"]["digest"], mesh._mesh.digest)
        # Closed meshes are rooms, whichever way their corners run.
        turned = problem.replace(surface=rc.Mesh((mesh.points, mesh.triangles[:, ::-1])))
        np.testing.assert_allclose(turned.solve()[0].values.value, 2, atol=1e-11)
        plates = rc.Mesh(unit_cube(), two_sided="floor")
        self.refused(lambda: problem.replace(surface=plates), "two_sided", "is for factors")
        doubled = rc.Mesh((mesh.points, mesh.triangles[[0, 0, 1]]))
        self.refused(lambda: problem.replace(surface=doubled), "mesh: ")


if __name__ == "__main__":
    unittest.main()
