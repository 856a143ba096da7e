# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces by name: ``ellipsoid(1, "3/4", "1/2")`` or ``box(a=4, b=3, c="5/2")``."""
from typing import Any, Optional

from . import _core
from .factors import Factors, Listener, Store, flag, real, store_name


class Surface:
    """A surface of the catalogue with its parameters; ``name``, ``pieces``, ``parameters``."""

    def __init__(self, name, parameters):
        self.name = name
        self.parameters = parameters
        self._choice = _core.SurfaceChoice.named({"name": name, **parameters})

    @property
    def pieces(self) -> list[str]:
        """The names of the pieces."""
        return self._choice.pieces

    def factors(self, by: str = "piece", accuracy: Optional[float] = None, *, level: int = 0, certified: bool = False,
                rays: bool = False, space: bool = False, store: Store = None, progress: Listener = None) -> Factors:
        """Configuration factors between triangles or pieces, see ``Mesh.factors``; of a surface of plane pieces alone.
        level: each triangle of the coarse triangulation is cut into 4^level."""
        wanted = None if accuracy is None else real(accuracy, "accuracy")
        return Factors(_core.factors_of_surface(self._choice, level, by, wanted, flag(certified, "certified"),
                                                flag(rays, "rays"), flag(space, "space"),
                                                store_name(store), progress))

    def __repr__(self):
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
