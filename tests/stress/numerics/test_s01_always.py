"""S1 and its like by the verifier: laws 2, 3, 4 and 7 for every way to refresh, bit for bit."""

from __future__ import annotations

from contextlib import closing

import pytest

from shadercache.harness.context import Gpu
from shadercache.harness.scene import load_scene
from shadercache.harness.shaders import analyse_scene
from shadercache.harness.verify import PERIOD, Verifier
from shadercache.options import read_cache_options
from shadercache.paths import data_path

from .criteria import Criteria

pytestmark = pytest.mark.xdist_group("gl")

SETTINGS = (
    *("", "age=on", "refresh=random", "refresh=tiled", "refresh=surface", "refresh=none"),
    *("refresh=tiled,age=on", "refresh=surface,age=on", "refresh=none,age=on", "ids=on,age=on"),
)

SHORT = ("refresh=surface", "refresh=none,age=on", "ids=on,age=on")


@pytest.mark.parametrize("settings", SETTINGS)
def test_always_refreshed_is_the_original(gpu: Gpu, stress: Criteria, settings: str) -> None:
    if not stress.deep and settings not in SHORT:
        pytest.skip("not in the short form")
    cache = read_cache_options([settings] if settings else [])
    scenes = ("dragon", "trashcan") if stress.deep else ("trashcan",)
    checked, broken = 0, []
    oldest: dict[str, float] = {}
    for name in scenes:
        scene, analysis = analyse_scene(load_scene(data_path("corpus", name)))
        nodes = [node for node in analysis.nodes if node.offered]
        few = nodes[:: max(1, len(nodes) // (24 if stress.deep else 1))]
        with closing(Verifier(gpu, scene, analysis, (64, 64), cache=cache)) as verifier:
            for node in few:
                verdict = verifier.check(node, plain=False)
                checked += 1
                broken += [f"{name} {node.id} {law}" for law in verdict.broken]
                for way, age in verdict.ages.items():
                    oldest[way] = max(age, oldest.get(way, 0.0))
    for way, age in oldest.items():
        stress.at_most(f"oldest, {way}, frames of {PERIOD}", age, PERIOD)
    stress.tell("nodes", checked)
    stress.demand("laws 2, 3, 4 and 7 that are broken", str(broken[:5]), "none", not broken)
