"""Verify many nodes in several processes: compiling programs is what takes the time, on one core.

Each worker has a context and a verifier of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from shadercache import cluster, processes
from shadercache.analysis.mapping import MappingKind
from shadercache.caching.algorithms import USUAL
from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import open_context
from shadercache.linking.scene_shaders import open_scene
from shadercache.processes import AllLostError, LostTaskError
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier

CRASHED = "the process that drew it died, twice: the driver crashes"

THREADS = "LP_NUM_THREADS"
"""The variable by which llvmpipe, once a context is opened, is told how many threads to have."""

MOST_LOST = 6
"""Processes that may die before there is any verdict; then the run is given up."""

_verifier: Verifier | None = None
"""The worker process's own; set once when the process starts."""

_verified: VerifiedScene | None = None
"""Of which scene it is, in a process of a cluster."""


@dataclass(frozen=True, slots=True)
class VerifiedScene:
    """A scene file, or a full-screen shader, which may have a vertex shader; how its shaders are
    read, and what is verified, by which algorithms."""

    path: Path
    reading: ReadOptions | None = None
    mapping: MappingKind | None = None
    configuration: Configuration | None = None
    algorithms: tuple[str, ...] = USUAL
    vertex: Path | None = None

    def open(self) -> Verifier:
        """Raises as :func:`open_scene` and :class:`Verifier`."""
        opened = open_scene(self.path, self.reading, self.mapping, None, self.vertex)
        verifier = Verifier(open_context(), opened, configuration=self.configuration)
        verifier.algorithms = self.algorithms
        return verifier


def verify_in_parallel(
    scene: VerifiedScene,
    nodes: Sequence[str],
    jobs: int,
    plain: bool = True,
    heard: Callable[[Verdict], None] = lambda verdict: None,
) -> list[Verdict]:
    """Verdicts for the nodes (by id; ``a+b`` is a set) of a scene, in the order of ``nodes``.

    A driver that crashes takes its process with it. A node whose process dies again when it is
    alone there has a verdict that says so.

    Args:
        jobs: how many processes; 1 works in this one.
        plain: as in :meth:`Verifier.check`.
        heard: called with each verdict as it comes.

    Raises :class:`GraphicsError` SC606 where nothing can be drawn, and as ``VerifiedScene.open``.
    """
    if jobs == 1:
        with closing(scene.open()) as verifier:
            checked = (verifier.check(verifier.analysis.nodes_of(node), plain) for node in nodes)
            return _in_order(nodes, enumerate(checked), heard)
    tasks = [(node, plain) for node in nodes]
    found = processes.spread(jobs, _work, tasks, begin=partial(_start, scene), most_lost=MOST_LOST)
    try:
        return _in_order(nodes, found, heard)
    except AllLostError:
        message = "the driver crashes, whatever it is given to draw"
        raise GraphicsError(Diagnostic("SC606", message)) from None


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
    found = cluster.spread(client, _work_on, [(scene, node, plain) for node in nodes])
    return _in_order(nodes, found, heard)


def _in_order(
    nodes: Sequence[str],
    found: Iterable[tuple[int, Verdict | LostTaskError]],
    heard: Callable[[Verdict], None],
) -> list[Verdict]:
    """Verdicts, which come by the number of their node, in the order of the nodes."""
    verdicts: dict[int, Verdict] = {}
    for at, verdict in found:
        if isinstance(verdict, LostTaskError):
            verdict = Verdict(nodes[at], "", "", True, failure=CRASHED)
        verdicts[at] = verdict
        heard(verdict)
    return [verdicts[at] for at in range(len(nodes))]


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
