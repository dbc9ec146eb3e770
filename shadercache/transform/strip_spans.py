"""Nodes without their places, for those that come from another text than the user's.

A span is an offset into one text. Were the nodes of the runtime's files put among the user's as
they are, a place in the one file would pass for a place in the other, and the user's comments would
be printed at the runtime's functions.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.source import NOWHERE

N = TypeVar("N", bound=n.Node)


def without_places(node: N) -> N:
    """The same tree, made of nodes that stand nowhere."""
    return replace(_SpanStripper().rewrite(node), span=NOWHERE)


class _SpanStripper(Rewriter):
    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        return replace(node, span=NOWHERE)

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        return replace(node, span=NOWHERE)

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        return node if node is n.NO_QUALIFIERS else replace(node, span=NOWHERE)
