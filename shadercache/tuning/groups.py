"""The objects of a scene by the shaders that draw them: each group has a choice of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.compiler import Analysis
from shadercache.linking.linker import Linker
from shadercache.scene.description import Scene


@dataclass(frozen=True, eq=False)
class ShaderGroup:
    """Objects that may be cached, by name, and their shaders.

    ``number``: 0 is the scene's own shader. ``changes``: why inputs of theirs change, by name.
    """

    number: int
    fragment: Path
    objects: tuple[str, ...]
    analysis: Analysis
    changes: Mapping[str, str]

    @property
    def name(self) -> str:
        """The fragment shader's file name."""
        return self.fragment.name


Choices = Mapping[ShaderGroup, Configuration]
"""What is cached of which group; the originals draw the others."""


def groups_of(linker: Linker) -> tuple[ShaderGroup, ...]:
    """The groups that the scene lets be cached, that of its own shader first."""
    scene = linker.scene
    found: dict[tuple[Path, Path | None], list[str]] = {}
    first = (scene.common.fragment, scene.common.vertex)
    for part in scene.parts:
        shaders = (part.fragment, part.vertex) if part.own_shader else first
        if part.caching.allowed:
            found.setdefault(shaders, []).append(part.name)
    ordered = sorted(found.items(), key=lambda entry: entry[0] != first)
    return tuple(
        _group(linker, number, shaders[0], names) for number, (shaders, names) in enumerate(ordered)
    )


def _group(linker: Linker, number: int, fragment: Path, names: list[str]) -> ShaderGroup:
    scene: Scene = linker.scene
    part = next(part for part in scene.parts if part.name == names[0])
    changes = part.inputs.causes if part.own_shader else scene.changes
    return ShaderGroup(number, fragment, tuple(names), linker.analysis_of(part), changes)


def assignment_of(scene: Scene, choices: Choices) -> Assignment:
    """What draws each object of the scene."""
    chosen = {name: one for group, one in choices.items() for name in group.objects}
    return Assignment(tuple((part.name, chosen.get(part.name)) for part in scene.parts))
