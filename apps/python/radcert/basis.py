# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases on triangles: nodes and functions by name, from a file, or exactly as Python states them."""
import os
from fractions import Fraction
from math import isqrt
from typing import Any

from . import _core
from .expression import Expression, as_expression

_NAMES = ("x", "y", "z")


class Basis:
    """Functions on the reference triangle and the nodes at which they interpolate.

    Basis(nodes=[(a, b, c), ...]): all polynomials of a degree r, for (r + 1)(r + 2)/2 nodes.
    Basis(space=[...], nodes=[...]): functions of your own, expressions in ``barycentric()``, as many as nodes.
    Basis("nodes.json"): a file of nodes. inset(degree, alpha) and symmetric(degree) are the named ones.

    nodes: barycentric coordinates, each from 0 to 1 with the exact sum 1: exact numbers, or expressions made of them with
        at most three different square roots, which are taken exactly.
    """

    def __init__(self, file=None, *, space=None, nodes=None, label=None):
        self._facts = None
        self._make_facts = None
        if file is not None:
            if nodes is not None or space is not None:
                raise TypeError("a basis is a file of nodes, or nodes")
            self._nodes = _core.Nodes.read(os.fspath(file))
            self._document = None
        elif nodes is not None:
            self._nodes = _core.Nodes(label or "nodes", node_document(nodes, space))
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
