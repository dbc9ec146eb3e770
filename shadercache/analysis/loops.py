"""Loops whose length hangs on certain variables: here, on what the cache holds.

A fragment that has no payload, or a pixel at the edge of a triangle that is computed for its
neighbours only, goes on with whatever the cache holds there. In a loop that waits for such a value
it may go round for ever::

    for (float t = 0.0; t < 2.0; t += sc_payload)    // sc_payload is 0.0 where nothing was drawn

The analysis works by name, on a module in which every identifier means one thing, and takes no
account of order: a variable that hangs on the payload anywhere counts everywhere.
"""

from __future__ import annotations

from collections.abc import Iterable

from shadercache.analysis.effects import Does, EffectTable, out_arguments, root_variable
from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk

LOOPS = (n.For, n.While, n.DoWhile)
Loop = n.For | n.While | n.DoWhile

_SHARED = Does.DERIVATIVE | Does.IMPLICIT_LOD
_EXITS = Does.RETURN | Does.DISCARD | Does.JUMP


def decided_loops(module: n.Module, names: Iterable[str]) -> frozenset[n.Node]:
    """The loops that may run for longer or shorter with other values of the named variables.

    Loops with derivatives inside are not among them: what decides on those is never a payload
    (SC315).
    """
    functions = [decl for decl in module.decls if isinstance(decl, n.FunctionDef)]
    if not any(isinstance(item, LOOPS) for function in functions for item in walk(function)):
        return frozenset()
    hanging = _Hanging(EffectTable(module), set(names))
    hanging.all()
    return frozenset(loop for loop in hanging.loops if not hanging.table.of(loop).does & _SHARED)


def hanging_names(module: n.Module, names: Iterable[str]) -> frozenset[str]:
    """The variables whose values, and the functions whose results, hang on the named variables."""
    hanging = _Hanging(EffectTable(module), set(names))
    hanging.all()
    return frozenset(hanging.names)


class _Hanging:
    """Names of variables, and of functions by what they return, that hang on the given ones."""

    def __init__(self, table: EffectTable, names: set[str]) -> None:
        self.table, self.names = table, names
        self.loops: set[n.Node] = set()
        self._function = ""
        self._left = False

    def all(self) -> None:
        """Note everything that hangs on the names."""
        size = -1
        while size < len(self.names):
            size = len(self.names)
            for function in self.table.functions.values():
                self._note(function)

    def _note(self, function: n.FunctionDef) -> None:
        self._function, self._left = function.name, False
        self._statement(function.body, False)

    def _statement(self, stmt: n.Node, under: bool) -> None:
        """``under``: whether the statement is executed hangs on the names already."""
        under = under or self._left
        match stmt:
            case n.Block():
                for item in stmt.body:
                    self._statement(item, under)
                return
            case n.If(condition=first) | n.Switch(selector=first):
                self._plain(first, under)
                inner = under or self._hangs(first)
            case n.For() | n.While() | n.DoWhile():
                inner = under or self._is_decided(stmt)
            case _:
                self._plain(stmt, under)
                return
        for part in children(stmt):
            self._statement(part, inner)
        # Behind a jump that some fragments take, the others are alone.
        self._left |= inner and not under and bool(self.table.of(stmt).does & Does.RETURN)

    def _plain(self, node: n.Node, under: bool) -> None:
        if isinstance(node, n.Return) and (under or (node.value and self._hangs(node.value))):
            self.names.add(self._function)
        if under:
            self.names |= self.table.of(node).writes
        for item in walk(node):
            match item:
                case n.Assign(target=target, value=value):
                    inner = (*children(target), value)
                    self._add(target, any(self._hangs(part) for part in inner))
                case n.Declarator(name=name, init=init) if init is not None and self._hangs(init):
                    self.names.add(name)
                case n.Conditional(condition=first) if self._hangs(first):
                    self.names |= self.table.of(item).writes
                case n.Binary(op="&&" | "||", left=first, right=other) if self._hangs(first):
                    self.names |= self.table.of(other).writes
                case n.Call():
                    self._call(item)

    def _call(self, call: n.Call) -> None:
        function = self.table.functions.get(call.name)
        outs = out_arguments(call, self.table)
        if function is None:
            for arg, out in zip(call.args, outs, strict=True):
                self._add(arg, out and self._hangs(call))
            return
        for arg, param, out in zip(call.args, function.proto.params, outs, strict=True):
            if param.name and self._hangs(arg):
                self.names.add(param.name)
            self._add(arg, out and param.name in self.names)

    def _add(self, target: n.Expr, hangs: bool) -> None:
        root = root_variable(target)
        if hangs and root is not None:
            self.names.add(root)

    def _is_decided(self, loop: Loop) -> bool:
        if loop not in self.loops and (
            (loop.condition is not None and self._hangs(loop.condition)) or self._jumps(loop.body)
        ):
            self.loops.add(loop)
        return loop in self.loops

    def _jumps(self, body: n.Stmt) -> bool:
        """Is there a jump out of the body under a condition that hangs on the names?"""
        return any(
            self._hangs(item.condition if isinstance(item, n.If) else item.selector)
            and bool(self.table.of(item).does & _EXITS)
            for item in walk(body)
            if isinstance(item, n.If | n.Switch)
        )

    def _hangs(self, node: n.Node) -> bool:
        return any(
            item.name in self.names for item in walk(node) if isinstance(item, n.Name | n.Call)
        )
