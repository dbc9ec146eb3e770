"""One trial: a case is read in this process, with limits on time and memory."""

from __future__ import annotations

import resource
import signal
import tempfile
import time
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import FrameType

from shadercache.ast.large import allow_deep_trees
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.options import ReadOptions
from shadercache.front.parse import parse
from shadercache.sema.check import check
from shadercache.source import Source

from .cases import Case

SECONDS_PER_MEGABYTE = 20.0
SECONDS = 6.0
"""For a small text: its macros may expand to as many words as the token limit allows."""

MEGABYTES_PER_MEGABYTE = 1_500
MEGABYTES = 400


@dataclass(frozen=True, slots=True)
class Result:
    """What became of a case; ``wrong`` is empty where it went as it has to."""

    case: Case
    seconds: float
    outcome: str
    wrong: str


def limit_memory(largest: int) -> None:
    """Bound this process's memory by what a text of ``largest`` characters may take."""
    bound = int((MEGABYTES + MEGABYTES_PER_MEGABYTE * largest / 1e6) * 1e6)
    resource.setrlimit(resource.RLIMIT_AS, (bound, bound))


def try_case(case: Case) -> Result:
    """Read a case, check and print it, and judge how that went."""
    allow_deep_trees()
    allowed = SECONDS + SECONDS_PER_MEGABYTE * _size(case) / 1e6
    begin = time.perf_counter()
    try:
        with tempfile.TemporaryDirectory() as folder, _time_limit(allowed):
            outcome, wrong = _read(case, Path(folder))
    except TimeoutError:
        outcome, wrong = "late", f"takes more than {allowed:.0f} s ({_size(case) / 1e6:.2f} MB)"
    except MemoryError:
        outcome, wrong = "out of memory", f"takes too much memory ({_size(case) / 1e6:.2f} MB)"
    except Exception as error:
        outcome, wrong = type(error).__name__, f"TRACEBACK {_last_lines(error)}"
    return Result(case, time.perf_counter() - begin, outcome, wrong)


def _read(case: Case, folder: Path) -> tuple[str, str]:
    for name, text in case.files.items():
        (folder / name).write_text(text, encoding="utf-8")
    source = Source(str(folder / "case"), case.text)
    try:
        module = parse(source, ReadOptions(include_folders=(folder,)))
        check(module, source, case.stage)
        print_module(module)
    except InputError as error:
        return _judge_errors(case, error)
    return "accepted", "accepted, though it is wrong" if case.expected == "rejected" else ""


def _judge_errors(case: Case, error: InputError) -> tuple[str, str]:
    first = error.diagnostics[0].render() if error.diagnostics else "no diagnostic at all"
    for item in error.diagnostics:
        if not item.message or len(item.message) > 1_000:
            return "rejected", f"a message of {len(item.message)} characters: {item.message[:100]}"
        if not item.code.startswith(("SC1", "SC2")):
            return "rejected", f"a code of another part: {item.code}"
        if len(rendered := item.render()) > 100_000:
            return "rejected", f"a diagnostic is shown in {len(rendered)} characters"
    if case.expected == "accepted":
        return "rejected", f"rejected, though it is right: {first[:300]}"
    return "rejected", "" if error.diagnostics else first


def _size(case: Case) -> int:
    return len(case.text) + sum(map(len, case.files.values()))


def _last_lines(error: Exception) -> str:
    frames = traceback.extract_tb(error.__traceback__)[-3:]
    places = " > ".join(f"{Path(frame.filename).name}:{frame.lineno}" for frame in frames)
    return f"{type(error).__name__}: {str(error)[:200]} at {places}"


@contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    signal.signal(signal.SIGALRM, _too_late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def _too_late(number: int, frame: FrameType | None) -> None:
    raise TimeoutError
