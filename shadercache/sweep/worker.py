"""A worker: a process of its own that carries out trials, watched by the one that asks.

A shader that hangs the driver, or crashes it, takes the worker along and nobody else.
"""

from __future__ import annotations

import os
import pickle
import sys
from contextlib import suppress
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from subprocess import PIPE, Popen
from threading import Thread
from typing import IO, Any

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
        self._child: _Child | None = None

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
            child = self._started()
            child.tell(request)
            # Each message starts the wait anew: only silence counts, however long a trial takes.
            while True:
                kind, value = child.answer(limit)
                if kind == "original":
                    limit, original_drawn = self._patience + ORIGINALS * value, True
                elif kind == "error":
                    raise value
                elif kind == "answer":
                    return value
        except _ChildDiedError:
            message = "the process that drew it died: the driver crashes"
            raise self._lost("crashed", message, original_drawn) from None
        except Empty:
            message = f"nothing was drawn for {limit:.0f} s: the shader hangs, or nearly so"
            raise self._lost("hung", message, original_drawn) from None

    def _lost(self, kind: FailureKind, message: str, original_drawn: bool) -> WorkerLostError:
        self.release()
        return WorkerLostError(Failure(kind, "SC606", message), original_drawn)

    def _started(self) -> _Child:
        if self._child is None:
            self._child = _Child()
        return self._child

    def release(self) -> None:
        """End the process."""
        if self._child is not None:
            self._child.release()
            self._child = None


class _ChildDiedError(Exception):
    """The process is gone."""


class _Child(Resource):
    """The process: requests go to its standard input, and answers come from its standard output.

    It is none of multiprocessing, since a Dask worker, which is daemonic, may have no such
    children; and no other pipe is inherited in the same way by every system.
    """

    def __init__(self) -> None:
        code = "from shadercache.sweep.worker import serve; serve()"
        self.process = Popen([sys.executable, "-c", code], stdin=PIPE, stdout=PIPE)
        assert self.process.stdin is not None and self.process.stdout is not None
        self._requests, self._answers = self.process.stdin, self.process.stdout
        self._heard: SimpleQueue[Any] = SimpleQueue()
        # A thread, since not every system can wait for a pipe for a limited time.
        self._listener = Thread(target=self._listen, daemon=True)
        self._listener.start()

    def _listen(self) -> None:
        try:
            with suppress(EOFError, OSError, pickle.UnpicklingError):
                while True:
                    self._heard.put(pickle.load(self._answers))
        finally:
            self._heard.put(None)

    def tell(self, request: Request) -> None:
        """Hand over a request."""
        # What is dead says so when it is asked for its answer.
        with suppress(EOFError):
            _send(self._requests, request)

    def answer(self, limit: float) -> Any:
        """What it says next. Raises :class:`Empty` after ``limit`` seconds, and
        :class:`_ChildDiedError`."""
        said = self._heard.get(timeout=limit)
        if said is None:
            raise _ChildDiedError
        return said

    def release(self) -> None:
        """End the process, whatever it does."""
        self.process.kill()
        self.process.wait()
        self._listener.join()
        self._answers.close()
        with suppress(OSError):  # of what it has not read
            self._requests.close()


def serve() -> None:
    """Answer the requests that come from standard input, until the other side goes away."""
    answers = os.fdopen(os.dup(1), "wb")
    # What a driver prints must not get between the answers.
    os.dup2(2, 1)
    room: TrialRoom | None = None
    try:
        while True:
            request: Request = pickle.load(sys.stdin.buffer)
            try:
                # At the first request, so that a missing OpenGL is an answer and no dead worker.
                room = room or TrialRoom(lambda *said: _send(answers, said))
                _send(answers, ("answer", getattr(room, request.method)(*request.arguments)))
            except DiagnosticError as error:
                _send(answers, ("error", error))
    except (EOFError, KeyboardInterrupt):
        pass  # whoever asked is gone, and what was not handed over is lost with the trial


def _send(stream: IO[bytes], message: Any) -> None:
    """Raises :class:`EOFError` where nobody is left to read."""
    try:
        stream.write(pickle.dumps(message))
        stream.flush()
    except OSError:  # which of them, differs from system to system
        raise EOFError from None
