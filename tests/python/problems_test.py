# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems stated and solved in Python: against the program, known solutions and each other."""
import io
import json
import os
import subprocess
import unittest

import numpy as np
import radcert as rc

from module import EXAMPLES, ModuleTest, unit_cube, without


def figures(document):
    """The numbers of a solution, without how long it took and how it was asked for."""
    return without(document, "command", "timing")


class Problems(ModuleTest):
    def setUp(self):
        super().setUp()
        self.room = rc.Problem(rc.box(4, 3, "5/2"), reflectivity={"floor": "0.3", "ceiling": "0.8", "*": rc.Q(1, 2)},
                               emission={"ceiling": 1, "*": 0}, levels=[0, 1])

    def test_the_numbers_are_those_of_the_program_to_the_bit(self):
        x, y, z = rc.xyz()
        file = self.folder / "problem.json"
        for problem in (self.room,
                        rc.Problem(rc.ellipsoid(1, "3/4", "1/2"), reflectivity="1/2", solution=rc.exp(x / 2 + y / 3 - z / 4),
                                   levels=[0, 1], basis=rc.symmetric(2), solver="direct"),
                        rc.Problem("cube", reflectivity="1/2", solution=x * y + z, levels=range(2), solver="verified"),
                        rc.Problem("cube", reflectivity="1/2", emission=1, levels=[0], basis="shepard")):
            problem.write(file)
            self.assertEqual(figures(problem.solve().to_json()), figures(self.program("solve", file)))
            self.assertEqual(rc.Problem.read(file).to_json(), problem.to_json())

    def test_a_problem_file_solves_as_the_program_solves_it(self):
        file = EXAMPLES / "01_solve" / "1_two_piece.json"
        self.assertEqual(figures(rc.Problem.read(file).solve().to_json()), figures(self.program("solve", file)))

    def test_arrays_are_the_figures_of_the_levels(self):
        x, y, _ = rc.xyz()
        solution = rc.Problem("ellipsoid", reflectivity="1/2", solution=rc.exp(x + y), levels=range(3)).solve()
        levels = solution.to_json()["levels"]
        self.assertEqual(solution.levels.tolist(), [0, 1, 2])
        self.assertEqual(solution.unknowns.tolist(), [level["unknowns"] for level in levels])
        self.assertEqual(solution.elements.tolist(), [level["elements"] for level in levels])
        self.assertEqual(solution.mesh_size.tolist(), [level["mesh_size"] for level in levels])
        for name, error in solution.errors.items():
            self.assertEqual(error.value.tolist(), [level[name]["value"] for level in levels])
            self.assertEqual([radius if np.isfinite(radius) else None for radius in error.radius.tolist()],
                             [level[name]["radius"] for level in levels])
            self.assertEqual(error.guaranteed.tolist(), [level[name]["guaranteed"] for level in levels])
        self.assertEqual(set(solution.errors), {"discretisation_error", "node_error", "uniform_error", "l2_error",
                                                "mean_error"})
        self.assertEqual(solution.eoc("node_error")[1:].tolist(), [level["node_order"] for level in levels[1:]])
        self.assertTrue(np.isnan(solution.eoc()[0]))
        self.refused(lambda: solution.eoc("uniform_error"), "discretisation_error, node_error")
        # Linear functions at alpha = 1/6 on a smooth surface: order 4 at the nodes, not reached yet.
        self.assertGreater(solution.eoc("node_error")[-1], 2)

    def test_values_at_the_nodes(self):
        x, y, z = rc.xyz()
        u = 1 + x * y + z
        solution = rc.Problem("cube", reflectivity="1/2", solution=u, levels=[0, 1], solver="verified").solve()
        self.assertEqual(len(solution), 2)
        for level, unknowns, error in zip(solution, solution.unknowns, solution.errors["node_error"].value):
            self.assertEqual(level.points.shape, (unknowns, 3))
            np.testing.assert_allclose(level.solution, u(level.points), rtol=1e-15)
            self.assertTrue(level.values.guaranteed.all())
            found = np.abs(level.values.value - level.solution).max()
            self.assertLessEqual(abs(found - error), level.values.radius.max() + 1e-12)
            np.testing.assert_allclose(np.linalg.norm(level.normals, axis=1), 1)
            self.assertEqual(level.corners.shape, (len(level.corner_pieces), 3, 3))
            self.assertEqual(level.corner_values.shape, (len(level.corner_pieces), 3))
            self.assertEqual(set(level.pieces), set(rc.cube().pieces))
            self.assertEqual(len(level.elements), unknowns)
        self.assertEqual(solution[-1].points.tolist(), solution[1].points.tolist())
        with self.assertRaises(IndexError):
            solution[2]
        with self.assertRaises(IndexError):
            solution[-3]

    def test_values_outlive_what_they_came_from(self):
        solution = self.room.solve([1])
        points, values = solution[0].points, solution[0].values.value
        before = points.copy(), values.copy()
        means = solution.means["floor"]
        del solution
        for _ in range(3):
            self.room.solve([1])
        np.testing.assert_array_equal(points, before[0])
        np.testing.assert_array_equal(values, before[1])
        self.assertEqual(len(means.value), 1)

    def test_a_closed_furnace_is_bright_everywhere(self):
        # u = E/(1 - rho).
        for solver in ("direct", "gmres", "neumann", "verified"):
            solution = rc.Problem("cube", reflectivity="3/4", emission=1, levels=[1], solver=solver).solve()
            values = solution[0].values
            self.assertTrue((np.abs(values.value - 4) <= values.radius + 1e-14).all(), solver)
            self.assertEqual(solution.solvers, [solver])

    def test_a_given_solver_and_levels_stand_in_for_the_problems(self):
        solution = self.room.solve(range(1), solver="direct")
        self.assertEqual((solution.solvers, solution.levels.tolist()), (["direct"], [0]))
        self.assertEqual(self.room.solve(2).levels.tolist(), [2])

    def test_files_are_written(self):
        solution = self.room.replace(solution="x", emission=None).solve([0, 1])
        for method, name, words in [("to_latex", "t.tex", "tabular"), ("to_csv", "e.csv", "unknowns"),
                                    ("nodes_to_csv", "n.csv", "normal_x"), ("to_vtu", "u.vtu", "VTKFile"),
                                    ("to_ply", "u.ply", "ply"), ("plot", "p.svg", "<svg")]:
            path = self.folder / name
            getattr(solution, method)(path)
            self.assertIn(words, path.read_text(encoding="utf-8"))
        self.assertEqual(solution.fits, solution.to_json()["orders"])
        self.assertEqual(set(solution.fits), {"discretisation_error", "node_error"})
        self.assertEqual((solution.seconds.shape, bool((solution.seconds > 0).all())), ((2,), True))
        self.assertIn("<svg", solution.plot()._repr_svg_())
        self.refused(lambda: self.room.solve([0]).plot(), "has no error that is positive")

    def test_finished_levels_are_kept(self):
        first = self.room.solve(store=self.folder / "kept")
        again = self.room.solve(store=self.folder / "kept")
        # Seconds too come from the store.
        self.assertEqual(first.to_json()["timing"]["levels"], again.to_json()["timing"]["levels"])
        self.assertEqual(figures(first.to_json()), figures(again.to_json()))

    def test_a_store_that_cannot_be_written_is_said(self):
        import warnings

        file = self.folder / "file"
        file.write_text("no folder", encoding="utf-8")
        mesh = rc.Mesh(unit_cube())
        for action in (lambda: self.room.solve([0], store=file / "kept"),
                       lambda: mesh.factors(store=file / "kept"),
                       lambda: rc.Problem("cube", reflectivity="1/2", emission={"floor": 1, "*": 0}).guarantee(
                           "0.5", store=file / "kept"),
                       lambda: rc.verify("ac98/equation_37", store=file / "kept")):
            with self.assertWarnsRegex(rc.StoreWarning, "finished work is not kept: .*file"):
                action()
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with self.assertRaises(rc.StoreWarning):
                    action()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.room.solve([0], store=self.folder / "kept")
            self.room.solve([0])

    def test_progress_is_told_in_this_thread(self):
        import threading

        heard = []
        self.room.solve([0, 1], progress=lambda fraction, words: heard.append((fraction, words, threading.get_ident())))
        self.assertTrue(heard)
        self.assertEqual(heard[-1][:2], (1, "done"))
        self.assertEqual({thread for _, _, thread in heard}, {threading.get_ident()})
        fractions = [fraction for fraction, _, _ in heard]
        self.assertEqual(fractions, sorted(fractions))

    def test_a_bar_is_drawn_to_its_end(self):
        stream = io.StringIO()
        self.room.solve([0, 1], progress=rc.progress_bar(stream))
        *_, last = stream.getvalue().split("\r")
        self.assertIn("100 % done", last)
        self.assertTrue(last.endswith("\n"))
        self.assertNotIn(".]", last)

    def test_the_grading_of_edges_is_that_of_the_nodes(self):
        graded = {basis.degree: rc.Problem("cube", basis=basis, reflectivity="1/2", emission=1, grading="edges").to_json()
                  for basis in (rc.inset(0), rc.inset(2, "1/10"))}
        nodes = rc.Problem("cube", basis=rc.Basis(nodes=rc.orbit(rc.Q(1, 6)) + rc.orbit(rc.Q(9, 20))), reflectivity="1/2",
                           emission=1, grading="edges").to_json()
        self.assertEqual(nodes["triangulation"], graded[2]["triangulation"])
        self.assertNotEqual(nodes["triangulation"], graded[0]["triangulation"])

    def test_bounds_enclose_what_radii_say(self):
        values = self.room.solve([1], solver="verified")[0].values
        for value, radius, lower, upper in zip(*(map(rc.Q, each) for each in (values.value, values.radius, values.lower,
                                                                              values.upper))):
            self.assertLessEqual(lower, value - radius)
            self.assertLessEqual(value + radius, upper)

    def test_what_a_file_could_not_say_is_refused_with_its_place(self):
        for changes, place, words in [
            ({"basis": {"family": "inset", "degree": 1, "alpha": "1/3"}}, "/basis/alpha", "is outside the range"),
            ({"basis": rc.inset(11, "1/6")}, "/basis/degree", "from 0 to 10"),
            ({"basis": "gausian"}, "/basis", ""),
            ({"reflectivity": float("nan")}, "/reflectivity", "is not finite"),
            ({"reflectivity": {"floor": float("inf"), "*": 0}}, "/reflectivity/floor", "is not finite"),
            ({"reflectivity": {"floor": 0}}, "/reflectivity", "leaves out the piece"),
            ({"reflectivity": {3: 0}}, "/reflectivity", "is a key and no text"),
            ({"reflectivity": "1/2 +"}, "/reflectivity", "is no expression"),
            ({"reflectivity": 1j}, "/reflectivity", "is of the type complex"),
            ({"reflectivity": np.ones(3)}, "/reflectivity", "is an array"),
            ({"reflectivity": lambda points: points}, "/reflectivity", "is of the type function"),
            ({"emission": {"roof": 1, "*": 0}}, "/emission/roof", "unknown key"),
            ({"emission": None}, "/solution", "is missing"),
            ({"emission": 1, "solution": 1}, "/emission", "stands beside a solution"),
            ({"levels": []}, "/triangulation/levels", ""),
            ({"levels": [1, 0]}, "/triangulation/levels/1", "does not ascend"),
            ({"levels": [0.5]}, "/triangulation/levels/0", ""),
            ({"levels": ["a"]}, "/triangulation/levels/0", ""),
            ({"grading": 0}, "/triangulation/grading", ""),
            ({"solver": "gmre"}, "/solver/name", "did you mean gmres?"),
            ({"solver": {"name": "gmres", "tolerance": -1}}, "/solver/tolerance", ""),
            ({"label": 3}, "/label", "is a number"),
            ({"surface": "cub"}, "/surface/name", "did you mean cube?"),
            ({"surface": {"name": "cube", "edge": 0}}, "/surface", ""),
        ]:
            with self.subTest(changes=changes):
                error = self.refused(lambda changes=changes: self.room.replace(**changes), words)
                self.assertTrue(error.place.startswith(place), error)
                self.assertEqual(error.source, "problem")
        self.refused(lambda: rc.box(4, 0, 1), "surface: /b", "is outside the range")
        self.refused(lambda: rc.box(4, float("nan"), 1), "is not finite")
        self.refused(lambda: rc.surface("bx"), "did you mean box?")
        with self.assertRaises(TypeError):
            rc.box(1, 2, 3, 4)
        with self.assertRaises(TypeError):
            rc.box(1, a=1)
        with self.assertRaises(TypeError):
            self.room.replace(colour="red")
        with self.assertRaises(AttributeError):
            rc.no_such_surface
        endless = [0]
        endless.append(endless)
        self.refused(lambda: self.room.replace(geometry=endless), "is nested too deeply")

    def test_what_only_the_whole_shows_is_refused(self):
        self.refused(self.room.replace(reflectivity=2).check, "/reflectivity")
        self.refused(lambda: self.room.replace(reflectivity=1).solve(), "problem")
        self.refused(lambda: self.room.replace(solution="1/x").solve(), "problem")
        self.refused(lambda: self.room.solve(range(30)), "memory")

    def test_a_float_is_a_double_and_a_text_is_exact(self):
        self.assertEqual(self.room.replace(reflectivity=0.1).to_json()["reflectivity"], 0.1)
        self.assertEqual(self.room.replace(reflectivity="0.1").to_json()["reflectivity"], "0.1")
        self.assertEqual(rc.box(0.1, "0.1", 1).parameters, {"a": 0.1, "b": "0.1", "c": 1})
        written = self.room.replace(surface=rc.box(0.1, "0.1", rc.Q(1, 3))).to_json()["surface"]
        self.assertEqual((written["b"], written["c"]), ("1/10", "1/3"))
        self.assertEqual(rc.Q(written["a"]), rc.Q(0.1))

    def test_every_surface_and_solver_is_named(self):
        names = [entry["name"] for entry in rc.surfaces()]
        self.assertIn("ellipsoid", names)
        for name in names:
            self.assertTrue(getattr(rc, name).__doc__)
            self.assertIn(name, dir(rc))
        for entry in rc.surfaces():
            if entry["served"]:
                made = getattr(rc, entry["name"])()
                self.assertEqual((made.name, made.pieces), (entry["name"], entry["pieces"]))
        self.refused(rc.torus, "curved parts that hide each other")
        self.assertEqual(set(rc.solvers()) & {"direct", "gmres", "neumann", "verified"},
                         {"direct", "gmres", "neumann", "verified"})

    def test_the_schema_takes_what_is_written(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("no jsonschema")
        schema = json.loads(subprocess.run([os.environ["RADCERT"], "schema", "problem"], capture_output=True, check=True)
                            .stdout)
        jsonschema.validate(self.room.to_json(), schema)


if __name__ == "__main__":
    unittest.main()
