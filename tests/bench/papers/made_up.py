"""Measurements that nobody took: times as shares of an original, with a steady small noise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from bench.papers.scene_nodes import NodeFacts
from bench.papers.turns import Series, Turns
from shadercache.caching.algorithms import USUAL

FRAMES, ORIGINAL = 24, 0.05


def samples(share: float, noise: float, seed: int) -> tuple[float, ...]:
    """Seconds; ``noise`` is their relative spread."""
    by = np.random.default_rng(seed).normal(1.0, noise, FRAMES)
    return tuple(float(ORIGINAL * share * each) for each in by)


def turns(
    shares: Mapping[str, float],
    bare: float = 0.1,
    errors: Mapping[str, float] | None = None,
    noise: float = 0.002,
) -> Turns:
    """What such shares of the original's time would look like."""
    series = tuple(
        Series(name, samples(share, noise, seed), (errors or {}).get(name, 0.0))
        for seed, (name, share) in enumerate(shares.items(), start=2)
    )
    return Turns(samples(1.0, noise, 0), samples(bare, noise, 1), series)


def facts(number: int, ratio: float, overlap: float = 0.0) -> NodeFacts:
    """A node."""
    return NodeFacts(f"node{number}", f"f({number})", "main", 1, ratio, overlap)


def curves(
    times: Mapping[str, Sequence[float]], periods: Sequence[int], block: int
) -> dict[str, float]:
    """Shares by label, of the algorithms' curves over the period."""
    return {
        f"{name} n{period} k{block}": share
        for name in USUAL
        for period, share in zip(periods, times[name], strict=True)
    }
