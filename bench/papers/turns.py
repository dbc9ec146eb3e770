"""What is drawn in turns in the papers' experiments, and the samples that are kept of it.

Everything is drawn by ``measure()``, but as foreign subjects: timed and compared, without the
masks, floors and resets that a table of ``shadercache bench`` has. That is a third of the time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from shadercache.caching.configuration import Configuration, Filter, Refresh
from shadercache.linking.linker import Linker
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.statistics import Ratio, StopRule, paired_ratio, widest
from shadercache.measure.subjects import Subject, VariantSubject
from shadercache.render.bundle import LinkedObject
from shadercache.render.pass_runners import PayloadRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER, VariantRunner

PERIOD, BLOCK = 32, 4
"""Those of figure 8 of Sitthi-amorn et al. 2008."""

HALF_WIDTH = 0.05
"""Batches end when every interval is this narrow, as a share of its ratio (half of its width)."""


class Drawing(Protocol):
    """What draws a frame and can be given back."""

    def draw(self, frame: int) -> None:
        """Draw it."""

    def release(self) -> None:
        """Give it back."""


class _Foreign:
    """A subject by what it draws with, which ``make`` compiles."""

    def __init__(self, label: str, subject: VariantSubject) -> None:
        self.label, self.subject = label, subject
        self._drawing: Drawing | None = None

    def make(self, world: RenderScene) -> Drawing:
        """What draws it; raises as ``VariantRunner``."""
        return VariantRunner(world, *self.subject.objects, short_reset=True)

    def prepare(self, world: RenderScene) -> None:
        """Compile all passes, those of a reset and those behind it. Raises as ``make``."""
        self._drawing = self.make(world)
        for frame in (0, 1):
            self.draw(frame)

    def draw(self, frame: int) -> None:
        """Draw a frame."""
        assert self._drawing is not None
        if frame == 0 and isinstance(self._drawing, VariantRunner):
            self._drawing.reset()
        self._drawing.draw(frame)

    def release(self) -> None:
        """Give programs and caches back."""
        if self._drawing is not None:
            self._drawing.release()


class Variant(_Foreign):
    """A variant as it is shipped."""


class PayloadAlone(_Foreign):
    """The payload in place of the colour: P."""

    def make(self, world: RenderScene) -> Drawing:
        """Raises as ``BoundPass``."""
        return PayloadRunner(world, *self.subject.objects)


class AllHits(_Foreign):
    """A variant at rest of which nothing is refreshed: every pixel is a hit. T_hit."""

    def make(self, world: RenderScene) -> Drawing:
        """Raises as ``VariantRunner``."""
        objects = [
            LinkedObject(linked.bundle, linked.configuration and _never(linked.configuration))
            for linked in self.subject.objects
        ]
        return VariantRunner(world, *objects, moving=False, short_reset=True)


class TwoTargets(_Foreign):
    """The original with the payload as a second render target: the second of two passes, alone."""

    def draw(self, frame: int) -> None:
        """Draw a frame."""
        assert isinstance(self._drawing, VariantRunner)
        self._drawing.draw_pass(frame, "miss")


def _never(configuration: Configuration) -> Configuration:
    return configuration.with_refresh(NEVER)


def as_in_the_papers(nodes: Sequence[str], algorithm: str = "2-pass") -> Configuration:
    """Bilinear look-ups, blocks refreshed by a hash: section 2.1 of Sitthi-amorn et al. 2008."""
    return Configuration(
        tuple(nodes), algorithm, Refresh("random", PERIOD, BLOCK), Filter("bilinear")
    )


@dataclass(frozen=True, slots=True)
class Series:
    """Seconds of each frame, and the error over the compared ones (display-encoded, 0-1)."""

    label: str
    times: tuple[float, ...]
    rmse: float


@dataclass(frozen=True, slots=True)
class Turns:
    """What was drawn in turns. All series are of the same frames, the reset frame left out."""

    original: tuple[float, ...]
    geometry: tuple[float, ...]
    series: tuple[Series, ...]

    def of(self, label: str) -> Series:
        """The series of a subject. Raises :class:`KeyError`."""
        for one in self.series:
            if one.label == label:
                return one
        raise KeyError(label)

    def has(self, label: str) -> bool:
        """Was it drawn?"""
        return any(one.label == label for one in self.series)

    def ratio(self, first: str, second: str) -> Ratio:
        """The time of one over that of another."""
        return paired_ratio(self.of(first).times, self.of(second).times)

    def speedup(self, label: str) -> Ratio:
        """The original's time over the subject's."""
        return paired_ratio(self.original, self.of(label).times)

    def slowdown(self, label: str) -> Ratio:
        """The subject's time over the original's."""
        return paired_ratio(self.of(label).times, self.original)

    def relative(self, times: Sequence[float]) -> float:
        """A time as a share of the original's: the median over the frames of both."""
        return float(np.median(np.divide(times, self.original)))

    def share(self, label: str) -> float:
        """The subject's time as a share of the original's."""
        return self.relative(self.of(label).times)

    @property
    def bare(self) -> float:
        """The geometry's time as a share of the original's."""
        return self.relative(self.geometry)

    def cost(self, label: str) -> float:
        """P/T: a subject's share of the original, both less the geometry."""
        return (self.share(label) - self.bare) / max(1e-9, 1.0 - self.bare)

    @property
    def widest(self) -> float:
        """Half of the widest interval of any speed-up, as a share of it."""
        return widest(self.speedup(one.label) for one in self.series)


def take_turns(
    world: RenderScene, linker: Linker, subjects: Sequence[Subject], how: MeasureOptions
) -> Turns:
    """Draw all subjects in the same turns; their labels differ. Raises as ``measure``."""
    how = replace(how, group=len(subjects), curves=0, weigh=False)
    [group] = measure(world, linker.originals(), subjects, how).groups
    return Turns(
        original=_rounded(group.original.samples),
        geometry=_rounded(group.geometry.samples),
        series=tuple(
            Series(other.label, _rounded(other.timing.samples), float(f"{other.error.rmse:.4g}"))
            for other in group.others
        ),
    )


def until_known(frames: int, seconds: float, half_width: float = HALF_WIDTH) -> MeasureOptions:
    """So many frames, which are repeated until all is known or so many seconds have passed."""
    return MeasureOptions(frames, stop=StopRule(half_width, seconds))


def _rounded(times: Sequence[float]) -> tuple[float, ...]:
    """To a tenth of a microsecond: files are half as large."""
    return tuple(round(time, 7) for time in times)
