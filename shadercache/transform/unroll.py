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

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import EXPRESSIONS, children, walk
from shadercache.diagnostics import Diagnostic, Severity
from shadercache.sema.facts import Facts, Scalar
from shadercache.sema.fold import convert
from shadercache.source import NOWHERE, Source, Span
from shadercache.transform.trees import block_of, change_functions, copied
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
    flat = change_functions(module, unroller.function)
    # Each loop may be short enough, and their product along the call paths too long.
    if flat is not module and unroller.size_of_call("main") > MAX_EXPRESSIONS:
        message = f"no loop is unrolled: the shader would have over {MAX_EXPRESSIONS} expressions"
        return Unrolled(module, (Diagnostic("SC414", message, source, severity=Severity.NOTE),))
    notes = (_note(loop, reason, source) for loop, reason in unroller.kept.items())
    return Unrolled(flat, tuple(notes))


def _note(loop: n.For, reason: str, source: Source) -> Diagnostic:
    head = Span(loop.span.start, max(loop.span.start, loop.body.span.start))
    message = f"this loop is not unrolled: {reason}"
    return Diagnostic("SC414", message, source, head, severity=Severity.NOTE)


class _TooMuchError(Exception):
    """A loop would be too long, with those inside it; says why."""


class _Unroller:
    """Unrolls the loops of a module; ``kept`` are those that stay, and why."""

    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._facts = facts
        self._table = EffectTable(module)
        self._functions = dict(self._table.functions)
        self._sizes: dict[str, int] = {}
        self.counter = TripCounter(module, facts)
        self.kept: dict[n.For, str] = {}

    def function(self, function: n.FunctionDef) -> n.FunctionDef:
        flat = _LoopRewriter(self, {}).rewrite(function)
        if flat is not function:
            self._functions[flat.name] = flat
            # The sizes of its callers contain that of the function.
            self._sizes.clear()
        return flat

    def size_of_call(self, name: str) -> int:
        """How many expressions a function has on all its call paths."""
        if name not in self._sizes:
            self._sizes[name] = self._size(self._functions[name].body)
        return self._sizes[name]

    def _size(self, node: n.Node) -> int:
        total = 0
        for part in walk(node):
            total += isinstance(part, EXPRESSIONS)
            if isinstance(part, n.Call) and part.name in self._functions:
                total += self.size_of_call(part.name)
        return total

    def outermost(self, loop: n.For) -> list[n.Block] | None:
        """The trips of a loop that stands in no other; ``None`` if it stays."""
        kept = dict(self.kept)
        reason = ""
        # Where it is too much with the loops inside, they may stay as they are.
        for deep in (True, False):
            try:
                return self.trips(loop, {}, deep)[0]
            except (UncountableError, _TooMuchError) as error:
                reason = str(error)
            # A try that failed leaves no notes on inner loops.
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
        trips: list[n.Block] = []
        count = size = 0
        for own in counted:
            inside = _LoopRewriter(self, {**around, **own}, deep)
            stmts, leaves = _up_to_jump(block_of(inside.rewrite(loop.body)).body)
            # A block can be left early neither by ``break`` nor by ``continue``.
            if any(map(_jumps, stmts)):
                raise UncountableError("there is a break or continue in it")
            # A comment before the loop stays there.
            start = (loop.body if trips else loop).span.start
            # Trips share what no decision changed, and tables know nodes by identity: hence copies.
            body = (*self._counters(loop, own), *map(copied, stmts))
            trips.append(n.Block(Span(start, loop.body.span.end), body))
            # A trip counts as the trips of the loops inside it, so those of nested loops multiply.
            count += max(1, inside.trips)
            size += self._size(trips[-1])
            if count > MAX_TRIPS:
                raise _TooMuchError(
                    f"with the loops inside it it makes more than {MAX_TRIPS} trips"
                )
            if size > MAX_EXPRESSIONS:
                raise _TooMuchError(f"it would have over {MAX_EXPRESSIONS} expressions")
            if leaves == "break":
                break
        return trips, count

    def _check(self, loop: n.For) -> None:
        # Names of structs are not made unique, and each trip would define it again.
        if any(isinstance(part, n.StructDef) for part in walk(loop.body)):
            raise UncountableError("a struct is defined in it")
        if self._table.of(loop.init).writes & self._table.of(loop.body).writes:
            raise UncountableError("its counter is written in its body")

    def _counters(self, loop: n.For, own: Counters) -> Iterator[n.DeclStmt]:
        """The declarations that a trip begins with; they stand nowhere, but their names do."""
        assert isinstance(loop.init, n.DeclStmt) and isinstance(loop.init.decl, n.VarDecl)
        decl = loop.init.decl
        for variable in decl.declarators:
            kind = self._facts.declared[variable].type
            counter = replace(variable, init=_literal(own[variable.name], kind.base or ""))
            yield n.DeclStmt(NOWHERE, replace(copied(decl), declarators=(counter,)))


class _LoopRewriter(Rewriter):
    """Unrolls the loops of a piece of program, which stands in trips of the loops ``around`` it."""

    def __init__(self, unroller: _Unroller, around: Counters, deep: bool = True) -> None:
        self._unroller, self._around, self._deep = unroller, around, deep
        self._unrolled: set[n.Node] = set()
        self.trips = 0

    def enter(self, node: n.Node) -> n.Node | None:
        match node:
            case n.For():
                trips = self._trips(node)
                return node if trips is None else self._spliceable(node.span, trips)
            case n.If(condition=condition, then=then, other=other) if self._around:
                holds = self._unroller.counter.decision(condition, self._around)
                if holds is None:
                    return None
                # Of the branch that a trip does not take nothing is left.
                branch = then if holds else other
                return self._spliceable(NOWHERE, ()) if branch is None else self.rewrite(branch)
            # Not loops that stay: what is inside one has many values, unrolled or not.
            case n.FunctionDef() | n.Block() | n.If() | n.Switch():
                return None
        return node

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        if isinstance(node, n.Block | n.Switch) and not self._unrolled.isdisjoint(node.body):
            spliced = (
                part
                for stmt in node.body
                for part in (block_of(stmt).body if stmt in self._unrolled else (stmt,))
            )
            return replace(node, body=tuple(spliced))
        return node

    def _spliceable(self, span: Span, stmts: Sequence[n.Stmt]) -> n.Block:
        """A block that its statements take the place of where several may stand."""
        block = n.Block(span, tuple(stmts))
        self._unrolled.add(block)
        return block

    def _trips(self, loop: n.For) -> list[n.Block] | None:
        if not self._around:
            return self._unroller.outermost(loop)
        if not self._deep:
            reason = f"with the loop around it there would be more than {MAX_TRIPS} trips"
            self._unroller.kept[loop] = reason
            return None
        try:
            trips, count = self._unroller.trips(loop, self._around, True)
        except UncountableError as error:
            self._unroller.kept[loop] = str(error)
            return None
        self.trips += count
        return trips


def _up_to_jump(stmts: Sequence[n.Stmt]) -> tuple[list[n.Stmt], str]:
    """The statements before a ``break`` or ``continue`` that is always reached, and which it is."""
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


def _jumps(node: n.Node, in_switch: bool = False) -> bool:
    """Does a ``break`` or ``continue`` in a loop's body belong to the loop?"""
    match node:
        case n.Jump(word=word):
            return word == "continue" or (word == "break" and not in_switch)
        case n.Block() | n.If() | n.Switch():
            inner = in_switch or isinstance(node, n.Switch)
            return any(_jumps(child, inner) for child in children(node))
    return False


def _literal(value: Scalar, base: str) -> n.Expr:
    """A number as GLSL writes it."""
    text = _shortest(value) if isinstance(value, float) else str(value)
    # GLSL has no negative literals: the minus is an operator.
    number = n.Literal(NOWHERE, text.removeprefix("-") + ("u" if base == "uint" else ""))
    return n.Unary(NOWHERE, "-", number) if text.startswith("-") else number


def _shortest(value: float) -> str:
    """As few digits as tell a float of 32 bits from all others; nine always do."""
    texts = (f"{value:.{digits}g}" for digits in range(1, 10))
    # `repr` writes a point or an exponent; without one the literal would be an integer.
    return repr(float(next(text for text in texts if convert(float(text), "float") == value)))
