"""From the error of payloads of one age to the error of a refresh period.

In a run that refreshes nothing, all that was found in frame a is a frames old, so one run shows the
error of every age. With a period of n frames the ages 0 to n - 1 are equally frequent.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from shadercache.measure.metrics.frame_errors import Metric


def error_of_period(ages: Mapping[int, float], period: int, metric: Metric) -> float:
    """The error of a period in frames, from errors by age; between these it is interpolated.

    Args:
        ages: age 0 is the frame after a reset. The period must not exceed the oldest age by more
            than one.

    Raises:
        ValueError: an older payload is asked for than was seen.
    """
    known = sorted(ages)
    if period - 1 > known[-1]:
        raise ValueError(f"no payload is {period - 1} frames old; the oldest is {known[-1]}")
    errors = np.interp(np.arange(period), known, [ages[age] for age in known])
    if metric == "flip":  # a mean over pixels
        return float(np.mean(errors))
    if metric != "flicker":  # pixels of all ages lie beside each other, so squares add
        return float(np.sqrt(np.mean(errors**2)))
    # What flickers are the pixels that are refreshed, whose error vanishes, and the growth of the
    # others' errors.
    return float(np.sqrt((errors[-1] ** 2 + np.sum(np.diff(errors) ** 2)) / period))
