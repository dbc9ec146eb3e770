"""Where a frame of two passes goes, part by part.

Each part is the difference of two times: with it, and without it (by ablation). All that is timed
is drawn in turns, frame by frame, as in :mod:`shadercache.measure.measure`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.algorithms import FIRST, PROFILED, LeftOut
from shadercache.caching.configuration import Configuration
from shadercache.linking.linker import Linker
from shadercache.measure.measure import Progress, measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.statistics import Ratio, paired_ratio
from shadercache.render.bundle import LinkedObject
from shadercache.render.draw_items import OLDEST_IN_HALF
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER, VariantRunner

NOTHING = ""
"""No pass has this name: to draw it is to clear targets, and to draw what is not cached."""

Seconds = NDArray[np.float64]
"""Of each frame that was timed."""


@dataclass(frozen=True, slots=True)
class FramePart:
    """What a part takes, as a share of the original's frame, with its 95 % interval."""

    name: str
    share: Ratio


@dataclass(frozen=True, slots=True)
class Profile:
    """A frame's parts in the order in which they are drawn.

    ``original``: its median, in seconds. ``frame``: the whole, as a share of it. ``unexplained`` is
    what is left of the frame beside all parts.
    """

    configuration: Configuration
    original: float
    frame: Ratio
    parts: tuple[FramePart, ...]
    unexplained: Ratio


class _Run:
    """A variant's frames."""

    def __init__(self, label: str, objects: Sequence[LinkedObject]) -> None:
        self.label, self._objects = label, objects
        self._runner: VariantRunner | None = None

    @property
    def runner(self) -> VariantRunner:
        """What draws it, once it is prepared."""
        assert self._runner is not None
        return self._runner

    def prepare(self, world: RenderScene) -> None:
        """Raises as ``VariantRunner``."""
        self._runner = VariantRunner(world, *self._objects, short_reset=True)

    def draw(self, frame: int) -> None:
        """Draw a frame."""
        if frame == 0:
            self.runner.reset()
        self.runner.draw(frame)

    def release(self) -> None:
        """Give everything back."""
        if self._runner is not None:
            self._runner.release()


class _PassOfRun:
    """One pass of the frame that a run is about to draw, alone."""

    def __init__(self, label: str, run: _Run, name: str = FIRST) -> None:
        self.label, self._run, self._name = label, run, name

    def prepare(self, world: RenderScene) -> None:
        """The run has what it needs."""

    def draw(self, frame: int) -> None:
        """Draw the pass."""
        self._run.runner.draw_pass(frame, self._name)

    def release(self) -> None:
        """The run does."""


class _FirstPass(_Run):
    """The first pass alone, of programs that look nothing up."""

    def prepare(self, world: RenderScene) -> None:
        """Raises as ``VariantRunner``."""
        super().prepare(world)
        self.runner.draw(0)  # a frame after a reset would leave the pass out

    def draw(self, frame: int) -> None:
        """Draw the pass."""
        self.runner.draw_pass(frame, FIRST)


def profile(
    world: RenderScene,
    linker: Linker,
    configuration: Configuration,
    options: MeasureOptions,
    progress: Progress | None = None,
) -> Profile:
    """Time a configuration's frame and its parts; its algorithm is taken to be two passes.

    Raises as ``measure`` and ``Linker.link``.
    """
    chosen = replace(configuration, algorithm=PROFILED)
    longest = OLDEST_IN_HALF if chosen.refresh.age else NEVER
    # A period that adapts is a matter of turns as well.
    without_turns = replace(chosen, refresh=replace(chosen.refresh, schedule="none", adaptive=0.0))

    def objects(which: Configuration, left_out: LeftOut | None = None) -> tuple[LinkedObject, ...]:
        return linker.link(linker.assign(which), left_out=left_out)

    frame = _Run("frame", objects(chosen))
    undecided = _Run("no decision", objects(without_turns.with_refresh(longest)))
    subjects = (
        _PassOfRun("nothing", frame, NOTHING),
        _PassOfRun("first pass", frame),
        frame,
        _Run("nothing due", objects(chosen.with_refresh(longest))),
        _PassOfRun("first pass, no decision", undecided),
        undecided,
        _FirstPass("found", objects(chosen, "look-up")),
        _FirstPass("found, not stored", objects(chosen, "look-up and store")),
    )
    how = replace(options, group=len(subjects), curves=0, perceptual=False)
    group = measure(world, linker.originals(), subjects, how, progress).groups[0]
    times = {other.label: np.asarray(other.timing.samples) for other in group.others}
    original = np.asarray(group.original.samples)
    parts = _parts(times, np.asarray(group.geometry.samples))

    def share(seconds: Seconds) -> Ratio:
        return paired_ratio(seconds.tolist(), original.tolist())

    return Profile(
        configuration=chosen,
        original=group.original.median,
        frame=share(times["frame"]),
        parts=tuple(FramePart(name, share(seconds)) for name, seconds in parts.items()),
        unexplained=share(times["frame"] - np.sum(list(parts.values()), axis=0)),
    )


def _parts(times: dict[str, Seconds], geometry: Seconds) -> dict[str, Seconds]:
    """The parts of a frame from what was timed with and without them."""
    # The bare geometry is drawn on cleared targets as well.
    bare = geometry - times["nothing"]
    return {
        "clears": times["nothing"],
        "geometry, first pass": bare,
        "look-up": times["first pass, no decision"] - times["found"],
        "refresh decision": times["nothing due"] - times["no decision"],
        "shading of hits": times["found, not stored"] - geometry,
        "store": times["found"] - times["found, not stored"],
        "geometry, second pass": bare,
        "shading of misses": times["frame"] - times["first pass"] - bare,
    }
