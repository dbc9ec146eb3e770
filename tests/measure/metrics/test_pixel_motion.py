"""Motion and flicker on made-up surfaces that slide by known amounts."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.measure.image_error import Floats
from shadercache.measure.metrics.flicker import flicker
from shadercache.measure.metrics.pixel_motion import NEAR, PixelMotion, motion_between
from shadercache.render.surfaces import Surface

HEIGHT, WIDTH = 6, 8
ALL = np.ones((HEIGHT, WIDTH), bool)


def surface(right: float = 0.0, up: float = 0.0) -> Surface:
    """A plane that fills the picture, and moved so far since the frame before."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH] + 0.5
    whole = np.ones((HEIGHT, WIDTH))
    place = np.stack([x - right, y - up], axis=-1)
    return Surface(number=whole.astype(np.int64), inverse_w=whole, place=place, before=whole)


def ramp() -> Floats:
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    return np.stack([x, y, 0.0 * x], axis=-1).astype(np.float32)


def test_at_rest_everything_is_where_it_was() -> None:
    motion = motion_between(surface(), surface())
    assert motion.both.all()
    assert np.array_equal(motion.warped(ramp()), ramp())


@pytest.mark.parametrize("off", [1e-4, -1e-4])
def test_at_rest_the_border_counts_however_places_are_rounded(off: float) -> None:
    assert motion_between(surface(off, off), surface()).both.all()


@pytest.mark.parametrize(
    ("right", "up"),
    [(2.0, 0.0), (0.0, 1.0), (0.5, 0.25), (-2.0, 0.0), (0.0, -1.0), (-0.5, -0.25), (0.5, -0.25)],
)
def test_a_ramp_that_moves_is_found_again(right: float, up: float) -> None:
    """But for what was not between four pixels, on whichever side that is."""
    motion = motion_between(surface(right, up), surface())
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    inside = (x >= right) & (y >= up) & (x - right <= WIDTH - 1) & (y - up <= HEIGHT - 1)
    assert np.array_equal(motion.both, inside)
    expected = ramp() - np.array([right, up, 0.0], np.float32)
    assert np.allclose(motion.warped(ramp())[inside], expected[inside], atol=1e-6)


def test_what_was_hidden_or_another_surface_is_not_seen_twice() -> None:
    before = surface()
    before.number[2, 3] = 2
    before.inverse_w[4, 5] = 1.0 + 1.5 * NEAR
    both = motion_between(surface(), before).both
    # In the middle of a pixel the others do not weigh, but nobody rounds that exactly: all four
    # have to agree.
    gone = np.zeros_like(ALL)
    gone[1:3, 2:4] = gone[3:5, 4:6] = True
    assert np.array_equal(both, ~gone)


def test_a_point_that_has_no_place_is_not_seen_twice() -> None:
    now = surface()
    now.place[1, 1] = np.nan
    now.before[2, 2] = -1.0
    both = motion_between(now, surface()).both
    assert not both[1, 1] and not both[2, 2] and both.sum() == ALL.sum() - 2


def test_values_come_from_the_nearest_pixel() -> None:
    motion = motion_between(surface(right=1.4), surface())
    values = np.arange(HEIGHT * WIDTH).reshape(HEIGHT, WIDTH)
    assert np.array_equal(motion.nearest(values)[:, 2:], values[:, 1:-1])


def errors(seed: int) -> Floats:
    shown = np.random.default_rng(seed).normal(0.0, 0.1, (HEIGHT, WIDTH, 3))
    return shown.astype(np.float32)


def test_an_error_that_moves_along_does_not_flicker() -> None:
    before = errors(1)
    now = np.roll(before, 2, axis=1)
    moving = motion_between(surface(right=2.0), surface())
    assert flicker(now, before, moving, ALL) == (0.0, HEIGHT * (WIDTH - 2))


def test_an_error_that_stays_on_the_screen_does() -> None:
    before = np.zeros((HEIGHT, WIDTH, 3), np.float32)
    before[:, ::2] = 0.5
    moving = motion_between(surface(right=1.0), surface())
    squares, pixels = flicker(before, before, moving, ALL)
    assert pixels == HEIGHT * (WIDTH - 1)
    assert squares == pytest.approx(3 * 0.25 * pixels)


def test_only_covered_pixels_flicker() -> None:
    now, before = errors(2), np.zeros((HEIGHT, WIDTH, 3), np.float32)
    covered = ALL.copy()
    covered[:, :4] = False
    squares, pixels = flicker(now, before, motion_between(surface(), surface()), covered)
    assert pixels == HEIGHT * 4
    assert squares == pytest.approx(float(np.sum(now[:, 4:].astype(np.float64) ** 2)))


def test_it_is_the_error_of_the_change() -> None:
    """(cached now - cached before) - (original now - original before), each at the same points."""
    original_before, cached_before = errors(3), errors(4)
    original, cached = errors(5), errors(6)
    motion = PixelMotion(surface(right=0.3, up=0.6).place, ALL)
    change = (cached - motion.warped(cached_before)) - (original - motion.warped(original_before))
    squares, _ = flicker(cached - original, cached_before - original_before, motion, ALL)
    assert squares == pytest.approx(float(np.sum(change.astype(np.float64) ** 2)), rel=1e-5)
