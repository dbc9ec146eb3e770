"""Law 8 on a text: derivatives that not all fragments of a quad take together.

Independent of what the compiler itself knows about that: a walk over the calls from ``main``, in
order, which remembers whether the fragments may have parted (by a condition, a loop or a jump that
hangs on what differs between fragments) or some may have been discarded.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import cast

from shadercache.analysis.dataflow import LOOPS
from shadercache.analysis.effect_table import EffectTable, needs_derivative
from shadercache.analysis.effects import Does
from shadercache.analysis.loops import hanging_names
from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk
from shadercache.emit.printer import print_node

SHARED = Does.DERIVATIVE | Does.IMPLICIT_LOD | Does.DISCARD
JUMPS = Does.JUMP | Does.RETURN | Does.DISCARD


def apart_derivatives(module: n.Module) -> list[str]:
    """The derivatives, also for a level of detail, that some fragments may not take."""
    walker = _Walker(module)
    walker.function("main", False)
    return walker.found


class _Walker:
    """``under`` tells that some fragments are elsewhere; ``gone``, that some were discarded."""

    def __init__(self, module: n.Module) -> None:
        self.module, self.table = module, EffectTable(module)
        self.found: list[str] = []
        self.gone = False

    @cached_property
    def differing(self) -> frozenset[str]:
        """What differs between fragments; most texts are done without."""
        return hanging_names(self.module, _varying(self.module))

    def function(self, name: str, under: bool) -> None:
        body = self.table.functions[name].body
        self.block(body.body, under, Does.RETURN)

    def block(self, stmts: tuple[n.Stmt, ...], under: bool, jumps: Does) -> None:
        """Statements in a row; behind one with a jump that some fragments take, they are apart."""
        for stmt in stmts:
            self.statement(stmt, under, jumps)
            under = under or self.parts(stmt, jumps)

    def parts(self, stmt: n.Stmt, jumps: Does) -> bool:
        """Is there such a jump in it that some fragments take and others do not?"""
        if not self.table.of(stmt).does & jumps:
            return False
        over = (item for item in walk(stmt) if self.table.of(item).does & jumps)
        return any(self.differs(head) for item in over for head in _heads(item))

    def statement(self, stmt: n.Stmt, under: bool, jumps: Does) -> None:
        heads = list(_heads(stmt))
        if not self.table.of(stmt).does & SHARED:
            return
        if isinstance(stmt, n.Block):
            self.block(stmt.body, under, jumps)
            return
        if not heads and not isinstance(stmt, LOOPS):
            self.expression(stmt, under)
            return
        inner = under or any(self.differs(head) for head in heads)
        if isinstance(stmt, LOOPS):
            inner = inner or self.parts(stmt.body, JUMPS)
        for part in children(stmt):
            if part in heads and not isinstance(stmt, LOOPS):
                self.expression(part, under)
            elif isinstance(part, n.Block):
                self.block(part.body, inner, JUMPS if isinstance(stmt, LOOPS) else jumps)
            else:
                self.statement(cast("n.Stmt", part), inner, jumps)

    def expression(self, node: n.Node, under: bool) -> None:
        """The parts of an expression in the order in which they are evaluated."""
        for part, apart in self.operands(node):
            self.expression(part, under or apart)
        if isinstance(node, n.Call) and node.name in self.table.functions:
            self.function(node.name, under)
        elif isinstance(node, n.Call) and needs_derivative(node, self.table):
            if under or self.gone:
                self.found.append(print_node(node))
        elif isinstance(node, n.Jump) and node.word == "discard":
            self.gone = self.gone or under

    def operands(self, node: n.Node) -> Iterator[tuple[n.Node, bool]]:
        """Each with whether some fragments may leave it out."""
        match node:
            case n.Conditional(condition=head, then=then, other=other):
                chosen = self.differs(head)
                yield from ((head, False), (then, chosen), (other, chosen))
            case n.Binary(op="&&" | "||", left=left, right=right):
                yield from ((left, False), (right, self.differs(left)))
            case _:
                yield from ((part, False) for part in children(node))

    def differs(self, node: n.Node) -> bool:
        return any(
            item.name in self.differing for item in walk(node) if isinstance(item, n.Name | n.Call)
        )


def _heads(stmt: n.Node) -> Iterator[n.Node]:
    match stmt:
        case n.If(condition=head) | n.Switch(selector=head):
            yield head
        case n.For() | n.While() | n.DoWhile():
            if stmt.condition is not None:
                yield stmt.condition


def _varying(module: n.Module) -> set[str]:
    """What differs between fragments from the start."""
    found = {"gl_FragCoord", "gl_FrontFacing", "gl_PointCoord"}
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("in", "varying"):
            found |= {item.name for item in decl.declarators}
    return found
