"""S12: from the same cache all algorithms make the same picture and the same next cache."""

from __future__ import annotations

import pytest

from shadercache.caching.settings import with_settings
from shadercache.gpu.context import Gpu
from tests.configured import DEFAULT, variant

from .criteria import Criteria
from .subjects import ALGORITHMS, changed, subject

pytestmark = pytest.mark.xdist_group("gl")

SETTINGS = ("", "filter=mitchell", "filter=bilinear,fallback", "age=on", "ids=on,guard=off")


@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
@pytest.mark.parametrize("settings", SETTINGS)
def test_from_the_same_cache(gpu: Gpu, stress: Criteria, scene: str, settings: str) -> None:
    if not stress.deep and (scene, settings) not in (("dragon", ""), ("trashcan", "age=on")):
        pytest.skip("not in the short form")
    cache = with_settings(DEFAULT, [settings] if settings else [])
    how = {"period": 4}
    frames = 12 if stress.deep else 3
    differing = hits = 0
    with subject(gpu, scene, (96, 96), cache=cache) as made:
        with variant(made.world, made.bundle, "2-pass", **how) as runner:
            runner.draw(0)
            stored = [runner.cache()]
            images = []
            for frame in range(1, frames + 1):
                mask = runner.hit_mask(frame)
                hits += int((mask == made.bundle.mask_values["hit"]).sum())
                images.append(runner.image(frame))
                stored.append(runner.cache())
        for algorithm in ALGORITHMS:
            with variant(made.world, made.bundle, algorithm, **how) as runner:
                for frame in range(1, frames + 1):
                    runner.restore(stored[frame - 1], frame - 1)
                    image, untied = runner.image(frame), made.untied(frame)
                    pairs = ((image, images[frame - 1]), (runner.cache(), stored[frame]))
                    for one, other in pairs:
                        differing += int((changed(one, other) & untied).sum())
    stress.none("pixels and texels that differ between algorithms", differing)
    stress.at_least("pixels reused", hits, 500 * frames)
