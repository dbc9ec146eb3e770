"""Instances of an object: how many are drawn, and the attributes that each has of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error
from shadercache.scene.npz import load_npz
from shadercache.scene.toml_reader import Table

MOST = 1_000_000
"""Instances of one object."""


@dataclass(frozen=True, slots=True)
class Stream:
    """Numbers of each instance: an array of an ``.npz`` file, (instances, numbers), or (frames,
    instances, numbers) played in a circle with ``rate`` frames of it in a frame.

    Matrices lie column by column, as OpenGL reads them. Between two frames of it numbers are mixed.
    """

    path: Path
    array: str
    rate: float = 1.0

    @property
    def moves(self) -> bool:
        """Does it change from frame to frame?"""
        return len(self._frames) > 1

    @property
    def count(self) -> int:
        """How many instances it has numbers for. Raises :class:`InputError` SC541."""
        return int(self._frames.shape[1])

    @property
    def width(self) -> int:
        """Numbers of an instance. Raises :class:`InputError` SC541."""
        return int(self._frames.shape[2])

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers of all instances at a frame, one behind the other.

        Raises :class:`InputError` SC541 for a file that does not hold them.
        """
        frames = self._frames
        place = frame * self.rate if self.moves else 0.0
        low = int(np.floor(place))
        part = place - low
        first, second = frames[low % len(frames)], frames[(low + 1) % len(frames)]
        mixed: NDArray[np.float64] = (1.0 - part) * first + part * second
        return mixed.ravel()

    @property
    def _frames(self) -> NDArray[np.float64]:
        return _frames(self.path, self.array)


@dataclass(frozen=True, eq=False)
class Instances:
    """Several of an object are drawn at once; ``streams`` by the names of attributes, ``count``
    where the scene says it."""

    streams: Mapping[str, Stream] = field(default_factory=dict)
    count: int | None = None

    @property
    def number(self) -> int:
        """How many are drawn. Raises :class:`InputError` SC541 as a stream, or where two of them
        have numbers for another number of instances."""
        counts = {name: stream.count for name, stream in self.streams.items()}
        if self.count is not None:
            counts["count"] = self.count
        if len(set(counts.values())) > 1:
            told = ", ".join(f"{name} {number}" for name, number in counts.items())
            message = f"all attributes have numbers for as many instances, but there are {told}"
            raise input_error("SC541", message)
        return next(iter(counts.values()), 1)

    def renamed(self, renamed: Mapping[str, str]) -> Instances:
        """The same, with every stream also under its new name."""
        new = {renamed[name]: it for name, it in self.streams.items() if name in renamed}
        return replace(self, streams={**self.streams, **new})


ALONE = Instances()
"""One object, with nothing of its own."""


def read_instances(table: Table) -> Instances:
    """``[instances]``: a ``count``, and for each attribute the table and array it comes from."""
    streams: dict[str, Stream] = {}
    count = table.whole("count", None, least=1) if table.has("count") else None
    for name, value in table.items():
        if isinstance(value, dict):
            entry = table.table(name)
            streams[name] = Stream(
                entry.file("table"), entry.text("array"), entry.number("rate", 1.0)
            )
        else:
            known = name == "count"
            table.require(known, name, f"{table.full(name)} must have a table and an array")
    return Instances(streams, count)


@lru_cache(maxsize=32)
def _frames(path: Path, name: str) -> NDArray[np.float64]:
    arrays = load_npz(path, "SC541", "the instances")
    if name not in arrays:
        hint = f"it has: {', '.join(sorted(arrays))}"
        raise input_error("SC541", f"{path} has no array {name!r}", hint=hint)
    stored = arrays[name]
    shape = f"{stored.dtype} {stored.shape}"
    if stored.dtype.kind not in "fiu" or stored.ndim not in (2, 3) or not stored.size:
        message = f"array {name!r} of {path} is no table of instances: {shape}"
        hint = "(instances, numbers), or (frames, instances, numbers)"
        raise input_error("SC541", message, hint=hint)
    frames: NDArray[np.float64] = stored.astype(np.float64)
    if not np.isfinite(frames).all():
        raise input_error("SC541", f"array {name!r} of {path} holds NaN or infinity")
    if frames.shape[-2] > MOST:
        raise input_error("SC541", f"array {name!r} of {path} has more than {MOST:,} instances")
    return frames if frames.ndim == 3 else frames[None]
