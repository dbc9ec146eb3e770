"""Replace expressions, knowing both what stood there and what it has become."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from shadercache.ast.nodes import Expr, Node
from shadercache.ast.rewriter import Rewriter

N = TypeVar("N", bound=Node)


class _Replacing(Rewriter):
    def __init__(self, choose: Callable[[Expr, Expr], Expr]) -> None:
        self._choose = choose

    def expression(self, node: Expr, original: Expr) -> Expr:
        return self._choose(original, node)


def replace_expressions(root: N, choose: Callable[[Expr, Expr], Expr]) -> N:
    """The tree with ``choose(original, rebuilt)`` in the place of every expression.

    Called from the bottom up; ``rebuilt`` has the replacements inside it made.
    """
    return _Replacing(choose).rewrite(root)
