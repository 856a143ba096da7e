# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of Python in place of formulas: the same numbers without a proof, and whatever they do wrong is refused."""
import gc
import json
import threading
import unittest

import numpy as np
import radcert as rc
from radcert import _core

from module import ModuleTest

x, y, z = rc.xyz()


def exponential(points):
    return np.exp(points[:, 0] / 2 + points[:, 1] / 3 - points[:, 2] / 4)


class Functions(ModuleTest):
    def setUp(self):
        super().setUp()
        self.formula = rc.Problem(rc.ellipsoid(1, "3/4", "1/2"), reflectivity="1/2", solution=rc.exp(x/2 + y/3 - z/4),
                                  levels=[0, 1])
        self.problem = self.formula.replace(solution=exponential)
        self.room = rc.Problem(rc.box(1, 2, 3), reflectivity="1/2", emission=1 + x*y, levels=[1])

    def test_an_array_of_doubles_in_rows_is_read_where_it_lies(self):
        points = np.random.default_rng(1).uniform(size=(6, 3))
        seen = []

        def first(rows):
            seen.append(rows)
            return rows[:, 0]

        for array, shared in ((points, True), (points[2:], True), (points[::2], False), (np.asfortranarray(points), False),
                              (points.astype(np.float32), False)):
            values = _core.function_values(first, array, "place")
            self.assertEqual(np.shares_memory(seen[-1], array), shared)
            np.testing.assert_array_equal(seen[-1], array)
            np.testing.assert_array_equal(values, array[:, 0])

    def test_a_solution_gives_the_errors_of_its_formula(self):
        exact, found = self.formula.solve(), self.problem.solve()
        self.assertEqual((exact.by_functions, found.by_functions), ([], ["solution"]))
        for name, error in exact.errors.items():
            np.testing.assert_allclose(found.errors[name].value, error.value, rtol=1e-9, atol=1e-13)
            self.assertFalse(found.errors[name].guaranteed.any())
        for one, other in zip(exact, found):
            np.testing.assert_allclose(other.values.value, one.values.value, rtol=1e-12)
            np.testing.assert_allclose(other.solution, exponential(one.points), rtol=1e-15)
            self.assertFalse(other.values.guaranteed.any())
            # How the function rounds is not known, and so no radius is.
            self.assertTrue(np.isinf(other.values.radius).all())

    def test_an_emission_gives_what_its_formula_gives(self):
        exact = self.room.solve()
        found = self.room.replace(emission=lambda points: 1 + points[:, 0] * points[:, 1]).solve()
        self.assertEqual(found.by_functions, ["emission"])
        np.testing.assert_allclose(found[0].values.value, exact[0].values.value, rtol=1e-13)
        np.testing.assert_allclose(found[0].emission, exact[0].emission, rtol=1e-15)
        for piece, mean in exact.means.items():
            np.testing.assert_allclose(found.means[piece].value, mean.value, rtol=1e-13)
            self.assertFalse(found.means[piece].guaranteed.any())

    def test_results_say_that_they_are_estimated_by_a_function(self):
        found = self.problem.solve([0])
        self.assertEqual(found.to_json()["problem"]["solution"], "estimated, by a function of Python: exponential")
        self.assertIn("estimated, by a function of Python", json.dumps(self.problem.to_json()))
        self.refused(lambda: self.problem.write(self.folder / "p.json"), "/solution", "which no file has")
        self.assertFalse((self.folder / "p.json").exists())
        # Formulas are evaluated where errors are drawn; there is none here, and no wrong one.
        found.to_vtu(self.folder / "u.vtu")
        self.assertNotIn("error", (self.folder / "u.vtu").read_text(encoding="utf-8"))

    def test_nothing_is_proved_by_a_function(self):
        error = self.refused(lambda: self.problem.solve(solver="verified"), "proves nothing where the solution")
        self.assertEqual(error.place, "/solver/name")
        cube = rc.Problem("cube", reflectivity="1/2", emission=lambda points: points[:, 0] * 0 + 1, levels=[0])
        self.refused(lambda: cube.solve(solver="verified"), "proves nothing where the emission")
        for action in (lambda: cube.guarantee("0.5"), lambda: cube.guarantee("0.5", certificate=True),
                       lambda: cube.replace(surface=rc.ellipsoid(1, 1, 1)).guarantee("0.5")):
            error = self.refused(action, "a function of Python")
            self.assertTrue(error.place.startswith("/emission"), error)

    def test_no_store_mistakes_one_function_for_another(self):
        def solved(scale):
            problem = self.room.replace(emission=lambda points: scale + 0 * points[:, 0])
            return problem.solve(store=self.folder / "kept")[0].values.value

        np.testing.assert_allclose(solved(3.0), 3 * solved(1.0), rtol=1e-12)
        self.assertFalse((self.folder / "kept").exists())

    def test_what_a_function_gives_is_an_array_of_a_number_a_point(self):
        for wrong, words in [(lambda p: 1.0, "has another shape"), (lambda p: p, "has another shape"),
                             (lambda p: p[:, :1], "has another shape"), (lambda p: np.ones(len(p) + 1), "has another shape"),
                             (lambda p: p[:, 0] * 1j, "is no array of doubles"), (lambda p: ["a"] * len(p), "array"),
                             (lambda p: None, "is None"), (lambda p: np.array([object()] * len(p)), "is no array of doubles"),
                             (lambda p: p[:, 0].astype(np.longdouble), "is no array of doubles"),
                             (lambda p: "1", "is of the type str")]:
            for part in ("solution", "emission"):
                error = self.refused(lambda wrong=wrong, part=part: self.room.replace(**{part: wrong}).solve(), words)
                self.assertEqual((error.source, error.place), ("problem", f"/{part}"))
        for value, words in [(np.nan, "is not a number at node 0"), (np.inf, "is infinite at node 0")]:
            error = self.refused(lambda value=value: self.room.replace(emission=lambda p: np.full(len(p), value)).solve(),
                                 words)
            self.assertEqual(error.place, "/emission")
        # Between the nodes, where Ku is taken.
        edge = self.room.replace(solution=lambda p: np.where(np.abs(p[:, 0] - 0.5) < 0.02, np.nan, 1.0))
        self.refused(edge.solve, "/solution", "is not finite")

    def test_what_means_the_numbers_is_taken(self):
        expected = self.room.replace(emission=1).solve()[0].values.value
        for kind in (lambda p: np.ones(len(p), dtype=np.float32), lambda p: np.ones(len(p), dtype=int),
                     lambda p: np.ones((len(p), 2))[:, 0], lambda p: [1.0] * len(p), lambda p: np.ones(2 * len(p))[::2]):
            np.testing.assert_array_equal(self.room.replace(emission=kind).solve()[0].values.value, expected)

    def test_what_a_function_raises_is_raised(self):
        class Mine(Exception):
            pass

        for error in (Mine("own"), KeyboardInterrupt(), SystemExit(3), MemoryError()):
            def failing(points, error=error):
                raise error

            for part in ("solution", "emission"):
                with self.assertRaises(type(error)) as caught:
                    self.room.replace(**{part: failing}).solve()
                self.assertIs(caught.exception, error)
        with self.assertRaises(TypeError):
            self.room.replace(emission=lambda: 1).solve()
        # The next one runs.
        self.assertEqual(len(self.room.solve()), 1)

    def test_an_expression_is_a_formula_and_a_class_nothing(self):
        self.assertEqual(self.room.replace(emission=1 + x*y).solve().by_functions, [])
        self.refused(lambda: self.room.replace(emission=float), "/emission")
        self.refused(lambda: self.room.replace(reflectivity=lambda p: p[:, 0]), "/reflectivity", "is of the type function")
        self.refused(lambda: self.room.replace(emission={"*": lambda p: p[:, 0]}), "/emission/*", "is of the type function")

    def test_a_function_outlives_its_owner_and_goes_with_its_problem(self):
        import weakref

        class Light:
            def __call__(self, points):
                return np.ones(len(points))

        light = Light()
        alive = weakref.ref(light)
        problem = self.room.replace(emission=light)
        del light
        gc.collect()
        np.testing.assert_allclose(problem.solve()[0].emission, 1)
        self.assertIn("Light", problem.to_json()["emission"])
        del problem
        gc.collect()
        self.assertIsNone(alive())

    def test_a_function_may_compute_and_threads_may_share_it(self):
        def light(points):
            return np.full(len(points), float(rc.reference("cube_opposite_faces", 5)))

        problem, found = self.room.replace(emission=light), []

        def work():
            found.append(problem.solve()[0].values.value.tobytes())

        threads = [threading.Thread(target=work) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((len(found), len(set(found))), (3, 1))

    def test_a_mother_function(self):
        basis = {"family": "meshless", "mother": "max(0, 1 - r)^4 * (4*r + 1)", "support": 1, "radius": {"neighbour": 10},
                 "distance": "euclidean_with_normal_factor", "sites": {"poisson_disk": "1/2", "seed": 1},
                 "weights": "integrated", "coefficients": "interpolated", "normalise": "partition_of_unity"}
        problem = rc.Problem(rc.ellipsoid(1, "6/5", "3/2"), reflectivity="1/2", emission=1 + z, levels=[0], basis=basis,
                             solver="neumann")

        def wendland(r):
            return max(0.0, 1 - r) ** 4 * (4 * r + 1)

        exact, own = problem.solve(), problem.replace(basis={**basis, "mother": wendland}).solve()
        self.assertEqual(own.by_functions, ["mother"])
        np.testing.assert_allclose(own[0].values.value, exact[0].values.value, rtol=1e-12)
        self.assertIn("a function of Python: ", own.to_json()["problem"]["basis"]["mother"])
        self.assertFalse(own[0].values.guaranteed.any())
        # Its support is what the dict says.
        self.assertEqual(own.to_json()["problem"]["basis"]["support"], 1)
        for wrong, words in [(lambda r: "1", "is no number"), (lambda r: None, "is no number"), (lambda r: np.ones(2), "is no number"),
                             (lambda r: float("nan"), "is not finite"), (lambda r: 1j, "is no number")]:
            error = self.refused(lambda wrong=wrong: problem.replace(basis={**basis, "mother": wrong}).solve(), "/basis/mother")
            self.assertEqual((error.place, words in str(error)), ("/basis/mother", True), error)
        with self.assertRaises(ZeroDivisionError):
            problem.replace(basis={**basis, "mother": lambda r: 1 / 0}).solve()
        self.refused(lambda: self.room.replace(basis={"family": "inset", "degree": 1, "alpha": "1/6", "mother": wendland}),
                     "/basis")


if __name__ == "__main__":
    unittest.main()
