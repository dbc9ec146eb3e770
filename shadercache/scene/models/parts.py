"""A model as it is drawn: parts with arrays and materials, on the nodes of a skeleton."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import InputError, input_error
from shadercache.scene.models.skeleton import ModelAnimation, Skeleton

Floats = NDArray[np.float32]

ROLES = ("albedo", "normal", "roughness", "occlusion", "emissive")
"""What a texture of a material is for. ``roughness`` holds the metalness as well."""

MOST_PARTS = 2_000

_ABSENT = {
    **{"color": (1, 1, 1, 1), "tangent": (1, 0, 0, 1), "bitangent": (0, 1, 0)},
    "weights": (1, 0, 0, 0),
}
"""What a part has in the place of an array that only others have; zeros for the rest."""


@dataclass(frozen=True, eq=False)
class Picture:
    """An encoded image: a file, or the bytes of one. ``flipped``: its last row lies at v = 0."""

    name: str
    data: bytes | Path
    flipped: bool = False


@dataclass(frozen=True, eq=False)
class Material:
    """What a model says of a surface. ``textures`` by their role, one of :data:`ROLES`."""

    name: str = ""
    color: tuple[float, ...] | None = None
    metallic: float | None = None
    roughness: float | None = None
    emissive: tuple[float, ...] | None = None
    two_sided: bool = False
    textures: Mapping[str, Picture] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class ModelPart:
    """What is drawn at once. ``node`` and ``skin`` count those of the skeleton.

    Arrays (n, c): ``position``, ``normal``, ``uv``, ``uv1``, ``tangent``, ``color``, ``joints``,
    ``weights``, and ``morph0_position``, ``morph0_normal``, ... of the ``targets``. ``computed``
    names those that the file lacks.
    """

    name: str
    arrays: Mapping[str, Floats]
    index: NDArray[np.uint32]
    material: Material = Material()
    node: int | None = None
    skin: int | None = None
    targets: int = 0
    computed: frozenset[str] = frozenset()


def filled(parts: Sequence[ModelPart]) -> list[ModelPart]:
    """The parts, each with every array that any of them has: one shader draws them all."""
    widths: dict[str, int] = {}
    for part in parts:
        for name, array in part.arrays.items():
            widths[name] = max(widths.get(name, 0), array.shape[1])
    whole = []
    for part in parts:
        count = len(part.arrays["position"])
        lacking = {
            name: np.tile(np.array(_ABSENT.get(name, (0,) * 4)[:width], np.float32), (count, 1))
            for name, width in widths.items()
            if name not in part.arrays
        }
        added = part.computed | set(lacking)
        whole.append(replace(part, arrays={**part.arrays, **lacking}, computed=added))
    return whole


@dataclass(frozen=True, eq=False)
class Model:
    """A file's parts. ``files`` are all that it was read from."""

    path: Path
    parts: tuple[ModelPart, ...]
    skeleton: Skeleton = field(default_factory=Skeleton)
    files: tuple[Path, ...] = ()

    def part(self, name: str) -> ModelPart:
        """The part of a name. Raises InputError SC515."""
        for part in self.parts:
            if part.name == name:
                return part
        raise self._unknown("part", name, [part.name for part in self.parts])

    def animation(self, name: str) -> ModelAnimation:
        """The animation of a name. Raises InputError SC515."""
        for animation in self.skeleton.animations:
            if animation.name == name:
                return animation
        known = [animation.name for animation in self.skeleton.animations]
        raise self._unknown("animation", name, known)

    def _unknown(self, what: str, name: str, known: list[str]) -> InputError:
        hint = f"it has: {', '.join(known)}" if known else f"it has no {what} at all"
        return input_error("SC515", f"the model {self.path} has no {what} '{name}'", hint)
