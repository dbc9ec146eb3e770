"""Verify many nodes in several processes: compiling programs is what takes the time, on one core.

Each worker has a context and a verifier of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.configuration import Configuration
from shadercache.cluster import LostTaskError, spread
from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import open_context
from shadercache.linking.scene_shaders import open_scene
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier

CRASHED = "the process that drew it died, twice: the driver crashes"

THREADS = "LP_NUM_THREADS"
"""The variable by which llvmpipe, once a context is opened, is told how many threads to have."""

MOST_LOST = 3
"""Nodes one after another that may be lost to crashes before the run is given up."""

_verifier: Verifier | None = None
"""The worker process's own; set once when the process starts."""

_verified: VerifiedScene | None = None
"""Of which scene it is, in a process of a cluster."""


@dataclass(frozen=True, slots=True)
class VerifiedScene:
    """A scene file, or a full-screen shader; how its shaders are read, and what is verified."""

    path: Path
    reading: ReadOptions | None = None
    mapping: MappingKind | None = None
    configuration: Configuration | None = None

    def open(self) -> Verifier:
        """Raises as :func:`open_scene` and :class:`Verifier`."""
        opened = open_scene(self.path, self.reading, self.mapping)
        return Verifier(open_context(), opened, configuration=self.configuration)


def verify_in_parallel(
    scene: VerifiedScene,
    nodes: Sequence[str],
    jobs: int,
    plain: bool = True,
    heard: Callable[[Verdict], None] = lambda verdict: None,
) -> list[Verdict]:
    """Verdicts for the nodes (by id; ``a+b`` is a set) of a scene, in the order of ``nodes``.

    A driver that crashes takes its process with it: what was left is given to new ones. A node
    whose process dies again when it is alone there has a verdict that says so.

    Args:
        jobs: how many processes; 1 works in this one.
        plain: as in :meth:`Verifier.check`.
        heard: called with each verdict as it comes.

    Raises :class:`GraphicsError` SC606 where nothing can be drawn, and as ``VerifiedScene.open``.
    """
    verdicts: dict[str, Verdict] = {}

    def keep(node: str, verdict: Verdict) -> None:
        verdicts[node] = verdict
        heard(verdict)

    if jobs == 1:
        with closing(scene.open()) as verifier:
            for node in nodes:
                keep(node, verifier.check(verifier.analysis.nodes_of(node), plain))
    spawn = get_context("spawn")  # a forked child would share the parent's driver state
    workers, lost = jobs, 0
    while left := [node for node in nodes if node not in verdicts]:
        with ProcessPoolExecutor(workers, spawn, _start, (scene,)) as pool:
            _drain(pool, left, plain, keep)
        if any(node in verdicts for node in left):
            # Some came through, so it is not the driver as a whole that crashes.
            workers, lost = jobs, 0
        elif workers > 1:
            workers = 1  # which of them it was shows when they come one by one
        elif lost == MOST_LOST:
            message = "the driver crashes, whatever it is given to draw"
            raise GraphicsError(Diagnostic("SC606", message))
        else:
            keep(left[0], Verdict(left[0], "", "", True, failure=CRASHED))
            workers, lost = jobs, lost + 1
    return [verdicts[node] for node in nodes]


def verify_on(
    client: Any,
    scene: VerifiedScene,
    nodes: Sequence[str],
    plain: bool = True,
    heard: Callable[[Verdict], None] = lambda verdict: None,
) -> list[Verdict]:
    """The same as :func:`verify_in_parallel` on a Dask cluster, whose workers see the same files.

    Args:
        client: as ``open_cluster`` gives it.
    """
    verdicts: dict[str, Verdict] = {}
    for at, verdict in spread(client, _work_on, [(scene, node, plain) for node in nodes]):
        if isinstance(verdict, LostTaskError):
            verdict = Verdict(nodes[at], "", "", True, failure=CRASHED)
        verdicts[nodes[at]] = verdict
        heard(verdict)
    return [verdicts[node] for node in nodes]


def _drain(
    pool: ProcessPoolExecutor,
    nodes: Sequence[str],
    plain: bool,
    keep: Callable[[str, Verdict], None],
) -> None:
    """Keep verdicts as they come, until a process dies, which ends the pool."""
    waiting = {pool.submit(_work, node, plain): node for node in nodes}
    try:
        for future in as_completed(waiting):
            keep(waiting[future], future.result())
    except BrokenProcessPool:
        return
    except BaseException:
        # Or the `with` block of the pool would wait for all nodes before the error gets through.
        pool.shutdown(cancel_futures=True)
        raise


def _start(scene: VerifiedScene) -> None:
    global _verifier
    # One rasteriser thread a process, or llvmpipe's threads fight over the cores. What else the
    # process may start, such as a worker that takes times, has all of them.
    given = os.environ.get(THREADS)
    os.environ.setdefault(THREADS, "1")
    try:
        _verifier = scene.open()
    finally:
        if given is None:
            del os.environ[THREADS]


def _work_on(scene: VerifiedScene, node: str, plain: bool) -> Verdict:
    """The same in a process that may have verified another scene before, one node at a time."""
    global _verified
    if _verified != scene:
        if _verifier is not None:
            _verifier.close()
        _start(scene)
        _verified = scene
    return _work(node, plain)


def _work(node: str, plain: bool) -> Verdict:
    assert _verifier is not None
    return _verifier.check(_verifier.analysis.nodes_of(node), plain)
