"""Static cost of expressions and functions, in scalar arithmetic operations.

One unit is one multiplication or addition of floats in one lane. The weights are rough figures for
current GPUs; they rank nodes and tell the hopeless ones from the rest. Costs that matter are
measured (:mod:`shadercache.measure.measure`), never taken from here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

from shadercache.ast import nodes as n
from shadercache.ast.walk import children, postorder
from shadercache.sema.facts import Facts

FETCH = 24.0
"""A filtered texture fetch; what a look-up in the cache costs at the very least."""

UNKNOWN_TRIPS = 8.0
"""Assumed trip count of a loop."""

PER_COMPONENT: Mapping[str, float] = {
    **dict.fromkeys(("sin", "cos", "exp", "exp2", "log", "log2"), 8.0),
    **dict.fromkeys(("tan", "sinh", "cosh", "tanh", "asin", "acos", "atan"), 16.0),
    **dict.fromkeys(("asinh", "acosh", "atanh", "pow"), 16.0),
    **dict.fromkeys(("sqrt", "inversesqrt"), 4.0),
    **dict.fromkeys(("mod", "fract", "floor", "ceil", "round", "roundEven", "trunc"), 2.0),
    **dict.fromkeys(("mix", "dot", "fma", "cross", "clamp"), 2.0),
    "smoothstep": 8.0,
    **dict.fromkeys(("length", "distance"), 3.0),
    **dict.fromkeys(("normalize", "reflect", "faceforward"), 4.0),
    "refract": 8.0,
    **dict.fromkeys(("dFdx", "dFdy"), 1.0),
    "fwidth": 3.0,
}
"""Built-in functions that cost other than one unit for each component of their widest operand."""

# A transposed matrix is the same registers in another order.
MATRIX_FUNCTIONS: Mapping[str, float] = {"inverse": 8.0, "determinant": 4.0, "transpose": 0.0}


class CostTable:
    """Cost of evaluating each expression, statement and function of a checked module once.

    A call costs what the called function costs; a loop :data:`UNKNOWN_TRIPS` times its body; of a
    conditional both sides count, since neighbouring fragments may take either.
    """

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self._table: dict[n.Node, float] = {}

    def of(self, node: n.Node) -> float:
        """Cost of an expression or a statement with everything it calls."""
        if node not in self._table:
            for part in postorder(node, self._table):
                cost = sum(self._table[child] for child in children(part))
                if isinstance(part, n.For | n.While | n.DoWhile):
                    cost *= UNKNOWN_TRIPS
                self._table[part] = cost + self._own(part)
        return self._table[node]

    def function(self, function: n.FunctionDef) -> float:
        """Cost of one call, arguments apart."""
        return self.of(function.body)

    def _own(self, node: n.Node) -> float:
        match node:
            case n.Call():
                return self._call(node)
            case n.Binary():
                return self._binary(node)
            case n.Assign() if node.op != "=":
                return self._width(node.value)
            case n.Conditional() | n.Unary(op="-" | "!" | "~" | "++" | "--") | n.Postfix():
                return self._width(node)
        return 0.0

    def _call(self, node: n.Call) -> float:
        callee = self._facts.calls.get(node)
        if isinstance(callee, n.FunctionDef):
            return self.function(callee)
        if node.name.startswith(("texelFetch", "texture", "shadow")):
            # textureSize reads a descriptor, and no texels.
            return FETCH if "Size" not in node.name else 1.0
        width = max([self._width(arg) for arg in node.args], default=1.0)
        if node.name in MATRIX_FUNCTIONS:
            return MATRIX_FUNCTIONS[node.name] * width
        return PER_COMPONENT.get(node.name, 1.0) * width

    def _binary(self, node: n.Binary) -> float:
        types = self._facts.types
        left, right = types.get(node.left), types.get(node.right)
        # A product with a matrix: one multiplication and one addition for each pair of factors.
        if node.op == "*" and left is not None and right is not None:
            if left.is_matrix and (right.is_matrix or right.is_vector):
                return 2.0 * left.components_or_one * (right.cols if right.is_matrix else 1)
            if left.is_vector and right.is_matrix:
                return 2.0 * right.components_or_one
        width = max(self._width(node.left), self._width(node.right))
        return (4.0 if node.op in ("/", "%") else 1.0) * width

    def _width(self, expr: n.Node) -> float:
        kind = self._facts.types.get(cast("n.Expr", expr))
        return float(kind.components_or_one) if kind is not None else 1.0
