"""One trial: a case is read in this process, with limits on time and memory.

What is read may take no longer than the limits of the tool say; what the compiler then makes of it
has time of its own.
"""

from __future__ import annotations

import resource
import signal
import tempfile
import time
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import FrameType

from shadercache.ast.large import allow_deep_trees
from shadercache.ast.nodes import Module
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.valid.read import read

from .behind import compile_behind
from .cases import Case

SECONDS_PER_MEGABYTE = 20.0
SECONDS = 3.0
"""For a small text."""

BEHIND = 10
"""How many times as long as reading a shader everything else may take."""

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
    begin = time.process_time()
    reading = ReadOptions(dialect=case.dialect)
    try:
        with tempfile.TemporaryDirectory() as folder:
            reading = replace(reading, include_folders=(Path(folder),))
            with _time_limit(allowed):
                outcome, wrong, module = _read(case, Path(folder), reading)
            if module is not None and not wrong:
                allowed *= BEHIND
                with _time_limit(allowed):
                    wrong = _go_on(case, Path(folder), module, reading)
    except TimeoutError:
        outcome, wrong = "late", f"takes more than {allowed:.0f} s ({_size(case) / 1e6:.2f} MB)"
    except MemoryError:
        outcome, wrong = "out of memory", f"takes too much memory ({_size(case) / 1e6:.2f} MB)"
    except Exception as error:
        outcome, wrong = type(error).__name__, f"TRACEBACK {_last_lines(error)}"
    return Result(case, time.process_time() - begin, outcome, wrong)


def _read(case: Case, folder: Path, reading: ReadOptions) -> tuple[str, str, Module | None]:
    for name, text in case.files.items():
        (folder / name).write_text(text, encoding="utf-8")
    source = Source(str(folder / "case"), case.text)
    try:
        module, _ = read(source, case.stage, reading)
    except InputError as error:
        return *_judge_errors(case, error), None
    right = case.expected in ("accepted", "either", "damaged")
    return "accepted", "" if right else "accepted, though it is wrong", module


def _go_on(case: Case, folder: Path, module: Module, reading: ReadOptions) -> str:
    """Print a tree, read that again, and compile it; what went wrong, if anything."""
    text = print_module(module)
    again = Source("printed", text)
    try:
        printed, _ = read(again, case.stage)
    except InputError as error:
        return f"is not taken again once it is printed: {error.diagnostics[0].render()[:300]}"
    if print_module(printed) != text:
        return "is printed in another way the second time"
    if case.stage == "vertex":
        return ""
    return compile_behind(Source(str(folder / "case"), case.text), module, reading)


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
    if not error.diagnostics:
        return "rejected", first
    if case.expected != "damaged" and len(error.diagnostics) > 1:
        return "rejected", f"{len(error.diagnostics)} diagnostics: {first[:300]}"
    if case.expected.startswith("SC") and error.diagnostics[0].code != case.expected:
        return "rejected", f"is to be {case.expected}: {first[:300]}"
    return "rejected", ""


def _size(case: Case) -> int:
    return len(case.text) + sum(map(len, case.files.values()))


def _last_lines(error: Exception) -> str:
    frames = traceback.extract_tb(error.__traceback__)[-3:]
    places = " > ".join(f"{Path(frame.filename).name}:{frame.lineno}" for frame in frames)
    return f"{type(error).__name__}: {str(error)[:200]} at {places}"


@contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    # Time of the processor: the machine may have other things to do.
    signal.signal(signal.SIGPROF, _too_late)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)


def _too_late(number: int, frame: FrameType | None) -> None:
    raise TimeoutError
