"""S8: points behind the camera, across its plane, and at the very edge of the picture."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.caching.configuration import FilterKind
from shadercache.gpu.context import Gpu
from tests.configured import configured

from .plane import SIZE, Plane, plane

pytestmark = pytest.mark.xdist_group("gl")

FILTERS = ["bilinear", "nearest", "bilateral", "lanczos2", "mitchell", "carried"]
OLD, NEW = (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)


def reused(made: Plane, **before: object) -> np.ndarray:
    """Which pixels, (h, w), take from the last frame what was stored by a plane at rest, where
    their own points were at ``before`` in that frame."""
    made.draw(0, u_value=OLD)
    made.runner.last_values = made.values | before
    image = made.draw(1, u_value=NEW)
    assert np.isfinite(image).all()
    assert np.isfinite(made.cached()).all()
    return image[..., 0] > 0.25


@pytest.mark.parametrize("kind", FILTERS)
def test_what_was_behind_the_camera_misses(gpu: Gpu, kind: FilterKind) -> None:
    for w in (0.0, -4.0, -1e-30, 1e-30, 1e30, np.inf, -np.inf, np.nan):
        made = plane(gpu, configured(filter=kind, refresh="none"))
        assert not reused(made, u_plane=(0.0, 0.0, w)).any(), w


@pytest.mark.parametrize("kind", FILTERS)
def test_a_plane_through_the_camera_misses_behind_it(gpu: Gpu, kind: FilterKind) -> None:
    """Its 1/w runs through infinity to the other sign across the picture."""
    made = plane(gpu, configured(filter=kind, refresh="none"))
    assert not reused(made, u_plane=(4.0, 0.0, 0.0))[:, : SIZE // 2].any()


@pytest.mark.parametrize("kind", FILTERS)
def test_the_edge_of_the_picture_is_sharp(gpu: Gpu, kind: FilterKind) -> None:
    """A texel's centre is the last place that was seen: uv of exactly 0 or 1 misses."""
    for pixels in (-0.5, 0.0, 0.5, 1.0):
        made = plane(gpu, configured(filter=kind, refresh="none"))
        found = reused(made, u_pan=(-pixels, 0.0))
        at = np.arange(SIZE) - pixels
        expected = (at >= 0.0) & (at <= SIZE - 1)
        assert np.array_equal(found, np.broadcast_to(expected, found.shape)), pixels


def test_at_rest_everything_is_reused(gpu: Gpu) -> None:
    assert reused(plane(gpu, configured(refresh="none"))).all()
