"""Arrays of numbers that a scene plays: attributes of instances, textures of poses, buffers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error
from shadercache.scene.npz import load_npz

MOST = 1 << 24
"""Numbers of a frame."""

SHAPES = {1: "(numbers)", 2: "(instances, numbers)", 3: "(height, width, channels)"}
"""What one frame is, by its dimensions."""


@dataclass(frozen=True, slots=True)
class Stream:
    """An array of an ``.npz`` file: one frame, or with a first dimension of frames, played in a
    circle with ``rate`` frames of it in a frame of the scene.

    ``dims`` are those of a frame (:data:`SHAPES`). Matrices lie column by column, as OpenGL reads
    them. Between two frames numbers are mixed.
    """

    path: Path
    array: str
    rate: float = 1.0
    dims: int = 2

    @property
    def moves(self) -> bool:
        """Does it change from frame to frame?"""
        return len(self._frames) > 1

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of a frame. Raises :class:`InputError` SC541: the file does not hold it."""
        return self._frames.shape[1:]

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers at a frame, one behind the other. Raises as :attr:`shape`."""
        frames = self._frames
        place = frame * self.rate if self.moves else 0.0
        low = int(np.floor(place))
        part = place - low
        first, second = frames[low % len(frames)], frames[(low + 1) % len(frames)]
        mixed: NDArray[np.float64] = (1.0 - part) * first + part * second
        return mixed.ravel()

    @property
    def _frames(self) -> NDArray[np.float64]:
        return _frames(self.path, self.array, self.dims)


@lru_cache(maxsize=32)
def _frames(path: Path, name: str, dims: int) -> NDArray[np.float64]:
    arrays = load_npz(path, "SC541", "the table")
    if name not in arrays:
        hint = f"it has: {', '.join(sorted(arrays))}"
        raise input_error("SC541", f"{path} has no array {name!r}", hint=hint)
    stored = arrays[name]
    if stored.dtype.kind not in "fiu" or stored.ndim not in (dims, dims + 1) or not stored.size:
        message = f"array {name!r} of {path} does not fit: {stored.dtype} {stored.shape}"
        shape = SHAPES[dims]
        raise input_error("SC541", message, hint=f"{shape}, or (frames, {shape[1:]}")
    frames: NDArray[np.float64] = stored.astype(np.float64)
    if not np.isfinite(frames).all():
        raise input_error("SC541", f"array {name!r} of {path} holds NaN or infinity")
    if frames.size > MOST * max(1, len(frames)):
        raise input_error(
            "SC541", f"array {name!r} of {path} has more than {MOST:,} numbers a frame"
        )
    return frames if frames.ndim == dims + 1 else frames[None]
