"""Where a value decides what neighbouring fragments compute together.

That is a derivative, taken openly or for a texture's level of detail, and the look-up in a cube
map: on llvmpipe the filter of a cube map rounds differently when any fragment of the same vector
lies on an edge of the cube (measured: 1 ulp in 2e-3 of the pixels, all beside fragments of another
surface).

Two questions are answered (DESIGN section 4, "Derivatives"). Which nodes *feed* such a use that
stays outside of the payload: there neighbouring fragments may hold reused values of something
else. And which implicit fetches belong to a payload: a one-pass variant must make those before its
branch.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from shadercache.analysis.effects import EffectTable, needs_derivative
from shadercache.analysis.instances import Instance, Place
from shadercache.analysis.slices import Slice, SliceTable
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.sema.facts import Facts

Chooses = Callable[[n.Call], bool]


@dataclass(frozen=True, slots=True, eq=False)
class SharedUse:
    """One evaluation of a derivative or fetch, and what its operands depend on."""

    instance: Instance
    place: Place
    operands: Slice


class SharedUses:
    """The uses of one kind in a program, in order of their instances and places.

    ``chooses`` tells whether a call is such a use: :func:`derivatives` or :func:`cube_lookups`.
    """

    def __init__(
        self, instances: tuple[Instance, ...], slices: SliceTable, chooses: Chooses
    ) -> None:
        self._slices = slices
        self._chooses = chooses
        self._children: dict[tuple[Instance, n.Call], Instance] = {
            (item.parent, item.call): item
            for item in instances
            if item.parent is not None and item.call is not None
        }
        self.all = tuple(use for instance in instances for use in self._of_instance(instance))
        self._atoms = 0
        for use in self.all:
            self._atoms |= use.operands.atoms
        self._operand_parts: dict[Instance, set[n.Node]] = {}
        self._mark_operands()
        self._fed: dict[Instance, bool] = {}

    def fed_by(self, instance: Instance, place: Place) -> bool:
        """Does any of these uses, outside of that expression, depend on the value at ``place``?"""
        return self._fed_by_step(instance, place) or self._call_fed(instance)

    def inside(self, instance: Instance, place: Place, found: Slice) -> list[SharedUse]:
        """The uses that belong to the payload at ``place``, whose slice is ``found``.

        In order of evaluation: whatever one of them depends on comes before it.
        """
        below = {item for item in walk(place.expr) if isinstance(item, n.Call)}
        chosen = [use for use in self.all if self._is_inside(use, instance, below, found)]
        # A use depends on more steps than any use among its operands; in one expression the
        # operand has the higher number.
        return sorted(chosen, key=lambda u: (u.operands.atoms.bit_count(), -u.place.ordinal))

    def _of_instance(self, instance: Instance) -> list[SharedUse]:
        found = []
        for place in instance.places.all:
            if isinstance(place.expr, n.Call) and self._chooses(place.expr):
                root = place.step.stmt if place.step.is_control else place.expr
                operands = self._slices.before(instance, place.step.index, root)
                found.append(SharedUse(instance, place, operands))
        return found

    def _mark_operands(self) -> None:
        """Mark every expression whose value flows into a derivative in the same statement."""
        for use in self.all:
            root = use.place.step.stmt if use.place.step.is_control else use.place.expr
            parts = self._operand_parts.setdefault(use.instance, set())
            parts.update(item for item in walk(root) if item is not use.place.expr)
        for (instance, name), bit in self._slices.argument_bits.items():
            if bit & self._atoms and instance.parent is not None and instance.call is not None:
                names = [param.name for param in instance.places.function.proto.params]
                arg = instance.call.args[names.index(name)]
                self._operand_parts.setdefault(instance.parent, set()).update(walk(arg))

    def _fed_by_step(self, instance: Instance, place: Place) -> bool:
        bit = self._slices.step_bits[instance][place.step.index]
        return bool(bit & self._atoms) or place.expr in self._operand_parts.get(instance, ())

    def _call_fed(self, instance: Instance) -> bool:
        """Does the result of this instance's call, or of one above it, feed a derivative?"""
        if instance.parent is None or instance.place is None:
            return False
        if instance not in self._fed:
            self._fed[instance] = self.fed_by(instance.parent, instance.place)
        return self._fed[instance]

    def _is_inside(
        self, use: SharedUse, instance: Instance, below: set[n.Call], found: Slice
    ) -> bool:
        at: Instance | None = use.instance
        inner: n.Expr = use.place.expr
        index = use.place.step.index
        while at is not None:
            if at is instance and inner in below:
                return True
            if self._slices.step_bits[at][index] & found.atoms:
                return True
            if self._in_argument(at, inner, found):
                return True
            if at.place is None or at.call is None:
                return False
            inner, index, at = at.call, at.place.step.index, at.parent
        return False

    def _in_argument(self, caller: Instance, inner: n.Expr, found: Slice) -> bool:
        """Is ``inner`` part of an argument that the payload depends on?"""
        for _, call, callee in caller.places.calls:
            child = self._children[caller, call]
            for param, arg in zip(callee.proto.params, call.args, strict=True):
                bit = self._slices.argument_bits.get((child, param.name or ""), 0)
                if bit & found.atoms and any(item is inner for item in walk(arg)):
                    return True
        return False


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
