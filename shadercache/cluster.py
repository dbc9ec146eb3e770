"""Work spread over the processes of a Dask cluster (extra ``cluster``)."""

from __future__ import annotations

import logging
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib import import_module
from typing import Any, TypeVar

from shadercache.diagnostics import usage_error
from shadercache.processes import LostTaskError

T = TypeVar("T")

CONNECT_SECONDS = 10.0
"""How long a scheduler may take to answer."""

MOST_LOCAL = 64

_LOCAL = re.compile(r"local:(\d{1,3})")


@contextmanager
def open_cluster(address: str) -> Iterator[Any]:
    """A client of the scheduler at an address, or of N worker processes here: ``local:N``.

    Raises:
        UsageError: SC031, the package is missing; SC036, no scheduler answers, there are no
            workers, or one has several threads.
    """
    distributed = _package()
    local = _LOCAL.fullmatch(address)
    if local is None:
        with _connected(distributed, address) as client:
            _check_workers(address, client.scheduler_info(n_workers=-1)["workers"])
            yield client
        return
    count = int(local[1])
    if not 1 <= count <= MOST_LOCAL:
        raise usage_error("SC036", f"'{address}': a local cluster has 1 to {MOST_LOCAL} workers")
    with (
        distributed.LocalCluster(
            n_workers=count,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            # A process that dies is told as what became of its task.
            silence_logs=logging.CRITICAL,
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def _connected(distributed: Any, address: str) -> Any:
    """A client of the scheduler at an address. Raises :class:`UsageError` SC036."""
    client = distributed.Client.__new__(distributed.Client)
    try:
        client.__init__(address, timeout=CONNECT_SECONDS)
    except (OSError, ValueError, TypeError) as error:
        # Left to the garbage collector it is closed wherever that happens to run. While another
        # client starts, that waits for itself.
        client.close()
        hint = "give the address of a Dask scheduler, such as tcp://host:8786, or local:N"
        message = f"there is no cluster at '{address}': {error}"
        raise usage_error("SC036", message, hint) from None
    return client


def spread(
    client: Any, work: Callable[..., T], tasks: Sequence[tuple[Any, ...]]
) -> Iterator[tuple[int, T | LostTaskError]]:
    """The results of tasks by their number, as they come.

    A task whose process dies is given to another; one that took several along is lost. Raises what
    ``work`` raises; then, and where the iteration is left, the other tasks are cancelled.
    """
    distributed = _package()
    suspects = []
    futures = {client.submit(work, *task, pure=False): at for at, task in enumerate(tasks)}
    try:
        for future in distributed.as_completed(futures):
            try:
                yield futures[future], future.result()
            except distributed.KilledWorker:
                suspects.append(futures[future])
            future.release()
        # Dask suspects all tasks that waited at a worker when it died. Which of them it was shows
        # when they come one by one.
        for at in suspects:
            alone = client.submit(work, *tasks[at], pure=False)
            futures[alone] = at
            try:
                yield at, alone.result()
            except distributed.KilledWorker as error:
                yield at, LostTaskError(str(error))
            alone.release()
    finally:
        client.cancel(list(futures))


def _check_workers(address: str, workers: Mapping[str, Mapping[str, Any]]) -> None:
    if not workers:
        raise usage_error("SC036", f"the cluster at {address} has no workers")
    for name, worker in workers.items():
        # Times are true only of what is drawn alone, and OpenGL's contexts belong to one thread.
        if worker["nthreads"] != 1:
            message = f"the worker {name} has {worker['nthreads']} threads"
            raise usage_error("SC036", message, "start it as 'dask worker --nthreads 1'")


def _package() -> Any:
    try:
        return import_module("distributed")
    except ImportError:
        hint = "pip install 'shadercache[cluster]'"
        raise usage_error("SC031", "a cluster needs the package distributed", hint) from None
