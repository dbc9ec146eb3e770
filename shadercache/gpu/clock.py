"""The clock that tells the truth on the renderer at hand."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import perf_counter
from typing import Protocol

import moderngl

from shadercache.gpu.context import Gpu


class Clock(Protocol):
    """Times one drawing."""

    name: str

    def time(self, draw: Callable[[], None]) -> float:
        """Run ``draw`` and return how long the renderer worked on it, in seconds."""
        ...


class WallClock:
    """``glFinish``, draw, ``glFinish``: for renderers that run on the CPU."""

    name = "wall clock between glFinish"

    def __init__(self, ctx: moderngl.Context) -> None:
        self._finish = ctx.finish

    def time(self, draw: Callable[[], None]) -> float:
        """See ``Clock``."""
        # Or work that was submitted earlier would be counted.
        self._finish()
        start = perf_counter()
        draw()
        self._finish()
        return perf_counter() - start


class QueryClock:
    """A timer query around the draw: for GPUs, whose work the CPU's clock does not see."""

    name = "GL_TIME_ELAPSED"

    def __init__(self, ctx: moderngl.Context) -> None:
        self._query = ctx.query(time=True)

    def time(self, draw: Callable[[], None]) -> float:
        """See ``Clock``."""
        with self._query:
            draw()
        # Reading it waits for the GPU.
        return float(self._query.elapsed) * 1e-9


def pick_clock(gpu: Gpu) -> Clock:
    """The clock for this renderer; store its name with every result."""
    # GL_TIME_ELAPSED means nothing in software: 80 times the work moved it without order.
    return WallClock(gpu.ctx) if gpu.is_software else QueryClock(gpu.ctx)


@contextmanager
def no_collection() -> Iterator[None]:
    """Keep Python's garbage collector (milliseconds at a time) out of what is timed."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()
