"""All files of the folder that a chosen variant is handed over in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from shadercache.caching.configuration import Assignment
from shadercache.linking.linker import Linker
from shadercache.report.hand_over.example.example_blocks import ExampleBlocks
from shadercache.report.hand_over.example.example_data import ExampleData, UnfitForExampleError
from shadercache.report.hand_over.example.example_one import example_of_one
from shadercache.report.hand_over.example.example_several import MOST_LINES, example_of_several
from shadercache.report.hand_over.example.own_values import add_own_values
from shadercache.report.hand_over.expected import Expected
from shadercache.report.hand_over.handed_shaders import (
    HandedObject,
    HandedShader,
    handed_shaders,
)
from shadercache.report.hand_over.integration.integration_text import integration_text
from shadercache.scene.description import Scene
from shadercache.scene.mesh import Mesh

FRAMES = 16
"""Frames of the scene that the example draws."""

USUAL_SIZE = (512, 512)
"""Of the example's picture, in pixels, where nothing was measured."""

INTEGRATION, EXAMPLE, DATA = "INTEGRATION.md", "example.py", "example.npz"


def hand_over(
    linker: Linker,
    assignment: Assignment,
    expected: Expected | None = None,
    mesh: Mesh | None = None,
    frames: int = FRAMES,
) -> dict[str, bytes]:
    """The files of the folder, by their paths in it with slashes.

    ``assignment``: what was chosen, as ``Linker.assign`` gives it. ``mesh``: in place of the
    scene's. The example draws the first ``frames`` of the scene, in the size that was measured.

    Raises:
        InputError: SC542, nothing is cached; and as ``Linker.link``, ``load_mesh`` and
            ``load_pixels``.
    """
    shaders = handed_shaders(linker, assignment)
    data = ExampleData(linker.scene, expected.size if expected else USUAL_SIZE, frames, mesh)
    used: Sequence[HandedShader] = [shader for shader in shaders if shader.variant]
    made: dict[str, bytes] = {}
    try:
        used, made = _example(shaders, linker.scene, data)
        example = "`example.py` draws it, with moderngl, numpy and Pillow."
    except UnfitForExampleError as reason:
        example = f"There is no example: {reason}."
    texts = {name: text for shader in used for name, text in shader.written().items()}
    texts[INTEGRATION] = integration_text(shaders, linker.scene, expected, example)
    return {**{name: text.encode() for name, text in texts.items()}, **made}


def _example(
    shaders: Sequence[HandedShader], scene: Scene, data: ExampleData
) -> tuple[Sequence[HandedShader], dict[str, bytes]]:
    """The shaders that the example draws with, and its files.

    Raises :class:`UnfitForExampleError`: what the scene needs is nothing that an example gives.
    """
    if not data.alone:
        try:
            files = _example_files(ExampleBlocks(scene, shaders, data))
            lines = files[EXAMPLE].count(b"\n")
            reason = f"with all objects it would have {lines} lines"
            if lines < MOST_LINES:
                return shaders, files
        except UnfitForExampleError as error:
            reason = str(error)
        shader, item = _first(shaders, data)
        cached = [one for one in shaders if one.variant]
        shaders = [replace(shader, objects=(item,))]
        scene = replace(scene, objects=(item.part,))
        data = ExampleData(scene, data.size, data.frames)
        note = f"\nOf the scene's objects it draws {item.part.name} alone: {reason}."
        return cached, _example_files(ExampleBlocks(scene, shaders, data, note))
    return shaders, _example_files(ExampleBlocks(scene, shaders, data))


def _first(shaders: Sequence[HandedShader], data: ExampleData) -> tuple[HandedShader, HandedObject]:
    """The object that stands for all: the first that is cached, and there all the time."""
    every = [(shader, item) for shader in shaders for item in shader.cached]
    # The scene's own shader goes before those of objects.
    every.sort(key=lambda one: (not data.is_there(one[1].part), one[1].part.own_shader))
    return every[0]


def _example_files(blocks: ExampleBlocks) -> dict[str, bytes]:
    for shader in blocks.shaders:
        blocks.data.add(shader)
    if not blocks.data.alone:
        for shader in blocks.shaders:
            add_own_values(shader, blocks.data)
    # First, since it may make textures smaller.
    packed = blocks.data.packed()
    text = example_of_one(blocks) if blocks.data.alone else example_of_several(blocks)
    return {EXAMPLE: text.encode(), DATA: packed}
