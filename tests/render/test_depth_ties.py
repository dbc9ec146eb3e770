"""Depth ties are found where two surfaces share their depth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.mesh import load_mesh

pytestmark = pytest.mark.xdist_group("gl")


@pytest.mark.parametrize("color", ["rgba8", "rgba32f"])
def test_every_triangle_twice(gpu: Gpu, scene: Scene, bundle: Bundle, color: str) -> None:
    once = load_mesh(scene.common.mesh)
    mesh = replace(once, index=np.concatenate([once.index, once.index]))
    with (
        RenderScene(gpu, scene, (48, 32), color, mesh) as world,
        CoverageRunner(world, bundle) as runner,
    ):
        assert (runner.ties(0) == runner.coverage(0)).all()
        assert runner.ties(0).any()
