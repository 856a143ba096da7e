# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases on triangles: nodes and functions by name, from a file, or exactly as Python states them."""
import os
from fractions import Fraction
from math import factorial, isqrt
from typing import Any, Optional

import numpy as np

from . import _core
from .expression import Expression, as_expression

_NAMES = ("x", "y", "z")


class Basis:
    """Functions on the reference triangle and the nodes at which they interpolate.

    Basis(nodes=[(a, b, c), ...]): all polynomials of a degree r, for (r + 1)(r + 2)/2 nodes.
    Basis(space=[...], nodes=[...]): functions of your own, expressions in ``barycentric()``, as many as nodes.
    Basis(functions=[...], nodes=[...]): the same as functions of Python, each of barycentric coordinates, an array (n, 3), that
        gives an array (n,), and each a polynomial of a degree up to 8: it is called once, on 225 points, and is not kept.
    Basis("nodes.json"): a file of nodes. inset(degree, alpha) and symmetric(degree) are the named ones.

    nodes: barycentric coordinates, each from 0 to 1 with the exact sum 1: exact numbers, or expressions made of them with
        at most three different square roots, which are taken exactly.

    by_functions: whether the basis was made of functions of Python. Then ``polynomials`` has those that were found, texts in
    x1, x2, x3 with exact coefficients, of the least degree, and fractions with denominators up to 10000 where these are as
    near; ``residual`` is the largest difference that was seen, relative to the function's largest value, at most 1e-13. All
    that is said and computed of the basis is of these polynomials. That they are the functions is not proved, and no
    solver that proves takes the basis; ``Basis(space=basis.polynomials, nodes=...)`` states them, and is taken by all.
    """

    def __init__(self, file=None, *, space=None, functions=None, nodes=None, label=None):
        self._facts = None
        self._make_facts = None
        self.by_functions = functions is not None
        self.polynomials: Optional[list[str]] = None
        self.residual: Optional[float] = None
        if space is not None and functions is not None:
            raise TypeError("a basis has a space, or functions")
        if file is not None:
            if nodes is not None or space is not None or functions is not None:
                raise TypeError("a basis is a file of nodes, or nodes")
            self._nodes = _core.Nodes.read(os.fspath(file))
            self._document = None
        elif nodes is not None:
            name = label or "nodes"
            if functions is not None:
                found = [polynomial_of(function, f"functions/{place}") for place, function in enumerate(functions)]
                space = self.polynomials = [text for text, _ in found]
                self.residual = max((residual for _, residual in found), default=0.0)
                name = f"estimated, by functions of Python: {name}"
            self._nodes = _core.Nodes.of_document(name, node_document(nodes, space))
            self._document = None
        else:
            raise TypeError("a basis is a file of nodes, or nodes")
        self.label = label or self._nodes.name

    @classmethod
    def _named(cls, document, label, facts):
        basis = cls.__new__(cls)
        basis._nodes, basis._document, basis.label = None, document, label
        basis._facts = None
        basis._make_facts = facts
        basis.by_functions, basis.polynomials, basis.residual = False, None, None
        return basis

    @property
    def facts(self) -> _core.BasisFacts:
        """What is known of interpolation at these nodes, computed at first use."""
        if self._facts is None:
            self._facts = self._nodes.facts() if self._nodes is not None else self._make_facts()
        return self._facts

    @property
    def degree(self) -> int:
        return self.facts.degree

    @property
    def precision(self) -> dict[str, Any]:
        """The degrees of precision of the rule that integrates the interpolant: a dict with "triangle", "parallelogram" and
        "proof", how that is known ("exact", "algebraic", "certificate")."""
        return self.facts.precision

    @property
    def weights(self) -> list[Fraction]:
        """The integrals of the functions, as Fractions; of nodes that are irrational, beside the true ones."""
        return self.facts.weights

    @property
    def nodes(self) -> list[tuple[Fraction, Fraction, Fraction]]:
        """The nodes, as triples of Fractions; of irrational ones those beside them with which problems are solved."""
        return self.facts.nodes

    @property
    def orders(self) -> dict[str, Any]:
        """The orders of convergence that theory predicts: a dict with "everywhere", "nodes" (on a smooth surface with a
        symmetric triangulation), "nodes_logarithm" (whether that is h^p |log h|), "smooth_kernel", "edges"."""
        return self.facts.orders

    def to_json(self) -> dict[str, Any]:
        """What ``radcert basis --json`` writes, as a dict: norm and condition too."""
        return self.facts.json()

    def __repr__(self):
        return f"<Basis {self.label}>"


def inset(degree: int, alpha: Any = None) -> Basis:
    """Polynomials of a degree with nodes inset by 0 <= alpha < 1/3, or alpha="superconvergent"."""
    document = {"family": "inset", "degree": degree}
    label = f"inset of degree {degree}"
    if alpha is not None:
        document["alpha"] = alpha if isinstance(alpha, str) else _core.exact_text(alpha, "alpha")
        label += f", alpha {document['alpha']}"
    return Basis._named(document, label, lambda: _core.inset_facts(degree, alpha))


def symmetric(degree: int) -> Basis:
    """Polynomials of a degree from 1 to 6 with symmetric nodes whose rule has a high degree of precision."""
    return Basis._named({"family": "symmetric", "degree": degree}, f"symmetric of degree {degree}",
                        lambda: _core.symmetric_facts(degree))


def orbit(a: Any, b: Any = None) -> list[tuple[Any, Any, Any]]:
    """The nodes that the symmetries of the triangle make of one: of (1 - 2a, a, a) three, of (a, b, 1 - a - b) six."""
    if b is None:
        c = 1 - 2 * a
        return [(c, a, a), (a, c, a), (a, a, c)]
    c = 1 - a - b
    return [(a, b, c), (a, c, b), (b, a, c), (b, c, a), (c, a, b), (c, b, a)]


_LARGEST_DEGREE = 8
_LARGEST_DENOMINATOR = 10000


def _powers(degree):
    """The exponents of Bernstein's polynomials of a degree; divided by it, the points of its lattice."""
    return np.array([(i, j, degree - i - j) for i in range(degree + 1) for j in range(degree + 1 - i)])


def _bernstein(degree, points):
    """Bernstein's polynomials of a degree at points, a column each."""
    powers = _powers(degree)
    counts = [factorial(degree) // (factorial(i) * factorial(j) * factorial(k)) for i, j, k in powers.tolist()]
    return np.array(counts, dtype=float) * np.prod(points[:, None, :] ** powers[None, :, :], axis=2)


def polynomial_of(function, place):
    """The polynomial of the least degree that a function of Python is, as a text in x1, x2, x3 with exact coefficients, and
    the largest difference between the two that was seen, relative to the largest value of the function."""
    lattices = [_powers(degree) / max(degree, 1) for degree in range(1, _LARGEST_DEGREE + 1)]
    lattices.insert(0, np.full((1, 3), 1 / 3))
    ratio = 1.32471795724474602596
    between = np.array([(i / ratio % 1, i / ratio**2 % 1) for i in range(1, 61)])
    between = np.where(between.sum(axis=1, keepdims=True) > 1, 1 - between, between)
    between = np.column_stack([between, 1 - between.sum(axis=1)])
    points = np.vstack([*lattices, between])
    values = _core.function_values(function, points, place)
    size = float(np.abs(values).max())
    if size == 0:
        _refuse(place, "is zero", "functions that are independent")
    start = 0
    for degree, lattice in enumerate(lattices):
        coefficients = np.linalg.solve(_bernstein(degree, lattice), values[start:start + len(lattice)])
        start += len(lattice)
        exact = [_simple(c, size) for c in coefficients.tolist()]
        off = np.abs(_bernstein(degree, points) @ np.array([float(c) for c in exact]) - values) / size
        worst = int(off.argmax())
        if off[worst] <= 1e-13:
            return _bernstein_text(degree, exact), float(off[worst])
    at = ", ".join(f"{x:.4g}" for x in points[worst])
    return _core.refuse("", place, getattr(function, "__qualname__", type(function).__qualname__),
                        f"is no polynomial of degree {_LARGEST_DEGREE} or less: the nearest that was found is off by "
                        f"{off[worst]:.1e} of its largest value, at ({at})", "polynomials in barycentric coordinates")


def _simple(number, size):
    """A fraction with a small denominator where one is as near as a coefficient is known, else the float exactly."""
    simple = Fraction(number).limit_denominator(_LARGEST_DENOMINATOR)
    return simple if abs(float(simple) - number) <= 1e-11 * size else Fraction(number)


def _bernstein_text(degree, coefficients):
    terms = []
    for (i, j, k), c in zip(_powers(degree).tolist(), coefficients):
        c *= factorial(degree) // (factorial(i) * factorial(j) * factorial(k))
        if c == 0:
            continue
        factors = [str(c)] if c != 1 or degree == 0 else []
        factors += [f"{name}^{power}" if power > 1 else name
                    for name, power in (("x1", i), ("x2", j), ("x3", k)) if power > 0]
        terms.append("*".join(factors))
    return " + ".join(terms).replace("+ -", "- ")


def node_document(nodes, space):
    """Nodes as the file format radcert/nodes/1 has them."""
    roots = {}
    texts = []
    for place, node in enumerate(nodes):
        coordinates = list(node)
        if len(coordinates) != 3:
            _refuse(f"nodes/{place}", f"has {len(coordinates)} coordinates", "three barycentric coordinates")
        texts.append([_coordinate(value, f"nodes/{place}/{axis}", roots) for axis, value in enumerate(coordinates)])
    document = {"schema": "radcert/nodes/1"}
    if space is not None:
        document["space"] = [_function(value, f"space/{place}") for place, value in enumerate(space)]
    else:
        count = len(texts)
        degree = (isqrt(8 * count + 1) - 3) // 2
        if count == 0 or (degree + 1) * (degree + 2) != 2 * count:
            _refuse("nodes", f"are {count}, not as many as polynomials of a degree have coefficients",
                           "1, 3, 6, 10, ... nodes, or a space of as many functions")
        document["degree"] = degree
    document["nodes"] = texts
    if roots:
        document["numbers"] = {name: _square_root(square) for square, name in roots.items()}
    return document


def _refuse(place, problem, allowed):
    _core.refuse("", place, None, problem, allowed)


def _function(value, place):
    text = value.text if isinstance(value, Expression) else value
    if isinstance(text, str):
        return text
    return _core.exact_text(value, place)


def _coordinate(value, place, roots):
    expression = value if isinstance(value, Expression) else None
    if expression is None:
        return _core.exact_text(value, place)
    number = _rational(expression)
    return str(number) if number is not None else _with_roots(expression, place, roots).text


def _rational(expression):
    """The exact value of an expression of numbers alone, None where it is something else."""
    if expression.operation == "number":
        return expression.operands[0]
    if expression.operation not in ("+", "-", "*", "/", "sqrt"):
        return None
    values = [_rational(operand) for operand in expression.operands]
    if any(value is None for value in values):
        return None
    if expression.operation == "sqrt":
        (square,) = values
        if square < 0:
            return None
        top, bottom = isqrt(square.numerator), isqrt(square.denominator)
        exact = top * top == square.numerator and bottom * bottom == square.denominator
        return Fraction(top, bottom) if exact else None
    if len(values) == 1:
        return -values[0]
    a, b = values
    if expression.operation == "/":
        return a / b if b != 0 else None
    return {"+": a + b, "-": a - b, "*": a * b}[expression.operation]


def _with_roots(expression, place, roots):
    """The expression with a name of the file in the place of each irrational square root."""
    number = _rational(expression)
    if number is not None:
        return as_expression(number)
    if expression.operation == "sqrt":
        square = _rational(expression.operands[0])
        if square is None or square < 0:
            _refuse(place, f"has {expression.text}", "square roots of numbers >= 0")
        if square not in roots and len(roots) == len(_NAMES):
            _refuse(place, f"has {expression.text}, beside three other square roots", "three of them")
        name = roots.setdefault(square, _NAMES[len(roots)])
        return Expression("variable", (name,), name, 5)
    operands = [_with_roots(operand, place, roots) for operand in expression.operands
                if isinstance(operand, Expression)]
    if expression.operation == "-" and len(operands) == 1:
        return -operands[0]
    combine = {"+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b}
    if expression.operation not in combine:
        _refuse(place, f"has {expression.text}", "numbers, + - * / and square roots of numbers")
    return combine[expression.operation](*operands)


def _square_root(square):
    """The positive zero of x^2 - q: where it lies, the library proves."""
    floor = isqrt(square.numerator // square.denominator)
    return {"polynomial": [str(-square), "0", "1"], "between": [str(floor), str(floor + 1)]}
