"""Pictures of a made surface: tiles with noise, their bumps and their roughness."""

from __future__ import annotations

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Numbers = NDArray[np.float64]

SIZE = 256
_TILES = 4
_WAVES = 48
_STEEPNESS = 6.0


def made_pictures() -> dict[str, bytes]:
    """PNG files by their role, as ``parts.ROLES`` has it; of roughness the green channel is that.

    They have detail at every size down to a few texels, so that a reuse that blurs or slides is
    seen. They repeat without a seam.
    """
    noise, gap = _noise(), _gaps()
    warm, cold = np.array([205.0, 150.0, 95.0]), np.array([70.0, 95.0, 125.0])
    share = np.clip(0.5 + 0.9 * noise, 0.0, 1.0)[..., None]
    albedo = (warm * share + cold * (1.0 - share)) * (1.0 - 0.6 * gap[..., None])
    rough = np.clip(0.45 + 0.35 * noise + 0.3 * gap, 0.05, 1.0)
    height = 0.25 * noise - gap
    slopes = [np.roll(height, -1, axis) - np.roll(height, 1, axis) for axis in (1, 0)]
    steep = _STEEPNESS / 8.0
    normal = np.stack([-steep * slopes[0], -steep * slopes[1], np.ones_like(height)], -1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    metal = np.zeros_like(rough)
    return {
        "albedo": _png(albedo / 255.0),
        "normal": _png(0.5 + 0.5 * normal),
        "roughness": _png(np.stack([np.ones_like(rough), rough, metal], -1)),
    }


def _noise() -> Numbers:
    """A sum of waves in all directions, which fits its own other side; about -1 to 1."""
    random = np.random.default_rng(739_949)
    y, x = np.mgrid[:SIZE, :SIZE] * (2.0 * np.pi / SIZE)
    total = np.zeros((SIZE, SIZE))
    for wave in range(_WAVES):
        across, up = random.integers(-2, 3, 2) << (wave // 8)
        total += np.cos(across * x + up * y + random.uniform(0.0, 2.0 * np.pi)) / (1 + wave // 8)
    scaled: Numbers = total / (2.0 * total.std())
    return scaled


def _gaps() -> Numbers:
    """One between the tiles, zero on them."""
    place = np.arange(SIZE) % (SIZE // _TILES)
    edge = np.clip(1.5 - np.minimum(place, SIZE // _TILES - place) / 2.0, 0.0, 1.0)
    gaps: Numbers = np.maximum(edge[:, None], edge[None, :])
    return gaps


def _png(colors: Numbers) -> bytes:
    packed = io.BytesIO()
    pixels = np.clip(np.round(255.0 * colors), 0.0, 255.0).astype(np.uint8)
    Image.fromarray(pixels).save(packed, "PNG")
    return packed.getvalue()
