"""How large an error may be."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shadercache.diagnostics import usage_error
from shadercache.measure.metrics.frame_errors import Metric

_LARGEST: dict[Metric, float] = {"rmse": 1.0, "psnr": math.inf, "flip": 1.0, "flicker": 2.0}


HEADROOM = 0.9
"""How much of a bound the worst of the frames that are looked at may use: they are a few dozen, and
others are worse."""


@dataclass(frozen=True, slots=True)
class Bound:
    """``limit`` of the error in a metric, for every frame; of the PSNR in decibels, the least."""

    metric: Metric
    limit: float

    def __post_init__(self) -> None:
        """Raises :class:`UsageError` SC008 for what no error is below, or all are."""
        if not 0.0 < self.limit <= _LARGEST[self.metric]:
            hint = "what moves is never reused to the last bit: give a bound above 0"
            raise usage_error("SC008", f"'{self.limit:g}' is no bound for {self.metric}", hint)

    @property
    def error(self) -> float:
        """The limit where 0 is no error: of a PSNR the RMSE."""
        return 10.0 ** (-self.limit / 20.0) if self.metric == "psnr" else self.limit

    @property
    def aim(self) -> float:
        """What an error that was measured has to stay within, so that other frames do as well."""
        return HEADROOM * self.error

    def told(self, error: float) -> str:
        """An error in the metric, as it is shown."""
        if self.metric != "psnr":
            return f"{error:.4f}"
        return f"{-20.0 * math.log10(error):.1f} dB" if error > 0.0 else "inf dB"

    def __str__(self) -> str:
        unit = " dB" if self.metric == "psnr" else ""
        return f"{self.metric} {self.limit:g}{unit}"
