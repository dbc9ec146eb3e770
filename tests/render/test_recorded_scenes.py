"""A scene and a recording of it draw the same bits."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.subjects import subjects_of
from shadercache.paths import data_path
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.description import Scene, load_scene, recorded
from shadercache.scene.recording import read_recording
from tests.altered import altered
from tests.configured import configured
from tests.recordings import Frames, dumped, write_csv, write_toml

pytestmark = pytest.mark.xdist_group("gl")

SIZE, FRAMES, CUT = (96, 80), 6, 4
WRITERS = (("r.csv", write_csv), ("r.toml", write_toml))
Writer = Callable[[Path, Frames, Sequence[int]], Path]


@pytest.fixture(scope="module")
def dragon() -> Scene:
    return load_scene(data_path("corpus", "dragon", "scene.toml")).small


def opened(scene: Scene, writer: Writer, path: Path, cuts: Sequence[int]) -> tuple[Scene, Analysis]:
    """The resting scene with a recording of the moving one."""
    writer(path, dumped(scene, FRAMES, SIZE), cuts)
    moved = altered(scene, motion=altered(scene.common.motion, degrees_per_frame=0.0))
    return analyse_scene(recorded(moved, read_recording(path)))


def images(gpu: Gpu, scene: Scene, analysis: Analysis, frames: int) -> list[np.ndarray]:
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        return render_original(world, Linker(scene, analysis).originals(), range(frames))


@pytest.mark.parametrize(("name", "writer"), WRITERS)
def test_the_dragon_draws_the_same_bits(
    gpu: Gpu, dragon: Scene, tmp_path: Path, name: str, writer: Writer
) -> None:
    own = images(gpu, *analyse_scene(dragon), FRAMES)
    scene, analysis = opened(dragon, writer, tmp_path / name, [])
    played = images(gpu, scene, analysis, FRAMES + 2)
    assert [image.tobytes() for image in played[:FRAMES]] == [image.tobytes() for image in own]
    assert own[0].tobytes() != own[1].tobytes(), "it moves"
    # Behind its end it rests.
    assert all(image.tobytes() == own[-1].tobytes() for image in played[FRAMES:])


def test_variants_reuse_what_a_recording_moves(gpu: Gpu, dragon: Scene, tmp_path: Path) -> None:
    drawn = []
    chosen = replace(configured(period=32, form="rgba32f"), algorithm="2-pass")
    for scene, analysis in (
        analyse_scene(dragon),
        opened(dragon, write_csv, tmp_path / "r.csv", [CUT]),
    ):
        [node] = analysis.nodes_of("albedo", scene.nodes)
        linker = Linker(scene, analysis)
        linked = linker.link(linker.assign(replace(chosen, nodes=(node.id,))))
        with (
            RenderScene(gpu, scene, SIZE, "rgba32f") as world,
            VariantRunner(world, *linked) as runner,
        ):
            hits, frames = [], []
            for frame in range(FRAMES):
                hits.append(int((runner.hit_mask(frame) == runner.bundle.mask_values["hit"]).sum()))
                frames.append(runner.image(frame).tobytes())
            drawn.append((hits, frames, runner.resets))
    (own_hits, own, _), (hits, played, resets) = drawn
    assert own[:CUT] == played[:CUT] and own_hits[:CUT] == hits[:CUT]
    assert hits[1] > 0
    assert resets == ["first frame", "cut"]
    assert own[CUT] != played[CUT], "at the cut nothing was reused"


def test_what_is_recorded_is_not_left_out_for_its_bounds(
    gpu: Gpu, scene: Scene, tmp_path: Path
) -> None:
    """The scene's own camera does not see it; with recorded matrices it is drawn."""
    seen, analysis = analyse_scene(scene)
    write_csv(tmp_path / "r.csv", dumped(scene, 2, SIZE))
    box = ((-1.2, -1.2, -0.4), (1.2, 1.2, 0.4))
    away = altered(scene, bounds=box, eye=(0.0, 1.2, 50.0), target=(0.0, 0.0, 99.0))
    with RenderScene(gpu, analyse_scene(away)[0], SIZE) as world:
        assert world.drawn(0) == ()
    played = recorded(away, read_recording(tmp_path / "r.csv"))
    assert images(gpu, *analyse_scene(played), 2)[1].tobytes() == (
        images(gpu, seen, analysis, 2)[1].tobytes()
    )


def test_a_measurement_says_where_a_recording_ends(gpu: Gpu, dragon: Scene, tmp_path: Path) -> None:
    scene, analysis = opened(dragon, write_csv, tmp_path / "r.csv", [])
    linker = Linker(scene, analysis)
    node = analysis.nodes_of("albedo", scene.nodes)[0]
    chosen = configured(period=4)
    subjects = subjects_of(linker, "albedo", [replace(chosen, nodes=(node.id,))], 1)
    for frames, notes in ((FRAMES, 0), (FRAMES + 2, 1)):
        with RenderScene(gpu, scene, SIZE) as world:
            found = measure(world, linker.originals(), subjects, MeasureOptions(frames))
        assert sum("r.csv has 6 frames: those behind" in note for note in found.notes) == notes
