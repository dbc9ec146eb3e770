"""The meadow: its files are what its code makes, every poppy moves, and values are found again."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.configuration import Configuration
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from tests.configured import configured

FOLDER = Path(__file__).resolve().parent.parent.parent / "corpus" / "meadow"


def test_the_generator_makes_the_files(tmp_path: Path) -> None:
    command = [sys.executable, str(FOLDER / "generate.py"), "--output", str(tmp_path)]
    subprocess.run(command, check=True)
    for path in FOLDER.glob("*.npz"):
        with np.load(path) as kept, np.load(tmp_path / path.name) as made:
            assert set(kept) == set(made)
            for name in kept:
                # Sines and powers are rounded in other ways by other processors.
                one, other = kept[name].astype(np.float64), made[name].astype(np.float64)
                assert kept[name].dtype == made[name].dtype
                assert np.allclose(one, other, rtol=0.0, atol=2.0**-10)


def test_two_thousand_move() -> None:
    scene, analysis = open_scene(FOLDER / "scene.toml")
    instances = scene.objects[0].inputs.instances
    sway = instances.streams["i_sway"].at(0) - instances.streams["i_sway"].at(1)
    assert instances.number == 2000
    assert np.abs(sway.reshape(2000, 2)).max(axis=1).min() > 0.0
    assert analysis.moving == {"i_sway"}


@pytest.mark.xdist_group("gl")
def test_values_are_found_again(gpu: Gpu) -> None:
    scene, analysis = open_scene(FOLDER / "scene.toml")
    node = next(node for node in analysis.nodes if node.id == scene.nodes["albedo"])
    linker = Linker(scene, analysis)
    linked = linker.link(linker.assign(configured(Configuration((node.id,)), period=16)))
    bundle = next(one.bundle for one in linked if one.configuration is not None)
    with (
        RenderScene(gpu, linker.scene, (256, 160)) as world,
        VariantRunner(world, *linked) as runner,
    ):
        for frame in range(3):
            runner.draw(frame)
        mask = runner.hit_mask(3)
    # Petals are thin at this size, and edges miss.
    assert (mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum() > 0.6
