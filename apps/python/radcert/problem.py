# SPDX-License-Identifier: GPL-3.0-or-later
"""Radiosity equations, stated and solved."""
import os
from typing import Any, Optional

import numpy as np

from . import _core
from .basis import Basis
from .factors import Listener, Path, Store, store_name, write
from .guarantee import Enclosure
from .mesh import Mesh
from .numbers import Approximations
from .surfaces import Surface


class Problem:
    """u(P) - rho(P)/pi Int_S G(P,Q) u(Q) dS_Q = E(P), on one surface and by one method.

    surface: ``ellipsoid(1, "3/4", "1/2")``, a name, a ``Mesh``, or a dict as a problem file has it.
    basis: a ``Basis``, ``inset(...)``, ``symmetric(...)``, the name of a meshless basis, or a dict; linear functions inset by
        1/6 where none is given.
    reflectivity: rho, from 0 to 1. solution: u, then E = u - Ku and the errors are known. emission: E, the power emitted per
        area. Each a number, an ``Expression`` in ``xyz()``, a text, or a dict of these by piece, "*" for the rest. A float
        is the double that it is. Exactly one of solution and emission is given.
    levels: numbers of symmetric refinements, ascending. pattern, grading: of the triangulation.
    geometry, quadrature, operator, solver: as in a problem file; a name alone will do for operator and solver.
    label: a short name for tables and plots. fit_from: the level with which fitted orders begin.

    Nothing is computed until ``solve``; what a file could not say is refused at once, as InputError with the place in it.
    """

    def __init__(self, surface: Any, *, basis: Any = None, reflectivity: Any, solution: Any = None, emission: Any = None,
                 levels: Any = (0, 1, 2), pattern: Any = None, grading: Any = None, geometry: Any = None,
                 quadrature: Any = None, operator: Any = None, solver: Any = None, label: Optional[str] = None,
                 fit_from: Optional[int] = None) -> None:
        self._given = {key: value for key, value in locals().items() if key not in ("self", "__class__")}
        self._problem = _stated(**self._given)

    @classmethod
    def read(cls, file: Path) -> "Problem":
        """A problem file."""
        problem = cls.__new__(cls)
        problem._given = {}
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
        return Solution(problem._problem.solve(store_name(store), progress))

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
        document: dict[str, Any] = {"width": _core.exact_text(width, "width"), "of": of}
        if points is not None:
            document["points"] = [[_core.exact_text(x, f"points/{i}/{j}") for j, x in enumerate(point)]
                                  for i, point in enumerate(points)]
        if outside is not None:
            document["outside"] = _core.exact_text(outside, "outside")
        if emissions is not None:
            document["emissions"] = emissions
        return Enclosure(_core.enclose(self._problem, document, certificate, store_name(store), progress))

    def to_json(self) -> dict[str, Any]:
        """The problem as its file has it, every default written out: a dict. A mesh or a basis of Python's own stands in it
        by its name and digest."""
        return self._problem.json()

    def write(self, path: Path) -> None:
        """Writes the problem file."""
        write(path, self._problem.text().encode())

    def __repr__(self):
        return f"<Problem on {self.to_json()['surface'].get('name', 'a mesh')}>"


def _stated(surface, basis, reflectivity, solution, emission, levels, pattern, grading, geometry, quadrature, operator,
            solver, label, fit_from):
    document = {"schema": "radcert/problem/1"}
    choice = None
    if isinstance(surface, Mesh):
        choice = _core.SurfaceChoice.of_mesh(surface._mesh)
    elif isinstance(surface, Surface):
        choice = surface._choice
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
        # The nodes stand beside the document, which needs a basis of triangles in their place.
        document["basis"] = basis._document or {"family": "inset", "degree": 0}
    else:
        document["basis"] = basis
    document["reflectivity"] = reflectivity
    for key, value in (("solution", solution), ("emission", emission), ("geometry", geometry), ("label", label),
                       ("quadrature", quadrature), ("fit_from", fit_from)):
        if value is not None:
            document[key] = value
    for key, value in (("operator", operator), ("solver", solver)):
        if value is not None:
            document[key] = {"name": value} if isinstance(value, str) else value
    return _core.Problem(document, "problem", choice, nodes)


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


class Solution:
    """What was computed of a problem, level by level.

    levels, elements, unknowns: (k,) ints. mesh_size: (k,) floats, the largest diameter of a triangle in the parameter plane.
    errors: dict of ``Approximations`` by name, for a problem with a solution: "discretisation_error", max |K(I - P_n)u| over
    the nodes; "node_error", max |u - u_n| over the nodes; "uniform_error", over a sample of the surface. means: dict of
    ``Approximations`` by piece, the means of u_n. norm_K: ``Approximations``. seconds: (k,) floats.
    ``solution[i]`` are the values of the i-th level.
    """

    def __init__(self, solution):
        self._solution = solution

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
        """The observed order of convergence between each level and the one before: (k,) floats, the first is NaN."""
        return self._solution.orders(error)

    @property
    def fits(self) -> list[dict[str, Any]]:
        """Fitted orders: a list of dicts as the JSON file has them."""
        return self._solution.fits()

    def __len__(self) -> int:
        return len(self._solution.levels)

    def __getitem__(self, place: int) -> LevelValues:
        count = len(self)
        index = place + count if place < 0 else place
        if not 0 <= index < count:
            raise IndexError(f"there are {count} levels")
        return LevelValues(self._solution.nodes(index), self._solution.corners(index))

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
                high: Optional[float] = None, scale: str = "map", progress: Listener = None) -> Optional["Picture"]:
        """u_n as a pinhole camera sees it: written to a file, or returned as an object that notebooks show.

        path: .svg with the scale beside the picture, or .png, the pixels alone. position, look_at, up: triples of floats;
            one looks into a closed room from outside, as faces are seen from their lit side alone. angle: between the upper
            and the lower edge, in radians. level: the place among ``levels``. size: (width, height) in pixels, each from 64
            to 4096. samples: rays a pixel, squared, from 1 to 8.
        low, high: the numbers at the ends of the scale; those of u_n, and 0 for light, where none are given. scale: "map",
            colours of equal steps, or "light", the amount of light.

        Elements are shown plane between their corners, and u_n linear between its values there. Of one solve, not of an
        experiment.
        """
        count = len(self)
        place = level + count if level < 0 else level
        if not 0 <= place < count:
            raise IndexError(f"there are {count} levels")
        name = None if path is None else os.fspath(path)
        if name is not None and not name.endswith((".svg", ".png")):
            _core.refuse("picture", "/path", name, "ends otherwise", ".svg, .png")
        drawn = _core.picture(self._solution, place, [float(x) for x in position], [float(x) for x in look_at],
                              [float(x) for x in up], float(angle), [int(x) for x in size], samples, low, high, scale,
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
