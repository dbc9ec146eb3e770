"""S2: a camera at rest for 1,000 frames: no bit changes."""

from __future__ import annotations

import pytest

from shadercache.caching.configuration import Configuration
from shadercache.gpu.context import Gpu
from tests.configured import configured, variant

from .criteria import Criteria
from .subjects import ALGORITHMS, changed, subject

pytestmark = pytest.mark.xdist_group("gl")

OPTIONS = {
    "default": Configuration(),
    "age": configured(age=True),
    "random": configured(refresh="random"),
    "tiled": configured(refresh="tiled"),
    "surface": configured(refresh="surface"),
    "none": configured(refresh="none"),
}


@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
def test_nothing_drifts(gpu: Gpu, stress: Criteria, scene: str, options: Configuration) -> None:
    if not stress.deep and scene == "dragon" and options != Configuration():
        pytest.skip("options are seen on the trash can in the short form")
    frames = 1000 if stress.deep else 40
    algorithms = ALGORITHMS if stress.deep or options == Configuration() else ("2-pass",)
    how = {"period": 32, "moving": False}
    with subject(gpu, scene, (64, 64), options) as made:
        first, sure = made.original(0), made.untied(0)
        drifted = 0
        for algorithm in algorithms:
            with variant(made.world, made.bundle, algorithm, **how) as runner:
                for frame in range(frames):
                    drifted += int((changed(runner.image(frame), first) & sure).sum())
    stress.none(f"pixels with another bit in {frames} frames, {', '.join(algorithms)}", drifted)
