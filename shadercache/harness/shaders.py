"""The shaders of a scene, read and analysed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import input_error, usage_error
from shadercache.front.options import ReadOptions
from shadercache.harness.made_scene import made_scene
from shadercache.harness.scene import Scene, load_scene
from shadercache.options import MappingKind
from shadercache.source import Source

T = TypeVar("T")

FULL_SCREEN = "--mapping screen"


def open_scene(
    path: Path, reading: ReadOptions | None = None, mapping: MappingKind | None = None
) -> tuple[Scene, Analysis]:
    """The scene of a scene file, or a made one for a full-screen shader; and its shaders.

    With ``mapping`` screen or user a full-screen shader may have a vertex shader beside it.

    Raises as ``load_scene`` and ``analyse_scene``, and :class:`UsageError` SC006 for a shader that
    needs geometry.
    """
    if path.suffix == ".toml":
        return analyse_scene(load_scene(path), reading, mapping)
    beside = path.with_suffix(".vert")
    flat = mapping in ("screen", "user")
    vertex = beside if flat and beside.is_file() else None
    sources = read_shader(path), None if vertex is None else read_shader(vertex)
    analysis = analyse(*sources, reading, mapping)
    if analysis.mapping == "surface":
        message = f"the shader {path} has no scene, and its values lie on surfaces"
        hint = f"put a scene.toml that names it beside it, or draw it full-screen: {FULL_SCREEN}"
        raise usage_error("SC006", message, hint)
    return made_scene(path, analysis, vertex), analysis


def analyse_scene(
    scene: Scene, reading: ReadOptions | None = None, mapping: MappingKind | None = None
) -> tuple[Scene, Analysis]:
    """The scene and what the compiler makes of its shaders; ``mapping`` goes before the scene's.

    Where shaders of an older version are raised some attributes, uniforms and textures get new
    names: the scene has what it gives under these as well. Raises as :func:`compiler.analyse`.
    """
    reading = reading or ReadOptions()
    reading = replace(reading, unroll=reading.unroll or scene.unroll)
    analysis = analyse(*read_shaders(scene), reading, mapping or scene.mapping)
    return with_aliases(scene, analysis.renamed), analysis


def read_shaders(scene: Scene) -> tuple[Source, Source | None]:
    """The scene's fragment shader, and its vertex shader if it has one."""
    vertex = None if scene.vertex is None else read_shader(scene.vertex)
    return read_shader(scene.fragment), vertex


def read_shader(path: Path) -> Source:
    """The text of one shader. Raises :class:`InputError` SC001 for what is no text."""
    try:
        return Source(str(path), path.read_text(encoding="utf-8-sig"))
    except (OSError, UnicodeDecodeError) as error:
        raise input_error("SC001", f"cannot read {path}: {error}") from None


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
        objects=tuple(
            item if item.own_shader else replace(item, scene=with_aliases(item.scene, renamed))
            for item in scene.objects
        ),
        attributes=aliased(scene.attributes),
        constants=aliased(scene.constants),
        semantics=aliased(scene.semantics),
        animated=aliased(scene.animated),
        textures=aliased(scene.textures),
        changes=aliased(scene.changes),
    )
