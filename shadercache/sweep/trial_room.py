"""Where trials are carried out: an OpenGL context, and the scene that was drawn last.

One process has one room. Nothing here knows the store; rows and pictures are handed out.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from statistics import median

from msgspec import structs

from shadercache.caching.algorithms import PROFILED
from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.clock import Clock, pick_clock
from shadercache.gpu.context import Gpu, open_context
from shadercache.gpu.resource import Resource
from shadercache.linking.linker import Linker
from shadercache.linking.user_places import at_home
from shadercache.measure.frame_profile import Profile, profile
from shadercache.measure.image_error import Pixels
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.result_files import environment
from shadercache.measure.statistics import StopRule
from shadercache.measure.subjects import VariantSubject, subjects_of
from shadercache.render.pass_runners import OriginalRunner, PayloadRunner
from shadercache.render.render_scene import RenderScene
from shadercache.sweep.fingerprint import scene_fingerprint
from shadercache.sweep.pictures import payload_picture
from shadercache.sweep.plan import SceneFile, SweepTrial
from shadercache.sweep.results import Blobs, failure_row, result_rows
from shadercache.sweep.row import Failure, FailureKind, Machine, Row

Say = Callable[[str, float], None]
"""Called with what is going on, and a number: ("original", seconds a frame), ("step", 0)."""

DRAWN_FIRST = 3
"""Frames of the original that are timed before anything else is drawn."""


@dataclass(frozen=True, slots=True)
class Finished:
    """The rows of a trial, and the shaders and pictures that they name."""

    rows: tuple[Row, ...]
    blobs: Mapping[str, bytes]


class TrialRoom(Resource):
    """Carries out trials, one after another."""

    def __init__(self, say: Say) -> None:
        """Raises :class:`GraphicsError` SC601: there is no OpenGL here."""
        self._say = say
        self._gpu = open_context()
        self._clock = pick_clock(self._gpu)
        self._opened: tuple[tuple[SceneFile, tuple[int, int]], Linker, RenderScene] | None = None
        self._seconds, self._fingerprint = 0.0, ""

    def machine(self) -> Machine:
        """Where the numbers come from."""
        return machine_of(self._gpu, self._clock)

    def original_seconds(self, file: SceneFile, size: tuple[int, int]) -> float:
        """What a frame of the original takes; the scene stays open for trials.

        Raises as :meth:`SceneFile.open` and ``OriginalRunner``.
        """
        if self._opened is None or self._opened[0] != (file, size):
            self._close()
            linker = file.open()
            world = RenderScene(self._gpu, linker.scene, size)
            self._opened = (file, size), linker, world
            self._fingerprint = scene_fingerprint(linker)
            with at_home(linker.analysis), OriginalRunner(world, *linker.originals()) as runner:
                runner.draw(0)  # compiles
                times = [self._clock.time(lambda: runner.draw(0)) for _ in range(DRAWN_FIRST)]
            self._seconds = median(times)
        return self._seconds

    def carry_out(self, trial: SweepTrial) -> Finished:
        """Draw the trial's configurations in turns; one that fails has a row that says why.

        The rows are of this machine, and of what the scene's files hold now.

        Raises as :meth:`original_seconds`: then nothing of the scene can be drawn.
        """
        self._say("original", self.original_seconds(trial.file, trial.scene.size))
        # Of what was read here: a file may have changed since the plan was made.
        trial = replace(trial, machine=self.machine(), fingerprint=self._fingerprint)
        failed: dict[Configuration, Failure] = {}
        fitting: list[VariantSubject] = []
        for configuration in trial.configurations:
            compiled = self._compile(trial, configuration)
            if isinstance(compiled, Failure):
                failed[configuration] = compiled
            else:
                fitting.append(compiled)
            # A sign of life: whoever waits for the trial gives up after a long silence.
            self._say("step", 0.0)
        finished = self._measured(trial, fitting) if fitting else Finished((), {})
        rows = [failure_row(trial, one, failure) for one, failure in failed.items()]
        return Finished((*finished.rows, *rows), finished.blobs)

    def _compile(self, trial: SweepTrial, configuration: Configuration) -> VariantSubject | Failure:
        assert self._opened is not None
        linker, payload = self._opened[1], trial.payload
        try:
            subjects = subjects_of(linker, payload.label, [configuration], payload.equal)
            if subjects:
                return subjects[0]
            reason = linker.refused(configuration)[configuration.algorithm]
            return Failure("refused", "SC026", reason)
        except DiagnosticError as error:
            return _failure("refused", error)

    def _measured(self, trial: SweepTrial, subjects: list[VariantSubject]) -> Finished:
        """Measure together; where the driver takes one of them not, each by itself."""
        try:
            return self._measure(trial, subjects)
        except DiagnosticError as error:
            if len(subjects) == 1:
                failure = _failure("rejected", error)
                return Finished((failure_row(trial, subjects[0].configuration, failure),), {})
        alone = [self._measured(trial, [subject]) for subject in subjects]
        blobs = {name: data for finished in alone for name, data in finished.blobs.items()}
        return Finished(tuple(row for finished in alone for row in finished.rows), blobs)

    def _measure(self, trial: SweepTrial, subjects: list[VariantSubject]) -> Finished:
        assert self._opened is not None
        _, linker, world = self._opened
        options = MeasureOptions(
            trial.scene.frames,
            picture_frame=trial.scene.frames - 1,
            curves=0,
            # Which objects are worth caching would be a matter of times; rows must not be.
            weigh=False,
            perceptual=trial.limits.perceptual,
            stop=StopRule(trial.limits.half_width, trial.limits.seconds),
        )
        with at_home(linker.analysis):
            measurement = measure(
                world,
                linker.originals(),
                subjects,
                options,
                self._step,
            )
            profiles = self._profiles(trial, subjects, options)
        blobs = Blobs()
        source, vertex = linker.analysis.fragment, linker.analysis.vertex_source
        texts = {
            "source.frag": blobs.add(source.text.encode()),
            "source.vert": blobs.add(vertex.text.encode()),
        }
        shown = {"payload": blobs.add(payload_picture(self._payload(subjects[0], options)))}
        bundles = {subject.configuration: subject.bundle for subject in subjects}
        rows = [
            structs.replace(row, texts={**texts, **row.texts}, pictures={**shown, **row.pictures})
            for row in result_rows(trial, measurement, bundles, blobs, profiles)
        ]
        return Finished(tuple(rows), blobs.data)

    def _profiles(
        self, trial: SweepTrial, subjects: list[VariantSubject], options: MeasureOptions
    ) -> dict[Configuration, Profile]:
        """Where frames go, if that is asked for: of those in two passes."""
        assert self._opened is not None
        _, linker, world = self._opened
        chosen = [subject.configuration for subject in subjects] if trial.limits.profile else []
        how = replace(options, picture_frame=None)
        return {
            one: profile(world, linker, one, how, self._step)
            for one in chosen
            if one.algorithm == PROFILED
        }

    def _step(self, done: int, steps: int, what: str) -> None:
        self._say("step", 0.0)

    def _payload(self, subject: VariantSubject, options: MeasureOptions) -> Pixels:
        """The payload alone, at the frame of the other pictures."""
        assert self._opened is not None and options.picture_frame is not None
        world = self._opened[2]
        with PayloadRunner(world, *subject.objects) as runner:
            runner.draw(options.picture_frame)
            return world.targets.shown()

    def _close(self) -> None:
        if self._opened is not None:
            self._opened[2].release()
            self._opened = None

    def release(self) -> None:
        """Give everything on the GPU back."""
        self._close()
        self._gpu.release()


def machine_of(gpu: Gpu, clock: Clock) -> Machine:
    """What rows say of where they were measured."""
    where = environment(gpu)
    return Machine(
        renderer=gpu.renderer,
        driver=gpu.version,
        clock=clock.name,
        processor=where["cpu"],
        cores=os.cpu_count() or 1,
        system=f"{where['system']}, Python {platform.python_version()}",
    )


def _failure(kind: FailureKind, error: DiagnosticError) -> Failure:
    first = error.diagnostics[0]
    return Failure(kind, first.code, first.message)
