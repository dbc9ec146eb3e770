"""The part of ``./dev stress`` that tries generated shaders: many, in batches of one seed each."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass

from shadercache.files import write_bytes
from shadercache.gpu.context import open_context
from shadercache.processes import LostTaskError, spread

from .dialects import DIALECTS
from .suite import OUTPUT, BrokenError, Coverage, check_shaders

BATCH = 25
"""Shaders of one seed. GLSL 3.30 has three batches for one of each other version."""

ROUND = 6
"""Batches of one process."""

ORDER = ("gl330", "gl330", "gl330", *(name for name in DIALECTS if name != "gl330"))


@dataclass(frozen=True)
class Batch:
    """Shaders of one version and one seed."""

    dialect: str
    seed: int

    def __str__(self) -> str:
        return f"{self.dialect}, seed {self.seed}"


class Record:
    """What the batches of one seed have seen, in a file, so that a run can go on later.

    Batches in which something broke are not kept: they are tried again.
    """

    def __init__(self, seed: int, resume: bool) -> None:
        self.path = OUTPUT / f"stress-{seed}.json"
        self._known: dict[str, Coverage] = {}
        if resume and self.path.exists():
            stored = json.loads(self.path.read_text(encoding="utf-8"))
            self._known = {name: Coverage.from_json(item) for name, item in stored.items()}

    def holds(self, batch: Batch) -> bool:
        """Has the batch been tried?"""
        return str(batch) in self._known

    def add(self, batch: Batch, seen: Coverage) -> None:
        """Keep what a batch has seen."""
        self._known[str(batch)] = seen
        data = {name: item.to_json() for name, item in self._known.items()}
        write_bytes(self.path, json.dumps(data).encode())

    def total(self) -> Coverage:
        """What all batches have seen."""
        found = Coverage()
        for seen in self._known.values():
            found.merge(seen)
        return found


def batches(count: int, seed: int) -> list[Batch]:
    """The batches with so many shaders."""
    return [Batch(ORDER[i % len(ORDER)], seed + i) for i in range(-(-count // BATCH))]


def try_many(todo: list[Batch], jobs: int) -> Iterator[tuple[Batch, Coverage, str]]:
    """Each batch with what it has seen, and what broke in it (or nothing), as they are done."""
    # Processes are replaced now and then, since a driver keeps what it has compiled.
    for first in range(0, len(todo), ROUND * jobs):
        some = todo[first : first + ROUND * jobs]
        for at, seen in spread(jobs, _try, [(batch,) for batch in some]):
            if isinstance(seen, LostTaskError):
                yield some[at], Coverage(), f"the process of batch {some[at]} died, twice"
            else:
                yield some[at], *seen


def _try(batch: Batch) -> tuple[Coverage, str]:
    coverage = Coverage()
    with open_context() as gpu:
        try:
            check_shaders(gpu, batch.dialect, BATCH, batch.seed, coverage)
        except BrokenError as error:
            return coverage, str(error)
    return coverage, ""
