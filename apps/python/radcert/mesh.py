# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of triangles, from files or from arrays."""
import os
from typing import Any, NamedTuple, Optional

import numpy as np

from . import _core
from .factors import Factors, Listener, Store, flag, real, store_name


def _words(given):
    return [given] if isinstance(given, str) else list(given)


class Piece(NamedTuple):
    """A piece or a group of a mesh.

    ``area`` encloses within ``area_radius`` (proved), in the square of the mesh's unit of length. ``normal``: unit vector to
    the side where light travels, shape (3,), None where the triangles lie in several planes. ``centroid``: shape (3,).
    """

    name: str
    triangles: int
    area: float
    area_radius: float
    normal: Optional[np.ndarray]
    centroid: np.ndarray


class Mesh:
    """A mesh from a file, or from arrays.

    Mesh("room.stl", front="right-hand"); Mesh((points, triangles)); Mesh((points, triangles, groups)).

    points: (n, 3) floats. triangles: (m, 3) ints, places of points counted from 0. groups: a name for each triangle.
    front: the side of a triangle where light travels: "right-hand", from which its corners run counterclockwise,
        "left-hand", or "auto": the inside of what is closed, right-hand else.
    repair: what is to be mended, of "align", "triangulate", "vertices", "faces", "orientation", "manifold", "crossings", "holes";
        nothing is mended unasked.
    two_sided: groups that are plates without thickness; light leaves their backs too.
    angle: in degrees; where normals make more, two pieces meet.
    unit: of the coordinates, "mm", "cm", "m" or "in", which areas carry in what is written; nothing is converted.
    """

    def __init__(self, source, *, front="auto", repair=(), two_sided=(), angle=30, unit=None, name="mesh"):
        options = {"front": front, "repair": _words(repair), "two_sided": _words(two_sided), "angle": angle,
                   "unit": "" if unit is None else unit}
        if isinstance(source, (str, os.PathLike)):
            self._mesh = _core.Mesh.read(os.fspath(source), **options)
            return
        if not isinstance(source, (tuple, list)) or len(source) not in (2, 3):
            raise TypeError("a mesh is the name of a file, (points, triangles) or (points, triangles, groups), not "
                            f"{type(source).__name__}")
        points, triangles, *rest = source
        groups = [str(each) for each in rest[0]] if rest else []
        self._mesh = _core.Mesh.of_arrays(name, points, triangles, groups, **options)

    @property
    def name(self) -> str:
        return self._mesh.name

    @property
    def unit(self) -> Optional[str]:
        """The unit of lengths, None where it is not known."""
        return self._mesh.unit

    @property
    def points(self) -> np.ndarray:
        """(n, 3) floats, in the order of the file."""
        return self._mesh.points

    @property
    def faces(self) -> list[list[int]]:
        """The corners of each face, a list of lists of places of points."""
        return self._mesh.faces

    @property
    def triangles(self) -> Optional[np.ndarray]:
        """(m, 3) ints; None where a face has more corners."""
        return self._mesh.triangles

    @property
    def face_groups(self) -> list[str]:
        """The group of each face, by name."""
        return self._mesh.groups

    @property
    def pieces(self) -> list[Piece]:
        """The smooth pieces, parted along edges sharper than ``angle``."""
        return [Piece(**each) for each in self._mesh.measured("piece")]

    @property
    def groups(self) -> list[Piece]:
        """The groups of the file."""
        return [Piece(**each) for each in self._mesh.measured("group")]

    def survey(self) -> dict[str, Any]:
        """All that is decided about the mesh, as ``radcert surface --json`` writes it: a dict."""
        return self._mesh.survey()

    def factors(self, by: str = "group", accuracy: Optional[float] = None, *, certified: bool = False, rays: bool = False,
                space: bool = False, store: Store = None, progress: Listener = None) -> Factors:
        """Configuration factors (view factors, form factors) between triangles, pieces or groups.

        by: "triangle", "piece" or "group": what a row stands for.
        accuracy: wanted of each row's sum; 1e-5, certified 1e-9, rays 1e-4 where none is given.
        certified: every radius is proved. rays: quasi-Monte Carlo, for scenes of thousands of triangles by group.
        space: the scene is open, and what reaches no front goes to space.
        store: a folder that keeps finished work, or True for that of the program; None keeps nothing.
        progress: a function of a fraction and of words, called in this thread.

        Raises InputError for a scene of which factors mean nothing: crossing triangles, reversed normals, open scenes
        without ``space``. Warns where a row of a closed scene does not sum to 1 within its radius, or an accuracy that
        was asked for was not reached; ``Factors.failures`` has the same words.
        """
        wanted = None if accuracy is None else real(accuracy, "accuracy")
        return Factors(_core.factors_of_mesh(self._mesh, by, wanted, flag(certified, "certified"), flag(rays, "rays"),
                                              flag(space, "space"), store_name(store), progress))

    def __repr__(self):
        return f"<Mesh {self.name}: {self._mesh.format}, {self._mesh.face_count} faces>"
