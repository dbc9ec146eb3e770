"""All programs of a node, or of a set of nodes: the passes of each algorithm, and their files.

An engine, and the harness, learns from the manifest what to do.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import (
    CACHE,
    COLOR,
    CURRENT,
    MASK,
    PREVIOUS,
    Algorithm,
    AlgorithmPass,
    Drawn,
    algorithm,
)
from shadercache.caching.configuration import Configuration, Mode
from shadercache.caching.settings import written_settings
from shadercache.emit.assemble import Shader, interface
from shadercache.emit.builder import FragmentProgram, exact_original
from shadercache.emit.fragment import FragmentEmitter, function_named
from shadercache.emit.full_screen import full_screen_vertex
from shadercache.emit.printer import print_module
from shadercache.emit.vertex import VertexEmitter
from shadercache.sema.facts import Stage
from shadercache.transform.proof.make_precise import make_precise
from shadercache.transform.proof.opaque_arguments import make_arguments_opaque
from shadercache.transform.proof.opaque_varyings import hide_uniform_varyings
from shadercache.transform.proof.write_out_matrices import write_out_matrices
from shadercache.transform.versions.state_precisions import with_precisions

SECOND = "-2"
"""Ends what belongs to the second texture of a cache: a target, what is read."""


@dataclass(frozen=True, slots=True)
class Pass:
    """One draw, of all objects or of the screen: its files, targets, depth and what it reads."""

    name: str
    file: str
    targets: tuple[str, ...]
    reads: tuple[str, ...] = ()
    on_reset: bool = True
    depth_test: Literal["less", "lequal"] = "less"
    depth_write: bool = True
    draws: Drawn = "objects"
    uniforms: tuple[str, ...] = ()
    attributes: tuple[str, ...] = ()


@dataclass(slots=True)
class ProgramSet:
    """The files of all passes, the passes of each algorithm, and the algorithms that do not fit."""

    files: dict[str, str] = field(default_factory=dict)
    variants: dict[str, tuple[Pass, ...]] = field(default_factory=dict)
    original: Pass | None = None
    debug: Pass | None = None
    payload: Pass | None = None
    refused: dict[str, str] = field(default_factory=dict)
    previous: dict[str, str] = field(default_factory=dict)
    unchanging: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()
    prefix: str = ""
    color: str = ""
    whole: bool = False


_ORIGINAL = Pass("original", "original", (COLOR,))
_PAYLOAD = Pass("payload-alone", "payload-alone", (COLOR,))
_NEEDED = Pass("needed", "needed", (MASK,), on_reset=False)
_HIT_MASK = Pass("hit-mask", "hit-mask", (MASK,), (PREVIOUS,), on_reset=False)


def emit_programs(
    program: FragmentProgram,
    vertex: VertexEmitter,
    nodes: Sequence[Candidate],
    configurations: Sequence[Configuration],
) -> ProgramSet:
    """Every pass of the nodes by some configurations that differ in their algorithms, with the
    original and the hit mask."""
    program.memo.trim()
    emitter = _emitter(program, nodes, configurations[0])
    made = ProgramSet(
        previous=vertex.previous_twins(),
        unchanging=vertex.unchanging(),
        numbers=vertex.numbers(),
        prefix=program.prefix,
        color=program.color,
    )
    about = ", ".join(f"node {node.id}" for node in nodes)
    write = _ProgramWriter(made, vertex, configurations[0].mode, about)
    made.original = write.original(program)
    made.debug = write.add(_HIT_MASK, emitter.made(FragmentEmitter.hit_mask))
    made.payload = write.add(_PAYLOAD, emitter.made(FragmentEmitter.payload_alone))
    for configuration in configurations:
        record = algorithm(configuration.algorithm)
        unfit = emitter.unfit(record)
        if unfit is not None:
            made.refused[record.name] = unfit
            continue
        made.variants[record.name] = tuple(
            write.add(_pass(record, item), emitter.made(function_named(item.maker)))
            for item in record.passes
        )
    return made


def _pass(record: Algorithm, item: AlgorithmPass) -> Pass:
    return Pass(
        item.name,
        record.file_of(item),
        item.targets,
        item.reads,
        item.on_reset,
        item.depth_test,
        item.depth_write,
        item.draws,
    )


def _emitter(
    program: FragmentProgram, nodes: Sequence[Candidate], configuration: Configuration
) -> FragmentEmitter:
    """Whoever wants one mode of a variant often wants the other next: only its printing differs."""
    kept: dict[object, FragmentEmitter] = program.memo.table("last emitter")
    settings = tuple(written_settings(configuration).items())
    key = (tuple(nodes), configuration.fetches, settings)
    if key not in kept:
        kept.clear()
        kept[key] = FragmentEmitter(program, nodes, configuration)
    return kept[key]


def emit_original(program: FragmentProgram, vertex: VertexEmitter, mode: Mode) -> ProgramSet:
    """The user's shaders themselves, printed: what variants are compared with."""
    made = ProgramSet(prefix=program.prefix, color=program.color)
    write = _ProgramWriter(made, vertex, mode, "unchanged")
    made.original = write.original(program)
    return made


def emit_needed(
    program: FragmentProgram,
    vertex: VertexEmitter,
    nodes: Sequence[Candidate],
    configuration: Configuration,
) -> ProgramSet:
    """The program that tells which pixels have payloads of the nodes, and which of them are fit."""
    emitter = _emitter(program, nodes, configuration)
    made = ProgramSet(prefix=program.prefix, color=program.color)
    write = _ProgramWriter(made, vertex, configuration.mode, "what has its payloads")
    made.debug = write.add(_NEEDED, emitter.made(FragmentEmitter.needed))
    made.whole = emitter.whole
    return made


@dataclass(frozen=True, slots=True)
class _ProgramWriter:
    """Prints shaders into a program set."""

    made: ProgramSet
    vertex: VertexEmitter
    mode: Mode
    about: str

    def original(self, program: FragmentProgram) -> Pass:
        """The user's own shaders: word for word, or ready for proof mode."""
        if self.mode == "plain":
            return self._write(_ORIGINAL, interface(program.parsed), interface(self.vertex.parsed))
        return self.add(_ORIGINAL, exact_original(program))

    def add(self, item: Pass, fragment: Shader) -> Pass:
        """Print a pass and the vertex shader for it; return it with its interface filled in."""
        if item.draws == "screen":
            _, module = full_screen_vertex(fragment.module)
            return self._write(item, fragment, interface(module))
        return self._write(item, fragment, self.vertex.for_fragment(fragment))

    def _write(self, item: Pass, fragment: Shader, vertex: Shader) -> Pass:
        self.made.files[f"{item.file}.frag"] = self._text(item, fragment, "fragment")
        self.made.files[f"{item.file}.vert"] = self._text(item, vertex, "vertex")
        uniforms = tuple(dict.fromkeys((*vertex.uniforms, *fragment.uniforms)))
        return replace(
            item,
            targets=self._with_second(item.targets, fragment.outputs, {CACHE: "store"}),
            reads=self._with_second(item.reads, uniforms, {PREVIOUS: "cache", CURRENT: "payloads"}),
            uniforms=uniforms,
            attributes=vertex.inputs,
        )

    def _with_second(
        self, listed: tuple[str, ...], declared: tuple[str, ...], names: dict[str, str]
    ) -> tuple[str, ...]:
        """What a pass writes or reads, with the second texture where the shader declares it."""
        prefix = self.made.prefix
        more = (w + SECOND for w in listed if w in names and f"{prefix}{names[w]}_2" in declared)
        return (*listed, *more)

    def _text(self, item: Pass, shader: Shader, stage: Stage) -> str:
        memo = self.vertex.memo
        module = with_precisions(shader.module, memo)
        if self.mode == "proof":
            if stage == "fragment":
                module = make_arguments_opaque(module, memo)
            else:
                module = hide_uniform_varyings(module, self.vertex.prefix, memo)
            module = write_out_matrices(module, self.vertex.prefix, stage, memo)
            module = make_precise(module, self.vertex.prefix, stage, memo)
        version, rest = print_module(module, memo).split("\n", 1)
        return f"{version}\n// shadercache: {item.file}, {self.about}\n{rest}"
