# SPDX-License-Identifier: GPL-3.0-or-later
"""u_n and its iterate at points, and the elements for pyvista."""
import sys
import types
import unittest
from unittest import mock

import numpy as np
import radcert as rc

from module import ModuleTest, unit_cube

x, y, z = rc.xyz()


class At(ModuleTest):
    def setUp(self):
        super().setUp()
        self.problem = rc.Problem(rc.ellipsoid(1, "3/4", "1/2"), reflectivity="1/2", solution=rc.exp(x/2 + y/3 - z/4),
                                  levels=[0, 1], basis=rc.inset(1, "1/6"))
        self.room = rc.Problem(rc.box(1, 2, 3), reflectivity="0.7", emission={"ceiling": 1, "*": 0}, levels=[0, 1])

    def test_at_a_node_both_are_the_value_of_the_system(self):
        # u_n(v) = E(v) + K u_n(v) is what the system demands; here K u_n comes from another quadrature.
        for problem in (self.problem, self.room, self.room.replace(basis=rc.inset(2, "1/10")),
                        self.problem.replace(basis=rc.symmetric(2), surface="octahedron")):
            solution = problem.solve()
            for level in (0, 1):
                nodes = solution[level]
                chosen = slice(None, None, max(1, len(nodes.points) // 12))
                found = solution.at(nodes.points[chosen], level)
                values = nodes.values.value[chosen]
                self.assertTrue((found.distance < 1e-14).all())
                self.assertEqual(found.pieces, nodes.pieces[chosen])
                np.testing.assert_allclose(found.u_n.value, values, rtol=1e-12, atol=1e-14)
                difference = np.abs(found.iterated.value - values)
                self.assertTrue((difference <= found.iterated.radius + nodes.values.radius[chosen]).all(), difference)
                self.assertTrue((found.iterated.radius < 1e-7).all())
                self.assertFalse(found.iterated.guaranteed.any() or found.u_n.guaranteed.any())

    def test_the_iterate_is_nearer_to_a_smooth_solution(self):
        solution = self.problem.solve()
        generator = np.random.default_rng(1)
        points = generator.normal(size=(12, 3))
        points = points / np.linalg.norm(points, axis=1)[:, None] * [1, 0.75, 0.5]
        exact = np.exp(points[:, 0] / 2 + points[:, 1] / 3 - points[:, 2] / 4)
        for level in (0, 1):
            found = solution.at(points, level)
            of_u_n = np.abs(found.u_n.value - exact).max()
            of_iterate = np.abs(found.iterated.value - exact).max()
            self.assertLess(of_u_n, 1.5 * solution.errors["uniform_error"].value[level])
            self.assertLess(of_iterate, of_u_n / 4)
            self.assertLess(of_iterate, 3 * solution.errors["node_error"].value[level])

    def test_a_furnace_is_bright_at_every_point(self):
        solution = rc.Problem(rc.Mesh(unit_cube()), reflectivity="3/4", emission=1, levels=[0]).solve()
        found = solution.at([(0.25, 0.4, 0), (1, 0.1, 0.7)])
        for values in (found.u_n, found.iterated):
            self.assertTrue((np.abs(values.value - 4) <= values.radius + 1e-14).all())

    def test_u_n_is_what_pictures_show(self):
        solution = self.room.solve()
        level = solution[1]
        # Near the corners of an element, inside it.
        k = 7
        inside = 0.999999 * level.corners[k] + 0.000001 * level.corners[k].mean(axis=0)
        found = solution.at(inside, iterated=False)
        np.testing.assert_allclose(found.u_n.value, level.corner_values[k], rtol=1e-4)
        self.assertIsNone(found.iterated)

    def test_points_are_moved_to_the_surface_or_refused(self):
        solution = self.room.solve([0])
        found = solution.at([(0.3, 0.4, 1e-4)], tolerance=1e-3)
        np.testing.assert_allclose(found.distance, 1e-4, rtol=1e-9)
        np.testing.assert_array_equal(found.points, [(0.3, 0.4, 0)])
        for points, place, words in [([(0.3, 0.4, 1e-4)], "points/0", "is off the surface, by 1e-04"),
                                     ([(0.3, 0.4, 0), (9, 9, 9)], "points/1", "is off the surface"),
                                     ([(np.nan, 0, 0)], "points/0", "is not finite"),
                                     ([(np.inf, 0, 0)], "points/0", "is not finite"),
                                     ([(0, 0)], "points", "has another shape"), ((0, 0, 0), "points", "has another shape"),
                                     ("points", "points", "is of the type str"), ([(0, 0, 1j)], "points", "is no array of doubles"),
                                     ([(0.5, 0, 0)], "points/0", "lies on an edge")]:
            error = self.refused(lambda points=points: solution.at(points), words)
            self.assertEqual(error.place, place)
        self.assertEqual(len(solution.at([(0.5, 0, 0)], iterated=False).pieces), 1)
        self.assertEqual(solution.at(np.empty((0, 3))).points.shape, (0, 3))
        big = np.zeros((6, 6))
        big[::3, ::2] = [(0.3, 0.4, 0), (0.5, 0.7, 0)]
        self.assertEqual(len(solution.at(big[::3, ::2]).pieces), 2)
        for tolerance in (-1, np.nan, 2):
            self.refused(lambda tolerance=tolerance: solution.at([(0, 0, 0)], tolerance=tolerance), "tolerance")
        for level in (1, -2):
            with self.assertRaises(IndexError):
                solution.at([(0, 0, 0)], level)
        with self.assertRaises(TypeError):
            solution.at([(0.3, 0.4, 0)], iterated="no")

    def test_around_a_corner_a_furnace_is_bright_too(self):
        corners = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
        vertices = [(a, b, c) for c in (0, 1) for a, b in corners]
        triangles = [t for a, b, c in [(0, 1, 3), (1, 2, 3), (0, 3, 5), (3, 4, 5)] for t in ((a, b, c), (6 + a, 6 + c, 6 + b))]
        for k in range(6):
            n = (k + 1) % 6
            triangles += [(k, 6 + k, n), (n, 6 + k, 6 + n)]
        room = rc.Problem(rc.Mesh((vertices, triangles)), reflectivity="1/2", emission="1/2", levels=[1], iterated=True)
        solution = room.solve()
        found = solution.at([(0.3, 0.4, 0), (1.4, 1, 0.25), (1, 1.7, 0.6)])
        self.assertTrue((np.abs(found.iterated.value - 1) <= found.iterated.radius).all())
        self.assertTrue((found.iterated.radius < 1e-9).all())
        level = solution.to_json()["levels"][0]
        self.assertLess(level["iterated"]["difference"]["value"], 1e-10)
        self.assertIsNone(level["iterated"]["error"])

    def test_what_has_no_such_values_says_so(self):
        meshless = rc.Problem("sphere", reflectivity="1/2", emission=1, levels=[0], basis="shepard").solve()
        self.refused(lambda: meshless.at([(0, 0, 1)]), "is not for a meshless basis")
        interpolated = self.problem.replace(geometry={"interpolated": 2}).solve([0])
        self.refused(lambda: interpolated.at([(1, 0, 0)]), "is not for an interpolated geometry")

    def test_a_function_of_python_has_an_iterate_without_a_radius(self):
        solution = self.problem.replace(solution=lambda p: np.exp(p[:, 0] / 2 + p[:, 1] / 3 - p[:, 2] / 4)).solve([0])
        found, known = solution.at([(1, 0, 0)]), self.problem.solve([0]).at([(1, 0, 0)])
        np.testing.assert_allclose(found.iterated.value, known.iterated.value, rtol=1e-10)
        self.assertTrue(np.isinf(found.iterated.radius).all() and np.isinf(found.u_n.radius).all())

    def test_elements_for_pyvista(self):
        class PolyData:
            def __init__(self, points, faces):
                self.points, self.faces = points, faces
                self.point_data, self.cell_data, self.field_data = {}, {}, {}

        solution = self.room.solve()
        with mock.patch.dict(sys.modules, {"pyvista": types.SimpleNamespace(PolyData=PolyData)}):
            shown, coarse = solution.to_pyvista(), solution.to_pyvista(0)
        level = solution[1]
        cells = shown.faces.reshape(-1, 4)
        self.assertTrue((cells[:, 0] == 3).all())
        np.testing.assert_array_equal(shown.points[cells[:, 1:]], level.corners)
        np.testing.assert_array_equal(shown.point_data["u_n"][cells[:, 1:]], level.corner_values)
        self.assertEqual([shown.field_data["pieces"][place] for place in shown.cell_data["piece"]], level.corner_pieces)
        self.assertEqual(len(coarse.faces), 4 * len(solution[0].corners))
        with mock.patch.dict(sys.modules, {"pyvista": None}), self.assertRaises(ImportError):
            solution.to_pyvista()


if __name__ == "__main__":
    unittest.main()
