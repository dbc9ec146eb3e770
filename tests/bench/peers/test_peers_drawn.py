"""What peers show: the original, as far as each of them can."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from bench.peers.comparison import PEERS
from bench.peers.peer import OF_DEPTH, SEARCH, read_shader
from bench.peers.scene_programs import color_node
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from tests.bench.peers.small_scene import FRAMES, SIZE, corpus, drawn, ring
from tests.shaders import analysed

pytestmark = pytest.mark.xdist_group("gl")

DRAWN = [name for name in PEERS if name != "fewer"]  # the ring has no cheaper shader
WHOLE = [name for name in DRAWN if not name.endswith("bilinear")]
"""Those that draw the objects themselves, and so cover what the original covers."""


@pytest.mark.parametrize("name", DRAWN)
def test_what_moves_is_where_it_is(gpu: Gpu, tmp_path: Path, name: str) -> None:
    seen = drawn(gpu, ring(tmp_path), name)
    for frame in (FRAMES - 2, FRAMES - 1):
        error = seen.rmse(frame)
        assert error < 0.05
        for axis in ((1, 0), (0, 1)):
            there = seen.rmse(frame, axis)
            back = seen.rmse(frame, (-axis[0], -axis[1]))
            assert error < 0.8 * min(there, back)
            # Half a pixel off, one way would be three times as far as the other.
            assert 0.6 < there / back < 1.6


@pytest.mark.parametrize("name", WHOLE)
def test_it_covers_what_the_original_covers(gpu: Gpu, tmp_path: Path, name: str) -> None:
    seen = drawn(gpu, ring(tmp_path), name)
    for image, truth, covered in zip(seen.images, seen.truth, seen.covered, strict=True):
        assert np.array_equal(image[..., 3] > 0, covered)
        # The darkest of the pattern is 0.25: what is black was never shaded.
        assert truth[covered, :3].max(axis=-1).min() > 40
        assert image[covered, :3].max(axis=-1).min() > 40


@pytest.mark.parametrize("name", DRAWN)
def test_one_colour_stays_that(gpu: Gpu, tmp_path: Path, name: str) -> None:
    seen = drawn(gpu, ring(tmp_path, "constant"), name)
    # Colours that are accumulated are rounded to half floats on the way.
    most = 1 if name == "temporal" else 0
    for frame in range(FRAMES):
        where = seen.covered[frame] if name in WHOLE else seen.inside(frame)
        assert seen.apart(frame)[where].max() <= most


def test_half_the_frames_are_the_original(gpu: Gpu, tmp_path: Path) -> None:
    seen = drawn(gpu, ring(tmp_path), "half-rate")
    for frame in range(FRAMES):
        assert (seen.apart(frame).max() == 0) == (frame % 2 == 0)
    # Warped, the last frame is far nearer than as it was.
    odd = FRAMES - 2
    stale = np.abs(seen.truth[odd - 1] - seen.truth[odd]).max(axis=-1)[seen.inside(odd)]
    assert seen.apart(odd)[seen.inside(odd)].mean() < 0.25 * stale.mean()


def test_at_rest_half_the_frames_are_as_good_as_all(gpu: Gpu, tmp_path: Path) -> None:
    seen = drawn(gpu, ring(tmp_path, turns=False), "half-rate")
    assert all(seen.apart(frame).max() == 0 for frame in range(FRAMES))


def fresh(frame: int) -> np.ndarray:
    """The fields of the checkerboard that are shaded in a frame, (h, w)."""
    y, x = np.indices((SIZE, SIZE))
    return (x + y + frame) % 2 == 0


def test_half_of_a_checkerboard_is_the_original(gpu: Gpu, tmp_path: Path) -> None:
    seen = drawn(gpu, ring(tmp_path), "checkerboard")
    for frame in range(FRAMES):
        apart, where = seen.apart(frame), seen.inside(frame, 1)
        # The same places in another viewport: interpolation rounds a little differently.
        assert apart[where & fresh(frame)].max() <= 1
        assert apart[where & ~fresh(frame)].max() > 2


def test_at_rest_a_checkerboard_is_whole_from_the_second_frame_on(gpu: Gpu, tmp_path: Path) -> None:
    seen = drawn(gpu, ring(tmp_path, turns=False), "checkerboard")
    inside = seen.inside(0, 1)
    assert seen.apart(0)[inside].max() > 1
    # The last picture is kept within the colours around, so the finest points are worn off.
    for frame in range(1, FRAMES):
        assert np.mean(seen.apart(frame)[inside] <= 1) > 0.9
        assert seen.rmse(frame) < 0.5 * seen.rmse(0)


def test_at_rest_samples_accumulate(gpu: Gpu, tmp_path: Path) -> None:
    still = ring(tmp_path, turns=False)
    seen = drawn(gpu, still, "temporal")
    assert seen.rmse(FRAMES - 1) < 0.6 * seen.rmse(0)
    assert seen.rmse(FRAMES - 1) < 0.6 * drawn(gpu, still, "half-depth").rmse(0)


def test_a_cached_colour_of_a_longer_period_is_farther_off(gpu: Gpu, tmp_path: Path) -> None:
    # The colour of the ring does not change with the view: what is wrong is resampled.
    setting = ring(tmp_path)
    short, long = (drawn(gpu, setting, "color", which).rmse(FRAMES - 1) for which in (0, 2))
    assert 0.0 < short < long


def test_finer_detail_needs_a_finer_picture(gpu: Gpu, tmp_path: Path) -> None:
    setting = ring(tmp_path)
    for how in ("bilinear", "depth"):
        half, quarter = (
            drawn(gpu, setting, f"{share}-{how}").rmse(3) for share in ("half", "quarter")
        )
        assert half < 0.7 * quarter


@pytest.mark.parametrize("name", ["half-depth", "quarter-depth"])
def test_some_of_what_a_smaller_picture_has_lost_is_found_nearby(
    gpu: Gpu, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    wire = ring(tmp_path, "constant", thinner=0.28)
    shares = []
    for steps in (0, SEARCH):
        monkeypatch.setattr("bench.peers.peer.SEARCH", steps)
        seen = drawn(gpu, wire, name)
        assert seen.covered[0].any() and not seen.inside(0).any()
        pairs = zip(seen.images, seen.covered, strict=True)
        shares.append(
            np.mean([np.mean(image[mask, :3].max(axis=-1) == 0) for image, mask in pairs])
        )
    assert 0.0 < shares[1] < 0.7 * shares[0]


def test_textures_have_the_detail_of_the_large_picture(gpu: Gpu) -> None:
    can, last = corpus("trashcan"), FRAMES - 1
    seen = drawn(gpu, can, "checkerboard")
    shaded = seen.inside(last, 2) & fresh(last)
    # One level of detail coarser, they would be seven levels off.
    assert seen.apart(last)[shaded].mean() < 0.5
    accumulated, upsampled = (
        drawn(gpu, can, name).rmse(last) for name in ("temporal", "half-depth")
    )
    assert accumulated < 0.8 * upsampled


@pytest.mark.parametrize("name", ["checkerboard", "temporal"])
def test_the_original_has_its_textures_as_before(gpu: Gpu, name: str) -> None:
    can = corpus("trashcan")
    alone, beside = (drawn(gpu, can, peer).truth for peer in ("half-rate", name))
    assert all(np.array_equal(*pair) for pair in zip(alone, beside, strict=True))


def test_the_colour_is_the_last_that_is_written() -> None:
    analysis = analysed("o_color = vec4(v_normal, 1.0);\no_color = vec4(sin(v_position), 1.0);")
    assert color_node(analysis).text == "sin(v_position)"
    analysis = analysed("o_color = vec4(sin(v_position), v_uv.x);")
    assert color_node(analysis).text == "vec4(sin(v_position), v_uv.x)"
    with pytest.raises(InputError, match="no value that can be cached"):
        color_node(analysed("o_color = vec4(1.0);"))


def test_parts_of_a_shader_stand_behind_its_version() -> None:
    text = read_shader("half_rate.frag", *OF_DEPTH, "reproject.glsl").text
    assert text.startswith("#version 330\n#extension GL_ARB_texture_gather : require\nuniform")
    assert text.index("own_surface(") < text.index("last_place()") < text.index("void main()")
