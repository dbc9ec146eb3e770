"""Textures that change from frame to frame and move vertices: bones of a figure, here of a rod."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle
from shadercache.scene.description import load_scene
from shadercache.verify.laws import judge
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, rewritten

VERTEX = """#version 330
in vec3 position;
in float bone;
uniform sampler2D u_rig;
uniform mat4 u_mvp;
out vec3 v_p;
mat4 posed(int number) {
    mat4 pose;
    for (int column = 0; column < 4; column++) {
        pose[column] = texelFetch(u_rig, ivec2(column, number), 0);
    }
    return pose;
}
void main() {
    v_p = position;
    gl_Position = u_mvp * posed(int(bone)) * vec4(position, 1.0);
}
"""
FRAGMENT = """#version 330
in vec3 v_p;
out vec4 color;
float noise(vec3 p) { return sin(9.0 * p.x) * cos(7.0 * p.y + sin(5.0 * p.z)); }
void main() { color = vec4(vec3(0.5 + 0.5 * noise(v_p)), 1.0); }
"""
SCENE = """
name = "rig"
fragment = "f.frag"
vertex = "v.vert"
mesh = "rod.npz"
[attributes]
position = "position"
bone = "bone"
[camera]
eye = [0.0, 0.0, 5.0]
target = [0.0, 0.0, 0.0]
fov_degrees = 40.0
near = 1.0
far = 10.0
[uniforms]
u_mvp = "model-view-projection"
[textures.u_rig]
table = "poses.npz"
array = "poses"
rate = 0.75
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A rod of two halves; the upper one swings."""
    rows = np.linspace(-1.0, 1.0, 9)
    points = np.array([(x, y, 0.0) for y in rows for x in (-0.4, 0.4)])
    quad = np.array([(0, 1, 2), (1, 3, 2)])
    faces = np.concatenate([2 * row + quad for row in range(8)])
    bone = (points[:, 1] > 0.0).astype(np.float32)
    mesh = {"position": points.astype(np.float32), "bone": bone, "index": faces.astype(np.uint16)}
    np.savez(tmp_path / "rod.npz", **mesh)
    angle = 0.3 * np.sin(2.0 * np.pi * np.arange(16) / 16.0)
    poses = np.tile(np.eye(4), (16, 2, 1, 1))
    poses[:, 1, 0, 0] = poses[:, 1, 1, 1] = np.cos(angle)
    poses[:, 1, 0, 1], poses[:, 1, 1, 0] = np.sin(angle), -np.sin(angle)
    np.savez(tmp_path / "poses.npz", poses=poses.astype(np.float32))
    for name, text in {"f.frag": FRAGMENT, "v.vert": VERTEX, "scene.toml": SCENE}.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def test_it_moves_though_its_name_does_not_say_so(folder: Path) -> None:
    assert analyse_scene(load_scene(folder / "scene.toml"))[1].moving == {"u_rig"}


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("wrong", [False, True])
def test_laws(folder: Path, gpu: Gpu, wrong: bool) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    node = next(node for node in analysis.nodes if node.text == "noise(v_p)")
    emission = rewritten(analysis, node, PROOF, unprofitable=True)
    files = dict(emission.files)
    if wrong:
        files = {
            name: text.replace("texelFetch(sc_previous_u_rig", "texelFetch(u_rig")
            for name, text in files.items()
        }
        assert files != emission.files
    verdict = Verdict("", "", "", True)
    with closing(Verifier(gpu, (scene, analysis), (96, 96))) as verifier:
        images = verifier.references.images["proof"]
        assert (images[0] != images[2]).any()
        judge(verifier.references, Bundle(emission.manifest, files), verdict)
    assert ("law 4 (2-pass)" in verdict.broken) == wrong, verdict.reasons
    assert bool(verdict.broken) == wrong


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('array = "poses"', 'array = "pose"', "SC541"),
        ('table = "poses.npz"', 'table = "pose.npz"', "SC507"),
        ("rate = 0.75", 'rate = 0.75\nfilter = "linear"', "SC504"),
    ],
)
def test_mistakes(folder: Path, old: str, new: str, code: str) -> None:
    path = folder / "scene.toml"
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(InputError) as caught:
        analyse_scene(load_scene(path))
    assert {problem.code for problem in caught.value.diagnostics} == {code}
