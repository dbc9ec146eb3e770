"""What a program needs and the scene lacks, textures, and what the driver refuses."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import moderngl
import numpy as np
import pytest
from manifests import reflected
from PIL import Image

from shadercache.diagnostics import GraphicsError, InputError
from shadercache.gpu.context import APT_LINE, Gpu, open_context
from shadercache.gpu.targets import Targets
from shadercache.gpu.textures import load_pixels
from shadercache.manifest.interface import InputEntry
from shadercache.render.pass_runners import PassRunner
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.mesh import load_mesh
from shadercache.scene.object_inputs import TextureSpec
from shadercache.source import Source
from tests.altered import altered

pytestmark = pytest.mark.xdist_group("gl")

VERTEX = """#version 330
in vec3 a_position;
uniform mat4 u_modelViewProjection;
void main() { gl_Position = u_modelViewProjection * vec4(a_position, 1.0); }
"""


def spec(fragment: str, vertex: str = VERTEX) -> PassSpec:
    sources = Source("test.vert", vertex), Source("test.frag", "#version 330\n" + fragment)
    inputs: tuple[InputEntry, ...] = ()
    # What only the driver turns down has no manifest that tells of it.
    with suppress(InputError):
        inputs = reflected(*sources)
    return PassSpec("test", *sources, inputs=inputs)


def codes(world: RenderScene, fragment: str, vertex: str = VERTEX) -> tuple[list[str], str]:
    with pytest.raises(InputError) as caught:
        PassRunner(world, spec(fragment, vertex))
    assert world.programs.used == 0, "a program that cannot be used is given back"
    return [item.code for item in caught.value.diagnostics], str(caught.value)


@pytest.fixture
def textured(gpu: Gpu, scene: Scene, tmp_path: Path) -> Iterator[RenderScene]:
    """A world with a two-colour picture and a cube map whose faces are 0 to 5."""
    pixels = np.zeros((2, 1, 4), np.uint8)
    pixels[0], pixels[1] = (255, 0, 0, 255), (0, 255, 0, 255)
    Image.fromarray(pixels).save(tmp_path / "p.png")
    faces = np.zeros((6, 4, 4, 3), np.float16)
    faces += np.arange(6, dtype=np.float16).reshape(6, 1, 1, 1)
    np.savez(tmp_path / "f.npz", faces=faces)
    textures = {
        "u_flat": TextureSpec(tmp_path / "p.png", "nearest", True, "clamp", 1.0),
        "u_sharp": TextureSpec(tmp_path / "p.png", "linear", True, "repeat", 4.0),
        "u_sky": TextureSpec(tmp_path / "f.npz", "linear", True, "clamp", 1.0),
        "u_gone": TextureSpec(tmp_path / "none.npz", "linear", False, "clamp", 1.0),
    }
    changed = altered(scene, textures=MappingProxyType(textures))
    with RenderScene(gpu, changed, (32, 32), "rgba32f") as world:
        yield world


def test_what_the_scene_lacks(world: RenderScene) -> None:
    out = "out vec4 o; void main() { "
    found, words = codes(world, "uniform float u_a; " + out + "o = vec4(u_a); }")
    assert found == ["SC520"] and "u_a" in words and "scene.toml" in words
    found, _ = codes(
        world, f"uniform float u_a; uniform vec2 u_b; {out} o = vec4(u_a, u_b, 1.0); }}"
    )
    assert found == ["SC520", "SC520"]
    found, words = codes(world, "uniform vec4 u_light; " + out + "o = u_light; }")
    assert found == ["SC523"] and "takes 4 numbers" in words
    found, words = codes(
        world, "uniform sampler2D u_t; " + out + "o = texelFetch(u_t, ivec2(0), 0); }"
    )
    assert found == ["SC522"] and "[textures.u_t]" in words
    vertex = VERTEX.replace("in vec3 a_position;", "in vec3 a_position; in vec2 a_uv;")
    vertex = vertex.replace("1.0)", "a_uv.x)")
    found, words = codes(world, out + "o = vec4(1.0); }", vertex)
    assert found == ["SC521"] and "a_uv" in words


def test_a_uniform_that_brings_its_own_value(world: RenderScene) -> None:
    fragment = "uniform float u_gain = 0.75; out vec4 o; void main() { o = vec4(u_gain); }"
    with PassRunner(world, spec(fragment)) as runner:
        assert runner.image(0).max() == 0.75


def test_what_the_harness_cannot_give(world: RenderScene) -> None:
    out = "out vec4 o; void main() { "
    for fragment in (
        "uniform sampler2DShadow u_t; " + out + "o = vec4(texture(u_t, vec3(0.0))); }",
        "uniform Block { vec4 a; }; " + out + "o = a; }",
    ):
        assert codes(world, fragment)[0] == ["SC524"]
    # moderngl would hide the attribute behind the uniform, and the picture would be another.
    vertex = VERTEX.replace("in vec3 a_position;", "in vec3 a_position; in float u_a;")
    vertex = vertex.replace("1.0)", "u_a)")
    found, words = codes(world, "uniform float u_a; " + out + "o = vec4(u_a); }", vertex)
    assert found == ["SC524"] and "two inputs of the name u_a" in words


def test_textures_and_matrices_that_the_scene_lacks(world: RenderScene) -> None:
    out = "out vec4 o; void main() { "
    volume = "uniform sampler3D u_t; " + out + "o = texture(u_t, vec3(0.0)); }"
    assert codes(world, volume)[0] == ["SC522"]
    both = out + "o = texture(u_t[0], vec2(0)) * texture(u_t[1], vec2(0)); }"
    found, words = codes(world, "uniform sampler2D u_t[2]; " + both)
    assert found == ["SC522"]
    assert '[textures."u_t[0]"]' in words
    vertex = VERTEX.replace("in vec3 a_position;", "in vec3 a_position; in mat3 a_turn;")
    vertex = vertex.replace("vec4(a_position", "vec4(a_turn * a_position")
    assert codes(world, out + "o = vec4(1.0); }", vertex)[0] == ["SC521"]


def test_the_drivers_words_at_their_line(world: RenderScene) -> None:
    found, words = codes(world, "out vec4 o;\nvoid main() { o = vec4(nothing); }")
    assert set(found) == {"SC602"}
    assert "test.frag:3:" in words and "nothing" in words
    found, words = codes(world, "out vec4 o; void main() { o = vec4(1); }", "\n\n" + VERTEX + "x")
    assert "test.vert:7:" in words
    found, words = codes(world, "out vec4 o; float f(); void main() { o = vec4(f()); }")
    assert found == ["SC602"] and "test.vert + test.frag" in words


def test_a_mesh_without_normals(gpu: Gpu, scene: Scene) -> None:
    mesh = load_mesh(scene.common.mesh)
    bare = replace(mesh, arrays={"position": mesh.arrays["position"]})
    with pytest.raises(InputError, match="SC511") as caught:
        RenderScene(gpu, scene, (8, 8), mesh=bare)
    words = str(caught.value)
    assert "attributes.a_normal" in words and "scene.toml" in words and "position" in words


def test_textures_reach_the_shader(textured: RenderScene) -> None:
    flat = (
        "uniform sampler2D u_flat; uniform samplerCube u_sky; out vec4 o; void main() { o = vec4("
        "textureLod(u_flat, vec2(0.5, 0.25), 0.0).r, textureLod(u_flat, vec2(0.5, 0.75), 0.0).g, "
        "textureLod(u_sky, vec3(0.0, 0.0, -1.0), 0.0).r, textureLod(u_sky, vec3(1.0, 0.0, 0.0), "
        "2.0).g); }"
    )
    with PassRunner(textured, spec(flat)) as runner:
        image = runner.image(0)
    assert image.reshape(-1, 4).max(axis=0).tolist() == [1.0, 1.0, 5.0, 0.0]


def test_sampling_state(textured: RenderScene) -> None:
    flat, sharp = textured.drawables[0].texture("u_flat"), textured.drawables[0].texture("u_sharp")
    assert isinstance(flat, moderngl.Texture) and isinstance(sharp, moderngl.Texture)
    assert flat.filter == (moderngl.NEAREST_MIPMAP_NEAREST, moderngl.NEAREST)
    assert sharp.filter == (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
    assert (flat.repeat_x, sharp.repeat_y) == (False, True)
    assert sharp.anisotropy == 4.0
    assert (
        textured.drawables[0].texture("u_flat") is flat
        and textured.drawables[0].texture("u_none") is None
    )


def test_wrong_textures(textured: RenderScene, tmp_path: Path) -> None:
    out = "out vec4 o; void main() { "
    found, words = codes(
        textured, "uniform samplerCube u_flat; " + out + "o = texture(u_flat, vec3(1)); }"
    )
    assert found == ["SC523"] and "as a cube map" in words
    found, _ = codes(
        textured, "uniform sampler2D u_gone; " + out + "o = texture(u_gone, vec2(0)); }"
    )
    assert found == ["SC530"]
    for name, arrays, words in (
        ("a", {"other": np.zeros((2, 2))}, "none of faces, layers"),
        ("b", {"pixels": np.zeros((2, 2, 5), np.float32)}, "shape"),
        ("c", {"pixels": np.zeros((2, 2, 3))}, "float64"),
        ("d", {"faces": np.zeros((5, 2, 2, 3), np.float32)}, "shape"),
        ("e", {"pixels": np.full((2, 2, 1), np.inf, np.float32)}, "infinity"),
    ):
        np.savez(tmp_path / f"{name}.npz", **arrays)
        with pytest.raises(InputError, match=words) as caught:
            load_pixels(tmp_path / f"{name}.npz")
        assert caught.value.diagnostics[0].code == "SC531"
    Image.fromarray(np.full((4, 4, 3), 200, np.uint8)).save(tmp_path / "x.jpg")
    pixels, what = load_pixels(tmp_path / "x.jpg")
    assert what == "pixels" and pixels[0, 0].tolist() == [200, 200, 200, 255]
    (tmp_path / "x.png").write_bytes(b"no picture")
    with pytest.raises(InputError, match="SC530"):
        load_pixels(tmp_path / "x.png")


def test_formats_that_do_not_exist(gpu: Gpu) -> None:
    with pytest.raises(InputError, match="SC603"):
        Targets(gpu.ctx, (8, 8), "rgb565")
    with pytest.raises(GraphicsError, match="SC603"):
        Targets(gpu.ctx, (1 << 20, 8), "rgba8")


def test_no_gl(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(**settings: object) -> None:
        raise Exception("libEGL.so: cannot\nopen")

    monkeypatch.setattr(moderngl, "create_context", fail)
    with pytest.raises(GraphicsError) as caught:
        open_context()
    assert caught.value.exit_code == 3
    rendered = str(caught.value)
    assert "SC601" in rendered and "libEGL.so: cannot open" in rendered and APT_LINE in rendered
