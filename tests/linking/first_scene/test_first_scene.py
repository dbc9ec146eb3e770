"""The scene file that is written for a model and a pair of shaders: guesses, pictures, laws."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from shadercache.compiler import analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.first_scene.framing import Up
from shadercache.linking.first_scene.scene_text import FirstScene, Sources, first_scene
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene, read_shader
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.models.load import load_model
from shadercache.verify.verifier import Verifier
from tests.conftest import Golden
from tests.gltf_maker import Maker, arms, quad, sheet, tower

pytestmark = pytest.mark.xdist_group("gl")

HERE = Path(__file__).parent
MODELS: dict[str, tuple[Callable[[], Maker], str, str]] = {
    "tower": (tower, "plain", "skinned"),
    "sheet": (sheet, "plain", "morphed"),
    "arms": (arms, "three", "three"),
    "still": (quad, "plain", "plain"),
}


def copied(name: str, folder: Path) -> Path:
    """A copy of a shader."""
    path = folder / name
    path.write_text((HERE / name).read_text(encoding="utf-8"), encoding="utf-8")
    return path


def written(model: Path, fragment: Path, vertex: Path, up: Up = "y") -> FirstScene:
    """The scene file of a model in its folder."""
    analysis = analyse(read_shader(fragment), read_shader(vertex), mapping="surface")
    folder, sources = model.parent, Sources(load_model(model), fragment, vertex, up)
    scene = first_scene(sources, analysis, folder, folder)
    (folder / "scene.toml").write_text(scene.text, encoding="utf-8")
    return scene


def made(name: str, folder: Path) -> FirstScene:
    maker, fragment, vertex = MODELS[name]
    model = maker().glb(folder / f"{name}.glb")
    return written(model, copied(f"{fragment}.frag", folder), copied(f"{vertex}.vert", folder))


def changed(folder: Path, old: str, new: str, name: str = "tower") -> FirstScene:
    """The scene of a model whose vertex shader has one piece of text replaced."""
    maker, fragment, vertex = MODELS[name]
    path = copied(f"{vertex}.vert", folder)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    model = maker().glb(folder / f"{name}.glb")
    return written(model, copied(f"{fragment}.frag", folder), path)


@pytest.mark.parametrize("name", MODELS)
def test_all_is_guessed_from_names_and_types(name: str, tmp_path: Path, golden: Golden) -> None:
    found = made(name, tmp_path)
    golden(f"tests/linking/first_scene/goldens/{name}.txt", found.text)
    scene = load_scene(tmp_path)
    assert len(scene.parts) == found.objects
    assert found.unknown == {"arms": ("map",)}.get(name, ("uWarp",))


@pytest.mark.parametrize("name", MODELS)
def test_the_model_is_in_the_picture(name: str, tmp_path: Path, gpu: Gpu) -> None:
    made(name, tmp_path)
    scene, analysis = open_scene(tmp_path / "scene.toml")
    linker = Linker(scene, analysis)
    with RenderScene(gpu, linker.scene, (64, 64)) as world:
        images = render_original(world, linker.originals(), range(0, 64, 9))
    covered = [image[..., 3] > 0.5 for image in images]
    # Sheets are seen from behind or edgewise in some frames.
    assert 0.05 < max(mask.mean() for mask in covered) < 0.9
    for mask in covered:
        edge = np.concatenate([mask[0], mask[-1], mask[:, 0], mask[:, -1]])
        assert not edge.any(), "all of it, whichever way it is turned and bent"
    assert not np.array_equal(images[0], images[1]), "it moves"


@pytest.mark.parametrize("name", ["tower", "sheet", "arms"])
def test_the_laws_hold(name: str, tmp_path: Path, gpu: Gpu) -> None:
    made(name, tmp_path)
    scene, analysis = open_scene(tmp_path / "scene.toml")
    offered = [node for node in analysis.nodes if node.offered]
    called = [node for node in offered if node.text.startswith(("waves(", "grain("))]
    with closing(Verifier(gpu, (scene, analysis), size=(64, 64))) as verifier:
        law1 = verifier.round_trip()
        assert law1 is None or law1.exact
        for node in (called[0], offered[-1]):
            verdict = verifier.check(node, plain=False)
            assert not verdict.broken and verdict.algorithms, verdict


def test_shaders_that_name_nothing_as_usual(tmp_path: Path) -> None:
    text = changed(tmp_path, "inPosition", "inThing").text
    assert 'inThing = "position"  # vec3; its name says nothing, and its type fits' in text
    still = changed(tmp_path, "uMVP", "uTransform", "still").text
    assert 'uTransform = "model-view-projection"  # mat4 (guess)' in still


def test_what_is_up_stays_up(tmp_path: Path) -> None:
    shaders = copied("plain.frag", tmp_path), copied("skinned.vert", tmp_path)
    model = tower().glb(tmp_path / "t.glb")
    for up, axis in (("y", (0, 1, 0)), ("z", (0, 0, 1))):
        written(model, *shaders, up)
        scene = load_scene(tmp_path)
        camera, motion = scene.view.camera, scene.common.motion
        assert camera.up == motion.axis == axis
        assert camera.target == motion.pivot == pytest.approx((-0.331444, 1.02188, 0.0))
        away = np.subtract(camera.eye, camera.target)
        assert np.argmax(np.abs(away)) == {"y": 2, "z": 1}[up] and away @ axis > 0


def test_names_from_one(tmp_path: Path) -> None:
    path = tmp_path / "morphed.vert"
    text = (HERE / "morphed.vert").read_text()
    text = text.replace("morphTarget1", "morphTarget2").replace("morphTarget0", "morphTarget1")
    path.write_text(text)
    scene = written(sheet().glb(tmp_path / "s.glb"), copied("plain.frag", tmp_path), path)
    assert 'morphTarget1 = "morph0_position"' in scene.text
    assert 'morphTarget2 = "morph1_position"' in scene.text


@pytest.mark.parametrize(
    ("old", "new", "code", "words"),
    [
        ("inNormal", "inUv", "SC521", "the attribute inUv (vec3), which looks like uv"),
        ("boneMatrices[32]", "boneMatrices[1]", "SC523", "boneMatrices has 1 matrices"),
        ("uniform mat4 world;", "uniform mat4 world; uniform sampler1D uRamp;", "SC524",
         "uRamp (sampler1D)"),
    ],
)  # fmt: skip
def test_what_cannot_be_given(tmp_path: Path, old: str, new: str, code: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        changed(tmp_path, old, new)
    [problem] = caught.value.diagnostics
    assert problem.code == code and words in problem.message
    if code == "SC521":
        assert problem.hint == (
            "the model has: position (vec3), normal (vec3), joints (vec4), weights (vec4)"
        )


def test_too_few_bones_are_told_where_they_are_drawn(tmp_path: Path, gpu: Gpu) -> None:
    made("tower", tmp_path)
    shader = tmp_path / "skinned.vert"
    shader.write_text(shader.read_text().replace("[32]", "[1]"))
    scene, analysis = open_scene(tmp_path / "scene.toml")
    linker = Linker(scene, analysis)
    with (
        RenderScene(gpu, linker.scene, (16, 16)) as world,
        pytest.raises(InputError, match="boneMatrices has 1 matrices, and 'Tower' has 2 bones"),
    ):
        render_original(world, linker.originals(), range(1))


def test_models_of_many_parts_are_one_mesh(tmp_path: Path) -> None:
    maker = quad()
    for number in range(70):
        maker.add("nodes", mesh=0, translation=[number, 0, 0])
    maker.document["scenes"] = [{"nodes": list(range(71))}]
    model = maker.glb(tmp_path / "m.glb")
    plain = copied("plain.frag", tmp_path), copied("plain.vert", tmp_path)
    scene = written(model, *plain)
    assert scene.objects == 1 and "71 parts" in scene.text and "[[objects]]" not in scene.text
    loaded: Scene = load_scene(tmp_path)
    assert loaded.common.part is None


def test_what_a_struct_and_a_block_hold(tmp_path: Path) -> None:
    declared = "struct Lamp { vec3 position; vec3 color; float reach; };\nuniform Lamp uLamp;\n"
    declared += "layout(std140) uniform Camera { mat4 view; vec3 eyePosition; } uCamera;\n"
    declared += "uniform float uTime;\nuniform vec2 uResolution;\nuniform mat4 inverseView;\n"
    text = changed(tmp_path, "out vec3 vPos;", declared + "out vec3 vPos;", "still").text
    for line in (
        '"uCamera.view" = "view"',
        '"uCamera.eyePosition" = "eye"',
        '"uLamp.color" = [1.0, 1.0, 1.0]',
        'uTime = "time"',
        'uResolution = "resolution"',
        'inverseView = "inverse-view"',
    ):
        assert f"\n{line}" in text, text


def test_pictures_are_files(tmp_path: Path) -> None:
    model = quad("JPEG").glb(tmp_path / "q.glb")
    shaders = copied("three.frag", tmp_path), copied("three.vert", tmp_path)
    text = written(model, *shaders).text
    assert '# (guess) albedo of the material.\nfile = "textures/image0.png"' in text
    assert (tmp_path / "textures" / "image0.png").is_file()
    broken = quad()
    view = broken.document["images"][0]["bufferView"]
    broken.document["bufferViews"][view]["byteLength"] = 20
    with pytest.raises(InputError, match="SC530"):
        written(broken.glb(tmp_path / "r.glb"), *shaders)
