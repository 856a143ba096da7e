# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces by name: ``ellipsoid(1, "3/4", "1/2")`` or ``box(a=4, b=3, c="5/2")``."""
from typing import Any, Callable, Optional, Sequence

import numpy as np

from . import _core
from .factors import Factors, Listener, Store, flag, real, store_name


class Chart:
    """A part of a surface of your own, the image of the unit square under a map that Python computes.

    map: a function of parameters (s, t), an array (n, 2) with numbers from 0 to 1, that gives points, an array (n, 3). It is
        analytic on the closed square, corners too, one-to-one, and its two tangents are independent everywhere.
    jacobian: the derivatives of the map, a function of the same array that gives an array (n, 3, 2), by s and by t. Where it
        is given, those of the interpolant are held against it.
    name, piece: of the chart, numbered where none is given, and of the smooth piece that it belongs to, the chart's where
        none is given. Charts of one piece join smoothly.

    The map is called here, a few times on up to 4225 points, and is not kept: its interpolant, a polynomial of a degree up to
    64 in each parameter, stands for it from here on, and gives the derivatives. degrees: in s and t. residual: the largest
    distance between the two at 101 other points, relative to the extent of the image; InputError above about 1e-13.
    jacobian_residual: the same of the derivatives, None without ``jacobian``; InputError above 1e-6. Both were seen, and are
    no bounds.
    """

    def __init__(self, map: Callable[[np.ndarray], Any], *, jacobian: Optional[Callable[[np.ndarray], Any]] = None,
                 name: Optional[str] = None, piece: Optional[str] = None) -> None:
        self.name = None if name is None else str(name)
        self.piece = self.name if piece is None else str(piece)
        self._chart = _core.OwnChart.of_map(self.name or "chart", map, jacobian)

    @property
    def degrees(self) -> tuple[int, int]:
        s, t = self._chart.degrees
        return s, t

    @property
    def residual(self) -> float:
        return self._chart.residual

    @property
    def jacobian_residual(self) -> Optional[float]:
        return self._chart.tangent_residual

    def __repr__(self):
        return f"<Chart {self.name or 'without a name'} of degrees {self.degrees}>"


class Surface:
    """A surface of the catalogue with its parameters, or one of charts of your own; ``name``, ``pieces``, ``parameters``.

    Surface(charts=[Chart(...), ...], name="hall"): the charts lie in the boundary of a convex body, so that nothing hides
    anything, and light is on its inside, whichever way the charts turn. The surface is closed where each side of a chart is
    one of another, point for point. That is looked at, at 11 x 11 points of each chart, and InputError where it is not so;
    it is not proved, nor is anything else on such a surface: problems take floats alone, results have no radius, and no
    store keeps them.
    """

    def __init__(self, name: Optional[str] = None, parameters: Optional[dict[str, Any]] = None, *,
                 charts: Optional[Sequence[Chart]] = None) -> None:
        self.parameters = dict(parameters or {})
        self.by_functions = charts is not None
        if charts is None:
            if name is None:
                raise TypeError("a surface has a name of the catalogue, or charts")
            self.name = name
            self._choice = _core.SurfaceChoice.named({"name": name, **self.parameters})
            return
        if self.parameters:
            raise TypeError("a surface of charts has no parameters")
        for place, chart in enumerate(charts):
            if not isinstance(chart, Chart):
                raise TypeError(f"charts/{place} is a {type(chart).__name__}, not a Chart")
            if chart.piece == "*":
                _core.refuse("surface", f"/charts/{place}", "*", "is no name of a piece: it stands for the rest", "another name")
        self.name = name or "own surface"
        names = [chart.name or f"chart_{place}" for place, chart in enumerate(charts, 1)]
        self._choice = _core.surface_of_charts(
            self.name, [chart._chart for chart in charts],
            [(name, chart.piece or name) for name, chart in zip(names, charts)])

    @property
    def pieces(self) -> list[str]:
        """The names of the pieces."""
        return self._choice.pieces

    def factors(self, by: str = "piece", accuracy: Optional[float] = None, *, level: int = 0, certified: bool = False,
                rays: bool = False, space: bool = False, store: Store = None, progress: Listener = None) -> Factors:
        """Configuration factors between triangles or pieces, see ``Mesh.factors``; of a surface of plane pieces alone.
        level: each triangle of the coarse triangulation is cut into 4^level.
        certified: as there; InputError where doubles hold the corners in no unit of lengths, as of sides with 30 digits."""
        wanted = None if accuracy is None else real(accuracy, "accuracy")
        return Factors(_core.factors_of_surface(self._choice, level, by, wanted, flag(certified, "certified"),
                                                flag(rays, "rays"), flag(space, "space"),
                                                store_name(store), progress))

    def __repr__(self):
        if self.by_functions:
            return f"<Surface {self.name} of charts of Python: {', '.join(self.pieces)}>"
        values = ", ".join(f"{key}={value}" for key, value in self.parameters.items())
        return f"{self.name}({values})"


def surfaces() -> list[dict[str, Any]]:
    """The catalogue: a list of dicts with name, summary, pieces, parameters and served, whether problems take it."""
    return _core.surfaces()


def surface(name: str, *values: Any, **parameters: Any) -> Surface:
    """A surface of the catalogue, its parameters in their order or by name; what is left out has its default."""
    known = {entry["name"]: [each["name"] for each in entry["parameters"]] for entry in _core.surfaces()}
    names = known.get(name, [])
    if name in known and len(values) > len(names):
        raise TypeError(f"{name} takes {len(names)} parameters ({', '.join(names)}), not {len(values)}")
    given = dict(zip(names, values))
    for key, value in parameters.items():
        if key in given:
            raise TypeError(f"{name}: {key} is given twice")
        given[key] = value
    return Surface(name, given)


def surface_function(name):
    """The function of a surface's name, or None."""
    if name not in {entry["name"] for entry in _core.surfaces()}:
        return None

    def make(*values, **parameters):
        return surface(name, *values, **parameters)

    make.__name__ = make.__qualname__ = name
    entry = next(each for each in _core.surfaces() if each["name"] == name)
    lines = [entry["summary"], "", "Pieces: " + ", ".join(entry["pieces"])]
    for parameter in entry["parameters"]:
        meaning = parameter["meaning"] or "a parameter"
        lines.append(f"{parameter['name']}: {meaning}, {parameter['requirement']}; default {parameter['default']}")
    make.__doc__ = "\n".join(lines)
    return make
