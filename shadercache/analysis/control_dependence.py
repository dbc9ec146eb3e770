"""What flows where inside a conditional or loop, which reaching definitions take as one step.

The parts of the step are its plain statements and the conditions that they stand under. A part is
relevant for a value if it writes what the value reads, directly or through other parts, in whatever
order they come; then its conditions are relevant too. Conditions of a ``return``, ``discard`` or
``break`` are relevant for everything: they decide whether the rest is reached.

A plain statement has one part, itself. What it writes comes after what it reads, unless one of its
operands has a side effect.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import cast

from shadercache.analysis.dataflow import LOOPS, reached
from shadercache.analysis.effect_table import EffectTable, direct_writes
from shadercache.analysis.effects import EXITS, Does, Effects, union
from shadercache.analysis.reaching_definitions import order_matters
from shadercache.ast import nodes as n
from shadercache.ast.walk import STATEMENTS, children, walk


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A plain statement, or a condition; and the conditions above it, outermost first."""

    node: n.Node
    effects: Effects
    above: tuple[Part, ...]


@dataclass(frozen=True, slots=True)
class Flow:
    """What flows into a value: names that it reads, and the parts that are relevant for it."""

    names: frozenset[str]
    parts: tuple[Part, ...]

    @property
    def does(self) -> Does:
        """What the parts do."""
        return union(part.effects for part in self.parts).does

    def expressions(self) -> Iterator[n.Node]:
        """Every expression of the parts."""
        return (node for part in self.parts for node in walk(part.node))


class ControlDependence:
    """The parts of one step."""

    def __init__(self, stmt: n.Stmt, table: EffectTable) -> None:
        self._table = table
        self.parts = tuple(self._collect(stmt, ()))
        self._of = {node: part for part in self.parts for node in walk(part.node)}
        self._writers: defaultdict[str, list[Part]] = defaultdict(list)
        for part in self.parts:
            for name in part.effects.writes:
                self._writers[name].append(part)

    def into_value(self, expr: n.Expr) -> Flow:
        """What decides the value of an expression, where it is evaluated."""
        own = self._of[expr]
        reads = self._table.of(expr).reads
        # What is evaluated has met no return or discard, but a break may have skipped a write of
        # what it reads.
        return self._closure(reads, self._later(own), given=own.above, exits=Does.JUMP)

    def into_global(self, call: n.Call, name: str) -> Flow:
        """What gives a global the value that the function called finds in it."""
        own = self._of[call]
        # The call's own writes come too late, but those of its arguments, or of a call beside it,
        # may come before.
        later = None if name in self._written_beside(own, call) else own
        return self._closure({name}, later, given=own.above, exits=Does.JUMP)

    def into_use(self, expr: n.Expr, whole: bool) -> Flow:
        """What decides whether an expression is evaluated, and on what; ``whole``: its statement
        may skip it."""
        own, reads = self._of[expr], self._table.of(expr).reads
        return self._closure(reads, self._later(own), self._deciding(own, whole))

    def into_reach(self, expr: n.Expr, whole: bool) -> Flow:
        """What decides whether an expression is reached, without what it works on."""
        own = self._of[expr]
        return self._closure((), self._later(own), self._deciding(own, whole))

    def into_exits(self) -> Flow:
        """What decides whether a ``return`` or ``discard`` is reached."""
        return self._closure((), None)

    def _deciding(self, own: Part, whole: bool) -> tuple[Part, ...]:
        # A choice in the statement may skip the expression, and so may the end of the loop: then
        # whatever the part reads can decide.
        return (*own.above, own) if whole or isinstance(own.node, LOOPS) else own.above

    def _later(self, own: Part) -> Part | None:
        """The part itself where nothing that it writes can be read in it afterwards."""
        # What one trip writes, the next one reads.
        if isinstance(own.node, LOOPS):
            return None
        if isinstance(own.node, STATEMENTS):
            back = order_matters(cast("n.Stmt", own.node), self._table)
        else:
            back = bool(own.effects.writes)
        return None if back else own

    def _written_beside(self, own: Part, call: n.Call) -> frozenset[str]:
        """What is written in a part before the call, or may be: all that others than it write."""
        if isinstance(own.node, LOOPS):
            return own.effects.writes
        others = (node for node in walk(own.node) if node is not call)
        return frozenset[str]().union(*(direct_writes(node, self._table) for node in others))

    def _closure(
        self,
        reads: Iterable[str],
        later: Part | None,
        first: Iterable[Part] = (),
        given: Iterable[Part] = (),
        exits: Does = EXITS,
    ) -> Flow:
        """What flows into ``reads``; what ``later`` writes does not, as it comes too late.

        ``first`` are relevant from the start, ``given`` hold anyway, and conditions above what
        does any of ``exits`` decide on everything.
        """
        holds = frozenset(given)

        def onward(name_or_part: str | Part) -> Iterable[str | Part]:
            if isinstance(name_or_part, Part):
                return name_or_part.effects.reads
            writers = (part for part in self._writers[name_or_part] if part is not later)
            # Whether a part writes at all is up to the conditions above it.
            return (one for part in writers for one in (part, *part.above) if one not in holds)

        start: list[str | Part] = [*reads]
        start += [part for part in (*first, *self._above_of(exits)) if part not in holds]
        flowing = reached(start, onward)
        names = frozenset(name for name in flowing if isinstance(name, str))
        return Flow(names, tuple(part for part in flowing if isinstance(part, Part)))

    def _above_of(self, exits: Does) -> Iterator[Part]:
        for part in self.parts:
            if part.effects.does & exits:
                yield from part.above
                # These hold the conditions of their exits within themselves.
                if isinstance(part.node, LOOPS) or self._may_skip_discard(part.node):
                    yield part

    def _may_skip_discard(self, node: n.Node) -> bool:
        """Does a choice in an expression decide on a discard, in a function that it calls?"""
        return any(
            isinstance(inner, n.Conditional)
            or (isinstance(inner, n.Binary) and inner.op in ("&&", "||"))
            for inner in walk(node)
            if self._table.of(inner).does & Does.DISCARD
        )

    def _collect(self, node: n.Node, above: tuple[Part, ...]) -> Iterator[Part]:
        match node:
            case n.If(condition=first) | n.Switch(selector=first):
                condition = Part(first, self._table.of(first), above)
                yield condition
                for child in children(node):
                    if child is not first:
                        yield from self._collect(child, (*above, condition))
            case n.Block():
                for child in node.body:
                    yield from self._collect(child, above)
            case _:
                # A loop is one part, too: whatever is in it comes before whatever else.
                yield Part(node, self._table.of(node), above)
