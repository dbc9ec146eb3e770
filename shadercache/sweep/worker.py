"""A worker: a process of its own that carries out trials, watched by the one that asks.

A shader that hangs the driver, or crashes it, takes the worker along and nobody else.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from subprocess import Popen
from typing import Any

from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.resource import Resource
from shadercache.sweep.plan import SceneFile, SweepTrial
from shadercache.sweep.row import Failure, FailureKind, Machine
from shadercache.sweep.trial_room import Finished, TrialRoom

ORIGINALS = 100.0
"""A worker that is silent for as long as so many frames of the original, and a while, hangs."""

PATIENCE = 90.0
"""That while in seconds, unless told otherwise: programs are compiled in it."""


@dataclass(frozen=True, slots=True)
class Request:
    """What a worker is asked: a method of :class:`TrialRoom` and its arguments."""

    method: str
    arguments: tuple[Any, ...] = ()


class WorkerLostError(Exception):
    """The worker died, or was killed since it was silent for too long."""

    def __init__(self, failure: Failure, original_drawn: bool) -> None:
        super().__init__(failure.message)
        self.failure, self.original_drawn = failure, original_drawn


class Worker(Resource):
    """Hands requests to a process and waits for the answer; a lost process is started anew."""

    def __init__(self, patience: float = PATIENCE) -> None:
        """Args: ``patience`` as :data:`PATIENCE`."""
        self._patience = patience
        # Not of multiprocessing: a Dask worker, which is daemonic, may have no such children.
        self._process: Popen[bytes] | None = None
        self._pipe: Connection | None = None

    def machine(self) -> Machine:
        """Where it draws. Raises :class:`GraphicsError` SC601, :class:`WorkerLostError`."""
        machine: Machine = self._ask(Request("machine"))
        return machine

    def original_seconds(self, file: SceneFile, size: tuple[int, int]) -> float:
        """As :meth:`TrialRoom.original_seconds`. Raises :class:`WorkerLostError` as well."""
        seconds: float = self._ask(Request("original_seconds", (file, size)))
        return seconds

    def carry_out(self, trial: SweepTrial) -> Finished:
        """As :meth:`TrialRoom.carry_out`. Raises :class:`WorkerLostError` as well."""
        finished: Finished = self._ask(Request("carry_out", (trial,)))
        return finished

    def _ask(self, request: Request) -> Any:
        limit, original_drawn = self._patience, False
        try:
            pipe = self._started()
            pipe.send(request)
            # Each message starts the wait anew: only silence counts, however long a trial takes.
            while pipe.poll(limit):
                kind, value = pipe.recv()
                if kind == "original":
                    limit, original_drawn = self._patience + ORIGINALS * value, True
                elif kind == "error":
                    raise value
                elif kind == "answer":
                    return value
        except (EOFError, ConnectionError):
            message = "the process that drew it died: the driver crashes"
            raise self._lost("crashed", message, original_drawn) from None
        message = f"nothing was drawn for {limit:.0f} s: the shader hangs, or nearly so"
        raise self._lost("hung", message, original_drawn)

    def _lost(self, kind: FailureKind, message: str, original_drawn: bool) -> WorkerLostError:
        self.release()
        return WorkerLostError(Failure(kind, "SC606", message), original_drawn)

    def _started(self) -> Connection:
        if self._pipe is None:
            self._pipe, theirs = Pipe()
            code = "import sys; from shadercache.sweep.worker import serve; serve(int(sys.argv[1]))"
            number = theirs.fileno()
            self._process = Popen([sys.executable, "-c", code, str(number)], pass_fds=[number])
            # While this process holds their end as well, a dead worker would never read as the end.
            theirs.close()
        return self._pipe

    def release(self) -> None:
        """End the process."""
        if self._pipe is not None:
            self._pipe.close()
            self._pipe = None
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None


def serve(number: int) -> None:
    """Answer the requests that come through a pipe, until the other side goes away.

    Args:
        number: the file descriptor of this end of the pipe.
    """
    pipe = Connection(number)
    room: TrialRoom | None = None
    try:
        while True:
            request: Request = pipe.recv()
            try:
                # At the first request, so that a missing OpenGL is an answer and no dead worker.
                room = room or TrialRoom(lambda *said: pipe.send(said))
                pipe.send(("answer", getattr(room, request.method)(*request.arguments)))
            except DiagnosticError as error:
                pipe.send(("error", error))
    except (EOFError, ConnectionError, KeyboardInterrupt):
        pass  # whoever asked is gone, and what was not handed over is lost with the trial
