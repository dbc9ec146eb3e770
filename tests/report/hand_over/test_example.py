"""The example of a variant draws the picture that the harness draws, and is short."""

from __future__ import annotations

import ast
import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from shadercache.caching.configuration import Assignment
from shadercache.gpu.context import Gpu
from shadercache.report.hand_over import handed_files
from shadercache.report.hand_over.example import example_data
from shadercache.report.hand_over.example.example_several import MOST_LINES
from shadercache.report.hand_over.handed_files import hand_over
from tests.report.hand_over.handed import (
    CHOICES,
    EXPECTED,
    FRAMES,
    SIZE,
    Choice,
    Handed,
    chosen,
    drawn_by_harness,
    example_pictures,
    handed,
    written,
)
from tests.report.hand_over.rich_scene import write_rich_scene

pytestmark = pytest.mark.xdist_group("gl")


def agree(gpu: Gpu, made: Handed, folder: Path) -> None:
    """Does the example draw what the harness does? The same driver draws the same programs with
    the same numbers, so it is the same to the bit."""
    told, by_variant, by_original = example_pictures(written(made, folder))
    expected = drawn_by_harness(gpu, made)
    assert expected.any(), "an empty picture proves nothing"
    assert np.array_equal(by_variant, expected)
    error = np.sqrt(np.mean((by_variant / 255.0 - by_original / 255.0) ** 2))
    assert told.startswith(f"RMSE {error:.5f}, ")
    assert told.endswith(" times as fast\n")


def check_text(made: Handed) -> None:
    """It is short, and needs nothing but three packages."""
    text = made.text("example.py")
    assert len(text.splitlines()) < MOST_LINES
    imported = {
        alias.name if isinstance(node, ast.Import) else node.module
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Import | ast.ImportFrom)
        for alias in node.names
    }
    assert imported == {"sys", "functools", "pathlib", "time", "moderngl", "numpy", "PIL"}


@pytest.mark.parametrize("name", CHOICES)
def test_examples_draw_the_same_bits(gpu: Gpu, tmp_path: Path, name: str) -> None:
    made = handed(CHOICES[name])
    check_text(made)
    agree(gpu, made, tmp_path)


@pytest.mark.parametrize("algorithm", ["2-pass", "3-pass"])
@pytest.mark.parametrize("several", [False, True])
def test_every_kind_of_input(
    gpu: Gpu, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, algorithm: str, several: bool
) -> None:
    """Uniform blocks, arrays, instances, cube maps, volumes, array textures, and twins. (All of
    them at once are many lines.)"""
    monkeypatch.setattr(handed_files, "MOST_LINES", 200)
    path = write_rich_scene(tmp_path / "scene", several)
    made = handed(Choice(path, 0, algorithm))
    agree(gpu, made, tmp_path / "handed")


def test_shaders_by_different_algorithms(
    gpu: Gpu, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    linker, assignment = chosen(CHOICES["heroine"])
    by = {"heroine": "parked", "ground": "3-pass"}
    own = Assignment(
        tuple((name, one and replace(one, algorithm=by[name])) for name, one in assignment.objects)
    )
    made = Handed(linker, own, hand_over(linker, own, EXPECTED, frames=FRAMES))
    text = made.text("example.py")
    assert "heroine/parked.find" in text and "ground/3-pass.reuse" in text
    agree(gpu, made, tmp_path)


def test_a_texture_that_changes_with_each_frame(gpu: Gpu, tmp_path: Path) -> None:
    path = write_rich_scene(tmp_path / "scene", several=False, played=True)
    made = handed(Choice(path, 0, "2-pass"))
    assert "sc_previous_u_pose" in made.text("example.py")
    agree(gpu, made, tmp_path / "handed")


def test_one_object_stands_for_several_where_a_texture_changes(tmp_path: Path) -> None:
    path = write_rich_scene(tmp_path / "scene", several=True, played=True)
    made = handed(Choice(path, 0, "2-pass"))
    reason = "u_pose is a texture that changes with each frame"
    assert f"it draws map of its own alone: {reason}." in made.text("example.py")
    example_pictures(written(made, tmp_path / "handed"))


def test_objects_that_come_and_go(
    gpu: Gpu, scene_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The example of all of them would be too long, so one stands for them; but it would be
    right. By one pass it is shorter."""
    choice = Choice(scene_folder / "objects", "main.0-7a71c60a", "parked", 5)
    made = handed(choice)
    check_text(made)
    assert "Of the scene's objects it draws turning alone" in made.text("example.py")
    assert not [name for name in made.files if name.startswith("sky")]
    example_pictures(written(made, tmp_path / "one"))
    monkeypatch.setattr(handed_files, "MOST_LINES", 200)
    agree(gpu, handed(choice), tmp_path / "all")
    shorter = handed(replace(choice, algorithm="1-pass"))
    check_text(shorter)
    agree(gpu, shorter, tmp_path / "one pass")


def test_large_textures_are_made_smaller(
    gpu: Gpu, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = handed(CHOICES["trashcan, three passes"])
    size = len(whole.files["example.npz"])
    monkeypatch.setattr(example_data, "LARGEST", size - 1)
    made = handed(CHOICES["trashcan, three passes"])
    assert len(made.files["example.npz"]) < size
    assert arrays(made)["textures/u_normals"].shape == (128, 128, 4)
    assert "u_normals is 2 times smaller than yours" in made.text("example.py")
    example_pictures(written(made, tmp_path))


def test_without_an_example_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(example_data, "LARGEST", 1000)
    made = handed(CHOICES["heroine"])
    assert {"example.py", "example.npz"}.isdisjoint(made.files)
    assert "There is no example: meshes and values would take" in made.text("INTEGRATION.md")
    # Nobody needs the originals of what is not cached then.
    assert not [name for name in made.files if name.startswith("sky/")]


def test_a_picture_without_measurement_has_a_usual_size() -> None:
    made = handed(CHOICES["a Shadertoy"], expected=None)
    assert "(512, 512)" in made.text("example.py")
    assert str(SIZE) in handed(CHOICES["a Shadertoy"], EXPECTED).text("example.py")


def test_values_are_those_of_the_frames() -> None:
    found = arrays(handed(CHOICES["dragon, two passes"]))
    assert found["values/u_modelViewProjection"].shape == (FRAMES, 16)
    assert found["values/u_light"].shape == (1, 3)
    assert found["values/u_light"].dtype == np.float32


def arrays(made: Handed) -> dict[str, NDArray[np.generic]]:
    return dict(np.load(io.BytesIO(made.files["example.npz"])))
