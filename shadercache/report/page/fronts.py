"""Which of several points nothing beats in both time and error."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

Point: TypeAlias = tuple[float, float]
"""Time and error; less is better in both."""


def pareto_front(points: Sequence[Point]) -> list[int]:
    """The numbers of the points that no other is better than in one and as good in the other.

    By ascending time, so with falling error. Of equal points the first is taken.
    """
    front: list[int] = []
    least = float("inf")
    for number in sorted(range(len(points)), key=lambda one: points[one]):
        error = points[number][1]
        if error < least:
            least = error
            front.append(number)
    return front
