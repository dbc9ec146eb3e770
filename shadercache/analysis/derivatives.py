"""Where the shader takes derivatives, openly or for a texture's level of detail.

Two questions are answered (DESIGN section 4, "Derivatives"). Which nodes *feed* a derivative that
stays outside of the payload: there neighbouring fragments may hold reused values, so the derivative
would be of nothing real. And which implicit fetches belong to a payload: a one-pass variant must
make those before its branch.
"""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.analysis.effects import EffectTable, needs_derivative
from shadercache.analysis.instances import Instance, Place
from shadercache.analysis.slices import Slice, SliceTable
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk


@dataclass(frozen=True, slots=True, eq=False)
class DerivativeUse:
    """One evaluation of a derivative or of an implicit fetch, and what its operands depend on."""

    instance: Instance
    place: Place
    operands: Slice


class DerivativeUses:
    """All derivative uses of a program, in order of their instances and places."""

    def __init__(
        self, instances: tuple[Instance, ...], slices: SliceTable, table: EffectTable
    ) -> None:
        self._slices = slices
        self._table = table
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
        """Does any derivative depend on the value at ``place`` from outside of that expression?"""
        return self._fed_by_step(instance, place) or self._call_fed(instance)

    def inside(self, instance: Instance, place: Place, found: Slice) -> list[DerivativeUse]:
        """The uses that belong to the payload at ``place``, whose slice is ``found``.

        In order of evaluation: whatever one of them depends on comes before it.
        """
        below = {item for item in walk(place.expr) if isinstance(item, n.Call)}
        chosen = [use for use in self.all if self._is_inside(use, instance, below, found)]
        # A use depends on more steps than any use among its operands; in one expression the
        # operand has the higher number.
        return sorted(chosen, key=lambda u: (u.operands.atoms.bit_count(), -u.place.ordinal))

    def _of_instance(self, instance: Instance) -> list[DerivativeUse]:
        found = []
        for place in instance.places.all:
            if isinstance(place.expr, n.Call) and needs_derivative(place.expr, self._table):
                root = place.step.stmt if place.step.is_control else place.expr
                operands = self._slices.before(instance, place.step.index, root)
                found.append(DerivativeUse(instance, place, operands))
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
        self, use: DerivativeUse, instance: Instance, below: set[n.Call], found: Slice
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
