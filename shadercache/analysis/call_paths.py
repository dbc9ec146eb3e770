"""Function instances (one for each call path from ``main``) and the uses of their expressions.

An expression of a function that is called twice has two values per fragment; a node is therefore an
expression together with the path of calls that leads to it.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import cast

from shadercache.analysis.effect_table import EffectTable, out_arguments
from shadercache.analysis.reaching_definitions import (
    ReachingDefinitions,
    Step,
    Trip,
    counters_of,
    order_matters,
)
from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, STATEMENTS, children
from shadercache.diagnostics import input_error
from shadercache.source import NOWHERE, Source

MAX_INSTANCES = 20_000
"""Call paths are capped here (a call graph of 20 functions calling twice has a million)."""

MAX_NODES = 300_000
"""Expressions on all call paths are capped here, too: they take half a minute."""

MAX_STEPS = 40_000
"""Statements on all call paths: for each it is noted on which of the others it depends."""


class Use(Enum):
    """How an expression stands in its function."""

    PLAIN = "evaluated once in every call"
    LVALUE = "the place of an assignment or of an out argument"
    BRANCH = "in a statement that is executed only under a condition"
    CONDITIONAL = "evaluated only under a condition inside its statement"
    LOOP = "inside a loop"
    CONSTANT = "in a place that must be constant"


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """An expression of a function: its number in source order, its step and its use.

    Only the user's own expressions are numbered: one that was added has the number of the next.

    ``order_matters``: the statement that it stands in has side effects, so that nothing may be
    moved out of it; that is the step, or a statement inside it. ``trip``: the counters of the
    unrolled loops that it stands in.
    """

    ordinal: int
    expr: n.Expr
    step: Step
    use: Use
    order_matters: bool
    trip: Trip


class Places:
    """All expressions of one function with their places, in source order."""

    def __init__(self, function: n.FunctionDef, table: EffectTable) -> None:
        self.function = function
        self.reaching = ReachingDefinitions(function, table)
        self.all: list[Place] = []
        self._own = 0
        for step in self.reaching.steps:
            self._visit(step, table)
        self.unrolled = any(place.trip for place in self.all)
        self.calls = [
            (place, place.expr, table.functions[place.expr.name])
            for place in self.all
            if isinstance(place.expr, n.Call) and place.expr.name in table.functions
        ]

    def _visit(self, step: Step, table: EffectTable) -> None:
        # Without recursion: a chain of operators is as deep as it is long.
        stack = [(cast("n.Node", step.stmt), Use.PLAIN, False, False, step.trip)]
        while stack:
            node, use, target, order, trip = stack.pop()
            if isinstance(node, EXPRESSIONS):
                shown = Use.LVALUE if target else use
                place = Place(self._own, cast("n.Expr", node), step, shown, order, trip)
                self.all.append(place)
                self._own += node.span != NOWHERE
            elif isinstance(node, STATEMENTS):
                order = order_matters(cast("n.Stmt", node), table)
                trip += counters_of(node) if isinstance(node, n.Block) else ()
            parts = _parts(node, use, target, table)
            stack.extend(reversed([(*part, order, trip) for part in parts]))


def _parts(
    node: n.Node, use: Use, target: bool, table: EffectTable
) -> Iterator[tuple[n.Node, Use, bool]]:
    """The children of a node with their use, and whether they are part of an l-value."""
    inner, written = dict[n.Node, Use](), dict[n.Node, bool]()
    match node:
        case n.For() | n.While() | n.DoWhile():
            inner = dict.fromkeys(children(node), Use.LOOP)
        case n.If() | n.Switch():
            inner = dict.fromkeys(children(node)[1:], _worse(use, Use.BRANCH))
        case n.Conditional() | n.Binary(op="&&" | "||"):
            # Only the first operand is always evaluated (GLSL 4.60 section 5.9).
            inner = dict.fromkeys(children(node)[1:], _worse(use, Use.CONDITIONAL))
        case n.Assign():
            # In a += b as well, although that reads it: no other variable can stand there.
            written[node.target] = True
        case n.Unary(op="++" | "--") | n.Postfix():
            written[node.operand] = True
        case n.Member() | n.Index():
            written[node.object] = target
        case n.Call():
            written = dict(zip(node.args, out_arguments(node, table), strict=True))
        case n.TypeSpec() | n.Case() | n.LayoutItem() | n.Length():
            # Of an array whose length is asked for nothing is evaluated either.
            inner = dict.fromkeys(children(node), Use.CONSTANT)
        case n.Declarator():
            inner = {dim: Use.CONSTANT for dim in node.dims if dim is not None}
    for child in children(node):
        yield child, inner.get(child, use), written.get(child, False)


@dataclass(frozen=True, slots=True, eq=False)
class Instance:
    """A function as reached by one path of calls.

    ``label`` is the path as people read it (``main > marble > noise@2``: the second call of
    ``noise`` in ``marble``; ``main [i=3] > noise@4`` in an unrolled loop). ``use``, ``after_exit``
    and ``order_matters`` say what holds for the call itself or for any call above it, ``unrolled``
    whether a loop of this function or of one above it was unrolled.
    """

    places: Places
    parent: Instance | None
    call: n.Call | None
    place: Place | None
    label: str
    use: Use
    after_exit: bool
    order_matters: bool
    unrolled: bool
    arguments: Mapping[str, n.Expr]
    """What the call gives the parameters."""

    @property
    def path(self) -> tuple[n.Call, ...]:
        """The calls from ``main`` down to this function; empty for ``main``."""
        if self.parent is None or self.call is None:
            return ()
        return (*self.parent.path, self.call)


def find_instances(table: EffectTable, source: Source) -> tuple[Instance, ...]:
    """All instances reached from ``main``, callers before callees, in order of evaluation text.

    Raises :class:`InputError` SC401 where there are more than :data:`MAX_INSTANCES`, or where they
    have more than :data:`MAX_NODES` expressions or :data:`MAX_STEPS` statements in all.
    """
    places: dict[str, Places] = {}
    # They are counted before any is made: calls that fan out make exponentially many.
    count = _count("main", table, places, {})
    if count > MAX_INSTANCES:
        raise input_error(
            "SC401", f"the shader has {count} call paths; at most {MAX_INSTANCES} are analysed"
        )
    top = places["main"]
    main = Instance(top, None, None, None, "main", Use.PLAIN, False, False, top.unrolled, {})
    instances = [main]
    for instance in instances:  # grows while it runs
        instances.extend(_callees(instance, places, source))
    nodes = sum(len(path.places.all) for path in instances)
    steps = sum(len(path.places.reaching.steps) for path in instances)
    for what, count, limit in (
        ("expressions", nodes, MAX_NODES),
        ("statements", steps, MAX_STEPS),
    ):
        if count > limit:
            message = f"the shader has {count} {what} on all its call paths"
            raise input_error("SC401", f"{message}; at most {limit} are analysed")
    return tuple(instances)


def by_call(instances: Iterable[Instance]) -> dict[tuple[Instance, n.Call], Instance]:
    """The instance that each call of a user's function leads to."""
    return {
        (instance.parent, instance.call): instance
        for instance in instances
        if instance.parent is not None and instance.call is not None
    }


def _count(name: str, table: EffectTable, places: dict[str, Places], counts: dict[str, int]) -> int:
    if name not in counts:
        here = places.setdefault(name, Places(table.functions[name], table))
        inner = (_count(callee.name, table, places, counts) for _, _, callee in here.calls)
        counts[name] = 1 + sum(inner)
    return counts[name]


def _callees(caller: Instance, places: dict[str, Places], source: Source) -> Iterator[Instance]:
    total = Counter(callee.name for _, _, callee in caller.places.calls)
    seen = Counter[str]()
    for place, call, callee in caller.places.calls:
        seen[callee.name] += 1
        suffix = f"@{seen[callee.name]}" if total[callee.name] > 1 else ""
        yield Instance(
            places=places[callee.name],
            parent=caller,
            call=call,
            place=place,
            label=f"{path_to(caller, place, source)} > {callee.name}{suffix}",
            use=_worse(caller.use, place.use),
            after_exit=caller.after_exit or place.step.after_exit,
            order_matters=caller.order_matters or place.order_matters,
            unrolled=caller.unrolled or places[callee.name].unrolled,
            arguments={
                param.name: arg
                for param, arg in zip(callee.proto.params, call.args, strict=True)
                if param.name is not None
            },
        )


def path_to(instance: Instance, place: Place, source: Source) -> str:
    """The path to an expression as people read it, with its trip: ``main [i=3, j=2]``."""
    trip = ", ".join(
        f"{_user_name(counter, source)}={_number(counter.init)}" for counter in place.trip
    )
    return f"{instance.label} [{trip}]" if trip else instance.label


def _user_name(variable: n.Declarator, source: Source) -> str:
    """A variable's name in the source; each trip has one of its own by now."""
    name = re.match(r"\w+", source.excerpt(variable.span))
    return name[0] if name and variable.name.startswith(name[0]) else variable.name


def _number(init: n.Expr | None) -> str:
    match init:
        case n.Literal(text=text):
            return text
        case n.Unary(op="-", operand=n.Literal(text=text)):
            return f"-{text}"
    raise AssertionError("a trip begins with the values of its counters")


def _worse(one: Use, other: Use) -> Use:
    # From the worst on; only values of the last two may be cached.
    ranking = (Use.LOOP, Use.CONDITIONAL, Use.CONSTANT, Use.LVALUE, Use.BRANCH, Use.PLAIN)
    return min(one, other, key=ranking.index)
