"""Nodes that have the same value: parentheses, copies through variables, common sub-expressions.

Every expression on every call path gets a number; equal numbers mean equal values, to the bit in
proof mode, and in GLSL ES of the same precision (value numbering; a variable has the number of what
was assigned to it last)::

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
from shadercache.analysis.effects import Does
from shadercache.analysis.precision import PrecisionTable
from shadercache.analysis.reaching_definitions import Step, written_anywhere
from shadercache.analysis.use_def import Definition, Definitions
from shadercache.ast import nodes as n
from shadercache.ast.walk import children
from shadercache.lang.types import Type
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
        self._precisions = PrecisionTable(module, facts)
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
                    # The arguments have numbers by now, which parameters take over; what the call
                    # returns needs one before the call itself.
                    child = self._definitions.callee(instance, place.expr)
                    if child is not None:
                        self._number_all(child)
                self._numbers[instance, place.expr] = self._number(instance, place)

    def _number(self, instance: Instance, place: Place) -> int:
        key: tuple[Hashable, ...] | None = None
        if place.use is not Use.LVALUE and not self._table.of(place.expr).writes:
            definition = self._definition(instance, place)
            if definition is not None:
                number = self._numbers[definition.instance, definition.expr]
                kind = definition.type, self._precisions.of(place.expr)
                if (self._type(definition.expr), self._precisions.of(definition.expr)) == kind:
                    return number
                key = ("converted", *kind, number)
            else:
                key = self._key(instance, place)
        # What nothing can be said of is equal to nothing else.
        return self._of_key.setdefault(key or (instance, place.expr), len(self._of_key))

    def _definition(self, instance: Instance, place: Place) -> Definition | None:
        """The expression that a local has its value from, or that a call returns."""
        match place.expr:
            case n.Name(name=name) if name in instance.places.reaching.local_names:
                return self._definitions.of(instance, place.step, name)
            case n.Call() as call if child := self._definitions.callee(instance, call):
                return self._definitions.result(child)
        return None

    def _key(self, instance: Instance, place: Place) -> tuple[Hashable, ...] | None:
        """What is equal where values are; ``None`` where that cannot be said."""
        expr = place.expr
        # Children that are no expressions have none; what they say is in the type.
        below = [self._numbers.get((instance, cast("n.Expr", part))) for part in children(expr)]
        match expr:
            case n.Name(name=name) if name in instance.places.reaching.local_names:
                version = self._definitions.version(instance, place.step, name)
                return None if version is None else ("version", instance, name, version)
            case n.Name(name=name):
                return None if name in self._mutable else ("global", name)
            case n.Literal(text=text):
                # By value and not by spelling: 1.0 and 1. are the same.
                return "literal", self._type(expr), self._facts.constants.get(expr, text)
            case n.InitList():
                return None
            case n.Call(name=name) if self._definitions.callee(instance, expr) is not None:
                summary = self._table.summary(name)
                # Equal arguments give equal results where nothing else goes in that may change.
                known = not summary.does and not summary.reads & self._mutable
                return ("call", name, *below) if known else None
            case n.Call(name=name):
                # A derivative may be taken with other neighbours under a condition, and where some
                # have left.
                everywhere = Use.PLAIN is place.use is instance.use
                if any(out_arguments(expr, self._table)) or (
                    needs_derivative(expr, self._table)
                    and (not everywhere or self._left_by_some(instance, place.step))
                ):
                    return None
                return ("built-in", name, self._type(expr), *below)
        return (*_shape(expr), self._type(expr), *below)

    def _left_by_some(self, instance: Instance, step: Step) -> bool:
        """May fragments have left ahead of a step, or of a part of it?"""
        at: Instance | None = instance
        here: Step | None = step
        while at is not None and here is not None:
            # What a step calls may discard ahead of what else it computes.
            if here.after_exit or here.effects.does & Does.DISCARD:
                return True
            here, at = at.place.step if at.place else None, at.parent
        return False

    def _type(self, expr: n.Expr) -> Type:
        # Not by its name: structs of one name in two scopes are two types (4.60 section 4.1.8).
        return self._facts.types[expr]


def _shape(expr: n.Expr) -> tuple[str, ...]:
    """What tells two expressions with equal operands apart."""
    return (type(expr).__name__, str(getattr(expr, "op", "")), str(getattr(expr, "name", "")))
