"""Verify many nodes in several processes: compiling programs is what takes the time, on one core.

Each worker has a context and a verifier of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import closing
from multiprocessing import get_context
from pathlib import Path

from shadercache.front.options import ReadOptions
from shadercache.harness.context import open_context
from shadercache.harness.shaders import open_scene
from shadercache.harness.verify import Verdict, Verifier
from shadercache.options import DEFAULT_CACHE, CacheOptions, MappingKind

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
    cache: CacheOptions = DEFAULT_CACHE,
) -> list[Verdict]:
    """Verdicts for the nodes (by id; ``a+b`` is a set) of a scene, in the order of ``nodes``.

    ``scene`` is its file, or a full-screen shader. ``jobs`` processes; 1 works in this one.
    ``told`` hears of each verdict as it comes; ``reading`` is how the shaders are read. Raises as
    :func:`open_scene` and :class:`Verifier`.
    """
    if jobs == 1:
        with closing(_open(scene, reading, mapping, cache)) as verifier:
            return [_tell(_check(verifier, node, plain), told) for node in nodes]
    found: dict[str, Verdict] = {}
    spawn = get_context("spawn")  # a forked child would share the parent's driver state
    with ProcessPoolExecutor(jobs, spawn, _start, (scene, reading, mapping, cache)) as pool:
        waiting = [pool.submit(_work, node, plain) for node in nodes]
        try:
            for future in as_completed(waiting):
                verdict = _tell(future.result(), told)
                found[verdict.node] = verdict
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return [found[node] for node in nodes]


def _open(
    path: Path, reading: ReadOptions | None, mapping: MappingKind | None, cache: CacheOptions
) -> Verifier:
    return Verifier(open_context(), *open_scene(path, reading, mapping), cache=cache)


def _start(
    path: Path, reading: ReadOptions | None, mapping: MappingKind | None, cache: CacheOptions
) -> None:
    global _verifier
    # One rasteriser thread a process, or llvmpipe's threads fight over the cores.
    os.environ.setdefault("LP_NUM_THREADS", "1")
    _verifier = _open(path, reading, mapping, cache)


def _work(node: str, plain: bool) -> Verdict:
    assert _verifier is not None
    return _check(_verifier, node, plain)


def _check(verifier: Verifier, node: str, plain: bool) -> Verdict:
    return verifier.check(verifier.analysis.nodes_of(node), plain)


def _tell(verdict: Verdict, told: Callable[[Verdict], None] | None) -> Verdict:
    if told is not None:
        told(verdict)
    return verdict
