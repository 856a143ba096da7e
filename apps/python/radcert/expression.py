# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas in x, y, z that are built by Python's operators and evaluated, enclosed and proved by the library.

An expression is the text that a problem file would have: ``exp(x/2 + y/3)`` as Python writes it becomes the same
characters, with every number exact. A Python float stands for the double that it is: ``0.1*x`` is
``3602879701896397/36028797018963968*x``; write ``Q("0.1")*x`` or ``x/10`` for a tenth.
"""
from fractions import Fraction
from typing import Any

from . import _core

# What the library reads of one expression; a longer one is refused while it is built, not when memory has ended.
_LONGEST = 4096
_SUM, _PRODUCT, _SIGNED, _POWER, _PRIMARY = 1, 2, 3, 4, 5
_SPACE = frozenset("xyz")
_BARYCENTRIC = frozenset(["x1", "x2", "x3"])


def Q(numerator: Any, denominator: Any = 1) -> Fraction:
    """An exact number: ``Q(1, 3)``, ``Q("0.1")``, ``Q("1/3")``. A float is the double that it is.

    Gives a ``fractions.Fraction``.
    """
    top = Fraction(_core.exact_text(numerator, "numerator"))
    bottom = Fraction(_core.exact_text(denominator, "denominator"))
    if bottom == 0:
        _core.refuse("", "denominator", "0", "is zero", "a number other than zero")
    return top / bottom


class Expression:
    """A formula: made of ``xyz()``, ``barycentric()``, numbers, ``+ - * / **`` and the functions of this module.

    ``text`` is what the library reads. Called with points, an array of the shape (n, 3), it gives the n values in
    double precision, as the library evaluates them.
    """

    __slots__ = ("operation", "operands", "text", "_level", "names")
    __array_ufunc__ = None  # NumPy's numbers leave operators to this class

    def __init__(self, operation, operands, text, level, names=frozenset()):
        self.operation = operation
        self.operands = operands
        self.text = text
        self._level = level
        self.names = names
        if len(text) > _LONGEST:
            _core.refuse("expression", "", text[:40] + "...", f"has {len(text)} characters", f"at most {_LONGEST}")
        if names & _SPACE and names & _BARYCENTRIC:
            _core.refuse("expression", "", text, "has coordinates of space beside barycentric ones", "one kind of them")

    @property
    def _radcert_text(self):
        return self.text

    def _at(self, level):
        return self.text if self._level >= level else f"({self.text})"

    def __call__(self, points: Any) -> Any:
        return _core.evaluate_expression(self.text, points)

    def __repr__(self):
        return f"<Expression {self.text}>"

    def __str__(self):
        return self.text

    def __add__(self, other: Any) -> "Expression":
        return _binary("+", self, other, _SUM, _SUM, _PRODUCT)

    def __radd__(self, other: Any) -> "Expression":
        return _binary("+", other, self, _SUM, _SUM, _PRODUCT)

    def __sub__(self, other: Any) -> "Expression":
        return _binary("-", self, other, _SUM, _SUM, _PRODUCT)

    def __rsub__(self, other: Any) -> "Expression":
        return _binary("-", other, self, _SUM, _SUM, _PRODUCT)

    def __mul__(self, other: Any) -> "Expression":
        return _binary("*", self, other, _PRODUCT, _PRODUCT, _SIGNED)

    def __rmul__(self, other: Any) -> "Expression":
        return _binary("*", other, self, _PRODUCT, _PRODUCT, _SIGNED)

    def __truediv__(self, other: Any) -> "Expression":
        return _binary("/", self, other, _PRODUCT, _PRODUCT, _SIGNED)

    def __rtruediv__(self, other: Any) -> "Expression":
        return _binary("/", other, self, _PRODUCT, _PRODUCT, _SIGNED)

    def __pow__(self, other: Any) -> "Expression":
        return _binary("^", self, other, _POWER, _PRIMARY, _SIGNED)

    def __rpow__(self, other: Any) -> "Expression":
        return _binary("^", other, self, _POWER, _PRIMARY, _SIGNED)

    def __neg__(self) -> "Expression":
        return Expression("-", (self,), f"-{self._at(_SIGNED)}", _SIGNED, self.names)

    def __pos__(self) -> "Expression":
        return self

    def __abs__(self) -> "Expression":
        return _function("abs", self)

    def __bool__(self):
        raise TypeError("an expression is neither true nor false")


def as_expression(value):
    """A number or an expression as an expression; ``None`` for everything else."""
    if isinstance(value, Expression):
        return value
    if isinstance(value, str) or value is None:
        return None
    try:
        text = _core.exact_text(value, "number")
    except _core.InputError as error:
        if error.problem.startswith("is of the type"):
            return None
        raise
    level = _SIGNED if text.startswith("-") else _PRIMARY
    return Expression("number", (Fraction(text),), text, _PRODUCT if "/" in text else level)


def _binary(sign, left, right, level, left_level, right_level):
    a, b = as_expression(left), as_expression(right)
    if a is None or b is None:
        return NotImplemented
    spaced = f" {sign} " if sign in "+-" else sign
    text = f"{a._at(left_level)}{spaced}{b._at(right_level)}"
    return Expression(sign, (a, b), text, level, a.names | b.names)


def _function(name, *arguments):
    operands = []
    for argument in arguments:
        operand = as_expression(argument)
        if operand is None:
            raise TypeError(f"{name} takes numbers and expressions, not {type(argument).__name__}")
        operands.append(operand)
    text = f"{name}({', '.join(operand.text for operand in operands)})"
    names = frozenset().union(*(operand.names for operand in operands))
    return Expression(name, tuple(operands), text, _PRIMARY, names)


def _variable(name):
    return Expression("variable", (name,), name, _PRIMARY, frozenset([name]))


def xyz() -> tuple[Expression, Expression, Expression]:
    """The coordinates of a point of space, as three expressions."""
    x, y, z = (_variable(name) for name in "xyz")
    return x, y, z


def barycentric() -> tuple[Expression, Expression, Expression]:
    """The barycentric coordinates of a point of the reference triangle, as three expressions x1, x2, x3."""
    x1, x2, x3 = (_variable(name) for name in ("x1", "x2", "x3"))
    return x1, x2, x3


pi = Expression("pi", (), "pi", _PRIMARY)


def sqrt(x: Any) -> Expression:
    """The square root of a number or an expression; of a number it is exact, also where it is irrational."""
    return _function("sqrt", x)


def exp(x: Any) -> Expression:
    """e to the power of x."""
    return _function("exp", x)


def log(x: Any) -> Expression:
    """The natural logarithm."""
    return _function("log", x)


def sin(x: Any) -> Expression:
    """The sine, of an angle in radians."""
    return _function("sin", x)


def cos(x: Any) -> Expression:
    """The cosine, of an angle in radians."""
    return _function("cos", x)


def tan(x: Any) -> Expression:
    """The tangent, of an angle in radians."""
    return _function("tan", x)


def atan(x: Any) -> Expression:
    """The inverse tangent, in radians, from -pi/2 to pi/2."""
    return _function("atan", x)


def minimum(a: Any, b: Any) -> Expression:
    """The smaller of two."""
    return _function("min", a, b)


def maximum(a: Any, b: Any) -> Expression:
    """The larger of two."""
    return _function("max", a, b)


def expression(text: str) -> Expression:
    """A formula from a text, as a problem file has it: ``expression("1/sqrt(x^2 + y^2 + 1)")``."""
    _core.require_expression(text, False)
    return Expression("text", (), text, _SUM, _SPACE)
