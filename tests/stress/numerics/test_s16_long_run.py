"""S16: 20,000 frames of a knot in motion: no error that grows, no leak, all is finite."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.configuration import Configuration
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from tests.altered import altered
from tests.configured import configured, rewritten, variant

from .criteria import Criteria
from .subjects import knot

pytestmark = pytest.mark.xdist_group("gl")

SIZE = (128, 128)
EVERY = 50
WARM = 200
DEGREES = 1.44
TURN = 5
"""Samples after which the knot is seen from the same side: 5 x 50 x 1.44 degrees are a turn."""

RUNS = {
    "default": (Configuration(), 20_000),
    "age": (configured(age=True), 4_000),
    "random": (configured(refresh="random"), 4_000),
    "lanczos2": (configured(filter="lanczos2"), 4_000),
    "mitchell": (configured(filter="mitchell"), 4_000),
    "bilateral": (configured(filter="bilateral"), 4_000),
    "nearest": (configured(filter="nearest"), 4_000),
}


def resident() -> int:
    """Bytes of this process that are in memory."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * 4096


def slope(errors: np.ndarray) -> tuple[float, float]:
    """The slope of a line through the errors, and half its 99 % interval, both of their mean and
    over the whole run. Each point of the line is the mean of a turn, for errors are those of a
    view, and the samples of a turn see the same views in each."""
    turns = errors[: len(errors) // TURN * TURN].reshape(-1, TURN).mean(axis=1)
    place = np.linspace(0.0, 1.0, len(turns))
    fit = np.polyfit(place, turns, 1)
    left = turns - np.polyval(fit, place)
    spread = np.sqrt((left**2).sum() / (len(turns) - 2) / ((place - place.mean()) ** 2).sum())
    student = 3.01  # Student's t with 13 degrees of freedom, which is what the shorter runs have
    return float(fit[0] / turns.mean()), float(student * spread / turns.mean())


@pytest.mark.parametrize(("cache", "frames"), RUNS.values(), ids=RUNS)
def test_a_long_run(gpu: Gpu, stress: Criteria, cache: Configuration, frames: int) -> None:
    if not stress.deep:
        if cache != Configuration():
            pytest.skip("only the default in the short form")
        frames = 400
    scene, analysis = analyse_scene(load_scene(data_path("corpus", "dragon")))
    scene = altered(scene, degrees_per_frame=DEGREES)
    node = analysis.nodes_of(scene.nodes["albedo"])
    found = rewritten(analysis, node, cache, ("2-pass",), unprofitable=True)
    bundle = Bundle(found.manifest, found.files)
    mesh = knot(125, 20)
    assert len(mesh.index) == 5000
    errors: list[float] = []
    memory: list[int] = []
    broken = 0
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f", mesh) as world,
        variant(world, bundle, "2-pass", period=32) as runner,
        OriginalRunner(world, bundle) as original,
    ):
        for frame in range(frames):
            if frame % EVERY or frame < WARM:
                runner.draw(frame)
                continue
            image, stored = runner.image(frame).copy(), runner.cache()
            broken += int(not np.isfinite(image).all()) + int(not np.isfinite(stored).all())
            true = original.image(frame)
            drawn = true[..., 3] > 0.0
            errors.append(float(np.sqrt(((image - true)[drawn] ** 2).mean())))
            memory.append(resident())
    stress.none("images and caches with a value that is not finite", broken)
    stress.tell("RMSE", float(np.mean(errors)))
    half = len(memory) // 4
    growth = max(memory[half:]) / memory[half] - 1.0
    stress.at_most("growth of resident memory", growth, 0.02)
    if stress.deep:
        trend, around = slope(np.array(errors))
        stress.tell("slope of the error over the run, of its mean", f"{trend:+.4f}")
        stress.at_most("that slope, of its 99 % interval", abs(trend) / around, 1.0)
    else:
        first, second = np.array_split(np.array(errors), 2)
        stress.at_most("error of the second half, of the first's", second.mean() / first.mean(), 2)
