"""S6 and law 6: values that no cache can hold, injected for one frame."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.harness.context import Gpu
from shadercache.options import CacheFormat, CacheOptions, FilterKind

from .criteria import Criteria
from .plane import SIZE, Plane, plane

pytestmark = pytest.mark.xdist_group("gl")

POISONS = {
    "nan": np.nan,
    "inf": np.inf,
    "-inf": -np.inf,
    "65505": 65505.0,
    "-1e30": -1e30,
    "subnormal": 1e-40,
    "small": 3e-6,
}
FITS_FLOATS = ("65505", "-1e30")
"""Those that 32 bits hold."""

SPOT = (0.5, 0.5)
CLEAN = (0.25, 0.5, 0.75)
LIMITS = {"rgba16f": (65504.0, 2.0**-24), "rgba32f": (float(np.finfo(np.float32).max), 2.0**-126)}


def injected(made: Plane, poison: float) -> np.ndarray:
    """A clean frame, then one with the poison, all computed; the colours of the second."""
    made.draw(0, period=1, u_value=CLEAN)
    spike = (poison, 0.5, 0.5)
    return made.draw(1, period=1, u_spot=SPOT, u_spike=spike)


def stored(made: Plane) -> np.ndarray:
    """The payloads of all texels, (n, 3)."""
    return made.cached()[..., :3].reshape(-1, 3)


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
def test_none_is_stored_and_the_pixel_is_right(
    gpu: Gpu, stress: Criteria, form: CacheFormat, algorithm: str
) -> None:
    made = plane(gpu, CacheOptions(guard="miss"), form, algorithm)
    at = SIZE // 2
    most, least = LIMITS[form]
    bad = 0
    for name, poison in POISONS.items():
        made.runner.reset()
        image = injected(made, poison)
        shown = poison
        if algorithm == "3-pass":
            # The third pass reads what comes nearest among what the cache can hold.
            shown = (
                0.0 if name == "nan" else float(np.clip(poison, -LIMITS[form][0], LIMITS[form][0]))
            )
        expected = np.array([shown, 0.5, 0.5], np.float32) * np.float32(0.5)
        if name == "subnormal":
            # Drivers may flush it, before the guard or behind it.
            assert 0.0 <= image[at, at, 0] < 1e-37
            expected[0] = image[at, at, 0]
        if name == "small":
            # The third pass reads what half floats made of it.
            assert image[at, at, 0] == pytest.approx(expected[0], abs=2.0**-25)
            expected[0] = image[at, at, 0]
        assert np.array_equal(image[at, at], expected, equal_nan=True), name
        held = stored(made)
        fine = np.isfinite(held) & (np.abs(held) <= most)
        bad += np.count_nonzero(~(fine & ((held == 0.0) | (np.abs(held) >= least))))
        if name not in ("subnormal", "small"):
            fits = form == "rgba32f" and name in FITS_FLOATS
            assert (held[at * SIZE + at, 0] == np.float32(poison)) == fits, name
    stress.none(f"values of {len(POISONS)} kinds in the cache that it cannot hold", bad)


@pytest.mark.parametrize("kind", ["bilinear", "bilateral", "lanczos2", "mitchell", "nearest"])
@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
def test_it_is_gone_one_frame_later(gpu: Gpu, algorithm: str, kind: FilterKind) -> None:
    """Although every filter reads across the spot."""
    cached = CacheOptions(guard="miss", filter=kind, refresh="none")
    made = plane(gpu, cached, "rgba16f", algorithm)
    for poison in (np.nan, np.inf, 65505.0):
        made.runner.reset()
        made.draw(0, u_value=CLEAN, u_spot=SPOT, u_spike=(poison, poison, poison), u_pan=(0, 0))
        image = made.draw(1, u_spot=(1e3, 1e3), u_pan=(0.4, 0.3))
        assert image == pytest.approx(
            np.broadcast_to(np.float32(CLEAN) * 0.5, image.shape), abs=1e-6
        )
        assert np.isfinite(made.cached()).all()


def test_without_a_guard_it_spreads(gpu: Gpu) -> None:
    """What the others say would mean nothing else."""
    made = plane(gpu, CacheOptions(guard="off", refresh="none"))
    made.draw(0, u_value=CLEAN, u_spot=SPOT, u_spike=(np.nan, np.nan, np.nan))
    image = made.draw(1, u_spot=(1e3, 1e3), u_pan=(0.4, 0.3))
    assert not np.isfinite(image).all()


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
def test_a_clamped_cache_is_finite(gpu: Gpu, form: CacheFormat, algorithm: str) -> None:
    made = plane(gpu, CacheOptions(guard="clamp"), form, algorithm)
    for poison in POISONS.values():
        made.runner.reset()
        injected(made, poison)
        held = stored(made)
        assert np.isfinite(held).all()
        assert np.abs(held).max() <= LIMITS[form][0]
