"""The error of each frame of a run in one metric, as it is drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Literal, TypeAlias, get_args

from shadercache.diagnostics import usage_error
from shadercache.gpu.color_targets import holds_integers, shown
from shadercache.measure.image_error import Floats, Mask, Pixels, encoded_pair
from shadercache.measure.metrics.flicker import flicker
from shadercache.measure.metrics.flip_error import flip_error
from shadercache.measure.metrics.pixel_motion import PixelMotion
from shadercache.measure.output_errors import OutputErrors

Metric: TypeAlias = Literal["rmse", "psnr", "flip", "flicker"]
"""``rmse`` over all outputs (``OutputErrors``), and ``psnr``, the same in decibels; ``flip``: the
mean LDR-FLIP of what is shown; ``flicker`` of it since the frame before."""

METRICS: tuple[Metric, ...] = get_args(Metric)


@dataclass(frozen=True, eq=False)
class Compared:
    """A frame by the original and by a variant: every output of both, which pixels count, and how
    they have moved since the frame before (None at the first one, or where nobody asked)."""

    originals: Sequence[Pixels]
    images: Sequence[Pixels]
    covered: Mask
    motion: PixelMotion | None = None

    @property
    def encoded(self) -> tuple[Floats, Floats]:
        """What is shown of both. Raises :class:`InputError` SC604 for NaN and infinity."""
        pictures = [at for at, one in enumerate(self.originals) if not holds_integers(one)]
        seen = pictures[0] if pictures else 0
        return encoded_pair(shown(self.originals[seen]), shown(self.images[seen]))


class FrameErrors:
    """``values``: the error of each frame that was added; 0 is none, and more is worse."""

    def __init__(self, metric: Metric) -> None:
        """Raises :class:`UsageError` SC046 where the metric's library is not installed."""
        if metric == "flip" and find_spec("flip_evaluator") is None:
            hint = "pip install 'shadercache[metrics]'"
            raise usage_error("SC046", "FLIP needs flip-evaluator, which is not installed", hint)
        self.values: list[float] = []
        self._metric, self._outputs = metric, OutputErrors()
        self._before: Floats | None = None

    @property
    def needs_motion(self) -> bool:
        """Is it asked how pixels have moved?"""
        return self._metric == "flicker"

    def add(self, frame: Compared) -> None:
        """Compare a frame; frames come one after another where their change counts.

        Raises :class:`InputError` SC604 for NaN and infinity.
        """
        if self._metric == "flip":
            self.values.append(flip_error(*frame.encoded, frame.covered) or 0.0)
        elif self._metric == "flicker":
            self._add_change(frame)
        else:
            error = self._outputs.add(frame.originals, frame.images, frame.covered)
            self.values.append(error)

    def _add_change(self, frame: Compared) -> None:
        original, image = frame.encoded
        error, before = image - original, self._before
        self._before = error
        # The first frame changes nothing.
        if before is None or frame.motion is None:
            return
        squares, pixels = flicker(error, before, frame.motion, frame.covered)
        self.values.append(math.sqrt(squares / (3 * pixels)) if pixels else 0.0)
