"""A worker: a process of its own that carries out trials, watched by the one that asks.

A shader that hangs the driver, or crashes it, takes the worker along and nobody else.
"""

from __future__ import annotations

from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection
from time import monotonic
from typing import Any

from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.resource import Resource
from shadercache.sweep.plan import SceneFile, SweepTrial
from shadercache.sweep.row import Failure, FailureKind, Machine
from shadercache.sweep.trial_room import Finished, TrialRoom


@dataclass(frozen=True, slots=True)
class Patience:
    """How long nothing may be heard of a worker, in seconds: ``least`` to begin with, which is for
    compiling; then also ``frames`` times what a frame of the original takes."""

    least: float = 90.0
    frames: float = 100.0

    def limit(self, original: float) -> float:
        """With a frame of the original known to take so many seconds."""
        return self.least + self.frames * original


class WorkerLostError(Exception):
    """The worker died, or was killed since it was silent for too long."""

    def __init__(self, failure: Failure, original_drawn: bool) -> None:
        super().__init__(failure.message)
        self.failure, self.original_drawn = failure, original_drawn


class Worker(Resource):
    """Hands requests to a process and waits for the answer; a lost process is started anew."""

    def __init__(self, patience: Patience | None = None) -> None:
        self._patience = patience or Patience()
        self._spawn = get_context("spawn")  # a forked child would share the parent's driver state
        self._process: Any = None
        self._pipe: Connection | None = None

    def machine(self) -> Machine:
        """Where it draws. Raises :class:`GraphicsError` SC601, :class:`WorkerLostError`."""
        machine: Machine = self._ask("machine")
        return machine

    def original_seconds(self, file: SceneFile, size: tuple[int, int]) -> float:
        """As :meth:`TrialRoom.original_seconds`. Raises :class:`WorkerLostError` as well."""
        seconds: float = self._ask("original", file, size)
        return seconds

    def carry_out(self, trial: SweepTrial) -> Finished:
        """As :meth:`TrialRoom.carry_out`. Raises :class:`WorkerLostError` as well."""
        finished: Finished = self._ask("trial", trial)
        return finished

    def _ask(self, *request: Any) -> Any:
        pipe = self._started()
        limit, original_drawn = self._patience.limit(0.0), False
        try:
            pipe.send(request)
            while True:
                begun = monotonic()
                if not pipe.poll(limit):
                    raise self._lost("hung", monotonic() - begun, original_drawn)
                kind, value = pipe.recv()
                if kind == "original":
                    limit, original_drawn = self._patience.limit(value), True
                elif kind == "error":
                    raise value
                elif kind == "answer":
                    return value
        except (EOFError, ConnectionError):
            raise self._lost("crashed", 0.0, original_drawn) from None

    def _lost(self, kind: FailureKind, silent: float, original_drawn: bool) -> WorkerLostError:
        self.release()
        message = "the process that drew it died: the driver crashes"
        if kind == "hung":
            message = f"nothing was drawn for {silent:.0f} s: the shader hangs, or nearly so"
        return WorkerLostError(Failure(kind, "SC606", message), original_drawn)

    def _started(self) -> Connection:
        if self._pipe is None:
            self._pipe, theirs = self._spawn.Pipe()
            self._process = self._spawn.Process(target=_serve, args=(theirs,), daemon=True)
            self._process.start()
            theirs.close()
        return self._pipe

    def release(self) -> None:
        """End the process."""
        if self._pipe is not None:
            self._pipe.close()
            self._process.kill()
            self._process.join()
            self._pipe = None


def _serve(pipe: Connection) -> None:
    """Answer requests until the other side goes away."""
    room: TrialRoom | None = None
    try:
        while True:
            kind, *arguments = pipe.recv()
            try:
                room = room or TrialRoom()
                if kind == "machine":
                    answer: Any = room.machine
                elif kind == "original":
                    answer = room.original_seconds(*arguments)
                else:
                    (trial,) = arguments
                    answer = room.carry_out(trial, lambda *said: pipe.send(said))
                pipe.send(("answer", answer))
            except DiagnosticError as error:
                pipe.send(("error", error))
    except (EOFError, ConnectionError, KeyboardInterrupt):
        pass  # whoever asked is gone, and what was not handed over is lost with the trial
