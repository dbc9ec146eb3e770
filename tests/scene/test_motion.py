"""Paths of cameras and objects, and uniforms that are animated."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import camera_at, look_at, model_matrix, uniform_values
from shadercache.scene.description import Scene
from shadercache.scene.motion import CameraPath, Key, Motion
from shadercache.scene.object_inputs import Ramp, Rows
from tests.altered import altered
from tests.configured import variant


def key(frame: int, x: float, fov: float = 40.0, cut: bool = False) -> Key:
    return Key(frame, (x, 0.0, 5.0), (x, 0.0, 0.0), (0.0, 1.0, 0.0), fov, cut)


def eye(scene: Scene, frame: int) -> tuple[float, float, float]:
    return camera_at(scene.view, frame).eye


def test_an_orbit_keeps_its_distance(scene: Scene) -> None:
    turning = altered(scene, camera_path=CameraPath(degrees_per_frame=10.0))
    x, y, z = np.subtract(scene.view.camera.eye, scene.view.camera.target)
    moved = np.subtract(eye(turning, 9), scene.view.camera.target)
    assert np.allclose(moved, [z, y, -x])
    assert eye(turning, 0) == pytest.approx(scene.view.camera.eye)
    assert eye(scene, 9) == scene.view.camera.eye


def test_keys_are_reached_and_a_shot_ends_at_a_cut(scene: Scene) -> None:
    keys = (key(2, 0.0), key(6, 4.0), key(10, 8.0, 20.0), key(14, -50.0, cut=True), key(16, -48.0))
    path = altered(scene, camera_path=CameraPath(keys=keys))
    assert [eye(path, frame)[0] for frame in (0, 2, 6, 10, 12, 13)] == [0, 0, 4, 8, 8, 8]
    assert [eye(path, frame)[0] for frame in (14, 16, 99)] == [-50, -48, -48]
    assert eye(path, 15)[0] == pytest.approx(-49.0)
    assert 0.0 < eye(path, 3)[0] < eye(path, 4)[0] < eye(path, 5)[0] < 4.0
    assert camera_at(path.view, 8).fov_degrees == pytest.approx(30.0)
    assert path.view.camera_path.cuts == {14}


def test_a_straight_row_of_keys_is_even(scene: Scene) -> None:
    keys = tuple(key(4 * at, float(at)) for at in range(5))
    path = altered(scene, camera_path=CameraPath(keys=keys))
    steps = np.diff([eye(path, frame)[0] for frame in range(4, 13)])
    assert np.allclose(steps, 0.25)


def test_objects_turn_about_their_pivot() -> None:
    axis, pivot = (0.0, 1.0, 0.0), (1.0, 2.0, 3.0)
    motion = Motion(axis, 30.0, 0.0, 9, (0.0, 0.0, 5.0), scale=2.0, pivot=pivot)
    for frame in (0, 1, 5):
        assert np.allclose(model_matrix(motion, frame) @ [*pivot, 1], [1, 2, 8, 1])
    assert np.allclose(model_matrix(motion, 3) @ [2, 2, 3, 1], [1, 2, 6, 1])


def test_inverses_and_normals(scene: Scene) -> None:
    words = {"a": "inverse-model-view", "b": "world-normal-matrix", "c": "bones"}
    named = altered(scene, semantics=words)
    values = uniform_values(named.view, named.common, 3, (64, 64))
    model = model_matrix(scene.common.motion, 3)
    inverse = np.linalg.inv(look_at(scene.view.camera) @ model)
    assert np.allclose(values["a"].reshape(4, 4).T, inverse)
    assert np.allclose(values["b"].reshape(3, 3).T, model[:3, :3]), "a turn is its own"
    assert values["c"][:16].tolist() == np.eye(4).ravel().tolist()


def test_objects_are_scaled_turned_and_put_somewhere() -> None:
    motion = Motion(
        (0.0, 1.0, 0.0), 90.0, 0.0, 4, (1.0, 0.0, 0.0), (0.0, 0.5, 0.0), 2.0, ((3, (9.0, 0, 0)),)
    )
    assert np.allclose(model_matrix(motion, 1) @ [0, 0, 1, 1], [3.0, 0.5, 0.0, 1.0])
    assert np.allclose(model_matrix(motion, 4) @ [0, 0, 0, 1], [9.0, 0.5, 0.0, 1.0])


def test_animated_uniforms(scene: Scene, tmp_path: Path) -> None:
    path = tmp_path / "rows.npz"
    np.savez(path, rows=np.arange(6.0).reshape(3, 2), flat=np.zeros(3), bad=[[np.nan]])
    table = Rows(path, "rows", rate=0.5)
    assert [table.at(frame).tolist() for frame in (0, 1, 2, 5, 6)] == [
        [0.0, 1.0], [1.0, 2.0], [2.0, 3.0], [2.0, 3.0], [0.0, 1.0],
    ]  # fmt: skip
    moving = altered(scene, animated={"u_scale": Ramp((5.0,), (0.5,)), "u_rows": table})
    values = uniform_values(moving.view, moving.common, 2, (8, 8))
    assert values["u_scale"].tolist() == [6.0] and values["u_rows"].tolist() == [2.0, 3.0]
    for wrong in ("flat", "bad", "none"):
        with pytest.raises(InputError, match="SC541"):
            Rows(path, wrong).at(0)


def test_a_scene_played_from_another_frame_and_faster(scene: Scene) -> None:
    keys = (key(2, 0.0), key(7, 4.0, cut=True), key(20, 9.0))
    moving = altered(
        scene, camera_path=CameraPath(keys=keys), animated={"u_a": Ramp((0.0,), (1.0,))}
    )
    faster = moving.played(4, 2)
    for frame in range(5):
        size = (8, 8)
        shown = uniform_values(faster.view, faster.common, frame, size)
        meant = uniform_values(moving.view, moving.common, 4 + 2 * frame, size)
        assert all(np.array_equal(shown[name], meant[name]) for name in meant)
    # The jump lies between what two frames show.
    assert [faster.view.is_cut(frame) for frame in range(4)] == [False, False, True, False]
    assert [moving.view.is_cut(frame) for frame in (6, 7, 8)] == [False, True, False]


def test_runners_are_told_of_a_cut(gpu: Gpu, scene: Scene, bundle: Bundle) -> None:
    near = replace(key(0, 0.1), eye=(0.1, 1.2, 2.6))
    keys = (near, replace(near, frame=3, eye=(0.4, 1.0, 2.8), cut=True))
    options = {"period": 16, "form": "rgba32f"}
    for told in (True, False):
        shots = tuple(replace(item, cut=item.cut and told) for item in keys)
        path = altered(scene, camera_path=CameraPath(keys=shots))
        with RenderScene(gpu, path, (96, 64), "rgba32f") as world:
            original = render_original(world, [bundle], range(4))
            with variant(world, bundle, "2-pass", **options) as runner:
                cached = [runner.image(frame) for frame in range(4)]
        assert (original[3].tobytes() == cached[3].tobytes()) == told
