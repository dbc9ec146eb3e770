"""Carry out a plan: each trial by the worker, its rows into the store as soon as it ends."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from shadercache.diagnostics import DiagnosticError
from shadercache.sweep.plan import SweepTrial
from shadercache.sweep.results import failure_row
from shadercache.sweep.row import Failure, Row
from shadercache.sweep.store import Store
from shadercache.sweep.trial_room import Finished
from shadercache.sweep.worker import Worker, WorkerLostError

Heard = Callable[[Row], None]
"""Called with each row once it is in the store."""


def carry_out(trials: Sequence[SweepTrial], worker: Worker, store: Store, heard: Heard) -> None:
    """Carry out trials in their order. A failure is a row, and the next trial follows.

    Raises as ``Store.keep``; what was finished before is kept.
    """
    hopeless: dict[object, Failure] = {}
    for trial in trials:
        scene = (trial.file, trial.scene.size)
        if scene in hopeless:
            keep(store, all_failed(trial, hopeless[scene]), heard)
            continue
        for part in parts(trial, worker, hopeless):
            keep(store, part, heard)


def parts(trial: SweepTrial, worker: Worker, hopeless: dict[object, Failure]) -> Sequence[Finished]:
    """What became of a trial; of one that takes the worker along, each configuration by itself.

    Args:
        hopeless: scenes whose originals cannot be drawn, and why; may be added to.
    """
    try:
        return [worker.carry_out(trial)]
    except DiagnosticError as error:  # the original itself cannot be drawn
        first = error.diagnostics[0]
        failure = Failure("rejected", first.code, first.message)
    except WorkerLostError as lost:
        if lost.original_drawn and len(trial.configurations) > 1:
            # The original was drawn, so the scene is sound: one of the configurations is to blame.
            # Which of them it was shows when they come one by one.
            alone = [replace(trial, configurations=(one,)) for one in trial.configurations]
            return [part for one in alone for part in parts(one, worker, hopeless)]
        failure = lost.failure
        if lost.original_drawn:
            return [all_failed(trial, failure)]
    hopeless[trial.file, trial.scene.size] = failure
    return [all_failed(trial, failure)]


def all_failed(trial: SweepTrial, failure: Failure) -> Finished:
    """The same failure for every configuration of a trial."""
    return Finished(tuple(failure_row(trial, one, failure) for one in trial.configurations), {})


def keep(store: Store, finished: Finished, heard: Heard) -> None:
    """Write rows into the store, then tell of them. Raises as ``Store.keep``."""
    store.keep(finished.rows, finished.blobs)
    for row in finished.rows:
        heard(row)
