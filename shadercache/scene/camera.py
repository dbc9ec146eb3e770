"""Matrices of a frame. Column vectors, right-handed, clip z from -w to w, as in OpenGL.

Everything is computed in float64 and rounded to float32 once, so that equal frames give equal bits.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from shadercache.scene.description import SceneObject, View
from shadercache.scene.models.pose import NO_BONES, NO_WEIGHTS
from shadercache.scene.motion import Camera, CameraPath, Motion
from shadercache.scene.object_inputs import INVERSES

Matrix = NDArray[np.float64]
Values = Mapping[str, NDArray[np.float64]]
"""Uniform name -> its numbers in the order of upload (n,); matrices column by column."""


FRAMES_PER_SECOND = 60.0


def uniform_values(
    view: View,
    scene_object: SceneObject,
    frame: int,
    size: tuple[int, int],
    jittered: int | None = None,
) -> Values:
    """The value of every uniform of an object at a frame, in a picture of a size in pixels, and of
    the attributes of its instances.

    ``jittered``: the frame whose jitter it has, if it is another.
    """
    width, height = size
    shift = shift_of(view, frame if jittered is None else jittered, size)
    values = semantic_values(view, scene_object.motion, frame, width / height, shift) | {
        "resolution": np.array([width, height], np.float64),
        # Of a Shadertoy: the shape of a pixel, 1, comes behind the size.
        "resolution-aspect": np.array([width, height, 1.0]),
    }
    given, played = scene_object.inputs, view.playback.at(frame)
    uniforms = {name: np.asarray(value, np.float64) for name, value in given.constants.items()}
    uniforms |= {name: animation.at(played) for name, animation in given.animated.items()}
    streams = {**given.instances.streams, **given.played}
    uniforms |= {name: stream.at(played) for name, stream in streams.items()}
    words = set(given.semantics.values())
    for word in words.intersection(INVERSES):
        values[word] = _inverse(values[INVERSES[word]])
    # A transpose read row by row is the matrix column by column; vectors stay as they are.
    return uniforms | {name: values[word].T.ravel() for name, word in given.semantics.items()}


def shift_of(view: View, frame: int, size: tuple[int, int]) -> tuple[float, float]:
    """The jitter of a frame in halves of the width and height of a picture of a size in pixels."""
    x, y = view.engine.shift(frame)
    # Clip space is two wide and two high.
    return 2.0 * x / size[0], 2.0 * y / size[1]


def semantic_values(
    view: View, motion: Motion, frame: int, aspect: float, shift: tuple[float, float] = (0.0, 0.0)
) -> dict[str, Matrix]:
    """Every semantic's value at a frame (counted from 0), but the picture's size.

    ``aspect`` is width / height, ``shift`` the jitter in halves of the picture's width and height.
    """
    camera, played = camera_at(view, frame), view.playback.at(frame)
    pose = None if motion.pose is None else motion.pose.at(played / FRAMES_PER_SECOND)
    model = model_matrix(motion, played)
    if pose is not None:
        model = model @ pose.matrix
    seen = look_at(camera)
    project = view.engine.projection(perspective(camera, aspect), shift)
    model_view = seen @ model
    values = {
        "model": model,
        "view": seen,
        "projection": project,
        "model-view": model_view,
        "view-projection": project @ seen,
        "model-view-projection": project @ model_view,
        "normal-matrix": _normal_matrix(model_view),
        "world-normal-matrix": _normal_matrix(model),
        "eye": np.asarray(camera.eye, np.float64),
        "time": np.asarray(view.start_time + played / FRAMES_PER_SECOND),
        # None in the first frame, which is also that of the scene at rest.
        "time-delta": np.asarray(view.playback.step / FRAMES_PER_SECOND if frame > 0 else 0.0),
        "frame": np.asarray(float(played)),
    }
    # One matrix beside the other, so that what is uploaded by columns has them in their order.
    values["bones"] = (NO_BONES if pose is None else pose.bones).transpose(1, 0, 2).reshape(4, -1)
    values["morph-weights"] = NO_WEIGHTS if pose is None else pose.weights
    return values


def _normal_matrix(matrix: Matrix) -> Matrix:
    return _inverse(matrix[:3, :3]).T


def _inverse(matrix: Matrix) -> Matrix:
    try:
        return np.asarray(np.linalg.inv(matrix), np.float64)
    except np.linalg.LinAlgError:  # animations may scale to nothing
        return np.asarray(np.linalg.pinv(matrix), np.float64)


def model_matrix(motion: Motion, frame: int) -> Matrix:
    """Where an object is at a frame: scaled, turned about its pivot, then put to its place."""
    matrix = rotation(motion, frame)
    matrix[:3, :3] *= motion.scale
    # What the scale and the turn do to the pivot is taken back.
    pivot = np.asarray(motion.pivot, np.float64)
    matrix[:3, 3] = np.asarray(motion.place(frame)) + (pivot - matrix[:3, :3] @ pivot)
    return matrix


def camera_at(view: View, frame: int) -> Camera:
    """The camera of a frame, on its path."""
    camera, path, frame = view.camera, view.camera_path, view.playback.at(frame)
    if path.keys:
        return _between_keys(camera, path, frame)
    if path.degrees_per_frame == 0.0:
        return camera
    turn = turn_about(camera.up, path.degrees_per_frame * frame)
    target = np.asarray(camera.target, np.float64)
    x, y, z = target + turn @ (np.asarray(camera.eye, np.float64) - target)
    return replace(camera, eye=(float(x), float(y), float(z)))


def _between_keys(camera: Camera, path: CameraPath, frame: int) -> Camera:
    """On the Catmull-Rom curve through the keys of a shot."""
    # A shot is what lies between two cuts: the curve must not look beyond them.
    past = [key for key in path.keys if key.frame <= frame]
    first = max((at for at, key in enumerate(past) if key.cut), default=0)
    rest = path.keys[len(past) :]
    end = next((at for at, key in enumerate(rest) if key.cut), len(rest))
    shot = [*past[first:], *rest[:end]]
    at = max(0, len(past) - first - 1)
    # At either end of a shot its last key stands in for the one that is missing.
    four = [shot[min(max(at + step, 0), len(shot) - 1)] for step in (-1, 0, 1, 2)]
    start, stop = four[1].frame, four[2].frame
    part = min(1.0, max(0.0, (frame - start) / (stop - start))) if stop > start else 0.0
    places = [np.array([key.eye, key.target, key.up], np.float64) for key in four]
    eye, target, up = ((float(x), float(y), float(z)) for x, y, z in _catmull_rom(places, part))
    angle = four[1].fov_degrees + part * (four[2].fov_degrees - four[1].fov_degrees)
    return replace(camera, eye=eye, target=target, up=up, fov_degrees=angle)


def _catmull_rom(points: Sequence[Matrix], part: float) -> Matrix:
    a, b, c, d = points
    if part == 0.0:  # At a key the camera is where the file says, to the bit.
        return b
    slope_b, slope_c = (c - a) / 2.0, (d - b) / 2.0
    # The cubic Hermite polynomials.
    t2, t3 = part * part, part * part * part
    curve: Matrix = (
        (2 * t3 - 3 * t2 + 1) * b
        + (t3 - 2 * t2 + part) * slope_b
        + (3 * t2 - 2 * t3) * c
        + (t3 - t2) * slope_c
    )
    return curve


def rotation(motion: Motion, frame: int) -> Matrix:
    """The turn of an object at a frame, as a matrix (4, 4)."""
    matrix = np.eye(4)
    angle = motion.start_degrees + motion.degrees_per_frame * frame
    matrix[:3, :3] = turn_about(motion.axis, angle)
    return matrix


def turn_about(axis_of_turn: Sequence[float], degrees: float) -> Matrix:
    """A turn about an axis (Rodrigues' formula), (3, 3)."""
    angle = math.radians(degrees)
    axis = np.asarray(axis_of_turn, np.float64)
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    bent = math.sin(angle) * cross + (1.0 - math.cos(angle)) * (cross @ cross)
    turn: Matrix = np.eye(3) + bent
    return turn


def look_at(camera: Camera) -> Matrix:
    """The view matrix."""
    eye = np.asarray(camera.eye, np.float64)
    # The camera looks along its own negative z axis.
    back = eye - np.asarray(camera.target, np.float64)
    back /= np.linalg.norm(back)
    right = np.cross(np.asarray(camera.up, np.float64), back)
    right /= np.linalg.norm(right)
    matrix = np.eye(4)
    matrix[:3, :3] = right, np.cross(back, right), back
    matrix[:3, 3] = -matrix[:3, :3] @ eye
    return matrix


def perspective(camera: Camera, aspect: float) -> Matrix:
    """The projection matrix."""
    scale = 1.0 / math.tan(math.radians(camera.fov_degrees) / 2.0)
    near, far = camera.near, camera.far
    matrix = np.zeros((4, 4))
    matrix[0, 0] = scale / aspect
    matrix[1, 1] = scale
    # Clip z from -w at the near plane to w at the far one; other clip spaces: GraphicsState.
    matrix[2, 2:] = (far + near) / (near - far), 2.0 * far * near / (near - far)
    matrix[3, 2] = -1.0
    return matrix
