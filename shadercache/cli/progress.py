"""Progress of long work on stderr: a bar with an estimate, or a line now and then in a log."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Advance = Callable[[int], None]
"""Call it with the number of steps that were finished."""

LOG_SECONDS = 10.0
"""Pause between two lines where stderr is not a terminal."""


@contextmanager
def progress(label: str, total: int) -> Iterator[Advance]:
    """Show how far ``total`` steps of work are; gone from the terminal when the block ends.

    On a terminal this is rich's bar with the time left. Elsewhere nothing is written in the first
    ten seconds, then one line every ten.
    """
    if sys.stderr.isatty():
        # Imported here: rich costs more than the whole of a short command.
        from rich.console import Console
        from rich.progress import Progress

        with Progress(console=Console(stderr=True), transient=True) as bar:
            task = bar.add_task(label, total=total)
            yield lambda steps: bar.advance(task, steps)
    else:
        yield _log(label, total)


def _log(label: str, total: int) -> Advance:
    done = 0
    started = spoke = time.monotonic()

    def advance(steps: int) -> None:
        nonlocal done, spoke
        done += steps
        now = time.monotonic()
        if now - spoke >= LOG_SECONDS and done:
            spoke = now
            left = (now - started) / done * max(0, total - done)
            line = f"{label}: {done} of {total}, about {left:.0f} s left"
            print(line, file=sys.stderr, flush=True)

    return advance
