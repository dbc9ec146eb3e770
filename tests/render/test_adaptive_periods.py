"""Periods that adapt: what changes is refreshed often, what does not seldom."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.configuration import Refresh
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from tests.configured import DEFAULT

pytestmark = pytest.mark.xdist_group("gl")

# To the left of the middle the payload changes in every frame, to the right never.
SHADER = """#version 330
uniform float u_time;
uniform vec2 u_resolution;
out vec4 o_color;
void main() {
    float here = gl_FragCoord.x < 0.5 * u_resolution.x ? u_time : 0.0;
    vec3 wave = sin(vec3(7.0, 8.0, 9.0) * here + gl_FragCoord.y);
    o_color = vec4(0.5 + 0.5 * wave * wave, 1.0);
}
"""
NODE = "sin(vec3(7.0, 8.0, 9.0) * here + gl_FragCoord.y)"
SIZE, PERIOD = (64, 64), 32


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
def test_each_place_is_refreshed_as_often_as_it_changes(
    gpu: Gpu, tmp_path: Path, algorithm: str
) -> None:
    file = tmp_path / "half.frag"
    file.write_text(SHADER)
    scene, analysis = open_scene(file, mapping="screen")
    node = next(node for node in analysis.nodes if node.text == NODE)
    chosen = replace(
        DEFAULT, nodes=(node.id,), algorithm=algorithm, refresh=Refresh(period=PERIOD, adaptive=0.2)
    )
    linker = Linker(scene, analysis)
    shares = []
    with (
        RenderScene(gpu, scene, SIZE) as world,
        VariantRunner(world, *linker.link(linker.assign(chosen))) as runner,
    ):
        refresh = runner.bundle.mask_values["refresh"]
        for frame in range(6 * PERIOD):
            if frame >= 4 * PERIOD:
                due = runner.hit_mask(frame) == refresh
                shares.append((due[:, : SIZE[0] // 2].mean(), due[:, SIZE[0] // 2 :].mean()))
            runner.draw(frame)
    changing, still = np.mean(shares, axis=0)
    # A frame is a sixtieth of a second, in which the fastest wave turns by .15: the bound allows
    # about a frame between two refreshes.
    assert still == pytest.approx(1.0 / PERIOD)
    assert 0.4 < changing <= 1.0
