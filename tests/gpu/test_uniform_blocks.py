"""Uniform blocks are filled as std140 lays them out, their twins with the last frame's values."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from manifests import reflected

from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.gpu.programs import Program, Programs
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from shadercache.source import Source
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, rewritten, variant

pytestmark = pytest.mark.xdist_group("gl")

STRUCTS = "struct Inner { vec2 a; mat2 m; }; struct Lamp { vec3 place; float power; Inner inner; };"

MEMBERS = {
    "one": "float",
    "three": "vec3",
    "after": "float",
    "whole": "ivec2",
    "flag": "bool",
    "sign": "uint",
    "turn": "mat3",
    "wide": "mat2x4",
    "tall": "mat4x2",
    "row": "float[3]",
    "spots": "vec2[2]",
    "turns": "mat2[2]",
    "lamp": "Lamp",
    "lamps": "Lamp[2]",
    "grid": "vec3[2][3]",
    "last": "vec4",
}

PARTS = {
    "float": ["{}"],
    "vec3": ["{}.x", "{}.y", "{}.z"],
    "ivec2": ["float({}.x)", "float({}.y)"],
    "bool": ["float({})"],
    "uint": ["float({})"],
    "mat3": [f"{{}}[{c}][{r}]" for c in range(3) for r in range(3)],
    "mat2x4": [f"{{}}[{c}][{r}]" for c in range(2) for r in range(4)],
    "mat4x2": [f"{{}}[{c}][{r}]" for c in range(4) for r in range(2)],
    "float[3]": [f"{{}}[{i}]" for i in range(3)],
    "vec2[2]": [f"{{}}[{i}].{x}" for i in range(2) for x in "xy"],
    "mat2[2]": [f"{{}}[{i}][{c}][{r}]" for i in range(2) for c in range(2) for r in range(2)],
    "vec3[2][3]": [f"{{}}[{i}][{j}].{x}" for i in range(2) for j in range(3) for x in "xyz"],
    "vec4": ["{}.x", "{}.y", "{}.z", "{}.w"],
}
LAMP = ["place.x", "place.z", "power", "inner.a.y", "inner.m[0][1]", "inner.m[1][0]"]
PARTS["Lamp"] = [f"{{}}.{part}" for part in LAMP]
PARTS["Lamp[2]"] = [f"{{}}[{i}].{part}" for i in range(2) for part in LAMP]

HEAD = "#version 430\n" + STRUCTS
VERTEX = "in vec2 a_corner; void main() { gl_Position = vec4(a_corner, 0.0, 1.0); }"


CASES = 64
"""Of one ``switch``, which Mesa makes a chain of conditions of. Where more than some 80 conditions
are nested, llvmpipe 25.0 (not 22.3) writes past the end of its stack of them and crashes::

    uniform float u; out float o;
    void main() {
        if (u > 0.0) { o += sin(o); if (u > 1.0) { o += sin(o); ... } }  // 84 of them
    }
"""


def acquired(programs: Programs, vertex: str, fragment: str) -> Program:
    """The program of two texts, with the blocks that a manifest would tell of."""
    sources = Source("t.vert", vertex), Source("t.frag", fragment)
    return programs.acquire(*sources, reflected(*sources))


def numbers(gpu: Gpu, declarations: str, prefix: str) -> tuple[list[str], np.ndarray]:
    """What programs read of their uniforms: their names, and every number as the shader has it."""
    read = [part.format(prefix + name) for name, kind in MEMBERS.items() for part in PARTS[kind]]
    names: set[str] = set()
    found = []
    for at in range(0, len(read), CASES):
        names_here, values = _drawn(gpu, declarations, prefix, read[at : at + CASES])
        names |= names_here
        found.append(values)
    return sorted(names), np.concatenate(found)


def _drawn(
    gpu: Gpu, declarations: str, prefix: str, read: list[str]
) -> tuple[set[str], np.ndarray]:
    cases = "".join(f"case {at}: o = {text}; break; " for at, text in enumerate(read))
    fragment = f"""{HEAD} {declarations} out float o;
        void main() {{ o = -1.0; switch (int(gl_FragCoord.x)) {{ {cases} }} }}"""
    programs = Programs(gpu)
    program = acquired(programs, HEAD + VERTEX, fragment)
    for uniform in program.uniforms.values():
        # Equal names, equal numbers; different ones for each number.
        seed = sum(map(ord, uniform.name.removeprefix(prefix)))
        values = np.random.default_rng(seed).integers(1, 100, uniform.count)
        uniform.write(uniform.encode(values.astype(np.float64), "the test"))
    program.bind_blocks()
    corners = gpu.ctx.buffer(np.array([-1, -1, 3, -1, -1, 3], np.float32).tobytes())
    array = gpu.ctx.simple_vertex_array(program.gl, corners, "a_corner")
    target = gpu.ctx.texture((len(read), 1), 1, dtype="f4")
    framebuffer = gpu.ctx.framebuffer([target])
    framebuffer.use()
    gpu.ctx.enable_only(0)
    array.render()
    found = np.frombuffer(target.read(), np.float32)
    for item in (array, corners, framebuffer, target):
        item.release()
    names = {name.removeprefix(prefix) for name in program.uniforms}
    programs.release_all()
    return names, found


@pytest.mark.parametrize("instance", ["", "block"])
@pytest.mark.parametrize("layout", ["layout(std140) ", "layout(std140) uniform; "])
def test_every_number_is_where_the_shader_reads_it(gpu: Gpu, layout: str, instance: str) -> None:
    plain = "".join(f"uniform {kind} {name};" for name, kind in MEMBERS.items())
    members = "".join(f"{kind} {name};" for name, kind in MEMBERS.items())
    names, wanted = numbers(gpu, plain, "")
    block = f"{layout}uniform Block {{ {members} }} {instance};"
    names_in_block, found = numbers(gpu, block, f"{instance}." if instance else "")
    assert len(set(wanted)) > 40
    np.testing.assert_array_equal(found, wanted)
    # Of an array of structs GL lists the parts that are read; here a block has all of them.
    assert set(names) <= set(names_in_block)


def test_two_blocks_and_members_that_nobody_reads(gpu: Gpu) -> None:
    fragment = """#version 330
        layout(std140) uniform First { float unread; vec4 one; };
        layout(std140) uniform Second { vec4 two; double never; } second;
        out vec4 o; void main() { o = one + second.two; }""".replace("double", "float")
    programs = Programs(gpu)
    program = acquired(programs, "#version 330\n" + VERTEX, fragment)
    assert set(program.uniforms) == {"one", "second.two"}
    programs.release_all()


@pytest.mark.parametrize(
    "block",
    [
        "layout(std140, row_major) uniform B { mat2x3 m; } b;",
        "layout(std140, row_major) uniform B { mat2x3 m; } b[2];",
        "layout(std140) uniform B { dmat2x3 m; } b;",
        "layout(std140) uniform; layout(shared) uniform B { mat2x3 m; } b;",
        "uniform B { mat2x3 m; } b;",
    ],
)
def test_other_layouts_are_told_to_be_unsupported(gpu: Gpu, block: str) -> None:
    which = "b[1].m" if "[2]" in block else "b.m"
    fragment = f"#version 430\n{block} out vec4 o; void main() {{ o = vec4({which}[0], 1.0); }}"
    with pytest.raises(InputError, match="SC524"):
        acquired(Programs(gpu), "#version 430\n" + VERTEX, fragment)


VERTEX_OF = """#version 330
{declared}
in vec3 a_position;
out vec3 v_position;
void main() {{
    v_position = a_position;
    gl_Position = {projection} * {view} * {model} * vec4(a_position, 1.0);
}}
"""
FRAGMENT = """#version 330
in vec3 v_position;
out vec4 o;
void main() { o = vec4(sin(v_position * 9.0) * cos(v_position.yzx * 7.0), 1.0); }
"""
PLACES = {
    "plain": ("uniform mat4 {p}, {v}, {m};", "u_p", "u_v", "u_m"),
    "block": ("layout(std140) uniform All {{ float unread; mat4 {p}, {v}, {m}; }};", "p", "v", "m"),
    "instance": (
        "layout(std140) uniform All {{ mat4 p; mat4 v; }} all; uniform mat4 {m};",
        *("all.p", "all.v", "m"),
    ),
    "struct": (
        "struct Eye {{ mat4 p; mat4 v; }}; uniform Eye e; uniform mat4 {m};",
        "e.p",
        "e.v",
        "m",
    ),
}


def written(folder: Path, mesh: Path, place: str) -> Path:
    """A scene whose matrices are kept in one way or another."""
    declared, p, v, m = PLACES[place]
    vertex = VERTEX_OF.format(
        declared=declared.format(p=p, v=v, m=m), projection=p, view=v, model=m
    )
    (folder / "a.vert").write_text(vertex)
    (folder / "a.frag").write_text(FRAGMENT)
    scene = folder / "scene.toml"
    scene.write_text(f"""
name = "blocks"
fragment = "a.frag"
vertex = "a.vert"
mesh = "{mesh}"
[attributes]
a_position = "position"
[camera]
eye = [0.0, -2.4, 1.6]
target = [0.0, 0.0, 0.0]
fov_degrees = 45.0
near = 0.5
far = 10.0
[motion]
axis = [0.0, 0.0, 1.0]
degrees_per_frame = 3.0
frames = 30
[uniforms]
"{p}" = "projection"
"{v}" = "view"
"{m}" = "model"
""")
    return scene


def run_of(gpu: Gpu, path: Path) -> tuple[bytes, bytes, float]:
    """Image and hit mask after some frames of motion, and the share of hits."""
    scene, analysis = analyse_scene(load_scene(path))
    node = next(node for node in analysis.nodes if node.offered and "cos" in node.text)
    emission = rewritten(analysis, node, PROOF)
    with (
        RenderScene(gpu, scene, (96, 96), "rgba32f") as world,
        variant(world, Bundle(emission.manifest, emission.files), "2-pass") as runner,
    ):
        for frame in range(5):
            runner.draw(frame)
        mask = runner.hit_mask(5)
        image = runner.image(5)
        assert not runner.cuts.suspicions
    share = float((mask == runner.bundle.mask_values["hit"]).sum() / (mask > 0).sum())
    return image.tobytes(), mask.tobytes(), share


@pytest.mark.parametrize("place", ["block", "instance", "struct"])
def test_twins_have_the_last_frames_values(
    gpu: Gpu, scene_folder: Path, tmp_path: Path, place: str
) -> None:
    mesh = scene_folder / "torus.npz"
    wanted = run_of(gpu, written(tmp_path, mesh, "plain"))
    found = run_of(gpu, written(tmp_path, mesh, place))
    assert wanted[2] > 0.8
    assert found == wanted


@pytest.mark.parametrize("place", ["block", "instance", "struct"])
def test_the_laws_hold(gpu: Gpu, scene_folder: Path, tmp_path: Path, place: str) -> None:
    path = written(tmp_path, scene_folder / "torus.npz", place)
    scene, analysis = analyse_scene(load_scene(path))
    node = next(node for node in analysis.nodes if node.offered and "cos" in node.text)
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        verdict = verifier.check(node)
    assert not verdict.broken
    assert verdict.algorithms == {"1-pass", "2-pass", "3-pass"}
