"""Shaders with fewer octaves and samples: one function is another, the rest is the corpus's."""

from __future__ import annotations

import difflib
from dataclasses import replace

import pytest

from bench.peers.fewer_samples import FOLDER, LABELS, cheaper_shader, fewer_samples
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene, read_shader
from shadercache.measure.image_error import ErrorSum
from shadercache.measure.subjects import OriginalSubject
from shadercache.paths import data_path
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from shadercache.source import Source

pytestmark = pytest.mark.xdist_group("gl")


@pytest.mark.parametrize("name", LABELS)
def test_nothing_but_the_function_differs(name: str) -> None:
    changed = 0
    for path in sorted(data_path("corpus", name, "scene.toml").parent.glob("*.frag")):
        source = read_shader(path)
        cheaper = cheaper_shader(source)
        if cheaper is None:
            continue
        changed += 1
        matcher = difflib.SequenceMatcher(
            None, source.text.splitlines(), cheaper.text.splitlines(), autojunk=False
        )
        touched = [code for code in matcher.get_opcodes() if code[0] != "equal"]
        lines = max(code[2] for code in touched) - min(code[1] for code in touched)
        assert 0 < lines < 30
    assert changed


def test_every_text_has_its_shader() -> None:
    texts = {path.name.split(".")[0] for path in FOLDER.glob("*.glsl")}
    shaders = {path.stem for path in data_path("corpus").rglob("*.frag")}
    assert texts and texts <= shaders


def test_a_shader_that_has_lost_the_function_is_told() -> None:
    source = Source("somewhere/dragon.frag", "#version 330\nvoid main() {}\n")
    with pytest.raises(ValueError, match=r"dragon\.frag has no function fbm"):
        cheaper_shader(source)
    assert cheaper_shader(Source("other.frag", source.text)) is None


@pytest.mark.parametrize("name", LABELS)
def test_it_is_near_to_the_original_and_not_the_same(gpu: Gpu, name: str) -> None:
    scene = load_scene(data_path("corpus", name, "scene.toml")).small
    linker = Linker(*analyse_scene(scene))
    cheaper = fewer_samples(scene)
    assert cheaper is not None
    error = ErrorSum()
    with RenderScene(gpu, linker.scene, (64, 64)) as world:
        original = OriginalSubject("original", *linker.originals())
        images = []
        for subject in (original, cheaper):
            subject.prepare(world)
            subject.draw(3)
            images.append(world.targets.pixels())
            subject.release()
        with CoverageRunner(world, *linker.originals()) as cover:
            rmse = error.add(images[0], images[1], cover.coverage(3))
    assert 0.002 < rmse < 0.05


def test_a_scene_without_a_cheaper_shader_has_none() -> None:
    scene = load_scene(data_path("corpus", "dragon", "scene.toml"))
    assert fewer_samples(replace(scene, name="another")) is None
