"""Running cases: each in a child process, and random ones in rounds."""

from __future__ import annotations

import multiprocessing
import random
import time
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from .cases import Case
from .damage import damaged, random_bytes, random_words
from .trial import Result, limit_memory, try_case

ROOT = Path(__file__).resolve().parent.parent.parent
ROUND = 50
"""Random cases that one child process reads: what a text leaves behind in memory is found so."""


def random_rounds(seed: int, seconds: float) -> Iterator[list[Case]]:
    """Lists of random cases until the time is up."""
    pick = random.Random(seed)
    shaders = real_shaders()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        yield [random_case(pick, shaders) for _ in range(ROUND)]


def random_case(pick: random.Random, shaders: Sequence[Path]) -> Case:
    """A case by chance: damage is the most telling, so it is the most frequent."""
    match pick.randrange(10):
        case 0:
            return random_bytes(pick)
        case 1:
            return random_words(pick, pick.choice(shaders))
        case _:
            return damaged(pick, pick.choice(shaders))


def real_shaders() -> list[Path]:
    """The shaders that may be damaged, always in the same order."""
    parts = ("corpus", "tests/front", "tests/stress", "out/public/shaders")
    paths = [path for part in parts for path in (ROOT / part).rglob("*.[fv][re][ar][gt]")]
    return sorted(path for path in paths if "printed" not in path.parts)


def run_apart(cases: Sequence[Case], start: str = "fork") -> list[Result]:
    """Try cases in a child process, which may be killed by its limits or crash.

    ``start`` is how the child begins: forking is quick, but not for a process with threads.
    """
    largest = max(len(case.text) + sum(map(len, case.files.values())) for case in cases)
    context: Any = multiprocessing.get_context(start)
    receive, send = context.Pipe(duplex=False)
    child = context.Process(target=_child, args=(cases, largest, send))
    child.start()
    send.close()
    results: list[Result] = []
    try:
        while len(results) < len(cases):
            results.append(receive.recv())
    except EOFError:
        child.join()
        case = cases[len(results)]
        results.append(Result(case, 0.0, "died", f"the process died, status {child.exitcode}"))
        rest = cases[len(results) :]
        return results + (run_apart(rest, start) if rest else [])
    child.join()
    return results


def _child(cases: Sequence[Case], largest: int, send: Connection) -> None:
    limit_memory(largest)
    for case in cases:
        send.send(try_case(case))
