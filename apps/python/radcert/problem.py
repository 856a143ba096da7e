# SPDX-License-Identifier: GPL-3.0-or-later
"""Radiosity equations, stated and solved."""
import os
from typing import Any, Optional

import numpy as np

from . import _core
from .basis import Basis
from .factors import Listener, Path, Store, flag, real, store_name, write
from .guarantee import Enclosure
from .mesh import Mesh
from .numbers import Approximations
from .surfaces import Surface


class Problem:
    """u(P) - rho(P)/pi Int_S G(P,Q) u(Q) dS_Q = E(P), on one surface and by one method.

    surface: ``ellipsoid(1, "3/4", "1/2")``, a name, a ``Mesh``, a ``Surface`` of charts of your own, or a dict as a problem
        file has it.
    basis: a ``Basis``, ``inset(...)``, ``symmetric(...)``, the name of a meshless basis, or a dict; linear functions inset by
        1/6 where none is given. In a dict of a meshless basis "mother" may be a function of a float r >= 0 that gives a
        float; it is called for each number, which is slow.
    reflectivity: rho, from 0 to 1. solution: u, then E = u - Ku and the errors are known. emission: E, the power emitted per
        area. Each a number, an ``Expression`` in ``xyz()``, a text, or a dict of these by piece, "*" for the rest. A float
        is the double that it is. Exactly one of solution and emission is given; it may be a function of points, an array
        (n, 3), that gives an array (n,): floats alone, so that nothing follows with a proof or a radius, and no store keeps
        it. It is called from threads of the library, and must be the same whenever it is called.
    levels: numbers of symmetric refinements, ascending. pattern, grading: of the triangulation.
    geometry, quadrature, operator, solver: as in a problem file; a name alone will do for operator and solver.
    iterated: whether the iterated solution E + K u_n is taken too, for ``to_json``. label: a short name for tables and plots.
    fit_from: the level with which fitted orders begin.

    Nothing is computed until ``solve``; what a file could not say is refused at once, as InputError with the place in it.
    """

    def __init__(self, surface: Any, *, basis: Any = None, reflectivity: Any, solution: Any = None, emission: Any = None,
                 levels: Any = (0, 1, 2), pattern: Any = None, grading: Any = None, geometry: Any = None,
                 quadrature: Any = None, operator: Any = None, solver: Any = None, label: Optional[str] = None,
                 fit_from: Optional[int] = None, iterated: Optional[bool] = None) -> None:
        self._given = {key: value for key, value in locals().items() if key not in ("self", "__class__")}
        self._problem, self._by_functions = _stated(**self._given)

    @classmethod
    def read(cls, file: Path) -> "Problem":
        """A problem file."""
        problem = cls.__new__(cls)
        problem._given = {}
        problem._by_functions = []
        problem._problem = _core.Problem.read(os.fspath(file))
        return problem

    def replace(self, **changes: Any) -> "Problem":
        """The same problem with other parts: p.replace(solver="verified")."""
        if not self._given:
            raise TypeError("a problem of a file is changed in the file; Problem(...) has parts to replace")
        unknown = set(changes) - set(self._given)
        if unknown:
            raise TypeError(f"a problem has no {', '.join(sorted(unknown))}; it has {', '.join(sorted(self._given))}")
        if "solution" in changes and "emission" not in changes and changes["solution"] is not None:
            changes["emission"] = None
        if "emission" in changes and "solution" not in changes and changes["emission"] is not None:
            changes["solution"] = None
        return Problem(**{**self._given, **changes})

    def check(self) -> None:
        """Everything about the problem that can be refused before any work; raises InputError."""
        self._problem.check()

    def solve(self, levels: Any = None, *, solver: Any = None, store: Store = None, progress: Listener = None) -> "Solution":
        """Solves the problem over its levels.

        levels, solver: in place of the problem's own. store: a folder that keeps finished levels, True for the program's.
        progress: a function of a fraction and of words, called in this thread; ``radcert.progress_bar()`` makes one.
        Ctrl-C stops the computation and raises KeyboardInterrupt.
        """
        changes = {}
        if levels is not None:
            changes["levels"] = levels
        if solver is not None:
            changes["solver"] = solver
        problem = self.replace(**changes) if changes else self
        # A function's name does not tell it from another: nothing of it is kept.
        folder = "" if problem._by_functions else store_name(store)
        return Solution(problem._problem.solve(folder, progress), problem._by_functions)

    def guarantee(self, width: Any, of: str = "means", *, points: Any = None, outside: Any = None, emissions: Any = None,
                  certificate: bool = False, store: Store = None, progress: Listener = None) -> Enclosure:
        """Encloses the solution u of the equation itself, not of an approximation to it, with a proof.

        width: of the enclosures that are wanted, an exact number. of: "means" over the pieces, "values" at points, or
        "function", u everywhere. points: triples of exact numbers, inside faces. outside: of a function on a polyhedron,
        how far from the vertices. emissions: further ones on a polyhedron whose means or values are enclosed too, "by piece"
        or a dict of expressions by name, each as the problem's emission. certificate: of means or values on a convex
        polyhedron, or of anything on a sphere or an ellipsoid, with what ``check_certificate`` verifies.

        Serves convex polyhedra, open ones too, spheres and ellipsoids, and for means closed meshes whose parts hide each
        other; levels, basis and solver do not matter. Raises AccuracyNotReached where nothing is proved; where the width
        is not reached ``Enclosure.hindrance`` says so.
        """
        with_certificate = flag(certificate, "certificate")
        document: dict[str, Any] = {"width": _core.exact_text(width, "width"), "of": of}
        if points is not None:
            document["points"] = [[_core.exact_text(x, f"points/{i}/{j}") for j, x in enumerate(point)]
                                  for i, point in enumerate(points)]
        if outside is not None:
            document["outside"] = _core.exact_text(outside, "outside")
        if emissions is not None:
            document["emissions"] = emissions
        return Enclosure(_core.enclose(self._problem, document, with_certificate, store_name(store), progress))

    def to_json(self) -> dict[str, Any]:
        """The problem as its file has it, every default written out: a dict. A mesh or a basis of Python's own stands in it
        by its name and digest."""
        return self._problem.json()

    def write(self, path: Path) -> None:
        """Writes the problem file; a problem with a function of Python has none."""
        for part in self._by_functions:
            _core.refuse("problem", f"/{part}", None, "is a function of Python, which no file has", "a formula")
        write(path, self._problem.text().encode())

    def __repr__(self):
        return f"<Problem on {self.to_json()['surface'].get('name', 'a mesh')}>"


def _stated(surface, basis, reflectivity, solution, emission, levels, pattern, grading, geometry, quadrature, operator,
            solver, label, fit_from, iterated):
    document = {"schema": "radcert/problem/1"}
    by_functions = []
    choice = None
    if isinstance(surface, Mesh):
        choice = _core.SurfaceChoice.of_mesh(surface._mesh)
    elif isinstance(surface, Surface):
        choice = surface._choice
        by_functions += ["surface"] * surface.by_functions
    else:
        document["surface"] = {"name": surface} if isinstance(surface, str) else surface
    triangulation = {"levels": _level_list(levels)}
    if pattern is not None:
        triangulation["pattern"] = pattern
    if grading is not None:
        triangulation["grading"] = _exact_or_same(grading, "grading")
    document["triangulation"] = triangulation
    nodes = None
    if basis is None:
        basis = {"family": "inset", "degree": 1, "alpha": "1/6"}
    if isinstance(basis, Basis):
        nodes = basis._nodes
        by_functions += ["basis"] * basis.by_functions
        # Nodes stand beside the document.
        basis = basis._document
    if nodes is None:
        document["basis"] = basis
    # Functions stand beside the document too, which needs something in their places.
    functions = {}
    if isinstance(basis, dict) and _is_function(basis.get("mother")):
        functions["mother"] = basis["mother"]
        document["basis"] = {**basis, "mother": "exp(-r)"}
    if _is_function(solution):
        functions["solution"], solution = solution, "0"
    if _is_function(emission):
        functions["emission"], emission = emission, "0"
    document["reflectivity"] = reflectivity
    for key, value in (("solution", solution), ("emission", emission), ("geometry", geometry), ("label", label),
                       ("quadrature", quadrature), ("fit_from", fit_from), ("iterated", iterated)):
        if value is not None:
            document[key] = value
    for key, value in (("operator", operator), ("solver", solver)):
        if value is not None:
            document[key] = {"name": value} if isinstance(value, str) else value
    problem = _core.Problem.of_document(document, "problem", choice, nodes, functions, "basis" in by_functions)
    return problem, sorted([*by_functions, *functions])


def _is_function(value):
    """Whether it is called for its values; an ``Expression`` is read as a formula."""
    return callable(value) and not hasattr(value, "_radcert_text") and not isinstance(value, type)


def _exact_or_same(value, place):
    return value if isinstance(value, str) else _core.exact_text(value, place)


def _level_list(levels):
    if isinstance(levels, (int, np.integer)):
        return [int(levels)]
    return list(levels)


class LevelValues:
    """The values of one level at the nodes.

    points, normals: (n, 3) floats, normals of unit length, inwards. values: ``Approximations`` of u_n. emission: (n,) floats.
    solution: (n,) floats, u where the problem states it, else None. pieces: a name a node. elements: (n,) ints, the element.
    corners: (m, 3, 3) floats, the corners of each element; corner_values: (m, 3) floats, u_n there.
    """

    def __init__(self, nodes, corners):
        self.points = nodes["points"]
        self.normals = nodes["normals"]
        self.values = Approximations(*nodes["values"])
        self.emission = nodes["emission"]
        self.solution = nodes["solution"]
        self.pieces = nodes["pieces"]
        self.elements = nodes["elements"]
        self.corners = corners["corners"]
        self.corner_values = corners["values"]
        self.corner_pieces = corners["pieces"]


class AtPoints:
    """Values at points of the surface.

    points: (n, 3) floats, of the surface, nearest to those that were asked for; distance: (n,) floats, between the two.
    pieces: a name a point. u_n: ``Approximations`` of the computed function; on the sides of elements, where it may have two
    values, the one of the first element. iterated: ``Approximations`` of E + K u_n, which is smooth where u is and often
    nearer to it; None where it was not asked for. Radii are estimates of how far these numbers of the discrete equation are
    off, not of their distance from u.
    """

    def __init__(self, found):
        self.points = found["points"]
        self.distance = found["distance"]
        self.pieces = found["pieces"]
        self.u_n = Approximations(*found["u_n"])
        self.iterated = None if found["iterated"] is None else Approximations(*found["iterated"])


class Solution:
    """What was computed of a problem, level by level.

    levels, elements, unknowns: (k,) ints. mesh_size: (k,) floats, the largest diameter of a triangle in the parameter plane.
    errors: dict of ``Approximations`` by name, for a problem with a solution: "discretisation_error", max |K(I - P_n)u| over
    the nodes; "node_error", max |u - u_n| over the nodes; "uniform_error", over a sample of the surface; "l2_error", the
    norm of u - u_n in L2; "mean_error", the largest error of the means. A radius that is not known is infinite. means: dict of
    ``Approximations`` by piece, the means of u_n. norm_K: ``Approximations``. seconds: (k,) floats.
    ``solution[i]`` are the values of the i-th level. by_functions: the parts of the problem that were functions of Python;
    what follows from them is estimated, never guaranteed.
    """

    def __init__(self, solution, by_functions=()):
        self._solution = solution
        self.by_functions = list(by_functions)

    @property
    def levels(self) -> np.ndarray:
        return self._solution.levels

    @property
    def elements(self) -> np.ndarray:
        return self._solution.elements

    @property
    def unknowns(self) -> np.ndarray:
        return self._solution.unknowns

    @property
    def mesh_size(self) -> np.ndarray:
        return self._solution.mesh_size

    @property
    def norm_K(self) -> Approximations:
        return Approximations(*self._solution.norm_K)

    @property
    def solvers(self) -> list[str]:
        """The solver that was taken at each level."""
        return self._solution.solvers

    @property
    def seconds(self) -> np.ndarray:
        return self._solution.seconds

    @property
    def errors(self) -> dict[str, Approximations]:
        out = {}
        for name in _core.error_names():
            found = self._solution.error(name)
            if found is not None:
                out[name] = Approximations(*found)
        return out

    @property
    def means(self) -> dict[str, Approximations]:
        return {piece: Approximations(*mean) for piece, mean in self._solution.means().items()}

    def eoc(self, error: str = "node_error") -> np.ndarray:
        """The observed order of convergence between each level and the one before: (k,) floats, the first is NaN, and so are
        those of errors whose radius exceeds 5 % of them."""
        return self._solution.orders(error)

    @property
    def fits(self) -> dict[str, dict[str, Any]]:
        """Fitted orders by the name of the error: dicts with order, halfwidth, levels, as the JSON file has them."""
        return self._solution.fits()

    def __len__(self) -> int:
        return len(self._solution.levels)

    def _place(self, place):
        count = len(self)
        index = place + count if place < 0 else place
        if not 0 <= index < count:
            raise IndexError(f"there are {count} levels")
        return index

    def __getitem__(self, place: int) -> LevelValues:
        index = self._place(place)
        return LevelValues(self._solution.nodes(index), self._solution.corners(index))

    def at(self, points: Any, level: int = -1, *, iterated: bool = True, tolerance: float = 1e-9,
           progress: Listener = None) -> AtPoints:
        """u_n, and the iterate E + K u_n, at points of the surface.

        points: (n, 3) floats. level: the place of a level, as in ``solution[level]``. tolerance: how far off the surface a
        point may lie, relative to the surface's extent; farther ones are refused, nearer ones moved to the nearest point.
        iterated: an integral over all elements for each point, tenths of a second; not on occluded surfaces, nor on edges.
        progress: as in ``Problem.solve``.
        """
        return AtPoints(self._solution.at(self._place(level), points, real(tolerance, "tolerance"), flag(iterated, "iterated"), progress))

    def to_pyvista(self, level: int = -1) -> Any:
        """u_n at a level as a ``pyvista.PolyData``: three points of its own for each element, since u_n may jump between
        them; point data "u_n", cell data "piece", the place in the field data "pieces". Needs pyvista."""
        import pyvista

        values = self[level]
        count = len(values.corners)
        cells = np.hstack([np.full((count, 1), 3), np.arange(3 * count).reshape(count, 3)])
        mesh = pyvista.PolyData(values.corners.reshape(3 * count, 3), cells.ravel())
        mesh.point_data["u_n"] = values.corner_values.ravel()
        names = list(dict.fromkeys(values.corner_pieces))
        places = {name: place for place, name in enumerate(names)}
        mesh.cell_data["piece"] = np.array([places[name] for name in values.corner_pieces])
        mesh.field_data["pieces"] = np.array(names)
        return mesh

    def to_json(self) -> dict[str, Any]:
        """What ``radcert solve --json`` writes, as a dict."""
        return self._solution.json()

    def to_latex(self, path: Path) -> None:
        """Writes the levels as a table for LaTeX, with booktabs and siunitx."""
        write(path, self._solution.latex())

    def to_csv(self, path: Path) -> None:
        """Writes the levels, a row each."""
        write(path, self._solution.csv())

    def nodes_to_csv(self, path: Path) -> None:
        """Writes the values at the nodes of all levels."""
        write(path, self._solution.nodes_csv())

    def to_vtu(self, path: Path) -> None:
        """Writes u_n at the last level for ParaView."""
        write(path, self._solution.vtu())

    def to_ply(self, path: Path) -> None:
        """Writes the same as PLY."""
        write(path, self._solution.ply())

    def plot(self, path: Optional[Path] = None, title: str = "Errors") -> Optional["Picture"]:
        """The errors against the mesh size, as SVG: written to a file, or returned as an object that notebooks show."""
        picture = self._solution.svg(title)
        if path is not None:
            write(path, picture)
            return None
        return Picture(picture.decode())

    def picture(self, path: Optional[Path] = None, *, position: Any, look_at: Any, up: Any = (0, 0, 1), angle: float = 0.75,
                level: int = -1, size: Any = (640, 480), samples: int = 2, low: Optional[float] = None,
                high: Optional[float] = None, scale: str = "map", of: str = "u_n",
                progress: Listener = None) -> Optional["Picture"]:
        """A solution as a pinhole camera sees it: written to a file, or returned as an object that notebooks show.

        path: .svg with the scale beside the picture, or .png, the pixels alone. position, look_at, up: triples of floats;
            one looks into a closed room from outside, as faces are seen from their lit side alone. angle: between the upper
            and the lower edge, in radians. level: the place among ``levels``. size: (width, height) in pixels, each from 64
            to 4096. samples: rays a pixel, squared, from 1 to 8.
        low, high: the numbers at the ends of the scale; those of what is shown, and 0 for light, where none are given.
            scale: "map", colours of equal steps, or "light", the amount of light. of: "u_n", or "iterated", E + K u_n, of a
            problem with ``iterated``.

        Elements are shown plane between their corners, and what is shown linear between its values there. Of one solve, not
        of an experiment.
        """
        count = len(self)
        place = level + count if level < 0 else level
        if not 0 <= place < count:
            raise IndexError(f"there are {count} levels")
        name = None if path is None else os.fspath(path)
        if name is not None and not name.endswith((".svg", ".png")):
            _core.refuse("picture", "/path", name, "ends otherwise", ".svg, .png")
        drawn = _core.picture(self._solution, place, [float(x) for x in position], [float(x) for x in look_at],
                              [float(x) for x in up], float(angle), [int(x) for x in size], samples, low, high, scale, of,
                              not (name or "").endswith(".png"), progress)
        if path is not None:
            write(path, drawn)
            return None
        return Picture(drawn.decode())

    def __repr__(self):
        return f"<Solution at {len(self)} levels, {self.unknowns[-1]} unknowns at the last>"


class Picture:
    """An SVG that notebooks show; ``text`` is its source."""

    def __init__(self, text):
        self.text = text

    def _repr_svg_(self):
        return self.text
