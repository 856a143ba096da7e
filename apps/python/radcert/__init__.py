# SPDX-License-Identifier: GPL-3.0-or-later
"""radcert: verified numerics for the radiosity integral equation.

    import radcert as rc

    rc.reference("cube_opposite_faces")                      # a number with a proof
    rc.Mesh("room.stl").factors(by="group", accuracy=1e-5)   # configuration factors with radii
    rc.Problem(rc.box(4, 3, "5/2"), reflectivity="1/2", emission={"ceiling": 1, "*": 0}).solve()

Arrays are NumPy's; numbers that decide something are exact (``Q``, texts as "1/3"), and a float stands for the double that
it is. Every result says how far it may be off, and whether that is proved. Errors are InputError, AccuracyNotReached,
EnvironmentError, with the words of the program.
"""
from typing import Callable

from . import _core
from ._core import (AccuracyNotReached, Ball, ContractViolation, EnvironmentError, InputError, Interrupted, StoreWarning)
from .basis import Basis, inset, orbit, symmetric
from .edge import Edge, EdgeExponent, edge
from .experiment import Experiment, experiment
from .expression import (Expression, Q, atan, barycentric, cos, exp, expression, log, maximum, minimum, pi, sin, sqrt, tan,
                         xyz)
from .factors import Comparison, Factors, FactorWarning
from .guarantee import Check, Enclosure, Proved, check_certificate
from .mesh import Mesh, Piece
from .numbers import Approximations, Reference, reference, references
from .problem import AtPoints, LevelValues, Problem, Solution
from .progress import progress_bar
from .surfaces import Chart, Surface, surface, surface_function, surfaces
from .verification import Report, claims, verify

__version__ = _core.version
thread_count = _core.thread_count
limit_threads = _core.limit_threads


def solvers() -> list[str]:
    """The names of the solvers."""
    return _core.solvers()


def __getattr__(name: str) -> Callable[..., Surface]:
    """Surfaces of the catalogue by their names: radcert.ellipsoid(1, "3/4", "1/2")."""
    made = surface_function(name) if not name.startswith("_") else None
    if made is None:
        raise AttributeError(f"module 'radcert' has no attribute {name!r}")
    return made


def __dir__():
    return sorted(list(globals()) + [entry["name"] for entry in surfaces()])
