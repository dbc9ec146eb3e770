"""Buffers, volumes and arrays of samplers of a scene, and the laws for shaders with them."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from shadercache.compiler import analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.scene.description import load_scene
from shadercache.source import Source
from shadercache.verify.verifier import Verifier

CAN = Path(__file__).resolve().parent.parent.parent / "corpus" / "trashcan" / "can.npz"
VERTEX = """#version 430
in vec3 a_position;
layout(std430, binding = 0) readonly buffer Heights { float height[]; };
uniform mat4 u_mvp;
out vec3 v_p;
void main() {
    v_p = a_position;
    gl_Position = u_mvp * vec4(a_position + vec3(0.0, height[2], 0.0), 1.0);
}
"""
FRAGMENT = """#version 430
in vec3 v_p;
out vec4 color;
struct Light { vec4 at; vec4 color; };
layout(std430, binding = 2) readonly buffer Lights { Light light[]; } lights;
uniform sampler3D u_volume;
uniform sampler2D u_maps[3];
uniform sampler2DArray u_layers;
vec3 lit(vec3 p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lights.light.length(); i++) {
        sum += lights.light[i].color.rgb * exp(-distance(p, lights.light[i].at.xyz));
    }
    return sum;
}
vec3 seen(vec3 p) {
    vec3 at = 0.5 + 0.4 * p;
    vec3 flat_ = textureLod(u_maps[0], at.xy, 0.0).rgb + textureLod(u_maps[2], at.yz, 0.0).rgb;
    vec3 layer = textureLod(u_layers, vec3(at.xy, 1.0), 0.0).rgb;
    return flat_ * textureLod(u_volume, at, 0.0).rgb + layer;
}
void main() { color = vec4(0.3 * lit(v_p) + 0.3 * seen(v_p), 1.0); }
"""
SCENE = """
name = "buffers"
fragment = "f.frag"
vertex = "v.vert"
mesh = "can.npz"
[attributes]
a_position = "position"
[motion]
degrees_per_frame = 2.0
[camera]
eye = [0.0, 0.62, 3.1]
target = [0.0, -0.04, 0.0]
fov_degrees = 36.0
near = 1.0
far = 10.0
[uniforms]
u_mvp = "model-view-projection"
[buffers]
Heights = { table = "data.npz", array = "heights" }
Lights = { table = "data.npz", array = "lights" }
[textures.u_volume]
file = "volume.npz"
[textures.u_layers]
file = "layers.npz"
[textures."u_maps[0]"]
file = "a.npz"
[textures."u_maps[1]"]
file = "a.npz"
[textures."u_maps[2]"]
file = "b.npz"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A scene with one of each."""
    random = np.random.default_rng(3)
    (tmp_path / "can.npz").write_bytes(CAN.read_bytes())
    lights = random.uniform(0.0, 1.0, (4, 8)).astype(np.float32)
    np.savez(tmp_path / "data.npz", lights=lights, heights=np.float32([9.0, 9.0, 0.1]))
    for name, key, shape in (
        ("volume", "volume", (6, 5, 4, 4)),
        ("layers", "layers", (2, 8, 8, 4)),
        ("a", "pixels", (8, 8, 4)),
        ("b", "pixels", (4, 4, 4)),
    ):
        np.savez(tmp_path / f"{name}.npz", **{key: random.random(shape).astype(np.float32)})
    for name, text in {"f.frag": FRAGMENT, "v.vert": VERTEX, "scene.toml": SCENE}.items():
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.xdist_group("gl")
def test_laws_hold(folder: Path, gpu: Gpu) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    wanted = ("lit(v_p)", "seen(v_p)", "sum", "textureLod(u_volume, at, 0.0).rgb")
    nodes = [node for node in analysis.nodes if node.legal and node.text in wanted]
    assert {node.text for node in nodes} == set(wanted)
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        found = verifier.round_trip()
        assert found is not None and found.exact
        image = verifier.references.images["proof"][0]
        assert len(np.unique(image[verifier.references.covered[0]], axis=0)) > 100
        for node in nodes:
            verdict = verifier.check(node)
            assert verdict.broken == [], (node.text, verdict.reasons)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("Lights = {", "Light = {", "SC526"),
        ('array = "lights"', 'array = "light"', "SC541"),
        ('[textures."u_maps[2]"]', '[textures."u_maps[3]"]', "SC522"),
        ('file = "volume.npz"', 'file = "layers.npz"', "SC523"),
    ],
)
def test_what_is_missing_is_told(folder: Path, gpu: Gpu, old: str, new: str, code: str) -> None:
    path = folder / "scene.toml"
    path.write_text(path.read_text().replace(old, new))
    scene, analysis = analyse_scene(load_scene(path))
    with pytest.raises(InputError) as caught:
        Verifier(gpu, (scene, analysis), (32, 32))
    assert code in {problem.code for problem in caught.value.diagnostics}


@pytest.mark.parametrize(
    ("declared", "body", "told"),
    [
        ("buffer B { float b[]; };", "b[0] = 1.0;", "writes the buffer B"),
        ("buffer B { float b[]; } it;", "it.b[1] += 1.0;", "writes the buffer B"),
        ("buffer B { uint b; };", "atomicAdd(b, 1u);", "B"),
        ("coherent buffer B { float b[]; };", "float x = b[0];", "shares the memory of B"),
        (
            "layout(r32f) writeonly uniform image2D i;",
            "imageStore(i, ivec2(0), vec4(1.0));",
            "imageStore",
        ),
        (
            "layout(r32f) volatile readonly uniform image2D i;",
            "float x = imageLoad(i, ivec2(0)).x;",
            "shares the memory of i",
        ),
    ],
)
def test_what_others_may_change_is_refused(declared: str, body: str, told: str) -> None:
    head = f"#version 430\nin vec3 p;\nout vec4 o;\n{declared}\n"
    text = f"{head}void main() {{ {body} o = vec4(p, 1.0); }}"
    with pytest.raises(InputError) as caught:
        analyse(Source("f.frag", text))
    assert {problem.code for problem in caught.value.diagnostics} == {"SC413"}
    assert any(told in problem.message for problem in caught.value.diagnostics)
