"""What the front end makes of a shader: read it, type it, print it, and read that once more."""

from __future__ import annotations

import signal
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import Pool
from traceback import extract_tb
from typing import NoReturn

from bench.public_shaders.shaders import Shader, Stage
from shadercache.ast.large import allow_deep_trees
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.emit.printer import print_module
from shadercache.source import Source
from shadercache.valid.read import read

SECONDS = 20
"""A shader that takes longer hangs."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a shader.

    ``code``, ``line`` and ``message`` are the first error's; ``code`` is the name of the exception
    where there was a traceback. ``again`` tells of the printed text: taken, and the same text when
    printed; otherwise its first error.
    """

    accepted: bool
    code: str = ""
    line: int = 0
    message: str = ""
    printed: str | None = None
    again: str = ""
    stable: bool = False


def read_all(shaders: Sequence[Shader], processes: int) -> list[Outcome]:
    """An outcome for each shader."""
    with Pool(processes, allow_deep_trees) as pool:
        return pool.map(outcome_of, shaders, chunksize=8)


def outcome_of(shader: Shader) -> Outcome:
    """The outcome of one shader; whatever is raised becomes one."""
    try:
        with time_limit():
            printed = _pass(shader.text, shader.stage)
            return _read_again(printed, shader.stage)
    except InputError as error:
        first = next(d for d in error.diagnostics if d.severity is Severity.ERROR)
        return Outcome(False, first.code, _line(first), first.message)
    except Exception as error:
        return Outcome(False, type(error).__name__, 0, f"{error} ({_place(error)})")


def _read_again(printed: str, stage: Stage) -> Outcome:
    try:
        return Outcome(True, printed=printed, stable=_pass(printed, stage) == printed)
    except InputError as error:
        first = error.diagnostics[0]
        again = f"{first.code} line {_line(first)}: {first.message}"
    except Exception as error:
        again = f"{type(error).__name__}: {error} ({_place(error)})"
    return Outcome(True, printed=printed, again=again)


def _pass(text: str, stage: Stage) -> str:
    return print_module(read(Source("shader", text), stage)[0])


def _line(diagnostic: Diagnostic) -> int:
    if diagnostic.source is None or diagnostic.span is None:
        return 0
    return diagnostic.source.position(diagnostic.span.start).line


def _place(error: Exception) -> str:
    last = extract_tb(error.__traceback__)[-1]
    return f"{last.filename}:{last.lineno}"


@contextmanager
def time_limit() -> Iterator[None]:
    """Raise :class:`TimeoutError` in what takes longer than it may."""
    signal.signal(signal.SIGALRM, _too_long)
    signal.alarm(SECONDS)
    try:
        yield
    finally:
        signal.alarm(0)


def _too_long(*_: object) -> NoReturn:
    raise TimeoutError(f"more than {SECONDS} s")
