"""Instances in a scene file: what is read, drawn and refused."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.algorithms import NAMES
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from shadercache.scene.instances import Stream
from shadercache.verify.laws import judge
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.configured import PROOF, configured, rewritten, variant

VERTEX = """#version 330
in vec3 a_position;
in vec3 i_offset;
in mat4 i_turn;
uniform mat4 u_mvp;
out vec3 v_p;
void main() {
    v_p = a_position;
    gl_Position = u_mvp * (i_turn * vec4(a_position, 1.0) + vec4(i_offset, 0.0));
}
"""
FRAGMENT = """#version 330
in vec3 v_p;
out vec4 color;
float noise(vec3 p) { return sin(9.0 * p.x) * cos(7.0 * p.y + sin(5.0 * p.z)); }
void main() { color = vec4(vec3(0.5 + 0.5 * noise(v_p)), 1.0); }
"""
SCENE = """
name = "instances"
fragment = "f.frag"
vertex = "v.vert"
mesh = "mesh.npz"
[attributes]
a_position = "position"
[camera]
eye = [0.0, 0.0, 6.0]
target = [0.0, 0.0, 0.0]
fov_degrees = 40.0
near = 1.0
far = 10.0
[uniforms]
u_mvp = "model-view-projection"
[instances]
i_offset = { table = "field.npz", array = "offset" }
i_turn = { table = "field.npz", array = "turn" }
"""
FRAMES, COUNT = 8, 5


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Five tetrahedra side by side, each turning on the spot."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], np.float32) * 0.35
    index = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], np.uint16)
    np.savez(tmp_path / "mesh.npz", position=corners, index=index)
    offset = np.column_stack([np.linspace(-1.6, 1.6, COUNT), np.zeros((COUNT, 2))])
    angle = 0.05 * np.arange(FRAMES)[:, None] + np.arange(COUNT)
    turn = np.zeros((FRAMES, COUNT, 4, 4))
    turn[..., 0, 0], turn[..., 0, 2] = np.cos(angle), -np.sin(angle)
    turn[..., 2, 0], turn[..., 2, 2] = np.sin(angle), np.cos(angle)
    turn[..., 1, 1] = turn[..., 3, 3] = 1.0
    np.savez(tmp_path / "field.npz", offset=offset, turn=turn.reshape(FRAMES, COUNT, 16))
    for name, text in {"f.frag": FRAGMENT, "v.vert": VERTEX, "scene.toml": SCENE}.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def test_numbers_are_mixed_between_frames(folder: Path) -> None:
    stream = Stream(folder / "field.npz", "turn", 0.5)
    assert (stream.shape, stream.moves) == ((COUNT, 16), True)
    mean = 0.5 * (stream.at(0) + stream.at(2))
    assert np.array_equal(stream.at(1), mean)
    assert np.array_equal(stream.at(2 * FRAMES), stream.at(0))


def test_only_what_moves_has_a_twin(folder: Path) -> None:
    _, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    assert analysis.moving == {"i_turn"}
    own = altered(load_scene(folder / "scene.toml"), own_shader=True, moving=("nothing",))
    assert analyse_scene(own.alone(own.common))[1].moving == {"i_turn"}


@pytest.mark.xdist_group("gl")
def test_laws_hold_where_instances_move(folder: Path, gpu: Gpu) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    with closing(Verifier(gpu, (scene, analysis), (96, 48))) as verifier:
        for node in (node for node in analysis.nodes if node.legal):
            verdict = verifier.check(node)
            assert verdict.broken == [], (node.text, verdict.reasons)


@pytest.mark.xdist_group("gl")
def test_laws_hold_where_instances_are_told_apart(folder: Path, gpu: Gpu) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    node = next(node for node in analysis.nodes if node.text == "noise(v_p)")
    told = configured(ids=True)
    with closing(Verifier(gpu, (scene, analysis), (96, 48), configuration=told)) as verifier:
        verdict = verifier.check(node)
        seen = verifier.references.surfaces.frame(1).number
    assert verdict.broken == [], verdict.reasons
    assert set(np.unique(seen)) == set(range(COUNT + 1)), "each has a number"
    emission = rewritten(analysis, node, told, algorithms=NAMES, unprofitable=True)
    uniforms = {uniform.role: uniform.name for uniform in emission.manifest.uniforms}
    assert uniforms["object"] == "sc_first_object"
    assert "sc_object = sc_first_object + gl_InstanceID;" in emission.files["2-pass.miss.vert"]
    (refused,) = emission.manifest.refused
    assert refused.algorithm == "parked"


@pytest.mark.xdist_group("gl")
def test_values_are_found_on_every_instance(folder: Path, gpu: Gpu) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    node = next(node for node in analysis.nodes if node.text == "noise(v_p)")
    emission = rewritten(analysis, node, PROOF, unprofitable=True)
    bundle = Bundle(emission.manifest, emission.files)
    with (
        RenderScene(gpu, Linker(scene, analysis).scene, (192, 48), "rgba32f") as world,
        variant(world, bundle, "2-pass", period=64) as runner,
    ):
        runner.draw(0)
        mask = runner.hit_mask(1)
        image = runner.image(1)
    # A part of the picture for each: they stand side by side.
    (columns,) = np.nonzero((mask > 0).any(axis=0))
    parts = np.array_split(mask[:, columns[0] : columns[-1] + 1], COUNT, axis=1)
    shares = [(part == bundle.mask_values["hit"]).sum() / (part > 0).sum() for part in parts]
    assert min(shares) > 0.5
    assert image.any()


@pytest.mark.xdist_group("gl")
def test_a_twin_that_gets_this_frame_is_noticed(folder: Path, gpu: Gpu) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    node = next(node for node in analysis.nodes if node.text == "noise(v_p)")
    emission = rewritten(analysis, node, PROOF, unprofitable=True)
    declared = "in mat4 sc_previous_i_turn;"
    files = {name: _with_this_frame(text, declared) for name, text in emission.files.items()}
    assert files != emission.files
    verdict = Verdict("", "", "", True)
    with closing(Verifier(gpu, (scene, analysis), (96, 48))) as verifier:
        judge(verifier.references, Bundle(emission.manifest, files), verdict)
    assert "law 4 (2-pass)" in verdict.broken


def _with_this_frame(text: str, declared: str) -> str:
    head, found, rest = text.partition(declared)
    return head + found + rest.replace("sc_previous_i_turn", "i_turn")


@pytest.mark.xdist_group("gl")
def test_an_attribute_of_another_width_is_an_error(folder: Path, gpu: Gpu) -> None:
    path = folder / "scene.toml"
    path.write_text(path.read_text().replace('array = "offset"', 'array = "turn"'))
    scene, analysis = analyse_scene(load_scene(path))
    with pytest.raises(InputError, match="has 3 numbers in i_offset, the instances 16"):
        Verifier(gpu, (scene, analysis), (96, 48))


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('array = "turn" }', 'array = "turns" }', "SC541"),
        ('array = "offset" }', 'array = "few" }', "SC541"),
        ('i_offset = { table = "field.npz", array = "offset" }', "i_offset = 3", "SC505"),
        ("[instances]", "[instances]\ncount = 4", "SC541"),
        ("[instances]", "[instances]\ncount = 0", "SC505"),
        ('array = "offset" }', 'array = "flat" }', "SC541"),
        ('array = "offset" }', 'array = "bad" }', "SC541"),
        ('array = "offset" }', 'array = "offset", speed = 2 }', "SC504"),
    ],
)
def test_mistakes(folder: Path, old: str, new: str, code: str) -> None:
    arrays = dict(np.load(folder / "field.npz"))
    bad = arrays["offset"].copy()
    bad[1, 1] = np.nan
    np.savez(folder / "field.npz", few=np.zeros((3, 3)), flat=np.zeros(5), bad=bad, **arrays)
    path = folder / "scene.toml"
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(InputError) as caught:
        assert load_scene(path).common.inputs.instances.number
    assert {problem.code for problem in caught.value.diagnostics} == {code}


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("ids", [True, False])
def test_no_hit_comes_from_another_instance(folder: Path, gpu: Gpu, ids: bool) -> None:
    """Law 5: the payload says which instance a texel holds."""
    # They stand so close that they pass through one another.
    arrays = dict(np.load(folder / "field.npz"))
    arrays["offset"] = arrays["offset"] * 0.15
    np.savez(folder / "field.npz", **arrays)
    (folder / "v.vert").write_text(
        VERTEX.replace("out vec3 v_p;", "out vec3 v_p; flat out float v_of;").replace(
            "v_p = a_position;", "v_p = a_position; v_of = float(gl_InstanceID);"
        )
    )
    (folder / "f.frag").write_text(
        "#version 330\nin vec3 v_p; flat in float v_of; out vec4 color;\n"
        "float of(vec3 p, float number) { return number + 0.0 * p.x; }\n"
        "void main() { color = vec4(vec3(of(v_p, v_of)), 1.0); }\n"
    )
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    node = next(node for node in analysis.nodes if node.text == "of(v_p, v_of)")
    told = configured(ids=ids, form="rgba32f", filter="nearest")
    emission = rewritten(analysis, node, told, unprofitable=True)
    bundle = Bundle(emission.manifest, emission.files)
    wrong = hits = 0
    with (
        RenderScene(gpu, Linker(scene, analysis).scene, (192, 96), "rgba32f") as world,
        variant(world, bundle, "2-pass", period=64, ids=ids) as runner,
    ):
        for frame in range(6):
            hit = runner.hit_mask(frame) == bundle.mask_values["hit"]
            image = runner.image(frame)
            with OriginalRunner(world, bundle) as original:
                truth = original.image(frame)
            hits += int(hit.sum())
            wrong += int((image != truth).any(axis=-1)[hit].sum())
    assert hits > 1000
    if ids:
        assert wrong == 0
    else:
        assert wrong > 0, "a test that cannot fail is none"
