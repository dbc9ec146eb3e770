"""S17's path: a camera that cuts, rolls, dives through bodies and goes far away and back, before
bodies that appear, vanish and jump. All by a seed.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from shadercache.scene.motion import Camera, Key, Motion

from .crowds import Body, Vector, ball, fence, sheet

FAR = 1e6
"""How far the camera goes from the origin; one body lives there."""
CAMERA = Camera((0.0, 1.0, 6.0), (0.0, 0.5, 0.0), (0.0, 1.0, 0.0), 55.0, 0.05, 400.0)
EVENTS = ("glide", "glide", "glide", "glide", "roll", "dive", "dive", "cut", "far", "rest")


def bodies(seed: int, frames: int) -> Mapping[str, Body]:
    """A floor, balls, bars, and one ball far away; all but the floor come and go."""
    pick = random.Random(seed)
    floor = sheet("floor", [(-20.0, -0.6, 20.0), (-20.0, -0.6, -20.0), (20.0, -0.6, -20.0)], 16)
    made = {"floor": Body(floor)}
    made["far"] = Body(
        ball("far", 1.5), replace(_wild(pick, frames), position=(FAR, 0.0, 0.0), jumps=())
    )
    for number in range(3):
        radius = pick.uniform(0.4, 1.0)
        made[f"ball{number}"] = Body(ball(f"ball{number}", radius), _wild(pick, frames))
    made["bars"] = Body(fence("bars", 17, 3.0, 2.0, 0.05), _wild(pick, frames))
    return made


def _wild(pick: random.Random, frames: int) -> Motion:
    """Turning and drifting; there in some spans of frames, elsewhere after each of some frames."""
    spans, at = [], 0
    while at < frames:
        end = at + pick.randint(4, 20)
        spans.append((at, end))
        at = end + pick.randint(1, 5)
    jumps = sorted(pick.sample(range(1, frames), min(frames - 1, max(1, frames // 12))))
    return Motion(
        axis=_point(pick, 1.0),
        degrees_per_frame=pick.uniform(-12.0, 12.0),
        start_degrees=pick.uniform(0.0, 360.0),
        frames=frames,
        position=_point(pick, 1.5),
        velocity=_point(pick, 0.04),
        scale=pick.uniform(0.6, 1.4),
        jumps=tuple((jump, _point(pick, 1.5)) for jump in jumps),
        visible=tuple(spans),
    )


def path(seed: int, frames: int, told: bool = False) -> tuple[list[Key], list[str]]:
    """A key for every frame, and what happens in each; ``told``: cuts are marked as such."""
    pick = random.Random(seed + 1)
    keys: list[Key] = []
    events: list[str] = []
    eye, aim, roll = np.array(CAMERA.eye), np.array(CAMERA.target), 0.0
    home = eye.copy()
    event, left = "glide", 6
    step = np.zeros(3)
    for frame in range(frames):
        if left == 0:
            was, event = event, pick.choice(EVENTS)
            left = 1 if event == "cut" else pick.randint(3, 9)
            step = np.array(_point(pick, 0.12))
            if was == "far":
                eye, aim = home.copy(), np.array(_point(pick, 0.5))
            elif event == "far":
                home = eye.copy()
                eye = np.array([FAR, 0.0, 0.0]) + _point(pick, 4.0)
                aim = np.array([FAR, 0.0, 0.0])
            elif event == "cut":
                eye, aim = np.array(_point(pick, 5.0)), np.array(_point(pick, 1.0))
            elif event == "dive":
                step = (aim - eye) * pick.uniform(0.1, 0.35)
        left -= 1
        if event in ("glide", "far"):
            eye = eye + step
        elif event == "roll":
            roll += pick.uniform(0.05, 0.4)
        elif event == "dive":
            eye, aim = eye + step, aim + step
        jumped = event == "cut" or (events[-1:] != ["far"]) != (event != "far")
        keys.append(_key(frame, eye, aim, roll, told and jumped and frame > 0))
        events.append(event)
    return keys, events


def _key(frame: int, eye: np.ndarray, aim: np.ndarray, roll: float, cut: bool) -> Key:
    back = eye - aim
    if np.linalg.norm(back) < 1e-3:
        back = np.array([0.0, 0.0, 1.0])
    back = back / np.linalg.norm(back)
    side = np.cross([0.0, 1.0, 0.0], back)
    side = np.array([1.0, 0.0, 0.0]) if np.linalg.norm(side) < 1e-3 else side
    side = side / np.linalg.norm(side)
    up = np.cos(roll) * np.cross(back, side) + np.sin(roll) * side
    return Key(frame, _vector(eye), _vector(eye - back), _vector(up), CAMERA.fov_degrees, cut)


def _point(pick: random.Random, most: float) -> Vector:
    return (pick.uniform(-most, most), pick.uniform(-most, most), pick.uniform(-most, most))


def _vector(values: np.ndarray) -> Vector:
    x, y, z = map(float, values)
    return (x, y, z)
