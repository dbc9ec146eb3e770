"""From the error of payloads of one age to the error of a refresh period.

In a run that refreshes nothing, all that was found in frame a is a frames old, so one run shows the
error of every age. With a period of n frames the ages 0 to n - 1 are equally frequent where nothing
moves. Where surfaces move, they leave the blocks that wait for their turns: the faster they do, the
more a payload is refreshed by chance, one time in n, and the more payloads are older than n frames.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from shadercache.measure.metrics.frame_errors import Metric

Floats = NDArray[np.float64]

OLDEST = 6
"""Where payloads are refreshed by chance, those older than so many periods hardly count."""


def error_of_period(
    ages: Mapping[int, float], period: int, metric: Metric, straying: float = 0.0
) -> float:
    """The error of a period in frames, from errors by age; between these it is interpolated.

    Args:
        ages: age 0 is the frame after a reset. The period must not exceed the oldest age by more
            than one.
        straying: by how much the share of payloads that are refreshed by chance grows with each
            frame of the period. Flicker is not changed by it.

    Raises:
        ValueError: an older payload is asked for than was seen.
    """
    longest = max(ages)
    if period - 1 > longest:
        raise ValueError(f"no payload is {period - 1} frames old; the oldest is {longest}")
    in_turn = _errors(ages, period)
    if metric == "flicker":
        # What flickers are the pixels that are refreshed, whose error vanishes, and the growth of
        # the others' errors.
        return float(np.sqrt((in_turn[-1] ** 2 + np.sum(np.diff(in_turn) ** 2)) / period))
    # Pixels of all ages lie beside each other, so squares add; FLIP is a mean over pixels.
    power = 1.0 if metric == "flip" else 2.0
    turns, chance = _means(ages, period, power)
    # Infinitely much may stray, but nothing where all is recomputed.
    stray = -np.expm1(-straying * (period - 1)) if period > 1 else 0.0
    return float((turns + stray * (chance - turns)) ** (1.0 / power))


def straying_of(ages: Mapping[int, float], period: int, error: float, metric: Metric) -> float:
    """What ``straying`` makes the error of a period, longer than one frame, what it was found to
    be. 0 where payloads are no older than in turn, infinite where all are refreshed by chance."""
    power = 1.0 if metric == "flip" else 2.0
    turns, chance = _means(ages, period, power)
    if metric == "flicker" or chance <= turns:
        return 0.0
    share = float(np.clip((error**power - turns) / (chance - turns), 0.0, 1.0))
    return float("inf") if share == 1.0 else float(-np.log1p(-share) / (period - 1))


def _means(ages: Mapping[int, float], period: int, power: float) -> tuple[float, float]:
    """The mean error to a power, with payloads that are refreshed in turn, and by chance."""
    errors = _errors(ages, OLDEST * period) ** power
    weights = (1.0 / period) * (1.0 - 1.0 / period) ** np.arange(len(errors))
    return float(np.mean(errors[:period])), float(np.average(errors, weights=weights))


def _errors(ages: Mapping[int, float], count: int) -> Floats:
    """Errors of the ages 0 to ``count`` - 1. Those of payloads older than any that was seen grow on
    with the logarithm of the age."""
    known = sorted(ages)
    found = np.array([ages[age] for age in known])
    wanted = np.arange(count)
    errors: Floats = np.interp(wanted, known, found)
    if len(known) > 2:
        slope = max(0.0, float((found[-1] - found[-2]) / np.log(known[-1] / known[-2])))
        older = wanted > known[-1]
        errors[older] += slope * np.log(wanted[older] / known[-1])
    return errors
