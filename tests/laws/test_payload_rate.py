"""Payloads at a fraction of the rate: what holds of pixels that take them from texels around them.

The payload is the object-space position, the normal or the body's number (:mod:`ground_truth`), and
the colour is the payload: so the picture says from which surface point each pixel's payload is.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from laws import test_conditions
from laws.ground_truth import (
    FOOTPRINT,
    Mask,
    TrueFrame,
    body_mesh,
    body_scene,
    bundle_of,
    true_frames,
)
from laws.look_ups import MOST_FOREIGN, MOST_STALE, OPPOSED
from numpy.typing import NDArray

from shadercache.caching.configuration import DIVISORS, Configuration, PayloadRate
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.verify.verifier import Verifier
from tests.configured import configured, variant

pytestmark = pytest.mark.xdist_group("law5")

SIZE = (256, 256)
ODD = (251, 157)
FRAMES = range(4)
BODIES = {
    "dragon": ("dragon", False),
    "trashcan": ("trashcan", False),
    "dragon and a sphere before it": ("dragon", True),
}
MOST_COMPUTED = {"half": 0.06, "quarter": 0.2}
"""Share of pixels that no texel fits, in pictures as small as these; larger ones have fewer."""


@contextmanager
def on_stage(gpu: Gpu, name: str, sphere: bool, size: tuple[int, int]) -> Iterator[RenderScene]:
    with RenderScene(gpu, body_scene(name, 5.0), size, "rgba32f", body_mesh(name, sphere)) as world:
        yield world


@dataclass(frozen=True)
class Drawn:
    """A frame: its picture, and the pixels that took their payloads from texels around them."""

    values: NDArray[np.float32]
    taken: Mask


def drawn(world: RenderScene, truth: list[TrueFrame], bundle: Bundle, period: int) -> list[Drawn]:
    found = []
    with variant(world, bundle, "3-pass", period=period) as runner:
        for frame, true in enumerate(truth):
            computed = runner.computed(frame)
            values = runner.image(frame)[..., :3].copy()
            found.append(Drawn(values, true.covered & ~computed))
    return found


def bundle_at(rate: PayloadRate, what: str, **settings: str) -> Bundle:
    return bundle_of(what, "rgba32f", replace(configured(**settings), payload_rate=rate))


@pytest.mark.parametrize("size", [SIZE, ODD], ids=["even", "odd"])
@pytest.mark.parametrize("rate", ["half", "quarter"])
@pytest.mark.parametrize("body", list(BODIES))
def test_what_is_taken_is_of_the_same_place(
    gpu: Gpu, body: str, rate: PayloadRate, size: tuple[int, int]
) -> None:
    """Nothing is from another body or another side, nor farther away than a texel reaches."""
    with on_stage(gpu, *BODIES[body], size) as world:
        truth = true_frames(world, FRAMES)
        places = drawn(world, truth, bundle_at(rate, "v_position"), 1)
        normals = drawn(world, truth, bundle_at(rate, "v_normal"), 1)
        bodies = drawn(world, truth, bundle_at(rate, "v_body"), 1)
    reach, taken, far, opposed, foreign, covered = FOOTPRINT * DIVISORS[rate], 0, 0, 0, 0, 0
    for true, place, normal, number in zip(truth, places, normals, bodies, strict=True):
        away = np.linalg.norm(place.values - true.position, axis=-1)
        far += np.count_nonzero(place.taken & (away > reach * true.footprint))
        lengths = np.linalg.norm(normal.values, axis=-1) * np.linalg.norm(true.normal, axis=-1)
        cosine = (normal.values * true.normal).sum(-1) / np.maximum(lengths, 1e-9)
        # At the tip of a spike both sides lie within a texel.
        beside = away > DIVISORS[rate] * true.footprint
        opposed += np.count_nonzero(normal.taken & (cosine < OPPOSED) & beside)
        foreign += np.count_nonzero(
            number.taken & (np.abs(number.values[..., 0] - true.body) > MOST_FOREIGN)
        )
        taken += np.count_nonzero(place.taken)
        covered += np.count_nonzero(true.covered)
        own = true.covered & ~place.taken
        assert np.array_equal(place.values[own], true.position[own].astype(np.float32))
    assert (foreign, opposed) == (0, 0)
    assert far <= MOST_STALE * taken
    assert 1.0 - taken / covered <= MOST_COMPUTED[rate]


@pytest.mark.parametrize("rate", ["half", "quarter"])
def test_positions_are_interpolated_and_not_shifted(gpu: Gpu, rate: PayloadRate) -> None:
    """On flat ground blending positions gives the position: a pixel that took the texel's own
    would be up to a texel off, and one with the wrong weights as much."""
    with on_stage(gpu, "trashcan", False, SIZE) as world:
        truth = true_frames(world, FRAMES)
        places = drawn(world, truth, bundle_at(rate, "v_position"), 1)
    off = np.concatenate(
        [
            (np.linalg.norm(place.values - true.position, axis=-1) / true.footprint)[place.taken]
            for true, place in zip(truth, places, strict=True)
        ]
    )
    assert np.median(off) < 0.02 * DIVISORS[rate]


@pytest.mark.parametrize("period", [4, 65535])
def test_nothing_taken_is_stored(gpu: Gpu, period: int) -> None:
    """Errors do not add up: however long texels are reused, each is of its own place."""
    frames = range(13)
    with on_stage(gpu, "trashcan", False, SIZE) as world:
        truth = true_frames(world, frames)
        places = drawn(world, truth, bundle_at("half", "v_position"), period)
    for true, place in zip(truth, places, strict=True):
        away = np.linalg.norm(place.values - true.position, axis=-1)
        # One footprint of a texel for the look-up in the last frame's cache, one for this frame's.
        far = place.taken & (away > 2.0 * FOOTPRINT * 2.0 * true.footprint + 1e-3 * true.w)
        assert np.count_nonzero(far) <= MOST_STALE * np.count_nonzero(place.taken)


@pytest.mark.parametrize(("settings", "renewed"), [({}, True), ({"refresh": "none"}, False)])
def test_a_period_of_one_needs_no_pass_that_reuses(
    gpu: Gpu, settings: dict[str, str], renewed: bool
) -> None:
    bundle = bundle_at("half", "v_position", **settings)
    with on_stage(gpu, "trashcan", False, SIZE) as world:
        seen: list[list[NDArray[np.float32]]] = []
        for short in (False, True):
            with variant(world, bundle, "3-pass", period=1, short_reset=short) as runner:
                seen.append([runner.image(frame).copy() for frame in FRAMES])
                due = {bound.name for role in runner.roles for bound in role.due if bound}
                assert due == set(runner.pass_names) - ({"reuse"} if short and renewed else set())
    for every, fewer in zip(*seen, strict=True):
        assert every.tobytes() == fewer.tobytes()


DISCARDS_BY_PLACE = """
float waves(vec2 p) {
    float sum = 0.0;
    for (int i = 1; i < 30; ++i) {
        sum += sin(dot(p * float(i), vec2(1.7, 2.3))) / float(i);
    }
    return sum;
}
void mainImage(out vec4 color, in vec2 at) {
    vec2 place = at / iResolution.xy;
    if (place.x > 0.7) {
        discard;
    }
    color = vec4(waves(place * 10.0), place, 1.0);
}
"""


@pytest.mark.parametrize("rate", ["half", "quarter"])
def test_what_is_discarded_by_its_place_is_no_fault(
    gpu: Gpu, rate: PayloadRate, tmp_path: Path
) -> None:
    """Texels discard by their places in the whole picture, of which a small one shows a corner."""
    path = tmp_path / "place.frag"
    path.write_text(DISCARDS_BY_PLACE, encoding="utf-8")
    opened = open_scene(path, ReadOptions(dialect="shadertoy"))
    node = next(n for n in opened[1].nodes if n.legal and n.text == "waves(place * 10.0)")
    slower = Configuration(payload_rate=rate)
    with closing(Verifier(gpu, opened, (64, 64), configuration=slower)) as verifier:
        found = verifier.check(node, plain=False)
    assert found.algorithms == {"3-pass"}
    assert not found.broken, found.reasons


def test_objects_with_shaders_of_their_own_hide_each_other(gpu: Gpu) -> None:
    """The ground under the heroine is drawn into the same cache, with the same depth buffer."""
    opened = open_scene(data_path("corpus", "heroine", "scene.toml"))
    node = opened[1].node(opened[0].nodes["surface"])
    slower = Configuration(payload_rate="half")
    with closing(Verifier(gpu, opened, (64, 64), configuration=slower)) as verifier:
        found = verifier.check(node, plain=False)
    assert found.algorithms == {"3-pass"}
    assert not found.broken, found.reasons


def test_what_is_discarded_before_others_is_no_fault(gpu: Gpu) -> None:
    """Behind what a shader discards, others are seen, which have their payloads from texels."""
    opened = test_conditions.load("discards")
    node = next(n for n in opened[1].nodes if n.legal and n.text == "noise(floor(p * 2.0))")
    slower = Configuration(payload_rate="half")
    with closing(Verifier(gpu, opened, (48, 40), configuration=slower)) as verifier:
        found = verifier.check(node, plain=False)
    assert found.algorithms == {"3-pass"}
    assert not found.broken, found.reasons


def test_the_sign_of_zero_is_kept(gpu: Gpu) -> None:
    """Of one texel that weighs 1 a pixel takes every bit."""
    opened = test_conditions.load("choices")
    text = "base * (uv.y < 0.3 ? noise(floor(p * 9.0)) : 1.0)"
    node = next(n for n in opened[1].nodes if n.legal and n.text == text)
    slower = Configuration(payload_rate="half")
    with closing(Verifier(gpu, opened, (48, 40), configuration=slower)) as verifier:
        found = verifier.check(node, plain=False)
    assert found.algorithms == {"3-pass"}
    assert not found.broken, found.reasons
