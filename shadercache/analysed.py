"""A shader as it was analysed: what the command line, the harness and a rewrite ask about it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property

from shadercache.analysis.candidates import Candidate, Candidates, varyings
from shadercache.analysis.costs import payload_sets
from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.costs.savings import Savings
from shadercache.analysis.costs.shared_work import SharedWorkTable
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.input_reads import input_kinds
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.moving import NO_GUESS, moving_inputs
from shadercache.analysis.naming import NO_NAMES, NodeNames
from shadercache.analysis.refusals import Code
from shadercache.analysis.screen.screen_varyings import ScreenVaryings
from shadercache.analysis.stages import Pairs, StageSide, links_of, match_stages
from shadercache.analysis.use_def import Definitions
from shadercache.analysis.value_class import ValueClass, class_of
from shadercache.analysis.value_numbering import ValueGroup, number_values
from shadercache.analysis.vertex_inputs import POSITION
from shadercache.ast import nodes as n
from shadercache.diagnostics import Diagnostic, InputError, Severity, input_error
from shadercache.emit.builder import FragmentProgram, PassBuilder
from shadercache.emit.printer import print_node
from shadercache.emit.runtime import full_screen_vertex
from shadercache.emit.side_passes import unneeded
from shadercache.emit.twins import twin_name
from shadercache.emit.vertex import VertexEmitter
from shadercache.emit.vulkan import VulkanPlaces
from shadercache.front.dialects import surrounded
from shadercache.front.read_options import ReadOptions
from shadercache.front.webgl import WEBGL, names_version
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import DependencyEntry
from shadercache.manifest.reflection import dependencies, inputs_of, twin_bindings
from shadercache.manifest.vulkan_inputs import places_of, twin_bindings_in_vulkan
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import infer
from shadercache.source import Source
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.versions.raise_version import Raised

_INCLUDE = re.compile(r"#[ \t]*include\b")
# The two outputs are GLSL ES 1.00's as well.
_FIXED_FUNCTION = re.compile(r"gl_(?!Frag(Color|Data))")

_MUCH = 0.1
"""Share of a shader in both passes from which on it is told."""


@dataclass(frozen=True, slots=True)
class VertexStage:
    """The vertex shader as it is worked on, and what it passes on."""

    module: n.Module
    facts: Facts
    pairs: Pairs
    screen: ScreenVaryings


@dataclass(frozen=True)
class Analysis:
    """A fragment shader with all its nodes, and the vertex shader where one was given.

    ``raised``: the stages in a version that variants can be written in. ``kept_loops``: which loops
    were not unrolled, where that was asked for, and why.
    """

    fragment: Source
    vertex: Source | None
    candidates: Candidates
    program: FragmentProgram
    raised: tuple[Raised, ...]
    stage: VertexStage | None
    reading: ReadOptions
    kept_loops: tuple[Diagnostic, ...] = ()

    @property
    def nodes(self) -> tuple[Candidate, ...]:
        """Every node, in order of call paths and source."""
        return self.candidates.nodes

    @property
    def mapping(self) -> MappingKind:
        """Where a fragment finds what the previous frame stored."""
        return self.program.mapping

    @property
    def full_screen(self) -> bool:
        """Is there no geometry but a triangle that covers the target?"""
        return self.vertex is None and self.mapping != "surface"

    @cached_property
    def vertex_emitter(self) -> VertexEmitter:
        """What makes the vertex shaders: of the user's, or of the one of a full-screen pass.

        Raises :class:`InputError` SC402 where there has to be one and is none, SC406 where a
        full-screen pass cannot give the fragment shader a varying.
        """
        program = self.program
        shared = program.prefix, program.memo, program.mapping
        if self.stage is not None:
            bindings = (twin_bindings_in_vulkan if self.vulkan else twin_bindings)(self.inputs)
            emitter = VertexEmitter(self.raised[1].module, self.stage.module, *shared)
            return replace(
                emitter,
                links=links_of(self.stage.pairs),
                moving=self.moving,
                bindings=bindings,
                vulkan=self.vulkan,
            )
        if not self.full_screen:
            raise input_error(
                "SC402", "a vertex shader is needed to rewrite a shader", "give --vert"
            )
        source, module = full_screen_vertex(program.module)
        # Only for what it raises: the triangle of a full-screen pass hands on no varyings.
        match_stages(
            StageSide(program.module, program.facts, self.fragment),
            StageSide(module, infer(module, source, "vertex"), source),
        )
        return replace(VertexEmitter(module, module, *shared), vulkan=self.vulkan)

    @cached_property
    def vulkan(self) -> VulkanPlaces | None:
        """Where what is added has its place in Vulkan GLSL; None in other GLSL."""
        if self.reading.dialect != "vulkan":
            return None
        program, vertex = self.program, None
        if self.stage is not None and self.vertex is not None:
            vertex = StageSide(self.stage.module, self.stage.facts, self.vertex)
        return places_of(
            StageSide(program.module, program.facts, self.fragment),
            vertex,
            self.inputs,
            {name: twin_name(program.prefix, name) for name in self.moving},
            program.instanced,
        )

    @cached_property
    def moving(self) -> frozenset[str]:
        """The attributes, textures and buffers that decide the position and have twins, since they
        are said or taken to move.

        Raises :class:`InputError` SC464 for a name that the vertex shader does not have.
        """
        if self.stage is None or self.vertex is None or self.mapping != "surface":
            return frozenset()
        asked = [self.renamed.get(name, name) for name in self.reading.moving]
        module = self.stage.module
        return moving_inputs(remove_dead(module, (POSITION,)), asked, module, self.vertex)

    @property
    def vertex_source(self) -> Source:
        """The vertex shader's text: the user's, or that of a full-screen pass."""
        return self.vertex or full_screen_vertex(self.program.module)[0]

    @cached_property
    def inputs(self) -> tuple[InputEntry, ...]:
        """What an engine gives the user's shaders."""
        stages: list[tuple[n.Module, Facts, Stage]] = []
        if self.stage is not None:
            stages.append((self.stage.module, self.stage.facts, "vertex"))
        return inputs_of([*stages, (self.program.module, self.program.facts, "fragment")])

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """What became of the stages where they were of an older version, of loops, and what is
        taken to move."""
        raised = (note for stage in self.raised for note in stage.notes)
        return (*raised, *self.kept_loops, *self._taken_to_move)

    @property
    def _taken_to_move(self) -> tuple[Diagnostic, ...]:
        old = {new: name for name, new in self.renamed.items()}
        taken = sorted(old.get(name, name) for name in self.moving)
        unasked = [name for name in taken if name not in self.reading.moving]
        if not unasked:
            return ()
        message = f"taken to move, and given what it was in the last frame: {', '.join(unasked)}"
        hint = f"'--moving {NO_GUESS}' if it rests; '--moving NAME' for what else moves"
        return (Diagnostic("SC465", message, self.vertex, hint=hint, severity=Severity.NOTE),)

    @property
    def renamed(self) -> dict[str, str]:
        """What an engine knows by another name than the user's text has: old name to new."""
        return {old: new for stage in self.raised for old, new in stage.renamed.items()}

    @cached_property
    def groups(self) -> Mapping[Candidate, ValueGroup]:
        """Which nodes have the same value: the group of every node."""
        program = self.program
        table = EffectTable(program.module)
        return number_values(program.module, program.facts, table, self.candidates)

    @cached_property
    def definitions(self) -> Definitions:
        """Where values come from."""
        table = EffectTable(self.program.module)
        return Definitions(self.program.facts, table, self.candidates.instances)

    @cached_property
    def shared_work(self) -> SharedWorkTable:
        """What both the payload's pass and the shading pass compute."""
        costs, table = CostTable(self.program.facts), EffectTable(self.program.module)
        return SharedWorkTable(self.candidates.instances, table, costs, self.program.colors)

    @cached_property
    def savings(self) -> Savings:
        """What caching each of the nodes would save."""
        return Savings(self.candidates, self.groups, self.shared_work)

    @cached_property
    def _names(self) -> NodeNames:
        about = self.fragment, self.candidates
        return NodeNames(*about, lambda: self.groups, lambda: self.savings, self.reading.unroll)

    def node(self, name: str) -> Candidate:
        """The node with this id, with this text, or at this place: see :mod:`analysis.naming`.

        Raises :class:`UsageError` SC010 or SC011 if there is none, SC012 if there are several.
        """
        return self._names.one(name)

    def nodes_of(self, names: str, named: Mapping[str, str] = NO_NAMES) -> tuple[Candidate, ...]:
        """The nodes with these names, joined by ``+``; one is a set of one. ``named`` are names of
        a scene's for nodes and sets. Raises as ``node``."""
        return self._names.several(names, named)

    def static_ratio(self, nodes: Sequence[Candidate]) -> float:
        """P/T by static costs, where the values of ``nodes`` are cached together."""
        if len(nodes) == 1:
            return nodes[0].ratio
        # Work that the values share would count twice in a sum of their ratios.
        return self.shared_work.parts(nodes).payload / (self.shared_work.whole or 1.0)

    def require_all(self, nodes: Sequence[Candidate], unprofitable: bool = False) -> None:
        """Raise :class:`InputError` with the refusal's code if a node may not be cached.

        SC415 to SC417 where nodes do not go together. ``unprofitable`` lets those pass that are
        refused only as cheaper than a fetch.
        """
        for node in nodes:
            refusal = node.refusal
            if refusal is None or (refusal.unprofitable and unprofitable):
                continue
            hint = "caching it anyway takes --unprofitable" if refusal.unprofitable else None
            if refusal.code is Code.LOOP and not self.reading.unroll:
                hint = "with --unroll, loops of few trips are taken apart"
            elif refusal.approximable and not self.reading.approximate:
                hint = "with --approximate it may be cached: reuse is exact at rest, not in motion"
            message = f"'{node.text}' {refusal.sentence}"
            about = refusal.code.code, message, self.fragment, node.expr.span
            raise InputError(Diagnostic(*about, hint))
        if len(nodes) > 1:
            payload_sets.check_set(nodes, self.groups, self.fragment)
            payload_sets.check_needed(unneeded(PassBuilder(self.program, nodes)), self.fragment)


def unchanged_for(analysis: Analysis, nodes: Sequence[Candidate]) -> tuple[str, ...] | None:
    """While which uniforms, textures and attributes do not change is reuse of values exact?

    ``None`` where this cannot be said: with another mapping than ``screen`` a value is found
    between the texels of a cache.
    """
    if analysis.mapping != "screen":
        return None
    module = analysis.program.module
    kinds = input_kinds(module, analysis.program.facts)
    given = ("uniforms", "textures", "varyings")
    inputs = frozenset(name for node in nodes for name in node.inputs if kinds.get(name) in given)
    passed = inputs & varyings(module)
    if analysis.vertex is None:
        return tuple(sorted(inputs))
    # A varying changes when something changes that the vertex shader makes it from.
    return tuple(sorted((inputs - passed) | analysis.vertex_emitter.inputs(passed)))


def depends_on(analysis: Analysis, nodes: Sequence[Candidate]) -> tuple[DependencyEntry, ...]:
    """What the engine sets that the values depend on, through varyings too."""
    read = frozenset(name for node in nodes for name in node.inputs)
    passed = read & varyings(analysis.program.module)
    stages: dict[Stage, frozenset[str]] = {"fragment": read - passed}
    if analysis.vertex is not None:
        stages["vertex"] = analysis.vertex_emitter.sources(passed)
    return dependencies(stages, analysis.inputs)


def of_vertex_stage(analysis: Analysis, passed: frozenset[str]) -> frozenset[str]:
    """The uniforms and textures that the vertex shader makes these varyings from."""
    stage = analysis.stage
    if stage is None or not passed:
        return frozenset()
    kinds = input_kinds(stage.module, stage.facts)
    sources = analysis.vertex_emitter.sources(passed)
    return frozenset(name for name in sources if kinds.get(name) in ("uniforms", "textures"))


def value_classes(
    analysis: Analysis, changes: Mapping[str, str] | None
) -> Callable[[Candidate], ValueClass]:
    """What tells the class of a node; ``changes``: which inputs change, and with what."""
    passed = varyings(analysis.program.module)
    stage = analysis.stage
    projection = frozenset[str]() if stage is None else stage.screen.projection

    @cache
    def of_inputs(on_screen: bool, inputs: frozenset[str]) -> ValueClass:
        uniforms = inputs | of_vertex_stage(analysis, inputs & passed)
        return class_of(on_screen, uniforms, projection, changes)

    return lambda node: of_inputs(node.on_screen, node.inputs)


def on_cpu(analysis: Analysis, node: Candidate) -> str | None:
    """What to compute on the CPU in place of a value of uniforms only (SC303), as GLSL.

    ``None`` for any other value, and where it takes more than one expression.
    """
    if node.refusal is None or node.refusal.code is not Code.UNIFORM:
        return None
    assert node.instance is not None and node.place is not None
    closed = analysis.definitions.closed(node.instance, node.place.step, node.expr)
    return None if closed is None else print_node(closed)


def written(analysis: Analysis) -> str | None:
    """The user's own text as a driver can be given it: with what its host adds to it.

    ``None`` where it needs what is outside of it, or attributes or state that only the
    compatibility profile has.
    """
    reading = analysis.reading
    sources = (analysis.fragment, analysis.vertex)
    outside = any(source and _INCLUDE.search(source.text) for source in sources)
    if outside or reading.defines or reading.undefined:
        return None
    if any(map(_FIXED_FUNCTION.match, analysis.renamed)):
        return None
    text = surrounded(analysis.fragment, reading.dialect)
    # Without a #version a desktop driver takes the text for GLSL 1.10, which has no precisions.
    webgl = analysis.program.parsed.profile == "es" and not names_version(text)
    return f"#version {WEBGL.number}\n{text}" if webgl else text


def carrying(analysis: Analysis, nodes: Sequence[Candidate]) -> tuple[Candidate, ...]:
    """The nodes, and what has to be cached along so that little is computed in both passes: as much
    as fits beside them."""
    together = tuple(nodes)
    tables = analysis.groups, analysis.shared_work
    while (more := payload_sets.companion(together, *tables)) is not None:
        together = (*together, more)
    return together


def overlap_notes(analysis: Analysis, nodes: Sequence[Candidate]) -> tuple[Diagnostic, ...]:
    """SC423 where much is computed in both passes and another payload would save it."""
    work = analysis.shared_work
    parts = work.parts(nodes)
    if parts.overlap < _MUCH * parts.whole:
        return ()
    more = payload_sets.companion(nodes, analysis.groups, work)
    if more is None:
        return ()
    return (payload_sets.note_on_overlap(nodes, more, work, analysis.fragment),)
