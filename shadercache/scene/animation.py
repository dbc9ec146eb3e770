"""Uniforms that change from frame to frame without a semantic: ramps, and tables such as bones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error
from shadercache.scene.npz import load_npz


@dataclass(frozen=True, slots=True)
class Ramp:
    """Numbers that change by the same amount in every frame."""

    start: tuple[float, ...]
    per_frame: tuple[float, ...]

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers at a frame, in the order of upload."""
        return np.asarray(self.start, np.float64) + frame * np.asarray(self.per_frame, np.float64)


@dataclass(frozen=True, slots=True)
class Rows:
    """Rows of an ``.npz`` file's array (rows, numbers in the order of upload), played in a circle.

    ``rate`` in rows a frame; between two rows the numbers are mixed. ``start`` is the row of
    frame 0.
    """

    path: Path
    array: str
    rate: float = 1.0
    start: float = 0.0

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers at a frame. Raises InputError SC541 for a file that does not hold them."""
        rows = _rows(self.path, self.array)
        place = self.start + frame * self.rate
        low = int(np.floor(place))
        part = place - low
        first, second = rows[low % len(rows)], rows[(low + 1) % len(rows)]
        mixed: NDArray[np.float64] = (1.0 - part) * first + part * second
        return mixed


Animation: TypeAlias = Ramp | Rows
Animations: TypeAlias = Mapping[str, Animation]


@lru_cache(maxsize=32)
def _rows(path: Path, name: str) -> NDArray[np.float64]:
    arrays = load_npz(path, "SC541", "the animation")
    if name not in arrays:
        hint = f"it has: {', '.join(sorted(arrays))}"
        raise input_error("SC541", f"the animation {path} has no array {name!r}", hint=hint)
    found = arrays[name]
    if found.dtype.kind not in "fiu" or found.ndim < 2 or not found.size:
        shape = f"{found.dtype} {found.shape}"
        raise input_error("SC541", f"array {name!r} of {path} has no rows of numbers: {shape}")
    rows: NDArray[np.float64] = found.reshape(len(found), -1).astype(np.float64)
    if not np.isfinite(rows).all():
        raise input_error("SC541", f"array {name!r} of {path} holds NaN or infinity")
    return rows
