"""The nodes of a model, what animates them, and the skins that they move.

Times are in seconds. Matrices are (4, 4), for column vectors.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]
Moved: TypeAlias = Mapping[tuple[int, str], Numbers]
"""What an animation sets at a time, by node and property."""


@dataclass(frozen=True, eq=False)
class Joint:
    """A node: its parent (an earlier node, or None), and where it is in that at rest.

    ``matrix`` goes before the three parts where a file gives it. ``weights`` are those of the morph
    targets of the mesh that hangs there.
    """

    parent: int | None
    translation: Numbers
    rotation: Numbers
    scale: Numbers
    matrix: Numbers | None = None
    weights: Numbers = field(default_factory=lambda: np.zeros(0))


@dataclass(frozen=True, eq=False)
class Channel:
    """Values (times, width) of ``translation``, ``rotation``, ``scale`` or ``weights`` of a node.

    With ``CUBICSPLINE`` there are three rows a time: slope before, value, slope behind.
    """

    node: int
    path: str
    times: Numbers
    values: Numbers
    interpolation: str

    def at(self, time: float) -> Numbers:
        """The value at a time; before the first and after the last it rests."""
        last = len(self.times) - 1
        low = int(np.clip(np.searchsorted(self.times, time, "right") - 1, 0, last))
        high = min(low + 1, last)
        span = float(self.times[high] - self.times[low])
        part = min(1.0, max(0.0, (time - float(self.times[low])) / span)) if span > 0.0 else 0.0
        if self.interpolation == "CUBICSPLINE":
            return self._unit(self._cubic(low, high, span, part))
        first: Numbers = self.values[low]
        second: Numbers = self.values[high]
        if self.interpolation == "STEP" or part == 0.0:
            return first
        if self.path == "rotation":
            return _slerp(first, second, part)
        mixed: Numbers = (1.0 - part) * first + part * second
        return mixed

    def _cubic(self, low: int, high: int, span: float, part: float) -> Numbers:
        _, first, leave = self.values[3 * low : 3 * low + 3]
        arrive, second, _ = self.values[3 * high : 3 * high + 3]
        t2, t3 = part * part, part * part * part
        # The cubic Hermite polynomials; slopes are a second's (glTF 2.0 appendix C).
        curve: Numbers = (
            (2 * t3 - 3 * t2 + 1) * first
            + span * (t3 - 2 * t2 + part) * leave
            + (3 * t2 - 2 * t3) * second
            + span * (t3 - t2) * arrive
        )
        return curve

    def _unit(self, value: Numbers) -> Numbers:
        return _unit(value) if self.path == "rotation" else value


@dataclass(frozen=True, eq=False)
class ModelAnimation:
    """Channels that are played together, in a circle of ``duration`` seconds."""

    name: str
    channels: tuple[Channel, ...]

    @property
    def duration(self) -> float:
        """Until the last of its times."""
        return max((float(channel.times[-1]) for channel in self.channels), default=0.0)


@dataclass(frozen=True, eq=False)
class Skin:
    """The nodes that move vertices, and the inverse of where each was when they were bound."""

    joints: tuple[int, ...]
    inverse_bind: Numbers


@dataclass(frozen=True, eq=False)
class Skeleton:
    """All nodes of a model, parents first."""

    joints: tuple[Joint, ...] = ()
    skins: tuple[Skin, ...] = ()
    animations: tuple[ModelAnimation, ...] = ()

    def moved(self, animation: ModelAnimation | None, time: float) -> Moved:
        """What an animation sets at a time, by node and property; nothing at rest."""
        if animation is None:
            return {}
        length = animation.duration
        at = time % length if length > 0.0 else 0.0
        return {(channel.node, channel.path): channel.at(at) for channel in animation.channels}

    def matrices(self, moved: Moved) -> list[Numbers]:
        """Where every node is in the model."""
        found: list[Numbers] = []
        for at, joint in enumerate(self.joints):
            own = _local(joint, at, moved)
            found.append(own if joint.parent is None else found[joint.parent] @ own)
        return found

    def bones(self, skin: int, matrices: Sequence[Numbers]) -> Numbers:
        """The matrices (joints, 4, 4) that move the vertices of a skin."""
        chosen = self.skins[skin]
        return np.stack([matrices[at] for at in chosen.joints]) @ chosen.inverse_bind

    def weights(self, node: int, moved: Moved) -> Numbers:
        """How far the morph targets of a node's mesh are moved."""
        return moved.get((node, "weights"), self.joints[node].weights)


def _local(joint: Joint, at: int, moved: Moved) -> Numbers:
    if joint.matrix is not None:
        return joint.matrix
    matrix = np.eye(4)
    turn = _turn(moved.get((at, "rotation"), joint.rotation))
    matrix[:3, :3] = turn * moved.get((at, "scale"), joint.scale)
    matrix[:3, 3] = moved.get((at, "translation"), joint.translation)
    return matrix


def _turn(quaternion: Numbers) -> Numbers:
    x, y, z, w = _unit(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def _unit(quaternion: Numbers) -> Numbers:
    length = float(np.linalg.norm(quaternion))
    return quaternion / length if length > 0.0 else np.array([0.0, 0.0, 0.0, 1.0])


def _slerp(first: Numbers, second: Numbers, part: float) -> Numbers:
    first, second = _unit(first), _unit(second)
    cosine = float(first @ second)
    if cosine < 0.0:  # the shorter way round
        second, cosine = -second, -cosine
    if cosine > 0.9995:  # so near that the sine below would be lost in rounding
        return _unit((1.0 - part) * first + part * second)
    angle = np.arccos(cosine)
    mixed: Numbers = np.sin((1.0 - part) * angle) * first + np.sin(part * angle) * second
    mixed /= np.sin(angle)
    return mixed
