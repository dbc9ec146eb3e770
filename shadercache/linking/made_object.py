"""A scene for a fragment and a vertex shader that have none: a knot, turning before a camera.

The knot has all arrays that vertex shaders commonly ask for, and pictures for its textures; values
of uniforms are guessed by name and type as ``shadercache scene`` does. Where there is no vertex
shader, one is made from what the fragment shader reads.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from shadercache.analysis.mapping import MappingKind
from shadercache.compiler import Analysis, analyse
from shadercache.front.read_options import ReadOptions
from shadercache.linking.first_scene.framing import FOV
from shadercache.linking.first_scene.guesses import sampler_roles
from shadercache.linking.first_scene.scene_text import FirstScene, Sources, first_scene
from shadercache.linking.first_scene.shader_inputs import inputs_of
from shadercache.linking.made_parts.made_pictures import made_pictures
from shadercache.linking.made_parts.made_vertex import made_vertex
from shadercache.linking.made_scene import START
from shadercache.linking.scene_shaders import (
    analyse_scene,
    check_drawn,
    full_screen,
    read_as_in,
    read_shader,
    vertex_beside,
    with_new_names,
)
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.models.load import load_model
from shadercache.scene.models.made_mesh import knot
from shadercache.scene.models.write_gltf import GltfWriter

AROUND, ACROSS = 200, 50
"""Quads along the knot's tube and round it: 20,000 triangles."""

# The camera makes room for the corners of a box, which the knot does not have.
_NARROW = 27.0
_SMALL = 80, 16
_SMALL_FILE = "small.npz"


class MadeObject(NamedTuple):
    """A scene with its analysed shaders; ``notes`` say what was guessed."""

    scene: Scene
    analysis: Analysis
    notes: tuple[str, ...]


def made_object(
    fragment: Path, vertex: Path | None, reading: ReadOptions, folder: Path
) -> MadeObject:
    """The scene of a knot with these shaders.

    Args:
        vertex: without it the file beside the fragment shader with the ending ``.vert``, or one
            that is made.
        folder: where the scene, its model and its textures are written; whoever draws the scene
            needs them.

    Raises:
        UsageError: SC005 for a varying of which a made vertex shader cannot tell what it is.
        InputError: as the compiler, ``first_scene`` and ``load_scene``.
    """
    return _on_knot(_paired(fragment, vertex, reading, folder), reading, folder)


def open_shader(
    fragment: Path,
    vertex: Path | None,
    reading: ReadOptions,
    mapping: MappingKind | None,
    folder: Path,
) -> MadeObject:
    """The scene of a shader that has none.

    It is drawn over the screen where the mapping says so, where it reads no varyings, and where no
    uniform moves vertices; else on a knot.

    Raises as :func:`made_object`, and UsageError SC006 for a shader without varyings whose values
    shall lie on surfaces.
    """
    check_drawn(reading)
    beside = vertex or vertex_beside(fragment)
    if mapping in ("screen", "user"):
        return MadeObject(*full_screen(fragment, beside, reading, mapping), ())
    if vertex is None and analyse(read_shader(fragment), None, reading).mapping != "surface":
        return MadeObject(*full_screen(fragment, None, reading, mapping), ())
    pair = _paired(fragment, vertex, reading, folder)
    if mapping is None and not pair.analysis.vertex_emitter.last_frame().twins:
        note = "nothing moves the vertices, so it is drawn over the screen"
        return MadeObject(*full_screen(fragment, pair.vertex, reading, "screen"), (note,))
    return _on_knot(pair, reading, folder)


class _Pair(NamedTuple):
    fragment: Path
    vertex: Path
    analysis: Analysis
    notes: tuple[str, ...]


def _paired(fragment: Path, vertex: Path | None, reading: ReadOptions, folder: Path) -> _Pair:
    """The shaders as values on surfaces are found in them; the vertex shader may be made."""
    source, notes = read_shader(fragment), tuple[str, ...]()
    vertex = vertex or vertex_beside(fragment)
    if vertex is None:
        made = made_vertex(source, reading)
        vertex, notes = folder / "made.vert", made.notes
        vertex.write_text(made.text, encoding="utf-8", newline="")
    analysis = analyse(source, read_shader(vertex), reading, "surface")
    return _Pair(fragment, vertex, analysis, notes)


def _on_knot(pair: _Pair, reading: ReadOptions, folder: Path) -> MadeObject:
    model = load_model(_written_knot(folder / f"{pair.fragment.stem}.glb"))
    sources = Sources(model, pair.fragment, pair.vertex)
    first = first_scene(sources, pair.analysis, folder, folder)
    path = folder / "scene.toml"
    head = f'verify_mesh = "{_SMALL_FILE}"\nstart_time = {START}\n'
    text = first.text.replace(f"fov_degrees = {FOV}", f"fov_degrees = {_NARROW}")
    path.write_text(head + text, encoding="utf-8", newline="")
    scene, notes = load_scene(path), (*pair.notes, *_notes(first, pair.analysis))
    if read_as_in(scene, reading) == reading:
        return MadeObject(with_new_names(scene, pair.analysis.renamed), pair.analysis, notes)
    return MadeObject(*analyse_scene(scene, reading, "surface"), notes)


def _written_knot(path: Path) -> Path:
    """The knot as a model, with its pictures; its small stand-in is written beside it."""
    arrays, index = knot(*_SMALL)
    stored: dict[str, Any] = {**arrays, "index": index.astype(np.uint32)}
    np.savez(path.with_name(_SMALL_FILE), **stored)
    made = GltfWriter()
    texture = {
        role: {"index": made.picture(data, name=role)} for role, data in made_pictures().items()
    }
    surface = {
        "baseColorTexture": texture["albedo"],
        "metallicRoughnessTexture": texture["roughness"],
        "metallicFactor": 0.0,
        "roughnessFactor": 0.5,
    }
    material = made.add(
        "materials", name="tiles", pbrMetallicRoughness=surface, normalTexture=texture["normal"]
    )
    arrays, index = knot(AROUND, ACROSS)
    made.hung(made.mesh(arrays, index, material=material), "knot")
    return made.glb(path)


def _notes(first: FirstScene, analysis: Analysis) -> Iterator[str]:
    """What was guessed and names alone do not say."""
    for guess in first.guesses:
        if not guess.sure:
            why = guess.why.replace(" (guess)", "")
            yield f"{guess.name} = {guess.value} ({why})"
    for name, role in sampler_roles(inputs_of(analysis).samplers).items():
        yield f"{name} is given a made picture ({role or 'squares'})"
