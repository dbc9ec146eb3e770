"""How much memory the textures of a variant take."""

from __future__ import annotations

from shadercache.gpu.cache_textures import texel_bytes
from shadercache.render.bundle import Bundle

BUFFERS = 2
"""Caches that swap each frame."""


def bytes_per_pixel(bundle: Bundle, algorithm: str) -> float:
    """Bytes for each pixel of the picture: both caches, and what passes hand on within a frame.

    Depth buffers are not counted. Raises as :meth:`Bundle.passes`.
    """
    cache = bundle.cache
    caches = BUFFERS * sum(map(texel_bytes, cache.formats)) / cache.divisor**2
    handed_on = {
        name: texel
        for spec in bundle.passes(algorithm)
        for name, texel in spec.parked.items()
        if name in spec.targets
    }
    return caches + sum(map(texel_bytes, handed_on.values()))
