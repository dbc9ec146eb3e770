"""Variants of scenes as they are handed over, and what the harness draws of them."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from shadercache.caching.configuration import Assignment, Configuration, PayloadRate
from shadercache.caching.settings import with_settings
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.report.hand_over.expected import Expected
from shadercache.report.hand_over.handed_files import hand_over

SIZE, FRAMES = (64, 48), 6
EXPECTED = Expected(
    speedup=2.034,
    low=1.98,
    high=2.081,
    metric="RMSE",
    mean=0.00312,
    worst=0.0042,
    bound=0.005,
    size=SIZE,
    frames=64,
    renderer="a renderer",
)


@dataclass(frozen=True)
class Choice:
    """What was chosen of a scene (a name of the corpus, or a path): a node by its name, its id or
    its number among those offered."""

    scene: str | Path
    node: str | int
    algorithm: str
    period: int = 4
    rate: PayloadRate = "full"
    settings: tuple[str, ...] = ()
    dialect: str | None = None

    @property
    def path(self) -> Path:
        return self.scene if isinstance(self.scene, Path) else data_path("corpus", self.scene)


FULL_SCREEN = Path(__file__).parents[2] / "laws" / "full_screen"
OUTPUTS = Path(__file__).parents[2] / "laws" / "outputs" / "scene.toml"
NOISE = "whole noise"

CHOICES = {
    "dragon, one pass": Choice("dragon", NOISE, "1-pass"),
    "dragon, two passes": Choice("dragon", NOISE, "2-pass"),
    "dragon, parked": Choice("dragon", NOISE, "parked"),
    "dragon, half the rate": Choice("dragon", NOISE, "3-pass", rate="half"),
    "trashcan, three passes": Choice("trashcan", "24 of 25 samples", "3-pass"),
    "trashcan, two textures": Choice(
        *("trashcan", "24 of 25 samples", "2-pass"),
        settings=("viewport=on", "ids=on", "mask=on", "tolerance=akeley-su", "age=on"),
    ),
    "a Shadertoy": Choice(FULL_SCREEN / "clouds.frag", 1, "2-pass", dialect="shadertoy"),
    "several outputs": Choice(OUTPUTS, 0, "2-pass"),
    "heroine": Choice("heroine", "surface", "2-pass"),
    "colonnade, parked": Choice("colonnade", "marble", "parked"),
    "chess, a period of its own": Choice("chess", "static share", "2-pass", period=8),
    "meadow, instances": Choice("meadow", "albedo", "2-pass", settings=("ids=on",)),
}


@dataclass(frozen=True)
class Handed:
    """A choice, and its files."""

    linker: Linker
    assignment: Assignment
    files: Mapping[str, bytes]

    def text(self, name: str) -> str:
        return self.files[name].decode()


def chosen(choice: Choice) -> tuple[Linker, Assignment]:
    """The choice as a tuner makes it, with small meshes."""
    path = choice.path / "scene.toml" if choice.path.is_dir() else choice.path
    reading = ReadOptions(dialect=choice.dialect) if choice.dialect else None
    scene, analysis = open_scene(path, reading)
    linker = Linker(scene.small, analysis)
    offered = [node.id for node in analysis.nodes if node.offered]
    node = offered[choice.node] if isinstance(choice.node, int) else choice.node
    nodes = tuple(found.id for found in analysis.nodes_of(scene.nodes.get(node, node)))
    base = replace(
        Configuration(), nodes=nodes, algorithm=choice.algorithm, payload_rate=choice.rate
    )
    configuration = with_settings(base.with_refresh(choice.period, 4), choice.settings)
    return linker, linker.assign(configuration)


def handed(choice: Choice, expected: Expected | None = EXPECTED) -> Handed:
    linker, assignment = chosen(choice)
    files = hand_over(linker, assignment, expected, frames=FRAMES)
    return Handed(linker, assignment, files)


def written(handed: Handed, folder: Path) -> Path:
    """The folder with the files in it."""
    for name, data in handed.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return folder


def example_pictures(folder: Path) -> tuple[str, NDArray[np.uint8], NDArray[np.uint8]]:
    """What the example prints, and its pictures: by the variant, and by the original."""
    # -I: nothing of this folder or of the environment's paths is imported.
    command = [sys.executable, "-I", str(folder / "example.py")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    both = np.asarray(Image.open(folder / "example.png"))
    assert both.shape == (SIZE[1], 2 * SIZE[0], 3)
    return done.stdout, both[:, : SIZE[0]], both[:, SIZE[0] :]


def drawn_by_harness(gpu: Gpu, handed: Handed) -> NDArray[np.uint8]:
    """The same frame by the harness, row 0 at the top."""
    objects = handed.linker.link(handed.assignment)
    with (
        RenderScene(gpu, handed.linker.scene, SIZE) as world,
        VariantRunner(world, *objects) as run,
    ):
        for frame in range(FRAMES):
            run.draw(frame)
        shown = np.asarray(world.targets.shown())[::-1, :, :3]
    assert shown.dtype == np.uint8
    return shown
