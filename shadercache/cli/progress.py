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
        yield _Log(label, total).advance


class _Log:
    def __init__(self, label: str, total: int) -> None:
        self._label = label
        self._total = total
        self._done = 0
        self._started = self._spoke = time.monotonic()

    def advance(self, steps: int) -> None:
        self._done += steps
        now = time.monotonic()
        if now - self._spoke < LOG_SECONDS or not self._done:
            return
        self._spoke = now
        left = (now - self._started) / self._done * max(0, self._total - self._done)
        line = f"{self._label}: {self._done} of {self._total}, about {left:.0f} s left"
        print(line, file=sys.stderr, flush=True)
