"""S21: carried samples keep what was computed, and know where that lies."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from laws.ground_truth import (
    Mutation,
    body_mesh,
    body_scene,
    bundle_of,
    mutated,
    project,
    true_frames,
)
from numpy.typing import NDArray

from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from tests.configured import configured, rewritten, variant

from .criteria import Criteria
from .plane import Plane, plane
from .test_s03_blur import START, moments

pytestmark = pytest.mark.xdist_group("gl")

CARRIED = configured(refresh="none", filter="carried")
OFFSET = slice(4, 6)
"""Of a cache of three floats in 32 bits, behind payload and depth."""


def impulse(gpu: Gpu) -> Plane:
    """A plane of zeros with one texel of ones."""
    made = plane(gpu, CARRIED)
    made.draw(0, u_value=(0.0, 0.0, 0.0), u_pan=(0.0, 0.0))
    texels = made.cached().copy()
    texels[START[1], START[0], :3] = 1.0
    made.overwrite(texels)
    return made


def shown(made: Plane, frame: int, pan: tuple[float, float]) -> NDArray[np.float64]:
    """The payload that the frame shows."""
    return made.draw(frame, u_pan=pan)[..., 0].astype(np.float64) * 2.0


@pytest.mark.parametrize("pan", [(0.1, 0.0), (0.25, 0.25), (0.5, 0.5), (0.3, 0.75)], ids=str)
def test_blur_does_not_grow(gpu: Gpu, stress: Criteria, pan: tuple[float, float]) -> None:
    """What is stored is never between two values, and what is shown is resampled once."""
    made = impulse(gpu)
    variances = []
    for frame in range(1, 65):
        image = shown(made, frame, (frame * pan[0] % 16.0, frame * pan[1] % 16.0))
        assert set(np.unique(made.cached()[..., 0])) <= {0.0, 1.0}
        if frame * max(pan) % 16.0 > 2.0:
            _, centre, variance = moments(image)
            place = np.array(START) + np.array([frame * pan[0] % 16.0, frame * pan[1] % 16.0])
            variances.append(variance)
            assert centre == pytest.approx(place, abs=0.5)
    stress.at_most("variance after up to 64 frames", max(variances), 0.5)


@pytest.mark.parametrize("rest", [(3.4, 2.7), (4.0, 2.5), (3.0, 2.0)], ids=str)
def test_motion_rest_and_motion(gpu: Gpu, stress: Criteria, rest: tuple[float, float]) -> None:
    """At rest nothing changes from the second frame on, and what goes on is what was there."""
    made = impulse(gpu)
    for step in range(1, 8):
        shown(made, step, (rest[0] * step / 7.0, rest[1] * step / 7.0))
    still = [shown(made, 8 + frame, rest) for frame in range(8)]
    drift = max(float(np.abs(image - still[1]).max()) for image in still[1:])
    stress.at_most("change at rest", drift, 0.0)
    for step in range(1, 8):
        image = shown(made, 16 + step, (rest[0] * (7 - step) / 7.0, rest[1] * (7 - step) / 7.0))
    _, centre, variance = moments(image)
    stress.at_most("from the place, pixels", float(np.abs(centre - START).max()), 0.5)
    stress.at_most("variance", variance, 0.5)


def test_whole_pixels_and_rest_give_the_bits(gpu: Gpu) -> None:
    """A sample right in the middle of a pixel is not filtered."""
    made = impulse(gpu)
    for frame in range(1, 6):
        image = shown(made, frame, (float(frame), 0.0))
        assert image[START[1], START[0] + frame] == 1.0
        assert np.count_nonzero(image) == 1


@pytest.mark.parametrize(("scene", "period"), [("dragon", 32), ("trashcan", 32), ("dragon", 128)])
def test_the_place_that_is_kept_is_the_true_one(
    gpu: Gpu, stress: Criteria, scene: str, period: int
) -> None:
    """In pixels, beside law 5's ground truth, 1 degree a frame."""
    if period > 32 and not stress.deep:
        pytest.skip("the long period is told in the long form")
    away = places(gpu, scene, period)
    assert len(away) > 5e4
    most, far = float(np.quantile(away, 0.99)), float((away > 1.0).mean())
    if period > 32:
        stress.tell("99 of 100 places are off by, pixels", most)
        stress.tell("share of places off by more than a pixel", far)
    else:
        stress.at_most("99 of 100 places are off by, pixels", most, 0.25)
        stress.at_most("share of places off by more than a pixel", far, 1e-3)


MUTATIONS = {
    "offsets that are not kept": ("vec4(sc_offset.x, sc_offset.y", "vec4(0.0, 0.0"),
    "offsets in the last frame's pixels": ("(jacobian.w * x - jacobian.z * y) / area", "x"),
}


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_wrong_places_are_noticed(gpu: Gpu, mutation: str) -> None:
    away = places(gpu, "trashcan", 32, lambda text: text.replace(*MUTATIONS[mutation]), 5.0)
    assert np.quantile(away, 0.99) > 0.25


def places(
    gpu: Gpu, scene: str, period: int, mutation: Mutation | None = None, degrees: float = 1.0
) -> NDArray[np.float64]:
    """How far off the places of hits are after a period, in pixels."""
    size, how = (192, 192), {"period": period, "block": 4}
    with RenderScene(gpu, body_scene(scene, degrees), size, "rgba32f", body_mesh(scene)) as world:
        bundle = bundle_of("v_position", "rgba32f", configured(filter="carried"))
        off: list[NDArray[np.float64]] = []
        with variant(world, mutated(bundle, mutation), "2-pass", **how) as runner:
            for frame in range(period + 6):
                hit = runner.hit_mask(frame) == bundle.mask_values["hit"]
                runner.draw(frame)
                if frame >= period:
                    matrix = true_frames(world, [frame])[0].matrix
                    off.append(misplaced(runner.cache(), matrix, size)[hit])
    return np.concatenate(off)


def misplaced(
    cache: NDArray[np.float32], matrix: NDArray[np.float64], size: tuple[int, int]
) -> NDArray[np.float64]:
    """How far from where their texels say samples lie whose payloads are object-space positions,
    (h, w), in pixels."""
    true, _ = project(matrix, cache[..., :3].astype(np.float64), size)
    row, column = np.mgrid[0 : size[1], 0 : size[0]]
    kept = np.stack([column + 0.5, row + 0.5], -1) + cache[..., OFFSET]
    away: NDArray[np.float64] = np.abs(true - kept).max(-1)
    return away


def test_where_samples_cannot_be_carried_is_told() -> None:
    """Three passes show what is stored, and on the screen nothing moves."""
    scene, analysis = open_scene(data_path("corpus", "dragon", "scene.toml"))
    node = next(node for node in analysis.nodes if node.id == scene.nodes["whole noise"])
    manifest = rewritten(analysis, node, CARRIED).manifest
    assert [variant.algorithm for variant in manifest.variants] == ["1-pass", "2-pass"]
    assert [entry.algorithm for entry in manifest.refused] == ["3-pass"]
    assert "filter=carried" in manifest.refused[0].reason
    path = Path(__file__).parents[2] / "laws" / "full_screen" / "orbit.frag"
    _, analysis = open_scene(path, mapping="screen")
    node = next(node for node in analysis.nodes if node.offered)
    with pytest.raises(InputError) as caught:
        rewritten(analysis, node, CARRIED)
    assert caught.value.diagnostics[0].code == "SC443"
