"""Spell out compound assignments, so that what a variable holds behind them is a value like others.

    c += f(x), d *= g;         =>        c = c + f(x);
                                         d = d * g;

The sum is an expression then, which can be cut out: a node with the text ``c += f(x)``. Only whole
statements outside of loops are spelled out, and only where the value has no side effect and the
target neither has one nor costs much, for it is read and written apart. The result is the same:
``a op= b`` is ``a = a op b`` but that ``a`` is evaluated once (GLSL 3.30 section 5.8).

What is printed reads like the user's text again: :func:`contract` undoes it wherever nothing was
cut out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from shadercache.analysis.costs.cost import FETCH, CostTable
from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import children, walk
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE, Span
from shadercache.transform.trees import change_functions, copied

# What targets of the same shape may differ in: names, components, operators and literals.
_FIELDS = ("name", "op", "text")
# No loops: a value in one is many values, which no cut can take.
_VISITED = (n.Module, n.FunctionDef, n.Block, n.If, n.Switch, n.ExprStmt)


def expand_compound_assignments(module: n.Module, facts: Facts) -> n.Module:
    """The module with compound assignments spelled out (the same module if there are none).

    ``facts`` are those of ``module``, which has unique names. The new expression has the place of
    the whole assignment; the assignment and its target have none, so that neither is a node.
    """
    return _CompoundExpander(module, facts).rewrite(module)


def contract(module: n.Module, memo: Memo) -> n.Module:
    """The module with compound assignments again, where they are whole."""
    return change_functions(module, _Contracter().rewrite, memo.table("contracted"))


class _StatementRewriter(Rewriter):
    """Visits statements outside of loops, and nothing else."""

    def enter(self, node: n.Node) -> n.Node | None:
        return None if isinstance(node, _VISITED) else node


class _CompoundExpander(_StatementRewriter):
    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._table = EffectTable(module)
        self._costs = CostTable(facts)

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        match node:
            case n.ExprStmt(expr=n.Comma() as comma):
                return [self._spelled(part) for part in _parts(node, comma)]
            case n.ExprStmt():
                return self._spelled(node)
        return node

    def _spelled(self, stmt: n.ExprStmt) -> n.ExprStmt:
        match stmt.expr:
            case n.Assign(span=span, op=op, target=target, value=value) if op != "=":
                if self._may_part(target) and not self._table.of(value).writes:
                    whole = n.Binary(span, op[:-1], target, value)
                    # A node stands in a tree once: tables are keyed by identity.
                    assign = n.Assign(NOWHERE, "=", copied(target, span=NOWHERE), whole)
                    return replace(stmt, expr=assign)
        return stmt

    def _may_part(self, target: n.Expr) -> bool:
        """May the target be evaluated twice?"""
        calls = (node.name for node in walk(target) if isinstance(node, n.Call))
        if self._table.of(target).writes or any(name in self._table.functions for name in calls):
            return False
        return self._costs.of(target) < FETCH


def _parts(stmt: n.ExprStmt, comma: n.Comma) -> Iterator[n.ExprStmt]:
    """A statement for each operand of a comma: nobody reads the value of the last one."""
    operands: list[n.Expr] = []
    stack: list[n.Expr] = [comma]
    while stack:
        part = stack.pop()
        if isinstance(part, n.Comma):
            stack += (part.right, part.left)
        else:
            operands.append(part)
    # Comments stand before the beginning and behind the end of the whole statement.
    starts = [stmt.span.start, *(part.span.start for part in operands[1:])]
    ends = [*(part.span.end for part in operands[:-1]), stmt.span.end]
    for part, start, end in zip(operands, starts, ends, strict=True):
        yield n.ExprStmt(Span(start, end), part)


class _Contracter(_StatementRewriter):
    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        match node:
            # The mark of the expansion is an assignment without a place whose value has one. The
            # user's own `c = c + x` has both, and stays.
            case n.ExprStmt(
                expr=n.Assign(span=span, target=target, value=n.Binary(left=left) as whole)
            ) if span == NOWHERE != whole.span and _equal(target, left):
                expr = n.Assign(whole.span, f"{whole.op}=", left, whole.right)
                return replace(node, expr=expr)
        return node


def _equal(one: n.Node, other: n.Node) -> bool:
    """Are these the same trees?"""
    # Nodes are compared by identity, and the target is a copy.
    if type(one) is not type(other):
        return False
    if any(getattr(one, field, "") != getattr(other, field, "") for field in _FIELDS):
        return False
    some, others = children(one), children(other)
    return len(some) == len(others) and all(map(_equal, some, others))
