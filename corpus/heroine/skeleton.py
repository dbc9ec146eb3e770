"""Her bones and how she walks: where the joints are at rest, and their turns in each frame.

Metres; y is up, she looks along +z, her left is +x. Angles in radians.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

CYCLE = 60
"""Frames of two steps."""
STRIDE = 0.023
"""Metres that she walks in a frame: what the foot on the ground goes back."""


@dataclass(frozen=True)
class Bone:
    """A bone from its joint to its end; it turns about the joint with all that hangs on it."""

    name: str
    parent: str | None
    joint: tuple[float, float, float]
    end: tuple[float, float, float]


def _limbs(side: str, sign: float) -> list[Bone]:
    def at(x: float, y: float, z: float) -> tuple[float, float, float]:
        return (sign * x, y, z)

    shoulder, elbow, wrist = at(0.158, 1.385, -0.01), at(0.290, 1.155, -0.02), at(0.400, 0.945, 0.0)
    hip, knee, ankle = at(0.088, 0.93, 0.0), at(0.098, 0.50, 0.012), at(0.104, 0.085, -0.025)
    ball = at(0.110, 0.028, 0.085)
    return [
        Bone("collar." + side, "chest", at(0.03, 1.385, 0.0), shoulder),
        Bone("upper arm." + side, "collar." + side, shoulder, elbow),
        Bone("forearm." + side, "upper arm." + side, elbow, wrist),
        Bone("hand." + side, "forearm." + side, wrist, at(0.458, 0.81, 0.015)),
        Bone("thigh." + side, "pelvis", hip, knee),
        Bone("shin." + side, "thigh." + side, knee, ankle),
        Bone("foot." + side, "shin." + side, ankle, ball),
        Bone("toes." + side, "foot." + side, ball, at(0.112, 0.025, 0.145)),
    ]


BONES = (
    Bone("pelvis", None, (0.0, 0.96, 0.0), (0.0, 1.06, 0.0)),
    Bone("spine", "pelvis", (0.0, 1.06, 0.0), (0.0, 1.20, 0.01)),
    Bone("chest", "spine", (0.0, 1.20, 0.01), (0.0, 1.42, -0.01)),
    Bone("neck", "chest", (0.0, 1.42, -0.01), (0.0, 1.51, 0.0)),
    Bone("head", "neck", (0.0, 1.51, 0.0), (0.0, 1.70, 0.0)),
    Bone("hair", "head", (0.0, 1.60, -0.10), (0.0, 1.43, -0.15)),
    Bone("braid", "hair", (0.0, 1.43, -0.15), (0.0, 1.20, -0.14)),
    *_limbs("left", 1.0),
    *_limbs("right", -1.0),
)
NUMBER = {bone.name: number for number, bone in enumerate(BONES)}


def turn(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Floats:
    """A turn about x, then y, then z (3, 3)."""
    (a, b, c), (d, e, f) = np.cos([x, y, z]), np.sin([x, y, z])
    about_x = np.array([[1, 0, 0], [0, a, -d], [0, d, a]])
    about_y = np.array([[b, 0, e], [0, 1, 0], [-e, 0, b]])
    about_z = np.array([[c, -f, 0], [f, c, 0], [0, 0, 1]])
    return np.asarray(about_z @ about_y @ about_x)


def pose(phase: float) -> dict[str, Floats]:
    """The turn of each bone against its parent at a phase of the walk, 0 to 2 pi."""
    turns = {
        "pelvis": turn(y=0.10 * np.sin(phase), z=0.035 * np.cos(phase)),
        "spine": turn(x=0.04, y=-0.09 * np.sin(phase), z=-0.03 * np.cos(phase)),
        "chest": turn(y=-0.12 * np.sin(phase), z=-0.02 * np.cos(phase)),
        "neck": turn(y=0.06 * np.sin(phase)),
        "head": turn(x=0.02 * np.cos(2.0 * phase), y=0.05 * np.sin(phase)),
        "hair": turn(x=-0.06 + 0.05 * np.cos(2.0 * phase - 0.8), z=0.07 * np.sin(phase - 0.7)),
        "braid": turn(x=-0.10 + 0.09 * np.cos(2.0 * phase - 1.5), z=0.12 * np.sin(phase - 1.2)),
    }
    for side, sign, own in (("left", 1.0, phase), ("right", -1.0, phase + np.pi)):
        swing = np.sin(own)
        bend = 0.14 + 0.42 * (1.0 + np.cos(own + 0.55)) * 0.5 + 0.45 * max(0.0, np.cos(own)) ** 2
        turns |= {
            "thigh." + side: turn(x=-0.40 * swing - 0.10),
            "shin." + side: turn(x=bend - 0.14),
            "foot." + side: turn(x=0.05 - 0.28 * max(0.0, swing) + 0.25 * max(0.0, -swing)),
            "toes." + side: turn(x=-0.35 * max(0.0, -swing) ** 2),
            "collar." + side: turn(y=0.05 * swing),
            "upper arm." + side: turn(x=0.42 * swing, z=-0.36 * sign),
            "forearm." + side: turn(x=-0.30 - 0.16 * max(0.0, -swing), y=-0.25 * sign),
            "hand." + side: turn(x=-0.10, z=0.06 * sign),
        }
    return turns


def placed(turns: Mapping[str, Floats]) -> Floats:
    """Where the turns put what is at rest: a matrix (4, 4) for each bone."""
    matrices = np.tile(np.eye(4), (len(BONES), 1, 1))
    for number, bone in enumerate(BONES):
        about = np.eye(4)
        about[:3, :3] = turns[bone.name]
        about[:3, 3] = np.asarray(bone.joint) - turns[bone.name] @ np.asarray(bone.joint)
        above = np.eye(4) if bone.parent is None else matrices[NUMBER[bone.parent]]
        matrices[number] = above @ about
    return matrices


def walk() -> npt.NDArray[np.float32]:
    """The bones' matrices in each frame of the walk (frames, bones, 16), column by column.

    The lower foot stands on the ground; the way that she walks is not in them.
    """
    soles = [(NUMBER[f"{part}.{side}"], height) for side in ("left", "right")
             for part, height in (("foot", 0.005), ("toes", 0.0))]  # fmt: skip
    frames = []
    for frame in range(CYCLE):
        matrices = placed(pose(2.0 * np.pi * frame / CYCLE))
        low = min(
            (matrices[number] @ [*_below(BONES[number], height), 1.0])[1]
            for number, height in soles
        )
        lift = np.eye(4)
        lift[1, 3] = -low
        frames.append(lift @ matrices)
    columns = np.asarray(frames).transpose(0, 1, 3, 2)
    return columns.reshape(CYCLE, len(BONES), 16).astype(np.float32)


def _below(bone: Bone, height: float) -> tuple[float, float, float]:
    """The point of a sole below a joint: below the heel for the foot."""
    x, _, z = bone.joint
    return (x, height, z - 0.03 if bone.name.startswith("foot") else z + 0.05)
