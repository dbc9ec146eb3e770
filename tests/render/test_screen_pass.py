"""A pass over the screen is one triangle, once for all objects of a manifest."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from render.test_independent_runner import agree

from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from tests.altered import altered
from tests.configured import variant
from tests.torus.mesh import EMISSION, FOLDER

pytestmark = pytest.mark.xdist_group("gl")

SKY = {
    **{"name": "sky", "vertex": "sky.vert", "fragment": "sky.frag", "draws": "screen"},
    **{"targets": ["color"], "depth": {"test": "lequal", "write": False}, "on_reset": True},
    **{"reads": [], "uniforms": [], "attributes": []},
}
"""Fills what no object covers: its depth is that of an empty buffer."""

BLUE = [0.25, 0.5, 1.0, 1.0]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The emission with a sky behind the miss pass of two passes."""
    folder = tmp_path_factory.mktemp("sky") / "emission"
    shutil.copytree(EMISSION, folder)
    for name in ("sky.vert", "sky.frag"):
        shutil.copy(FOLDER / "sky" / name, folder)
    manifest: dict[str, Any] = json.loads((folder / "manifest.json").read_text())
    two = next(item for item in manifest["variants"] if item["algorithm"] == "2-pass")
    two["passes"].append(SKY)
    (folder / "manifest.json").write_text(json.dumps(manifest))
    return folder


@pytest.fixture
def with_sky(folder: Path) -> Bundle:
    return load_bundle(folder)


@pytest.fixture
def two_rings(gpu: Gpu, scene: Scene) -> Iterator[RenderScene]:
    """The torus, and another one beside it."""
    aside = altered(scene.common, name="other", position=(0.7, 0.0, 0.0))
    items = (scene.common, aside)
    with RenderScene(gpu, replace(scene, objects=items), (96, 64), "rgba32f") as opened:
        yield opened


def test_it_is_drawn_once_behind_all_objects(two_rings: RenderScene, with_sky: Bundle) -> None:
    with CoverageRunner(two_rings, with_sky) as runner:
        empty = ~runner.coverage(3)
    assert 0.2 < empty.mean() < 0.9
    how = {"period": 4, "form": "rgba32f"}
    with (
        variant(two_rings, with_sky, "2-pass", **how) as runner,
        variant(two_rings, with_sky, "1-pass", **how) as bare,
    ):
        for frame in range(4):
            fragments = runner.work(frame)["sky"]
            seen, expected = runner.image(frame), bare.image(frame)
            assert fragments == (seen == BLUE).all(-1).sum()
        assert (seen[empty] == BLUE).all()
        assert np.array_equal(seen[~empty], expected[~empty])


def test_a_runner_that_knows_only_the_manifest_draws_the_same(
    world: RenderScene, with_sky: Bundle, folder: Path
) -> None:
    assert agree(world, with_sky, folder, "2-pass", "rgba32f")
