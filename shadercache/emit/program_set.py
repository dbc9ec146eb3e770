"""All programs of a node, or of a set of nodes: the passes of each algorithm, and their files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.outputs import MOST_TARGETS, Output, targets_of
from shadercache.caching import algorithms
from shadercache.caching.algorithms import AlgorithmPass, LeftOut
from shadercache.caching.configuration import Configuration, Mode
from shadercache.emit.assemble import Shader, interface
from shadercache.emit.builder import (
    FragmentProgram,
    PassBuilder,
    exact_original,
    function_named,
    unfit,
)
from shadercache.emit.parking import parked_formats
from shadercache.emit.printer import print_module
from shadercache.emit.runtime import full_screen_vertex, group_vertex
from shadercache.emit.vertex import LastFrame, VertexEmitter
from shadercache.emit.vulkan import VulkanPlaces, vulkan_form
from shadercache.sema.facts import Stage
from shadercache.transform.proof.make_precise import make_precise
from shadercache.transform.proof.opaque_arguments import make_arguments_opaque
from shadercache.transform.proof.opaque_varyings import hide_uniform_varyings
from shadercache.transform.proof.rewrite_do_loops import rewrite_do_loops
from shadercache.transform.proof.write_out_matrices import write_out_matrices
from shadercache.transform.versions.state_precisions import with_precisions

_SECOND = "-2"
"""Ends what belongs to the second texture of a cache: a target, what is read."""


@dataclass(frozen=True, slots=True)
class Pass:
    """A pass as it was emitted: what its record says, the name of its files, and its interface.

    ``targets`` and ``reads`` are the record's, with the second textures that the shader has, and
    as many for what is parked; ``parked`` are the formats of these, where it writes them.
    """

    record: AlgorithmPass
    file: str
    targets: tuple[str, ...]
    reads: tuple[str, ...]
    uniforms: tuple[str, ...]
    attributes: tuple[str, ...]
    parked: tuple[str, ...] = ()


@dataclass(slots=True)
class ProgramSet:
    """The files of all passes, the passes of each algorithm, and the algorithms that do not fit."""

    files: dict[str, str] = field(default_factory=dict)
    variants: dict[str, tuple[Pass, ...]] = field(default_factory=dict)
    original: Pass | None = None
    debug: Pass | None = None
    payload: Pass | None = None
    refused: dict[str, str] = field(default_factory=dict)
    last_frame: LastFrame = field(default_factory=LastFrame)
    prefix: str = ""
    outputs: tuple[Output, ...] = ()
    whole: bool = False
    vulkan: VulkanPlaces | None = None

    @property
    def passes(self) -> list[Pass]:
        """All that there are."""
        variants = [emitted for passes in self.variants.values() for emitted in passes]
        beside = (self.original, self.debug, self.payload)
        return [*variants, *(emitted for emitted in beside if emitted is not None)]


NO_RATE = (
    "no pass of it computes payloads alone, so that they could be computed for a fraction of the "
    "pixels"
)
"""Why an algorithm cannot compute payloads at a fraction of the rate."""

# Not part of any algorithm; what is drawn with objects as the passes of one are.
_ORIGINAL = AlgorithmPass("original", "", (algorithms.COLOR,))
_PAYLOAD = AlgorithmPass("payload-alone", "side_passes:payload_alone", (algorithms.COLOR,))
_NEEDED = AlgorithmPass("needed", "side_passes:needed", (algorithms.MASK,), on_reset=False)
_HIT_MASK = AlgorithmPass(
    "hit-mask", "side_passes:hit_mask", (algorithms.MASK,), (algorithms.PREVIOUS,), on_reset=False
)


def emit_programs(
    program: FragmentProgram,
    vertex: VertexEmitter,
    nodes: Sequence[Candidate],
    configurations: Sequence[Configuration],
    left_out: LeftOut | None = None,
) -> ProgramSet:
    """Every pass of the nodes by some configurations that differ in their algorithms, with the
    original and the hit mask. ``left_out``: what two passes do without."""
    program.memo.trim()
    builder = _builder(program, nodes, configurations[0])
    programs = ProgramSet(
        last_frame=vertex.last_frame(),
        vulkan=vertex.vulkan,
        prefix=program.prefix,
        outputs=program.outputs,
    )
    about = ", ".join(f"node {node.id}" for node in nodes)
    write = _ProgramWriter(programs, vertex, configurations[0].mode, about)
    programs.original = write.original(program)
    programs.debug = write.add(_HIT_MASK, builder)
    programs.payload = write.add(_PAYLOAD, builder)
    for configuration in configurations:
        algorithm = algorithms.algorithm(configuration.algorithm)
        if left_out is not None:
            algorithm = algorithms.without(left_out)
        reason = unfit(builder, algorithm)
        if configuration.payload_rate != "full":
            slower = algorithm.at_fraction()
            reason = (reason or _unfit_at_fraction(nodes)) if slower else NO_RATE
            algorithm = slower or algorithm
        if reason is not None:
            programs.refused[algorithm.name] = reason
            continue
        programs.variants[algorithm.name] = tuple(
            write.add(record, builder, algorithm.file_of(record)) for record in algorithm.passes
        )
    return programs


def _unfit_at_fraction(nodes: Sequence[Candidate]) -> str | None:
    """Why payloads cannot be computed for a fraction of the pixels, if so."""
    if any(node.on_screen for node in nodes):
        return (
            "the value depends on how large a surface is seen or where, which a smaller picture "
            "shows otherwise"
        )
    return None


def _builder(
    program: FragmentProgram, nodes: Sequence[Candidate], configuration: Configuration
) -> PassBuilder:
    # Whoever wants one mode of a variant often wants the other next: only its printing differs.
    kept: dict[object, PassBuilder] = program.memo.table("last builder")
    key = (tuple(nodes), configuration.fetches, configuration.look_up)
    if key not in kept:
        kept.clear()
        kept[key] = PassBuilder(program, nodes, configuration)
    return kept[key]


def emit_original(program: FragmentProgram, vertex: VertexEmitter, mode: Mode) -> ProgramSet:
    """The user's shaders themselves, printed: what variants are compared with."""
    programs = ProgramSet(prefix=program.prefix, outputs=program.outputs)
    programs.original = _ProgramWriter(programs, vertex, mode, "unchanged").original(program)
    return programs


def emit_needed(
    program: FragmentProgram,
    vertex: VertexEmitter,
    nodes: Sequence[Candidate],
    configuration: Configuration,
) -> ProgramSet:
    """The program that tells which pixels have payloads of the nodes, and which of them are fit."""
    builder = _builder(program, nodes, configuration)
    programs = ProgramSet(prefix=program.prefix, outputs=program.outputs, whole=builder.whole)
    write = _ProgramWriter(programs, vertex, configuration.mode, "what has its payloads")
    programs.debug = write.add(_NEEDED, builder)
    return programs


def color_targets(count: int) -> tuple[str, ...]:
    """The names of the targets of the user's outputs, location by location."""
    return (algorithms.COLOR, *(f"{algorithms.COLOR}-{at}" for at in range(2, count + 1)))


@dataclass(frozen=True, slots=True)
class _ProgramWriter:
    """Prints shaders into a program set; ``about`` is the comment at their head."""

    programs: ProgramSet
    vertex: VertexEmitter
    mode: Mode
    about: str

    def original(self, program: FragmentProgram) -> Pass:
        """The user's own shaders: word for word, or ready for proof mode."""
        if self.mode == "plain":
            shaders = interface(program.parsed), interface(self.vertex.parsed)
        else:
            # What is compared to the bit is rewritten alike: the programs differ by the cut alone.
            fragment = exact_original(program)
            shaders = fragment, self.vertex.for_fragment(fragment)
        return self._write(_ORIGINAL, _ORIGINAL.name, *shaders)

    def add(self, record: AlgorithmPass, builder: PassBuilder, file: str | None = None) -> Pass:
        """Make a pass, with the vertex shader for it, and print both."""
        fragment = builder.made(function_named(record.maker))
        prefix = self.programs.prefix
        if record.draws == "screen":
            vertex = interface(full_screen_vertex(fragment.module, prefix)[1])
        elif record.draws == "groups":
            vertex = interface(group_vertex(fragment.module, prefix)[1])
        else:
            vertex = self.vertex.for_fragment(fragment)
        return self._write(record, file or record.name, fragment, vertex)

    def _write(self, record: AlgorithmPass, file: str, fragment: Shader, vertex: Shader) -> Pass:
        self.programs.files[f"{file}.frag"] = self._text(file, fragment, "fragment")
        self.programs.files[f"{file}.vert"] = self._text(file, vertex, "vertex")
        # Both stages may declare a uniform.
        uniforms = tuple(dict.fromkeys((*vertex.uniforms, *fragment.uniforms)))
        stores = {algorithms.CACHE: "store", algorithms.PARKED: "park"}
        read = {
            algorithms.PREVIOUS: "cache",
            algorithms.CURRENT: "payloads",
            algorithms.PARKED: algorithms.PARKED,
        }
        return Pass(
            record,
            file,
            self._each(self._targets(record, fragment), fragment.outputs, stores),
            self._each(self._reads(record, uniforms), uniforms, read),
            uniforms,
            vertex.inputs,
            parked_formats(fragment.module, f"{self.programs.prefix}park_"),
        )

    def _targets(self, record: AlgorithmPass, fragment: Shader) -> tuple[str, ...]:
        """What a pass writes: of colours as many as the user's outputs take, if it writes these."""
        own = f"{self.programs.prefix}value" in fragment.outputs
        colors = color_targets(1 if own else targets_of(self.programs.outputs))
        written = (colors if word == algorithms.COLOR else (word,) for word in record.targets)
        return tuple(word for words in written for word in words)

    def _reads(self, record: AlgorithmPass, uniforms: tuple[str, ...]) -> tuple[str, ...]:
        """What a pass reads: with adaptive periods one that computes compares with what was."""
        looks = (
            f"{self.programs.prefix}cache" in uniforms and algorithms.PREVIOUS not in record.reads
        )
        return (algorithms.PREVIOUS, *record.reads) if looks else record.reads

    def _each(
        self, listed: tuple[str, ...], declared: tuple[str, ...], names: dict[str, str]
    ) -> tuple[str, ...]:
        """What a pass writes or reads: second textures where the shader declares them, and of what
        is parked as many as it declares."""
        each: list[str] = []
        for word in listed:
            stem = f"{self.programs.prefix}{names.get(word, word)}"
            numbers = [at for at in range(1, MOST_TARGETS) if f"{stem}_{at}" in declared]
            if word == algorithms.PARKED:
                each += [f"{word}-{at}" for at in numbers]
            else:
                each += [word, *[word + _SECOND] * (word in names and 2 in numbers)]
        return tuple(each)

    def _text(self, file: str, shader: Shader, stage: Stage) -> str:
        memo, prefix = self.vertex.memo, self.vertex.prefix
        module = with_precisions(shader.module, memo)
        # The order counts: what hides a zero of a matrix is arithmetic on it, to be written out,
        # and what is written out has to be precise.
        if self.mode == "proof":
            module = rewrite_do_loops(module, prefix)
            if stage == "fragment":
                module = make_arguments_opaque(module, memo)
            else:
                module = hide_uniform_varyings(module, prefix, memo)
            module = write_out_matrices(module, prefix, stage, memo)
            module = make_precise(module, prefix, stage, memo)
        if self.vertex.vulkan is not None:
            module = vulkan_form(module, prefix, self.vertex.vulkan)
        # In GLSL ES 3.00 `#version` is the very first line (section 3.3): the comment comes second.
        version, rest = print_module(module, memo).split("\n", 1)
        return f"{version}\n// shadercache: {file}, {self.about}\n{rest}"
