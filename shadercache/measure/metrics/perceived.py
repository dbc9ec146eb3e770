"""What an RMSE hides: structure, what one sees, flicker, age, and the pattern of the refresh."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np

from shadercache.measure.image_error import Floats, Mask
from shadercache.measure.metrics import flip_error, structural
from shadercache.measure.metrics.block_pattern import block_pattern
from shadercache.measure.metrics.flicker import flicker
from shadercache.measure.metrics.flip_error import flip_error as flip_of
from shadercache.measure.metrics.pixel_motion import PixelMotion
from shadercache.measure.metrics.structural import structural_similarity
from shadercache.measure.metrics.texel_age import AgeError, AgeErrors

_MARGIN = max(flip_error.RADIUS, structural.RADIUS)
"""What the metrics with windows see of what is not covered."""

_LIBRARIES = {"skimage": "SSIM needs scikit-image", "flip_evaluator": "FLIP needs flip-evaluator"}


@dataclass(frozen=True, slots=True)
class Perceived:
    """Over the covered pixels of ``frames`` frames; the mean of the frames, unless said otherwise.

    ``ssim``: 1 for equal images (``metrics.structural``). ``flip``: 0 for equal images
    (``metrics.flip_error``). ``flicker``: the root of the mean square over all frames, in
    display-encoded units of 0-1 (``metrics.flicker``). ``pattern``: how far the blocks that are
    refreshed together stand out in the error, about 1 where they do not
    (``metrics.block_pattern``). ``by_age``: the error by the age of what is reused
    (``metrics.texel_age``).

    ``ssim`` and ``flip`` are None without the extra ``metrics``. ``flicker`` is None where no pixel
    was visible in two frames. ``pattern`` is None and ``by_age`` empty of what has no cache, and
    ``pattern`` also where the error has no steps, or the objects are less than eight blocks wide;
    ``by_age`` also where only the shader knows where a point was (``--mapping user``).
    """

    frames: int
    ssim: float | None
    flip: float | None
    flicker: float | None
    pattern: float | None
    by_age: tuple[AgeError, ...]


class PerceivedSum:
    """Adds up what is perceived of one subject. All images are as ``encoded_pair`` gives them."""

    def __init__(self, block: int | None) -> None:
        """Args: ``block``: edge of what is refreshed together, in pixels; None of no variant."""
        self._block = block
        self._frames = 0
        self._lists: dict[str, list[float]] = {"ssim": [], "flip": [], "pattern": []}
        self._changed, self._changing = 0.0, 0
        self.ages = AgeErrors()

    def add(self, original: Floats, image: Floats, covered: Mask) -> None:
        """Add the images of a frame."""
        self._frames += 1
        window = _window(covered)
        shown = original[window], image[window], covered[window]
        if find_spec("skimage") is not None:
            self._keep("ssim", structural_similarity(*shown))
        if find_spec("flip_evaluator") is not None:
            self._keep("flip", flip_of(*shown))
        if self._block is not None:
            error = (image - original)[window].mean(axis=-1)
            self._keep("pattern", block_pattern(error, shown[2], self._block))

    def add_change(self, now: Floats, before: Floats, motion: PixelMotion, covered: Mask) -> None:
        """Add the change of the error from one frame to the next."""
        squares, pixels = flicker(now, before, motion, covered)
        self._changed += squares
        self._changing += pixels

    def result(self) -> Perceived:
        """What was added so far."""
        means = {name: float(np.mean(of)) if of else None for name, of in self._lists.items()}
        changes = 3 * self._changing
        return Perceived(
            frames=self._frames,
            flicker=float(np.sqrt(self._changed / changes)) if changes else None,
            by_age=self.ages.result(),
            **means,
        )

    def _keep(self, name: str, found: float | None) -> None:
        if found is not None:
            self._lists[name].append(found)


def missing_extras() -> list[str]:
    """A note for each metric whose library is not installed."""
    return [
        f"{why}: pip install 'shadercache[metrics]'"
        for module, why in _LIBRARIES.items()
        if find_spec(module) is None
    ]


def _window(covered: Mask) -> tuple[slice[Any, Any, Any], slice[Any, Any, Any]]:
    """The part of an image that the metrics of covered pixels depend on: the rest costs time."""
    rows, columns = np.flatnonzero(covered.any(axis=1)), np.flatnonzero(covered.any(axis=0))
    if not rows.size:
        return slice(None), slice(None)
    return (
        slice(max(0, int(rows[0]) - _MARGIN), int(rows[-1]) + 1 + _MARGIN),
        slice(max(0, int(columns[0]) - _MARGIN), int(columns[-1]) + 1 + _MARGIN),
    )
