"""Which objects are worth caching, measured: the others are drawn by their originals.

What a scene's own shader is cached for was asked; objects with shaders of their own come along, and
may cost a frame more than they save it.
"""

from __future__ import annotations

from contextlib import ExitStack
from functools import partial
from pathlib import Path

from shadercache.gpu.clock import Clock, no_collection
from shadercache.measure.measurement import CachingGain, Entry, MeasureOptions
from shadercache.measure.statistics import Ratio, paired_ratio
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import RunOptions, VariantRunner

WARM_UP = 3
"""Frames that are not timed: a reset, and the first that reuse."""

WEIGHED = 12
"""Frames that are, for each shader and algorithm."""


def weigh(
    world: RenderScene, entry: Entry, options: MeasureOptions, clock: Clock
) -> tuple[CachingGain, ...]:
    """Time the scene with and without caching the objects of each shader but the scene's own.

    The runs take turns frame by frame, from frame 0 on. Raises as ``VariantRunner``.
    """
    shaders: dict[Path, list[str]] = {}
    for drawable in world.drawables:
        if drawable.item.own_shader and drawable.item.cached:
            shaders.setdefault(drawable.scene.fragment, []).append(drawable.item.name)
    found = []
    for shader, names in shaders.items():
        other = world.without_caching(names)
        ratios = {name: _ratio(world, other, entry, name, options, clock) for name in entry.chosen}
        if ratios:
            best = max(ratios, key=lambda name: ratios[name].median)
            found.append(CachingGain(shader.name, tuple(names), best, ratios[best]))
    return tuple(found)


def _ratio(
    world: RenderScene,
    other: RenderScene,
    entry: Entry,
    name: str,
    options: MeasureOptions,
    clock: Clock,
) -> Ratio:
    run = RunOptions(options.period, options.block, options.epsilon, options.cache_format)
    times: tuple[list[float], list[float]] = ([], [])
    with ExitStack() as held, no_collection():
        runners = [
            held.enter_context(VariantRunner(on, entry.bundle, name, run)) for on in (other, world)
        ]
        for frame in range(WARM_UP + WEIGHED):
            world.prepare(frame)
            other.prepare(frame)
            for kept, runner in zip(times, runners, strict=True):
                kept.append(clock.time(partial(runner.draw, frame)))
    without, cached = (kept[WARM_UP:] for kept in times)
    return paired_ratio(without, cached)
