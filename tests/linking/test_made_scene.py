"""The scene of a shader that has none: values by name and by type, and generated textures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.compiler import analyse, emit_original
from shadercache.diagnostics import InputError, UsageError
from shadercache.gpu.context import Gpu
from shadercache.linking.made_scene import START, made_scene
from shadercache.linking.scene_shaders import analyse_scene, open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import uniform_values
from shadercache.scene.description import load_scene
from shadercache.source import Source

INPUTS = """#version 330
struct Lamp { vec3 place; float power; };
uniform float u_time, uTime, time, u_gain;
uniform int iFrame, u_count;
uniform vec2 u_resolution;
uniform vec3 iResolution;
uniform vec4 iMouse;
uniform vec2 u_mouse;
uniform bool u_lit;
uniform mat3 u_turn;
uniform mat2x3 u_skew;
uniform vec4 u_tint;
uniform vec3 u_path[2];
uniform Lamp u_lamp;
uniform Lamp u_lamps[2];
uniform float u_set = 7.0;
uniform sampler2D u_map;
uniform samplerCube u_sky;
uniform sampler2DArray u_layers;
out vec4 o_color;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    o_color = texture(u_map, p) + texture(u_sky, vec3(p, 1.0)) + texture(u_layers, vec3(p, 2.0));
    o_color += float(u_lit) * u_tint * vec4(u_turn * u_path[1], u_skew[1].y);
    o_color += u_time + uTime + time;
    o_color.xy += u_lamp.place.xy * u_lamps[1].power + iResolution.xy / iMouse.zw + u_mouse;
    o_color.x += u_gain + float(iFrame + u_count) + u_set;
}
"""


def test_values_by_name_and_type() -> None:
    scene = made_scene(Path("toy.frag"), analyse(Source("toy.frag", INPUTS)))
    values = {
        name: array.tolist()
        for name, array in uniform_values(scene.view, scene.common, 6, (40, 30)).items()
    }
    now = START + 0.1
    assert values["u_time"] == values["uTime"] == values["time"] == [pytest.approx(now)]
    assert values["iFrame"] == [6.0] and values["u_count"] == [1.0]
    assert values["u_resolution"] == [40.0, 30.0]
    assert values["iResolution"] == [40.0, 30.0, 1.0]
    assert values["iMouse"] == [0.0] * 4 and values["u_mouse"] == [0.0] * 2
    assert values["u_lit"] == [1.0] and values["u_gain"] == [0.5]
    assert values["u_turn"] == [1, 0, 0, 0, 1, 0, 0, 0, 1]
    assert values["u_skew"] == [1, 0, 0, 0, 1, 0]
    assert values["u_tint"] == [0.8, 0.6, 0.4, 1.0]
    assert values["u_path"] == [0.8, 0.6, 0.4] * 2
    assert values["u_lamp.place"] == values["u_lamps[1].place"] == [0.8, 0.6, 0.4]
    assert values["u_lamps[0].power"] == [0.5]
    assert "u_set" not in values
    assert set(scene.common.inputs.textures) == {"u_map", "u_sky", "u_layers"}
    assert scene.changes["u_time"] == scene.changes["iFrame"] == "time"
    assert "u_resolution" not in scene.changes
    assert uniform_values(scene.view, scene.common, 0, (4, 3))["u_time"] == START


def test_everything_can_be_drawn(gpu: Gpu) -> None:
    analysis = analyse(Source("toy.frag", INPUTS))
    emission = emit_original(analysis)
    bundle = Bundle(emission.manifest, emission.files)
    with RenderScene(gpu, made_scene(Path("toy.frag"), analysis), (16, 12), "rgba32f") as world:
        first, later = render_original(world, [bundle], (0, 6))
    assert np.isfinite(first[..., 2]).all() and len(np.unique(first[..., 2])) > 50
    assert (later[..., 2] > first[..., 2]).all(), "three clocks go on"


def test_members_of_blocks_have_values_as_uniforms_do(gpu: Gpu, tmp_path: Path) -> None:
    path = tmp_path / "block.frag"
    path.write_text("""#version 330
        layout(std140) uniform Light { vec4 tint; };
        layout(std140) uniform Host { float u_time; float gain; } host;
        out vec4 c;
        void main() { c = vec4(tint.xy, host.u_time / 8.0, host.gain); }
    """)
    scene, analysis = open_scene(path)
    emission = emit_original(analysis)
    with RenderScene(gpu, scene, (8, 8), "rgba32f") as world:
        [image] = render_original(world, [Bundle(emission.manifest, emission.files)], (0,))
    assert image[0, 0].tolist() == pytest.approx([0.8, 0.6, START / 8.0, 0.5])


def test_samplers_of_any_kind_and_in_structs_have_textures(gpu: Gpu, tmp_path: Path) -> None:
    path = tmp_path / "kinds.frag"
    path.write_text("""#version 330
        struct Paint { sampler2D map; float gain; };
        uniform Paint paint, paints[2];
        uniform sampler2D maps[2];
        uniform sampler3D volume;
        uniform isampler2D integers;
        uniform usampler2D naturals;
        out vec4 c;
        void main() {
            vec2 p = gl_FragCoord.xy / 8.0;
            vec4 all = texture(paint.map, p) * paint.gain + texture(maps[1], p);
            all += texture(paints[1].map, p);
            all += texture(volume, vec3(p, 0.5)) + vec4(texture(integers, p)) / 255.0;
            c = all - vec4(texture(naturals, p)) / 255.0;
        }
    """)
    scene, analysis = open_scene(path)
    emission = emit_original(analysis)
    with RenderScene(gpu, scene, (8, 8), "rgba32f") as world:
        [image] = render_original(world, [Bundle(emission.manifest, emission.files)], (0,))
    assert np.ptp(image[..., :3]) > 0.1


def test_nothing_is_made_for_a_block_in_a_layout_of_the_drivers_own(
    gpu: Gpu, tmp_path: Path
) -> None:
    path = tmp_path / "block.frag"
    path.write_text(
        "#version 330\nuniform Light { vec4 tint; };\nout vec4 c;\nvoid main() { c = tint; }\n"
    )
    scene, analysis = open_scene(path)
    emission = emit_original(analysis)
    with RenderScene(gpu, scene, (8, 8)) as world, pytest.raises(InputError, match="SC524"):
        render_original(world, [Bundle(emission.manifest, emission.files)], (0,))


def test_a_shader_of_surfaces_needs_a_scene(tmp_path: Path) -> None:
    path = tmp_path / "solid.frag"
    path.write_text("#version 330\nin vec3 v;\nout vec4 c;\nvoid main() { c = vec4(v, 1.0); }\n")
    with pytest.raises(UsageError, match="SC006"):
        open_scene(path)
    path.write_text("#version 330\nout vec4 c;\nvoid main() { c = gl_FragCoord; }\n")
    with pytest.raises(UsageError, match="SC006"):
        open_scene(path, mapping="surface")
    assert open_scene(path)[1].full_screen
    with pytest.raises(InputError, match="SC001"):
        open_scene(tmp_path / "none.frag")


QUAD = """#version 330
in vec2 a_corner;
in vec2 a_texCoord;
uniform mat4 u_matrix;
out vec2 v_uv;
void main() { v_uv = a_texCoord; gl_Position = u_matrix * vec4(a_corner, 0.0, 1.0); }
"""


def test_a_vertex_shader_beside_it_is_drawn(gpu: Gpu, tmp_path: Path) -> None:
    path = tmp_path / "quad.frag"
    path.write_text("#version 330\nin vec2 v_uv;\nout vec4 c;\nvoid main() { c = v_uv.xyxy; }\n")
    path.with_suffix(".vert").write_text(QUAD)
    scene, analysis = open_scene(path, mapping="screen")
    assert scene.common.inputs.attributes == {"a_corner": "position", "a_texCoord": "uv"}
    emission = emit_original(analysis)
    with RenderScene(gpu, scene, (8, 4), "rgba32f") as world:
        (image,) = render_original(world, [Bundle(emission.manifest, emission.files)], (0,))
    assert np.allclose(image[0, :, 0], (np.arange(8) + 0.5) / 8, atol=1e-6)
    assert np.allclose(image[:, 0, 1], (np.arange(4) + 0.5) / 4, atol=1e-6)
    with pytest.raises(UsageError, match="SC006"):
        open_scene(path)


SCENE = """name = "flat"
fragment = "flat.frag"
mapping = "screen"
start_time = 2.0
[uniforms]
u_time = "time"
u_resolution = "resolution"
"""


def test_a_scene_file_can_be_full_screen(tmp_path: Path) -> None:
    text = "uniform float u_time;\nuniform vec2 u_resolution;\nout vec4 c;\n"
    body = "void main() { c = vec4(gl_FragCoord.xy / u_resolution, u_time, 1.0); }\n"
    (tmp_path / "flat.frag").write_text(f"#version 330\n{text}{body}")
    (tmp_path / "scene.toml").write_text(SCENE)
    scene = load_scene(tmp_path)
    assert scene.common.vertex is None and scene.common.mesh is None
    assert uniform_values(scene.view, scene.common, 60, (8, 4))["u_time"] == 3.0
    assert analyse_scene(scene)[1].mapping == "screen"
    for old, new, code in (
        ('"screen"', '"air"', "SC505"),
        ('"screen"', '"surface"', "SC503"),
        ('"screen"', '"screen"\nmesh = "flat.frag"', "SC503"),
        ('"screen"', '"user"\nvertex = "none.vert"', "SC507"),
    ):
        (tmp_path / "scene.toml").write_text(SCENE.replace(old, new))
        with pytest.raises(InputError, match=code):
            load_scene(tmp_path)
