"""The shaders of a scene, read and analysed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from shadercache.analysis.mapping import MappingKind
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import input_error, usage_error
from shadercache.foreign_files import read_text
from shadercache.front.read_options import ReadOptions
from shadercache.linking.made_scene import made_scene
from shadercache.scene.camera import uniform_values
from shadercache.scene.description import Scene, SceneObject, View, load_scene, recorded
from shadercache.scene.object_inputs import Inputs, with_aliases
from shadercache.scene.recording import Recording
from shadercache.source import Source

FULL_SCREEN = "--mapping screen"


def open_scene(
    path: Path,
    reading: ReadOptions | None = None,
    mapping: MappingKind | None = None,
    recording: Recording | None = None,
    vertex: Path | None = None,
) -> tuple[Scene, Analysis]:
    """The scene of a scene file, or a made one for a full-screen shader; and its shaders.

    With ``mapping`` screen or user a full-screen shader may have a vertex shader: ``vertex``, or
    the one beside it. A ``recording`` is laid over the scene.

    Raises as ``load_scene``, ``recorded`` and ``analyse_scene``, and :class:`UsageError` SC006 for
    a shader that needs geometry.
    """
    if path.suffix == ".toml":
        scene = load_scene(path)
        return analyse_scene(
            scene if recording is None else recorded(scene, recording), reading, mapping
        )
    if vertex is None and mapping in ("screen", "user"):
        vertex = vertex_beside(path)
    scene, analysis = full_screen(path, vertex, reading, mapping)
    if recording is not None:
        # The scene has everything under its new name already.
        scene = recorded(scene, recording.with_aliases(analysis.renamed))
    return scene, analysis


def vertex_beside(fragment: Path) -> Path | None:
    """The vertex shader that lies beside a fragment shader, if one does."""
    beside = fragment.with_suffix(".vert")
    return beside if beside.is_file() else None


def full_screen(
    path: Path,
    vertex: Path | None,
    reading: ReadOptions | None = None,
    mapping: MappingKind | None = None,
) -> tuple[Scene, Analysis]:
    """The scene of a shader that is drawn over the screen. Raises as :func:`open_scene`."""
    sources = read_shader(path), None if vertex is None else read_shader(vertex)
    analysis = analyse(*sources, reading, mapping)
    if analysis.mapping == "surface":
        message = f"the shader {path} has no scene, and its values lie on surfaces"
        hint = f"give a scene.toml that names it, or draw it full-screen: {FULL_SCREEN}"
        raise usage_error("SC006", message, hint)
    return made_scene(path, analysis, vertex), analysis


def analyse_scene(
    scene: Scene, reading: ReadOptions | None = None, mapping: MappingKind | None = None
) -> tuple[Scene, Analysis]:
    """The scene and what the compiler makes of its shaders; ``mapping`` goes before the scene's.

    Where neither says one and nothing moves, values are found at their own pixel: what it shows, it
    has shown in the frame before, so reprojection can be skipped.

    Where shaders of an older version are raised some attributes, uniforms and textures get new
    names: the scene has what it gives under these as well. Raises as :func:`compiler.analyse`.
    """
    reading = read_as_in(scene, reading or ReadOptions())
    check_drawn(reading)
    sources, wanted = read_shaders(scene), mapping or scene.mapping
    analysis = analyse(*sources, reading, wanted)
    named = with_new_names(scene, analysis.renamed)
    if wanted is None and analysis.mapping == "surface" and _rests(named, analysis):
        analysis = analyse(*sources, reading, "screen")
    return named, analysis


def check_drawn(reading: ReadOptions) -> None:
    """Refuse to draw Vulkan GLSL: :class:`InputError` SC450."""
    if reading.dialect == "vulkan":
        hint = (
            "'rewrite' writes its variants; to draw them here take the OpenGL GLSL that "
            "'spirv-cross --version 450 --no-es' makes of its SPIR-V"
        )
        raise input_error("SC450", "Vulkan GLSL is not drawn: the harness runs OpenGL", hint=hint)


def read_as_in(scene: Scene, reading: ReadOptions) -> ReadOptions:
    """These options, and what a scene asks for besides."""
    return replace(
        reading,
        unroll=reading.unroll or scene.reading.unroll,
        approximate=reading.approximate or scene.reading.approximate,
        moving=(*reading.moving, *scene.reading.moving, *_moving(scene)),
        instanced=any(given.instances.number > 1 for given in _inputs(scene)),
    )


def _inputs(scene: Scene) -> list[Inputs]:
    """Those of the objects with the scene's own shaders."""
    # Objects with shaders of their own are analysed alone.
    parts = [part for part in scene.objects if not part.own_shader] or [scene.common]
    return [part.inputs for part in parts]


def _moving(scene: Scene) -> Iterable[str]:
    """The attributes of instances and the textures that change from frame to frame."""
    streams = ({**given.instances.streams, **given.played} for given in _inputs(scene))
    return dict.fromkeys(name for both in streams for name, it in both.items() if it.moves)


def _rests(scene: Scene, analysis: Analysis) -> bool:
    """Is each vertex at the same place of the picture in every frame?"""
    names = analysis.vertex_emitter.last_frame().twins
    frames = range(scene.common.motion.frames + 1)
    # Objects with shaders of their own are analysed alone, so their motion has no say here.
    items = [part for part in scene.objects if not part.own_shader] or [scene.common]
    return all(_is_constant(scene.view, part, names, frames) for part in items)


def _is_constant(
    view: View, scene_object: SceneObject, names: Iterable[str], frames: range
) -> bool:
    """Do these uniforms have one value in all frames? Their size in pixels does not matter."""
    first, *rest = frames
    at_first = uniform_values(view, scene_object, first, (64, 64))
    # One after the other: what moves does so in the second frame, and a path may be long.
    return all(name in at_first for name in names) and all(
        np.array_equal(values[name], at_first[name])
        for values in (uniform_values(view, scene_object, frame, (64, 64)) for frame in rest)
        for name in names
    )


def read_shaders(scene: Scene) -> tuple[Source, Source | None]:
    """The scene's fragment shader, and its vertex shader if it has one."""
    common = scene.common
    fragment = read_shader(common.fragment)
    return fragment, None if common.vertex is None else read_shader(common.vertex)


def read_shader(path: Path) -> Source:
    """The text of one shader. Raises :class:`InputError` SC001 for what is no text."""
    try:
        return Source(str(path), read_text(path))
    except (OSError, UnicodeDecodeError) as error:
        raise input_error("SC001", f"cannot read {path}: {error}") from None


def with_new_names(scene: Scene, renamed: Mapping[str, str]) -> Scene:
    """The scene with everything that its shaders name also under its new name."""

    def named(scene_object: SceneObject) -> SceneObject:
        return replace(scene_object, inputs=scene_object.inputs.with_aliases(renamed))

    return replace(
        scene,
        common=named(scene.common),
        objects=tuple(part if part.own_shader else named(part) for part in scene.objects),
        changes=with_aliases(scene.changes, renamed),
    )
