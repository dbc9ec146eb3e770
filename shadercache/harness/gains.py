"""Which objects are worth caching, measured: the others are drawn by their originals.

What a scene's own shader is cached for was asked; objects with shaders of their own come along, and
may cost a frame more than they save it.
"""

from __future__ import annotations

from contextlib import ExitStack
from functools import partial
from pathlib import Path

from shadercache.harness.clock import Clock, no_collection
from shadercache.harness.measurement import Entry, Gain, MeasureOptions
from shadercache.harness.runner import RunOptions, VariantRunner
from shadercache.harness.stage import Stage
from shadercache.harness.stats import Ratio, paired_ratio

WARM_UP = 3
"""Frames that are not timed: a reset, and the first that reuse."""

WEIGHED = 12
"""Frames that are, for each shader and algorithm."""


def weigh(stage: Stage, entry: Entry, options: MeasureOptions, clock: Clock) -> tuple[Gain, ...]:
    """Time the scene with and without caching the objects of each shader but the scene's own.

    The runs take turns frame by frame, from frame 0 on. Raises as ``VariantRunner``.
    """
    shaders: dict[Path, list[str]] = {}
    for prop in stage.props:
        if prop.item.own_shader and prop.item.cached:
            shaders.setdefault(prop.scene.fragment, []).append(prop.item.name)
    found = []
    for shader, names in shaders.items():
        other = stage.without_caching(names)
        ratios = {name: _ratio(stage, other, entry, name, options, clock) for name in entry.chosen}
        if ratios:
            best = max(ratios, key=lambda name: ratios[name].median)
            found.append(Gain(shader.name, tuple(names), best, ratios[best]))
    return tuple(found)


def _ratio(
    stage: Stage, other: Stage, entry: Entry, name: str, options: MeasureOptions, clock: Clock
) -> Ratio:
    run = RunOptions(options.period, options.block, options.epsilon, options.cache_format)
    times: tuple[list[float], list[float]] = ([], [])
    with ExitStack() as held, no_collection():
        runners = [
            held.enter_context(VariantRunner(on, entry.bundle, name, run)) for on in (other, stage)
        ]
        for frame in range(WARM_UP + WEIGHED):
            stage.prepare(frame)
            other.prepare(frame)
            for kept, runner in zip(times, runners, strict=True):
                kept.append(clock.time(partial(runner.draw, frame)))
    without, cached = (kept[WARM_UP:] for kept in times)
    return paired_ratio(without, cached)
