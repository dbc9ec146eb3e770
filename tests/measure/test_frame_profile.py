"""Where a frame goes: each part is what is left when it is left out."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure import measure as measuring
from shadercache.measure.frame_profile import Profile, profile
from shadercache.measure.measurement import MeasureOptions
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from tests.configured import configured
from tests.told_clock import ToldClock

pytestmark = pytest.mark.xdist_group("gl")

SECONDS = {
    "geometry": 1.0,
    "original": 10.0,
    "nothing": 0.5,
    "first pass": 5.0,
    "frame": 8.0,
    "nothing due": 7.0,
    "first pass, no decision": 4.0,
    "no decision": 6.0,
    "found": 3.0,
    "found, not stored": 2.5,
}
"""What each draw takes, in the order of a frame."""


def profiled(gpu: Gpu, monkeypatch: pytest.MonkeyPatch, **changed: float) -> Profile:
    """Of the heroine, whose ground is cached as well."""
    scene, analysis = analyse_scene(load_scene(data_path("corpus", "heroine")))
    linker = Linker(scene, analysis)
    nodes = tuple(node.id for node in analysis.nodes_of(scene.nodes["surface"]))
    chosen = replace(configured(ids=True, period=8), nodes=nodes)
    seconds = [changed.get(label.replace(" ", "_"), SECONDS[label]) for label in SECONDS]
    monkeypatch.setattr(measuring, "pick_clock", lambda _: ToldClock(*seconds))
    with RenderScene(gpu, linker.scene, (32, 32)) as world:
        return profile(world, linker, chosen, MeasureOptions(frames=4))


def test_parts_are_differences(gpu: Gpu, monkeypatch: pytest.MonkeyPatch) -> None:
    found = profiled(gpu, monkeypatch)
    assert {part.name: pytest.approx(10.0 * part.share.median) for part in found.parts} == {
        "clears": 0.5,
        "geometry, first pass": 0.5,
        "look-up": 1.0,
        "refresh decision": 1.0,
        "shading of hits": 1.5,
        "store": 0.5,
        "geometry, second pass": 0.5,
        "shading of misses": 2.5,
    }
    assert (found.original, found.frame.median) == (10.0, 0.8)
    assert np.isclose(found.unexplained.median, 0.0)


def test_what_the_parts_do_not_explain_is_told(gpu: Gpu, monkeypatch: pytest.MonkeyPatch) -> None:
    # The first pass of the frame itself costs more than looking up and deciding do apart.
    found = profiled(gpu, monkeypatch, first_pass=6.0)
    assert np.isclose(found.unexplained.median, 0.1)
