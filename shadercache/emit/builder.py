"""What all passes of a node are built from: the program, its clones with the nodes cut out, a
``main``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.derivative_uses import SharedUse, evaluation_order
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.loops import decided_loops
from shadercache.analysis.mapping import CURRENT_CLIP, MappingKind
from shadercache.analysis.precision import PrecisionTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.caching.configuration import Configuration
from shadercache.caching.layout import Layout, extras_of
from shadercache.caching.program_parts import program_part
from shadercache.caching.slots import Choice, Located
from shadercache.emit.assemble import Shader, interface, merge, with_locations, without_main
from shadercache.emit.runtime import FOLDER, runtime_names
from shadercache.sema.facts import Facts
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.drop_results import drop_results
from shadercache.transform.expand_compound_assignments import contract
from shadercache.transform.guard_loops import guard_loops
from shadercache.transform.hoist_fetches import form_of
from shadercache.transform.names import FreshNames
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.specialise import Clones, Cut, CutKind, insert_clones, specialise

_LATE = ("passes/here_late", "passes/hit_late")
"""Passes that fragments without a payload go through, up to a discard at the end."""


@dataclass(frozen=True, slots=True, eq=False)
class FragmentProgram:
    """The user's fragment shader, checked and with unique names, and how to extend it.

    ``parsed`` is the same as the user wrote it, ``original`` the one before loops were unrolled;
    ``memo`` is what its variants share.
    """

    parsed: n.Module
    module: n.Module
    facts: Facts
    candidates: Candidates
    color: str
    prefix: str
    original: n.Module
    mapping: MappingKind = "surface"
    memo: Memo = field(default_factory=Memo)

    @property
    def unrolled(self) -> bool:
        """Are there loops that were unrolled?"""
        return self.original is not self.module

    @property
    def located(self) -> Located:
        """How the passes find their texels."""
        if self.mapping != "user":
            return Located(self.mapping)
        functions = (d.name for d in self.module.decls if isinstance(d, n.FunctionDef))
        return Located(self.mapping, CURRENT_CLIP in functions)


class PassBuilder:
    """Builds passes of nodes that are cached together from templates and clones."""

    def __init__(
        self,
        program: FragmentProgram,
        nodes: Sequence[Candidate],
        configuration: Configuration | None = None,
    ) -> None:
        """The configuration's own nodes and algorithm play no part: it says how, not what."""
        self.program, self.nodes = program, tuple(nodes)
        chosen = configuration or Configuration()
        self.configuration = chosen.look_up
        precisions = PrecisionTable(program.module, program.facts)
        self.precisions = precisions
        self.layout = Layout(
            tuple(node.type for node in nodes),
            program.module.profile == "es",
            tuple(precisions.of(node.expr) for node in nodes),
            extras_of(chosen),
        )
        self.payloads = self.layout.variables(program.prefix + "payload")
        stores = ("store", "store_2") if self.layout.second else ("store",)
        self.stores = [program.prefix + name for name in stores]
        discards = EffectTable(program.module, program.memo).summary("main").does & Does.DISCARD
        self.whole = any(node.unsure for node in nodes) or bool(discards)
        """Do fragments do without a payload, so that each pass goes through the shader?"""
        self._clones: dict[str, Clones] = {}
        types = program.facts.types
        self.fetches = [
            (use, self.own(f"fetch_{i}"), form_of(use.place.expr, chosen.fetches, types))
            for i, use in enumerate(_fetches(program.candidates, self.nodes))
        ]

    def own(self, name: str) -> str:
        return self.program.prefix + name

    def names(self) -> FreshNames:
        made = {self.own(f"fetch_{i}") for i in range(len(self.fetches))}
        return FreshNames(runtime_names(self.program.prefix) | made | set(self.payloads))

    def clone(self, names: FreshNames, entry: str, cuts: tuple[Cut, ...]) -> Clones:
        prefix = self.program.prefix
        return specialise(self.program.module, cuts, prefix + entry, names, prefix)

    def shaded(self, kind: CutKind, names: FreshNames | None = None) -> Clones:
        """The whole shader with the nodes cut out in one way."""
        if names is not None:
            return self.clone(names, "shade", self.node_cuts(kind))
        return self._alone("shade", kind)

    def computed(self) -> Clones:
        """The payloads alone."""
        return self._alone("compute", "goal")

    def _alone(self, entry: str, kind: CutKind) -> Clones:
        """The only clones of a pass. Other passes have the same, and then share what is found out
        about them."""
        if kind not in self._clones:
            self._clones[kind] = self.clone(self.names(), entry, self.node_cuts(kind))
        return self._clones[kind]

    def node_cuts(self, kind: CutKind) -> tuple[Cut, ...]:
        flags = self.layout.variables(self.own("valid"))
        return tuple(
            Cut(node.instance.path, node.expr, payload, kind, flag)
            for node, payload, flag in zip(self.nodes, self.payloads, flags, strict=True)
            if node.instance is not None
        )

    def finish(
        self,
        template: str,
        clones: list[Clones],
        extra: list[n.Decl] | None = None,
        both: bool = False,
        store: bool = True,
    ) -> Shader:
        """``both``: colour and cache are written; else the cache if ``store``, else the colour."""
        outputs = [self.program.color] if both or not store else []
        outputs += self.stores if store else []
        locations = {name: i for i, name in enumerate(outputs)}
        return self.build(template, clones, extra or (), locations)

    def build(
        self,
        template: str,
        clones: list[Clones],
        extra: list[n.Decl] | tuple[()],
        locations: dict[str, int],
    ) -> Shader:
        # What lies beside the payload in the cache is no part of what the payload alone costs.
        alone = template in ("passes/payload_alone", "passes/needed")
        layout = replace(self.layout, extras=()) if alone else self.layout
        program = self.program
        choice = Choice(layout, program.prefix, self.whole, program.located, self.configuration)
        part = program_part(FOLDER / f"{template}.glsl", choice)
        user = insert_clones(self.program.module, *clones)
        if template in _LATE and self.decides_loops:
            user = guard_loops(user, self._decided(user), self.own("lacks"))
        module = merge(program.module, without_main(user), extra, part.decls)
        module = replace(module, comments=(*module.comments, *part.comments))
        made = {clone.name for group in clones for _, clone in group.made}
        memo = self.program.memo
        module = contract(_shrink(module, locations, made, memo), memo)
        return interface(with_locations(module, locations))

    def takes_derivatives(self, module: n.Module) -> bool:
        """Does the shading? (The look-up may, ahead of everything.)"""
        table, shade = EffectTable(module, self.program.memo), self.own("shade")
        does = table.summary(shade).does if shade in table.functions else Does(0)
        return bool(does & (Does.DERIVATIVE | Does.IMPLICIT_LOD))

    @cached_property
    def decides_loops(self) -> bool:
        """Does a payload decide how long a loop runs?"""
        user = insert_clones(self.program.module, self.shaded("use"))
        return bool(self._decided(user))

    def _decided(self, user: n.Module) -> frozenset[n.Node]:
        """The loops that a payload decides on."""
        return decided_loops(user, self.payloads, self.program.memo)


def _fetches(candidates: Candidates, nodes: Sequence[Candidate]) -> list[SharedUse]:
    """The derivatives and implicit fetches that the nodes' values need, in order of evaluation."""
    found: dict[SharedUse, None] = {}
    for node in nodes:
        assert node.instance is not None and node.place is not None
        value = candidates.slices.value(node.instance, node.place)
        found |= dict.fromkeys(candidates.derivatives.inside(node.instance, node.place, value))
    return sorted(found, key=evaluation_order)


def exact_original(program: FragmentProgram) -> Shader:
    """The user's shader with unique names and without what it does not need, for proof mode."""
    needed = remove_dead(program.original, (program.color,), program.memo)
    module = contract(needed, program.memo)
    return interface(with_locations(module, {program.color: 0}))


def _shrink(module: n.Module, wanted: dict[str, int], clones: set[str], memo: Memo) -> n.Module:
    """Remove what is dead; a parameter that nobody reads keeps its argument alive, and a result
    that nobody uses what it is made of: so in turns."""
    while True:
        module = remove_dead(module, wanted, memo)
        smaller = drop_parameters(drop_results(module, clones, memo), clones, memo)
        if smaller is module:
            return module
        module = smaller
