"""What all passes of a node are built from: the program, its clones with the nodes cut out, a
``main``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib import import_module
from itertools import accumulate
from typing import Any, TypeAlias

from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.derivative_uses import SharedUse, evaluation_order
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.loops import decided_loops
from shadercache.analysis.mapping import CURRENT_CLIP, MappingKind
from shadercache.analysis.outputs import MOST_TARGETS, Output, targets_of
from shadercache.analysis.precision import PrecisionTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.caching.algorithms import CACHE, COLOR, Algorithm
from shadercache.caching.configuration import Configuration
from shadercache.caching.layout import layout_of
from shadercache.caching.program_parts import program_part
from shadercache.caching.slots import Choice, LocateKind
from shadercache.emit.assemble import Shader, interface, merge, with_locations, without_main
from shadercache.emit.runtime import FOLDER, runtime_names, whole_picture
from shadercache.sema.facts import Facts
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.drop_results import drop_results
from shadercache.transform.expand_compound_assignments import contract
from shadercache.transform.guard_loops import guard_loops
from shadercache.transform.hoist_fetches import form_of
from shadercache.transform.names import FreshNames
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.scale_coordinates import scale_coordinates
from shadercache.transform.specialise import Clones, Cut, CutKind, insert_clones, specialise

_LATE = ("here_late", "hit_late", "find", "find_here")
"""Passes that fragments without a payload go through, up to the end."""

_INTO_CACHE = ("reuse", "reuse_late", "payload", "miss", "hit_mask", "needed")
"""Passes that are drawn as large as the cache, of those there are at a fraction of the rate."""


@dataclass(frozen=True, slots=True, eq=False)
class FragmentProgram:
    """The user's fragment shader, checked and with unique names, and how to extend it.

    ``parsed`` is the same as the user wrote it, ``original`` the one before loops were unrolled;
    ``instanced``: are several instances drawn at once? ``memo`` is what its variants share.
    """

    parsed: n.Module
    module: n.Module
    facts: Facts
    candidates: Candidates
    outputs: tuple[Output, ...]
    prefix: str
    original: n.Module
    mapping: MappingKind = "surface"
    instanced: bool = False
    memo: Memo = field(default_factory=Memo)

    @property
    def colors(self) -> tuple[str, ...]:
        """The names of the user's outputs, in the order of their locations."""
        return tuple(output.name for output in self.outputs)

    @property
    def unrolled(self) -> bool:
        """Are there loops that were unrolled?"""
        return self.original is not self.module

    @property
    def located(self) -> LocateKind:
        """How the passes find their texels."""
        functions = (d.name for d in self.module.decls if isinstance(d, n.FunctionDef))
        if self.mapping == "user" and CURRENT_CLIP in functions:
            return "user, current"
        return self.mapping


class PassBuilder:
    """Builds passes of nodes that are cached together from templates and clones.

    A maker is a function that takes a builder and returns the fragment shader of one pass.
    """

    def __init__(
        self,
        program: FragmentProgram,
        nodes: Sequence[Candidate],
        configuration: Configuration | None = None,
    ) -> None:
        """The configuration's own nodes and algorithm play no part: it says how, not what."""
        self.program, self.nodes = program, tuple(nodes)
        chosen = configuration or Configuration()
        # It is a key: what does not change the runtime's text must not tell two of them apart.
        self._configuration = chosen.look_up
        self.precisions = PrecisionTable(program.module, program.facts)
        self.layout = layout_of(
            tuple(node.type for node in nodes),
            chosen,
            program.module.profile == "es",
            tuple(self.precisions.of(node.expr) for node in nodes),
        )
        self.payloads = self.layout.variables(self.own("payload"))
        self.stores = [self.own("store"), *[self.own("store_2")] * self.layout.second]
        self.colors_and_stores = [*program.colors, *self.stores]
        # A pass writes no pixel that the original discards, so it must get as far as the discard.
        discards = EffectTable(program.module, program.memo).summary("main").does & Does.DISCARD
        self.whole = any(node.unsure for node in nodes) or bool(discards)
        """Do fragments do without a payload, so that each pass goes through the shader?"""
        self._cut: dict[CutKind, Clones] = {}
        self._made: dict[Maker, Shader] = {}
        types = program.facts.types
        self.fetch_form = chosen.fetches
        # In order of evaluation: a later one may need an earlier one.
        self.fetches = [
            (use, self.own(f"fetch_{i}"), form_of(use.place.expr, chosen.fetches, types))
            for i, use in enumerate(_fetches(program.candidates, self.nodes))
        ]

    @property
    def carries(self) -> bool:
        """Does what is stored of a hit differ from what is shown?"""
        return self._configuration.filter.carries

    @property
    def tells_instances(self) -> bool:
        """Does each instance of a draw reuse only what it stored itself?"""
        return self.program.instanced and self._configuration.hit_test.ids

    @property
    def free_targets(self) -> int:
        """How many render targets a pass has left beside the user's and the cache."""
        return MOST_TARGETS - targets_of(self.program.outputs) - len(self.stores)

    def made(self, maker: Maker) -> Shader:
        """What a maker builds, built once."""
        if maker not in self._made:
            self._made[maker] = maker(self)
        return self._made[maker]

    def own(self, name: str) -> str:
        """A name of the compiler's."""
        return self.program.prefix + name

    def names(self) -> FreshNames:
        """Names that are still free in a pass."""
        # None of the user's: the prefix is one that nothing in their text begins with.
        fetched = {
            self.own(f"fetch_{i}") for i in range(len(self.program.candidates.derivatives.all))
        }
        return FreshNames(runtime_names(self.program.prefix) | fetched | set(self.payloads))

    def clone(self, names: FreshNames, entry: str, cuts: tuple[Cut, ...]) -> Clones:
        """The functions on the call paths of cuts, cut, ``main`` as ``entry``."""
        prefix = self.program.prefix
        return specialise(self.program.module, cuts, prefix + entry, names, prefix)

    def cut(self, kind: CutKind) -> Clones:
        """The whole shader with the nodes cut out in one way, or (``goal``) the payloads alone."""
        # Passes with the same clones share them, and what the memo knows of them.
        if kind not in self._cut:
            entry = "compute" if kind == "goal" else "shade"
            self._cut[kind] = self.clone(self.names(), entry, self.node_cuts(kind))
        return self._cut[kind]

    def node_cuts(self, kind: CutKind) -> tuple[Cut, ...]:
        """Where the nodes are cut out."""
        flags = self.layout.variables(self.own("valid"))
        return tuple(
            Cut(node.instance.path, node.expr, payload, kind, flag)
            for node, payload, flag in zip(self.nodes, self.payloads, flags, strict=True)
            if node.instance is not None
        )

    def build(
        self,
        template: str,
        clones: Sequence[Clones],
        outputs: Sequence[str],
        extra: Sequence[n.Decl] = (),
    ) -> Shader:
        """A file of ``glsl/passes`` with what its ``main`` needs for the ``outputs``."""
        # What lies beside the payload in the cache is no part of what the payload alone costs.
        alone = template in ("payload_alone", "needed")
        layout = replace(self.layout, extras=(), tucked=()) if alone else self.layout
        program = self.program
        choice = Choice(
            layout,
            program.prefix,
            self.whole,
            program.located,
            self._configuration,
            program.instanced,
        )
        part = program_part(FOLDER / f"passes/{template}.glsl", choice)
        user = insert_clones(program.module, *clones)
        if template in _INTO_CACHE and self._configuration.payload_rate != "full":
            scale, whole = whole_picture(program.prefix)
            user, extra = scale_coordinates(user, whole), (*extra, scale)
        # Without a payload a loop that waits for it may never end, whatever is discarded later.
        if template in _LATE and self.decides_loops:
            user = guard_loops(user, self._decided(user), self.own("lacks"))
        module = merge(program.module, without_main(user), extra, part.decls)
        module = replace(module, comments=(*module.comments, *part.comments))
        copies = {copy.name for group in clones for _, copy in group.pairs}
        module = contract(_shrink(module, outputs, copies, program.memo), program.memo)
        return interface(with_locations(module, self._locations(outputs)))

    def _locations(self, outputs: Sequence[str]) -> dict[str, int]:
        """Where a pass has its outputs: the user's as many targets as they take, others one."""
        targets = {output.name: output.targets for output in self.program.outputs}
        places = accumulate((targets.get(name, 1) for name in outputs), initial=0)
        return dict(zip(outputs, places, strict=False))

    def takes_derivatives(self, module: n.Module) -> bool:
        """Does the shading? (The look-up may, ahead of everything.)"""
        table, shade = EffectTable(module, self.program.memo), self.own("shade")
        does = table.summary(shade).does if shade in table.functions else Does(0)
        return bool(does & (Does.DERIVATIVE | Does.IMPLICIT_LOD))

    @cached_property
    def decides_loops(self) -> bool:
        """Does a payload decide how long a loop runs?"""
        user = insert_clones(self.program.module, self.cut("use"))
        return bool(self._decided(user))

    def _decided(self, user: n.Module) -> frozenset[n.Node]:
        """The loops that a payload decides on."""
        return decided_loops(user, self.payloads, self.program.memo)


def _fetches(candidates: Candidates, nodes: Sequence[Candidate]) -> list[SharedUse]:
    """The derivatives and implicit fetches that the nodes' values need, in order of evaluation."""
    uses: dict[SharedUse, None] = {}
    for node in nodes:
        assert node.instance is not None and node.place is not None
        value = candidates.slices.value(node.instance, node.place)
        uses |= dict.fromkeys(candidates.derivatives.inside(node.instance, node.place, value))
    return sorted(uses, key=evaluation_order)


def exact_original(program: FragmentProgram) -> Shader:
    """The user's shader with unique names and without what it does not need, for proof mode."""
    needed = remove_dead(program.original, program.colors, program.memo)
    locations = {output.name: output.location for output in program.outputs}
    return interface(with_locations(contract(needed, program.memo), locations))


def _shrink(module: n.Module, wanted: Sequence[str], clones: set[str], memo: Memo) -> n.Module:
    """Remove what is dead, until nothing is."""
    # A parameter that nobody reads keeps its argument alive, and a result that nobody uses what it
    # is made of.
    while True:
        module = remove_dead(module, wanted, memo)
        smaller = drop_parameters(drop_results(module, clones, memo), clones, memo)
        if smaller is module:
            return module
        module = smaller


Maker: TypeAlias = Callable[[PassBuilder], Shader]


def function_named(text: str) -> Any:
    """A function of this folder, as the table of algorithms writes it: ``module:function``."""
    module, _, name = text.partition(":")
    return getattr(import_module(f"{__package__}.{module}"), name)


def unfit(builder: PassBuilder, algorithm: Algorithm) -> str | None:
    """Why the nodes cannot be cached by an algorithm, if so."""
    together = any({COLOR, CACHE} <= set(record.targets) for record in algorithm.passes)
    if together and builder.free_targets < 0:
        return (
            f"the shader writes {targets_of(builder.program.outputs)} render targets and the cache "
            f"has {len(builder.stores)}, but a pass has {MOST_TARGETS}"
        )
    reason: str | None = function_named(algorithm.unfit)(builder) if algorithm.unfit else None
    return reason
