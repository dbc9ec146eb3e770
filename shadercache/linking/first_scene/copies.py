"""Instances that stand in for those of an engine, where a vertex shader has a matrix of each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from shadercache.linking.first_scene.framing import Frame
from shadercache.linking.first_scene.shader_inputs import Wanted

COUNT = 6
_SIZE = 0.4
_FILE = "instances.npz"


def is_of_instance(wanted: Wanted) -> bool:
    """Is it an attribute that no model has an array for, but engines give each instance?"""
    kind = wanted.type
    return kind.is_matrix and kind.cols == kind.rows == 4 and not kind.is_array


def copies(wanted: Sequence[Wanted], frame: Frame, folder: Path) -> Iterator[str]:
    """The table of a scene file, if there are any; their matrices are written to the folder."""
    if not wanted:
        return
    matrices = np.stack([_matrix(number, frame).T for number in range(COUNT)])
    np.savez_compressed(folder / _FILE, matrix=matrices.reshape(COUNT, 16).astype(np.float32))
    yield ""
    yield f"[instances]  # (guess) {COUNT} small ones, where the model is"
    for item in wanted:
        yield f'{item.name} = {{ table = "{_FILE}", array = "matrix" }}  # {item.spelt}'


def _matrix(number: int, frame: Frame) -> np.ndarray:
    """Smaller about the middle, and moved away from it, each in its own direction."""
    turn = 2.0 * np.pi * number / COUNT
    away = 0.6 * frame.radius * np.asarray(frame.upright(np.cos(turn), 0.0, np.sin(turn)))
    matrix = np.diag([_SIZE, _SIZE, _SIZE, 1.0])
    matrix[:3, 3] = np.asarray(frame.centre) * (1.0 - _SIZE) + away
    return matrix
