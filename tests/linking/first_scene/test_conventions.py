"""What tutorials have: blocks, samplers in structs, matrices of instances, flat things, skies."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest

from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.verify.verifier import Verifier
from tests.gltf_maker import quad, sheet
from tests.linking.first_scene.test_first_scene import copied, written

pytestmark = pytest.mark.xdist_group("gl")

FLAT = """#version 330 core
in vec4 {position};
uniform mat4 projection;
{more}
out vec2 place;
void main() {{
    place = {position}.xy;
    gl_Position = projection * {moved};
}}
"""
SHADE = """#version 330 core
in vec2 place;
uniform sampler2D image;
out vec4 color;
void main() {
    float wave = sin(place.x * 5.0) * cos(place.y * 7.0) + pow(abs(place.x), 1.5);
    color = texture(image, place) * wave;
}
"""


def holds(gpu: Gpu, folder: Path) -> None:
    """The dearest value of the scene in the folder is seen, and exact."""
    opened = open_scene(folder / "scene.toml")
    best = opened[1].savings.ranked()[0].node
    with closing(Verifier(gpu, opened)) as verifier:
        verdict = verifier.check(best, plain=False)
    assert not verdict.broken and verdict.algorithms


def test_blocks_structs_of_samplers_and_instances(gpu: Gpu, tmp_path: Path) -> None:
    shaders = copied("lamps.frag", tmp_path), copied("lamps.vert", tmp_path)
    text = written(quad().glb(tmp_path / "q.glb"), *shaders).text
    assert 'aNormal = "normal"' in text and 'aTexCoords = "uv"' in text
    assert 'aInstance = { table = "instances.npz", array = "matrix" }' in text
    for name in ("material.diffuse", "material.specular", "stains[0]", "stains[1]"):
        assert f'[textures."{name}"]' in text
    assert "[textures.dust]" in text and "[textures.cells]" in text
    assert '"material.shininess" = 32.0' in text
    holds(gpu, tmp_path)


@pytest.mark.parametrize(
    ("more", "moved", "meaning"),
    [
        ("", "vec4(aPos.xy, 0.0, 1.0)", "model-view-projection"),
        ("uniform mat4 model;", "model * vec4(aPos.xy, 0.0, 1.0)", "view-projection"),
        ("uniform mat4 view;", "view * vec4(aPos.xy, 0.0, 1.0)", "projection"),
    ],
)
def test_a_projection_without_a_view_is_all_of_it(
    gpu: Gpu, tmp_path: Path, more: str, moved: str, meaning: str
) -> None:
    vertex = tmp_path / "flat.vert"
    vertex.write_text(FLAT.format(position="aPos", more=more, moved=moved))
    fragment = tmp_path / "flat.frag"
    fragment.write_text(SHADE)
    text = written(sheet().glb(tmp_path / "s.glb"), fragment, vertex).text
    assert f'projection = "{meaning}"' in text
    holds(gpu, tmp_path)


def test_a_sky_has_to_be_before_the_far_plane(gpu: Gpu, tmp_path: Path) -> None:
    vertex = tmp_path / "sky.vert"
    more, moved = "uniform mat4 view;", "(view * vec4(aPos.xyz, 1.0))"
    text = FLAT.format(position="aPos", more=more, moved=moved)
    vertex.write_text(text.replace("    gl_Position = ", "    vec4 all = ").replace(
        ";\n}", ";\n    gl_Position = all.xyww;\n}"
    ))  # fmt: skip
    fragment = tmp_path / "sky.frag"
    fragment.write_text(SHADE)
    written(sheet().glb(tmp_path / "s.glb"), fragment, vertex)
    with pytest.raises(InputError) as caught:
        holds(gpu, tmp_path)
    [told] = caught.value.diagnostics
    assert told.code == "SC612" and told.hint is not None and "0.9999" in told.hint
    vertex.write_text(vertex.read_text().replace("all.xyww", "vec4(all.xy, 0.9999 * all.w, all.w)"))
    holds(gpu, tmp_path)
