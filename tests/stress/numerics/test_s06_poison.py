"""S6 and law 6: values that no cache can hold, injected for one frame."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.caching.algorithms import NAMES
from shadercache.caching.configuration import CacheFormat, FilterKind
from shadercache.gpu.context import Gpu
from tests.configured import configured

from .criteria import Criteria
from .plane import SIZE, Plane, plane

pytestmark = pytest.mark.xdist_group("gl")

POISONS = {
    "nan": np.nan,
    "inf": np.inf,
    "-inf": -np.inf,
    "65505": 65505.0,
    "-1e30": -1e30,
    "3e38": 3e38,
    "subnormal": 1e-40,
    "small": 3e-6,
}
FITS_FLOATS = ("65505", "-1e30")
"""Those that 32 bits hold."""

SPOT = (0.5, 0.5)
CLEAN = (0.25, 0.5, 0.75)
LIMITS = {"rgba16f": (65504.0, 2.0**-24), "rgba32f": (2.0**126, 2.0**-126)}
MARK = -65504.0
"""The depth of a texel that no later frame reuses."""


def injected(made: Plane, poison: float) -> np.ndarray:
    """A clean frame, then one with the poison, all computed; the colours of the second."""
    made.draw(0, period=1, u_value=CLEAN)
    spike = (poison, 0.5, 0.5)
    return made.draw(1, period=1, u_spot=SPOT, u_spike=spike)


def reusable(made: Plane) -> np.ndarray:
    """The payloads of all texels that a later frame may reuse, (n, 3)."""
    texels = made.cached().reshape(-1, 4)
    return texels[texels[:, 3] != MARK, :3]


def read_back(poison: float, form: CacheFormat, algorithm: str) -> np.float32:
    """What an algorithm shows of a value: itself, but that the third of three passes reads numbers
    from half floats, which hold no larger ones."""
    rounded = algorithm == "3-pass" and form == "rgba16f" and np.isfinite(poison)
    return np.float32(np.clip(poison, -65504.0, 65504.0) if rounded else poison)


@pytest.mark.parametrize("algorithm", NAMES)
@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
def test_none_is_reusable_and_the_pixel_is_right(
    gpu: Gpu, stress: Criteria, form: CacheFormat, algorithm: str
) -> None:
    made = plane(gpu, configured(guard="miss"), form, algorithm)
    at = SIZE // 2
    most, least = LIMITS[form]
    bad = 0
    for name, poison in POISONS.items():
        made.runner.reset()
        image = injected(made, poison)
        expected = np.array([read_back(poison, form, algorithm), 0.5, 0.5]) * np.float32(0.5)
        if name == "subnormal":
            # Drivers may flush it, before the guard or behind it.
            assert 0.0 <= image[at, at, 0] < 1e-37
            expected[0] = image[at, at, 0]
        if name == "small":
            # The third pass reads what half floats made of it.
            assert image[at, at, 0] == pytest.approx(expected[0], abs=2.0**-25)
            expected[0] = image[at, at, 0]
        assert np.array_equal(image[at, at], expected.astype(np.float32), equal_nan=True), name
        held = reusable(made)
        fine = np.isfinite(held) & (np.abs(held) <= most)
        bad += np.count_nonzero(~(fine & ((held == 0.0) | (np.abs(held) >= least))))
        if name not in ("subnormal", "small"):
            fits = form == "rgba32f" and name in FITS_FLOATS
            assert (made.cached()[at, at, 3] == MARK) != fits, name
            assert len(held) == SIZE * SIZE - (not fits), name
    stress.none(f"values of {len(POISONS)} kinds to be reused that the cache cannot hold", bad)


@pytest.mark.parametrize(
    "kind", ["bilinear", "bilateral", "lanczos2", "mitchell", "nearest", "carried"]
)
@pytest.mark.parametrize("algorithm", NAMES)
def test_it_is_gone_one_frame_later(gpu: Gpu, algorithm: str, kind: FilterKind) -> None:
    """Although every filter reads across the spot."""
    if kind == "carried" and algorithm == "3-pass":
        pytest.skip("refused: test_s21_carried.py")
    cached = configured(guard="miss", filter=kind, refresh="none")
    made = plane(gpu, cached, "rgba16f", algorithm)
    # Three carried floats lie in 32 bits, which hold the last one.
    for poison in (np.nan, np.inf, *[65505.0] * (kind != "carried")):
        made.runner.reset()
        made.draw(0, u_value=CLEAN, u_spot=SPOT, u_spike=(poison, poison, poison), u_pan=(0, 0))
        image = made.draw(1, u_spot=(1e3, 1e3), u_pan=(0.4, 0.3))
        assert image == pytest.approx(
            np.broadcast_to(np.float32(CLEAN) * 0.5, image.shape), abs=1e-6
        )
        assert np.isfinite(made.cached()).all()


def test_without_a_guard_it_spreads(gpu: Gpu) -> None:
    """What the others say would mean nothing else."""
    made = plane(gpu, configured(guard="off", refresh="none"))
    made.draw(0, u_value=CLEAN, u_spot=SPOT, u_spike=(np.nan, np.nan, np.nan))
    image = made.draw(1, u_spot=(1e3, 1e3), u_pan=(0.4, 0.3))
    assert not np.isfinite(image).all()


@pytest.mark.parametrize("algorithm", NAMES)
@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
def test_a_clamped_cache_is_read_as_finite(gpu: Gpu, form: CacheFormat, algorithm: str) -> None:
    """In the frame itself the pixel is right; the next one reuses what comes nearest."""
    cached = configured(guard="clamp", refresh="none")
    made = plane(gpu, cached, form, algorithm)
    at = SIZE // 2
    for name, poison in POISONS.items():
        if name in ("subnormal", "small"):
            continue
        made.runner.reset()
        spike = (poison, 0.5, 0.5)
        shown = made.draw(0, u_value=CLEAN, u_spot=SPOT, u_spike=spike, u_pan=(0, 0))[at, at, 0]
        expected = read_back(poison, form, algorithm) * np.float32(0.5)
        assert np.array_equal(shown, expected, equal_nan=True), name
        most = LIMITS[form][0]
        nearest = np.float32(0.0 if name == "nan" else np.clip(poison, -most, most))
        again = made.draw(1, u_spot=(1e3, 1e3))
        assert again[at, at, 0] == nearest * np.float32(0.5), name
        assert np.isfinite(again).all()
        assert np.isfinite(made.draw(2, u_pan=(0.4, 0.3))).all(), name
        assert np.isfinite(made.cached()).all(), name


@pytest.mark.parametrize("algorithm", NAMES)
def test_what_a_filter_makes_is_kept_alike(gpu: Gpu, algorithm: str) -> None:
    """Between a number above zero and one below a filter finds smaller ones than either: they are
    no poison in any algorithm."""
    made = plane(gpu, configured(refresh="none"), "rgba32f", algorithm, {"least": 0.2})
    made.draw(0, u_value=(0.25, 0.5, 0.75), u_spot=SPOT, u_spike=(-0.25, 0.5, 0.75), u_pan=(0, 0))
    made.draw(1, u_spot=(1e3, 1e3), u_pan=(0.4, 0.3))
    kept = made.cached().reshape(-1, 4)
    filtered = (np.abs(kept[:, 0]) < 0.2) & (kept[:, 1] == 0.5)
    assert filtered.any(), "nothing was filtered, so nothing is tested"
    assert not (kept[filtered, 3] == MARK).any()
