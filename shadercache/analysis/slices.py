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


class AtomCosts:
    """Bits of atoms, and what executing them costs."""

    def __init__(self) -> None:
        self._costs: list[float] = []
        self._totals: dict[int, float] = {}
        self._words: dict[tuple[int, bytes], float] = {}

    def new(self, cost: float) -> int:
        """The bit of another atom."""
        self._costs.append(cost)
        return 1 << (len(self._costs) - 1)

    def of(self, atoms: int) -> float:
        """Static cost of executing the given atoms once."""
        total = self._totals.get(atoms)
        if total is None:
            data = atoms.to_bytes(-(-atoms.bit_length() // 8), "little")
            words = ((at, data[at : at + _WORD]) for at in range(0, len(data), _WORD))
            total = self._totals[atoms] = sum(self._of_word(*word) for word in words)
        return total

    def _of_word(self, at: int, word: bytes) -> float:
        # Large sets have most of their words in common.
        total = self._words.get((at, word))
        if total is None:
            # Without 0b and from the end: the lowest bit first, as the costs stand.
            bits = bin(int.from_bytes(word, "little"))[:1:-1]
            costs = self._costs[8 * at : 8 * (at + _WORD)]
            total = self._words[at, word] = sum(compress(costs, map(int, bits)))
        return total


class Leaves:
    """Bits of inputs."""

    def __init__(self) -> None:
        self._bits: dict[str, int] = {}
        self._names: dict[int, frozenset[str]] = {}

    def bit(self, name: str) -> int:
        """The bit of an input."""
        return self._bits.setdefault(name, 1 << len(self._bits))

    def names(self, leaves: int) -> frozenset[str]:
        """The inputs in a bit set."""
        names = self._names.get(leaves)
        if names is None:
            names = frozenset(name for name, bit in self._bits.items() if bit & leaves)
            self._names[leaves] = names
        return names


class SliceTable:
    """Backward slices over all instances of a module.

    ``step_bits`` are the atoms of the steps of each instance, ``entry_bits`` those of what it
    finds in its parameters and in globals when it is called.
    """

    def __init__(
        self,
        module: n.Module,
        instances: tuple[Instance, ...],
        table: EffectTable,
        cost: CostTable,
    ) -> None:
        self.instances = instances
        self.leaves, self.atom_costs = Leaves(), AtomCosts()
        self.step_bits: dict[Instance, list[int]] = {}
        self.entry_bits: dict[tuple[Instance, str], int] = {}
        self._table, self._cost = table, cost
        self._globals = _global_initialisers(module)
        self._mutable = written_anywhere(module, table)
        self._of_globals: dict[str, Slice] = {}
        self._entries: dict[tuple[Instance, str], Slice] = {}
        self._steps: dict[Instance, list[Slice]] = {}
        self._dependences: dict[n.Stmt, ControlDependence] = {}
        self._reaching: dict[tuple[Instance, str], list[tuple[Slice, bool]]] = {}
        for instance in instances:  # callers first
            self._fill(instance)

    def value(self, instance: Instance, place: Place) -> Slice:
        """What the value of an expression depends on, the expression itself apart."""
        step, slice_ = place.step, self._before(instance, place.step.index, place.expr)
        # Reaching definitions know nothing of what a control step did before the expression in it.
        if step.is_control:
            flow = self.dependence(step.stmt).into_value(place.expr)
            slice_ = self.flow(instance, step.index, flow) | slice_
        return slice_

    def flow(self, instance: Instance, step: int, flow: Flow) -> Slice:
        """What a flow inside a step depends on."""
        return self._of_names(instance, step, flow.names, flow.does)

    def dependence(self, stmt: n.Stmt) -> ControlDependence:
        """The parts of a step."""
        dependence = self._dependences.get(stmt)
        if dependence is None:
            dependence = self._dependences[stmt] = ControlDependence(stmt, self._table)
        return dependence

    def handed_down(self, atoms: int) -> Iterator[tuple[Instance, Iterable[n.Node]]]:
        """For each argument and global among the atoms: the caller, and the expressions of the
        calling step that flow into it."""
        for (instance, name), bit in self.entry_bits.items():
            if bit & atoms and instance.parent is not None:
                arg = instance.arguments.get(name)
                yield instance.parent, () if arg is None else walk(arg)
                yield instance.parent, self._into_entry(instance, name).expressions()

    def _before(self, instance: Instance, step: int, node: n.Node) -> Slice:
        """What evaluating ``node`` at that step depends on, ``node`` itself apart."""
        effects = self._table.of(node)
        return self._of_names(instance, step, effects.reads, effects.does)

    def _fill(self, instance: Instance) -> None:
        slices = self._steps[instance] = []
        bits = self.step_bits[instance] = []
        for step in instance.places.reaching.steps:
            bit = self.atom_costs.new(self._cost.of(step.stmt))
            bits.append(bit)
            slices.append(self._before(instance, step.index, step.stmt) | Slice(bit))

    def _entry(self, instance: Instance, name: str) -> Slice:
        """What a function finds in a parameter, or in a global, when it is called."""
        if instance.parent is None or instance.place is None:
            return NOTHING
        entry = self._entries.get((instance, name))
        if entry is None:
            caller, place, arg = instance.parent, instance.place, instance.arguments.get(name)
            cost = 0.0 if arg is None else self._cost.of(arg)
            # An atom of its own: what is inside needs the argument, not the whole calling step.
            bit = self.entry_bits[instance, name] = self.atom_costs.new(cost)
            entry = Slice(bit)
            if arg is not None:
                entry |= self._before(caller, place.step.index, arg)
            # In other steps nothing is written before the call: what reaches the step says it all.
            if arg is None or place.step.is_control or place.order_matters:
                entry |= self.flow(caller, place.step.index, self._into_entry(instance, name))
            self._entries[instance, name] = entry
        return entry

    def _into_entry(self, instance: Instance, name: str) -> Flow:
        """What flows, in the calling step, into a parameter or a global."""
        assert instance.place is not None and instance.call is not None
        dependence = self.dependence(instance.place.step.stmt)
        arg = instance.arguments.get(name)
        if arg is None:
            return dependence.into_global(instance.call, name)
        return dependence.into_value(arg)

    def _of_names(self, instance: Instance, step: int, names: Iterable[str], does: Does) -> Slice:
        slice_ = Slice(0, self.leaves.bit(DERIVATIVE)) if does & Does.DERIVATIVE else NOTHING
        for name in names:
            written, from_entry = self._written(instance, name, step)
            slice_ |= written
            if name in self._globals or name.startswith("%"):
                # A global may also have been written elsewhere: it always counts as an input.
                slice_ |= self._of_global(name)
                from_entry = from_entry and name in self._mutable
            else:
                from_entry = from_entry and name in instance.arguments
            if from_entry:
                slice_ |= self._entry(instance, name)
        return slice_

    def _written(self, instance: Instance, name: str, step: int) -> tuple[Slice, bool]:
        """What the writes before a step may have given ``name``.

        And whether the value at the function's entry may still be there.
        """
        writes = instance.places.reaching.writes(name)
        count = bisect_left(writes, (step, False))
        # Behind each write: what those up to it depend on, from the last on that leaves nothing.
        # Kept and extended, so that each write is joined once however many steps read the variable.
        known = self._reaching.setdefault((instance, name), [(NOTHING, True)])
        for index, kills in writes[len(known) - 1 : count]:
            earlier, from_entry = (NOTHING, False) if kills else known[-1]
            known.append((earlier | self._steps[instance][index], from_entry))
        return known[count]

    def _of_global(self, name: str) -> Slice:
        slice_ = self._of_globals.get(name)
        if slice_ is None:
            slice_ = Slice(0, self.leaves.bit(name))
            init = self._globals.get(name)
            if init is not None:
                effects = self._table.of(init)
                if effects.does & Does.DERIVATIVE:
                    slice_ |= Slice(0, self.leaves.bit(DERIVATIVE))
                for other in effects.reads - {name}:
                    if other in self._globals or other.startswith("%"):
                        slice_ |= self._of_global(other)
            self._of_globals[name] = slice_
        return slice_


def _global_initialisers(module: n.Module) -> dict[str, n.Expr | None]:
    """Every global variable, block member and block instance, with its initialiser."""
    initialisers: dict[str, n.Expr | None] = {}
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            initialisers |= {variable.name: variable.init for variable in decl.declarators}
        elif isinstance(decl, n.BlockDecl):
            members = (member.name for field in decl.fields for member in field.declarators)
            initialisers |= dict.fromkeys((decl.instance or "", *members))
    # Built-in variables are inputs too, and no declaration of the module names them.
    for node in walk(module):
        if isinstance(node, n.Name) and node.name.startswith("gl_"):
            initialisers.setdefault(node.name, None)
    return initialisers
