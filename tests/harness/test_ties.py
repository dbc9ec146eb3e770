"""Depth ties are found where two surfaces share their depth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from shadercache.harness.bundle import Bundle
from shadercache.harness.context import Gpu
from shadercache.harness.mesh import load_mesh
from shadercache.harness.runner import CoverageRunner
from shadercache.harness.scene import Scene
from shadercache.harness.stage import Stage

pytestmark = pytest.mark.xdist_group("gl")


@pytest.mark.parametrize("color", ["rgba8", "rgba32f"])
def test_every_triangle_twice(gpu: Gpu, scene: Scene, bundle: Bundle, color: str) -> None:
    once = load_mesh(scene.mesh)
    mesh = replace(once, index=np.concatenate([once.index, once.index]))
    with (
        Stage(gpu, scene, (48, 32), color, mesh) as stage,
        CoverageRunner(stage, bundle) as runner,
    ):
        assert (runner.ties(0) == runner.coverage(0)).all()
        assert runner.ties(0).any()
