"""S2: a camera at rest for 1,000 frames: no bit changes."""

from __future__ import annotations

import pytest

from shadercache.gpu.context import Gpu
from shadercache.options import CacheOptions
from shadercache.render.variant_runner import RunOptions, VariantRunner

from .criteria import Criteria
from .subjects import ALGORITHMS, changed, subject

pytestmark = pytest.mark.xdist_group("gl")

OPTIONS = {
    "default": CacheOptions(),
    "age": CacheOptions(age=True),
    "random": CacheOptions(refresh="random"),
    "tiled": CacheOptions(refresh="tiled"),
    "surface": CacheOptions(refresh="surface"),
    "none": CacheOptions(refresh="none"),
}


@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
def test_nothing_drifts(gpu: Gpu, stress: Criteria, scene: str, options: CacheOptions) -> None:
    if not stress.deep and scene == "dragon" and options != CacheOptions():
        pytest.skip("options are seen on the trash can in the short form")
    frames = 1000 if stress.deep else 40
    algorithms = ALGORITHMS if stress.deep or options == CacheOptions() else ("2-pass",)
    how = RunOptions(period=32, moving=False)
    with subject(gpu, scene, (64, 64), options) as made:
        first, sure = made.original(0), made.untied(0)
        drifted = 0
        for algorithm in algorithms:
            with VariantRunner(made.world, made.bundle, algorithm, how) as runner:
                for frame in range(frames):
                    drifted += int((changed(runner.image(frame), first) & sure).sum())
    stress.none(f"pixels with another bit in {frames} frames, {', '.join(algorithms)}", drifted)
