"""Verify many nodes in several processes: compiling programs is what takes the time, on one core.

Each worker has a context and a verifier of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing
from multiprocessing import get_context
from pathlib import Path

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import open_context
from shadercache.linking.scene_shaders import open_scene
from shadercache.verify.verifier import Verdict, Verifier

CRASHED = "the process that drew it died, twice: the driver crashes"

MOST_LOST = 3
"""Nodes one after another that may be lost to crashes before the run is given up."""

_verifier: Verifier | None = None
"""The worker process's own; set once when the process starts."""


def verify_in_parallel(
    scene: Path,
    nodes: Sequence[str],
    jobs: int,
    plain: bool = True,
    told: Callable[[Verdict], None] | None = None,
    reading: ReadOptions | None = None,
    mapping: MappingKind | None = None,
    configuration: Configuration | None = None,
) -> list[Verdict]:
    """Verdicts for the nodes (by id; ``a+b`` is a set) of a scene, in the order of ``nodes``.

    ``scene`` is its file, or a full-screen shader. ``jobs`` processes; 1 works in this one.
    ``told`` hears of each verdict as it comes; ``reading`` is how the shaders are read. A driver
    that crashes takes its process with it: what was left is given to new ones, and a node whose
    process dies again when it is alone there has a verdict that says so. Raises as
    :func:`open_scene` and :class:`Verifier`; GraphicsError SC606 where nothing can be drawn.
    """
    if jobs == 1:
        with closing(_open(scene, reading, mapping, configuration)) as verifier:
            return [_tell(_check(verifier, node, plain), told) for node in nodes]
    found: dict[str, Verdict] = {}
    spawn = get_context("spawn")  # a forked child would share the parent's driver state
    left, workers, lost = list(nodes), jobs, 0
    while left:
        given = (scene, reading, mapping, configuration)
        with ProcessPoolExecutor(workers, spawn, _start, given) as pool:
            whole = _drain(pool, left, plain, found, told)
        rest = [node for node in left if node not in found]
        if whole or len(rest) < len(left):
            left, workers, lost = rest, jobs, 0
        elif workers > 1:
            workers = 1  # which of them it was shows when they come one by one
        elif lost == MOST_LOST:
            message = "the driver crashes, whatever it is given to draw"
            raise GraphicsError(Diagnostic("SC606", message))
        else:
            found[rest[0]] = _tell(Verdict(rest[0], "", "", True, failure=CRASHED), told)
            left, workers, lost = rest[1:], jobs, lost + 1
    return [found[node] for node in nodes]


def _drain(
    pool: ProcessPoolExecutor,
    nodes: Sequence[str],
    plain: bool,
    found: dict[str, Verdict],
    told: Callable[[Verdict], None] | None,
) -> bool:
    """Collect verdicts as they come; False if a process died, which ends the pool."""
    waiting = [pool.submit(_work, node, plain) for node in nodes]
    try:
        for future in as_completed(waiting):
            verdict = _tell(future.result(), told)
            found[verdict.node] = verdict
    except BrokenProcessPool:
        return False
    except BaseException:
        pool.shutdown(cancel_futures=True)
        raise
    return True


def _open(
    path: Path,
    reading: ReadOptions | None,
    mapping: MappingKind | None,
    configuration: Configuration | None,
) -> Verifier:
    opened = open_scene(path, reading, mapping)
    return Verifier(open_context(), *opened, configuration=configuration)


def _start(
    path: Path,
    reading: ReadOptions | None,
    mapping: MappingKind | None,
    configuration: Configuration | None,
) -> None:
    global _verifier
    # One rasteriser thread a process, or llvmpipe's threads fight over the cores.
    os.environ.setdefault("LP_NUM_THREADS", "1")
    _verifier = _open(path, reading, mapping, configuration)


def _work(node: str, plain: bool) -> Verdict:
    assert _verifier is not None
    return _check(_verifier, node, plain)


def _check(verifier: Verifier, node: str, plain: bool) -> Verdict:
    return verifier.check(verifier.analysis.nodes_of(node), plain)


def _tell(verdict: Verdict, told: Callable[[Verdict], None] | None) -> Verdict:
    if told is not None:
        told(verdict)
    return verdict
