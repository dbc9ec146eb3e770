"""Shaders without a scene: on a knot, or over the screen; what is drawn, guessed and refused."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError, UsageError
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.made_object import MadeObject, made_object, open_shader
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.subjects import subjects_of
from shadercache.paths import data_path
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import uniform_values
from shadercache.verify.verifier import Verifier
from tests.configured import configured

pytestmark = pytest.mark.xdist_group("gl")

MADE = Path(__file__).parent / "made"
READ = ReadOptions()
PAIRS = ("textured", "mapped", "lights")
ALONE = ("alone", "alone_es", "alone_100", "alone_120")
SIZE = (96, 96)


def images(gpu: Gpu, made: MadeObject, frames: range) -> Iterator[np.ndarray]:
    linker = Linker(made.scene, made.analysis)
    with RenderScene(gpu, linker.scene, SIZE) as world:
        yield from render_original(world, linker.originals(), frames)


@pytest.mark.parametrize("name", [*PAIRS, *ALONE])
def test_something_is_seen(gpu: Gpu, tmp_path: Path, name: str) -> None:
    made = made_object(MADE / f"{name}.frag", None, READ, tmp_path)
    assert made.analysis.mapping == "surface"
    assert (tmp_path / "made.vert").is_file() == (name in ALONE)
    shown = list(images(gpu, made, range(0, 360, 60)))
    for image in shown:
        covered = image[..., 3] > 0.5
        assert 0.25 < covered.mean() < 0.65
        edge = np.concatenate([covered[0], covered[-1], covered[:, 0], covered[:, -1]])
        assert not edge.any()
        colors = image[covered][:, :3]
        assert np.isfinite(colors).all() and colors.mean() > 0.05
        assert colors.std(0).max() > 0.03, "not all of one colour"
    assert not np.array_equal(shown[0], shown[1]), "it turns"


def test_shaders_of_the_corpus(gpu: Gpu, tmp_path: Path) -> None:
    dragon = data_path("corpus", "dragon", "dragon.frag")
    made = made_object(dragon, dragon.with_suffix(".vert"), READ, tmp_path)
    [image] = images(gpu, made, range(1))
    colors = image[image[..., 3] > 0.5][:, :3]
    assert colors.mean() > 0.1 and colors.std() > 0.05
    assert made.scene.name == "dragon"


@pytest.mark.parametrize("name", ["mapped", "alone_120"])
def test_the_laws_hold(gpu: Gpu, tmp_path: Path, name: str) -> None:
    made = made_object(MADE / f"{name}.frag", None, READ, tmp_path)
    best = made.analysis.savings.ranked()[0].node
    with closing(Verifier(gpu, (made.scene, made.analysis), size=(64, 64))) as verifier:
        assert verifier.references.world.drawables[0].mesh.name.endswith("small.npz")
        verdict = verifier.check(best, plain=False)
    assert not verdict.broken and verdict.algorithms


def test_it_can_be_measured_and_hides_parts_of_itself(gpu: Gpu, tmp_path: Path) -> None:
    made = made_object(MADE / "lights.frag", None, READ, tmp_path)
    linker = Linker(made.scene, made.analysis)
    best = made.analysis.savings.ranked()[0].node
    chosen = replace(configured(period=64), nodes=(best.id,), algorithm="2-pass")
    subjects = subjects_of(linker, "best", [chosen], 1)
    with RenderScene(gpu, linker.scene, SIZE) as world:
        found = measure(world, linker.originals(), subjects, MeasureOptions(8, weigh=False))
    [group] = found.groups
    [variant] = group.nodes[0].variants
    # A pixel in 64 is refreshed on purpose; what comes into view at silhouettes is more than that.
    assert 0.5 < variant.hit_rate < 1.0 - 2.0 / 64.0
    assert group.original.median > 0.0


def test_time_runs_and_all_else_rests(tmp_path: Path) -> None:
    made = made_object(MADE / "textured.frag", None, READ, tmp_path)
    scene = made.scene
    assert scene.view.start_time > 0.0 and scene.common.motion.degrees_per_frame == 1.0
    first, later = (uniform_values(scene.view, scene.parts[0], at, SIZE) for at in (0, 30))
    changed = {name for name in first if not np.array_equal(first[name], later[name])}
    assert changed == {"time", "model"}


def test_what_was_guessed_is_told(tmp_path: Path) -> None:
    notes = made_object(MADE / "lights.frag", None, READ, tmp_path).notes
    told = {note.partition(" ")[0]: note for note in notes}
    assert told["dirLight.direction"].endswith("(vec3: from the light, unit length)")
    assert told["material.diffuse"] == "material.diffuse is given a made picture (albedo)"
    places = [told[f"pointLights[{at}].position"] for at in range(3)]
    assert all("a light above the model, in the world" in place for place in places)
    assert len({place.partition("(")[0].partition("=")[2] for place in places}) == 3
    assert "viewPos" not in told, "its name says it"


def test_the_scene_can_be_opened_again_and_is_the_same_each_time(tmp_path: Path) -> None:
    texts = []
    for name in ("one", "two"):
        folder = tmp_path / name
        folder.mkdir()
        made = made_object(MADE / "mapped.frag", None, READ, folder)
        texts.append({path.name: path.read_bytes() for path in folder.rglob("*.*")})
        scene, analysis = open_scene(made.scene.path)
        assert [node.id for node in analysis.nodes] == [node.id for node in made.analysis.nodes]
        assert scene.parts[0].inputs.constants == made.scene.parts[0].inputs.constants
    assert texts[0] == texts[1]


def test_old_names_are_there_as_well(gpu: Gpu, tmp_path: Path) -> None:
    """Raised to a later version a shader has other names; the original is drawn as it is."""
    (tmp_path / "old.frag").write_text(
        "varying vec3 normal;\nuniform float layout;\n"
        "void main() { gl_FragColor = vec4(normal * layout, 1.0); }\n"
    )
    made = made_object(tmp_path / "old.frag", None, READ, tmp_path)
    assert made.analysis.renamed["layout"] in made.scene.parts[0].inputs.constants
    [image] = images(gpu, made, range(1))
    assert image[..., :3].max() > 0.1


def test_attributes_of_instances(gpu: Gpu, tmp_path: Path) -> None:
    text = (MADE / "textured.vert").read_text()
    text = text.replace("out vec2", "in mat4 place;\nout vec2").replace(
        "model *", "model * place *"
    )
    (tmp_path / "many.vert").write_text(text)
    made = made_object(MADE / "textured.frag", tmp_path / "many.vert", READ, tmp_path)
    assert made.scene.parts[0].inputs.instances.number > 1 and made.analysis.program.instanced
    [image] = images(gpu, made, range(1))
    assert (image[..., 3] > 0.5).mean() > 0.05


def test_shaders_over_the_screen(tmp_path: Path) -> None:
    flat = tmp_path / "flat.frag"
    flat.write_text("#version 330\nout vec4 c;\nvoid main() { c = gl_FragCoord / 64.0; }\n")
    found = open_shader(flat, None, READ, None, tmp_path)
    assert found.scene.common.mesh is None and found.analysis.mapping == "screen"
    assert found.notes == ()
    with pytest.raises(UsageError, match="SC006"):
        open_shader(flat, None, READ, "surface", tmp_path)


FLAT = """#version 330
in vec2 aPos; out vec2 TexCoord;
void main() { TexCoord = aPos; gl_Position = vec4(aPos, 0.0, 1.0); }
"""


def test_vertices_that_nothing_moves_are_the_screens(gpu: Gpu, tmp_path: Path) -> None:
    vertex = tmp_path / "flat.vert"
    vertex.write_text(FLAT)
    for mapping in (None, "screen"):
        found = open_shader(MADE / "textured.frag", vertex, READ, mapping, tmp_path)
        assert found.scene.common.mesh is None and found.scene.common.vertex == vertex
        assert found.analysis.mapping == "screen"
        [image] = images(gpu, found, range(1))
        assert (image[..., 3] > 0.5).all()
    again = open_scene(found.scene.path, READ, "screen", None, vertex)
    assert again[0].common.vertex == vertex


def test_what_cannot_be_shown(tmp_path: Path) -> None:
    (tmp_path / "thing.frag").write_text(
        "#version 330\nin vec3 thing; out vec4 c;\nvoid main() { c = thing.xyzz; }\n"
    )
    with pytest.raises(UsageError, match="SC005"):
        open_shader(tmp_path / "thing.frag", None, READ, None, tmp_path)
    text = (MADE / "textured.vert").read_text().replace("aTexCoord", "aWhat")
    (tmp_path / "what.vert").write_text(text.replace("vec2 aWhat", "ivec2 aWhat"))
    with pytest.raises(InputError, match="SC521"):
        open_shader(MADE / "textured.frag", tmp_path / "what.vert", READ, None, tmp_path)
    with pytest.raises(InputError, match="SC001"):
        open_shader(MADE / "textured.frag", tmp_path / "nothing.vert", READ, None, tmp_path)
