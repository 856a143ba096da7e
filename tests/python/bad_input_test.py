# SPDX-License-Identifier: GPL-3.0-or-later
"""What nobody should pass and somebody will: a Python exception, never a crash."""
import gc
import pickle
import unittest

import numpy as np
import radcert as rc

from module import ModuleTest, unit_cube


class Raising:
    """An object that raises whatever it is asked for."""

    def __getattr__(self, name):
        raise RuntimeError(name)


class Counting:
    """An index that changes the list that it stands in."""

    def __init__(self, owner):
        self.owner = owner

    def __index__(self):
        self.owner.clear()
        gc.collect()
        return 1


class Shifting(dict):
    def __init__(self, *arguments):
        super().__init__(*arguments)
        self["a"] = self

    def items(self):
        raise RuntimeError("items")


class BadInput(ModuleTest):
    def setUp(self):
        super().setUp()
        self.problem = rc.Problem("cube", reflectivity="1/2", emission=1, levels=[0])

    def test_errors_are_whole_after_a_pipe(self):
        error = self.refused(lambda: self.problem.replace(levels=[1, 0]))
        copy = pickle.loads(pickle.dumps(error))
        self.assertIs(type(copy), rc.InputError)
        self.assertEqual((str(copy), copy.source, copy.place, copy.value, copy.problem, copy.allowed),
                         (str(error), error.source, error.place, error.value, error.problem, error.allowed))
        for kind in (rc.EnvironmentError, rc.AccuracyNotReached, rc.ContractViolation, rc.Interrupted):
            self.assertIs(type(pickle.loads(pickle.dumps(kind("words")))), kind)

    def test_words_for_numbers_and_masked_arrays_are_refused_by_name(self):
        mesh = rc.Mesh(unit_cube())
        with self.assertRaisesRegex(TypeError, "accuracy is a number, not str: '1e-3'"):
            mesh.factors(accuracy="1e-3")
        factors = mesh.factors(by="group")
        for name in ("tolerance", "relative", "halfwidth"):
            with self.assertRaisesRegex(TypeError, f"{name} is a number, not str: '1%'"):
                factors.compare(factors.value, **{name: "1%"})
        points, triangles = (np.asarray(part) for part in unit_cube()[:2])
        error = self.refused(lambda: rc.Mesh((np.ma.masked_array(points, mask=points > 2), triangles)))
        self.assertIn("masked array", error.problem)

    def test_strange_objects_are_refused(self):
        for strange in (Raising(), object(), type, rc, b"1/2", {1, 2}, iter([1]), slice(1), ..., NotImplemented, 1j,
                        np.datetime64("2020-01-01"), np.zeros(2, dtype=[("a", "f8")]), memoryview(b"1")):
            with self.subTest(strange=str(type(strange))):
                for key in ("reflectivity", "emission", "solver", "geometry", "label", "quadrature", "basis"):
                    with self.assertRaises((rc.InputError, TypeError, RuntimeError)):
                        self.problem.replace(**{key: strange})
                if not isinstance(strange, (set, type(iter([])))):
                    with self.assertRaises((rc.InputError, TypeError)):
                        self.problem.replace(levels=strange)
                with self.assertRaises((rc.InputError, TypeError)):
                    rc.Mesh(strange)
                with self.assertRaises((rc.InputError, TypeError, RuntimeError)):
                    rc.Mesh((strange, [(0, 1, 2)]))
                with self.assertRaises((rc.InputError, TypeError, RuntimeError)):
                    rc.Q(strange)
                with self.assertRaises((rc.InputError, TypeError)):
                    rc.reference(strange)

    def test_objects_that_change_what_they_stand_in(self):
        levels = [0, 1]
        levels.append(Counting(levels))
        with self.assertRaises(rc.InputError):
            self.problem.replace(levels=levels)
        by_piece = {}
        by_piece["*"] = [Counting(by_piece), Counting(by_piece)]
        with self.assertRaises(rc.InputError):
            self.problem.replace(reflectivity=by_piece)
        self.refused(lambda: self.problem.replace(geometry=Shifting()), "is nested too deeply")

    def test_texts_that_no_file_has(self):
        for text in ("", "\0", "x\0y", "\udcff", "1" * 100_000, "(" * 1000, "ä", "１/２"):
            with self.subTest(text=text[:10]):
                with self.assertRaises((rc.InputError, UnicodeEncodeError)):
                    self.problem.replace(reflectivity=text)
                with self.assertRaises((rc.InputError, UnicodeEncodeError)):
                    rc.Q(text)
                with self.assertRaises((rc.InputError, UnicodeEncodeError, TypeError)):
                    rc.reference(text)
                with self.assertRaises((rc.InputError, rc.EnvironmentError, ValueError, TypeError)):
                    rc.Mesh(text + ".stl")

    def test_numbers_of_any_size(self):
        self.refused(lambda: rc.Q(10**2000), "is no number")
        self.refused(lambda: rc.Q("1e-401"), "is no number")
        for huge in (2**63, 2**64, 10**400, -(2**63) - 1):
            self.refused(lambda huge=huge: self.problem.replace(levels=[huge]), "/triangulation/levels/0")
            with self.assertRaises((rc.InputError, TypeError)):
                self.problem.replace(basis=rc.inset(huge, "1/6"))
            with self.assertRaises((rc.InputError, TypeError)):
                rc.reference("cube_opposite_faces", huge)

    def test_numbers_of_any_kind_mean_themselves(self):
        kinds = [np.float64(0.5), np.float32(0.5), np.float16(0.5), rc.Q(1, 2), "1/2", np.array(0.5), 0.5]
        values = {self.problem.replace(reflectivity=kind).solve()[0].values.value.tobytes() for kind in kinds}
        self.assertEqual(len(values), 1)

    def test_what_is_given_outlives_its_owner_in_any_order(self):
        mesh = rc.Mesh(unit_cube())
        factors = mesh.factors(by="triangle")
        comparison = factors.compare(factors.value + 0.5)
        pair, value, area = comparison.pairs[0], factors.value, factors.area.value
        names = factors.names
        record = rc.reference("cube_opposite_faces", 30)
        ball, routes = record.ball, record.routes
        before = value.copy(), area.copy(), str(ball), pair.from_
        del mesh, factors, comparison, record
        gc.collect()
        np.testing.assert_array_equal(value, before[0])
        np.testing.assert_array_equal(area, before[1])
        self.assertEqual((str(ball), pair.from_), before[2:])
        self.assertEqual((len(names), len(routes)), (12, 2))
        value[:] = 7  # an array that came out is its owner's, and nobody else's
        self.assertEqual(float(value.max()), 7)

    def test_what_is_written_into_an_array_does_not_reach_the_result(self):
        factors = rc.Mesh(unit_cube()).factors()
        values = factors.value
        first = factors.value
        first[:] = 0
        np.testing.assert_array_equal(factors.value, values)


if __name__ == "__main__":
    unittest.main()
