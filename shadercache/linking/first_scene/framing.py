"""A camera that sees all of a model, whichever way it turns and however it is animated."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from shadercache.scene.camera import FRAMES_PER_SECOND
from shadercache.scene.models.parts import Model, ModelPart
from shadercache.scene.models.pose import Pose

FOV = 40.0
FRAMES = 64
_ABOVE = math.radians(15.0)
_MOST_VERTICES = 20_000


@dataclass(frozen=True, slots=True)
class Frame:
    """Where the middle of a model is, how far it reaches, and a camera before it."""

    centre: tuple[float, float, float]
    radius: float
    eye: tuple[float, float, float]
    near: float
    far: float


def framed(model: Model, animation: str | None, bends: bool) -> Frame:
    """A camera before a model. ``bends``: the shader moves vertices by the model's bones."""
    points = np.concatenate(list(_places(model, animation, bends)))
    low, high = points.min(0), points.max(0)
    centre = (low + high) / 2.0
    away = points - centre
    # About the upright axis it may turn in any way.
    round_about = float(np.hypot(away[:, 0], away[:, 2]).max())
    half = float(np.abs(away[:, 1]).max())
    radius = max(math.hypot(round_about, half), 1e-6)
    height = half * math.cos(_ABOVE) + round_about * math.sin(_ABOVE)
    seen = max(round_about, height) / math.tan(math.radians(FOV / 2.0))
    distance = 1.05 * seen + round_about * math.cos(_ABOVE) + half * math.sin(_ABOVE)
    eye = centre + distance * np.array([0.0, math.sin(_ABOVE), math.cos(_ABOVE)])
    near = max(0.5 * (distance - radius), 0.01 * distance)
    far = distance + 2.0 * radius
    return Frame(_vector(centre), radius, _vector(eye), near, far)


def _vector(point: NDArray[np.float64]) -> tuple[float, float, float]:
    x, y, z = map(float, point)
    return x, y, z


def _places(model: Model, animation: str | None, bends: bool) -> Iterator[NDArray[np.float64]]:
    frames = (0,) if animation is None else range(0, FRAMES, 9)
    for part in model.parts:
        chosen = slice(None, None, 1 + len(part.arrays["position"]) // _MOST_VERTICES)
        for frame in frames:
            pose = Pose(model.path, part.name, animation)
            yield _placed(part, pose, frame / FRAMES_PER_SECOND, chosen, bends)


def _placed(
    part: ModelPart, pose: Pose, seconds: float, chosen: slice, bends: bool
) -> NDArray[np.float64]:
    values = pose.at(seconds)
    points = part.arrays["position"][chosen].astype(np.float64)
    for at in range(part.targets):
        moved = part.arrays.get(f"morph{at}_position")
        if moved is not None:
            points = points + values.weights[at] * moved[chosen]
    whole = np.concatenate([points, np.ones((len(points), 1))], 1)
    if part.skin is None or not bends:
        return (whole @ values.matrix.T)[:, :3]
    bones = values.bones[part.arrays["joints"][chosen].astype(np.int64)]
    blended = np.einsum("nj,njab->nab", part.arrays["weights"][chosen], bones)
    found: NDArray[np.float64] = np.einsum("nab,nb->na", blended, whole)[:, :3]
    return found
