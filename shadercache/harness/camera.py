"""Matrices of a frame. Column vectors, right-handed, clip z from -w to w, as in OpenGL.

Everything is computed in float64 and rounded to float32 once, so that equal frames give equal bits.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from shadercache.harness.scene import Camera, Motion, Scene

Matrix = NDArray[np.float64]
Values = Mapping[str, NDArray[np.float64]]
"""Uniform name -> its numbers in the order of upload (n,); matrices column by column."""

FRAMES_PER_SECOND = 60.0


def semantic_values(scene: Scene, frame: int, aspect: float) -> dict[str, Matrix]:
    """Every semantic's value at a frame (counted from 0); ``aspect`` is width / height.

    ``normal-matrix`` is the inverse transpose of the model-view matrix (3x3), ``eye`` the camera's
    place in the world, ``time`` seconds at 60 frames a second, ``time-delta`` those since the last
    frame (none in the first, which is also the scene at rest).
    """
    model = rotation(scene.motion, frame)
    view = look_at(scene.camera)
    project = perspective(scene.camera, aspect)
    model_view = view @ model
    return {
        "model": model,
        "view": view,
        "projection": project,
        "model-view": model_view,
        "view-projection": project @ view,
        "model-view-projection": project @ model_view,
        "normal-matrix": np.linalg.inv(model_view[:3, :3]).T,
        "eye": np.asarray(scene.camera.eye, np.float64),
        "time": np.asarray(scene.start_time + frame / FRAMES_PER_SECOND),
        "time-delta": np.asarray(1.0 / FRAMES_PER_SECOND if frame > 0 else 0.0),
        "frame": np.asarray(float(frame)),
    }


def scene_values(scene: Scene, frame: int, size: tuple[int, int]) -> Values:
    """The value of every uniform of the scene at a frame, in a picture of a size in pixels.

    ``resolution`` is that size, ``resolution-aspect`` the same with the shape of a pixel, 1.
    """
    width, height = size
    values = semantic_values(scene, frame, width / height) | {
        "resolution": np.array([width, height], np.float64),
        "resolution-aspect": np.array([width, height, 1.0]),
    }
    uniforms = {name: np.asarray(value, np.float64) for name, value in scene.constants.items()}
    # A transpose read row by row is the matrix column by column; vectors stay as they are.
    return uniforms | {name: values[word].T.ravel() for name, word in scene.semantics.items()}


def rotation(motion: Motion, frame: int) -> Matrix:
    """The model matrix: a turn about the motion's axis (Rodrigues' formula)."""
    angle = math.radians(motion.start_degrees + motion.degrees_per_frame * frame)
    axis = np.asarray(motion.axis, np.float64)
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    matrix = np.eye(4)
    matrix[:3, :3] += math.sin(angle) * cross + (1.0 - math.cos(angle)) * (cross @ cross)
    return matrix


def look_at(camera: Camera) -> Matrix:
    """The view matrix."""
    eye = np.asarray(camera.eye, np.float64)
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
    matrix[2, 2:] = (far + near) / (near - far), 2.0 * far * near / (near - far)
    matrix[3, 2] = -1.0
    return matrix
