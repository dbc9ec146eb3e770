"""Laws 2 to 4 and 7 of CONTRIBUTING.md, for the variants of one bundle in proof mode."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from shadercache.caching.configuration import Mode
from shadercache.caching.layout import POISONED
from shadercache.render.bundle import Bundle
from shadercache.render.surfaces import Mask
from shadercache.verify.references import MOVING, References
from shadercache.verify.reuse_checks import DEPTH, Look, Reuse
from shadercache.verify.verdict import (
    PERIOD,
    Difference,
    Image,
    Verdict,
    difference,
    rmse,
    worst_of,
)

ALWAYS = range(3)
# The first frame, which is a reset, and one period, over which `at_rest` counts.
RESTING = range(5)
# Long enough for a payload to get older than a period, if nothing stopped it.
AGEING = range(3 * PERIOD)

Frames = list[tuple[Image, Image]]
"""Colour and cache of each frame of a run."""


def judge(references: References, bundle: Bundle, verdict: Verdict) -> Image | None:
    """Laws 2 to 4 for a proof-mode bundle, and 7 where it keeps ages, into ``verdict``.

    Returns what the cache holds after the first frame, in which every payload is computed; None
    without an algorithm.
    """
    # At a fraction of the rate most pixels take payloads of others, and are not the original's. So
    # the same programs are judged twice: with a texel for each pixel, where they are, and as they
    # are shipped.
    whole = bundle.enlarge()
    reuse, laws = Reuse(references, whole), verdict.laws
    first: Frames = []
    for name in bundle.algorithms:
        laws["always"][name] = refreshed(references, whole, name, "proof")
        laws["resting"][name], resting_fault = _resting(references, reuse, name)
        frames, moving_fault = _reusing(references, reuse, name)
        first = first or frames  # the first algorithm agrees with itself
        laws["agreeing"][name] = _agreement(references, frames, first)
        if verdict.moving is not None:
            # Behind the first frame, which is a reset.
            shown, right = [image for image, _ in frames[1:]], references.images["proof"][1:]
            verdict.moving[name] = rmse(shown, right, references.covered[1:])
        _note(verdict, name, resting_fault, moving_fault)
        if bundle.cache.age_channel is not None:
            verdict.ages[name] = _oldest(references, bundle, name, bundle.cache.age_channel)
    if bundle.cache.divisor > 1:
        _judge_fraction(references, bundle, verdict)
    return first[0][1] if first else None


def _judge_fraction(references: References, bundle: Bundle, verdict: Verdict) -> None:
    """What holds at a fraction of the rate: pixels with payloads of their own are the original, at
    rest each frame is the first one, and texels are reused as pixels of a smaller picture are."""
    reuse, laws = Reuse(references.smaller(bundle.cache.divisor), bundle), verdict.laws
    for name in bundle.algorithms:
        own = _computed(references, bundle, name)
        laws["always"][name] = worst_of((laws["always"][name], own))
        resting, resting_fault = _resting(references, reuse, name)
        laws["resting"][name] = worst_of((laws["resting"][name], resting))
        _, moving_fault = _reusing(references, reuse, name)
        _note(verdict, name, resting_fault, moving_fault)


def _note(verdict: Verdict, name: str, resting_fault: str, moving_fault: str) -> None:
    for law, fault in (("law 3", resting_fault), ("law 4", moving_fault)):
        if fault:
            verdict.faults.setdefault(f"{law} ({name})", fault)


def apart(references: References, mode: Mode, images: Iterable[Image]) -> Difference:
    """How far images of a run, from frame 0 on, are from the original's."""
    return between(images, references.images[mode], references.covered)


def between(images: Iterable[Image], others: Iterable[Image], judged: Iterable[Mask]) -> Difference:
    """How far images of two runs, from frame 0 on, are from each other, in pixels that count."""
    pairs = zip(images, others, judged, strict=False)
    return worst_of(difference(image, original, covered) for image, original, covered in pairs)


def refreshed(references: References, bundle: Bundle, name: str, mode: Mode) -> Difference:
    """Law 2: with everything refreshed in every frame a variant is the original.

    In plain mode it need not be; this is what that changes.
    """
    images = []
    refresh = bundle.configuration.refresh
    never = refresh.schedule == "none" and not refresh.age
    with references.run(bundle, name, period=1) as runner:
        for frame in ALWAYS:
            # Where no period refreshes anything, a reset does. It draws the passes that compute,
            # not those that would find nothing to reuse: compiling these takes a third of plain
            # mode.
            if mode == "plain" or never:
                runner.reset("cut")
            images.append(runner.image(frame))
    return apart(references, mode, images)


def _computed(references: References, bundle: Bundle, name: str) -> Difference:
    """Law 2 at a fraction of the rate: the pixels for which no texel fits."""
    images, judged = [], []
    with references.run(bundle, name) as runner:
        for frame in ALWAYS:
            judged.append(references.covered[frame] & runner.computed(frame))
            images.append(runner.image(frame))
    return between(images, references.images["proof"], judged)


def _resting(references: References, reuse: Reuse, name: str) -> tuple[Difference, str]:
    """Law 3: while nothing moves a variant is the original, however often it reuses; at a fraction
    of the rate it is what its first frame was.

    And it reuses all that is not due. What it reuses that it should not, or does not, in words.
    """
    masks, differences = [], []
    still, covered = references.images["proof"][0], references.covered[0]
    with references.run(reuse.bundle, name, moving=False) as runner:
        if reuse.bundle.cache.divisor > 1:
            still = runner.image(0)
            runner.reset()
        for frame in RESTING:
            if frame > 0:
                masks.append(runner.hit_mask(frame))
            differences.append(difference(runner.image(frame), still, covered))
        return worst_of(differences), reuse.rest_fault(runner, masks, RESTING.stop)


def _reusing(references: References, reuse: Reuse, name: str) -> tuple[Frames, str]:
    """A short run in motion, and what is wrong with what it reuses there, in words."""
    frames: Frames = []
    looks: list[Look] = []
    fault = ""
    with references.run(reuse.bundle, name) as runner:
        for frame in MOVING:
            look = reuse.look(runner, frame) if frame > 0 else None
            if look is not None:
                looks.append(look)
                fault = fault or reuse.previous_fault(runner, frame)
            frames.append((runner.image(frame), runner.cache()))
        return frames, fault or reuse.motion_fault(runner, looks)


def _agreement(references: References, frames: Frames, first: Frames) -> Difference:
    """Law 4: the algorithms agree on colour and cache."""
    # Equal caches before a frame follow from equal caches after the one before.
    pairs = zip(frames, first, references.covered, strict=True)
    return worst_of(
        difference(image, reference, covered)
        for own, other, covered in pairs
        for image, reference in zip(own, other, strict=True)
    )


def _oldest(references: References, bundle: Bundle, name: str, channel: int) -> float:
    """Law 7: the greatest age that is stored in a run in motion."""
    ages = []
    empty = np.float32(bundle.cache.clear[0][DEPTH])
    with references.run(bundle, name) as runner:
        for frame in AGEING:
            runner.draw(frame)
            cache = runner.cache()
            # The sign tells only whether a filter made the payload of a part of its texels.
            depths = cache[..., DEPTH]
            held = (depths != empty) & ~np.isin(depths, POISONED)
            ages.append(np.max(cache[..., channel][held], initial=0.0))
    # Unlike max, which drops a NaN that is not the first: a NaN has to break the law.
    return float(np.max(ages))
