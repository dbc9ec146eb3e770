"""Nodes that have the same value: parentheses, copies through variables, common sub-expressions.

Every expression on every call path gets a number; equal numbers mean equal values, to the bit in
proof mode (value numbering; a variable has the number of what was assigned to it last)::

    float a = wave(p) + 1.0;    // wave(p), and what it returns, are one group;
    float b = (a);              // wave(p) + 1.0, a and b another;
    float c = wave(p) * b;      // wave(p) is in the first once more
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import cast

from shadercache.analysis.call_paths import Instance, Place, Use
from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.effect_table import EffectTable, needs_derivative, out_arguments
from shadercache.analysis.reaching_definitions import written_anywhere
from shadercache.analysis.use_def import Definition, Definitions
from shadercache.ast import nodes as n
from shadercache.ast.walk import children
from shadercache.sema.facts import Facts


@dataclass(frozen=True, slots=True, eq=False)
class ValueGroup:
    """Nodes of one value. ``first`` stands for them: the first that is offered, if any is; the one
    to cache where one of the group is wanted."""

    nodes: tuple[Candidate, ...]
    first: Candidate = field(init=False)

    def __post_init__(self) -> None:
        legal = next((node for node in self.nodes if node.legal), self.nodes[0])
        first = next((node for node in self.nodes if node.offered), legal)
        object.__setattr__(self, "first", first)


def number_values(
    module: n.Module, facts: Facts, table: EffectTable, candidates: Candidates
) -> Mapping[Candidate, ValueGroup]:
    """The group of every node; the nodes of a group stand in their own order.

    ``module`` is the one that the candidates were found in.
    """
    numbers = _ValueNumbering(module, facts, table, candidates.instances)
    members: dict[Hashable, list[Candidate]] = {}
    for node in candidates.nodes:
        members.setdefault(numbers.of(node), []).append(node)
    groups = (ValueGroup(tuple(nodes)) for nodes in members.values())
    return {node: group for group in groups for node in group.nodes}


def one_of_each(
    nodes: Iterable[Candidate], groups: Mapping[Candidate, ValueGroup]
) -> dict[Candidate, int]:
    """The first of the given nodes of each group, with how many of its group were given."""
    counts: dict[ValueGroup, int] = {}
    chosen: dict[ValueGroup, Candidate] = {}
    for node in nodes:
        group = groups[node]
        chosen.setdefault(group, node)
        counts[group] = counts.get(group, 0) + 1
    return {node: counts[group] for group, node in chosen.items()}


class _ValueNumbering:
    """Numbers every expression of every instance, operands before what they are operands of."""

    def __init__(
        self, module: n.Module, facts: Facts, table: EffectTable, instances: tuple[Instance, ...]
    ) -> None:
        self._facts, self._table = facts, table
        self._definitions = Definitions(facts, table, instances)
        self._mutable = written_anywhere(module, table)
        self._of_key: dict[Hashable, int] = {}
        self._numbers: dict[tuple[Instance, n.Expr], int] = {}
        self._done: set[Instance] = set()
        for instance in instances:  # callers first: what is called is done on the way
            self._number_all(instance)

    def of(self, node: Candidate) -> Hashable:
        """The number of a node; one in an initialiser is equal to no other."""
        if node.instance is None:
            return node
        return self._numbers[node.instance, node.expr]

    def _number_all(self, instance: Instance) -> None:
        if instance in self._done:
            return
        self._done.add(instance)
        steps: dict[int, list[Place]] = {}
        for place in instance.places.all:
            steps.setdefault(place.step.index, []).append(place)
        for index in sorted(steps):
            for place in reversed(steps[index]):  # Operands stand behind what they belong to.
                if isinstance(place.expr, n.Call):
                    child = self._definitions.callee(instance, place.expr)
                    if child is not None:
                        self._number_all(child)
                self._numbers[instance, place.expr] = self._number(instance, place)

    def _number(self, instance: Instance, place: Place) -> int:
        expr = place.expr
        alone = (instance, expr)
        if place.use is Use.LVALUE or self._table.of(expr).writes:
            return self._new(alone)
        match expr:
            case n.Name():
                return self._name(instance, place, expr.name)
            case n.Literal(text=text):
                return self._new(
                    ("literal", self._type(expr), self._facts.constants.get(expr, text))
                )
            case n.InitList():
                return self._new(alone)
            case n.Call():
                return self._call(instance, place, expr)
        return self._new((*_shape(expr), self._type(expr), *self._below(instance, expr)))

    def _name(self, instance: Instance, place: Place, name: str) -> int:
        if name not in instance.places.reaching.local_names:
            alone = (instance, place.expr)
            return self._new(alone if name in self._mutable else ("global", name))
        found = self._definitions.of(instance, place.step, name)
        if found is not None:
            return self._defined(found)
        version = self._definitions.version(instance, place.step, name)
        if version is None:
            return self._new((instance, place.expr))
        return self._new(("version", instance, name, version))

    def _call(self, instance: Instance, place: Place, call: n.Call) -> int:
        alone = (instance, call)
        child = self._definitions.callee(instance, call)
        below = self._below(instance, call)
        if child is None:
            if any(out_arguments(call, self._table)):
                return self._new(alone)
            everywhere = Use.PLAIN is place.use is instance.use
            if needs_derivative(call, self._table) and not everywhere:
                return self._new(alone)
            return self._new(("built-in", call.name, self._type(call), *below))
        found = self._definitions.result(child)
        if found is not None:
            return self._defined(found)
        summary = self._table.summary(call.name)
        if summary.does or summary.reads & self._mutable:
            return self._new(alone)
        return self._new(("call", call.name, *below))

    def _defined(self, found: Definition) -> int:
        number = self._numbers[found.instance, found.expr]
        kind = str(found.type)
        if self._type(found.expr) == kind:
            return number
        return self._new(("converted", kind, number))

    def _below(self, instance: Instance, expr: n.Expr) -> list[int | None]:
        return [self._numbers.get((instance, cast("n.Expr", part))) for part in children(expr)]

    def _type(self, expr: n.Expr) -> str:
        return str(self._facts.types[expr])

    def _new(self, key: Hashable) -> int:
        return self._of_key.setdefault(key, len(self._of_key))


def _shape(expr: n.Expr) -> tuple[str, ...]:
    """What tells two expressions with equal operands apart."""
    return (type(expr).__name__, str(getattr(expr, "op", "")), str(getattr(expr, "name", "")))
