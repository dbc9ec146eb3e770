"""The part of ``./dev stress`` that tries generated shaders: many, on all cores."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool

from shadercache.harness.context import open_context

from .dialects import DIALECTS
from .suite import BrokenError, Coverage, check_shaders

BATCH = 25
"""Shaders of one seed. GLSL 3.30 has three batches for one of each other version."""

ORDER = ("gl330", "gl330", "gl330", *(name for name in DIALECTS if name != "gl330"))


def try_many(count: int, seed: int) -> Iterator[tuple[Coverage, str]]:
    """What each batch has seen, and what broke in it (or nothing), until all are done."""
    batches = [(ORDER[i % len(ORDER)], seed + i) for i in range(-(-count // BATCH))]
    context = multiprocessing.get_context("spawn")
    workers = os.cpu_count() or 1
    with ProcessPoolExecutor(workers, context, max_tasks_per_child=4) as pool:
        futures = {pool.submit(_batch, *batch): batch for batch in batches}
        for future in as_completed(futures):
            try:
                yield future.result()
            except BrokenProcessPool:
                yield Coverage(), f"a process died, near batch {futures[future]}"


def _batch(dialect: str, seed: int) -> tuple[Coverage, str]:
    coverage = Coverage()
    with open_context() as gpu:
        try:
            check_shaders(gpu, dialect, BATCH, seed, coverage)
        except BrokenError as error:
            return coverage, str(error)
    return coverage, ""
