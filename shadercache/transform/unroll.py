"""Unroll loops of few trips, so that what is computed in each of them is a value of its own.

A value inside a loop is many values. On request each trip becomes a block that begins with the
counters of the trip, and partial sums can be cached::

    for (int i = 0; i < 2; i++) {          {
        sum += sample(i);                      int i = 0;
    }                                          sum += sample(i);
                                     =>    }
                                           {
                                               int i = 1;
                                               sum += sample(i);
                                           }

A condition on counters alone is decided for each trip, and with it ``if (i == 1) continue;``. The
counters are no constants, although they could be: an index that is out of bounds in a trip
that never gets there would be an error. Loops that cannot be taken apart stay, with a note.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import EXPRESSIONS, children, walk
from shadercache.diagnostics import Diagnostic, Severity
from shadercache.sema.facts import Facts, Scalar
from shadercache.sema.fold import convert
from shadercache.source import NOWHERE, Source, Span
from shadercache.transform.trip_count import Counters, TripCounter, UncountableError

MAX_TRIPS = 64
"""Trips of a loop, those of loops inside it multiplied."""

MAX_EXPRESSIONS = 60_000
"""Expressions of the unrolled shader on all its call paths (they are analysed in seconds)."""


@dataclass(frozen=True, slots=True)
class Unrolled:
    """The module (the same one where nothing was unrolled), and which loops stay, and why."""

    module: n.Module
    notes: tuple[Diagnostic, ...]


def unroll_loops(module: n.Module, facts: Facts, source: Source) -> Unrolled:
    """Unroll what can be unrolled.

    ``facts`` are those of ``module``, which has unique names and one declarator to a declaration.
    In what comes out names are not unique.
    """
    unroller = _Unroller(module, facts)
    made = unroller.module()
    if made is not module and unroller.sizes.of_call("main") > MAX_EXPRESSIONS:
        message = f"no loop is unrolled: the shader would have over {MAX_EXPRESSIONS} expressions"
        return Unrolled(module, (Diagnostic("SC414", message, source, severity=Severity.NOTE),))
    notes = (_note(loop, reason, source) for loop, reason in unroller.kept.items())
    return Unrolled(made, tuple(notes))


def _note(loop: n.For, reason: str, source: Source) -> Diagnostic:
    head = Span(loop.span.start, max(loop.span.start, loop.body.span.start))
    message = f"this loop is not unrolled: {reason}"
    return Diagnostic("SC414", message, source, head, severity=Severity.NOTE)


class _TooMuchError(Exception):
    """A loop would be too long, with those inside it; says why."""


class _Sizes:
    """How many expressions a piece of program has on all its call paths."""

    def __init__(self, functions: Mapping[str, n.FunctionDef]) -> None:
        self._functions = dict(functions)
        self._calls: dict[str, int] = {}

    def replace(self, function: n.FunctionDef) -> None:
        self._functions[function.name] = function
        self._calls.clear()

    def of_call(self, name: str) -> int:
        if name not in self._calls:
            self._calls[name] = self.of(self._functions[name].body)
        return self._calls[name]

    def of(self, node: n.Node) -> int:
        total = 0
        for item in walk(node):
            total += isinstance(item, EXPRESSIONS)
            if isinstance(item, n.Call) and item.name in self._functions:
                total += self.of_call(item.name)
        return total


class _Unroller:
    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._module, self._facts = module, facts
        self.counter = TripCounter(module, facts)
        self._table = EffectTable(module)
        self.sizes = _Sizes(self._table.functions)
        self.kept: dict[n.For, str] = {}

    def module(self) -> n.Module:
        decls: list[n.Decl] = []
        for decl in self._module.decls:
            made = decl
            if isinstance(decl, n.FunctionDef):
                made = _LoopRewriter(self, {}).rewrite(decl)
                if made is not decl:
                    self.sizes.replace(made)
            decls.append(made)
        same = all(new is old for new, old in zip(decls, self._module.decls, strict=True))
        return self._module if same else replace(self._module, decls=tuple(decls))

    def outermost(self, loop: n.For) -> list[n.Block] | None:
        """The trips of a loop that stands in no other; ``None`` if it stays."""
        kept = dict(self.kept)
        reason = ""
        for deep in (True, False):
            try:
                return self.trips(loop, {}, deep)[0]
            except (UncountableError, _TooMuchError) as error:
                reason = str(error)
            self.kept = dict(kept)
        self.kept[loop] = reason
        return None

    def trips(self, loop: n.For, around: Counters, deep: bool) -> tuple[list[n.Block], int]:
        """A block for each trip, and how many trips these are with those of loops inside.

        ``deep``: loops inside are unrolled as well, where possible.
        """
        self._check(loop)
        counted = self.counter.trips(loop, around, MAX_TRIPS)
        if not counted and not around:
            raise UncountableError("it makes no trip")
        made: list[n.Block] = []
        count = size = 0
        for own in counted:
            inside = _LoopRewriter(self, {**around, **own}, deep)
            body = inside.rewrite(loop.body)
            stmts, leaves = _up_to_jump(body.body if isinstance(body, n.Block) else (body,))
            if any(map(_jumps, stmts)):
                raise UncountableError("there is a break or continue in it")
            start = loop.body.span if made else loop.span  # A comment before the loop stays there.
            span = Span(start.start, loop.body.span.end)
            made.append(n.Block(span, (*self._counters(loop, own), *map(_copy, stmts))))
            count += max(1, inside.trips)
            size += self.sizes.of(made[-1])
            if count > MAX_TRIPS:
                raise _TooMuchError(
                    f"with the loops inside it it makes more than {MAX_TRIPS} trips"
                )
            if size > MAX_EXPRESSIONS:
                raise _TooMuchError(f"it would have over {MAX_EXPRESSIONS} expressions")
            if leaves == "break":
                break
        return made, count

    def _check(self, loop: n.For) -> None:
        if any(isinstance(item, n.StructDef) for item in walk(loop.body)):
            raise UncountableError("a struct is defined in it")
        if self._table.of(loop.init).writes & self._table.of(loop.body).writes:
            raise UncountableError("its counter is written in its body")

    def _counters(self, loop: n.For, own: Counters) -> Iterator[n.DeclStmt]:
        """The declarations that a trip begins with; they stand nowhere, but their names do."""
        assert isinstance(loop.init, n.DeclStmt) and isinstance(loop.init.decl, n.VarDecl)
        decl = loop.init.decl
        for item in decl.declarators:
            kind = self._facts.declared[item].type
            value = _literal(own[item.name], kind.base or "")
            made = replace(item, init=value)
            yield n.DeclStmt(NOWHERE, replace(_copy(decl), declarators=(made,)))


class _LoopRewriter(Rewriter):
    """Unrolls the loops of a piece of program, which stands in trips of the loops ``around`` it."""

    def __init__(self, unroller: _Unroller, around: Counters, deep: bool = True) -> None:
        self._unroller, self._around, self._deep = unroller, around, deep
        self._unrolled: set[n.Node] = set()
        self.trips = 0

    def enter(self, node: n.Node) -> n.Node | None:
        match node:
            case n.For():
                made = self._trips(node)
                if made is None:
                    return node
                block = n.Block(node.span, tuple(made))
                self._unrolled.add(block)
                return block
            case n.If() if self._around:
                holds = self._unroller.counter.decision(node.condition, self._around)
                return None if holds is None else self._chosen(node.then if holds else node.other)
            case n.FunctionDef() | n.Block() | n.If() | n.Switch():
                return None
        return node

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        if isinstance(node, n.Block | n.Switch) and not self._unrolled.isdisjoint(node.body):
            return replace(node, body=tuple(self._spliced(node.body)))
        return node

    def _chosen(self, branch: n.Stmt | None) -> n.Stmt:
        """The branch that a trip takes; what it never comes by is not there."""
        if branch is not None:
            return self.rewrite(branch)
        nothing = n.Block(NOWHERE, ())
        self._unrolled.add(nothing)
        return nothing

    def _spliced(self, stmts: Sequence[n.Stmt]) -> Iterator[n.Stmt]:
        for stmt in stmts:
            if isinstance(stmt, n.Block) and stmt in self._unrolled:
                yield from stmt.body
            else:
                yield stmt

    def _trips(self, loop: n.For) -> list[n.Block] | None:
        if not self._around:
            return self._unroller.outermost(loop)
        if not self._deep:
            reason = f"with the loop around it there would be more than {MAX_TRIPS} trips"
            self._unroller.kept[loop] = reason
            return None
        try:
            made, count = self._unroller.trips(loop, self._around, True)
        except UncountableError as error:
            self._unroller.kept[loop] = str(error)
            return None
        self.trips += count
        return made


class _Copier(Rewriter):
    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        return replace(node)

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        return replace(node)

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        return node if node is n.NO_QUALIFIERS else replace(node)


_N = TypeVar("_N", bound=n.Node)


def _copy(node: _N) -> _N:
    """The same tree, of other nodes: each trip has its own."""
    return _Copier().rewrite(node)


def _up_to_jump(stmts: Sequence[n.Stmt]) -> tuple[list[n.Stmt], str]:
    """The statements before a ``break`` or ``continue`` that is always come by, and which it is."""
    kept: list[n.Stmt] = []
    for stmt in stmts:
        match stmt:
            case n.Jump(word="break" | "continue" as word):
                return kept, word
            case n.Block():
                inner, leaves = _up_to_jump(stmt.body)
                kept.append(replace(stmt, body=tuple(inner)) if leaves else stmt)
                if leaves:
                    return kept, leaves
            case _:
                kept.append(stmt)
    return kept, ""


def _jumps(body: n.Stmt) -> bool:
    """Does a ``break`` or ``continue`` in a loop's body belong to the loop?"""
    stack: list[tuple[n.Node, bool]] = [(body, False)]
    while stack:
        node, in_switch = stack.pop()
        if isinstance(node, n.Jump):
            if node.word == "continue" or (node.word == "break" and not in_switch):
                return True
        elif not isinstance(node, n.For | n.While | n.DoWhile):
            inner = in_switch or isinstance(node, n.Switch)
            stack += ((child, inner) for child in children(node))
    return False


def _literal(value: Scalar, base: str) -> n.Expr:
    """A number as GLSL writes it."""
    text = _shortest(value) if isinstance(value, float) else str(value)
    number = n.Literal(NOWHERE, text.removeprefix("-") + ("u" if base == "uint" else ""))
    return n.Unary(NOWHERE, "-", number) if text.startswith("-") else number


def _shortest(value: float) -> str:
    """As few digits as tell a float of 32 bits from all others; nine always do."""
    for digits in range(1, 10):
        text = f"{value:.{digits}g}"
        if convert(float(text), "float") == value:
            break
    return repr(float(text))
