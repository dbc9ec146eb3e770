"""A camera that sees all of a model, whichever way it turns and however it is animated."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.scene.camera import FRAMES_PER_SECOND
from shadercache.scene.models.parts import Model, ModelPart
from shadercache.scene.models.pose import Pose

Up: TypeAlias = Literal["y", "z"]

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
    up: Up = "y"

    def upright(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """A direction where y is up, as it is here."""
        return (x, y, z) if self.up == "y" else (x, -z, y)


def framed(model: Model, animation: str | None, bends: bool, up: Up) -> Frame:
    """A camera before a model. ``bends``: the shader moves vertices by the model's bones."""
    points = np.concatenate(list(_places(model, animation, bends)))
    if up == "z":
        points = points[:, [0, 2, 1]] * [1.0, 1.0, -1.0]
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
    plain = Frame((0.0, 0.0, 0.0), radius, (0.0, 0.0, 0.0), near, far, up)
    middle, place = (plain.upright(*map(float, point)) for point in (centre, eye))
    return replace(plain, centre=middle, eye=place)


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
