"""The shaders of a tuning's page: the user's own, and what is emitted for each family."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from shadercache.analysed import Analysis
from shadercache.caching.algorithms import algorithm
from shadercache.caching.configuration import Assignment, Configuration
from shadercache.diagnostics import DiagnosticError
from shadercache.linking.linker import Linker
from shadercache.report.parts.page_words import settings_in_words
from shadercache.scene.description import Scene, SceneObject


@dataclass(frozen=True)
class FamilyTexts:
    """What is emitted for a family, by file name, and the command line that writes it.

    ``instead``: the algorithm that draws it where it has no variant by its own; none is the
    original.
    """

    files: Mapping[str, str]
    command: str
    instead: str | None = None


@dataclass(frozen=True)
class TunedTexts:
    """The shaders of each group by file name, the fragment shader first, and the texts of each
    family; ``scene``: what the command line calls it, with how its shaders are read."""

    groups: tuple[Mapping[str, str], ...]
    families: tuple[FamilyTexts, ...]
    scene: tuple[str, ...] = ()


def texts_of(found: Mapping[str, Any], linker: Linker) -> TunedTexts:
    """The texts of what tuning ``found``. Raises as ``Linker.link``."""
    scene = linker.scene
    parts = [_part(scene, group["objects"]) for group in found["groups"]]
    groups = tuple(_own(linker.analysis_of(part)) for part in parts)
    families = tuple(
        _family(linker, parts[family["group"]], assignment)
        for family, assignment in zip(found["families"], assignments(found, scene), strict=True)
    )
    words = (scene_in_words(scene), *linker.analysis.reading.words)
    return TunedTexts(groups, families, words)


def assignments(found: Mapping[str, Any], scene: Scene) -> Iterator[Assignment]:
    """What draws the objects with each family, the period of which is any."""
    for family in found["families"]:
        chosen = Configuration.from_json(family["configuration"])
        objects = found["groups"][family["group"]]["objects"]
        yield Assignment(
            tuple((part.name, chosen if part.name in objects else None) for part in scene.parts)
        )


def scene_in_words(scene: Scene) -> str:
    """What the command line calls a scene: its name where it is one of the corpus, or its path."""
    from shadercache.paths import data_path

    own = data_path("corpus", scene.name, "scene.toml")
    return scene.name if scene.path == own else _shown(scene.path)


def rewrite_command(part: SceneObject, analysis: Analysis, chosen: Configuration) -> str:
    """The command line that writes the shaders of a configuration of an object's shader."""
    words = ["shadercache", "rewrite", _shown(part.fragment)]
    if part.vertex is not None and part.vertex != part.fragment.with_suffix(".vert"):
        words += ["--vert", _shown(part.vertex)]
    if analysis.full_screen:
        words += ["--mapping", analysis.mapping]
    words += analysis.reading.words
    for name in chosen.nodes:
        words += ["--node", name]
    words += ["--passes", algorithm(chosen.algorithm).word]
    words += ["--rate", chosen.payload_rate] if chosen.divisor > 1 else []
    words += _if_other("--format", chosen.storage.format, Configuration().storage.format)
    words += _if_other("--fetches", chosen.fetches, Configuration().fetches)
    own = ("format=", "rate=")
    settings = [word for word in settings_in_words(chosen) if not word.startswith(own)]
    words += ["--cache", ",".join(settings)] if settings else []
    words += ["--unprofitable"] if _is_cheap(analysis, chosen) else []
    return shlex.join([*words, "-o", "cached"])


def _if_other(option: str, word: str, usual: str) -> list[str]:
    return [] if word == usual else [option, word]


def _is_cheap(analysis: Analysis, chosen: Configuration) -> bool:
    """Is it refused unless asked for, since a look-up may cost more?"""
    nodes = tuple(found for name in chosen.nodes for found in analysis.nodes_of(name))
    try:
        analysis.require_all(nodes)
    except DiagnosticError:
        return True
    return False


def _family(linker: Linker, part: SceneObject, assignment: Assignment) -> FamilyTexts:
    # Only this object's: what another one is drawn by is no part of the family.
    place = [name for name, _ in assignment.objects].index(part.name)
    wanted, linked = assignment.objects[place][1], linker.link(assignment)[place]
    chosen, bundle = linked.configuration, linked.bundle
    assert wanted is not None
    passes = (bundle.original,) if chosen is None else bundle.passes(chosen.algorithm)
    files = {one.name: one.text for spec in passes for one in (spec.fragment, spec.vertex)}
    if chosen is None:
        return FamilyTexts(files, "", "original")
    instead = None if chosen.algorithm == wanted.algorithm else chosen.algorithm
    command = rewrite_command(part, linker.analysis_of(part), chosen)
    return FamilyTexts(files, command, instead)


def _own(analysis: Analysis) -> dict[str, str]:
    sources = [source for source in (analysis.fragment, analysis.vertex) if source is not None]
    return {Path(source.name).name: source.text for source in sources}


def _part(scene: Scene, names: list[str]) -> SceneObject:
    """The first object of a group, with the shaders that draw it."""
    part = next(part for part in scene.parts if part.name in names)
    if part.own_shader:
        return part
    return replace(part, fragment=scene.common.fragment, vertex=scene.common.vertex)


def _shown(path: Path) -> str:
    """A path as somebody would type it who works in this folder."""
    try:
        return str(path.resolve().relative_to(Path.cwd()))
    except ValueError:
        return str(path)
