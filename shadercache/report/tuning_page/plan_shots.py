"""What plans draw at one frame of a scene, beside the original: the pictures of a tuning's page."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from shadercache.caching.configuration import Assignment
from shadercache.diagnostics import DiagnosticError
from shadercache.linking.linker import Linker
from shadercache.measure.image_error import ErrorStats, ErrorSum, Mask, Pixels
from shadercache.measure.measurement import Probe, Shot
from shadercache.render.pass_runners import CoverageRunner, OriginalRunner, PayloadRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.description import Scene

Plan: TypeAlias = tuple[tuple[int, int], ...]
"""Numbers of families, each with its period in frames."""

Value: TypeAlias = tuple[int, int]
"""The number of a group, and of a value in it."""

Drawing: TypeAlias = Callable[[str], None]
"""Called with what is drawn next."""

SHOWN = 52
"""The frame that is shown: then payloads with the longest period that is tried are as old as they
get."""

STEADY = 4
"""Frames that are drawn beyond a period before the one that is shown."""


@dataclass(frozen=True, slots=True)
class DrawnPlan:
    """A plan, what draws it, and the objects that it leaves to their originals."""

    plan: Plan
    assignment: Assignment
    without: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class PlanShot:
    """A plan at a frame, in which objects ``without`` it are drawn by their originals; ``error`` of
    what is shown then, over the covered pixels."""

    plan: Plan
    without: tuple[str, ...]
    frame: int
    shot: Shot
    error: ErrorStats


def shown_frame(scene: Scene) -> int:
    """The frame that pictures show: one in which something still moves."""
    keys = scene.view.camera_path.keys
    ends = [SHOWN]
    if keys:
        ends.append(keys[-1].frame - 1)
    if scene.recording is not None:
        ends.append(scene.recording.frames - 1)
    return max(1, min(ends))


def original_of(world: RenderScene, linker: Linker, frame: int) -> Pixels:
    """The frame as the original draws it. Raises as ``OriginalRunner``."""
    with OriginalRunner(world, *linker.originals()) as runner:
        runner.draw(frame)
        return world.targets.shown()


def shots_of(
    world: RenderScene,
    linker: Linker,
    plans: Sequence[DrawnPlan],
    frame: int,
    drawing: Drawing,
) -> list[PlanShot]:
    """Draw each plan until its payloads are as old as they get, and keep that frame.

    A plan that cannot be drawn there is left out. Raises as ``OriginalRunner``.
    """
    reference = original_of(world, linker, frame)
    with CoverageRunner(world, *linker.originals()) as coverage:
        covered = coverage.coverage(frame)
    beside = _Original(world, linker, reference, covered)
    found = []
    for plan in plans:
        drawing("pictures")
        try:
            found.append(beside.shot(plan, frame))
        except DiagnosticError:  # what cannot be drawn here has no picture
            continue
    return found


@dataclass(frozen=True, eq=False)
class _Original:
    world: RenderScene
    linker: Linker
    pixels: Pixels
    covered: Mask

    def shot(self, drawn: DrawnPlan, frame: int) -> PlanShot:
        """Raises as ``Linker.link`` and ``BoundPass``; :class:`InputError` SC604."""
        longest = max(period for _, period in drawn.plan)
        with VariantRunner(self.world, *self.linker.link(drawn.assignment)) as runner:
            for before in range(max(0, frame - longest - STEADY), frame):
                runner.draw(before)
            mask = runner.outcomes(frame)
            runner.draw(frame)
            cached = self.world.targets.shown()
            probe = Probe(mask, runner.bundle.mask_values, runner.ages(), longest)
            shot = Shot("", runner.configuration, self.pixels, cached, probe)
        error = ErrorSum()
        error.add(self.pixels, cached, self.covered)
        return PlanShot(drawn.plan, drawn.without, frame, shot, error.stats())


def payloads_of(
    world: RenderScene,
    linker: Linker,
    values: Mapping[Value, Assignment],
    frame: int,
    drawing: Drawing,
) -> Iterator[tuple[Value, Pixels]]:
    """Each value as it is computed at a frame; one that cannot be drawn is left out."""
    for value, assignment in values.items():
        drawing("payloads")
        try:
            with PayloadRunner(world, *linker.link(assignment)) as runner:
                runner.draw(frame)
                yield value, world.targets.shown()
        except DiagnosticError:
            continue
