"""All programs of a node, or of a set of nodes: which passes each algorithm has, and their files.

The table of algorithms here is the one place that knows them; an engine, and the harness, learns
from the manifest what to do.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from shadercache.analysis.candidates import Candidate
from shadercache.emit.assemble import Shader, interface
from shadercache.emit.builder import FragmentProgram, exact_original
from shadercache.emit.fragment import FragmentEmitter
from shadercache.emit.printer import print_module
from shadercache.emit.vertex import VertexEmitter
from shadercache.options import Options
from shadercache.sema.facts import Stage
from shadercache.transform.make_precise import make_precise
from shadercache.transform.opaque_arguments import hide_arguments
from shadercache.transform.state_precisions import with_precisions
from shadercache.transform.write_out_matrices import write_out_matrices

COLOR, CACHE, MASK = "color", "cache", "mask"
PREVIOUS, CURRENT = "previous-cache", "current-cache"
SECOND = "-2"
"""Ends what belongs to the second texture of a cache: a target, what is read."""


@dataclass(frozen=True, slots=True)
class Pass:
    """One draw of all objects: its files, targets, depth test and what it reads."""

    name: str
    file: str
    targets: tuple[str, ...]
    depth_test: str
    reads: tuple[str, ...]
    on_reset: bool
    uniforms: tuple[str, ...] = ()
    attributes: tuple[str, ...] = ()


@dataclass(slots=True)
class ProgramSet:
    """The files of all passes, the passes of each algorithm, and the algorithms that do not fit."""

    files: dict[str, str] = field(default_factory=dict)
    variants: dict[int, tuple[Pass, ...]] = field(default_factory=dict)
    original: Pass | None = None
    debug: Pass | None = None
    payload: Pass | None = None
    refused: dict[int, str] = field(default_factory=dict)
    previous: dict[str, str] = field(default_factory=dict)
    unchanging: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()
    prefix: str = ""
    color: str = ""
    whole: bool = False


_ORIGINAL = Pass("original", "original", (COLOR,), "less", (), True)
_PAYLOAD = Pass("payload-alone", "payload-alone", (COLOR,), "less", (), True)
_NEEDED = Pass("needed", "needed", (MASK,), "less", (), False)
_HIT_MASK = Pass("hit-mask", "hit-mask", (MASK,), "less", (PREVIOUS,), False)

_PASSES: dict[int, tuple[tuple[Pass, Callable[[FragmentEmitter], Shader]], ...]] = {
    1: (
        (
            Pass("shade", "1-pass", (COLOR, CACHE), "less", (PREVIOUS,), True),
            FragmentEmitter.one,
        ),
    ),
    2: (
        (
            Pass("hit", "2-pass.hit", (COLOR, CACHE), "less", (PREVIOUS,), False),
            FragmentEmitter.hit,
        ),
        (Pass("miss", "2-pass.miss", (COLOR, CACHE), "less", (), True), FragmentEmitter.miss),
    ),
    3: (
        (
            Pass("reuse", "3-pass.reuse", (CACHE,), "less", (PREVIOUS,), False),
            FragmentEmitter.reuse,
        ),
        (
            Pass("payload", "3-pass.payload", (CACHE,), "less", (), True),
            FragmentEmitter.payload_only,
        ),
        (
            # The visible surface has been drawn twice already: equal depth is the winner.
            Pass("shade", "3-pass.shade", (COLOR,), "lequal", (CURRENT,), True),
            FragmentEmitter.shade,
        ),
    ),
}


def emit_programs(
    program: FragmentProgram,
    vertex: VertexEmitter,
    nodes: Sequence[Candidate],
    options: Options,
    algorithms: tuple[int, ...],
) -> ProgramSet:
    """Every pass of the given algorithms for the nodes, with the original and the hit mask."""
    program.memo.trim()
    emitter = _emitter(program, nodes, options)
    made = ProgramSet(
        previous=vertex.previous_twins(),
        unchanging=vertex.unchanging(),
        numbers=vertex.numbers(),
        prefix=program.prefix,
        color=program.color,
    )
    about = ", ".join(f"node {node.id}" for node in nodes)
    write = _Writer(made, vertex, options, about)
    made.original = write.original(program)
    made.debug = write.add(_HIT_MASK, emitter.made(FragmentEmitter.hit_mask))
    made.payload = write.add(_PAYLOAD, emitter.made(FragmentEmitter.payload_alone))
    for number in algorithms:
        unfit = emitter.unfit(number)
        if unfit is not None:
            made.refused[number] = unfit
            continue
        made.variants[number] = tuple(
            write.add(item, emitter.made(build)) for item, build in _PASSES[number]
        )
    return made


def _emitter(
    program: FragmentProgram, nodes: Sequence[Candidate], options: Options
) -> FragmentEmitter:
    """Whoever wants one mode of a variant often wants the other next: only its printing differs."""
    kept: dict[object, FragmentEmitter] = program.memo.table("last emitter")
    key = (tuple(nodes), options.fetches, options.cache)
    if key not in kept:
        kept.clear()
        kept[key] = FragmentEmitter(program, nodes, options.fetches, options.cache)
    return kept[key]


def emit_original(program: FragmentProgram, vertex: VertexEmitter, options: Options) -> ProgramSet:
    """The user's shaders themselves, printed: what variants are compared with."""
    made = ProgramSet(prefix=program.prefix, color=program.color)
    write = _Writer(made, vertex, options, "unchanged")
    made.original = write.original(program)
    return made


def emit_needed(
    program: FragmentProgram,
    vertex: VertexEmitter,
    nodes: Sequence[Candidate],
    options: Options,
) -> ProgramSet:
    """The program that tells which pixels have payloads of the nodes, and which of them are fit."""
    emitter = _emitter(program, nodes, options)
    made = ProgramSet(prefix=program.prefix, color=program.color)
    write = _Writer(made, vertex, options, "what has its payloads")
    made.debug = write.add(_NEEDED, emitter.made(FragmentEmitter.needed))
    made.whole = emitter.whole
    return made


@dataclass(frozen=True, slots=True)
class _Writer:
    """Prints shaders into a program set."""

    made: ProgramSet
    vertex: VertexEmitter
    options: Options
    about: str

    def original(self, program: FragmentProgram) -> Pass:
        """The user's own shaders: word for word, or ready for proof mode."""
        if self.options.mode == "plain":
            return self._write(_ORIGINAL, interface(program.parsed), interface(self.vertex.parsed))
        return self.add(_ORIGINAL, exact_original(program))

    def add(self, item: Pass, fragment: Shader) -> Pass:
        """Print a pass and the vertex shader for it; return it with its interface filled in."""
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
        if self.options.mode == "proof":
            if stage == "fragment":
                module = hide_arguments(module, memo)
            module = write_out_matrices(module, self.vertex.prefix, stage, memo)
            module = make_precise(module, self.vertex.prefix, stage, memo)
        version, rest = print_module(module, memo).split("\n", 1)
        return f"{version}\n// shadercache: {item.file}, {self.about}\n{rest}"
