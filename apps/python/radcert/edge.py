# SPDX-License-Identifier: GPL-3.0-or-later
"""The exponents of the solution at an edge."""
from typing import Any, NamedTuple, Optional

from . import _core


class EdgeExponent(NamedTuple):
    """A power r^b of the distance from the edge, with a proof by two routes.

    real: the real part of b, a pair of decimals, midpoint and radius. imaginary: the same of the imaginary part, whose
    conjugate is an exponent too; None where b is real. symmetric: whether u is the same on both faces in that part of it.
    """

    real: tuple[str, str]
    imaginary: Optional[tuple[str, str]]
    symmetric: bool

    @property
    def value(self) -> complex:
        """b, rounded to doubles."""
        return complex(float(self.real[0]), 0.0 if self.imaginary is None else float(self.imaginary[0]))


class Edge:
    """What is known of the solution at an edge, where it is u_0 + c r^b + ..., r the distance from the edge.

    exponents: list of ``EdgeExponent``, all with a real part up to the one that was asked for, which is proved; None where
    they were not counted, and ``not_counted`` says why. smallest: the smallest, a pair of decimals, midpoint and radius,
    proved; None where the faces do not see each other or one reflects nothing. logarithms: whether u has terms r^n log r.
    """

    def __init__(self, found):
        self._found = found
        self.exponents = None if found["exponents"] is None else [
            EdgeExponent(_pair(each["real"]), _pair(each["imaginary"]), each["symmetry"] == "symmetric")
            for each in found["exponents"]]
        self.not_counted: Optional[str] = found["not_counted"]
        self.smallest = _pair(found["smallest"])
        self.logarithms: bool = found["logarithms"]

    def order(self, degree: int) -> float:
        """The order of convergence on a uniform mesh, with polynomials of a degree from 0 to 4."""
        return self._of(degree)["uniform_order"]

    def grading(self, degree: int) -> float:
        """The exponent of a grading towards the edge that brings the order degree + 1, for a degree from 0 to 4."""
        return self._of(degree)["grading"]

    def _of(self, degree):
        for each in self._found["degrees"]:
            if each["degree"] == degree:
                return each
        return _core.refuse("degree", "", str(degree), "is not allowed", "a whole number from 0 to 4")

    def to_json(self) -> dict[str, Any]:
        """What ``radcert edge --json`` writes, as a dict."""
        return self._found

    def __repr__(self):
        return f"<Edge of {self._found['angle']} degrees, reflectivities {', '.join(self._found['reflectivities'])}>"


def _pair(ball):
    return None if ball is None else (ball["midpoint"], ball["radius"])


def edge(angle: Any, rho: Any, rho_other: Any = None, *, up_to: Any = 3, digits: int = 12) -> Edge:
    """The exponents of the solution at an edge between two plane faces, proved.

    angle: the dihedral angle in degrees, in (0, 360). rho, rho_other: the reflectivities of the two faces, in [0, 1); the
    same where only one is given. Exact numbers. up_to: exponents are sought whose real part is at most this, in (0, 20].
    digits: radii are at most 10^-digits, 1 to 100. Raises AccuracyNotReached where an exponent is not found.
    """
    return Edge(_core.edge(angle, rho, rho_other, up_to, digits))
