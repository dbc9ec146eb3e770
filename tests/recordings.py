"""Recordings of what a scene would give its shaders, as an engine would dump them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from shadercache.scene.camera import uniform_values
from shadercache.scene.description import Scene

Frames = Sequence[Mapping[str, np.ndarray]]


def dumped(scene: Scene, frames: int, size: tuple[int, int]) -> Frames:
    """The values of every uniform of the scene's objects, one mapping a frame.

    Those of objects are called ``object/name``.
    """

    def at(frame: int) -> Mapping[str, np.ndarray]:
        return {
            (f"{part.name}/{name}" if scene.objects else name): values
            for part in scene.parts
            for name, values in uniform_values(scene.view, part, frame, size).items()
        }

    return [at(frame) for frame in range(frames)]


def write_csv(path: Path, frames: Frames, cuts: Sequence[int] = ()) -> Path:
    """A column for each number, and one that says where cuts are."""
    names = ["cut"]
    for name, values in frames[0].items():
        names += [name] if values.size == 1 else [f"{name}[{at}]" for at in range(values.size)]
    lines = [",".join(names)]
    for number, frame in enumerate(frames):
        numbers = [value for values in frame.values() for value in np.ravel(values).tolist()]
        lines.append(",".join(map(repr, [int(number in cuts), *numbers])))
    path.write_text("\n".join(lines) + "\n")
    return path


def write_toml(path: Path, frames: Frames, cuts: Sequence[int] = ()) -> Path:
    """A table for each frame, with one in it for each object that has values of its own."""
    lines: list[str] = []
    for number, frame in enumerate(frames):
        lines += ["[[frames]]", f"cut = {str(number in cuts).lower()}"]
        owned: dict[str, list[str]] = {}
        for key, values in frame.items():
            owner, _, name = key.rpartition("/")
            text = repr(values.tolist() if values.size > 1 else float(values.ravel()[0]))
            owned.setdefault(owner, []).append(f'"{name}" = {text}')
        lines += owned.pop("", [])
        for owner, entries in owned.items():
            lines += [f'[frames.objects."{owner}"]', *entries]
    path.write_text("\n".join(lines) + "\n")
    return path
