"""Which steps of the program, and which inputs, the value of an expression depends on.

Everything is kept as bit sets in plain integers: one bit for each (instance, step) and for each
argument or global handed down a call path (an *atom*), one bit for each input (a *leaf*: a
uniform, a varying, a built-in variable, a global, or a marker such as :data:`DERIVATIVE`).

A global that the shader writes is followed like a parameter: what a function finds in it is what
the caller's steps before the call left there, and before these the caller's own callers.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import compress

from shadercache.analysis.call_paths import Instance, Place
from shadercache.analysis.control_dependence import ControlDependence, Flow
from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.reaching_definitions import written_anywhere
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk

DERIVATIVE = "%derivative"
"""Leaf of a value that was computed from an explicit derivative (no GLSL name begins with %)."""

_WORD = 32
"""Bytes of a bit set that are looked up at once."""


@dataclass(frozen=True, slots=True)
class Slice:
    """Atoms and leaves as bit sets."""

    atoms: int = 0
    leaves: int = 0

    def __or__(self, other: Slice) -> Slice:
        return Slice(self.atoms | other.atoms, self.leaves | other.leaves)


NOTHING = Slice()


class SliceTable:
    """Backward slices over all instances of a module."""

    def __init__(
        self,
        module: n.Module,
        instances: tuple[Instance, ...],
        table: EffectTable,
        cost: CostTable,
    ) -> None:
        self.instances = instances
        self._table = table
        self._cost = cost
        self._leaf_bits: dict[str, int] = {}
        self._leaf_names: dict[int, frozenset[str]] = {}
        self._atom_costs: list[float] = []
        self._totals: dict[int, float] = {}
        self._word_costs: dict[tuple[int, bytes], float] = {}
        self._globals = _global_initialisers(module)
        self._mutable = written_anywhere(module, table)
        self._params: dict[tuple[Instance, str], Slice] = {}
        self._of_globals: dict[str, Slice] = {}
        self._steps: dict[Instance, list[Slice]] = {}
        self._dependences: dict[n.Stmt, ControlDependence] = {}
        self._reaching: dict[tuple[Instance, str], list[tuple[Slice, bool]]] = {}
        self.step_bits: dict[Instance, list[int]] = {}
        self.argument_bits: dict[tuple[Instance, str], int] = {}
        self._found: dict[tuple[Instance, str], Slice] = {}
        self._found_bits: dict[tuple[Instance, str], int] = {}
        for instance in instances:  # callers first
            self._hand_down(instance)
            self._fill(instance)

    def before(self, instance: Instance, step: int, node: n.Node) -> Slice:
        """What evaluating ``node`` at that step depends on, ``node`` itself apart."""
        effects = self._table.of(node)
        found = self._of_names(instance, step, effects.reads)
        if effects.does & Does.DERIVATIVE:
            found = found | Slice(0, self.leaf_bit(DERIVATIVE))
        return found

    def value(self, instance: Instance, place: Place) -> Slice:
        """What the value of an expression depends on, the expression itself apart."""
        step = place.step
        if not step.is_control:
            return self.before(instance, step.index, place.expr)
        flow = self.dependence(step.stmt).into_value(place.expr)
        return self.flow(instance, step.index, flow) | self.before(instance, step.index, place.expr)

    def flow(self, instance: Instance, step: int, flow: Flow) -> Slice:
        """What a flow inside a step depends on."""
        found = self._of_names(instance, step, flow.names)
        if flow.does & Does.DERIVATIVE:
            found = found | Slice(0, self.leaf_bit(DERIVATIVE))
        return found

    def dependence(self, stmt: n.Stmt) -> ControlDependence:
        """The parts of a step."""
        found = self._dependences.get(stmt)
        if found is None:
            found = self._dependences[stmt] = ControlDependence(stmt, self._table)
        return found

    def step(self, instance: Instance, index: int) -> Slice:
        """What a step depends on, itself included."""
        return self._steps[instance][index]

    def leaf_bit(self, name: str) -> int:
        """The bit of an input."""
        return self._leaf_bits.setdefault(name, 1 << len(self._leaf_bits))

    def leaf_names(self, leaves: int) -> frozenset[str]:
        """The inputs in a bit set."""
        found = self._leaf_names.get(leaves)
        if found is None:
            names = (name for name, bit in self._leaf_bits.items() if bit & leaves)
            found = self._leaf_names[leaves] = frozenset(names)
        return found

    def cost(self, atoms: int) -> float:
        """Static cost of executing the given atoms once."""
        found = self._totals.get(atoms)
        if found is None:
            data = atoms.to_bytes(-(-atoms.bit_length() // 8), "little")
            words = ((at, data[at : at + _WORD]) for at in range(0, len(data), _WORD))
            found = self._totals[atoms] = sum(self._word_cost(*word) for word in words)
        return found

    def _word_cost(self, at: int, word: bytes) -> float:
        """Cost of the atoms in some bytes of a bit set; large sets have most of them in common."""
        found = self._word_costs.get((at, word))
        if found is None:
            bits = bin(int.from_bytes(word, "little"))[:1:-1]
            costs = self._atom_costs[8 * at : 8 * (at + _WORD)]
            found = self._word_costs[at, word] = sum(compress(costs, map(int, bits)))
        return found

    def _new_atom(self, cost: float) -> int:
        self._atom_costs.append(cost)
        return 1 << (len(self._atom_costs) - 1)

    def handed_down(self, atoms: int) -> Iterator[tuple[Instance, Iterable[n.Node]]]:
        """For each argument and global among the atoms: the caller, and the expressions of the
        calling step that flow into it."""
        for (instance, name), bit in self.argument_bits.items():
            if bit & atoms and instance.parent is not None and instance.call is not None:
                names = [param.name for param in instance.places.function.proto.params]
                arg = instance.call.args[names.index(name)]
                yield instance.parent, walk(arg)
                yield instance.parent, self._into_argument(instance, arg).expressions()
        for (instance, name), bit in self._found_bits.items():
            if bit & atoms and instance.parent is not None:
                yield instance.parent, self._into_global(instance, name).expressions()

    def _hand_down(self, instance: Instance) -> None:
        """Slices of the arguments that the caller passes to this instance."""
        caller, call, place = instance.parent, instance.call, instance.place
        if caller is None or call is None or place is None:
            return
        index = place.step.index
        for param, arg in zip(instance.places.function.proto.params, call.args, strict=True):
            if param.name is None:
                continue
            bit = self._new_atom(self._cost.of(arg))
            self.argument_bits[instance, param.name] = bit
            found = self.before(caller, index, arg) | Slice(bit)
            if place.step.is_control or place.order_matters:
                found = found | self.flow(caller, index, self._into_argument(instance, arg))
            self._params[instance, param.name] = found

    def _into_argument(self, instance: Instance, arg: n.Expr) -> Flow:
        assert instance.place is not None
        return self.dependence(instance.place.step.stmt).into_value(arg)

    def _into_global(self, instance: Instance, name: str) -> Flow:
        assert instance.place is not None and instance.call is not None
        return self.dependence(instance.place.step.stmt).into_global(instance.call, name)

    def _found_in(self, instance: Instance, name: str) -> Slice:
        """What a function finds in a global when it is called."""
        if instance.parent is None or instance.place is None:
            return NOTHING
        found = self._found.get((instance, name))
        if found is None:
            bit = self._found_bits[instance, name] = self._new_atom(0.0)
            flow = self._into_global(instance, name)
            found = self.flow(instance.parent, instance.place.step.index, flow) | Slice(bit)
            self._found[instance, name] = found
        return found

    def _fill(self, instance: Instance) -> None:
        slices = self._steps[instance] = []
        bits = self.step_bits[instance] = []
        for step in instance.places.reaching.steps:
            bit = self._new_atom(self._cost.of(step.stmt))
            bits.append(bit)
            slices.append(self.before(instance, step.index, step.stmt) | Slice(bit))

    def _of_names(self, instance: Instance, step: int, names: Iterable[str]) -> Slice:
        found = NOTHING
        for name in names:
            written, from_entry = self._written(instance, name, step)
            found = found | written
            if name in self._globals or name.startswith("%"):
                # A global may also have been written elsewhere: it always counts as an input.
                found = found | self._of_global(name)
                if from_entry and name in self._mutable:
                    found = found | self._found_in(instance, name)
            elif from_entry and (instance, name) in self._params:
                found = found | self._params[instance, name]
        return found

    def _written(self, instance: Instance, name: str, step: int) -> tuple[Slice, bool]:
        """What the writes before a step may have given ``name``.

        And whether the value at the function's entry may still be there.
        """
        writes = instance.places.reaching.writes(name)
        count = bisect_left(writes, (step, False))
        # Behind each write: what those up to it depend on, from the last on that leaves nothing.
        known = self._reaching.setdefault((instance, name), [(NOTHING, True)])
        for index, kills in writes[len(known) - 1 : count]:
            earlier, from_entry = (NOTHING, False) if kills else known[-1]
            known.append((earlier | self._steps[instance][index], from_entry))
        return known[count]

    def _of_global(self, name: str) -> Slice:
        found = self._of_globals.get(name)
        if found is None:
            found = self._of_globals[name] = self._new_global(name)
        return found

    def _new_global(self, name: str) -> Slice:
        found = Slice(0, self.leaf_bit(name))
        init = self._globals.get(name)
        if init is not None:
            effects = self._table.of(init)
            if effects.does & Does.DERIVATIVE:
                found = found | Slice(0, self.leaf_bit(DERIVATIVE))
            for item in effects.reads:
                if (item in self._globals or item.startswith("%")) and item != name:
                    found = found | self._of_global(item)
        return found


def _global_initialisers(module: n.Module) -> dict[str, n.Expr | None]:
    """Every global variable, block member and block instance, with its initialiser."""
    found: dict[str, n.Expr | None] = {}
    for decl in module.decls:
        match decl:
            case n.VarDecl():
                found |= {item.name: item.init for item in decl.declarators}
            case n.BlockDecl():
                if decl.instance is not None:
                    found[decl.instance] = None
                for item in decl.fields:
                    found |= {one.name: None for one in item.declarators}
    for decl in module.decls:
        for node in walk(decl):
            if isinstance(node, n.Name) and node.name.startswith("gl_"):
                found.setdefault(node.name, None)
    return found
