"""Where a part of a model is at a frame, and how its bones and morph targets stand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.scene.models.load import load_model
from shadercache.scene.models.skeleton import Moved, Skeleton

MOST_BONES = 256
"""Matrices that ``bones`` has, those of the unit behind the skin's: shaders may have more."""

MOST_WEIGHTS = 64
"""Numbers that ``morph-weights`` has, zeros behind those of the model."""

NO_BONES, NO_WEIGHTS = np.tile(np.eye(4), (MOST_BONES, 1, 1)), np.zeros(MOST_WEIGHTS)
"""Of what has neither."""


@dataclass(frozen=True, eq=False)
class PoseValues:
    """``matrix`` puts the part into the model; ``bones`` (n, 4, 4) move its vertices."""

    matrix: NDArray[np.float64]
    bones: NDArray[np.float64]
    weights: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Pose:
    """A part of a model's file, and the animation that it plays, in a circle.

    ``speed``: seconds of the animation in a second of the scene's clock.
    """

    path: Path
    part: str
    animation: str | None = None
    speed: float = 1.0

    def at(self, seconds: float) -> PoseValues:
        """What it is at a time. Raises InputError SC51x for a model that does not hold it."""
        return _values(self, seconds * self.speed if self.animation is not None else 0.0)

    @property
    def bone_count(self) -> int:
        """How many bones move the part."""
        model = load_model(self.path)
        skin = model.part(self.part).skin
        return 0 if skin is None else len(model.skeleton.skins[skin].joints)


@lru_cache(maxsize=256)
def _values(pose: Pose, time: float) -> PoseValues:
    model = load_model(pose.path)
    part, skeleton = model.part(pose.part), model.skeleton
    moved, matrices = _skeleton_at(pose.path, pose.animation, time)
    if part.node is None:
        return PoseValues(np.eye(4), NO_BONES, NO_WEIGHTS)
    own = skeleton.weights(part.node, moved)[:MOST_WEIGHTS]
    weights = NO_WEIGHTS.copy()
    weights[: len(own)] = own
    # Bones put vertices into the model, wherever the node is (glTF 2.0 section 3.7.3.3).
    matrix = matrices[part.node] if part.skin is None else np.eye(4)
    return PoseValues(matrix, _bones(skeleton, part.skin, matrices), weights)


# The parts of a model share it.
@lru_cache(maxsize=64)
def _skeleton_at(
    path: Path, animation: str | None, time: float
) -> tuple[Moved, list[NDArray[np.float64]]]:
    model = load_model(path)
    played = None if animation is None else model.animation(animation)
    moved = model.skeleton.moved(played, time)
    return moved, model.skeleton.matrices(moved)


def _bones(
    skeleton: Skeleton, skin: int | None, matrices: list[NDArray[np.float64]]
) -> NDArray[np.float64]:
    if skin is None:
        return NO_BONES
    found = skeleton.bones(skin, matrices)
    return np.concatenate([found, NO_BONES[len(found) :]])
