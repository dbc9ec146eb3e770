"""Who carries out the trials of a plan: a worker here, or those of a cluster."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Protocol

from shadercache.cluster import spread
from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.resource import Resource
from shadercache.processes import LostTaskError
from shadercache.sweep.carry_out import Heard, all_failed, carry_out, keep, parts
from shadercache.sweep.plan import SceneFile, SweepTrial
from shadercache.sweep.row import Failure, Machine
from shadercache.sweep.store import Store
from shadercache.sweep.trial_room import Finished
from shadercache.sweep.which_trials import on_each
from shadercache.sweep.worker import Worker, WorkerLostError

Size = tuple[int, int]

LOST = Failure("crashed", "SC606", "every process that drew it died: the driver crashes")


class Crew(Protocol):
    """Workers, and where each of them draws. Rows say which machine they are of."""

    machines: Sequence[Machine]

    def original_seconds(self, file: SceneFile, size: Size) -> float | Failure:
        """What a frame of the original takes, or why it cannot be drawn."""

    def carry_out(self, trials: Sequence[SweepTrial], store: Store, heard: Heard) -> None:
        """Carry out trials; ``heard`` is told of each row in the store. Raises as ``Store``."""


class LocalCrew(Resource):
    """One worker process on this machine."""

    def __init__(self, patience: float) -> None:
        """Raises as :meth:`Worker.machine`."""
        self._worker = Worker(patience)
        self.machines: Sequence[Machine] = (self._worker.machine(),)

    def original_seconds(self, file: SceneFile, size: Size) -> float | Failure:
        """See ``Crew``."""
        return _original_seconds(self._worker, file, size)

    def carry_out(self, trials: Sequence[SweepTrial], store: Store, heard: Heard) -> None:
        """In their order. See ``Crew``."""
        carry_out(on_each(trials, self.machines), self._worker, store, heard)

    def release(self) -> None:
        """End the process."""
        self._worker.release()


class ClusterCrew:
    """The processes of a Dask cluster, each of which draws one trial at a time.

    One that is killed loses nothing: its trial is given to another.
    """

    def __init__(self, client: Any, patience: float) -> None:
        """Raises as :meth:`Worker.machine`."""
        self._client, self._patience = client, patience
        self.machines: Sequence[Machine] = tuple(client.run(_machine, patience).values())

    def original_seconds(self, file: SceneFile, size: Size) -> float | Failure:
        """See ``Crew``; by whichever process is idle."""
        # Not pure: Dask may hand out a pure function's earlier result, and times are taken anew.
        task = self._client.submit(_original, file, size, self._patience, pure=False)
        seconds: float | Failure = task.result()
        return seconds

    def carry_out(self, trials: Sequence[SweepTrial], store: Store, heard: Heard) -> None:
        """Spread over the processes. See ``Crew``."""
        tasks = [(trial, self._patience) for trial in trials]
        for at, finished in spread(self._client, _carry_out, tasks):
            if isinstance(finished, LostTaskError):
                keep(store, all_failed(trials[at], LOST), heard)
                continue
            for part in finished:
                keep(store, part, heard)


# Kept from task to task: it holds an OpenGL context and the scene that was drawn last.
_worker: Worker | None = None
"""That of a Dask worker's process."""


def _here(patience: float) -> Worker:
    global _worker
    _worker = _worker or Worker(patience)
    return _worker


def _machine(patience: float) -> Machine:
    return _here(patience).machine()


def _original(file: SceneFile, size: Size, patience: float) -> float | Failure:
    return _original_seconds(_here(patience), file, size)


def _carry_out(trial: SweepTrial, patience: float) -> Sequence[Finished]:
    worker = _here(patience)
    # What is hopeless each process finds out by itself: none sees the trials of the others.
    return parts(replace(trial, machine=worker.machine()), worker, {})


def _original_seconds(worker: Worker, file: SceneFile, size: Size) -> float | Failure:
    try:
        return worker.original_seconds(file, size)
    except DiagnosticError as error:
        first = error.diagnostics[0]
        return Failure("rejected", first.code, first.message)
    except WorkerLostError as lost:
        return lost.failure
