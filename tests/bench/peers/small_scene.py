"""A ring that turns, drawn by one of two shaders, and the pictures of peers of it."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bench.peers.comparison import PEERS, Setting
from bench.peers.scene_programs import ScenePrograms
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene, open_scene
from shadercache.measure.subjects import OriginalSubject
from shadercache.paths import data_path
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from tests.torus.mesh import torus

SIZE, FRAMES = 96, 9

Image = NDArray[np.int16]


def ring(
    folder: Path, shader: str = "patterned", turns: bool = True, thinner: float = 0.0
) -> Setting:
    """The scene in a new folder; ``turns``: or it rests. It is 0.3 thick, or ``thinner``."""
    shutil.copytree(Path(__file__).parent / "scene", folder, dirs_exist_ok=True)
    arrays = torus()
    arrays["position"] -= np.float32(thinner) * arrays["normal"]
    np.savez(folder / "torus.npz", **arrays)
    scene = load_scene(folder)
    common = replace(scene.common, fragment=folder / f"{shader}.frag")
    if not turns:
        common = replace(common, motion=replace(common.motion, degrees_per_frame=0.0))
    linker = Linker(*analyse_scene(replace(scene, common=common), mapping="surface"))
    return Setting(linker, ScenePrograms.of(linker), FRAMES)


def corpus(name: str) -> Setting:
    """A scene of the corpus."""
    linker = Linker(*open_scene(data_path("corpus", name, "scene.toml"), mapping="surface"))
    return Setting(linker, ScenePrograms.of(linker), FRAMES)


@dataclass(frozen=True)
class Drawn:
    """Images (h, w, 4) of all frames in levels of 0-255, and what the original covers."""

    truth: list[Image]
    images: list[Image]
    covered: list[NDArray[np.bool_]]

    def apart(self, frame: int) -> Image:
        """How many levels each pixel is off, in the worst channel; 0 where nothing is covered."""
        apart: Image = np.abs(self.images[frame] - self.truth[frame]).max(axis=-1)
        return np.where(self.covered[frame], apart, 0)

    def rmse(self, frame: int, shift: tuple[int, int] = (0, 0)) -> float:
        """Over the pixels well inside of the objects, with the image shifted."""
        moved = np.roll(self.images[frame], shift, (0, 1)) - self.truth[frame]
        return float(np.sqrt(np.mean(moved[self.inside(frame)].astype(float) ** 2)) / 255.0)

    def inside(self, frame: int, margin: int = 4) -> NDArray[np.bool_]:
        """The covered pixels that have covered ones around."""
        inner = self.covered[frame]
        for axis in (0, 1):
            inner = np.logical_and.reduce(
                [np.roll(inner, step, axis) for step in range(-margin, margin + 1)]
            )
        return inner


def drawn(gpu: Gpu, setting: Setting, name: str, which: int = 0) -> Drawn:
    """What the first peer of a name shows."""
    with RenderScene(gpu, setting.linker.scene, (SIZE, SIZE)) as world:
        original = OriginalSubject("original", *setting.programs.originals)
        [peer] = PEERS[name](setting)[which : which + 1]
        subjects: Sequence[OriginalSubject] = (original, peer)
        pictures: list[list[Image]] = [[], []]
        for subject in subjects:
            subject.prepare(world)
        with CoverageRunner(world, *setting.programs.originals) as cover:
            covered = [cover.coverage(frame) for frame in range(FRAMES)]
        for frame in range(FRAMES):
            for subject, kept in zip(subjects, pictures, strict=True):
                subject.draw(frame)
                kept.append(world.targets.pixels().astype(np.int16))
        for subject in subjects:
            subject.release()
        assert world.programs.used == 0, "a program was not given back"
    return Drawn(*pictures, covered)
