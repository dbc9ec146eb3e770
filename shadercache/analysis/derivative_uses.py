"""Where a value decides what neighbouring fragments compute together, or whether there is one.

That is a derivative, taken openly or for a texture's level of detail, and the look-up in a cube
map: on llvmpipe the filter of a cube map rounds differently when any fragment of the same vector
lies on an edge of the cube (measured: 1 ulp in 2e-3 of the pixels, all beside fragments of another
surface).

Two questions are answered (law 8 of CONTRIBUTING.md). Which nodes *feed* such a use that
stays outside of the payload: there neighbouring fragments may hold reused values of something
else. And which implicit fetches belong to a payload: a one-pass variant must make those before its
branch.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias

from shadercache.analysis.call_paths import Instance, Place, Use, by_call
from shadercache.analysis.control_dependence import Flow
from shadercache.analysis.effect_table import EffectTable, needs_derivative
from shadercache.analysis.effects import Does
from shadercache.analysis.slices import Slice, SliceTable
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.sema.facts import Facts

Chooses: TypeAlias = Callable[[n.Call], bool]

Operands: TypeAlias = "tuple[Instance, Slice, Iterable[n.Node]]"
"""What something depends on: its instance, the slice, and the expressions of its own statement."""


@dataclass(frozen=True, slots=True, eq=False)
class SharedUse:
    """One evaluation of a derivative or fetch, and what its operands depend on."""

    instance: Instance
    place: Place
    operands: Slice
    parts: frozenset[n.Node]
    """The expressions of its own statement that flow into it."""


def evaluation_order(use: SharedUse) -> tuple[int, int]:
    """A key to sort uses by: whatever one of them depends on comes before it.

    A use depends on more steps than any use among its operands; in one expression the operand has
    the higher number.
    """
    return use.operands.atoms.bit_count(), -use.place.ordinal


class Dependents:
    """Whether values flow into certain places of a program, which have these operands."""

    def __init__(self, slices: SliceTable, operands: Iterable[Operands]) -> None:
        self._slices = slices
        self._atoms = 0
        self._parts: dict[Instance, set[n.Node]] = {}
        for instance, slice_, parts in operands:
            self._atoms |= slice_.atoms
            self._parts.setdefault(instance, set()).update(parts)
        # The atom of an argument says nothing of the step that calls: what flows into it from
        # there is noted by expressions.
        for instance, parts in slices.handed_down(self._atoms):
            self._parts.setdefault(instance, set()).update(parts)
        self._fed: dict[Instance, bool] = {}

    def fed_by(self, instance: Instance, place: Place) -> bool:
        """Does any of the places depend on the value at ``place``?"""
        bit = self._slices.step_bits[instance][place.step.index]
        # By steps in front of the places, and by expressions within the steps that hold them.
        if bit & self._atoms or place.expr in self._parts.get(instance, ()):
            return True
        if instance.parent is None or instance.place is None:
            return False
        # Else the result of the call may flow into one, or that of a call above it.
        if instance not in self._fed:
            self._fed[instance] = self.fed_by(instance.parent, instance.place)
        return self._fed[instance]


class SharedUses:
    """The uses of one kind in a program, in order of their instances and places.

    ``chooses`` tells whether a call is such a use: :func:`derivatives` or :func:`cube_lookups`.
    """

    def __init__(
        self, instances: tuple[Instance, ...], slices: SliceTable, chooses: Chooses
    ) -> None:
        self._slices = slices
        self._children = by_call(instances)
        self.all = tuple(
            self._use(instance, place, place.expr)
            for instance in instances
            for place in instance.places.all
            if isinstance(place.expr, n.Call) and chooses(place.expr)
        )
        operands = ((use.instance, use.operands, use.parts) for use in self.all)
        self._dependents = Dependents(slices, chain(operands, self._returns(), self._reached()))

    def fed_by(self, instance: Instance, place: Place) -> bool:
        """Does any of these uses, outside of that expression, depend on the value at ``place``?"""
        return self._dependents.fed_by(instance, place)

    def inside(self, instance: Instance, place: Place, payload: Slice) -> list[SharedUse]:
        """The uses that belong to the payload at ``place``, whose slice is given.

        In order of evaluation: whatever one of them depends on comes before it.
        """
        below = {call for call in walk(place.expr) if isinstance(call, n.Call)}
        chosen = [use for use in self.all if self._is_inside(use, instance, below, payload)]
        return sorted(chosen, key=evaluation_order)

    def _returns(self) -> Iterator[Operands]:
        """What decides on a return in front of a use, in its function or in those that call it."""
        last: dict[Instance, int] = {}
        for use in self.all:
            at: Instance | None = use.instance
            index = use.place.step.index
            # A later use in the same function has been followed up through the same calls.
            while at is not None and index > last.get(at, -1):
                last[at] = index
                index = at.place.step.index if at.place is not None else 0
                at = at.parent
        for instance, index in last.items():
            for step in instance.places.reaching.steps[:index]:
                # A value that decides on a discard in front is refused for that alone (SC316).
                if step.is_control and step.effects.does & Does.RETURN:
                    flow = self._slices.dependence(step.stmt).into_exits()
                    yield _operands(self._slices, instance, step.index, flow)

    def _reached(self) -> Iterator[Operands]:
        """What decides on a call that leads to a use: the conditionals and loops it stands in."""
        seen: set[Instance] = set()
        for use in self.all:
            at = use.instance
            while at not in seen and at.parent is not None and at.place is not None:
                seen.add(at)
                step, guarded = at.place.step, at.place.use is Use.CONDITIONAL
                if (step.is_control or guarded) and at.call is not None:
                    flow = self._slices.dependence(step.stmt).into_reach(at.call, guarded)
                    yield _operands(self._slices, at.parent, step.index, flow)
                at = at.parent

    def _use(self, instance: Instance, place: Place, call: n.Call) -> SharedUse:
        step = place.step
        flow = self._slices.dependence(step.stmt).into_use(call, place.use is Use.CONDITIONAL)
        _, slice_, expressions = _operands(self._slices, instance, step.index, flow)
        # The call does not feed itself: what it returns may be cached.
        parts = {*expressions, *walk(call)} - {call}
        return SharedUse(instance, place, slice_, frozenset(parts))

    def _is_inside(
        self, use: SharedUse, instance: Instance, below: set[n.Call], payload: Slice
    ) -> bool:
        # Up the calls that lead to the use: it is inside if one of them is.
        at: Instance | None = use.instance
        inner: n.Expr = use.place.expr
        index = use.place.step.index
        while at is not None:
            if at is instance and inner in below:
                return True
            if self._slices.step_bits[at][index] & payload.atoms:
                return True
            if self._in_argument(at, inner, payload):
                return True
            if at.place is None or at.call is None:
                return False
            inner, index, at = at.call, at.place.step.index, at.parent
        return False

    def _in_argument(self, caller: Instance, inner: n.Expr, payload: Slice) -> bool:
        """Is ``inner`` part of an argument that the payload depends on?"""
        children = (self._children[caller, call] for _, call, _ in caller.places.calls)
        return any(
            self._slices.entry_bits.get((child, name), 0) & payload.atoms
            and any(node is inner for node in walk(arg))
            for child in children
            for name, arg in child.arguments.items()
        )


def _operands(slices: SliceTable, instance: Instance, step: int, flow: Flow) -> Operands:
    return instance, slices.flow(instance, step, flow), flow.expressions()


def discards(instances: tuple[Instance, ...], slices: SliceTable) -> Dependents:
    """What decides whether a fragment is discarded: conditions with a discard under them, and those
    with a return in front of one."""

    def operands() -> Iterator[Operands]:
        for instance in instances:
            ahead = False
            for step in reversed(instance.places.reaching.steps):
                does = step.effects.does
                # Backward, for a return decides only on the discards that stand behind it.
                ahead = ahead or bool(does & Does.DISCARD)
                if ahead and does & (Does.DISCARD | Does.RETURN):
                    flow = slices.dependence(step.stmt).into_exits()
                    yield _operands(slices, instance, step.index, flow)

    return Dependents(slices, operands())


def derivatives(table: EffectTable) -> Chooses:
    """Chooses built-in derivatives and fetches with implicit level of detail."""
    return lambda call: needs_derivative(call, table)


def cube_lookups(table: EffectTable, facts: Facts) -> Chooses:
    """Chooses fetches from cube maps, whatever their level of detail."""

    def chooses(call: n.Call) -> bool:
        if call.name in table.functions or not call.args:
            return False
        return "Cube" in facts.types[call.args[0]].name

    return chooses
