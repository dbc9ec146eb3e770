"""Which objects are worth caching, measured: the others are drawn by their originals.

What a scene's own shader is cached for was asked; objects with shaders of their own come along, and
may cost a frame more than they save it.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from functools import partial
from pathlib import Path

from shadercache.gpu.clock import Clock, no_collection
from shadercache.measure.measurement import CachingGain
from shadercache.measure.statistics import Ratio, paired_ratio
from shadercache.measure.subjects import VariantSubject
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner

WARM_UP = 3
"""Frames that are not timed: a reset, and the first that reuse."""

WEIGHED = 12
"""Frames that are, for each shader and algorithm."""


def weigh(
    world: RenderScene, subjects: Sequence[VariantSubject], clock: Clock
) -> tuple[CachingGain, ...]:
    """Time the scene with and without caching the objects of each shader but the scene's own.

    Of the first subject's payload the first of each algorithm is taken. Raises as
    ``VariantRunner``.
    """
    if not subjects:
        return ()
    same = [subject for subject in subjects if subject.label == subjects[0].label]
    # The last that is written for a key stays, so the first of each algorithm.
    firsts = {subject.configuration.algorithm: subject for subject in reversed(same)}
    gains = []
    for shader, names in _own_shaders(world, subjects[0]).items():
        ratios = {name: _ratio(world, subject, names, clock) for name, subject in firsts.items()}
        best = max(ratios, key=lambda name: ratios[name].median)
        gains.append(CachingGain(shader.name, tuple(names), best, ratios[best]))
    return tuple(gains)


def _own_shaders(world: RenderScene, subject: VariantSubject) -> dict[Path, list[str]]:
    """Shaders of cached objects beside the scene's own, and the objects' names."""
    shaders: dict[Path, list[str]] = {}
    # One that stands for all objects has no shader but the scene's.
    if len(subject.objects) == len(world.drawables):
        for drawable, linked in zip(world.drawables, subject.objects, strict=True):
            if drawable.scene_object.own_shader and linked.configuration is not None:
                shaders.setdefault(drawable.scene_object.fragment, []).append(
                    drawable.scene_object.name
                )
    return shaders


def _ratio(
    world: RenderScene, subject: VariantSubject, names: Sequence[str], clock: Clock
) -> Ratio:
    times: tuple[list[float], list[float]] = ([], [])
    with ExitStack() as held, no_collection():
        runners = [
            held.enter_context(VariantRunner(world, *drawn.objects))
            for drawn in (subject.with_originals(world, names), subject)
        ]
        for frame in range(WARM_UP + WEIGHED):
            world.prepare(frame)
            for kept, runner in zip(times, runners, strict=True):
                kept.append(clock.time(partial(runner.draw, frame)))
    without, cached = (kept[WARM_UP:] for kept in times)
    return paired_ratio(without, cached)
