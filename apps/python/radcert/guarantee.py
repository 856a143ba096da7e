# SPDX-License-Identifier: GPL-3.0-or-later
"""Enclosures of solutions of the equation itself, and certificates."""
import os
from fractions import Fraction
from typing import Any, NamedTuple, Optional

from . import _core
from .factors import Listener, Path, write


class Proved(NamedTuple):
    """A number with a proved radius: ``|exact - value| <= radius``, floats."""

    value: float
    radius: float
    guaranteed: bool


class OfEmission(NamedTuple):
    """What is proved of the solution for a further emission: as means and points of an Enclosure."""

    means: dict[str, Proved]
    points: list[dict[str, Any]]


class Enclosure:
    """What is proved of the solution u of a problem.

    width: that was reached; wanted: that was asked for. hindrance: "" where it was reached, else what hindered it.
    means: ``Proved`` by piece. points: a list of dicts with piece, at (Fractions), value, radius. function: a dict with
    sup |u - v| for an approximation v, None where that was not asked for. emissions: ``OfEmission`` by the names of
    further emissions.
    """

    def __init__(self, enclosed):
        self._enclosed = enclosed

    @property
    def width(self) -> float:
        return self._enclosed.width

    @property
    def wanted(self) -> Fraction:
        return self._enclosed.wanted

    @property
    def hindrance(self) -> str:
        return self._enclosed.hindrance

    @property
    def reached(self) -> bool:
        """Whether the width that was asked for was reached."""
        return self.hindrance == ""

    @property
    def means(self) -> dict[str, Proved]:
        return {piece: Proved(*mean) for piece, mean in self._enclosed.means().items()}

    @property
    def points(self) -> list[dict[str, Any]]:
        return self._enclosed.points()

    @property
    def emissions(self) -> dict[str, OfEmission]:
        return {name: OfEmission({piece: Proved(*mean) for piece, mean in means.items()}, points)
                for name, (means, points) in self._enclosed.emissions().items()}

    @property
    def function(self) -> Optional[dict[str, Any]]:
        return self._enclosed.function()

    def to_json(self) -> dict[str, Any]:
        """What ``radcert solve --guarantee --json`` writes, as a dict."""
        return self._enclosed.json()

    def to_vtu(self, path: Path) -> None:
        """Writes what is proved of values or of a function for ParaView."""
        write(path, self._enclosed.vtu())

    def certificate_to(self, path: Path) -> None:
        """Writes the certificate, for ``check_certificate`` and ``radcert check``."""
        if self._enclosed.certificate is None:
            raise TypeError("no certificate was asked for: guarantee(..., certificate=True)")
        write(path, self._enclosed.certificate.encode())

    def __repr__(self):
        return f"<Enclosure of width {_core.upper_text(self.width)}, asked for {self.wanted}>"


class Check(NamedTuple):
    """What a check of a certificate found.

    verified: whether all that was looked at holds; refusal: else the place and the reason. elements: how many the certificate
    has, on an ellipsoid rows of points; looked_at: the claims on how many were proved again. means: (midpoint, radius) by
    piece, Fractions. points: of a certificate of values, a list of dicts with piece, at and value, a (midpoint, radius).
    function: of a certificate of a function, how far the solution is from it at most, at points that are outside or more
    from every corner of a face: 0, everywhere.
    """

    verified: bool
    refusal: Optional[str]
    elements: int
    looked_at: int
    means: dict[str, tuple[Fraction, Fraction]]
    points: list[dict[str, Any]]
    function: Optional[Fraction] = None
    outside: Optional[Fraction] = None


def check_certificate(path: Path, elements: Optional[int] = None, *, seed: Optional[str] = None,
                      progress: Listener = None) -> Check:
    """Verifies a certificate with code that shares nothing with the search that wrote it.

    elements: the claims on so many elements are proved again, chosen by ``seed``; None: on all.
    """
    return Check(**_core.check_certificate(os.fspath(path), elements, seed, progress))
