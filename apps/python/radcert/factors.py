# SPDX-License-Identifier: GPL-3.0-or-later
"""Matrices of configuration factors, and how they compare with others."""
import numbers
import os
import warnings
from typing import Any, Callable, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .numbers import Approximations

Path = Union[str, "os.PathLike[str]"]
Store = Union[None, bool, Path]
Listener = Optional[Callable[[float, str], Any]]


class FactorWarning(UserWarning):
    """Something about a matrix of factors that a user should look at."""


def store_name(store: Store) -> str:
    """The store as the library knows it."""
    if store is None or store is False:
        return ""
    return "default" if store is True else os.fspath(store)


def flag(value: Any, name: str) -> bool:
    """A word that is True or False; anything else is taken for a slip."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is True or False, not {type(value).__name__}")
    return bool(value)


def real(value: Any, name: str) -> float:
    """A number, and neither a word nor an array."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name} is a number, not {type(value).__name__}: {value!r}"[:200])
    return float(value)


def write(path: Path, content: bytes) -> None:
    """Writes bytes to a file."""
    with open(path, "wb") as file:
        file.write(content)


class Comparison:
    """Two matrices of factors, pair by pair, the largest differences first: ``pairs``, each with ``from_``, ``to``,
    ``ours``, ``radius``, ``theirs``, ``halfwidth``, ``difference``, ``verdict`` and a guess at the ``cause``."""

    def __init__(self, comparison):
        self._comparison = comparison
        self.pairs = comparison.pairs

    def worst(self, count: int = 10) -> list[_core.FactorPair]:
        """The pairs with the largest differences."""
        return self.pairs[:count]

    @property
    def differing(self) -> list[_core.FactorPair]:
        """The pairs for which no number within our radius agrees with theirs."""
        return [pair for pair in self.pairs if pair.verdict == "differs"]

    @property
    def agrees(self) -> bool:
        """Whether no pair differs. Pairs that are undecided do not count."""
        return not self.differing

    def counts(self) -> dict[str, int]:
        """How many pairs have each verdict."""
        out = {"agrees": 0, "differs": 0, "undecided": 0}
        for pair in self.pairs:
            out[pair.verdict] += 1
        return out

    def to_csv(self, path: Path) -> None:
        """Writes all pairs: from, to, ours, radius, theirs, halfwidth, difference, verdict, cause."""
        write(path, self._comparison.csv())

    def to_svg(self, path: Path) -> None:
        """The matrix as a picture, what differs in red."""
        write(path, self._comparison.svg())

    def __repr__(self):
        return f"<Comparison {self.counts()}>"


class Factors:
    """Configuration factors F_IJ: the part of the light that leaves I evenly and arrives at J.

    value, radius: (n, n) floats, ``|exact - value| <= radius``; an exact 0 has the radius 0. names: of rows and columns.
    guaranteed: whether the radii are proved. area, row_sum, to_space: ``Approximations`` of length n; to_space is None
    for a closed scene. closure: (n,) floats, |row sum - 1|. reciprocity: a bound of |A_I F_IJ - A_J F_JI| / sqrt(A_I A_J).
    """

    def __init__(self, factors):
        self._factors = factors
        self.names = factors.names
        self.failures = factors.failures
        for words in factors.warnings + factors.failures:
            warnings.warn(words, FactorWarning, stacklevel=3)

    @property
    def value(self) -> np.ndarray:
        return self._factors.value()

    @property
    def radius(self) -> np.ndarray:
        return self._factors.radius()

    @property
    def guaranteed(self) -> bool:
        return self._factors.guaranteed

    @property
    def open(self) -> bool:
        """Whether light leaves the scene."""
        return self._factors.open

    @property
    def area(self) -> Approximations:
        return Approximations(*self._factors.area())

    @property
    def row_sum(self) -> Approximations:
        return Approximations(*self._factors.row_sum())

    @property
    def to_space(self) -> Optional[Approximations]:
        found = self._factors.to_space()
        return None if found is None else Approximations(*found)

    @property
    def closure(self) -> np.ndarray:
        return self._factors.closure()

    @property
    def reciprocity(self) -> float:
        return self._factors.reciprocity

    def entries(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """The factors that are not exactly 0: arrays (from, to, value, radius), by rows."""
        return self._factors.entries()

    def compare(self, other: Union[npt.ArrayLike, Path], tolerance: float = 0.0, *, relative: float = 0.0,
                halfwidth: float = 0.0) -> Comparison:
        """Holds other factors against these.

        other: an (n, n) array in the order of ``names``, or the name of a file: CSV with from, to, factor, a matrix with
            names about it, or View3D's output.
        tolerance, relative: how far the others may be off beside what their own digits leave; the larger counts.
        halfwidth: of an array, how far its numbers may be from what they stand for (0.5e-4 for four decimals).
        """
        source = os.fspath(other) if isinstance(other, (str, os.PathLike)) else other
        return Comparison(self._factors.compare(source, real(tolerance, "tolerance"), real(relative, "relative"),
                                                real(halfwidth, "halfwidth")))

    def to_csv(self, path: Path) -> None:
        """Writes from, to, factor, radius, guaranteed."""
        write(path, self._factors.csv())

    def surfaces_to_csv(self, path: Path) -> None:
        """Writes name, area, row_sum, row_radius, to_space."""
        write(path, self._factors.surfaces_csv())

    def __repr__(self):
        radius = "proved" if self.guaranteed else "estimated"
        return f"<Factors {len(self.names)} x {len(self.names)} by {self._factors.by}, radii {radius}>"
