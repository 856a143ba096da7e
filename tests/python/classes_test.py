# SPDX-License-Identifier: GPL-3.0-or-later
"""All classes and functions of the compiled part, each with what it was not made for: a Python exception, never a crash."""
import copy
import inspect
import os
import pickle
import unittest
import warnings

import numpy as np
import radcert as rc
from radcert import _core

from module import EXAMPLES, ModuleTest, unit_cube

BASE = _core.Ball.__mro__[1]
# What a wrong argument may raise. An IndexError or a RuntimeError would tell of the code, not of the argument.
REFUSALS = (TypeError, ValueError, rc.EnvironmentError, rc.AccuracyNotReached)
STRANGE = (None, True, -1, 2**70, float("nan"), "", "\0", b"x", [], [None], {}, {1: 2}, (), object(), np.zeros((2, 2)), lambda: 1)
PROBLEM = {"schema": "radcert/problem/1", "surface": {"name": "cube"}, "triangulation": {"levels": [0]},
           "basis": {"family": "inset", "degree": 0}, "reflectivity": "0", "emission": "1"}


def bound(module=_core):
    """The classes that are bound, by name."""
    return {name: value for name, value in vars(module).items() if inspect.isclass(value) and issubclass(value, BASE)}


def square(parameters):
    return np.column_stack([parameters, np.zeros(len(parameters))])


class Classes(ModuleTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        points, triangles, groups = unit_cube()
        options = {"front": "auto", "repair": [], "two_sided": [], "angle": 30, "unit": ""}
        document = {"schema": "radcert/nodes/1", "degree": 0, "nodes": [["1/3", "1/3", "1/3"]]}
        base = {key: PROBLEM[key] for key in ("surface", "triangulation", "reflectivity")}
        beside = {key: value for key, value in PROBLEM.items() if key not in ("surface", "basis")}
        experiment = {"schema": "radcert/experiment/1", "name": "one", "base": {**base, "solution": "1"},
                      "vary": {"basis": [PROBLEM["basis"]]}}
        mesh = _core.Mesh.of_arrays("mesh", points, triangles, groups, **options)
        nodes = _core.Nodes.of_document("nodes", document)
        charts = [_core.OwnChart.of_map("chart", square, None)]
        surface = _core.SurfaceChoice.named({"name": "cube"})
        problem = _core.Problem.of_document(PROBLEM, "problem", None, None, {}, False)
        solution = problem.solve("", None)
        factors = _core.factors_of_mesh(mesh, "group", None, False, False, False, "", None)
        comparison = factors.compare(np.zeros((6, 6)), 0.0, 0.0, 0.0)
        record = _core.reference("cube_opposite_faces", 20, {})
        run = _core.run_experiment(experiment, "experiment", "", None)
        enclosed = _core.enclose(problem, {"width": "1/2", "of": "means"}, False, "", None)
        report = _core.verify(["ac98/lemma_2_1"], "quick", "", None)
        cls.objects = {type(each).__name__: each for each in (
            mesh, nodes, *charts, surface, problem, solution, factors, comparison, comparison.pairs[0], record, record.routes[0],
            record.routes[0].ball, run, enclosed, nodes.facts(), report, report.statements[0])}
        file = str(EXAMPLES / "08_factors_of_an_stl" / "attic.stl")
        # One call that is right, of each function with arguments; the words are those by name alone.
        cls.calls = {
            "refuse": (_core.refuse, ["source", "place", "value", "problem", "allowed"]),
            "limit_threads": (_core.limit_threads, [None]),
            "upper_text": (_core.upper_text, [0.5]),
            "exact_text": (_core.exact_text, ["1/3", "place"]),
            "reference": (_core.reference, ["perpendicular_rectangles", 20, {"edge": 5}]),
            "evaluate_expression": (_core.evaluate_expression, ["x", np.zeros((1, 3))]),
            "require_expression": (_core.require_expression, ["x", False]),
            "is_mesh_file_name": (_core.is_mesh_file_name, ["x.stl"]),
            "factors_of_mesh": (_core.factors_of_mesh, [mesh, "group", 0.1, False, False, False, "", None]),
            "factors_of_surface": (_core.factors_of_surface, [surface, 0, "piece", 0.1, False, False, False, "", None]),
            "surface_of_charts": (_core.surface_of_charts, ["surface", charts, [("chart", "chart")]]),
            "inset_facts": (_core.inset_facts, [0, None]),
            "function_values": (_core.function_values, [lambda x: x[:, 0], np.ones((1, 3)), "place"]),
            "symmetric_facts": (_core.symmetric_facts, [1]),
            "picture": (_core.picture, [solution, 0, [-3.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 0.0, 1.0], 0.7, [64, 64], 1, 0.0, 1.0,
                                        "map", False, None]),
            "run_experiment": (_core.run_experiment, [experiment, "experiment", "", None]),
            "edge": (_core.edge, [90, "1/2", None, "2", 10]),
            "enclose": (_core.enclose, [problem, {"width": "1/2", "of": "means"}, False, "", None]),
            "check_certificate": (_core.check_certificate, ["no such file", 1, "seed", None]),
            "verify": (_core.verify, [["ac98/lemma_2_1"], "quick", "", None]),
            "Mesh.read": (lambda file, *rest: _core.Mesh.read(file, **dict(zip(options, rest, strict=True))), [file, *options.values()]),
            "Mesh.of_arrays": (lambda *given: _core.Mesh.of_arrays(*given[:4], **dict(zip(options, given[4:], strict=True))),
                               ["mesh", points, triangles, groups, *options.values()]),
            "Nodes.of_document": (_core.Nodes.of_document, ["nodes", document]),
            "Nodes.read": (_core.Nodes.read, [str(EXAMPLES / "04_own_basis" / "nodes.json")]),
            "OwnChart.of_map": (_core.OwnChart.of_map, ["chart", square, None]),
            "SurfaceChoice.named": (_core.SurfaceChoice.named, [{"name": "cube"}]),
            "SurfaceChoice.of_mesh": (_core.SurfaceChoice.of_mesh, [mesh]),
            "Problem.of_document": (_core.Problem.of_document, [beside, "problem", surface, nodes, {}, False]),
            "Problem.read": (_core.Problem.read, [str(EXAMPLES / "01_solve" / "1_two_piece.json")]),
            "Problem.solve": (problem.solve, ["", None]),
            "Solution.error": (solution.error, ["node_error"]),
            "Solution.orders": (solution.orders, ["node_error"]),
            "Solution.nodes": (solution.nodes, [0]),
            "Solution.corners": (solution.corners, [0]),
            "Solution.at": (solution.at, [0, np.full((1, 3), [0.5, 0.5, 0.0]), 1e-9, False, None]),
            "Solution.svg": (solution.svg, ["title"]),
            "Factors.compare": (factors.compare, [np.zeros((6, 6)), 0.0, 0.0, 0.0]),
            "Mesh.measured": (mesh.measured, ["group"]),
            "Ball.decimal": (record.routes[0].ball.decimal, [20]),
            "Ball.contains": (record.routes[0].ball.contains, [0.5]),
            "Ball.overlaps": (record.routes[0].ball.overlaps, [record.routes[0].ball]),
        }

    def members(self):
        """The properties and methods of the classes, as (class, name, what is called with an object)."""
        for name, kind in bound().items():
            for member, value in vars(kind).items():
                if isinstance(value, property):
                    yield kind, f"{name}.{member}", value.fget
                elif not isinstance(value, staticmethod) and callable(value) and not member.startswith("_pybind11"):
                    yield kind, f"{name}.{member}", value

    def test_there_is_an_object_of_every_class_and_a_call_of_every_function(self):
        self.assertEqual(set(self.objects), set(bound()))
        statics = {f"{name}.{member}" for name, kind in bound().items() for member, value in vars(kind).items()
                   if isinstance(value, staticmethod)}
        functions = {name for name, value in vars(_core).items() if inspect.isbuiltin(value) and "()" not in value.__doc__}
        methods = {name for _, name, value in self.members()
                   if "__" not in name and getattr(value, "__doc__", None) and "self: " in value.__doc__ and ", " in value.__doc__.split(")")[0]}
        self.assertEqual(set(self.calls) - {"Problem.solve", *methods}, functions | statics)
        self.assertLessEqual(methods, set(self.calls))

    def test_no_class_makes_an_object(self):
        class Silent(BASE):
            def __init__(self):
                """Leaves the class above without its __init__."""

        for kind in (BASE, Silent, *bound().values()):
            derived = type("Derived", (kind,), {"__init__": lambda self: None})
            forced = type("Forced", (kind,), {"__new__": lambda cls, kind=kind: kind.__new__(cls)})
            for make in (kind, derived, forced, lambda: kind.__new__(kind), lambda: BASE.__new__(kind), lambda: object.__new__(kind),
                         lambda: BASE(kind), lambda: object.__new__(derived)):
                with self.subTest(kind=kind.__name__), self.assertRaisesRegex(TypeError, "has no constructor|is not safe"):
                    make()

    def test_no_object_becomes_another_or_is_copied(self):
        for name, each in self.objects.items():
            others = [kind for kind in bound().values() if kind is not type(each)]
            derived = type("Derived", (type(each),), {})
            tries = [lambda kind=kind: setattr(each, "__class__", kind) for kind in (*others, derived, object, BASE)]
            tries += [lambda p=p: pickle.dumps(each, p) for p in range(pickle.HIGHEST_PROTOCOL + 1)]
            tries += [lambda p=p: each.__reduce_ex__(p) for p in range(pickle.HIGHEST_PROTOCOL + 1)]
            tries += [each.__reduce__, lambda: copy.copy(each), lambda: copy.deepcopy(each), each.__init__,
                      lambda: setattr(type(each), "name", 1), lambda: delattr(type(each), "__repr__")]
            for action in tries:
                with self.subTest(name=name), self.assertRaises((TypeError, AttributeError)):
                    action()
            self.assertIs(type(each), bound()[name])
            self.assertIn(name, repr(each))

    def test_methods_of_another_object(self):
        strangers = [None, object(), 1, "", *self.objects.values()]
        for kind, name, action in self.members():
            for stranger in strangers:
                if not isinstance(stranger, kind) and not name.endswith(("__init__", "__new__")):
                    with self.subTest(name=name, stranger=type(stranger).__name__), self.assertRaises(TypeError):
                        action(stranger)

    def test_one_argument_is_another(self):
        self.addCleanup(_core.limit_threads, None)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)  # some would be names of folders
        unheard = warnings.catch_warnings()
        unheard.__enter__()
        self.addCleanup(unheard.__exit__, None, None, None)
        warnings.simplefilter("ignore", rc.StoreWarning)
        for name, (function, given) in self.calls.items():
            for place in range(len(given)):
                for strange in (*STRANGE, *self.objects.values()):
                    if name == "verify" and place == 0 and isinstance(strange, (list, tuple)) and not strange:
                        continue  # it would be right, and all claims run
                    with self.subTest(name=name, place=place, strange=str(type(strange))):
                        try:
                            function(*given[:place], strange, *given[place + 1:])
                        except REFUSALS:
                            pass
            with self.subTest(name=name), self.assertRaises((TypeError, ValueError)):
                function(*given, None)

    def test_classes_of_python_without_their_parts(self):
        for name, kind in vars(rc).items():
            if not inspect.isclass(kind) or not kind.__module__.startswith("radcert.") or issubclass(kind, (Exception, tuple, BASE)):
                continue
            empty = kind.__new__(kind)
            for action in [lambda: repr(empty), lambda: copy.copy(empty), lambda: pickle.dumps(empty),
                           *(lambda member=member: getattr(empty, member) for member in dir(kind))]:
                with self.subTest(name=name):
                    try:
                        action()
                    except (AttributeError, TypeError):
                        pass

    def test_a_copy_in_python_shares_what_does_not_change(self):
        mesh = rc.Mesh(unit_cube())
        other = copy.copy(mesh)
        del mesh
        self.assertEqual(len(other.pieces), 6)
        with self.assertRaisesRegex(TypeError, "cannot pickle"):
            pickle.dumps(other)


if __name__ == "__main__":
    unittest.main()
