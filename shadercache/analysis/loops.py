"""Loops whose length depends on certain variables: here, on what the cache holds.

A fragment that has no payload, or a pixel at the edge of a triangle that is computed for its
neighbours only, goes on with whatever the cache holds there. In a loop that waits for such a value
it may go round for ever::

    for (float t = 0.0; t < 2.0; t += sc_payload)    // sc_payload is 0.0 where nothing was drawn

The analysis works by name, on a module in which every identifier of a function means one thing. It
follows each value to what it is written into, and each condition to what is written under it,
outside of where that is declared. It takes no account of order.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Set
from dataclasses import dataclass, field

from shadercache.analysis.dataflow import LOOPS, Loop, reached
from shadercache.analysis.effect_table import EffectTable, out_arguments
from shadercache.analysis.effects import EXITS, Does, local_names, root_variable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import children, walk

_SHARED = Does.DERIVATIVE | Does.IMPLICIT_LOD
_NOTHING: frozenset[str] = frozenset()


def decided_loops(
    module: n.Module, names: Iterable[str], memo: Memo | None = None
) -> frozenset[n.Node]:
    """The loops that may run for longer or shorter with other values of the named globals.

    Loops with derivatives inside are not among them: what decides on those is never a payload
    (SC315). ``memo`` keeps what is found out about functions.
    """
    table = EffectTable(module, memo)
    every = _all_flows(table, memo)
    if not any(flows.loops for flows in every):
        return frozenset()
    dependent = _reached(every, names)
    return frozenset(
        loop
        for flows in every
        for loop, readings in flows.loops
        if not dependent.isdisjoint(readings) and not table.of(loop).does & _SHARED
    )


def hanging_names(module: n.Module, names: Iterable[str]) -> frozenset[str]:
    """The variables whose values, and the functions whose results, depend on the named globals.

    Of locals the bare name is given: it may be one of another function.
    """
    dependent = _reached(_all_flows(EffectTable(module), None), names)
    return frozenset(name.rpartition(".")[2].removesuffix("()") for name in dependent)


@dataclass(slots=True)
class _Flows:
    """Where values go in one function. Names are those of globals, ``f.x`` for the local ``x`` of
    ``f``, ``f()`` for its result, ``f#0`` for what is given to its first parameter and ``f#0>`` for
    what comes back from there."""

    targets: defaultdict[str, set[str]] = field(default_factory=lambda: defaultdict(set))
    loops: list[tuple[n.Node, frozenset[str]]] = field(default_factory=list)


def _all_flows(table: EffectTable, memo: Memo | None) -> list[_Flows]:
    kept: dict[object, _Flows] = {} if memo is None else memo.table("flows of functions")
    every: list[_Flows] = []
    for linked in map(table.linked, table.functions):
        if linked not in kept:
            kept[linked] = _FlowWalker(linked.function, table).flows
        every.append(kept[linked])
    return every


def _reached(every: list[_Flows], names: Iterable[str]) -> Set[str]:
    """All names that a value of the given ones may come to."""
    return reached(
        names, lambda name: (to for flows in every for to in flows.targets.get(name, _NOTHING))
    ).keys()


class _FlowWalker:
    """Collects the flows of one function."""

    def __init__(self, function: n.FunctionDef, table: EffectTable) -> None:
        self.flows = _Flows()
        self._table, self._function = table, function.name
        self._locals = local_names(function)
        self._under: tuple[frozenset[str], ...] = ()
        """What the conditions read under which the statement at hand is executed."""
        self._depths: dict[str, int] = {}
        """Under how many of them a local is declared; parameters under none."""
        for i, param in enumerate(function.proto.params):
            if param.name:
                self._flow((f"{function.name}#{i}",), self._key(param.name))
                if param.writes_back:
                    self._flow((self._key(param.name),), f"{function.name}#{i}>")
        self._statement(function.body, ())

    def _key(self, name: str) -> str:
        return f"{self._function}.{name}" if name in self._locals else name

    def _readings(self, *parts: n.Node) -> frozenset[str]:
        """What decides on the values of these expressions."""
        readings: set[str] = set()
        for node in (node for part in parts for node in walk(part)):
            if isinstance(node, n.Name):
                readings.add(self._key(node.name))
            elif isinstance(node, n.Call) and node.name in self._table.functions:
                readings.add(f"{node.name}()")
        return frozenset(readings)

    def _flow(self, readings: Iterable[str], key: str) -> None:
        for name in readings:
            self.flows.targets[name].add(key)

    def _write(self, name: str, readings: Iterable[str], *under: frozenset[str]) -> None:
        """A variable is written, under what the walk is under and these conditions."""
        key = self._key(name)
        self._flow(readings, key)
        # What is declared under a condition has no other value where the condition is false.
        for condition in (*self._under[self._depths.get(name, 0) :], *under):
            self._flow(condition, key)

    def _statement(self, stmt: n.Node, under: tuple[frozenset[str], ...]) -> None:
        match stmt:
            case n.Block(body=body):
                self._sequence(body, under)
            case n.If(condition=first):
                self._plain(first, under)
                for part in children(stmt)[1:]:
                    self._statement(part, (*under, self._readings(first)))
            case n.Switch(selector=first, body=body):
                self._plain(first, under)
                self._sequence(body, (*under, self._readings(first)))
            case n.For() | n.While() | n.DoWhile():
                readings = self._decision(stmt)
                self.flows.loops.append((stmt, readings))
                for part in children(stmt):
                    self._statement(part, (*under, readings))
            case _:
                self._plain(stmt, under)

    def _sequence(self, stmts: tuple[n.Stmt, ...], under: tuple[frozenset[str], ...]) -> None:
        for stmt in stmts:
            self._statement(stmt, under)
            # Behind a jump that some fragments take, the others are alone.
            if not isinstance(stmt, n.Return | n.Jump) and self._jumps_out(stmt):
                under = (*under, _NOTHING.union(*self._decisions(stmt)))

    def _jumps_out(self, stmt: n.Node) -> bool:
        """Can a statement end with a jump to elsewhere than what follows it?"""
        does = self._table.of(stmt).does
        if does & Does.RETURN or isinstance(stmt, n.Jump):
            return True
        # A jump ends with its loop. Discards do not count: no payload decides on one (SC316).
        if not does & Does.JUMP or isinstance(stmt, LOOPS):
            return False
        return any(self._jumps_out(part) for part in children(stmt))

    def _decisions(self, stmt: n.Node) -> Iterator[frozenset[str]]:
        """What the conditions in a statement read that decide on its jumps."""
        for node in walk(stmt):
            match node:
                case n.If(condition=first) | n.Switch(selector=first) if self._jumps_out(node):
                    yield self._readings(first)
                case n.For() | n.While() | n.DoWhile() if self._jumps_out(node):
                    yield self._decision(node)

    def _decision(self, loop: Loop) -> frozenset[str]:
        """What decides how long a loop runs: its condition, and those of jumps out of its body."""
        readings = self._readings(loop.condition) if loop.condition is not None else _NOTHING
        # Jumps of loops inside count as well: a guard too many costs a test, one too few may hang.
        for node in walk(loop.body):
            if isinstance(node, n.If | n.Switch) and self._table.of(node).does & EXITS:
                readings |= self._readings(children(node)[0])
        return readings

    def _plain(self, node: n.Node, under: tuple[frozenset[str], ...]) -> None:
        self._under = under
        for part in walk(node):
            match part:
                case n.Return(value=value):
                    result = f"{self._function}()"
                    # No condition is left out: a result is declared under none of them.
                    for readings in (*under, self._readings(value) if value else _NOTHING):
                        self._flow(readings, result)
                case n.Assign(target=target, value=value):
                    self._target(target, self._readings(*children(target), value))
                case n.Unary(op="++" | "--", operand=target) | n.Postfix(operand=target):
                    # i++ puts nothing new into i; only the conditions that it stands under count.
                    self._target(target, _NOTHING)
                case n.Declarator(name=name, init=init):
                    self._depths[name] = len(under)
                    self._write(name, self._readings(init) if init is not None else _NOTHING)
                case n.Conditional(condition=first):
                    self._under_operand(first, part)
                case n.Binary(op="&&" | "||", left=first, right=other):
                    self._under_operand(first, other)
                case n.Call():
                    self._call(part)

    def _under_operand(self, first: n.Expr, other: n.Node) -> None:
        """What ``other`` writes is written where ``first`` says so."""
        for name in self._table.of(other).writes:
            self._write(name, _NOTHING, self._readings(first))

    def _target(self, target: n.Expr, readings: frozenset[str]) -> None:
        root = root_variable(target)
        if root is not None:
            self._write(root, readings)

    def _call(self, call: n.Call) -> None:
        outs = out_arguments(call, self._table)
        user = call.name in self._table.functions
        every = _NOTHING if user else self._readings(*call.args)
        for i, (arg, out) in enumerate(zip(call.args, outs, strict=True)):
            if user:
                self._flow(self._readings(arg), f"{call.name}#{i}")
            if out:
                self._target(arg, frozenset((f"{call.name}#{i}>",)) if user else every)
        if user:
            # What is written into globals is the called function's matter, but not under what.
            for name in self._table.summary(call.name).writes:
                self._write(name, _NOTHING)
