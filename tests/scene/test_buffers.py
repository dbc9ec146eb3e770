"""Buffers, volumes and arrays of samplers of a scene, and the laws for shaders with them."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
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
layout(std140) uniform Lamp { vec3 at; float power; } lamps[2];
uniform sampler3D u_volume;
uniform sampler2D u_maps[3];
uniform sampler2DArray u_layers;
uniform isampler3D u_steps;
layout(rgba32f, binding = 1) readonly uniform image2D u_image;
layout(r32ui, binding = 4) readonly uniform uimage3D u_counts[2];
vec3 lit(vec3 p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lights.light.length(); i++) {
        sum += lights.light[i].color.rgb * exp(-distance(p, lights.light[i].at.xyz));
    }
    return sum;
}
vec3 stored(vec3 p) {
    ivec2 at = ivec2(4.0 + 3.9 * p.xy);
    uint counted = imageLoad(u_counts[1], ivec3(at & 3, 1)).x;
    int stepped = texelFetch(u_steps, ivec3(at & 3, 0), 0).x;
    return imageLoad(u_image, at).rgb * float(counted & 7u) * 0.1 + 0.02 * float(stepped);
}
vec3 near(vec3 p) {
    float one = exp(-lamps[0].power * distance(p, lamps[0].at));
    float other = exp(-lamps[1].power * distance(p, lamps[1].at));
    return vec3(one, other, sin(one * other * 9.0));
}
vec3 seen(vec3 p) {
    vec3 at = 0.5 + 0.4 * p;
    vec3 flat_ = textureLod(u_maps[0], at.xy, 0.0).rgb + textureLod(u_maps[2], at.yz, 0.0).rgb;
    vec3 layer = textureLod(u_layers, vec3(at.xy, 1.0), 0.0).rgb;
    return flat_ * textureLod(u_volume, at, 0.0).rgb + layer;
}
void main() {
    color = vec4(0.3 * (lit(v_p) + seen(v_p) + near(v_p)) + 0.2 * stored(v_p), 1.0);
}
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
"lamps[0].at" = [0.5, 0.5, 0.5]
"lamps[0].power" = 1.5
"lamps[1].at" = [-0.5, 0.5, 0.5]
"lamps[1].power" = 0.5
[buffers]
Heights = { table = "data.npz", array = "heights" }
Lights = { table = "data.npz", array = "lights" }
[textures.u_volume]
file = "volume.npz"
[textures.u_layers]
file = "layers.npz"
[textures.u_steps]
file = "steps.npz"
[textures.u_image]
file = "a.npz"
[textures."u_counts[0]"]
file = "counts.npz"
[textures."u_counts[1]"]
file = "counts.npz"
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
    for name, kind in (("steps", np.int32), ("counts", np.uint32)):
        np.savez(tmp_path / f"{name}.npz", volume=random.integers(0, 9, (2, 4, 4, 1), dtype=kind))
    for name, text in {"f.frag": FRAGMENT, "v.vert": VERTEX, "scene.toml": SCENE}.items():
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.xdist_group("gl")
def test_laws_hold(folder: Path, gpu: Gpu) -> None:
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    wanted = (
        *("lit(v_p)", "seen(v_p)", "near(v_p)", "stored(v_p)", "sum"),
        *("textureLod(u_volume, at, 0.0).rgb", "imageLoad(u_image, at).rgb"),
    )
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
def test_a_buffer_that_moves_the_vertices_has_a_twin(folder: Path, gpu: Gpu) -> None:
    """Without the last frame's heights next to nothing would be found again."""
    waves = 0.1 * np.sin(0.7 * np.arange(12))[:, None] * np.float32([0.0, 0.0, 1.0])
    np.savez(folder / "waves.npz", heights=waves.astype(np.float32))
    path = folder / "scene.toml"
    still = 'Heights = { table = "data.npz", array = "heights" }'
    moving = 'Heights = { table = "waves.npz", array = "heights", rate = 1.0 }'
    path.write_text(path.read_text().replace(still, moving))
    scene, analysis = analyse_scene(load_scene(path))
    assert "Heights" in analysis.moving
    [node] = [node for node in analysis.nodes if node.legal and node.text == "lit(v_p)"]
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        images = verifier.references.images["proof"]
        assert any((images[0] != image).any() for image in images[1:])
        verdict = verifier.check(node)
        assert verdict.broken == [], verdict.reasons
        blind = replace(analysis, reading=replace(analysis.reading, moving=("none",)))
    with closing(Verifier(gpu, (scene, blind), (64, 64))) as verifier:
        assert verifier.check(blind.node(node.id)).broken


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("Lights = {", "Light = {", "SC526"),
        ('array = "lights"', 'array = "light"', "SC541"),
        ('[textures."u_maps[2]"]', '[textures."u_maps[3]"]', "SC522"),
        ('file = "volume.npz"', 'file = "layers.npz"', "SC523"),
        ('file = "counts.npz"', 'file = "steps.npz"', "SC523"),
        ("[textures.u_image]", "[textures.u_picture]", "SC522"),
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
