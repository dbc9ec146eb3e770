"""Sets of nodes at random: what may be cached together, and how the rest is refused."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from random import Random

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis
from shadercache.diagnostics import InputError

SIZES = (2, 2, 2, 3, 3, 4)
TRIES = 20
"""Sets that are drawn for each that is wanted: many feed one another or are too wide."""


def random_sets(
    analysis: Analysis, nodes: Sequence[Candidate], random: Random, count: int
) -> tuple[list[tuple[Candidate, ...]], Counter[str]]:
    """About ``count`` sets of the legal ``nodes``, and how often others had which code."""
    found: list[tuple[Candidate, ...]] = []
    refused: Counter[str] = Counter()
    for _ in range(TRIES * count):
        size = min(random.choice(SIZES), len(nodes))
        if len(found) == count or size < 2:
            break
        drawn = tuple(random.sample(nodes, size))
        try:
            analysis.require_all(drawn, unprofitable=True)
        except InputError as error:
            refused.update(item.code for item in error.diagnostics)
        else:
            found.append(drawn)
    return found, refused
