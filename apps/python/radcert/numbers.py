# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers with a radius: arrays of them, and reference values in balls of any precision."""
from fractions import Fraction
from typing import Any, NamedTuple, Optional

import numpy as np

from . import _core
from ._core import Ball


class Approximations(NamedTuple):
    """Numbers as they were computed, with their errors: arrays of one length.

    ``value``: float64. ``radius``: float64, ``|exact - value| <= radius``; infinite where nothing is known of the error.
    ``guaranteed``: bool, True where that is a theorem, False where the radius is an estimate.
    """

    value: np.ndarray
    radius: np.ndarray
    guaranteed: np.ndarray

    @property
    def lower(self) -> np.ndarray:
        """Bounds from below, rounded downwards."""
        return np.nextafter(self.value - self.radius, -np.inf)

    @property
    def upper(self) -> np.ndarray:
        """Bounds from above, rounded upwards."""
        return np.nextafter(self.value + self.radius, np.inf)


def ball_to_arb(ball: Ball) -> Any:
    """A ``flint.arb`` (python-flint) that contains the ball."""
    import flint

    middle, radius = ball.midpoint_binary, ball.radius_binary
    return flint.arb(middle, radius)


def ball_to_mpf(ball: Ball) -> Any:
    """The midpoint of a ball as an ``mpmath.mpf``, exactly, whatever ``mp.prec`` is."""
    import mpmath

    mantissa, exponent = ball.midpoint_binary
    return mpmath.mp.make_mpf(mpmath.libmp.from_man_exp(mantissa, exponent))


def ball_to_iv(ball: Ball) -> Any:
    """An interval ``mpmath.iv.mpf`` that contains the ball, its ends rounded outwards to ``mpmath.iv.prec`` bits."""
    import mpmath

    middle = mpmath.iv.make_mpf((mpmath.libmp.from_man_exp(*ball.midpoint_binary),) * 2)
    radius = mpmath.iv.make_mpf((mpmath.libmp.from_man_exp(*ball.radius_binary),) * 2)
    return middle + radius * mpmath.iv.mpf([-1, 1])


class Reference:
    """A reference value: a number enclosed by two routes that share only their arithmetic.

    ``midpoint`` and ``radius`` are decimals, as texts, rounded such that they enclose the value: the radius is at most
    10^-digits. ``ball`` is the first route's ball, exactly.
    """

    def __init__(self, record):
        self._record = record
        self.midpoint, self.radius = record.decimal()

    @property
    def name(self) -> str:
        return self._record.name

    @property
    def digits(self) -> int:
        """The radius is at most 10^-digits."""
        return self._record.digits

    @property
    def parameters(self) -> dict[str, Fraction]:
        """The values of the family's parameters, as a dict of Fractions."""
        return self._record.parameters

    @property
    def formula(self) -> str:
        return self._record.formula

    @property
    def source(self) -> str:
        return self._record.source

    @property
    def guaranteed(self) -> bool:
        """Whether the radius is proved."""
        return self._record.guaranteed

    @property
    def routes(self) -> list[_core.Route]:
        """The two routes, each with ``how`` and ``ball``."""
        return self._record.routes

    @property
    def ball(self) -> Ball:
        return self._record.routes[0].ball

    def to_arb(self) -> Any:
        """A ``flint.arb`` that contains the value; needs python-flint."""
        return ball_to_arb(self.ball)

    def to_mpf(self) -> Any:
        """The midpoint as an ``mpmath.mpf``, exactly; needs mpmath."""
        return ball_to_mpf(self.ball)

    def to_iv(self) -> Any:
        """An ``mpmath.iv`` interval that contains the value; needs mpmath."""
        return ball_to_iv(self.ball)

    def to_json(self) -> dict[str, Any]:
        """What ``radcert reference --json`` writes, as a dict."""
        return self._record.json()

    def __float__(self):
        return float(self.ball)

    def __repr__(self):
        proved = "proved" if self.guaranteed else "estimated"
        return f"<Reference {self.name}: {self.midpoint} +- {self.radius} ({proved})>"


def reference(name: str, digits: Optional[int] = None, **parameters: Any) -> Reference:
    """A reference value by its name, or a member of a family by the values of its parameters.

    digits: the radius is at most 10^-digits, from 1 to 1000; 20 where none is asked for, and for the means of continuous
        solutions what their certificates prove.
    parameters: exact numbers, as ``Q``, ints, Fractions, texts ("1/3", "0.1"); a float is the double that it is.

    Raises InputError for a name or a value that is not allowed, AccuracyNotReached where a route does not get so far.
    """
    return Reference(_core.reference(name, digits, parameters))


def references() -> list[dict[str, Any]]:
    """All names that ``reference`` takes: a list of dicts with name, kind ("value", "family", "mean"), summary, family, and
    of a family the parameters: {name: (default, what is allowed)}."""
    return _core.references()


__all__ = ["Approximations", "Ball", "Reference", "reference", "references"]
