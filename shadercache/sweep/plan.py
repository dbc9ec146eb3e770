"""The plan of a sweep: its trials, in the order in which they are carried out.

A trial draws configurations of one payload in turns with the original; each becomes a row.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.value_numbering import one_of_each
from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import usage_error
from shadercache.front.read_options import ReadOptions
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.source import as_text
from shadercache.sweep.choices import Choices
from shadercache.sweep.fingerprint import scene_fingerprint, short_hash
from shadercache.sweep.row import Machine, PayloadEntry, SceneEntry, words

IN_TURNS = 6
"""Configurations that one trial draws in turns; a kill loses no more than these."""


@dataclass(frozen=True, slots=True)
class SceneFile:
    """A scene file or a shader that has none, and how its shaders are read.

    ``made``: the scene file that was made for a shader, which is drawn; the shader is what counts.
    """

    path: Path
    reading: ReadOptions
    mapping: MappingKind | None = None
    made: Path | None = None

    @property
    def options(self) -> Iterator[str]:
        """How it is read, as the command line says it."""
        yield from self.reading.words
        if self.mapping is not None:
            yield from ("--mapping", self.mapping)

    def open(self) -> Linker:
        """Raises as :func:`open_scene`."""
        return Linker(*open_scene(self.made or self.path, self.reading, self.mapping))


@dataclass(frozen=True, slots=True)
class Limits:
    """How long a trial goes on: ``StopRule`` says what the first two are. ``perceptual``: also the
    metrics of ``measure.metrics``, by drawing the fixed frames once more; ``profile``: where the
    frames of two passes go, by as much timing again."""

    half_width: float
    seconds: float
    perceptual: bool = False
    profile: bool = False


@dataclass(frozen=True, slots=True)
class SweepTrial:
    """Configurations of one payload, drawn in turns.

    ``fingerprint`` names the scene's content; ``machine`` is known once there is a worker.
    """

    file: SceneFile
    scene: SceneEntry
    payload: PayloadEntry
    configurations: tuple[Configuration, ...]
    limits: Limits
    fingerprint: str
    machine: Machine | None = None

    def key(self, configuration: Configuration) -> str:
        """All that determines a row: content of all files, configuration, machine, version."""
        return short_hash([self.fingerprint, self.identity(configuration)])

    def identity(self, configuration: Configuration) -> str:
        """What was asked for, whatever the files hold."""
        scene, machine = self.scene, self.machine
        assert machine is not None
        where = [machine.renderer, machine.driver, machine.clock, machine.processor, machine.cores]
        # Named by its last two parts: a store may be filled from any folder.
        named = [*self.file.path.resolve().parts[-2:], *scene.options]
        # Without how long is timed: rows that differ in that alone differ in times alone.
        what = [named, list(scene.size), scene.frames, self.limits.perceptual, self.payload.label]
        what += ["profile"] if self.limits.profile else []  # rows without it keep their keys
        return short_hash([what, configuration.to_json(), where])

    def words(self, configuration: Configuration) -> Mapping[str, str]:
        """What ``--where`` asks about."""
        return words(self.scene.name, self.payload.label, configuration.to_json())

    def only(self, wanted: Callable[[SweepTrial, Configuration], bool]) -> SweepTrial:
        """The trial with those of its configurations that are wanted."""
        chosen = tuple(one for one in self.configurations if wanted(self, one))
        return replace(self, configurations=chosen)


def plan_scene(file: SceneFile, choices: Choices) -> list[SweepTrial]:
    """All trials of one scene.

    Raises:
        InputError, UsageError: as :func:`open_scene`; SC010 to SC012 for an id that is not that of
            one node; SC028 for a setting; SC027 where nothing can be cached.
    """
    linker = file.open()
    scene, analysis = linker.scene, linker.analysis
    entry = SceneEntry(
        scene.name,
        as_text(str(file.path)),
        choices.size,
        choices.frames,
        analysis.mapping,
        tuple(file.options),
    )
    several = sum(part.caching.on for part in scene.objects) > 1
    fingerprint = scene_fingerprint(linker)
    limits = Limits(choices.until / 100.0, choices.seconds, choices.perceptual, choices.profile)
    trials = []
    for payload in _payloads(linker, choices):
        every = list(choices.configurations(payload.ids, several))
        for start in range(0, len(every), IN_TURNS):
            turns = tuple(every[start : start + IN_TURNS])
            trials.append(SweepTrial(file, entry, payload, turns, limits, fingerprint))
    if not trials:
        raise usage_error("SC027", f"{file.path}: no node is offered, so there is nothing to sweep")
    return trials


def _payloads(linker: Linker, choices: Choices) -> Iterable[PayloadEntry]:
    analysis, names = linker.analysis, linker.scene.nodes
    if choices.nodes:
        for label in choices.nodes:
            yield _entry(linker, label, analysis.nodes_of(label, names), 1)
        return
    offered = [node for node in analysis.nodes if node.offered]
    counts = dict.fromkeys(offered, 1)
    if not choices.every_node:
        counts = one_of_each(offered, analysis.groups)
    labels = {node_id: name for name, node_id in names.items()}
    for node, equal in counts.items():
        yield _entry(linker, labels.get(node.id, node.id), (node,), equal)


def _entry(linker: Linker, label: str, nodes: Sequence[Candidate], equal: int) -> PayloadEntry:
    source = linker.analysis.fragment
    spans = [node.expr.span for node in nodes]
    # What stands in an included file has no place in the shader's own.
    own = [span for span in spans if span.start >= 0 and source.part(span.start) is source]
    return PayloadEntry(
        label,
        ids=tuple(node.id for node in nodes),
        path=" + ".join(dict.fromkeys(node.path for node in nodes)),
        text=" + ".join(node.text for node in nodes),
        type=" + ".join(node.type.name for node in nodes),
        places=tuple((*source.position(span.start), *source.position(span.end)) for span in own),
        static_ratio=sum(node.ratio for node in nodes),
        equal=equal,
    )
