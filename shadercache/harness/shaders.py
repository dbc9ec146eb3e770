"""The shaders of a scene, read and analysed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

from shadercache.compiler import Analysis, analyse
from shadercache.front.options import ReadOptions
from shadercache.harness.scene import Scene
from shadercache.source import Source

T = TypeVar("T")


def analyse_scene(scene: Scene, reading: ReadOptions | None = None) -> tuple[Scene, Analysis]:
    """The scene and what the compiler makes of its shaders.

    Where shaders of an older version are raised some attributes, uniforms and textures get new
    names: the scene has what it gives under these as well. Raises as :func:`compiler.analyse`.
    """
    reading = reading or ReadOptions()
    reading = replace(reading, unroll=reading.unroll or scene.unroll)
    analysis = analyse(*read_shaders(scene), reading)
    return with_aliases(scene, analysis.renamed), analysis


def read_shaders(scene: Scene) -> tuple[Source, Source]:
    """The scene's fragment and vertex shader."""
    return (
        Source(str(scene.fragment), scene.fragment.read_text(encoding="utf-8")),
        Source(str(scene.vertex), scene.vertex.read_text(encoding="utf-8")),
    )


def with_aliases(scene: Scene, renamed: Mapping[str, str]) -> Scene:
    """The scene with everything named ``old``, ``old[0]`` or ``old.member`` also under its new
    name."""

    def aliased(values: Mapping[str, T]) -> dict[str, T]:
        made = dict(values)
        for name, value in values.items():
            root = name.partition("[")[0].partition(".")[0]
            if root in renamed:
                made[renamed[root] + name[len(root) :]] = value
        return made

    if not renamed:
        return scene
    return replace(
        scene,
        attributes=aliased(scene.attributes),
        constants=aliased(scene.constants),
        semantics=aliased(scene.semantics),
        textures=aliased(scene.textures),
        changes=aliased(scene.changes),
    )
