# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of charts that Python computes: the numbers of the catalogue without a proof, and whatever is none is refused."""
import gc
import json
import threading
import unittest
import weakref

import numpy as np
import radcert as rc

from module import ModuleTest

x, y, z = rc.xyz()


def ground(P):
    return np.column_stack([P, np.zeros(len(P))])


def vault(P, height=0.5):
    s, t = P.T
    return np.column_stack([s, t, 4 * height * s * (1 - s)])


def hall():
    return rc.Surface(charts=[rc.Chart(ground, name="floor"), rc.Chart(vault, name="vault")], name="hall")


def box_of_charts(a, b, c):
    """A box by six affine maps, named and turned as it comes."""
    def face(origin, first, second):
        return lambda P: np.array(origin) + P[:, :1] * np.array(first) + P[:, 1:] * np.array(second)

    return rc.Surface(name="box", charts=[
        rc.Chart(face((0, 0, 0), (a, 0, 0), (0, b, 0)), name="floor"), rc.Chart(face((0, 0, c), (a, 0, 0), (0, b, 0)), name="ceiling"),
        rc.Chart(face((0, 0, 0), (0, b, 0), (0, 0, c)), name="west"), rc.Chart(face((a, 0, 0), (0, b, 0), (0, 0, c)), name="east"),
        rc.Chart(face((0, 0, 0), (0, 0, c), (a, 0, 0)), name="south"), rc.Chart(face((0, b, 0), (0, 0, c), (a, 0, 0)), name="north")])


def room():
    """The unit square below a vault, with walls: closed, of polynomials, two of its walls plane and not affine."""
    def wall(at):
        return lambda P: np.column_stack([P[:, 0], np.full(len(P), at), P[:, 1] * (1 + P[:, 0] * (1 - P[:, 0]))])

    return rc.Surface(name="room", charts=[
        rc.Chart(ground, name="floor"), rc.Chart(lambda P: vault(P, 0.25) + (0, 0, 1), name="vault"),
        rc.Chart(lambda P: np.column_stack([0 * P[:, 0], P]), name="west"),
        rc.Chart(lambda P: np.column_stack([0 * P[:, 0] + 1, P]), name="east"),
        rc.Chart(wall(0), name="south"), rc.Chart(wall(1), name="north")])


class OwnSurfaces(ModuleTest):
    def test_a_box_gives_what_that_of_the_catalogue_gives(self):
        exact = rc.Problem(rc.box(1, 2, 3), reflectivity={"floor": "0.3", "*": "1/2"}, emission=1 + x*y, levels=[0, 1],
                           solver="direct")
        own = exact.replace(surface=box_of_charts(1, 2, 3))
        found, expected = own.solve(), exact.solve()
        self.assertEqual((found.by_functions, expected.by_functions), (["surface"], []))
        for piece, mean in expected.means.items():
            # Other triangles, of the same means within what level 1 is worth.
            np.testing.assert_allclose(found.means[piece].value, mean.value, rtol=3e-3)
        self.assertEqual(sorted(own.to_json()["reflectivity"]), ["*", "floor"])
        # The integral of G over all faces is pi, which the library has looked at.
        np.testing.assert_allclose(found.norm_K.value, 0.5)
        for each in (found.norm_K, *found.means.values(), found[0].values):
            self.assertFalse(each.guaranteed.any())
        self.assertTrue(np.isinf(found[0].values.radius).all())

    def test_a_closed_room_with_a_vault(self):
        problem = rc.Problem(room(), reflectivity="1/2", solution=1 + x*y, levels=[0, 1], solver="direct")
        found = problem.solve()
        error = found.errors["node_error"]
        self.assertLess(error.value[1], error.value[0] / 2)
        self.assertFalse(error.guaranteed.any())
        self.assertTrue(np.isinf(error.radius).all())
        self.assertEqual(problem.solve([0])[0].values.value.tobytes(), found[0].values.value.tobytes())
        # Normals inwards, whichever way a chart turns.
        middle = np.array((0.5, 0.5, 0.6))
        self.assertTrue((np.einsum("ij,ij->i", found[-1].normals, middle - found[-1].points) > 0).all())
        # With u = 1 and rho constant E is 1 - rho everywhere, since the integral of G is pi, and u_n is 1.
        ones = problem.replace(solution=1, levels=[0]).solve()
        np.testing.assert_allclose(ones[0].values.value, 1, rtol=1e-12)
        np.testing.assert_allclose(ones[0].emission, 0.5, rtol=1e-12)
        self.assertFalse(ones[0].values.guaranteed.any())
        self.assertEqual((found.norm_K.value.tolist(), found.norm_K.guaranteed.any()), ([0.5, 0.5], False))

    def test_an_open_surface(self):
        problem = rc.Problem(hall(), reflectivity={"floor": "0.3", "vault": "1/2"}, solution=1 + x*y, levels=[0, 1])
        found = problem.solve()
        error = found.errors["node_error"].value
        self.assertLess(error[1], error[0] / 2)
        self.assertEqual(problem.to_json()["surface"], {"name": "estimated, by functions of Python: hall"})
        self.assertEqual(hall().pieces, ["floor", "vault"])
        at = found.at([(0.25, 0.5, 0)], iterated=True)
        self.assertLess(abs(at.iterated.value[0] - 1.125), 0.02)
        self.assertFalse(at.iterated.guaranteed.any())
        self.assertEqual(at.pieces, ["floor"])
        found.to_vtu(self.folder / "u.vtu")
        self.assertIn("vault", (self.folder / "u.vtu").read_text(encoding="utf-8"))
        self.assertEqual(json.loads(json.dumps(found.to_json()))["problem"]["surface"]["name"][:9], "estimated")

    def test_nothing_is_proved_on_it_and_nothing_kept(self):
        problem = rc.Problem(hall(), reflectivity="1/2", emission=1, levels=[0])
        error = self.refused(lambda: problem.solve(solver="verified"), "proves nothing where the charts")
        self.assertEqual(error.place, "/solver/name")
        for of in ("means", "function"):
            self.refused(lambda of=of: problem.guarantee("0.5", of=of), "/surface", "of which nothing is proved")
        self.refused(lambda: problem.guarantee("0.5", certificate=True), "of which nothing is proved")
        self.refused(lambda: box_of_charts(1, 1, 1).factors(), "of which no factors are taken")
        self.refused(lambda: rc.Problem(box_of_charts(1, 1, 1), reflectivity="1/2", emission=1).guarantee("0.5"),
                     "of which nothing is proved")
        self.refused(lambda: problem.write(self.folder / "p.json"), "/surface", "which no file has")
        problem.solve(store=self.folder / "kept")
        self.assertFalse((self.folder / "kept").exists())
        self.refused(problem.replace(geometry={"interpolated": 2}).solve, "/geometry/interpolated", "interpolants already")
        self.refused(problem.replace(operator="h2").solve, "/operator/name", "known by their values alone")
        self.refused(problem.replace(basis="shepard").solve, "/basis", "known by their values alone")
        self.refused(lambda: problem.replace(basis={"family": "galerkin", "degree": 1}).solve(), "/basis")
        self.refused(lambda: problem.replace(grading="edges").solve(), "grading")
        # Of a closed one norms are estimates, and a reflectivity of 1 is refused.
        closed = rc.Problem(box_of_charts(1, 1, 1), reflectivity=1, emission=1, levels=[0])
        self.refused(closed.solve, "/reflectivity", "norm of K")

    def test_what_a_chart_knows(self):
        chart = rc.Chart(vault, jacobian=lambda P: np.stack([np.column_stack([np.ones(len(P)), np.zeros(len(P)), 2 - 4 * P[:, 0]]),
                                                             np.tile((0.0, 1.0, 0.0), (len(P), 1))], axis=2))
        self.assertEqual(chart.degrees, (2, 1))
        self.assertLess(chart.residual, 1e-15)
        self.assertLess(chart.jacobian_residual, 1e-14)
        self.assertIsNone(rc.Chart(vault).jacobian_residual)
        self.assertIn("(2, 1)", repr(chart))
        wavy = rc.Chart(lambda P: np.column_stack([P, np.sin(3 * P[:, 0]) * np.exp(P[:, 1])]))
        self.assertTrue(1e-18 < wavy.residual < 1e-13, wavy.residual)

    def test_what_a_map_gives_is_an_array_of_three_numbers_a_point(self):
        for wrong, words in [(lambda P: 1.0, "has another shape"), (lambda P: P, "has another shape"),
                             (lambda P: ground(P)[:-1], "has another shape"), (lambda P: ground(P).T, "has another shape"),
                             (lambda P: ground(P) * 1j, "is no array of doubles"), (lambda P: None, "is None"),
                             (lambda P: [["a"] * 3] * len(P), "array"), (lambda P: ground(P).astype(np.longdouble), "is no array"),
                             (lambda P: ground(P) * np.nan, "is not finite at (s, t)"),
                             (lambda P: np.where(P[:, :1] == 1, np.inf, ground(P)), "is not finite at (s, t) = (1, ")]:
            error = self.refused(lambda wrong=wrong: rc.Chart(wrong, name="c"), words)
            self.assertEqual((error.source, error.place), ("c", "/map"))
        for wrong, words in [(ground, "has another shape"), (lambda P: np.zeros((len(P), 3, 2)), "is no derivative of the map"),
                             (lambda P: np.full((len(P), 3, 2), np.nan), "is not finite"), (lambda P: None, "is None"),
                             (1, "cannot be called")]:
            error = self.refused(lambda wrong=wrong: rc.Chart(ground, name="c", jacobian=wrong), words)
            self.assertEqual((error.source, error.place), ("c", "/jacobian"))
        self.refused(lambda: rc.Chart(3), "/map", "cannot be called")
        self.refused(lambda: rc.Chart(lambda P: np.column_stack([P, np.abs(P[:, 0] - 0.4)])), "/map", "is not smooth enough")
        self.refused(lambda: rc.Chart(lambda P: np.column_stack([P, np.sqrt(P[:, 0])])), "/map", "is not smooth enough")
        self.refused(lambda: rc.Chart(lambda P: np.ones((len(P), 3))), "/map", "has one value")
        # Lists, floats of 32 bits and whole numbers are numbers.
        for kind in (lambda P: ground(P).tolist(), lambda P: ground(np.round(P)) * 0 + (P[:, :1] > 2) + ground(P)):
            self.assertEqual(rc.Chart(kind).degrees, (1, 1))

    def test_what_is_no_surface(self):
        def bowl(P):
            return np.column_stack([P, ((P - 0.5)**2).sum(axis=1)])

        def refused(charts, *words):
            return self.refused(lambda: rc.Surface(charts=charts), *words)

        self.assertEqual(refused([], "1 to 256 charts").place, "/charts")
        saddle = rc.Chart(lambda P: np.column_stack([P, (P[:, 0] - 0.5) * (P[:, 1] - 0.5)]), name="saddle")
        self.assertEqual(refused([saddle], "on both sides of its tangent plane").place, "/charts/0")
        refused([rc.Chart(bowl, name="bowl"), rc.Chart(lambda P: ground(P) - (0, 0, 1), name="below")], "on both sides")
        refused([rc.Chart(lambda P: P[:, :1] * np.column_stack([P[:, 1], 1 - P[:, 1], 0 * P[:, 1]]))], "has no normal at (s, t) = (0, 0)")
        refused([rc.Chart(ground, name="a"), rc.Chart(vault, name="a")], "is the name of two charts")
        slope = rc.Chart(lambda P: ground(P) + np.column_stack([np.ones(len(P)), 0 * P[:, 0], P[:, 0]]), name="slope", piece="one")
        refused([rc.Chart(ground, name="floor", piece="one"), slope], "meets floor at an angle")
        refused([rc.Chart(ground, name="*")], "stands for the rest")
        for wrong in ([ground], [None], "ab", [rc.cube()]):
            with self.assertRaises(TypeError):
                rc.Surface(charts=wrong)
        with self.assertRaises(TypeError):
            rc.Surface()
        with self.assertRaises(TypeError):
            rc.Surface("box", {"a": 1}, charts=[rc.Chart(ground)])

    def test_what_a_map_raises_is_raised_and_nothing_is_kept_of_it(self):
        class Mine(Exception):
            pass

        for error in (Mine("own"), KeyboardInterrupt(), SystemExit(3), MemoryError()):
            def failing(P, error=error):
                raise error

            for arguments in ((failing, None), (ground, failing)):
                with self.assertRaises(type(error)) as caught:
                    rc.Chart(arguments[0], jacobian=arguments[1])
                self.assertIs(caught.exception, error)

        class Map:
            def __call__(self, P):
                P[:] = P  # an array of its own
                return ground(P)

        own = Map()
        alive = weakref.ref(own)
        chart = rc.Chart(own, name="floor")
        del own
        gc.collect()
        self.assertIsNone(alive())
        surface = rc.Surface(charts=[chart, rc.Chart(vault, name="vault")])
        del chart
        gc.collect()
        problem = rc.Problem(surface, reflectivity="1/2", emission=1, levels=[0])
        del surface
        gc.collect()
        self.assertEqual(len(problem.solve()), 1)

    def test_threads_may_make_and_share_surfaces(self):
        shared, found = hall(), []

        def work():
            own = rc.Problem(hall(), reflectivity="1/2", emission=1 + x, levels=[0]).solve()[0].values.value
            same = rc.Problem(shared, reflectivity="1/2", emission=1 + x, levels=[0]).solve()[0].values.value
            found.extend([own.tobytes(), same.tobytes()])

        threads = [threading.Thread(target=work) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((len(found), len(set(found))), (6, 1))


if __name__ == "__main__":
    unittest.main()
