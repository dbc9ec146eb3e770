"""A shader as it was analysed: what the command line, the harness and a rewrite ask about it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from shadercache.analysis.candidates import (
    Candidate,
    Candidates,
    varyings,
)
from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.costs.payload_sets import (
    check_needed,
    check_set,
    companion,
    note_on_overlap,
)
from shadercache.analysis.costs.shared_work import Parts, SharedWorkTable
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.input_reads import input_kinds
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.refusals import Code
from shadercache.analysis.stages import Links, StageSide, match_stages
from shadercache.analysis.use_def import Definitions
from shadercache.analysis.value_numbering import ValueGroup, number_values
from shadercache.ast import nodes as n
from shadercache.diagnostics import Diagnostic, InputError, UsageError, input_error, usage_error
from shadercache.emit.builder import FragmentProgram, PassBuilder
from shadercache.emit.printer import print_node
from shadercache.emit.runtime import full_screen_vertex
from shadercache.emit.side_passes import unneeded
from shadercache.emit.vertex import VertexEmitter
from shadercache.front.dialects import surrounded
from shadercache.front.read_options import ReadOptions
from shadercache.front.webgl import WEBGL, names_version
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import DependencyEntry
from shadercache.manifest.reflection import dependencies, inputs_of
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import infer
from shadercache.source import Source
from shadercache.transform.versions.raise_version import Raised

_UNROLLED = re.compile(r"\.\d+u-")
_INCLUDE = re.compile(r"#[ \t]*include\b")


MUCH = 0.1
"""Share of a shader in both passes from which on it is told."""


@dataclass(frozen=True)
class Analysis:
    """A fragment shader with all its nodes, and the vertex shader where one was given."""

    fragment: Source
    vertex: Source | None
    candidates: Candidates
    program: FragmentProgram
    raised: tuple[Raised, ...]
    vertex_module: n.Module | None
    links: Links
    """Which outputs of the vertex shader what the fragment shader reads comes from."""
    reading: ReadOptions
    kept_loops: tuple[Diagnostic, ...] = ()
    """Which loops were not unrolled, where that was asked for, and why."""
    vertex_facts: Facts | None = None

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
        prefix = self.program.prefix
        if self.vertex_module is not None:
            parsed = self.raised[1].module
            return VertexEmitter(
                *(parsed, self.vertex_module, prefix, self.program.memo, self.mapping, self.links)
            )
        if not self.full_screen:
            raise input_error(
                "SC402", "a vertex shader is needed to rewrite a shader", "give --vert"
            )
        source, module = full_screen_vertex(self.program.module)
        program = self.program
        match_stages(
            StageSide(program.module, program.facts, self.fragment),
            StageSide(module, infer(module, source, "vertex"), source),
        )
        return VertexEmitter(module, module, prefix, self.program.memo, self.mapping)

    @property
    def vertex_source(self) -> Source:
        """The vertex shader's text: the user's, or that of a full-screen pass."""
        return self.vertex or full_screen_vertex(self.program.module)[0]

    def unchanged_for(self, *nodes: Candidate) -> tuple[str, ...] | None:
        """While which uniforms, textures and attributes do not change is reuse of values exact?

        ``None`` where this cannot be said: with another mapping than ``screen`` a value is found
        between the texels of a cache.
        """
        if self.mapping != "screen":
            return None
        kinds = ("uniforms", "textures", "varyings")
        read = self._read(nodes)
        inputs = frozenset(name for name in read if self.input_kinds.get(name) in kinds)
        passed = inputs & varyings(self.program.module)
        if self.vertex is None:
            return tuple(sorted(inputs))
        return tuple(sorted((inputs - passed) | self.vertex_emitter.inputs(passed)))

    def dependencies(self, *nodes: Candidate) -> tuple[DependencyEntry, ...]:
        """What the engine sets that the values depend on, through varyings too."""
        read = self._read(nodes)
        passed = read & varyings(self.program.module)
        stages: dict[Stage, frozenset[str]] = {"fragment": read - passed}
        if self.vertex is not None:
            stages["vertex"] = self.vertex_emitter.sources(passed)
        return dependencies(stages, self.inputs)

    @staticmethod
    def _read(nodes: Sequence[Candidate]) -> frozenset[str]:
        return frozenset(name for node in nodes for name in node.inputs)

    @cached_property
    def inputs(self) -> tuple[InputEntry, ...]:
        """What an engine gives the user's shaders."""
        program = self.program
        stages: list[tuple[n.Module, Facts, Stage]] = []
        if self.vertex_module is not None and self.vertex_facts is not None:
            stages.append((self.vertex_module, self.vertex_facts, "vertex"))
        return inputs_of([*stages, (program.module, program.facts, "fragment")])

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """What became of the stages where they were of an older version, and of loops."""
        return (*(note for stage in self.raised for note in stage.notes), *self.kept_loops)

    @property
    def renamed(self) -> dict[str, str]:
        """What an engine knows by another name than the user's text has: old name to new."""
        return {old: new for stage in self.raised for old, new in stage.renamed.items()}

    @property
    def reads_fixed_function(self) -> bool:
        """Does it use attributes or state that only the compatibility profile has?"""
        return any(re.match(r"gl_(?!Frag(Color|Data))", name) for name in self.renamed)

    @property
    def written(self) -> str | None:
        """The user's own text as a driver can be given it: with what its host adds to it.

        ``None`` where it needs what is outside of it.
        """
        reading = self.reading
        texts = (self.fragment.text, self.vertex.text if self.vertex else "")
        if reading.defines or reading.undefined or any(_INCLUDE.search(text) for text in texts):
            return None
        text = surrounded(self.fragment, reading.dialect)
        webgl = self.program.parsed.profile == "es" and not names_version(text)
        return f"#version {WEBGL.number}\n{text}" if webgl else text

    @cached_property
    def groups(self) -> Mapping[Candidate, ValueGroup]:
        """Which nodes have the same value: the group of every node."""
        program = self.program
        return number_values(
            program.module, program.facts, EffectTable(program.module), self.candidates
        )

    def on_cpu(self, node: Candidate) -> str | None:
        """What to compute on the CPU in place of a value of uniforms only (SC303), as GLSL.

        ``None`` for any other value, and where it takes more than one expression.
        """
        if node.refusal is None or node.refusal.code is not Code.UNIFORM:
            return None
        assert node.instance is not None and node.place is not None
        found = self._definitions.closed(node.instance, node.place.step, node.expr)
        return None if found is None else print_node(found)

    @property
    def whole(self) -> float:
        """What the shader costs without what it does not need."""
        return self._overlaps.whole

    def parts(self, *nodes: Candidate) -> Parts:
        """What the payload pass and the shading pass cost where the nodes are cached together."""
        return self._overlaps.parts(nodes)

    def carrying(self, nodes: Sequence[Candidate]) -> tuple[Candidate, ...]:
        """The nodes, and what has to be cached along so that little is computed in both passes:
        as much as fits beside them."""
        found = tuple(nodes)
        while (more := companion(found, self.groups, self._overlaps)) is not None:
            found = (*found, more)
        return found

    def overlap_notes(self, nodes: Sequence[Candidate]) -> tuple[Diagnostic, ...]:
        """SC423 where much is computed in both passes and another payload would save it."""
        parts = self.parts(*nodes)
        if parts.overlap < MUCH * parts.whole:
            return ()
        more = companion(nodes, self.groups, self._overlaps)
        if more is None:
            return ()
        return (note_on_overlap(nodes, more, self._overlaps, self.fragment),)

    @cached_property
    def input_kinds(self) -> dict[str, str]:
        """What the inputs of nodes are, by their names: see :mod:`analysis.input_reads`."""
        return input_kinds(self.program.module, self.program.facts)

    @cached_property
    def _definitions(self) -> Definitions:
        program = self.program
        return Definitions(program.facts, EffectTable(program.module), self.candidates.instances)

    @cached_property
    def _overlaps(self) -> SharedWorkTable:
        program = self.program
        costs, table = CostTable(program.facts), EffectTable(program.module)
        return SharedWorkTable(self.candidates.instances, table, costs, program.color)

    @cached_property
    def _by_id(self) -> dict[str, Candidate]:
        return {node.id: node for node in self.nodes}

    def node(self, node_id: str) -> Candidate:
        """The node with this id. Raises :class:`UsageError` SC010 or SC011 if there is none."""
        found = self._by_id.get(node_id)
        if found is not None:
            return found
        unroll = " --unroll" if self.reading.unroll else ""
        hint = f"'shadercache nodes {self.fragment.name}{unroll}' lists the nodes"
        if not unroll and _UNROLLED.search(node_id):
            hint = "it is of the shader with its loops unrolled: add --unroll"
        stem = node_id.rpartition("-")[0]
        if any(node.id.rpartition("-")[0] == stem for node in self.nodes):
            message = (
                f"node '{node_id}' is not from this source of {self.fragment.name}: "
                "a function on its call path has changed since"
            )
            raise UsageError(Diagnostic("SC011", message, hint=hint))
        message = f"{self.fragment.name} has no node '{node_id}'"
        raise UsageError(Diagnostic("SC010", message, hint=hint))

    def nodes_of(self, ids: str) -> tuple[Candidate, ...]:
        """The nodes with these ids, joined by ``+``; one id is a set of one. Raises as ``node``."""
        parts = ids.split("+")
        if len(parts) > 1 and "" in parts:
            raise usage_error("SC010", f"'{ids}' lacks an id beside a '+'")
        return tuple(self.node(node_id) for node_id in parts)

    def require(self, node: Candidate, unprofitable: bool = False) -> None:
        """Raise :class:`InputError` with the refusal's code if the node may not be cached.

        ``unprofitable`` lets nodes pass that are refused only as cheaper than a fetch.
        """
        refusal = node.refusal
        if refusal is None or (refusal.unprofitable and unprofitable):
            return
        hint = "caching it anyway takes --unprofitable" if refusal.unprofitable else None
        if refusal.code is Code.LOOP and not self.reading.unroll:
            hint = "with --unroll, loops of few trips are taken apart"
        message = f"'{node.text}' {refusal.sentence}"
        raise InputError(
            Diagnostic(refusal.code.code, message, self.fragment, node.expr.span, hint)
        )

    def require_all(self, nodes: Sequence[Candidate], unprofitable: bool = False) -> None:
        """As :meth:`require` for each node; SC415 to SC417 where they do not go together."""
        for node in nodes:
            self.require(node, unprofitable)
        if len(nodes) > 1:
            check_set(nodes, self.groups, self.fragment)
            check_needed(unneeded(PassBuilder(self.program, nodes)), self.fragment)
