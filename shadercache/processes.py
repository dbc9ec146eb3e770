"""Work spread over processes of this machine, any of which may die.

``concurrent.futures`` shares its queues among all processes of a pool. One that dies may leave
them locked, and whoever waits for the pool waits for ever (CPython 94777, 115634). Here each
process has a pipe of its own, whose end tells of its death and of the task that it had.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import Pipe, get_context
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar

T = TypeVar("T")

# A forked child would share the driver's state with its parent.
_SPAWN = get_context("spawn")


class LostTaskError(Exception):
    """The processes that were given a task died, one after another."""


class AllLostError(Exception):
    """Process after process died, and nothing came of any."""


def spread(
    jobs: int,
    work: Callable[..., T],
    tasks: Sequence[tuple[Any, ...]],
    *,
    begin: Callable[[], None] | None = None,
    most_lost: int | None = None,
) -> Iterator[tuple[int, T | LostTaskError]]:
    """The results of tasks by their number, as they come.

    A task whose process dies is tried once more, in a new process and with nothing beside it; then
    it is lost. Where the iteration is left, the processes are killed.

    Args:
        begin: what each process does first.
        most_lost: so many processes may die before there is any result; then all is given up.

    Raises what ``begin`` and ``work`` raise, and :class:`AllLostError`.
    """
    left, suspects = deque(range(len(tasks))), deque[int]()
    idle: list[_Process] = []
    busy: dict[Connection, _Process] = {}
    deaths, answers = 0, 0
    try:
        while left or suspects or busy:
            again = not left
            if again and not busy:
                _stop(idle)
            waiting, most = (suspects, 1) if again else (left, jobs)
            while waiting and len(busy) < most:
                process = idle.pop() if idle else _Process(work, begin)
                busy[process.pipe] = process
                process.take(waiting.popleft(), tasks, again)
            answered = wait(list(busy))
            for process in [busy.pop(pipe) for pipe in list(busy) if pipe in answered]:
                if (answer := process.answer()) is not None:
                    answers += 1
                    idle.append(process)
                    yield process.task, answer.result()
                    continue
                process.stop()
                deaths += 1
                if most_lost is not None and deaths > most_lost and not answers:
                    raise AllLostError(f"{deaths} processes died, and nothing came of any")
                if process.again:
                    yield process.task, LostTaskError("the process died, twice")
                else:
                    suspects.append(process.task)
    finally:
        _stop([*idle, *busy.values()])


@dataclass(frozen=True, slots=True)
class _Answer:
    """What a task came to."""

    value: Any = None
    error: Exception | None = None

    def result(self) -> Any:
        """The value. Raises what the task raised."""
        if self.error is not None:
            raise self.error
        return self.value


class _Process:
    """One process, the task that it has, and whether it is that task's second try."""

    def __init__(self, work: Callable[..., Any], begin: Callable[[], None] | None) -> None:
        self.pipe, theirs = Pipe()
        self.task, self.again = -1, False
        self._process = _SPAWN.Process(target=_serve, args=(theirs, work, begin), daemon=True)
        self._process.start()
        # While this process holds their end as well, a dead one would never read as the end.
        theirs.close()

    def take(self, number: int, tasks: Sequence[tuple[Any, ...]], again: bool) -> None:
        """Begin with a task."""
        self.task, self.again = number, again
        # A dead one says so when it is asked for its answer.
        with suppress(ConnectionError):
            self.pipe.send(tasks[number])

    def answer(self) -> _Answer | None:
        """What it says; nothing if it is dead. Waits for it."""
        try:
            answer: _Answer = self.pipe.recv()
        except (EOFError, ConnectionError):
            return None
        return answer

    def stop(self) -> None:
        """End the process, whatever it does."""
        self.pipe.close()
        self._process.kill()
        self._process.join()


def _stop(processes: list[_Process]) -> None:
    while processes:
        processes.pop().stop()


def _serve(pipe: Connection, work: Callable[..., Any], begin: Callable[[], None] | None) -> None:
    """Answer tasks until the other side goes away."""
    try:
        while True:
            arguments = pipe.recv()
            try:
                if begin is not None:
                    begin()
                    begin = None
                answer = _Answer(work(*arguments))
            except Exception as error:
                answer = _Answer(error=error)
            pipe.send(answer)
    except (EOFError, ConnectionError, KeyboardInterrupt):
        pass  # Whoever asked is gone, or was interrupted as well.
